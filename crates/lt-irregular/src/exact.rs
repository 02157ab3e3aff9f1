//! The ray tracer's own test of one triangle, with several rays side by side.
//!
//! The operations and their order are those of `lt_bvh::RayTest`, ray by ray (lt-bvh/src/triangle.rs, `intersect`, and lt-bvh/src/slab.rs), so
//! that every answer and every weight has its bits; only axes are permuted once for all rays of a view instead of ray by ray. Tests hold
//! the two together. Nothing here may be fused to a multiply-add.

use crate::lanes::Lanes;
use crate::view::{Rays, View};
use lt_bvh::{COORDINATE_LIMIT, FAR, LEAST_COMPONENT, TRIANGLE_MARGIN, Triangle, permute};
use lt_math::glam::Vec3;

/// A triangle in the permuted axes of a view.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    corners: [Vec3; 3],
    normal: Vec3,
}

/// Where several rays meet a triangle.
#[derive(Clone, Copy)]
pub(crate) struct Meeting<L: Lanes> {
    /// A bit for each ray that does.
    pub mask: u32,
    /// Of these, the weight of the second vertex.
    pub u: L::F,
    /// Of the third.
    pub v: L::F,
}

/// Several rays in permuted axes.
struct Several<L: Lanes> {
    origin: [L::F; 3],
    /// The ray tracer's sₓ, s_y and s_z.
    shear: [L::F; 3],
    end: L::F,
}

#[inline(always)]
fn spread<L: Lanes>(lanes: L, v: Vec3) -> [L::F; 3] {
    [lanes.splat(v.x), lanes.splat(v.y), lanes.splat(v.z)]
}

#[inline(always)]
fn minus<L: Lanes>(lanes: L, a: [L::F; 3], b: [L::F; 3]) -> [L::F; 3] {
    [lanes.sub(a[0], b[0]), lanes.sub(a[1], b[1]), lanes.sub(a[2], b[2])]
}

/// a·x + b·y + c·z in this order, each step rounded.
#[inline(always)]
fn dot<L: Lanes>(lanes: L, a: [L::F; 3], b: [L::F; 3]) -> L::F {
    lanes.add(lanes.add(lanes.mul(a[0], b[0]), lanes.mul(a[1], b[1])), lanes.mul(a[2], b[2]))
}

#[inline(always)]
fn cross<L: Lanes>(lanes: L, a: [L::F; 2], b: [L::F; 2]) -> L::F {
    lanes.sub(lanes.mul(a[0], b[1]), lanes.mul(a[1], b[0]))
}

impl Exact {
    #[inline(always)]
    pub fn new(view: &View, triangle: &Triangle) -> Self {
        let corners = [triangle.v0, triangle.v1, triangle.v2].map(|v| permute(v, view.axis));
        let (e, f) = (corners[1] - corners[0], corners[2] - corners[0]);
        let normal = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
        Exact { corners, normal }
    }

    /// Which of the rays from these origins, in permuted axes, meet the triangle; those outside of `mask` are not looked at. They must be
    /// rays that the view takes.
    #[inline(always)]
    pub fn meet<L: Lanes>(&self, lanes: L, view: &View, origin: [L::F; 3], mask: u32) -> Meeting<L> {
        let zero = lanes.splat(0.0);
        let n = spread(lanes, self.normal);
        let (shear, end, slope) = match view.rays {
            Rays::Parallel { shear, .. } => {
                let slope = self.normal.x * shear.x + self.normal.y * shear.y + self.normal.z;
                (spread(lanes, shear), FAR, lanes.splat(slope))
            }
            Rays::Converging { light } => {
                let d = minus(lanes, spread(lanes, light), origin);
                let shear = [lanes.div(d[0], d[2]), lanes.div(d[1], d[2]), lanes.div(lanes.splat(1.0), d[2])];
                let along = lanes.add(lanes.mul(n[0], shear[0]), lanes.mul(n[1], shear[1]));
                (shear, 1.0, lanes.add(along, n[2]))
            }
        };
        let from = minus(lanes, spread(lanes, self.corners[0]), origin);
        let t = lanes.div(lanes.mul(shear[2], dot(lanes, n, from)), slope);
        let rays = Several { origin, shear, end: lanes.splat(end) };
        let mask = mask & lanes.lt(zero, t) & lanes.lt(t, rays.end);
        // Nearly all rays that planes cannot decide start on the very triangle, and end here.
        if mask == 0 {
            return Meeting { mask, u: zero, v: zero };
        }
        self.meet_beyond(lanes, view, &rays, t, mask)
    }

    /// The same of rays that meet the plane at `t` between their ends.
    #[inline(always)]
    fn meet_beyond<L: Lanes>(
        &self,
        lanes: L,
        view: &View,
        rays: &Several<L>,
        t: L::F,
        mut mask: u32,
    ) -> Meeting<L> {
        let zero = lanes.splat(0.0);
        let [x, y, _] = rays.shear;
        let mut flat = [[zero; 2]; 3];
        for (flat, corner) in flat.iter_mut().zip(self.corners) {
            let p = minus(lanes, spread(lanes, corner), rays.origin);
            *flat = [lanes.sub(p[0], lanes.mul(x, p[2])), lanes.sub(p[1], lanes.mul(y, p[2]))];
        }
        let [a, b, c] = flat;
        let (u, v, w) = (cross(lanes, c, b), cross(lanes, a, c), cross(lanes, b, a));
        let sum = lanes.add(lanes.add(u, v), w);
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        mask &= lanes.le(zero, least) | lanes.le(most, zero);
        mask &= lanes.lt(sum, zero) | lanes.lt(zero, sum);
        if mask == 0 {
            return Meeting { mask, u: zero, v: zero };
        }
        let (near, far) = self.span(lanes, view, rays, &mut mask);
        let clamped = lanes.min(lanes.max(t, near), far);
        mask &= lanes.le(near, far) & lanes.lt(zero, clamped) & lanes.lt(clamped, rays.end);
        Meeting { mask, u: lanes.div(v, sum), v: lanes.div(w, sum) }
    }

    /// Where the rays pass the triangle's widened box; takes those out of `mask` that have coordinates too large to hit anything.
    #[inline(always)]
    fn span<L: Lanes>(&self, lanes: L, view: &View, rays: &Several<L>, mask: &mut u32) -> (L::F, L::F) {
        let limit = lanes.splat(COORDINATE_LIMIT);
        let inverse = match view.rays {
            Rays::Parallel { inverse, .. } => spread(lanes, inverse),
            Rays::Converging { light } => {
                let d = minus(lanes, spread(lanes, light), rays.origin);
                // In permuted axes z is the largest.
                let largest = lanes.abs(d[2]);
                *mask &= lanes.lt(largest, limit);
                let least = lanes.mul(largest, lanes.splat(LEAST_COMPONENT));
                let mut inverse = d;
                for inverse in &mut inverse {
                    let zero = lanes.splat(0.0);
                    let is_negative = lanes.lt(*inverse, zero);
                    let size = lanes.div(lanes.splat(1.0), lanes.max(lanes.abs(*inverse), least));
                    *inverse = lanes.pick(is_negative, lanes.sub(zero, size), size);
                }
                inverse
            }
        };
        let mut reach = lanes.splat(0.0);
        for corner in [view.root.low, view.root.high] {
            for distance in minus(lanes, spread(lanes, corner), rays.origin) {
                reach = lanes.max(reach, lanes.abs(distance));
            }
        }
        let margin = lanes.mul(reach, lanes.splat(TRIANGLE_MARGIN));
        let [a, b, c] = self.corners;
        let low = minus(lanes, spread(lanes, a.min(b).min(c)), rays.origin);
        let high = minus(lanes, spread(lanes, a.max(b).max(c)), rays.origin);
        let (mut near, mut far) = (lanes.splat(-FAR), lanes.splat(FAR));
        for axis in 0..3 {
            *mask &= lanes.lt(lanes.abs(rays.origin[axis]), limit);
            let inverse = inverse[axis];
            let (a, b) = (lanes.mul(low[axis], inverse), lanes.mul(high[axis], inverse));
            let margin = lanes.mul(lanes.abs(inverse), margin);
            near = lanes.max(near, lanes.sub(lanes.min(a, b), margin));
            far = lanes.min(far, lanes.add(lanes.max(a, b), margin));
        }
        (near, far)
    }
}
