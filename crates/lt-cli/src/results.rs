//! `results.json`, schema 1: fields may be added, never renamed. What its numbers are of, where several frames were played, stands in
//! the field `statistics`.

use lt_render::{Comparison, Doubt, FrameStats, LightStats, PassKind, PassTime, Row, frames_to_settle};
use serde::Serialize;

use crate::{
    pareto,
    play::{Playback, Spread, spread},
    summary::Summary,
};

/// The whole file.
#[derive(Debug, Serialize)]
pub struct Results<'a> {
    schema: u32,
    #[serde(flatten)]
    summary: &'a Summary,
    frames: usize,
    statistics: Statistics,
    /// Null for a single view.
    playback: Option<&'a Playback>,
    repeats: u16,
    valid_pixels: u64,
    peak_memory_mb: Option<f64>,
    rows: Vec<ResultRow>,
}

/// What the numbers of a row are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Statistics {
    /// Whatever counts rays or pixels, and rates of those.
    pub counts: &'static str,
    /// Whatever is in milliseconds, and speed-ups.
    pub times: &'static str,
    /// Pictures and `flip_mean`; also `valid_pixels` and `map_bytes`.
    pub pictures: &'static str,
}

impl Statistics {
    /// Of a run; `None` for a single view.
    pub fn of(playback: Option<&Playback>) -> Self {
        let (frames, last) = ("medians over the frames", "of the last frame");
        match playback {
            None => {
                Self { counts: "of the view", times: "medians over the repeats", pictures: "of the view" }
            }
            Some(p) if p.is_still => Self { counts: last, times: frames, pictures: last },
            Some(_) => Self { counts: frames, times: frames, pictures: last },
        }
    }

    /// The same for people.
    pub fn sentence(&self) -> String {
        format!(
            "rates and rays: {}; times: {}; FLIP and pictures: {}",
            self.counts, self.times, self.pictures
        )
    }
}

/// What a single view shows of techniques that remember.
pub const SETTLED: &str = "techniques with a mask (lt-…) as they have settled: their first frame traces every pixel; --frames N shows a path";

/// Whether a row was timed on a still view after its first frame, of which a temporal mask keeps the answers: it traces next to nothing.
pub fn is_settled(row: &Row) -> bool {
    row.technique.mask.is_some() && row.frames.is_empty()
}

/// One technique.
#[derive(Debug, Serialize)]
struct ResultRow {
    technique: String,
    is_settled: bool,
    rays_per_pixel: f64,
    false_lit_ppm: f64,
    false_shadowed_ppm: f64,
    largest_cluster_px: u32,
    flips_per_frame: u64,
    flip_mean: Option<f64>,
    ms: Times,
    speedup_over_ray: Option<f64>,
    map_bytes: u64,
    epsilon: Option<f32>,
    map_size: Option<u32>,
    rays: u64,
    false_lit_px: u64,
    false_shadowed_px: u64,
    is_on_frontier: bool,
    passes: Vec<PassRow>,
    /// Each light's share; empty for one light.
    lights: Vec<LightRow>,
    /// Null for a single view.
    path: Option<PathRow>,
}

/// One light's share of a technique.
#[derive(Debug, Serialize)]
struct LightRow {
    rays_per_pixel: f64,
    false_lit_ppm: f64,
    false_shadowed_ppm: f64,
    largest_cluster_px: u32,
}

/// One technique over several frames.
#[derive(Debug, Serialize)]
struct PathRow {
    false_lit_ppm: Spread,
    false_shadowed_ppm: Spread,
    rays_per_pixel: Spread,
    total_ms: Option<Spread>,
    /// The first frame, which draws every map and has no history.
    first_ms: Option<f64>,
    /// Mean over the frames after the first: with what few of them do, such as drawing a map that is then kept.
    later_mean_ms: Option<f64>,
    /// Mean over all frames.
    mean_ms: Option<f64>,
    /// `ray`'s mean over the frames after the first, over this one's.
    speedup_by_means: Option<f64>,
    map_draws: u32,
    /// Frames until as many pixels were wrong as in the last one; null where things move.
    frames_to_settle: Option<usize>,
    frames: Vec<FrameRow>,
}

/// One technique in one frame.
#[derive(Debug, Serialize)]
struct FrameRow {
    false_lit_ppm: f64,
    false_shadowed_ppm: f64,
    rays_per_pixel: f64,
    map_draws: u32,
    flips: Option<u64>,
    map_ms: Option<f64>,
    shadow_ms: Option<f64>,
    total_ms: Option<f64>,
}

/// Medians in milliseconds; a time that was not measured is null.
#[derive(Debug, Serialize)]
struct Times {
    map: Option<f64>,
    shadow: Option<f64>,
    total: Option<f64>,
}

/// One pass over the repeats.
#[derive(Debug, Serialize)]
struct PassRow {
    name: &'static str,
    median_ms: Option<f64>,
    p95_ms: Option<f64>,
}

impl<'a> Results<'a> {
    /// Puts a run into the schema. `flips[i]` counts the pixels that differ between two frames of `rows[i]` with
    /// nothing moving.
    pub fn new(
        summary: &'a Summary,
        comparison: &Comparison,
        flips: &[u64],
        repeats: u16,
        playback: Option<&'a Playback>,
    ) -> Self {
        let frontier = frontier_of(comparison);
        let is_still = playback.is_some_and(|p| p.is_still);
        let rows = comparison.rows.iter().zip(flips).zip(frontier);
        Self {
            schema: 1,
            summary,
            frames: playback.map_or(1, |p| p.frames),
            statistics: Statistics::of(playback),
            playback,
            repeats: if playback.is_some() { 1 } else { repeats },
            valid_pixels: comparison.valid_pixels,
            peak_memory_mb: peak_memory_mb(),
            rows: rows
                .map(|((row, &flips), is_best)| result_row(row, summary, (flips, is_still), is_best))
                .collect(),
        }
    }
}

/// Which rows no other row beats in both total time and wrong pixels.
pub fn frontier_of(comparison: &Comparison) -> Vec<bool> {
    let points: Vec<_> = comparison.rows.iter().map(|r| (r.total_ms, r.errors.wrong_ppm())).collect();
    pareto::frontier(&points)
}

fn result_row(
    row: &Row,
    summary: &Summary,
    (flips, is_still): (u64, bool),
    is_on_frontier: bool,
) -> ResultRow {
    let technique = row.technique;
    ResultRow {
        technique: technique.to_string(),
        is_settled: is_settled(row),
        rays_per_pixel: row.rays_per_pixel,
        false_lit_ppm: row.errors.false_lit_ppm(),
        false_shadowed_ppm: row.errors.false_shadowed_ppm(),
        largest_cluster_px: row.errors.largest_cluster_px,
        flips_per_frame: flips,
        flip_mean: row.flip_mean,
        ms: Times { map: row.map_ms, shadow: row.shadow_ms, total: row.total_ms },
        speedup_over_ray: row.speedup_over_ray,
        map_bytes: row.map_bytes,
        epsilon: (technique.doubt == Doubt::Ltt).then_some(technique.epsilon),
        map_size: technique.map_test().map(|_| technique.map_size.unwrap_or(summary.map_size)),
        rays: row.rays,
        false_lit_px: row.errors.false_lit,
        false_shadowed_px: row.errors.false_shadowed,
        is_on_frontier,
        passes: row.passes.iter().map(pass_row).collect(),
        lights: row.lights.iter().map(light_row).collect(),
        path: path_row(row, is_still),
    }
}

fn light_row(light: &LightStats) -> LightRow {
    LightRow {
        rays_per_pixel: light.rays_per_pixel(),
        false_lit_ppm: light.errors.false_lit_ppm(),
        false_shadowed_ppm: light.errors.false_shadowed_ppm(),
        largest_cluster_px: light.errors.largest_cluster_px,
    }
}

fn path_row(row: &Row, is_still: bool) -> Option<PathRow> {
    let frames = &row.frames;
    if frames.is_empty() {
        return None;
    }
    let times: Option<Vec<f64>> = frames.iter().map(|f| f.ms(|_| true)).collect();
    Some(PathRow {
        false_lit_ppm: spread(frames.iter().map(|f| f.errors.false_lit_ppm())),
        false_shadowed_ppm: spread(frames.iter().map(|f| f.errors.false_shadowed_ppm())),
        rays_per_pixel: spread(frames.iter().map(FrameStats::rays_per_pixel)),
        total_ms: times.map(|t| spread(t.into_iter())),
        first_ms: row.means.map(|m| m.first_ms),
        later_mean_ms: row.means.map(|m| m.later_ms),
        mean_ms: row.means.map(|m| m.all_ms),
        speedup_by_means: row.speedup_by_means,
        map_draws: frames.iter().map(|f| f.map_draws).sum(),
        frames_to_settle: is_still.then(|| frames_to_settle(frames)),
        frames: frames.iter().map(frame_row).collect(),
    })
}

fn frame_row(frame: &FrameStats) -> FrameRow {
    FrameRow {
        false_lit_ppm: frame.errors.false_lit_ppm(),
        false_shadowed_ppm: frame.errors.false_shadowed_ppm(),
        rays_per_pixel: frame.rays_per_pixel(),
        map_draws: frame.map_draws,
        flips: frame.flips,
        map_ms: frame.ms(PassKind::makes_map),
        shadow_ms: frame.ms(|k| !k.makes_map()),
        total_ms: frame.ms(|_| true),
    }
}

fn pass_row(pass: &PassTime) -> PassRow {
    PassRow { name: pass.kind.name(), median_ms: pass.median_ms, p95_ms: pass.p95_ms }
}

/// The process's largest resident size so far in MiB, where the system tells (Linux: VmHWM).
fn peak_memory_mb() -> Option<f64> {
    parse_peak(&std::fs::read_to_string("/proc/self/status").ok()?)
}

fn parse_peak(status: &str) -> Option<f64> {
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    let kib: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;

    #[test]
    fn the_schema_holds() {
        let (summary, comparison) = (fixture::summary(), fixture::comparison());
        let json = serde_json::to_value(Results::new(&summary, &comparison, &[0, 2], 5, None)).unwrap();
        for (key, expected) in [("schema", 1), ("triangles", 12), ("threads", 2), ("frames", 1)] {
            assert_eq!(json[key], expected, "{key}");
        }
        assert_eq!(json["size"], serde_json::json!([4, 2]));
        assert!(json["scene"].is_string() && json["backend"].is_string() && json["device"].is_string());
        let row = &json["rows"][1];
        assert_eq!(row["technique"], "sm");
        for key in [
            "rays_per_pixel",
            "false_lit_ppm",
            "false_shadowed_ppm",
            "largest_cluster_px",
            "flips_per_frame",
            "flip_mean",
            "speedup_over_ray",
            "map_bytes",
        ] {
            assert!(row[key].is_number(), "{key}: {row}");
        }
        assert_eq!(row["flips_per_frame"], 2);
        assert!(
            row["ms"]["map"].is_number() && row["ms"]["shadow"].is_number() && row["ms"]["total"].is_number()
        );
    }

    #[test]
    fn what_numbers_are_of_is_named() {
        let (comparison, mut playback) = fixture::played();
        let summary = fixture::summary();
        let counts = |playback: Option<&Playback>| {
            let results = Results::new(&summary, &comparison, &[0, 0], 1, playback);
            serde_json::to_value(results).unwrap()["statistics"]["counts"].clone()
        };
        assert_eq!(counts(None), "of the view");
        assert_eq!(counts(Some(&playback)), "medians over the frames");
        playback.is_still = true;
        assert_eq!(counts(Some(&playback)), "of the last frame");
    }

    #[test]
    fn means_stand_beside_medians_and_the_first_frame_apart() {
        let (comparison, playback) = fixture::played();
        let summary = fixture::summary();
        let results = Results::new(&summary, &comparison, &[0, 0], 1, Some(&playback));
        let path = &serde_json::to_value(results).unwrap()["rows"][1]["path"];
        let of = |key: &str| path[key].as_f64();
        assert_eq!(
            (of("first_ms"), of("later_mean_ms"), of("mean_ms")),
            (Some(31.25), Some(4.5), Some(17.875))
        );
        assert_eq!(of("speedup_by_means"), Some(1.5));
    }

    #[test]
    fn a_technique_that_remembers_has_settled_in_a_single_view_alone() {
        let mut comparison = fixture::comparison();
        comparison.rows[1].technique = "lt-vsm".parse().unwrap();
        assert!(is_settled(&comparison.rows[1]) && !is_settled(&comparison.rows[0]));
        comparison.rows[1].frames = fixture::played().0.rows.remove(1).frames;
        assert!(!is_settled(&comparison.rows[1]));
    }

    #[test]
    fn a_missing_time_is_null() {
        let mut comparison = fixture::comparison();
        comparison.rows[1].total_ms = None;
        comparison.rows[1].speedup_over_ray = None;
        comparison.rows[1].flip_mean = Some(f64::NAN);
        let summary = fixture::summary();
        let json = serde_json::to_value(Results::new(&summary, &comparison, &[0, 0], 1, None)).unwrap();
        let row = &json["rows"][1];
        assert!(
            row["ms"]["total"].is_null() && row["speedup_over_ray"].is_null() && row["flip_mean"].is_null()
        );
        assert_eq!(row["is_on_frontier"], false);
    }

    #[test]
    fn peak_memory_is_read_in_mebibytes() {
        assert_eq!(parse_peak("Name:\tlt\nVmHWM:\t  2048 kB\n"), Some(2.0));
        assert_eq!(parse_peak("Name:\tlt\n"), None);
    }
}
