//! Translucent casters tint what light they let through, in any order, on CPU and GPU.

use lt_math::glam::{Affine3A, Vec3, Vec4};
use lt_render::{BackendKind, Frame, Packing, Session, Setup, Technique};
use lt_scene::{AlphaMode, Camera, Instance, Light, LightKind, Material, Mesh, Scene};
use lt_tests::{builtin, gpu_session, ppm, twin_ppm};

/// Largest difference between two ways to multiply the same factors.
const ORDER_TOLERANCE: f32 = 1e-5;

fn square(y: f32, half: f32, material: u32) -> Mesh {
    let at = |x: f32, z: f32| Vec3::new(x * half, y, z * half);
    Mesh {
        positions: vec![at(-1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0)],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Mesh::default()
    }
}

/// A floor under horizontal panes, seen from between the two; the sun stands overhead.
fn panes(materials: &[Material], order: &[usize]) -> Scene {
    let mut scene = Scene { name: "panes".to_owned(), ..Scene::default() };
    scene.materials.push(Material::opaque("floor", Vec3::ONE));
    scene.materials.extend_from_slice(materials);
    scene.meshes.push(square(0.0, 4.0, 0));
    for (level, &i) in order.iter().enumerate() {
        scene.meshes.push(square(2.0 + level as f32, 6.0, i as u32 + 1));
    }
    for mesh in 0..scene.meshes.len() as u32 {
        scene.instances.push(Instance::new(mesh, Affine3A::IDENTITY));
    }
    scene.lights.push(Light::sun(Vec3::new(0.1, -1.0, 0.2)));
    scene.cameras.push(Camera {
        name: "below".to_owned(),
        eye: Vec3::new(0.0, 1.5, 3.0),
        target: Vec3::new(0.0, 0.0, -0.5),
        up: Vec3::Y,
        fov_y_rad: 0.8,
    });
    scene
}

fn glass(color: Vec3, transmission: f32) -> Material {
    Material { transmission, ..Material::opaque("glass", color) }
}

fn blended(color: Vec4) -> Material {
    Material { base_color: color, alpha: AlphaMode::Blend, ..Material::opaque("film", Vec3::ONE) }
}

fn setup(scene: &Scene) -> Setup {
    Setup {
        map_size: 512,
        packing: Packing { traces_translucency: true, bakes_copies: true, layers_behind: 0 },
        ..Setup::for_scene(scene, 160, 100)
    }
}

fn frame(scene: &Scene, id: &str) -> Frame {
    let mut session = Session::new(scene, setup(scene), BackendKind::Cpu).expect("session");
    session.render(&id.parse().expect("id")).expect("frame")
}

fn farthest(a: &[Vec3], b: &[Vec3]) -> f32 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most, (a, b)| most.max((*a - *b).abs().max_element()))
}

#[test]
fn panes_multiply_in_any_order() {
    let materials = [
        glass(Vec3::new(0.9, 0.5, 0.2), 0.8),
        blended(Vec4::new(0.1, 0.2, 0.9, 0.3)),
        glass(Vec3::new(0.3, 0.7, 1.0), 1.0),
    ];
    let expected = Vec3::new(0.9, 0.5, 0.2) * 0.8 * 0.7 * Vec3::new(0.3, 0.7, 1.0);
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let scene = panes(&materials, &order);
        let frame = frame(&scene, "ray");
        let valid: Vec<usize> = (0..frame.tint.len()).filter(|&i| frame.visibility[i] == 1.0).collect();
        assert!(valid.len() > 10_000, "the floor fills the picture");
        for i in valid {
            // On the seam of a pane's two triangles both count: one point of a picture may lie there exactly.
            let off = (frame.tint[i] - expected).abs().max_element();
            assert!(off <= 1e-6, "{order:?}, pixel {i}: {} instead of {expected}", frame.tint[i]);
        }
    }
}

#[test]
fn an_opaque_thing_among_panes_blocks_all() {
    let materials = [glass(Vec3::new(0.9, 0.5, 0.2), 0.8), Material::opaque("lid", Vec3::ONE)];
    for order in [[0, 1], [1, 0]] {
        let lit = frame(&panes(&materials, &order), "ray").visibility.iter().filter(|v| **v > 0.0).count();
        assert_eq!(lit, 0);
    }
}

#[test]
fn a_clear_film_changes_no_bit() {
    let scene = panes(&[blended(Vec4::new(0.5, 0.5, 0.5, 0.0))], &[0]);
    let with = frame(&scene, "ray");
    assert!(with.tint.iter().all(|t| *t == Vec3::ONE));
    assert!(with.visibility.contains(&1.0));
}

#[test]
fn every_technique_sees_the_same_tint_where_it_sees_light() {
    let scene = builtin("strands:200");
    let truth = frame(&scene, "ray");
    let tinted = truth.tint.iter().filter(|t| **t != Vec3::ONE).count();
    assert!(tinted > 200, "{tinted} pixels are tinted");
    for id in ["sm", "ltt-evsm", "lt-msm"] {
        let other = frame(&scene, id);
        for (i, (a, b)) in truth.tint.iter().zip(&other.tint).enumerate() {
            let both = truth.visibility[i] > 0.0 && other.visibility[i] > 0.0;
            assert!(!both || a == b, "{id}, pixel {i}: {a} and {b}");
        }
    }
}

#[test]
fn the_alias_free_map_lets_through_what_rays_do() {
    let mut overhead = builtin("strands:200");
    let bounds = overhead.bounds();
    let position = bounds.max + (bounds.max - bounds.min) * 0.2;
    let lamp = LightKind::Point { position, range: f32::INFINITY };
    for is_lamp in [false, true] {
        if is_lamp {
            overhead.lights = vec![Light { kind: lamp, ..Light::sun(Vec3::NEG_Y) }];
        }
        let truth = frame(&overhead, "ray");
        let tinted = truth.tint.iter().filter(|t| **t != Vec3::ONE).count();
        assert!(tinted > 200, "{tinted} pixels are tinted");
        let map = frame(&overhead, "alias-free");
        assert_eq!(map.visibility, truth.visibility);
        assert_eq!(map.rays, truth.rays);
        let off = farthest(&map.tint, &truth.tint);
        assert!(off <= ORDER_TOLERANCE, "lamp {is_lamp}: off by {off}");
        let hybrid = frame(&overhead, "ltt-evsm:alias-free");
        let rays = frame(&overhead, "ltt-evsm");
        let off = farthest(&hybrid.tint, &rays.tint);
        assert!(off <= ORDER_TOLERANCE, "lamp {is_lamp}, hybrid: off by {off}");
    }
}

#[test]
fn another_tree_over_the_same_strands_multiplies_to_the_same_tint() {
    let scene = builtin("strands:200");
    let mut shuffled = scene.clone();
    for mesh in &mut shuffled.meshes {
        let mut triangles: Vec<[u32; 3]> = mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect();
        triangles.reverse();
        mesh.indices = triangles.into_iter().flatten().collect();
    }
    // An instance apart moves the root's box, and with it every split.
    let far = shuffled.meshes.len() as u32;
    shuffled.meshes.push(Mesh {
        material: shuffled.meshes[shuffled.instances[0].mesh as usize].material,
        ..square(40.0, 0.01, 0)
    });
    shuffled.instances.push(Instance::new(far, Affine3A::from_translation(Vec3::new(60.0, 0.0, 60.0))));
    let view = setup(&scene);
    let mut session = Session::new(&shuffled, view, BackendKind::Cpu).expect("session");
    let other = session.render(&Technique::RAY).expect("frame");
    let off = farthest(&frame(&scene, "ray").tint, &other.tint);
    assert!(off <= ORDER_TOLERANCE, "{off}");
}

#[test]
fn where_nothing_is_translucent_asking_changes_nothing() {
    let scene = builtin("square:6");
    let plain = Setup { packing: Packing::default(), ..setup(&scene) };
    let mut session = Session::new(&scene, plain, BackendKind::Cpu).expect("session");
    let without = session.render(&Technique::RAY).expect("frame");
    let with = frame(&scene, "ray");
    assert!(with.tint.is_empty());
    assert_eq!((with.visibility, with.rays), (without.visibility, without.rays));
}

#[test]
fn cpu_and_gpu_tint_alike() {
    let glassy =
        panes(&[glass(Vec3::new(0.9, 0.5, 0.2), 0.8), blended(Vec4::new(0.1, 0.2, 0.9, 0.3))], &[0, 1]);
    for scene in [glassy, builtin("strands:200")] {
        let Some(mut gpu) = gpu_session(&scene, setup(&scene)) else { return };
        for id in ["ray", "ltt-evsm"] {
            let (a, b) = (frame(&scene, id), gpu.render(&id.parse().expect("id")).expect("frame"));
            let differ = |(a, b): (&Vec3, &Vec3)| (*a - *b).abs().max_element() > ORDER_TOLERANCE;
            let wrong = a.tint.iter().zip(&b.tint).filter(|t| differ(*t)).count();
            assert!(ppm(wrong, a.tint.len()) <= twin_ppm(), "{} {id}: {wrong} pixels differ", scene.name);
            assert!(a.rays.abs_diff(b.rays) <= 1, "{} {id}: rays {} and {}", scene.name, a.rays, b.rays);
        }
        let frame = gpu.render(&Technique::RAY).expect("frame");
        let mut cpu = Session::new(&scene, setup(&scene), BackendKind::Cpu).expect("session");
        let (a, b) = (cpu.shade(&frame).expect("picture"), gpu.shade(&frame).expect("picture"));
        let far = |(a, b): (&[u8; 4], &[u8; 4])| (0..4).any(|c| a[c].abs_diff(b[c]) > 1);
        let wrong = a.iter().zip(&b).filter(|p| far(*p)).count();
        assert!(ppm(wrong, a.len()) <= twin_ppm() * 5.0, "{}: {wrong} pixels differ in shade", scene.name);
    }
}
