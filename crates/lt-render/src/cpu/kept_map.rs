//! A depth map whose still casters are drawn once: those that move are drawn into a copy every frame (Kern et al. 2024, §3.4).
//!
//! The paper keeps two maps and takes the lesser depth of both at every texel of a footprint. Drawing what moves over
//! what stands still takes the same minimum before anyone asks, so that the map has the bits of one drawn whole.

use std::ops::Range;

use lt_shaders::abi::DepthParams;

use super::marks::{Stained, copy_marks};
use super::raster::{Ground, draw_depths};
use crate::PackedScene;

/// What stands still, and what a copy of it must forget before the next frame.
#[derive(Default)]
pub struct StillMap {
    depths: Vec<f32>,
    /// Rows of the copy in which something moving was drawn, to whole tiles.
    moving_rows: Range<usize>,
}

/// What is drawn of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Draw {
    /// All of it, to be drawn whole again next time.
    Once,
    /// All of it; what stands still is remembered if anything moves.
    Whole,
    /// What moves, over what stood still when the map was last drawn by the same projection.
    Moving,
}

impl StillMap {
    /// Draws into `map`, which holds what the last draw left there.
    pub fn draw(&mut self, kind: Draw, scene: &PackedScene, p: &DepthParams, map: &mut [f32]) {
        let moving = scene.moving_draws();
        if kind == Draw::Moving && self.depths.len() == map.len() {
            let size = p.map_size as usize;
            let changed = self.moving_rows.start * size..self.moving_rows.end * size;
            map[changed.clone()].copy_from_slice(&self.depths[changed]);
            self.moving_rows = draw_depths(scene, moving, p, Ground::Kept, map);
            // What moves was drawn over marks, which are of the place.
            let drawn = self.moving_rows.start * size..self.moving_rows.end * size;
            copy_marks(&self.depths[drawn.clone()], &mut map[drawn]);
            return;
        }
        if kind == Draw::Once || moving.is_empty() {
            draw_depths(scene, scene.draws(), p, Ground::Empty, map);
            *self = Self::default();
        } else {
            draw_depths(scene, scene.still_draws(), p, Ground::Empty, map);
            self.depths.resize(map.len(), 1.0);
            self.depths.copy_from_slice(map);
            self.moving_rows = draw_depths(scene, moving, p, Ground::Kept, map);
        }
    }

    /// Marks a texel of it, too.
    pub fn mark(&mut self, texel: usize, stained: Stained) {
        if let Some(depth) = self.depths.get_mut(texel) {
            stained.mark(depth);
        }
    }

    /// Bytes it holds.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.depths[..])
    }
}

#[cfg(test)]
mod tests {
    use super::super::marks;
    use super::*;
    use lt_math::glam::Vec3;
    use lt_math::{LightFrame, LightProjection};

    fn bits(map: &[f32]) -> Vec<u32> {
        map.iter().map(|d| d.to_bits()).collect()
    }

    #[test]
    fn what_moves_drawn_over_what_stands_still_is_the_map_drawn_whole() {
        for name in ["forest:12", "street:4"] {
            let source = lt_scene::Source::open(name, 1).expect("a scene");
            let pose = |i: usize| source.pose(i as f32 * 0.2).expect("a pose");
            let bounds = pose(0).bounds();
            let frame = LightFrame::from_direction(Vec3::new(0.4, -1.0, 0.3));
            let corners = bounds.corners().map(|c| frame.to_light(c));
            let (low, high) =
                corners.iter().fold((corners[0], corners[0]), |(l, h), c| (l.min(*c), h.max(*c)));
            let projection = LightProjection::orthographic(&frame, low - 1.0, high + 1.0);
            let p = DepthParams { projection, map_size: 512, near: 0.0, pad0: 0, pad1: 0 };
            let (mut still, mut kept) = (StillMap::default(), vec![0.0; 512 * 512]);
            let mut moved = 0;
            for i in 0..4 {
                let scene = PackedScene::new(&pose(i)).expect("packs");
                let before = bits(&kept);
                let kind = if i == 0 { Draw::Whole } else { Draw::Moving };
                still.draw(kind, &scene, &p, &mut kept);
                let mut whole = vec![0.0; kept.len()];
                draw_depths(&scene, scene.draws(), &p, Ground::Empty, &mut whole);
                let depths: Vec<f32> = kept.iter().map(|texel| marks::depth(*texel)).collect();
                assert!(bits(&depths) == bits(&whole), "{name} frame {i}");
                // Where nothing moves, all of it is drawn anew.
                let is_kept = i > 0 && !scene.moving_draws().is_empty();
                let marked = |i: usize| i.is_multiple_of(7);
                let lost =
                    (0..kept.len()).find(|&t| marks::wrong(kept[t].to_bits()) != [is_kept && marked(t); 2]);
                assert_eq!(lost, None, "{name} frame {i}: marks are of the place, whatever moves over it");
                if i == 0 {
                    for texel in (0..kept.len()).filter(|&t| marked(t)) {
                        for said in [false, true] {
                            let stained = Stained::against(texel, said);
                            stained.mark(&mut kept[texel]);
                            still.mark(texel, stained);
                        }
                    }
                }
                moved += usize::from(i > 0 && before != bits(&kept));
            }
            assert!(name != "forest:12" || moved == 3, "something moves in {name}");
        }
    }
}
