//! A rolling refresh: every pixel is traced once in so many frames, whatever map and history say.
//!
//! What a map missed and no neighbour knows of stays missed, however long a history grows; a history that was cleared
//! therefore never heals by itself. A refresh bounds how long anything can stay wrong where nothing moves.

use lt_math::glam::UVec2;

/// Longest period, frames.
pub const MAX_REFRESH: u32 = 256;

/// How far the turn of a row's pixels lies ahead of the row above, in frames of a period of 1 … [`MAX_REFRESH`].
///
/// About the golden section of the period: the pixels of one turn then lie evenly apart (a lattice of rank 1).
#[inline]
pub const fn refresh_stride(period: u32) -> u32 {
    (period * 5 / 8) | 1
}

/// Whether it is a pixel's turn: once in `period` frames for every pixel on the screen, in every frame for about one pixel
/// in `period`. Never for a period of 0.
///
/// `period` is at most [`MAX_REFRESH`], pixels count from the top left, `frame` counts frames.
#[inline]
pub fn is_due(pixel: UVec2, frame: u32, period: u32) -> bool {
    period != 0 && (pixel.x + pixel.y * refresh_stride(period) + frame % period).is_multiple_of(period)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_its_turn_once_in_a_period() {
        for period in [1, 2, 3, 7, 16, 60, 256] {
            for (x, y) in [(0, 0), (5, 3), (1919, 1079), (16383, 16383)] {
                for start in [0, 1000] {
                    let turns =
                        (start..start + period).filter(|&f| is_due(UVec2::new(x, y), f, period)).count();
                    assert_eq!(turns, 1, "{period} {x} {y}");
                }
            }
        }
        assert!((0..100).all(|f| !is_due(UVec2::ONE, f, 0)));
    }

    #[test]
    fn turns_of_a_frame_are_spread_over_the_picture() {
        for period in [4, 16, 64] {
            for frame in 0..period {
                let is_due = |x, y| is_due(UVec2::new(x, y), frame, period);
                let area = 64 * 64;
                let due = (0..area).filter(|i| is_due(i % 64, i / 64)).count() as u32;
                assert_eq!(due, area / period);
                let neighbours = (0..area).filter(|i| is_due(i % 64, i / 64) && is_due(i % 64, i / 64 + 1));
                assert_eq!(neighbours.count(), 0, "{period}");
            }
        }
    }
}
