//! Speed-ups by scene and by picture size, and wrong pixels from no history: one picture of three panels.

use anyhow::{Result, anyhow};
use plotters::coord::{CoordTranslate, Shift};
use plotters::prelude::*;

use super::tables::speed_up;
use super::{FENCE, Found, ONE_MAP, SCENES, paper};

const SIZE: (u32, u32) = (1000, 900);
/// Readable on white and on dark grey alike.
const INK: RGBColor = RGBColor(110, 110, 110);
/// Colours told apart by colour-blind eyes (Okabe and Ito).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Name, colour, and points (place on the axis, average, least, largest).
type Bars<'a> = (&'a str, RGBColor, Vec<(f64, paper::Spread)>);

/// All panels.
///
/// # Errors
/// A run that lacks a technique, or whatever the drawing library reports.
pub fn svg(found: &Found) -> Result<String> {
    let scene = |id: &str| -> Result<Vec<(f64, paper::Spread)>> {
        found.scenes.iter().enumerate().map(|(i, (_, r))| Ok((i as f64, speed_up(r, id)?))).collect()
    };
    let size = |id: &str| -> Result<Vec<(f64, paper::Spread)>> {
        found.sizes.iter().enumerate().map(|(i, (_, r))| Ok((i as f64, speed_up(r, id)?))).collect()
    };
    let flat = |v: f64| [v, v, v];
    let of_paper = paper::SPEED_UPS.iter().enumerate().map(|(i, p)| (i as f64, p.1)).collect();
    let paper_sizes = paper::PICTURE_SIZES.iter().enumerate().map(|(i, p)| (i as f64, flat(p.1))).collect();
    let by_scene: [Bars<'_>; 3] = [
        ("lt-evsm", COLOURS[0], scene("lt-evsm")?),
        ("ltt-evsm", COLOURS[2], scene("ltt-evsm")?),
        ("the paper's, in its four scenes", COLOURS[1], of_paper),
    ];
    let by_size: [Bars<'_>; 3] = [
        ("lt-evsm, street", COLOURS[0], size("lt-evsm")?),
        ("ltt-evsm, street", COLOURS[2], size("ltt-evsm")?),
        ("the paper's, Bistro", COLOURS[1], paper_sizes),
    ];
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        let failed = |e: DrawingAreaErrorKind<std::io::Error>| anyhow!("plot: {e}");
        area.fill(&WHITE).map_err(failed)?;
        let (top, bottom) = area.split_vertically(430);
        let (left, right) = top.split_horizontally(500);
        whiskers(&left, "Speed-up over full ray tracing", &by_scene, &SCENES).map_err(failed)?;
        whiskers(&right, "Speed-up by picture size", &by_size, &found.extent.sizes).map_err(failed)?;
        let lines: Result<Vec<_>> = FENCE
            .iter()
            .map(|id| {
                let frames = &found.fence.1.row(&format!("{id}{ONE_MAP}"))?.path.frames;
                Ok((*id, frames.iter().map(|f| f.wrong_ppm()).collect::<Vec<f64>>()))
            })
            .collect();
        convergence(&bottom, &lines?).map_err(failed)?;
        area.present().map_err(failed)?;
    }
    Ok(text)
}

/// Averages as dots, least to largest as lines, one place on the axis for each name.
fn whiskers(area: &Area<'_>, caption: &str, bars: &[Bars<'_>], names: &[&str]) -> Drawn {
    // Room for the legend above.
    let most = bars.iter().flat_map(|b| &b.2).map(|p| p.1[2]).fold(1.0, f64::max) * 1.35;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(caption, ("sans-serif", 18).into_font().color(&INK))
        .set_label_area_size(LabelAreaPosition::Left, 50)
        .set_label_area_size(LabelAreaPosition::Bottom, 34)
        .build_cartesian_2d(-0.5..names.len() as f64 - 0.5, 0.0..most)?;
    let name = |x: &f64| {
        let is_whole = (x - x.round()).abs() < 1e-6 && *x > -0.1;
        let name = names.get(x.round() as usize).filter(|_| is_whole);
        name.map_or(String::new(), |n| (*n).to_owned())
    };
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .x_labels(2 * names.len() + 1)
        .x_label_formatter(&name)
        .y_desc("times as fast")
        .axis_style(INK)
        .draw()?;
    chart.draw_series(LineSeries::new([(-0.5, 1.0), (names.len() as f64 - 0.5, 1.0)], INK))?;
    for (i, (label, colour, points)) in bars.iter().enumerate() {
        let colour = *colour;
        let shift = (i as f64 - 1.0) * 0.18;
        for &(x, [average, least, largest]) in points {
            let line = [(x + shift, least), (x + shift, largest)];
            chart.draw_series(LineSeries::new(line, colour.stroke_width(2)))?;
            chart.draw_series([Circle::new((x + shift, average), 4, colour.filled())])?;
        }
        let none = std::iter::empty::<Circle<(f64, f64), i32>>();
        chart
            .draw_series(none)?
            .label(*label)
            .legend(move |(x, y)| Circle::new((x + 9, y), 4, colour.filled()));
    }
    legend(&mut chart, SeriesLabelPosition::UpperRight)
}

/// Wrong pixels over frames, on a logarithmic axis whose floor reads "none".
fn convergence(area: &Area<'_>, lines: &[(&str, Vec<f64>)]) -> Drawn {
    let known = || lines.iter().flat_map(|l| &l.1).copied().filter(|v| *v > 0.0);
    let (least, most) = known().fold((f64::INFINITY, 1.0), |(a, b): (f64, f64), v| (a.min(v), b.max(v)));
    let floor = 10f64.powf(if least.is_finite() { least.log10().floor() - 1.0 } else { -1.0 });
    let frames = lines.iter().map(|l| l.1.len()).max().unwrap_or(1).max(2);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(
            "A fence with one map of 64², from no history: wrong pixels, ppm",
            ("sans-serif", 18).into_font().color(&INK),
        )
        .set_label_area_size(LabelAreaPosition::Left, 70)
        .set_label_area_size(LabelAreaPosition::Bottom, 40)
        .build_cartesian_2d(
            (1.0..frames as f64).log_scale(),
            (floor..most * 2.0).log_scale().with_key_points(
                (0..9).map(|e| floor * 10f64.powi(e)).filter(|v| *v < most * 2.0).collect::<Vec<f64>>(),
            ),
        )?;
    let number = |v: &f64| if *v <= floor * 1.001 { "none".to_owned() } else { format!("{v}") };
    let whole = |v: &f64| format!("{v:.0}");
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("frame")
        .x_label_formatter(&whole)
        .y_label_formatter(&number)
        .axis_style(INK)
        .draw()?;
    for ((name, values), colour) in lines.iter().zip(COLOURS) {
        let points = values.iter().enumerate().map(|(i, v)| (i as f64 + 1.0, v.max(floor)));
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
    }
    legend(&mut chart, SeriesLabelPosition::LowerLeft)
}

fn legend<'a, 'b, C: CoordTranslate>(
    chart: &mut ChartContext<'a, SVGBackend<'b>, C>,
    position: SeriesLabelPosition,
) -> Drawn
where
    'b: 'a,
{
    chart
        .configure_series_labels()
        .position(position)
        .border_style(INK)
        .background_style(WHITE.mix(0.85))
        .draw()
}
