//! Techniques side by side: the same scene, the same samples, interleaved repeats, judged against full ray tracing.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::{EffectPlan, Frame, PassKind, RenderError, Session, Technique, metrics};

/// How to measure.
#[derive(Clone, Debug)]
pub struct CompareOptions {
    /// Timed repeats of every technique after one warm-up round; at least 1.
    pub repeats: usize,
    /// Whether to compute FLIP (costs a second or so a picture).
    pub with_flip: bool,
}

/// A pass over the repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassTime {
    /// Which.
    pub kind: PassKind,
    /// Median time, or `None` where the device has no timestamps.
    pub median_ms: Option<f64>,
    /// 95th percentile, likewise.
    pub p95_ms: Option<f64>,
}

/// One technique's result.
#[derive(Clone, Debug)]
pub struct Row {
    /// What ran.
    pub technique: Technique,
    /// The effects it called for.
    pub plan: EffectPlan,
    /// Shadow rays per valid pixel (a pixel with geometry).
    pub rays_per_pixel: f64,
    /// Wrong pixels against `ray`.
    pub errors: metrics::Errors,
    /// Mean FLIP of the shaded picture against the reference's, in [0, 1]; `None` if not asked for.
    pub flip_mean: Option<f64>,
    /// Every pass, median and p95 over the repeats.
    pub passes: Vec<PassTime>,
    /// Median time of the map passes; `None` without timestamps.
    pub map_ms: Option<f64>,
    /// Median time of estimate, doubt and resolve.
    pub shadow_ms: Option<f64>,
    /// Median of map plus shadow.
    pub total_ms: Option<f64>,
    /// Median total of `ray` over this median total.
    pub speedup_over_ray: Option<f64>,
    /// Bytes of map storage.
    pub map_bytes: u64,
    /// The last frame.
    pub frame: Frame,
    /// Its shaded picture, sRGB, row by row from the top.
    pub picture: Vec<[u8; 4]>,
}

/// All rows, and the truth they are judged by.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Pixels with geometry.
    pub valid_pixels: u64,
    /// Full ray tracing.
    pub reference: Frame,
    /// The reference's shaded picture.
    pub reference_picture: Vec<[u8; 4]>,
    /// In the order asked for.
    pub rows: Vec<Row>,
}

/// Runs every technique and judges it. `progress(done, total, what)` is called before each step.
///
/// `ray` is always rendered, listed or not: it is the reference and the base of the speed-ups. Each repeat runs all
/// techniques in turn, so that a disturbance of the machine hits all alike.
///
/// # Errors
/// Whatever the backend reports, or cancellation through `is_cancelled`.
pub fn compare(
    session: &mut Session,
    techniques: &[Technique],
    options: &CompareOptions,
    is_cancelled: &AtomicBool,
    mut progress: impl FnMut(usize, usize, &str),
) -> Result<Comparison, RenderError> {
    let mut jobs = vec![Technique::RAY];
    jobs.extend(techniques.iter().filter(|t| **t != Technique::RAY));
    let rounds = options.repeats.max(1) + 1;
    let steps = rounds * jobs.len();
    let mut runs: Vec<Vec<Vec<crate::Pass>>> = vec![Vec::new(); jobs.len()];
    let mut last: Vec<Option<Frame>> = vec![None; jobs.len()];
    for round in 0..rounds {
        for (i, job) in jobs.iter().enumerate() {
            if is_cancelled.load(Ordering::Relaxed) {
                return Err(RenderError::Cancelled);
            }
            progress(round * jobs.len() + i, steps, &job.to_string());
            let frame = session.render(job)?;
            if round > 0 {
                runs[i].push(frame.passes.clone());
            }
            last[i] = Some(frame);
        }
    }
    progress(steps, steps, "judging");
    let frames: Vec<Frame> = last.into_iter().flatten().collect();
    judge(session, &jobs, techniques, frames, &runs, options)
}

fn judge(
    session: &mut Session,
    jobs: &[Technique],
    wanted: &[Technique],
    frames: Vec<Frame>,
    runs: &[Vec<Vec<crate::Pass>>],
    options: &CompareOptions,
) -> Result<Comparison, RenderError> {
    let size = session.setup().size;
    let valid: Vec<bool> = session.samples().iter().map(|s| s.is_valid()).collect();
    let valid_pixels = valid.iter().filter(|v| **v).count() as u64;
    let mut pictures = Vec::with_capacity(jobs.len());
    for frame in &frames {
        pictures.push(session.shade(&frame.visibility)?);
    }
    let reference = frames[0].clone();
    let flips: Vec<Option<f64>> = pictures
        .par_iter()
        .map(|p| options.with_flip.then(|| metrics::flip_mean(size.x, size.y, &pictures[0], p)))
        .collect();
    let ray_ms = median_of(&runs[0], |_| true);
    let reference_picture = pictures[0].clone();
    let mut rows = Vec::new();
    for (i, (frame, picture)) in frames.into_iter().zip(pictures).enumerate() {
        if !wanted.contains(&jobs[i]) {
            continue;
        }
        let total_ms = median_of(&runs[i], |_| true);
        rows.push(Row {
            technique: jobs[i],
            plan: session.plan(&jobs[i]),
            rays_per_pixel: frame.rays as f64 / valid_pixels.max(1) as f64,
            errors: metrics::errors([size.x, size.y], &valid, &reference.visibility, &frame.visibility),
            flip_mean: flips[i],
            passes: pass_times(&runs[i]),
            map_ms: median_of(&runs[i], PassKind::makes_map),
            shadow_ms: median_of(&runs[i], |k| !k.makes_map()),
            total_ms,
            speedup_over_ray: ray_ms.zip(total_ms).map(|(ray, own)| ray / own.max(1e-9)),
            map_bytes: frame.map_bytes,
            frame,
            picture,
        });
    }
    rows.sort_by_key(|r| wanted.iter().position(|t| *t == r.technique));
    Ok(Comparison { size: [size.x, size.y], valid_pixels, reference, reference_picture, rows })
}

/// Median over the repeats of the summed time of the passes that `wanted` names; `None` if any lacks a timestamp.
fn median_of(repeats: &[Vec<crate::Pass>], wanted: impl Fn(PassKind) -> bool) -> Option<f64> {
    let sum = |passes: &Vec<crate::Pass>| -> Option<f64> {
        passes.iter().filter(|p| wanted(p.kind)).map(|p| p.ms).sum()
    };
    let times: Option<Vec<f64>> = repeats.iter().map(sum).collect();
    times.map(|t| quantile(t, 0.5))
}

fn pass_times(repeats: &[Vec<crate::Pass>]) -> Vec<PassTime> {
    let Some(first) = repeats.first() else { return Vec::new() };
    (0..first.len())
        .map(|i| {
            let times: Option<Vec<f64>> = repeats.iter().map(|r| r[i].ms).collect();
            PassTime {
                kind: first[i].kind,
                median_ms: times.clone().map(|t| quantile(t, 0.5)),
                p95_ms: times.map(|t| quantile(t, 0.95)),
            }
        })
        .collect()
}

/// The q-quantile by linear interpolation between order statistics; 0 for no values.
fn quantile(mut values: Vec<f64>, q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else { return 0.0 };
    let at = q * last as f64;
    let below = at.floor() as usize;
    values[below] + (values[(below + 1).min(last)] - values[below]) * at.fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate() {
        assert_eq!(quantile(vec![3.0, 1.0, 2.0], 0.5), 2.0);
        assert_eq!(quantile(vec![1.0, 2.0], 0.5), 1.5);
        assert_eq!(quantile(vec![], 0.5), 0.0);
    }

    #[test]
    fn a_missing_timestamp_is_missing_not_zero() {
        let pass = |ms| crate::Pass { kind: PassKind::Resolve, ms };
        assert_eq!(median_of(&[vec![pass(Some(1.0)), pass(None)]], |_| true), None);
        assert_eq!(median_of(&[vec![pass(Some(1.0)), pass(Some(2.0))]], |_| true), Some(3.0));
    }
}
