//! The options that ask for several frames: how many, and what changes between them.

use clap::{Args, value_parser};
use lt_render::Sequence;
use lt_scene::Source;

use crate::{
    scene_args::{Opened, SceneArgs},
    values,
};

/// Options shared by `compare`, which plays the frames, and `plan`, which says what they call for.
#[derive(Args, Clone, Debug)]
pub struct FrameArgs {
    /// Play this many frames along a camera path, node animations running at 60 per second; `lt plan` plans for them
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(2..=10_000), help_heading = "Frames")]
    pub frames: Option<u16>,
    /// Play the frames with nothing moving: errors are the last frame's, and every flip is counted
    #[arg(long, requires = "frames", help_heading = "Frames")]
    pub still: bool,
    /// Turn the lights by this many degrees per frame around the vertical through what the camera looks at first
    #[arg(long, value_name = "DEG", requires = "frames", conflicts_with = "still", allow_hyphen_values = true, value_parser = values::finite, help_heading = "Frames")]
    pub light_spin: Option<f32>,
}

impl FrameArgs {
    /// What changes between the frames of what was opened; no history starts cold.
    pub fn sequence(&self, scene: &SceneArgs, opened: &Opened) -> Sequence {
        let moves = self.frames.is_some() && !self.still;
        Sequence {
            is_played: self.frames.is_some(),
            camera_moves: moves,
            objects_move: moves && opened.scene.instances.iter().any(|i| i.is_dynamic),
            lights_move: self.animates_lights(scene, opened) || self.light_spin.is_some(),
            starts_cold: false,
        }
    }

    /// Whether the scene's own animation moves the lights.
    pub fn animates_lights(&self, scene: &SceneArgs, opened: &Opened) -> bool {
        let has_moving = matches!(&opened.source, Source::Gltf(asset) if asset.moves_lights());
        self.frames.is_some() && !self.still && scene.lights_are_the_scenes() && has_moving
    }
}
