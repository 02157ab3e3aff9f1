//! Where in a pixel its samples lie: the canonical multi-jittered arrangement (Kensler, "Correlated Multi-Jittered Sampling",
//! 2013, §2), without its shuffling.
//!
//! A pixel of `grid.x · grid.y` samples is a grid of so many cells, one sample in each, and all cells of all pixels together
//! are the grid that passes run on. Within its cell a sample lies the further right the lower its row and the further down
//! the further right its column, so that all samples of a pixel differ in x and in y: an edge that is nearly upright or level
//! meets them one by one.

use lt_math::glam::{UVec2, Vec2};

/// The place of sample `at` (column, row) of the picture's grid of samples, in cells from its upper left corner.
///
/// `grid` holds a pixel's columns and rows of samples, powers of two. A pixel's only sample lies at its centre.
#[inline]
pub fn sample_place(at: UVec2, grid: UVec2) -> Vec2 {
    let (column, row) = (at.x & (grid.x - 1), at.y & (grid.y - 1));
    let x = (row as f32 + 0.5) / grid.y as f32;
    let y = (column as f32 + 0.5) / grid.x as f32;
    Vec2::new(at.x as f32 + x, at.y as f32 + y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lone_sample_lies_at_the_centre() {
        for at in [UVec2::ZERO, UVec2::new(7, 1079), UVec2::new(16383, 3)] {
            let centre = Vec2::new(at.x as f32 + 0.5, at.y as f32 + 0.5);
            assert_eq!(sample_place(at, UVec2::ONE), centre);
        }
    }

    /// Every one of n strips of a pixel, upright or level, holds one sample, in its middle: Kensler's equation.
    #[test]
    fn samples_differ_in_x_and_in_y() {
        for grid in [[1, 1], [2, 1], [2, 2], [4, 2], [4, 4], [8, 4]].map(UVec2::from_array) {
            let count = grid.x * grid.y;
            let (mut columns, mut rows) = (0u32, 0u32);
            let corner = grid * UVec2::new(5, 3);
            for i in 0..count {
                let at = corner + UVec2::new(i % grid.x, i / grid.x);
                let strip = (sample_place(at, grid) / grid.as_vec2() - Vec2::new(5.0, 3.0)) * count as f32;
                assert_eq!(strip.fract(), Vec2::splat(0.5), "{grid} {at}");
                columns |= 1 << strip.x as u32;
                rows |= 1 << strip.y as u32;
            }
            assert_eq!((columns.count_ones(), rows.count_ones()), (count, count), "{grid}");
        }
    }
}
