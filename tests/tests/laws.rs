//! What must hold of techniques on real pictures.

use lt_render::{Technique, metrics};
use lt_tests::{builtin, cpu_session};

fn errors(session: &mut lt_render::Session, truth: &[f32], technique: &Technique) -> (metrics::Errors, u64) {
    let frame = session.render(technique).expect("frame");
    let valid: Vec<bool> = session.samples().iter().map(|s| s.is_valid()).collect();
    let size = session.setup().size;
    (metrics::errors([size.x, size.y], &valid, truth, &frame.visibility), frame.rays)
}

#[test]
fn the_leak_tracing_test_mends_each_map_with_a_fraction_of_the_rays() {
    for name in ["cornell", "street:4", "square:6"] {
        let scene = builtin(name);
        let mut session = cpu_session(&scene, 320, 200);
        let truth = session.render(&Technique::RAY).expect("frame");
        for id in ["vsm", "esm", "evsm", "msm", "msm-hausdorff"] {
            let (map, _) = errors(&mut session, &truth.visibility, &id.parse().expect("id"));
            let (hybrid, rays) =
                errors(&mut session, &truth.visibility, &format!("ltt-{id}").parse().expect("id"));
            let wrong = |e: &metrics::Errors| e.false_lit + e.false_shadowed;
            assert!(wrong(&map) > 0, "{name} {id}: the map alone errs somewhere");
            assert!(wrong(&hybrid) < wrong(&map), "{name} {id}: {} → {}", wrong(&map), wrong(&hybrid));
            assert!(rays > 0 && rays < truth.rays, "{name} {id}: {rays} of {} rays", truth.rays);
        }
    }
}

#[test]
fn rays_doubted_by_a_wider_band_never_get_fewer() {
    let scene = builtin("street:4");
    let mut session = cpu_session(&scene, 320, 200);
    let mut last = u64::MAX;
    for eps in ["0.001", "0.01", "0.1"] {
        let frame = session.render(&format!("ltt-evsm:eps={eps}").parse().expect("id")).expect("frame");
        assert!(frame.rays <= last, "eps {eps}: {} after {last}", frame.rays);
        last = frame.rays;
    }
}

#[test]
fn surfaces_that_face_away_are_dark_and_cost_nothing() {
    let scene = builtin("cornell");
    let mut session = cpu_session(&scene, 200, 120);
    let frame = session.render(&Technique::RAY).expect("frame");
    let lt_scene::LightKind::Directional { direction } = session.setup().light.kind else { panic!("a sun") };
    let faces: Vec<bool> =
        session.samples().iter().map(|s| s.is_valid() && s.normal.dot(-direction) > 0.0).collect();
    assert_eq!(frame.rays, faces.iter().filter(|f| **f).count() as u64);
    for (visibility, faces) in frame.visibility.iter().zip(&faces) {
        assert!(*faces || *visibility == 0.0);
    }
}
