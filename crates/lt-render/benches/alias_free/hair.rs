//! The hair ball whose strands let light through.

use lt_bvh::transmitted;
use lt_irregular::{Bounds, Casters, Counters, Options as MapOptions, SampleMap};
use lt_math::glam::{UVec2, Vec3};
use lt_render::{BackendKind, PackedScene, Packing, Session, Setup, Technique};
use lt_scene::Source;
use lt_shaders::surface::Translucence;
use rayon::prelude::*;

use super::options::Options;
use super::rays::RayList;
use super::{Outcome, median, timed};

/// The paper's picture.
const SIZE: UVec2 = UVec2::new(1536, 1088);
/// Largest difference between two orders of the same factors.
const TOLERANCE: f32 = 1e-5;

/// One ball's figures; times in milliseconds on all threads, medians.
pub struct Row {
    pub hairs: u32,
    pub triangles: usize,
    pub samples: usize,
    pub counters: Counters,
    pub build: f64,
    pub draw: f64,
    /// The shared kernel along every ray, its tree built before.
    pub rays: f64,
    /// Largest difference of a channel between the two.
    pub largest_difference: f32,
}

/// Measures a ball of this many hairs.
pub fn measure(hairs: u32, options: &Options) -> Outcome<Row> {
    let scene = Source::open(&format!("strands:{hairs}"), 1)?.pose(0.0)?;
    let session = Session::new(&scene, Setup::for_scene(&scene, SIZE.x, SIZE.y), BackendKind::Cpu)?;
    let light = session.job(&Technique::RAY).shadow.light;
    let rays = RayList::of_picture(session.samples(), SIZE, &light).rays;
    drop(session);
    let packed = PackedScene::with(&scene, Packing { traces_translucency: true, ..Packing::default() })?;
    let bvh = packed.translucent().ok_or("strands are translucent")?;
    let strands = Translucence {
        triangles: bvh.triangles(),
        vertices: packed.vertices(),
        materials: packed.materials(),
        alpha_texels: packed.alpha_texels(),
        color_texels: packed.color_texels(),
    };
    let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
    let origins: Vec<Vec3> = rays.iter().map(|r| r.origin).collect();
    let corners = bvh.triangles().iter().flat_map(|t| [t.v0, t.v1, t.v2]);
    let domain = corners.chain(origins.iter().copied()).fold(Bounds::EMPTY, Bounds::with);
    let (mut build, mut draw, mut along) = (Vec::new(), Vec::new(), Vec::new());
    let mut found = vec![Vec3::ZERO; origins.len()];
    let mut truth = Vec::new();
    let mut counters = Counters::default();
    for _ in 0..options.repeats {
        let (mut map, ms) =
            timed(|| SampleMap::build(light.place, domain, casters, &origins, MapOptions::default()));
        build.push(ms);
        let ms;
        (counters, ms) = timed(|| map.transmitted(casters, &origins, strands, &mut found));
        draw.push(ms);
        let one = |ray: &lt_bvh::Ray| transmitted(bvh.nodes(), bvh.triangles(), *ray, strands);
        let ms;
        (truth, ms) = timed(|| rays.par_iter().map(one).collect::<Vec<Vec3>>());
        along.push(ms);
    }
    let differences = found.iter().zip(&truth).map(|(a, b)| (*a - *b).abs().max_element());
    let largest_difference = differences.fold(0.0, f32::max);
    if largest_difference.is_nan() || largest_difference > TOLERANCE {
        return Err(format!("strands:{hairs}: transmittances differ by {largest_difference}").into());
    }
    Ok(Row {
        hairs,
        triangles: bvh.triangles().len(),
        samples: origins.len(),
        counters,
        build: median(build),
        draw: median(draw),
        rays: median(along),
        largest_difference,
    })
}
