//! Rates by scene, on a logarithmic axis.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::Outcome;
use super::measure::Family;
use super::report::{List, Row};

const SIZE: (u32, u32) = (1100, 900);
/// Readable on white and on dark grey alike.
const INK: RGBColor = RGBColor(110, 110, 110);
const OURS: [RGBColor; 4] =
    [RGBColor(214, 60, 40), RGBColor(240, 150, 60), RGBColor(200, 90, 160), RGBColor(150, 60, 60)];
const EMBREE: [RGBColor; 5] = [
    RGBColor(30, 90, 200),
    RGBColor(40, 150, 160),
    RGBColor(90, 190, 120),
    RGBColor(120, 110, 220),
    RGBColor(70, 170, 240),
];
const OBVHS: RGBColor = RGBColor(130, 130, 130);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Both lists, one above the other, one thread each.
///
/// # Errors
/// Whatever the drawing library reports.
pub fn svg(rows: &[Row]) -> Outcome<String> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let halves = area.split_evenly((2, 1));
        for (list, half) in [List::Primary, List::Residual].into_iter().zip(&halves) {
            let rows: Vec<&Row> = rows.iter().filter(|row| row.list == list).collect();
            if !rows.is_empty() {
                draw(half, &rows, list)?;
            }
        }
        area.present()?;
    }
    Ok(text)
}

fn draw(area: &Area, rows: &[&Row], list: List) -> Outcome<()> {
    let rates = || rows.iter().flat_map(|row| row.columns.iter().map(|c| c.one.median));
    let (low, high) = (rates().fold(f64::INFINITY, f64::min) / 1.3, rates().fold(0.0, f64::max) * 1.3);
    let title = match list {
        List::Primary => "all light-facing pixels",
        List::Residual => "the 5 % nearest to a shadow edge",
    };
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .margin_right(230)
        .caption(format!("Occlusion rays, one thread: {title}"), ("sans-serif", 18).into_font().color(&INK))
        .set_label_area_size(LabelAreaPosition::Left, 60)
        .set_label_area_size(LabelAreaPosition::Bottom, 34)
        .build_cartesian_2d(-0.5..rows.len() as f64 - 0.5, (low..high).log_scale())?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .axis_style(INK)
        .bold_line_style(INK.mix(0.25))
        .light_line_style(TRANSPARENT)
        .label_style(("sans-serif", 14).into_font().color(&INK))
        .x_labels(rows.len() + 1)
        .x_label_formatter(&|x| {
            let is_scene = (x - x.round()).abs() < 1e-6 && *x > -0.25;
            if is_scene {
                rows.get(x.round() as usize).map_or(String::new(), |r| r.scene.clone())
            } else {
                String::new()
            }
        })
        .y_desc("Mrays/s (log)")
        .draw()?;
    let names: Vec<(String, Family)> = rows[0]
        .columns
        .iter()
        .filter(|c| c.family != Family::Obvhs)
        .map(|c| (c.name.clone(), c.family))
        .collect();
    let mut seen = [0usize; 2];
    for (name, family) in names {
        let color = match family {
            Family::Ours => OURS[seen[0] % OURS.len()],
            _ => EMBREE[seen[1] % EMBREE.len()],
        };
        seen[usize::from(family != Family::Ours)] += 1;
        let size = if family == Family::Ours { 6 } else { 4 };
        let rate = |row: &&Row| row.columns.iter().find(|c| c.name == name).map(|c| c.one.median);
        series(&mut chart, rows, &name, color, size, &rate)?;
    }
    let best = |row: &&Row| row.best(Family::Obvhs, super::report::one);
    series(&mut chart, rows, "obvhs, better tree", OBVHS, 4, &best)?;
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::Coordinate(SIZE.0 as i32 - 290, 20))
        .label_font(("sans-serif", 14).into_font().color(&INK))
        .draw()?;
    Ok(())
}

type Chart<'a, 'b> =
    ChartContext<'a, SVGBackend<'b>, Cartesian2d<plotters::coord::types::RangedCoordf64, LogCoord<f64>>>;

fn series(
    chart: &mut Chart,
    rows: &[&Row],
    name: &str,
    color: RGBColor,
    size: i32,
    rate: &dyn Fn(&&Row) -> Option<f64>,
) -> Outcome<()> {
    let points = rows.iter().enumerate().filter_map(|(i, row)| Some((i as f64, rate(row)?)));
    let points: Vec<(f64, f64)> = points.collect();
    chart.draw_series(LineSeries::new(points.iter().copied(), color.mix(0.35)))?;
    chart
        .draw_series(points.into_iter().map(|at| Circle::new(at, size, color.filled())))?
        .label(name)
        .legend(move |at| Circle::new(at, size, color.filled()));
    Ok(())
}
