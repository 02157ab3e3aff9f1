//! `lt compare`: techniques side by side, as a table, a results file, images and a report.

use std::{
    io::Write,
    path::{Path, PathBuf},
    sync::atomic::AtomicBool,
};

use lt_render::{CompareOptions, Comparison, LightStats, Row, Session, Technique};
use rayon::prelude::*;

use crate::{
    args::CompareArgs,
    error_map,
    exr_file::{self, as_floats},
    files,
    numbers::{decimals, factor, grouped, ms, ppm},
    picture::Picture,
    play,
    progress::{Steps, spinner},
    report::Report,
    results::{Results, SETTLED, Statistics, frontier_of, is_settled},
    summary::Summary,
    table::{self, Align},
};

/// Runs the command.
///
/// # Errors
/// A bad request, a failed run, or a file that cannot be written. Files of an earlier run stay until their
/// replacements are complete.
pub fn run(args: &CompareArgs) -> anyhow::Result<()> {
    if args.list {
        return list();
    }
    files::prepare_dir(&args.out)?;
    let mut opened = args.scene.open(&args.techniques(), args.upkeep())?;
    let repeats = args.repeats.unwrap_or(DEFAULT_REPEATS);
    let (comparison, playback) = match args.play.frames {
        None => (single_view(args, &mut opened.session, repeats)?, None),
        Some(frames) => {
            let (comparison, playback) = play::run(args, &mut opened, usize::from(frames))?;
            (comparison, Some(playback))
        }
    };
    let session = &mut opened.session;
    let flips = match args.play.still {
        true => comparison.rows.iter().map(most_flips).collect(),
        false => flips(session, &comparison)?,
    };
    let summary = Summary::of(&opened.name, session);
    let is_valid = session.valid_samples();

    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "{}\n\n{}",
        summary.headline(),
        text_table(&comparison, Statistics::of(playback.as_ref()))
    )?;
    if let Some(playback) = &playback {
        writeln!(
            out,
            "{}\n\n{}",
            playback.headline(),
            play::text_table(&comparison, &flips, playback.is_still)
        )?;
    }
    if !session.setup().more_lights.is_empty() {
        writeln!(out, "{}", light_table(&comparison))?;
    }
    let work = spinner("writing");
    let results = Results::new(&summary, &comparison, &flips, repeats, playback.as_ref());
    files::write(&args.out.join("results.json"), |to| {
        serde_json::to_writer_pretty(&mut *to, &results)?;
        Ok(to.write_all(b"\n")?)
    })?;
    if args.brief {
        work.finish_and_clear();
        writeln!(out, "{}", args.out.join("results.json").display())?;
        return Ok(());
    }
    write_images(&args.out, &comparison, &is_valid)?;
    let report = Report::new(&summary, &comparison, &is_valid, playback.as_ref())?.render()?;
    let report_path = args.out.join("report.html");
    files::write(&report_path, |to| Ok(to.write_all(report.as_bytes())?))?;
    work.finish_and_clear();
    writeln!(out, "{} (open in a browser), results.json and images beside it", report_path.display())?;
    Ok(())
}

/// Timed repeats unless told otherwise.
const DEFAULT_REPEATS: u16 = 5;

fn single_view(args: &CompareArgs, session: &mut Session, repeats: u16) -> anyhow::Result<Comparison> {
    let options = CompareOptions { repeats: usize::from(repeats), with_flip: !args.no_flip };
    let mut steps = Steps::new();
    let never = AtomicBool::new(false);
    let comparison =
        lt_render::compare(session, &args.techniques(), &options, &never, |done, total, what| {
            steps.at(done, total, what);
        });
    steps.clear();
    Ok(comparison?)
}

/// The most pixels that changed between two successive frames with nothing moving.
fn most_flips(row: &Row) -> u64 {
    row.frames.iter().filter_map(|f| f.flips).max().unwrap_or(0)
}

fn list() -> anyhow::Result<()> {
    let row = |(id, words): (String, String)| vec![id, words];
    let all = Technique::catalogue().into_iter().chain(Technique::in_light_space());
    let techniques: Vec<_> = all.map(|(t, words)| row((t.to_string(), words))).collect();
    let modifiers: Vec<_> =
        Technique::modifiers().iter().map(|(m, w)| row((format!(":{m}"), (*w).into()))).collect();
    let mut out = std::io::stdout().lock();
    write!(
        out,
        "{}",
        table::render(&[("technique", Align::Left), ("what it does", Align::Left)], &techniques)
    )?;
    write!(
        out,
        "\n{}",
        table::render(&[("modifier", Align::Left), ("what it changes", Align::Left)], &modifiers)
    )?;
    writeln!(out, "\nModifiers follow the technique: ltt-evsm:prefiltered:eps=0.02:map=1024")?;
    Ok(())
}

/// Pixels that differ, bit by bit, between the judged frame and one more of the same with nothing moved.
fn flips(session: &mut Session, comparison: &Comparison) -> anyhow::Result<Vec<u64>> {
    let work = spinner("looking for flicker");
    let again = |row: &Row| Ok(lt_render::flips(&session.render(&row.technique)?, &row.frame));
    let flips = comparison.rows.iter().map(again).collect();
    work.finish_and_clear();
    flips
}

fn text_table(comparison: &Comparison, statistics: Statistics) -> String {
    let [rays, cluster] = per_unit_headings(comparison);
    let columns = [
        ("technique", Align::Left),
        (&rays[..], Align::Right),
        ("false-lit\nppm", Align::Right),
        ("false-shadowed\nppm", Align::Right),
        (&cluster[..], Align::Right),
        ("FLIP", Align::Right),
        ("map\nms", Align::Right),
        ("shadow\nms", Align::Right),
        ("total\nms", Align::Right),
        ("speed-up\nover ray", Align::Right),
    ];
    let row = |(row, is_best): (&Row, bool)| {
        vec![
            format!("{}{}", row.technique, if is_best { " *" } else { "" }),
            decimals(Some(row.rays_per_pixel), 3),
            ppm(row.errors.false_lit_ppm()),
            ppm(row.errors.false_shadowed_ppm()),
            grouped(row.errors.largest_cluster_px.into()),
            decimals(row.flip_mean, 4),
            ms(row.map_ms),
            ms(row.shadow_ms),
            ms(row.total_ms),
            factor(row.speedup_over_ray),
        ]
    };
    let rows: Vec<_> = comparison.rows.iter().zip(frontier_of(comparison)).map(row).collect();
    let mut text = format!(
        "{}\n* no other row is both faster and more right; ppm of {} {}s with geometry\n{}\n",
        table::render(&columns, &rows),
        grouped(comparison.valid_pixels),
        comparison.unit(),
        statistics.sentence()
    );
    if comparison.rows.iter().any(is_settled) {
        text += SETTLED;
        text.push('\n');
    }
    text
}

/// Headings of what counts pixels, or samples.
fn per_unit_headings(comparison: &Comparison) -> [String; 2] {
    let unit = comparison.unit();
    let px = if unit == "pixel" { " px" } else { "" };
    [format!("rays\n/{unit}"), format!("largest wrong\ncluster{px}")]
}

/// Each light's share of every technique. Lights count from 0 in the order asked for.
fn light_table(comparison: &Comparison) -> String {
    let [rays, cluster] = per_unit_headings(comparison);
    let columns = [
        ("technique", Align::Left),
        ("light", Align::Right),
        (&rays[..], Align::Right),
        ("false-lit\nppm", Align::Right),
        ("false-shadowed\nppm", Align::Right),
        (&cluster[..], Align::Right),
    ];
    let row = |row: &Row| {
        let id = row.technique.to_string();
        let of = move |(i, light): (usize, &LightStats)| {
            vec![
                id.clone(),
                i.to_string(),
                decimals(Some(light.rays_per_pixel()), 3),
                ppm(light.errors.false_lit_ppm()),
                ppm(light.errors.false_shadowed_ppm()),
                grouped(light.errors.largest_cluster_px.into()),
            ]
        };
        row.lights.iter().enumerate().map(of).collect::<Vec<_>>()
    };
    let rows: Vec<_> = comparison.rows.iter().flat_map(row).collect();
    format!(
        "{}\nabove: rays of all lights; rates count every {} once for each light\n",
        table::render(&columns, &rows),
        comparison.unit()
    )
}

/// Per technique: picture, signed errors and rays as PNG, visibility and doubt of the first layer as EXR, sample by sample; and the
/// reference.
fn write_images(dir: &Path, comparison: &Comparison, is_valid: &[Vec<bool>]) -> anyhow::Result<()> {
    let reference = Picture::new(comparison.size, comparison.reference_picture.clone());
    write_png(dir.join("reference.png"), &reference)?;
    comparison.rows.par_iter().try_for_each(|row| {
        let name = files::stem(&row.technique.to_string());
        let under = &row.picture;
        write_png(dir.join(format!("{name}.png")), &Picture::new(comparison.size, under.clone()))?;
        let errors = error_map::error_marks(comparison, row, is_valid);
        write_png(dir.join(format!("{name}.errors.png")), &error_map::over_dimmed(&errors, under))?;
        let rays = error_map::ray_marks(comparison, row);
        write_png(dir.join(format!("{name}.rays.png")), &error_map::over_dimmed(&rays, under))?;
        let channels =
            vec![("visibility.Y", row.frame.visibility.clone()), ("doubt.Y", as_floats(&row.frame.doubt))];
        let size = comparison.size_in_samples();
        files::write(&dir.join(format!("{name}.exr")), |to| exr_file::write(to, size, channels))
    })
}

fn write_png(path: PathBuf, picture: &Picture) -> anyhow::Result<()> {
    files::write(&path, |to| picture.write_png(to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;

    #[test]
    fn the_table_names_every_technique_and_the_frontier() {
        let text = text_table(&fixture::comparison(), Statistics::of(None));
        assert!(text.contains("\nray *") && text.contains("\nsm *"), "{text}");
        assert!(text.contains("125 000"), "{text}");
    }

    #[test]
    fn a_pixel_that_changes_is_counted() {
        let frame = fixture::comparison().reference;
        let mut other = frame.clone();
        assert_eq!(lt_render::flips(&frame, &other), 0);
        other.visibility[3] = f32::NAN;
        assert_eq!((lt_render::flips(&frame, &other), lt_render::flips(&other, &frame)), (1, 1));
    }
}
