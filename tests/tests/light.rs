//! Resolvers in the light's own space give the rays' own bits, for every light, scene and number of threads.

use lt_render::{BackendKind, Frame, PassKind, RenderError, Session, Setup, Technique, Upkeep};
use lt_scene::{Light, LightKind};
use lt_tests::{builtin, count_different, cpu_session, gpu_session};

/// Rays, and the resolvers that must equal them.
const FAMILIES: [(&str, [&str; 3]); 3] = [
    ("ray", ["ray:light", "ray:dac", "alias-free"]),
    ("ltt-evsm", ["ltt-evsm:light", "ltt-evsm:dac", "ltt-evsm:alias-free"]),
    ("lt-evsm", ["lt-evsm:light", "lt-evsm:dac", "lt-evsm:alias-free"]),
];

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

fn compare(session: &mut Session, label: &str) {
    for (rays, others) in FAMILIES {
        let rays = session.render(&technique(rays)).expect("frame");
        for id in others {
            let points = session.render(&technique(id)).expect("frame");
            assert_eq!(count_different(&points.visibility, &rays.visibility, 0.0), 0, "{label} {id}");
            assert_eq!(points.rays, rays.rays, "{label} {id}");
            assert_eq!(points.doubt, rays.doubt, "{label} {id}");
            assert_eq!(points.mask, rays.mask, "{label} {id}");
        }
    }
}

#[test]
fn resolvers_in_light_space_answer_as_rays_do() {
    for name in ["cornell", "street:4", "square:6", "strands:200", "random:20000"] {
        let mut session = cpu_session(&builtin(name), 320, 180);
        compare(&mut session, name);
        // The masks of the second frame have learnt from the first.
        compare(&mut session, name);
    }
}

#[test]
fn lights_with_a_position_are_seen_on_six_faces() {
    let scene = builtin("square:6");
    let bounds = scene.bounds();
    let mut setup = Setup::for_scene(&scene, 320, 180);
    let kind = LightKind::Point { position: (bounds.min + bounds.max) * 0.5, range: f32::INFINITY };
    setup.light = Light { kind, ..setup.light };
    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    let rays = session.render(&Technique::RAY).expect("frame");
    for id in ["ray:light", "ray:dac", "alias-free"] {
        let points = session.render(&technique(id)).expect("frame");
        assert_eq!(count_different(&points.visibility, &rays.visibility, 0.0), 0, "{id}");
    }
    let blocked = rays.visibility.iter().zip(&rays.doubt).filter(|(v, d)| **d && **v == 0.0).count();
    assert!(blocked > 100, "{blocked} blocked");
}

#[test]
fn rebuilding_counts_what_a_technique_traces_with_and_changes_no_bit() {
    let scene = builtin("square:6");
    let ids = ["ray", "ray:light", "ray:dac", "alias-free", "sm", "lt-evsm", "lt-evsm:dac"];
    let passes_of = |frame: &Frame| -> Vec<PassKind> { frame.passes.iter().map(|p| p.kind).collect() };
    for upkeep in [Upkeep::Build, Upkeep::Refit] {
        let mut setup = Setup::for_scene(&scene, 160, 90);
        setup.packing.bakes_copies = true;
        let mut kept = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
        let mut session = Session::new(&scene, Setup { upkeep, ..setup }, BackendKind::Cpu).expect("session");
        for id in ids {
            let expected = kept.render(&technique(id)).expect("frame");
            let frame = session.render(&technique(id)).expect("frame");
            assert_eq!(frame.visibility, expected.visibility, "{id}");
            let builds = ["ray", "lt-evsm"].contains(&id);
            assert_eq!(passes_of(&frame).contains(&PassKind::Build), builds, "{id}");
            let time = |kind| frame.passes.iter().find(|p| p.kind == kind).and_then(|p| p.ms);
            assert!(!builds || time(PassKind::Build).expect("is timed") > 0.0, "{id}");
        }
    }
}

#[test]
fn what_has_no_such_resolver_says_so() {
    let scene = builtin("cornell");
    if let Some(mut gpu) = gpu_session(&scene, Setup::for_scene(&scene, 64, 48)) {
        let error = gpu.render(&technique("ray:light")).expect_err("none on the GPU");
        assert!(
            matches!(error, RenderError::Gpu { .. }) && error.to_string().contains("--backend cpu"),
            "{error}"
        );
    }
}
