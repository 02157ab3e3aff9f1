//! Where scenes come from, and posing them in time.

use std::path::Path;

use crate::{Camera, CameraPath, Scene, SceneError, builtin::Builtin, gltf::GltfAsset};

/// Something that can be posed at any time: a procedural place or a glTF file.
#[derive(Clone, Debug)]
pub enum Source {
    /// A procedural place.
    Builtin(Builtin),
    /// An imported file.
    Gltf(Box<GltfAsset>),
}

impl Source {
    /// Opens what a user typed: a built-in such as `street` or `random:1000`, else a path ending in .gltf or .glb.
    ///
    /// # Errors
    /// Names neither a built-in scene nor a readable glTF file; the error lists what would have been understood.
    pub fn open(text: &str, seed: u64) -> Result<Self, SceneError> {
        let is_path = Path::new(text)
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("gltf") || e.eq_ignore_ascii_case("glb"));
        if is_path {
            return Ok(Self::Gltf(Box::new(GltfAsset::open(Path::new(text))?)));
        }
        Ok(Self::Builtin(Builtin::parse(text)?.with_seed(seed)))
    }

    /// The scene at `time_s` seconds.
    ///
    /// # Errors
    /// A glTF file whose data is malformed.
    pub fn pose(&self, time_s: f32) -> Result<Scene, SceneError> {
        match self {
            Self::Builtin(b) => Ok(b.pose(time_s)),
            Self::Gltf(g) => g.pose(time_s),
        }
    }

    /// The way a camera takes through it from `start`: a procedural place's own, else an orbit around the target.
    pub fn camera_path(&self, start: Camera) -> CameraPath {
        match self {
            Self::Builtin(b) => b.camera_path(start),
            Self::Gltf(_) => CameraPath::around_target(start),
        }
    }
}

impl From<Builtin> for Source {
    fn from(builtin: Builtin) -> Self {
        Self::Builtin(builtin)
    }
}
