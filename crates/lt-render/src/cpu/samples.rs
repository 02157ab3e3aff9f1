//! What the camera sees, as the passes of lights read it: pieces of eight by eight samples, each part in a row of its own.
//!
//! A light asks for 28 of a sample's 48 bytes, and for 4 more where it traces a ray; what shading alone asks for lies apart. So a
//! pass reads little more than half of the memory, and finds it as its vectors want it.

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

/// A piece's samples but for what shading alone asks for; the parts are those of [`Sample`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct SampleRows {
    pub(super) position: Points,
    pub(super) normal: Points,
    pub(super) flags: [u32; PIECE],
    magnitude: Lanes,
}

/// The part of a [`Sample`] that shading alone asks for.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(super) struct Look {
    shading_normal: Vec3,
    albedo: u32,
}

/// The sample at a place in tile order, as shadows know it.
#[inline]
pub(super) fn sample_at(rows: &[SampleRows], i: usize) -> Sample {
    rows[i / PIECE].sample(i % PIECE)
}

/// A piece's samples, part by part.
pub(super) fn keep(samples: &[Sample; PIECE], looks: &mut [Look]) -> SampleRows {
    for (look, sample) in looks.iter_mut().zip(samples) {
        *look = Look { shading_normal: sample.shading_normal, albedo: sample.albedo };
    }
    SampleRows::of_piece(samples)
}

impl SampleRows {
    /// Samples in tile order as pieces; the last one is filled up with samples that show nothing.
    pub fn of(samples: &[Sample]) -> Vec<Self> {
        let (pieces, rest) = samples.as_chunks::<PIECE>();
        let mut last = [Sample::default(); PIECE];
        last[..rest.len()].copy_from_slice(rest);
        let last = (!rest.is_empty()).then_some(&last);
        pieces.iter().chain(last).map(Self::of_piece).collect()
    }

    /// By four samples at a time, whose vectors are transposed in registers: left alone, compilers make seven gathers.
    #[inline(always)]
    pub(super) fn of_piece(samples: &[Sample; PIECE]) -> Self {
        let mut rows = Self::zeroed();
        for (group, four) in samples.as_chunks::<4>().0.iter().enumerate() {
            let at = 4 * group..4 * group + 4;
            let [x, y, z, magnitude] = transposed(four.map(|s| s.position.extend(s.magnitude)));
            rows.position[0][at.clone()].copy_from_slice(&x);
            rows.position[1][at.clone()].copy_from_slice(&y);
            rows.position[2][at.clone()].copy_from_slice(&z);
            rows.magnitude[at.clone()].copy_from_slice(&magnitude);
            let [x, y, z, flags] = transposed(four.map(|s| s.normal.extend(f32::from_bits(s.flags))));
            rows.normal[0][at.clone()].copy_from_slice(&x);
            rows.normal[1][at.clone()].copy_from_slice(&y);
            rows.normal[2][at.clone()].copy_from_slice(&z);
            rows.flags[at].copy_from_slice(&flags.map(f32::to_bits));
        }
        rows
    }

    /// One of them, as shadows know it: what shading alone asks for is 0.
    #[inline]
    pub fn sample(&self, i: usize) -> Sample {
        let of = |rows: &Points| Vec3::new(rows[0][i], rows[1][i], rows[2][i]);
        Sample {
            position: of(&self.position),
            magnitude: self.magnitude[i],
            normal: of(&self.normal),
            flags: self.flags[i],
            ..Sample::default()
        }
    }

    /// The same with what shading asks for.
    pub(super) fn shaded_sample(&self, i: usize, look: &Look) -> Sample {
        Sample { shading_normal: look.shading_normal, albedo: look.albedo, ..self.sample(i) }
    }

    /// [`lt_shaders::evaluate::settle`]: `BLOCKED`, `LIT`, or `MAPPED` if that settles nothing.
    #[inline(always)]
    pub(super) fn settle(&self, light: &LightParams) -> [u32; PIECE] {
        let [x, y, z] = &self.position;
        let [nx, ny, nz] = &self.normal;
        let [lx, ly, lz, lw] = light.place.to_array();
        let [ax, ay, az] = light.axis.to_array();
        let mut states = [BLOCKED; PIECE];
        // Of what is turned away from the sun wherever it may be, the rest is not read.
        let turned = |i: usize| nx[i] * lx + ny[i] * ly + nz[i] * lz;
        if lw == 0.0 && !(0..PIECE).fold(false, |any, i| any | (turned(i) > 0.0)) {
            return states;
        }
        for i in 0..PIECE {
            let is_valid = (nx[i] != 0.0) | (ny[i] != 0.0) | (nz[i] != 0.0);
            let (tx, ty, tz) = (lx - x[i] * lw, ly - y[i] * lw, lz - z[i] * lw);
            let facing = nx[i] * tx + ny[i] * ty + nz[i] * tz;
            let squared = tx * tx + ty * ty + tz * tz;
            let along = -(tx * ax + ty * ay + tz * az);
            let reaches = (lw == 0.0)
                | ((squared <= light.range_squared) & (along >= light.cos_outer * squared.sqrt()));
            let open = if self.flags[i] & Sample::RECEIVES == 0 { LIT } else { MAPPED };
            states[i] = if is_valid & (facing > 0.0) & reaches { open } else { BLOCKED };
        }
        states
    }
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
        let pieces = SampleRows::of(&samples);
        assert_eq!(pieces.len(), 2);
        for i in 0..2 * PIECE {
            let expected = samples.get(i).copied().unwrap_or_default();
            let shadows = Sample { shading_normal: Vec3::ZERO, albedo: 0, ..expected };
            assert_eq!(pieces[i / PIECE].sample(i % PIECE), shadows, "{i}");
        }
        let first: &[Sample; PIECE] = samples.first_chunk().expect("a piece");
        let mut looks = [Look::default(); PIECE];
        let rows = keep(first, &mut looks);
        assert!((0..PIECE).all(|i| rows.shaded_sample(i, &looks[i]) == samples[i]));
    }
}
