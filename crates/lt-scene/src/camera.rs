//! Perspective cameras.

use lt_math::glam::Vec3;

/// A pinhole camera, world space.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// For messages; may be empty.
    pub name: String,
    /// Centre of projection.
    pub eye: Vec3,
    /// A point it looks at, different from `eye`.
    pub target: Vec3,
    /// Which way is up; need not be perpendicular to the view.
    pub up: Vec3,
    /// Full vertical field of view, radians, in (0, π).
    pub fov_y_rad: f32,
}
