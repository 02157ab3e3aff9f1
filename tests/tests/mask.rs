//! The temporal mask over several frames: exact where nothing moves, never worse than the doubt it corrects, and the same on
//! CPU and GPU.

use lt_render::{
    BackendKind, Frame, PassKind, Sequence, Session, Setup, Technique, metrics::Verdict, metrics::verdict,
    way_per_frame,
};
use lt_scene::{CameraPath, Scene, Source};
use lt_tests::{cpu_session, gpu_session, ppm, twin_ppm};
use std::collections::HashMap;

/// Every built-in place, small enough for a test.
const PLACES: [&str; 8] =
    ["street:6", "square:8", "forest:20", "town:40", "fence:12", "cornell", "random:3000", "hairball:40"];

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

/// False-lit and false-shadowed pixels.
fn wrong(session: &Session, truth: &Frame, frame: &Frame) -> [usize; 2] {
    let pixels = session.samples().iter().zip(truth.visibility.iter().zip(&frame.visibility));
    let verdicts: Vec<Verdict> =
        pixels.filter(|(s, _)| s.is_valid()).map(|(_, (t, v))| verdict(*t, *v)).collect();
    [Verdict::FalseLit, Verdict::FalseShadowed].map(|side| verdicts.iter().filter(|v| **v == side).count())
}

const STILL: Sequence = Sequence {
    is_played: true,
    camera_moves: false,
    objects_move: false,
    lights_move: false,
    starts_cold: false,
};
const MOVING: Sequence = Sequence {
    is_played: true,
    camera_moves: true,
    objects_move: false,
    lights_move: false,
    starts_cold: false,
};

fn open(name: &str, width: u32, height: u32, map_size: u32) -> (Source, Scene, Setup) {
    let source = Source::open(name, 1).expect("a place");
    let scene = source.pose(0.0).expect("a pose");
    let setup = Setup { map_size, ..Setup::for_scene(&scene, width, height) };
    (source, scene, setup)
}

#[test]
fn a_still_view_has_no_wrong_pixel_in_any_frame_and_never_flips() {
    for name in PLACES {
        let (_, scene, setup) = open(name, 240, 136, 128);
        let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
        session.play(STILL);
        let truth = session.render(&Technique::RAY).expect("frame");
        let mut had_work = false;
        for id in [
            "lt-vsm",
            "lt-esm",
            "lt-evsm",
            "lt-msm",
            "lt-msm-hausdorff",
            "lt-evsm:no-rr",
            "lt-evsm:pattern=plus",
            "lt-evsm:cascades=1",
            "lt-evsm:cascades=3:far=map",
        ] {
            let doubt = session.render(&technique(id.replace("lt-", "ltt-").split(':').next().unwrap_or("")));
            had_work |= wrong(&session, &truth, &doubt.expect("frame")) != [0, 0];
            let mut last: Option<Frame> = None;
            for frame_index in 0..6 {
                let frame = session.render(&technique(id)).expect("frame");
                assert_eq!(wrong(&session, &truth, &frame), [0, 0], "{name} {id} frame {frame_index}");
                match last {
                    None => assert_eq!(frame.rays, truth.rays, "{name} {id}: the start traces everything"),
                    Some(last) => {
                        assert_eq!(lt_render::flips(&last, &frame), 0, "{name} {id} frame {frame_index}");
                        assert!(frame.rays <= truth.rays);
                    }
                }
                last = Some(frame);
            }
        }
        assert!(had_work, "{name}: without a mask some pixel is wrong, else this shows nothing");
    }
}

/// Plays frames of a path; `each` gets the frame's number and every technique's frame, `ray` first.
fn play(name: &str, frames: usize, ids: &[&str], mut each: impl FnMut(usize, &Session, &[Frame])) {
    let (source, scene, setup) = open(name, 320, 180, 512);
    let mut session = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
    let path = source.camera_path(setup.camera.clone());
    let way = way_per_frame(&session, &path, 1.0);
    session.play(MOVING);
    for i in 0..frames {
        if i > 0 {
            session.look(&path.at(way * i as f32)).expect("a view");
        }
        let drawn: Vec<Frame> = std::iter::once("ray")
            .chain(ids.iter().copied())
            .map(|id| session.render(&technique(id)).expect("frame"))
            .collect();
        each(i, &session, &drawn);
    }
}

#[test]
fn in_motion_the_mask_never_errs_where_the_doubt_alone_does_not() {
    for name in ["street:6", "square:8", "fence:12", "random:3000"] {
        let (mut with, mut without) = (Vec::new(), Vec::new());
        play(name, 8, &["ltt-evsm", "lt-evsm"], |i, session, frames| {
            let [truth, doubt, mask] = frames else { panic!("three frames") };
            for (at, (t, (d, m))) in
                truth.visibility.iter().zip(doubt.visibility.iter().zip(&mask.visibility)).enumerate()
            {
                assert!(verdict(*t, *m) == Verdict::Right || m == d, "{name} frame {i} pixel {at}");
            }
            if i > 0 {
                with.push(wrong(session, truth, mask).iter().sum::<usize>());
                without.push(wrong(session, truth, doubt).iter().sum::<usize>());
            }
        });
        with.sort_unstable();
        without.sort_unstable();
        let (with, without) = (with[with.len() / 2], without[without.len() / 2]);
        assert!(without > 0, "{name}: nothing to mend");
        assert!(with * 2 <= without, "{name}: {with} wrong with the mask, {without} without");
    }
}

/// The comparison above must be able to fail: the published rule breaks it.
#[test]
fn the_published_removal_errs_where_the_doubt_alone_does_not() {
    let mut new_errors = 0;
    play("street:6", 8, &["ltt-evsm", "lt-evsm:published"], |_, _, frames| {
        let [truth, doubt, mask] = frames else { panic!("three frames") };
        let pixels = truth.visibility.iter().zip(doubt.visibility.iter().zip(&mask.visibility));
        new_errors += pixels.filter(|(t, (d, m))| verdict(**t, **m) != Verdict::Right && m != d).count();
    });
    assert!(new_errors > 0);
}

#[test]
fn a_kept_map_is_drawn_once_while_it_fits_and_every_frame_without_reuse() {
    for (id, maps) in [("lt-evsm:cascades=1", 1), ("lt-evsm", 3)] {
        let mut draws = 0;
        play("street:6", 6, &[id, &format!("{id}:no-reuse")], |i, _, frames| {
            draws += frames[1].map_draws;
            let has_drawn = frames[1].passes.iter().any(|p| p.kind == PassKind::DepthMap);
            assert_eq!(has_drawn, frames[1].map_draws > 0);
            assert!(i == 0 || frames[2].map_draws > 0, "{id} frame {i}");
        });
        assert!((1..=maps).contains(&draws), "{id}: {draws}");
    }
}

#[test]
fn needless_motion_vectors_change_no_bit() {
    let (_, scene, setup) = open("square:8", 200, 120, 256);
    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    let id = technique("lt-evsm:depth-test");
    let lean: Vec<Frame> = (0..3).map(|_| session.render(&id).expect("frame")).collect();
    session.play(Sequence::default());
    for expected in lean {
        let mut plan = session.plan(&id);
        plan.mask.as_mut().expect("a mask").motion = true;
        let forced = session.render_plan(&id, plan).expect("frame");
        assert_eq!(lt_render::flips(&expected, &forced), 0);
        assert_eq!((expected.rays, expected.mask), (forced.rays, forced.mask));
    }
}

#[test]
fn a_view_that_a_technique_missed_starts_it_anew() {
    let (source, scene, setup) = open("cornell", 120, 80, 256);
    let mut session = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
    let path: CameraPath = source.camera_path(setup.camera);
    session.play(MOVING);
    let id = technique("lt-evsm");
    let all = session.render(&Technique::RAY).expect("frame").rays;
    assert_eq!(session.render(&id).expect("frame").rays, all);
    assert!(session.render(&id).expect("frame").rays < all);
    session.look(&path.at(0.001)).expect("a view");
    session.look(&path.at(0.002)).expect("a view");
    let all = session.render(&Technique::RAY).expect("frame").rays;
    assert_eq!(session.render(&id).expect("frame").rays, all, "one view was missed");
}

/// Motion vectors of what moves: a pose that shifts everything with the camera is a still picture.
#[test]
fn what_moves_with_the_camera_keeps_its_history() {
    use lt_math::glam::{Affine3A, Vec3};
    let scene = lt_tests::builtin("cornell");
    let shift = Vec3::new(0.125, 0.0, 0.0625);
    let moved = |times: f32| {
        let mut scene = scene.clone();
        for instance in &mut scene.instances {
            instance.transform = Affine3A::from_translation(shift * times) * instance.transform;
            instance.is_dynamic = true;
        }
        scene
    };
    let setup = Setup { map_size: 256, ..Setup::for_scene(&scene, 160, 100) };
    let camera = |times: f32| lt_scene::Camera {
        eye: setup.camera.eye + shift * times,
        target: setup.camera.target + shift * times,
        ..setup.camera.clone()
    };
    let sequence = Sequence {
        is_played: true,
        camera_moves: true,
        objects_move: true,
        lights_move: false,
        starts_cold: false,
    };
    for kind in [BackendKind::Cpu, BackendKind::Gpu] {
        let mut session = match kind {
            BackendKind::Cpu => cpu_session(&moved(0.0), 160, 100),
            _ => match gpu_session(&moved(0.0), Setup::for_scene(&scene, 160, 100)) {
                Some(session) => session,
                None => return,
            },
        };
        session.play(sequence);
        let id = technique("lt-evsm:depth-test");
        session.render(&id).expect("frame");
        session.advance(&camera(1.0), &moved(1.0), &moved(0.0)).expect("a pose");
        let truth = session.render(&Technique::RAY).expect("frame");
        let frame = session.render(&id).expect("frame");
        assert!(frame.rays * 2 < truth.rays, "{kind}: {} of {} rays", frame.rays, truth.rays);
        // Told that nothing but the camera moved, the mask looks in the wrong place and finds other depths or edges.
        let blind = {
            let mut session = cpu_session(&moved(0.0), 160, 100);
            session.play(sequence);
            session.render(&id).expect("frame");
            session.advance(&camera(1.0), &moved(1.0), &moved(0.0)).expect("a pose");
            let mut plan = session.plan(&id);
            plan.object_motion = false;
            session.render_plan(&id, plan).expect("frame")
        };
        assert!(blind.rays > frame.rays, "{kind}: {} blind, {} seeing", blind.rays, frame.rays);
    }
}

/// A caster that swings out of the scene's box and back, as a skinned figure does at every step.
#[test]
fn maps_are_kept_once_they_have_seen_how_far_casters_swing() {
    use lt_math::glam::{Affine3A, Vec3};
    let scene = lt_tests::builtin("cornell");
    let last = scene.instances.len() - 1;
    let pose = |i: usize| {
        let mut scene = scene.clone();
        let height = 9.0 * (i as f32 * std::f32::consts::TAU / 6.0).sin().max(0.0);
        let instance = &mut scene.instances[last];
        instance.is_dynamic = true;
        instance.transform = Affine3A::from_translation(Vec3::Y * height) * instance.transform;
        scene
    };
    let (low, high) = (pose(0).bounds().max.y, pose(1).bounds().max.y);
    assert!(high > low, "it leaves the box: {high} over {low}");
    let mut session = cpu_session(&pose(0), 160, 100);
    session.play(Sequence {
        is_played: true,
        camera_moves: false,
        objects_move: true,
        lights_move: false,
        starts_cold: false,
    });
    let camera = session.setup().camera.clone();
    let mut draws = [0; 2];
    for i in 0..12 {
        if i > 0 {
            session.advance(&camera, &pose(i), &pose(i - 1)).expect("a pose");
        }
        let truth = session.render(&Technique::RAY).expect("frame");
        let frame = session.render(&technique("lt-evsm:cascades=2:far=map:map=512")).expect("frame");
        assert_eq!(wrong(&session, &truth, &frame), [0, 0], "frame {i}");
        draws[i / 6] += frame.map_draws;
    }
    assert!(draws[0] > 2 && draws[1] == 0, "{draws:?}");
}

/// How far a difference may be handed on in one frame: two pixels by the widest pattern, one by motion, one by rounding.
const REACH_PX: usize = 4;

/// Distance of two pixels, the larger of both axes.
fn distance(a: usize, b: usize, width: usize) -> usize {
    (a % width).abs_diff(b % width).max((a / width).abs_diff(b / width))
}

/// `forest` moves by itself, has holes and many placed trees; `advance` must agree on both backends and never err where
/// the doubt alone does not.
#[test]
fn things_that_move_in_an_alpha_tested_scene_are_followed() {
    let (source, scene, setup) = open("forest:12", 320, 200, 512);
    assert!(scene.instances.iter().any(|i| i.is_dynamic), "nothing moves");
    let mut sessions = vec![Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("CPU session")];
    sessions.extend(gpu_session(&scene, setup.clone()));
    let path = source.camera_path(setup.camera.clone());
    let way = way_per_frame(&sessions[0], &path, 1.0);
    let mut drawn = Vec::new();
    for session in &mut sessions {
        session.play(Sequence {
            is_played: true,
            camera_moves: true,
            objects_move: true,
            lights_move: false,
            starts_cold: false,
        });
        let mut before = scene.clone();
        for i in 0..4 {
            if i > 0 {
                let now = source.pose(i as f32 / 60.0).expect("a pose");
                session.advance(&path.at(way * i as f32), &now, &before).expect("a pose");
                before = now;
            }
            let truth = session.render(&Technique::RAY).expect("frame");
            let doubt = session.render(&technique("ltt-evsm")).expect("frame");
            let mask = session.render(&technique("lt-evsm")).expect("frame");
            let pixels = truth.visibility.iter().zip(doubt.visibility.iter().zip(&mask.visibility));
            for (at, (t, (d, m))) in pixels.enumerate() {
                assert!(verdict(*t, *m) == Verdict::Right || m == d, "frame {i} pixel {at}");
            }
            assert!(i == 0 || mask.rays * 10 < truth.rays * 9, "frame {i}: {} of {}", mask.rays, truth.rays);
            drawn.push(mask.visibility);
        }
    }
    let (cpu, gpu) = drawn.split_at(4);
    for (a, b) in cpu.iter().zip(gpu) {
        let sides = a.iter().zip(b).filter(|(x, y)| (**x >= 0.5) != (**y >= 0.5)).count();
        assert!(ppm(sides, a.len()) <= twin_ppm(), "{sides} pixels on the other side");
    }
}

#[test]
fn cpu_and_gpu_remember_the_same() {
    for name in ["cornell", "street:4", "square:6", "forest:12"] {
        let (source, scene, setup) = open(name, 640, 400, 512);
        let Some(mut gpu) = gpu_session(&scene, setup.clone()) else { return };
        let mut cpu = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
        let path = source.camera_path(setup.camera.clone());
        let way = way_per_frame(&cpu, &path, 1.0);
        for session in [&mut cpu, &mut gpu] {
            session.play(MOVING);
        }
        let mut last: HashMap<&str, Vec<usize>> = HashMap::new();
        let mut new_on_path: HashMap<&str, usize> = HashMap::new();
        for i in 0..5 {
            // The last two views are one: removal gets its turn.
            let camera = path.at(way * i.min(3) as f32);
            if i > 0 && i < 4 {
                cpu.look(&camera).expect("a view");
                gpu.look(&camera).expect("a view");
            }
            for id in [
                "lt-evsm",
                "lt-vsm:depth-test",
                "lt-esm",
                "lt-evsm:no-rr:moving=5x5",
                "lt-evsm:no-er:moving=diamond",
            ] {
                let (a, b) =
                    (cpu.render(&technique(id)).expect("CPU"), gpu.render(&technique(id)).expect("GPU"));
                assert_eq!(a.mask.len(), b.mask.len());
                let differ: Vec<usize> = (0..a.mask.len()).filter(|&k| a.mask[k] != b.mask[k]).collect();
                // ER hands one pixel's difference on to its neighbours, which then trace a ray more or less and find the
                // same truth: what counts as new lies far from all that differed in the last frame.
                let before = last.insert(id, differ.clone()).unwrap_or_default();
                let is_new = |k: &&usize| before.iter().all(|&j| distance(**k, j, 640) > REACH_PX);
                let new = differ.iter().filter(is_new).count();
                *new_on_path.entry(id).or_default() += new;
                // Twice the path's bound: one frame is few pixels.
                assert!(
                    ppm(new, a.mask.len()) <= 2.0 * twin_ppm(),
                    "{name} {id} frame {i}: {new} masks newly differ"
                );
                assert!(
                    differ.len() <= new + 25 * before.len(),
                    "{name} {id} frame {i}: {differ:?} after {before:?}"
                );
                let sides =
                    a.visibility.iter().zip(&b.visibility).filter(|(x, y)| (**x >= 0.5) != (**y >= 0.5));
                assert!(ppm(sides.count(), a.mask.len()) <= twin_ppm(), "{name} {id} frame {i}");
                assert_eq!(
                    a.passes.iter().map(|p| p.kind).collect::<Vec<_>>(),
                    b.passes.iter().map(|p| p.kind).collect::<Vec<_>>()
                );
            }
        }
        let pixels = 5 * cpu.samples().len();
        for (id, new) in new_on_path {
            assert!(ppm(new, pixels) <= twin_ppm(), "{name} {id}: {new} masks newly differ");
        }
    }
}
