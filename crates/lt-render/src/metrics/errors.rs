//! Wrong pixels of a binary shadow, told apart by the side they err on.

use super::largest_cluster;
use crate::Frame;

/// Wrong pixels of a technique against full ray tracing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Pixels the technique calls lit (visibility ≥ 0.5) though they are blocked.
    pub false_lit: u64,
    /// Pixels the technique calls blocked though they are lit.
    pub false_shadowed: u64,
    /// Valid pixels, of several lights each time.
    pub valid: u64,
    /// Pixels in the largest 8-connected cluster of wrong pixels (either kind).
    pub largest_cluster_px: u32,
}

impl Errors {
    /// False-lit pixels per million valid pixels; 0 when no pixel is valid.
    pub fn false_lit_ppm(&self) -> f64 {
        self.ppm(self.false_lit)
    }

    /// False-shadowed pixels per million valid pixels; 0 when no pixel is valid.
    pub fn false_shadowed_ppm(&self) -> f64 {
        self.ppm(self.false_shadowed)
    }

    /// Wrong pixels of either kind per million valid pixels; 0 when no pixel is valid.
    pub fn wrong_ppm(&self) -> f64 {
        self.ppm(self.false_lit + self.false_shadowed)
    }

    /// Those of several pictures together.
    pub fn sum(parts: impl IntoIterator<Item = Self>) -> Self {
        parts.into_iter().fold(Self::default(), |all, part| Self {
            false_lit: all.false_lit + part.false_lit,
            false_shadowed: all.false_shadowed + part.false_shadowed,
            valid: all.valid + part.valid,
            largest_cluster_px: all.largest_cluster_px.max(part.largest_cluster_px),
        })
    }

    fn ppm(&self, count: u64) -> f64 {
        count as f64 * 1e6 / self.valid.max(1) as f64
    }
}

/// What a pixel's visibility is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// On the truth's side of 0.5.
    Right,
    /// Lit though blocked.
    FalseLit,
    /// Blocked though lit.
    FalseShadowed,
}

/// Judges one visibility against the truth; a pixel counts as lit from 0.5 on.
///
/// NaN on either side is always wrong, counted on the side opposite to the truth (a NaN truth counts as blocked), so
/// that a technique can neither hide behind NaN nor be absolved by it.
pub fn verdict(reference: f32, visibility: f32) -> Verdict {
    let is_comparable = !reference.is_nan() && !visibility.is_nan();
    let is_truly_lit = reference >= 0.5;
    match is_truly_lit {
        _ if is_comparable && is_truly_lit == (visibility >= 0.5) => Verdict::Right,
        true => Verdict::FalseShadowed,
        false => Verdict::FalseLit,
    }
}

/// Counts the wrong pixels among the valid ones of a picture of `[width, height]` pixels, row by row.
///
/// All three slices should hold `width · height` values. Total all the same: a pixel that `valid` does not reach is
/// invalid, and a missing `reference` or `visibility` counts as NaN, which is wrong (see [`verdict`]).
pub fn errors(size: [u32; 2], valid: &[bool], reference: &[f32], visibility: &[f32]) -> Errors {
    let pixels = size[0] as usize * size[1] as usize;
    let at = |values: &[f32], i: usize| values.get(i).copied().unwrap_or(f32::NAN);
    let mut counts = Errors::default();
    let mut is_wrong = vec![false; pixels];
    for (i, wrong) in is_wrong.iter_mut().enumerate() {
        if !valid.get(i).copied().unwrap_or(false) {
            continue;
        }
        counts.valid += 1;
        let verdict = verdict(at(reference, i), at(visibility, i));
        counts.false_lit += u64::from(verdict == Verdict::FalseLit);
        counts.false_shadowed += u64::from(verdict == Verdict::FalseShadowed);
        *wrong = verdict != Verdict::Right;
    }
    counts.largest_cluster_px = largest_cluster(size, &is_wrong);
    counts
}

/// The wrong pixels of a frame, light by light, those of all layers together; `truth` was drawn of the same view under the same
/// lights. `valid` has a picture for each layer.
pub fn errors_by_light(size: [u32; 2], valid: &[Vec<bool>], truth: &Frame, frame: &Frame) -> Vec<Errors> {
    let mut sums = vec![Errors::default(); frame.each_light().len()];
    for (valid, (truth, frame)) in valid.iter().zip(truth.each_layer().iter().zip(frame.each_layer())) {
        let lights = truth.each_light().iter().zip(frame.each_light());
        for (sum, (truth, frame)) in sums.iter_mut().zip(lights) {
            *sum = Errors::sum([*sum, errors(size, valid, &truth.visibility, &frame.visibility)]);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [3, 2];
    const VALID: [bool; 6] = [true; 6];
    const TRUTH: [f32; 6] = [1.0, 0.0, 1.0, 0.0, 1.0, 0.0];

    #[test]
    fn the_truth_is_right() {
        let e = errors(SIZE, &VALID, &TRUTH, &TRUTH);
        assert_eq!(e, Errors { valid: 6, ..Errors::default() });
    }

    #[test]
    fn a_changed_pixel_counts_on_its_side() {
        let mut lit = TRUTH;
        lit[1] = 1.0;
        let e = errors(SIZE, &VALID, &TRUTH, &lit);
        assert_eq!((e.false_lit, e.false_shadowed, e.largest_cluster_px), (1, 0, 1));
        // The same change in the truth errs on the other side.
        let e = errors(SIZE, &VALID, &lit, &TRUTH);
        assert_eq!((e.false_lit, e.false_shadowed, e.largest_cluster_px), (0, 1, 1));
    }

    #[test]
    fn nan_is_wrong_on_either_side() {
        let mut bad = TRUTH;
        bad[0] = f32::NAN;
        assert_eq!(errors(SIZE, &VALID, &TRUTH, &bad).false_shadowed, 1);
        assert_eq!(errors(SIZE, &VALID, &bad, &TRUTH).false_lit, 1);
        assert_eq!(errors(SIZE, &VALID, &bad, &bad).false_lit, 1, "NaN against itself");
        bad = TRUTH;
        bad[1] = f32::NAN;
        assert_eq!(errors(SIZE, &VALID, &TRUTH, &bad).false_lit, 1);
    }

    #[test]
    fn missing_values_are_wrong() {
        let e = errors(SIZE, &VALID, &TRUTH, &TRUTH[..4]);
        assert_eq!((e.false_lit, e.false_shadowed, e.valid), (1, 1, 6));
        assert_eq!(errors(SIZE, &VALID, &TRUTH[..5], &TRUTH).false_lit, 1);
        assert_eq!(errors(SIZE, &VALID, &[], &[]).false_lit, 6);
    }

    #[test]
    fn invalid_pixels_do_not_count() {
        let mut valid = VALID;
        valid[1] = false;
        let mut lit = TRUTH;
        lit[1] = 1.0;
        let e = errors(SIZE, &valid, &TRUTH, &lit);
        assert_eq!(e, Errors { valid: 5, ..Errors::default() });
    }

    #[test]
    fn nothing_valid_is_zero_ppm() {
        let e = errors([0, 0], &[], &[], &[]);
        assert_eq!((e.valid, e.false_lit_ppm(), e.false_shadowed_ppm(), e.wrong_ppm()), (0, 0.0, 0.0, 0.0));
    }

    #[test]
    fn ppm_are_of_valid_pixels() {
        let e = Errors { false_lit: 1, false_shadowed: 3, valid: 4, largest_cluster_px: 1 };
        assert_eq!((e.false_lit_ppm(), e.false_shadowed_ppm(), e.wrong_ppm()), (250_000.0, 750_000.0, 1e6));
    }

    #[test]
    fn half_counts_as_lit() {
        assert_eq!(verdict(0.0, 0.5), Verdict::FalseLit);
        assert_eq!(verdict(1.0, 0.5), Verdict::Right);
        assert_eq!(verdict(1.0, 0.499), Verdict::FalseShadowed);
    }
}
