//! Occlusion rays and builds beside the peers': our tracer, Intel Embree and obvhs on the same rays and triangles.
//!
//! `cargo xtask bench-rays` compiles the Embree side and runs this; `cargo bench -p lt-render --bench rays` alone
//! measures us and obvhs. All tracers run in one process, interleaved repeat by repeat, on the same list of rays in
//! batches of [`measure::BATCH`]: one thread by its own CPU time, two threads by wall time, medians. Embree's rays are
//! laid out for it beforehand and its answers read back afterwards, both outside the measured time. Answers are
//! compared ray by ray; differences are judged in f64 ([`judge`]).
//!
//! To add a column: one more entry in [`ours::ways`].

mod builds;
mod clock;
mod crossover;
mod embree;
mod judge;
mod light;
mod measure;
mod obvhs_peer;
mod options;
mod ours;
mod places;
mod plot;
mod rays;
mod rebuilt;
mod report;
mod residual;
mod today;

use std::fs;
use std::path::Path;

use lt_bvh::AnyHit;
use lt_bvh::Opaque;

use embree::{Embree, Quality};
use measure::{Way, measure};
use options::Options;
use places::Place;
use rebuilt::Rebuilt;
use report::{List, Report, Row};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Outcome<()> {
    let options = Options::from_command_line();
    let embree = Embree::from_environment()?;
    let mut report = Report::new(&options, embree.as_ref());
    println!("{}", report.preamble());
    for name in &options.scenes {
        eprintln!("{name}: preparing");
        let place = Place::open(name, options.size())?;
        report.on_machine(&place.device);
        let (rows, rebuilt) = match place.has_holes() {
            true => scene(&place, place.coverage(), embree.as_ref(), &options)?,
            false => scene(&place, Opaque, embree.as_ref(), &options)?,
        };
        for row in rows {
            println!("{}", report.text_row(&row));
            report.rows.push(row);
        }
        report.rebuilt.extend(rebuilt);
    }
    if let Some(name) = options.build() {
        eprintln!("build {name}: preparing");
        report.build = Some(builds::compare(name, embree.as_ref(), options.repeats)?);
    }
    println!("{}", report.text_after());
    if let Some(folder) = &options.out {
        write(folder, &report)?;
    }
    if report.has_unexplained() {
        return Err("some answers differ by more than rounding".into());
    }
    Ok(())
}

/// Measures every way on both lists of a scene.
fn scene<A: AnyHit + Sync>(
    place: &Place,
    any_hit: A,
    embree: Option<&Embree>,
    options: &Options,
) -> Outcome<(Vec<Row>, Vec<Rebuilt>)> {
    let bvh = place.bvh();
    let counts = ours::mean_counts(bvh, &place.rays.rays, any_hit);
    eprintln!("{}: building the peers' trees", place.name);
    let peer = obvhs_peer::Obvhs::new(bvh);
    let their_scene = embree
        .map(|e| e.scene(place, place.packed.triangles(), options.robust, Quality::Default))
        .transpose()?;
    let light = light::Tree::new(place)?;
    let mut rows = Vec::new();
    let mut residual = Vec::new();
    let mut rebuilt = Vec::new();
    for list in [List::Primary, List::Residual] {
        let rays = match list {
            List::Primary => place.rays.clone(),
            List::Residual => place.rays.subset(&residual),
        };
        if rays.rays.is_empty() {
            continue;
        }
        let laid_out = their_scene.as_ref().map(|s| s.rays(&rays.rays));
        let mut ways: Vec<Box<dyn Way + '_>> = ours::ways(place, &rays.rays, any_hit, list);
        ways.push(light.way(&rays.rays, any_hit));
        ways.extend(laid_out.iter().flat_map(|rays| rays.ways()));
        ways.extend(peer.ways(&rays.rays, any_hit));
        let label = format!("{}, {} rays, {list}", place.name, rays.rays.len());
        let mut measured = measure(&label, &ways, rays.rays.len(), options.repeats);
        ours::check_against_kernel(bvh, &rays.rays, any_hit, &measured.answers[0])?;
        let damaged = if options.self_test { damage(&mut measured) } else { 0 };
        let differences = judge::judge(place, &rays.rays, &measured)?;
        if options.self_test && differences.theirs_wrong * 10 < damaged.min(differences.judged) * 9 {
            return Err(
                format!("{label}: too few of {damaged} damaged answers were found: {differences:?}").into()
            );
        }
        if list == List::Primary {
            residual = residual::nearest_to_edges(&rays, &measured.answers[0]);
            if let Some(embree) = embree {
                rebuilt = rebuilt::of_place(place, &measured.answers[0], embree, options.repeats)?;
            }
        }
        rows.push(Row::new(place, list, rays.rays.len(), counts, &measured, differences));
    }
    Ok((rows, rebuilt))
}

/// Turns over one answer in a thousand of the last way; how many.
fn damage(measured: &mut measure::Measured) -> usize {
    let answers = measured.answers.last_mut().into_iter().flatten().step_by(1000);
    answers.map(|answer| *answer = !*answer).count()
}

fn write(folder: &Path, report: &Report) -> Outcome<()> {
    fs::create_dir_all(folder)?;
    fs::write(folder.join("rays.csv"), report.csv())?;
    fs::write(folder.join("rays.md"), report.markdown())?;
    fs::write(folder.join("rays.svg"), plot::svg(&report.rows)?)?;
    fs::write(folder.join("crossover.svg"), crossover::svg(&report.rows, &report.rebuilt)?)?;
    println!("\nwritten: rays.csv, rays.md, rays.svg, crossover.svg in {}", folder.display());
    Ok(())
}
