//! The doubt list: which pixels a ray must answer, compacted on the GPU.
//!
//! Layout in words: three workgroup counts for the indirect dispatch, the number of listed pixels, then the pixels'
//! indices ([`Listed`]) in no particular order. The CPU backend collects the same pixels tile by tile instead.

use lt_math::glam::{UVec2, UVec3};

/// First word of the list proper.
pub const LIST_START: u32 = 4;
/// Word that counts the listed pixels.
pub const COUNT: usize = 3;
/// Pixels one workgroup of the resolve pass takes.
pub const RESOLVE_WORKGROUP: u32 = 64;

/// A word of the list proper: a pixel that needs a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listed {
    /// The pixel's index, below 2³¹.
    pub pixel: u32,
    /// The test was sure of itself; the mask pass asks for a ray all the same.
    pub is_trusted: bool,
}

impl Listed {
    const TRUSTED: u32 = 1 << 31;

    /// Reads a word.
    #[inline]
    pub fn from_word(word: u32) -> Self {
        Self { pixel: word & !Self::TRUSTED, is_trusted: word & Self::TRUSTED != 0 }
    }

    /// The word.
    #[inline]
    pub fn to_word(self) -> u32 {
        if self.is_trusted { self.pixel | Self::TRUSTED } else { self.pixel }
    }
}

/// Words of a list that can hold every pixel.
#[inline]
pub const fn list_words(pixels: u32) -> u32 {
    LIST_START + pixels
}

/// Workgroups along x at most: every API allows 65535, and a 4K picture may need more in all.
pub const MAX_WORKGROUPS_X: u32 = 32768;

/// Workgroups along x and y that cover `count` listed pixels.
#[inline]
pub fn workgroups_for(count: u32) -> UVec2 {
    let total = count.div_ceil(RESOLVE_WORKGROUP);
    UVec2::new(total.min(MAX_WORKGROUPS_X), total.div_ceil(MAX_WORKGROUPS_X))
}

/// Which listed pixel an invocation takes.
#[inline]
pub fn slot_of(id: UVec3) -> u32 {
    id.y * (MAX_WORKGROUPS_X * RESOLVE_WORKGROUP) + id.x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_holds_a_pixel_and_whether_it_was_trusted() {
        for pixel in [0, 1, 8_294_399, (1 << 31) - 1] {
            for is_trusted in [false, true] {
                let listed = Listed { pixel, is_trusted };
                assert_eq!(Listed::from_word(listed.to_word()), listed);
            }
        }
    }

    #[test]
    fn the_dispatch_covers_every_listed_pixel() {
        for count in [0, 1, 64, 65, 2_097_152, 2_097_153, 8_294_400, 268_435_456] {
            let groups = workgroups_for(count);
            assert!(groups.x <= MAX_WORKGROUPS_X);
            assert!(u64::from(groups.x) * u64::from(groups.y) * 64 >= u64::from(count));
            if groups.y > 1 {
                assert_eq!(groups.x, MAX_WORKGROUPS_X, "rows must be full: slots count on it");
            }
        }
    }
}
