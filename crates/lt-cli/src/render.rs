//! `lt render`: one shaded picture, and on request the buffers behind it.

use std::{io::Write, path::Path};

use lt_math::glam::Vec3;
use lt_render::{Frame, Session, Technique, Upkeep};

use crate::{
    args::RenderArgs,
    exr_file::{self, as_floats},
    files,
    numbers::{grouped, ms},
    picture::Picture,
    progress::spinner,
    summary::View,
};

/// Runs the command.
///
/// # Errors
/// A bad request, a failed run, or a file that cannot be written.
pub fn run(args: &RenderArgs) -> anyhow::Result<()> {
    files::prepare_dir(files::folder_of(&args.out))?;
    if let Some(dir) = &args.dump {
        files::prepare_dir(dir)?;
    }
    let technique = args.technique.with(args.scene.technique_defaults());
    let mut opened = args.scene.open(&[technique], Upkeep::Kept)?;
    let session = &mut opened.session;
    let work = spinner(&format!("drawing with {technique}"));
    let frame = session.render(&technique)?;
    let size = session.setup().size.to_array();
    let picture = Picture::new(size, session.shade(&frame)?);
    files::write(&args.out, |to| picture.write_png(to))?;
    if let Some(dir) = &args.dump {
        dump(dir, session, &frame)?;
    }
    work.finish_and_clear();
    let total_ms: Option<f64> = frame.passes.iter().map(|p| p.ms).sum();
    writeln!(
        std::io::stdout(),
        "{}: {} by {technique}, {} rays, {} ms on {}",
        args.out.display(),
        opened.name,
        grouped(frame.rays),
        ms(total_ms),
        session.device_name()
    )?;
    Ok(())
}

/// Writes `frame.exr` and `camera.json`.
fn dump(dir: &Path, session: &mut Session, frame: &Frame) -> anyhow::Result<()> {
    let reference = session.render(&Technique::RAY)?;
    let samples = session.samples();
    let axis = |pick: fn(&lt_render::Sample) -> f32| samples.iter().map(pick).collect::<Vec<f32>>();
    let tint = |pick: fn(&Vec3) -> f32| frame.tint.iter().map(pick).collect::<Vec<f32>>();
    let mut channels = vec![
        ("position.X", axis(|s| s.position.x)),
        ("position.Y", axis(|s| s.position.y)),
        ("position.Z", axis(|s| s.position.z)),
        ("normal.X", axis(|s| s.normal.x)),
        ("normal.Y", axis(|s| s.normal.y)),
        ("normal.Z", axis(|s| s.normal.z)),
        ("visibility.Y", frame.visibility.clone()),
        ("reference.Y", reference.visibility),
        ("doubt.Y", as_floats(&frame.doubt)),
    ];
    let names: Vec<[String; 2]> = (0..frame.lights.len())
        .map(|i| [format!("light{i}.visibility"), format!("light{i}.reference")])
        .collect();
    for (names, (light, truth)) in names.iter().zip(frame.lights.iter().zip(&reference.lights)) {
        channels.push((&names[0], light.visibility.clone()));
        channels.push((&names[1], truth.visibility.clone()));
    }
    if !frame.tint.is_empty() {
        channels.extend([("tint.R", tint(|t| t.x)), ("tint.G", tint(|t| t.y)), ("tint.B", tint(|t| t.z))]);
    }
    let setup = session.setup();
    let size = setup.size_in_samples().to_array();
    files::write(&dir.join("frame.exr"), |to| exr_file::write(to, size, channels))?;
    files::write(&dir.join("camera.json"), |to| {
        serde_json::to_writer_pretty(&mut *to, &View::of(setup))?;
        Ok(to.write_all(b"\n")?)
    })
}
