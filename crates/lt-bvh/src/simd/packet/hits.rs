//! How a packet's rays hit triangles: eight or sixteen rays per triangle, by all of the kernel's arithmetic.

use super::super::tree::Block;
use super::{Column, PACKET, Packet, bits_at, piece, set};
use crate::lanes::Lanes;
use crate::lanes::watertight::{Edges, Vector, axes, is_between, is_confirmed, plane_t, span, spread};
use lt_math::glam::Vec3;

/// Barycentric weights of the second and third vertex, per ray.
pub(crate) struct Weights {
    pub u: Column,
    pub v: Column,
}

impl Weights {
    pub fn none() -> Self {
        Weights { u: [0.0; PACKET], v: [0.0; PACKET] }
    }
}

/// The pieces of three columns, in this order.
#[inline(always)]
fn pieces<R: Lanes>(rays: R, columns: &[Column; 3], [x, y, z]: [usize; 3], at: usize) -> Vector<R> {
    [piece(rays, &columns[x], at), piece(rays, &columns[y], at), piece(rays, &columns[z], at)]
}

impl Packet {
    /// Which rays of `mask` hit a triangle of a block, by all of the kernel's arithmetic. The barycentric weights of their
    /// hits go to `weights`, if asked for.
    #[inline(always)]
    pub fn hits<R: Lanes, const WEIGHTS: bool>(
        &self,
        rays: R,
        block: Block,
        lane: usize,
        mask: u64,
        weights: &mut Weights,
    ) -> u64 {
        let axes = axes(self.kind.axis);
        let corners = [
            corner(block, 0, axes, lane & 7),
            corner(block, 1, axes, lane & 7),
            corner(block, 2, axes, lane & 7),
        ];
        let triangle = [spread(rays, corners[0]), spread(rays, corners[1]), spread(rays, corners[2])];
        let mut found = 0;
        let mut at = 0;
        while at < PACKET {
            let group = bits_at::<R>(mask, at);
            if group != 0 {
                let origin = pieces(rays, &self.origin, axes, at);
                let shear = pieces(rays, &self.shear, [0, 1, 2], at);
                let edges = Edges::new(rays, triangle, origin, [shear[0], shear[1]]);
                let inside = edges.hold(rays) & group;
                if inside != 0 {
                    let t = plane_t(rays, triangle, origin, shear);
                    let (tmin, tmax) = (piece(rays, &self.tmin, at), piece(rays, &self.tmax, at));
                    let hit = inside & edges.have_area(rays) & is_between(rays, t, tmin, tmax);
                    if hit != 0 {
                        let (near, far) = self.own_span(rays, corners, axes, at);
                        found |= u64::from(hit & is_confirmed(rays, t, (near, far), tmin, tmax)) << at;
                        if WEIGHTS {
                            let [u, v] = edges.weights(rays);
                            set(rays, &mut weights.u, at, u);
                            set(rays, &mut weights.v, at, v);
                        }
                    }
                }
            }
            at += R::WIDTH;
        }
        found
    }

    /// Where rays pass the triangle's own widened box, within their windows.
    #[inline(always)]
    fn own_span<R: Lanes>(&self, rays: R, [a, b, c]: [Vec3; 3], axes: [usize; 3], at: usize) -> (R::F, R::F) {
        let bounds = [spread(rays, a.min(b).min(c)), spread(rays, a.max(b).max(c))];
        let origin = pieces(rays, &self.origin, axes, at);
        let inverse = pieces(rays, &self.inverse, axes, at);
        let margin = pieces(rays, &self.triangle_margin, axes, at);
        let (near, far) = span(rays, bounds, origin, inverse, margin);
        (rays.max(near, piece(rays, &self.window_near, at)), rays.min(far, piece(rays, &self.window_far, at)))
    }
}

/// A vertex of a block's triangle, in permuted axes.
#[inline(always)]
fn corner(block: Block, vertex: usize, [x, y, z]: [usize; 3], lane: usize) -> Vec3 {
    Vec3::new(
        block.coordinate(vertex, x, lane),
        block.coordinate(vertex, y, lane),
        block.coordinate(vertex, z, lane),
    )
}
