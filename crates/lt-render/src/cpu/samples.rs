//! What the camera sees, as the passes of lights read it: pieces of eight by eight samples, each part in a row of its own.
//!
//! Whom a sun faces is told by a piece's [`Head`], where it shows few planes, so that a sun's light asks for 14 lines of memory in place of 28. What only rays
//! ask for, and what pieces of many planes ask for, lies in an array of its own, and what shading alone asks for in a third: memory that is skipped is not
//! fetched ahead by the processor itself.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use lt_bvh::lanes::{Chosen, NodeLanes, Work, prefetch};
use lt_math::glam::{Mat4, Vec3, Vec4};
use lt_shaders::abi::{LightParams, Sample};

use super::bits::pack;
use super::heads::{Facing, Head};
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

/// What rays read as well, and passes over pieces whose [`Head`] does not tell.
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
    pub(super) heads: Vec<Head>,
    pub(super) positions: Vec<Points>,
    pub(super) parts: Vec<Parts>,
}

/// Some of their pieces, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Pieces<'a> {
    heads: &'a [Head],
    positions: &'a [Points],
    parts: &'a [Parts],
}

/// A piece's samples; the parts are those of [`Sample`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'a> {
    head: &'a Head,
    position: &'a Points,
    parts: &'a Parts,
}

/// The part of a [`Sample`] that shading alone asks for.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(super) struct Look {
    shading_normal: Vec3,
    albedo: u32,
}

/// A piece as it is kept.
pub(super) struct Kept {
    pub(super) head: Head,
    pub(super) position: Points,
    pub(super) parts: Parts,
}

/// Samples part by part.
pub(super) fn keep(samples: &[Sample; PIECE], looks: &mut [Look]) -> Kept {
    for (look, sample) in looks.iter_mut().zip(samples) {
        *look = Look { shading_normal: sample.shading_normal, albedo: sample.albedo };
    }
    Chosen::best().run(Keep(samples))
}

/// The work of [`keep`].
struct Keep<'a>(&'a [Sample; PIECE]);

impl Work for Keep<'_> {
    type Output = Kept;
    #[inline(always)]
    fn run<L: NodeLanes>(self, _: L) -> Self::Output {
        rows_of(self.0)
    }
}

/// By four samples at a time, whose vectors are transposed in registers: left alone, compilers make seven gathers.
#[inline(always)]
fn rows_of(samples: &[Sample; PIECE]) -> Kept {
    let (mut position, mut parts) = ([[0.0; PIECE]; 3], Parts::zeroed());
    for (group, four) in samples.as_chunks::<4>().0.iter().enumerate() {
        let at = 4 * group..4 * group + 4;
        let [x, y, z, magnitude] = transposed(four.map(|s| s.position.extend(s.magnitude)));
        position[0][at.clone()].copy_from_slice(&x);
        position[1][at.clone()].copy_from_slice(&y);
        position[2][at.clone()].copy_from_slice(&z);
        parts.magnitude[at.clone()].copy_from_slice(&magnitude);
        let [x, y, z, flags] = transposed(four.map(|s| s.normal.extend(f32::from_bits(s.flags))));
        parts.normal[0][at.clone()].copy_from_slice(&x);
        parts.normal[1][at.clone()].copy_from_slice(&y);
        parts.normal[2][at.clone()].copy_from_slice(&z);
        parts.flags[at].copy_from_slice(&flags.map(f32::to_bits));
    }
    Kept { head: Head::of(&position, &parts.normal, &parts.flags), position, parts }
}

impl SampleRows {
    /// Samples in tile order as pieces; the last one is filled up with samples that show nothing.
    pub fn of(samples: &[Sample]) -> Self {
        let (pieces, rest) = samples.as_chunks::<PIECE>();
        let mut last = [Sample::default(); PIECE];
        last[..rest.len()].copy_from_slice(rest);
        let last = (!rest.is_empty()).then_some(&last);
        let mut rows = Self::default();
        for piece in pieces.iter().chain(last) {
            let Kept { head, position, parts } = rows_of(piece);
            rows.heads.push(head);
            rows.positions.push(position);
            rows.parts.push(parts);
        }
        rows
    }

    /// All of them.
    #[inline]
    pub fn pieces(&self) -> Pieces<'_> {
        Pieces { heads: &self.heads, positions: &self.positions, parts: &self.parts }
    }
}

impl<'a> Pieces<'a> {
    /// Samples of a piece.
    pub const SAMPLES: usize = PIECE;

    /// How many pieces.
    #[inline]
    pub fn len(self) -> usize {
        self.positions.len()
    }

    /// Whether there is none.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.positions.is_empty()
    }

    /// Some of them.
    #[inline]
    pub(super) fn range(self, pieces: Range<usize>) -> Self {
        Self {
            heads: &self.heads[pieces.clone()],
            positions: &self.positions[pieces.clone()],
            parts: &self.parts[pieces],
        }
    }

    #[inline(always)]
    pub(super) fn piece(self, i: usize) -> Piece<'a> {
        Piece { head: &self.heads[i], position: &self.positions[i], parts: &self.parts[i] }
    }

    #[inline(always)]
    pub(super) fn iter(self) -> impl ExactSizeIterator<Item = Piece<'a>> {
        let all = self.heads.iter().zip(self.positions).zip(self.parts);
        all.map(|((head, position), parts)| Piece { head, position, parts })
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
        self.position
    }

    /// Has the processor fetch what only rays read.
    #[inline(always)]
    pub(super) fn prefetch(self) {
        prefetch(&self.parts.magnitude);
    }

    /// One of them, as shadows know it: what shading alone asks for is 0.
    #[inline(always)]
    pub(super) fn sample(self, i: usize) -> Sample {
        Sample {
            position: vector(self.position, i),
            magnitude: self.parts.magnitude[i],
            normal: self.head.normal(i).map_or_else(|| vector(&self.parts.normal, i), Vec3::from),
            flags: self.parts.flags[i],
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
        let [x, y, z] = &self.parts.normal;
        std::array::from_fn(|i| (x[i] != 0.0) | (y[i] != 0.0) | (z[i] != 0.0))
    }

    /// [`lt_shaders::evaluate::settle`]: who is not settled, and who is lit; the others are blocked.
    #[inline(always)]
    pub(super) fn facing(self, light: &LightParams) -> Facing {
        let [lx, ly, lz, lw] = light.place.to_array();
        if lw == 0.0
            && let Some(facing) = self.head.facing([lx, ly, lz])
        {
            return facing;
        }
        let [x, y, z] = self.position;
        let Parts { normal: [nx, ny, nz], flags, .. } = self.parts;
        let [ax, ay, az] = light.axis.to_array();
        let (mut is_reached, mut receives) = ([0; PIECE], [0; PIECE]);
        for i in 0..PIECE {
            let is_valid = (nx[i] != 0.0) | (ny[i] != 0.0) | (nz[i] != 0.0);
            let (tx, ty, tz) = (lx - x[i] * lw, ly - y[i] * lw, lz - z[i] * lw);
            let facing = nx[i] * tx + ny[i] * ty + nz[i] * tz;
            let squared = tx * tx + ty * ty + tz * tz;
            let along = -(tx * ax + ty * ay + tz * az);
            let reaches = (lw == 0.0)
                | ((squared <= light.range_squared) & (along >= light.cos_outer * squared.sqrt()));
            is_reached[i] = u8::from(is_valid & (facing > 0.0) & reaches);
            receives[i] = u8::from(flags[i] & Sample::RECEIVES != 0);
        }
        let (reached, receives) = (pack(&is_reached), pack(&receives));
        Facing { open: reached & receives, lit: reached & !receives }
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
        let Kept { head, position, parts } = keep(first, &mut looks);
        let piece = Piece { head: &head, position: &position, parts: &parts };
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
        let mut tally = [0; 3];
        for (all, one) in kinds.into_iter().flatten() {
            let mut samples = [all; PIECE];
            samples[37] = one;
            for (i, sample) in samples.iter_mut().enumerate() {
                sample.position.x += 0.01 * i as f32;
            }
            let rows = SampleRows::of(&samples);
            for light in [sun(0.2, 1.0, 0.1), sun(-0.2, -1.0, 0.3), sun(0.0, 0.0, 1.0), lamp] {
                let facing = rows.pieces().piece(0).facing(&light);
                for (i, sample) in samples.iter().enumerate() {
                    let (verdict, is_settled) = lt_shaders::evaluate::settle(sample, &light);
                    let [open, lit] = [facing.open, facing.lit].map(|bits| bits >> i & 1 != 0);
                    let expected = (!is_settled, is_settled && verdict.visibility > 0.0);
                    assert_eq!((open, lit), expected, "{sample:?} {light:?}");
                    tally[usize::from(lit) + 2 * usize::from(open)] += 1;
                }
            }
        }
        assert!(tally.iter().all(|&n| n > 100), "{tally:?}");
    }
}
