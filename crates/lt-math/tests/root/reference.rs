//! Every bound again in f64, by formulas of their own, and how near the f32 answers come.

use crate::support::random::Random;
use lt_math::glam::Vec4;
use lt_math::six_atoms::RECEIVER_ROUNDING;
use lt_math::{
    DEFAULT_MIN_VARIANCE, Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, ShadowTest, Vsm, lit_fraction,
};

fn wide(v: Vec4) -> [f64; 4] {
    v.to_array().map(f64::from)
}

/// Weights in f64, normalised.
fn wide_weights(v: Vec4) -> [f64; 4] {
    let w = wide(v);
    let sum: f64 = w.iter().sum();
    w.map(|x| x / sum)
}

fn expectation(z: [f64; 4], w: [f64; 4], f: impl Fn(f64) -> f64) -> f64 {
    (0..4).map(|i| w[i] * f(z[i])).sum()
}

fn chebyshev(z: [f64; 4], w: [f64; 4], d: f64, min_variance: f64) -> f64 {
    let mean = expectation(z, w, |x| x);
    let variance = expectation(z, w, |x| (x - mean).powi(2)).max(min_variance);
    if d <= mean { 1.0 } else { variance / (variance + (d - mean).powi(2)) }
}

pub fn vsm(z: Vec4, w: Vec4, d: f32) -> f64 {
    chebyshev(wide(z), wide_weights(w), d.into(), DEFAULT_MIN_VARIANCE.into())
}

pub fn esm(z: Vec4, w: Vec4, d: f32) -> f64 {
    expectation(wide(z), wide_weights(w), |z| (80.0 * (z - f64::from(d))).exp()).min(1.0)
}

pub fn evsm(z: Vec4, w: Vec4, d: f32) -> f64 {
    let d = f64::from(d);
    let bound = |warp: &dyn Fn(f64) -> f64, c: f64| {
        let min_variance = f64::from(DEFAULT_MIN_VARIANCE) * (c * warp(d)).powi(2);
        chebyshev(wide(z).map(warp), wide_weights(w), warp(d), min_variance)
    };
    bound(&|z| (20.0 * z).exp(), 20.0).min(bound(&|z| -(-5.0 * z).exp(), 5.0))
}

/// Moments 0 … 4, biased towards ½.
fn moments(z: [f64; 4], w: [f64; 4], bias: f64) -> [f64; 5] {
    let m = |k| (1.0 - bias) * expectation(z, w, |z| z.powi(k)) + bias * 0.5;
    [1.0, m(1), m(2), m(3), m(4)]
}

fn det3(m: [[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// Depths and masses of the extreme distribution on the line that has mass at `d`, by Cramer's rule.
fn hamburger_support(b: [f64; 5], d: f64) -> Vec<(f64, f64)> {
    let hankel = [[b[0], b[1], b[2]], [b[1], b[2], b[3]], [b[2], b[3], b[4]]];
    let z = [1.0, d, d * d];
    let c: Vec<f64> = (0..3)
        .map(|column| {
            let mut m = hankel;
            for (row, z) in z.into_iter().enumerate() {
                m[row][column] = z;
            }
            det3(m)
        })
        .collect();
    let root = (c[1] * c[1] - 4.0 * c[2] * c[0]).max(0.0).sqrt();
    let nodes = vec![d, (-c[1] - root) / (2.0 * c[2]), (-c[1] + root) / (2.0 * c[2])];
    with_masses(&nodes, b)
}

/// Depths and masses of the extreme distribution on [0, 1] that has mass at `d`.
fn hausdorff_support(b: [f64; 5], d: f64) -> Vec<(f64, f64)> {
    let free = hamburger_support(b, d);
    if free.iter().all(|&(z, _)| (0.0..=1.0).contains(&z)) {
        return free;
    }
    let p = [0.0, d, -(1.0 + d), 1.0];
    let shifted = |k: usize| (0..4).map(|i| p[i] * b[i + k]).sum::<f64>();
    with_masses(&[0.0, shifted(1) / shifted(0), d, 1.0], [b[0], b[1], b[2], b[3], b[4]])
}

/// Masses by Gaussian elimination of the Vandermonde system.
fn with_masses(nodes: &[f64], b: [f64; 5]) -> Vec<(f64, f64)> {
    let n = nodes.len();
    let mut m: Vec<Vec<f64>> =
        (0..n).map(|k| nodes.iter().map(|z| z.powi(k as i32)).chain([b[k]]).collect()).collect();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| m[a][i].abs().total_cmp(&m[b][i].abs())).unwrap();
        m.swap(i, pivot);
        for row in 0..n {
            if row != i {
                let factor = m[row][i] / m[i][i];
                let source = m[i].clone();
                m[row].iter_mut().zip(&source).for_each(|(x, s)| *x -= factor * s);
            }
        }
    }
    (0..n).map(|i| (nodes[i], m[i][n] / m[i][i])).collect()
}

fn lit(support: &[(f64, f64)], d: f64) -> f64 {
    support.iter().filter(|(z, _)| *z >= d).map(|(_, mass)| mass).sum()
}

/// The default bias.
const BIAS: f64 = 3e-6;

pub fn hamburger(z: Vec4, w: Vec4, d: f32) -> f64 {
    biased(z, w, d.into(), BIAS, hamburger_support)
}

pub fn hausdorff(z: Vec4, w: Vec4, d: f32) -> f64 {
    biased(z, w, d.into(), BIAS, hausdorff_support)
}

fn biased(z: Vec4, w: Vec4, d: f64, bias: f64, support: fn([f64; 5], f64) -> Vec<(f64, f64)>) -> f64 {
    lit(&support(moments(wide(z), wide_weights(w), bias), d), d)
}

/// For the receiver that the gather form takes, which has its answer for receivers in front of all.
fn gathered_reference(
    z: Vec4,
    w: Vec4,
    d: f32,
    bias: f32,
    support: fn([f64; 5], f64) -> Vec<(f64, f64)>,
) -> f64 {
    let d = f64::from(d - RECEIVER_ROUNDING);
    if d <= f64::from(z.min_element()) { 1.0 } else { biased(z, w, d, bias.into(), support) }
}

fn gathered_hamburger(bias: f32) -> impl Fn(Vec4, Vec4, f32) -> f64 {
    move |z, w, d| gathered_reference(z, w, d, bias, hamburger_support)
}

fn gathered_hausdorff(bias: f32) -> impl Fn(Vec4, Vec4, f32) -> f64 {
    move |z, w, d| gathered_reference(z, w, d, bias, hausdorff_support)
}

/// The largest difference, and the share of footprints that differ by more than 0.01 or are NaN.
fn difference<T: ShadowTest>(
    test: T,
    reference: impl Fn(Vec4, Vec4, f32) -> f64,
    is_gathered: bool,
) -> (f64, f64) {
    let mut random = Random::new(7);
    let (mut worst, mut far) = (0.0f64, 0.0);
    const COUNT: u32 = 50_000;
    for _ in 0..COUNT {
        let (z, w, d) = (random.four_depths(), random.weights(), random.unit());
        let v = if is_gathered {
            crate::support::measure::gathered(test, z, w, d)
        } else {
            crate::support::measure::filtered(test, z, w, d)
        };
        let error = (f64::from(v) - reference(z, w, d)).abs();
        if error > 0.01 || error.is_nan() {
            far += 1.0 / f64::from(COUNT);
        }
        worst = worst.max(error);
    }
    (worst, far)
}

#[test]
fn pcf_without_bias_is_the_lit_fraction() {
    let truth = |z, w, d| f64::from(lit_fraction(z, w, d));
    assert!(difference(Pcf { bias: 0.0 }, truth, true).0 < 1e-6);
}

#[test]
fn centred_variance_agrees_with_f64_to_rounding() {
    let (worst, _) = difference(Vsm::default(), vsm, true);
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn raw_variance_agrees_with_f64_but_for_its_noise() {
    let (worst, far) = difference(Vsm::default(), vsm, false);
    assert!(worst < 0.2 && far < 1e-3, "{worst} {far}");
}

#[test]
fn esm_agrees_with_f64_on_both_paths() {
    for is_gathered in [true, false] {
        let (worst, _) = difference(Esm::default(), esm, is_gathered);
        assert!(worst < 2e-5, "{worst}");
    }
}

#[test]
fn evsm_agrees_with_f64() {
    let (worst, _) = difference(Evsm::default(), evsm, true);
    assert!(worst < 1e-5, "{worst}");
    let (worst, far) = difference(Evsm::default(), evsm, false);
    assert!(worst < 0.2 && far < 1e-3, "{worst} {far}");
}

#[test]
fn filtered_moments_agree_with_f64_nearly_everywhere() {
    let (_, far) = difference(MsmHamburger::default(), hamburger, false);
    assert!(far < 0.01, "{far}");
    let (_, far) = difference(MsmHausdorff::default(), hausdorff, false);
    assert!(far < 0.01, "{far}");
}

#[test]
fn moments_of_depths_in_hand_agree_with_f64_at_every_bias() {
    for moment_bias in [0.0, 3e-7, 3e-6, 6e-5] {
        let line = difference(MsmHamburger { moment_bias }, gathered_hamburger(moment_bias), true);
        let interval = difference(MsmHausdorff { moment_bias }, gathered_hausdorff(moment_bias), true);
        println!("{moment_bias:e}: {:e} {:e}", line.0, interval.0);
        assert!(line.0 < 1e-5 && interval.0 < 1e-5, "{moment_bias:e}: {line:?} {interval:?}");
    }
}

/// The reference's own proof: its extreme distributions have the given moments, no negative mass, and stay in [0, 1].
#[test]
fn the_extreme_distributions_exist() {
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let (z, w, d) = (wide(random.four_depths()), wide_weights(random.weights()), random.unit());
        let b = moments(z, w, 1e-3);
        for (support, is_bounded) in
            [(hamburger_support(b, d.into()), false), (hausdorff_support(b, d.into()), true)]
        {
            for (k, b) in b.iter().enumerate() {
                let moment: f64 = support.iter().map(|(z, m)| m * z.powi(k as i32)).sum();
                assert!((moment - b).abs() < 1e-6, "moment {k}: {moment} {b} {support:?}");
            }
            for &(z, mass) in &support {
                assert!(mass > -1e-6, "{support:?}");
                assert!(!is_bounded || (-1e-9..=1.0 + 1e-9).contains(&z), "{support:?}");
            }
        }
    }
}
