//! Parallel rays as points of the plane across them: few against eight triangles at a time, many side by side against one after another.
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

use super::super::tree::Block;
use super::{PACKET, Packet, bits_at, piece, set};
use crate::lanes::watertight::{axes, cross, minus, sheared, spread};
use crate::lanes::{Lanes, NodeLanes};
use lt_math::glam::Vec3;

const EPSILON: f32 = 1.0 / 16_777_216.0;
const EDGE: f32 = 320.0;
const CORNER: f32 = 4096.0;
/// Rays that, one by one, take as long against a block as a group of ray lanes against one of its triangles.
const PER_GROUP: u32 = 2;

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
        let [ix, iy, iz] = axes(self.kind.axis);
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
        if mask.count_ones() > PER_GROUP * Packet::groups_of::<L::Rays>(mask) * block.len() as u32 {
            let rows = across.stored(lanes);
            let mut sets = [0; 8];
            for (lane, set) in sets.iter_mut().enumerate().take(block.len()) {
                *set = self.may_hit_one(lanes.rays(), &rows, lane, mask);
            }
            return sets;
        }
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

    /// Which of the rays of `mask` the triangle of a lane may block, rays side by side.
    #[inline(always)]
    fn may_hit_one<R: Lanes>(&self, rays: R, rows: &[[f32; 8]; 8], lane: usize, mask: u64) -> u64 {
        let one = Across::spread(rays, rows, lane & 7);
        let mut found = 0;
        let mut at = 0;
        while at < PACKET {
            if bits_at::<R>(mask, at) != 0 {
                let point = [piece(rays, &self.points[0], at), piece(rays, &self.points[1], at)];
                found |= u64::from(one.may_hold(rays, point)) << at;
            }
            at += R::WIDTH;
        }
        found & mask
    }

    /// The triangles of a block.
    #[inline(always)]
    fn across<L: NodeLanes>(&self, lanes: L, block: Block) -> Across<L> {
        let [ix, iy, iz] = axes(self.kind.axis);
        let from = self.rays[0].origin;
        let from = Vec3::new(from[ix], from[iy], from[iz]);
        let shear = [lanes.splat(self.shear[0][0]), lanes.splat(self.shear[1][0])];
        let (x, y, z) = (block.rows(ix), block.rows(iy), block.rows(iz));
        let v0 = [lanes.load(x[0]), lanes.load(y[0]), lanes.load(z[0])];
        let v1 = [lanes.load(x[1]), lanes.load(y[1]), lanes.load(z[1])];
        let v2 = [lanes.load(x[2]), lanes.load(y[2]), lanes.load(z[2])];
        let (e, f) = (minus(lanes, v1, v0), minus(lanes, v2, v0));
        let base = minus(lanes, v0, spread(lanes, from));
        let edges = [sheared(lanes, e, shear), sheared(lanes, f, shear)];
        let size = lanes.max(largest(lanes, e), largest(lanes, f));
        let reach = self.reach;
        let per_size = lanes.mul(lanes.splat(EDGE * EPSILON), lanes.add(size, lanes.splat(reach)));
        let corner = CORNER * EPSILON * reach * (EPSILON * reach);
        Across {
            first: sheared(lanes, base, shear),
            edges,
            area: cross(lanes, edges[0], edges[1]),
            tolerance: lanes.mul_add(size, per_size, lanes.splat(corner)),
            lanes: block.lanes(),
        }
    }
}

impl<L: Lanes> Across<L> {
    /// Number by number: the first vertex, the edges, the area and the tolerance.
    #[inline(always)]
    fn stored(&self, lanes: L) -> [[f32; 8]; 8] {
        let ([e, f], mut rows) = (self.edges, [[0.0; 8]; 8]);
        let numbers = [self.first[0], self.first[1], e[0], e[1], f[0], f[1], self.area, self.tolerance];
        for (row, numbers) in rows.iter_mut().zip(numbers) {
            lanes.store(numbers, row);
        }
        rows
    }

    /// One triangle of those [`Across::stored`], in all lanes.
    #[inline(always)]
    fn spread(lanes: L, [x, y, ex, ey, fx, fy, area, tolerance]: &[[f32; 8]; 8], lane: usize) -> Self {
        let e = [lanes.splat(ex[lane]), lanes.splat(ey[lane])];
        let f = [lanes.splat(fx[lane]), lanes.splat(fy[lane])];
        Across {
            first: [lanes.splat(x[lane]), lanes.splat(y[lane])],
            edges: [e, f],
            area: lanes.splat(area[lane]),
            tolerance: lanes.splat(tolerance[lane]),
            lanes: L::ALL,
        }
    }

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

/// The largest magnitude of three numbers.
#[inline(always)]
fn largest<L: NodeLanes>(lanes: L, p: [L::F; 3]) -> L::F {
    let most = lanes.max(lanes.max(p[0], p[1]), p[2]);
    let least = lanes.min(lanes.min(p[0], p[1]), p[2]);
    lanes.max(most, lanes.sub(lanes.splat(0.0), least))
}

#[cfg(test)]
mod tests {
    use super::super::{Kind, Run};
    use super::*;
    use crate::build::{BuildQuality, Bvh};
    use crate::lanes::Portable;
    use crate::ray::Ray;
    use crate::slab::{Slab, WHOLE_RAY};
    use crate::triangle::Shear;
    use std::vec::Vec;

    /// Numbers in 0..1.
    fn random(state: &mut u64) -> f32 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as f32 / (1 << 24) as f32
    }

    fn random_point(state: &mut u64) -> Vec3 {
        Vec3::new(random(state), random(state), random(state))
    }

    /// Four triangles, two of them slivers, within `size` of `centre`; and rays that pass their vertices and edges by a few roundings.
    fn grazing(state: &mut u64, centre: Vec3, size: f32) -> (Bvh, Vec<Ray>) {
        let mut positions: Vec<Vec3> = (0..12).map(|_| centre + random_point(state) * size).collect();
        for sliver in [0, 3] {
            let along = positions[sliver + 1] - positions[sliver];
            positions[sliver + 2] = positions[sliver] + along * 0.4 + random_point(state) * (size * 1e-4);
        }
        let indices: Vec<[u32; 3]> = (0..4).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        let bvh = Bvh::build(&positions, &indices, |_| true, BuildQuality::Medium).unwrap();
        let direction = Vec3::new(0.3 * random(state), 1.0, -0.8 * random(state));
        let rays = (0..PACKET).map(|_| {
            let triangle = &indices[(random(state) * 4.0) as usize & 3];
            let [a, b] = [0, 1].map(|k| positions[triangle[k] as usize]);
            let on_edge = a.lerp(b, [0.0, 1.0, random(state)][(random(state) * 3.0) as usize % 3]);
            let back = size * 8.0 * random(state);
            Ray::new(on_edge - direction * back, direction)
        });
        let rays = rays.collect();
        (bvh, rays)
    }

    #[test]
    fn what_is_ruled_out_is_missed_and_without_tolerance_would_not_be() {
        let (mut state, mut hits, mut saved) = (1, 0, 0);
        for case in 0..400 {
            let size = [0.01, 1.0, 300.0][case % 3];
            let centre = random_point(&mut state) * [0.0, 10.0, 4000.0][case / 3 % 3];
            let (bvh, rays) = grazing(&mut state, centre, size);
            let part = bvh.simd_part();
            let mut packet = Packet::empty();
            packet.fill(Kind::of(&rays[0]).unwrap(), Run::first(Portable, &rays), &rays, None);
            packet.prepare(Portable, part.tree);
            assert!(packet.is_parallel());
            for link in part.tree.leaf_links() {
                let block = part.tree.block(link);
                let may_hit = packet.may_hit(Portable, block, packet.all());
                let rows = packet.across(Portable, block).stored(Portable);
                for (lane, one_by_one) in may_hit.into_iter().enumerate().take(block.len()) {
                    assert_eq!(packet.may_hit_one(Portable, &rows, lane, packet.all()), one_by_one);
                }
                let exactly = Across { tolerance: [0.0; 8], ..packet.across(Portable, block) };
                for (i, ray) in rays.iter().enumerate() {
                    let slab = Slab::new(ray, part.tree.low, part.tree.high);
                    let point = [[packet.points[0][i]; 8], [packet.points[1][i]; 8]];
                    let may_hold = exactly.may_hold(Portable, point);
                    for (lane, may_hit) in may_hit.into_iter().enumerate().take(block.len()) {
                        let triangle = &bvh.triangles()[block.triangle(lane) as usize];
                        if Shear::new(ray).intersect(ray, &slab, triangle, WHOLE_RAY).is_hit {
                            assert!(may_hit >> i & 1 != 0, "case {case}: {ray:?} hits {triangle:?}");
                            hits += 1;
                            saved += u32::from(may_hold >> lane & 1 == 0);
                        }
                    }
                }
            }
        }
        assert!(hits > 5000 && saved > 100, "{saved} of {hits} hits would be lost without tolerance");
    }
}
