//! The measurements of "Alias-Free Shadow Maps" (Aila and Laine 2004), ours beside the paper's: random triangles of constant total
//! area, close-ups of them, and a hair ball that lets light through; and what several samples per pixel cost.
//!
//! `cargo xtask papers alias-free` runs this and keeps the tables. Counters are the paper's own and depend on no machine. Every
//! answer is compared with the ray tracer's; a difference ends the run.

#[path = "../rays/rays.rs"]
#[expect(dead_code, reason = "the rays' bench takes parts of its lists")]
mod rays;
#[path = "../rays/today.rs"]
mod today;

mod figures;
mod hair;
mod options;
mod plot;
mod random;
mod samples;
mod table;

use std::io::Cursor;
use std::path::Path;
use std::time::Instant;

use clap::Parser;
use image::{ImageFormat, RgbImage};
use options::Options;

/// Whatever may go wrong ends the run with its message.
type Outcome<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

fn main() -> Outcome<()> {
    let options = Options::parse();
    let mut rows = Vec::new();
    for &count in &options.triangles {
        eprintln!("random:{count}");
        rows.push(random::measure(count, None, &options)?);
    }
    let mut close = Vec::new();
    for &fov in &options.close_ups {
        eprintln!("random:100000 within {fov}°");
        close.push(random::measure(100_000, Some(fov), &options)?);
    }
    let mut hair = Vec::new();
    for &hairs in options.hairs.iter().filter(|hairs| **hairs > 0) {
        eprintln!("strands:{hairs}");
        hair.push(hair::measure(hairs, &options)?);
    }
    let mut sampled = Vec::new();
    for name in options.sampled.iter().filter(|name| *name != "none") {
        eprintln!("{name}, 1 to 32 samples per pixel");
        sampled.push(samples::measure(name, &options)?);
    }
    let text = table::markdown(&rows, &close, &hair, &sampled);
    println!("{text}");
    if let Some(folder) = &options.out {
        std::fs::create_dir_all(folder)?;
        write(&folder.join("alias-free.md"), text.as_bytes())?;
        write(&folder.join("alias-free.svg"), plot::svg(&rows)?.as_bytes())?;
        write(&folder.join("alias-free-zoom.png"), &png(&figures::zoom()?)?)?;
        write(&folder.join("alias-free-tree.png"), &png(&figures::tree()?)?)?;
    }
    Ok(())
}

/// Written beside its place and renamed, so that no half of it is ever seen.
fn write(path: &Path, content: &[u8]) -> Outcome<()> {
    let draft = path.with_extension("part");
    std::fs::write(&draft, content)?;
    Ok(std::fs::rename(draft, path)?)
}

fn png(picture: &RgbImage) -> Outcome<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png)?;
    Ok(bytes.into_inner())
}

/// What a call returns and the milliseconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let value = work();
    (value, start.elapsed().as_secs_f64() * 1e3)
}

/// The middle of several values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
