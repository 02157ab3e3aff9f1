//! How the rays of a packet meet the boxes of a node one by one, eight children at a time.
//!
//! The planes of the node are loaded once for all of them, and no ray waits for the one before: a dozen cycles each.

use super::super::tree::WideNode;
use super::{NODE_PER_TRIANGLE, PACKET, Packet, Reached};
use crate::lanes::{Lanes, NodeLanes};

/// A ray as the test of one ray against eight boxes needs it, numbers side by side.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
pub(super) struct Record {
    inverse: [f32; 3],
    /// Where the ray meets the tree's base planes, less and plus the node margin.
    near: [f32; 3],
    far: [f32; 3],
    tmin: f32,
    tmax: f32,
}

pub(super) const NO_RECORD: Record =
    Record { inverse: [0.0; 3], near: [0.0; 3], far: [0.0; 3], tmin: 0.0, tmax: 0.0 };

/// The planes of a node's children where rays of one kind enter and leave.
struct OctantPlanes<L: Lanes> {
    near: [L::F; 3],
    far: [L::F; 3],
}

impl<L: NodeLanes> OctantPlanes<L> {
    #[inline(always)]
    fn new(lanes: L, packet: &Packet, node: &WideNode) -> Self {
        let n = packet.kind.is_negative;
        let near = [
            lanes.load(&node.planes[usize::from(n[0])]),
            lanes.load(&node.planes[2 + usize::from(n[1])]),
            lanes.load(&node.planes[4 + usize::from(n[2])]),
        ];
        let far = [
            lanes.load(&node.planes[1 - usize::from(n[0])]),
            lanes.load(&node.planes[3 - usize::from(n[1])]),
            lanes.load(&node.planes[5 - usize::from(n[2])]),
        ];
        OctantPlanes { near, far }
    }
}

impl Packet {
    /// Which children of a node each ray of `mask` meets.
    #[inline(always)]
    pub fn reach_alone<L: NodeLanes>(&mut self, lanes: L, node: &WideNode, mask: u64) -> Reached {
        self.record(mask);
        let planes = OctantPlanes::new(lanes, self, node);
        let mut sets = lanes.no_sets();
        let mut mask = mask;
        while mask != 0 {
            let ray = mask.trailing_zeros() as usize;
            let bit = mask & mask.wrapping_neg();
            mask ^= bit;
            let met = self.meets_alone(lanes, &planes, ray);
            sets = lanes.add_to_sets(sets, met, bit);
        }
        Reached::new(lanes, sets)
    }

    /// Makes the records of the rays of `mask` that have none yet.
    #[inline(always)]
    fn record(&mut self, mask: u64) {
        let mut missing = mask & !self.recorded;
        self.recorded |= mask;
        while missing != 0 {
            let i = missing.trailing_zeros() as usize & (PACKET - 1);
            missing &= missing - 1;
            let record = &mut self.records[i];
            for axis in 0..3 {
                let margin = self.triangle_margin[axis][i] * NODE_PER_TRIANGLE;
                record.inverse[axis] = self.inverse[axis][i];
                record.near[axis] = self.start[axis][i] - margin;
                record.far[axis] = self.start[axis][i] + margin;
            }
            record.tmin = self.tmin[i];
            record.tmax = self.tmax[i];
        }
    }

    /// Which children one ray of those recorded meets.
    #[inline(always)]
    fn meets_alone<L: NodeLanes>(&self, lanes: L, planes: &OctantPlanes<L>, ray: usize) -> u32 {
        let record = &self.records[ray & (PACKET - 1)];
        let (ix, iy, iz) =
            (lanes.splat(record.inverse[0]), lanes.splat(record.inverse[1]), lanes.splat(record.inverse[2]));
        let nx = lanes.mul_add(planes.near[0], ix, lanes.splat(record.near[0]));
        let ny = lanes.mul_add(planes.near[1], iy, lanes.splat(record.near[1]));
        let nz = lanes.mul_add(planes.near[2], iz, lanes.splat(record.near[2]));
        let fx = lanes.mul_add(planes.far[0], ix, lanes.splat(record.far[0]));
        let fy = lanes.mul_add(planes.far[1], iy, lanes.splat(record.far[1]));
        let fz = lanes.mul_add(planes.far[2], iz, lanes.splat(record.far[2]));
        let entry = lanes.max(lanes.max(nx, ny), lanes.max(nz, lanes.splat(record.tmin)));
        let exit = lanes.min(lanes.min(fx, fy), lanes.min(fz, lanes.splat(record.tmax)));
        lanes.le(entry, exit)
    }
}
