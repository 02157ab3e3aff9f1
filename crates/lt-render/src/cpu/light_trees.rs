//! The trees in the spaces of the lights: one of each light's, kept while it stands still.

use std::time::Instant;

use lt_irregular::LightBvh;
use lt_math::glam::Vec4;
use lt_shaders::abi::LightParams;

use super::milliseconds;
use crate::PackedScene;
use crate::light_space::{self, Planted};

/// By the light's number. The scene must stay the same: an empty one has no trees.
#[derive(Default)]
pub struct LightTrees(Vec<Option<LightTree>>);

struct LightTree {
    /// The light's, homogeneous.
    place: Vec4,
    tree: LightBvh,
    planted: Planted,
}

impl LightTrees {
    /// Plants the light's tree unless it has one for where it is, or `is_kept` does not hold. Milliseconds that the technique of `slot` is
    /// charged for it in this frame.
    pub fn plant(&mut self, scene: &PackedScene, light: &LightParams, is_kept: bool, slot: usize) -> f64 {
        let number = light.number as usize;
        if !is_kept || self.of(light).is_none() {
            if self.0.len() <= number {
                self.0.resize_with(number + 1, || None);
            }
            let start = Instant::now();
            let (place, tree) = (light.place, light_space::tree(scene, light.place));
            let planted = Planted::in_ms(milliseconds(start));
            self.0[number] = Some(LightTree { place, tree, planted });
        }
        self.0[number].as_mut().map_or(0.0, |tree| tree.planted.charge(slot))
    }

    /// The tree of this light where it is now.
    pub fn of(&self, light: &LightParams) -> Option<&LightBvh> {
        let LightTree { place, tree, .. } = self.0.get(light.number as usize)?.as_ref()?;
        (*place == light.place).then_some(tree)
    }
}

#[cfg(test)]
mod tests {
    use lt_scene::Source;

    use super::*;

    #[test]
    fn each_light_keeps_its_tree_until_it_moves() {
        let scene = PackedScene::new(&Source::open("cornell", 1).unwrap().pose(0.0).unwrap()).unwrap();
        let light = |number, place| LightParams { number, place, ..bytemuck::Zeroable::zeroed() };
        let lights = [
            light(0, Vec4::new(0.1, 1.0, 0.2, 0.0)),
            light(1, Vec4::ONE),
            light(2, Vec4::new(0.0, 1.0, 0.3, 0.0)),
        ];
        let mut trees = LightTrees::default();
        assert!(trees.of(&lights[2]).is_none());
        for light in &lights {
            assert!(trees.plant(&scene, light, true, 0) > 0.0, "the first frame");
        }
        for light in &lights {
            assert_eq!(trees.plant(&scene, light, true, 0), 0.0, "the second frame: light {}", light.number);
            assert!(trees.plant(&scene, light, true, 3) > 0.0, "another technique's first frame");
        }
        let moved = light(1, Vec4::new(1.0, 1.5, 1.0, 1.0));
        assert!(trees.of(&moved).is_none());
        assert!(trees.plant(&scene, &moved, true, 0) > 0.0 && trees.of(&lights[1]).is_none());
        assert_eq!(trees.plant(&scene, &lights[0], true, 0), 0.0, "another light has moved");
        assert!(trees.plant(&scene, &lights[0], false, 0) > 0.0, "what is made anew in every frame");
    }
}
