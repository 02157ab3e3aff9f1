//! The binary tree that everything else is collapsed from: PLOC with reinsertion (Meister & Bittner 2018, by
//! obvhs), or halves along a Morton curve where that grows too deep.

use super::bounds::Bounds;
use super::quality::BuildQuality;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;
use rayon::prelude::*;
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
        let unit = to_unit_cube(boxes);
        if boxes.len() == 1 {
            return BinaryTree { nodes: vec![LEAF] };
        }
        let parameters = quality.parameters();
        let indices = (0..boxes.len() as u32).collect();
        let mut tree = PlocBuilder::with_capacity(unit.len()).build(
            parameters.ploc_search_distance,
            &unit,
            indices,
            parameters.sort_precision,
            parameters.search_depth_threshold,
        );
        ReinsertionOptimizer::default().run(&mut tree, parameters.reinsertion_batch_ratio, None);
        Self::from_obvhs(&tree)
    }

    /// Halves the primitives along a Morton curve of their centres: never deeper than log₂ n + 1.
    pub fn balanced(boxes: &[Bounds]) -> Self {
        let unit = to_unit_cube(boxes);
        let mut order: Vec<(u64, u32)> =
            unit.iter().enumerate().map(|(i, b)| (morton(b.center().to_array()), i as u32)).collect();
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
            pending.push((first, begin, middle));
            pending.push((first + 1, middle, end));
        }
        BinaryTree { nodes }
    }

    fn from_obvhs(tree: &Bvh2) -> Self {
        let mut nodes = Vec::with_capacity(tree.nodes.len());
        nodes.push(0);
        let mut pending = vec![(0, 0)];
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
        for link in &mut self.nodes {
            if *link & LEAF != 0 {
                *link = LEAF | new[(*link & !LEAF) as usize];
            }
        }
    }

    /// Box of every node, from those of the primitives.
    pub fn bounds(&self, boxes: &[Bounds]) -> Vec<Bounds> {
        let mut bounds = vec![Bounds::EMPTY; self.nodes.len()];
        for node in (0..self.nodes.len()).rev() {
            bounds[node] = match self.content(node as u32) {
                Content::Leaf(primitive) => boxes[primitive as usize],
                Content::Pair(first) => bounds[first as usize].union(&bounds[first as usize + 1]),
            };
        }
        bounds
    }

    /// Appends the primitives under `node`, left to right.
    pub fn primitives_under(&self, node: u32, into: &mut Vec<u32>) {
        let mut pending = vec![node];
        while let Some(node) = pending.pop() {
            match self.content(node) {
                Content::Leaf(primitive) => into.push(primitive),
                Content::Pair(first) => pending.extend([first + 1, first]),
            }
        }
    }
}

/// Boxes moved and scaled into the unit cube, so that areas neither overflow nor vanish at any scene scale.
fn to_unit_cube(boxes: &[Bounds]) -> Vec<Aabb> {
    let scene = boxes.iter().fold(Bounds::EMPTY, |a, b| a.union(b));
    let (low, high) = (scene.low.as_dvec3(), scene.high.as_dvec3());
    let extent = (high - low).max_element();
    let scale = if extent > 0.0 { 1.0 / extent } else { 1.0 };
    let unit = |b: &Bounds| {
        let (l, h) = ((b.low.as_dvec3() - low) * scale, (b.high.as_dvec3() - low) * scale);
        Aabb::new(l.as_vec3a(), h.as_vec3a())
    };
    boxes.par_iter().map(unit).collect()
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
