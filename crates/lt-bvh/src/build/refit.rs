//! New boxes on an old topology, for meshes that deform.

use super::bounds::Bounds;
use super::collapse::WIDTH;
use super::quantize::with_boxes;
use super::validate::{Slot, read_slot};
use crate::node::Node;
use rayon::prelude::*;
use std::vec::Vec;

/// The shared kernel's nodes with the boxes that their primitives have now. Children must come after their parents, as
/// the builder writes them.
pub(crate) fn refit(nodes: &[Node], boxes: impl Fn(u32) -> Bounds + Sync) -> Vec<Node> {
    let leaf = |first: u32, count: u32| {
        (first..first + count).fold(Bounds::EMPTY, |all, primitive| all.union(&boxes(primitive)))
    };
    // What every node holds itself, then what lies below it too.
    let of_leaves = |node: &Node| {
        slots(node).fold(Bounds::EMPTY, |all, slot| match slot {
            Slot::Leaf { first, count } => all.union(&leaf(first, count)),
            Slot::Empty | Slot::Inner(_) => all,
        })
    };
    let mut below: Vec<Bounds> = nodes.par_iter().map(of_leaves).collect();
    for (at, node) in nodes.iter().enumerate().rev() {
        for slot in slots(node) {
            if let Slot::Inner(child) = slot {
                debug_assert!(child as usize > at, "children come after their parents");
                below[at] = below[at].union(&below[child as usize]);
            }
        }
    }
    let renewed = |node: &Node| {
        let mut boxes: [Option<Bounds>; WIDTH] = [None; WIDTH];
        for (to, slot) in boxes.iter_mut().zip(slots(node)) {
            *to = match slot {
                Slot::Empty => None,
                Slot::Inner(child) => Some(below[child as usize]),
                Slot::Leaf { first, count } => Some(leaf(first, count)),
            };
        }
        with_boxes(boxes, node.inner_mask(), node.links)
    };
    nodes.par_iter().map(renewed).collect()
}

/// What the eight slots of a node hold; of the builder's nodes none is malformed.
fn slots(node: &Node) -> impl Iterator<Item = Slot> {
    (0..WIDTH as u32).map(|slot| read_slot(node, slot).unwrap_or(Slot::Empty))
}
