//! Surfaces seen through translucent ones: layers with shadows of their own, put together front to back.

use lt_math::glam::{Affine3A, Vec3, Vec4};
use lt_render::{BackendKind, Frame, Packing, SampleGrid, Sequence, Session, Setup, Technique};
use lt_scene::{AlphaMode, Camera, Instance, Light, Material, Mesh, Scene};
use lt_tests::{builtin, count_different, gpu_session, ppm, twin_ppm};

/// Dark enough that its picture is not clipped.
const FLOOR: Vec3 = Vec3::new(0.55, 0.5, 0.45);

fn rectangle(y: f32, half: [f32; 2], material: u32) -> Mesh {
    let at = |x: f32, z: f32| Vec3::new(x * half[0], y, z * half[1]);
    Mesh {
        positions: vec![at(-1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0)],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Mesh::default()
    }
}

/// A floor under panes, one a unit above the other, under a bar; seen from between panes and bar. The sun stands overhead and
/// shines along `sun`.
fn place(panes: &[Material], sun: Vec3) -> Scene {
    let mut scene = Scene { name: "layers".to_owned(), ..Scene::default() };
    scene.materials = vec![Material::opaque("floor", FLOOR), Material::opaque("bar", Vec3::ONE)];
    scene.materials.extend_from_slice(panes);
    scene.meshes = vec![rectangle(0.0, [6.0, 6.0], 0), rectangle(7.0, [0.4, 6.0], 1)];
    for i in 0..panes.len() {
        scene.meshes.push(rectangle(1.0 + i as f32, [6.0, 6.0], i as u32 + 2));
    }
    scene.instances = (0..scene.meshes.len() as u32).map(|i| Instance::new(i, Affine3A::IDENTITY)).collect();
    scene.lights.push(Light::sun(sun));
    scene.cameras.push(Camera {
        name: "between".to_owned(),
        eye: Vec3::new(0.0, 5.0, 0.5),
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_y_rad: 0.7,
    });
    scene
}

fn glass(color: Vec3, transmission: f32) -> Material {
    Material { transmission, ..Material::opaque("glass", color) }
}

fn film(color: Vec3, alpha: f32) -> Material {
    Material {
        base_color: color.extend(alpha),
        alpha: AlphaMode::Blend,
        ..Material::opaque("film", Vec3::ONE)
    }
}

fn setup(scene: &Scene, layers: u32) -> Setup {
    Setup {
        map_size: 512,
        packing: Packing { traces_translucency: true, bakes_copies: true, layers_behind: layers - 1 },
        ..Setup::for_scene(scene, 120, 80)
    }
}

fn session(scene: &Scene, layers: u32) -> Session {
    Session::new(scene, setup(scene, layers), BackendKind::Cpu).expect("session")
}

fn frame(session: &mut Session, id: &str) -> Frame {
    session.render(&id.parse().expect("id")).expect("frame")
}

/// The picture in linear light.
fn linear(scene: &Scene, layers: u32) -> Vec<Vec3> {
    let mut session = session(scene, layers);
    let frame = frame(&mut session, "ray");
    let decode = |b: u8| {
        let x = f32::from(b) / 255.0;
        if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    };
    let pixels = session.shade(&frame).expect("picture");
    pixels.iter().map(|p| Vec3::new(decode(p[0]), decode(p[1]), decode(p[2]))).collect()
}

const SUN: Vec3 = Vec3::NEG_Y;
/// What two encodings to bytes, and the encoding's own distance from sRGB (0.008), leave open.
const TOLERANCE: f32 = 0.025;

#[test]
fn each_layer_has_the_bars_shadow_where_it_lies_itself() {
    let tint = Vec3::new(0.9, 0.5, 0.2) * 0.75;
    let mut session = session(&place(&[glass(Vec3::new(0.9, 0.5, 0.2), 0.75)], SUN), 4);
    let frame = frame(&mut session, "ray");
    assert_eq!((session.layers().len(), frame.layers.len()), (4, 4));
    for (layer, (samples, frame)) in session.layers().iter().zip(&frame.layers).enumerate() {
        let (mut lit, mut dark) = (0, 0);
        for (i, sample) in samples.iter().enumerate() {
            assert_eq!(sample.is_valid(), layer < 2, "layer {layer}");
            if !sample.is_valid() {
                continue;
            }
            assert!(
                (sample.position.y - [1.0, 0.0][layer]).abs() < 1e-5,
                "layer {layer}: {}",
                sample.position
            );
            let off_edge = (sample.position.x.abs() - 0.4).abs();
            let expected = if sample.position.x.abs() < 0.4 { 0.0 } else { 1.0 };
            assert!(
                off_edge < 1e-5 || frame.visibility[i] == expected,
                "layer {layer} at {}",
                sample.position
            );
            if frame.visibility[i] == 1.0 {
                let passes = [Vec3::ONE, tint][layer];
                assert!(
                    (frame.tint[i] - passes).abs().max_element() < 1e-6,
                    "layer {layer}: {}",
                    frame.tint[i]
                );
                lit += 1;
            } else {
                dark += 1;
            }
        }
        assert!(layer >= 2 || (lit > 1000 && dark > 500), "layer {layer}: {lit} lit, {dark} dark");
    }
    assert_eq!(frame.rays, frame.layers.iter().map(|l| l.rays).sum::<u64>());
}

/// What is seen through a pane is what it scatters, and what it lets pass of the floor, whose sunlight has passed it as well.
#[test]
fn layers_are_put_together_as_computed_by_hand() {
    let color = Vec3::new(0.6, 0.35, 0.15);
    let floor = linear(&place(&[], SUN), 1);
    let shaded_floor = linear(&place(&[], Vec3::Y), 1);
    let pane = linear(&place(&[Material::opaque("pane", color)], SUN), 1);
    for (material, scatters, passes) in [
        (glass(color, 0.75), 0.25, color * 0.75),
        (glass(color, 1.0), 0.0, color),
        (film(color, 0.3), 0.3, Vec3::splat(0.7)),
        (film(color, 0.8), 0.8, Vec3::splat(0.2)),
    ] {
        let seen = linear(&place(std::slice::from_ref(&material), SUN), 3);
        for i in 0..seen.len() {
            let below = shaded_floor[i] + passes * (floor[i] - shaded_floor[i]);
            let expected = pane[i] * scatters + passes * below;
            let off = (seen[i] - expected).abs().max_element();
            assert!(
                off < TOLERANCE,
                "{} {passes}, pixel {i}: {} instead of {expected}",
                material.name,
                seen[i]
            );
        }
        let changed = seen.iter().zip(&floor).filter(|(a, b)| (**a - **b).abs().max_element() > 0.1).count();
        assert!(changed > seen.len() / 2, "the pane is seen");
    }
}

#[test]
fn what_is_clear_is_not_seen_and_the_last_layer_hides_what_lies_behind() {
    let color = Vec3::new(0.1, 0.2, 0.9);
    let floor = linear(&place(&[], SUN), 1);
    let near =
        |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).all(|(a, b)| (*a - *b).abs().max_element() < TOLERANCE);
    assert!(near(&linear(&place(&[film(color, 0.0)], SUN), 2), &floor), "a clear film");
    assert!(near(&linear(&place(&[glass(Vec3::ONE, 1.0), film(color, 0.0)], SUN), 2), &floor), "clear glass");
    // Two panes fill two layers: the lower one is seen as if nothing passed it.
    let panes = [film(color, 0.6), glass(Vec3::ONE, 1.0)];
    let opaque = [Material::opaque("film", color), glass(Vec3::ONE, 1.0)];
    assert!(near(&linear(&place(&panes, SUN), 2), &linear(&place(&opaque, SUN), 2)));
    assert!(!near(&linear(&place(&panes, SUN), 3), &linear(&place(&opaque, SUN), 3)));
}

/// On every layer, of scenes with many, with several samples per pixel too.
#[test]
fn resolvers_in_light_space_answer_as_rays_do_on_every_layer() {
    let panes =
        place(&[film(Vec3::X, 0.4), glass(Vec3::new(0.9, 0.5, 0.2), 0.75)], Vec3::new(0.3, -1.0, 0.1));
    for (scene, samples) in [(builtin("strands:200"), 1), (panes, 4)] {
        let samples = SampleGrid::of(samples).expect("a grid");
        let view = Setup { samples, ..setup(&scene, 4) };
        let mut session = Session::new(&scene, view, BackendKind::Cpu).expect("session");
        let valid = session.valid_samples();
        assert!(valid[1].iter().filter(|v| **v).count() > 200, "{}: something lies behind", scene.name);
        let rays = frame(&mut session, "ray");
        for id in ["ray:light", "ray:dac", "alias-free"] {
            let points = frame(&mut session, id);
            for (layer, (a, b)) in rays.layers.iter().zip(&points.layers).enumerate() {
                assert!(a.visibility == b.visibility, "{} {id}, layer {layer}", scene.name);
                let off = |(a, b): (&Vec3, &Vec3)| (*a - *b).abs().max_element() > 1e-5;
                assert_eq!(a.tint.iter().zip(&b.tint).filter(|t| off(*t)).count(), 0, "{id}, layer {layer}");
            }
            assert_eq!(points.rays, rays.rays);
        }
    }
}

#[test]
fn a_mask_remembers_every_layer() {
    let scene = builtin("strands:200");
    let mut session = session(&scene, 3);
    session.play(Sequence { is_played: true, ..Sequence::default() });
    let truth = frame(&mut session, "ray");
    let mut rays = Vec::new();
    for i in 0..3 {
        let hybrid = frame(&mut session, "lt-evsm");
        for (layer, (a, b)) in truth.layers.iter().zip(&hybrid.layers).enumerate() {
            assert!(a.visibility == b.visibility, "frame {i}, layer {layer}");
        }
        rays.push(hybrid.rays);
    }
    assert!(rays[2] < rays[0], "{rays:?}");
}

#[test]
fn cpu_and_gpu_see_the_same_layers() {
    let panes =
        place(&[film(Vec3::X, 0.4), glass(Vec3::new(0.9, 0.5, 0.2), 0.75)], Vec3::new(0.3, -1.0, 0.1));
    for (scene, samples) in [(panes, 1), (builtin("strands:200"), 2)] {
        let samples = SampleGrid::of(samples).expect("a grid");
        let view = Setup { samples, ..setup(&scene, 3) };
        let Some(mut gpu) = gpu_session(&scene, view.clone()) else { return };
        let mut cpu = Session::new(&scene, view, BackendKind::Cpu).expect("session");
        let places = |s: &Session| -> Vec<f32> {
            let all = s.layers().iter().flatten();
            all.flat_map(|s| s.position.to_array().into_iter().chain([s.scattered()])).collect()
        };
        let (a, b) = (places(&cpu), places(&gpu));
        let extent = a.iter().fold(0f32, |m, x| m.max(x.abs()));
        let wrong = count_different(&a, &b, extent * 1e-5);
        assert!(ppm(wrong, a.len()) <= twin_ppm(), "{}: {wrong} of {} numbers differ", scene.name, a.len());
        for id in ["ray", "sm", "ltt-evsm", "lt-evsm"] {
            let (a, b) = (frame(&mut cpu, id), frame(&mut gpu, id));
            for (layer, (a, b)) in a.layers.iter().zip(&b.layers).enumerate() {
                let wrong = count_different(&a.visibility, &b.visibility, 0.0);
                assert!(
                    ppm(wrong, a.visibility.len()) <= twin_ppm(),
                    "{} {id}, layer {layer}: {wrong}",
                    scene.name
                );
                let off = |(a, b): (&Vec3, &Vec3)| (*a - *b).abs().max_element() > 1e-5;
                let wrong = a.tint.iter().zip(&b.tint).filter(|t| off(*t)).count();
                assert!(
                    ppm(wrong, a.tint.len()) <= twin_ppm(),
                    "{} {id}, layer {layer}: {wrong} tints",
                    scene.name
                );
            }
        }
        let drawn = frame(&mut cpu, "ray");
        let (a, b) = (cpu.shade(&drawn).expect("picture"), gpu.shade(&drawn).expect("picture"));
        let bytes = |p: &[[u8; 4]]| p.iter().flatten().map(|v| f32::from(*v)).collect::<Vec<_>>();
        let wrong = count_different(&bytes(&a), &bytes(&b), 1.0);
        assert!(
            ppm(wrong, a.len() * 4) <= twin_ppm() * 5.0,
            "{}: {wrong} bytes differ by more than a step",
            scene.name
        );
    }
}

/// The bar moves, and with it the shadows on every layer: points are followed, on CPU and GPU alike.
#[test]
fn layers_are_followed_as_things_move() {
    /// One map: the last of several levels is traced.
    const LEAK_TRACING: &str = "lt-evsm:cascades=1";
    let panes = [film(Vec3::X, 0.4), glass(Vec3::new(0.9, 0.5, 0.2), 0.75)];
    let pose = |step: f32| {
        let mut scene = place(&panes, Vec3::new(0.3, -1.0, 0.1));
        for (i, way) in [(1, Vec3::new(0.05, 0.0, 0.02)), (3, Vec3::new(-0.03, 0.02, 0.0))] {
            scene.instances[i].transform = Affine3A::from_translation(way * step);
            scene.instances[i].is_dynamic = true;
        }
        scene
    };
    let start = pose(0.0);
    let view = setup(&start, 3);
    let mut cpu = Session::new(&start, view.clone(), BackendKind::Cpu).expect("session");
    let mut gpu = gpu_session(&start, view.clone());
    let playing = Sequence { is_played: true, objects_move: true, ..Sequence::default() };
    cpu.play(playing);
    gpu.iter_mut().for_each(|gpu| gpu.play(playing));
    let mut rays = Vec::new();
    for step in 0..4u8 {
        if step > 0 {
            let (now, before) = (pose(step.into()), pose(f32::from(step) - 1.0));
            for session in [Some(&mut cpu), gpu.as_mut()].into_iter().flatten() {
                session.advance(&view.camera, &now, &before).expect("view");
            }
        }
        let truth = frame(&mut cpu, "ray");
        let (hybrid, test) = (frame(&mut cpu, LEAK_TRACING), frame(&mut cpu, "ltt-evsm:cascades=1"));
        let wrong = |f: &Frame| lt_render::flips(f, &truth);
        assert!(wrong(&hybrid) <= wrong(&test), "frame {step}: {} and {}", wrong(&hybrid), wrong(&test));
        rays.push(hybrid.rays as f64 / truth.rays as f64);
        let Some(gpu) = &mut gpu else { continue };
        let other = frame(gpu, LEAK_TRACING);
        for (layer, (a, b)) in hybrid.layers.iter().zip(&other.layers).enumerate() {
            let wrong = count_different(&a.visibility, &b.visibility, 0.0);
            let masks = a.mask.iter().zip(&b.mask).filter(|(a, b)| a != b).count();
            let wrong = ppm(wrong.max(masks), a.visibility.len());
            assert!(wrong <= 10.0 * twin_ppm(), "frame {step}, layer {layer}: {wrong} ppm differ");
        }
    }
    assert!(rays[3] < 0.5, "{rays:?}");
}

#[test]
fn the_light_tree_on_the_gpu_answers_as_rays_do_on_every_layer() {
    let scene = place(&[film(Vec3::X, 0.4)], Vec3::new(0.3, -1.0, 0.1));
    let Some(mut gpu) = gpu_session(&scene, setup(&scene, 3)) else { return };
    let (rays, points) = (frame(&mut gpu, "ray"), frame(&mut gpu, "ray:light"));
    assert_eq!((lt_render::flips(&points, &rays), points.rays), (0, rays.rays));
}

#[test]
fn where_nothing_is_translucent_there_is_one_layer() {
    let scene = builtin("square:6");
    let (mut one, mut asked) = (session(&scene, 1), session(&scene, 4));
    assert_eq!(asked.layers().len(), 1);
    assert!(asked.samples() == one.samples());
    let (a, b) = (frame(&mut one, "ltt-evsm"), frame(&mut asked, "ltt-evsm"));
    assert!(a.visibility == b.visibility && a.rays == b.rays && b.layers.is_empty());
    assert!(one.shade(&a).expect("picture") == asked.shade(&b).expect("picture"));
    let effect = |s: &Session| s.plan(&Technique::RAY).effects.into_iter().find(|e| e.name == "layers");
    assert!(effect(&asked).is_some_and(|e| !e.is_on));
}

#[test]
fn layers_without_translucency_are_refused() {
    let scene = place(&[film(Vec4::ONE.truncate(), 0.5)], SUN);
    let mut view = setup(&scene, 2);
    view.packing.traces_translucency = false;
    let error = view.check().expect_err("no translucency").to_string();
    assert!(error.contains("2 layers") && error.contains("--translucent"), "{error}");
    assert!(setup(&scene, 17).check().is_err() && setup(&scene, 16).check().is_ok());
}
