//! A light BVH in the buffers of the shared kernel (`lt_bvh::occluded_in_light_space`), for GPUs.
//!
//! The trees are [`LightBvh`]'s own; every triangle of a block has its own box here, because the kernel has no planes: it opens what a point
//! lies in, and decides by the ray tracer's own test alone. Boxes are rectangles less two corners (`hexagon.rs`).
//!
//! # Proof that no hit is lost
//!
//! On a GPU products may be contracted to fused multiply-adds, and a division may be off by 2.5 units in the last place: 5ε of its value,
//! ε = 2⁻²⁴, where ours are off by 1ε. So the ray tracer's test there may say yes where it says no here, and the point that walks the
//! tree is another. The rectangles are those of the CPU (`rect.rs`); what follows is that their margins, made for its rounding, also
//! hold for a GPU's, both for the test and for the point. R and D are as in `planes.rs`, first-order bounds.
//!
//! *The slab test.* Its planes and its margin of 16εR are multiplied by the same reciprocal, so that along one axis only 4εR of
//! rounding come in, as on the CPU. Between axes reciprocals differ by 2 · 5ε: 10εR in place. A ray that hits meets the triangle's box
//! widened by 20εR along z, 30εR along x and y.
//!
//! *Nearness.* A hit lies before the light, so that the ray passes that box on its way: the point's nearness is at most the box's and 20εR, its
//! own rounding εD included. The margin is 32εR. Positioned: nearness 1/z is off by 5ε of itself, which at a distance of z ≤ R is 5εR: 25εR;
//! the reciprocal of the rectangle has 8ε of itself to spare for its own.
//!
//! *Place, slivers.* The box's projection, widened by 30εR along x, y and z, is widened by 60εR; point and box are off by 2.5εD each. The
//! margin is 80εR.
//!
//! *Place, others.* The test shears vertices by slopes that are off by 5ε, not 1ε: a sheared vertex is off by at most 10εD, 12εD under a
//! positioned light. The point is off by 2.5εD, positioned 5ε of a slope of at most 1; the rectangle by 2.5εD. Together 20εD; the margin is
//! 32εD. A point outside of the rectangle that passed all edges would see all vertices within an angle of 4ε, as in `rect.rs`: rounded
//! products, fused or not, are off by no more. Then twice the projected area is at most 8εDW and the 4 · 12εDW that rounded vertices
//! add, and triangles of less than 307εDW (`planes.rs`) are slivers.
//!
//! *The third pair of sides.* c = a·X + b·Y with |a|, |b| ≤ 1, and margins of |a| + |b| times those of X and Y: what moves X and Y moves c
//! by no more, and the reasons above hold in any direction of the plane. Evaluating c, here and there, adds 4εD (|a| + |b|), which makes 24εD
//! of 32εD. Slopes beyond 1, where a division of equals is off, are within the 16ε by which lamps' hexagons are wider.
//!
//! *Boxes of eight bits.* The kernel subtracts where a grid begins and compares with lines of the grid, which loses nothing
//! (`lt_bvh::Grid`): a subtraction that rounds never carries past a line, which is an f32 number. All else there is exact.
//!
//! Tests move points by these bounds, in every direction, and find all hits.

use crate::block::Block;
use crate::casters::Casters;
use crate::hexagon::{Hexagon, hexagons};
use crate::light_bvh::LightBvh;
use crate::tree::{LEAF, Tree, WIDTH};
use alloc::vec::Vec;
use core::fmt;
use lt_bvh::{Grid, LightNode, LightSpace, MAX_DEPTH, NODE_ROWS};
use lt_math::glam::UVec4;

/// A light BVH as kernels walk it.
#[derive(Clone, Debug)]
pub struct PackedLightBvh {
    /// How rays become points, and the roots of the trees.
    pub space: LightSpace,
    /// Nodes of all trees, then the triangles of their leaves: the buffer that the kernel takes. At least one row.
    pub rows: Vec<UVec4>,
}

/// Why a light BVH cannot be packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unpackable {
    /// The kernel's stack does not hold so many levels.
    TooDeep {
        /// Levels of the tree.
        levels: usize,
    },
    /// Nodes are named by 24 bits.
    TooLarge {
        /// How many there are.
        nodes: usize,
    },
}

impl fmt::Display for Unpackable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unpackable::TooDeep { levels } => {
                write!(f, "the tree in light space has {levels} levels, {MAX_DEPTH} are possible")
            }
            Unpackable::TooLarge { nodes } => {
                write!(f, "the tree in light space has {nodes} nodes, {MOST_NODES} are possible")
            }
        }
    }
}

impl core::error::Error for Unpackable {}

/// Nodes that 24 bits name.
const MOST_NODES: usize = 1 << 24;
/// Rows with the triangles of a leaf.
const ID_ROWS: usize = WIDTH / 4;

impl LightBvh {
    /// Packs the trees for kernels. `casters` must be those it was built over.
    ///
    /// # Errors
    /// [`Unpackable`], by triangles piled up as no scene has them, or more than about a hundred million.
    pub fn pack(&self, casters: Casters<'_>) -> Result<PackedLightBvh, Unpackable> {
        let sizes = self.trees().iter().map(|tree| tree.nodes.len() + tree.blocks.len());
        let nodes: usize = sizes.sum();
        if nodes > MOST_NODES {
            return Err(Unpackable::TooLarge { nodes });
        }
        let blocks: usize = self.trees().iter().map(|tree| tree.blocks.len()).sum();
        let first_id = nodes * NODE_ROWS as usize;
        let mut rows = alloc::vec![UVec4::ZERO; (first_id + blocks * ID_ROWS).max(1)];
        let mut space = self.trees().first().map_or(LightSpace::empty(), |tree| tree.view.space());
        let (mut next_node, mut next_id) = (0, first_id);
        for tree in self.trees().iter().filter(|tree| !tree.nodes.is_empty()) {
            match tree.view.face() {
                face @ 0..4 => space.roots[face] = next_node as u32,
                face => space.roots_z[face - 4] = next_node as u32,
            }
            let hulls = Hulls::new(tree, casters);
            let mut packer = Packer { tree, hulls, rows: &mut rows, next_node, next_id };
            packer.pack()?;
            (next_node, next_id) = (packer.next_node, packer.next_id);
        }
        Ok(PackedLightBvh { space, rows })
    }
}

/// The hexagons of a tree's parts.
struct Hulls {
    triangles: Vec<Hexagon>,
    nodes: Vec<Hexagon>,
    blocks: Vec<Hexagon>,
}

impl Hulls {
    fn new(tree: &Tree, casters: Casters<'_>) -> Self {
        let triangles = hexagons(&tree.view, casters);
        let union = |all: Hexagon, h: &Hexagon| all.union(h);
        let of_block =
            |block: &Block| block.triangles().map(|t| &triangles[t as usize]).fold(Hexagon::EMPTY, union);
        let blocks = tree.blocks.iter().map(of_block).collect();
        let nodes = alloc::vec![Hexagon::EMPTY; tree.nodes.len()];
        let mut hulls = Hulls { triangles, nodes, blocks };
        // Children come after their parents.
        for (at, node) in tree.nodes.iter().enumerate().rev() {
            hulls.nodes[at] =
                node.children().map(|link| hulls.below(link)).fold(Hexagon::EMPTY, |all, h| all.union(h));
        }
        hulls
    }

    fn below(&self, link: u32) -> &Hexagon {
        let at = (link & !LEAF) as usize;
        if link & LEAF == 0 { &self.nodes[at] } else { &self.blocks[at] }
    }
}

/// Packs one tree.
struct Packer<'a> {
    tree: &'a Tree,
    hulls: Hulls,
    rows: &'a mut [UVec4],
    /// Free places.
    next_node: usize,
    next_id: usize,
}

impl Packer<'_> {
    fn pack(&mut self) -> Result<(), Unpackable> {
        // What a link leads to, where it goes, and on which level that is.
        let mut pending = alloc::vec![(0u32, self.next_node, 1)];
        self.next_node += 1;
        while let Some((link, to, level)) = pending.pop() {
            if level > MAX_DEPTH {
                return Err(Unpackable::TooDeep { levels: level });
            }
            let mut children = [Hexagon::EMPTY; WIDTH];
            let first = if link & LEAF != 0 {
                let first = self.next_id;
                self.next_id += ID_ROWS;
                for (slot, triangle) in self.tree.block(link).triangles().enumerate() {
                    children[slot] = self.hulls.triangles[triangle as usize];
                    self.rows[first + slot / 4][slot % 4] = triangle;
                }
                first as u32 | LightNode::LEAF
            } else {
                let first = self.next_node;
                for (slot, link) in self.tree.nodes[link as usize].children().enumerate() {
                    children[slot] = *self.hulls.below(link);
                    pending.push((link, self.next_node, level + 1));
                    self.next_node += 1;
                }
                first as u32
            };
            let LightNode { low, x, y, diagonal, rest } = node(&children, first);
            let at = to * NODE_ROWS as usize;
            self.rows[at..at + NODE_ROWS as usize].copy_from_slice(&[low, x, y, diagonal, rest]);
        }
        Ok(())
    }
}

/// A node with these children, the empty ones last.
fn node(children: &[Hexagon; WIDTH], first: u32) -> LightNode {
    let Hexagon { rect, low, high } = children.iter().fold(Hexagon::EMPTY, |all, h| all.union(h));
    // What has no end of nearness lies on the last line, whatever that is.
    let ends = children.iter().map(|h| h.rect.z).filter(|z| z.is_finite());
    let (least, most) =
        ends.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    let grids = [
        Grid::over(rect.x0, rect.x1),
        Grid::over(rect.y0, rect.y1),
        Grid::over(low, high),
        if least <= most { Grid::over(least, most) } else { Grid::over(0.0, 0.0) },
    ];
    let [x, y, diagonal, z] = grids;
    let mut rows = [UVec4::new(u32::MAX, u32::MAX, 0, 0); 3];
    let mut rest = UVec4::new(0, 0, 0, first);
    for (slot, child) in children.iter().enumerate().filter(|(_, h)| !h.is_empty()) {
        let (half, shift) = (slot / 4, 8 * (slot % 4));
        let Hexagon { rect, low, high } = *child;
        let sides = [(x, rect.x0, rect.x1), (y, rect.y0, rect.y1), (diagonal, low, high)];
        for (row, (grid, low, high)) in rows.iter_mut().zip(sides) {
            row[half] &= !(0xff << shift);
            row[half] |= grid.line_below(low) << shift;
            row[2 + half] |= grid.line_above(high) << shift;
        }
        let end = if rect.z.is_finite() { z.line_above(rect.z) } else { 255 };
        rest[half] |= end << shift;
    }
    rest.z = x.exponent | y.exponent << 8 | diagonal.exponent << 16 | z.exponent << 24;
    let low = UVec4::from_array(grids.map(|grid| grid.low.to_bits()));
    LightNode { low, x: rows[0], y: rows[1], diagonal: rows[2], rest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planes::EPSILON;
    use crate::planes::support::{PLACES, Random, Soup, lights, origins};
    use crate::view::View;
    use lt_bvh::{BuildQuality, Bvh, LightPoint, NONE, Ray};

    /// All triangles in boxes that hold a point.
    fn reached(packed: &PackedLightBvh, root: u32, point: &LightPoint) -> Vec<u32> {
        let (mut pending, mut found) = (alloc::vec![root], Vec::new());
        while let Some(at) = pending.pop().filter(|at| *at != NONE) {
            let node = LightNode::load(&packed.rows, at);
            let holders = node.holders(point, packed.space.diagonal(point));
            for slot in (0..8).filter(|slot| holders >> slot & 1 == 1) {
                if node.is_leaf() {
                    found.push(node.triangle(&packed.rows, slot));
                } else {
                    pending.push(node.first() + slot);
                }
            }
        }
        found
    }

    /// Points moved as far as a GPU's rounding may move them, times `factor`: beside what the CPU's own does, for the point and for the
    /// test.
    fn moved(view: &View, p: LightPoint, factor: f32) -> [LightPoint; 8] {
        let (place, nearness) = if view.sees_all() {
            (12.0 * EPSILON * view.size, 4.0 * EPSILON * view.size)
        } else {
            (4.0 * EPSILON + 5.0 * EPSILON * view.size * p.z, 4.0 * EPSILON * p.z)
        };
        let (place, nearness) = (place * factor, nearness * factor);
        let sign = |i: usize, bit: usize| if i >> bit & 1 == 0 { 1.0 } else { -1.0 };
        core::array::from_fn(|i| LightPoint {
            x: p.x + sign(i, 0) * place,
            y: p.y + sign(i, 1) * place,
            z: p.z + sign(i, 2) * nearness,
        })
    }

    /// Hits lost, and all, by points that are moved.
    fn lost(factor: f32) -> (usize, usize) {
        let mut random = Random(11);
        let (mut lost, mut all) = (0, 0);
        for (scale, offset) in PLACES {
            for light in lights(&mut random, scale, offset).into_iter().step_by(3) {
                let soup = Soup::mixed(&mut random, 300, light.truncate()).moved(scale, offset);
                let bvh = Bvh::build(&soup.positions, &soup.triangles, |_| true, BuildQuality::Fast).unwrap();
                let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
                let tree = LightBvh::build(light, soup.bounds(), casters);
                let packed = tree.pack(casters).unwrap();
                packed.validate(&tree, casters).unwrap();
                for origin in origins(&mut random, &soup, light, 200) {
                    let ray = Ray::to_light(origin, light);
                    let view = tree.trees().iter().map(|t| t.view).find(|view| view.takes(&ray));
                    let (Some(view), Some(test)) = (view, casters.test(&ray)) else { continue };
                    let (point, root) = packed.space.point(&ray);
                    assert_eq!(point, view.point(&ray));
                    assert!(packed.space.takes(&ray));
                    let reached = moved(&view, point, factor).map(|p| reached(&packed, root, &p));
                    for (i, _) in casters.triangles.iter().enumerate().filter(|(_, t)| test.meet(t).is_some())
                    {
                        all += 1;
                        lost += usize::from(reached.iter().any(|found| !found.contains(&(i as u32))));
                    }
                }
            }
        }
        (lost, all)
    }

    #[test]
    fn no_rounding_of_a_gpu_loses_a_hit() {
        let (wrong, all) = lost(1.0);
        assert_eq!(wrong, 0, "of {all}");
        assert!(all > 5_000, "{all}");
        assert!(lost(1000.0).0 > 0, "points moved a thousand times as far lost nothing");
    }
}
