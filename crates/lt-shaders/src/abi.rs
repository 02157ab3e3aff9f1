//! Every type that crosses between host and kernels: `repr(C)`, explicit padding, sizes asserted.
//!
//! A `Vec3` sits at a multiple of 16 bytes and is paired with a 4-byte scalar, so that the layout is the same in
//! Rust, SPIR-V and WGSL.

use bytemuck::{Pod, Zeroable};
use lt_math::LightProjection;
use lt_math::glam::{UVec2, Vec3, Vec4};

/// What the camera sees through one sample of a pixel.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Sample {
    /// World position of the visible point.
    pub position: Vec3,
    /// Largest absolute world coordinate of the visible triangle's vertices: the scale of rounding errors there.
    pub magnitude: f32,
    /// Unit geometric normal, facing the camera; zero where nothing is visible.
    pub normal: Vec3,
    /// Surface flags: see [`Sample::RECEIVES`]. The upper half is [`Sample::scattered`].
    pub flags: u32,
    /// Unit shading normal, on the same side as `normal`.
    pub shading_normal: Vec3,
    /// Base colour, linear RGB in three bytes from the lowest, square-rooted for precision.
    pub albedo: u32,
}

impl Sample {
    /// Flag: shadows fall on this surface.
    pub const RECEIVES: u32 = 1;

    /// Bit of `flags` where the share of light that a layer scatters begins, as a 16-bit fraction.
    const SCATTERED_SHIFT: u32 = 16;

    /// Whether anything is visible in this pixel.
    pub fn is_valid(&self) -> bool {
        self.normal != Vec3::ZERO
    }

    /// The same surface as a layer that scatters this share of the light, in [0, 1]; it lets the rest pass or swallows it.
    #[inline]
    pub fn scattering(self, share: f32) -> Self {
        let fraction = (share * 65535.0 + 0.5) as u32;
        Self { flags: self.flags & 0xffff | fraction << Self::SCATTERED_SHIFT, ..self }
    }

    /// The share of the light that a layer scatters, in [0, 1] within 1e-5: see [`Sample::scattering`]. Of no meaning where the
    /// camera sees no layers.
    #[inline]
    pub fn scattered(&self) -> f32 {
        (self.flags >> Self::SCATTERED_SHIFT) as f32 / 65535.0
    }
}

/// How far a primary ray has come through layers. All zero before the first.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Sight {
    /// Share of the light from farther on that the layers before keep from the eye, linear RGB; 1 where nothing more is seen.
    pub kept: Vec3,
    /// Where the next layer's ray starts, in lengths of its direction: surfaces at or before it do not count.
    pub t: f32,
}

impl Sight {
    /// Share of the light from farther on that reaches the eye, linear RGB.
    #[inline]
    pub fn passes(&self) -> Vec3 {
        Vec3::ONE - self.kept
    }

    /// Whether any does.
    #[inline]
    pub fn is_open(&self) -> bool {
        self.kept.x < 1.0 || self.kept.y < 1.0 || self.kept.z < 1.0
    }
}

/// A pinhole camera as the camera pass wants it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct CameraParams {
    /// Centre of projection, world.
    pub eye: Vec3,
    /// First node of the tree to walk: the TLAS, or the one world-space tree.
    pub root: u32,
    /// Half the picture's width at distance 1, along the camera's right.
    pub right: Vec3,
    /// Layers that may follow the one that a layer pass looks for; 0 for the last. Read by that pass alone.
    pub layers_behind: u32,
    /// Half the picture's height at distance 1, along the camera's up.
    pub up: Vec3,
    /// Explicit padding.
    pub pad1: u32,
    /// Unit view direction.
    pub forward: Vec3,
    /// Explicit padding.
    pub pad2: u32,
    /// Picture size in samples: columns and rows of the grid that passes run on.
    pub size: UVec2,
    /// A pixel's columns and rows of samples, powers of two ([`crate::sampling`]); 1 × 1 for one sample a pixel.
    pub grid: UVec2,
}

/// A light as kernels see it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct LightParams {
    /// Homogeneous place: `xyz` with `w = 0` is the unit direction *to* a directional light, with `w = 1` the position
    /// of a point or spot light. The vector from p to the light is `xyz − w·p` either way.
    pub place: Vec4,
    /// Unit axis of a spot light's cone, the way its light travels; zero for other lights.
    pub axis: Vec3,
    /// Cosine of the half-angle past which a spot light does not shine; −1 for other lights.
    pub cos_outer: f32,
    /// Distance past which a point or spot light does not shine, squared; huge if unlimited.
    pub range_squared: f32,
    /// Cosine of the half-angle up to which a spot light shines fully; −1 for other lights. For shading.
    pub cos_inner: f32,
    /// Which of the frame's lights it is: its bits in a pixel's mask (`lt_mask::PackedMask`).
    pub number: u32,
    /// 32-bit words of a pixel's mask, for all of the frame's lights: `lt_mask::words_for_lights`.
    pub mask_words: u32,
}

impl LightParams {
    /// A directional light, the frame's only one.
    ///
    /// `to_light` is the unit direction to it.
    pub const fn directional(to_light: Vec3) -> Self {
        Self {
            place: Vec4::new(to_light.x, to_light.y, to_light.z, 0.0),
            axis: Vec3::ZERO,
            cos_outer: -1.0,
            range_squared: 3.0e38,
            cos_inner: -1.0,
            number: 0,
            mask_words: 1,
        }
    }
}

/// The light, the map and the test, as the evaluate and resolve passes want them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ShadowParams {
    /// World to light map; variants with levels read a list of projections instead.
    pub projection: LightProjection,
    /// The light.
    pub light: LightParams,
    /// Parameters of the shadow test, in the order its kernel documents.
    pub test: Vec4,
    /// Picture size in samples.
    pub size: UVec2,
    /// Map size in texels (square).
    pub map_size: u32,
    /// LTT's ε.
    pub epsilon: f32,
    /// First node of the tree to walk: the TLAS, or the one world-space tree.
    pub root: u32,
    /// Levels of the light's map (cascades); read by variants with levels only.
    pub level_count: u32,
    /// Explicit padding: scalars, because uniform arrays would need a stride of 16.
    pub pad0: u32,
    /// Explicit padding.
    pub pad1: u32,
}

/// Vertex attributes, indexed by `lt_bvh::Triangle::i0…i2`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// Texture coordinate, u to the right.
    pub u: f32,
    /// Texture coordinate, v down.
    pub v: f32,
    /// Octahedral unit normal in the tree's space, two 16-bit signed fractions; [`Vertex::NO_NORMAL`] if absent.
    pub normal: u32,
    /// Linear RGBA vertex colour, 8 bits each, red lowest.
    pub color: u32,
    /// Index of the material.
    pub material: u32,
}

impl Vertex {
    /// No shading normal here: use the geometric one.
    pub const NO_NORMAL: u32 = 0x8000_8000;
}

/// A surface as kernels see it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Material {
    /// Linear RGBA factor.
    pub base_color: Vec4,
    /// Coverage threshold: a point lets light through where alpha is below; 0 covers everywhere.
    pub cutoff: f32,
    /// [`Material::CASTS`] and the other flags.
    pub flags: u32,
    /// Coverage texture: first byte in the alpha texels (in texels, 4 to a word).
    pub alpha_offset: u32,
    /// Coverage texture: width in the low, height in the high 16 bits; 0 if none.
    pub alpha_size: u32,
    /// Colour texture: first word in the colour texels.
    pub color_offset: u32,
    /// Colour texture: width in the low, height in the high 16 bits; 0 if none.
    pub color_size: u32,
    /// Share of the light that a covered point lets through, tinted by its colour, in [0, 1].
    pub transmission: f32,
    /// Explicit padding.
    pub pad: u32,
}

impl Material {
    /// Flag: blocks light.
    pub const CASTS: u32 = 1;
    /// Flag: shadows fall on it.
    pub const RECEIVES: u32 = 2;
    /// Flag: nearest texel instead of bilinear.
    pub const NEAREST: u32 = 4;
    /// Flag: alpha blends; translucent shadows take it as the covered share of a point, not by the cut-off.
    pub const BLENDS: u32 = 8;
    /// Bit where the wrap mode along u starts (two bits: [`Material::REPEAT`] …).
    pub const WRAP_U_SHIFT: u32 = 4;
    /// Bit where the wrap mode along v starts.
    pub const WRAP_V_SHIFT: u32 = 6;
    /// Wrap mode: periodic.
    pub const REPEAT: u32 = 0;
    /// Wrap mode: periodic, every other copy reversed.
    pub const MIRROR: u32 = 1;
    /// Wrap mode: the edge texel goes on.
    pub const CLAMP: u32 = 2;
}

/// One frame of the temporal mask.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct MaskParams {
    /// This frame's camera.
    pub current: CameraParams,
    /// The camera of the frame that the history is of.
    pub previous: CameraParams,
    /// The light.
    pub light: LightParams,
    /// Neighbours of pixels that stand still, in this frame (`lt_mask::Offsets`).
    pub still: UVec2,
    /// Neighbours of pixels that move, in this frame.
    pub moving: UVec2,
    /// Counts frames; steers the rolling refresh.
    pub frame: u32,
    /// [`MaskParams::HAS_HISTORY`] and the other flags.
    pub flags: u32,
    /// Relative tolerance of the temporal depth test.
    pub depth_tolerance: f32,
    /// Period of the rolling refresh, frames (`lt_mask::is_due`); 0 for none.
    pub refresh: u32,
    /// Number of the rule by which neighbours expand rays (`lt_mask::Expansion`).
    pub expansion: u32,
    /// Explicit padding.
    pub pad0: u32,
    /// Explicit padding.
    pub pad1: u32,
    /// Explicit padding.
    pub pad2: u32,
}

impl MaskParams {
    /// Flag: there is a last frame to learn from; without it every pixel is one that was not found.
    pub const HAS_HISTORY: u32 = 1;
    /// Flag: rays are removed as published (eq. 8), where pixels move too.
    pub const REMOVES_AS_PUBLISHED: u32 = 2;
    /// Flag: camera, light and casters are those of the last frame, so that its rays' answers hold for all that has not moved.
    pub const KEEPS_ANSWERS: u32 = 4;
    /// Flag: the history is a cleared one, for the host to clear: nothing was traced, everything lit.
    pub const CLEARED: u32 = 8;
    /// Flag: both cameras are the same to the bit, so that a surface whose place is the same has not moved on the screen. Arithmetic alone does
    /// not tell: a compiler may round the two projections differently (seen on hardware).
    pub const CAMERA_RESTS: u32 = 16;
}

/// Sun, sky and tone for the shading pass.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ShadeParams {
    /// Camera, for the sky behind.
    pub camera: CameraParams,
    /// The light.
    pub light: LightParams,
    /// Linear RGB of the light (at distance 1 from a point or spot light); `w` is the haze at distance 1.
    pub light_color: Vec4,
}

/// What a level of the depth map pass is drawn by: its projection.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DepthParams {
    /// World to light map.
    pub projection: LightProjection,
    /// Map size in texels (square).
    pub map_size: u32,
    /// Least distance along the axis of a spot or point light that is drawn; 0 for directional lights.
    pub near: f32,
    /// Explicit padding: a scalar, because uniform arrays would need a stride of 16.
    pub pad0: u32,
    /// Explicit padding.
    pub pad1: u32,
}

/// One separable blur pass over a map of depth vectors.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct FilterParams {
    /// Parameters of the shadow test, as in [`ShadowParams::test`].
    pub test: Vec4,
    /// Map size in texels (square).
    pub map_size: u32,
    /// Standard deviation of the Gaussian, texels.
    pub sigma: f32,
    /// Explicit padding.
    pub pad: UVec2,
}

const _: () = {
    assert!(size_of::<Sample>() == 48);
    assert!(size_of::<Sight>() == 16);
    assert!(size_of::<CameraParams>() == 80);
    assert!(size_of::<LightParams>() == 48);
    assert!(size_of::<ShadowParams>() == 160);
    assert!(size_of::<Vertex>() == 20);
    assert!(size_of::<Material>() == 48);
    assert!(size_of::<MaskParams>() == 256);
    assert!(size_of::<ShadeParams>() == 144);
    assert!(size_of::<DepthParams>() == 80);
    assert!(size_of::<FilterParams>() == 32);
};
