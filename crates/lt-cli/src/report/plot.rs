//! Wrong pixels against time, both on logarithmic axes, with the Pareto frontier.

use anyhow::anyhow;
use lt_render::Comparison;
use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use super::labels::{self, Rect};

/// Plot size in its own units; the page scales it.
const SIZE: (u32, u32) = (1000, 560);
/// Stands for the page's text colour, which plotters cannot name; replaced after drawing.
const INK: RGBColor = RGBColor(1, 2, 3);
/// Techniques without rays.
const MAPS: RGBColor = RGBColor(214, 96, 77);
/// Techniques with rays.
const RAYS: RGBColor = RGBColor(56, 142, 215);
/// Label font size as plotters counts (points): 13 px.
const LABEL_SIZE: f64 = 16.0;
/// Average advance of a label's characters, pixels.
const LABEL_ADVANCE: f64 = 6.9;

/// One technique in the plot.
#[derive(Clone, Debug)]
pub struct Point {
    label: String,
    ms: f64,
    wrong_ppm: f64,
    has_rays: bool,
    is_best: bool,
}

/// The rows whose time was measured.
pub fn points(comparison: &Comparison, is_best: &[bool]) -> Vec<Point> {
    let point = |(row, &is_best): (&lt_render::Row, &bool)| {
        let ms = row.total_ms.filter(|ms| *ms > 0.0 && ms.is_finite())?;
        Some(Point {
            label: row.technique.to_string(),
            ms,
            wrong_ppm: row.errors.wrong_ppm(),
            has_rays: row.technique.resolve.is_exact(),
            is_best,
        })
    };
    comparison.rows.iter().zip(is_best).filter_map(point).collect()
}

/// The plot as an SVG element whose ink is `currentColor`; `None` without points.
///
/// # Errors
/// Whatever the drawing library reports.
pub fn error_against_time(points: &[Point]) -> anyhow::Result<Option<String>> {
    if points.is_empty() {
        return Ok(None);
    }
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        draw(&area, points).map_err(|e| anyhow!("plot: {e}"))?;
        area.present().map_err(|e| anyhow!("plot: {e}"))?;
    }
    let fixed = format!("<svg width=\"{}\" height=\"{}\" ", SIZE.0, SIZE.1);
    let svg = svg.replace("#010203", "currentColor").replacen(&fixed, "<svg role=\"img\" ", 1);
    Ok(Some(svg))
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type DrawResult<T> = Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// Ranges of both axes; error 0, which a logarithm cannot show, is drawn on the floor line.
struct Ranges {
    x: std::ops::Range<f64>,
    y: std::ops::Range<f64>,
    floor: f64,
}

fn ranges(points: &[Point]) -> Ranges {
    let fold = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
    };
    let (fastest, slowest) = fold(&mut points.iter().map(|p| p.ms));
    let (least, most) = fold(&mut points.iter().map(|p| p.wrong_ppm).filter(|v| *v > 0.0));
    let (least, most) = if least.is_finite() { (least, most) } else { (1.0, 1.0) };
    let floor = 10f64.powf(least.log10().floor() - 1.0);
    Ranges { x: fastest / 1.6..slowest * 1.9, y: floor / 1.8..most * 3.0, floor }
}

fn draw(area: &Area, points: &[Point]) -> DrawResult<()> {
    let ranges = ranges(points);
    let floor = ranges.floor;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .set_label_area_size(LabelAreaPosition::Left, 86)
        .set_label_area_size(LabelAreaPosition::Bottom, 52)
        .build_cartesian_2d(
            ranges.x.clone().log_scale().with_key_points(ticks(&ranges.x)),
            ranges.y.clone().log_scale().with_key_points(decades(&ranges.y)),
        )?;
    let number = |v: &f64| if *v >= 10_000.0 { crate::numbers::grouped(*v as u64) } else { format!("{v}") };
    chart
        .configure_mesh()
        .bold_line_style(INK.mix(0.13))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.mix(0.5))
        .label_style(("sans-serif", 15).with_color(INK))
        .axis_desc_style(("sans-serif", 16).with_color(INK))
        .x_desc("total time, ms (log)")
        .y_desc("wrong, ppm (log)")
        .x_label_formatter(&number)
        .y_label_formatter(&|v| if (*v / floor - 1.0).abs() < 1e-6 { "none".to_owned() } else { number(v) })
        .draw()?;
    let height_of = |p: &Point| if p.wrong_ppm > 0.0 { p.wrong_ppm } else { floor };

    let mut best: Vec<(f64, f64)> =
        points.iter().filter(|p| p.is_best).map(|p| (p.ms, height_of(p))).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    let frontier = staircase(&best);
    chart.draw_series(LineSeries::new(frontier.iter().copied(), INK.mix(0.45).stroke_width(2)))?;
    for point in points {
        let (at, color) = ((point.ms, height_of(point)), if point.has_rays { RAYS } else { MAPS });
        chart.draw_series([Circle::new(at, 5, color.filled())])?;
        if point.is_best {
            chart.draw_series([Circle::new(at, 8, INK.stroke_width(2))])?;
        }
    }
    let pixel = |at: (f64, f64)| {
        let (x, y) = chart.backend_coord(&at);
        (f64::from(x), f64::from(y))
    };
    let marks: Vec<(f64, f64)> = points.iter().map(|p| pixel((p.ms, height_of(p)))).collect();
    let lines: Vec<Rect> =
        frontier.windows(2).map(|ends| Rect::around(pixel(ends[0]), pixel(ends[1]))).collect();
    let (xs, ys) = chart.plotting_area().get_pixel_range();
    let frame = Rect {
        left: f64::from(xs.start) + 4.0,
        top: f64::from(ys.start) + 2.0,
        right: f64::from(xs.end) - 2.0,
        bottom: f64::from(ys.end) - 4.0,
    };
    draw_labels(area, points, &marks, &lines, frame)
}

/// The frontier as a staircase: no faster point is as right until the next step.
fn staircase(best: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let corner = |pair: &[(f64, f64)]| [(pair[1].0, pair[0].1), pair[1]];
    best.first().copied().into_iter().chain(best.windows(2).flat_map(corner)).collect()
}

/// Writes every label near its mark, with a thin line where it had to move away.
fn draw_labels(
    area: &Area,
    points: &[Point],
    marks: &[(f64, f64)],
    lines: &[Rect],
    frame: Rect,
) -> DrawResult<()> {
    let widths: Vec<f64> =
        points.iter().map(|p| p.label.chars().count() as f64 * LABEL_ADVANCE + 4.0).collect();
    let style = TextStyle::from(("sans-serif", LABEL_SIZE).into_font())
        .color(&INK)
        .pos(Pos::new(HPos::Center, VPos::Center));
    for ((point, &at), label) in points.iter().zip(marks).zip(labels::place(marks, &widths, lines, frame)) {
        let nearest = (at.0.clamp(label.left, label.right), at.1.clamp(label.top, label.bottom));
        if (nearest.0 - at.0).hypot(nearest.1 - at.1) > 16.0 {
            let line = [at, nearest].map(|(x, y)| (x.round() as i32, y.round() as i32));
            area.draw(&PathElement::new(line, INK.mix(0.35)))?;
        }
        let center = ((label.left + label.right) / 2.0, (label.top + label.bottom) / 2.0);
        let center = (center.0.round() as i32, center.1.round() as i32);
        area.draw(&Text::new(point.label.clone(), center, &style))?;
    }
    Ok(())
}

/// Round times within the range: 1, 2 and 5 times powers of ten, or finer steps where these are too few.
fn ticks(range: &std::ops::Range<f64>) -> Vec<f64> {
    let times = |factors: &[f64]| -> Vec<f64> {
        let of = |decade: f64| factors.iter().map(move |f| f * decade);
        powers_of_ten(range).into_iter().flat_map(of).filter(|v| range.contains(v)).collect()
    };
    let coarse = times(&[1.0, 2.0, 5.0]);
    if coarse.len() < 4 { times(&[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0]) } else { coarse }
}

/// Powers of ten from the one below the range to the one above.
fn powers_of_ten(range: &std::ops::Range<f64>) -> Vec<f64> {
    let (first, last) = (range.start.log10().floor() as i32, range.end.log10().ceil() as i32);
    (first..=last).map(|e| 10f64.powi(e)).collect()
}

/// Powers of ten within the range.
fn decades(range: &std::ops::Range<f64>) -> Vec<f64> {
    powers_of_ten(range).into_iter().filter(|v| range.contains(v)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(label: &str, ms: f64, wrong_ppm: f64) -> Point {
        Point { label: label.into(), ms, wrong_ppm, has_rays: wrong_ppm == 0.0, is_best: true }
    }

    #[test]
    fn every_point_is_named_in_the_pages_ink() {
        let svg = error_against_time(&[point("ray", 100.0, 0.0), point("sm", 3.0, 5e4)]).unwrap().unwrap();
        assert!(svg.starts_with("<svg role=\"img\" viewBox"), "{}", &svg[..80]);
        assert!(svg.contains("ray") && svg.contains("sm") && svg.contains("none"));
        assert!(svg.contains("currentColor") && !svg.contains("#010203") && !svg.contains("#000000"));
    }

    #[test]
    fn extreme_values_still_draw() {
        for points in [
            vec![point("a", 1e-6, 0.0)],
            vec![point("a", 5.0, 1e6), point("b", 5.0, 1e6)],
            vec![point("a", 1e9, 1e-3), point("b", 1e-3, 0.0)],
        ] {
            assert!(error_against_time(&points).unwrap().is_some());
        }
        assert!(error_against_time(&[]).unwrap().is_none());
    }

    #[test]
    fn the_frontier_steps_down() {
        assert_eq!(staircase(&[(1.0, 9.0), (4.0, 2.0)]), [(1.0, 9.0), (4.0, 9.0), (4.0, 2.0)]);
        assert!(staircase(&[]).is_empty());
    }

    #[test]
    fn ticks_lie_inside() {
        assert_eq!(ticks(&(1.5..30.0)), [2.0, 5.0, 10.0, 20.0]);
        assert_eq!(ticks(&(8.0..22.0)), [10.0, 15.0, 20.0]);
        assert_eq!(decades(&(0.5..150.0)), [1.0, 10.0, 100.0]);
    }
}
