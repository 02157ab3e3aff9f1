//! Writes the wide nodes of a plan from the root down: first counts the nodes of every subtree, then fills, in parallel,
//! the piece of the common buffers that each has come to own.
//!
//! The cut into subtrees depends on the tree alone, so the buffers are the same for any number of threads. Every node
//! comes before its children, and inner children of a node are consecutive.

use super::binary::{BinaryTree, Content, PART, split};
use super::bounds::Bounds;
use super::collapse::{Plan, WIDTH, WideChild};
use crate::simd::memory;
use bytemuck::Zeroable;
use rayon::prelude::*;
use std::ops::Range;
use std::vec;
use std::vec::Vec;

/// What a slot of a node holds.
#[derive(Clone, Copy)]
pub(crate) enum Held<'a> {
    /// The wide node with this index.
    Inner(u32),
    /// A leaf.
    Leaf {
        /// What it holds.
        primitives: &'a [u32],
        /// Index among all primitives of the first of them.
        first: u32,
    },
}

/// A layout of wide nodes.
pub(crate) trait Encoder: Sync {
    /// One node; all zeros must be a valid value.
    type Node: Copy + Send + Zeroable;

    /// The slots in which children lie, and in which order leaves and inner nodes are numbered.
    fn arrange(&self, children: &[WideChild], bounds: &[Bounds]) -> [Option<WideChild>; WIDTH];

    /// A node whose first inner child and first primitive have these indices.
    fn encode(
        &self,
        slots: &[Option<(Bounds, Held)>; WIDTH],
        first_node: u32,
        first_primitive: u32,
    ) -> Self::Node;
}

/// All nodes of a tree, and what its leaves hold.
pub(crate) struct Emitted<N> {
    pub nodes: Vec<N>,
    /// Leaf after leaf.
    pub primitives: Vec<u32>,
    /// One past each leaf's last primitive.
    pub leaf_ends: Vec<u32>,
    /// Levels, counting the root.
    pub depth: usize,
}

/// How much of each buffer something takes, or where it starts there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Extent {
    nodes: usize,
    primitives: usize,
    leaves: usize,
}

impl Extent {
    fn plus(self, other: Extent) -> Self {
        Extent {
            nodes: self.nodes + other.nodes,
            primitives: self.primitives + other.primitives,
            leaves: self.leaves + other.leaves,
        }
    }
}

/// A wide node still to be written.
#[derive(Clone, Copy)]
struct Task {
    binary: u32,
    /// Its index.
    to: usize,
    level: usize,
}

/// The pieces of the common buffers that belong to what lies below one node, and where they start there.
struct Piece<'a, N> {
    start: Extent,
    nodes: &'a mut [N],
    primitives: &'a mut [u32],
    leaf_ends: &'a mut [u32],
}

struct Emitter<'a, E> {
    encoder: &'a E,
    tree: &'a BinaryTree,
    bounds: &'a [Bounds],
    plan: &'a Plan,
}

/// Writes the wide tree of `plan`.
pub(crate) fn emit<E: Encoder>(
    encoder: &E,
    tree: &BinaryTree,
    bounds: &[Bounds],
    plan: &Plan,
) -> Emitted<E::Node> {
    let emitter = Emitter { encoder, tree, bounds, plan };
    let root = Task { binary: 0, to: 0, level: 1 };
    let is_small = |task: Task| emitter.is_small(task.binary);

    // What lies above all small subtrees comes first, the roots of these included.
    let (top, mut depth) = emitter.count(root, is_small);
    let top = Extent { nodes: top.nodes + 1, ..top };
    let mut out = Emitted::<E::Node>::zeroed(top);
    let mut tasks = Vec::new();
    let (first, below) = out.nodes.split_at_mut(1);
    let piece = Piece {
        start: Extent { nodes: 1, ..Extent::default() },
        nodes: below,
        primitives: &mut out.primitives,
        leaf_ends: &mut out.leaf_ends,
    };
    first[0] = emitter.fill(root, piece, |task| {
        let stops = is_small(task);
        if stops {
            tasks.push(task);
        }
        stops
    });

    let counts: Vec<(Extent, usize)> = tasks.par_iter().map(|&task| emitter.count(task, |_| false)).collect();
    let mut starts = vec![top];
    for &(count, below) in &counts {
        starts.push(starts[starts.len() - 1].plus(count));
        depth = depth.max(below);
    }
    let whole = starts[starts.len() - 1];
    let mut all = Emitted { depth, ..Emitted::<E::Node>::zeroed(whole) };
    all.nodes[..top.nodes].copy_from_slice(&out.nodes);
    all.primitives[..top.primitives].copy_from_slice(&out.primitives);
    all.leaf_ends[..top.leaves].copy_from_slice(&out.leaf_ends);
    let ranges = |of: fn(&Extent) -> usize| -> Vec<Range<usize>> {
        starts.windows(2).map(|ends| of(&ends[0])..of(&ends[1])).collect()
    };
    let nodes = split(&mut all.nodes, &ranges(|e| e.nodes));
    let primitives = split(&mut all.primitives, &ranges(|e| e.primitives));
    let leaf_ends = split(&mut all.leaf_ends, &ranges(|e| e.leaves));
    let pieces = starts.iter().zip(nodes.into_iter().zip(primitives).zip(leaf_ends));
    let pieces: Vec<_> = pieces
        .map(|(&start, ((nodes, primitives), leaf_ends))| Piece { start, nodes, primitives, leaf_ends })
        .collect();
    let roots: Vec<E::Node> =
        tasks.par_iter().zip(pieces).map(|(&task, piece)| emitter.fill(task, piece, |_| false)).collect();
    for (task, node) in tasks.iter().zip(roots) {
        all.nodes[task.to] = node;
    }
    all
}

impl<N: Zeroable + Send> Emitted<N> {
    fn zeroed(extent: Extent) -> Self {
        Emitted {
            nodes: memory::zeroed(extent.nodes),
            primitives: memory::zeroed(extent.primitives),
            leaf_ends: memory::zeroed(extent.leaves),
            depth: 0,
        }
    }

    /// Primitives held by the leaves before this one, which may be one past the last.
    pub fn leaf_begin(&self, leaf: usize) -> usize {
        if leaf == 0 { 0 } else { self.leaf_ends[leaf - 1] as usize }
    }

    /// What a leaf holds.
    pub fn leaf(&self, leaf: usize) -> &[u32] {
        &self.primitives[self.leaf_begin(leaf)..self.leaf_ends[leaf] as usize]
    }
}

impl<E: Encoder> Emitter<'_, E> {
    /// Whether a subtree is for one thread.
    fn is_small(&self, binary: u32) -> bool {
        match self.tree.content(binary) {
            Content::Leaf(_) => true,
            Content::Pair(first) => (self.tree.end_below(first) - first) as usize <= PART,
        }
    }

    /// What lies below `root`, and the deepest level; nodes that `stops` accepts count, but what is below them does not.
    fn count(&self, root: Task, stops: impl Fn(Task) -> bool) -> (Extent, usize) {
        let mut count = Extent::default();
        let mut depth = root.level;
        let mut pending = vec![root];
        let mut children = Vec::with_capacity(WIDTH);
        while let Some(task) = pending.pop() {
            depth = depth.max(task.level);
            if stops(task) {
                continue;
            }
            self.plan.children(self.tree, task.binary, &mut children);
            for child in &children {
                if child.is_inner {
                    count.nodes += 1;
                    pending.push(Task { binary: child.binary, to: 0, level: task.level + 1 });
                } else {
                    let held = self.tree.count_under(child.binary);
                    count.primitives += held;
                    count.leaves += 1;
                }
            }
        }
        (count, depth)
    }

    /// Writes what lies below `root` into its piece, and returns the root's own node. Nodes that `stops` accepts, be it the
    /// root, are left zeroed.
    fn fill(&self, root: Task, piece: Piece<E::Node>, mut stops: impl FnMut(Task) -> bool) -> E::Node {
        let Piece { start, nodes, primitives, leaf_ends } = piece;
        let mut result = E::Node::zeroed();
        let mut next = start;
        let mut pending = vec![root];
        let mut children = Vec::with_capacity(WIDTH);
        while let Some(task) = pending.pop() {
            if stops(task) {
                continue;
            }
            self.plan.children(self.tree, task.binary, &mut children);
            let slots = self.encoder.arrange(&children, self.bounds);
            let first = next;
            for child in slots.iter().flatten().filter(|child| !child.is_inner) {
                let begin = next.primitives - start.primitives;
                let held = self.tree.primitives_under(child.binary, &mut primitives[begin..]);
                next.primitives += held;
                leaf_ends[next.leaves - start.leaves] = next.primitives as u32;
                next.leaves += 1;
            }
            let mut leaf = first;
            let slots = slots.map(|child| {
                let child = child?;
                let held = if child.is_inner {
                    let to = next.nodes;
                    next.nodes += 1;
                    pending.push(Task { binary: child.binary, to, level: task.level + 1 });
                    Held::Inner(to as u32)
                } else {
                    let end = leaf_ends[leaf.leaves - start.leaves] as usize;
                    let within = leaf.primitives - start.primitives..end - start.primitives;
                    let first = leaf.primitives as u32;
                    leaf.primitives = end;
                    leaf.leaves += 1;
                    Held::Leaf { primitives: &primitives[within], first }
                };
                Some((self.bounds[child.binary as usize], held))
            });
            let node = self.encoder.encode(&slots, first.nodes as u32, first.primitives as u32);
            match task.to.checked_sub(start.nodes) {
                Some(at) if task.to != root.to => nodes[at] = node,
                _ => result = node,
            }
        }
        result
    }
}
