//! Wide tree to the shared kernel's nodes: grid boxes and octant-ordered slots (Ylitie, Karras, Laine 2017,
//! sections 3.1 and 3.2).

use super::binary::BinaryTree;
use super::bounds::Bounds;
use super::collapse::{LeafCost, WIDTH, WideChild, WideTree};
use crate::node::Node;
use lt_math::glam::{UVec4, Vec3};
use std::vec;
use std::vec::Vec;

/// A node's leaves hold up to 24 primitives together: three each.
pub(crate) const NODE_LEAF: LeafCost = LeafCost { capacity: 3, fixed: 0.0, each: 0.3 };

/// Nodes of a tree, and the primitives in the order in which its leaves hold them.
pub(crate) struct Quantized {
    pub nodes: Vec<Node>,
    pub order: Vec<u32>,
}

/// Encodes a wide tree. At least one primitive.
pub(crate) fn quantize(wide: &WideTree, tree: &BinaryTree, bounds: &[Bounds]) -> Quantized {
    let mut nodes = vec![Node::default()];
    let mut order = Vec::new();
    let mut pending = vec![(0usize, 0usize)];
    while let Some((from, to)) = pending.pop() {
        let slots = assign_slots(wide.children(from), bounds);
        let (first_node, first_primitive) = (nodes.len() as u32, order.len() as u32);
        let mut meta = [0u8; WIDTH];
        let mut inner_mask = 0;
        for (slot, child) in slots.iter().enumerate() {
            let Some(child) = child else { continue };
            meta[slot] = if let Some(inner) = child.inner {
                inner_mask |= 1 << slot;
                pending.push((inner as usize, nodes.len()));
                nodes.push(Node::default());
                0b0010_0000 | (24 + slot as u8)
            } else {
                let offset = order.len() as u32 - first_primitive;
                tree.primitives_under(child.binary, &mut order);
                let count = order.len() as u32 - first_primitive - offset;
                (((1 << count) - 1) << 5) as u8 | offset as u8
            };
        }
        let boxes = slots.map(|child| child.map(|c| bounds[c.binary as usize]));
        nodes[to] = encode(boxes, meta, inner_mask, first_node, first_primitive);
    }
    Quantized { nodes, order }
}

/// Gives each child the slot whose direction it lies in most, best matches first, so that visiting slots in the
/// order slot ^ octant is roughly front to back.
fn assign_slots(children: &[WideChild], bounds: &[Bounds]) -> [Option<WideChild>; WIDTH] {
    let all = children.iter().fold(Bounds::EMPTY, |a, c| a.union(&bounds[c.binary as usize]));
    let centre = all.centre();
    let mut slots = [None; WIDTH];
    let mut is_placed = [false; WIDTH];
    for _ in children {
        let mut best = (f32::NEG_INFINITY, 0, 0);
        for (index, child) in children.iter().enumerate().filter(|(index, _)| !is_placed[*index]) {
            let offset = bounds[child.binary as usize].centre() - centre;
            for (slot, _) in slots.iter().enumerate().filter(|(_, taken)| taken.is_none()) {
                let sign = |axis: usize| if slot >> axis & 1 == 1 { 1.0 } else { -1.0 };
                let along = offset.dot(Vec3::new(sign(0), sign(1), sign(2)));
                if along > best.0 {
                    best = (along, index, slot);
                }
            }
        }
        slots[best.2] = Some(children[best.1]);
        is_placed[best.1] = true;
    }
    slots
}

/// Biased exponent of the smallest power of two of which 255 steps span `extent`.
fn step_exponent(extent: f64) -> u32 {
    let mut exponent = 1;
    if extent > 0.0 {
        // The exponent field of extent / 255, rebiased from f64 to f32, is at most one too low.
        let biased = ((extent / 255.0).to_bits() >> 52) as i64 - 1023 + 127;
        exponent = biased.clamp(1, 254) as u32;
    }
    while exponent < 254 && step_length(exponent) * 255.0 < extent {
        exponent += 1;
    }
    exponent
}

fn step_length(exponent: u32) -> f64 {
    f64::from(f32::from_bits(exponent << 23))
}

/// Lower and upper planes of one axis on the grid from `low`, packed four to a word.
fn planes(boxes: &[Option<Bounds>; WIDTH], axis: usize, low: f32, step: f64) -> UVec4 {
    let mut words = [0u32; 4];
    for (slot, bounds) in boxes.iter().enumerate() {
        let Some(bounds) = bounds else { continue };
        let cells = |x: f32| (f64::from(x) - f64::from(low)) / step;
        let lower = cells(bounds.low[axis]).floor().clamp(0.0, 255.0) as u32;
        let upper = cells(bounds.high[axis]).ceil().clamp(0.0, 255.0) as u32;
        words[slot / 4] |= lower << (8 * (slot % 4));
        words[2 + slot / 4] |= upper << (8 * (slot % 4));
    }
    UVec4::from_array(words)
}

fn encode(
    boxes: [Option<Bounds>; WIDTH],
    meta: [u8; WIDTH],
    inner_mask: u32,
    first_node: u32,
    first_primitive: u32,
) -> Node {
    let all = boxes.iter().flatten().fold(Bounds::EMPTY, |a, b| a.union(b));
    let extent = all.high.as_dvec3() - all.low.as_dvec3();
    let exponents = extent.to_array().map(step_exponent);
    let axis = |axis: usize| planes(&boxes, axis, all.low[axis], step_length(exponents[axis]));
    let frame_w = exponents[0] | exponents[1] << 8 | exponents[2] << 16 | inner_mask << 24;
    let word = |half: usize| {
        u32::from_le_bytes([meta[half * 4], meta[half * 4 + 1], meta[half * 4 + 2], meta[half * 4 + 3]])
    };
    Node {
        frame: UVec4::new(all.low.x.to_bits(), all.low.y.to_bits(), all.low.z.to_bits(), frame_w),
        links: UVec4::new(first_node, first_primitive, word(0), word(1)),
        x: axis(0),
        y: axis(1),
        z: axis(2),
    }
}
