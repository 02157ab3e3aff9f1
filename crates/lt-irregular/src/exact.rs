//! The ray tracer's own test of one triangle, with several rays of a view side by side.
//!
//! It is `lt_bvh::lanes::watertight`, so that every answer and every weight has the ray tracer's bits; axes are permuted once for all
//! rays of a view, and what all rays of a sun share is computed once.

use crate::view::{Rays, View};
use lt_bvh::lanes::Lanes;
use lt_bvh::lanes::watertight::{Edges, Vector, is_between, is_confirmed, minus, plane_t, span, spread};
use lt_bvh::{COORDINATE_LIMIT, FAR, LEAST_COMPONENT, TRIANGLE_MARGIN, Triangle, permute};
use lt_math::glam::Vec3;

/// A triangle in the permuted axes of a view.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    corners: [Vec3; 3],
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

impl Exact {
    #[inline(always)]
    pub fn new(view: &View, triangle: &Triangle) -> Self {
        Exact { corners: [triangle.v0, triangle.v1, triangle.v2].map(|v| permute(v, view.axis)) }
    }

    /// Which of the rays from these origins, in permuted axes, meet the triangle; those outside of `mask` are not looked at. They must be
    /// rays that the view takes.
    #[inline(always)]
    pub fn meet<L: Lanes>(&self, lanes: L, view: &View, origin: Vector<L>, mask: u32) -> Meeting<L> {
        let zero = lanes.splat(0.0);
        let [a, b, c] = self.corners;
        let triangle = [spread(lanes, a), spread(lanes, b), spread(lanes, c)];
        let (shear, end) = match view.rays {
            Rays::Parallel { shear, .. } => (spread(lanes, shear), lanes.splat(FAR)),
            Rays::Converging { light } => {
                let d = minus(lanes, spread(lanes, light), origin);
                let z = lanes.div(lanes.splat(1.0), d[2]);
                ([lanes.div(d[0], d[2]), lanes.div(d[1], d[2]), z], lanes.splat(1.0))
            }
        };
        // First of all: nearly all rays that planes cannot decide start on the very triangle, and end here.
        let t = plane_t(lanes, triangle, origin, shear);
        let mut mask = mask & is_between(lanes, t, zero, end);
        if mask == 0 {
            return Meeting { mask, u: zero, v: zero };
        }
        let edges = Edges::new(lanes, triangle, origin, [shear[0], shear[1]]);
        mask &= edges.hold(lanes) & edges.have_area(lanes);
        if mask == 0 {
            return Meeting { mask, u: zero, v: zero };
        }
        let own = self.span(lanes, view, origin, &mut mask);
        mask &= is_confirmed(lanes, t, own, zero, end);
        let [u, v] = edges.weights(lanes);
        Meeting { mask, u, v }
    }

    /// Where the rays pass the triangle's widened box; takes those out of `mask` that have coordinates too large to hit anything.
    #[inline(always)]
    fn span<L: Lanes>(&self, lanes: L, view: &View, origin: Vector<L>, mask: &mut u32) -> (L::F, L::F) {
        let limit = lanes.splat(COORDINATE_LIMIT);
        let inverse = match view.rays {
            Rays::Parallel { inverse, .. } => spread(lanes, inverse),
            Rays::Converging { light } => {
                let d = minus(lanes, spread(lanes, light), origin);
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
            for distance in minus(lanes, spread(lanes, corner), origin) {
                reach = lanes.max(reach, lanes.abs(distance));
            }
        }
        let reach = lanes.mul(reach, lanes.splat(TRIANGLE_MARGIN));
        let mut margin = inverse;
        for (margin, origin) in margin.iter_mut().zip(origin) {
            *margin = lanes.mul(lanes.abs(*margin), reach);
            *mask &= lanes.lt(lanes.abs(origin), limit);
        }
        let [a, b, c] = self.corners;
        let bounds = [spread(lanes, a.min(b).min(c)), spread(lanes, a.max(b).max(c))];
        span(lanes, bounds, origin, inverse, margin)
    }
}
