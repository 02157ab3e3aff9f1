//! The evaluate pass: what the map says about a pixel, and whether that is to be trusted.

use lt_math::glam::{IVec2, Vec2, Vec3, Vec4};
use lt_math::{
    Esm, Evsm, Footprint, LightProjection, MsmHamburger, MsmHausdorff, Pcf, ShadowTest, Sm, Vsm,
    bilinear_footprint, needs_ray,
};

use crate::abi::{Sample, ShadowParams};

/// Estimate and doubt of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// 1 lit, 0 blocked.
    pub visibility: f32,
    /// Whether only a ray can tell.
    pub is_doubted: bool,
}

impl Verdict {
    const BLOCKED: Self = Self { visibility: 0.0, is_doubted: false };
    const LIT: Self = Self { visibility: 1.0, is_doubted: false };
}

/// Unnormalised vector from a point to the light; see [`ShadowParams::light`].
#[inline]
pub fn to_light(position: Vec3, light: Vec4) -> Vec3 {
    light.truncate() - position * light.w
}

/// What needs neither map nor ray: nothing visible or facing away is blocked, and what receives no shadow is lit.
/// The last field says whether a pixel is settled so.
#[inline]
pub fn settle(sample: &Sample, light: Vec4) -> (Verdict, bool) {
    if !sample.is_valid() {
        return (Verdict::BLOCKED, true);
    }
    let faces = sample.normal.dot(to_light(sample.position, light)) > 0.0;
    if !faces {
        return (Verdict::BLOCKED, true);
    }
    (Verdict::LIT, sample.flags & Sample::RECEIVES == 0)
}

/// A shadow test made from a pass's four parameters.
pub trait TestFromParams: ShadowTest {
    /// Receiver-plane bias in texels: how far along the receiver's own plane the deciding texel's centre may lie. 0 for
    /// tests that compare with the mean, which on a plane *is* the receiver.
    const PLANE_BIAS_TEXELS: f32;
    /// The test with these parameters.
    fn from_params(params: Vec4) -> Self;
}

/// `params.x`: constant bias, light depth. The nearest texel's centre is at most half a texel away.
impl TestFromParams for Sm {
    const PLANE_BIAS_TEXELS: f32 = 0.5;
    fn from_params(params: Vec4) -> Self {
        Self { bias: params.x }
    }
}

/// `params.x`: constant bias, light depth. The farthest of the four texels' centres is a texel away.
impl TestFromParams for Pcf {
    const PLANE_BIAS_TEXELS: f32 = 1.0;
    fn from_params(params: Vec4) -> Self {
        Self { bias: params.x }
    }
}

/// `params.x`: least variance.
impl TestFromParams for Vsm {
    const PLANE_BIAS_TEXELS: f32 = 0.0;
    fn from_params(params: Vec4) -> Self {
        Self { min_variance: params.x }
    }
}

/// `params.x`: exponent.
impl TestFromParams for Esm {
    const PLANE_BIAS_TEXELS: f32 = 0.0;
    fn from_params(params: Vec4) -> Self {
        Self { exponent: params.x }
    }
}

/// `params.xyz`: positive exponent, negative exponent, least variance.
impl TestFromParams for Evsm {
    const PLANE_BIAS_TEXELS: f32 = 0.0;
    fn from_params(params: Vec4) -> Self {
        Self { positive_exponent: params.x, negative_exponent: params.y, min_variance: params.z }
    }
}

/// `params.x`: moment bias.
impl TestFromParams for MsmHamburger {
    const PLANE_BIAS_TEXELS: f32 = 0.0;
    fn from_params(params: Vec4) -> Self {
        Self { moment_bias: params.x }
    }
}

/// `params.x`: moment bias.
impl TestFromParams for MsmHausdorff {
    const PLANE_BIAS_TEXELS: f32 = 0.0;
    fn from_params(params: Vec4) -> Self {
        Self { moment_bias: params.x }
    }
}

/// What the evaluate pass reads of a map.
pub trait MapSource: Copy {
    /// v̂ at a footprint of a square map.
    fn visibility<T: TestFromParams>(&self, test: T, footprint: Footprint, map_size: u32, depth: f32) -> f32;
}

/// Plain depths, row by row: the four of the footprint become vectors here.
#[derive(Clone, Copy)]
pub struct GatheredDepths<'a> {
    /// `map_size²` depths.
    pub depths: &'a [f32],
}

impl MapSource for GatheredDepths<'_> {
    fn visibility<T: TestFromParams>(&self, test: T, footprint: Footprint, map_size: u32, depth: f32) -> f32 {
        let i = quad_indices(footprint.texel, map_size);
        let depths = Vec4::new(
            self.depths[i[0] as usize],
            self.depths[i[1] as usize],
            self.depths[i[2] as usize],
            self.depths[i[3] as usize],
        );
        test.visibility_of_gather(depths, footprint.weights, depth)
    }
}

/// Pre-filtered depth vectors, row by row.
#[derive(Clone, Copy)]
pub struct FilteredVectors<'a> {
    /// `map_size²` vectors.
    pub vectors: &'a [Vec4],
}

impl MapSource for FilteredVectors<'_> {
    fn visibility<T: TestFromParams>(&self, test: T, footprint: Footprint, map_size: u32, depth: f32) -> f32 {
        let i = quad_indices(footprint.texel, map_size);
        let w = footprint.weights;
        let blended = self.vectors[i[0] as usize] * w.x
            + self.vectors[i[1] as usize] * w.y
            + self.vectors[i[2] as usize] * w.z
            + self.vectors[i[3] as usize] * w.w;
        test.visibility(blended, depth)
    }
}

/// Indices of a footprint's texels (order of [`Footprint::weights`]), clamped to the map.
#[inline]
pub fn quad_indices(texel: IVec2, map_size: u32) -> [u32; 4] {
    let last = map_size as i32 - 1;
    let low = texel.clamp(IVec2::ZERO, IVec2::splat(last)).as_uvec2();
    let high = (texel + IVec2::ONE).clamp(IVec2::ZERO, IVec2::splat(last)).as_uvec2();
    let (row0, row1) = (low.y * map_size, high.y * map_size);
    [row0 + low.x, row0 + high.x, row1 + low.x, row1 + high.x]
}

/// Depth by which the plane with this normal falls off over one texel along x and along y, added and capped:
/// the receiver-plane bias of a directional map (Isidoro 2006).
#[inline]
pub fn plane_slope(projection: &LightProjection, normal: Vec3, map_size: u32) -> f32 {
    let per = |row: Vec4| row.truncate().dot(normal) / row.truncate().length_squared();
    let (x, y, z) = (per(projection.row_x), per(projection.row_y), per(projection.row_z));
    let slope = (x.abs() + y.abs()) / (z.abs() * map_size as f32);
    // Written so that NaN and infinity (grazing light) give the cap.
    if slope < MAX_SLOPE { slope } else { MAX_SLOPE }
}

/// Cap of the receiver-plane bias, light depth: beyond it a shadow would detach visibly.
const MAX_SLOPE: f32 = 0.002;

/// Estimate and doubt of one pixel by a map; with `LTT` off nothing is ever doubted.
pub fn evaluate<T: TestFromParams, M: MapSource, const LTT: bool>(
    sample: &Sample,
    p: &ShadowParams,
    map: M,
) -> Verdict {
    let (verdict, is_settled) = settle(sample, p.light);
    if is_settled {
        return verdict;
    }
    let point = p.projection.project(sample.position);
    if !point.is_inside {
        return Verdict { visibility: 1.0, is_doubted: LTT };
    }
    let mut depth = point.depth;
    if T::PLANE_BIAS_TEXELS > 0.0 {
        depth -= T::PLANE_BIAS_TEXELS * plane_slope(&p.projection, sample.normal, p.map_size);
    }
    let footprint = bilinear_footprint(point.uv * Vec2::splat(p.map_size as f32));
    let visibility = map.visibility(T::from_params(p.test), footprint, p.map_size, depth);
    if LTT {
        let is_doubted = needs_ray(visibility, p.epsilon);
        // What is trusted is snapped: sure light is 1, sure shadow 0.
        let snapped = if visibility > 0.5 { 1.0 } else { 0.0 };
        return Verdict { visibility: snapped, is_doubted };
    }
    Verdict { visibility, is_doubted: false }
}
