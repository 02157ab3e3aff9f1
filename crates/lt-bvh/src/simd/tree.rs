//! The wide tree of the CPU: exact boxes of eight children side by side, and triangles in blocks of eight.

use super::layout::{LeafLink, WideLayout};
use crate::build::{BinaryTree, Bounds, Emitted, LeafCost, wide_tree};
use crate::node::Node;
use crate::ray::{FAR, NONE};
use crate::traverse::MAX_DEPTH;
use crate::triangle::Triangle;
use bytemuck::Zeroable;
use lt_math::glam::Vec3;
use rayon::prelude::*;
use std::vec;
use std::vec::Vec;

/// Bit of a child link that marks a leaf; below it the block of triangles, or the instance.
pub(crate) const LEAF: u32 = 0x8000_0000;

/// Links that may wait on the stack: at most seven siblings per level, and room for eight at the top.
pub(crate) const STACK: usize = 7 * MAX_DEPTH + 9;

/// One block per leaf, whatever it holds: testing one triangle or eight costs the same.
pub(crate) const BLOCK_LEAF: LeafCost = LeafCost { capacity: 8, fixed: 1.5, each: 0.0 };
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

/// Up to eight triangles; NaN where there is none.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// By vertex and axis.
    pub vertices: [[[f32; 8]; 3]; 3],
    /// Indices in leaf order of the tree's own triangles.
    pub triangles: [u32; 8],
}

/// A wide tree over triangles or instances.
#[derive(Debug)]
pub(crate) struct SimdTree {
    pub nodes: Vec<WideNode>,
    pub blocks: Vec<Block>,
    /// What planes count from, so that they are no larger than the tree.
    pub base: Vec3,
    /// Root box of the shared kernel's tree, from which both take their margins.
    pub low: Vec3,
    pub high: Vec3,
}

pub(crate) const NO_CHILD: WideNode =
    WideNode { planes: [[FAR; 8], [-FAR; 8], [FAR; 8], [-FAR; 8], [FAR; 8], [-FAR; 8]], children: [NONE; 8] };

const NO_TRIANGLE: Block = Block { vertices: [[[f32::NAN; 8]; 3]; 3], triangles: [NONE; 8] };

fn block_of(indices: &[u32], triangles: &[Triangle]) -> Block {
    let mut block = NO_TRIANGLE;
    for (lane, &index) in indices.iter().enumerate() {
        let triangle = &triangles[index as usize];
        block.triangles[lane] = index;
        for (vertex, position) in [triangle.v0, triangle.v1, triangle.v2].into_iter().enumerate() {
            for axis in 0..3 {
                block.vertices[vertex][axis][lane] = position[axis];
            }
        }
    }
    block
}

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
        let (mut tree, leaves) = Self::collapse(binary, boxes, BLOCK_LEAF, root, LeafLink::Position(|_| 1));
        // Blocks are the largest part: they come at their exact number.
        tree.blocks = leaves.leaves().map(|leaf| block_of(leaf, triangles)).collect();
        tree
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
