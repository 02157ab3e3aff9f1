//! Whether a tree is what it should be.

use crate::block::{ASKS, NOBODY};
use crate::casters::Casters;
use crate::hexagon::{Hexagon, hexagons};
use crate::light_bvh::LightBvh;
use crate::packed::PackedLightBvh;
use crate::rect::Rect;
use crate::tree::{LEAF, Tree, items};
use alloc::vec::Vec;
use core::fmt;
use lt_bvh::{LightNode, NONE};

/// What is wrong with a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Invalid {
    /// A node's rectangle does not hold all that lies below it.
    Rectangle {
        /// The node.
        node: u32,
    },
    /// A triangle is not found, or more often than once, or not as it should be.
    Triangle {
        /// The triangle.
        triangle: u32,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Invalid::Rectangle { node } => write!(f, "a rectangle of node {node} is too small"),
            Invalid::Triangle { triangle } => {
                write!(f, "triangle {triangle} is missing, doubled or out of place")
            }
        }
    }
}

impl core::error::Error for Invalid {}

impl Tree {
    /// Checks that every triangle that the view can see is in the tree once, and that all rectangles hold what lies below them.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate(&self, casters: Casters<'_>) -> Result<(), Invalid> {
        let mut rects: Vec<Option<Rect>> = alloc::vec![None; casters.triangles.len()];
        for item in items(&self.view, casters) {
            rects[item.triangle as usize] = Some(item.rect);
        }
        if !self.nodes.is_empty() {
            self.check(0, casters, &mut rects)?;
        }
        let missing = rects.iter().position(Option::is_some);
        missing.map_or(Ok(()), |triangle| Err(Invalid::Triangle { triangle: triangle as u32 }))
    }

    /// Checks a subtree, takes its triangles out of `rects`, and returns its rectangle.
    fn check(&self, node: u32, casters: Casters<'_>, rects: &mut [Option<Rect>]) -> Result<Rect, Invalid> {
        let mut all = Rect::EMPTY;
        for (slot, &link) in self.nodes[node as usize].links.iter().enumerate() {
            let rect = self.nodes[node as usize].rect(slot);
            if rect.x0 > rect.x1 {
                continue;
            }
            let mut below = Rect::EMPTY;
            if link & LEAF == 0 {
                below = self.check(link, casters, rects)?;
            } else {
                for id in self.block(link).ids.into_iter().filter(|id| *id != NOBODY) {
                    let triangle = id & !ASKS;
                    let asks = casters.triangles.get(triangle as usize).is_some_and(|t| !t.is_opaque());
                    let found = rects.get_mut(triangle as usize).and_then(Option::take);
                    let Some(rect) = found.filter(|_| asks == (id & ASKS != 0)) else {
                        return Err(Invalid::Triangle { triangle });
                    };
                    below = below.union(&rect);
                }
            }
            if !rect.holds(&below) {
                return Err(Invalid::Rectangle { node });
            }
            all = all.union(&rect);
        }
        Ok(all)
    }
}

impl PackedLightBvh {
    /// Checks that every triangle that a view can see is in its packed tree once, and that all boxes hold what lies below them. `of` is
    /// what was packed.
    ///
    /// # Errors
    /// The first fault found; nodes are counted over all trees.
    pub fn validate(&self, of: &LightBvh, casters: Casters<'_>) -> Result<(), Invalid> {
        for tree in of.trees() {
            let mut hexagons = hexagons(&tree.view, casters);
            let root = match tree.view.face() {
                face @ 0..4 => self.space.roots[face],
                face => self.space.roots_z[face - 4],
            };
            if root != NONE {
                self.check(root, &mut hexagons)?;
            }
            if let Some(triangle) = hexagons.iter().position(|hexagon| !hexagon.is_empty()) {
                return Err(Invalid::Triangle { triangle: triangle as u32 });
            }
        }
        Ok(())
    }

    /// Checks a subtree, empties the hexagons of its triangles, and returns its own.
    fn check(&self, at: u32, hexagons: &mut [Hexagon]) -> Result<Hexagon, Invalid> {
        let node = LightNode::load(&self.rows, at);
        let mut all = Hexagon::EMPTY;
        for (slot, end) in node.ends().into_iter().enumerate().filter(|(_, end)| end[0] <= end[1]) {
            let below = if node.is_leaf() {
                let triangle = node.triangle(&self.rows, slot as u32);
                let found = hexagons.get_mut(triangle as usize);
                let hexagon = found.map(|h| core::mem::replace(h, Hexagon::EMPTY));
                hexagon.filter(|h| !h.is_empty()).ok_or(Invalid::Triangle { triangle })?
            } else {
                self.check(node.first() + slot as u32, hexagons)?
            };
            let Hexagon { rect: r, low, high } = below;
            let sides = [(r.x0, r.x1), (r.y0, r.y1), (low, high)];
            let holds = |(i, (low, high)): (usize, (f32, f32))| {
                end[2 * i] <= f64::from(low) && f64::from(high) <= end[2 * i + 1]
            };
            if !sides.into_iter().enumerate().all(holds) || f64::from(r.z) > end[6] {
                return Err(Invalid::Rectangle { node: at });
            }
            all = all.union(&below);
        }
        Ok(all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Bounds, View};
    use lt_bvh::{BuildQuality, Bvh};
    use lt_math::glam::{Vec3, Vec4};

    fn small() -> (Bvh, Bounds) {
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        for i in 0..40u32 {
            let at = Vec3::new(i as f32, (i * 7 % 11) as f32, (i * 3 % 5) as f32);
            positions.extend([at, at + Vec3::X, at + Vec3::Y]);
            triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
        }
        let bounds = positions.iter().fold(Bounds::EMPTY, |b, p| b.with(*p));
        (Bvh::build(&positions, &triangles, |_| true, BuildQuality::Fast).unwrap(), bounds)
    }

    #[test]
    fn faults_are_found() {
        let (bvh, bounds) = small();
        let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
        let view = View::of_light(Vec4::new(0.1, 0.2, 1.0, 0.0), bounds, casters.root).next().unwrap();
        let bvh = LightBvh::build(Vec4::new(0.1, 0.2, 1.0, 0.0), bounds, casters);
        let packed = bvh.pack(casters).unwrap();
        assert_eq!(packed.validate(&bvh, casters), Ok(()));
        let mut bad = packed.clone();
        bad.rows[1].z -= 1;
        assert!(matches!(bad.validate(&bvh, casters), Err(Invalid::Rectangle { .. })));
        let mut bad = packed.clone();
        let last = bad.rows.len() - 1;
        bad.rows[last].x = 40;
        assert!(matches!(bad.validate(&bvh, casters), Err(Invalid::Triangle { .. })));
        let tree = Tree::build(view, casters);
        assert_eq!(tree.validate(casters), Ok(()));
        let mut bad = tree.clone();
        bad.nodes[0].x1[0] -= 0.01;
        assert!(matches!(bad.validate(casters), Err(Invalid::Rectangle { .. })));
        let mut bad = tree.clone();
        bad.nodes[0].z[1] -= 100.0;
        assert!(matches!(bad.validate(casters), Err(Invalid::Rectangle { .. })));
        let mut bad = tree.clone();
        bad.blocks[0].ids[0] = bad.blocks[0].ids[1];
        assert!(matches!(bad.validate(casters), Err(Invalid::Triangle { .. })));
        let mut bad = tree.clone();
        bad.blocks[0].ids[0] = NOBODY;
        assert!(matches!(bad.validate(casters), Err(Invalid::Triangle { .. })));
        let mut bad = tree;
        bad.blocks[0].ids[0] |= ASKS;
        assert!(matches!(bad.validate(casters), Err(Invalid::Triangle { .. })));
    }
}
