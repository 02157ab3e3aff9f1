//! The one-sided Chebyshev (Cantelli) bound on the lit fraction, from raw moments and from centred offsets.
//!
//! P(z ≥ d) ≤ σ² / (σ² + (d − μ)²) for d > μ, and 1 otherwise (Donnelly & Lauritzen 2006, eq. 5). From raw moments,
//! σ² = M₂ − M₁² cancels: near z = 1 and σ² = 1e-8 nothing of it survives in f32. With the four depths in hand we use
//! σ² = Σ w (zᵢ − μ)², measured from the receiver, and nothing cancels.

use crate::float;
use glam::Vec4;

/// How much of M₂ the difference M₂ − M₁² may lose to rounding: 2⁻²¹.
///
/// Eight roundings of 2⁻²⁴ relative to M₂ each: squaring, weighting and summing M₂ and M₁, and weights that sum to 1 only
/// within rounding. [`from_raw_moments`] adds that share of M₂ to the variance, because a bound that rounding has made too
/// small is a shadow claimed with confidence, while one too large merely costs a ray.
pub const RAW_VARIANCE_NOISE: f32 = 4.768_371_6e-7;

/// The bound for a variance and the receiver's distance behind the mean, `receiver − mean`; all in the same unit.
///
/// 1 for distances ≤ 0. NaN if an input is NaN, and where `variance` is 0 and the square of the distance underflows.
#[inline]
pub fn upper_bound(variance: f32, distance_behind_mean: f32) -> f32 {
    if distance_behind_mean <= 0.0 && !float::is_nan(variance) {
        1.0
    } else {
        variance / (variance + distance_behind_mean * distance_behind_mean)
    }
}

/// The bound from raw moments `mean` = M₁ and `second` = M₂ of a (warped) depth, for a receiver warped alike.
///
/// The variance is M₂ − M₁² plus [`RAW_VARIANCE_NOISE`]·M₂, and at least `min_variance`.
#[inline]
pub fn from_raw_moments(mean: f32, second: f32, receiver: f32, min_variance: f32) -> f32 {
    let variance = float::max(second - mean * mean + RAW_VARIANCE_NOISE * second, min_variance);
    upper_bound(variance, receiver - mean)
}

/// The bound from four offsets zᵢ − d of (warped) depths from the receiver, with their weights.
///
/// The variance Σ w (zᵢ − μ)² is computed centred and is at least `min_variance`.
#[inline]
pub fn from_offsets(offsets: Vec4, weights: Vec4, min_variance: f32) -> f32 {
    let mean = float::dot4(offsets, weights);
    let centred = offsets - Vec4::splat(mean);
    let variance = float::dot4(centred * centred, weights);
    upper_bound(float::max(variance, min_variance), -mean)
}

/// Whether no offset is negative, where [`from_offsets`] is 1 for every rising warp; not so for a NaN in either.
#[inline]
pub fn is_lit(offsets: Vec4, weights: Vec4) -> bool {
    let is_in_front = offsets.x >= 0.0 && offsets.y >= 0.0 && offsets.z >= 0.0 && offsets.w >= 0.0;
    is_in_front && !float::is_nan(float::dot4(offsets, weights))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_front_of_the_mean_is_lit_and_behind_falls_off() {
        assert_eq!([upper_bound(0.1, -1.0), upper_bound(0.1, 0.0), upper_bound(0.0, 0.0)], [1.0; 3]);
        assert_eq!(upper_bound(0.25, 0.5), 0.5);
        assert_eq!(upper_bound(0.0, 0.5), 0.0);
    }

    #[test]
    fn nan_is_not_lit() {
        assert!(upper_bound(f32::NAN, -1.0).is_nan());
        assert!(upper_bound(0.1, f32::NAN).is_nan());
        assert!(from_raw_moments(f32::NAN, 0.5, 0.2, 0.0).is_nan());
        assert!(from_raw_moments(0.5, f32::NAN, 0.2, 0.0).is_nan());
        assert!(from_offsets(Vec4::new(f32::NAN, 0.1, 0.1, 0.1), Vec4::splat(0.25), 0.0).is_nan());
    }

    #[test]
    fn two_layers_are_exact_at_the_far_one() {
        // Chebyshev's bound is attained by two masses, here a quarter at distance 0 and the rest in front.
        let offsets = Vec4::new(0.0, -0.5, -0.5, -0.5);
        assert_eq!(from_offsets(offsets, Vec4::splat(0.25), 0.0), 0.25);
    }

    #[test]
    fn raw_variance_is_never_below_its_noise() {
        // A true variance of 1e-9 vanishes in M2 − M1² near z = 1; the bound must not claim a shadow.
        let (a, b) = (0.99f32, 0.99006);
        let v = from_raw_moments(0.5 * (a + b), 0.5 * (a * a + b * b), b, 0.0);
        assert!(v >= 0.5, "{v}");
    }
}
