//! The Pareto frontier of time against error.

/// Which points no other beats: none is at least as fast and as right, and better in one of the two.
///
/// A point is `(milliseconds, error)`; one without a time, or with NaN, is never on the frontier.
pub fn frontier(points: &[(Option<f64>, f64)]) -> Vec<bool> {
    let known: Vec<Option<(f64, f64)>> = points
        .iter()
        .map(|&(ms, error)| ms.map(|ms| (ms, error)).filter(|p| !p.0.is_nan() && !p.1.is_nan()))
        .collect();
    let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1);
    known.iter().map(|p| p.is_some_and(|p| !known.iter().flatten().any(|&other| beats(other, p)))).collect()
}

#[cfg(test)]
mod tests {
    use super::frontier;

    #[test]
    fn only_unbeaten_points_are_on_it() {
        let points =
            [(Some(10.0), 0.0), (Some(1.0), 500.0), (Some(4.0), 3.0), (Some(5.0), 3.0), (Some(12.0), 0.0)];
        assert_eq!(frontier(&points), [true, true, true, false, false]);
    }

    #[test]
    fn equals_do_not_beat_each_other() {
        assert_eq!(frontier(&[(Some(1.0), 1.0), (Some(1.0), 1.0)]), [true, true]);
    }

    #[test]
    fn what_was_not_measured_is_not_on_it() {
        assert_eq!(
            frontier(&[(None, 0.0), (Some(f64::NAN), 0.0), (Some(1.0), f64::NAN), (Some(2.0), 9.0)]),
            [false, false, false, true]
        );
        assert!(frontier(&[]).is_empty());
    }
}
