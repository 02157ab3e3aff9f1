//! A triangle in light space: three edge planes and a depth plane, scaled so that **one tolerance is right for all**.
//!
//! The ray tracer's answer is a function of ray and triangle, f32 rounding included. Here the same question is decided by other
//! arithmetic, and only where that is *proven* to agree: an edge value above 1 means that the ray tracer finds the ray inside that edge,
//! below −1 that it finds it outside; likewise for depth. Between them nobody knows, and the ray tracer's own test is asked.
//!
//! # Proof
//!
//! ε = 2⁻²⁴, D = [`View::size`], R = [`View::reach`]; E, F the largest components of the triangle's two shorter edges, G of any edge;
//! W = 2G + 48εR. First-order bounds; the constants below leave a quarter and more for the rest.
//!
//! *The ray passes the triangle's box.* The ray tracer counts a hit only if the ray meets the triangle's box widened by 16εR
//! (lt-bvh/src/slab.rs), so where it does not, "no" is right whatever we find. Where it does, a vertex is at most W from the ray in the
//! shear plane.
//!
//! *Edges, ray tracer.* A vertex relative to the origin, sheared, is off by at most δ = 5εD; 7εD under a positioned light, whose ray
//! direction is rounded too. An edge function is a difference of two products of such, of magnitude W² at most: off by
//! 4δW + 4εW² ≤ 36εDW (as W ≤ 2D).
//!
//! *Edges, here.* Sun: E(X, Y) = d×(p − P). X and Y of the point and of P are off by 2.5εD each: 20εGD. Coefficients are made from
//! differences of vertices and off by 5εG: 20εGD. Constant and evaluation round at magnitudes of 8GD: 26εGD. Positioned: N = r×e is off by
//! 8εDG per component, 24εDG; evaluation and slopes 30εDG. With G ≤ W/2 both stay below 33εDW.
//! Together below 69εDW; [`EDGE`] has 96.
//!
//! *Outside.* The ray tracer takes all edge functions ≥ 0 or all ≤ 0, so a point is surely outside where one is surely negative **and**
//! another surely positive. (Their sum is twice the projected area A under a sun: of triangles that are not slivers one is positive
//! wherever another is surely negative.) Inside is where all three are surely positive.
//!
//! *Depth, ray tracer.* t's sign is that of dist/den, dist = n·(v₀ − o) with n = e×f. n is off by 8εEF per component, dist by 48εEFD, den
//! by 40εEF; den's sign is sure where A > 128εEF, ours included.
//! *Depth, here.* dist again, over light space: n 32, den 40, the constant 18, evaluation 41, points and vertices 26, in εEFD; positioned,
//! in units of Z = 1/w ≥ 1/D, below 126. Together below 207εEFD; [`DEPTH`] has 256.
//! t < tmax: without end under a sun; for a position t = 1 is the light itself, and P > 256εEFD keeps every plane surely away from it.
//! A hit that is surely inside lies in the triangle's box, whose widening outweighs the slab test's rounding, so that clamping t keeps
//! its verdict.
//!
//! Triangles edge-on to the light (A ≤ 128εEF, P ≤ 282εEFD) have a depth plane of 0, which is never sure; where magnitudes come near
//! over- or underflow all planes are 0.

use crate::view::{Rays, View, permute};
use lt_bvh::Triangle;
use lt_math::glam::Vec3;

/// 2⁻²⁴: the largest relative error of one rounding.
pub(crate) const EPSILON: f32 = 1.0 / 16_777_216.0;
/// Tolerance of an edge function in units of D·W.
const EDGE: f32 = 96.0 * EPSILON;
/// Tolerance of the depth test in units of E·F·D.
const DEPTH: f32 = 256.0 * EPSILON;
/// Projected area in units of E·F below which a triangle is edge-on to a sun.
const LEAST_SLOPE: f32 = 128.0 * EPSILON;
/// Least and largest size of a scene, and of E·F·D, for which no product over- or underflows.
const SIZES: core::ops::Range<f32> = 1e-9..1e9;
const VOLUMES: core::ops::Range<f32> = 1e-29..1e29;

/// Rows of a triangle: three edges `x, y, constant`, then depth `x, y, constant, z`.
pub(crate) const ROWS: usize = 13;

/// A triangle's planes. Edge value: `row[0]·X + row[1]·Y + row[2]`, sure beyond ±1. Depth value:
/// `row[9]·X + row[10]·Y + row[11] − row[12]·Z`, sure beyond ± [`View::depth_tolerance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Planes(pub [f32; ROWS]);

/// Never sure.
const DOUBTFUL: Planes = Planes([0.0; ROWS]);

#[inline(always)]
fn largest(v: Vec3) -> f32 {
    let v = v.abs();
    v.x.max(v.y).max(v.z)
}

/// x and y of the product a × b's three components are in permuted axes; the product itself keeps its sign under a cyclic permutation.
struct Shape {
    e: Vec3,
    f: Vec3,
    g: Vec3,
    normal: Vec3,
    /// E·F.
    product: f32,
    /// W.
    width: f32,
}

impl Shape {
    #[inline(always)]
    fn new(view: &View, triangle: &Triangle) -> Self {
        let e = permute(triangle.v1 - triangle.v0, view.axis);
        let f = permute(triangle.v2 - triangle.v0, view.axis);
        let g = permute(triangle.v2 - triangle.v1, view.axis);
        let (le, lf) = (largest(e), largest(f));
        Shape {
            e,
            f,
            g,
            normal: Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x),
            product: le * lf,
            width: 2.0 * le.max(lf).max(largest(g)) + 48.0 * EPSILON * view.reach,
        }
    }
}

impl Planes {
    /// The planes of a triangle with finite vertices, and whether it is a **sliver**: a point outside of its rectangle may then pass its
    /// edges. Of others the three edge values have a sum above 3 wherever a point passes the depth test, so that one is surely
    /// positive where another is surely negative.
    #[inline(always)]
    pub fn new(view: &View, triangle: &Triangle) -> (Self, bool) {
        let shape = Shape::new(view, triangle);
        let volume = shape.product * view.size;
        if !(SIZES.contains(&view.size) && VOLUMES.contains(&volume)) {
            return (DOUBTFUL, true);
        }
        let edge = EDGE * view.size * shape.width;
        match view.rays {
            Rays::Parallel { shear, middle, .. } => {
                let v = [triangle.v0, triangle.v1, triangle.v2].map(|v| permute(v, view.axis) - middle);
                Self::parallel(&shape, v, shear, view.sign, edge, DEPTH * volume)
            }
            Rays::Converging { light } => {
                let r = [triangle.v0, triangle.v1, triangle.v2].map(|v| permute(v, view.axis) - light);
                Self::converging(&shape, r, view, edge, DEPTH * volume)
            }
        }
    }

    #[inline(always)]
    fn parallel(s: &Shape, v: [Vec3; 3], shear: Vec3, sign: f32, edge: f32, depth: f32) -> (Self, bool) {
        let n = s.normal;
        let den = n.x * shear.x + n.y * shear.y + n.z;
        let flat = |v: Vec3| (v.x - shear.x * v.z, v.y - shear.y * v.z);
        let turn = if den < 0.0 { -1.0 } else { 1.0 };
        let k = turn / edge;
        let (p0, p1, p2) = (flat(v[0]), flat(v[1]), flat(v[2]));
        // From a vertex along an edge: positive on the left of it, where the triangle is if it turns counter-clockwise.
        let line = |p: (f32, f32), d: (f32, f32)| {
            let (x, y) = (-d.1 * k, d.0 * k);
            [x, y, -(x * p.0 + y * p.1)]
        };
        let (e, g, f) = (flat(s.e), flat(s.g), flat(-s.f));
        let ([a0, a1, a2], [b0, b1, b2], [c0, c1, c2]) = (line(p0, e), line(p1, g), line(p2, f));
        let is_edge_on = den.abs() <= LEAST_SLOPE * s.product;
        let h = if is_edge_on { 0.0 } else { turn * sign / depth };
        let (hx, hy) = (-n.x * h, -n.y * h);
        let z = den * h;
        let hc = z * v[0].z - (hx * p0.0 + hy * p0.1);
        let planes = Planes([a0, a1, a2, b0, b1, b2, c0, c1, c2, hx, hy, hc, z * sign]);
        (planes, is_edge_on || den.abs() <= 3.2 * edge)
    }

    #[inline(always)]
    fn converging(s: &Shape, r: [Vec3; 3], view: &View, edge: f32, depth: f32) -> (Self, bool) {
        let n = s.normal;
        let volume = n.x * r[0].x + n.y * r[0].y + n.z * r[0].z;
        let turn = if volume < 0.0 { view.sign } else { -view.sign };
        let k = turn / edge;
        let line = |r: Vec3, e: Vec3| {
            [(r.y * e.z - r.z * e.y) * k, (r.z * e.x - r.x * e.z) * k, (r.x * e.y - r.y * e.x) * k]
        };
        let ([a0, a1, a2], [b0, b1, b2], [c0, c1, c2]) = (line(r[0], s.e), line(r[1], s.g), line(r[2], -s.f));
        let is_edge_on = volume.abs() <= 1.1 * depth;
        let h = if is_edge_on { 0.0 } else { turn / depth };
        let z = volume.abs() * h.abs();
        let planes = Planes([a0, a1, a2, b0, b1, b2, c0, c1, c2, n.x * h, n.y * h, n.z * h, z]);
        // Such a point sees a sum of (P − tolerance)·Z at least, and Z ≥ 1/D.
        (planes, volume.abs() <= 1.1 * depth + 3.2 * edge * view.size)
    }
}
