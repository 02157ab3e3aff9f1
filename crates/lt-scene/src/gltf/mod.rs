//! glTF 2.0 import: .gltf and .glb files, posed at any time of their first animation.
//!
//! Follows the Khronos glTF 2.0 specification (2.0.1) with KHR_lights_punctual, KHR_texture_transform,
//! KHR_materials_transmission, KHR_materials_emissive_strength, KHR_materials_pbrSpecularGlossiness and
//! KHR_mesh_quantization. The booleans `castShadow` and `receiveShadow` in a node's `extras` (three.js' names) say whether its own mesh
//! blocks light and whether shadows fall on it; both are true where they are missing, and children inherit neither. A file is read and checked once, by [`GltfAsset::open`]; nothing in it is trusted: every
//! index, range and number is checked, nothing recurses, and memory is bounded by the file's size or a fixed ceiling.
//! What can be mended is mended and counted in [`Repairs`](crate::Repairs), the rest is an error that names its place.

mod accessors;
mod animation;
mod budget;
mod buffers;
mod cameras;
mod container;
mod extras;
mod fault;
mod files;
mod images;
mod json;
mod lights;
mod materials;
mod morph;
mod nodes;
mod open;
mod pose;
mod primitives;
mod skin;
mod triangles;

use std::{
    fmt,
    path::{Path, PathBuf},
    sync::Arc,
};

use crate::{Scene, SceneError};

/// A loaded glTF file. Cloning is cheap.
#[derive(Clone)]
pub struct GltfAsset {
    path: PathBuf,
    asset: Arc<pose::Asset>,
}

impl GltfAsset {
    /// Opens a .gltf or .glb file; the content decides which of the two it is.
    ///
    /// Shown is the file's default scene, else its first one, else all nodes. Buffers and images may be embedded or
    /// lie inside the file's folder.
    ///
    /// # Errors
    /// [`SceneError::Io`] for a file that cannot be read, [`SceneError::UnsupportedExtension`] for an unknown
    /// extension that the file requires, and [`SceneError::Malformed`] for anything wrong inside.
    pub fn open(path: &Path) -> Result<Self, SceneError> {
        let asset = open::open(path).map_err(|fault| fault.in_file(path))?;
        Ok(Self { path: path.to_owned(), asset: Arc::new(asset) })
    }

    /// The scene at `time_s` seconds of the first animation, wrapped to its duration; any time will do for a file
    /// without one. Meshes come in the same order at all times.
    ///
    /// Meshes that are skinned, or morphed by animated or non-zero weights, get a copy per instance, with a skin in
    /// world space.
    ///
    /// # Errors
    /// [`SceneError::Malformed`] if posing takes a vertex beyond finite numbers, or unfolds to more vertices than a
    /// file of this size may.
    pub fn pose(&self, time_s: f32) -> Result<Scene, SceneError> {
        self.asset.pose(time_s).map_err(|fault| fault.in_file(&self.path))
    }

    /// Whether the first animation moves a light, or something that carries one.
    pub fn moves_lights(&self) -> bool {
        self.asset.moves_lights()
    }

    /// Length of the first animation, seconds; 0 if there is none.
    pub fn animation_duration_s(&self) -> f32 {
        self.asset.animation.as_ref().map_or(0.0, |a| a.duration_s)
    }
}

impl fmt::Debug for GltfAsset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("GltfAsset").field("path", &self.path).finish_non_exhaustive()
    }
}
