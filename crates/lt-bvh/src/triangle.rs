//! Watertight ray-triangle test (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013).
//!
//! The ray becomes the z axis by a translation, a permutation and a shear; each vertex is transformed by
//! arithmetic that depends on that vertex alone, so neighbours agree on it bit for bit. What is left are three
//! 2D edge functions. The paper resolves an edge function of exactly zero in f64 to give the ray to one of
//! the two neighbours. Here **zero counts as inside, on both sides**: then the ray hits both, never neither,
//! and a shadow ray does not care which, while a closest-hit ray has the rule that of equal t the lower index
//! wins. What must hold is that the edge function of a shared edge gives exactly opposite values in the two
//! triangles. a·b − c·d does by itself as long as both products round; a GPU compiler that contracts it to a
//! fused multiply-add rounds only one of them, and which one depends on the order of the vertices. So each
//! edge is evaluated with its two vertices in one canonical order and the sign put back afterwards. Without
//! contraction this equals the direct formula exactly, which is what the SIMD paths evaluate.
//!
//! The paper blends t from the vertices by the edge functions. On a sliver these are all but rounding, and t may lie
//! anywhere along it, so that long thin triangles shadow themselves. Here t comes from the triangle's plane, whose normal
//! is the product of the two shorter edges: their differences are small numbers, exact to their own rounding.

use crate::axes::{main_axis, permute};
use crate::ray::{NONE, Ray};
use crate::slab::{Slab, Span};
use bytemuck::{Pod, Zeroable};
use lt_math::glam::{Vec2, Vec3};

/// A triangle in leaf order: positions, and the caller's vertex indices for fetching attributes.
///
/// The builder turns vertices around so that `v0` lies opposite the longest edge; t is the more exact for it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Triangle {
    /// First vertex.
    pub v0: Vec3,
    /// The caller's index of the first vertex; the top bit is [`Triangle::NON_OPAQUE`].
    pub i0: u32,
    /// Second vertex, of barycentric weight u.
    pub v1: Vec3,
    /// The caller's index of the second vertex.
    pub i1: u32,
    /// Third vertex, of barycentric weight v.
    pub v2: Vec3,
    /// The caller's index of the third vertex.
    pub i2: u32,
}

impl Triangle {
    /// Bit of `i0` set on triangles that ask the [`AnyHit`](crate::AnyHit) callback.
    pub const NON_OPAQUE: u32 = 0x8000_0000;

    /// The caller's three vertex indices.
    #[inline(always)]
    pub fn indices(&self) -> [u32; 3] {
        [self.i0 & !Self::NON_OPAQUE, self.i1, self.i2]
    }

    /// Whether hits on this triangle need no asking.
    #[inline(always)]
    pub fn is_opaque(&self) -> bool {
        self.i0 & Self::NON_OPAQUE == 0
    }

    /// Lower corner of the bounding box.
    #[inline(always)]
    pub fn low(&self) -> Vec3 {
        self.v0.min(self.v1).min(self.v2)
    }

    /// Upper corner of the bounding box.
    #[inline(always)]
    pub fn high(&self) -> Vec3 {
        self.v0.max(self.v1).max(self.v2)
    }
}

/// The transformation that turns a ray into the z axis, once per ray and tree.
#[derive(Clone, Copy)]
pub(crate) struct Shear {
    pub origin: Vec3,
    /// Axis of the direction's largest component, which becomes z; x and y follow it cyclically.
    pub axis: u32,
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

/// A geometric hit: t and barycentric weights of `v1` and `v2`.
#[derive(Clone, Copy)]
pub(crate) struct Intersection {
    pub t: f32,
    pub u: f32,
    pub v: f32,
    pub is_hit: bool,
}

const NO_INTERSECTION: Intersection = Intersection { t: 0.0, u: 0.0, v: 0.0, is_hit: false };

/// The cross product a × b, evaluated with the two points in canonical order: exactly `-cross(b, a)`, with or
/// without contraction to fused multiply-adds.
#[inline(always)]
fn cross(a: Vec2, b: Vec2) -> f32 {
    let swap = b.x < a.x || (b.x == a.x && b.y < a.y);
    let (p, q) = if swap { (b, a) } else { (a, b) };
    let value = p.x * q.y - p.y * q.x;
    if swap { -value } else { value }
}

impl Shear {
    /// Prepares a valid ray.
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        Self::along(ray.origin, ray.direction)
    }

    /// Prepares a ray from its parts.
    #[inline(always)]
    pub fn along(origin: Vec3, direction: Vec3) -> Self {
        let (axis, _) = main_axis(direction);
        let p = permute(direction, axis);
        Shear { origin, axis, x: p.x / p.z, y: p.y / p.z, z: 1.0 / p.z }
    }

    /// x and y of a vertex in the ray's frame.
    #[inline(always)]
    fn apply(&self, vertex: Vec3) -> Vec2 {
        let p = permute(vertex - self.origin, self.axis);
        Vec2::new(p.x - self.x * p.z, p.y - self.y * p.z)
    }

    /// t at which the ray meets the triangle's plane; infinite or NaN along it.
    #[inline(always)]
    fn plane_t(&self, triangle: &Triangle) -> f32 {
        let from_origin = permute(triangle.v0 - self.origin, self.axis);
        let e = permute(triangle.v1 - triangle.v0, self.axis);
        let f = permute(triangle.v2 - triangle.v0, self.axis);
        let normal = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
        let distance = normal.x * from_origin.x + normal.y * from_origin.y + normal.z * from_origin.z;
        self.z * distance / (normal.x * self.x + normal.y * self.y + normal.z)
    }

    /// Intersects between the ends of `ray`; the hit must also lie within `window`, and its t is clamped to where the ray passes the
    /// triangle's own widened box, so that no box test can contradict it (see [`crate::slab`]).
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, slab: &Slab, triangle: &Triangle, window: Span) -> Intersection {
        let a = self.apply(triangle.v0);
        let b = self.apply(triangle.v1);
        let c = self.apply(triangle.v2);
        let (u, v, w) = (cross(c, b), cross(a, c), cross(b, a));
        let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        let sum = u + v + w;
        if !inside || sum == 0.0 {
            return NO_INTERSECTION;
        }
        let t = self.plane_t(triangle);
        if !(t > ray.tmin && t < ray.tmax) {
            return NO_INTERSECTION;
        }
        let span = slab.span(triangle.low(), triangle.high());
        let near = if span.near > window.near { span.near } else { window.near };
        let far = if span.far < window.far { span.far } else { window.far };
        let raised = if t < near { near } else { t };
        let clamped = if raised > far { far } else { raised };
        Intersection { t: clamped, u: v / sum, v: w / sum, is_hit: near <= far }
    }
}

/// Whether a hit at `t` on triangle `index` of `instance` beats the best one so far.
#[inline(always)]
pub(crate) fn is_nearer(t: f32, index: u32, instance: u32, best: &crate::ray::Hit) -> bool {
    if t < best.t {
        return true;
    }
    let tied = t == best.t && best.triangle != NONE;
    tied && (index < best.triangle || (index == best.triangle && instance < best.instance))
}
