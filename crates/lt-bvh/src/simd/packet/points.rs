//! Parallel rays as points of the plane across them, against eight triangles at a time.
//!
//! What turns a sun's ray into the z axis is the same for all its rays but for the origin. So the triangles of a block are turned
//! once for all rays, and a ray is a point. This rounds otherwise than the kernel does, so it only **rules out**: what may be hit is
//! put to the kernel's own test.
//!
//! # What is ruled out is missed
//!
//! ε = 2⁻²⁴; R the greatest distance along an axis from a ray's origin to the tree's root box; G the largest component of two of a
//! triangle's edges. First-order bounds. The kernel counts a hit only where the ray passes the triangle's box widened by 16εR
//! ([`crate::slab`]), so let it: its vertices then lie within W = 4G + 48εR of the point.
//!
//! *The kernel.* A turned vertex is off by 5εR, so that an edge function, a difference of two products, is off by
//! 4·5εRW + 4εW² ≤ 36εRW (as W ≤ 4R) = 144εRG + 1728ε²R².
//!
//! *Here.* A point is off by 8εR and a turned vertex by 5εR, so that q, from the first vertex to the point, is off by 13εR + εW; a
//! turned edge of at most 2G by 5εG. The edge functions at the first vertex, two products of an edge and q each, are off by
//! 52εRG + 20εGW ≤ 52εRG + 80εG²; the third is what these two leave of the triangle's area, itself off by 52εG², and off by
//! 104εRG + 272εG².
//!
//! Together, below 248εRG + 272εG² + 1728ε²R². Where one edge function is negative by more than [`EDGE`]·εG·(R + G) +
//! [`CORNER`]·ε²R² and another is positive by as much, the kernel's have both signs too, which is a miss.

use super::super::lanes::{Lanes, NodeLanes};
use super::super::tree::Block;
use super::{PACKET, Packet, axes, piece, set};
use lt_math::glam::Vec3;

const EPSILON: f32 = 1.0 / 16_777_216.0;
const EDGE: f32 = 320.0;
const CORNER: f32 = 4096.0;

/// Eight triangles in the plane across the rays of a packet.
struct Across<L: Lanes> {
    /// First vertex.
    first: [L::F; 2],
    /// From it to the second and to the third.
    edges: [[L::F; 2]; 2],
    /// Twice the area.
    area: L::F,
    tolerance: L::F,
    /// Those that there are.
    lanes: u32,
}

impl Packet {
    /// Whether all directions are the same, so that its rays are points.
    #[inline(always)]
    pub fn is_parallel(&self) -> bool {
        self.is_parallel
    }

    /// Places the points, after all else is prepared.
    #[inline(always)]
    pub(super) fn place<R: Lanes>(&mut self, rays: R) {
        let (ix, iy, iz) = axes(self.kind.axis);
        let from = self.rays[0].origin;
        let mut at = 0;
        while at < self.len {
            let x = rays.sub(piece(rays, &self.origin[ix], at), rays.splat(from[ix]));
            let y = rays.sub(piece(rays, &self.origin[iy], at), rays.splat(from[iy]));
            let z = rays.sub(piece(rays, &self.origin[iz], at), rays.splat(from[iz]));
            let along_x = rays.mul(piece(rays, &self.shear[0], at), z);
            let along_y = rays.mul(piece(rays, &self.shear[1], at), z);
            set(rays, &mut self.points[0], at, rays.sub(x, along_x));
            set(rays, &mut self.points[1], at, rays.sub(y, along_y));
            at += R::WIDTH;
        }
    }

    /// Which of the parallel rays of `mask` each triangle of a block may block; it cannot block the others.
    #[inline(always)]
    pub fn may_hit<L: NodeLanes>(&self, lanes: L, block: Block, mask: u64) -> [u64; 8] {
        let across = self.across(lanes, block);
        let (mut sets, mut mask) = (lanes.no_sets(), mask);
        while mask != 0 {
            let ray = mask.trailing_zeros() as usize & (PACKET - 1);
            let bit = mask & mask.wrapping_neg();
            mask ^= bit;
            let point = [lanes.splat(self.points[0][ray]), lanes.splat(self.points[1][ray])];
            sets = lanes.add_to_sets(sets, across.may_hold(lanes, point), bit);
        }
        lanes.stored_sets(sets)
    }

    /// The triangles of a block.
    #[inline(always)]
    fn across<L: NodeLanes>(&self, lanes: L, block: Block) -> Across<L> {
        let (ix, iy, iz) = axes(self.kind.axis);
        let from = self.rays[0].origin;
        let from = Vec3::new(from[ix], from[iy], from[iz]);
        let (sx, sy) = (lanes.splat(self.shear[0][0]), lanes.splat(self.shear[1][0]));
        let (x, y, z) = (block.rows(ix), block.rows(iy), block.rows(iz));
        let v0 = [lanes.load(x[0]), lanes.load(y[0]), lanes.load(z[0])];
        let e = edge(lanes, [x[1], y[1], z[1]], v0);
        let f = edge(lanes, [x[2], y[2], z[2]], v0);
        let base = [
            lanes.sub(v0[0], lanes.splat(from.x)),
            lanes.sub(v0[1], lanes.splat(from.y)),
            lanes.sub(v0[2], lanes.splat(from.z)),
        ];
        let edges = [turned(lanes, e, sx, sy), turned(lanes, f, sx, sy)];
        let size = lanes.max(largest(lanes, e), largest(lanes, f));
        let reach = self.reach;
        let per_size = lanes.mul(lanes.splat(EDGE * EPSILON), lanes.add(size, lanes.splat(reach)));
        let corner = CORNER * EPSILON * reach * (EPSILON * reach);
        Across {
            first: turned(lanes, base, sx, sy),
            edges,
            area: cross(lanes, edges[0], edges[1]),
            tolerance: lanes.mul_add(size, per_size, lanes.splat(corner)),
            lanes: block.lanes(),
        }
    }
}

impl<L: NodeLanes> Across<L> {
    /// The triangles in which a point may lie, one for all of them.
    #[inline(always)]
    fn may_hold(&self, lanes: L, point: [L::F; 2]) -> u32 {
        let q = [lanes.sub(point[0], self.first[0]), lanes.sub(point[1], self.first[1])];
        // As the kernel calls them, the sign of w turned around.
        let v = cross(lanes, self.edges[1], q);
        let minus_w = cross(lanes, self.edges[0], q);
        let zero = lanes.splat(0.0);
        let w = lanes.sub(zero, minus_w);
        let u = lanes.sub(lanes.sub(minus_w, v), self.area);
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        (lanes.le(lanes.sub(zero, self.tolerance), least) | lanes.le(most, self.tolerance)) & self.lanes
    }
}

#[inline(always)]
fn edge<L: NodeLanes>(lanes: L, to: [&[f32]; 3], from: [L::F; 3]) -> [L::F; 3] {
    [
        lanes.sub(lanes.load(to[0]), from[0]),
        lanes.sub(lanes.load(to[1]), from[1]),
        lanes.sub(lanes.load(to[2]), from[2]),
    ]
}

/// Along the rays into the plane.
#[inline(always)]
fn turned<L: NodeLanes>(lanes: L, p: [L::F; 3], sx: L::F, sy: L::F) -> [L::F; 2] {
    [lanes.sub(p[0], lanes.mul(sx, p[2])), lanes.sub(p[1], lanes.mul(sy, p[2]))]
}

#[inline(always)]
fn cross<L: NodeLanes>(lanes: L, p: [L::F; 2], q: [L::F; 2]) -> L::F {
    lanes.sub(lanes.mul(p[0], q[1]), lanes.mul(p[1], q[0]))
}

/// The largest magnitude of three numbers.
#[inline(always)]
fn largest<L: NodeLanes>(lanes: L, p: [L::F; 3]) -> L::F {
    let most = lanes.max(lanes.max(p[0], p[1]), p[2]);
    let least = lanes.min(lanes.min(p[0], p[1]), p[2]);
    lanes.max(most, lanes.sub(lanes.splat(0.0), least))
}
