//! Rays and hits as the traversals take and return them.

use bytemuck::{Pod, Zeroable};
use lt_math::glam::{Vec3, Vec4};

/// Index that names no triangle and no instance.
pub const NONE: u32 = u32::MAX;

/// Largest finite stand-in for infinity that every shader compiler takes; the `tmax` of an unbounded ray.
pub const FAR: f32 = 3.0e38;

/// Largest magnitude of a coordinate of a vertex, a ray origin or a direction; beyond it nothing is hit.
pub const COORDINATE_LIMIT: f32 = 1.0e15;

/// A ray `origin + t · direction` for `tmin < t < tmax`; both ends are exclusive.
///
/// `direction` need not have unit length; t counts in its lengths, so a ray to a point light may use the whole
/// difference as direction and `tmax` = 1. A NaN or a magnitude above [`COORDINATE_LIMIT`] anywhere, or a zero
/// direction, hits nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Ray {
    /// Start of the ray.
    pub origin: Vec3,
    /// Hits at or before this t do not count.
    pub tmin: f32,
    /// Direction; its largest component should lie between 1e-12 and 1e12 in magnitude.
    pub direction: Vec3,
    /// Hits at or beyond this t do not count.
    pub tmax: f32,
}

#[inline(always)]
fn is_bounded(magnitudes: Vec3) -> bool {
    magnitudes.x < COORDINATE_LIMIT && magnitudes.y < COORDINATE_LIMIT && magnitudes.z < COORDINATE_LIMIT
}

impl Ray {
    /// The ray from `origin` along `direction` without an end: 0 < t < [`FAR`].
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Ray { origin, tmin: 0.0, direction, tmax: FAR }
    }

    /// The ray from `origin` to a homogeneous light: a position and w = 1, or the direction to a sun and w = 0. t runs to 1 at a
    /// position, without end to a sun.
    #[inline(always)]
    pub fn to_light(origin: Vec3, light: Vec4) -> Self {
        let tmax = if light.w == 0.0 { FAR } else { 1.0 };
        Ray { origin, tmin: 0.0, direction: light.truncate() - origin * light.w, tmax }
    }

    /// Whether every number is usable; see [`Ray`].
    #[inline(always)]
    pub fn is_valid(&self) -> bool {
        let d = self.direction.abs();
        self.starts_validly() && is_bounded(d) && (d.x > 0.0 || d.y > 0.0 || d.z > 0.0)
    }

    /// Whether the numbers of the origin are usable.
    #[inline(always)]
    pub(crate) fn starts_validly(&self) -> bool {
        is_bounded(self.origin.abs())
    }
}

/// The nearest hit of a ray, or a miss.
///
/// Of several hits at the same t the one with the lowest triangle index wins, then the lowest instance.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Hit {
    /// Ray parameter of the hit, in lengths of the ray's direction; the ray's `tmax` on a miss.
    pub t: f32,
    /// Barycentric weight of `v1`, in [0, 1].
    pub u: f32,
    /// Barycentric weight of `v2`, in [0, 1].
    pub v: f32,
    /// Index into the triangle buffer, [`NONE`] on a miss.
    pub triangle: u32,
    /// Index into the instance buffer, [`NONE`] on a miss and in a tree without instances.
    pub instance: u32,
}

impl Hit {
    /// No hit before `tmax`.
    #[inline(always)]
    pub fn miss(tmax: f32) -> Self {
        Hit { t: tmax, u: 0.0, v: 0.0, triangle: NONE, instance: NONE }
    }

    /// Whether something was hit.
    #[inline(always)]
    pub fn is_hit(&self) -> bool {
        self.triangle != NONE
    }
}
