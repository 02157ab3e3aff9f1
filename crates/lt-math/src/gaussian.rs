//! Separable Gaussian kernels for filtering depth vectors beforehand.

use crate::float;

/// The largest radius in texels for which [`gaussian_weights`] is meant: 7 texels to each side.
pub const GAUSSIAN_MAX_RADIUS: usize = 7;

/// e^{−i²/2σ²}: the unnormalised weight `offset` texels from the centre.
///
/// A `sigma` that is not positive gives 1 at the centre and 0 elsewhere.
#[inline]
pub fn gaussian_weight(offset: i32, sigma: f32) -> f32 {
    if sigma > 0.0 {
        let x = offset as f32 / sigma;
        float::exp(-0.5 * x * x)
    } else if offset == 0 {
        1.0
    } else {
        0.0
    }
}

/// One side of a normalised kernel: entry 0 is the centre, entry i stands for the texels at ±i; `N` is radius + 1.
///
/// The whole kernel, w₀ + 2 Σ wᵢ, sums to 1 within rounding. `N` of 0 gives an empty array.
#[inline]
pub fn gaussian_weights<const N: usize>(sigma: f32) -> [f32; N] {
    let mut weights = [0.0; N];
    let mut sum = 0.0;
    let mut i = 0;
    while i < N {
        weights[i] = gaussian_weight(i as i32, sigma);
        sum += if i == 0 { weights[i] } else { 2.0 * weights[i] };
        i += 1;
    }
    i = 0;
    while i < N {
        weights[i] /= sum;
        i += 1;
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_sum_to_one_and_fall_off() {
        for sigma in [0.3, 1.0, 2.5, 100.0] {
            let w: [f32; GAUSSIAN_MAX_RADIUS + 1] = gaussian_weights(sigma);
            let sum = w[0] + 2.0 * w[1..].iter().sum::<f32>();
            assert!((sum - 1.0).abs() < 1e-6, "{sigma}: {sum}");
            assert!(w.windows(2).all(|p| p[0] >= p[1] && p[1] >= 0.0), "{sigma}: {w:?}");
        }
    }

    #[test]
    fn ratios_are_those_of_a_gaussian() {
        let w: [f32; 3] = gaussian_weights(1.0);
        assert!((w[1] / w[0] - (-0.5f32).exp()).abs() < 1e-6);
        assert!((w[2] / w[0] - (-2.0f32).exp()).abs() < 1e-6);
    }

    #[test]
    fn a_sigma_that_is_not_positive_filters_nothing() {
        for sigma in [0.0, -1.0, f32::NAN] {
            assert_eq!(gaussian_weights::<3>(sigma), [1.0, 0.0, 0.0], "{sigma}");
        }
    }
}
