//! Surfaces: colour, coverage, translucency.

use std::sync::Arc;

use lt_math::glam::{Mat2, Vec2, Vec3, Vec4};

/// How a surface covers what lies behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AlphaMode {
    /// Covers everywhere; alpha is ignored.
    Opaque,
    /// Covers where alpha ≥ `cutoff`.
    Mask {
        /// Coverage threshold, at least 0; above 1 nothing covers.
        cutoff: f32,
    },
    /// Blends by alpha. Where a binary answer is needed it covers where alpha ≥ 0.5.
    Blend,
}

/// Texture addressing outside [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Wrap {
    /// Periodic.
    #[default]
    Repeat,
    /// Periodic, every other copy reversed.
    MirroredRepeat,
    /// The edge texel goes on.
    ClampToEdge,
}

/// `uv' = matrix · uv + offset` (KHR_texture_transform). Importers apply it to `Mesh::uvs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UvTransform {
    /// Rotation and scale.
    pub matrix: Mat2,
    /// Offset added after the matrix.
    pub offset: Vec2,
}

/// 8-bit RGBA image, row 0 at the top, shared between materials.
#[derive(Clone, Debug)]
pub struct Texture {
    /// For messages; may be empty.
    pub name: String,
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// `width · height` texels: sRGB colour, linear alpha.
    pub texels: Arc<[[u8; 4]]>,
}

/// A texture as a material uses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextureRef {
    /// Index into `Scene::textures`.
    pub texture: u32,
    /// Addressing along u and v.
    pub wrap: [Wrap; 2],
    /// Nearest texel instead of bilinear (the sampler's magnification filter).
    pub is_nearest: bool,
}

/// What a surface is made of.
#[derive(Clone, Debug)]
pub struct Material {
    /// For messages and reports; may be empty.
    pub name: String,
    /// Linear RGBA factor, multiplied with texture and vertex colour.
    pub base_color: Vec4,
    /// Base colour texture, its alpha the coverage.
    pub texture: Option<TextureRef>,
    /// Coverage.
    pub alpha: AlphaMode,
    /// Whether both faces are shaded alike: kept for callers, not shaded, since every face is drawn from both sides. Shadows always see
    /// both faces.
    pub is_double_sided: bool,
    /// Fraction of light let through a covered point (KHR_materials_transmission), 0 to 1, tinted by the base colour. Binary
    /// coverage ignores it.
    pub transmission: f32,
    /// Linear RGB emission: kept for callers, not shaded.
    pub emissive: Vec3,
}

impl Material {
    /// An opaque, untextured surface of this linear colour.
    pub fn opaque(name: &str, color: Vec3) -> Self {
        Self {
            name: name.to_owned(),
            base_color: color.extend(1.0),
            texture: None,
            alpha: AlphaMode::Opaque,
            is_double_sided: false,
            transmission: 0.0,
            emissive: Vec3::ZERO,
        }
    }

    /// The alpha below which a point lets light through, or `None` when every point covers.
    pub fn cutoff(&self) -> Option<f32> {
        match self.alpha {
            AlphaMode::Opaque => None,
            AlphaMode::Mask { cutoff } => Some(cutoff),
            AlphaMode::Blend => Some(0.5),
        }
    }

    /// Whether light passes partly: blended or transmissive.
    pub fn is_translucent(&self) -> bool {
        self.alpha == AlphaMode::Blend || self.transmission > 0.0
    }
}
