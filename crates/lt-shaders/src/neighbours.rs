//! What a pixel's neighbourhood in the last frame asks for, for all pixels at once, before the mask pass.
//!
//! Two passes, one invocation for every 32 pixels of a row: [`row`] turns their histories into words and asks what contradicts,
//! [`hear`] joins the words around. What the mask then reads of 24 neighbours is one bit ([`Heard`]).

use lt_mask::{Expansion, MaskBits, MaskRow, Offsets, Window, repeat_from};
use lt_math::glam::{UVec2, UVec4};

use crate::{
    abi::MaskParams,
    mask::{BitsPlace, HistorySource},
};

/// How many [`MaskRow`]s a picture's row takes.
#[inline]
pub const fn row_words(width: u32) -> u32 {
    width.div_ceil(MaskRow::PIXELS)
}

/// Words that [`hear`] leaves for each [`MaskRow`]: four that ask ([`asking_word`]), then the traced pixels and those whose ray hit.
pub const HEARD_WORDS: u32 = 6;

/// Which of the words asks for pixels that are shadowed by the test, and for those that have moved and so ask by the other
/// pattern.
#[inline]
pub fn asking_word(is_test_shadowed: bool, has_moved: bool) -> u32 {
    u32::from(is_test_shadowed) | u32::from(has_moved) << 1
}

/// The last frame's histories at 32 pixels, `at.x` of [`row_words`], row `at.y`: those that contradict *lit*, those that contradict
/// *shadowed*, the traced and the hit. Beyond the picture's right edge stands what stands there.
///
/// `bits` are the words of [`BitsPlace`]; `at` is inside the picture.
pub fn row(at: UVec2, bits: &[u32], p: &MaskParams) -> UVec4 {
    let place = BitsPlace::of(&p.light);
    let size = p.current.size;
    let x = at.x * MaskRow::PIXELS;
    let count = (size.x - x).min(MaskRow::PIXELS);
    let mut row = MaskRow::default();
    let mut column = 0;
    while column < count {
        row = row.with(column, place.read(bits, at.y * size.x + x + column));
        column += 1;
    }
    let expansion = Expansion::from_index(p.expansion);
    let contradicting = |st: bool| repeat_from(row.contradicting(expansion, st), count - 1);
    UVec4::new(contradicting(false), contradicting(true), row.traced, row.hit)
}

/// What the pixels around those of [`row`] ask for, in the order of [`asking_word`].
///
/// `rows` is what [`row`] gave, [`row_words`] to a row of pixels; `at` is inside the picture, beyond whose edge stands what is on the
/// edge.
pub fn hear(at: UVec2, rows: &[UVec4], p: &MaskParams) -> UVec4 {
    const REACH: u32 = Offsets::REACH;
    let (columns, last_y) = (row_words(p.current.size.x), p.current.size.y - 1);
    let mut lit = Window::<5>::EMPTY;
    let mut shadowed = Window::<5>::EMPTY;
    let mut i = 0;
    while i <= 2 * REACH {
        let y = (at.y + i).max(REACH) - REACH;
        let y = y.min(last_y);
        let start = y * columns;
        let own = rows[(start + at.x) as usize];
        // At an edge the row beside is its own, whose outermost pixel stands for all.
        let left = rows[(start + at.x.max(1) - 1) as usize];
        let right = rows[(start + (at.x + 1).min(columns - 1)) as usize];
        let (is_first, is_last) = (at.x == 0, at.x + 1 == columns);
        lit.put(i as usize, before(left.x, is_first), own.x, after(right.x, is_last));
        shadowed.put(i as usize, before(left.y, is_first), own.y, after(right.y, is_last));
        i += 1;
    }
    let (still, moving) = (Offsets(p.still), Offsets(p.moving));
    let [still_lit]: [u32; 1] = lit.any(at.y, still);
    let [still_shadowed]: [u32; 1] = shadowed.any(at.y, still);
    if still == moving {
        return UVec4::new(still_lit, still_shadowed, still_lit, still_shadowed);
    }
    let [moving_lit]: [u32; 1] = lit.any(at.y, moving);
    let [moving_shadowed]: [u32; 1] = shadowed.any(at.y, moving);
    UVec4::new(still_lit, still_shadowed, moving_lit, moving_shadowed)
}

/// The word to the left of a row of pixels: beyond the picture, all of it is the row's own first pixel.
#[inline]
fn before(left: u32, is_beyond: bool) -> u32 {
    if is_beyond { repeat_from(left, 0) } else { left }
}

/// The word to the right: beyond the picture, all of it is the row's own last pixel.
#[inline]
fn after(right: u32, is_beyond: bool) -> u32 {
    if is_beyond { repeat_from(right >> 31, 0) } else { right }
}

/// Leaves what [`hear`] found for the mask pass: [`HEARD_WORDS`] for each element of `rows`.
#[inline]
pub fn keep(at: UVec2, asking: UVec4, rows: &[UVec4], p: &MaskParams, words: &mut [u32]) {
    let index = at.y * row_words(p.current.size.x) + at.x;
    let row = rows[index as usize];
    let first = (index * HEARD_WORDS) as usize;
    words[first] = asking.x;
    words[first + 1] = asking.y;
    words[first + 2] = asking.z;
    words[first + 3] = asking.w;
    words[first + 4] = row.z;
    words[first + 5] = row.w;
}

/// Both passes over a whole picture: `rows` takes [`row_words`] elements for each row of pixels, `words` [`HEARD_WORDS`] times as many.
pub fn hear_all(bits: &[u32], p: &MaskParams, rows: &mut [UVec4], words: &mut [u32]) {
    let columns = row_words(p.current.size.x);
    let count = columns * p.current.size.y;
    for i in 0..count {
        rows[i as usize] = row(UVec2::new(i % columns, i / columns), bits, p);
    }
    for i in 0..count {
        let at = UVec2::new(i % columns, i / columns);
        keep(at, hear(at, rows, p), rows, p, words);
    }
}

/// The last frame as the mask pass reads it.
#[derive(Clone, Copy)]
pub struct Heard<'a> {
    /// What [`keep`] left.
    pub words: &'a [u32],
    /// [`row_words`] of the picture.
    pub columns: u32,
}

impl Heard<'_> {
    /// Bit `pixel.x` % 32 of word `word` of the row that holds `pixel`.
    #[inline]
    fn has(self, pixel: UVec2, word: u32) -> bool {
        let row = pixel.y * self.columns + pixel.x / MaskRow::PIXELS;
        self.words[(row * HEARD_WORDS + word) as usize] >> (pixel.x % MaskRow::PIXELS) & 1 != 0
    }
}

impl HistorySource for Heard<'_> {
    #[inline]
    fn asks(&self, pixel: UVec2, is_test_shadowed: bool, has_moved: bool) -> bool {
        self.has(pixel, asking_word(is_test_shadowed, has_moved))
    }
    #[inline]
    fn ray(&self, pixel: UVec2) -> MaskBits {
        if self.has(pixel, 4) { MaskBits::traced(false, self.has(pixel, 5)) } else { MaskBits::BLACK }
    }
    #[inline]
    fn depth(&self, _pixel: UVec2) -> f32 {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use lt_mask::{Neighbourhood, PackedMask, Pattern};
    use std::vec;
    use std::vec::Vec;

    /// All patterns, frames and sizes that fill words, leave one pixel in a word, or are one pixel in all; random states; lights that
    /// straddle words.
    #[test]
    fn what_is_heard_is_the_neighbourhood() {
        let mut state = 5u32;
        let mut next = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 8
        };
        let sizes = [UVec2::new(64, 5), UVec2::new(33, 9), UVec2::new(40, 2), UVec2::ONE, UVec2::new(97, 1)];
        for (size, light, lights) in sizes.into_iter().zip([0, 10, 21, 3, 41]).map(|(s, l)| (s, l, l + 1)) {
            let words = lt_mask::words_for_lights(lights);
            // Regions that agree, with rare contradictions: with many of them, every neighbourhood asks.
            let masks: Vec<MaskBits> = (0..size.element_product())
                .map(|i| match next() % 24 {
                    0 => MaskBits::from_bits(next()),
                    _ => MaskBits::untraced(i / 50 % 2 == 0),
                })
                .collect();
            let mut bits: Vec<u32> = Vec::new();
            for mask in &masks {
                let packed = PackedMask::default().with_light(light, *mask);
                bits.extend(&packed.0.to_array()[..words as usize]);
            }
            let mut p = MaskParams::zeroed();
            p.current.size = size;
            (p.light.number, p.light.mask_words) = (light, words);
            let columns = row_words(size.x);
            let mut rows = vec![UVec4::ZERO; (columns * size.y) as usize];
            let mut words = vec![0; rows.len() * HEARD_WORDS as usize];
            for (pattern, rule) in Pattern::ALL.into_iter().flat_map(|p| Expansion::ALL.map(|e| (p, e))) {
                for frame in 0..4 {
                    p.expansion = rule.to_index();
                    (p.still, p.moving) =
                        (Offsets::of(pattern, frame).0, Offsets::of(Pattern::PLUS, frame).0);
                    hear_all(&bits, &p, &mut rows, &mut words);
                    let heard = Heard { words: &words, columns };
                    for i in 0..size.element_product() {
                        let pixel = UVec2::new(i % size.x, i / size.x);
                        let own = masks[i as usize];
                        assert_eq!(heard.ray(pixel).is_traced(), own.is_traced());
                        assert_eq!(heard.ray(pixel).is_ray_hit(), own.is_ray_hit());
                        for st in [false, true] {
                            for (moved, pattern) in [(false, pattern), (true, Pattern::PLUS)] {
                                let said = (0..pattern.neighbour_count())
                                    .map(|i| pattern.neighbour(i, pixel, frame, size))
                                    .map(|n| masks[(n.y * size.x + n.x) as usize])
                                    .fold(Neighbourhood::EMPTY, |all, bits| all.with(bits, st, rule));
                                let asks = heard.asks(pixel, st, moved);
                                assert_eq!(asks, said.any_expands, "{size} {pattern:?} {frame} {pixel} {st}");
                                assert!(rule != Expansion::PUBLISHED || said.all_remove != asks);
                            }
                        }
                    }
                }
            }
        }
    }
}
