//! How the SIMD tracer's nodes are written.

use super::tree::{LEAF, NO_CHILD, WideNode, block_link};
use crate::build::{Bounds, Encoder, Held, WIDTH, WideChild};
use lt_math::glam::Vec3;

/// What the link of a leaf says.
#[derive(Clone, Copy)]
pub(crate) enum LeafLink {
    /// Its block: see [`block_link`].
    Block,
    /// The one primitive that it holds.
    Primitive,
}

/// Exact boxes relative to `base`.
pub(crate) struct WideLayout {
    pub base: Vec3,
    pub link: LeafLink,
}

impl Encoder for WideLayout {
    type Node = WideNode;

    /// By rising area: the last one pushed is visited first, let that be the one a ray meets most likely.
    fn arrange(&self, children: &[WideChild], bounds: &[Bounds]) -> [Option<WideChild>; WIDTH] {
        let mut sorted = [None; WIDTH];
        for (slot, &child) in sorted.iter_mut().zip(children) {
            *slot = Some((bounds[child.binary as usize].half_area(), child));
        }
        sorted[..children.len()]
            .sort_by(|a, b| a.map_or(0.0, |(area, _)| area).total_cmp(&b.map_or(0.0, |(area, _)| area)));
        sorted.map(|slot| slot.map(|(_, child)| child))
    }

    fn encode(&self, slots: &[Option<(Bounds, Held)>; WIDTH], _: u32, _: u32) -> WideNode {
        let mut node = NO_CHILD;
        for (lane, content) in slots.iter().enumerate() {
            let Some((bounds, held)) = content else { continue };
            node.set_box(lane, bounds, self.base);
            node.children[lane] = match (held, self.link) {
                (Held::Inner(node), _) => *node,
                (Held::Leaf { primitives, first }, LeafLink::Block) => block_link(*first, primitives.len()),
                (Held::Leaf { primitives, .. }, LeafLink::Primitive) => LEAF | primitives[0],
            };
        }
        node
    }
}

impl WideNode {
    /// Puts the box of a child into its lane.
    pub fn set_box(&mut self, lane: usize, bounds: &Bounds, base: Vec3) {
        for axis in 0..3 {
            self.planes[2 * axis][lane] = bounds.low[axis] - base[axis];
            self.planes[2 * axis + 1][lane] = bounds.high[axis] - base[axis];
        }
    }
}
