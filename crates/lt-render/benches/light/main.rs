//! Shadow queries in light space beside Intel Embree: prebuilt, and with everything rebuilt.
//!
//! `cargo xtask bench-light` compiles the Embree side and runs this; `cargo bench -p lt-render --bench light` measures us alone. The
//! rays, the peers and the clocks are those of the bench `rays`. What is asked of us is what is asked of a ray tracer: a list of ray
//! origins in 8×8 tiles in Morton order goes in, an answer for each comes out; turning rays into points is in the time.

#[path = "../rays/clock.rs"]
mod clock;
#[path = "../rays/embree.rs"]
mod embree;
#[path = "../rays/measure.rs"]
mod measure;
mod ours;
#[path = "../rays/places.rs"]
mod places;
#[path = "../rays/rays.rs"]
mod rays;

use clap::Parser;
use lt_bvh::{AnyHit, Opaque};
use lt_math::glam::UVec2;

use embree::Embree;
use measure::{Family, Way, measure};
use places::Place;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// Shadow queries in light space: ours, and Embree's rays (if LT_EMBREE_LIBRARY names its library)
#[derive(Clone, Debug, Parser)]
#[command(name = "light")]
struct Options {
    /// Scenes, separated by commas
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "street,square,forest,random:10000,random:100000,random:1000000"
    )]
    scenes: Vec<String>,
    /// Measured rounds, after one to warm up
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(1..=99))]
    repeats: u32,
    /// 640×360 and three rounds: minutes become seconds, and noise grows
    #[arg(long)]
    quick: bool,
    /// What `cargo bench` passes to every bench
    #[arg(long = "bench", hide = true)]
    _bench: bool,
}

fn main() -> Outcome<()> {
    let options = Options::parse();
    let embree = Embree::from_environment()?;
    let size = if options.quick { UVec2::new(640, 360) } else { UVec2::new(1920, 1080) };
    let repeats = if options.quick { options.repeats.min(3) } else { options.repeats };
    for name in &options.scenes {
        eprintln!("{name}: preparing");
        let place = Place::open(name, size)?;
        match place.has_holes() {
            true => scene(&place, place.coverage(), embree.as_ref(), repeats)?,
            false => scene(&place, Opaque, embree.as_ref(), repeats)?,
        }
    }
    Ok(())
}

fn scene<A: AnyHit + Sync>(place: &Place, any_hit: A, embree: Option<&Embree>, repeats: u32) -> Outcome<()> {
    let rays = &place.rays.rays;
    let light = ours::Prebuilt::new(place);
    let scene = embree.map(|e| e.scene(place, false)).transpose()?;
    let laid_out = scene.as_ref().map(|s| s.rays(rays));
    let mut ways: Vec<Box<dyn Way + '_>> = light.ways(rays, any_hit);
    ways.extend(laid_out.iter().flat_map(|r| r.ways()));
    let measured = measure(&place.name, &ways, rays.len(), repeats);
    println!("\n{} · {} triangles · {} rays", place.name, place.packed.triangles().len(), rays.len());
    let best = |family| {
        measured.columns.iter().filter(|c| c.family == family).map(|c| c.one.median).fold(0.0, f64::max)
    };
    for (column, answers) in measured.columns.iter().zip(&measured.answers) {
        let differ = answers.iter().zip(&measured.answers[0]).filter(|(a, b)| a != b).count();
        println!("  {:<30} {:>8.2} {:>8.2}  {differ}", column.name, column.one.median, column.two.median);
    }
    println!("  ours / Embree's best: {:.2}", best(Family::Ours) / best(Family::Embree));
    Ok(())
}
