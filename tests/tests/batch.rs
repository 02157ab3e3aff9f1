//! Map evaluation in batches gives the verdicts of the shared function, on every built-in scene.

use lt_math::{Esm, Evsm, Levels, MsmHamburger, MsmHausdorff, Pcf, Sm, Vsm};
use lt_render::cpu::{
    BatchTest, CpuBackend, Pieces, SampleRows, evaluate_batch, evaluate_batch_levels, maps_to_rows,
};
use lt_render::{Backend, PackedScene, PassKind, Sample};
use lt_shaders::abi::ShadowParams;
use lt_shaders::evaluate::{GatheredDepths, evaluate, evaluate_levels};
use lt_tests::{builtin, cpu_session};

const SCENES: [&str; 8] =
    ["street", "square:6", "forest:12", "town:40", "fence", "cornell", "hairball", "random:10000"];

#[test]
fn batches_have_the_bits_of_the_shared_function_on_every_built_in_scene() {
    for name in SCENES {
        let scene = builtin(name);
        let session = cpu_session(&scene, 333, 217);
        let mut backend = CpuBackend::new(PackedScene::new(&scene).expect("packs"));
        for id in
            ["vsm", "ltt-vsm", "evsm", "ltt-evsm", "ltt-esm", "ltt-msm", "ltt-msm-hausdorff", "sm", "pcf"]
        {
            let job = session.job(&format!("{id}:cascades=1").parse().expect("id"));
            backend.begin(&job).expect("begins");
            backend.pass(PassKind::DepthMap, &job).expect("draws");
            let (samples, p, depths) = (session.samples(), &job.shadow, backend.depth_maps());
            let different = match id {
                "vsm" => differences::<Vsm, false>(samples, p, &depths),
                "ltt-vsm" => differences::<Vsm, true>(samples, p, &depths),
                "evsm" => differences::<Evsm, false>(samples, p, &depths),
                "ltt-evsm" => differences::<Evsm, true>(samples, p, &depths),
                "ltt-esm" => differences::<Esm, true>(samples, p, &depths),
                "ltt-msm" => differences::<MsmHamburger, true>(samples, p, &depths),
                "ltt-msm-hausdorff" => differences::<MsmHausdorff, true>(samples, p, &depths),
                "sm" => differences::<Sm, false>(samples, p, &depths),
                _ => differences::<Pcf, false>(samples, p, &depths),
            };
            assert_eq!(different, 0, "{name} {id}");
        }
        let job = session.job(&"ltt-evsm".parse().expect("id"));
        let projections = job.searched_levels().expect("cascades");
        backend.begin(&job).expect("begins");
        backend.pass(PassKind::DepthMap, &job).expect("draws");
        let (samples, p, depths) = (session.samples(), &job.shadow, backend.depth_maps());
        let (rows, mut lit, mut doubted) = pieces_of(samples);
        evaluate_batch_levels::<Evsm, true>(rows.pieces(), p, &projections, &depths, &mut lit, &mut doubted);
        let depths = &maps_to_rows(&depths, p.map_size)[..];
        let levels = Levels { projections: &projections, count: projections.len() as u32 };
        for (i, sample) in samples.iter().enumerate() {
            let v = evaluate_levels::<Evsm, _, _, true>(sample, p, GatheredDepths { depths }, levels);
            let answer = (lit[i].to_bits(), is_doubted(&doubted, i));
            assert_eq!((v.visibility.to_bits(), v.is_doubted), answer, "{name} {i}");
        }
    }
}

/// Samples in pieces, and room for their visibilities and doubts.
fn pieces_of(samples: &[Sample]) -> (SampleRows, Vec<f32>, Vec<u64>) {
    let rows = SampleRows::of(samples);
    let len = rows.pieces().len();
    (rows, vec![0.0; Pieces::SAMPLES * len], vec![0; len])
}

fn is_doubted(doubted: &[u64], i: usize) -> bool {
    doubted[i / Pieces::SAMPLES] >> (i % Pieces::SAMPLES) & 1 != 0
}

fn differences<T: BatchTest, const LTT: bool>(samples: &[Sample], p: &ShadowParams, depths: &[f32]) -> usize {
    let (rows, mut lit, mut doubted) = pieces_of(samples);
    let pieces = rows.pieces();
    evaluate_batch::<T, LTT>(pieces, p, depths, &mut lit, &mut doubted);
    let map = GatheredDepths { depths: &maps_to_rows(depths, p.map_size) };
    let is_different = |(i, sample): (usize, &Sample)| {
        let v = evaluate::<T, _, LTT>(sample, p, map);
        v.visibility.to_bits() != lit[i].to_bits() || v.is_doubted != is_doubted(&doubted, i)
    };
    samples.iter().enumerate().filter(|&s| is_different(s)).count()
}
