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

use crate::view::{Rays, View};
use lt_bvh::Triangle;
use lt_bvh::lanes::Lanes;
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

/// A vector in every lane.
type V<L> = [<L as Lanes>::F; 3];

/// A place in the light's plane in every lane.
type Flat<L> = [<L as Lanes>::F; 2];

/// The vertices of eight triangles side by side, in permuted axes.
#[derive(Clone, Copy)]
pub(crate) struct Corners<L: Lanes>(pub [V<L>; 3]);

impl<L: Lanes> Corners<L> {
    /// Of up to eight triangles; lanes beyond them hold a point.
    #[inline(always)]
    pub fn load<'a>(lanes: L, view: &View, triangles: impl Iterator<Item = &'a Triangle>) -> Self {
        let axes = view.axes();
        let mut rows = [[[0.0; 8]; 3]; 3];
        for (lane, triangle) in triangles.take(8).enumerate() {
            for (row, corner) in rows.iter_mut().zip([triangle.v0, triangle.v1, triangle.v2]) {
                for (row, axis) in row.iter_mut().zip(axes) {
                    row[lane] = corner[axis];
                }
            }
        }
        let mut corners = [[lanes.splat(0.0); 3]; 3];
        for (corner, rows) in corners.iter_mut().zip(&rows) {
            for (axis, row) in corner.iter_mut().zip(rows) {
                *axis = lanes.load(row);
            }
        }
        Corners(corners)
    }

    /// The same relative to a point.
    #[inline(always)]
    pub fn from(&self, lanes: L, point: Vec3) -> [V<L>; 3] {
        let point = [lanes.splat(point.x), lanes.splat(point.y), lanes.splat(point.z)];
        let [a, b, c] = self.0;
        [minus(lanes, a, point), minus(lanes, b, point), minus(lanes, c, point)]
    }
}

#[inline(always)]
fn minus<L: Lanes>(lanes: L, a: V<L>, b: V<L>) -> V<L> {
    [lanes.sub(a[0], b[0]), lanes.sub(a[1], b[1]), lanes.sub(a[2], b[2])]
}

/// a·d − b·c.
#[inline(always)]
fn determinant<L: Lanes>(lanes: L, a: L::F, b: L::F, c: L::F, d: L::F) -> L::F {
    lanes.sub(lanes.mul(a, d), lanes.mul(b, c))
}

#[inline(always)]
fn cross<L: Lanes>(lanes: L, a: V<L>, b: V<L>) -> V<L> {
    [
        determinant(lanes, a[1], a[2], b[1], b[2]),
        determinant(lanes, a[2], a[0], b[2], b[0]),
        determinant(lanes, a[0], a[1], b[0], b[1]),
    ]
}

#[inline(always)]
fn dot<L: Lanes>(lanes: L, a: V<L>, b: V<L>) -> L::F {
    lanes.add(lanes.add(lanes.mul(a[0], b[0]), lanes.mul(a[1], b[1])), lanes.mul(a[2], b[2]))
}

#[inline(always)]
fn scaled<L: Lanes>(lanes: L, a: V<L>, factor: L::F) -> V<L> {
    [lanes.mul(a[0], factor), lanes.mul(a[1], factor), lanes.mul(a[2], factor)]
}

#[inline(always)]
fn negated<L: Lanes>(lanes: L, a: V<L>) -> V<L> {
    minus(lanes, [lanes.splat(0.0); 3], a)
}

#[inline(always)]
fn largest<L: Lanes>(lanes: L, a: V<L>) -> L::F {
    lanes.max(lanes.max(lanes.abs(a[0]), lanes.abs(a[1])), lanes.abs(a[2]))
}

/// What a triangle's planes are made of, in permuted axes, where the cross product keeps its sign.
struct Shape<L: Lanes> {
    e: V<L>,
    f: V<L>,
    g: V<L>,
    normal: V<L>,
    /// E·F.
    product: L::F,
    /// What an edge value, and a depth value, may be off by.
    edge: L::F,
    depth: L::F,
}

/// Planes of eight triangles, row by row, and a bit for each that is a **sliver**: a point outside of its rectangle may then pass its
/// edges. Of others the three edge values have a sum above 3 wherever a point passes the depth test, so that one is surely
/// positive where another is surely negative. All vertices must be finite.
#[inline(always)]
pub(crate) fn planes<L: Lanes>(lanes: L, view: &View, corners: &Corners<L>) -> ([L::F; ROWS], u32) {
    let [a, b, c] = corners.0;
    let (e, f, g) = (minus(lanes, b, a), minus(lanes, c, a), minus(lanes, c, b));
    let (le, lf) = (largest(lanes, e), largest(lanes, f));
    let product = lanes.mul(le, lf);
    let size = lanes.splat(view.size);
    let volume = lanes.mul(product, size);
    let longest = lanes.max(lanes.max(le, lf), largest(lanes, g));
    let width = lanes.add(lanes.add(longest, longest), lanes.splat(48.0 * EPSILON * view.reach));
    let shape = Shape {
        e,
        f,
        g,
        normal: cross(lanes, e, f),
        product,
        edge: lanes.mul(lanes.splat(view.caution[0] * EDGE * view.size), width),
        depth: lanes.mul(lanes.splat(view.caution[1] * DEPTH), volume),
    };
    let (mut rows, slivers) = match view.rays {
        Rays::Parallel { shear, middle, .. } => {
            parallel(lanes, &shape, corners.from(lanes, middle), shear, view.sign)
        }
        Rays::Converging { light } => converging(lanes, &shape, corners.from(lanes, light), view),
    };
    let mut is_safe =
        lanes.le(lanes.splat(VOLUMES.start), volume) & lanes.lt(volume, lanes.splat(VOLUMES.end));
    if !SIZES.contains(&view.size) {
        is_safe = 0;
    }
    for row in &mut rows {
        *row = lanes.pick(is_safe, *row, lanes.splat(0.0));
    }
    (rows, slivers | !is_safe)
}

/// From a vertex along an edge: positive on the left of it, where the triangle is if it turns counter-clockwise.
#[inline(always)]
fn line<L: Lanes>(lanes: L, p: Flat<L>, d: Flat<L>, k: L::F) -> V<L> {
    let (x, y) = (lanes.mul(lanes.sub(lanes.splat(0.0), d[1]), k), lanes.mul(d[0], k));
    let constant = lanes.add(lanes.mul(x, p[0]), lanes.mul(y, p[1]));
    [x, y, lanes.sub(lanes.splat(0.0), constant)]
}

/// A place or direction in the sun's plane.
#[inline(always)]
pub(crate) fn flat<L: Lanes>(lanes: L, v: V<L>, shear: Vec3) -> Flat<L> {
    [
        lanes.sub(v[0], lanes.mul(lanes.splat(shear.x), v[2])),
        lanes.sub(v[1], lanes.mul(lanes.splat(shear.y), v[2])),
    ]
}

#[inline(always)]
fn parallel<L: Lanes>(lanes: L, s: &Shape<L>, v: [V<L>; 3], shear: Vec3, sign: f32) -> ([L::F; ROWS], u32) {
    let (zero, one) = (lanes.splat(0.0), lanes.splat(1.0));
    let n = s.normal;
    let den = dot(lanes, n, [lanes.splat(shear.x), lanes.splat(shear.y), one]);
    let turn = lanes.pick(lanes.lt(den, zero), lanes.splat(-1.0), one);
    let k = lanes.div(turn, s.edge);
    let p = flat(lanes, v[0], shear);
    let a = line(lanes, p, flat(lanes, s.e, shear), k);
    let b = line(lanes, flat(lanes, v[1], shear), flat(lanes, s.g, shear), k);
    let c = line(lanes, flat(lanes, v[2], shear), flat(lanes, negated(lanes, s.f), shear), k);
    let is_edge_on = lanes.le(lanes.abs(den), lanes.mul(lanes.splat(LEAST_SLOPE), s.product));
    let sign = lanes.splat(sign);
    let h = lanes.pick(is_edge_on, zero, lanes.div(lanes.mul(turn, sign), s.depth));
    let n = scaled(lanes, n, h);
    let (hx, hy) = (lanes.sub(zero, n[0]), lanes.sub(zero, n[1]));
    let z = lanes.mul(den, h);
    let at = lanes.add(lanes.mul(hx, p[0]), lanes.mul(hy, p[1]));
    let hc = lanes.sub(lanes.mul(z, v[0][2]), at);
    let rows = [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], hx, hy, hc, lanes.mul(z, sign)];
    let is_thin = lanes.le(lanes.abs(den), lanes.mul(lanes.splat(3.2), s.edge));
    (rows, is_edge_on | is_thin)
}

#[inline(always)]
fn converging<L: Lanes>(lanes: L, s: &Shape<L>, r: [V<L>; 3], view: &View) -> ([L::F; ROWS], u32) {
    let (zero, sign) = (lanes.splat(0.0), lanes.splat(view.sign));
    let volume = dot(lanes, s.normal, r[0]);
    let turn = lanes.pick(lanes.lt(volume, zero), sign, lanes.sub(zero, sign));
    let k = lanes.div(turn, s.edge);
    let a = scaled(lanes, cross(lanes, r[0], s.e), k);
    let b = scaled(lanes, cross(lanes, r[1], s.g), k);
    let c = scaled(lanes, cross(lanes, r[2], negated(lanes, s.f)), k);
    let size = lanes.abs(volume);
    let least = lanes.mul(lanes.splat(1.1), s.depth);
    let is_edge_on = lanes.le(size, least);
    let h = lanes.pick(is_edge_on, zero, lanes.div(turn, s.depth));
    let n = scaled(lanes, s.normal, h);
    let z = lanes.mul(size, lanes.abs(h));
    let rows = [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], n[0], n[1], n[2], z];
    // Such a point sees a sum of (P − tolerance)·Z at least, and Z ≥ 1/D.
    let thin = lanes.add(least, lanes.mul(lanes.splat(3.2 * view.size), s.edge));
    (rows, lanes.le(size, thin))
}

#[cfg(test)]
#[path = "../tests/support/mod.rs"]
pub(crate) mod support;

#[cfg(test)]
mod tests {
    use super::support::{PLACES, Random, Soup, lights, origins};
    use crate::block::{BLOCK, Block};
    use crate::casters::Casters;
    use crate::rect::{Rect, rects};
    use crate::view::View;
    use alloc::vec::Vec;
    use lt_bvh::lanes::Portable;
    use lt_bvh::{BuildQuality, Bvh, LightPoint, Ray};

    /// Verdicts that the ray tracer contradicts, and how many are sure, with error bounds scaled by these factors.
    fn wrong_verdicts(caution: [f32; 2]) -> (usize, usize) {
        let mut random = Random(7);
        let (mut wrong, mut sure) = (0, 0);
        for (scale, offset) in PLACES {
            for light in lights(&mut random, scale, offset).into_iter().step_by(2) {
                let soup = Soup::mixed(&mut random, 64, light.truncate()).moved(scale, offset);
                let starts = origins(&mut random, &soup, light, 600);
                let bvh = Bvh::build(&soup.positions, &soup.triangles, |_| true, BuildQuality::Fast).unwrap();
                let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
                for mut view in View::of_light(light, soup.bounds(), casters.root) {
                    view.caution = caution;
                    let rays = starts.iter().map(|o| Ray::to_light(*o, light));
                    for ray in rays.filter(|ray| view.takes(ray)) {
                        let counts = contradicted(&view, casters, &ray);
                        (wrong, sure) = (wrong + counts.0, sure + counts.1);
                    }
                }
            }
        }
        (wrong, sure)
    }

    fn contradicted(view: &View, casters: Casters<'_>, ray: &Ray) -> (usize, usize) {
        let LightPoint { x, y, z } = view.point(ray);
        let point = Rect { x0: x, x1: x, y0: y, y1: y, z };
        let (constant, factor) = view.depth_tolerance();
        let test = casters.test(ray);
        let (mut wrong, mut sure) = (0, 0);
        for (at, triangles) in casters.triangles.chunks(BLOCK).enumerate() {
            let ids: Vec<u32> = (0..triangles.len()).map(|i| (at * BLOCK + i) as u32).collect();
            let block = Block::of(Portable, view, casters, &ids);
            let answer = block.test_one(Portable, [x, y, z], constant + factor * z);
            let rects = rects(Portable, view, triangles);
            for (slot, triangle) in triangles.iter().enumerate() {
                let meets = test.is_some_and(|t| t.meet(triangle).is_some());
                let is_near = rects[slot].covers(&point) && z <= rects[slot].z;
                let is_sure = is_near && answer.sure >> slot & 1 == 1;
                let is_possible = is_near && answer.possible >> slot & 1 == 1;
                wrong += usize::from(is_sure && !meets || !is_possible && meets);
                sure += usize::from(is_sure || !is_possible);
            }
        }
        (wrong, sure)
    }

    /// The cases are hard enough that bounds matter: with nearly none, verdicts are wrong.
    #[test]
    fn error_bounds_are_kept_and_needed() {
        let (wrong, sure) = wrong_verdicts([1.0, 1.0]);
        assert_eq!(wrong, 0, "of {sure}");
        assert!(sure > 100_000, "{sure}");
        for caution in [[1e-3, 1.0], [1.0, 1e-3]] {
            let (wrong, _) = wrong_verdicts(caution);
            assert!(wrong > 0, "bounds {caution:?} times the proven ones were never missed");
        }
    }
}
