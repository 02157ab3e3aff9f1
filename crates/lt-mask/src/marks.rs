//! What rays found out about a map, kept in the map: texels on whose footprint it was wrong.
//!
//! The mask remembers pixels, and looks for them where motion led them; what it learnt is lost where nobody looks for it. But a map that is
//! kept errs in the same places in every frame: where a caster fell between its texels. So a ray that contradicts a test that was sure of itself
//! *marks* the texels that the test read, with what it had said wrongly, and from then on no test is sure that reads one of them and says
//! the same. Marks are as old as the map: whoever draws it anew begins without any. Not in the paper.

use lt_math::glam::IVec2;

/// What a ray found wrong about a texel, two bits.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TexelMarks(u32);

impl TexelMarks {
    /// How many bits a texel takes.
    pub const BIT_COUNT: u32 = 2;
    /// Texels in a word of 32 bits.
    pub const PER_WORD: u32 = u32::BITS / Self::BIT_COUNT;
    /// Nothing.
    pub const NONE: Self = Self(0);
    /// A test said lit, and a ray was blocked.
    pub const LIT: Self = Self(1);
    /// A test said shadowed, and a ray met nothing.
    pub const SHADOWED: Self = Self(2);

    /// What a test that said this was wrong about.
    #[inline]
    pub fn against(is_test_shadowed: bool) -> Self {
        if is_test_shadowed { Self::SHADOWED } else { Self::LIT }
    }

    /// Reads the low two bits.
    #[inline]
    pub fn from_bits(bits: u32) -> Self {
        Self(bits & 3)
    }

    /// The two bits, in the low end.
    #[inline]
    pub fn to_bits(self) -> u32 {
        self.0
    }

    /// What either has found.
    #[inline]
    pub fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether a test that says this has been wrong here.
    #[inline]
    pub fn contradict(self, is_test_shadowed: bool) -> bool {
        self.0 & Self::against(is_test_shadowed).0 != 0
    }
}

/// Where a texel's marks lie among the words of maps that follow one another, row by row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MarksPlace {
    /// The word.
    pub word: u32,
    /// The lower of the two bits in it.
    pub shift: u32,
}

impl MarksPlace {
    /// Of the texel that is nearest to `texel` on map number `level` of maps of `map_size`² texels; `map_size` is a multiple of 16.
    #[inline]
    pub fn of(texel: IVec2, map_size: u32, level: u32) -> Self {
        let last = map_size as i32 - 1;
        let at = texel.clamp(IVec2::ZERO, IVec2::splat(last)).as_uvec2();
        let words = map_size / TexelMarks::PER_WORD;
        Self {
            word: (level * map_size + at.y) * words + at.x / TexelMarks::PER_WORD,
            shift: at.x % TexelMarks::PER_WORD * TexelMarks::BIT_COUNT,
        }
    }

    /// The four of a footprint whose upper left texel this is.
    #[inline]
    pub fn of_footprint(texel: IVec2, map_size: u32, level: u32) -> [Self; 4] {
        [
            Self::of(texel, map_size, level),
            Self::of(texel + IVec2::X, map_size, level),
            Self::of(texel + IVec2::Y, map_size, level),
            Self::of(texel + IVec2::ONE, map_size, level),
        ]
    }

    /// The marks in a word.
    #[inline]
    pub fn read(self, word: u32) -> TexelMarks {
        TexelMarks::from_bits(word >> self.shift)
    }

    /// The bits of a word that marks take.
    #[inline]
    pub fn bits(self, marks: TexelMarks) -> u32 {
        marks.to_bits() << self.shift
    }
}

/// Words that hold the marks of so many texels, a multiple of 16.
#[inline]
pub const fn marks_words(texels: u64) -> u64 {
    texels / TexelMarks::PER_WORD as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec;

    #[test]
    fn a_mark_speaks_against_what_was_said_wrongly_and_nothing_else() {
        for said in [false, true] {
            let marks = TexelMarks::against(said);
            assert!(marks.contradict(said) && !marks.contradict(!said));
            assert!(!TexelMarks::NONE.contradict(said));
            assert!(marks.and(TexelMarks::against(!said)).contradict(said), "what was known stays known");
            assert_eq!(TexelMarks::from_bits(marks.to_bits() | 4), marks);
        }
    }

    #[test]
    fn every_texel_has_its_own_two_bits_and_places_beyond_the_edge_are_those_on_it() {
        let (size, levels) = (32, 3);
        let texels = u64::from(size * size * levels);
        let mut words = vec![0u32; marks_words(texels) as usize];
        for level in 0..levels {
            for y in 0..size as i32 {
                for x in 0..size as i32 {
                    let place = MarksPlace::of(IVec2::new(x, y), size, level);
                    let bits = place.bits(TexelMarks::LIT.and(TexelMarks::SHADOWED));
                    assert_eq!(words[place.word as usize] & bits, 0, "{level} {x} {y}");
                    words[place.word as usize] |= bits;
                }
            }
        }
        assert!(words.iter().all(|word| *word == !0));
        let at = |x, y| MarksPlace::of(IVec2::new(x, y), size, 1);
        assert_eq!(MarksPlace::of_footprint(IVec2::new(-1, 31), size, 1), [at(0, 31); 4]);
        assert_eq!(
            MarksPlace::of_footprint(IVec2::new(4, 5), size, 1),
            [at(4, 5), at(5, 5), at(4, 6), at(5, 6)]
        );
    }
}
