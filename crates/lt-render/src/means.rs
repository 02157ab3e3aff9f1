//! What a frame costs on average: a median leaves out what few frames do, such as drawing a level of a map that is then kept.

use crate::FrameStats;

/// Mean times of a technique over several frames, milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanTimes {
    /// The first frame alone: it draws every map and has no history.
    pub first_ms: f64,
    /// Mean over the frames after it.
    pub later_ms: f64,
    /// Mean over all frames.
    pub all_ms: f64,
}

impl MeanTimes {
    /// Of frames in order; `None` for fewer than two, or where any lacks a timestamp.
    pub fn of(frames: &[FrameStats]) -> Option<Self> {
        let times: Vec<f64> = frames.iter().map(|f| f.ms(|_| true)).collect::<Option<_>>()?;
        let (&first_ms, later) = times.split_first().filter(|(_, later)| !later.is_empty())?;
        let later_sum: f64 = later.iter().sum();
        Some(Self {
            first_ms,
            later_ms: later_sum / later.len() as f64,
            all_ms: (first_ms + later_sum) / times.len() as f64,
        })
    }

    /// How many times the mean of `other` is that of this, over the frames after the first.
    pub fn speedup_over(&self, other: &Self) -> f64 {
        other.later_ms / self.later_ms.max(1e-9)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Pass, PassKind, metrics::Errors};

    fn frame(ms: Option<f64>) -> FrameStats {
        FrameStats {
            lights: Vec::new(),
            errors: Errors::default(),
            rays: 0,
            map_draws: 0,
            passes: vec![
                Pass { kind: PassKind::DepthMap, ms },
                Pass { kind: PassKind::Evaluate, ms: Some(1.0) },
            ],
            flips: None,
            mask: None,
        }
    }

    #[test]
    fn a_map_that_few_frames_draw_counts_and_the_first_frame_stands_apart() {
        let times = [90.0, 0.0, 0.0, 6.0].map(|ms| frame(Some(ms)));
        let means = MeanTimes::of(&times).unwrap();
        assert_eq!(means, MeanTimes { first_ms: 91.0, later_ms: 3.0, all_ms: 25.0 });
        assert_eq!(means.speedup_over(&MeanTimes { later_ms: 6.0, ..means }), 2.0);
    }

    #[test]
    fn a_missing_timestamp_or_frame_leaves_no_mean() {
        assert_eq!(MeanTimes::of(&[frame(Some(1.0)), frame(None)]), None);
        assert_eq!(MeanTimes::of(&[frame(Some(1.0))]), None);
        assert_eq!(MeanTimes::of(&[]), None);
    }
}
