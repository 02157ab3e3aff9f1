//! Occlusion rays toward a sun: obvhs's own traversals against ours, interleaved, on every kind of scene.
//!
//! `cargo bench -p lt-bvh` prints a table first (Mrays/s of one thread, medians), then runs Criterion.

#[path = "../tests/support/mod.rs"]
mod support;

use criterion::{Criterion, Throughput};
use lt_bvh::{AnyHit, BuildQuality, Bvh, Opaque, Ray, Scalar, Simd, SimdLevel, Tracer, Triangle};
use lt_math::glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::rt_triangle::RtTriangle;
use std::hint::black_box;
use std::time::{Duration, Instant};
use support::{Leaf, Mesh, city, foliage, leaf_texels, soup, sun_rays};

/// Asks the callback with barycentrics, for obvhs's any-hit on alpha-tested scenes.
trait Judge: Copy {
    fn blocks(&self, triangle: usize, ray: &obvhs::ray::Ray, hit: &RtTriangle) -> bool;
}

#[derive(Clone, Copy)]
struct Everything;

impl Judge for Everything {
    fn blocks(&self, _: usize, _: &obvhs::ray::Ray, _: &RtTriangle) -> bool {
        true
    }
}

#[derive(Clone, Copy)]
struct Alpha<'a> {
    leaf: Leaf<'a>,
}

impl Judge for Alpha<'_> {
    fn blocks(&self, triangle: usize, ray: &obvhs::ray::Ray, hit: &RtTriangle) -> bool {
        let weights = hit.compute_barycentric(ray);
        self.leaf.triangles[triangle].is_opaque() || self.leaf.accepts(triangle as u32, weights.x, weights.y)
    }
}

/// obvhs with its triangles in leaf order, as its documentation advises.
struct Peer {
    cwbvh: CwBvh,
    cwbvh_triangles: Vec<RtTriangle>,
    cwbvh_ours: Vec<Triangle>,
    bvh2: Bvh2,
    bvh2_triangles: Vec<RtTriangle>,
    bvh2_ours: Vec<Triangle>,
}

fn peer(ours: &[Triangle]) -> Peer {
    let convert = |t: &Triangle| obvhs::triangle::Triangle {
        v0: Vec3A::from(t.v0),
        v1: Vec3A::from(t.v1),
        v2: Vec3A::from(t.v2),
    };
    let triangles: Vec<_> = ours.iter().map(convert).collect();
    let best = BvhBuildParams::very_slow_build();
    let cwbvh = build_cwbvh_from_tris(&triangles, best, &mut Duration::default());
    let bvh2 = build_bvh2_from_tris(&triangles, best, &mut Duration::default());
    let rt = |order: &[u32]| order.iter().map(|&i| RtTriangle::from(&triangles[i as usize])).collect();
    let kernel = |order: &[u32]| order.iter().map(|&i| ours[i as usize]).collect();
    Peer {
        cwbvh_triangles: rt(&cwbvh.primitive_indices),
        cwbvh_ours: kernel(&cwbvh.primitive_indices),
        cwbvh,
        bvh2_triangles: rt(&bvh2.primitive_indices),
        bvh2_ours: kernel(&bvh2.primitive_indices),
        bvh2,
    }
}

fn their_ray(ray: &Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), ray.tmin, ray.tmax)
}

fn judged<J: Judge>(judge: J, triangles: &[RtTriangle], ray: &obvhs::ray::Ray, index: usize) -> f32 {
    let t = triangles[index].intersect(ray);
    if t < ray.tmax && !judge.blocks(index, ray, &triangles[index]) { f32::INFINITY } else { t }
}

fn by_cwbvh<J: Judge>(peer: &Peer, judge: J, rays: &[Ray], out: &mut [bool]) {
    for (ray, out) in rays.iter().zip(out) {
        *out = !peer
            .cwbvh
            .ray_traverse_miss(their_ray(ray), |ray, i| judged(judge, &peer.cwbvh_triangles, ray, i));
    }
}

fn by_bvh2<J: Judge>(peer: &Peer, judge: J, rays: &[Ray], out: &mut [bool]) {
    for (ray, out) in rays.iter().zip(out) {
        *out = !peer
            .bvh2
            .ray_traverse_miss(their_ray(ray), |ray, i| judged(judge, &peer.bvh2_triangles, ray, i));
    }
}

/// A tracer under test: rays in, blocked or not out.
type Run<'a> = Box<dyn Fn(&[Ray], &mut [bool]) + 'a>;

struct Case {
    name: &'static str,
    mesh: Mesh,
    bvh: Bvh,
    rays: Vec<Ray>,
    peer: Peer,
    texels: Vec<u8>,
}

fn case(name: &'static str, mesh: Mesh) -> Case {
    let bvh = mesh.build(BuildQuality::Slow);
    let rays = sun_rays(&bvh, 512);
    let peer = peer(bvh.triangles());
    Case { name, mesh, bvh, rays, peer, texels: leaf_texels() }
}

impl Case {
    fn runs(&self) -> Vec<(String, Run<'_>)> {
        let has_alpha = self.mesh.is_opaque.iter().any(|opaque| !opaque);
        let leaf = |triangles| Leaf { triangles, uvs: &self.mesh.uvs, texels: &self.texels };
        let mut runs: Vec<(String, Run)> = Vec::new();
        let peer = &self.peer;
        if has_alpha {
            let (c, b) = (Alpha { leaf: leaf(&peer.cwbvh_ours) }, Alpha { leaf: leaf(&peer.bvh2_ours) });
            runs.push(("obvhs cwbvh".into(), Box::new(move |r, o| by_cwbvh(peer, c, r, o))));
            runs.push(("obvhs bvh2".into(), Box::new(move |r, o| by_bvh2(peer, b, r, o))));
        } else {
            runs.push(("obvhs cwbvh".into(), Box::new(move |r, o| by_cwbvh(peer, Everything, r, o))));
            runs.push(("obvhs bvh2".into(), Box::new(move |r, o| by_bvh2(peer, Everything, r, o))));
        }
        let ours = leaf(self.bvh.triangles());
        let scalar = Scalar::new(&self.bvh);
        runs.push((
            "scalar".into(),
            if has_alpha {
                Box::new(move |r, o| scalar.occluded_batch(r, ours, o))
            } else {
                Box::new(move |r, o| scalar.occluded_batch(r, Opaque, o))
            },
        ));
        for level in SimdLevel::available() {
            let Some(simd) = Simd::new(&self.bvh).with_level(level) else { continue };
            runs.push((
                format!("{level:?}"),
                if has_alpha {
                    Box::new(move |r, o| simd.occluded_batch(r, ours, o))
                } else {
                    Box::new(move |r, o| simd.occluded_batch(r, Opaque, o))
                },
            ));
        }
        runs
    }
}

/// Time that this thread has run, where the system tells (a busy machine then matters less), or time passed.
fn thread_time(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|line| line.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

fn table(cases: &[Case]) {
    let start = Instant::now();
    const REPEATS: usize = 5;
    for case in cases {
        let runs = case.runs();
        let mut times = vec![Vec::new(); runs.len()];
        let mut blocked = vec![0; runs.len()];
        let mut out = vec![false; case.rays.len()];
        for _ in 0..=REPEATS {
            for (i, (_, run)) in runs.iter().enumerate() {
                let before = thread_time(start);
                run(black_box(&case.rays), &mut out);
                times[i].push(thread_time(start) - before);
                blocked[i] = out.iter().filter(|b| **b).count();
            }
        }
        println!("{}: {} triangles, {} rays", case.name, case.bvh.triangles().len(), case.rays.len());
        for (i, (name, _)) in runs.iter().enumerate() {
            times[i].sort_by(f64::total_cmp);
            let rate = case.rays.len() as f64 / times[i][REPEATS / 2] / 1e6;
            println!("  {name:12} {rate:7.2} Mrays/s, {} blocked", blocked[i]);
        }
    }
}

fn main() {
    let cases = [
        case("random 10k", soup(10_000, 1)),
        case("random 100k", soup(100_000, 2)),
        case("city", city(8_000, 3)),
        case("foliage, alpha", foliage(60_000, 4)),
    ];
    table(&cases);
    let mut criterion = Criterion::default().configure_from_args();
    for case in &cases {
        let mut group = criterion.benchmark_group(case.name);
        group.sample_size(10).throughput(Throughput::Elements(case.rays.len() as u64));
        let mut out = vec![false; case.rays.len()];
        for (name, run) in case.runs() {
            group.bench_function(name, |b| b.iter(|| run(black_box(&case.rays), &mut out)));
        }
        group.finish();
    }
    criterion.final_summary();
}
