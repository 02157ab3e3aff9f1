//! How a binary tree is cut into wide nodes at the least surface-area cost, by dynamic programming (Ylitie, Karras,
//! Laine 2017, section 3.1, equations 1 to 5).

use super::binary::{BinaryTree, Content, split};
use super::bounds::Bounds;
use crate::simd::memory;
use bytemuck::Zeroable;
use rayon::prelude::*;
use std::vec::Vec;

/// Children of a wide node.
pub(crate) const WIDTH: usize = 8;

/// Costs that decide where leaves begin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LeafCost {
    /// Most primitives in a leaf.
    pub capacity: u32,
    /// Cost of a leaf, whatever it holds, relative to a node test.
    pub fixed: f32,
    /// Cost per primitive.
    pub each: f32,
}

/// Least costs of making a subtree into at most 1 to 7 children.
#[derive(Clone, Copy, Zeroable)]
struct Best {
    cost: [f32; WIDTH - 1],
    /// Primitives below.
    count: u32,
}

/// How a subtree is cut, three bits each: for 2 to 7 children, how many the left half gets, 0 for "same as with one
/// fewer"; and if the subtree becomes one wide node, how many of eight children the left half gets, 0 for a leaf.
#[derive(Clone, Copy, Default, Zeroable)]
struct Cut(u32);

impl Cut {
    fn left(self, children: usize) -> usize {
        (self.0 >> (3 * children) & 7) as usize
    }

    fn set_left(&mut self, children: usize, left: usize) {
        self.0 |= (left as u32) << (3 * children);
    }

    /// As one wide node. 1 child, for which there is nothing to cut, has its place.
    fn left_of_node(self) -> usize {
        self.left(1)
    }
}

/// The cheapest cut of every subtree.
pub(crate) struct Plan {
    cuts: Vec<Cut>,
}

/// A child of a wide node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideChild {
    /// The binary node that it is, for its box and its primitives.
    pub binary: u32,
    /// Whether it becomes a wide node, or a leaf.
    pub is_inner: bool,
}

/// The least cost of giving 1 to `n` − 1 of `n` children to the left half, and how many that are. Costs never rise with
/// the number of children, so a half that is one primitive gets one child.
fn distribute(left: &Best, right: &Best, n: usize) -> (f32, usize) {
    if left.count == 1 {
        return (left.cost[0] + right.cost[n - 2], 1);
    }
    if right.count == 1 {
        return (left.cost[n - 2] + right.cost[0], n - 1);
    }
    let mut best = (f32::INFINITY, 1);
    for k in 1..n {
        let cost = left.cost[k - 1] + right.cost[n - k - 1];
        if cost < best.0 {
            best = (cost, k);
        }
    }
    best
}

/// The best of a pair, from those of its halves.
fn join(left: &Best, right: &Best, area: f32, leaf: LeafCost) -> (Best, Cut) {
    let mut cut = Cut::default();
    let count = left.count + right.count;
    let (below, left_of_node) = distribute(left, right, WIDTH);
    let as_node = below + area;
    let as_leaf = area * (leaf.fixed + leaf.each * count as f32);
    let is_leaf = count <= leaf.capacity && as_leaf <= as_node;
    if !is_leaf {
        cut.set_left(1, left_of_node);
    }
    let mut best = Best { cost: [if is_leaf { as_leaf } else { as_node }; WIDTH - 1], count };
    for n in 2..WIDTH {
        let (cost, left) = distribute(left, right, n);
        best.cost[n - 1] = best.cost[n - 2];
        if cost < best.cost[n - 2] {
            best.cost[n - 1] = cost;
            cut.set_left(n, left);
        }
    }
    (best, cut)
}

impl Plan {
    /// Plans for `tree`, whose nodes' boxes are `bounds`.
    pub fn new(tree: &BinaryTree, bounds: &[Bounds], leaf: LeafCost) -> Self {
        // Relative areas fit f32 at every scene scale.
        let unit = bounds[0].half_area().max(f64::MIN_POSITIVE).recip();
        let of = |node: usize, best: &[Best], start: usize| {
            let area = (bounds[node].half_area() * unit) as f32;
            match tree.content(node as u32) {
                Content::Leaf(_) => {
                    let cost = [area * (leaf.fixed + leaf.each); WIDTH - 1];
                    (Best { cost, count: 1 }, Cut::default())
                }
                Content::Pair(first) => {
                    let at = first as usize - start;
                    join(&best[at], &best[at + 1], area, leaf)
                }
            }
        };
        let mut cuts: Vec<Cut> = memory::zeroed(tree.len());
        let parts = tree.parts();
        // Within a part, costs live in a buffer that fits the cache; only those of its first pair are asked for later.
        let tops: Vec<[Best; 2]> = parts
            .ranges
            .par_iter()
            .zip(split(&mut cuts, &parts.ranges))
            .map_init(Vec::new, |best, (range, cuts)| {
                best.clear();
                best.resize(range.len(), Best::zeroed());
                for node in range.clone().rev() {
                    let at = node - range.start;
                    (best[at], cuts[at]) = of(node, best, range.start);
                }
                [best[0], best[1]]
            })
            .collect();
        // Zeroed memory costs nothing until it is written: here, at the few nodes above all parts.
        let mut best: Vec<Best> = bytemuck::zeroed_vec(tree.len());
        for (range, top) in parts.ranges.iter().zip(tops) {
            best[range.start..range.start + 2].copy_from_slice(&top);
        }
        for &node in parts.above.iter().rev() {
            (best[node as usize], cuts[node as usize]) = of(node as usize, &best, 0);
        }
        Plan { cuts }
    }

    /// Whether a binary node becomes a wide node if it is a child.
    pub fn is_inner(&self, node: u32) -> bool {
        self.cuts[node as usize].left_of_node() != 0
    }

    /// The children of the wide node that `binary` becomes, at most eight, left to right. Where the plan makes it a leaf
    /// it is its own only child: so for a root with few primitives, which still need a node to hold them.
    pub fn children(&self, tree: &BinaryTree, binary: u32, into: &mut Vec<WideChild>) {
        into.clear();
        match (tree.content(binary), self.cuts[binary as usize].left_of_node()) {
            (Content::Pair(first), left) if left != 0 => {
                self.gather(tree, first, left, into);
                self.gather(tree, first + 1, WIDTH - left, into);
            }
            _ => into.push(WideChild { binary, is_inner: false }),
        }
    }

    /// Appends the children that `node` contributes if it may be up to `n`; recursion is at most seven deep.
    fn gather(&self, tree: &BinaryTree, node: u32, n: usize, into: &mut Vec<WideChild>) {
        let cut = self.cuts[node as usize];
        let mut n = n;
        while n > 1 && cut.left(n) == 0 {
            n -= 1;
        }
        match tree.content(node) {
            Content::Pair(first) if n > 1 => {
                let left = cut.left(n);
                self.gather(tree, first, left, into);
                self.gather(tree, first + 1, n - left, into);
            }
            _ => into.push(WideChild { binary: node, is_inner: self.is_inner(node) }),
        }
    }
}
