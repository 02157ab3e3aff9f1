//! The measured tables of the numerics page: rows that concern correctness gate, at a tenth of their footprints.

use crate::support::measure::{
    close_layers, filtered, flat, four_depths, gathered, shares, two_layers, variance_errors,
};
use lt_math::{Evsm, MsmHamburger, MsmHausdorff, ShadowTest, Vsm};

const COUNT: u32 = 100_000;

#[test]
fn centred_variance_does_not_cancel_where_raw_moments_do() {
    for (mean, variance, raw_loses) in [(0.999, 1e-7, 0.4), (0.999, 1e-8, 1.0), (0.5, 1e-8, 1.0)] {
        let e = variance_errors(mean, variance);
        assert!(e.centred < 1e-5, "{mean} {variance}: {}", e.centred);
        assert!(e.raw > raw_loses, "{mean} {variance}: {}", e.raw);
    }
    // Shifting to [−1, 1] helps near ½ and hurts near 0.
    let half = variance_errors(0.5, 1e-8);
    let tenth = variance_errors(0.1, 1e-7);
    assert!(half.shifted < 1e-3 && tenth.shifted > tenth.raw && tenth.centred < 1e-5);
}

#[test]
fn hamburger_fails_as_often_as_published() {
    // bias, two layers confidently wrong, in percent; published with 10⁶ footprints.
    for (moment_bias, published) in [(0.0, 0.035), (3e-7, 0.029), (3e-6, 0.037), (3e-5, 0.098), (6e-5, 0.135)]
    {
        let test = MsmHamburger { moment_bias };
        let two = shares(test, COUNT, filtered, two_layers);
        let four = shares(test, COUNT, filtered, four_depths);
        let wrong = 100.0 * two.confidently_wrong;
        println!("{moment_bias:e}: published {published} %, measured {wrong:.3} %");
        // Three standard deviations of a count of 30 … 130 in 10⁵.
        assert!((wrong - published).abs() < 0.03 + 0.2 * published, "{moment_bias:e}: {wrong}");
        assert!((100.0 * four.confidently_wrong - 0.41).abs() < 0.08, "{}", four.confidently_wrong);
        // Every NaN asks for a ray.
        assert!(two.rays >= two.nan);
    }
}

#[test]
fn bias_buys_solvable_moments() {
    let nan = |moment_bias| shares(MsmHamburger { moment_bias }, COUNT, filtered, flat).nan;
    let [none, paper, large] = [0.0, 3e-6, 6e-5].map(nan);
    assert!(none > 0.5 && paper < 0.1 && large < 0.005, "{none} {paper} {large}");
    let interval = shares(MsmHausdorff::default(), COUNT, filtered, flat).nan;
    assert!(interval < 0.1, "{interval}");
}

#[test]
fn depths_in_hand_need_no_bias() {
    fn check<T: ShadowTest>(test: T, four_wrong: f64) {
        let [flat, close, two, four] = [
            shares(test, COUNT, gathered, flat),
            shares(test, COUNT, gathered, close_layers),
            shares(test, COUNT, gathered, two_layers),
            shares(test, COUNT, gathered, four_depths),
        ];
        for s in [&flat, &close, &two, &four] {
            assert_eq!((s.nan, s.below_truth), (0.0, 0.0));
        }
        // Four moments know two layers exactly: wrong are receivers within rounding behind a layer 3·10⁻⁴ before another.
        assert!(
            two.confidently_wrong < 2e-5 && close.confidently_wrong < 3e-3,
            "{}",
            close.confidently_wrong
        );
        // A property of the bound, not of rounding.
        assert!((four.confidently_wrong - four_wrong).abs() < 8e-4, "{}", four.confidently_wrong);
    }
    check(MsmHamburger { moment_bias: 0.0 }, 0.0041);
    check(MsmHausdorff { moment_bias: 0.0 }, 0.0024);
}

#[test]
fn close_layers_never_become_a_confident_shadow_by_rounding() {
    let below = [
        shares(Vsm::default(), COUNT, gathered, close_layers).below_truth,
        shares(Vsm::default(), COUNT, filtered, close_layers).below_truth,
        shares(Vsm { min_variance: 0.0 }, COUNT, filtered, close_layers).below_truth,
        shares(Evsm::default(), COUNT, gathered, close_layers).below_truth,
        shares(Evsm::default(), COUNT, filtered, close_layers).below_truth,
    ];
    assert_eq!(below, [0.0; 5]);
}

#[test]
fn the_minimum_variance_hardly_matters_once_the_variance_is_centred() {
    let rays = |min_variance| shares(Vsm { min_variance }, COUNT, gathered, two_layers).rays;
    assert!((rays(0.0) - rays(1e-10)).abs() < 1e-4);
}
