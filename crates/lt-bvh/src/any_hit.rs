//! The alpha callback: what a non-opaque triangle says about a hit, asked inside the traversal.

/// Decides whether a geometric hit on a non-opaque triangle counts.
///
/// Only triangles flagged [`Triangle::NON_OPAQUE`](crate::Triangle::NON_OPAQUE) are asked; opaque ones never
/// reach it. The answer must depend on the arguments alone: a triangle may be asked more than once per ray,
/// in any order.
pub trait AnyHit: Copy {
    /// Whether [`AnyHit::accepts`] is always true, so that nobody need look whether a triangle is opaque.
    const IS_OPAQUE: bool = false;

    /// Whether the hit at barycentric weights `u` (of `v1`) and `v` (of `v2`), both in [0, 1], on the triangle
    /// at index `triangle` of the triangle buffer stops the ray.
    fn accepts(&self, triangle: u32, u: f32, v: f32) -> bool;
}

/// Every hit counts: no alpha test.
#[derive(Clone, Copy, Debug, Default)]
pub struct Opaque;

impl AnyHit for Opaque {
    const IS_OPAQUE: bool = true;

    #[inline(always)]
    fn accepts(&self, _triangle: u32, _u: f32, _v: f32) -> bool {
        true
    }
}
