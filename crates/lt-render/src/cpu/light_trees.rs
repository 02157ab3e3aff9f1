//! The trees in the spaces of the lights: one of each light's, kept while it stands still.

use lt_irregular::LightBvh;
use lt_math::glam::Vec4;
use lt_shaders::abi::LightParams;

use crate::{PackedScene, light_space};

/// By the light's number, its homogeneous place and the tree that was planted for it. The scene must stay the same: an empty one has no trees.
#[derive(Default)]
pub struct LightTrees(Vec<Option<(Vec4, LightBvh)>>);

impl LightTrees {
    /// Plants the light's tree unless it has one for where it is, or `is_kept` does not hold; whether it did.
    pub fn plant(&mut self, scene: &PackedScene, light: &LightParams, is_kept: bool) -> bool {
        if is_kept && self.of(light).is_some() {
            return false;
        }
        let number = light.number as usize;
        if self.0.len() <= number {
            self.0.resize_with(number + 1, || None);
        }
        self.0[number] = Some((light.place, light_space::tree(scene, light.place)));
        true
    }

    /// The tree of this light where it is now.
    pub fn of(&self, light: &LightParams) -> Option<&LightBvh> {
        let (place, tree) = self.0.get(light.number as usize)?.as_ref()?;
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
            assert!(trees.plant(&scene, light, true), "the first frame");
        }
        for light in &lights {
            assert!(!trees.plant(&scene, light, true), "the second frame: light {}", light.number);
        }
        let moved = light(1, Vec4::new(1.0, 1.5, 1.0, 1.0));
        assert!(trees.of(&moved).is_none());
        assert!(trees.plant(&scene, &moved, true) && trees.of(&lights[1]).is_none());
        assert!(!trees.plant(&scene, &lights[0], true), "another light has moved");
        assert!(trees.plant(&scene, &lights[0], false), "what is made anew in every frame");
    }
}
