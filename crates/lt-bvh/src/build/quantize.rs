//! The shared kernel's nodes: grid boxes and octant-ordered slots (Ylitie, Karras, Laine 2017,
//! sections 3.1 and 3.2).

use super::bounds::Bounds;
use super::collapse::{LeafCost, WIDTH, WideChild};
use super::emit::{Encoder, Held};
use crate::grid::Grid;
use crate::node::Node;
use lt_math::glam::UVec4;

/// A node's leaves hold up to 24 primitives together: three each.
pub(crate) const NODE_LEAF: LeafCost = LeafCost { capacity: 3, fixed: 0.0, each: 0.3 };

/// The shared kernel's layout.
pub(crate) struct Quantizer;

impl Encoder for Quantizer {
    type Node = Node;

    /// Gives each child the slot whose direction it lies in most, best matches first, so that visiting slots in the
    /// order slot ^ octant is roughly front to back.
    fn arrange(&self, children: &[WideChild], bounds: &[Bounds]) -> [Option<WideChild>; WIDTH] {
        let all = children.iter().fold(Bounds::EMPTY, |a, c| a.union(&bounds[c.binary as usize]));
        let centre = all.centre();
        // How far each child lies in the direction of each slot, largest first in the order of integers. The lowest bits
        // make way for which child and slot it is; the lower one wins.
        let mut keys = [[i32::MIN; WIDTH]; WIDTH];
        for (index, (child, keys)) in children.iter().zip(&mut keys).enumerate() {
            let offset = bounds[child.binary as usize].centre() - centre;
            for (slot, key) in keys.iter_mut().enumerate() {
                let signed = |axis: usize| if slot >> axis & 1 == 1 { offset[axis] } else { -offset[axis] };
                let bits = (signed(0) + signed(1) + signed(2)).to_bits() as i32;
                let rising = bits ^ ((bits >> 31) & i32::MAX);
                *key = rising & !63 | (63 - (index * WIDTH + slot) as i32);
            }
        }
        let mut slots = [None; WIDTH];
        for _ in children {
            let best = keys.as_flattened().iter().fold(i32::MIN, |best, &key| best.max(key));
            let chosen = 63 - (best & 63) as usize;
            let (index, slot) = (chosen / WIDTH, chosen % WIDTH);
            slots[slot] = Some(children[index]);
            // Neither this child nor this slot again.
            keys[index] = [i32::MIN; WIDTH];
            keys.iter_mut().for_each(|row| row[slot] = i32::MIN);
        }
        slots
    }

    fn encode(&self, slots: &[Option<(Bounds, Held)>; WIDTH], first_node: u32, first_primitive: u32) -> Node {
        let mut meta = [0u8; WIDTH];
        let mut inner_mask = 0;
        for (slot, content) in slots.iter().enumerate() {
            meta[slot] = match content {
                None => 0,
                Some((_, Held::Inner(_))) => {
                    inner_mask |= 1 << slot;
                    0b0010_0000 | (24 + slot as u8)
                }
                Some((_, Held::Leaf { primitives, first })) => {
                    (((1 << primitives.len()) - 1) << 5) as u8 | (first - first_primitive) as u8
                }
            };
        }
        let word = |half: usize| {
            u32::from_le_bytes([meta[half * 4], meta[half * 4 + 1], meta[half * 4 + 2], meta[half * 4 + 3]])
        };
        let links = UVec4::new(first_node, first_primitive, word(0), word(1));
        with_boxes(slots.map(|content| content.map(|(bounds, _)| bounds)), inner_mask, links)
    }
}

/// Lower and upper planes of one axis on its grid, packed four to a word.
fn planes(boxes: &[Option<Bounds>; WIDTH], axis: usize, grid: Grid) -> UVec4 {
    let mut words = [0u32; 4];
    for (slot, bounds) in boxes.iter().enumerate() {
        let Some(bounds) = bounds else { continue };
        words[slot / 4] |= grid.line_below(bounds.low[axis]) << (8 * (slot % 4));
        words[2 + slot / 4] |= grid.line_above(bounds.high[axis]) << (8 * (slot % 4));
    }
    UVec4::from_array(words)
}

/// A node with these children's boxes.
pub(crate) fn with_boxes(boxes: [Option<Bounds>; WIDTH], inner_mask: u32, links: UVec4) -> Node {
    let all = boxes.iter().flatten().fold(Bounds::EMPTY, |a, b| a.union(b));
    let grids = [0, 1, 2].map(|axis| Grid::over(all.low[axis], all.high[axis]));
    let axis = |axis: usize| planes(&boxes, axis, grids[axis]);
    let exponents = grids.map(|grid| grid.exponent);
    let frame_w = exponents[0] | exponents[1] << 8 | exponents[2] << 16 | inner_mask << 24;
    Node {
        frame: UVec4::new(all.low.x.to_bits(), all.low.y.to_bits(), all.low.z.to_bits(), frame_w),
        links,
        x: axis(0),
        y: axis(1),
        z: axis(2),
    }
}
