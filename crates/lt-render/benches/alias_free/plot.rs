//! Cost against the number of triangles, on logarithmic axes.

use plotters::prelude::*;

use super::Outcome;
use super::random::{Phases, Row};

const SIZE: (u32, u32) = (900, 520);
/// Readable on white and on dark grey alike.
const INK: RGBColor = RGBColor(110, 110, 110);

/// A way to answer, its colour, and its time.
type Line = (&'static str, RGBColor, fn(&Row) -> f64);

const LINES: [Line; 6] = [
    ("alias-free, medians: all", RGBColor(214, 60, 40), |r| r.medians.total()),
    ("alias-free, medians: tree", RGBColor(240, 170, 150), |r| r.medians.build),
    ("alias-free, Morton: all", RGBColor(240, 150, 60), |r| r.morton.total()),
    ("rays and their BVH", RGBColor(30, 90, 200), |r| r.rays.total()),
    ("rays alone", RGBColor(70, 170, 240), |r| run(&r.rays)),
    ("samples to light space", INK, |r| r.transform),
];

fn run(phases: &Phases) -> f64 {
    phases.run
}

/// One thread's milliseconds over triangles.
///
/// # Errors
/// Whatever the drawing library reports.
pub fn svg(rows: &[Row]) -> Outcome<String> {
    let mut text = String::new();
    let counts = || rows.iter().map(|r| f64::from(r.triangles));
    let all = || rows.iter().flat_map(|r| LINES.iter().map(move |l| l.2(r)));
    let (least, most) = (counts().fold(f64::INFINITY, f64::min), counts().fold(1.0, f64::max));
    let (low, high) = (all().fold(f64::INFINITY, f64::min) / 1.3, all().fold(0.0, f64::max) * 1.3);
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        if !rows.is_empty() {
            let mut chart = ChartBuilder::on(&area)
                .margin(12)
                .caption("Random triangles, 1024×768, one thread", ("sans-serif", 18).into_font().color(&INK))
                .set_label_area_size(LabelAreaPosition::Left, 60)
                .set_label_area_size(LabelAreaPosition::Bottom, 40)
                .build_cartesian_2d((least..most.max(least * 10.0)).log_scale(), (low..high).log_scale())?;
            chart.configure_mesh().x_desc("triangles").y_desc("ms").axis_style(INK).draw()?;
            for (name, colour, value) in LINES {
                let points = rows.iter().map(|r| (f64::from(r.triangles), value(r)));
                let line = LineSeries::new(points, colour.stroke_width(2)).point_size(3);
                chart
                    .draw_series(line)?
                    .label(name)
                    .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
            }
            chart
                .configure_series_labels()
                .position(SeriesLabelPosition::UpperLeft)
                .border_style(INK)
                .background_style(WHITE.mix(0.8))
                .draw()?;
        }
        area.present()?;
    }
    Ok(text)
}
