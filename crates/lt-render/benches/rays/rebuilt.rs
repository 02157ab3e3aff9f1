//! Everything built anew for a frame like the one before: Embree's fastest build and its best mode beside divide and conquer, which
//! builds nothing.
//!
//! Both have the same triangles, in the order of the scene's meshes: what puts them in the order of a tree's leaves has built that tree. Making them
//! of posed meshes is in neither time; both test textures alone, and looking for the box of all triangles is in ours.

use std::time::{Duration, Instant};

use lt_bvh::{AnyHit, Opaque};
use lt_irregular::{Bounds, Casters, DivideAndConquer, Workspace};
use lt_math::glam::Vec3;

use super::Outcome;
use super::clock::process_time;
use super::embree::{BUILD_THREADS, Embree, Quality};
use super::measure::measure;
use super::places::Place;

/// What a frame takes, milliseconds: of CPU time on one thread, else of wall time; medians.
#[derive(Clone, Debug)]
pub struct Rebuilt {
    pub scene: String,
    pub triangles: usize,
    pub threads: u32,
    pub embree_build: f64,
    pub embree_rays: f64,
    /// The mode that answers fastest.
    pub mode: String,
    pub ours: f64,
}

impl Rebuilt {
    /// Embree's time over ours.
    pub fn ratio(&self) -> f64 {
        (self.embree_build + self.embree_rays) / self.ours
    }
}

/// [`compare`], with the alpha test where the place has one.
///
/// # Errors
/// As there.
pub fn of_place(place: &Place, truth: &[bool], embree: &Embree, repeats: u32) -> Outcome<Vec<Rebuilt>> {
    match place.has_holes() {
        true => compare(place, place.plain_coverage(), truth, embree, repeats),
        false => compare(place, Opaque, truth, embree, repeats),
    }
}

/// One thread, then two.
///
/// # Errors
/// Embree refuses the scene, or the answers differ from those of `truth` in more than one ray of 10,000 (Embree's) or in any (ours).
fn compare<A: AnyHit + Sync>(
    place: &Place,
    any_hit: A,
    truth: &[bool],
    embree: &Embree,
    repeats: u32,
) -> Outcome<Vec<Rebuilt>> {
    let rays = &place.rays.rays;
    let origins: Vec<Vec3> = rays.iter().map(|ray| ray.origin).collect();
    let light = rays.first().map_or(Vec3::Y, |ray| ray.direction).extend(0.0);
    let bounds = place.packed.bounds();
    let domain = origins.iter().fold(Bounds { low: bounds.min, high: bounds.max }, |b, o| b.with(*o));
    let triangles = &place.in_mesh_order[..];
    let both = DivideAndConquer::new(light, domain);
    let mut rows = Vec::new();
    for threads in [1, BUILD_THREADS] {
        embree.use_threads(threads)?;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads as usize).build()?;
        let (mut builds, mut ours) = (Vec::new(), Vec::new());
        // A frame before has warmed the memory, as Embree's pools are.
        let mut workspace = Workspace::default();
        for round in 0..=repeats {
            let scene = embree.scene(place, triangles, false, Quality::Fast)?;
            builds.push(if threads == 1 { scene.build_cpu_ms() } else { scene.build_ms() });
            drop(scene);
            let mut out = vec![false; rays.len()];
            let start = Started::now();
            pool.install(|| {
                both.occluded(Casters::of(triangles), &origins, any_hit, &mut out, &mut workspace);
            });
            if round > 0 {
                ours.push(start.elapsed(threads).as_secs_f64() * 1e3);
            }
            if out != truth {
                return Err(
                    format!("{}: divide and conquer answers otherwise than the rays", place.name).into()
                );
            }
        }
        let scene = embree.scene(place, triangles, false, Quality::Fast)?;
        let laid_out = scene.rays(rays);
        let measured = measure(&format!("{}, rebuilt", place.name), &laid_out.ways(), rays.len(), repeats);
        for answers in &measured.answers {
            let differ = answers.iter().zip(truth).filter(|(a, b)| a != b).count();
            if differ * 10_000 > rays.len() {
                return Err(
                    format!("{}: Embree's fast tree answers {differ} rays otherwise", place.name).into()
                );
            }
        }
        let rate = |c: &super::measure::Column| if threads == 1 { c.one.median } else { c.two.median };
        let best = measured.columns.iter().max_by(|a, b| rate(a).total_cmp(&rate(b)));
        let Some(best) = best else { continue };
        rows.push(Rebuilt {
            scene: place.name.clone(),
            triangles: triangles.len(),
            threads,
            embree_build: median(builds),
            embree_rays: rays.len() as f64 / rate(best) * 1e-3,
            mode: best.name.clone(),
            ours: median(ours),
        });
    }
    embree.use_threads(BUILD_THREADS)?;
    Ok(rows)
}

/// When something began, on the clock on the wall and on that of the process.
struct Started {
    wall: Instant,
    cpu: Duration,
}

impl Started {
    fn now() -> Self {
        Started { wall: Instant::now(), cpu: process_time() }
    }

    /// CPU time where one thread works, which other programs add little to.
    fn elapsed(&self, threads: u32) -> Duration {
        if threads == 1 { process_time() - self.cpu } else { self.wall.elapsed() }
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
