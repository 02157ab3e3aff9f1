//! Several frames in pictures: wrong pixels and rays over the path, and the temporal mask's colours.

use anyhow::{Context, anyhow};
use base64::{Engine, prelude::BASE64_STANDARD};
use lt_render::{Comparison, FrameStats, Row};
use plotters::{coord::Shift, prelude::*};
use serde::Serialize;

use crate::{
    numbers::{factor, grouped, ms, ppm},
    picture::Picture,
    play::{MEANS, Playback, spread},
};

/// Plot size in its own units; the page scales it.
const SIZE: (u32, u32) = (1000, 420);
/// Stands for the page's text colour, which plotters cannot name; replaced after drawing.
const INK: RGBColor = RGBColor(1, 2, 3);
/// Colours of techniques in order, told apart by colour-blind eyes (Okabe and Ito), then over again with lines of other [`DASHES`].
const COLOURS: [RGBColor; 7] = [
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(204, 121, 167),
    RGBColor(128, 128, 128),
];
/// What lines are called whose colours were taken before, and their strokes and gaps.
const DASHES: [(&str, i32, i32); 3] = [("dashed", 9, 4), ("dotted", 2, 3), ("with long dashes", 18, 6)];
/// Columns of a pictured mask at most.
const MASK_COLUMNS: u32 = 640;

/// What the report shows of several frames.
#[derive(Debug, Serialize)]
pub struct PathReport {
    headline: String,
    wrong: String,
    rays: String,
    legend: Vec<(String, String)>,
    rows: Vec<(String, [String; 12])>,
    means: &'static str,
    masks: Vec<MaskStrip>,
}

/// The masks of one technique.
#[derive(Debug, Serialize)]
struct MaskStrip {
    technique: String,
    frames: Vec<(usize, String)>,
}

impl PathReport {
    /// Draws the plots and encodes the masks.
    ///
    /// # Errors
    /// A plot or picture that cannot be drawn.
    pub fn new(comparison: &Comparison, playback: &Playback) -> anyhow::Result<Self> {
        let (rows, unit) = (&comparison.rows, comparison.unit());
        let wrong = |f: &FrameStats| f.errors.wrong_ppm();
        let legend = rows.iter().enumerate().map(|(i, row)| {
            let RGBColor(r, g, b) = COLOURS[i % COLOURS.len()];
            let dashes = dashes(i).map_or_else(String::new, |(name, ..)| format!(" ({name})"));
            (format!("{}{dashes}", row.technique), format!("#{r:02x}{g:02x}{b:02x}"))
        });
        let strips: anyhow::Result<Vec<MaskStrip>> = rows
            .iter()
            .filter(|r| r.frames.iter().any(|f| f.mask.is_some()))
            .map(|row| mask_strip(row, comparison.size_in_samples()))
            .collect();
        Ok(Self {
            headline: playback.headline(),
            wrong: plot(rows, &format!("wrong {unit}s, ppm"), wrong)?,
            rays: plot(rows, &format!("rays per {unit}"), FrameStats::rays_per_pixel)?,
            legend: legend.collect(),
            rows: rows.iter().map(table_row).collect(),
            means: MEANS,
            masks: strips?,
        })
    }
}

fn table_row(row: &Row) -> (String, [String; 12]) {
    let frames = &row.frames;
    let lit = spread(frames.iter().map(|f| f.errors.false_lit_ppm()));
    let shadowed = spread(frames.iter().map(|f| f.errors.false_shadowed_ppm()));
    let times: Option<Vec<f64>> = frames.iter().map(|f| f.ms(|_| true)).collect();
    let times = times.map(|t| spread(t.into_iter()));
    let draws: u64 = frames.iter().map(|f| u64::from(f.map_draws)).sum();
    let cells = [
        ppm(lit.median),
        ppm(lit.p95),
        ppm(lit.max),
        ppm(shadowed.median),
        ppm(shadowed.p95),
        ppm(shadowed.max),
        grouped(draws),
        ms(times.map(|t| t.median)),
        ms(times.map(|t| t.max)),
        ms(row.means.map(|m| m.first_ms)),
        ms(row.means.map(|m| m.later_ms)),
        factor(row.speedup_by_means),
    ];
    (row.technique.to_string(), cells)
}

fn mask_strip(row: &Row, [width, height]: [u32; 2]) -> anyhow::Result<MaskStrip> {
    let stride = width.div_ceil(MASK_COLUMNS);
    let picture = |(index, frame): (usize, &FrameStats)| {
        let mask = frame.mask.as_ref()?;
        let pixels = mask.iter().map(|bits| {
            let [r, g, b] = bits.colour().to_array().map(|c| (c * 255.0) as u8);
            [r, g, b, 255]
        });
        Some((index, Picture::new([width, height], pixels.collect()).thinned(stride)))
    };
    let frames: anyhow::Result<Vec<(usize, String)>> = row
        .frames
        .iter()
        .enumerate()
        .filter_map(picture)
        .map(|(index, picture)| {
            let png = picture.to_png().with_context(|| format!("mask of {}", row.technique))?;
            Ok((index, format!("data:image/png;base64,{}", BASE64_STANDARD.encode(png))))
        })
        .collect();
    Ok(MaskStrip { technique: row.technique.to_string(), frames: frames? })
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type DrawResult<T> = Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// One line per technique over the frames, as an SVG element whose ink is `currentColor`.
fn plot(rows: &[Row], what: &str, value: impl Fn(&FrameStats) -> f64) -> anyhow::Result<String> {
    let lines: Vec<Vec<f64>> = rows.iter().map(|r| r.frames.iter().map(&value).collect()).collect();
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        draw(&area, &lines, what).map_err(|e| anyhow!("plot: {e}"))?;
        area.present().map_err(|e| anyhow!("plot: {e}"))?;
    }
    let fixed = format!("<svg width=\"{}\" height=\"{}\" ", SIZE.0, SIZE.1);
    Ok(svg.replace("#010203", "currentColor").replacen(&fixed, "<svg role=\"img\" ", 1))
}

/// A logarithmic axis that starts at 0: values below its floor are drawn on the floor line, which reads "none".
fn draw(area: &Area, lines: &[Vec<f64>], what: &str) -> DrawResult<()> {
    let known = || lines.iter().flatten().copied().filter(|v| *v > 0.0);
    let (least, most) = known().fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
    let (least, most) = if least.is_finite() { (least, most) } else { (1.0, 1.0) };
    let floor = 10f64.powf(least.log10().floor() - 1.0);
    let frames = lines.iter().map(Vec::len).max().unwrap_or(1).max(2);
    let range = floor / 1.5..most * 2.0;
    let decades: Vec<f64> =
        (floor.log10() as i32..=most.log10().ceil() as i32).map(|e| 10f64.powi(e)).collect();
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .set_label_area_size(LabelAreaPosition::Left, 96)
        .set_label_area_size(LabelAreaPosition::Bottom, 52)
        .build_cartesian_2d(0..frames - 1, range.log_scale().with_key_points(decades))?;
    let number = |v: &f64| match *v {
        v if (v / floor - 1.0).abs() < 1e-6 => "none".to_owned(),
        v if v >= 10_000.0 => grouped(v as u64),
        v => format!("{v}"),
    };
    chart
        .configure_mesh()
        .bold_line_style(INK.mix(0.13))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.mix(0.5))
        .label_style(("sans-serif", 15).with_color(INK))
        .axis_desc_style(("sans-serif", 16).with_color(INK))
        .x_desc("frame")
        .y_desc(format!("{what} (log)"))
        .y_label_formatter(&number)
        .draw()?;
    for (i, line) in lines.iter().enumerate() {
        let points = line.iter().enumerate().map(|(x, &y)| (x, y.max(floor)));
        let style = COLOURS[i % COLOURS.len()].stroke_width(2);
        match dashes(i) {
            None => chart.draw_series(LineSeries::new(points, style))?,
            Some((_, stroke, gap)) => chart.draw_series(DashedLineSeries::new(points, stroke, gap, style))?,
        };
    }
    Ok(())
}

/// How the line of a technique by this number is broken, if it is.
fn dashes(number: usize) -> Option<(&'static str, i32, i32)> {
    let round = number / COLOURS.len();
    round.checked_sub(1).map(|round| DASHES[round % DASHES.len()])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;

    fn report() -> PathReport {
        let (comparison, playback) = fixture::played();
        PathReport::new(&comparison, &playback).unwrap()
    }

    #[test]
    fn every_technique_has_a_line_and_only_masks_are_pictured() {
        let report = report();
        assert_eq!((report.legend.len(), report.rows.len()), (2, 2));
        assert!(report.wrong.matches("<polyline").count() >= 2 && report.wrong.contains("none"));
        assert_eq!(report.masks.len(), 1);
        assert_eq!(report.masks[0].frames.len(), 1);
        assert!(report.masks[0].frames[0].1.starts_with("data:image/png"));
    }

    #[test]
    fn the_plot_takes_the_pages_ink() {
        let report = report();
        assert!(report.rays.starts_with("<svg role=\"img\"") && !report.rays.contains("#010203"));
    }
}
