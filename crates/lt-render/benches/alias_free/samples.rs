//! What several samples per pixel cost beside one.

use lt_math::glam::UVec2;
use lt_render::{BackendKind, Packing, SampleGrid, Session, Setup, Technique};
use lt_scene::Source;

use super::options::Options;
use super::{Outcome, median};

/// A picture that 32 samples per pixel make one of 4.1 million.
pub const SIZE: UVec2 = UVec2::new(480, 270);
/// Who answers. What rays and the light BVH walk is built before; the other two build all of theirs every time.
pub const TECHNIQUES: [&str; 4] = ["ray", "ray:light", "ray:dac", "alias-free"];
/// Samples per pixel.
pub const COUNTS: [u32; 6] = [1, 2, 4, 8, 16, 32];

/// One scene's times on all threads: milliseconds, medians, by samples per pixel and technique.
pub struct Row {
    pub name: String,
    pub ms: [[f64; TECHNIQUES.len()]; COUNTS.len()],
}

/// Measures a scene from its own camera.
pub fn measure(name: &str, options: &Options) -> Outcome<Row> {
    let scene = Source::open(name, 1)?.pose(0.0)?;
    let techniques: Vec<Technique> = TECHNIQUES.iter().map(|id| id.parse()).collect::<Result<_, _>>()?;
    let mut ms = [[0.0; TECHNIQUES.len()]; COUNTS.len()];
    for (count, row) in COUNTS.iter().zip(&mut ms) {
        let setup = Setup {
            samples: SampleGrid::of(*count)?,
            packing: Packing { bakes_copies: true, ..Packing::default() },
            ..Setup::for_scene(&scene, SIZE.x, SIZE.y)
        };
        let mut session = Session::new(&scene, setup, BackendKind::Cpu)?;
        let truth = session.render(&Technique::RAY)?.visibility;
        let mut times = vec![Vec::new(); techniques.len()];
        // The first round builds what is kept.
        for round in 0..=options.repeats {
            for (technique, times) in techniques.iter().zip(&mut times) {
                let frame = session.render(technique)?;
                if frame.visibility != truth {
                    return Err(format!("{name}: {technique} differs from rays at {count} samples").into());
                }
                if round > 0 {
                    times.push(frame.passes.iter().filter_map(|p| p.ms).sum());
                }
            }
        }
        for (at, times) in row.iter_mut().zip(times) {
            *at = median(times);
        }
    }
    Ok(Row { name: name.to_owned(), ms })
}
