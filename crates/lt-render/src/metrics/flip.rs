//! Perceptual distance of two pictures: NVIDIA's FLIP (Andersson et al., "FLIP: A Difference Evaluator for
//! Alternating Images", 2020).

use nv_flip::{DEFAULT_PIXELS_PER_DEGREE, FlipImageRgb8, FlipPool, flip};

/// Mean FLIP of `test` against `reference`, in [0, 1]: 0 for equal pictures.
///
/// Pixels are sRGB, row by row, alpha ignored, seen at 67 pixels per degree. NaN, which passes no threshold, if there
/// are no pixels or either slice does not hold `width · height` of them.
pub fn flip_mean(width: u32, height: u32, reference: &[[u8; 4]], test: &[[u8; 4]]) -> f64 {
    let pixels = width as usize * height as usize;
    if pixels == 0 || reference.len() != pixels || test.len() != pixels {
        return f64::NAN;
    }
    let image = |rgba: &[[u8; 4]]| {
        let rgb: Vec<u8> = rgba.iter().flat_map(|p| [p[0], p[1], p[2]]).collect();
        FlipImageRgb8::with_data(width, height, &rgb)
    };
    let map = flip(image(reference), image(test), DEFAULT_PIXELS_PER_DEGREE);
    f64::from(FlipPool::from_image(&map).mean())
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREY: [u8; 4] = [90, 90, 90, 255];
    const BRIGHT: [u8; 4] = [240, 230, 200, 255];

    fn pictures() -> (Vec<[u8; 4]>, Vec<[u8; 4]>) {
        let same = vec![GREY; 32 * 16];
        let mut changed = same.clone();
        changed[5 * 32 + 7] = BRIGHT;
        (same, changed)
    }

    #[test]
    fn equal_pictures_are_at_zero() {
        let (same, _) = pictures();
        assert_eq!(flip_mean(32, 16, &same, &same), 0.0);
        assert_eq!(flip_mean(1, 1, &[GREY], &[GREY]), 0.0);
    }

    #[test]
    fn one_changed_pixel_is_seen_on_either_side() {
        let (same, changed) = pictures();
        for distance in [flip_mean(32, 16, &same, &changed), flip_mean(32, 16, &changed, &same)] {
            assert!(distance > 1e-4 && distance < 0.1, "{distance}");
        }
    }

    #[test]
    fn black_against_white_is_far() {
        assert!(flip_mean(8, 8, &[[0, 0, 0, 255]; 64], &[[255; 4]; 64]) > 0.8);
    }

    #[test]
    fn alpha_is_ignored() {
        assert_eq!(flip_mean(1, 1, &[GREY], &[[90, 90, 90, 0]]), 0.0);
    }

    #[test]
    fn what_cannot_be_compared_is_nan() {
        let (same, _) = pictures();
        assert!(flip_mean(0, 0, &[], &[]).is_nan());
        assert!(flip_mean(32, 16, &same, &same[1..]).is_nan());
        assert!(flip_mean(32, 16, &same[1..], &same).is_nan());
        assert!(flip_mean(16, 16, &same, &same).is_nan());
    }
}
