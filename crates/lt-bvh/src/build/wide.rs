//! From boxes to a wide tree: the binary tree, its plan and its nodes, and what happens if it is too deep.

use super::binary::BinaryTree;
use super::bounds::Bounds;
use super::collapse::{LeafCost, Plan};
use super::emit::{Emitted, Encoder, emit};
use super::quality::BuildQuality;
use super::quantize::Quantizer;
use crate::node::Node;
use crate::traverse::MAX_DEPTH;
use std::vec;
use std::vec::Vec;

/// The wide tree of a binary one over primitives with these `boxes`; of a balanced one where that is deeper than [`MAX_DEPTH`], which then
/// comes too.
pub(crate) fn wide_tree<E: Encoder>(
    encoder: &E,
    binary: &BinaryTree,
    boxes: impl Fn(u32) -> Bounds + Sync,
    cost: LeafCost,
) -> (Emitted<E::Node>, Option<BinaryTree>) {
    let wide = planned(encoder, binary, &boxes, cost);
    if wide.depth <= MAX_DEPTH {
        return (wide, None);
    }
    let all: Vec<Bounds> = (0..binary.len().div_ceil(2) as u32).map(boxes).collect();
    let balanced = BinaryTree::balanced(&all);
    (planned(encoder, &balanced, |i| all[i as usize], cost), Some(balanced))
}

fn planned<E: Encoder>(
    encoder: &E,
    binary: &BinaryTree,
    boxes: impl Fn(u32) -> Bounds + Sync,
    cost: LeafCost,
) -> Emitted<E::Node> {
    let bounds = binary.bounds(boxes);
    emit(encoder, binary, &bounds, &Plan::new(binary, &bounds, cost))
}

/// The shared kernel's tree over boxes.
pub(crate) struct KernelTree {
    pub nodes: Vec<Node>,
    /// The primitives in leaf order.
    pub order: Vec<u32>,
    /// Levels, counting the root.
    pub depth: usize,
    /// What it was made from; it names primitives by their place in `order`.
    pub binary: BinaryTree,
}

impl KernelTree {
    /// Builds over the boxes of at least one primitive. Boxes must be finite.
    pub fn build(boxes: &[Bounds], quality: BuildQuality, cost: LeafCost) -> Self {
        let built = BinaryTree::build(boxes, quality);
        let (wide, balanced) = wide_tree(&Quantizer, &built, |i| boxes[i as usize], cost);
        let mut binary = balanced.unwrap_or(built);
        let mut new_index = vec![0; boxes.len()];
        for (to, &from) in wide.primitives.iter().enumerate() {
            new_index[from as usize] = to as u32;
        }
        binary.rename(&new_index);
        KernelTree { nodes: wide.nodes, order: wide.primitives, depth: wide.depth, binary }
    }
}
