//! Building and asking each structure, beside the ray tracer, on one thread: `cargo bench -p lt-irregular`.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use lt_bvh::{BuildQuality, Bvh, Opaque, Ray, Simd, Tracer};
use lt_irregular::{
    Bounds, Casters, DivideAndConquer, LightBvh, Options, SampleMap, Scratch, Walk, Workspace,
};
use lt_math::glam::{Vec3, Vec4};

/// Towards the sun.
const SUN: Vec4 = Vec4::new(0.2, 0.3, 1.0, 0.0);
/// Rays along each side of a plane below the triangles.
const SIDE: usize = 384;
/// Triangles; their total area is the same.
const SIZES: [u32; 3] = [1_000, 30_000, 300_000];

/// Triangles all over a cube of half side 1.
fn scattered(count: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let number = |i: u32, n: u32| (i.wrapping_mul(n) >> 8) as f32 / 8_388_608.0 - 1.0;
    let vector = |i: u32| Vec3::new(number(i, 0x9e37_79b1), number(i, 0x85eb_ca77), number(i, 0xc2b2_ae3d));
    let size = 4.0 / (count as f32).sqrt();
    let corners = |i: u32| {
        let at = vector(3 * i + 1);
        [at, at + vector(3 * i + 2) * size, at + vector(3 * i + 3) * size]
    };
    ((0..count).flat_map(corners).collect(), (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
}

/// In tiles of 8 × 8, as pictures are.
fn origins() -> Vec<Vec3> {
    let place = |i: usize| {
        let (tile, within) = (i / 64, i % 64);
        let (x, y) = (tile % (SIDE / 8) * 8 + within % 8, tile / (SIDE / 8) * 8 + within / 8);
        let at = |c: usize| (c as f32 + 0.37) / SIDE as f32 * 2.0 - 1.0;
        Vec3::new(at(x), at(y), -1.5)
    };
    (0..SIDE * SIDE).map(place).collect()
}

fn structures(c: &mut Criterion) {
    // Some structures share work among threads, rays and the light BVH leave that to their callers.
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first to start threads");
    let origins = origins();
    let rays: Vec<Ray> = origins.iter().map(|&o| Ray::to_light(o, SUN)).collect();
    let mut out = vec![false; origins.len()];
    for count in SIZES {
        let (positions, indices) = scattered(count);
        let bvh = Bvh::build(&positions, &indices, |_| true, BuildQuality::Medium).expect("builds");
        let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
        let domain = positions.iter().chain(&origins).fold(Bounds::EMPTY, |b, p| b.with(*p));
        let mut build = c.benchmark_group("build");
        build.sample_size(10);
        build.bench_function(BenchmarkId::new("light BVH", count), |b| {
            b.iter(|| black_box(LightBvh::build(SUN, domain, casters)));
        });
        let map = || SampleMap::build(SUN, domain, casters, &origins, Options::default());
        build.bench_function(BenchmarkId::new("sample map", count), |b| b.iter(|| black_box(map())));
        build.finish();
        let mut query = c.benchmark_group("query");
        query.sample_size(10).throughput(Throughput::Elements(origins.len() as u64));
        let simd = Simd::new(&bvh);
        query.bench_function(BenchmarkId::new("rays", count), |b| {
            b.iter(|| simd.occluded_batch(&rays, Opaque, &mut out));
        });
        let tree = LightBvh::build(SUN, domain, casters);
        let mut scratch = Scratch::default();
        for walk in Walk::ALL {
            query.bench_function(BenchmarkId::new(format!("light BVH, {walk:?}"), count), |b| {
                b.iter(|| tree.occluded_by(walk, casters, &origins, Opaque, &mut out, &mut scratch));
            });
        }
        let mut built = map();
        query.bench_function(BenchmarkId::new("sample map", count), |b| {
            b.iter(|| black_box(built.occluded(casters, &origins, Opaque, &mut out)));
        });
        let both = DivideAndConquer::new(SUN, domain);
        let mut workspace = Workspace::default();
        query.bench_function(BenchmarkId::new("divide and conquer", count), |b| {
            b.iter(|| both.occluded(casters, &origins, Opaque, &mut out, &mut workspace));
        });
        query.finish();
    }
}

criterion_group!(benches, structures);
criterion_main!(benches);
