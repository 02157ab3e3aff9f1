//! How many samples a pixel has.

use std::fmt;

use lt_math::glam::UVec2;

use crate::RenderError;

/// Columns and rows of a pixel's samples; `lt_shaders::sampling` says where each lies.
///
/// A picture of `size` pixels is drawn on a grid of `size · columns × rows` samples. Estimate, doubt, mask and resolve know
/// samples alone; the shaded picture is their mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleGrid(UVec2);

impl SampleGrid {
    /// One sample, at the pixel's centre.
    pub const ONE: Self = Self(UVec2::ONE);
    /// All there are, by number of samples.
    const ALL: [Self; 6] = [
        Self::ONE,
        Self(UVec2::new(2, 1)),
        Self(UVec2::new(2, 2)),
        Self(UVec2::new(4, 2)),
        Self(UVec2::new(4, 4)),
        Self(UVec2::new(8, 4)),
    ];

    /// The grid of this many samples.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for a number that is not 1, 2, 4, 8, 16 or 32.
    pub fn of(count: u32) -> Result<Self, RenderError> {
        let grid = Self::ALL.into_iter().find(|g| g.count() == count);
        grid.ok_or_else(|| {
            RenderError::BadSetup(format!("{count} samples per pixel: must be 1, 2, 4, 8, 16 or 32"))
        })
    }

    /// Samples of a pixel.
    pub fn count(self) -> u32 {
        self.0.x * self.0.y
    }

    /// Columns and rows.
    pub fn size(self) -> UVec2 {
        self.0
    }

    /// Which pixel of a picture `width` pixels wide holds each of its samples; both are counted row by row.
    pub fn pixel_of(self, sample: usize, width: u32) -> usize {
        let columns = (width * self.0.x) as usize;
        let (x, y) = (sample % columns / self.0.x as usize, sample / columns / self.0.y as usize);
        y * width as usize + x
    }
}

impl fmt::Display for SampleGrid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.count())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_of_powers_of_two_up_to_32() {
        let counts: Vec<u32> = (0..100).filter(|&n| SampleGrid::of(n).is_ok()).collect();
        assert_eq!(counts, [1, 2, 4, 8, 16, 32]);
        for count in counts {
            let grid = SampleGrid::of(count).expect("one of them");
            assert_eq!(grid.count(), count);
            assert!(grid.size().x.is_power_of_two() && grid.size().y.is_power_of_two());
        }
        let text = SampleGrid::of(3).expect_err("not a grid").to_string();
        assert!(text.contains('3') && text.contains("16 or 32"), "{text}");
    }

    #[test]
    fn every_pixel_holds_its_samples() {
        let grid = SampleGrid::of(8).expect("a grid");
        let (width, height) = (3, 2);
        let mut held = [0; 6];
        (0..width * height * 8).for_each(|i| held[grid.pixel_of(i as usize, width)] += 1);
        assert_eq!(held, [8; 6]);
        // The second row of samples of the second row of pixels, fifth column.
        assert_eq!(grid.pixel_of(3 * 12 + 4, width), 3 + 1);
    }
}
