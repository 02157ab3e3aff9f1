//! Techniques side by side: the same scene, the same samples, interleaved repeats, judged against full ray tracing.
//!
//! Where pixels have several samples, or the camera sees several layers, whatever is counted is counted sample by sample, in all
//! layers: wrong ones, those with geometry, rays.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::{
    EffectPlan, Frame, MaskBits, MeanTimes, PassKind, RenderError, SampleGrid, Session, Technique,
    map_memory, metrics,
};

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
    /// Shadow rays per valid pixel (a pixel with geometry). Of several frames this, [`Row::rays`], [`Row::errors`] and [`Row::lights`] are
    /// medians, or the last one's where nothing moves.
    pub rays_per_pixel: f64,
    /// Shadow rays for all lights.
    pub rays: u64,
    /// Wrong pixels against `ray`, those of several lights together.
    pub errors: metrics::Errors,
    /// Each light's share, where several shine; else empty.
    pub lights: Vec<LightStats>,
    /// Mean FLIP of [`Row::picture`] against the reference's, in [0, 1]; `None` if not asked for.
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
    /// Mean times over the frames; `None` for a single view, or without timestamps.
    pub means: Option<MeanTimes>,
    /// The same ratio of those means.
    pub speedup_by_means: Option<f64>,
    /// Bytes of map storage.
    pub map_bytes: u64,
    /// The last frame.
    pub frame: Frame,
    /// Its shaded picture, sRGB, row by row from the top.
    pub picture: Vec<[u8; 4]>,
    /// Frame by frame, where several were played; else empty.
    pub frames: Vec<FrameStats>,
}

/// One light's share of what a technique did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightStats {
    /// Wrong pixels against `ray`.
    pub errors: metrics::Errors,
    /// Shadow rays.
    pub rays: u64,
}

impl LightStats {
    /// Shadow rays per valid pixel.
    pub fn rays_per_pixel(&self) -> f64 {
        self.rays as f64 / self.errors.valid.max(1) as f64
    }

    /// Of every light, in a frame and against the truth.
    fn each(size: [u32; 2], valid: &[Vec<bool>], truth: &Frame, frame: &Frame) -> Vec<Self> {
        let errors = metrics::errors_by_light(size, valid, truth, frame);
        errors.into_iter().zip(frame.each_light()).map(|(errors, f)| Self { errors, rays: f.rays }).collect()
    }
}

/// One technique in one frame of several.
#[derive(Clone, Debug)]
pub struct FrameStats {
    /// Every light's share, at least one's.
    pub lights: Vec<LightStats>,
    /// Wrong pixels against `ray` in the same frame, those of several lights together.
    pub errors: metrics::Errors,
    /// Shadow rays.
    pub rays: u64,
    /// Maps drawn.
    pub map_draws: u32,
    /// Passes that ran.
    pub passes: Vec<crate::Pass>,
    /// Pixels whose visibility differs, bit by bit, from the frame before; only where nothing moves.
    pub flips: Option<u64>,
    /// What the temporal mask remembers, for the frames that [`PlayOptions::mask_frames`] asks for.
    pub mask: Option<Vec<MaskBits>>,
}

impl FrameStats {
    /// Time of the passes that `wanted` names, or `None` if any lacks a timestamp.
    pub fn ms(&self, wanted: impl Fn(PassKind) -> bool) -> Option<f64> {
        total_ms(&self.passes, wanted)
    }

    /// Shadow rays per valid pixel, for all lights.
    pub fn rays_per_pixel(&self) -> f64 {
        self.lights.iter().map(LightStats::rays_per_pixel).sum()
    }
}

/// What several frames show.
#[derive(Clone, Debug)]
pub struct PlayOptions {
    /// How many; at least 1.
    pub frames: usize,
    /// Nothing moves: errors are the last frame's, and flips are counted.
    pub is_still: bool,
    /// Whether to compute FLIP of the last frame.
    pub with_flip: bool,
    /// Frames whose masks are kept for pictures.
    pub mask_frames: Vec<usize>,
}

/// All rows, and the truth they are judged by.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Samples of a pixel.
    pub samples: SampleGrid,
    /// Pixels, or samples, with geometry.
    pub valid_pixels: u64,
    /// Full ray tracing.
    pub reference: Frame,
    /// The reference's shaded picture.
    pub reference_picture: Vec<[u8; 4]>,
    /// In the order asked for.
    pub rows: Vec<Row>,
}

impl Comparison {
    /// What is counted: `pixel`, or `sample` where pixels have several or the camera sees several layers.
    pub fn unit(&self) -> &'static str {
        let is_one = self.samples == SampleGrid::ONE && self.reference.layers.is_empty();
        if is_one { "pixel" } else { "sample" }
    }

    /// Width and height in samples: of visibilities, doubts and masks.
    pub fn size_in_samples(&self) -> [u32; 2] {
        let grid = self.samples.size();
        [self.size[0] * grid.x, self.size[1] * grid.y]
    }
}

/// Runs every technique and judges it. `progress(done, total, what)` is called before each step.
///
/// `ray` is always rendered, listed or not: it is the reference and the base of the speed-ups. Each repeat runs all
/// techniques in turn, so that a disturbance of the machine hits all alike.
///
/// # Errors
/// [`RenderError::BadSetup`] where all maps together exceed [`crate::MAX_MAP_BYTES`]; whatever the backend reports; or cancellation through
/// `is_cancelled`.
pub fn compare(
    session: &mut Session,
    techniques: &[Technique],
    options: &CompareOptions,
    is_cancelled: &AtomicBool,
    mut progress: impl FnMut(usize, usize, &str),
) -> Result<Comparison, RenderError> {
    map_memory::check(session, techniques)?;
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

/// Plays frames: every technique draws each of them before the next, and each is judged by full ray tracing of the same
/// frame. `step(session, i)` moves the session on to frame i > 0; [`Session::play`] was told what that changes.
///
/// Before the first frame every technique draws once to warm up, and then forgets. Times are medians over the frames;
/// errors are medians, or the last frame's where nothing moves.
///
/// # Errors
/// [`RenderError::BadSetup`] where all maps together exceed [`crate::MAX_MAP_BYTES`]; whatever the backend or `step` reports; or cancellation
/// through `is_cancelled`.
pub fn compare_frames(
    session: &mut Session,
    techniques: &[Technique],
    options: &PlayOptions,
    mut step: impl FnMut(&mut Session, usize) -> Result<(), RenderError>,
    is_cancelled: &AtomicBool,
    mut progress: impl FnMut(usize, usize, &str),
) -> Result<Comparison, RenderError> {
    map_memory::check(session, techniques)?;
    let mut jobs = vec![Technique::RAY];
    jobs.extend(techniques.iter().filter(|t| **t != Technique::RAY));
    let steps = (options.frames + 1) * jobs.len();
    for (i, job) in jobs.iter().enumerate() {
        progress(i, steps, &format!("warming up {job}"));
        session.render(job)?;
    }
    session.play(session.sequence());
    let mut played: Vec<Vec<FrameStats>> = vec![Vec::new(); jobs.len()];
    let mut last: Vec<Frame> = Vec::new();
    for frame_index in 0..options.frames.max(1) {
        if frame_index > 0 {
            step(session, frame_index)?;
        }
        let size = session.setup().size_in_samples().to_array();
        let valid = session.valid_samples();
        let mut frames: Vec<Frame> = Vec::new();
        for (i, job) in jobs.iter().enumerate() {
            if is_cancelled.load(Ordering::Relaxed) {
                return Err(RenderError::Cancelled);
            }
            progress((frame_index + 1) * jobs.len() + i, steps, &format!("frame {frame_index}: {job}"));
            let frame = session.render(job)?;
            let truth = frames.first().unwrap_or(&frame);
            let lights = LightStats::each(size, &valid, truth, &frame);
            played[i].push(FrameStats {
                errors: metrics::Errors::sum(lights.iter().map(|l| l.errors)),
                lights,
                rays: frame.rays,
                map_draws: frame.map_draws,
                passes: frame.passes.clone(),
                flips: last.get(i).filter(|_| options.is_still).map(|before| flips(before, &frame)),
                mask: (options.mask_frames.contains(&frame_index) && !frame.mask.is_empty())
                    .then(|| frame.mask.clone()),
            });
            frames.push(frame);
        }
        last = frames;
    }
    progress(steps, steps, "judging");
    let runs: Vec<Vec<Vec<crate::Pass>>> =
        played.iter().map(|p| p.iter().map(|f| f.passes.clone()).collect()).collect();
    let single = CompareOptions { repeats: 1, with_flip: options.with_flip };
    let mut comparison = judge(session, &jobs, techniques, last, &runs, &single)?;
    let ray_means = MeanTimes::of(&played[0]);
    for row in &mut comparison.rows {
        let Some(at) = jobs.iter().position(|j| *j == row.technique) else { continue };
        row.frames = std::mem::take(&mut played[at]);
        row.means = MeanTimes::of(&row.frames);
        row.speedup_by_means = row.means.zip(ray_means).map(|(own, ray)| own.speedup_over(&ray));
        if !options.is_still {
            row.errors = median_errors(row.frames.iter().map(|f| f.errors));
            for (i, light) in row.lights.iter_mut().enumerate() {
                light.errors = median_errors(row.frames.iter().map(|f| f.lights[i].errors));
                light.rays = median(row.frames.iter().map(|f| f.lights[i].rays as f64)) as u64;
            }
            row.rays_per_pixel = median(row.frames.iter().map(FrameStats::rays_per_pixel));
            row.rays = median(row.frames.iter().map(|f| f.rays as f64)).round() as u64;
        }
    }
    Ok(comparison)
}

/// The number of frames before the first from which on as many pixels are wrong as in the last: how long a history takes to
/// grow, where nothing moves. 0 for no frames.
pub fn frames_to_settle(frames: &[FrameStats]) -> usize {
    let wrong = |f: &FrameStats| f.errors.false_lit + f.errors.false_shadowed;
    let Some(last) = frames.last() else { return 0 };
    frames.iter().rposition(|f| wrong(f) != wrong(last)).map_or(0, |i| i + 1)
}

/// Pixels whose visibility differs, bit by bit; those of several lights and layers together.
pub fn flips(a: &Frame, b: &Frame) -> u64 {
    let differs = |(a, b): &(&f32, &f32)| a.to_bits() != b.to_bits();
    let layers = a.each_layer().iter().zip(b.each_layer());
    let lights = layers.flat_map(|(a, b)| a.each_light().iter().zip(b.each_light()));
    lights.map(|(a, b)| a.visibility.iter().zip(&b.visibility).filter(differs).count() as u64).sum()
}

/// Each count's own median over the frames; halves round up.
fn median_errors(frames: impl Iterator<Item = metrics::Errors>) -> metrics::Errors {
    let frames: Vec<metrics::Errors> = frames.collect();
    let of = |pick: fn(&metrics::Errors) -> u64| median(frames.iter().map(|e| pick(e) as f64)).round() as u64;
    metrics::Errors {
        false_lit: of(|e| e.false_lit),
        false_shadowed: of(|e| e.false_shadowed),
        valid: of(|e| e.valid),
        largest_cluster_px: of(|e| e.largest_cluster_px.into()) as u32,
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    quantile(values.collect(), 0.5)
}

fn judge(
    session: &mut Session,
    jobs: &[Technique],
    wanted: &[Technique],
    frames: Vec<Frame>,
    runs: &[Vec<Vec<crate::Pass>>],
    options: &CompareOptions,
) -> Result<Comparison, RenderError> {
    let (size, samples) = (session.setup().size, session.setup().samples);
    let in_samples = session.setup().size_in_samples().to_array();
    let valid = session.valid_samples();
    let valid_pixels = valid.iter().flatten().filter(|v| **v).count() as u64;
    let mut pictures = Vec::with_capacity(jobs.len());
    for frame in &frames {
        pictures.push(session.shade(frame)?);
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
        let lights = LightStats::each(in_samples, &valid, &reference, &frame);
        rows.push(Row {
            technique: jobs[i],
            plan: session.plan(&jobs[i]),
            rays_per_pixel: frame.rays as f64 / valid_pixels.max(1) as f64,
            rays: frame.rays,
            errors: metrics::Errors::sum(lights.iter().map(|l| l.errors)),
            lights: if lights.len() > 1 { lights } else { Vec::new() },
            flip_mean: flips[i],
            passes: pass_times(&runs[i]),
            map_ms: median_of(&runs[i], PassKind::makes_map),
            shadow_ms: median_of(&runs[i], |k| !k.makes_map()),
            total_ms,
            speedup_over_ray: ray_ms.zip(total_ms).map(|(ray, own)| ray / own.max(1e-9)),
            means: None,
            speedup_by_means: None,
            map_bytes: frame.map_bytes,
            frame,
            picture,
            frames: Vec::new(),
        });
    }
    rows.sort_by_key(|r| wanted.iter().position(|t| *t == r.technique));
    Ok(Comparison { size: [size.x, size.y], samples, valid_pixels, reference, reference_picture, rows })
}

/// Time of the passes that `wanted` names; `None` if any lacks a timestamp. No pass takes 0, not the −0 of an empty sum.
fn total_ms(passes: &[crate::Pass], wanted: impl Fn(PassKind) -> bool) -> Option<f64> {
    passes.iter().filter(|p| wanted(p.kind)).try_fold(0.0, |sum, p| Some(sum + p.ms?))
}

/// Median over the repeats of the summed time of the passes that `wanted` names; `None` if any lacks a timestamp.
fn median_of(repeats: &[Vec<crate::Pass>], wanted: impl Fn(PassKind) -> bool) -> Option<f64> {
    let times: Option<Vec<f64>> = repeats.iter().map(|passes| total_ms(passes, &wanted)).collect();
    times.map(|t| quantile(t, 0.5))
}

/// Every pass that any repeat ran, in order; where a repeat did without (a kept map), its time there is 0.
fn pass_times(repeats: &[Vec<crate::Pass>]) -> Vec<PassTime> {
    let mut kinds: Vec<PassKind> = repeats.iter().flatten().map(|p| p.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let of = |kind: PassKind| {
        let time =
            |passes: &Vec<crate::Pass>| passes.iter().find(|p| p.kind == kind).map_or(Some(0.0), |p| p.ms);
        let times: Option<Vec<f64>> = repeats.iter().map(time).collect();
        PassTime {
            kind,
            median_ms: times.clone().map(|t| quantile(t, 0.5)),
            p95_ms: times.map(|t| quantile(t, 0.95)),
        }
    };
    kinds.into_iter().map(of).collect()
}

/// The q-quantile, 0 ≤ q ≤ 1, by linear interpolation between order statistics; 0 for no values.
pub fn quantile(mut values: Vec<f64>, q: f64) -> f64 {
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
    fn a_pass_that_a_frame_did_without_took_no_time_there() {
        let pass = |kind, ms| crate::Pass { kind, ms: Some(ms) };
        let drawn = vec![pass(PassKind::DepthMap, 9.0), pass(PassKind::Evaluate, 2.0)];
        let kept = vec![pass(PassKind::Evaluate, 4.0)];
        let times = pass_times(&[drawn, kept.clone(), kept]);
        let named: Vec<_> = times.iter().map(|t| (t.kind, t.median_ms)).collect();
        assert_eq!(named, [(PassKind::DepthMap, Some(0.0)), (PassKind::Evaluate, Some(4.0))]);
    }

    #[test]
    fn errors_of_a_path_are_medians_of_each_count() {
        let errors = |false_lit, false_shadowed| metrics::Errors {
            false_lit,
            false_shadowed,
            valid: 10,
            largest_cluster_px: 1,
        };
        let frame = |false_lit, false_shadowed| FrameStats {
            lights: vec![LightStats { errors: errors(false_lit, false_shadowed), rays: 5 }],
            errors: errors(false_lit, false_shadowed),
            rays: 5,
            map_draws: 0,
            passes: Vec::new(),
            flips: None,
            mask: None,
        };
        let medians = median_errors([errors(1, 9), errors(2, 0), errors(9, 1)].into_iter());
        assert_eq!((medians.false_lit, medians.false_shadowed, medians.valid), (2, 1, 10));
        let settling = [frame(9, 1), frame(3, 1), frame(2, 0), frame(1, 1), frame(0, 2)];
        assert_eq!((frames_to_settle(&settling), frames_to_settle(&settling[..1])), (2, 0));
        assert_eq!(frame(0, 0).rays_per_pixel(), 0.5);
    }

    #[test]
    fn a_missing_timestamp_is_missing_not_zero() {
        let pass = |ms: Option<f64>| crate::Pass { kind: PassKind::Resolve, ms };
        assert_eq!(median_of(&[vec![pass(Some(1.0)), pass(None)]], |_| true), None);
        assert_eq!(median_of(&[vec![pass(Some(1.0)), pass(Some(2.0))]], |_| true), Some(3.0));
    }
}
