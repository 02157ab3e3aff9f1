//! Measurements behind the tables of the numerics page: what raw moments lose, how often four moments fail.

use super::random::Random;
use lt_math::glam::Vec4;
use lt_math::{LTT_EPSILON, ShadowTest, lit_fraction, needs_ray};

/// Relative errors of a variance that was computed in three ways, averaged over many means.
pub struct VarianceError {
    /// M₂ − M₁² of depths in [0, 1].
    pub raw: f64,
    /// The same of depths moved to [−1, 1].
    pub shifted: f64,
    /// Σ w (z − z̄)².
    pub centred: f64,
}

/// Two equally weighted depths around `mean` with the given true variance, over 1000 slightly different means.
///
/// The reference is f64 on the very f32 depths.
pub fn variance_errors(mean: f64, variance: f64) -> VarianceError {
    let mut sum = VarianceError { raw: 0.0, shifted: 0.0, centred: 0.0 };
    for i in 0..1000 {
        let mean = mean + f64::from(i - 500) * 1.37e-7;
        let (a, b) = ((mean - variance.sqrt()) as f32, (mean + variance.sqrt()) as f32);
        let truth = ((f64::from(b) - f64::from(a)) / 2.0).powi(2);
        let raw = |a: f32, b: f32| {
            let m = 0.5 * a + 0.5 * b;
            (0.5 * (a * a) + 0.5 * (b * b)) - m * m
        };
        let m = 0.5 * a + 0.5 * b;
        let centred = 0.5 * ((a - m) * (a - m)) + 0.5 * ((b - m) * (b - m));
        let error = |v: f32| (f64::from(v) - truth).abs() / truth;
        sum.raw += error(raw(a, b));
        sum.shifted += error(raw(2.0 * a - 1.0, 2.0 * b - 1.0) / 4.0);
        sum.centred += error(centred);
    }
    VarianceError { raw: sum.raw / 1e3, shifted: sum.shifted / 1e3, centred: sum.centred / 1e3 }
}

/// Shares of footprints, 0 … 1.
#[derive(Default)]
pub struct Shares {
    /// NaN answers.
    pub nan: f64,
    /// Asks for a ray, NaN included.
    pub rays: f64,
    /// Confident, but lit where more than half of the footprint blocks, or shadowed where less than half does.
    pub confidently_wrong: f64,
    /// Confidently shadowed although ε of the footprint or more is lit: what an upper bound must never be.
    pub below_truth: f64,
}

/// Asks `test` about `count` footprints that `footprint` draws as (depths, weights, receiver).
pub fn shares<T: ShadowTest>(
    test: T,
    count: u32,
    mut answer: impl FnMut(T, Vec4, Vec4, f32) -> f32,
    mut footprint: impl FnMut(&mut Random) -> (Vec4, Vec4, f32),
) -> Shares {
    let mut random = Random::new(1);
    let mut shares = Shares::default();
    let one = 1.0 / f64::from(count);
    for _ in 0..count {
        let (depths, weights, d) = footprint(&mut random);
        let v = answer(test, depths, weights, d);
        let truth = lit_fraction(depths, weights, d);
        if v.is_nan() {
            shares.nan += one;
        }
        if needs_ray(v, LTT_EPSILON) {
            shares.rays += one;
        } else if (v < 0.5) != (truth < 0.5) {
            shares.confidently_wrong += one;
        }
        if v < LTT_EPSILON && truth > 2.0 * LTT_EPSILON {
            shares.below_truth += one;
        }
    }
    shares
}

/// The 2×2 gather path.
pub fn gathered<T: ShadowTest>(test: T, depths: Vec4, weights: Vec4, d: f32) -> f32 {
    test.visibility_of_gather(depths, weights, d)
}

/// The path of stored, filtered vectors.
pub fn filtered<T: ShadowTest>(test: T, depths: Vec4, weights: Vec4, d: f32) -> f32 {
    let b = |z| test.depth_vector(z);
    test.visibility(lt_math::blend(b(depths.x), b(depths.y), b(depths.z), b(depths.w), weights), d)
}

/// Four equal depths, and a receiver at that depth.
pub fn flat(random: &mut Random) -> (Vec4, Vec4, f32) {
    let z = random.unit();
    (Vec4::splat(z), random.weights(), z)
}

/// Two layers, and a receiver anywhere.
pub fn two_layers(random: &mut Random) -> (Vec4, Vec4, f32) {
    (random.two_layers(), random.weights(), random.unit())
}

/// Four depths, and a receiver anywhere.
pub fn four_depths(random: &mut Random) -> (Vec4, Vec4, f32) {
    (random.four_depths(), random.weights(), random.unit())
}

/// Two layers about 3·10⁻⁴ apart, and a receiver between them: where raw moments drown in rounding.
pub fn close_layers(random: &mut Random) -> (Vec4, Vec4, f32) {
    let z = 0.01 + 0.98 * random.unit();
    let gap = 1e-3 * random.unit();
    let mut pick = || if random.unit() < 0.5 { z } else { z + gap };
    let depths = Vec4::new(pick(), pick(), pick(), pick());
    (depths, random.weights(), z + gap * random.unit())
}
