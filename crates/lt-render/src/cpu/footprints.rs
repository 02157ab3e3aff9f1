//! Where the pixels of a batch lie on a light's maps, and what is there: 64 at a time, in stages over arrays.
//!
//! The stages are those of [`super::batch`], which has the story.

use lt_math::glam::{Vec2, Vec3, Vec4};
use lt_math::{LightPoint, LightProjection, ShadowTest, blend, float, level_margin_uv};
use lt_shaders::abi::ShadowParams;
use lt_shaders::evaluate::{plane_slope, plane_slope_at};

use super::map_tiles::{column_start, row_start};
use super::samples::{BLOCKED, Lanes, MAPPED, OUTSIDE, Piece};
use super::tiles::PIECE;

/// What a batch reads of a light's maps.
#[derive(Clone, Copy)]
pub(super) struct Maps<'a> {
    pub projections: &'a [LightProjection],
    pub texels: Texels<'a>,
    /// How far from its edge a level answers; `None` for one map, all of which answers.
    pub margin_uv: Option<f32>,
}

/// What maps hold, map after map, each in [tiles](super::map_tiles).
#[derive(Clone, Copy)]
pub(super) enum Texels<'a> {
    Depths(&'a [f32]),
    /// Filtered beforehand.
    Vectors(&'a [Vec4]),
}

impl Texels<'_> {
    pub(super) fn len(&self) -> usize {
        match self {
            Texels::Depths(all) => all.len(),
            Texels::Vectors(all) => all.len(),
        }
    }
}

impl<'a> Maps<'a> {
    /// The one map of a light.
    pub(super) fn one(p: &'a ShadowParams, texels: Texels<'a>) -> Self {
        Maps { projections: std::slice::from_ref(&p.projection), texels, margin_uv: None }
    }

    /// Its levels, finest first.
    pub(super) fn levels(p: &ShadowParams, projections: &'a [LightProjection], texels: Texels<'a>) -> Self {
        Maps { projections, texels, margin_uv: Some(level_margin_uv(p.map_size)) }
    }
}

/// A batch's pixels on the levels that answer for them, first where they lie ([`Footprints::find`]), then what is there
/// ([`Footprints::gather`]). Pixels that no level answers have numbers, too.
pub struct Footprints {
    pub(super) states: [u32; PIECE],
    /// Whether any is for the map to say.
    pub(super) is_any_open: bool,
    u: Lanes,
    v: Lanes,
    pub(super) receivers: Lanes,
    /// Numbers of the first texels of the levels.
    first_texels: [u32; PIECE],
    pub(super) weights: [Lanes; 4],
    /// Numbers of the four texels.
    texels: [[u32; PIECE]; 4],
    /// Their depths, limited to \[0, 1\], minus the receiver's if the test asks for that.
    pub(super) offsets: [Lanes; 4],
}

impl Footprints {
    pub(super) fn new() -> Self {
        Self {
            states: [BLOCKED; PIECE],
            is_any_open: false,
            u: [0.0; PIECE],
            v: [0.0; PIECE],
            receivers: [0.0; PIECE],
            first_texels: [0; PIECE],
            weights: [[0.0; PIECE]; 4],
            texels: [[0; PIECE]; 4],
            offsets: [[0.0; PIECE]; 4],
        }
    }

    /// Settles and projects, and finds who is `OUTSIDE`.
    #[inline(always)]
    pub(super) fn find(&mut self, piece: Piece<'_>, p: &ShadowParams, maps: Maps<'_>) {
        self.states = piece.settle(&p.light);
        self.is_any_open = self.states.iter().fold(false, |any, &s| any | (s == MAPPED));
        if !self.is_any_open {
            return;
        }
        (self.u, self.v, self.receivers) = ([0.0; PIECE], [0.0; PIECE], [0.0; PIECE]);
        self.first_texels = [0; PIECE];
        let mut is_sought = self.states.map(|state| u32::from(state == MAPPED));
        for (level, projection) in maps.projections.iter().enumerate() {
            let first_texel = level as u32 * p.map_size * p.map_size;
            if projection.row_w == Vec4::W {
                self.try_level::<true>(piece, projection, maps.margin_uv, first_texel, &mut is_sought);
            } else {
                self.try_level::<false>(piece, projection, maps.margin_uv, first_texel, &mut is_sought);
            }
            if is_sought.iter().fold(0, |any, &sought| any | sought) == 0 {
                break;
            }
        }
        for (state, sought) in self.states.iter_mut().zip(&is_sought) {
            *state = if *sought != 0 { OUTSIDE } else { *state };
        }
        self.find_texels(p.map_size);
    }

    /// Moves pixels that are still sought, and that a level holds, onto it. A directional light's last row is (0, 0, 0, 1), which divides
    /// by 1: `PARALLEL` leaves that out.
    #[inline(always)]
    fn try_level<const PARALLEL: bool>(
        &mut self,
        piece: Piece<'_>,
        projection: &LightProjection,
        margin_uv: Option<f32>,
        first_texel: u32,
        is_sought: &mut [u32; PIECE],
    ) {
        let [x, y, z] = piece.position();
        let [row_x, row_y, row_z, row_w] =
            [projection.row_x, projection.row_y, projection.row_z, projection.row_w].map(|r| r.to_array());
        // Without a margin all of [0, 1] is inside: the same comparisons.
        let margin = margin_uv.unwrap_or(0.0);
        let (low, high) = (margin, 1.0 - margin);
        for i in 0..PIECE {
            let along = |r: [f32; 4]| r[0] * x[i] + r[1] * y[i] + r[2] * z[i] + r[3] * 1.0;
            let w = if PARALLEL { 1.0 } else { along(row_w) };
            let (at_u, at_v, depth) = (along(row_x) / w, along(row_y) / w, along(row_z));
            let is_between = |x: f32| (x >= low) & (x <= high);
            let is_unit = |x: f32| (0.0..=1.0).contains(&x);
            let is_inside =
                (is_sought[i] != 0) & (w > 0.0) & is_between(at_u) & is_between(at_v) & is_unit(depth);
            self.u[i] = if is_inside { at_u } else { self.u[i] };
            self.v[i] = if is_inside { at_v } else { self.v[i] };
            self.receivers[i] = if is_inside { depth } else { self.receivers[i] };
            self.first_texels[i] = if is_inside { first_texel } else { self.first_texels[i] };
            is_sought[i] = if is_inside { 0 } else { is_sought[i] };
        }
    }

    /// The four texels around each place, and their weights.
    #[inline(always)]
    fn find_texels(&mut self, map_size: u32) {
        let (size, last) = (map_size as f32, map_size as i32 - 1);
        for (i, first_texel) in self.first_texels.iter().enumerate() {
            let (x, y) = (self.u[i] * size - 0.5, self.v[i] * size - 0.5);
            let (x0, y0) = (float::floor_lane(x), float::floor_lane(y));
            let (fx, fy) = (x - x0, y - y0);
            self.weights[0][i] = (1.0 - fx) * (1.0 - fy);
            self.weights[1][i] = fx * (1.0 - fy);
            self.weights[2][i] = (1.0 - fx) * fy;
            self.weights[3][i] = fx * fy;
            let (x0, y0) = (float::whole_lane(x0), float::whole_lane(y0));
            let on_map = |t: i32| t.max(0).min(last) as u32;
            let [left, right] = [x0, x0 + 1].map(|x| column_start(on_map(x)));
            let [upper, lower] = [y0, y0 + 1].map(|y| row_start(on_map(y), map_size) + first_texel);
            self.texels[0][i] = upper + left;
            self.texels[1][i] = upper + right;
            self.texels[2][i] = lower + left;
            self.texels[3][i] = lower + right;
        }
    }

    /// Moves receivers to the light by how far their own planes fall off over some texels ([`TestFromParams::PLANE_BIAS_TEXELS`]).
    ///
    /// [`TestFromParams::PLANE_BIAS_TEXELS`]: lt_shaders::evaluate::TestFromParams::PLANE_BIAS_TEXELS
    pub(super) fn bias_receivers(&mut self, texels: f32, piece: Piece<'_>, p: &ShadowParams, maps: Maps<'_>) {
        for i in (0..PIECE).filter(|&i| self.states[i] == MAPPED) {
            let level = self.first_texels[i] / (p.map_size * p.map_size);
            let (projection, sample) = (&maps.projections[level as usize], piece.sample(i));
            let is_straight = maps.margin_uv.is_none() || projection.row_w.truncate() == Vec3::ZERO;
            let slope = if is_straight {
                plane_slope(projection, sample.normal, p.map_size)
            } else {
                let uv = Vec2::new(self.u[i], self.v[i]);
                let point = LightPoint { uv, depth: self.receivers[i], is_inside: true };
                plane_slope_at(projection, &sample, &point, p.map_size)
            };
            self.receivers[i] -= texels * slope;
        }
    }

    /// Fetches depths, and takes the receivers' from them if asked to.
    #[inline(always)]
    pub(super) fn gather(&mut self, depths: &[f32], from_receivers: bool) {
        for i in 0..PIECE {
            for (offsets, texels) in self.offsets.iter_mut().zip(&self.texels) {
                offsets[i] = depths[texels[i] as usize];
            }
        }
        for row in &mut self.offsets {
            for (offset, receiver) in row.iter_mut().zip(&self.receivers) {
                let depth = float::saturate(*offset);
                *offset = if from_receivers { depth - receiver } else { depth };
            }
        }
    }

    /// The blended vectors' answers for pixels that are for the map to say, 0 for others.
    pub(super) fn filtered(&self, test: &impl ShadowTest, vectors: &[Vec4]) -> Lanes {
        let mut v = [0.0; PIECE];
        for i in (0..PIECE).filter(|&i| self.states[i] == MAPPED) {
            let [a, b, c, d] = self.texels.each_ref().map(|texels| vectors[texels[i] as usize]);
            v[i] = test.visibility(blend(a, b, c, d, self.weights(i).into()), self.receivers[i]);
        }
        v
    }

    #[inline(always)]
    pub(super) fn offsets(&self, i: usize) -> [f32; 4] {
        [self.offsets[0][i], self.offsets[1][i], self.offsets[2][i], self.offsets[3][i]]
    }

    #[inline(always)]
    pub(super) fn weights(&self, i: usize) -> [f32; 4] {
        [self.weights[0][i], self.weights[1][i], self.weights[2][i], self.weights[3][i]]
    }
}
