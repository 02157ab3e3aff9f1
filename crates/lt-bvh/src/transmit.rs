//! The transmittance callback: what a translucent triangle lets through at a hit.

use lt_math::glam::Vec3;

/// Says how much light passes a hit.
pub trait Transmit: Copy {
    /// Share of the light that passes the hit at barycentric weights `u` (of `v1`) and `v` (of `v2`), both in [0, 1], on
    /// the triangle at index `triangle` of the triangle buffer: linear RGB in [0, 1], white where it is clear.
    ///
    /// Every triangle is asked, opaque or not, once for each time that a ray meets it.
    fn transmittance(&self, triangle: u32, u: f32, v: f32) -> Vec3;
}
