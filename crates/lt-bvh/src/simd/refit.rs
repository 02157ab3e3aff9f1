//! New boxes and vertices on an old topology, and whether a tree keeps its promises.

use super::tree::{BLOCKS, LEAF, SimdTree, WORDS, WideNode, block_link, first_and_count, write_block};
use crate::build::{Bounds, Invalid, split, triangle_bounds};
use crate::node::Node;
use crate::ray::NONE;
use crate::traverse::MAX_DEPTH;
use crate::triangle::Triangle;
use rayon::prelude::*;
use std::ops::Range;
use std::vec;
use std::vec::Vec;

impl SimdTree {
    /// The same tree over `triangles` that have moved, in the same order; `root` is the shared kernel's root node.
    pub fn refit(&self, triangles: &[Triangle], root: &Node) -> Self {
        let base = root.low();
        let below = self.boxes_below(triangles);
        let renewed = |node: &WideNode| {
            let mut node = *node;
            for lane in 0..node.children.len() {
                match node.children[lane] {
                    NONE => {}
                    link if link & LEAF != 0 => node.set_box(lane, &self.leaf_box(link, triangles), base),
                    child => node.set_box(lane, &below[child as usize], base),
                }
            }
            node
        };
        let mut nodes: Vec<WideNode> = super::memory::zeroed(self.nodes.len());
        nodes.par_iter_mut().zip(&self.nodes).for_each(|(to, from)| *to = renewed(from));
        let blocks = self.moved_blocks(triangles);
        SimdTree { nodes, blocks, base, low: root.low(), high: root.high() }
    }

    /// Box of what lies below each node. Children come after their parents.
    fn boxes_below(&self, triangles: &[Triangle]) -> Vec<Bounds> {
        let leaves = |node: &WideNode| {
            let links = node.children.iter().filter(|&&link| link != NONE && link & LEAF != 0);
            links.fold(Bounds::EMPTY, |all, &link| all.union(&self.leaf_box(link, triangles)))
        };
        let mut below: Vec<Bounds> = self.nodes.par_iter().map(leaves).collect();
        for (at, node) in self.nodes.iter().enumerate().rev() {
            for &child in node.children.iter().filter(|&&link| link & LEAF == 0) {
                debug_assert!(child as usize > at, "children come after their parents");
                below[at] = below[at].union(&below[child as usize]);
            }
        }
        below
    }

    /// Links to all leaves.
    pub(super) fn leaf_links(&self) -> impl Iterator<Item = u32> {
        let links = self.nodes.iter().flat_map(|node| node.children);
        links.filter(|&link| link != NONE && link & LEAF != 0)
    }

    fn leaf_box(&self, link: u32, triangles: &[Triangle]) -> Bounds {
        let block = self.block(link);
        (0..block.len()).fold(Bounds::EMPTY, |all, lane| {
            all.union(&triangle_bounds(&triangles[block.triangle(lane) as usize]))
        })
    }

    /// The blocks with the vertices that their triangles have now.
    fn moved_blocks(&self, triangles: &[Triangle]) -> Vec<u32> {
        let mut words = super::memory::zeroed(self.blocks.len());
        // How many triangles the block has of which the first is this one.
        let mut counts = vec![0u8; triangles.len()];
        for (first, count) in self.leaf_links().map(first_and_count) {
            counts[first] = count as u8;
        }
        // Blocks follow one another; one begins a task where enough triangles have passed.
        let (mut at, mut starts) = (0, Vec::new());
        while at < counts.len() {
            if starts.last().is_none_or(|&start| at - start >= BLOCKS) {
                starts.push(at);
            }
            at += usize::from(counts[at]);
        }
        starts.push(counts.len());
        let ranges: Vec<Range<usize>> =
            starts.windows(2).map(|ends| ends[0] * WORDS..ends[1] * WORDS).collect();
        ranges.par_iter().zip(split(&mut words, &ranges)).for_each(|(range, mut words)| {
            let mut at = range.start / WORDS;
            while !words.is_empty() {
                let count = usize::from(counts[at]);
                let block = self.block(block_link(at as u32, count));
                let mut held = [0; 8];
                for (lane, held) in held[..count].iter_mut().enumerate() {
                    *held = block.triangle(lane);
                }
                let (to, rest) = words.split_at_mut(WORDS * count);
                write_block(&held[..count], triangles, to);
                at += count;
                words = rest;
            }
        });
        words
    }

    /// Checks that the tree holds every triangle once, as it is, in boxes that contain it, within [`MAX_DEPTH`] levels.
    pub fn validate(&self, triangles: &[Triangle]) -> Result<(), Invalid> {
        let mut is_held = vec![false; triangles.len()];
        let mut is_visited = vec![false; self.nodes.len()];
        let mut pending = vec![(0u32, 1)];
        // Before anything follows a link from a node to a later one.
        while let Some((at, level)) = pending.pop() {
            if std::mem::replace(&mut is_visited[at as usize], true) {
                return Err(Invalid::VisitedTwice { node: at });
            }
            if level > MAX_DEPTH {
                return Err(Invalid::TooDeep { node: at });
            }
            for &link in self.nodes[at as usize].children.iter().filter(|&&link| link != NONE) {
                if link & LEAF == 0 {
                    if link as usize >= self.nodes.len() {
                        return Err(Invalid::NodeOutOfRange { node: at, child: link });
                    }
                    pending.push((link, level + 1));
                } else {
                    self.hold(at, link, triangles, &mut is_held)?;
                }
            }
        }
        if let Some(node) = is_visited.iter().position(|seen| !seen) {
            return Err(Invalid::Unreachable { node: node as u32 });
        }
        if let Some(primitive) = is_held.iter().position(|held| !held) {
            return Err(Invalid::NotHeld { primitive: primitive as u32 });
        }
        let below = self.boxes_below(triangles);
        for (at, node) in self.nodes.iter().enumerate() {
            for (lane, &link) in node.children.iter().enumerate().filter(|(_, link)| **link != NONE) {
                let under =
                    if link & LEAF != 0 { self.leaf_box(link, triangles) } else { below[link as usize] };
                let (low, high) = (under.low - self.base, under.high - self.base);
                let is_contained = (0..3).all(|axis| {
                    node.planes[2 * axis][lane] <= low[axis] && high[axis] <= node.planes[2 * axis + 1][lane]
                });
                if !is_contained {
                    return Err(Invalid::NotContained { node: at as u32, slot: lane as u32 });
                }
            }
        }
        Ok(())
    }

    /// Marks the triangles of a leaf as held.
    fn hold(
        &self,
        node: u32,
        link: u32,
        triangles: &[Triangle],
        is_held: &mut [bool],
    ) -> Result<(), Invalid> {
        let block = self.block(link);
        for lane in 0..block.len() {
            let primitive = block.triangle(lane);
            let triangle =
                triangles.get(primitive as usize).ok_or(Invalid::PrimitiveOutOfRange { node, primitive })?;
            if std::mem::replace(&mut is_held[primitive as usize], true) {
                return Err(Invalid::HeldTwice { node, primitive });
            }
            let corners = [triangle.v0, triangle.v1, triangle.v2];
            let is_same = corners.iter().enumerate().all(|(vertex, corner)| {
                (0..3).all(|axis| block.coordinate(vertex, axis, lane).to_bits() == corner[axis].to_bits())
            });
            if !is_same || block.asks(lane) == triangle.is_opaque() {
                return Err(Invalid::OtherTriangle { node, primitive });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildQuality, Bvh};
    use lt_math::glam::Vec3;

    fn strip() -> Bvh {
        let corner = |i: u32| Vec3::new(i as f32, (i % 7) as f32, (i * i % 11) as f32);
        let positions: Vec<Vec3> = (0..303).map(corner).collect();
        let indices: Vec<[u32; 3]> = (0..300).map(|i| [i, i + 1, i + 3]).collect();
        Bvh::build(&positions, &indices, |i| i % 3 != 0, BuildQuality::Medium).unwrap()
    }

    #[test]
    fn each_broken_promise_of_the_wide_tree_is_found_and_named() {
        let bvh = strip();
        let triangles = bvh.triangles();
        let part = bvh.simd_part();
        assert_eq!(part.tree.validate(triangles), Ok(()));
        assert!(part.tree.nodes.len() > 4);
        let refit = || part.tree.refit(triangles, &bvh.nodes()[0]);
        assert_eq!(refit().validate(triangles), Ok(()));
        let broken = |change: &dyn Fn(&mut SimdTree)| {
            let mut tree = refit();
            change(&mut tree);
            tree.validate(triangles).unwrap_err()
        };
        let first_inner =
            |tree: &SimdTree| tree.nodes[0].children.iter().position(|link| link & LEAF == 0).unwrap();
        let small = broken(&|tree| tree.nodes[0].planes[1][0] -= 1.0);
        assert_eq!(small, Invalid::NotContained { node: 0, slot: 0 });
        let cycle = broken(&|tree| {
            let lane = first_inner(tree);
            tree.nodes[0].children[lane] = 0;
        });
        assert_eq!(cycle, Invalid::VisitedTwice { node: 0 });
        let beyond = broken(&|tree| {
            let lane = first_inner(tree);
            tree.nodes[0].children[lane] = 1 << 20;
        });
        assert_eq!(beyond, Invalid::NodeOutOfRange { node: 0, child: 1 << 20 });
        let lost = broken(&|tree| {
            let lane = first_inner(tree);
            tree.nodes[0].children[lane] = NONE;
        });
        assert!(matches!(lost, Invalid::Unreachable { .. }));
        let moved = broken(&|tree| tree.blocks[0] = 7.5f32.to_bits());
        assert!(matches!(moved, Invalid::OtherTriangle { .. }));
        let asking = broken(&|tree| {
            let (first, count) = first_and_count(tree.leaf_links().next().unwrap());
            tree.blocks[WORDS * (first + count) - 1] ^= 1 << 31;
        });
        assert!(matches!(asking, Invalid::OtherTriangle { .. }));
        let mut more = triangles.to_vec();
        more.push(more[0]);
        assert_eq!(part.tree.validate(&more), Err(Invalid::NotHeld { primitive: 300 }));
        assert!(matches!(part.tree.validate(&triangles[..200]), Err(Invalid::PrimitiveOutOfRange { .. })));
    }
}
