//! A part of the samples: a tree in heap order, whose leaves are runs of the samples.

use super::sort::Point;
use super::visit::Paint;
use super::{Counters, Scene};
use crate::block::Spreadout;
use crate::exact::Exact;
use crate::planes::Planes;
use crate::rect::Rect;
use crate::split::Item;
use crate::view::View;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use lt_bvh::lanes::Lanes;
use lt_math::glam::Vec3;

/// Room behind the samples, so that whole registers may be read at their end.
const SLACK: usize = 16;
/// Nearness of a sample that is settled: nothing is beyond it.
const SETTLED: f32 = f32::INFINITY;

/// Bounds of some samples.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Least and largest x and y, and the largest nearness.
    rect: Rect,
    /// The least nearness: what a triangle must be beyond.
    least: f32,
    is_open: bool,
}

const NO_NODE: Node = Node { rect: Rect::EMPTY, least: f32::INFINITY, is_open: false };

impl Node {
    fn union(&self, other: &Self) -> Self {
        let least = if self.least < other.least { self.least } else { other.least };
        Node { rect: self.rect.union(&other.rect), least, is_open: self.is_open || other.is_open }
    }

    /// Whether a triangle of this rectangle may block any of the samples.
    #[inline(always)]
    fn may_meet(&self, rect: &Rect) -> bool {
        rect.x0 <= self.rect.x1
            && rect.x1 >= self.rect.x0
            && rect.y0 <= self.rect.y1
            && rect.y1 >= self.rect.y0
            && rect.z >= self.least
    }
}

/// See the [module](self).
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// Node i has the children 2i + 1 and 2i + 2; the last `2^depth` are leaves.
    nodes: Vec<Node>,
    depth: u32,
    /// Samples in the order of the leaves, light space.
    x: Vec<f32>,
    y: Vec<f32>,
    /// Nearness, [`SETTLED`] once nothing more can happen.
    z: Vec<f32>,
    /// Nearness as it was.
    depths: Vec<f32>,
    sources: Vec<u32>,
    /// Empty where samples are blocked or not.
    tints: Vec<Vec3>,
}

impl Part {
    /// Levels below the root such that leaves hold fewer than `leaf` samples.
    pub fn depth(len: usize, leaf: usize) -> u32 {
        let mut depth = 0;
        while len.div_ceil(1 << depth) >= leaf {
            depth += 1;
        }
        depth
    }

    /// Over samples in order.
    pub fn new(points: &[Point], depth: u32) -> Self {
        let column = |pick: fn(&Point) -> f32, rest: f32| {
            let mut column: Vec<f32> = points.iter().map(pick).collect();
            column.resize(points.len() + SLACK, rest);
            column
        };
        let depths = column(|p| p.z, SETTLED);
        let mut part = Part {
            nodes: alloc::vec![NO_NODE; (2 << depth) - 1],
            depth,
            x: column(|p| p.x, 0.0),
            y: column(|p| p.y, 0.0),
            z: depths.clone(),
            depths,
            sources: points.iter().map(|p| p.source).collect(),
            tints: Vec::new(),
        };
        let leaves = (1 << depth) - 1;
        for leaf in 0..1 << depth {
            let (start, end) = part.range(leaves + leaf);
            part.nodes[leaves + leaf] = points[start..end].iter().fold(NO_NODE, |all, p| {
                let rect = Rect { x0: p.x, x1: p.x, y0: p.y, y1: p.y, z: p.z };
                all.union(&Node { rect, least: p.z, is_open: true })
            });
        }
        part.sum_up();
        part
    }

    /// Makes inner nodes from their children.
    fn sum_up(&mut self) {
        for node in (0..self.nodes.len() / 2).rev() {
            self.nodes[node] = self.nodes[2 * node + 1].union(&self.nodes[2 * node + 2]);
        }
    }

    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// Rectangles around the samples of each leaf that has any.
    pub fn leaves(&self) -> impl Iterator<Item = Rect> {
        let rects = self.nodes[self.nodes.len() / 2..].iter().map(|node| node.rect);
        rects.filter(|rect| rect.x0 <= rect.x1)
    }

    pub fn sources(&self) -> &[u32] {
        &self.sources
    }

    /// The samples below a node. Halves are taken from the root on, as they were when the samples were put in order.
    fn range(&self, node: usize) -> (usize, usize) {
        let level = (node + 1).ilog2();
        let path = node + 1 - (1 << level);
        let (mut start, mut len) = (0, self.sources.len());
        for step in (0..level).rev() {
            let left = len / 2;
            if path >> step & 1 == 0 {
                len = left;
            } else {
                (start, len) = (start + left, len - left);
            }
        }
        (start, start + len)
    }

    /// Lets every sample be unblocked again.
    pub fn open(&mut self) {
        self.z.copy_from_slice(&self.depths);
        let leaves = (1 << self.depth) - 1;
        for node in &mut self.nodes[leaves..] {
            node.is_open = node.rect.x0 <= node.rect.x1;
        }
        self.sum_up();
    }

    /// Makes every sample white.
    pub fn whiten(&mut self) {
        self.tints.clear();
        self.tints.resize(self.sources.len(), Vec3::ONE);
    }

    /// The caller's places of blocked samples.
    pub fn blocked(&self) -> impl Iterator<Item = usize> + '_ {
        self.z.iter().zip(&self.sources).filter(|(z, _)| **z == SETTLED).map(|(_, s)| *s as usize)
    }

    /// The caller's places and what light is left there.
    pub fn tints(&self) -> impl Iterator<Item = (usize, Vec3)> + '_ {
        self.tints.iter().zip(&self.sources).map(|(t, s)| (*s as usize, *t))
    }

    /// Draws one triangle.
    #[inline(always)]
    pub fn draw<L: Lanes, P: Paint>(
        &mut self,
        lanes: L,
        scene: &Scene<'_, P>,
        item: &Item,
        cover: &Cover,
        counters: &mut Counters,
    ) {
        if !self.nodes[0].is_open {
            counters.nodes_visited += 1;
            counters.nodes_culled += 1;
            return;
        }
        let triangle = &scene.casters.triangles[item.triangle as usize];
        let wide = Spreadout::new(lanes, &cover.planes);
        let exact = Exact::new(scene.view, triangle);
        let is_sure = scene.paint.blocks_unasked(triangle.is_opaque());
        let leaves = (1 << self.depth) - 1;
        // Next node in order of a walk without a stack: down to the left, or past what is done.
        let mut at = 0;
        loop {
            let node = &self.nodes[at];
            counters.nodes_visited += 1;
            let mut goes_down = false;
            if !node.is_open {
                counters.nodes_culled += 1;
            } else if node.may_meet(&item.rect) && cover.touches(&node.rect) {
                if is_sure && cover.blocks_all(&node.rect) {
                    self.settle_all(at);
                } else if at >= leaves {
                    let (start, end) = self.range(at);
                    let leaf = Leaf { at, start, end, triangle: item.triangle, is_sure };
                    self.draw_leaf(lanes, scene, &wide, &exact, leaf, counters);
                } else {
                    goes_down = true;
                }
            }
            if goes_down {
                at = 2 * at + 1;
                continue;
            }
            // Up from right children, then to the sibling.
            while at != 0 && at % 2 == 0 {
                at = (at - 1) / 2;
            }
            if at == 0 {
                return;
            }
            at += 1;
        }
    }

    #[inline(always)]
    fn draw_leaf<L: Lanes, P: Paint>(
        &mut self,
        lanes: L,
        scene: &Scene<'_, P>,
        wide: &Spreadout<L>,
        exact: &Exact,
        leaf: Leaf,
        counters: &mut Counters,
    ) {
        let (constant, factor) = scene.view.depth_tolerance();
        let (constant, factor) = (lanes.splat(constant), lanes.splat(factor));
        let mut is_closing = false;
        let mut first = leaf.start;
        while first < leaf.end {
            let (x, y, z) =
                (lanes.load(&self.x[first..]), lanes.load(&self.y[first..]), lanes.load(&self.z[first..]));
            let within = u32::MAX >> (32 - (leaf.end - first).min(L::WIDTH) as u32);
            let open = lanes.lt(z, lanes.splat(SETTLED)) & within;
            counters.samples_tested += u64::from(open.count_ones());
            let answer = wide.test(lanes, x, y, z, lanes.mul_add(factor, z, constant));
            let mut settled = if leaf.is_sure { answer.sure & open } else { 0 };
            let unsure = answer.possible & open & !settled;
            if unsure != 0 {
                counters.tests_exact += u64::from(unsure.count_ones());
                settled |= self.meet(lanes, scene, exact, leaf, first, unsure);
            }
            is_closing |= settled != 0;
            while settled != 0 {
                self.z[first + settled.trailing_zeros() as usize] = SETTLED;
                settled &= settled - 1;
            }
            first += L::WIDTH;
        }
        if is_closing && self.z[leaf.start..leaf.end].iter().all(|z| *z == SETTLED) {
            self.nodes[leaf.at].is_open = false;
            self.close_above(leaf.at);
        }
    }

    /// Puts samples of a register to the ray tracer's own test; those to which nothing more can happen.
    #[inline(always)]
    fn meet<L: Lanes, P: Paint>(
        &mut self,
        lanes: L,
        scene: &Scene<'_, P>,
        exact: &Exact,
        leaf: Leaf,
        first: usize,
        unsure: u32,
    ) -> u32 {
        let axes = scene.view.axes();
        let mut o = [[0.0; 16]; 3];
        for (lane, &source) in self.sources[first..leaf.end].iter().take(L::WIDTH).enumerate() {
            // Nobody asks about samples behind the end of a shorter list.
            let Some(from) = scene.origins.get(source as usize) else { continue };
            (o[0][lane], o[1][lane], o[2][lane]) = (from[axes[0]], from[axes[1]], from[axes[2]]);
        }
        let origin = [lanes.load(&o[0]), lanes.load(&o[1]), lanes.load(&o[2])];
        let met = exact.meet(lanes, scene.view, origin, unsure);
        let is_opaque = scene.casters.triangles[leaf.triangle as usize].is_opaque();
        let (mut u, mut v) = ([0.0; 16], [0.0; 16]);
        lanes.store(met.u, &mut u);
        lanes.store(met.v, &mut v);
        let (mut rest, mut settled) = (met.mask, 0);
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize & 15;
            rest &= rest - 1;
            let tint = self.tints.get_mut(first + lane);
            let is_settled = scene.paint.meet(leaf.triangle, is_opaque, (u[lane], v[lane]), tint);
            settled |= u32::from(is_settled) << lane;
        }
        settled
    }

    /// All samples below a node are blocked.
    #[cold]
    fn settle_all(&mut self, node: usize) {
        let (start, end) = self.range(node);
        self.z[start..end].fill(SETTLED);
        // Nodes below are not visited while this one is closed.
        self.nodes[node].is_open = false;
        self.close_above(node);
    }

    fn close_above(&mut self, node: usize) {
        let mut at = node;
        while at != 0 {
            at = (at - 1) / 2;
            self.nodes[at].is_open = self.nodes[2 * at + 1].is_open || self.nodes[2 * at + 2].is_open;
            if self.nodes[at].is_open {
                return;
            }
        }
    }

    /// See [`super::SampleMap::validate`].
    pub fn validate(&self, leaf: usize) -> Result<(), String> {
        let leaves = (1 << self.depth) - 1;
        for (i, node) in self.nodes.iter().enumerate() {
            let (start, end) = self.range(i);
            if i >= leaves && end - start >= leaf {
                return Err(format!("leaf {i} holds {} samples", end - start));
            }
            for at in start..end {
                let r = Rect {
                    x0: self.x[at],
                    x1: self.x[at],
                    y0: self.y[at],
                    y1: self.y[at],
                    z: self.depths[at],
                };
                if !(node.rect.holds(&r) && node.least <= r.z) {
                    return Err(format!("sample {} lies outside of node {i}", self.sources[at]));
                }
            }
        }
        Ok(())
    }
}

/// A leaf under a triangle.
#[derive(Clone, Copy)]
struct Leaf {
    at: usize,
    start: usize,
    end: usize,
    triangle: u32,
    /// Whether what is surely met is blocked.
    is_sure: bool,
}

/// A triangle's planes over whole rectangles. A plane is least and largest at corners, which lie among the samples' own coordinates, so
/// that the bounds on rounding for samples hold for corners.
pub(super) struct Cover {
    planes: Planes,
    tolerance: (f32, f32),
    is_sliver: bool,
}

impl Cover {
    /// Of a triangle that is a sliver or not, in the sense of [`crate::planes::planes`].
    #[inline(always)]
    pub fn new(view: &View, planes: Planes, is_sliver: bool) -> Self {
        Cover { planes, tolerance: view.depth_tolerance(), is_sliver }
    }

    /// Whether some point may be inside all edges. What is surely outside of one edge of a sliver may be so of all three, as where the
    /// light lies in the triangle's plane, and the ray tracer then finds it inside: another edge must have it surely inside.
    #[inline(always)]
    fn touches(&self, rect: &Rect) -> bool {
        let is_outside = (0..3).any(|edge| self.extreme(3 * edge, rect, false) < -1.0);
        !is_outside || self.is_sliver && !(0..3).any(|edge| self.extreme(3 * edge, rect, true) > 1.0)
    }

    /// Whether every point is surely inside and surely nearer to the light's far side than the triangle.
    #[inline(always)]
    fn blocks_all(&self, rect: &Rect) -> bool {
        let depth = self.extreme(9, rect, true) - self.planes.0[12] * rect.z;
        (0..3).all(|edge| self.extreme(3 * edge, rect, true) > 1.0)
            && depth > self.tolerance.0 + self.tolerance.1 * rect.z
    }

    /// The least or largest value of a plane over the rectangle.
    #[inline(always)]
    fn extreme(&self, row: usize, rect: &Rect, is_least: bool) -> f32 {
        let rows = &self.planes.0;
        let (a, b, c) = (rows[row], rows[row + 1], rows[row + 2]);
        let x = if (a < 0.0) == is_least { rect.x1 } else { rect.x0 };
        let y = if (b < 0.0) == is_least { rect.y1 } else { rect.y0 };
        a * x + b * y + c
    }
}

/// Triangles sorted into parts.
pub(crate) struct Tasks {
    items: Vec<Vec<Item>>,
}

impl Tasks {
    /// Sorts triangles by the parts that they may meet, keeping their order.
    pub fn sort(parts: &[Part], items: &[Item], counters: &mut Counters) -> Self {
        let mut tasks = Tasks { items: alloc::vec![Vec::new(); parts.len()] };
        if parts.len() == 1 {
            tasks.items[0].extend_from_slice(items);
            return tasks;
        }
        // The tree above the parts: bounds of halves of halves.
        let mut above = alloc::vec![NO_NODE; 2 * parts.len() - 1];
        for (i, part) in parts.iter().enumerate() {
            above[parts.len() - 1 + i] = part.nodes[0];
        }
        for node in (0..parts.len() - 1).rev() {
            above[node] = above[2 * node + 1].union(&above[2 * node + 2]);
        }
        for item in items {
            sort_one(&above, parts.len(), 0, item, &mut tasks.items, counters);
        }
        tasks
    }

    /// Runs every part's triangles.
    pub fn run(&self, parts: &mut [Part], work: impl Fn(&mut Part, &[Item]) -> Counters + Sync) -> Counters {
        let sum = |mut a: Counters, b: Counters| {
            a += b;
            a
        };
        #[cfg(feature = "std")]
        {
            use rayon::prelude::*;
            let both = parts.par_iter_mut().zip(&self.items);
            both.map(|(part, items)| work(part, items)).reduce(Counters::default, sum)
        }
        #[cfg(not(feature = "std"))]
        parts
            .iter_mut()
            .zip(&self.items)
            .map(|(part, items)| work(part, items))
            .fold(Counters::default(), sum)
    }
}

fn sort_one(
    above: &[Node],
    parts: usize,
    at: usize,
    item: &Item,
    out: &mut [Vec<Item>],
    counters: &mut Counters,
) {
    if at >= parts - 1 {
        // The part itself counts the visit.
        out[at + 1 - parts].push(*item);
        return;
    }
    let node = &above[at];
    counters.nodes_visited += 1;
    counters.nodes_culled += u64::from(!node.is_open);
    if node.is_open && node.may_meet(&item.rect) {
        sort_one(above, parts, 2 * at + 1, item, out, counters);
        sort_one(above, parts, 2 * at + 2, item, out, counters);
    }
}
