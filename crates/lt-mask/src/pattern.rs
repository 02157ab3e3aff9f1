//! Which neighbours of the reprojected pixel are asked, by pattern and frame (Kern et al. 2024, §3.1.1).

use lt_math::glam::{IVec2, UVec2};

/// A choice of neighbours; each pattern includes the pixel itself.
///
/// A `u32` in a coat, so that it may cross to the GPU as a parameter. Unknown numbers act as the full 3×3.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pattern(u32);

impl Pattern {
    /// All nine pixels, every frame.
    pub const FULL_3X3: Self = Self(0);
    /// The pixel and its four edge neighbours.
    pub const PLUS: Self = Self(1);
    /// The pixel and its four corner neighbours.
    pub const CROSS: Self = Self(2);
    /// Plus on even pixels, cross on odd ones, as a chessboard.
    pub const CHECKERBOARD: Self = Self(3);
    /// Plus in even frames, cross in odd ones.
    pub const ALTERNATING: Self = Self(4);
    /// One 2×2 gather, shifted by half a pixel: four successive frames cover the 3×3. The paper's choice.
    pub const GATHER_2X2: Self = Self(5);
    /// All 25 pixels within two, every frame: for pixels that move, not in the paper.
    pub const FULL_5X5: Self = Self(6);

    /// The 13 pixels within two steps along the axes, every frame: the 3×3 and four more. Not in the paper.
    pub const DIAMOND: Self = Self(7);

    /// Every pattern, for sweeps.
    pub const ALL: [Self; 8] = [
        Self::FULL_3X3,
        Self::PLUS,
        Self::CROSS,
        Self::CHECKERBOARD,
        Self::ALTERNATING,
        Self::GATHER_2X2,
        Self::FULL_5X5,
        Self::DIAMOND,
    ];

    /// The pattern with this number, as [`Pattern::to_index`] gave it.
    #[inline]
    pub fn from_index(index: u32) -> Self {
        Self(index)
    }

    /// The pattern's number.
    #[inline]
    pub fn to_index(self) -> u32 {
        self.0
    }

    /// How many neighbours are asked: 25, 13, 9, 5 or 4.
    #[inline]
    pub fn neighbour_count(self) -> u32 {
        match self.0 {
            1..=4 => 5,
            5 => 4,
            6 => 25,
            7 => 13,
            _ => 9,
        }
    }

    /// The offset of neighbour `index` < [`Pattern::neighbour_count`], each part −1, 0 or 1
    /// (−2 to 2 for the 5×5 and the diamond).
    ///
    /// `pixel` steers the chessboard, `frame` the patterns that change over time. Larger indices start over.
    #[inline]
    pub fn offset(self, index: u32, pixel: UVec2, frame: u32) -> IVec2 {
        match self.0 {
            1 => plus(index),
            2 => cross(index),
            3 => plus_or_cross(index, (pixel.x + pixel.y) & 1),
            4 => plus_or_cross(index, frame & 1),
            5 => gather_corner(frame) + IVec2::new((index & 1) as i32, ((index >> 1) & 1) as i32),
            6 => IVec2::new((index % 5) as i32 - 2, ((index / 5) % 5) as i32 - 2),
            7 => diamond(index),
            _ => IVec2::new((index % 3) as i32 - 1, ((index / 3) % 3) as i32 - 1),
        }
    }

    /// The neighbour itself, clamped to the screen of `size_px` (at least 1×1); `pixel` is inside.
    #[inline]
    pub fn neighbour(self, index: u32, pixel: UVec2, frame: u32, size_px: UVec2) -> UVec2 {
        let offset = self.offset(index, pixel, frame);
        UVec2::new(step_clamped(pixel.x, offset.x, size_px.x), step_clamped(pixel.y, offset.y, size_px.y))
    }
}

impl Default for Pattern {
    fn default() -> Self {
        Self::GATHER_2X2
    }
}

/// The smallest corner of the 2×2 in `frame`: opposite corners first, so that two frames already see seven of the nine.
#[inline]
pub fn gather_corner(frame: u32) -> IVec2 {
    match frame & 3 {
        0 => IVec2::new(-1, -1),
        1 => IVec2::new(0, 0),
        2 => IVec2::new(0, -1),
        _ => IVec2::new(-1, 0),
    }
}

fn plus(index: u32) -> IVec2 {
    match index % 5 {
        0 => IVec2::new(0, 0),
        1 => IVec2::new(0, -1),
        2 => IVec2::new(-1, 0),
        3 => IVec2::new(1, 0),
        _ => IVec2::new(0, 1),
    }
}

fn cross(index: u32) -> IVec2 {
    match index % 5 {
        0 => IVec2::new(0, 0),
        1 => IVec2::new(-1, -1),
        2 => IVec2::new(1, -1),
        3 => IVec2::new(-1, 1),
        _ => IVec2::new(1, 1),
    }
}

/// The 3×3, then the four pixels at distance two.
fn diamond(index: u32) -> IVec2 {
    match index % 13 {
        9 => IVec2::new(0, -2),
        10 => IVec2::new(-2, 0),
        11 => IVec2::new(2, 0),
        12 => IVec2::new(0, 2),
        near => IVec2::new((near % 3) as i32 - 1, ((near / 3) % 3) as i32 - 1),
    }
}

fn plus_or_cross(index: u32, is_cross: u32) -> IVec2 {
    if is_cross == 0 { plus(index) } else { cross(index) }
}

/// `coordinate` + `offset` kept in 0…`size` − 1.
fn step_clamped(coordinate: u32, offset: i32, size: u32) -> u32 {
    let stepped = coordinate as i32 + offset;
    if stepped < 0 {
        0
    } else if stepped >= size as i32 {
        size - 1
    } else {
        stepped as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::vec::Vec;

    fn offsets(pattern: Pattern, pixel: UVec2, frame: u32) -> Vec<(i32, i32)> {
        (0..pattern.neighbour_count()).map(|i| pattern.offset(i, pixel, frame).into()).collect()
    }

    fn covered(pattern: Pattern, frames: core::ops::Range<u32>) -> usize {
        frames.flat_map(|f| offsets(pattern, UVec2::ZERO, f)).collect::<BTreeSet<_>>().len()
    }

    #[test]
    fn offsets_are_distinct_adjacent_and_include_the_pixel() {
        for pattern in Pattern::ALL {
            for frame in 0..8 {
                for pixel in [UVec2::new(4, 4), UVec2::new(5, 4)] {
                    let all = offsets(pattern, pixel, frame);
                    let set: BTreeSet<_> = all.iter().copied().collect();
                    assert_eq!(set.len(), all.len());
                    assert!(set.contains(&(0, 0)));
                    let is_wide = [Pattern::FULL_5X5, Pattern::DIAMOND].contains(&pattern);
                    let reach = if is_wide { 2 } else { 1 };
                    assert!(set.iter().all(|(x, y)| x.abs() <= reach && y.abs() <= reach));
                }
            }
        }
    }

    #[test]
    fn the_gather_covers_the_3x3_in_any_4_frames_and_not_in_3() {
        for start in [0, 1, 2, 3, u32::MAX - 20] {
            assert_eq!(covered(Pattern::GATHER_2X2, start..start + 4), 9);
            assert!(covered(Pattern::GATHER_2X2, start..start + 3) < 9);
        }
        assert_eq!(covered(Pattern::GATHER_2X2, 0..2), 7);
    }

    #[test]
    fn plus_and_cross_together_cover_the_3x3() {
        assert_eq!(covered(Pattern::ALTERNATING, 0..2), 9);
        assert_eq!(covered(Pattern::FULL_3X3, 0..1), 9);
        assert_eq!(covered(Pattern::FULL_5X5, 0..1), 25);
        assert_eq!(covered(Pattern::DIAMOND, 0..1), 13);
        let steps = |(x, y): &(i32, i32)| x.abs() + y.abs();
        assert!(offsets(Pattern::DIAMOND, UVec2::ZERO, 0).iter().all(|o| steps(o) <= 2));
        assert_eq!(covered(Pattern::PLUS, 0..9), 5);
        assert_eq!(covered(Pattern::CROSS, 0..9), 5);
    }

    #[test]
    fn the_checkerboard_alternates_over_pixels_not_frames() {
        let even = offsets(Pattern::CHECKERBOARD, UVec2::new(2, 4), 0);
        assert_eq!(even, offsets(Pattern::PLUS, UVec2::ZERO, 0));
        assert_eq!(even, offsets(Pattern::CHECKERBOARD, UVec2::new(3, 5), 1));
        for neighbour in [UVec2::new(3, 4), UVec2::new(2, 5)] {
            assert_eq!(offsets(Pattern::CHECKERBOARD, neighbour, 0), offsets(Pattern::CROSS, UVec2::ZERO, 0));
        }
    }

    #[test]
    fn neighbours_stay_on_the_screen() {
        for size in [UVec2::ONE, UVec2::new(1, 3), UVec2::new(3, 2), UVec2::splat(5)] {
            for pattern in Pattern::ALL {
                for y in 0..size.y {
                    for x in 0..size.x {
                        for frame in 0..4 {
                            for i in 0..pattern.neighbour_count() {
                                let pixel = UVec2::new(x, y);
                                let n = pattern.neighbour(i, pixel, frame, size);
                                assert!(n.x < size.x && n.y < size.y);
                                let wanted = pixel.as_ivec2() + pattern.offset(i, pixel, frame);
                                let clamped = wanted.clamp(IVec2::ZERO, size.as_ivec2() - 1);
                                assert_eq!(n.as_ivec2(), clamped);
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn numbers_round_trip() {
        for pattern in Pattern::ALL {
            assert_eq!(Pattern::from_index(pattern.to_index()), pattern);
        }
        assert_eq!(Pattern::from_index(77).neighbour_count(), 9);
    }
}
