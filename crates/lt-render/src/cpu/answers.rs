//! What each shadow test answers for a batch of footprints, with the bits of the shared test.
//!
//! An exponential costs as much as the rest of a pixel, and most pixels can do without. [`Evsm`] asks [`Shortcut`]
//! first, which knows three kinds of footprint whose answer is certain. Moment bounds, comparisons and percentages are the shared tests'
//! own, pixel by pixel, where stages have not answered before.

use lt_math::glam::Vec4;
use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, ShadowTest, Sm, Vsm, chebyshev, float, six_atoms};
use lt_shaders::evaluate::TestFromParams;

use super::bits::{pack, places};
use super::footprints::Footprints;
use super::samples::Lanes;
use super::shortcut::Shortcut;
use super::tiles::PIECE;

/// A test that answers batches.
pub trait BatchTest: TestFromParams {
    /// Whether footprints hold depths minus the receivers', not depths.
    const FROM_RECEIVERS: bool;
    /// Visibilities with the bits of the test's own answer; with `LTT` it may also be 0 or 1 for an answer that is sure
    /// to lie on that side of doubt.
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, epsilon: f32) -> Lanes;
}

impl BatchTest for Vsm {
    const FROM_RECEIVERS: bool = true;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        let mut v = [0.0; PIECE];
        for (i, v) in v.iter_mut().enumerate() {
            let spread = Spread::of(footprints.offsets(i), footprints.weights(i));
            *v = float::saturate(spread.bound(self.min_variance));
        }
        v
    }
}

impl BatchTest for Evsm {
    const FROM_RECEIVERS: bool = true;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, epsilon: f32) -> Lanes {
        let shortcut = Shortcut::new(self, epsilon);
        let mut v = [0.0; PIECE];
        let mut is_open = [0; PIECE];
        for i in 0..PIECE {
            let offsets = footprints.offsets(i);
            let spread = Spread::of(offsets, footprints.weights(i));
            let [a, b, c, d] = offsets;
            let is_lit = (a >= 0.0) & (b >= 0.0) & (c >= 0.0) & (d >= 0.0) & !float::is_nan(spread.mean);
            if LTT {
                let is_surely_lit = is_lit | shortcut.is_lit(offsets, spread.mean, spread.variance);
                let is_surely_dark = shortcut.is_dark(offsets, spread.variance);
                v[i] = if is_surely_lit { 1.0 } else { 0.0 };
                is_open[i] = u8::from(!(is_surely_lit | is_surely_dark));
            } else {
                v[i] = 1.0;
                is_open[i] = u8::from(!is_lit);
            }
        }
        let open = pack(&is_open) & footprints.mapped;
        if open.count_ones() as usize >= DENSE {
            let answers = bounds(self, &footprints.offsets, &footprints.weights, PIECE);
            for i in 0..PIECE {
                v[i] = if is_open[i] != 0 { answers[i] } else { v[i] };
            }
        } else if open != 0 {
            answer_some(self, footprints, open, &mut v);
        }
        v
    }
}

impl BatchTest for Esm {
    const FROM_RECEIVERS: bool = true;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        let c = self.clamped_exponent();
        let mut v = [0.0; PIECE];
        for (i, v) in v.iter_mut().enumerate() {
            let ratios = footprints.offsets(i).map(|x| float::exp_lane(c * x));
            *v = float::saturate(dot(ratios, footprints.weights(i)));
        }
        v
    }
}

impl BatchTest for MsmHamburger {
    const FROM_RECEIVERS: bool = false;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        moment_bounds(self, footprints)
    }
}

impl BatchTest for MsmHausdorff {
    const FROM_RECEIVERS: bool = false;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        moment_bounds(self, footprints)
    }
}

impl BatchTest for Sm {
    const FROM_RECEIVERS: bool = false;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        one_by_one(self, footprints, footprints.mapped)
    }
}

impl BatchTest for Pcf {
    const FROM_RECEIVERS: bool = false;
    #[inline(always)]
    fn visibility_of_footprints<const LTT: bool>(&self, footprints: &Footprints, _: f32) -> Lanes {
        one_by_one(self, footprints, footprints.mapped)
    }
}

/// Bounds by four moments: 1 where no depth is in front of the receiver.
#[inline(always)]
fn moment_bounds(test: &impl ShadowTest, footprints: &Footprints) -> Lanes {
    let mut is_open = [0; PIECE];
    for (i, is_open) in is_open.iter_mut().enumerate() {
        let receiver = footprints.receivers[i] - six_atoms::RECEIVER_ROUNDING;
        let x = footprints.offsets(i).map(|depth| depth - receiver);
        let is_lit = (x[0] >= 0.0) & (x[1] >= 0.0) & (x[2] >= 0.0) & (x[3] >= 0.0);
        let is_number = !float::is_nan(dot(x, footprints.weights(i)));
        *is_open = u8::from(!(is_lit & is_number));
    }
    one_by_one(test, footprints, pack(&is_open) & footprints.mapped)
}

/// The shared test's answers for the pixels that are asked about, and 1 for others.
#[inline(always)]
fn one_by_one(test: &impl ShadowTest, footprints: &Footprints, asked: u64) -> Lanes {
    let mut v = [1.0; PIECE];
    for i in places(asked) {
        let (depths, weights) = (Vec4::from(footprints.offsets(i)), Vec4::from(footprints.weights(i)));
        v[i] = test.visibility_of_gather(depths, weights, footprints.receivers[i]);
    }
    v
}

/// With so many of a batch's pixels open it takes longer to pick them than to compute them all.
const DENSE: usize = PIECE * 3 / 4;

/// The full formula for the open pixels of a batch, picked together.
#[inline(always)]
fn answer_some(test: &Evsm, footprints: &Footprints, open: u64, v: &mut Lanes) {
    let (mut all, mut count) = ([0u8; PIECE], 0);
    for i in places(open) {
        all[count % PIECE] = i as u8;
        count += 1;
    }
    let open = &all[..count];
    let (mut offsets, mut weights) = ([[0.0; PIECE]; 4], [[0.0; PIECE]; 4]);
    // Row by row: pixel by pixel takes longer.
    for k in 0..4 {
        for (j, &i) in open.iter().enumerate() {
            offsets[k][j] = footprints.offsets[k][usize::from(i)];
            weights[k][j] = footprints.weights[k][usize::from(i)];
        }
    }
    let answers = bounds(test, &offsets, &weights, count.next_multiple_of(16).min(PIECE));
    for (&i, &answer) in open.iter().zip(&answers) {
        v[usize::from(i)] = answer;
    }
}

/// The full formula for the first `count` of some offsets and weights.
#[inline(always)]
fn bounds(test: &Evsm, offsets: &[Lanes; 4], weights: &[Lanes; 4], count: usize) -> Lanes {
    let (up, down) = (test.positive(), test.negative());
    let (mut warped_up, mut warped_down) = ([[0.0; PIECE]; 4], [[0.0; PIECE]; 4]);
    for k in 0..4 {
        let rows =
            warped_up[k][..count].iter_mut().zip(&mut warped_down[k][..count]).zip(&offsets[k][..count]);
        for ((warped_up, warped_down), x) in rows {
            *warped_up = float::exp_lane(up * x) - 1.0;
            *warped_down = 1.0 - float::exp_lane(-down * x);
        }
    }
    let mut v = [0.0; PIECE];
    for (j, v) in v[..count].iter_mut().enumerate() {
        let lane = |of: &[Lanes; 4]| [of[0][j], of[1][j], of[2][j], of[3][j]];
        let w = lane(weights);
        let positive = Spread::of(lane(&warped_up), w).bound(test.min_variance * up * up);
        let negative = Spread::of(lane(&warped_down), w).bound(test.min_variance * down * down);
        *v = float::saturate(float::min(positive, negative));
    }
    v
}

/// [`float::dot4`].
#[inline(always)]
fn dot(a: [f32; 4], w: [f32; 4]) -> f32 {
    a[0] * w[0] + a[1] * w[1] + a[2] * w[2] + a[3] * w[3]
}

/// Mean and variance of four numbers, in the order of operations of [`chebyshev::from_offsets`].
struct Spread {
    mean: f32,
    variance: f32,
}

impl Spread {
    #[inline(always)]
    fn of(x: [f32; 4], w: [f32; 4]) -> Self {
        let mean = dot(x, w);
        let centred = x.map(|x| x - mean);
        Self { mean, variance: dot(centred.map(|c| c * c), w) }
    }

    #[inline(always)]
    fn bound(&self, min_variance: f32) -> f32 {
        chebyshev::upper_bound(float::max(self.variance, min_variance), -self.mean)
    }
}
