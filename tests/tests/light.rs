//! Resolvers in the light's own space give the rays' own bits, for every light, scene and number of threads.

use lt_math::glam::{Affine3A, UVec2, Vec3};
use lt_render::gpu::{GBuffer, GpuScene};
use lt_render::{
    BackendKind, Frame, FrameJob, PackedScene, PassKind, RenderError, Resolve, Sequence, Session, Setup,
    Technique, Upkeep,
};
use lt_scene::{Light, LightKind};
use lt_tests::textures::{download, upload, visibility_texture};
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

/// Far from the coordinates' own origin, where rays start further above their surfaces than any share of the scene's size.
#[test]
fn resolvers_in_light_space_answer_as_rays_do_far_away() {
    let mut scene = builtin("square:6");
    let away = Vec3::new(2e4, 0.0, -3e4);
    for instance in &mut scene.instances {
        instance.transform = Affine3A::from_translation(away) * instance.transform;
    }
    for camera in &mut scene.cameras {
        (camera.eye, camera.target) = (camera.eye + away, camera.target + away);
    }
    compare(&mut cpu_session(&scene, 160, 90), "far away");
}

/// Every built-in scene, with fewer things, under its sun, a lamp in its middle and a spot light that looks down on it; on one thread and on three.
#[test]
fn structures_in_light_space_answer_as_rays_do_under_every_kind_of_light() {
    let names =
        ["street:4", "square:6", "forest:8", "town:40", "fence", "cornell", "random:3000", "hairball:60"];
    for name in names {
        let scene = builtin(name);
        let bounds = scene.bounds();
        let setup = Setup::for_scene(&scene, 160, 90);
        let above = bounds.min.lerp(bounds.max, 0.5).with_y(bounds.min.lerp(bounds.max, 0.9).y);
        let spot = LightKind::Spot {
            position: above,
            direction: Vec3::new(0.1, -1.0, 0.2).normalize(),
            inner_cone_rad: 1.0,
            outer_cone_rad: 1.2,
            range: f32::INFINITY,
        };
        let middle = bounds.min.lerp(bounds.max, 0.5);
        let lamps = [LightKind::Point { position: middle, range: f32::INFINITY }, spot];
        let lights = lamps.map(|kind| Light { kind, ..setup.light.clone() });
        for light in [&setup.light, &lights[0], &lights[1]] {
            for threads in [1, 3] {
                let setup = Setup { light: light.clone(), ..setup.clone() };
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
                pool.install(|| {
                    let label = format!("{name} {:?}, {threads} threads", light.kind);
                    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
                    let rays = session.render(&Technique::RAY).expect("frame");
                    for id in ["ray:light", "ray:dac", "alias-free"] {
                        let points = session.render(&technique(id)).expect("frame");
                        let different = count_different(&points.visibility, &rays.visibility, 0.0);
                        assert_eq!(different, 0, "{label} {id}");
                    }
                    let blocked = rays.visibility.iter().zip(&rays.doubt).filter(|(v, d)| **d && **v == 0.0);
                    assert!(blocked.count() > 20, "{label}: hardly anything is blocked");
                });
            }
        }
    }
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
            // Points need no tree, but triangles of vertices that have moved.
            let builds = id != "sm";
            assert_eq!(passes_of(&frame).contains(&PassKind::Build), builds, "{id}");
            let time = |kind| frame.passes.iter().find(|p| p.kind == kind).and_then(|p| p.ms);
            assert!(!builds || time(PassKind::Build).expect("is timed") > 0.0, "{id}");
        }
    }
}

/// `space` plants a tree where it stands for more than a frame, and keeps nothing elsewhere; on the GPU there is the tree alone.
#[test]
fn the_structure_in_light_space_is_chosen_by_what_stands() {
    let scene = builtin("square:6");
    let mut setup = Setup::for_scene(&scene, 160, 90);
    setup.packing.bakes_copies = true;
    let space = technique("ray:space");
    let mut session = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
    let truth = session.render(&Technique::RAY).expect("frame");
    let chosen = |session: &mut Session| {
        let frame = session.render(&space).expect("frame");
        assert_eq!(frame.visibility, truth.visibility);
        session.plan(&space).resolve
    };
    let playing = Sequence { is_played: true, ..Sequence::default() };
    assert_eq!(chosen(&mut session), Resolve::DivideAndConquer, "one frame");
    session.play(playing);
    assert_eq!(chosen(&mut session), Resolve::Light, "several");
    session.look(&setup.camera).expect("a view");
    session.relight(std::slice::from_ref(&setup.light)).expect("the same light");
    assert_eq!(chosen(&mut session), Resolve::Light, "a camera that moves");
    session.play(Sequence { objects_move: true, ..playing });
    assert_eq!(chosen(&mut session), Resolve::DivideAndConquer, "casters that move");
    session.play(Sequence { lights_move: true, ..playing });
    assert_eq!(chosen(&mut session), Resolve::DivideAndConquer, "a light that moves");
    session.play(playing);
    let moved = LightKind::Directional { direction: Vec3::new(0.1, -1.0, 0.2) };
    session.relight(&[Light { kind: moved, ..setup.light.clone() }]).expect("a light");
    assert_eq!(session.plan(&space).resolve, Resolve::DivideAndConquer, "a light that has moved");
    let upkeep = Upkeep::Refit;
    let mut session =
        Session::new(&scene, Setup { upkeep, ..setup.clone() }, BackendKind::Cpu).expect("session");
    session.play(playing);
    assert_eq!(chosen(&mut session), Resolve::DivideAndConquer, "what is made anew in every frame");
    for id in ["ray:light", "ray:dac", "alias-free"] {
        assert_eq!(session.plan(&technique(id)).resolve, technique(id).resolve, "asked for");
    }
    if let Some(mut gpu) = gpu_session(&scene, setup) {
        assert_eq!(gpu.plan(&space).resolve, Resolve::Light);
        gpu.render(&space).expect("frame");
    }
}

/// Rays, and what the light tree makes of them on the GPU.
const GPU_FAMILIES: [(&str, &str); 3] =
    [("ray", "ray:light"), ("ltt-evsm", "ltt-evsm:light"), ("lt-evsm", "lt-evsm:light")];

/// Renders two frames of each: masks of the second have learnt from the first. How many rays were blocked.
fn compare_on_gpu(gpu: &mut Session, label: &str) -> usize {
    let mut blocked = 0;
    for _ in 0..2 {
        for (rays, id) in GPU_FAMILIES {
            let rays = gpu.render(&technique(rays)).expect("frame");
            let points = gpu.render(&technique(id)).expect("frame");
            assert_eq!(count_different(&points.visibility, &rays.visibility, 0.0), 0, "{label} {id}");
            assert_eq!(points.rays, rays.rays, "{label} {id}");
            assert_eq!(points.doubt, rays.doubt, "{label} {id}");
            assert_eq!(points.packed_masks(), rays.packed_masks(), "{label} {id}");
            assert!(points.passes.iter().any(|p| p.kind == PassKind::LightTree), "{label} {id}");
            blocked += points.visibility.iter().zip(&points.doubt).filter(|(v, d)| **d && **v == 0.0).count();
        }
    }
    blocked
}

#[test]
fn the_light_tree_on_the_gpu_answers_as_the_traversal_kernel_does() {
    for name in ["cornell", "street:4", "square:6", "forest:12", "random:20000"] {
        let scene = builtin(name);
        let mut setup = Setup { map_size: 512, ..Setup::for_scene(&scene, 320, 180) };
        setup.packing.bakes_copies = true;
        let Some(mut gpu) = gpu_session(&scene, setup) else { return };
        let blocked = compare_on_gpu(&mut gpu, name);
        assert!(blocked > 1000, "{name}: {blocked} blocked");
    }
}

#[test]
fn lamps_and_several_lights_have_trees_of_their_own_on_the_gpu() {
    let scene = builtin("square:6");
    let bounds = scene.bounds();
    let middle = (bounds.min + bounds.max) * 0.5;
    let mut setup = Setup { map_size: 256, ..Setup::for_scene(&scene, 200, 112) };
    let lamp = LightKind::Point { position: middle, range: f32::INFINITY };
    let cone = LightKind::Spot {
        position: middle + Vec3::new(1.0, 4.0, -2.0),
        direction: Vec3::new(0.2, -1.0, 0.1).normalize(),
        range: f32::INFINITY,
        inner_cone_rad: 0.3,
        outer_cone_rad: 0.9,
    };
    let sun = setup.light.clone();
    let like_it = |kind| Light { kind, ..sun.clone() };
    setup.more_lights = vec![sun.clone(), like_it(cone)];
    setup.light = like_it(lamp);
    let Some(mut gpu) = gpu_session(&scene, setup) else { return };
    let blocked = compare_on_gpu(&mut gpu, "three lights");
    assert!(blocked > 1000, "{blocked} blocked");
}

/// The tree of the light and of the frame that the rays belong to: with lamps that move, and with several lights at once.
#[test]
fn hybrids_ask_the_tree_of_their_own_light_and_frame() {
    let scene = builtin("square:6");
    let bounds = scene.bounds();
    let at = |x: f32, y: f32| bounds.min + (bounds.max - bounds.min) * Vec3::new(x, y, 0.5);
    let sun = Setup::for_scene(&scene, 200, 112).light;
    let lamp = |x: f32, y: f32| Light {
        kind: LightKind::Point { position: at(x, y), range: f32::INFINITY },
        ..sun.clone()
    };
    let setup =
        Setup { map_size: 256, more_lights: vec![lamp(0.4, 0.7)], ..Setup::for_scene(&scene, 200, 112) };
    for (rays, by_tree) in [("ltt-evsm", "ltt-evsm:light"), ("lt-evsm", "lt-evsm:light")] {
        let mut session = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
        session.play(Sequence { is_played: true, lights_move: true, ..Sequence::default() });
        let mut rays_traced = 0;
        for frame in 0..4usize {
            let x = 0.4 + 0.1 * frame.div_ceil(2) as f32;
            session.relight(&[sun.clone(), lamp(x, 0.7)]).expect("lights");
            let by_tree = session.render(&technique(by_tree)).expect("frame");
            let by_rays = session.render(&technique(rays)).expect("frame");
            assert_eq!(
                count_different(&by_tree.visibility, &by_rays.visibility, 0.0),
                0,
                "{rays} frame {frame}"
            );
            assert_eq!(by_tree.rays, by_rays.rays, "{rays} frame {frame}");
            rays_traced += by_rays.rays;
        }
        assert!(rays_traced > 1000, "{rays}: {rays_traced}");
    }
}

/// Places that are in no scene's box, as an engine's G-buffer may have them, and trees that are kept and replaced.
#[test]
fn an_engine_plants_trees_and_may_ask_from_anywhere() {
    use lt_render::gpu::{Recorder, open};
    let Ok((_, device, queue)) = open() else {
        assert!(std::env::var_os(lt_tests::REQUIRE_GPU).is_none(), "no adapter");
        eprintln!("skipped: no GPU adapter");
        return;
    };
    let scene = builtin("street:4");
    let packed = PackedScene::new(&scene).expect("packed");
    let session = cpu_session(&scene, 64, 64);
    let job = session.job(&technique("ray:light"));
    let truth = session.job(&Technique::RAY);
    let bounds = packed.bounds();
    let size = bounds.max - bounds.min;
    // Three pixels of four lie outside of the box, and see the light through it.
    let place = |i: usize| {
        let at = Vec3::new(
            (i % 64) as f32 / 32.0 - 0.5,
            -((i / 4 % 8) as f32) * 0.4,
            (i / 64) as f32 / 32.0 - 0.5,
        );
        bounds.min + size * if i.is_multiple_of(4) { at.clamp(Vec3::ZERO, Vec3::ONE) } else { at }
    };
    let positions: Vec<[f32; 4]> = (0..64 * 64).map(|i| place(i).extend(0.0).to_array()).collect();
    let to_light = job.shadow.light.place.truncate();
    let normals = vec![to_light.extend(0.0).to_array(); 64 * 64];
    let positions = upload(&device, &queue, UVec2::splat(64), &positions);
    let normals = upload(&device, &queue, UVec2::splat(64), &normals);

    let mut recorder = Recorder::new(&device);
    let mut gpu_scene = recorder.upload(&packed).expect("fits");
    let draw = |recorder: &mut Recorder, gpu_scene: &GpuScene, job: &FrameJob| {
        let mut frame = recorder.frame_buffers(UVec2::splat(64))?;
        recorder.prepare(&mut frame, job)?;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let gbuffer = GBuffer { positions: &positions, normals: &normals, last_positions: None };
        recorder.import_gbuffer(&mut encoder, &mut frame, gbuffer)?;
        for kind in job.plan.passes() {
            recorder.pass(&mut encoder, gpu_scene, &frame, kind, job)?;
        }
        let target = visibility_texture(&device, 64, 64);
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        recorder.export_visibility(&mut encoder, &frame, &view)?;
        Ok::<_, RenderError>(download(&device, &queue, encoder, &target))
    };
    let error = draw(&mut recorder, &gpu_scene, &job).expect_err("nothing planted");
    assert!(error.to_string().contains("plant_light_tree"), "{error}");
    assert!(recorder.plant_light_tree(&mut gpu_scene, &packed, &job).expect("fits"));
    assert!(!recorder.plant_light_tree(&mut gpu_scene, &packed, &job).expect("kept"));
    let rays = draw(&mut recorder, &gpu_scene, &truth).expect("recorded");
    let points = draw(&mut recorder, &gpu_scene, &job).expect("recorded");
    assert_eq!(count_different(&points, &rays, 0.0), 0);
    let blocked = rays.iter().filter(|v| **v == 0.0).count();
    assert!(blocked > 100 && blocked < 4000, "{blocked} of 4096 blocked");
    // Another light: its tree takes the place of the last one.
    let mut other = job.clone();
    other.shadow.light.place = to_light.with_y(to_light.y * 2.0).normalize().extend(0.0);
    draw(&mut recorder, &gpu_scene, &other).expect_err("planted for another light");
    assert!(recorder.plant_light_tree(&mut gpu_scene, &packed, &other).expect("fits"));
    draw(&mut recorder, &gpu_scene, &other).expect("recorded");
    draw(&mut recorder, &gpu_scene, &job).expect_err("replaced");
}

#[test]
fn what_the_gpu_has_no_resolver_for_says_so() {
    let scene = builtin("cornell");
    let Some(mut gpu) = gpu_session(&scene, Setup::for_scene(&scene, 64, 48)) else { return };
    for id in ["ray:dac", "alias-free", "lt-evsm:dac"] {
        let error = gpu.render(&technique(id)).expect_err("none on the GPU");
        assert!(matches!(error, RenderError::Gpu { .. }), "{error}");
        assert!(
            error.to_string().contains("`light`") && error.to_string().contains("--backend cpu"),
            "{error}"
        );
    }
}
