//! Prints what a centred variance buys over raw moments, and how often four filtered moments fail in f32.
//!
//! `cargo run -p lt-math --release --example centred_variance [FOOTPRINTS]`

#[path = "../tests/root/support/mod.rs"]
mod support;

use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, ShadowTest, Vsm};
use support::measure::{
    Shares, close_layers, filtered, flat, four_depths, gathered, shares, two_layers, variance_errors,
};

const DEFAULT_FOOTPRINTS: u32 = 1_000_000;

fn main() {
    let count = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(DEFAULT_FOOTPRINTS);
    println!("Relative error of the variance of two depths, mean of 1000 pairs (f64 is the reference)\n");
    println!("| mean z | variance | M2-M1^2 in [0,1] | M2-M1^2 in [-1,1] | centred |\n|---|---|---|---|---|");
    for (mean, variance) in [(0.999, 1e-7), (0.999, 1e-8), (0.5, 1e-8), (0.1, 1e-7)] {
        let e = variance_errors(mean, variance);
        let [raw, shifted, centred] = [e.raw, e.shifted, e.centred].map(|x| 100.0 * x);
        println!("| {mean} | {variance:e} | {raw:.1} % | {shifted:.1} % | {centred:.6} % |");
    }

    println!("\nFour filtered moments in f32, {count} random 2x2 footprints, bias towards 1/2\n");
    println!("| kind | bias | flat, d = z: NaN | two layers: NaN | two layers: wrong | four depths: wrong |");
    println!("|---|---|---|---|---|---|");
    for moment_bias in [0.0, 3e-7, 3e-6, 3e-5, 6e-5] {
        print_moments(count, "Hamburger", moment_bias, MsmHamburger { moment_bias });
        print_moments(count, "Hausdorff", moment_bias, MsmHausdorff { moment_bias });
    }

    println!("\nEach kind, {count} footprints each: rays / confidently wrong / below the truth\n");
    println!("| kind | path | two close layers | two layers | four depths |\n|---|---|---|---|---|");
    print_kind(count, "PCF", Pcf { bias: 0.0 });
    print_kind(count, "VSM", Vsm::default());
    print_kind(count, "VSM, no minimum variance", Vsm { min_variance: 0.0 });
    print_kind(count, "ESM", Esm::default());
    print_kind(count, "EVSM (20, 5)", Evsm::default());
    print_kind(
        count,
        "EVSM (40, 10): (20, 5) on [-1,1]",
        Evsm { positive_exponent: 40.0, negative_exponent: 10.0, ..Evsm::default() },
    );
    print_kind(count, "EVSM, minimum variance 1e-8", Evsm { min_variance: 1e-8, ..Evsm::default() });
    print_kind(count, "MSM Hamburger", MsmHamburger::default());
    print_kind(count, "MSM Hausdorff", MsmHausdorff::default());
}

fn percent(share: f64) -> String {
    format!("{:.3} %", 100.0 * share)
}

fn print_moments<T: ShadowTest>(count: u32, kind: &str, bias: f32, test: T) {
    let flat = shares(test, count, filtered, flat).nan;
    let two = shares(test, count, filtered, two_layers);
    let four = shares(test, count, filtered, four_depths).confidently_wrong;
    let [flat, nan, wrong, four] = [flat, two.nan, two.confidently_wrong, four].map(percent);
    println!("| {kind} | {bias:e} | {flat} | {nan} | {wrong} | {four} |");
}

fn print_kind<T: ShadowTest>(count: u32, kind: &str, test: T) {
    let cell = |s: Shares| {
        let [rays, wrong, below] = [s.rays, s.confidently_wrong, s.below_truth].map(percent);
        format!("{rays} / {wrong} / {below}")
    };
    let close = cell(shares(test, count, gathered, close_layers));
    let two = cell(shares(test, count, gathered, two_layers));
    let four = cell(shares(test, count, gathered, four_depths));
    println!("| {kind} | gather | {close} | {two} | {four} |");
    let close = cell(shares(test, count, filtered, close_layers));
    let two = cell(shares(test, count, filtered, two_layers));
    let four = cell(shares(test, count, filtered, four_depths));
    println!("| {kind} | filtered | {close} | {two} | {four} |");
}
