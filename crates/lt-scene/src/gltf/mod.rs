//! glTF 2.0 import.
use crate::{Scene, SceneError};
/// A loaded glTF file.
#[derive(Clone, Debug)]
pub struct GltfAsset {}
impl GltfAsset {
    /// Opens a .gltf or .glb file.
    ///
    /// # Errors
    /// Unreadable or malformed.
    pub fn open(_path: &std::path::Path) -> Result<Self, SceneError> { Ok(Self {}) }
    /// The scene at `time_s` seconds.
    ///
    /// # Errors
    /// Malformed data.
    pub fn pose(&self, _time_s: f32) -> Result<Scene, SceneError> { Ok(Scene::default()) }
}
