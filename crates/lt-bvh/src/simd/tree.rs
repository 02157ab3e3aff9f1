//! The wide tree of the CPU: exact boxes of eight children side by side, and triangles in blocks of eight.

use super::layout::{LeafLink, WideLayout};
use super::memory;
use crate::build::{BinaryTree, Bounds, Emitted, LeafCost, split, wide_tree};
use crate::lanes::prefetch;
use crate::node::Node;
use crate::ray::{FAR, NONE};
use crate::traverse::MAX_DEPTH;
use crate::triangle::Triangle;
use bytemuck::Zeroable;
use lt_math::glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;
use std::vec;
use std::vec::Vec;

/// Bit of a child link that marks a leaf; below it the block of triangles, or the instance.
pub(crate) const LEAF: u32 = 0x8000_0000;

/// Link to the root.
pub(crate) const ROOT: u32 = 0;

/// Links that may wait on the stack: at most seven siblings per level, and room for eight at the top.
pub(crate) const STACK: usize = 7 * MAX_DEPTH + 9;

/// One block per leaf, whatever it holds: testing one triangle or eight costs the same.
pub(crate) const BLOCK_LEAF: LeafCost = LeafCost { capacity: 8, fixed: 2.0, each: 0.0 };
/// A leaf is one instance.
pub(crate) const INSTANCE_LEAF: LeafCost = LeafCost { capacity: 1, fixed: 2.0, each: 0.0 };

/// Eight children.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug, Zeroable)]
pub(crate) struct WideNode {
    /// Lower and upper planes in x, y, z, from the tree's `base`; lower above upper where there is no child.
    pub planes: [[f32; 8]; 6],
    /// Links to inner nodes, or leaves.
    pub children: [u32; 8],
}

/// Bits of a block's link above the ordinal of its first triangle.
const COUNT_SHIFT: u32 = 28;

/// Triangles that links can count.
pub(crate) const MOST_TRIANGLES: usize = 1 << COUNT_SHIFT;

/// Link to the block of 1 to 8 triangles of which the first is the `first` of all blocks. Their number stands in the link, so that
/// a test can begin before anything of the block has come from memory.
pub(crate) fn block_link(first: u32, count: usize) -> u32 {
    LEAF | (count as u32 - 1) << COUNT_SHIFT | first
}

/// Ordinal of a block's first triangle, and how many it has.
#[inline(always)]
pub(super) fn first_and_count(link: u32) -> (usize, usize) {
    let first = link & ((1 << COUNT_SHIFT) - 1);
    (first as usize, (link >> COUNT_SHIFT & 7) as usize + 1)
}

/// Up to eight triangles of a leaf, side by side and without gaps.
///
/// In the tree's buffer a block of n triangles is n numbers for each vertex, for each axis; then n indices, with a bit for those
/// that ask the callback. Eight lanes loaded from such a row reach into the next one: the lanes behind n hold anything and are
/// masked out.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// The rows, and a load's worth of words after their end, which takes in the indices.
    words: &'a [u32],
    len: usize,
}

/// Set in every word that is no coordinate: lanes that reach into it would else compute with denormal numbers, which takes
/// tens of cycles each time although the result is masked out.
const NORMAL: u32 = 0x4000_0000;
/// Set in the index of a triangle that asks.
const ASKS: u32 = 0x8000_0000;

/// Rows of a block before its indices: three vertices in each of three axes.
const ROWS: usize = 9;
/// Words of a triangle.
pub(super) const WORDS: usize = ROWS + 1;
/// Words to a line of the cache.
const LINE: usize = 16;
/// Words that a load of eight lanes reads.
const LOAD: usize = 8;

impl<'a> Block<'a> {
    /// Triangles in it: 1 to 8.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Mask of the lanes that hold triangles.
    #[inline(always)]
    pub fn lanes(&self) -> u32 {
        (1 << self.len) - 1
    }

    /// Whether the hits on a triangle need asking.
    #[inline(always)]
    pub fn asks(&self, lane: usize) -> bool {
        self.words[ROWS * self.len + lane] & ASKS != 0
    }

    /// One coordinate of all triangles' three vertices, eight lanes long; the last axis for one above 2.
    #[inline(always)]
    pub fn rows(&self, axis: usize) -> [&'a [f32]; 3] {
        let first = 3 * axis.min(2) * self.len;
        [0, 1, 2].map(|vertex| {
            let at = first + vertex * self.len;
            // SAFETY: `SimdTree::block` has cut `words` to as many as the last row and a load from it reach, and rows before
            // it end earlier; every u32 is an f32. Checks here, bytemuck's for a null pointer among them, cost single rays a tenth
            // of their time.
            let row: &[f32; LOAD] = unsafe { &*self.words.as_ptr().add(at).cast() };
            row.as_slice()
        })
    }

    /// One coordinate of one triangle.
    #[inline(always)]
    pub fn coordinate(&self, vertex: usize, axis: usize, lane: usize) -> f32 {
        f32::from_bits(self.words[(3 * axis + vertex) * self.len + lane])
    }

    /// Index of a triangle in leaf order of the tree's own triangles.
    #[inline(always)]
    pub fn triangle(&self, lane: usize) -> u32 {
        self.words[ROWS * self.len + lane] & !(NORMAL | ASKS)
    }
}

/// Writes the words of a block; see [`Block`].
pub(super) fn write_block(indices: &[u32], triangles: &[Triangle], words: &mut [u32]) {
    let len = indices.len();
    for (lane, &index) in indices.iter().enumerate() {
        let triangle = &triangles[index as usize];
        for (vertex, position) in [triangle.v0, triangle.v1, triangle.v2].into_iter().enumerate() {
            for axis in 0..3 {
                words[(3 * axis + vertex) * len + lane] = position[axis].to_bits();
            }
        }
        words[ROWS * len + lane] = NORMAL | index | if triangle.is_opaque() { 0 } else { ASKS };
    }
}

/// Blocks written by one task.
pub(super) const BLOCKS: usize = 1 << 10;

/// The blocks of all leaves, and what a load from the last row reaches beyond them.
fn blocks(leaves: &Emitted<WideNode>, triangles: &[Triangle]) -> Vec<u32> {
    let mut words = memory::zeroed(WORDS * leaves.primitives.len() + LOAD);
    let count = leaves.leaf_ends.len();
    let position = |leaf: usize| WORDS * leaves.leaf_begin(leaf);
    let tasks: Vec<Range<usize>> =
        (0..count).step_by(BLOCKS).map(|first| first..(first + BLOCKS).min(count)).collect();
    let ranges: Vec<Range<usize>> =
        tasks.iter().map(|task| position(task.start)..position(task.end)).collect();
    tasks.into_par_iter().zip(split(&mut words, &ranges)).for_each(|(task, mut words)| {
        for leaf in task {
            let held = leaves.leaf(leaf);
            let (block, rest) = words.split_at_mut(WORDS * held.len());
            write_block(held, triangles, block);
            words = rest;
        }
    });
    words
}

/// A wide tree over triangles or instances.
#[derive(Debug)]
pub(crate) struct SimdTree {
    pub nodes: Vec<WideNode>,
    /// [`Block`]s, one after the other; see [`block_link`].
    pub(super) blocks: Vec<u32>,
    /// What planes count from, so that they are no larger than the tree.
    pub base: Vec3,
    /// Root box of the shared kernel's tree, from which both take their margins.
    pub low: Vec3,
    pub high: Vec3,
}

/// A tree with the triangles its leaves name.
#[derive(Clone, Copy)]
pub(crate) struct Part<'a> {
    pub tree: &'a SimdTree,
    /// All triangles, and the first of this tree.
    pub triangles: &'a [Triangle],
    pub first_triangle: u32,
}

pub(crate) const NO_CHILD: WideNode =
    WideNode { planes: [[FAR; 8], [-FAR; 8], [FAR; 8], [-FAR; 8], [FAR; 8], [-FAR; 8]], children: [NONE; 8] };

impl SimdTree {
    /// A tree of which nothing can be hit.
    pub fn empty() -> Self {
        SimdTree {
            nodes: vec![NO_CHILD],
            blocks: Vec::new(),
            base: Vec3::ZERO,
            low: Vec3::ZERO,
            high: Vec3::ZERO,
        }
    }

    /// Over triangles in leaf order; `root` is the shared kernel's root node.
    pub fn of_triangles(binary: Option<&BinaryTree>, triangles: &[Triangle], root: &Node) -> Self {
        let Some(binary) = binary else { return Self::empty() };
        let boxes = |i: u32| crate::build::triangle_bounds(&triangles[i as usize]);
        let (mut tree, leaves) = Self::collapse(binary, boxes, BLOCK_LEAF, root, LeafLink::Block);
        tree.blocks = blocks(&leaves, triangles);
        tree
    }

    /// Starts to fetch what a link leads to.
    #[inline(always)]
    pub fn prefetch(&self, link: u32) {
        if link & LEAF != 0 {
            let (first, len) = first_and_count(link);
            if let Some(words) = self.blocks.get(WORDS * first..WORDS * (first + len)) {
                words.iter().step_by(LINE).for_each(prefetch);
            }
        } else if let Some(node) = self.nodes.get(link as usize) {
            for planes in node.planes.iter().step_by(2) {
                prefetch(planes);
            }
            prefetch(&node.children);
        }
    }

    /// The block of a leaf's link.
    #[inline(always)]
    pub fn block(&self, link: u32) -> Block<'_> {
        let (first, len) = first_and_count(link);
        Block { words: &self.blocks[WORDS * first..][..ROWS * len + LOAD], len }
    }

    /// Over the boxes of instances in leaf order; `root` is the shared kernel's TLAS root.
    pub fn of_instances(binary: Option<&BinaryTree>, boxes: &[Bounds], root: &Node) -> Self {
        let Some(binary) = binary else { return Self::empty() };
        Self::collapse(binary, |i| boxes[i as usize], INSTANCE_LEAF, root, LeafLink::Primitive).0
    }

    /// The nodes, and what their leaves hold.
    fn collapse(
        binary: &BinaryTree,
        boxes: impl Fn(u32) -> Bounds + Sync,
        cost: LeafCost,
        root: &Node,
        link: LeafLink,
    ) -> (Self, Emitted<WideNode>) {
        let base = root.low();
        let (mut wide, _) = wide_tree(&WideLayout { base, link }, binary, boxes, cost);
        let nodes = std::mem::take(&mut wide.nodes);
        (SimdTree { nodes, blocks: Vec::new(), base, low: root.low(), high: root.high() }, wide)
    }
}
