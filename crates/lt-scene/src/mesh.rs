//! Triangle meshes and where they stand.

use lt_math::glam::{Affine3A, Vec2, Vec3};

/// Indexed triangles with one material, in object space.
///
/// `positions`, `normals`, `uvs` and `colors` are per vertex. The last three are either empty (absent) or exactly as
/// long as `positions`. Every index is below `positions.len()`, `indices.len()` is a multiple of three, and every
/// position is finite: importers and generators guarantee it.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// For messages and reports; may be empty.
    pub name: String,
    /// Vertex positions, object space.
    pub positions: Vec<Vec3>,
    /// Unit shading normals, or empty: shading then uses the face normal.
    pub normals: Vec<Vec3>,
    /// Texture coordinates of the base colour texture, its `UvTransform` already applied, or empty.
    pub uvs: Vec<Vec2>,
    /// Linear RGBA vertex colours, 0 to 255 for 0 to 1, or empty for white.
    pub colors: Vec<[u8; 4]>,
    /// Three vertex indices per triangle.
    pub indices: Vec<u32>,
    /// Index into `Scene::materials`.
    pub material: u32,
}

impl Mesh {
    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / 3
    }
}

/// A mesh placed in the world.
#[derive(Clone, Copy, Debug)]
pub struct Instance {
    /// Index into `Scene::meshes`.
    pub mesh: u32,
    /// Object to world; finite and invertible (importers drop and count what is not).
    pub transform: Affine3A,
    /// Whether it blocks light.
    pub casts_shadow: bool,
    /// Whether shadows fall on it.
    pub receives_shadow: bool,
    /// Whether its transform or mesh may differ between two poses of one source.
    pub is_dynamic: bool,
}

impl Instance {
    /// A static instance that casts and receives.
    pub fn new(mesh: u32, transform: Affine3A) -> Self {
        Self { mesh, transform, casts_shadow: true, receives_shadow: true, is_dynamic: false }
    }
}
