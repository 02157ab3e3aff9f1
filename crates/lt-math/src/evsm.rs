//! EVSM: two Chebyshev bounds on exponentially warped depths, the smaller one counts (Lauritzen & McCool 2008).

use crate::vsm::DEFAULT_MIN_VARIANCE;
use crate::{ShadowTest, chebyshev, float};
use glam::Vec4;

/// The paper's positive exponent c₊, on depths in [0, 1].
pub const DEFAULT_POSITIVE_EXPONENT: f32 = 20.0;

/// The paper's negative exponent c₋, on depths in [0, 1].
pub const DEFAULT_NEGATIVE_EXPONENT: f32 = 5.0;

/// Larger exponents are clamped: the square e^{2c} must stay finite in f32, ln(f32::MAX)/2 = 44.36.
///
/// Maps in 16-bit floats bear no more than ln(65504)/2 = 5.545: see [`MAX_EVSM_EXPONENT_F16`].
pub const MAX_EVSM_EXPONENT: f32 = 42.0;

/// The largest exponent whose square still fits a 16-bit float, for those who store vectors as such.
pub const MAX_EVSM_EXPONENT_F16: f32 = 5.54;

/// Exponential variance shadow map: stores (p, p², n, n²) of p = e^{c₊z} and n = −e^{−c₋z}.
///
/// The paper prints a minus on the 4th channel: a misprint, it is a square. Depths stay in [0, 1] as in the paper; the
/// reference program's [−1, 1] is the same bound with doubled exponents, because Chebyshev's bound ignores scale.
///
/// The gather form warps z − d instead of z: again only a scale, yet numbers stay near 1 wherever the decision is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evsm {
    /// c₊ ≥ 0 per depth range; clamped at [`MAX_EVSM_EXPONENT`].
    pub positive_exponent: f32,
    /// c₋ ≥ 0 per depth range; clamped at [`MAX_EVSM_EXPONENT`].
    pub negative_exponent: f32,
    /// Lower limit of the variance in squared *depth*; each warp scales it by its squared slope at the receiver.
    ///
    /// A fixed variance in warped space (the paper's 1e-10) vanishes beside e^{40} and leaves acne; the reference
    /// program scales too, with 1e-8 for our 1e-10.
    pub min_variance: f32,
}

impl Default for Evsm {
    fn default() -> Self {
        Self {
            positive_exponent: DEFAULT_POSITIVE_EXPONENT,
            negative_exponent: DEFAULT_NEGATIVE_EXPONENT,
            min_variance: DEFAULT_MIN_VARIANCE,
        }
    }
}

impl Evsm {
    /// c₊ as used: at most [`MAX_EVSM_EXPONENT`].
    #[inline]
    pub fn positive(&self) -> f32 {
        float::min(self.positive_exponent, MAX_EVSM_EXPONENT)
    }

    /// c₋ as used: at most [`MAX_EVSM_EXPONENT`].
    #[inline]
    pub fn negative(&self) -> f32 {
        float::min(self.negative_exponent, MAX_EVSM_EXPONENT)
    }

    /// The smaller bound from depths relative to the receiver.
    fn bound_of_offsets(&self, offsets: Vec4, weights: Vec4) -> f32 {
        let c = self.positive();
        let positive =
            chebyshev::from_offsets(float::exp4(c * offsets) - Vec4::ONE, weights, self.min_variance * c * c);
        let c = self.negative();
        let negative = chebyshev::from_offsets(
            Vec4::ONE - float::exp4(-c * offsets),
            weights,
            self.min_variance * c * c,
        );
        float::saturate(float::min(positive, negative))
    }
}

impl ShadowTest for Evsm {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        let z = float::saturate(depth);
        let p = float::exp(self.positive() * z);
        let n = -float::exp(-self.negative() * z);
        Vec4::new(p, p * p, n, n * n)
    }

    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        let receiver = self.depth_vector(receiver_depth);
        let c = self.positive();
        let min_variance = self.min_variance * c * c * receiver.y;
        let positive = chebyshev::from_raw_moments(filtered.x, filtered.y, receiver.x, min_variance);
        let c = self.negative();
        let min_variance = self.min_variance * c * c * receiver.w;
        let negative = chebyshev::from_raw_moments(filtered.z, filtered.w, receiver.z, min_variance);
        float::saturate(float::min(positive, negative))
    }

    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let d = float::saturate(receiver_depth);
        let offsets = float::saturate4(depths) - Vec4::splat(d);
        if chebyshev::is_lit(offsets, weights) { 1.0 } else { self.bound_of_offsets(offsets, weights) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_footprint_behind_the_receiver_gets_what_the_full_formula_says() {
        let evsm = Evsm::default();
        for i in 0..4096u32 {
            let lane = |k: u32| (i.wrapping_mul(2_654_435_761 + 97 * k) >> 8) as f32 / 16_777_216.0;
            let scale = [1.0, 1e-3, 1e-7, 0.0][(i % 4) as usize];
            let offsets = scale * Vec4::new(lane(1), lane(2), lane(3), lane(4));
            let (fx, fy) = (lane(5), lane(6));
            let weights = Vec4::new((1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy);
            assert!(chebyshev::is_lit(offsets, weights));
            assert_eq!(evsm.bound_of_offsets(offsets, weights), 1.0, "{offsets} {weights}");
            assert!(!chebyshev::is_lit(offsets, weights * f32::NAN));
            assert!(!chebyshev::is_lit(offsets * f32::NAN, weights));
        }
    }
}
