//! What a pixel's neighbourhood in the last frame asks for, for all pixels at once: [`lt_mask::Window`] over blocks.

use lt_mask::{Expansion, Offsets, Window, repeat_from};
use lt_shaders::neighbours::asking_word;
use rayon::prelude::*;

use super::planes::BlockBits;
use super::tiles::{SIDE, Tiles};

/// Rows of a block.
const ROWS: usize = SIDE as usize;
/// Rows of the blocks above and below that a pattern sees.
const REACH: usize = Offsets::REACH as usize;

/// Four words for every row of every block, in the order of [`asking_word`]: bit x tells whether anyone around that pixel
/// contradicts a shadow test.
#[derive(Default)]
pub struct Asks {
    words: Vec<[[u32; 4]; ROWS]>,
}

impl Asks {
    /// All blocks' words, in the order of [`Tiles`]: row y of block b is element 32·b + y.
    pub fn rows(&self) -> &[[u32; 4]] {
        self.words.as_flattened()
    }

    /// Hears all neighbourhoods of a frame, by the offsets of pixels that stand still and of those that move. `last` holds a
    /// picture's blocks; bits set outside it are ignored.
    pub fn hear(
        &mut self,
        tiles: Tiles,
        last: &[BlockBits],
        expansion: Expansion,
        [still, moving]: [Offsets; 2],
    ) {
        self.words.resize(last.len(), [[0; 4]; ROWS]);
        self.words.par_iter_mut().enumerate().for_each(|(block, words)| {
            let by_rays = matches!(expansion, Expansion::RAYS | Expansion::LEAKS);
            if by_rays && !has_rays_near(block, tiles, last) {
                *words = [[0; 4]; ROWS];
                return;
            }
            let first_row = tiles.origin(block).y;
            for st in [false, true] {
                let window = around(block, tiles, last, (expansion, st));
                let by_still: [u32; ROWS] = window.any(first_row, still);
                let by_moving = if still == moving { by_still } else { window.any(first_row, moving) };
                for (row, (still, moving)) in words.iter_mut().zip(by_still.into_iter().zip(by_moving)) {
                    row[asking_word(st, false) as usize] = still;
                    row[asking_word(st, true) as usize] = moving;
                }
            }
        });
    }
}

/// Whether any ray was traced in a block or one beside it: nobody else contradicts by the narrower rules.
fn has_rays_near(block: usize, tiles: Tiles, last: &[BlockBits]) -> bool {
    let columns = tiles.columns() as usize;
    let (bx, rows) = (block % columns, last.len() / columns);
    let near = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    let mut all = near(block / columns, rows).flat_map(|y| near(bx, columns).map(move |x| y * columns + x));
    all.any(|block| last[block].traced.iter().fold(0, |any, row| any | row) != 0)
}

/// Who contradicts, in a block and around it; beyond the picture's edge stands what is on the edge.
fn around(
    block: usize,
    tiles: Tiles,
    last: &[BlockBits],
    (expansion, is_test_shadowed): (Expansion, bool),
) -> Window<{ ROWS + 2 * REACH }> {
    let (columns, size) = (tiles.columns() as usize, tiles.size());
    let (bx, by) = (block % columns, block / columns);
    let contradicting = |bx: usize, y: u32| -> u32 {
        let row = last[(y / SIDE) as usize * columns + bx].row(y % SIDE);
        let last_column = (size.x - 1 - bx as u32 * SIDE).min(SIDE - 1);
        repeat_from(row.contradicting(expansion, is_test_shadowed), last_column)
    };
    let everywhere = |bit: u32| 0u32.wrapping_sub(bit & 1);
    let mut window = Window::EMPTY;
    for i in 0..ROWS + 2 * REACH {
        let y =
            (by as i64 * i64::from(SIDE) + i as i64 - REACH as i64).clamp(0, i64::from(size.y) - 1) as u32;
        let own = contradicting(bx, y);
        let left = if bx == 0 { everywhere(own) } else { contradicting(bx - 1, y) };
        let right = if bx + 1 == columns { everywhere(own >> 31) } else { contradicting(bx + 1, y) };
        window.put(i, left, own, right);
    }
    window
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_mask::{MaskBits, Neighbourhood, Pattern};
    use lt_math::glam::UVec2;

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
                last[(block.y * tiles.columns() + block.x) as usize].row(p.y % SIDE).get(p.x % SIDE)
            };
            for (pattern, rule) in Pattern::ALL.into_iter().flat_map(|p| Expansion::ALL.map(|e| (p, e))) {
                for frame in 0..4 {
                    let mut asks = Asks::default();
                    asks.hear(tiles, &last, rule, [pattern, Pattern::PLUS].map(|p| Offsets::of(p, frame)));
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
                                let word = asks.rows()[row as usize][asking_word(st, moved) as usize];
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
