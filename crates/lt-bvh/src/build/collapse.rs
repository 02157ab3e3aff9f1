//! Binary tree to wide tree at the least surface-area cost, by dynamic programming (Ylitie, Karras, Laine 2017,
//! section 3.1, equations 1 to 5).

use super::binary::{BinaryTree, Content};
use super::bounds::Bounds;
use std::vec;
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

/// A child of a wide node: a node of the binary tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideChild {
    /// The binary node, for its box and its primitives.
    pub binary: u32,
    /// The wide node it became, `None` for a leaf.
    pub inner: Option<u32>,
}

/// A tree of up to eight children per node; the root is node 0 and siblings are consecutive.
pub(crate) struct WideTree {
    /// Each node's range of `children`.
    pub nodes: Vec<(u32, u32)>,
    pub children: Vec<WideChild>,
    /// Levels, counting the root.
    pub depth: usize,
}

/// Best ways to make a subtree into at most 1 to 7 children, and how the root of it is cut.
#[derive(Clone, Copy)]
struct Plan {
    cost: [f32; WIDTH - 1],
    /// For 2 to 7 children: how many the left half gets, 0 for "same as with one fewer".
    left: [u8; WIDTH - 1],
    /// If the subtree becomes one wide node: how many of eight children the left half gets; 0 for a leaf.
    left_of_node: u8,
}

fn plan_all(tree: &BinaryTree, bounds: &[Bounds], leaf: LeafCost) -> Vec<Plan> {
    // Relative areas fit f32 at every scene scale.
    let unit = bounds[0].half_area().max(f64::MIN_POSITIVE).recip();
    let none = Plan { cost: [0.0; WIDTH - 1], left: [0; WIDTH - 1], left_of_node: 0 };
    let mut plans = vec![none; tree.len()];
    let mut counts = vec![1u32; tree.len()];
    for node in (0..tree.len()).rev() {
        let area = (bounds[node].half_area() * unit) as f32;
        let Content::Pair(first) = tree.content(node as u32) else {
            plans[node].cost = [area * (leaf.fixed + leaf.each); WIDTH - 1];
            continue;
        };
        let (left, right) = (plans[first as usize], plans[first as usize + 1]);
        let count = counts[first as usize] + counts[first as usize + 1];
        counts[node] = count;
        // The best of giving 1 to n − 1 of n children to the left half.
        let distribute = |n: usize| {
            let mut best = (f32::INFINITY, 1);
            for k in 1..n {
                let cost = left.cost[k - 1] + right.cost[n - k - 1];
                if cost < best.0 {
                    best = (cost, k as u8);
                }
            }
            best
        };
        let plan = &mut plans[node];
        let (below, cut) = distribute(WIDTH);
        let as_node = below + area;
        let as_leaf = area * (leaf.fixed + leaf.each * count as f32);
        let is_leaf = count <= leaf.capacity && as_leaf <= as_node;
        plan.left_of_node = if is_leaf { 0 } else { cut };
        plan.cost[0] = if is_leaf { as_leaf } else { as_node };
        for n in 2..WIDTH {
            let (cost, cut) = distribute(n);
            let is_better = cost < plan.cost[n - 2];
            plan.left[n - 1] = if is_better { cut } else { 0 };
            plan.cost[n - 1] = if is_better { cost } else { plan.cost[n - 2] };
        }
    }
    plans
}

/// Appends the children that `node` contributes if it may be up to `n`; recursion is at most seven deep.
fn gather(tree: &BinaryTree, plans: &[Plan], node: u32, n: usize, into: &mut Vec<u32>) {
    let mut n = n;
    while n > 1 && plans[node as usize].left[n - 1] == 0 {
        n -= 1;
    }
    match tree.content(node) {
        Content::Pair(first) if n > 1 => {
            let left = plans[node as usize].left[n - 1] as usize;
            gather(tree, plans, first, left, into);
            gather(tree, plans, first + 1, n - left, into);
        }
        _ => into.push(node),
    }
}

impl WideTree {
    /// Collapses `tree`, whose nodes' boxes are `bounds`.
    pub fn collapse(tree: &BinaryTree, bounds: &[Bounds], leaf: LeafCost) -> Self {
        let plans = plan_all(tree, bounds, leaf);
        let mut wide = WideTree { nodes: vec![(0, 0)], children: Vec::new(), depth: 1 };
        let mut pending = vec![(0u32, 0u32, 1usize)];
        let mut found = Vec::with_capacity(WIDTH);
        while let Some((node, binary, level)) = pending.pop() {
            wide.depth = wide.depth.max(level);
            found.clear();
            match (tree.content(binary), plans[binary as usize].left_of_node) {
                (Content::Pair(first), cut) if cut != 0 => {
                    gather(tree, &plans, first, cut as usize, &mut found);
                    gather(tree, &plans, first + 1, WIDTH - cut as usize, &mut found);
                }
                // Only the root: a tree small enough to be a leaf still needs a node to hold it.
                _ => found.push(binary),
            }
            let begin = wide.children.len() as u32;
            for &child in &found {
                let is_inner = plans[child as usize].left_of_node != 0;
                let inner = is_inner.then(|| {
                    wide.nodes.push((0, 0));
                    wide.nodes.len() as u32 - 1
                });
                if let Some(inner) = inner {
                    pending.push((inner, child, level + 1));
                }
                wide.children.push(WideChild { binary: child, inner });
            }
            wide.nodes[node as usize] = (begin, wide.children.len() as u32);
        }
        wide
    }

    pub fn children(&self, node: usize) -> &[WideChild] {
        let (begin, end) = self.nodes[node];
        &self.children[begin as usize..end as usize]
    }
}
