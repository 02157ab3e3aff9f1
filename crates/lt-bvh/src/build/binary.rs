//! The binary tree that everything else is collapsed from: cut from the top down ([`super::cut`]) into groups that PLOC with
//! reinsertion (Meister & Bittner 2018, by obvhs) makes into trees; or halves along a Morton curve where that grows too deep.
//!
//! Nodes lie in depth-first order, pairs side by side: what hangs below a pair's left half comes before what hangs below
//! its right half, so that every subtree is one range of indices and threads may own ranges ([`Parts`]).

use super::bounds::Bounds;
use super::cut::{self, Group, Item};
use super::quality::BuildQuality;
use crate::simd::memory;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;
use rayon::prelude::*;
use std::ops::Range;
use std::vec;
use std::vec::Vec;

const LEAF: u32 = 0x8000_0000;

/// What a node of the binary tree holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    /// One primitive.
    Leaf(u32),
    /// Two children, at this index and the next.
    Pair(u32),
}

/// A binary tree with one primitive per leaf; parents come before their children.
#[derive(Clone, Debug)]
pub(crate) struct BinaryTree {
    nodes: Vec<u32>,
}

impl BinaryTree {
    /// Builds over the boxes of at least one primitive. Boxes must be finite.
    pub fn build(boxes: &[Bounds], quality: BuildQuality) -> Self {
        if boxes.len() == 1 {
            return BinaryTree { nodes: vec![LEAF] };
        }
        let extent = scene_of(boxes).extent();
        let mut items = if EXTENTS_AS_THEY_ARE.contains(&extent) {
            cut::items(boxes)
        } else {
            cut::items(&to_unit_cube(boxes))
        };
        let mut nodes: Vec<u32> = memory::zeroed(2 * boxes.len() - 1);
        let (root, below) = nodes.split_at_mut(1);
        plant(Group::new(&mut items), quality, &mut root[0], below, 1);
        BinaryTree { nodes }
    }

    /// Halves the primitives along a Morton curve of their centres: never deeper than log₂ n + 1.
    pub fn balanced(boxes: &[Bounds]) -> Self {
        let unit = to_unit_cube(boxes);
        let mut order: Vec<(u64, u32)> =
            unit.iter().enumerate().map(|(i, b)| (morton(b.centre().to_array()), i as u32)).collect();
        order.sort_unstable();
        let mut nodes = vec![0];
        let mut pending = vec![(0, 0, order.len())];
        while let Some((node, begin, end)) = pending.pop() {
            if end - begin == 1 {
                nodes[node] = LEAF | order[begin].1;
                continue;
            }
            let (middle, first) = (begin + (end - begin) / 2, nodes.len());
            nodes[node] = first as u32;
            nodes.extend([0, 0]);
            pending.push((first + 1, middle, end));
            pending.push((first, begin, middle));
        }
        BinaryTree { nodes }
    }

    /// Subtrees from [`CUT_DEPTH`] on are renumbered in parallel and appended one after the other.
    fn from_obvhs(tree: &Bvh2) -> Self {
        let mut cut = Vec::new();
        walk(tree, 0, |node, level| {
            let is_cut = level == CUT_DEPTH;
            if is_cut {
                cut.push(node);
            }
            is_cut
        });
        let mut below = cut.par_iter().map(|&pair| links_below(tree, pair)).collect::<Vec<_>>().into_iter();
        let mut nodes = Vec::with_capacity(tree.nodes.len());
        nodes.push(0);
        let mut pending = vec![(0, 0, 0)];
        while let Some((from, to, level)) = pending.pop() {
            let node = &tree.nodes[from as usize];
            let first = nodes.len();
            if node.is_leaf() {
                nodes[to] = LEAF | tree.primitive_indices[node.first_index as usize];
                continue;
            }
            nodes[to] = first as u32;
            if level == CUT_DEPTH {
                let moved = |link: u32| if link & LEAF != 0 { link } else { link + first as u32 };
                nodes.extend(below.next().into_iter().flatten().map(moved));
                continue;
            }
            nodes.extend([0, 0]);
            pending.push((node.first_index + 1, first + 1, level + 1));
            pending.push((node.first_index, first, level + 1));
        }
        BinaryTree { nodes }
    }

    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn content(&self, node: u32) -> Content {
        let link = self.nodes[node as usize];
        if link & LEAF != 0 { Content::Leaf(link & !LEAF) } else { Content::Pair(link) }
    }

    /// Renames the primitives: what was `i` becomes `new[i]`.
    pub fn rename(&mut self, new: &[u32]) {
        self.nodes.par_iter_mut().with_min_len(PART).for_each(|link| {
            if *link & LEAF != 0 {
                *link = LEAF | new[(*link & !LEAF) as usize];
            }
        });
    }

    /// Box of every node, from those of the primitives.
    pub fn bounds(&self, of_primitive: impl Fn(u32) -> Bounds + Sync) -> Vec<Bounds> {
        let mut bounds: Vec<Bounds> = memory::zeroed(self.nodes.len());
        let parts = self.parts();
        let of = |node: usize, bounds: &[Bounds], start: usize| match self.content(node as u32) {
            Content::Leaf(primitive) => of_primitive(primitive),
            Content::Pair(first) => {
                let at = first as usize - start;
                bounds[at].union(&bounds[at + 1])
            }
        };
        let slices = split(&mut bounds, &parts.ranges);
        parts.ranges.par_iter().zip(slices).for_each(|(range, out)| {
            for node in range.clone().rev() {
                out[node - range.start] = of(node, out, range.start);
            }
        });
        for &node in parts.above.iter().rev() {
            bounds[node as usize] = of(node as usize, &bounds, 0);
        }
        bounds
    }

    /// One past the last node below `node`, whose pair starts at `first`.
    pub fn end_below(&self, first: u32) -> u32 {
        let mut first = first;
        loop {
            match (self.content(first), self.content(first + 1)) {
                (_, Content::Pair(below)) | (Content::Pair(below), _) => first = below,
                _ => return first + 2,
            }
        }
    }

    /// Cuts the tree into subtrees of at most [`PART`] nodes each, the same for any number of threads.
    pub fn parts(&self) -> Parts {
        let mut parts = Parts { ranges: Vec::new(), above: Vec::new() };
        // A node and the range of everything below it.
        let mut pending = vec![(0, 1..self.nodes.len())];
        while let Some((node, below)) = pending.pop() {
            parts.above.push(node);
            if below.is_empty() {
                continue;
            }
            if below.len() <= PART {
                parts.ranges.push(below);
                continue;
            }
            let first = below.start;
            let middle = match self.content(first as u32 + 1) {
                Content::Pair(right) => right as usize,
                Content::Leaf(_) => below.end,
            };
            pending.push((first as u32 + 1, middle..below.end));
            pending.push((first as u32, first + 2..middle));
        }
        parts
    }

    /// Puts the primitives under `node` into `into`, left to right; how many.
    pub fn primitives_under(&self, node: u32, into: &mut [u32]) -> usize {
        match self.content(node) {
            Content::Leaf(primitive) => {
                into[0] = primitive;
                1
            }
            Content::Pair(first) => {
                let mut count = 0;
                let mut pending = [0; DEEPEST_LEAF];
                let mut waiting = 2;
                pending[..2].copy_from_slice(&[first + 1, first]);
                while waiting > 0 {
                    waiting -= 1;
                    match self.content(pending[waiting]) {
                        Content::Leaf(primitive) => {
                            into[count] = primitive;
                            count += 1;
                        }
                        Content::Pair(first) => {
                            pending[waiting..waiting + 2].copy_from_slice(&[first + 1, first]);
                            waiting += 2;
                        }
                    }
                }
                count
            }
        }
    }

    /// Primitives under `node`.
    pub fn count_under(&self, node: u32) -> usize {
        match self.content(node) {
            Content::Leaf(_) => 1,
            // Half of the nodes of a subtree, rounded up, are leaves; the root is not in the range.
            Content::Pair(first) => (self.end_below(first) - first) as usize / 2 + 1,
        }
    }
}

/// Most nodes that wait in a walk through a leaf of at most eight primitives: one per level, and one more.
const DEEPEST_LEAF: usize = 9;

/// Nodes of a subtree that one thread handles: its data fit a core's cache.
pub(crate) const PART: usize = 1 << 14;

/// Levels of obvhs's tree below which subtrees are converted in parallel.
const CUT_DEPTH: usize = 8;

/// Groups of more items are made into trees by more than one thread.
const LEAST_SHARED: usize = 1 << 12;

/// A tree cut into subtrees.
pub(crate) struct Parts {
    /// Disjoint, rising ranges of nodes; the children of each node lie in its own range.
    pub ranges: Vec<Range<usize>>,
    /// All other nodes, parents before children.
    pub above: Vec<u32>,
}

/// The pieces of `all` that lie in rising, disjoint ranges.
pub(crate) fn split<'a, T>(all: &'a mut [T], ranges: &[Range<usize>]) -> Vec<&'a mut [T]> {
    let mut rest = all;
    let mut passed = 0;
    let mut pieces = Vec::with_capacity(ranges.len());
    for range in ranges {
        let (_, from) = rest.split_at_mut(range.start - passed);
        let (piece, after) = from.split_at_mut(range.len());
        pieces.push(piece);
        (rest, passed) = (after, range.end);
    }
    pieces
}

/// Visits the pairs of a tree of obvhs's, left first, down to where `stops` says so.
fn walk(tree: &Bvh2, root: u32, mut stops: impl FnMut(u32, usize) -> bool) {
    let mut pending = vec![(root, 0)];
    while let Some((at, level)) = pending.pop() {
        let node = &tree.nodes[at as usize];
        if !node.is_leaf() && !stops(at, level) {
            pending.push((node.first_index + 1, level + 1));
            pending.push((node.first_index, level + 1));
        }
    }
}

/// Links of all nodes below a pair of obvhs's, as if the first of them had index 0.
fn links_below(tree: &Bvh2, pair: u32) -> Vec<u32> {
    let first = tree.nodes[pair as usize].first_index;
    let mut nodes = vec![0, 0];
    let mut pending = vec![(first + 1, 1), (first, 0)];
    while let Some((from, to)) = pending.pop() {
        let node = &tree.nodes[from as usize];
        if node.is_leaf() {
            nodes[to] = LEAF | tree.primitive_indices[node.first_index as usize];
        } else {
            let first = nodes.len();
            nodes[to] = first as u32;
            nodes.extend([0, 0]);
            pending.push((node.first_index + 1, first + 1));
            pending.push((node.first_index, first));
        }
    }
    nodes
}

/// Scene sizes of which areas, and those of boxes 2⁻²⁰ as large, neither overflow nor vanish in f32.
const EXTENTS_AS_THEY_ARE: Range<f64> = 1e-9..1e12;

/// Makes the tree of a group: its root's link, and the links of all nodes below it, of which the first has the index `first`.
fn plant(group: Group, quality: BuildQuality, link: &mut u32, below: &mut [u32], first: u32) {
    if group.items.len() <= quality.most_joined() {
        return join(group.items, quality, link, below, first);
    }
    *link = first;
    let is_large = group.items.len() > LEAST_SHARED;
    let (left, right) = group.cut();
    let (pair, rest) = below.split_at_mut(2);
    let (left_link, right_link) = pair.split_at_mut(1);
    let (below_left, below_right) = rest.split_at_mut(2 * left.items.len() - 2);
    let first_right = first + 2 + below_left.len() as u32;
    let plant_left = || plant(left, quality, &mut left_link[0], below_left, first + 2);
    let plant_right = || plant(right, quality, &mut right_link[0], below_right, first_right);
    if is_large {
        rayon::join(plant_left, plant_right);
    } else {
        plant_left();
        plant_right();
    }
}

/// [`plant`] by joining neighbours.
fn join(items: &[Item], quality: BuildQuality, link: &mut u32, below: &mut [u32], first: u32) {
    if let [item] = items {
        *link = LEAF | item.primitive();
        return;
    }
    let tree = BinaryTree::from_obvhs(&ploc(items, quality));
    let moved = |link: u32| match link & LEAF {
        0 => link - 1 + first,
        _ => LEAF | items[(link & !LEAF) as usize].primitive(),
    };
    *link = moved(tree.nodes[0]);
    for (to, from) in below.iter_mut().zip(&tree.nodes[1..]) {
        *to = moved(*from);
    }
}

fn ploc(items: &[Item], quality: BuildQuality) -> Bvh2 {
    let parameters = quality.parameters();
    let indices = (0..items.len() as u32).collect();
    let mut tree = PlocBuilder::with_capacity(items.len()).build(
        parameters.ploc_search_distance,
        items,
        indices,
        parameters.sort_precision,
        parameters.search_depth_threshold,
    );
    ReinsertionOptimizer::default().run(&mut tree, parameters.reinsertion_batch_ratio, None);
    tree
}

fn scene_of(boxes: &[Bounds]) -> Bounds {
    boxes.par_iter().copied().reduce(|| Bounds::EMPTY, |a, b| a.union(&b))
}

/// Boxes moved and scaled into the unit cube, so that areas neither overflow nor vanish at any scene scale.
fn to_unit_cube(boxes: &[Bounds]) -> Vec<Bounds> {
    let scene = scene_of(boxes);
    let (low, extent) = (scene.low.as_dvec3(), scene.extent());
    let scale = if extent > 0.0 { 1.0 / extent } else { 1.0 };
    let unit = |b: &Bounds| {
        let (l, h) = ((b.low.as_dvec3() - low) * scale, (b.high.as_dvec3() - low) * scale);
        Bounds { low: l.as_vec3(), high: h.as_vec3() }
    };
    memory::filled(boxes.len(), |i| unit(&boxes[i]))
}

/// 21 bits per axis, interleaved, of a point in the unit cube.
fn morton(point: [f32; 3]) -> u64 {
    let mut code = 0;
    for (axis, x) in point.into_iter().enumerate() {
        let cell = (x * 2_097_151.0) as u64;
        for bit in 0..21 {
            code |= (cell >> bit & 1) << (3 * bit + axis as u64);
        }
    }
    code
}
