//! Marks on the CPU's maps: depths in [0, 1] leave the two highest bits of a float unused, and a texel's marks lie there, so that they come
//! with what is read anyway.
//!
//! Maps that techniques without marks read have none. Drawing a map whole removes them, as whole depths are written.

use lt_mask::TexelMarks;
use lt_math::glam::Vec4;
use lt_math::{Levels, OneLevel};
use lt_shaders::abi::{Sample, ShadowParams};
use lt_shaders::marks::stain;

use super::bits::places;
use super::estimator::LightMaps;
use super::history::Memory;
use super::map_tiles;
use super::samples::Pieces;
use super::tiles::{PIECE, PIECES};

/// The bits of a texel that are its depth.
pub const DEPTH_BITS: u32 = 0x3fff_ffff;
/// Where its marks begin.
const SHIFT: u32 = 30;

/// The depth of a texel that may have marks.
#[inline(always)]
pub fn depth(texel: f32) -> f32 {
    f32::from_bits(texel.to_bits() & DEPTH_BITS)
}

/// Puts the marks of other texels on those of a map, place by place.
pub fn copy_marks(from: &[f32], to: &mut [f32]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = f32::from_bits(to.to_bits() | from.to_bits() & !DEPTH_BITS);
    }
}

/// Whether a test that said lit, and one that said shadowed, was wrong about the texels whose words were joined.
#[inline(always)]
pub fn wrong(joined: u32) -> [bool; 2] {
    let marks = TexelMarks::from_bits(joined >> SHIFT);
    [marks.contradict(false), marks.contradict(true)]
}

/// A texel to be marked once the frame is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stained {
    /// Its place in maps that follow one another.
    pub texel: usize,
    marks: TexelMarks,
}

impl Stained {
    /// A texel about which a test was wrong that said this.
    pub fn against(texel: usize, is_test_shadowed: bool) -> Self {
        Self { texel, marks: TexelMarks::against(is_test_shadowed) }
    }

    /// Marks it, in a map or in what of it stands still.
    pub fn mark(self, texel: &mut f32) {
        *texel = f32::from_bits(texel.to_bits() | self.marks.to_bits() << SHIFT);
    }
}

/// What is needed to find the texels that a test read.
#[derive(Clone, Copy)]
pub struct Stains<'a> {
    /// The maps.
    pub maps: LightMaps<'a>,
    /// See [`stain`].
    pub moving: &'a [Vec4],
}

impl Stains<'_> {
    /// The texels that a block's rays tell to mark, after it has learnt of them.
    pub fn of_block(&self, pieces: Pieces<'_>, memory: &Memory<'_>, stained: &mut Vec<Stained>) {
        for piece in 0..PIECES {
            let [shadowed, contradicted] = memory.contradicted(piece);
            for i in places(contradicted) {
                let sample = pieces.sample(piece * PIECE + i);
                self.of_sample(&sample, shadowed >> i & 1 != 0, stained);
            }
        }
    }

    fn of_sample(&self, sample: &Sample, is_test_shadowed: bool, stained: &mut Vec<Stained>) {
        let p: &ShadowParams = self.maps.p;
        let found = match self.maps.levels {
            Some(projections) => {
                stain(sample, p, Levels { projections, count: projections.len() as u32 }, self.moving)
            }
            None => stain(sample, p, OneLevel { projection: p.projection }, self.moving),
        };
        if !found.is_on_map {
            return;
        }
        let first = (found.level as usize) * (p.map_size as usize).pow(2);
        for [x, y] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            let on_map = |at: i32| at.clamp(0, p.map_size as i32 - 1) as u32;
            let at = map_tiles::index(on_map(found.texel.x + x), on_map(found.texel.y + y), p.map_size);
            let texel = first + at as usize;
            // Most that are wrong are so in every frame.
            if !wrong(self.maps.depths[texel].to_bits())[usize::from(is_test_shadowed)] {
                stained.push(Stained::against(texel, is_test_shadowed));
            }
        }
    }
}

/// The marks of maps that lie row by row, as words.
#[cfg(test)]
pub fn words(maps: &[f32], map_size: u32) -> Vec<u32> {
    use lt_mask::{MarksPlace, marks_words};
    use lt_math::glam::IVec2;
    let mut words = vec![0; marks_words(maps.len() as u64) as usize];
    let size = map_size as usize;
    for (i, texel) in maps.iter().enumerate() {
        let at = IVec2::new((i % size) as i32, (i / size % size) as i32);
        let place = MarksPlace::of(at, map_size, (i / size / size) as u32);
        words[place.word as usize] |= place.bits(TexelMarks::from_bits(texel.to_bits() >> SHIFT));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_leaves_the_depth_and_tells_what_was_wrong() {
        for depth_before in [0.0, f32::MIN_POSITIVE, 0.25, 0.999_999_9, 1.0] {
            let mut texel: f32 = depth_before;
            assert_eq!(wrong(texel.to_bits()), [false; 2]);
            for (i, said) in [(0, true), (1, false)] {
                Stained::against(0, said).mark(&mut texel);
                assert_eq!(depth(texel).to_bits(), depth_before.to_bits());
                assert_eq!(wrong(texel.to_bits()), [i > 0, true]);
            }
            let mut other = [0.5, 0.75];
            copy_marks(&[texel, 1.0], &mut other);
            assert_eq!((other.map(depth), other[1].to_bits()), ([0.5, 0.75], 0.75f32.to_bits()));
            assert_eq!(wrong(other[0].to_bits()), [true; 2]);
        }
    }
}
