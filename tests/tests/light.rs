//! Resolvers in the light's own space give the rays' own bits, for every light, scene and number of threads.

use lt_render::{RenderError, Session, Setup, Technique};
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
