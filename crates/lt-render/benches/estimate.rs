//! Map evaluation: nanoseconds per pixel of the batched evaluator beside the shared per-pixel function.
//!
//! `street` at 1920×1080, one 2048² map or the three of the default, samples in 32×32 tiles, Morton order inside. Before every pass 256 MB are read
//! and written, so that neither map nor samples are in a cache. One thread, by its own CPU time; interleaved repeats, medians.
//! Per pixel of the picture, settled ones included, and per pixel that faces the light. Run: `cargo bench -p lt-render --bench estimate`.

use std::hint::black_box;
use std::time::Duration;

use lt_math::glam::UVec2;
use lt_math::{Esm, Evsm, Levels, LightProjection, MsmHamburger, Vsm};
use lt_render::cpu::{
    BatchTest, CpuBackend, Pieces, SampleRows, evaluate_batch, evaluate_batch_levels, maps_to_rows,
};
use lt_render::{Backend, BackendKind, PackedScene, PassKind, Session, Setup};
use lt_scene::Source;
use lt_shaders::abi::{Sample, ShadowParams};
use lt_shaders::evaluate::{GatheredDepths, evaluate, evaluate_levels, settle};

const REPEATS: usize = 15;
const SIZE: UVec2 = UVec2::new(1920, 1080);
const MAP_SIZE: u32 = 2048;

fn main() {
    let scene = Source::open("street", 1).and_then(|s| s.pose(0.0)).expect("a built-in scene");
    let setup = Setup { map_size: MAP_SIZE, ..Setup::for_scene(&scene, SIZE.x, SIZE.y) };
    let session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    let samples = in_tiles(session.samples());
    let mut backend = CpuBackend::new(PackedScene::new(&scene).expect("packs"));
    println!("technique           pixels   facing |  batch ns/px  (facing)  shared ns/px  (facing) | ratio");
    for id in ["vsm", "ltt-vsm:cascades=1", "evsm", "ltt-evsm:cascades=1", "ltt-evsm", "ltt-esm", "ltt-msm"] {
        let job = session.job(&id.parse().expect("id"));
        backend.begin(&job).expect("begins");
        backend.pass(PassKind::DepthMap, &job).expect("draws");
        let levels = job.searched_levels();
        let (p, tiles) = (&job.shadow, backend.depth_maps());
        let rows = maps_to_rows(&tiles, p.map_size);
        let maps = Maps { p, levels: levels.as_deref(), tiles: &tiles, rows: &rows };
        match id {
            "vsm" => row::<Vsm, false>(id, &samples, maps),
            "evsm" => row::<Evsm, false>(id, &samples, maps),
            "ltt-esm" => row::<Esm, true>(id, &samples, maps),
            "ltt-msm" => row::<MsmHamburger, true>(id, &samples, maps),
            _ if id.contains("evsm") => row::<Evsm, true>(id, &samples, maps),
            _ => row::<Vsm, true>(id, &samples, maps),
        }
    }
}

/// What is looked up.
#[derive(Clone, Copy)]
struct Maps<'a> {
    p: &'a ShadowParams,
    /// Several maps, or one by `p`.
    levels: Option<&'a [LightProjection]>,
    /// Depths, as batches want them.
    tiles: &'a [f32],
    /// The same, as the shared function does.
    rows: &'a [f32],
}

fn row<T: BatchTest, const LTT: bool>(id: &str, samples: &[Sample], maps: Maps<'_>) {
    let Maps { p, levels, tiles, .. } = maps;
    let mut cache = vec![1u64; 32 << 20];
    let rows = SampleRows::of(samples);
    let pieces = rows.pieces();
    let new = || (vec![0.0f32; samples.len()], vec![0; pieces.len()]);
    let mut answers = [new(), new()];
    let mut times = [Vec::new(), Vec::new()];
    for round in 0..=REPEATS {
        for (way, (lit, doubted)) in answers.iter_mut().enumerate() {
            cache.iter_mut().for_each(|x| *x = x.wrapping_mul(3));
            black_box(&cache);
            let start = thread_time();
            match (way, levels) {
                (0, None) => evaluate_batch::<T, LTT>(pieces, p, tiles, lit, doubted),
                (0, Some(levels)) => {
                    evaluate_batch_levels::<T, LTT>(pieces, p, levels, tiles, lit, doubted);
                }
                _ => one_by_one::<T, LTT>(samples, maps, lit, doubted),
            }
            if round > 0 {
                times[way].push(thread_time() - start);
            }
        }
    }
    assert!(answers[0] == answers[1], "{id}: the batch differs from the shared function");
    let by_map = samples.iter().filter(|s| !settle(s, &p.light).1).count();
    let [batch, shared] = times.map(|mut t| {
        t.sort();
        t[t.len() / 2].as_secs_f64() * 1e9
    });
    let (all, mapped) = (samples.len() as f64, by_map as f64);
    println!(
        "{id:<20} {all:>8} {mapped:>8} | {:>12.2} {:>9.2} {:>13.2} {:>9.2} | {:>5.2}",
        batch / all,
        batch / mapped,
        shared / all,
        shared / mapped,
        shared / batch
    );
}

fn one_by_one<T: BatchTest, const LTT: bool>(
    samples: &[Sample],
    Maps { p, levels, rows, .. }: Maps<'_>,
    visibility: &mut [f32],
    doubted: &mut [u64],
) {
    let map = GatheredDepths { depths: rows };
    doubted.fill(0);
    for (i, (sample, visibility)) in samples.iter().zip(visibility).enumerate() {
        let verdict = match levels {
            None => evaluate::<T, _, LTT>(sample, p, map),
            Some(all) => {
                let levels = Levels { projections: all, count: all.len() as u32 };
                evaluate_levels::<T, _, _, LTT>(sample, p, map, levels)
            }
        };
        *visibility = verdict.visibility;
        let (piece, bit) = (i / Pieces::SAMPLES, i % Pieces::SAMPLES);
        doubted[piece] |= u64::from(verdict.is_doubted) << bit;
    }
}

/// Rows of pixels as 32×32 tiles, in Morton order inside.
fn in_tiles(rows: &[Sample]) -> Vec<Sample> {
    let even_bits = |i: u32| (0..5).map(|bit| (i >> (2 * bit) & 1) << bit).sum::<u32>();
    let mut tiled = Vec::with_capacity(rows.len());
    for tile_y in 0..SIZE.y.div_ceil(32) {
        for tile_x in 0..SIZE.x.div_ceil(32) {
            for i in 0..1024 {
                let (x, y) = (32 * tile_x + even_bits(i), 32 * tile_y + even_bits(i >> 1));
                if x < SIZE.x && y < SIZE.y {
                    tiled.push(rows[(y * SIZE.x + x) as usize]);
                }
            }
        }
    }
    tiled
}

/// CPU time of this thread, where the system tells it; the clock's elsewhere.
#[cfg(not(unix))]
fn thread_time() -> Duration {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    START.get_or_init(std::time::Instant::now).elapsed()
}

/// CPU time of this thread, where the system tells it; the clock's elsewhere.
#[cfg(unix)]
fn thread_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
