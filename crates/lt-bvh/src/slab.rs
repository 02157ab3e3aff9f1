//! Ray against box: the slab test (Kay & Kajiya 1986) with an absolute margin that covers all rounding.
//!
//! Ize ("Robust BVH Ray Traversal", JCGT 2(2), 2013) widens the exit by a relative amount, which covers the
//! slab test's own rounding. That is not enough for an answer that never depends on the tree: the triangle test
//! rounds too, and may accept a ray that passes just outside the triangle's box. So boxes are widened by an
//! absolute margin instead, in proportion to D, the largest distance along an axis from the ray's origin to the
//! tree's root box. All rounding of the triangle test together stays below 8·2⁻²⁴·D and that of the slab test
//! below 4·2⁻²⁴·D, whichever way a compiler contracts or reorders it. A hit counts only if the ray meets the
//! triangle's own box widened by [`TRIANGLE_MARGIN`]·D; nodes are widened by twice as much, so a node test can
//! never cut off a hit that counts. Hence the answer is a function of the ray and the triangles alone.

use crate::ray::{FAR, Ray};
use lt_math::glam::Vec3;

/// Margin of a triangle's own box in units of D, the largest distance along an axis from a ray's origin to the tree's root box: 16 roundings.
pub const TRIANGLE_MARGIN: f32 = 16.0 / 16_777_216.0;
/// Margin of a node's box in units of D.
pub(crate) const NODE_MARGIN: f32 = 32.0 / 16_777_216.0;
/// A direction component below this fraction of the largest one is raised to it, so that its reciprocal stays
/// finite: over the length of the tree it moves the ray by 2⁻⁴⁰·D, far below the margins.
pub const LEAST_COMPONENT: f32 = 1.0 / 1_099_511_627_776.0;

/// What the box tests need of a ray, once per ray and tree.
#[derive(Clone, Copy)]
pub(crate) struct Slab {
    pub origin: Vec3,
    /// Reciprocal direction, every component finite and not 0.
    pub inverse: Vec3,
    /// Node margin in units of t per axis.
    pub node_margin: Vec3,
    /// Triangle margin in units of t per axis.
    pub triangle_margin: Vec3,
}

/// The part of a ray inside a box.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    pub near: f32,
    pub far: f32,
}

/// The stretch that a tree without instances looks at: all of a ray.
pub(crate) const WHOLE_RAY: Span = Span { near: -FAR, far: FAR };

#[inline(always)]
fn finite_reciprocal(d: f32, least: f32) -> f32 {
    let magnitude = if d.abs() < least { least } else { d.abs() };
    if d < 0.0 { -1.0 / magnitude } else { 1.0 / magnitude }
}

/// Reciprocals of a direction's components as box tests take them: every one finite and not 0 ([`LEAST_COMPONENT`]).
#[inline(always)]
pub fn reciprocal(direction: Vec3) -> Vec3 {
    let least = largest(direction.abs()) * LEAST_COMPONENT;
    Vec3::new(
        finite_reciprocal(direction.x, least),
        finite_reciprocal(direction.y, least),
        finite_reciprocal(direction.z, least),
    )
}

#[inline(always)]
pub(crate) fn largest(v: Vec3) -> f32 {
    v.x.max(v.y).max(v.z)
}

impl Slab {
    /// Prepares a valid ray for a tree whose root box is `low` to `high`.
    #[inline(always)]
    pub fn new(ray: &Ray, low: Vec3, high: Vec3) -> Self {
        let inverse = reciprocal(ray.direction);
        let reach = largest((low - ray.origin).abs().max((high - ray.origin).abs()));
        Slab {
            origin: ray.origin,
            inverse,
            node_margin: inverse.abs() * (reach * NODE_MARGIN),
            triangle_margin: inverse.abs() * (reach * TRIANGLE_MARGIN),
        }
    }

    /// Where the ray passes the box `low` to `high` widened by the triangle margin; `near > far` if it misses.
    #[inline(always)]
    pub fn span(&self, low: Vec3, high: Vec3) -> Span {
        let a = (low - self.origin) * self.inverse;
        let b = (high - self.origin) * self.inverse;
        let near = a.min(b) - self.triangle_margin;
        let far = a.max(b) + self.triangle_margin;
        Span { near: largest(near), far: far.x.min(far.y).min(far.z) }
    }
}
