//! The scenes of ../shared/scenes, where they are there: CPU and GPU agree on real input.

use std::path::PathBuf;

use lt_math::glam::Vec3;
use lt_render::{BackendKind, Session, Setup, Technique, metrics};
use lt_scene::{Camera, Light, Source};
use lt_tests::{gpu_session, twin_ppm};

fn folder() -> Option<PathBuf> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/scenes");
    path.join("views.json").exists().then_some(path)
}

fn vec3(value: &serde_json::Value) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|i| value[i].as_f64().expect("a number") as f32))
}

#[test]
fn every_real_scene_renders_alike_on_cpu_and_gpu() {
    let Some(folder) = folder() else {
        eprintln!("skipped: ../shared/scenes is not here");
        return;
    };
    let views: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("views.json")).expect("readable"))
            .expect("json");
    for (name, view) in views.as_object().expect("an object of views") {
        let path = folder.join(format!("{name}.glb"));
        if !path.exists() {
            continue;
        }
        let source = Source::open(&path.to_string_lossy(), 1).unwrap_or_else(|e| panic!("{name}: {e}"));
        let mut scene = source.pose(0.0).unwrap_or_else(|e| panic!("{name}: {e}"));
        if let Some(ground) = view["ground"].as_array() {
            scene.add_ground(
                ground[0].as_f64().expect("y") as f32,
                ground[1].as_f64().expect("half size") as f32,
            );
        }
        let fov = view["fov"].as_f64().unwrap_or(55.0) as f32;
        let camera = Camera {
            name: name.clone(),
            eye: vec3(&view["eye"]),
            target: vec3(&view["target"]),
            up: Vec3::Y,
            fov_y_rad: fov.to_radians(),
        };
        let setup = Setup {
            camera,
            light: Light::sun(vec3(&view["light"])),
            map_size: 1024,
            ..Setup::for_scene(&scene, 480, 270)
        };
        agree(name, &scene, setup);
    }
}

fn agree(name: &str, scene: &lt_scene::Scene, setup: Setup) {
    let mut cpu =
        Session::new(scene, setup.clone(), BackendKind::Cpu).unwrap_or_else(|e| panic!("{name}: {e}"));
    let truth = cpu.render(&Technique::RAY).expect("frame");
    assert!(truth.rays > 1000, "{name}: the view sees the scene");
    let Some(mut gpu) = gpu_session(scene, setup) else { return };
    let gpu_truth = gpu.render(&Technique::RAY).expect("frame");
    for id in ["sm", "ltt-evsm", "ltt-msm"] {
        let technique = id.parse().expect("id");
        let count = |session: &mut Session, truth: &[f32]| {
            let frame = session.render(&technique).expect("frame");
            let valid: Vec<bool> = session.samples().iter().map(|s| s.is_valid()).collect();
            metrics::errors([480, 270], &valid, truth, &frame.visibility)
        };
        let (a, b) = (count(&mut cpu, &truth.visibility), count(&mut gpu, &gpu_truth.visibility));
        let allowed = (480.0 * 270.0 * twin_ppm() * 1e-6) as u64;
        assert!(a.false_lit.abs_diff(b.false_lit) <= allowed, "{name} {id}: {a:?} {b:?}");
        assert!(a.false_shadowed.abs_diff(b.false_shadowed) <= allowed, "{name} {id}: {a:?} {b:?}");
    }
}
