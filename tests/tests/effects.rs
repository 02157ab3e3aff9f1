//! An effect that a scene does not call for changes nothing: forcing it on gives the same bits, and off it has no pass.

use lt_render::{PassKind, Technique};
use lt_tests::{builtin, count_different, cpu_session, gpu_session};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

#[test]
fn a_needless_alpha_test_changes_no_bit() {
    let scene = builtin("cornell");
    let mut session = cpu_session(&scene, 200, 120);
    for id in ["ray", "ltt-evsm"] {
        let technique = technique(id);
        let plan = session.plan(&technique);
        assert!(!plan.alpha_test && !plan.instances, "cornell calls for neither");
        let lean = session.render(&technique).expect("frame");
        let mut forced = plan.clone();
        forced.alpha_test = true;
        let forced = session.render_plan(&technique, forced).expect("frame");
        assert_eq!(count_different(&lean.visibility, &forced.visibility, 0.0), 0, "{id}");
        assert_eq!(lean.rays, forced.rays);
    }
}

#[test]
fn needless_levels_change_no_bit() {
    let scene = builtin("square:6");
    let mut session = cpu_session(&scene, 200, 120);
    for id in [
        "sm",
        "pcf",
        "esm",
        "vsm:prefiltered",
        "ltt-vsm:cascades=1",
        "ltt-evsm:cascades=1",
        "lt-evsm:cascades=1",
    ] {
        let technique = technique(id);
        let plan = session.plan(&technique);
        assert!(!plan.level_search && plan.levels == 1, "one map calls for no search");
        let lean = session.render(&technique).expect("frame");
        session.play(lt_render::Sequence::default());
        let forced = session
            .render_plan(&technique, lt_render::EffectPlan { level_search: true, ..plan })
            .expect("frame");
        assert_eq!(count_different(&lean.visibility, &forced.visibility, 0.0), 0, "{id}");
        assert_eq!(lean.rays, forced.rays);
    }
}

#[test]
fn only_the_passes_of_the_plan_run() {
    use PassKind::{DepthMap, Evaluate, FilterX, FilterY, Resolve};
    let scene = builtin("cornell");
    let mut session = cpu_session(&scene, 64, 48);
    let expected: [(&str, &[PassKind]); 5] = [
        ("ray", &[Resolve]),
        ("sm", &[DepthMap, Evaluate]),
        ("vsm:prefiltered", &[DepthMap, FilterX, FilterY, Evaluate]),
        ("ltt-vsm", &[DepthMap, Evaluate, Resolve]),
        ("ltt-msm:prefiltered", &[DepthMap, FilterX, FilterY, Evaluate, Resolve]),
    ];
    for (id, passes) in expected {
        let frame = session.render(&technique(id)).expect("frame");
        assert_eq!(frame.passes.iter().map(|p| p.kind).collect::<Vec<_>>(), passes, "{id}");
    }
    assert_eq!(session.render(&technique("ray")).expect("frame").map_bytes, 0);
    assert_eq!(session.render(&technique("sm")).expect("frame").map_bytes, 2048 * 2048 * 4);
    assert_eq!(session.render(&technique("vsm:prefiltered")).expect("frame").map_bytes, 2048 * 2048 * 36);
}

#[test]
fn a_frame_leaves_nothing_behind_for_the_next() {
    let scene = builtin("square:6");
    let setup = lt_render::Setup { map_size: 256, ..lt_render::Setup::for_scene(&scene, 160, 100) };
    let sessions = [
        Some(lt_render::Session::new(&scene, setup.clone(), lt_render::BackendKind::Cpu).expect("session")),
        gpu_session(&scene, setup),
    ];
    for mut session in sessions.into_iter().flatten() {
        let first = session.render(&technique("ltt-evsm")).expect("frame");
        for other in ["ray", "msm:prefiltered", "ltt-vsm:map=64", "sm"] {
            session.render(&technique(other)).expect("frame");
        }
        let again = session.render(&technique("ltt-evsm")).expect("frame");
        assert_eq!(count_different(&first.visibility, &again.visibility, 0.0), 0);
        assert_eq!((first.rays, &first.doubt), (again.rays, &again.doubt));
    }
}
