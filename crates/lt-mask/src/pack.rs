//! Up to 42 lights' histories in one 128-bit texel, three bits each, lights straddling words (Kern et al. 2024, §6).

use crate::bits::MaskBits;
use lt_math::glam::UVec4;

/// How many lights fit 128 bits.
pub const MAX_LIGHTS: u32 = 128 / MaskBits::BIT_COUNT;

/// How many 32-bit words the histories of `light_count` lights take; 1 … 4 for 1 … 42 lights.
#[inline]
pub const fn words_for_lights(light_count: u32) -> u32 {
    (light_count * MaskBits::BIT_COUNT).div_ceil(32)
}

/// The histories of up to [`MAX_LIGHTS`] lights at one pixel. Light i lies in bits 3i … 3i + 2, word x first.
///
/// With fewer lights, only the first [`words_for_lights`] words need storing; the others stay 0.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackedMask(pub UVec4);

impl PackedMask {
    /// The history of light `light`; [`MaskBits::BLACK`] from 42 on.
    #[inline]
    pub fn light(self, light: u32) -> MaskBits {
        if light >= MAX_LIGHTS {
            return MaskBits::BLACK;
        }
        let place = LightPlace::of(light);
        let next = if place.straddles() { self.word(place.word + 1) } else { 0 };
        place.read(self.word(place.word), next)
    }

    /// The same histories with that of light `light` replaced; unchanged from 42 on.
    #[inline]
    pub fn with_light(self, light: u32, mask: MaskBits) -> Self {
        if light >= MAX_LIGHTS {
            return self;
        }
        let place = LightPlace::of(light);
        let packed = self.with_word(place.word, place.write(self.word(place.word), mask));
        if !place.straddles() {
            return packed;
        }
        packed.with_word(place.word + 1, place.write_rest(self.word(place.word + 1), mask))
    }

    /// Word 0 … 3, by comparison rather than by index: shaders then need no bounds check.
    #[inline]
    fn word(self, index: u32) -> u32 {
        match index {
            0 => self.0.x,
            1 => self.0.y,
            2 => self.0.z,
            _ => self.0.w,
        }
    }

    #[inline]
    fn with_word(self, index: u32, value: u32) -> Self {
        let v = self.0;
        Self(match index {
            0 => UVec4::new(value, v.y, v.z, v.w),
            1 => UVec4::new(v.x, value, v.z, v.w),
            2 => UVec4::new(v.x, v.y, value, v.w),
            _ => UVec4::new(v.x, v.y, v.z, value),
        })
    }
}

/// Where the history of one light lies among a pixel's words, for those who store words rather than texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightPlace {
    /// The word of its lowest bit.
    pub word: u32,
    /// How far up in that word its lowest bit lies, 0 … 31.
    shift: u32,
}

impl LightPlace {
    /// The place of light `light`, below [`MAX_LIGHTS`].
    #[inline]
    pub fn of(light: u32) -> Self {
        let bit = light * MaskBits::BIT_COUNT;
        Self { word: bit / 32, shift: bit % 32 }
    }

    /// Whether it goes on in the next word.
    #[inline]
    pub fn straddles(self) -> bool {
        self.shift > 32 - MaskBits::BIT_COUNT
    }

    /// The history in `word` and, where it [`LightPlace::straddles`], in `next`, which is ignored otherwise.
    #[inline]
    pub fn read(self, word: u32, next: u32) -> MaskBits {
        let mut bits = word >> self.shift;
        if self.straddles() {
            bits |= next << (32 - self.shift);
        }
        MaskBits::from_bits(bits)
    }

    /// `word` with the history put into it, as far as it lies there.
    #[inline]
    pub fn write(self, word: u32, mask: MaskBits) -> u32 {
        word & !(MaskBits::ALL << self.shift) | mask.to_bits() << self.shift
    }

    /// The next word with the rest of the history; only where it [`LightPlace::straddles`].
    #[inline]
    pub fn write_rest(self, next: u32, mask: MaskBits) -> u32 {
        let rest = 32 - self.shift;
        next & !(MaskBits::ALL >> rest) | mask.to_bits() >> rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_mask() -> impl Strategy<Value = MaskBits> {
        (0u32..8).prop_map(MaskBits::from_bits)
    }

    /// The 128 bits as one integer: the layout that the type's documentation promises.
    fn wide(packed: PackedMask) -> u128 {
        let [x, y, z, w] = packed.0.to_array().map(u128::from);
        x | y << 32 | z << 64 | w << 96
    }

    proptest! {
        #[test]
        fn every_light_reads_back_what_was_written(masks in prop::collection::vec(any_mask(), 42)) {
            let mut packed = PackedMask::default();
            let mut expected = 0u128;
            for (i, &mask) in masks.iter().enumerate() {
                packed = packed.with_light(i as u32, mask);
                expected |= u128::from(mask.to_bits()) << (3 * i);
            }
            prop_assert_eq!(wide(packed), expected);
            for (i, &mask) in masks.iter().enumerate() {
                prop_assert_eq!(packed.light(i as u32), mask);
            }
        }

        #[test]
        fn writing_one_light_leaves_the_others(
            words in any::<[u32; 4]>(), light in 0u32..42, mask in any_mask()
        ) {
            let before = PackedMask(UVec4::from_array(words));
            let after = before.with_light(light, mask);
            let cleared = !(7u128 << (3 * light));
            prop_assert_eq!(wide(after) & cleared, wide(before) & cleared);
            prop_assert_eq!(after.light(light), mask);
        }

        #[test]
        fn lights_beyond_the_last_are_black_and_ignored(
            words in any::<[u32; 4]>(), light in 42u32.., mask in any_mask()
        ) {
            let packed = PackedMask(UVec4::from_array(words));
            prop_assert_eq!(packed.with_light(light, mask), packed);
            prop_assert_eq!(packed.light(light), MaskBits::BLACK);
        }
    }

    #[test]
    fn the_straddling_lights_are_10_and_21_but_not_the_aligned_32() {
        let straddles = |light: u32| LightPlace::of(light).straddles();
        assert_eq!((0..42).filter(|&l| straddles(l)).collect::<std::vec::Vec<_>>(), [10, 21]);
        assert_eq!(LightPlace::of(32), LightPlace { word: 3, shift: 0 });
        for light in [10, 21] {
            for state in [MaskBits::GREEN, MaskBits::WHITE, MaskBits::PURPLE, MaskBits::RED, MaskBits::YELLOW]
            {
                assert_eq!(PackedMask(UVec4::MAX).with_light(light, state).light(light), state);
                assert_eq!(PackedMask::default().with_light(light, state).light(light), state);
            }
        }
    }

    #[test]
    fn word_counts() {
        assert_eq!(MAX_LIGHTS, 42);
        let expected = [(0, 0), (1, 1), (10, 1), (11, 2), (21, 2), (22, 3), (32, 3), (33, 4), (42, 4)];
        for (lights, words) in expected {
            assert_eq!(words_for_lights(lights), words, "{lights}");
        }
    }
}
