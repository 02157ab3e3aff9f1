//! Time from a mesh in memory to a tree that the first ray can enter.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use lt_bvh::{BuildQuality, Bvh, Simd};
use lt_math::glam::Vec3;

use super::Outcome;
use super::clock::process_time;
use super::embree::Embree;
use super::places::posed;

/// One builder's time.
#[derive(Clone, Debug)]
pub struct Build {
    pub name: &'static str,
    /// Wall time on two threads, median, ms.
    pub wall_ms: f64,
    /// Least and largest wall time, ms.
    pub range_ms: (f64, f64),
    /// CPU time of both threads together, median, ms.
    pub cpu_ms: f64,
}

/// All builders on one mesh.
#[derive(Clone, Debug)]
pub struct Builds {
    pub scene: String,
    pub triangles: usize,
    pub builds: Vec<Build>,
}

/// Builds the scene by every builder in turn, `repeats` times after one to warm up.
pub fn compare(name: &str, embree: Option<&Embree>, repeats: u32) -> Outcome<Builds> {
    let (positions, indices) = mesh(name)?;
    let vertices = &positions[..positions.len() - 1];
    let ours = |quality: BuildQuality| {
        let (positions, indices) = (vertices, &indices);
        move || -> Outcome<()> {
            let bvh = Bvh::build(positions, indices, |_| true, quality)?;
            // Makes the SIMD tree, which `Bvh::build` leaves for the first tracer.
            std::hint::black_box(Simd::new(&bvh));
            Ok(())
        }
    };
    // Refit to the mesh as it is: what moves a tree does not depend on how far.
    let tree = Mutex::new(Bvh::build(vertices, &indices, |_| true, BuildQuality::Medium)?);
    type Builder<'a> = Box<dyn Fn() -> Outcome<()> + Send + Sync + 'a>;
    let mut builders: Vec<(&'static str, Builder)> = vec![
        ("ours, medium", Box::new(ours(BuildQuality::Medium))),
        ("ours, fast", Box::new(ours(BuildQuality::Fast))),
    ];
    builders.push((
        "ours, refit",
        Box::new(|| {
            let mut tree = tree.lock().map_err(|e| e.to_string())?;
            // From the second time on there is a SIMD tree, which is refit too.
            tree.refit(vertices, &indices)?;
            std::hint::black_box(Simd::new(&tree));
            Ok(())
        }),
    ));
    if let Some(embree) = embree {
        builders.push(("Embree, default", Box::new(|| embree.build(&positions, &indices))));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let mut times = vec![Vec::new(); builders.len()];
    for round in 0..=repeats {
        eprint!("\rbuild {name}: round {round} of {repeats} ");
        for (i, (_, build)) in builders.iter().enumerate() {
            let (wall, cpu) = (Instant::now(), process_time());
            pool.install(|| build().map_err(|e| e.to_string()))?;
            if round > 0 {
                times[i].push((wall.elapsed(), process_time() - cpu));
            }
        }
    }
    eprintln!();
    let builds = builders.iter().zip(times).map(|((name, _), times)| {
        let sorted = |of: fn(&(Duration, Duration)) -> Duration| {
            let mut values: Vec<f64> = times.iter().map(|t| of(t).as_secs_f64() * 1e3).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let (wall, cpu) = (sorted(|t| t.0), sorted(|t| t.1));
        let middle = wall.len() / 2;
        Build { name, wall_ms: wall[middle], range_ms: (wall[0], wall[wall.len() - 1]), cpu_ms: cpu[middle] }
    });
    Ok(Builds { scene: name.to_owned(), triangles: indices.len(), builds: builds.collect() })
}

/// All meshes of a scene as one, with one position more than it uses.
fn mesh(name: &str) -> Outcome<(Vec<Vec3>, Vec<[u32; 3]>)> {
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for mesh in posed(name)?.meshes {
        let first = positions.len() as u32;
        positions.extend_from_slice(&mesh.positions);
        indices.extend(mesh.indices.chunks_exact(3).map(|t| [t[0] + first, t[1] + first, t[2] + first]));
    }
    positions.push(Vec3::ZERO);
    Ok((positions, indices))
}
