//! What the camera sees, as the passes of lights read it: pieces of eight by eight samples, each part in a row of its own.
//!
//! Most pieces lie on one plane and receive: one normal and one word of flags are all of theirs ([`Places::is_even`]). A sun's light asks such a piece for
//! 13 lines of memory in place of 28, and settles it at once. What only rays ask for, and what pieces of several normals ask for, lies in an array of its
//! own, and what shading alone asks for in a third: memory that is skipped is not fetched ahead by the processor itself.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use lt_math::glam::{Mat4, Vec3, Vec4};
use lt_shaders::abi::{LightParams, Sample};

use super::tiles::PIECE;

/// A number for every sample of a piece.
pub(super) type Lanes = [f32; PIECE];

/// Coordinates of a piece's points, an axis each.
pub(super) type Points = [Lanes; 3];

/// Points in rows.
#[inline(always)]
pub(super) fn points(points: impl Iterator<Item = Vec3>) -> Points {
    let mut rows = [[0.0; PIECE]; 3];
    for (i, point) in points.take(PIECE).enumerate() {
        rows[0][i] = point.x;
        rows[1][i] = point.y;
        rows[2][i] = point.z;
    }
    rows
}

/// Settled: nothing visible, or facing away.
pub(super) const BLOCKED: u32 = 0;
/// Settled: receives no shadow.
pub(super) const LIT: u32 = 1;
/// Not settled, and outside the map.
pub(super) const OUTSIDE: u32 = 2;
/// For the map to say.
pub(super) const MAPPED: u32 = 3;

/// What every pass reads of a piece.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Places {
    pub(super) position: Points,
    /// Of all samples, where the piece is even.
    normal: [f32; 3],
    flags: u32,
    /// 1 where all samples have these normal and flags, bit by bit, and finite positions; else 0.
    is_even: u32,
    pad: [u32; 11],
}

/// What rays, and passes over pieces that are not even, read as well.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Parts {
    normal: Points,
    flags: [u32; PIECE],
    magnitude: Lanes,
}

/// Samples as the passes of lights read them, all but for what shading alone asks for.
#[derive(Clone, Debug, Default)]
pub struct SampleRows {
    pub(super) places: Vec<Places>,
    pub(super) parts: Vec<Parts>,
}

/// Some of their pieces, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Pieces<'a> {
    places: &'a [Places],
    parts: &'a [Parts],
}

/// A piece's samples; the parts are those of [`Sample`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'a> {
    places: &'a Places,
    parts: &'a Parts,
}

/// The part of a [`Sample`] that shading alone asks for.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(super) struct Look {
    shading_normal: Vec3,
    albedo: u32,
}

/// A piece's samples, part by part.
pub(super) fn keep(samples: &[Sample; PIECE], looks: &mut [Look]) -> (Places, Parts) {
    for (look, sample) in looks.iter_mut().zip(samples) {
        *look = Look { shading_normal: sample.shading_normal, albedo: sample.albedo };
    }
    rows_of(samples)
}

/// By four samples at a time, whose vectors are transposed in registers: left alone, compilers make seven gathers.
#[inline(always)]
fn rows_of(samples: &[Sample; PIECE]) -> (Places, Parts) {
    let (mut places, mut parts) = (Places::zeroed(), Parts::zeroed());
    for (group, four) in samples.as_chunks::<4>().0.iter().enumerate() {
        let at = 4 * group..4 * group + 4;
        let [x, y, z, magnitude] = transposed(four.map(|s| s.position.extend(s.magnitude)));
        places.position[0][at.clone()].copy_from_slice(&x);
        places.position[1][at.clone()].copy_from_slice(&y);
        places.position[2][at.clone()].copy_from_slice(&z);
        parts.magnitude[at.clone()].copy_from_slice(&magnitude);
        let [x, y, z, flags] = transposed(four.map(|s| s.normal.extend(f32::from_bits(s.flags))));
        parts.normal[0][at.clone()].copy_from_slice(&x);
        parts.normal[1][at.clone()].copy_from_slice(&y);
        parts.normal[2][at.clone()].copy_from_slice(&z);
        parts.flags[at].copy_from_slice(&flags.map(f32::to_bits));
    }
    let is_one = |row: &Lanes| row.iter().fold(true, |one, x| one & (x.to_bits() == row[0].to_bits()));
    let is_finite = |row: &Lanes| row.iter().fold(true, |finite, x| finite & x.is_finite());
    let has_one_flag = parts.flags.iter().fold(true, |one, flags| one & (*flags == parts.flags[0]));
    places.normal = parts.normal.map(|row| row[0]);
    places.flags = parts.flags[0];
    places.is_even =
        u32::from(parts.normal.iter().all(is_one) & has_one_flag & places.position.iter().all(is_finite));
    (places, parts)
}

impl SampleRows {
    /// Samples in tile order as pieces; the last one is filled up with samples that show nothing.
    pub fn of(samples: &[Sample]) -> Self {
        let (pieces, rest) = samples.as_chunks::<PIECE>();
        let mut last = [Sample::default(); PIECE];
        last[..rest.len()].copy_from_slice(rest);
        let last = (!rest.is_empty()).then_some(&last);
        let (places, parts) = pieces.iter().chain(last).map(rows_of).unzip();
        Self { places, parts }
    }

    /// All of them.
    #[inline]
    pub fn pieces(&self) -> Pieces<'_> {
        Pieces { places: &self.places, parts: &self.parts }
    }
}

impl<'a> Pieces<'a> {
    /// Samples of a piece.
    pub const SAMPLES: usize = PIECE;

    /// How many pieces.
    #[inline]
    pub fn len(self) -> usize {
        self.places.len()
    }

    /// Whether there is none.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.places.is_empty()
    }

    /// Some of them.
    #[inline]
    pub(super) fn range(self, pieces: Range<usize>) -> Self {
        Self { places: &self.places[pieces.clone()], parts: &self.parts[pieces] }
    }

    #[inline(always)]
    pub(super) fn piece(self, i: usize) -> Piece<'a> {
        Piece { places: &self.places[i], parts: &self.parts[i] }
    }

    #[inline(always)]
    pub(super) fn iter(self) -> impl ExactSizeIterator<Item = Piece<'a>> {
        self.places.iter().zip(self.parts).map(|(places, parts)| Piece { places, parts })
    }

    /// The sample at a place in tile order, as shadows know it: what shading alone asks for is 0.
    #[inline]
    pub fn sample(self, i: usize) -> Sample {
        self.piece(i / PIECE).sample(i % PIECE)
    }
}

impl<'a> Piece<'a> {
    #[inline(always)]
    pub(super) fn position(self) -> &'a Points {
        &self.places.position
    }

    #[inline(always)]
    fn is_even(self) -> bool {
        self.places.is_even != 0
    }

    /// Normal and flags of one of them.
    #[inline(always)]
    fn facet(self, i: usize) -> (Vec3, u32) {
        match self.is_even() {
            true => (self.places.normal.into(), self.places.flags),
            false => (vector(&self.parts.normal, i), self.parts.flags[i]),
        }
    }

    /// Normals in rows.
    #[inline(always)]
    fn normals(self) -> Points {
        match self.is_even() {
            true => self.places.normal.map(|x| [x; PIECE]),
            false => self.parts.normal,
        }
    }

    /// One of them, as shadows know it: what shading alone asks for is 0.
    #[inline(always)]
    pub(super) fn sample(self, i: usize) -> Sample {
        let (normal, flags) = self.facet(i);
        Sample {
            position: vector(&self.places.position, i),
            magnitude: self.parts.magnitude[i],
            normal,
            flags,
            ..Sample::default()
        }
    }

    /// The same with what shading asks for.
    pub(super) fn shaded_sample(self, i: usize, look: &Look) -> Sample {
        Sample { shading_normal: look.shading_normal, albedo: look.albedo, ..self.sample(i) }
    }

    /// Which of them show anything ([`Sample::is_valid`]).
    #[inline(always)]
    pub(super) fn valid(self) -> [bool; PIECE] {
        let [x, y, z] = self.normals();
        std::array::from_fn(|i| (x[i] != 0.0) | (y[i] != 0.0) | (z[i] != 0.0))
    }

    /// [`lt_shaders::evaluate::settle`]: `BLOCKED`, `LIT`, or `MAPPED` if that settles nothing.
    #[inline(always)]
    pub(super) fn settle(self, light: &LightParams) -> [u32; PIECE] {
        let [lx, ly, lz, lw] = light.place.to_array();
        if self.is_even() && lw == 0.0 {
            return [self.settle_at_once([lx, ly, lz]); PIECE];
        }
        let [x, y, z] = self.position();
        let [nx, ny, nz] = &self.normals();
        let [ax, ay, az] = light.axis.to_array();
        let mut states = [BLOCKED; PIECE];
        // Of what is turned away from the sun wherever it may be, the rest is not read.
        let turned = |i: usize| nx[i] * lx + ny[i] * ly + nz[i] * lz;
        if lw == 0.0 && !(0..PIECE).fold(false, |any, i| any | (turned(i) > 0.0)) {
            return states;
        }
        let even = [self.places.flags; PIECE];
        let flags = if self.is_even() { &even } else { &self.parts.flags };
        for i in 0..PIECE {
            let is_valid = (nx[i] != 0.0) | (ny[i] != 0.0) | (nz[i] != 0.0);
            let (tx, ty, tz) = (lx - x[i] * lw, ly - y[i] * lw, lz - z[i] * lw);
            let facing = nx[i] * tx + ny[i] * ty + nz[i] * tz;
            let squared = tx * tx + ty * ty + tz * tz;
            let along = -(tx * ax + ty * ay + tz * az);
            let reaches = (lw == 0.0)
                | ((squared <= light.range_squared) & (along >= light.cos_outer * squared.sqrt()));
            let open = if flags[i] & Sample::RECEIVES == 0 { LIT } else { MAPPED };
            states[i] = if is_valid & (facing > 0.0) & reaches { open } else { BLOCKED };
        }
        states
    }

    /// The state of all samples of an even piece under a sun, which lies in the direction `to_light`. A normal of zeros faces nothing.
    #[inline(always)]
    fn settle_at_once(self, to_light: [f32; 3]) -> u32 {
        let n = self.places.normal;
        let facing = n[0] * to_light[0] + n[1] * to_light[1] + n[2] * to_light[2];
        match (facing > 0.0, self.places.flags & Sample::RECEIVES) {
            (false, _) => BLOCKED,
            (true, 0) => LIT,
            (true, _) => MAPPED,
        }
    }
}

#[inline(always)]
fn vector(rows: &Points, i: usize) -> Vec3 {
    Vec3::new(rows[0][i], rows[1][i], rows[2][i])
}

/// The channels of four vectors.
#[inline(always)]
fn transposed(v: [Vec4; 4]) -> [[f32; 4]; 4] {
    Mat4::from_cols(v[0], v[1], v[2], v[3]).transpose().to_cols_array_2d()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_hold_every_sample_and_are_filled_up_with_nothing() {
        let sample = |i: usize| {
            let x = i as f32;
            let (position, normal) = (Vec3::new(x, x + 0.1, x + 0.2), Vec3::new(-x, 0.3 - x, 0.6));
            let look = Vec3::new(0.5, x, -x);
            let (magnitude, flags, albedo) = (7.0 * x, i as u32, !(i as u32));
            Sample { position, magnitude, normal, flags, shading_normal: look, albedo }
        };
        let samples: Vec<Sample> = (0..PIECE + 3).map(sample).collect();
        let rows = SampleRows::of(&samples);
        assert_eq!(rows.pieces().len(), 2);
        for i in 0..2 * PIECE {
            let expected = samples.get(i).copied().unwrap_or_default();
            let shadows = Sample { shading_normal: Vec3::ZERO, albedo: 0, ..expected };
            assert_eq!(rows.pieces().sample(i), shadows, "{i}");
        }
        let first: &[Sample; PIECE] = samples.first_chunk().expect("a piece");
        let mut looks = [Look::default(); PIECE];
        let (places, parts) = keep(first, &mut looks);
        let piece = Piece { places: &places, parts: &parts };
        assert!((0..PIECE).all(|i| piece.shaded_sample(i, &looks[i]) == samples[i]));
    }

    /// Pieces of one normal and of several, by suns and a lamp, of every kind: each sample as the shared function settles it.
    #[test]
    fn pieces_are_settled_as_their_samples_are() {
        let even = Sample {
            position: Vec3::new(0.3, -0.2, 0.5),
            magnitude: 2.0,
            normal: Vec3::new(0.1, 0.9, -0.2),
            flags: Sample::RECEIVES,
            ..Sample::default()
        };
        let sun = |x: f32, y: f32, z: f32| LightParams::directional(Vec3::new(x, y, z).normalize());
        let lamp = LightParams {
            place: Vec3::new(0.5, 2.0, 0.1).extend(1.0),
            axis: Vec3::NEG_Y,
            cos_outer: 0.8,
            range_squared: 9.0,
            ..sun(0.0, 1.0, 0.0)
        };
        let others = [
            even,
            Sample { normal: -even.normal, ..even },
            Sample { normal: Vec3::ZERO, ..even },
            Sample { normal: Vec3::new(f32::NAN, 0.0, 0.0), ..even },
            Sample { flags: 0, ..even },
            Sample { position: Vec3::new(0.0, f32::INFINITY, 0.0), ..even },
            Sample { position: Vec3::new(0.0, 0.0, f32::NAN), ..even },
        ];
        let kinds = others.map(|all| others.map(|one| (all, one)));
        let (mut even_pieces, mut tally) = (0, [0; 3]);
        for (all, one) in kinds.into_iter().flatten() {
            let mut samples = [all; PIECE];
            samples[37] = one;
            for (i, sample) in samples.iter_mut().enumerate() {
                sample.position.x += 0.01 * i as f32;
            }
            let rows = SampleRows::of(&samples);
            even_pieces += rows.places[0].is_even;
            for light in [sun(0.2, 1.0, 0.1), sun(-0.2, -1.0, 0.3), sun(0.0, 0.0, 1.0), lamp] {
                let states = rows.pieces().piece(0).settle(&light);
                for (sample, state) in samples.iter().zip(states) {
                    let expected = match lt_shaders::evaluate::settle(sample, &light) {
                        (_, false) => MAPPED,
                        (v, true) => {
                            if v.visibility > 0.0 {
                                LIT
                            } else {
                                BLOCKED
                            }
                        }
                    };
                    assert_eq!(state, expected, "{sample:?} {light:?}");
                    tally[usize::from(state == LIT) + 2 * usize::from(state == MAPPED)] += 1;
                }
            }
        }
        assert!(even_pieces >= 4 && tally.iter().all(|&n| n > 100), "{even_pieces} {tally:?}");
    }
}
