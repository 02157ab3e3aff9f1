//! The leak tracing test: is a filtered answer confident, or does it ask for a ray (Kern et al. 2024, eq. 3)?

use crate::float;

/// The paper's ε.
pub const LTT_EPSILON: f32 = 0.01;

/// LTT := ε < v̂ < 1 − ε; a NaN needs a ray too.
///
/// NaN is asked of the bits (see [`float::is_nan`]), so that no shader compiler answers "confident" for it.
#[inline]
pub fn needs_ray(visibility: f32, epsilon: f32) -> bool {
    let is_confident = visibility <= epsilon || visibility >= 1.0 - epsilon;
    float::is_nan(visibility) || !is_confident
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_open_interval_is_in_doubt() {
        for (v, expected) in [
            (0.0, false),
            (0.01, false),
            (0.0101, true),
            (0.5, true),
            (0.9899, true),
            (0.99, false),
            (1.0, false),
        ] {
            assert_eq!(needs_ray(v, LTT_EPSILON), expected, "{v}");
        }
    }

    #[test]
    fn nan_needs_a_ray_whatever_epsilon() {
        for epsilon in [0.0, LTT_EPSILON, 0.5, f32::NAN] {
            assert!(needs_ray(f32::NAN, epsilon) && needs_ray(-f32::NAN, epsilon));
        }
    }
}
