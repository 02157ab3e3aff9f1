//! Hard numerical cases of whole pictures: scale, offset, degenerate geometry, extreme lights.

use lt_math::glam::{Affine3A, Vec3};
use lt_render::{BackendKind, Session, Setup, Technique};
use lt_scene::{Camera, Instance, Light, Material, Mesh, Scene};
use lt_tests::{builtin, count_different, ppm};

/// A scene with everything in it moved and scaled: `p ↦ p · scale + offset`.
fn transformed(scene: &Scene, scale: f32, offset: Vec3) -> Scene {
    let mut out = scene.clone();
    let placed = Affine3A::from_scale_rotation_translation(Vec3::splat(scale), Default::default(), offset);
    for instance in &mut out.instances {
        instance.transform = placed * instance.transform;
    }
    for camera in &mut out.cameras {
        camera.eye = camera.eye * scale + offset;
        camera.target = camera.target * scale + offset;
    }
    out
}

fn visibility(scene: &Scene, id: &str) -> Vec<f32> {
    let setup = Setup { map_size: 512, ..Setup::for_scene(scene, 240, 160) };
    let mut session = Session::new(scene, setup, BackendKind::Cpu).expect("session");
    session.render(&id.parse().expect("id")).expect("frame").visibility
}

#[test]
fn the_picture_does_not_depend_on_the_scene_s_scale() {
    let scene = builtin("cornell");
    for id in ["ray", "ltt-evsm", "ltt-msm"] {
        let base = visibility(&scene, id);
        // Powers of two change no mantissa; powers of ten round every vertex anew.
        for scale in [1.0 / 1048576.0, 1048576.0, 1e-6, 1e-3, 1e3, 1e6] {
            let other = visibility(&transformed(&scene, scale, Vec3::ZERO), id);
            let wrong = count_different(&base, &other, 0.0);
            assert!(ppm(wrong, base.len()) <= 400.0, "{id} at scale {scale}: {wrong} pixels differ");
        }
    }
}

#[test]
fn the_picture_survives_an_offset_within_the_precision_of_its_vertices() {
    let scene = builtin("cornell");
    let base = visibility(&scene, "ray");
    for (offset, most_ppm) in [(500.0, 2_000.0), (8_000.0, 6_000.0)] {
        let other = visibility(&transformed(&scene, 1.0, Vec3::new(offset, 0.0, -offset)), "ray");
        let wrong = count_different(&base, &other, 0.0);
        assert!(ppm(wrong, base.len()) <= most_ppm, "offset {offset}: {wrong} pixels differ");
    }
}

/// A floor under a sun with nothing between: every point is lit, at every angle and scale.
#[test]
fn a_bare_surface_never_shadows_itself() {
    for scale in [1e-6f32, 1.0, 1e6] {
        for slope in [0.0f32, 0.1, 1.0, 10.0, 100.0] {
            let direction = Vec3::new(slope, -1.0, 0.3 * slope);
            let scene = floor(scale, direction);
            for id in
                ["ray", "sm", "pcf", "vsm", "ltt-vsm", "ltt-esm", "ltt-evsm", "ltt-msm", "ltt-msm-hausdorff"]
            {
                let lit = visibility(&scene, id);
                let dark = lit.iter().filter(|v| **v < 0.5 || v.is_nan()).count();
                assert_eq!(dark, 0, "{id}, scale {scale}, light {direction}: dark pixels");
            }
        }
    }
}

/// A square of 32² cells on a wavy grid, seen from straight above so that every pixel shows it.
fn floor(scale: f32, direction: Vec3) -> Scene {
    let n = 32;
    let at = |i: usize, j: usize| {
        Vec3::new(i as f32 / n as f32 - 0.5, 0.0, j as f32 / n as f32 - 0.5) * 8.0 * scale
    };
    let positions = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| at(i, j)).collect();
    let index = |i: usize, j: usize| (i * (n + 1) + j) as u32;
    let mut indices = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let quad = [index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j)];
        indices.extend([quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]]);
    }
    one_mesh(Mesh { positions, indices, ..Mesh::default() }, scale, direction)
}

fn one_mesh(mesh: Mesh, scale: f32, direction: Vec3) -> Scene {
    Scene {
        name: "test".to_owned(),
        meshes: vec![mesh],
        instances: vec![Instance::new(0, Affine3A::IDENTITY)],
        materials: vec![Material::opaque("grey", Vec3::splat(0.5))],
        lights: vec![Light::sun(direction)],
        cameras: vec![Camera {
            name: String::new(),
            eye: Vec3::new(0.0, 3.0, 0.0) * scale,
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_y_rad: 1.0,
        }],
        ..Scene::default()
    }
}

#[test]
fn degenerate_triangles_do_no_harm() {
    let mut scene = floor(1.0, Vec3::new(0.3, -1.0, 0.2));
    let clean = visibility(&scene, "ltt-evsm");
    let mesh = &mut scene.meshes[0];
    let first = mesh.positions.len() as u32;
    mesh.positions.extend([
        Vec3::splat(f32::NAN),
        Vec3::splat(f32::INFINITY),
        Vec3::new(0.0, 1.0, 0.0),
        Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(2.0, 1.0, 0.0),
    ]);
    // NaN, infinity, collinear, and thrice the same vertex.
    mesh.indices.extend([
        0,
        1,
        first,
        0,
        1,
        first + 1,
        first + 2,
        first + 3,
        first + 4,
        first + 2,
        first + 2,
        first + 2,
    ]);
    let setup = Setup { map_size: 512, ..Setup::for_scene(&scene, 240, 160) };
    let session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    assert_eq!(session.info().stats.dropped, 4);
    assert_eq!(count_different(&clean, &visibility(&scene, "ltt-evsm"), 0.0), 0);
}

#[test]
fn empty_and_invisible_scenes_render() {
    let empty = Scene::default();
    let mut session =
        Session::new(&empty, Setup::for_scene(&empty, 16, 16), BackendKind::Cpu).expect("session");
    for (technique, _) in Technique::catalogue() {
        let frame = session.render(&technique).expect("frame");
        assert_eq!(frame.rays, 0);
        assert!(frame.visibility.iter().all(|v| *v == 0.0));
    }
}

#[test]
fn impossible_setups_are_refused_with_a_reason() {
    let scene = builtin("cornell");
    let good = Setup::for_scene(&scene, 16, 16);
    let mut bad = Vec::new();
    bad.push(Setup { size: [0, 4].into(), ..good.clone() });
    bad.push(Setup { map_size: 100, ..good.clone() });
    bad.push(Setup {
        light: Light {
            kind: lt_scene::LightKind::Directional { direction: Vec3::ZERO },
            ..good.light.clone()
        },
        ..good.clone()
    });
    bad.push(Setup { camera: Camera { target: good.camera.eye, ..good.camera.clone() }, ..good.clone() });
    bad.push(Setup { camera: Camera { fov_y_rad: f32::NAN, ..good.camera.clone() }, ..good });
    for setup in bad {
        let Err(error) = Session::new(&scene, setup, BackendKind::Cpu) else { panic!("accepted") };
        assert!(error.to_string().len() > 20, "{error}");
    }
}

#[test]
fn flags_decide_who_casts_and_who_receives() {
    let floor_scene = floor(1.0, Vec3::NEG_Y);
    let roof = Mesh {
        positions: [[-1.0, 1.0, -1.0], [-1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]
            .map(Vec3::from)
            .to_vec(),
        indices: vec![0, 1, 2, 0, 2, 3],
        ..Mesh::default()
    };
    let with_roof = |casts: bool, floor_receives: bool| {
        let mut scene = floor_scene.clone();
        scene.cameras[0].eye = Vec3::new(0.0, 0.8, 0.0);
        scene.meshes.push(roof.clone());
        scene.instances.push(Instance { casts_shadow: casts, ..Instance::new(1, Affine3A::IDENTITY) });
        scene.instances[0].receives_shadow = floor_receives;
        scene
    };
    for id in ["ray", "sm", "ltt-evsm"] {
        let dark = |scene: &Scene| visibility(scene, id).iter().filter(|v| **v < 0.5).count();
        assert!(dark(&with_roof(true, true)) > 10_000, "{id}: the roof shades the floor");
        assert_eq!(dark(&with_roof(false, true)), 0, "{id}: a roof that does not cast");
        assert_eq!(dark(&with_roof(true, false)), 0, "{id}: a floor that does not receive");
    }
}
