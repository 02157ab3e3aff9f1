//! Footprints whose EVSM answer is certain without an exponential: surely lit, or surely shadowed, for a given ε.
//!
//! EVSM is the smaller of two Chebyshev bounds, of depths warped by p(x) = e^{c₊x} − 1 and by n(x) = 1 − e^{−c₋x}, where
//! x is the distance behind the receiver. Write μ and σ² for mean and variance of x (σ² at least the least variance),
//! and Var, D for the variance and the warped mean's distance in front of the receiver. A bound is Var / (Var + D²).
//!
//! **Surely shadowed.** Let all x ≤ −b < 0. There p is flatter than c₊, so that Var ≤ c₊²σ², and
//! D ≥ 1 − e^{−c₊b} ≥ c₊b / (1 + c₊b). The positive bound, hence the answer, is at most ε if
//! σ²(1 + c₊b)² ≤ b² ε/(1 − ε).
//!
//! **Surely lit.** Let all |x| ≤ t. Both warps are steeper than c·e^{−ct}, so that Var ≥ c²e^{−2ct}σ². By Jensen,
//! D ≤ −c₊μ for p (and nothing where μ ≥ 0); for n, e^y ≤ 1 + y + ½y²e^{|y|} gives D ≤ −c₋μ + ½c₋²e^{c₋t}M with
//! M = μ² + σ². Both bounds are at least 1 − ε if (max(−μ, 0) + ½c₋e^{c₋t}M)² e^{2ct} ≤ σ² ε/(1 − ε) for the larger c.
//! We only look at t with ct ≤ [`REACH`].
//!
//! **Rounding.** The shared function computes a warp within 3·10⁻⁷ of its value, and means, variances and quotients
//! within a few 2⁻²⁴ more. [`WARP_ERROR`] is allowed to D (as a depth, over c) and [`MARGIN`] on ε/(1 − ε) takes in the
//! rest: a shortcut's answer is on the side of ε that the shared function's is, by far.

use lt_math::{Evsm, float};

/// ct up to which [`Shortcut::is_lit`] looks: e^{2ct} is at most 1.082 then.
const REACH: f32 = 0.039;

/// e^{2·REACH}, rounded up.
const SLOPE_SQUARED: f32 = 1.082;

/// e^{REACH}, rounded up.
const CURVATURE: f32 = 1.04;

/// What rounding may add to a warped mean's distance, and more.
const WARP_ERROR: f32 = 6.0e-7;

/// Part of ε/(1 − ε) that a shortcut asks for.
const MARGIN: f32 = 0.9;

/// Receivers less far behind the footprint, in depth, are not called surely shadowed: rounding of warps would tell.
const LEAST_DISTANCE: f32 = 1.0e-4;

/// Bounds of one pass, made once.
#[derive(Clone, Copy, Debug)]
pub struct Shortcut {
    /// MARGIN·ε/(1 − ε)
    odds: f32,
    min_variance: f32,
    positive: f32,
    half_negative: f32,
    /// Largest |x| of a surely lit footprint.
    reach: f32,
    /// Rounding of the warped means, as depth.
    slack: f32,
}

impl Shortcut {
    /// For a test and LTT's ε; with ε outside (0, ½) or a negative or infinite number anywhere, nothing is ever sure.
    #[inline]
    pub fn new(test: &Evsm, epsilon: f32) -> Self {
        let (up, down) = (test.positive(), test.negative());
        let is_usable = up > 0.0 && down > 0.0 && epsilon > 0.0 && epsilon < 0.5 && test.min_variance >= 0.0;
        let odds = if is_usable { MARGIN * epsilon / (1.0 - epsilon) } else { -1.0 };
        let larger = float::max(up, down);
        let smaller = float::min(up, down);
        Self {
            odds,
            min_variance: test.min_variance,
            positive: up,
            half_negative: 0.5 * down,
            reach: REACH / larger,
            slack: WARP_ERROR / smaller,
        }
    }

    /// At least the least variance; NaN stays one, so that no comparison with it holds.
    #[inline(always)]
    fn limited(&self, variance: f32) -> f32 {
        if variance < self.min_variance { self.min_variance } else { variance }
    }

    /// Whether the test's answer is at least 1 − ε, for certain. False for NaN.
    #[inline(always)]
    pub fn is_lit(&self, offsets: [f32; 4], mean: f32, variance: f32) -> bool {
        let [a, b, c, d] = offsets.map(f32::abs);
        let is_near = (a <= self.reach) & (b <= self.reach) & (c <= self.reach) & (d <= self.reach);
        let variance = self.limited(variance);
        let in_front = if mean < 0.0 { -mean } else { 0.0 };
        let curved = self.half_negative * CURVATURE * (mean * mean + variance);
        let distance = in_front + curved + self.slack;
        is_near & (distance * distance * SLOPE_SQUARED <= variance * self.odds)
    }

    /// Whether the test's answer is at most ε, for certain. False for NaN.
    #[inline(always)]
    pub fn is_dark(&self, offsets: [f32; 4], variance: f32) -> bool {
        let [a, b, c, d] = offsets;
        let larger = |a: f32, b: f32| if a > b { a } else { b };
        let distance = -larger(larger(a, b), larger(c, d));
        let is_number = !float::is_nan(a + b + c + d);
        let variance = self.limited(variance);
        let stretch = 1.0 + self.positive * distance;
        let is_tight = variance * stretch * stretch <= distance * distance * self.odds;
        is_number & (distance >= LEAST_DISTANCE) & is_tight
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::glam::Vec4;
    use lt_math::{ShadowTest, bilinear_footprint, glam::Vec2};

    /// Sloped, layered and loose footprints of all sizes, near and far from the receiver.
    #[test]
    fn what_is_called_sure_is_what_the_full_formula_says() {
        let mut state = 1u64;
        let mut unit = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / 16_777_216.0
        };
        let tests = [
            Evsm::default(),
            Evsm { min_variance: 0.0, ..Evsm::default() },
            Evsm { positive_exponent: 42.0, negative_exponent: 42.0, min_variance: 1e-12 },
            Evsm { positive_exponent: 0.5, negative_exponent: 30.0, min_variance: 1e-7 },
        ];
        for test in tests {
            for epsilon in [1e-3, 0.01, 0.1, 0.4] {
                let shortcut = Shortcut::new(&test, epsilon);
                let (mut lit, mut dark) = (0, 0);
                for i in 0..200_000 {
                    let d = unit();
                    let size = 10f32.powf(-7.0 * unit());
                    let weights = bilinear_footprint(Vec2::new(unit(), unit())).weights;
                    let (slope_x, slope_y) = (size * (unit() - 0.5), size * (unit() - 0.5));
                    let plane = Vec4::new(0.0, slope_x, slope_y, slope_x + slope_y);
                    let loose = size * Vec4::new(unit(), unit(), unit(), unit());
                    let shape = [plane, loose, plane + 0.01 * loose][i % 3];
                    let mean = (shape * weights).element_sum();
                    let gap = [0.0, 0.2, 10.0, 40.0][i / 3 % 4] * size * (unit() - 0.5);
                    let depths =
                        (Vec4::splat(d) + shape - Vec4::splat(mean - gap)).clamp(Vec4::ZERO, Vec4::ONE);
                    let offsets = depths - Vec4::splat(d);
                    let mean = float::dot4(offsets, weights);
                    let centred = offsets - Vec4::splat(mean);
                    let variance = float::dot4(centred * centred, weights);
                    let v = test.visibility_of_gather(depths, weights, d);
                    if shortcut.is_lit(offsets.to_array(), mean, variance) {
                        lit += 1;
                        assert!(v >= 1.0 - epsilon, "{test:?} {epsilon} {depths} {weights} {d}: {v}");
                    }
                    if shortcut.is_dark(offsets.to_array(), variance) {
                        dark += 1;
                        assert!(v <= epsilon, "{test:?} {epsilon} {depths} {weights} {d}: {v}");
                    }
                }
                assert!(lit > 500 && dark > 500, "{test:?} {epsilon}: {lit} lit, {dark} dark");
            }
        }
    }

    #[test]
    fn nothing_is_sure_of_a_nan_or_for_strange_parameters() {
        let sure = |s: Shortcut, offsets: [f32; 4], mean, variance| {
            s.is_lit(offsets, mean, variance) || s.is_dark(offsets, variance)
        };
        let usual = Shortcut::new(&Evsm::default(), 0.01);
        assert!(sure(usual, [1e-4; 4], 1e-4, 0.0) && sure(usual, [-0.3; 4], -0.3, 0.0));
        for offsets in [[1e-4; 4], [-0.3; 4]] {
            assert!(!sure(usual, offsets, f32::NAN, f32::NAN));
            for lane in 0..4 {
                let mut broken = offsets;
                broken[lane] = f32::NAN;
                assert!(!sure(usual, broken, offsets[0], 0.0));
            }
            for epsilon in [0.0, -1.0, 0.5, 1.0, f32::NAN] {
                assert!(
                    !sure(Shortcut::new(&Evsm::default(), epsilon), offsets, offsets[0], 0.0),
                    "{epsilon}"
                );
            }
            for broken in [f32::NAN, -1.0] {
                let min_variance = Evsm { min_variance: broken, ..Evsm::default() };
                let exponent = Evsm { positive_exponent: broken, ..Evsm::default() };
                for test in [min_variance, exponent] {
                    assert!(!sure(Shortcut::new(&test, 0.01), offsets, offsets[0], 0.0), "{test:?}");
                }
            }
        }
    }
}
