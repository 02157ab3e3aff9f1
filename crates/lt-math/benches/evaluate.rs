//! Time per evaluation of every kind, on the gather path and on filtered vectors.
//!
//! `gather` is what a technique asks of four depths in hand; `gather_blended` turns them into vectors and blends those, the
//! way that a test without a gather form of its own goes.
//!
//! `cargo bench -p lt-math`; each figure is for one pass over 1024 footprints (Criterion also prints elements/s).

#[path = "../tests/root/support/random.rs"]
mod random;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use lt_math::glam::Vec4;
use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, ShadowTest, Sm, Vsm, blend};
use std::hint::black_box;

const COUNT: u64 = 1024;

struct Query {
    depths: Vec4,
    weights: Vec4,
    receiver_depth: f32,
}

fn queries() -> Vec<Query> {
    let mut random = random::Random::new(11);
    let mut query = |i| Query {
        depths: if i % 2 == 0 { random.two_layers() } else { random.four_depths() },
        weights: random.weights(),
        receiver_depth: random.unit(),
    };
    (0..COUNT).map(&mut query).collect()
}

fn bench_kind<T: ShadowTest>(criterion: &mut Criterion, name: &str, test: T) {
    let queries = queries();
    let b = |z| test.depth_vector(z);
    let filtered: Vec<Vec4> = queries
        .iter()
        .map(|q| blend(b(q.depths.x), b(q.depths.y), b(q.depths.z), b(q.depths.w), q.weights))
        .collect();
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(COUNT));
    group.bench_function("gather", |bencher| {
        bencher.iter(|| {
            for q in &queries {
                black_box(test.visibility_of_gather(q.depths, q.weights, q.receiver_depth));
            }
        });
    });
    group.bench_function("gather_blended", |bencher| {
        bencher.iter(|| {
            for q in &queries {
                let [b0, b1, b2, b3] = q.depths.to_array().map(b);
                black_box(test.visibility(blend(b0, b1, b2, b3, q.weights), q.receiver_depth));
            }
        });
    });
    group.bench_function("filtered", |bencher| {
        bencher.iter(|| {
            for (q, &b) in queries.iter().zip(&filtered) {
                black_box(test.visibility(b, q.receiver_depth));
            }
        });
    });
    group.finish();
}

fn bench(criterion: &mut Criterion) {
    bench_kind(criterion, "sm", Sm::default());
    bench_kind(criterion, "pcf", Pcf::default());
    bench_kind(criterion, "vsm", Vsm::default());
    bench_kind(criterion, "esm", Esm::default());
    bench_kind(criterion, "evsm", Evsm::default());
    bench_kind(criterion, "msm_hamburger", MsmHamburger::default());
    bench_kind(criterion, "msm_hausdorff", MsmHausdorff::default());
}

criterion_group!(benches, bench);
criterion_main!(benches);
