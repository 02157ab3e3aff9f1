//! What 16-bit depth maps cost: the doubt, the answers and the rays of leak tracing from depths rounded as D16 and R16F textures round them.
//!
//! `cargo test -p lt-tests --test root map_formats -- --nocapture` prints the table of docs/results/leak-tracing.md.

use half::f16;
use lt_math::glam::Vec4;
use lt_math::{Evsm, MsmHamburger, Vsm};
use lt_render::cpu::{BatchTest, CpuBackend, Pieces, SampleRows, evaluate_batch_levels};
use lt_render::{Backend, PackedScene, PassKind, Technique};
use lt_tests::{builtin, cpu_session, ppm};

/// How a texture keeps a depth in [0, 1].
#[derive(Clone, Copy, Debug)]
enum Format {
    F32,
    Unorm16,
    F16,
}

impl Format {
    fn stored(self, depth: f32) -> f32 {
        match self {
            Self::F32 => depth,
            Self::Unorm16 => (depth * 65535.0).round() / 65535.0,
            Self::F16 => f16::from_f32(depth).to_f32(),
        }
    }
}

/// The largest rounding error of a depth in [0, 1] that a half float keeps.
const F16_ERROR: f32 = 0.5 / 2048.0;

/// What is wrong although it was not doubted, and what is doubted, ppm of all samples.
#[derive(Clone, Copy, Debug)]
struct Outcome {
    false_lit: f64,
    false_shadowed: f64,
    doubted: f64,
}

/// The least variance in proportion to what depths are rounded by, as the user of such a map would set it.
fn widened(params: Vec4, id: &str, error: f32) -> Vec4 {
    match id {
        "ltt-vsm" => params.with_x(params.x.max(error * error)),
        "ltt-evsm" => params.with_z(params.z.max(error * error)),
        _ => params,
    }
}

fn outcome(scene: &str, id: &str, format: Format, is_widened: bool) -> Outcome {
    let scene = builtin(scene);
    let mut session = cpu_session(&scene, 320, 200);
    let truth = session.render(&Technique::RAY).expect("frame").visibility;
    let mut job = session.job(&format!("{id}:cascades=3:far=map").parse().expect("id"));
    let mut backend = CpuBackend::new(PackedScene::new(&scene).expect("packs"));
    backend.begin(&job).expect("begins");
    backend.pass(PassKind::DepthMap, &job).expect("draws");
    if is_widened {
        job.shadow.test = widened(job.shadow.test, id, F16_ERROR);
    }
    let depths: Vec<f32> = backend.depth_maps().iter().map(|&d| format.stored(d)).collect();
    let rows = SampleRows::of(session.samples());
    let pieces = rows.pieces();
    let projections = job.searched_levels().expect("cascades");
    let (mut lit, mut doubted) = (vec![0.0; Pieces::SAMPLES * pieces.len()], vec![0; pieces.len()]);
    let evaluate = |lit: &mut [f32], doubted: &mut [u64]| match id {
        "ltt-vsm" => batch::<Vsm>(pieces, &job.shadow, &projections, &depths, lit, doubted),
        "ltt-evsm" => batch::<Evsm>(pieces, &job.shadow, &projections, &depths, lit, doubted),
        _ => batch::<MsmHamburger>(pieces, &job.shadow, &projections, &depths, lit, doubted),
    };
    evaluate(&mut lit, &mut doubted);
    let is_doubted = |i: usize| doubted[i / Pieces::SAMPLES] >> (i % Pieces::SAMPLES) & 1 != 0;
    let share = |is_meant: &dyn Fn(usize) -> bool| {
        ppm((0..truth.len()).filter(|&i| is_meant(i)).count(), truth.len())
    };
    Outcome {
        false_lit: share(&|i| !is_doubted(i) && lit[i] > 0.5 && truth[i] < 0.5),
        false_shadowed: share(&|i| !is_doubted(i) && lit[i] < 0.5 && truth[i] > 0.5),
        doubted: share(&is_doubted),
    }
}

fn batch<T: BatchTest>(
    pieces: Pieces<'_>,
    p: &lt_shaders::abi::ShadowParams,
    projections: &[lt_math::LightProjection],
    depths: &[f32],
    lit: &mut [f32],
    doubted: &mut [u64],
) {
    evaluate_batch_levels::<T, true>(pieces, p, projections, depths, lit, doubted);
}

#[test]
fn sixteen_bits_of_depth_cost_rays_and_no_more_errors_once_the_least_variance_knows_them() {
    println!("| scene | test | depths | least variance | false-lit ppm | false-shadowed ppm | doubted |");
    for scene in ["street:4", "square:6", "cornell"] {
        for id in ["ltt-vsm", "ltt-evsm", "ltt-msm"] {
            let row = |format: Format, is_widened: bool| {
                let o = outcome(scene, id, format, is_widened);
                let name = if is_widened { "widened" } else { "default" };
                println!(
                    "| {scene} | {id} | {format:?} | {name} | {:.0} | {:.0} | {:.4} |",
                    o.false_lit,
                    o.false_shadowed,
                    o.doubted * 1e-6
                );
                o
            };
            let exact = row(Format::F32, false);
            let unorm = row(Format::Unorm16, false);
            // One pixel, and a quarter of the errors: thin things that a rounded depth happens to reveal or to hide.
            let is_near = |rounded: f64, exact: f64| rounded <= exact * 1.25 + 16.0;
            let is_as_right = |o: Outcome| {
                is_near(o.false_lit, exact.false_lit) && is_near(o.false_shadowed, exact.false_shadowed)
            };
            assert!(is_as_right(unorm), "{scene} {id}: {unorm:?}, {exact:?}");
            let float = row(Format::F16, false);
            if id == "ltt-msm" {
                assert!(is_as_right(float), "{scene} {id}: {float:?}, {exact:?}");
                continue;
            }
            assert!(
                float.false_shadowed > 5_000.0,
                "{scene} {id}: half floats need a wider variance, {float:?}"
            );
            let widened = row(Format::F16, true);
            assert!(is_as_right(widened) && widened.doubted > unorm.doubted, "{scene} {id}: {widened:?}");
        }
    }
}
