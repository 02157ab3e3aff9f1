//! The evaluate pass: what the map says about a pixel, and whether that is to be trusted.

use lt_mask::TexelMarks;
use lt_math::glam::{IVec2, Vec2, Vec3, Vec4};
use lt_math::{
    Esm, Evsm, Footprint, LevelSource, LightPoint, LightProjection, MsmHamburger, MsmHausdorff, OneLevel,
    Pcf, ShadowTest, Sm, Vsm, bilinear_footprint, needs_ray,
};

use crate::abi::{LightParams, Sample, ShadowParams};

/// Estimate and doubt of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// 1 lit, 0 blocked. Under a doubt test: exactly 0 or 1 where it is trusted, the map's own answer between them where
    /// it is doubted, [`Verdict::UNJUDGED`] where no map answered, [`Verdict::RECALLED_LIT`] or its like where a mark alone doubts; so this one
    /// number tells all to the mask pass.
    pub visibility: f32,
    /// Whether only a ray can tell.
    pub is_doubted: bool,
}

impl Verdict {
    /// Visibility of a doubted pixel about which no map says anything: outside the map, or its answer is NaN. A map that
    /// answers exactly this is as undecided, and treated alike.
    pub const UNJUDGED: f32 = 0.5;
    /// Visibility of a pixel that the test takes for surely lit and a mark speaks against: the number below 1. A test's own answer may be
    /// the same under an ε that is as small, and is then treated alike.
    pub const RECALLED_LIT: f32 = 1.0 - f32::EPSILON * 0.5;
    /// The same of one that the test takes for surely shadowed.
    pub const RECALLED_SHADOWED: f32 = f32::EPSILON * 0.5;

    const BLOCKED: Self = Self { visibility: 0.0, is_doubted: false };
    const LIT: Self = Self { visibility: 1.0, is_doubted: false };
}

/// Unnormalised vector from a point to the light; see [`LightParams::place`].
#[inline]
pub fn to_light(position: Vec3, light: &LightParams) -> Vec3 {
    light.place.truncate() - position * light.place.w
}

/// Whether a light shines towards a point at all, `to_light` away from it: within its range and its cone. The edge of
/// either counts as inside.
#[inline]
pub fn reaches(to_light: Vec3, light: &LightParams) -> bool {
    let squared = to_light.dot(to_light);
    let along = -to_light.dot(light.axis);
    light.place.w == 0.0
        || (squared <= light.range_squared && along >= light.cos_outer * lt_math::float::sqrt(squared))
}

/// What needs neither map nor ray: nothing visible, facing away or out of the light's reach is blocked, and what receives
/// no shadow is lit.
/// The last field says whether a pixel is settled so.
#[inline]
pub fn settle(sample: &Sample, light: &LightParams) -> (Verdict, bool) {
    if !sample.is_valid() {
        return (Verdict::BLOCKED, true);
    }
    let to_light = to_light(sample.position, light);
    let faces = sample.normal.dot(to_light) > 0.0;
    if !faces || !reaches(to_light, light) {
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
    /// v̂ at a footprint of a square map, `level` maps past the first.
    fn visibility<T: TestFromParams>(
        &self,
        test: T,
        footprint: Footprint,
        map_size: u32,
        level: u32,
        depth: f32,
    ) -> f32;

    /// What rays have found wrong about a footprint with this upper left texel.
    #[inline]
    fn marks(&self, _texel: IVec2, _map_size: u32, _level: u32) -> TexelMarks {
        TexelMarks::NONE
    }
}

/// Plain depths, row by row and map after map: the four of the footprint become vectors here.
#[derive(Clone, Copy)]
pub struct GatheredDepths<'a> {
    /// `map_size²` depths a map.
    pub depths: &'a [f32],
}

impl MapSource for GatheredDepths<'_> {
    fn visibility<T: TestFromParams>(
        &self,
        test: T,
        footprint: Footprint,
        map_size: u32,
        level: u32,
        depth: f32,
    ) -> f32 {
        let i = level_quad_indices(footprint.texel, map_size, level);
        let depths = Vec4::new(
            self.depths[i[0] as usize],
            self.depths[i[1] as usize],
            self.depths[i[2] as usize],
            self.depths[i[3] as usize],
        );
        test.visibility_of_gather(depths, footprint.weights, depth)
    }
}

/// Pre-filtered depth vectors, row by row and map after map.
#[derive(Clone, Copy)]
pub struct FilteredVectors<'a> {
    /// `map_size²` vectors a map.
    pub vectors: &'a [Vec4],
}

impl MapSource for FilteredVectors<'_> {
    fn visibility<T: TestFromParams>(
        &self,
        test: T,
        footprint: Footprint,
        map_size: u32,
        level: u32,
        depth: f32,
    ) -> f32 {
        let i = level_quad_indices(footprint.texel, map_size, level);
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

/// [`quad_indices`] in maps that follow one another.
#[inline]
fn level_quad_indices(texel: IVec2, map_size: u32, level: u32) -> [u32; 4] {
    let first = level * map_size * map_size;
    let i = quad_indices(texel, map_size);
    [i[0] + first, i[1] + first, i[2] + first, i[3] + first]
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

/// The same for perspective maps, times their size: they are about as deep as wide at their far end, so that the slope of a
/// surface seen at 83° is 16 texels' share of the depth.
const MAX_SLOPE_AT: f32 = 16.0;

/// The leak tracing test on a map's answer: trusted answers are snapped, sure light to 1, sure shadow to 0.
#[inline]
pub fn doubt(visibility: f32, epsilon: f32) -> Verdict {
    if !needs_ray(visibility, epsilon) {
        return Verdict { visibility: if visibility > 0.5 { 1.0 } else { 0.0 }, is_doubted: false };
    }
    // Written so that NaN is unjudged too.
    let is_between = visibility > 0.0 && visibility < 1.0;
    Verdict { visibility: if is_between { visibility } else { Verdict::UNJUDGED }, is_doubted: true }
}

/// Doubts a trusted answer that has been wrong here.
#[inline]
pub fn recall(verdict: Verdict, marks: TexelMarks) -> Verdict {
    let is_shadowed = verdict.visibility < 0.5;
    if verdict.is_doubted || !marks.contradict(is_shadowed) {
        return verdict;
    }
    let visibility = if is_shadowed { Verdict::RECALLED_SHADOWED } else { Verdict::RECALLED_LIT };
    Verdict { visibility, is_doubted: true }
}

/// Whether a doubt is [`recall`]'s, of an answer that the test itself trusts.
#[inline]
pub fn is_recalled(visibility: f32) -> bool {
    visibility == Verdict::RECALLED_LIT || visibility == Verdict::RECALLED_SHADOWED
}

/// [`plane_slope`] for any map, at the place of a sample: from the map's derivatives there.
#[inline]
pub fn plane_slope_at(
    projection: &LightProjection,
    sample: &Sample,
    point: &LightPoint,
    map_size: u32,
) -> f32 {
    let along = projection.row_w.truncate();
    let w = along.dot(sample.position) + projection.row_w.w;
    // How u and v grow along world axes.
    let u = (projection.row_x.truncate() - along * point.uv.x) / w;
    let v = (projection.row_y.truncate() - along * point.uv.y) / w;
    let depth = projection.row_z.truncate();
    // In the plane: a step across v, along which u alone grows, and one across u.
    let (across_v, across_u) = (v.cross(sample.normal), u.cross(sample.normal));
    let per = |step: Vec3, axis: Vec3| (depth.dot(step) / axis.dot(step)).abs();
    let slope = (per(across_v, u) + per(across_u, v)) / map_size as f32;
    let cap = MAX_SLOPE_AT / map_size as f32;
    if slope < cap { slope } else { cap }
}

/// Estimate and doubt of one pixel by the one map of a directional light; with `LTT` off nothing is ever doubted.
#[inline]
pub fn evaluate<T: TestFromParams, M: MapSource, const LTT: bool>(
    sample: &Sample,
    p: &ShadowParams,
    map: M,
) -> Verdict {
    evaluate_levels::<T, M, OneLevel, LTT>(sample, p, map, OneLevel { projection: p.projection })
}

/// Estimate and doubt of one pixel by the level that answers for it; with `LTT` off nothing is ever doubted.
///
/// A pixel on no level is doubted and unjudged, or lit with `LTT` off.
pub fn evaluate_levels<T: TestFromParams, M: MapSource, L: LevelSource, const LTT: bool>(
    sample: &Sample,
    p: &ShadowParams,
    map: M,
    levels: L,
) -> Verdict {
    let (verdict, is_settled) = settle(sample, &p.light);
    if is_settled {
        return verdict;
    }
    let found = levels.find(sample.position, p.map_size);
    let point = found.point;
    if !point.is_inside {
        return Verdict { visibility: if LTT { Verdict::UNJUDGED } else { 1.0 }, is_doubted: LTT };
    }
    let mut depth = point.depth;
    if T::PLANE_BIAS_TEXELS > 0.0 {
        let projection = levels.projection(found.level);
        let is_straight = !L::MAY_BE_PERSPECTIVE || projection.row_w.truncate() == Vec3::ZERO;
        depth -= T::PLANE_BIAS_TEXELS
            * if is_straight {
                plane_slope(&projection, sample.normal, p.map_size)
            } else {
                plane_slope_at(&projection, sample, &point, p.map_size)
            };
    }
    let footprint = bilinear_footprint(point.uv * Vec2::splat(p.map_size as f32));
    let visibility = map.visibility(T::from_params(p.test), footprint, p.map_size, found.level, depth);
    if LTT {
        let marks = map.marks(footprint.texel, p.map_size, found.level);
        return recall(doubt(visibility, p.epsilon), marks);
    }
    Verdict { visibility, is_doubted: false }
}
