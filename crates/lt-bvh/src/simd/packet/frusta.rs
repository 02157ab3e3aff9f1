//! How groups of a packet's rays meet the boxes of a node: first the bounds of each group, eight children at a time, then
//! the rays of the group themselves for each child that remains.

use super::super::tree::{SimdTree, WideNode};
use super::{NODE_PER_TRIANGLE, PACKET, Packet, Reached, bits_at, piece};
use crate::lanes::{Lanes, NodeLanes};

/// Children that a group's bounds meet, beyond which testing its rays one by one costs less.
const SPREAD: u32 = 4;

/// Most groups of ray lanes in a packet.
const GROUPS: usize = PACKET / 8;

/// Bounds of everything that a box test depends on, for each group of ray lanes.
pub(crate) struct Frusta<L: NodeLanes> {
    /// Where the origin of a group's rays lies, as the entry planes and as the exit planes see it worst. For parallel rays
    /// what is to be added to a plane's distance in units of t, else the origin itself, from the tree's base.
    near: [[f32; GROUPS]; 3],
    far: [[f32; GROUPS]; 3],
    inverse_low: [L::F; 3],
    inverse_high: [L::F; 3],
    margin: [L::F; 3],
    tmin: L::F,
    tmax: L::F,
    entry: [usize; 3],
    is_parallel: bool,
    /// The packet's ends: the least tmin and the greatest tmax.
    ends: (<L::Rays as Lanes>::F, <L::Rays as Lanes>::F),
    /// Of the node at hand.
    planes: Planes,
}

/// The planes of a node's children where rays enter and leave: for parallel rays in units of t, with the node margin, else
/// as the node has them.
struct Planes {
    near: [[f32; 8]; 3],
    far: [[f32; 8]; 3],
}

impl Planes {
    fn none() -> Self {
        Planes { near: [[0.0; 8]; 3], far: [[0.0; 8]; 3] }
    }
}

/// Smallest and largest of the first `len` numbers, a multiple of eight of them read.
#[inline(always)]
fn extremes(numbers: &[f32], len: usize) -> (f32, f32) {
    let (mut low, mut high) = ([numbers[0]; 8], [numbers[0]; 8]);
    for eight in numbers.chunks_exact(8).take(len.div_ceil(8)) {
        for i in 0..8 {
            low[i] = if eight[i] < low[i] { eight[i] } else { low[i] };
            high[i] = if eight[i] > high[i] { eight[i] } else { high[i] };
        }
    }
    let mut half = 4;
    while half > 0 {
        for i in 0..half {
            low[i] = if low[i + half] < low[i] { low[i + half] } else { low[i] };
            high[i] = if high[i + half] > high[i] { high[i + half] } else { high[i] };
        }
        half /= 2;
    }
    (low[0], high[0])
}

impl Packet {
    /// Bounds of the packet's groups for their box tests; `tree` is that of [`Packet::prepare`].
    #[inline(always)]
    pub fn frusta<L: NodeLanes>(&self, lanes: L, tree: &SimdTree) -> Frusta<L> {
        let zero = lanes.splat(0.0);
        let (tmin, tmax) = (extremes(&self.tmin, self.len).0, extremes(&self.tmax, self.len).1);
        let mut frusta = Frusta {
            near: [[0.0; GROUPS]; 3],
            far: [[0.0; GROUPS]; 3],
            inverse_low: [zero; 3],
            inverse_high: [zero; 3],
            margin: [zero; 3],
            tmin: lanes.splat(tmin),
            tmax: lanes.splat(tmax),
            entry: [0; 3],
            is_parallel: self.is_parallel,
            ends: (lanes.rays().splat(tmin), lanes.rays().splat(tmax)),
            planes: Planes::none(),
        };
        for axis in 0..3 {
            let is_negative = self.kind.is_negative[axis];
            let first = self.inverse[axis][0];
            let (low, high) =
                if self.is_parallel { (first, first) } else { extremes(&self.inverse[axis], self.len) };
            let margin = extremes(&self.triangle_margin[axis], self.len).1 * NODE_PER_TRIANGLE;
            frusta.inverse_low[axis] = lanes.splat(low);
            frusta.inverse_high[axis] = lanes.splat(high);
            frusta.margin[axis] = lanes.splat(margin);
            frusta.entry[axis] = 2 * axis + usize::from(is_negative);
            let mut at = 0;
            while at < self.len {
                let width = <L::Rays as Lanes>::WIDTH;
                let (least, most) = extremes(&self.origin[axis][at..at + width], width);
                let (near, far) = if is_negative { (least, most) } else { (most, least) };
                let (near, far) = (near - tree.base[axis], far - tree.base[axis]);
                let group = at / width;
                (frusta.near[axis][group], frusta.far[axis][group]) =
                    if self.is_parallel { (-(near * first), -(far * first)) } else { (near, far) };
                at += width;
            }
        }
        frusta
    }

    /// Which rays of the group that starts at `at` meet the box of a child between the packet's ends.
    #[inline(always)]
    fn meets<R: Lanes>(&self, rays: R, planes: &Planes, child: usize, at: usize, ends: (R::F, R::F)) -> u32 {
        let child = child & 7;
        let mut entry = ends.0;
        let mut exit = ends.1;
        for axis in 0..3 {
            let near = rays.splat(planes.near[axis][child]);
            let far = rays.splat(planes.far[axis][child]);
            let start = piece(rays, &self.start[axis], at);
            if self.is_parallel {
                entry = rays.max(entry, rays.add(near, start));
                exit = rays.min(exit, rays.add(far, start));
            } else {
                let inverse = piece(rays, &self.inverse[axis], at);
                let margin =
                    rays.mul(piece(rays, &self.triangle_margin[axis], at), rays.splat(NODE_PER_TRIANGLE));
                entry = rays.max(entry, rays.sub(rays.mul_add(near, inverse, start), margin));
                exit = rays.min(exit, rays.add(rays.mul_add(far, inverse, start), margin));
            }
        }
        rays.le(entry, exit)
    }
}

impl<L: NodeLanes> Frusta<L> {
    /// Which children of a node each ray of `mask` meets, and whether the rays fall apart there: then the bounds of groups
    /// tell little about their rays, here and in all that lies below.
    #[inline(always)]
    pub fn reach(&mut self, lanes: L, packet: &Packet, node: &WideNode, mask: u64) -> (Reached, bool) {
        let mut reached = Reached { rays: [0; 8], children: 0 };
        let (mut groups, mut candidates) = (0, 0);
        let mut at = 0;
        self.read(lanes, node);
        while at < PACKET {
            let group = bits_at::<L::Rays>(mask, at);
            if group != 0 {
                let mut may_meet = self.test(lanes, at / <L::Rays as Lanes>::WIDTH);
                groups += 1;
                candidates += may_meet.count_ones();
                while may_meet != 0 {
                    let child = may_meet.trailing_zeros() as usize & 7;
                    may_meet &= may_meet - 1;
                    let met = packet.meets(lanes.rays(), &self.planes, child, at, self.ends) & group;
                    reached.rays[child] |= u64::from(met) << at;
                    reached.children |= u32::from(met != 0) << child;
                }
            }
            at += <L::Rays as Lanes>::WIDTH;
        }
        (reached, candidates > SPREAD * groups)
    }

    /// Which children of a node each ray of `mask` meets, ray by ray, eight children at a time; of parallel rays, which share all but
    /// where they start.
    #[inline(always)]
    pub fn reach_alone(&self, lanes: L, packet: &Packet, node: &WideNode, mask: u64) -> Reached {
        let (x, y, z) = (self.slab(lanes, node, 0), self.slab(lanes, node, 1), self.slab(lanes, node, 2));
        let mut sets = lanes.no_sets();
        let mut mask = mask;
        while mask != 0 {
            let ray = mask.trailing_zeros() as usize & (PACKET - 1);
            let bit = mask & mask.wrapping_neg();
            mask ^= bit;
            let sx = lanes.splat(packet.start[0][ray]);
            let sy = lanes.splat(packet.start[1][ray]);
            let sz = lanes.splat(packet.start[2][ray]);
            // The packet's ends first, which may be NaN.
            let entry = lanes.max(
                lanes.max(lanes.add(x.0, sx), lanes.add(y.0, sy)),
                lanes.max(self.tmin, lanes.add(z.0, sz)),
            );
            let exit = lanes.min(
                lanes.min(lanes.add(x.1, sx), lanes.add(y.1, sy)),
                lanes.min(self.tmax, lanes.add(z.1, sz)),
            );
            sets = lanes.add_to_sets(sets, lanes.le(entry, exit), bit);
        }
        Reached::new(lanes, sets)
    }

    /// A node's planes along an axis, of entry and of exit, in units of t with the node margin; for parallel rays.
    #[inline(always)]
    fn slab(&self, lanes: L, node: &WideNode, axis: usize) -> (L::F, L::F) {
        let near = lanes.load(&node.planes[self.entry[axis]]);
        let far = lanes.load(&node.planes[self.entry[axis] ^ 1]);
        let (inverse, margin) = (self.inverse_low[axis], self.margin[axis]);
        (lanes.sub(lanes.mul(near, inverse), margin), lanes.add(lanes.mul(far, inverse), margin))
    }

    /// Reads a node's planes for [`Frusta::test`] and [`Packet::meets`].
    #[inline(always)]
    fn read(&mut self, lanes: L, node: &WideNode) {
        for axis in 0..3 {
            let (near, far) = if self.is_parallel {
                self.slab(lanes, node, axis)
            } else {
                let entry = self.entry[axis];
                (lanes.load(&node.planes[entry]), lanes.load(&node.planes[entry ^ 1]))
            };
            lanes.store(near, &mut self.planes.near[axis]);
            lanes.store(far, &mut self.planes.far[axis]);
        }
    }

    /// Which children any ray of a group may meet.
    #[inline(always)]
    fn test(&self, lanes: L, group: usize) -> u32 {
        let group = group & (GROUPS - 1);
        let mut entry = self.tmin;
        let mut exit = self.tmax;
        for axis in 0..3 {
            let near = lanes.load(&self.planes.near[axis]);
            let far = lanes.load(&self.planes.far[axis]);
            let (near_origin, far_origin) =
                (lanes.splat(self.near[axis][group]), lanes.splat(self.far[axis][group]));
            if self.is_parallel {
                entry = lanes.max(entry, lanes.add(near, near_origin));
                exit = lanes.min(exit, lanes.add(far, far_origin));
            } else {
                let (near, far) = (lanes.sub(near, near_origin), lanes.sub(far, far_origin));
                let (low, high) = (self.inverse_low[axis], self.inverse_high[axis]);
                let first = lanes.min(lanes.mul(near, low), lanes.mul(near, high));
                let last = lanes.max(lanes.mul(far, low), lanes.mul(far, high));
                entry = lanes.max(entry, lanes.sub(first, self.margin[axis]));
                exit = lanes.min(exit, lanes.add(last, self.margin[axis]));
            }
        }
        lanes.le(entry, exit)
    }
}
