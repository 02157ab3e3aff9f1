//! Occlusion rays on every built-in scene: our SIMD tracer and shared kernel beside obvhs's own traversals.
//!
//! One thread, the same rays (a 640×360 picture's light-facing pixels in tile order), the same alpha test, the whole
//! scene baked into one tree for all; five interleaved repeats, medians, Mrays/s. obvhs gets its slowest, best build,
//! triangles in leaf order and its own triangle test. Run: `cargo bench -p lt-render --bench rays [-- SCENE…]`.

use std::time::{Duration, Instant};

use lt_bvh::{AnyHit, Bvh, Opaque, Ray, Scalar, Simd, Tracer};
use lt_math::glam::Vec3A;
use lt_render::{BackendKind, PackedScene, Session, Setup, Trees};
use lt_scene::{Instance, Scene, Source};
use lt_shaders::abi::Material;
use lt_shaders::{evaluate::settle, resolve::shadow_ray, surface::Coverage};
use obvhs::{BvhBuildParams, bvh2::builder::build_bvh2_from_tris, cwbvh::builder::build_cwbvh_from_tris};

const SCENES: [&str; 10] = [
    "street",
    "square",
    "forest",
    "town",
    "fence",
    "cornell",
    "hairball",
    "random:10000",
    "random:100000",
    "random:1000000",
];
const REPEATS: usize = 5;

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    println!(
        "scene            triangles     rays |  ours simd  ours scalar  obvhs cwbvh   obvhs bvh2 | simd / best obvhs"
    );
    for name in SCENES.iter().map(|s| s.to_string()).chain(wanted.iter().cloned()) {
        if wanted.is_empty() || wanted.contains(&name) {
            bench(&name);
        }
    }
}

fn bench(name: &str) {
    let scene = baked(&Source::open(name, 1).and_then(|s| s.pose(0.0)).expect("a built-in scene"));
    let rays = shadow_rays(&scene);
    let packed = PackedScene::new(&scene).expect("packs");
    let Trees::Flat(ours) = packed.trees() else { panic!("baked scenes have one tree") };
    let coverage = Coverage {
        triangles: packed.triangles(),
        vertices: packed.vertices(),
        materials: packed.materials(),
        alpha_texels: packed.alpha_texels(),
        required_flags: Material::CASTS,
    };
    match packed.stats().masked_triangles {
        0 => row(name, ours, &rays, Opaque),
        _ => row(name, ours, &rays, coverage),
    }
}

fn row<A: AnyHit>(name: &str, ours: &Bvh, rays: &[Ray], any_hit: A) {
    let obvhs = Obvhs::new(ours);
    let (simd, scalar) = (Simd::new(ours), Scalar::new(ours));
    let mut answers = vec![vec![false; rays.len()]; 4];
    let mut times = vec![Vec::new(); 4];
    for round in 0..=REPEATS {
        for way in 0..4 {
            let start = Instant::now();
            let out = &mut answers[way];
            match way {
                0 => simd.occluded_batch(rays, any_hit, out),
                1 => scalar.occluded_batch(rays, any_hit, out),
                2 => rays.iter().zip(out).for_each(|(r, o)| *o = obvhs.cwbvh(r, any_hit)),
                _ => rays.iter().zip(out).for_each(|(r, o)| *o = obvhs.bvh2(r, any_hit)),
            }
            if round > 0 {
                times[way].push(start.elapsed());
            }
        }
    }
    assert_eq!(answers[0], answers[1], "{name}: SIMD and shared kernel differ");
    let differ = answers[0].iter().zip(&answers[2]).filter(|(a, b)| a != b).count();
    let rate: Vec<f64> =
        times.into_iter().map(|t| rays.len() as f64 / median(t).as_secs_f64() * 1e-6).collect();
    println!(
        "{name:<15} {:>10} {:>8} | {:>10.2} {:>12.2} {:>12.2} {:>12.2} | {:>6.2}   ({differ} answers differ from obvhs)",
        ours.triangles().len(),
        rays.len(),
        rate[0],
        rate[1],
        rate[2],
        rate[3],
        rate[0] / rate[2].max(rate[3])
    );
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

/// obvhs's trees over our triangles, in its own triangle type.
struct Obvhs {
    cwbvh: obvhs::cwbvh::CwBvh,
    cwbvh_triangles: Vec<(obvhs::rt_triangle::RtTriangle, u32, bool)>,
    bvh2: obvhs::bvh2::Bvh2,
    bvh2_triangles: Vec<(obvhs::rt_triangle::RtTriangle, u32, bool)>,
}

impl Obvhs {
    fn new(ours: &Bvh) -> Self {
        let corners = |v: lt_math::glam::Vec3| Vec3A::from(v);
        let triangles: Vec<obvhs::triangle::Triangle> = ours
            .triangles()
            .iter()
            .map(|t| obvhs::triangle::Triangle { v0: corners(t.v0), v1: corners(t.v1), v2: corners(t.v2) })
            .collect();
        let cwbvh =
            build_cwbvh_from_tris(&triangles, BvhBuildParams::very_slow_build(), &mut Duration::default());
        let bvh2 =
            build_bvh2_from_tris(&triangles, BvhBuildParams::very_slow_build(), &mut Duration::default());
        let in_order = |order: &[u32]| {
            order
                .iter()
                .map(|&i| {
                    let t = &triangles[i as usize];
                    let rt = obvhs::rt_triangle::RtTriangle::new(t.v0, t.v1, t.v2);
                    (rt, i, ours.triangles()[i as usize].is_opaque())
                })
                .collect()
        };
        let (cwbvh_triangles, bvh2_triangles) =
            (in_order(&cwbvh.primitive_indices), in_order(&bvh2.primitive_indices));
        Self { cwbvh, cwbvh_triangles, bvh2, bvh2_triangles }
    }

    fn cwbvh<A: AnyHit>(&self, ray: &Ray, any_hit: A) -> bool {
        !self.cwbvh.ray_traverse_miss(their_ray(ray), |r, i| hit(&self.cwbvh_triangles[i], r, any_hit))
    }

    fn bvh2<A: AnyHit>(&self, ray: &Ray, any_hit: A) -> bool {
        !self.bvh2.ray_traverse_miss(their_ray(ray), |r, i| hit(&self.bvh2_triangles[i], r, any_hit))
    }
}

fn their_ray(ray: &Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), ray.tmin, ray.tmax)
}

fn hit<A: AnyHit>(
    triangle: &(obvhs::rt_triangle::RtTriangle, u32, bool),
    ray: &obvhs::ray::Ray,
    any_hit: A,
) -> f32 {
    let (shape, index, is_opaque) = triangle;
    let t = shape.intersect(ray);
    if t < ray.tmax && !is_opaque {
        let weights = shape.compute_barycentric(ray);
        return if any_hit.accepts(*index, weights.x, weights.y) { t } else { f32::INFINITY };
    }
    t
}

/// The scene's light-facing pixels as shadow rays, in 8×8 tiles.
fn shadow_rays(scene: &Scene) -> Vec<Ray> {
    let (width, height) = (640, 360);
    let session =
        Session::new(scene, Setup::for_scene(scene, width, height), BackendKind::Cpu).expect("session");
    let light = session.job(&lt_render::Technique::RAY).shadow.light;
    let mut rays = Vec::new();
    for tile in 0..(width / 8) * (height / 8) {
        for i in 0..64 {
            let (x, y) = (tile % (width / 8) * 8 + i % 8, tile / (width / 8) * 8 + i / 8);
            let sample = &session.samples()[(y * width + x) as usize];
            if !settle(sample, light).1 {
                rays.push(shadow_ray(sample, light));
            }
        }
    }
    rays
}

/// Every instance turned into a mesh of its own, so that all tracers see one world-space tree.
fn baked(scene: &Scene) -> Scene {
    let mut out = Scene { meshes: Vec::new(), instances: Vec::new(), ..scene.clone() };
    for instance in &scene.instances {
        let mut mesh = scene.meshes[instance.mesh as usize].clone();
        mesh.positions.iter_mut().for_each(|p| *p = instance.transform.transform_point3(*p));
        mesh.normals.clear();
        out.instances.push(Instance {
            mesh: out.meshes.len() as u32,
            transform: Default::default(),
            ..*instance
        });
        out.meshes.push(mesh);
    }
    out
}
