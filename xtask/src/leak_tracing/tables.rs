//! Markdown of all that was measured, the paper's figures beside ours.

use std::fmt::Write;

use anyhow::Result;

use super::cells::{Cell, Frame, Results, Row};
use super::paper::{self, Spread};
use super::today::today;
use super::{FENCE, Found, KINDS, ONE_MAP, SCALES, SCENES};

/// All tables.
///
/// # Errors
/// A run that lacks a technique it was asked for.
pub fn markdown(found: &Found) -> Result<String> {
    let mut out = String::new();
    let first = &found.scenes[0].1;
    let _ = writeln!(
        out,
        "{}, {}, {} threads. Counted are maps, estimate, mask and rays (the paper's *without shading*; the camera pass and shading are \
         not); trees built anew where things move are not counted either. Unless said otherwise {}, three maps of 2048² and a \
         traced last level, the camera moving by 2 px a frame at a width of 1920; speed-ups are those of single frames over \
         `ray` in the same frame, averages (least to largest), without the first frame, which has neither map nor history. Rays are \
         per pixel with geometry, wrong pixels per million of them, false-lit + false-shadowed, medians over the same frames. The \
         paper's scenes are not ours, and its machine traces rays in hardware.\n",
        today(),
        first.device,
        first.threads,
        found.extent.size,
    );
    speed_ups(&mut out, found)?;
    times(&mut out, found)?;
    figure_8(&mut out, found)?;
    convergence(&mut out, found)?;
    scale(&mut out, found)?;
    Ok(out)
}

fn commands<'a>(out: &mut String, cells: impl IntoIterator<Item = &'a Cell>) {
    let lines: Vec<String> = cells.into_iter().map(Cell::command).collect();
    let _ = writeln!(out, "```sh\n{}\n```\n", lines.join("\n"));
}

/// Frames after the first.
pub fn later(row: &Row) -> &[Frame] {
    row.path.frames.get(1..).unwrap_or(&[])
}

/// Speed-ups over full ray tracing, frame by frame, without the first.
///
/// # Errors
/// No such technique, or no `ray`.
pub fn speed_up(results: &Results, technique: &str) -> Result<Spread> {
    let (ray, own) = (results.row("ray")?, results.row(technique)?);
    Ok(spread(later(ray).iter().zip(later(own)).map(|(r, o)| r.total_ms / o.total_ms)))
}

/// Average, least and largest.
fn spread(values: impl Iterator<Item = f64>) -> Spread {
    let values: Vec<f64> = values.collect();
    let average = values.iter().sum::<f64>() / values.len().max(1) as f64;
    [
        average,
        values.iter().copied().fold(f64::INFINITY, f64::min),
        values.iter().copied().fold(0.0, f64::max),
    ]
}

fn shown(s: Spread) -> String {
    format!("{:.2} ({:.2}–{:.2})", s[0], s[1], s[2])
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn rays(row: &Row) -> String {
    format!("{:.3}", median(later(row).iter().map(|f| f.rays_per_pixel)))
}

fn wrong(row: &Row) -> String {
    let of = |side: fn(&Frame) -> f64| median(later(row).iter().map(side));
    format!("{:.0} + {:.0}", of(|f| f.false_lit_ppm), of(|f| f.false_shadowed_ppm))
}

fn speed_ups(out: &mut String, found: &Found) -> Result<()> {
    let _ = writeln!(out, "### Table 2: speed-ups over full ray tracing\n");
    commands(out, found.scenes.iter().map(|s| &s.0));
    let _ = writeln!(
        out,
        "| | `lt-evsm` | first frame | `ltt-evsm` | rays: `ray` | `ltt-evsm` | `lt-evsm` | wrong: `ltt-evsm` | `lt-evsm` | paper's \
         scene | without shading | with shading |\n|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for ((scene, (_, results)), paper) in SCENES.iter().zip(&found.scenes).zip(&paper::SPEED_UPS) {
        let (ray, doubt, mask) = (results.row("ray")?, results.row("ltt-evsm")?, results.row("lt-evsm")?);
        let first = ray.path.frames[0].total_ms / mask.path.frames[0].total_ms;
        let _ = writeln!(
            out,
            "| {scene} | {} | {first:.2} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            shown(speed_up(results, "lt-evsm")?),
            shown(speed_up(results, "ltt-evsm")?),
            rays(ray),
            rays(doubt),
            rays(mask),
            wrong(doubt),
            wrong(mask),
            paper.0,
            shown(paper.1),
            shown(paper.2),
        );
    }
    out.push('\n');
    Ok(())
}

fn times(out: &mut String, found: &Found) -> Result<()> {
    let results = &found.scenes[1].1;
    let _ = writeln!(
        out,
        "### Table 3: milliseconds along a path\n\nThe square's run of Table 2; the paper's are of Emerald Square. Maps alone are drawn \
         every frame in four levels. The paper's row of leak tracing after AMD's detector, 1.31 (0.58–2.39) ms, has no counterpart: that \
         detector is not built here.\n\n| | ms | times `ray` | rays | wrong | maps drawn | paper, ms | times its `ray` |\n\
         |---|---|---|---|---|---|---|---|"
    );
    let ray = spread(later(results.row("ray")?).iter().map(|f| f.total_ms));
    let paper_ray = paper::TIMES_MS.iter().find(|t| t.0 == "ray").map_or(f64::NAN, |t| t.1[0]);
    for (name, theirs) in paper::TIMES_MS {
        let id = match name {
            "sm" | "vsm" | "msm" => format!("{name}:no-reuse:cascades=4"),
            _ => name.to_owned(),
        };
        let row = results.row(&id)?;
        let ms = spread(later(row).iter().map(|f| f.total_ms));
        let _ = writeln!(
            out,
            "| `{id}` | {:.1} ({:.1}–{:.1}) | {:.2} | {} | {} | {} | {} | {:.2} |",
            ms[0],
            ms[1],
            ms[2],
            ms[0] / ray[0],
            rays(row),
            wrong(row),
            row.path.map_draws,
            shown(theirs),
            theirs[0] / paper_ray,
        );
    }
    out.push('\n');
    Ok(())
}

fn figure_8(out: &mut String, found: &Found) -> Result<()> {
    let _ = writeln!(out, "### Figure 8: sizes and kinds\n");
    commands(out, found.sizes.iter().map(|s| &s.0));
    let _ = writeln!(
        out,
        "Picture sizes, street (the paper's are of Bistro, with shading):\n\n| | `lt-evsm` | `ltt-evsm` | rays: `lt-evsm` | wrong: \
         `ltt-evsm` | `lt-evsm` | paper |\n|---|---|---|---|---|---|---|"
    );
    for (size, (_, results)) in found.extent.sizes.iter().zip(&found.sizes) {
        let theirs = paper::PICTURE_SIZES.iter().find(|p| p.0 == *size);
        let _ = writeln!(
            out,
            "| {size} | {} | {} | {} | {} | {} | {} |",
            shown(speed_up(results, "lt-evsm")?),
            shown(speed_up(results, "ltt-evsm")?),
            rays(results.row("lt-evsm")?),
            wrong(results.row("ltt-evsm")?),
            wrong(results.row("lt-evsm")?),
            theirs.map_or("–".to_owned(), |p| format!("{:.2}", p.1)),
        );
    }
    let (cell, results) = &found.map_sizes;
    let _ = writeln!(out, "\nMap sizes, street:\n");
    commands(out, [cell]);
    let _ = writeln!(out, "| | `lt-evsm` | rays | wrong | paper |\n|---|---|---|---|---|");
    for (size, theirs) in paper::MAP_SIZES {
        let id = format!("lt-evsm:map={size}");
        let row = results.row(&id)?;
        let up = shown(speed_up(results, &id)?);
        let _ = writeln!(out, "| {size}² | {up} | {} | {} | {theirs:.2} |", rays(row), wrong(row));
    }
    let _ = writeln!(out, "\nMap kinds (the paper ranks EVSM ≥ VSM > MSM > ESM):\n");
    commands(out, found.kinds.iter().map(|k| &k.0));
    let _ = writeln!(
        out,
        "| | street: speed-up | rays | wrong | forest: speed-up | rays | wrong |\n|---|---|---|---|---|---|---|"
    );
    for id in KINDS {
        let mut cells = Vec::new();
        for (_, results) in &found.kinds {
            let row = results.row(id)?;
            cells.extend([shown(speed_up(results, id)?), rays(row), wrong(row)]);
        }
        let _ = writeln!(out, "| `{id}` | {} |", cells.join(" | "));
    }
    out.push('\n');
    Ok(())
}

/// Frames of a cold start that tables show.
const SHOWN_FRAMES: [usize; 8] = [0, 1, 3, 7, 15, 31, 63, 399];

fn convergence(out: &mut String, found: &Found) -> Result<()> {
    let _ = writeln!(
        out,
        "### Figure 10: from no history\n\nNothing moves and the mask starts cleared (`--cold`); wrong pixels per million in the frames \
         counted from 1, false-lit + false-shadowed together. The paper's worst case, a fence with a map of 64², takes about 350 frames \
         and keeps one hole. *Settled* is the number of frames before the first from which on as many pixels are wrong as in the last.\n"
    );
    let all = [&found.fence].into_iter().chain(&found.cold);
    commands(out, all.clone().map(|c| &c.0));
    for ((cell, results), name) in all.zip(["fence, one map of 64²", "street", "forest"]) {
        let count = results.rows.first().map_or(0, |r| r.path.frames.len());
        let frames: Vec<usize> = SHOWN_FRAMES.into_iter().filter(|f| *f < count).chain([count - 1]).collect();
        let frames: Vec<usize> =
            frames.iter().enumerate().filter(|(i, f)| !frames[..*i].contains(f)).map(|(_, f)| *f).collect();
        let heads: Vec<String> = frames.iter().map(|f| (f + 1).to_string()).collect();
        let _ = writeln!(
            out,
            "| {name}: frame | {} | settled | rays in the last |\n|---|{}---|---|",
            heads.join(" | "),
            "---|".repeat(heads.len())
        );
        let ids: Vec<String> = match cell.args[0].as_str() {
            "fence" => FENCE.map(|id| format!("{id}{ONE_MAP}")).to_vec(),
            _ => ["lt-evsm", "lt-evsm:refresh=16"].map(str::to_owned).to_vec(),
        };
        for id in ids {
            let row = results.row(&id)?;
            let wrong: Vec<String> =
                frames.iter().map(|f| format!("{:.0}", row.path.frames[*f].wrong_ppm())).collect();
            let last = row.path.frames[count - 1].rays_per_pixel;
            let settled = row.path.frames_to_settle.map_or("–".to_owned(), |n| n.to_string());
            let _ = writeln!(out, "| `{id}` | {} | {settled} | {last:.3} |", wrong.join(" | "));
        }
        out.push('\n');
    }
    Ok(())
}

fn scale(out: &mut String, found: &Found) -> Result<()> {
    let _ = writeln!(out, "### Scale: the scene 10⁻³ and 10³ times as large, every parameter as it is\n");
    commands(out, found.scales.iter().map(|s| &s.0));
    let _ = writeln!(
        out,
        "| | rays: `ray` | `ltt-evsm` | `lt-evsm` | wrong: `ltt-evsm` | `lt-evsm` |\n|---|---|---|---|---|---|"
    );
    for (factor, (_, results)) in SCALES.iter().zip(&found.scales) {
        let row = |id: &str| results.row(id);
        let _ = writeln!(
            out,
            "| × {factor} | {} | {} | {} | {} | {} |",
            rays(row("ray")?),
            rays(row("ltt-evsm")?),
            rays(row("lt-evsm")?),
            wrong(row("ltt-evsm")?),
            wrong(row("lt-evsm")?),
        );
    }
    Ok(())
}
