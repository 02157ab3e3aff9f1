//! The ray tracer's test of triangles on lanes: several rays against one triangle, or several triangles against one ray. What all lanes
//! share is spread over them.
//!
//! The operations and their order are those of the shared kernel (`triangle.rs`, `intersect`, and `slab.rs`), lane by lane, so
//! that every answer and every weight has its bits. Nothing here may be fused to a multiply-add. A triangle is hit where [`Edges::hold`]
//! and [`Edges::area`] is not 0, [`plane_t`] lies between the ray's ends, and [`is_confirmed`] by its own box; which is asked first is left to
//! callers, who know what rules out most.
//!
//! Everything is in permuted axes ([`crate::permute`]): the rays' main axis is z.

use super::Lanes;
use lt_math::glam::Vec3;

/// The axes that become x, y and z where `axis` (0 to 2) becomes z.
#[inline(always)]
pub fn axes(axis: usize) -> [usize; 3] {
    if axis == 0 {
        [1, 2, 0]
    } else if axis == 1 {
        [2, 0, 1]
    } else {
        [0, 1, 2]
    }
}

/// One vector per lane.
pub type Vector<L> = [<L as Lanes>::F; 3];

/// The same vector in all lanes.
#[inline(always)]
pub fn spread<L: Lanes>(lanes: L, v: Vec3) -> Vector<L> {
    [lanes.splat(v.x), lanes.splat(v.y), lanes.splat(v.z)]
}

/// a − b.
#[inline(always)]
pub fn minus<L: Lanes>(lanes: L, a: Vector<L>, b: Vector<L>) -> Vector<L> {
    [lanes.sub(a[0], b[0]), lanes.sub(a[1], b[1]), lanes.sub(a[2], b[2])]
}

/// a·x + b·y + c·z in this order, each step rounded.
#[inline(always)]
fn dot<L: Lanes>(lanes: L, a: Vector<L>, b: Vector<L>) -> L::F {
    lanes.add(lanes.add(lanes.mul(a[0], b[0]), lanes.mul(a[1], b[1])), lanes.mul(a[2], b[2]))
}

/// a·b' − a'·b. The kernel's edge function by the direct formula: the same value, in other order of vertices too.
#[inline(always)]
pub fn cross<L: Lanes>(lanes: L, a: [L::F; 2], b: [L::F; 2]) -> L::F {
    lanes.sub(lanes.mul(a[0], b[1]), lanes.mul(a[1], b[0]))
}

/// A vector in the plane across rays of these sₓ and s_y, along the rays.
#[inline(always)]
pub fn sheared<L: Lanes>(lanes: L, p: Vector<L>, shear: [L::F; 2]) -> [L::F; 2] {
    [lanes.sub(p[0], lanes.mul(shear[0], p[2])), lanes.sub(p[1], lanes.mul(shear[1], p[2]))]
}

/// Edge functions u, v and w of a triangle, in proportion to the weights of its vertices.
#[derive(Clone, Copy)]
pub struct Edges<L: Lanes> {
    u: L::F,
    v: L::F,
    w: L::F,
}

impl<L: Lanes> Edges<L> {
    /// As rays from `origin` with this sₓ and s_y see them.
    #[inline(always)]
    pub fn new(lanes: L, [a, b, c]: [Vector<L>; 3], origin: Vector<L>, shear: [L::F; 2]) -> Self {
        let a = sheared(lanes, minus(lanes, a, origin), shear);
        let b = sheared(lanes, minus(lanes, b, origin), shear);
        let c = sheared(lanes, minus(lanes, c, origin), shear);
        Edges { u: cross(lanes, c, b), v: cross(lanes, a, c), w: cross(lanes, b, a) }
    }

    /// Where all three are of one sign, or 0.
    #[inline(always)]
    pub fn hold(&self, lanes: L) -> u32 {
        let zero = lanes.splat(0.0);
        let least = lanes.min(lanes.min(self.u, self.v), self.w);
        let most = lanes.max(lanes.max(self.u, self.v), self.w);
        lanes.le(zero, least) | lanes.le(most, zero)
    }

    /// Twice the area that rays see, with the sign of its winding. Where it is 0 the triangle is seen edge-on, and nothing is hit.
    #[inline(always)]
    pub fn area(&self, lanes: L) -> L::F {
        lanes.add(lanes.add(self.u, self.v), self.w)
    }

    /// Where that is not 0.
    #[inline(always)]
    pub fn have_area(&self, lanes: L) -> u32 {
        let (zero, area) = (lanes.splat(0.0), self.area(lanes));
        lanes.lt(area, zero) | lanes.lt(zero, area)
    }

    /// Barycentric weights of the second and of the third vertex.
    #[inline(always)]
    pub fn weights(&self, lanes: L) -> [L::F; 2] {
        let area = self.area(lanes);
        [lanes.div(self.v, area), lanes.div(self.w, area)]
    }
}

/// t at which rays with this sₓ, s_y and s_z meet the plane of a triangle; infinite or NaN along it.
#[inline(always)]
pub fn plane_t<L: Lanes>(lanes: L, [a, b, c]: [Vector<L>; 3], origin: Vector<L>, shear: Vector<L>) -> L::F {
    let (e, f) = (minus(lanes, b, a), minus(lanes, c, a));
    let normal = [
        cross(lanes, [e[1], e[2]], [f[1], f[2]]),
        cross(lanes, [e[2], e[0]], [f[2], f[0]]),
        cross(lanes, [e[0], e[1]], [f[0], f[1]]),
    ];
    let distance = dot(lanes, normal, minus(lanes, a, origin));
    let along = lanes.add(lanes.mul(normal[0], shear[0]), lanes.mul(normal[1], shear[1]));
    lanes.div(lanes.mul(shear[2], distance), lanes.add(along, normal[2]))
}

/// Where t lies between the ends of rays.
#[inline(always)]
pub fn is_between<L: Lanes>(lanes: L, t: L::F, tmin: L::F, tmax: L::F) -> u32 {
    lanes.lt(tmin, t) & lanes.lt(t, tmax)
}

/// Where rays enter and leave a triangle's own box `low` to `high`, widened by a margin in units of t along each axis.
#[inline(always)]
pub fn span<L: Lanes>(
    lanes: L,
    [low, high]: [Vector<L>; 2],
    origin: Vector<L>,
    inverse: Vector<L>,
    margin: Vector<L>,
) -> (L::F, L::F) {
    let (low, high) = (minus(lanes, low, origin), minus(lanes, high, origin));
    let (x0, x1) = slab(lanes, [low[0], high[0]], inverse[0], margin[0]);
    let (y0, y1) = slab(lanes, [low[1], high[1]], inverse[1], margin[1]);
    let (z0, z1) = slab(lanes, [low[2], high[2]], inverse[2], margin[2]);
    (lanes.max(lanes.max(x0, y0), z0), lanes.min(lanes.min(x1, y1), z1))
}

#[inline(always)]
fn slab<L: Lanes>(lanes: L, [low, high]: [L::F; 2], inverse: L::F, margin: L::F) -> (L::F, L::F) {
    let (a, b) = (lanes.mul(low, inverse), lanes.mul(high, inverse));
    (lanes.sub(lanes.min(a, b), margin), lanes.add(lanes.max(a, b), margin))
}

/// The last condition: where rays pass a span, and t clamped to it is still between their ends.
#[inline(always)]
pub fn is_confirmed<L: Lanes>(lanes: L, t: L::F, (near, far): (L::F, L::F), tmin: L::F, tmax: L::F) -> u32 {
    let clamped = lanes.min(lanes.max(t, near), far);
    lanes.le(near, far) & is_between(lanes, clamped, tmin, tmax)
}
