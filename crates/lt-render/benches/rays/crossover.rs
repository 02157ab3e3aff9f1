//! Where it pays to ask in the light's own space: ours beside Embree's over the number of random triangles, and scene by scene beside what
//! was aimed at.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::Outcome;
use super::light;
use super::measure::Family;
use super::rebuilt::Rebuilt;
use super::report::{List, Row, one, two};

const SIZE: (u32, u32) = (1100, 980);
/// Readable on white and on dark grey alike.
const INK: RGBColor = RGBColor(110, 110, 110);
const DIVIDED: RGBColor = RGBColor(214, 60, 40);
const PLANTED: RGBColor = RGBColor(200, 90, 160);
const RAYS: RGBColor = RGBColor(240, 150, 60);
const EMBREE: RGBColor = RGBColor(30, 90, 200);
const EMBREE_STANDS: RGBColor = RGBColor(70, 170, 240);

/// How many times as fast as Embree's fastest build and best mode divide and conquer should be.
const DIVIDED_AIMS: [(&str, f64); 4] =
    [("street", 1.8), ("forest", 3.5), ("random:100000", 3.5), ("random:1000000", 3.5)];
/// How many times as fast as Embree's best mode the light BVH should be.
const PLANTED_AIMS: [(&str, f64); 6] = [
    ("street", 1.1),
    ("square", 1.5),
    ("forest", 1.5),
    ("random:10000", 2.5),
    ("random:100000", 2.5),
    ("random:1000000", 2.5),
];

/// A scene of the plot.
struct Entry<'a> {
    row: &'a Row,
    /// On one thread and on two.
    rebuilt: [&'a Rebuilt; 2],
}

impl Entry<'_> {
    fn planted(&self, threads: usize) -> Option<f64> {
        let rate = [one, two][threads];
        Some(self.row.rate(light::NAME, rate)? / self.row.best(Family::Embree, rate)?)
    }

    /// Milliseconds of all rays at a rate.
    fn ms(&self, rate: Option<f64>) -> Option<f64> {
        Some(self.row.rays as f64 / rate? * 1e-3)
    }
}

fn entries<'a>(rows: &'a [Row], rebuilt: &'a [Rebuilt]) -> Vec<Entry<'a>> {
    let of = |scene: &str, threads| rebuilt.iter().find(|r| r.scene == scene && r.threads == threads);
    let primary = rows.iter().filter(|row| row.list == List::Primary);
    let entry = |row: &'a Row| Some(Entry { row, rebuilt: [of(&row.scene, 1)?, of(&row.scene, 2)?] });
    primary.filter_map(entry).collect()
}

/// How many triangles a scene of random ones has.
fn random(scene: &str) -> Option<f64> {
    scene.strip_prefix("random:")?.parse().ok()
}

/// In words, where the times of divide and conquer and of Embree with its build cross on random triangles, one thread.
pub fn words(rows: &[Row], rebuilt: &[Rebuilt]) -> Option<String> {
    let mut points: Vec<(f64, f64)> = entries(rows, rebuilt)
        .iter()
        .filter_map(|e| Some((random(&e.row.scene)?, e.rebuilt[0].ratio())))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (first, last) = (points.first()?, points.last()?);
    let crossing = points.windows(2).find(|w| w[0].1 < 1.0 && w[1].1 >= 1.0).map(|w| {
        let part = -w[0].1.ln() / (w[1].1 / w[0].1).ln();
        (w[0].0.ln() + part * (w[1].0 / w[0].0).ln()).exp()
    });
    Some(match crossing {
        Some(at) => {
            // No more digits than two measurements on either side allow.
            let digit = 10f64.powf(at.log10().floor());
            format!(
                "On random triangles the two cross at about {:.0} triangles, one thread.",
                (at / digit).round() * digit
            )
        }
        None if first.1 >= 1.0 => {
            format!("On random triangles divide and conquer is ahead from {} on, one thread.", first.0)
        }
        None => format!("On random triangles Embree is ahead up to {}, one thread.", last.0),
    })
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Milliseconds over random triangles, one thread; below, ratios of every scene.
///
/// # Errors
/// Whatever the drawing library reports.
pub fn svg(rows: &[Row], rebuilt: &[Rebuilt]) -> Outcome<String> {
    let entries = entries(rows, rebuilt);
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let (upper, lower) = area.split_vertically(SIZE.1 / 2);
        if !entries.is_empty() {
            times(&upper, &entries)?;
            ratios(&lower, &entries)?;
        }
        area.present()?;
    }
    Ok(text)
}

/// A way to answer, its colour, and its milliseconds in a scene.
type Line<'a> = (&'static str, RGBColor, Box<dyn Fn(&Entry) -> Option<f64> + 'a>);

fn times<'a>(area: &Area<'a>, entries: &[Entry]) -> Outcome<()> {
    let mut of_random: Vec<(f64, &Entry)> =
        entries.iter().filter_map(|e| Some((random(&e.row.scene)?, e))).collect();
    of_random.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (Some(first), Some(last)) = (of_random.first(), of_random.last()) else { return Ok(()) };
    let lines: [Line; 5] = [
        (
            "all rebuilt: Embree, fastest build + best mode",
            EMBREE,
            Box::new(|e| Some(e.rebuilt[0].embree_build + e.rebuilt[0].embree_rays)),
        ),
        ("all rebuilt: divide and conquer", DIVIDED, Box::new(|e| Some(e.rebuilt[0].ours))),
        (
            "built before: Embree, best mode",
            EMBREE_STANDS,
            Box::new(|e| e.ms(e.row.best(Family::Embree, one))),
        ),
        ("built before: our rays", RAYS, Box::new(|e| e.ms(e.row.rate("ours", one)))),
        ("built before: light BVH", PLANTED, Box::new(|e| e.ms(e.row.rate(light::NAME, one)))),
    ];
    let all = || of_random.iter().flat_map(|(_, e)| lines.iter().filter_map(|l| l.2(e)));
    let (low, high) = (all().fold(f64::INFINITY, f64::min) / 1.3, all().fold(0.0, f64::max) * 1.3);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(
            "Random triangles, all rays of a frame, one thread",
            ("sans-serif", 18).into_font().color(&INK),
        )
        .set_label_area_size(LabelAreaPosition::Left, 60)
        .set_label_area_size(LabelAreaPosition::Bottom, 40)
        .build_cartesian_2d(
            (first.0 / 1.2..last.0.max(first.0 * 10.0) * 1.2).log_scale(),
            (low..high).log_scale(),
        )?;
    chart
        .configure_mesh()
        .axis_style(INK)
        .bold_line_style(INK.mix(0.25))
        .light_line_style(TRANSPARENT)
        .label_style(("sans-serif", 14).into_font().color(&INK))
        .x_label_formatter(&|x| format!("{x:.0}"))
        .x_desc("triangles (log)")
        .y_desc("ms (log)")
        .draw()?;
    for (name, colour, value) in &lines {
        let points = of_random.iter().filter_map(|(count, e)| Some((*count, value(e)?)));
        let (colour, line) = (*colour, LineSeries::new(points, colour.stroke_width(2)).point_size(4));
        chart
            .draw_series(line)?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
    }
    legend(&mut chart)
}

fn legend<'a, X: Ranged<ValueType = f64>, Y: Ranged<ValueType = f64>>(
    chart: &mut ChartContext<'a, SVGBackend<'a>, Cartesian2d<X, Y>>,
) -> Outcome<()> {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .border_style(INK)
        .background_style(WHITE.mix(0.8))
        .label_font(("sans-serif", 14).into_font().color(&INK))
        .draw()?;
    Ok(())
}

fn ratios<'a>(area: &Area<'a>, entries: &[Entry]) -> Outcome<()> {
    let planted = entries.iter().flat_map(|e| [e.planted(0), e.planted(1)]).flatten();
    let divided = entries.iter().flat_map(|e| e.rebuilt.map(Rebuilt::ratio));
    let (low, high) = planted.chain(divided).fold((0.7f64, 5.0f64), |(l, h), r| (l.min(r), h.max(r)));
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(
            "Times as fast as Embree; the bars are what was aimed at",
            ("sans-serif", 18).into_font().color(&INK),
        )
        .set_label_area_size(LabelAreaPosition::Left, 60)
        .set_label_area_size(LabelAreaPosition::Bottom, 40)
        .build_cartesian_2d(-0.5..entries.len() as f64 - 0.5, (low / 1.2..high * 1.8).log_scale())?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .axis_style(INK)
        .bold_line_style(INK.mix(0.25))
        .light_line_style(TRANSPARENT)
        .label_style(("sans-serif", 14).into_font().color(&INK))
        .x_labels(entries.len() + 1)
        .x_label_formatter(&|x| {
            let at = (*x + 0.25).max(0.0) as usize;
            let is_scene = (x - x.round()).abs() < 1e-6 && *x > -0.25;
            entries.get(at).filter(|_| is_scene).map_or(String::new(), |e| e.row.scene.clone())
        })
        .y_label_formatter(&|y| format!("{y:.1}"))
        .y_desc("Embree's time / ours (log)")
        .draw()?;
    let even = [(-0.5, 1.0), (entries.len() as f64 - 0.5, 1.0)];
    chart.draw_series(LineSeries::new(even, INK.stroke_width(1)))?;
    let aim = |aims: &[(&str, f64)], e: &Entry| aims.iter().find(|a| a.0 == e.row.scene).map(|a| a.1);
    for (aims, at, colour) in [(&DIVIDED_AIMS[..], -0.12, DIVIDED), (&PLANTED_AIMS[..], 0.12, PLANTED)] {
        for (i, value) in entries.iter().enumerate().filter_map(|(i, e)| Some((i as f64 + at, aim(aims, e)?)))
        {
            let bar = [(i - 0.1, value), (i + 0.1, value)];
            chart.draw_series(LineSeries::new(bar, colour.stroke_width(3)))?;
        }
    }
    type Ratio = Box<dyn Fn(&Entry) -> Option<f64>>;
    let series: [(&str, f64, RGBColor, bool, Ratio); 4] = [
        (
            "divide and conquer, all rebuilt: one thread",
            -0.17,
            DIVIDED,
            true,
            Box::new(|e| Some(e.rebuilt[0].ratio())),
        ),
        ("… two threads", -0.07, DIVIDED, false, Box::new(|e| Some(e.rebuilt[1].ratio()))),
        ("light BVH, built before: one thread", 0.07, PLANTED, true, Box::new(|e| e.planted(0))),
        ("… two threads", 0.17, PLANTED, false, Box::new(|e| e.planted(1))),
    ];
    for (name, at, colour, is_filled, ratio) in series {
        let style = ShapeStyle { color: colour.to_rgba(), filled: is_filled, stroke_width: 2 };
        let points = entries.iter().enumerate().filter_map(|(i, e)| Some((i as f64 + at, ratio(e)?)));
        chart
            .draw_series(points.map(|at| Circle::new(at, 5, style)))?
            .label(name)
            .legend(move |at| Circle::new(at, 5, style));
    }
    legend(&mut chart)
}
