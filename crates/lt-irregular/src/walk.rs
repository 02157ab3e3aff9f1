//! Points through a tree: in streams that are thinned out on the way down, one by one where few are left.

use crate::block::{ASKS, Answer, Block, NOBODY};
use crate::casters::Query;
use crate::exact::Exact;
use crate::rect::Rect;
use crate::tree::{LEAF, Tree};
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::lanes::{Lanes, NodeLanes};
use lt_bvh::{AnyHit, RayTest};
use lt_math::glam::Vec3;

/// Room behind every list, so that whole registers may be written at its end.
const SLACK: usize = 16;
/// Nearness of a point that is settled: nothing is beyond it.
const SETTLED: f32 = f32::INFINITY;
/// Up to this many points a subtree is walked point by point.
const FEW: usize = 6;
/// Levels that a walk point by point can hold; a tree over so many triangles that fit memory has fewer.
const DEPTH: usize = 64;

/// Rays of one view, as points, and the lists on the way down.
#[derive(Default)]
pub(crate) struct Stream {
    /// Light space, by place in the stream; z is [`SETTLED`] once the point is blocked.
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    origins: Vec<Vec3>,
    /// Places in the caller's list.
    sources: Vec<u32>,
    /// Points in it; the lists above have room to spare.
    len: usize,
    lists: Lists,
    path: Vec<Step>,
    /// Points blocked so far.
    blocked: usize,
}

/// A node that is being passed through.
struct Step {
    node: u32,
    /// The child that comes next.
    slot: usize,
    /// Its list.
    start: usize,
    len: usize,
    /// What was blocked when the list was last purged.
    blocked: usize,
}

/// Lists of points, one behind the other.
#[derive(Default)]
struct Lists {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    /// Places in the stream.
    ids: Vec<u32>,
}

impl Lists {
    fn reserve(&mut self, end: usize) {
        if self.x.len() < end + SLACK {
            let len = (end + SLACK).next_power_of_two();
            self.x.resize(len, 0.0);
            self.y.resize(len, 0.0);
            self.z.resize(len, SETTLED);
            self.ids.resize(len, 0);
        }
    }
}

impl Stream {
    /// Takes the rays that the view takes; how many.
    #[inline(always)]
    pub fn fill<P: Lanes>(&mut self, lanes: P, view: &View, origins: &[Vec3]) -> usize {
        let room = origins.len() + SLACK;
        for list in [&mut self.x, &mut self.y, &mut self.z] {
            list.resize(room, 0.0);
        }
        self.origins.resize(room, Vec3::ZERO);
        self.sources.resize(room, 0);
        self.blocked = 0;
        let [x, y, z] = view.axes();
        let mut len = 0;
        for (chunk, some) in origins.chunks(P::WIDTH).enumerate() {
            // What is not given starts nowhere, which no view takes.
            let mut o = [[f32::NAN; 16]; 3];
            for (i, from) in some.iter().enumerate() {
                (o[0][i], o[1][i], o[2][i]) = (from[x], from[y], from[z]);
            }
            let (point, taken) =
                view.points(lanes, [lanes.load(&o[0]), lanes.load(&o[1]), lanes.load(&o[2])]);
            lanes.compress(taken, point[0], &mut self.x[len..]);
            lanes.compress(taken, point[1], &mut self.y[len..]);
            lanes.compress(taken, point[2], &mut self.z[len..]);
            let mut rest = taken;
            while rest != 0 {
                let i = rest.trailing_zeros() as usize;
                rest &= rest - 1;
                self.origins[len] = some[i];
                self.sources[len] = (chunk * P::WIDTH + i) as u32;
                len += 1;
            }
        }
        self.len = len;
        len
    }

    /// The caller's places of the points that are blocked.
    pub fn blocked(&self) -> impl Iterator<Item = usize> + '_ {
        self.z[..self.len].iter().zip(&self.sources).filter(|(z, _)| **z == SETTLED).map(|(_, s)| *s as usize)
    }

    /// Walks the tree with all points.
    #[inline(always)]
    pub fn walk<L: NodeLanes, A: AnyHit>(&mut self, lanes: L, tree: &Tree, query: &Query<'_, A>) {
        let len = self.len;
        if tree.nodes.is_empty() || len == 0 {
            return;
        }
        self.lists.reserve(len);
        self.lists.x[..len].copy_from_slice(&self.x[..len]);
        self.lists.y[..len].copy_from_slice(&self.y[..len]);
        self.lists.z[..len].copy_from_slice(&self.z[..len]);
        for (i, id) in self.lists.ids[..len].iter_mut().enumerate() {
            *id = i as u32;
        }
        self.descend(lanes, tree, query, len);
    }

    /// Passes the first list down the tree. A loop and not a recursion: a function that calls itself is not inlined, and so would
    /// not be compiled for the instructions that it is asked to use.
    #[inline(always)]
    fn descend<L: NodeLanes, A: AnyHit>(&mut self, lanes: L, tree: &Tree, query: &Query<'_, A>, len: usize) {
        let mut path = core::mem::take(&mut self.path);
        path.push(Step { node: 0, slot: 0, start: 0, len, blocked: self.blocked });
        while let Some(step) = path.last_mut() {
            let node = &tree.nodes[step.node as usize];
            let slot = step.slot;
            if slot == node.links.len() || node.x0[slot] > node.x1[slot] {
                path.pop();
                continue;
            }
            step.slot += 1;
            if self.blocked != step.blocked {
                step.blocked = self.blocked;
                step.len = self.purge(step.start, step.len);
            }
            let to = step.start + step.len;
            let found = self.filter(lanes.rays(), &node.rect(slot), step.start, step.len);
            if found == 0 {
                continue;
            }
            let link = node.links[slot];
            if link & LEAF != 0 {
                self.leaf(lanes.rays(), tree, query, tree.block(link), to, found);
            } else if found > FEW {
                path.push(Step { node: link, slot: 0, start: to, len: found, blocked: self.blocked });
            } else {
                for i in to..to + found {
                    let id = self.lists.ids[i];
                    let point = [self.lists.x[i], self.lists.y[i], self.lists.z[i]];
                    if walk_one(lanes, tree, query, link, self.origins[id as usize], point) {
                        self.settle(id);
                    }
                }
            }
        }
        self.path = path;
    }

    fn settle(&mut self, id: u32) {
        self.z[id as usize] = SETTLED;
        self.blocked += 1;
    }

    /// Drops what is settled from a list; its new length.
    fn purge(&mut self, start: usize, len: usize) -> usize {
        let lists = &mut self.lists;
        let mut to = start;
        for i in start..start + len {
            let id = lists.ids[i];
            (lists.x[to], lists.y[to], lists.z[to], lists.ids[to]) = (lists.x[i], lists.y[i], lists.z[i], id);
            to += usize::from(self.z[id as usize] != SETTLED);
        }
        to - start
    }

    /// Writes the points of a list that lie in a rectangle and are not beyond it behind the list; how many.
    #[inline(always)]
    fn filter<P: Lanes>(&mut self, lanes: P, rect: &Rect, start: usize, len: usize) -> usize {
        let mut to = start + len;
        self.lists.reserve(start + 2 * len + SLACK);
        let lists = &mut self.lists;
        let (x0, x1) = (lanes.splat(rect.x0), lanes.splat(rect.x1));
        let (y0, y1) = (lanes.splat(rect.y0), lanes.splat(rect.y1));
        let far = lanes.splat(rect.z);
        let mut at = start;
        while at < start + len {
            let (x, y, z) =
                (lanes.load(&lists.x[at..]), lanes.load(&lists.y[at..]), lanes.load(&lists.z[at..]));
            let mut mask =
                lanes.le(x0, x) & lanes.le(x, x1) & lanes.le(y0, y) & lanes.le(y, y1) & lanes.le(z, far);
            mask &= first(start + len - at);
            if mask != 0 {
                let mut ids = [0; 16];
                ids[..P::WIDTH].copy_from_slice(&lists.ids[at..at + P::WIDTH]);
                lanes.compress(mask, x, &mut lists.x[to..]);
                lanes.compress(mask, y, &mut lists.y[to..]);
                lanes.compress(mask, z, &mut lists.z[to..]);
                lanes.compress_words(mask, &ids, &mut lists.ids[to..]);
                to += mask.count_ones() as usize;
            }
            at += P::WIDTH;
        }
        to - start - len
    }

    /// Holds a list against a block.
    #[inline(always)]
    fn leaf<P: Lanes, A: AnyHit>(
        &mut self,
        lanes: P,
        tree: &Tree,
        query: &Query<'_, A>,
        block: &Block,
        start: usize,
        len: usize,
    ) {
        let (constant, factor) = tree.view.depth_tolerance();
        let (constant, factor) = (lanes.splat(constant), lanes.splat(factor));
        // No lane beyond the list is ever possible.
        self.lists.z[start + len..start + len + SLACK].fill(SETTLED);
        for (slot, &id) in block.ids.iter().enumerate() {
            if id == NOBODY {
                break;
            }
            let planes = block.spread_out(lanes, slot);
            let mut at = start;
            while at < start + len {
                let x = lanes.load(&self.lists.x[at..]);
                let y = lanes.load(&self.lists.y[at..]);
                let z = lanes.load(&self.lists.z[at..]);
                let answer = planes.test(lanes, x, y, z, lanes.mul_add(factor, z, constant));
                if answer.possible != 0 {
                    self.decide(lanes, tree, query, id, at, answer);
                }
                at += P::WIDTH;
            }
        }
    }

    /// Settles the points of a register that a triangle blocks.
    #[inline(always)]
    fn decide<P: Lanes, A: AnyHit>(
        &mut self,
        lanes: P,
        tree: &Tree,
        query: &Query<'_, A>,
        triangle: u32,
        at: usize,
        answer: Answer,
    ) {
        let asks = !A::IS_OPAQUE && triangle & ASKS != 0;
        let mut blocked = if asks { 0 } else { answer.sure };
        let unsure = answer.possible & !blocked;
        if unsure != 0 {
            let index = triangle & !ASKS;
            let exact = Exact::new(&tree.view, &query.casters.triangles[index as usize]);
            let origin = self.origins(lanes, tree, at);
            blocked |= query.blocked(lanes, &tree.view, index, &exact, origin, unsure);
        }
        while blocked != 0 {
            let i = at + blocked.trailing_zeros() as usize;
            blocked &= blocked - 1;
            self.lists.z[i] = SETTLED;
            self.settle(self.lists.ids[i]);
        }
    }

    /// The origins of a register of a list, in permuted axes; what lies beyond the list is anything.
    #[inline(always)]
    fn origins<P: Lanes>(&self, lanes: P, tree: &Tree, at: usize) -> [P::F; 3] {
        let [x, y, z] = tree.view.axes();
        let mut o = [[0.0; 16]; 3];
        for (lane, &id) in self.lists.ids[at..at + P::WIDTH].iter().enumerate() {
            let from = self.origins[(id as usize).min(self.origins.len() - 1)];
            (o[0][lane], o[1][lane], o[2][lane]) = (from[x], from[y], from[z]);
        }
        [lanes.load(&o[0]), lanes.load(&o[1]), lanes.load(&o[2])]
    }
}

/// The lowest bits, as many as `count`.
#[inline(always)]
fn first(count: usize) -> u32 {
    if count >= 32 { u32::MAX } else { (1 << count) - 1 }
}

/// Whether anything below `link` blocks one point.
#[inline(always)]
pub(crate) fn walk_one<E: Lanes, A: AnyHit>(
    lanes: E,
    tree: &Tree,
    query: &Query<'_, A>,
    link: u32,
    origin: Vec3,
    point: [f32; 3],
) -> bool {
    let (constant, factor) = tree.view.depth_tolerance();
    let tolerance = constant + factor * point[2];
    let around = Rect { x0: point[0], x1: point[0], y0: point[1], y1: point[1], z: point[2] };
    let mut test = None;
    let mut stack = [(0u32, 0u32); DEPTH];
    let mut top = 0;
    let mut at = link;
    let mut hits = tree.nodes[at as usize].hits(lanes, &around);
    loop {
        if hits == 0 {
            if top == 0 {
                return false;
            }
            top -= 1;
            (at, hits) = stack[top];
            continue;
        }
        let link = tree.nodes[at as usize].links[hits.trailing_zeros() as usize & 7];
        hits &= hits - 1;
        if link & LEAF == 0 {
            if hits != 0 && top < DEPTH {
                stack[top] = (at, hits);
                top += 1;
            }
            at = link;
            hits = tree.nodes[at as usize].hits(lanes, &around);
        } else if is_blocked_by(lanes, query, tree.block(link), origin, point, tolerance, &mut test) {
            return true;
        }
    }
}

/// Whether a triangle of a block blocks one point. `test` is made on the first use.
#[inline(always)]
fn is_blocked_by<E: Lanes, A: AnyHit>(
    lanes: E,
    query: &Query<'_, A>,
    block: &Block,
    origin: Vec3,
    point: [f32; 3],
    tolerance: f32,
    test: &mut Option<Option<RayTest>>,
) -> bool {
    let answer = block.test_one(lanes, point, tolerance);
    let mut possible = answer.possible;
    while possible != 0 {
        let slot = possible.trailing_zeros();
        possible &= possible - 1;
        let id = block.ids[slot as usize & 7];
        let asks = !A::IS_OPAQUE && id & ASKS != 0;
        if answer.sure >> slot & 1 == 1 && !asks {
            return true;
        }
        let Some(test) = test.get_or_insert_with(|| query.test(origin)) else { return false };
        let index = id & !ASKS;
        if test.is_blocked_by(&query.casters.triangles[index as usize], index, query.any_hit) {
            return true;
        }
    }
    false
}
