//! Packets of 64 rays down the wide tree, each node with the mask of the rays that reached it.
//!
//! A node is first tested once for each group of ray lanes, eight children at a time, then each child that remains by the
//! rays of the group themselves. Which rays are where is exact at every node, so that a packet of rays that drift apart turns
//! into a stream: rays that share a node's data and nothing else are tested one by one, and while one node's data are
//! fetched others are tested ([`super::visits`]).

use super::packet::{Frusta, Kind, PACKET, Packet, Run, Weights};
use super::prepared::Prepared;
use super::traverse::{self, Instanced, Scratch};
use super::tree::{LEAF, Part, ROOT, SimdTree};
use super::visits::{Visit, Walk};
use crate::any_hit::AnyHit;
use crate::lanes::NodeLanes;
use crate::ray::{NONE, Ray};
use crate::slab::{Span, WHOLE_RAY};

/// Packets of fewer rays do not repay their preparation.
const LEAST_RAYS: usize = 4;

/// What the leaves of a tree hold, and what it means that rays reach them.
trait Leaves<L: NodeLanes> {
    fn tree(&self) -> &SimdTree;
    /// Starts to fetch what a link leads to.
    fn prefetch(&self, link: u32);
    /// Which rays of `mask` a leaf blocks.
    fn blocked(&mut self, lanes: L, packet: &Packet, link: u32, mask: u64) -> u64;
}

/// Which rays of a packet prepared for the tree it blocks.
#[inline(always)]
fn blocked<L: NodeLanes, T: Leaves<L>>(
    lanes: L,
    leaves: &mut T,
    packet: &mut Packet,
    walk: &mut Walk,
) -> u64 {
    let mut frusta: Frusta<L> = packet.frusta(lanes, leaves.tree());
    let mut alive = packet.all();
    if walk.blocker != NONE {
        let found = leaves.blocked(lanes, packet, walk.blocker, alive);
        alive &= !found;
        walk.blocker = if found != 0 { walk.blocker } else { NONE };
    }
    walk.push(Visit { link: ROOT, is_spread: false, rays: alive });
    while let Some(visit) = walk.next(alive, |link| leaves.prefetch(link)) {
        if visit.link & LEAF != 0 {
            let found = leaves.blocked(lanes, packet, visit.link, visit.rays);
            if found != 0 {
                alive &= !found;
                walk.blocker = visit.link;
            }
            continue;
        }
        let node = &leaves.tree().nodes[visit.link as usize];
        let (reached, is_spread) = if visit.is_spread {
            let reached = if packet.is_parallel() {
                frusta.reach_alone(lanes, packet, node, visit.rays)
            } else {
                packet.reach_alone(lanes, node, visit.rays)
            };
            (reached, true)
        } else {
            frusta.reach(lanes, packet, node, visit.rays)
        };
        let mut children = reached.children;
        while children != 0 {
            let child = children.trailing_zeros() as usize & 7;
            children &= children - 1;
            walk.push(Visit { link: node.children[child], is_spread, rays: reached.rays[child] });
        }
    }
    packet.all() & !alive
}

/// Blocks of triangles.
struct Triangles<'a, 's, A> {
    part: Part<'a>,
    any_hit: A,
    weights: &'s mut Weights,
}

impl<L: NodeLanes, A: AnyHit> Leaves<L> for Triangles<'_, '_, A> {
    #[inline(always)]
    fn tree(&self) -> &SimdTree {
        self.part.tree
    }

    #[inline(always)]
    fn prefetch(&self, link: u32) {
        self.part.tree.prefetch(link);
    }

    #[inline(always)]
    fn blocked(&mut self, lanes: L, packet: &Packet, link: u32, mask: u64) -> u64 {
        let rays = lanes.rays();
        let block = self.part.tree.block(link);
        // What either way costs is the number of its tests.
        let are_few = mask.count_ones() < Packet::groups_of::<L::Rays>(mask) * block.len() as u32;
        if are_few && !packet.is_parallel() {
            let (mut rest, mut found) = (mask, 0);
            while rest != 0 {
                let prepared: Prepared<L> = packet.single(lanes, rest.trailing_zeros() as usize);
                if prepared.is_blocked_by(lanes, self.part, link, self.any_hit) {
                    found |= rest & rest.wrapping_neg();
                }
                rest &= rest - 1;
            }
            return found;
        }
        let may_hit = if packet.is_parallel() { packet.may_hit(lanes, block, mask) } else { [mask; 8] };
        let mut alive = mask;
        for (lane, may_hit) in may_hit.into_iter().enumerate().take(block.len()) {
            let near = alive & may_hit;
            if near == 0 {
                continue;
            }
            if A::IS_OPAQUE || !block.asks(lane) {
                alive &= !packet.hits::<_, false>(rays, block, lane, near, self.weights);
                continue;
            }
            let index = self.part.first_triangle + block.triangle(lane);
            let mut candidates = packet.hits::<_, true>(rays, block, lane, near, self.weights);
            while candidates != 0 {
                let ray = candidates.trailing_zeros() as usize & (PACKET - 1);
                candidates &= candidates - 1;
                if self.any_hit.accepts(index, self.weights.u[ray], self.weights.v[ray]) {
                    alive &= !(1 << ray);
                }
            }
        }
        mask & !alive
    }
}

/// Work memory for packets in a tree of triangles.
struct Work {
    packet: Packet,
    walk: Walk,
    weights: Weights,
    scratch: Scratch,
}

impl Work {
    fn new() -> Self {
        Work { packet: Packet::empty(), walk: Walk::new(), weights: Weights::none(), scratch: Scratch::new() }
    }

    /// Which of up to [`PACKET`] rays of one kind the tree blocks.
    #[inline(always)]
    fn blocked<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        part: Part,
        (kind, run): (Kind, Run),
        rays: &[Ray],
        windows: Option<&[Span]>,
        any_hit: A,
    ) -> u64 {
        self.packet.fill(kind, run, rays, windows);
        self.packet.prepare(lanes.rays(), part.tree);
        let mut leaves = Triangles { part, any_hit, weights: &mut self.weights };
        blocked(lanes, &mut leaves, &mut self.packet, &mut self.walk)
    }
}

/// Whether each ray is blocked by one tree in world space.
#[inline(always)]
pub(crate) fn occluded<L: NodeLanes, A: AnyHit>(
    lanes: L,
    part: Part,
    rays: &[Ray],
    any_hit: A,
    out: &mut [bool],
) {
    let mut work = Work::new();
    let mut at = 0;
    while at < rays.len() {
        let run = Run::first(lanes, &rays[at..]);
        let (rays, out) = (&rays[at..at + run.len], &mut out[at..at + run.len]);
        at += run.len;
        match run.kind {
            Some(kind) if run.len >= LEAST_RAYS => {
                let blocked = work.blocked(lanes, part, (kind, run), rays, None, any_hit);
                for (i, out) in out.iter_mut().enumerate() {
                    *out = blocked >> i & 1 != 0;
                }
            }
            _ => {
                for (ray, out) in rays.iter().zip(out) {
                    *out = traverse::occluded(lanes, part, *ray, any_hit, &mut work.scratch);
                }
            }
        }
    }
}

/// Rays in the space of an instance, and which of the packet outside each is.
struct Entered {
    rays: [Ray; PACKET],
    windows: [Span; PACKET],
    outside: [u8; PACKET],
    len: usize,
}

/// Placed trees.
struct Instances<'a, 's, A> {
    view: Instanced<'a>,
    any_hit: A,
    entered: &'s mut Entered,
    work: &'s mut Work,
    /// The instance that `work` was in last.
    last: &'s mut u32,
}

impl<L: NodeLanes, A: AnyHit> Leaves<L> for Instances<'_, '_, A> {
    #[inline(always)]
    fn tree(&self) -> &SimdTree {
        self.view.tlas
    }

    #[inline(always)]
    fn prefetch(&self, link: u32) {
        if link & LEAF == 0 {
            self.view.tlas.prefetch(link);
        }
    }

    #[inline(always)]
    fn blocked(&mut self, lanes: L, packet: &Packet, link: u32, mask: u64) -> u64 {
        let index = link & !LEAF;
        if *self.last != index {
            *self.last = index;
            self.work.walk.blocker = NONE;
        }
        let part = self.view.parts[index as usize];
        let entered = &mut *self.entered;
        entered.len = 0;
        let mut candidates = mask;
        while candidates != 0 {
            let ray = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            let world = packet.ray(ray);
            if let Some((object, window)) = self.view.enter(&packet.slab(ray), &world, world.tmax, index) {
                let at = entered.len & (PACKET - 1);
                (entered.rays[at], entered.windows[at], entered.outside[at]) = (object, window, ray as u8);
                entered.len = at + 1;
            }
        }
        let (mut found, mut at) = (0, 0);
        while at < entered.len {
            let run = Run::first(lanes, &entered.rays[at..entered.len]);
            let end = at + run.len;
            let (rays, windows) = (&entered.rays[at..end], &entered.windows[at..end]);
            let outside = &entered.outside[at..end];
            at = end;
            match run.kind {
                Some(kind) if run.len >= LEAST_RAYS => {
                    let windows = Some(windows);
                    let blocked = self.work.blocked(lanes, part, (kind, run), rays, windows, self.any_hit);
                    for (i, &ray) in outside.iter().enumerate() {
                        found |= (blocked >> i & 1) << ray;
                    }
                }
                _ => {
                    for ((ray, window), &place) in rays.iter().zip(windows).zip(outside) {
                        let prepared = Prepared::new(lanes, *ray, part.tree, *window);
                        let scratch = &mut self.work.scratch;
                        let blocker = traverse::blocker(lanes, part, &prepared, ROOT, self.any_hit, scratch);
                        found |= u64::from(blocker != NONE) << place;
                    }
                }
            }
        }
        found
    }
}

/// Whether each ray is blocked by placed trees.
#[inline(always)]
pub(crate) fn occluded_instanced<L: NodeLanes, A: AnyHit>(
    lanes: L,
    view: Instanced,
    rays: &[Ray],
    any_hit: A,
    out: &mut [bool],
) {
    let mut work = Work::new();
    let mut packet = Packet::empty();
    let mut walk = Walk::new();
    let mut entered = Entered {
        rays: [Ray::default(); PACKET],
        windows: [WHOLE_RAY; PACKET],
        outside: [0; PACKET],
        len: 0,
    };
    let mut last = NONE;
    let mut at = 0;
    while at < rays.len() {
        let run = Run::first(lanes, &rays[at..]);
        let (rays, out) = (&rays[at..at + run.len], &mut out[at..at + run.len]);
        at += run.len;
        match run.kind {
            Some(kind) if run.len >= LEAST_RAYS => {
                packet.fill(kind, run, rays, None);
                packet.prepare(lanes.rays(), view.tlas);
                let (entered, work, last) = (&mut entered, &mut work, &mut last);
                let mut leaves = Instances { view, any_hit, entered, work, last };
                let blocked = blocked(lanes, &mut leaves, &mut packet, &mut walk);
                for (i, out) in out.iter_mut().enumerate() {
                    *out = blocked >> i & 1 != 0;
                }
            }
            _ => {
                for (ray, out) in rays.iter().zip(out) {
                    *out = traverse::occluded_instanced(lanes, view, *ray, any_hit, &mut work.scratch);
                }
            }
        }
    }
}
