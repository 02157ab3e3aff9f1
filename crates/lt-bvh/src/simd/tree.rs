//! The wide tree of the CPU: exact boxes of eight children side by side, and triangles in blocks of eight.

use super::memory;
use crate::build::{BinaryTree, Bounds, LeafCost, WideTree};
use crate::node::Node;
use crate::ray::{FAR, NONE};
use crate::traverse::MAX_DEPTH;
use crate::triangle::Triangle;
use lt_math::glam::Vec3;
use std::vec;
use std::vec::Vec;

/// Bit of a child link that marks a leaf; below it the block of triangles, or the instance.
pub(crate) const LEAF: u32 = 0x8000_0000;

/// Link to the root.
pub(crate) const ROOT: u32 = 0;

/// Links that may wait on the stack: at most seven siblings per level, and room for eight at the top.
pub(crate) const STACK: usize = 7 * MAX_DEPTH + 9;

/// One block per leaf, whatever it holds: testing one triangle or eight costs the same.
pub(crate) const BLOCK_LEAF: LeafCost = LeafCost { capacity: 8, fixed: 1.5, each: 0.0 };
/// A leaf is one instance.
pub(crate) const INSTANCE_LEAF: LeafCost = LeafCost { capacity: 1, fixed: 2.0, each: 0.0 };

/// Eight children.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideNode {
    /// Lower and upper planes in x, y, z, from the tree's `base`; lower above upper where there is no child.
    pub planes: [[f32; 8]; 6],
    /// Links to inner nodes, or leaves.
    pub children: [u32; 8],
}

/// Up to eight triangles of a leaf, side by side and without gaps.
///
/// In the tree's buffer a block is a word with the number of triangles n and, from bit 8, a bit for each that asks the
/// callback; then n numbers for each axis of each vertex; then n indices. Eight lanes loaded from such a row reach into the
/// next one: the lanes behind n hold anything and are masked out.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// From the first vertex's x on, and at least eight words past the end.
    words: &'a [u32],
    len: usize,
    asking: u32,
}

/// Rows of a block before its indices: three axes of three vertices.
const ROWS: usize = 9;
/// Words that a load of eight lanes reads.
const LOAD: usize = 8;

fn words_of_block(len: usize) -> usize {
    1 + (ROWS + 1) * len
}

impl<'a> Block<'a> {
    /// Triangles in it: 1 to 8.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Mask of the lanes that hold triangles.
    #[inline(always)]
    pub fn lanes(&self) -> u32 {
        0xff >> (8 - self.len)
    }

    /// Whether the hits on a triangle need asking.
    #[inline(always)]
    pub fn asks(&self, lane: usize) -> bool {
        self.asking >> lane & 1 != 0
    }

    /// One coordinate of all triangles, at least eight lanes long.
    #[inline(always)]
    pub fn row(&self, vertex: usize, axis: usize) -> &'a [f32] {
        bytemuck::cast_slice(&self.words[(3 * vertex + axis) * self.len..])
    }

    /// One coordinate of one triangle.
    #[inline(always)]
    pub fn coordinate(&self, vertex: usize, axis: usize, lane: usize) -> f32 {
        f32::from_bits(self.words[(3 * vertex + axis) * self.len + lane])
    }

    /// Index of a triangle in leaf order of the tree's own triangles.
    #[inline(always)]
    pub fn triangle(&self, lane: usize) -> u32 {
        self.words[ROWS * self.len + lane]
    }
}

/// The words of a block; see [`Block`].
fn push_block(indices: &[u32], triangles: &[Triangle], words: &mut Vec<u32>) {
    let asking = indices
        .iter()
        .enumerate()
        .map(|(lane, &i)| u32::from(!triangles[i as usize].is_opaque()) << (8 + lane));
    words.push(indices.len() as u32 | asking.fold(0, |all, bit| all | bit));
    for vertex in [|t: &Triangle| t.v0, |t: &Triangle| t.v1, |t: &Triangle| t.v2] {
        for axis in 0..3 {
            words.extend(indices.iter().map(|&i| vertex(&triangles[i as usize])[axis].to_bits()));
        }
    }
    words.extend_from_slice(indices);
}

/// A wide tree over triangles or instances.
#[derive(Debug)]
pub(crate) struct SimdTree {
    pub nodes: Vec<WideNode>,
    /// [`Block`]s, named by the index of their first word.
    blocks: Vec<u32>,
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

const NO_CHILD: WideNode =
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
        let boxes: Vec<Bounds> = triangles.iter().map(crate::build::triangle_bounds).collect();
        let mut end = 0;
        let (mut tree, leaves) = Self::collapse(binary, &boxes, BLOCK_LEAF, root, |held| {
            let begin = end;
            end += words_of_block(held.len());
            begin as u32
        });
        // Blocks are the largest part: they come once the boxes are gone, and at their exact number.
        drop(boxes);
        let mut words = memory::with_capacity(end + LOAD);
        leaves.iter().for_each(|leaf| push_block(leaf, triangles, &mut words));
        // What a load from the last row reaches beyond it.
        words.extend([0; LOAD]);
        tree.blocks = words;
        tree
    }

    /// Starts to fetch what a link leads to.
    #[inline(always)]
    pub fn prefetch(&self, link: u32) {
        if link & LEAF != 0 {
            if let Some(word) = self.blocks.get((link & !LEAF) as usize) {
                memory::prefetch(word);
            }
        } else if let Some(node) = self.nodes.get(link as usize) {
            for planes in node.planes.iter().step_by(2) {
                memory::prefetch(planes);
            }
            memory::prefetch(&node.children);
        }
    }

    /// The block of a leaf's link.
    #[inline(always)]
    pub fn block(&self, link: u32) -> Block<'_> {
        let words = &self.blocks[(link & !LEAF) as usize..];
        Block { words: &words[1..], len: (words[0] & 15) as usize, asking: words[0] >> 8 }
    }

    /// Over the boxes of instances in leaf order; `root` is the shared kernel's TLAS root.
    pub fn of_instances(binary: Option<&BinaryTree>, boxes: &[Bounds], root: &Node) -> Self {
        let Some(binary) = binary else { return Self::empty() };
        Self::collapse(binary, boxes, INSTANCE_LEAF, root, |held| held[0]).0
    }

    /// The nodes, and what each leaf holds. `link` says what a parent stores of a leaf, from its content.
    fn collapse(
        binary: &BinaryTree,
        boxes: &[Bounds],
        cost: LeafCost,
        root: &Node,
        mut link: impl FnMut(&[u32]) -> u32,
    ) -> (Self, Leaves) {
        let mut bounds = binary.bounds(boxes);
        let balanced;
        let mut tree = binary;
        let mut wide = WideTree::collapse(tree, &bounds, cost);
        if wide.depth > MAX_DEPTH {
            balanced = BinaryTree::balanced(boxes);
            tree = &balanced;
            bounds = tree.bounds(boxes);
            wide = WideTree::collapse(tree, &bounds, cost);
        }
        let base = root.low();
        let mut nodes = memory::with_capacity(wide.nodes.len());
        let mut leaves = Leaves { ends: Vec::new(), primitives: Vec::with_capacity(boxes.len()) };
        for index in 0..wide.nodes.len() {
            let mut node = NO_CHILD;
            let mut children = wide.children(index).to_vec();
            // The last one pushed is visited first: let that be the one a ray meets most likely.
            children.sort_by(|a, b| {
                let area = |c: u32| bounds[c as usize].half_area();
                area(a.binary).total_cmp(&area(b.binary))
            });
            for (lane, child) in children.iter().enumerate() {
                let (low, high) = (bounds[child.binary as usize].low, bounds[child.binary as usize].high);
                for axis in 0..3 {
                    node.planes[2 * axis][lane] = low[axis] - base[axis];
                    node.planes[2 * axis + 1][lane] = high[axis] - base[axis];
                }
                node.children[lane] = child.inner.unwrap_or_else(|| {
                    let begin = leaves.primitives.len();
                    tree.primitives_under(child.binary, &mut leaves.primitives);
                    leaves.ends.push(leaves.primitives.len() as u32);
                    LEAF | link(&leaves.primitives[begin..])
                });
            }
            nodes.push(node);
        }
        (SimdTree { nodes, blocks: Vec::new(), base, low: root.low(), high: root.high() }, leaves)
    }
}

/// What the leaves hold, one after the other.
struct Leaves {
    /// One past each leaf's last primitive.
    ends: Vec<u32>,
    primitives: Vec<u32>,
}

impl Leaves {
    fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.ends.len()).map(|leaf| {
            let begin = if leaf == 0 { 0 } else { self.ends[leaf - 1] };
            &self.primitives[begin as usize..self.ends[leaf] as usize]
        })
    }
}
