//! Whether a tree keeps the promises that the traversal relies on.

use super::bounds::Bounds;
use crate::grid::byte;
use crate::node::Node;
use crate::traverse::MAX_DEPTH;
use lt_math::glam::{DVec3, UVec4};
use std::fmt;
use std::vec;
use std::vec::Vec;

/// A promise that a tree breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Invalid {
    /// The node buffer is empty; even an empty tree has a root.
    NoRoot,
    /// A link leads past the end of the node buffer.
    NodeOutOfRange {
        /// The node with the link.
        node: u32,
        /// Where it leads.
        child: u32,
    },
    /// Two links lead to the same node, or back to the root: a cycle or a shared subtree.
    VisitedTwice {
        /// The node reached again.
        node: u32,
    },
    /// A node that no link leads to.
    Unreachable {
        /// That node.
        node: u32,
    },
    /// A node deeper than the traversal's stack.
    TooDeep {
        /// That node.
        node: u32,
    },
    /// A child byte that means neither empty, inner node nor leaf, or contradicts the mask of inner nodes.
    BadChild {
        /// The node.
        node: u32,
        /// The slot.
        slot: u32,
    },
    /// A leaf names a primitive that is not there.
    PrimitiveOutOfRange {
        /// The node.
        node: u32,
        /// The primitive.
        primitive: u32,
    },
    /// A primitive in more than one leaf.
    HeldTwice {
        /// The node with the second leaf.
        node: u32,
        /// The primitive.
        primitive: u32,
    },
    /// A primitive in no leaf.
    NotHeld {
        /// The primitive.
        primitive: u32,
    },
    /// A triangle of which the SIMD tracer's tree keeps other vertices, or another answer to whether it is opaque.
    OtherTriangle {
        /// The wide node.
        node: u32,
        /// The triangle.
        primitive: u32,
    },
    /// A primitive that sticks out of the box of a child on the path to it.
    NotContained {
        /// The node.
        node: u32,
        /// The slot whose box is too small.
        slot: u32,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Invalid::NoRoot => write!(f, "the node buffer is empty: an empty tree is one zeroed node"),
            Invalid::NodeOutOfRange { node, child } => write!(f, "node {node} links to missing node {child}"),
            Invalid::VisitedTwice { node } => write!(f, "node {node} is linked to twice"),
            Invalid::Unreachable { node } => write!(f, "node {node} is linked to by none"),
            Invalid::TooDeep { node } => write!(f, "node {node} lies deeper than {MAX_DEPTH} levels"),
            Invalid::BadChild { node, slot } => write!(f, "node {node} has a malformed child in slot {slot}"),
            Invalid::PrimitiveOutOfRange { node, primitive } => {
                write!(f, "node {node} holds missing primitive {primitive}")
            }
            Invalid::HeldTwice { node, primitive } => {
                write!(f, "node {node} holds primitive {primitive}, as another does")
            }
            Invalid::NotHeld { primitive } => write!(f, "no node holds primitive {primitive}"),
            Invalid::OtherTriangle { node, primitive } => {
                write!(f, "wide node {node} holds another triangle {primitive} than the mesh has")
            }
            Invalid::NotContained { node, slot } => {
                write!(f, "the box in slot {slot} of node {node} does not contain what is under it")
            }
        }
    }
}

impl std::error::Error for Invalid {}

/// Exact box of a slot, in f64.
fn slot_box(node: &Node, slot: u32) -> (DVec3, DVec3) {
    let (low, step) = (node.low().as_dvec3(), node.step().as_dvec3());
    let grid = |planes: UVec4| {
        let (lower, upper) = if slot < 4 { (planes.x, planes.z) } else { (planes.y, planes.w) };
        (f64::from(byte(lower, slot & 3)), f64::from(byte(upper, slot & 3)))
    };
    let ((xl, xh), (yl, yh), (zl, zh)) = (grid(node.x), grid(node.y), grid(node.z));
    (low + step * DVec3::new(xl, yl, zl), low + step * DVec3::new(xh, yh, zh))
}

/// What hangs in a slot.
pub(crate) enum Slot {
    Empty,
    Inner(u32),
    Leaf { first: u32, count: u32 },
}

pub(crate) fn read_slot(node: &Node, slot: u32) -> Option<Slot> {
    let meta = byte(if slot < 4 { node.links.z } else { node.links.w }, slot & 3);
    let is_inner = node.inner_mask() >> slot & 1 == 1;
    let (unary, position) = (meta >> 5, meta & 31);
    match (is_inner, unary) {
        (true, 1) if position == 24 + slot => {
            let before = (node.inner_mask() & ((1 << slot) - 1)).count_ones();
            Some(Slot::Inner(node.links.x.checked_add(before)?))
        }
        (false, 0) if meta == 0 => Some(Slot::Empty),
        (false, 1 | 3 | 7) if position + unary.count_ones() <= 24 => {
            Some(Slot::Leaf { first: node.links.y.checked_add(position)?, count: unary.count_ones() })
        }
        _ => None,
    }
}

/// One way down: a node, the level it is on, and where it hangs.
#[derive(Clone, Copy)]
struct Visit {
    node: u32,
    level: usize,
    /// Index of the parent's visit and the slot there.
    parent: Option<(usize, u32)>,
}

/// Checks a tree of its own buffer, rooted at node 0, over primitives with the given boxes.
pub(crate) fn validate_tree(nodes: &[Node], boxes: &[Bounds]) -> Result<(), Invalid> {
    if nodes.is_empty() {
        return Err(Invalid::NoRoot);
    }
    let mut is_visited = vec![false; nodes.len()];
    let mut is_held = vec![false; boxes.len()];
    let mut visits = vec![Visit { node: 0, level: 1, parent: None }];
    is_visited[0] = true;
    let mut under: Vec<Bounds> = Vec::new();
    let mut next = 0;
    while next < visits.len() {
        let Visit { node: at, level, .. } = visits[next];
        let node = &nodes[at as usize];
        let mut all = Bounds::EMPTY;
        for slot in 0..8 {
            match read_slot(node, slot).ok_or(Invalid::BadChild { node: at, slot })? {
                Slot::Empty => {}
                Slot::Inner(child) => {
                    let seen = is_visited
                        .get_mut(child as usize)
                        .ok_or(Invalid::NodeOutOfRange { node: at, child })?;
                    if std::mem::replace(seen, true) {
                        return Err(Invalid::VisitedTwice { node: child });
                    }
                    if level + 1 > MAX_DEPTH {
                        return Err(Invalid::TooDeep { node: child });
                    }
                    visits.push(Visit { node: child, level: level + 1, parent: Some((next, slot)) });
                }
                Slot::Leaf { first, count } => {
                    let leaf = hold(at, first, count, boxes, &mut is_held)?;
                    check_box(node, at, slot, &leaf)?;
                    all = all.union(&leaf);
                }
            }
        }
        under.push(all);
        next += 1;
    }
    for (index, visit) in visits.iter().enumerate().rev() {
        if let Some((parent, slot)) = visit.parent {
            let at = visits[parent].node;
            check_box(&nodes[at as usize], at, slot, &under[index])?;
            under[parent] = under[parent].union(&under[index]);
        }
    }
    if let Some(node) = is_visited.iter().position(|seen| !seen) {
        return Err(Invalid::Unreachable { node: node as u32 });
    }
    match is_held.iter().position(|held| !held) {
        Some(primitive) => Err(Invalid::NotHeld { primitive: primitive as u32 }),
        None => Ok(()),
    }
}

/// Marks the primitives of a leaf as held; their common box.
fn hold(at: u32, first: u32, count: u32, boxes: &[Bounds], is_held: &mut [bool]) -> Result<Bounds, Invalid> {
    let mut leaf = Bounds::EMPTY;
    for primitive in first..first.saturating_add(count) {
        let held = is_held
            .get_mut(primitive as usize)
            .ok_or(Invalid::PrimitiveOutOfRange { node: at, primitive })?;
        if std::mem::replace(held, true) {
            return Err(Invalid::HeldTwice { node: at, primitive });
        }
        leaf = leaf.union(&boxes[primitive as usize]);
    }
    Ok(leaf)
}

fn check_box(node: &Node, at: u32, slot: u32, under: &Bounds) -> Result<(), Invalid> {
    let (low, high) = slot_box(node, slot);
    let is_contained = under.low.as_dvec3().cmpge(low).all() && under.high.as_dvec3().cmple(high).all();
    if is_contained { Ok(()) } else { Err(Invalid::NotContained { node: at, slot }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildQuality, Bvh};
    use lt_math::glam::Vec3;

    /// Nodes and boxes of a small valid tree of several levels.
    fn tree() -> (Vec<Node>, Vec<Bounds>) {
        let positions: Vec<Vec3> = (0..600)
            .map(|i| {
                Vec3::new((i / 3 % 10) as f32, (i / 30) as f32, 0.0) + [Vec3::ZERO, Vec3::X, Vec3::Y][i % 3]
            })
            .collect();
        let indices: Vec<[u32; 3]> = (0..200).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let bvh = Bvh::build(&positions, &indices, |_| true, BuildQuality::Fast).unwrap();
        assert!(bvh.depth() > 2);
        let boxes = bvh.triangles().iter().map(crate::build::triangle_bounds).collect();
        (bvh.nodes().to_vec(), boxes)
    }

    #[test]
    fn each_broken_promise_is_found_and_named() {
        let (nodes, boxes) = tree();
        assert_eq!(validate_tree(&nodes, &boxes), Ok(()));
        assert_eq!(validate_tree(&[], &boxes), Err(Invalid::NoRoot));
        assert!(matches!(validate_tree(&nodes[..1], &boxes), Err(Invalid::NodeOutOfRange { node: 0, .. })));
        assert!(matches!(validate_tree(&nodes, &boxes[..199]), Err(Invalid::PrimitiveOutOfRange { .. })));
        let broken = |change: &dyn Fn(&mut Vec<Node>, &mut Vec<Bounds>)| {
            let (mut nodes, mut boxes) = (nodes.clone(), boxes.clone());
            change(&mut nodes, &mut boxes);
            validate_tree(&nodes, &boxes).unwrap_err()
        };
        let cycle = broken(&|nodes, _| nodes[0].links.x = 0);
        assert_eq!(cycle, Invalid::VisitedTwice { node: 0 });
        let lost = nodes.len() as u32;
        let unreachable = broken(&|nodes, _| nodes.push(Node::default()));
        assert_eq!(unreachable, Invalid::Unreachable { node: lost });
        let not_held = broken(&|_, boxes| boxes.push(boxes[0]));
        assert_eq!(not_held, Invalid::NotHeld { primitive: 200 });
        let small = broken(&|nodes, _| nodes[0].y = UVec4::ZERO);
        assert!(matches!(small, Invalid::NotContained { .. }));
        let moved = broken(&|_, boxes| boxes[17].high.x += 100.0);
        assert!(matches!(moved, Invalid::NotContained { .. }));
        let malformed = broken(&|nodes, _| nodes[0].links.z |= 0b0101_0000);
        assert!(matches!(malformed, Invalid::BadChild { node: 0, .. }));
        let twice = broken(&|nodes, boxes| {
            boxes.fill(Bounds::EMPTY);
            nodes.iter_mut().for_each(|n| n.links.y = 0);
        });
        assert!(matches!(twice, Invalid::HeldTwice { .. }));
    }

    #[test]
    fn a_tree_deeper_than_the_stack_is_found() {
        let mut nodes = vec![Node::default(); MAX_DEPTH + 1];
        for (i, node) in nodes.iter_mut().enumerate().take(MAX_DEPTH) {
            node.frame.w = 1 << 24;
            node.links = UVec4::new(i as u32 + 1, 0, 0b0010_0000 | 24, 0);
        }
        assert_eq!(validate_tree(&nodes, &[]), Err(Invalid::TooDeep { node: MAX_DEPTH as u32 }));
        nodes.truncate(MAX_DEPTH);
        nodes[MAX_DEPTH - 1] = Node::default();
        assert_eq!(validate_tree(&nodes, &[]), Ok(()));
    }
}
