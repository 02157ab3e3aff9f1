//! Where the pixels of a batch lie on a light's maps, and what is there: 64 at a time, in stages over arrays.
//!
//! The stages are those of [`super::batch`], which has the story.

use lt_bvh::lanes;
use lt_math::glam::{Vec2, Vec3, Vec4};
use lt_math::{LightPoint, LightProjection, ShadowTest, blend, float, level_margin_uv};
use lt_shaders::abi::ShadowParams;
use lt_shaders::evaluate::{Verdict, plane_slope, plane_slope_at};

use super::bits::{self, places};
use super::heads::Facing;
use super::map_tiles::{column_start, row_start};
use super::marks;
use super::samples::{Lanes, Piece};
use super::tiles::PIECE;

/// What a batch reads of a light's maps.
#[derive(Clone, Copy)]
pub(super) struct Maps<'a> {
    pub projections: &'a [LightProjection],
    pub texels: Texels<'a>,
    /// How far from its edge a level answers; `None` for one map, all of which answers.
    pub margin_uv: Option<f32>,
    /// Depths that may have [marks](super::marks), where these count.
    pub marked: Option<&'a [f32]>,
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
        Maps { projections: std::slice::from_ref(&p.projection), texels, margin_uv: None, marked: None }
    }

    /// Its levels, finest first.
    pub(super) fn levels(p: &ShadowParams, projections: &'a [LightProjection], texels: Texels<'a>) -> Self {
        Maps { projections, texels, margin_uv: Some(level_margin_uv(p.map_size)), marked: None }
    }
}

/// A batch's pixels on the levels that answer for them, first where they lie ([`Footprints::find`]), then what is there
/// ([`Footprints::gather`]). Pixels that no level answers have numbers, too.
pub struct Footprints {
    /// Who is settled.
    pub(super) facing: Facing,
    /// Who is for the map to say: of those not settled, whoever lies on a level.
    pub(super) mapped: u64,
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
    /// Their words joined, for the marks in them; 0 without marks.
    joined: [u32; PIECE],
}

impl Footprints {
    pub(super) fn new() -> Self {
        Self {
            facing: Facing::default(),
            mapped: 0,
            u: [0.0; PIECE],
            v: [0.0; PIECE],
            receivers: [0.0; PIECE],
            first_texels: [0; PIECE],
            weights: [[0.0; PIECE]; 4],
            texels: [[0; PIECE]; 4],
            offsets: [[0.0; PIECE]; 4],
            joined: [0; PIECE],
        }
    }

    /// Settles and projects, and finds who lies on a level.
    #[inline(always)]
    pub(super) fn find<L: lanes::Lanes>(
        &mut self,
        lanes: L,
        piece: Piece<'_>,
        p: &ShadowParams,
        maps: Maps<'_>,
    ) {
        self.facing = piece.facing(&p.light);
        self.mapped = 0;
        if self.facing.open == 0 {
            return;
        }
        (self.u, self.v, self.receivers) = ([0.0; PIECE], [0.0; PIECE], [0.0; PIECE]);
        self.first_texels = [0; PIECE];
        for (level, projection) in maps.projections.iter().enumerate() {
            let first_texel = level as u32 * p.map_size * p.map_size;
            if projection.row_w == Vec4::W {
                self.try_level::<_, true>(lanes, piece, projection, maps.margin_uv, first_texel);
            } else {
                self.try_level::<_, false>(lanes, piece, projection, maps.margin_uv, first_texel);
            }
            if self.mapped == self.facing.open {
                break;
            }
        }
        self.find_texels(p.map_size);
    }

    /// Moves pixels that are still sought, and that a level holds, onto it. A directional light's last row is (0, 0, 0, 1), which divides
    /// by 1: `PARALLEL` leaves that out.
    #[inline(always)]
    fn try_level<L: lanes::Lanes, const PARALLEL: bool>(
        &mut self,
        lanes: L,
        piece: Piece<'_>,
        projection: &LightProjection,
        margin_uv: Option<f32>,
        first_texel: u32,
    ) {
        let sought = self.facing.open & !self.mapped;
        // Without a margin all of [0, 1] is inside: the same comparisons.
        let margin = margin_uv.unwrap_or(0.0);
        let (low, high) = (lanes.splat(margin), lanes.splat(1.0 - margin));
        let (zero, one) = (lanes.splat(0.0), lanes.splat(1.0));
        let [x, y, z] = piece.position();
        for first in (0..PIECE).step_by(L::WIDTH) {
            let at = [lanes.load(&x[first..]), lanes.load(&y[first..]), lanes.load(&z[first..])];
            let mut u = along(lanes, projection.row_x, at);
            let mut v = along(lanes, projection.row_y, at);
            let depth = along(lanes, projection.row_z, at);
            let mut inside = (sought >> first) as u32 & L::ALL;
            if !PARALLEL {
                let w = along(lanes, projection.row_w, at);
                (u, v) = (lanes.div(u, w), lanes.div(v, w));
                inside &= lanes.lt(zero, w);
            }
            inside &= lanes.le(low, u) & lanes.le(u, high) & lanes.le(low, v) & lanes.le(v, high);
            inside &= lanes.le(zero, depth) & lanes.le(depth, one);
            write(lanes, inside, u, &mut self.u[first..]);
            write(lanes, inside, v, &mut self.v[first..]);
            write(lanes, inside, depth, &mut self.receivers[first..]);
            self.mapped |= u64::from(inside) << first;
            // Those of the first level are there already.
            if first_texel != 0 {
                for i in places(u64::from(inside)) {
                    self.first_texels[first + i] = first_texel;
                }
            }
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
        for i in places(self.mapped) {
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

    /// Fetches depths, and takes the receivers' from them if asked to; marks too where there are any.
    #[inline(always)]
    pub(super) fn gather<L: lanes::Lanes, const MARKED: bool>(
        &mut self,
        lanes: L,
        depths: &[f32],
        from_receivers: bool,
    ) {
        let depths: &[u32] = bytemuck::cast_slice(depths);
        for (offsets, texels) in self.offsets.iter_mut().zip(&self.texels) {
            let offsets: &mut [u32; PIECE] = bytemuck::cast_mut(offsets);
            for first in (0..PIECE).step_by(L::WIDTH) {
                lanes.gather_words(depths, &texels[first..], &mut offsets[first..]);
            }
        }
        if MARKED {
            let [a, b, c, d] = &self.offsets;
            for (i, joined) in self.joined.iter_mut().enumerate() {
                *joined = a[i].to_bits() | b[i].to_bits() | c[i].to_bits() | d[i].to_bits();
            }
        }
        for row in &mut self.offsets {
            for (offset, receiver) in row.iter_mut().zip(&self.receivers) {
                let depth = float::saturate(if MARKED { marks::depth(*offset) } else { *offset });
                *offset = if from_receivers { depth - receiver } else { depth };
            }
        }
    }

    /// Fetches marks alone.
    pub(super) fn gather_marks(&mut self, depths: &[f32]) {
        self.joined = [0; PIECE];
        for i in places(self.mapped) {
            let words = self.texels.each_ref().map(|texels| depths[texels[i] as usize].to_bits());
            self.joined[i] = words.into_iter().fold(0, |joined, word| joined | word);
        }
    }

    /// Who said this and was wrong about the same texels before: lit, then shadowed.
    #[inline(always)]
    fn recalled(&self) -> [u64; 2] {
        if self.joined.iter().fold(0, |all, word| all | word) & !marks::DEPTH_BITS == 0 {
            return [0; 2];
        }
        let wrong = self.joined.map(marks::wrong);
        [0, 1].map(|said| bits::pack(&wrong.map(|wrong| u8::from(wrong[said]))))
    }

    /// The blended vectors' answers for pixels that are for the map to say, 0 for others.
    pub(super) fn filtered(&self, test: &impl ShadowTest, vectors: &[Vec4]) -> Lanes {
        let mut v = [0.0; PIECE];
        for i in places(self.mapped) {
            let [a, b, c, d] = self.texels.each_ref().map(|texels| vectors[texels[i] as usize]);
            v[i] = test.visibility(blend(a, b, c, d, self.weights(i).into()), self.receivers[i]);
        }
        v
    }

    /// Writes what comes of answers, and of pixels that no map is asked about; who is doubted. With `LTT` by
    /// [`doubt`](lt_shaders::evaluate::doubt) and [`recall`](lt_shaders::evaluate::recall).
    #[inline(always)]
    pub(super) fn judge<L: lanes::Lanes, const LTT: bool>(
        &self,
        lanes: L,
        answers: &Lanes,
        epsilon: f32,
        visibility: &mut Lanes,
    ) -> u64 {
        let Facing { open, lit } = self.facing;
        let outside = open & !self.mapped;
        if !LTT {
            bits::paint(lanes, lit | outside, visibility);
            bits::put(lanes, self.mapped, answers, visibility);
            return 0;
        }
        let is_confident =
            bits::at_most(lanes, answers, epsilon) | bits::at_least(lanes, answers, 1.0 - epsilon);
        let sure = self.mapped & is_confident;
        let surely_lit = sure & bits::more(lanes, answers, 0.5);
        bits::paint(lanes, lit | surely_lit, visibility);
        let doubted = open & !sure;
        if doubted != 0 {
            let is_between = bits::more(lanes, answers, 0.0) & bits::less(lanes, answers, 1.0);
            let judged = doubted & self.mapped & is_between;
            bits::put(lanes, judged, answers, visibility);
            bits::put(lanes, doubted & !judged, &[Verdict::UNJUDGED; PIECE], visibility);
        }
        let [wrongly_lit, wrongly_shadowed] = self.recalled();
        let recalled = surely_lit & wrongly_lit | sure & !surely_lit & wrongly_shadowed;
        if recalled != 0 {
            bits::put(lanes, recalled & surely_lit, &[Verdict::RECALLED_LIT; PIECE], visibility);
            bits::put(lanes, recalled & !surely_lit, &[Verdict::RECALLED_SHADOWED; PIECE], visibility);
        }
        doubted | recalled
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

/// Writes the lanes whose bit is set.
#[inline(always)]
fn write<L: lanes::Lanes>(lanes: L, mask: u32, found: L::F, to: &mut [f32]) {
    lanes.store(lanes.pick(mask, found, lanes.load(to)), to);
}

/// A row of a projection times positions, in the order of operations of [`float::dot4`].
#[inline(always)]
fn along<L: lanes::Lanes>(lanes: L, row: Vec4, at: [L::F; 3]) -> L::F {
    let [x, y, z] = [row.x, row.y, row.z].map(|x| lanes.splat(x));
    let sum = lanes.add(lanes.mul(x, at[0]), lanes.mul(y, at[1]));
    lanes.add(lanes.add(sum, lanes.mul(z, at[2])), lanes.splat(row.w))
}
