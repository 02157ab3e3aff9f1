//! `report.html`: one file without network or neighbours, pictures inlined.
//!
//! The reference is inlined once; each technique adds only what differs from it (changed pixels, error and ray marks,
//! transparent elsewhere), which a browser lays on top. That keeps a dozen techniques within a few megabytes.

mod effects;
mod labels;
mod layers;
mod path;
mod plot;

use lt_render::{Comparison, Row};
use minijinja::{Environment, value::Serde};
use serde::Serialize;

use crate::{
    files,
    numbers::{decimals, factor, grouped, ms, ppm},
    play::Playback,
    results::{SETTLED, Statistics, frontier_of, is_settled},
    summary::{LightView, Summary},
};

use effects::EffectTable;
use layers::Layers;
use path::PathReport;

/// Everything the template shows.
#[derive(Debug, Serialize)]
pub struct Report {
    title: String,
    facts: Vec<(&'static str, String)>,
    command: String,
    size: [u32; 2],
    /// What rates count: pixel or sample.
    unit: &'static str,
    /// What the numbers are of.
    statistics: String,
    /// What the times of some techniques are times of.
    settled: Option<&'static str>,
    /// Row that the slider shows first: one that differs from the reference, if any.
    shown: usize,
    layers: Layers,
    plot: Option<String>,
    path: Option<PathReport>,
    effects: EffectTable,
    rows: Vec<ReportRow>,
    /// Each light's share: technique, light, cells; empty for one light.
    lights: Vec<(String, usize, [String; 3])>,
}

/// One technique: text for the table, classes for its layers are made from `index`.
#[derive(Debug, Serialize)]
struct ReportRow {
    id: String,
    stem: String,
    is_best: bool,
    cells: [String; 9],
    caption: String,
    passes: Vec<(&'static str, String, String)>,
}

impl Report {
    /// Collects what the report shows.
    ///
    /// # Errors
    /// A picture that cannot be encoded, or a plot that cannot be drawn.
    pub fn new(
        summary: &Summary,
        comparison: &Comparison,
        is_valid: &[Vec<bool>],
        playback: Option<&Playback>,
    ) -> anyhow::Result<Self> {
        let best = frontier_of(comparison);
        Ok(Self {
            title: format!("Shadows of {}", summary.scene),
            facts: facts(summary, comparison),
            command: summary.command.clone(),
            size: comparison.size,
            unit: comparison.unit(),
            statistics: Statistics::of(playback).sentence(),
            settled: comparison.rows.iter().any(is_settled).then_some(SETTLED),
            shown: comparison
                .rows
                .iter()
                .position(|r| r.picture != comparison.reference_picture)
                .unwrap_or(0),
            layers: Layers::fitting(comparison, is_valid, layers::BUDGET)?,
            plot: plot::error_against_time(&plot::points(comparison, &best))?,
            path: playback.map(|p| PathReport::new(comparison, p)).transpose()?,
            effects: EffectTable::of(&comparison.rows),
            lights: comparison.rows.iter().flat_map(light_rows).collect(),
            rows: comparison
                .rows
                .iter()
                .zip(best)
                .map(|(row, is_best)| report_row(row, is_best, comparison.unit()))
                .collect(),
        })
    }

    /// The finished page.
    ///
    /// # Errors
    /// A template that does not fit its data.
    pub fn render(&self) -> anyhow::Result<String> {
        let mut environment = Environment::new();
        environment.add_template("report.html", include_str!("report.html"))?;
        environment.add_template("report.css.html", include_str!("report.css"))?;
        environment.add_template("report.js.html", include_str!("report.js"))?;
        Ok(environment.get_template("report.html")?.render(Serde(self))?)
    }
}

fn facts(summary: &Summary, comparison: &Comparison) -> Vec<(&'static str, String)> {
    let (view, unit) = (&summary.view, comparison.unit());
    let mut all = vec![
        ("Scene", summary.scene.clone()),
        ("Triangles", format!("{} in {} instances", grouped(summary.triangles), grouped(summary.instances))),
        (
            "Picture",
            format!("{}, {} {}s with geometry", summary.picture(), grouped(comparison.valid_pixels), unit),
        ),
        ("Backend", format!("{} · {} · {} threads", summary.backend, summary.device, summary.threads)),
        ("BVH", format!("{} ms, {} KiB", ms(Some(summary.bvh_ms)), grouped(summary.bvh_bytes / 1024))),
        ("Visible samples", format!("{} ms, shared by all techniques", ms(summary.camera_ms))),
        ("Shadow map", format!("{0} × {0} unless a technique says otherwise", summary.map_size)),
        ("Camera", format!("from {} to {}, {:.1}°", vector(view.eye), vector(view.target), view.fov_deg)),
    ];
    let lights = view.lights();
    all.extend(lights.iter().map(|light| ("Light", light_words(light))));
    all.push(("Version", format!("lt {}", summary.version)));
    all
}

fn vector(v: [f32; 3]) -> String {
    v.map(|x| format!("{x:.3}")).join(", ")
}

fn light_words(light: &LightView) -> String {
    let ways = match (light.light_dir, light.cone_deg) {
        (Some(d), Some(cone)) => format!("along {} in a cone of {cone:.1}°", vector(d)),
        (Some(d), None) => format!("along {}", vector(d)),
        (None, _) => "all ways".to_owned(),
    };
    match light.light_pos {
        Some(from) => format!("travels from {} {ways}", vector(from)),
        None => format!("travels {ways}"),
    }
}

fn light_rows(row: &Row) -> impl Iterator<Item = (String, usize, [String; 3])> {
    row.lights.iter().enumerate().map(|(i, light)| {
        let cells = [
            decimals(Some(light.rays_per_pixel()), 3),
            ppm(light.errors.false_lit_ppm()),
            ppm(light.errors.false_shadowed_ppm()),
        ];
        (row.technique.to_string(), i, cells)
    })
}

fn report_row(row: &Row, is_best: bool, unit: &str) -> ReportRow {
    let id = row.technique.to_string();
    let (lit, shadowed) = (ppm(row.errors.false_lit_ppm()), ppm(row.errors.false_shadowed_ppm()));
    let rays = decimals(Some(row.rays_per_pixel), 3);
    ReportRow {
        stem: files::stem(&id),
        is_best,
        caption: format!(
            "{rays} rays per {unit}, {lit} ppm false-lit, {shadowed} ppm false-shadowed, {} ms",
            ms(row.total_ms)
        ),
        cells: [
            rays,
            lit,
            shadowed,
            grouped(row.errors.largest_cluster_px.into()),
            decimals(row.flip_mean, 4),
            ms(row.map_ms),
            ms(row.shadow_ms),
            ms(row.total_ms),
            factor(row.speedup_over_ray),
        ],
        passes: row.passes.iter().map(|p| (p.kind.name(), ms(p.median_ms), ms(p.p95_ms))).collect(),
        id,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;

    fn page() -> String {
        Report::new(&fixture::summary(), &fixture::comparison(), &[vec![true; 8]], None)
            .unwrap()
            .render()
            .unwrap()
    }

    #[test]
    fn several_frames_get_plots_and_masks() {
        let (comparison, playback) = fixture::played();
        let report =
            Report::new(&fixture::summary(), &comparison, &[vec![true; 8]], Some(&playback)).unwrap();
        let played = report.render().unwrap();
        assert!(played.contains("Over the frames") && played.contains("Temporal mask"));
        assert!(!page().contains("Over the frames"));
    }

    #[test]
    fn a_settled_technique_is_told() {
        let mut comparison = fixture::comparison();
        assert!(!page().contains("as they have settled"));
        comparison.rows[1].technique = "lt-vsm".parse().unwrap();
        let report = Report::new(&fixture::summary(), &comparison, &[vec![true; 8]], None).unwrap();
        assert!(report.render().unwrap().contains("as they have settled"));
    }

    #[test]
    fn names_are_escaped() {
        let page = page();
        assert!(page.contains("box &lt;&amp;&gt;"), "{page}");
        assert!(!page.contains("box <&>"));
    }

    #[test]
    fn nothing_is_fetched() {
        let page = page();
        let addresses: Vec<&str> =
            page.match_indices("http").map(|(at, _)| &page[at..(at + 30).min(page.len())]).collect();
        assert!(addresses.iter().all(|a| a.starts_with("http://www.w3.org/2000/svg")), "{addresses:?}");
        assert!(!page.contains("src=") && page.contains("data:image/png;base64,"));
    }

    #[test]
    fn every_technique_has_a_section() {
        let page = page();
        for id in ["ray", "sm"] {
            assert!(page.contains(&format!("id=\"t-{id}\"")), "{id}");
        }
    }
}
