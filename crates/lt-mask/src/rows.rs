//! Neighbourhoods of 32 pixels at a time: histories as rows of bits, joined by shifts.
//!
//! ER looks at a neighbour through one question: does it contradict shadow test ST? (And so does RR as published: over the
//! states that occur, eqs. 6 and 8 negate each other.) So what a pattern's neighbours say to any pixel is two bits, "anyone contradicts
//! *lit*" and "anyone contradicts *shadowed*", and either is made for 32 pixels of a row by shifting and joining words. A pixel
//! then reads one bit, wherever motion led it, in place of up to 25 neighbours.

use crate::bits::MaskBits;
use crate::decide::Expansion;
use crate::pattern::Pattern;
use lt_math::glam::UVec2;

/// The histories of 32 pixels side by side, a word for each of the three bits; bit x is the pixel at column x.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaskRow {
    /// ST: the shadow test said shadow.
    pub shadowed: u32,
    /// LTT: a ray was traced.
    pub traced: u32,
    /// RS: it hit something; 0 where none was traced.
    pub hit: u32,
}

impl MaskRow {
    /// Pixels in a row.
    pub const PIXELS: u32 = 32;

    /// The history at `column` < 32.
    #[inline]
    pub fn get(self, column: u32) -> MaskBits {
        let is_test_shadowed = self.shadowed >> column & 1 != 0;
        if self.traced >> column & 1 != 0 {
            MaskBits::traced(is_test_shadowed, self.hit >> column & 1 != 0)
        } else {
            MaskBits::untraced(is_test_shadowed)
        }
    }

    /// The same with a history put at `column` < 32, which was empty.
    #[inline]
    pub fn with(self, column: u32, mask: MaskBits) -> Self {
        Self {
            shadowed: self.shadowed | u32::from(mask.is_test_shadowed()) << column,
            traced: self.traced | u32::from(mask.is_traced()) << column,
            hit: self.hit | u32::from(mask.is_ray_hit()) << column,
        }
    }

    /// Which of the pixels contradict a shadow test: [`Expansion::asks`] of each.
    #[inline]
    pub fn contradicting(self, expansion: Expansion, is_test_shadowed: bool) -> u32 {
        let (by_ray, by_test) = if is_test_shadowed {
            (self.traced & !self.hit, !self.shadowed)
        } else {
            (self.traced & self.hit, self.shadowed)
        };
        match expansion {
            Expansion::RAYS => by_ray,
            Expansion::LEAKS => by_ray & (self.hit ^ self.shadowed),
            _ => by_ray | by_test,
        }
    }
}

/// The bits of `word` up to `column` ≤ 31, and the bit at `column` in place of all above: what stands at a picture's right edge stands
/// beyond it.
#[inline]
pub fn repeat_from(word: u32, column: u32) -> u32 {
    let above = (!1u32) << column;
    if word >> column & 1 != 0 { word | above } else { word & !above }
}

/// The neighbours of a [`Pattern`] in one frame, as two sets of places in the 5×5 around a pixel: of pixels whose x + y is even,
/// and of the others. Bit 5 (y + 2) + x + 2 is the neighbour at offset (x, y).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Offsets(pub UVec2);

impl Offsets {
    /// Farthest that any pattern looks, pixels along either axis.
    pub const REACH: u32 = 2;
    /// Side of the square that holds all offsets, pixels.
    const SIDE: u32 = 2 * Self::REACH + 1;

    /// Those of a pattern in `frame`.
    pub fn of(pattern: Pattern, frame: u32) -> Self {
        let (mut even, mut odd) = (0, 0);
        let mut i = 0;
        while i < pattern.neighbour_count() {
            even |= Self::bit(pattern, i, UVec2::ZERO, frame);
            odd |= Self::bit(pattern, i, UVec2::X, frame);
            i += 1;
        }
        Self(UVec2::new(even, odd))
    }

    fn bit(pattern: Pattern, index: u32, pixel: UVec2, frame: u32) -> u32 {
        let at = pattern.offset(index, pixel, frame) + Self::REACH as i32;
        1 << (at.y as u32 * Self::SIDE + at.x as u32)
    }
}

/// Words of one bit per pixel, `ROWS` rows below each other, with the [`Offsets::REACH`] pixels beside them: what
/// neighbourhoods are joined from.
#[derive(Clone, Copy, Debug)]
pub struct Window<const ROWS: usize> {
    /// A row's 32 pixels from the one two to the left on.
    low: [u32; ROWS],
    /// And the four that are then left over, in the low bits.
    high: [u32; ROWS],
}

impl<const ROWS: usize> Window<ROWS> {
    /// No bit set.
    pub const EMPTY: Self = Self { low: [0; ROWS], high: [0; ROWS] };

    /// Puts a row in: its own word and those to its left and right.
    #[inline]
    pub fn put(&mut self, row: usize, left: u32, own: u32, right: u32) {
        self.low[row] = own << Offsets::REACH | left >> (32 - Offsets::REACH);
        self.high[row] = own >> (32 - Offsets::REACH) | right << Offsets::REACH;
    }

    /// Whether any neighbour of each pixel of the `INNER` = `ROWS` − 4 middle rows has its bit set; the first of those is the picture's
    /// row `first_row`, and columns begin at an even one.
    #[inline]
    pub fn any<const INNER: usize>(&self, first_row: u32, offsets: Offsets) -> [u32; INNER] {
        const { assert!(ROWS == INNER + 2 * Offsets::REACH as usize) };
        let mut any = self.any_of::<INNER>(offsets.0.x);
        if offsets.0.x != offsets.0.y {
            let odd = self.any_of::<INNER>(offsets.0.y);
            let mut row = 0;
            while row < INNER {
                let evens = 0x5555_5555u32 << ((first_row + row as u32) & 1);
                any[row] = any[row] & evens | odd[row] & !evens;
                row += 1;
            }
        }
        any
    }

    #[inline]
    fn any_of<const INNER: usize>(&self, set: u32) -> [u32; INNER] {
        let mut any = [0; INNER];
        let mut y = 0;
        while y < Offsets::SIDE {
            let mut x = 0;
            while x < Offsets::SIDE {
                if set >> (y * Offsets::SIDE + x) & 1 != 0 {
                    let mut row = 0;
                    while row < INNER {
                        let (low, high) = (self.low[row + y as usize], self.high[row + y as usize]);
                        // In two steps, since a shift by 32 is none.
                        any[row] |= low >> x | high << 1 << (31 - x);
                        row += 1;
                    }
                }
                x += 1;
            }
            y += 1;
        }
        any
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    const STATES: [MaskBits; 6] = [
        MaskBits::BLACK,
        MaskBits::GREEN,
        MaskBits::WHITE,
        MaskBits::PURPLE,
        MaskBits::RED,
        MaskBits::YELLOW,
    ];

    fn row_of(states: impl Iterator<Item = MaskBits>) -> MaskRow {
        (0..).zip(states).fold(MaskRow::default(), |row, (x, state)| row.with(x, state))
    }

    #[test]
    fn rows_ask_as_their_pixels_do() {
        let row = row_of(STATES.into_iter().cycle().take(32));
        for (x, state) in (0..32).zip(STATES.into_iter().cycle()) {
            assert_eq!(row.get(x), state);
            for rule in Expansion::ALL.into_iter().chain([Expansion::from_index(7)]) {
                for st in [false, true] {
                    assert_eq!(row.contradicting(rule, st) >> x & 1 != 0, rule.asks(state, st), "{rule:?}");
                }
            }
        }
    }

    #[test]
    fn the_last_column_stands_for_all_beyond() {
        assert_eq!(repeat_from(0b0101_0100, 4), !0 << 4 | 0b0100);
        assert_eq!(repeat_from(0b0101_0100, 3), 0b0100);
        assert_eq!((repeat_from(!0, 31), repeat_from(1, 31), repeat_from(1, 0)), (!0, 1, !0));
    }

    #[test]
    fn offsets_are_the_patterns() {
        for pattern in Pattern::ALL {
            for frame in 0..5 {
                let Offsets(sets) = Offsets::of(pattern, frame);
                for (pixel, set) in [(UVec2::new(6, 2), sets.x), (UVec2::new(6, 3), sets.y)] {
                    let listed = (0..pattern.neighbour_count()).map(|i| pattern.offset(i, pixel, frame));
                    let bits: u32 = listed.map(|o| 1 << (5 * (o.y + 2) + o.x + 2)).sum();
                    assert_eq!(set, bits, "{pattern:?} {frame}");
                }
            }
        }
    }

    /// One bit in a window of nine rows and 96 columns, wherever it may lie, is heard by just the pixels whose offsets lead there.
    #[test]
    fn a_bit_is_heard_where_an_offset_leads_to_it() {
        for pattern in Pattern::ALL {
            let offsets = Offsets::of(pattern, 3);
            for (at_x, at_y) in (-3..35).flat_map(|x| (0..9).map(move |y| (x, y))) {
                let mut window = Window::<9>::EMPTY;
                let word = |from: i32| match at_x - from {
                    bit @ 0..32 => 1u32 << bit,
                    _ => 0,
                };
                window.put(at_y as usize, word(-32), word(0), word(32));
                for first_row in [4, 7] {
                    let heard: [u32; 5] = window.any(first_row, offsets);
                    for (x, y) in (0..32).flat_map(|x| (0..5).map(move |y| (x, y))) {
                        let pixel = UVec2::new(x as u32, first_row + y as u32);
                        let leads: Vec<_> = (0..pattern.neighbour_count())
                            .map(|i| pattern.offset(i, pixel, 3))
                            .filter(|o| (x + o.x, y + 2 + o.y) == (at_x, at_y))
                            .collect();
                        assert_eq!(heard[y as usize] >> x & 1 != 0, !leads.is_empty(), "{pattern:?} {x} {y}");
                    }
                }
            }
        }
    }
}
