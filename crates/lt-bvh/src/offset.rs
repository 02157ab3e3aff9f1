//! Ray origins that clear their own surface at every scale, after Wächter & Binder ("A Fast and Robust Method for
//! Avoiding Self-Intersection", Ray Tracing Gems, 2019), without their fixed threshold near the coordinate origin.

use lt_math::glam::Vec3;

/// Length of the offset in units of 2⁻²³ · magnitude.
///
/// Measured over scene scales 10⁻⁶ to 10⁶ and scene offsets of 500, 8,000 and 6·10⁶, 286,692 grazing rays: 6,601
/// self-hits at 0.5, 16 at 1, none at 2. Four times that, for instances and slivers round a few times more.
pub const ORIGIN_ULPS: f32 = 8.0;

/// `position` moved along `geometric_normal` far enough that a ray from there cannot hit the surface it stands on.
///
/// `position` on the surface, in world space, best interpolated from the vertices by the hit's barycentric weights:
/// `origin + t · direction` carries an error in proportion to the distance from the eye as well. `geometric_normal` of unit length, pointing to the side that
/// the ray leaves to; `magnitude` the largest absolute coordinate of the triangle's world-space vertices and of
/// `position`, which is what the rounding errors of `position` and of the triangle test are in proportion to.
/// (The paper uses each coordinate's own ULP and a constant below 1/32; here the picture is the same for a scene
/// in micrometres.)
#[inline(always)]
pub fn offset_origin(position: Vec3, geometric_normal: Vec3, magnitude: f32) -> Vec3 {
    position + geometric_normal * (ORIGIN_ULPS / 8_388_608.0 * magnitude)
}
