//! Several samples per pixel: all passes run on them, on CPU and GPU, and pictures are their mean.

use lt_render::{BackendKind, SampleGrid, Sequence, Session, Setup, Technique, metrics};
use lt_scene::Scene;
use lt_tests::{builtin, count_different, gpu_session, ppm, twin_ppm};

fn setup(scene: &Scene, size: [u32; 2], samples: u32) -> Setup {
    let samples = SampleGrid::of(samples).expect("a grid");
    Setup { samples, map_size: 512, ..Setup::for_scene(scene, size[0], size[1]) }
}

fn session(scene: &Scene, size: [u32; 2], samples: u32) -> Session {
    Session::new(scene, setup(scene, size, samples), BackendKind::Cpu).expect("session")
}

fn wrong(session: &mut Session, truth: &[f32], id: &str) -> (u64, u64) {
    let frame = session.render(&id.parse().expect("id")).expect("frame");
    let valid: Vec<bool> = session.samples().iter().map(|s| s.is_valid()).collect();
    let size = session.setup().size_in_samples().to_array();
    let errors = metrics::errors(size, &valid, truth, &frame.visibility);
    (errors.false_lit + errors.false_shadowed, frame.rays)
}

/// Four samples of each pixel see what the pixels of a picture of twice the size see, through other points of them.
#[test]
fn samples_are_a_finer_picture_of_the_same() {
    let scene = builtin("street:4");
    let (one, four) = (session(&scene, [320, 200], 1), session(&scene, [160, 100], 4));
    assert_eq!((one.samples().len(), four.samples().len()), (320 * 200, 320 * 200));
    let eye = one.setup().camera.eye;
    let near = one.samples().iter().zip(four.samples()).filter(|(a, b)| {
        let (step, far) = (a.position.distance(b.position), a.position.distance(eye));
        a.is_valid() == b.is_valid() && (!a.is_valid() || step < 0.03 * far)
    });
    assert!(near.count() > 320 * 200 * 9 / 10);
    let same = one.samples().iter().zip(four.samples()).filter(|(a, b)| a.is_valid() && a == b).count();
    assert_eq!(same, 0, "but through other points");
}

/// Maps err and tests mend them with a fraction of the rays, sample by sample as pixel by pixel.
#[test]
fn techniques_keep_their_bounds_at_four_samples() {
    for name in ["cornell", "street:4", "square:6"] {
        let mut session = session(&builtin(name), [160, 100], 4);
        let truth = session.render(&Technique::RAY).expect("frame");
        for id in ["vsm", "esm", "evsm", "msm", "msm-hausdorff"] {
            let (map, _) = wrong(&mut session, &truth.visibility, id);
            let (hybrid, rays) = wrong(&mut session, &truth.visibility, &format!("ltt-{id}"));
            assert!(map > 0 && hybrid < map, "{name} {id}: {map} → {hybrid}");
            assert!(rays > 0 && rays < truth.rays, "{name} {id}: {rays} of {} rays", truth.rays);
        }
    }
}

#[test]
fn resolvers_in_light_space_answer_as_rays_do_for_all_samples() {
    for name in ["street:4", "square:6"] {
        for samples in [4, 32] {
            let size = if samples == 4 { [160, 90] } else { [64, 36] };
            let mut session = session(&builtin(name), size, samples);
            let mut frame = |id: &str| session.render(&id.parse().expect("id")).expect("frame");
            for (rays, others) in [
                ("ray", ["ray:light", "ray:dac", "alias-free"]),
                ("lt-evsm", ["lt-evsm:light", "lt-evsm:dac", "lt-evsm:alias-free"]),
            ] {
                let rays = frame(rays);
                for id in others {
                    let points = frame(id);
                    assert!(points.visibility == rays.visibility, "{name}, {samples} samples, {id}");
                    assert!(
                        points.rays == rays.rays && points.mask == rays.mask,
                        "{name}, {samples} samples, {id}"
                    );
                }
            }
        }
    }
}

#[test]
fn cpu_and_gpu_agree_at_four_samples() {
    for name in ["street:4", "forest:12"] {
        let scene = builtin(name);
        let Some(mut gpu) = gpu_session(&scene, setup(&scene, [160, 100], 4)) else { return };
        let mut cpu = session(&scene, [160, 100], 4);
        let samples = cpu.samples().len();
        assert_eq!(samples, 320 * 200);
        for id in ["ray", "sm", "pcf", "evsm", "msm", "ltt-vsm", "ltt-evsm", "ltt-msm", "lt-evsm", "lt-msm"] {
            let technique: Technique = id.parse().expect("id");
            for session in [&mut cpu, &mut gpu] {
                session.play(Sequence { is_played: true, camera_moves: true, ..Sequence::default() });
            }
            // The second frame of the same view has a history.
            for _ in 0..2 {
                let (a, b) = (cpu.render(&technique).expect("frame"), gpu.render(&technique).expect("frame"));
                let lit = |v: &[f32]| v.iter().map(|v| f32::from(u8::from(*v >= 0.5))).collect::<Vec<_>>();
                let wrong = count_different(&lit(&a.visibility), &lit(&b.visibility), 0.0);
                let doubts = a.doubt.iter().zip(&b.doubt).filter(|(a, b)| a != b).count();
                assert!(
                    ppm(wrong.max(doubts), samples) <= twin_ppm(),
                    "{name} {id}: {wrong}, {doubts} doubts"
                );
            }
        }
        let frame = cpu.render(&Technique::RAY).expect("frame");
        let (a, b) = (cpu.shade(&frame).expect("picture"), gpu.shade(&frame).expect("picture"));
        assert_eq!((a.len(), b.len()), (160 * 100, 160 * 100));
        let bytes = |p: &[[u8; 4]]| p.iter().flatten().map(|v| f32::from(*v)).collect::<Vec<_>>();
        let wrong = count_different(&bytes(&a), &bytes(&b), 1.0);
        assert!(
            ppm(wrong, a.len() * 4) <= twin_ppm() * 5.0,
            "{name}: {wrong} bytes differ by more than a step"
        );
    }
}

#[test]
fn the_light_tree_on_the_gpu_answers_as_rays_do_for_all_samples() {
    let scene = builtin("square:6");
    let mut view = setup(&scene, [120, 80], 8);
    view.packing.bakes_copies = true;
    let Some(mut gpu) = gpu_session(&scene, view) else { return };
    let mut frame = |id: &str| gpu.render(&id.parse().expect("id")).expect("frame");
    for (rays, points) in [("ray", "ray:light"), ("ltt-evsm", "ltt-evsm:light")] {
        let (rays, points) = (frame(rays), frame(points));
        assert_eq!(count_different(&points.visibility, &rays.visibility, 0.0), 0);
        assert!(points.rays == rays.rays && rays.rays > 1000);
    }
}

/// Looking on from the same place moves nothing, although samples lie off the middle of their cells: rays stay removed, and
/// nothing is wrong.
#[test]
fn a_still_view_moves_no_sample() {
    let scene = builtin("square:6");
    for backend in [BackendKind::Cpu, BackendKind::Gpu] {
        let view = setup(&scene, [160, 90], 8);
        let mut session = match backend {
            BackendKind::Gpu => match gpu_session(&scene, view) {
                Some(session) => session,
                None => return,
            },
            _ => Session::new(&scene, view, backend).expect("session"),
        };
        session.play(Sequence { is_played: true, camera_moves: true, ..Sequence::default() });
        let camera = session.setup().camera.clone();
        let technique: Technique = "lt-evsm".parse().expect("id");
        let mut rays = Vec::new();
        for frame in 0..4 {
            if frame > 0 {
                session.look(&camera).expect("view");
            }
            let truth = session.render(&Technique::RAY).expect("frame");
            let hybrid = session.render(&technique).expect("frame");
            assert_eq!(
                count_different(&hybrid.visibility, &truth.visibility, 0.0),
                0,
                "{backend} frame {frame}"
            );
            rays.push(hybrid.rays);
        }
        assert!(rays[3] < rays[0] / 2, "{backend}: {rays:?}");
    }
}

/// Where the camera moves, samples find their past as pixels do: most histories are found, and few samples are wrong.
#[test]
fn samples_are_followed_as_the_camera_moves() {
    let scene = builtin("street:4");
    let mut session = session(&scene, [160, 90], 4);
    session.play(Sequence { is_played: true, camera_moves: true, ..Sequence::default() });
    let start = session.setup().camera.clone();
    let technique: Technique = "lt-evsm".parse().expect("id");
    let mut shares = Vec::new();
    for frame in 0..6 {
        let mut camera = start.clone();
        camera.eye.x += frame as f32 * 0.01;
        camera.target.x += frame as f32 * 0.01;
        session.look(&camera).expect("view");
        let truth = session.render(&Technique::RAY).expect("frame");
        let hybrid = session.render(&technique).expect("frame");
        let test = session.render(&"ltt-evsm".parse().expect("id")).expect("frame");
        let wrong = |f: &lt_render::Frame| count_different(&f.visibility, &truth.visibility, 0.0);
        assert!(wrong(&hybrid) <= wrong(&test), "frame {frame}");
        shares.push(hybrid.rays as f64 / truth.rays as f64);
    }
    assert!(shares[5] < 0.5, "{shares:?}");
}

/// More samples bring the picture nearer to one of many.
#[test]
fn pictures_converge_as_samples_grow() {
    let scene = builtin("square:6");
    let picture = |samples: u32| {
        let mut session = session(&scene, [120, 68], samples);
        let frame = session.render(&Technique::RAY).expect("frame");
        session.shade(&frame).expect("picture")
    };
    let last = picture(32);
    let off = |samples: u32| {
        let bytes =
            picture(samples).into_iter().flatten().zip(last.iter().flatten().copied()).collect::<Vec<_>>();
        bytes.iter().map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum::<f64>() / bytes.len() as f64
    };
    let [one, four, sixteen] = [1, 4, 16].map(off);
    assert!(four < one / 2.5 && sixteen < four / 2.5, "{one}, {four}, {sixteen}");
}

#[test]
fn too_many_samples_are_refused_with_size_and_remedy() {
    let scene = builtin("cornell");
    let fits = setup(&scene, [1920, 1080], 32).check();
    assert!(fits.is_ok(), "{fits:?}");
    let error = setup(&scene, [1921, 1093], 32).check().expect_err("too many").to_string();
    assert!(["1921×1093", "32 samples", "GiB", "fewer samples"].iter().all(|w| error.contains(w)), "{error}");
}
