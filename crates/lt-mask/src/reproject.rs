//! Where a pixel was in the last frame, by its motion vector, or that it was nowhere (Kern et al. 2024, §3.1).

use lt_math::float;
use lt_math::glam::{UVec2, Vec2};

/// A pixel's place in the last frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reprojection {
    /// The last frame's pixel; this frame's own where there is none, so that it may be read without harm.
    pub pixel: UVec2,
    /// Whether the pixel was on the screen; false for a NaN motion too. If false, a ray is forced.
    pub is_valid: bool,
    /// Whether it moved at all: RR is then unsafe. A motion below any threshold adds up over frames, so there is none;
    /// what has not moved must come with a motion of exactly 0, which is to be made sure of by comparing what was projected: compilers
    /// for GPUs may round two projections by the same arithmetic differently.
    pub has_moved: bool,
}

/// Follows `motion_px`, the way in pixels from here to where the same surface was last frame, to the pixel there.
///
/// `pixel` is inside the screen of `size_px`; x right, y down. `place_px` is the point of it that was looked through, in pixels
/// from the screen's corner: its centre, `pixel` + 0.5, unless samples lie elsewhere.
#[inline]
pub fn reproject(pixel: UVec2, place_px: Vec2, motion_px: Vec2, size_px: UVec2) -> Reprojection {
    let x = float::floor(place_px.x + motion_px.x);
    let y = float::floor(place_px.y + motion_px.y);
    let is_valid = x >= 0.0 && y >= 0.0 && x < size_px.x as f32 && y < size_px.y as f32;
    let is_still = motion_px.x == 0.0 && motion_px.y == 0.0;
    Reprojection {
        pixel: if is_valid { UVec2::new(x as u32, y as u32) } else { pixel },
        is_valid,
        has_moved: !is_still,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn from_centre(pixel: UVec2, motion_px: Vec2, size_px: UVec2) -> Reprojection {
        reproject(pixel, pixel.as_vec2() + 0.5, motion_px, size_px)
    }

    const SIZE: UVec2 = UVec2::new(1920, 1080);

    #[test]
    fn no_motion_is_the_same_pixel() {
        for pixel in [UVec2::ZERO, UVec2::new(7, 9), SIZE - 1] {
            let r = from_centre(pixel, Vec2::ZERO, SIZE);
            assert_eq!(r, Reprojection { pixel, is_valid: true, has_moved: false });
        }
    }

    #[test]
    fn motion_rounds_to_the_nearest_pixel() {
        let at = |x, y| from_centre(UVec2::new(10, 10), Vec2::new(x, y), SIZE).pixel;
        assert_eq!(at(0.49, -0.49), UVec2::new(10, 10));
        assert_eq!(at(0.51, -0.51), UVec2::new(11, 9));
        assert_eq!(at(-3.0, 2.0), UVec2::new(7, 12));
    }

    #[test]
    fn motion_starts_where_the_pixel_was_looked_through() {
        let at = |x: f32| {
            reproject(UVec2::new(10, 10), Vec2::new(10.0 + x, 10.5), Vec2::new(0.2, 0.0), SIZE).pixel.x
        };
        assert_eq!((at(0.125), at(0.75), at(0.875)), (10, 10, 11));
    }

    #[test]
    fn leaving_the_screen_fails_on_every_side() {
        for (pixel, motion) in [
            (UVec2::ZERO, Vec2::new(-0.6, 0.0)),
            (UVec2::ZERO, Vec2::new(0.0, -0.6)),
            (SIZE - 1, Vec2::new(0.6, 0.0)),
            (SIZE - 1, Vec2::new(0.0, 0.6)),
            (SIZE - 1, Vec2::splat(1e30)),
        ] {
            let r = from_centre(pixel, motion, SIZE);
            assert_eq!(r, Reprojection { pixel, is_valid: false, has_moved: true });
        }
    }

    #[test]
    fn nan_and_infinity_fail_and_count_as_moved() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            for motion in [Vec2::new(bad, 0.0), Vec2::new(0.0, bad)] {
                let r = from_centre(UVec2::new(3, 4), motion, SIZE);
                assert_eq!((r.is_valid, r.has_moved, r.pixel), (false, true, UVec2::new(3, 4)));
            }
        }
    }

    #[test]
    fn the_least_motion_counts() {
        let moved = |x| from_centre(UVec2::ONE, Vec2::new(x, 0.0), SIZE).has_moved;
        assert!(!moved(0.0) && !moved(-0.0));
        assert!(moved(1e-30) && moved(-1e-6));
    }

    proptest! {
        #[test]
        fn a_valid_pixel_is_on_the_screen_and_within_half_a_pixel(
            x in 0u32..1920, y in 0u32..1080, mx in -3000.0f32..3000.0, my in -3000.0f32..3000.0
        ) {
            let r = from_centre(UVec2::new(x, y), Vec2::new(mx, my), SIZE);
            prop_assert!(r.pixel.x < SIZE.x && r.pixel.y < SIZE.y);
            if r.is_valid {
                prop_assert!((r.pixel.x as f32 - (x as f32 + mx)).abs() <= 0.501);
                prop_assert!((r.pixel.y as f32 - (y as f32 + my)).abs() <= 0.501);
            }
        }
    }
}
