//! What a pixel's neighbourhood in the last frame asks for, for all pixels at once.
//!
//! ER looks at a neighbour through one question: does it contradict shadow test ST? (And so does RR as published: over the states
//! that occur, eqs. 6 and 8 negate each other.) So a neighbourhood is two bits, "anyone contradicts *lit*" and "anyone contradicts
//! *shadowed*", and it is made for a whole row of pixels by shifting and joining words. A pixel then reads one bit,
//! wherever motion led it.

use lt_mask::{Expansion, Pattern};
use lt_math::glam::{IVec2, UVec2};
use rayon::prelude::*;

use super::planes::BlockBits;
use super::tiles::{SIDE, Tiles};

/// Rows of a block.
const ROWS: usize = SIDE as usize;
/// Farthest that a pattern looks, pixels.
const REACH: usize = 2;

/// Four words for every row of every block: bit x of word [`Asks::word`] tells whether anyone around that pixel contradicts
/// a shadow test.
#[derive(Default)]
pub struct Asks {
    words: Vec<[[u32; 4]; ROWS]>,
}

impl Asks {
    /// Which of a row's four words: for pixels that are shadowed by the test, or have moved and so ask by the other pattern.
    #[inline(always)]
    pub fn word(is_test_shadowed: bool, has_moved: bool) -> u32 {
        u32::from(is_test_shadowed) | u32::from(has_moved) << 1
    }

    /// All blocks' words, in the order of [`Tiles`]: row y of block b is element 32·b + y.
    pub fn rows(&self) -> &[[u32; 4]] {
        self.words.as_flattened()
    }

    /// Hears all neighbourhoods of a frame, by the patterns of pixels that stand still and of those that move. `last` holds a
    /// picture's blocks; bits set outside it are ignored.
    pub fn hear(
        &mut self,
        tiles: Tiles,
        last: &[BlockBits],
        expansion: Expansion,
        [still, moving]: [Pattern; 2],
        frame: u32,
    ) {
        self.words.resize(last.len(), [[0; 4]; ROWS]);
        let patterns = [Offsets::of(still, frame), Offsets::of(moving, frame)];
        self.words.par_iter_mut().enumerate().for_each(|(block, words)| {
            for is_test_shadowed in [false, true] {
                let window = Window::around(block, tiles, last, (expansion, is_test_shadowed));
                let still = window.joined(&patterns[0]);
                let moving = if patterns[0] == patterns[1] { still } else { window.joined(&patterns[1]) };
                for (row, (still, moving)) in words.iter_mut().zip(still.into_iter().zip(moving)) {
                    row[Asks::word(is_test_shadowed, false) as usize] = still;
                    row[Asks::word(is_test_shadowed, true) as usize] = moving;
                }
            }
        });
    }
}

/// A pattern's offsets on the chessboard's even and odd pixels.
#[derive(PartialEq, Eq)]
struct Offsets {
    even: Vec<IVec2>,
    odd: Vec<IVec2>,
}

impl Offsets {
    fn of(pattern: Pattern, frame: u32) -> Self {
        let at = |pixel| (0..pattern.neighbour_count()).map(|i| pattern.offset(i, pixel, frame)).collect();
        Self { even: at(UVec2::ZERO), odd: at(UVec2::X) }
    }
}

/// A block's rows with [`REACH`] more on every side: bits 16 … 47 are the block's, the others its neighbours'.
struct Window([u64; ROWS + 2 * REACH]);

impl Window {
    /// Who contradicts, in the block and around it; beyond the picture's edge stands what is on the edge.
    fn around(
        block: usize,
        tiles: Tiles,
        last: &[BlockBits],
        (expansion, is_test_shadowed): (Expansion, bool),
    ) -> Self {
        let (columns, size) = (tiles.columns() as usize, tiles.size());
        let (bx, by) = (block % columns, block / columns);
        let contradicts = |bx: usize, y: u32| -> u32 {
            let bits = &last[(y / SIDE) as usize * columns + bx];
            let row = (y % SIDE) as usize;
            let (st, traced, hit) = (bits.shadowed[row], bits.traced[row], bits.hit[row]);
            // [`Expansion::asks`] of a row; RS is kept only where a ray was traced.
            let (by_ray, by_test) = match is_test_shadowed {
                false => (traced & hit, st),
                true => (traced & !hit, !st),
            };
            let word = match expansion {
                Expansion::RAYS => by_ray,
                Expansion::LEAKS => by_ray & (hit ^ st),
                _ => by_ray | by_test,
            };
            let last_column = size.x - 1 - bx as u32 * SIDE;
            if last_column < SIDE - 1 { repeat_from(word, last_column) } else { word }
        };
        let all = |bit: u32| 0u32.wrapping_sub(bit & 1);
        Self(std::array::from_fn(|i| {
            let y = (by as i64 * i64::from(SIDE) + i as i64 - REACH as i64).clamp(0, i64::from(size.y) - 1);
            let own = contradicts(bx, y as u32);
            let left = if bx == 0 { all(own) } else { contradicts(bx - 1, y as u32) };
            let right = if bx + 1 == columns { all(own >> 31) } else { contradicts(bx + 1, y as u32) };
            u64::from(left >> 16) | u64::from(own) << 16 | u64::from(right) << 48
        }))
    }

    /// Per pixel, whether anyone at these offsets has the bit.
    fn joined(&self, offsets: &Offsets) -> [u32; ROWS] {
        let even = self.any_of(&offsets.even);
        if offsets.even == offsets.odd {
            return even;
        }
        let odd = self.any_of(&offsets.odd);
        // Blocks begin at even rows and columns.
        std::array::from_fn(|row| {
            let evens = 0x5555_5555 << (row & 1);
            even[row] & evens | odd[row] & !evens
        })
    }

    fn any_of(&self, offsets: &[IVec2]) -> [u32; ROWS] {
        let mut any = [0; ROWS];
        for offset in offsets {
            let rows = &self.0[(REACH as i32 + offset.y) as usize..][..ROWS];
            let shift = 16 + offset.x;
            for (any, row) in any.iter_mut().zip(rows) {
                *any |= (row >> shift) as u32;
            }
        }
        any
    }
}

/// The bits up to `column` < 31, and the bit at `column` in place of all others.
fn repeat_from(word: u32, column: u32) -> u32 {
    let above = !0u32 << (column + 1);
    if word >> column & 1 != 0 { word | above } else { word & !above }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_mask::{MaskBits, Neighbourhood};

    /// All patterns, frames and sizes that fill blocks, leave one pixel in a block, or are one pixel in all; random states.
    #[test]
    fn asks_are_the_neighbourhoods_of_the_shared_function() {
        let mut state = 5u32;
        let mut next = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 8
        };
        for size in [UVec2::new(64, 32), UVec2::new(33, 65), UVec2::new(40, 31), UVec2::ONE] {
            let tiles = Tiles::new(size);
            let blocks = tiles.len() / super::super::tiles::BLOCK;
            // Sparse contradictions: with many of them, every neighbourhood asks.
            let mut word = |is_rare: bool| if is_rare { next() & next() & next() & next() } else { next() };
            let last: Vec<BlockBits> = (0..blocks)
                .map(|b| {
                    let shadowed = std::array::from_fn(|y| if (y + b) % 9 < 5 { !0 } else { word(true) });
                    let traced = std::array::from_fn(|_| word(true));
                    let hit = std::array::from_fn(|y| traced[y] & word(false));
                    BlockBits { shadowed, traced, hit }
                })
                .collect();
            let at = |p: UVec2| -> MaskBits {
                let block = p / SIDE;
                last[(block.y * tiles.columns() + block.x) as usize].get(p.x % SIDE, p.y % SIDE)
            };
            for (pattern, rule) in Pattern::ALL.into_iter().flat_map(|p| Expansion::ALL.map(|e| (p, e))) {
                for frame in 0..4 {
                    let mut asks = Asks::default();
                    asks.hear(tiles, &last, rule, [pattern, Pattern::PLUS], frame);
                    for i in 0..size.x * size.y {
                        let p = UVec2::new(i % size.x, i / size.x);
                        for st in [false, true] {
                            for (moved, pattern) in [(false, pattern), (true, Pattern::PLUS)] {
                                let neighbours = (0..pattern.neighbour_count())
                                    .map(|i| at(pattern.neighbour(i, p, frame, size)));
                                let heard =
                                    neighbours.fold(Neighbourhood::EMPTY, |n, bits| n.with(bits, st, rule));
                                let block = p / SIDE;
                                let row = (block.y * tiles.columns() + block.x) * SIDE + p.y % SIDE;
                                let word = asks.rows()[row as usize][Asks::word(st, moved) as usize];
                                let asked = word >> (p.x % SIDE) & 1 != 0;
                                assert_eq!(heard.any_expands, asked, "{size} {pattern:?} {frame} {p} {st}");
                                assert!(rule != Expansion::PUBLISHED || heard.all_remove != asked);
                            }
                        }
                    }
                }
            }
        }
    }
}
