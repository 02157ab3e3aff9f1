//! Several lights in one frame: each as it would be alone, masks packed side by side, pictures summed, CPU like GPU.

use lt_math::glam::Vec3;
use lt_render::{BackendKind, CompareOptions, RenderError, Sequence, Session, Setup, Technique};
use lt_scene::{Light, LightKind};
use lt_tests::{builtin, gpu_session};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

/// Twelve lights of all kinds: the eleventh's bits straddle two words.
fn lights() -> Vec<Light> {
    let light = |kind| Light { kind, ..Light::sun(Vec3::NEG_Y) };
    (0..12)
        .map(|i| {
            let turn = i as f32 * 0.9;
            let position = Vec3::new(1.6 * turn.cos(), 3.0 + 0.15 * i as f32, 1.6 * turn.sin());
            match i % 3 {
                0 => light(LightKind::Point { position, range: f32::INFINITY }),
                1 => Light::sun(Vec3::new(turn.cos(), -1.0, turn.sin() - 1.5)),
                _ => light(LightKind::Spot {
                    position,
                    direction: (Vec3::new(0.0, 0.5, 0.0) - position).normalize(),
                    inner_cone_rad: 0.2,
                    outer_cone_rad: 0.7,
                    range: 20.0,
                }),
            }
        })
        .collect()
}

fn setup(scene: &lt_scene::Scene, lights: &[Light]) -> Setup {
    Setup {
        light: lights[0].clone(),
        more_lights: lights[1..].to_vec(),
        map_size: 256,
        ..Setup::for_scene(scene, 160, 100)
    }
}

const STILL: Sequence = Sequence {
    is_played: true,
    camera_moves: false,
    objects_move: false,
    lights_move: false,
    starts_cold: false,
};

#[test]
fn every_light_is_as_it_would_be_alone() {
    let scene = builtin("cornell");
    let lights = lights();
    let together = setup(&scene, &lights);
    let mut sessions = vec![Session::new(&scene, together.clone(), BackendKind::Cpu).expect("CPU session")];
    sessions.extend(gpu_session(&scene, together.clone()));
    for mut session in sessions {
        let backend = session.backend_name();
        session.play(STILL);
        let ids = ["ray", "evsm", "ltt-evsm", "lt-evsm", "lt-msm"];
        let mut frames = Vec::new();
        for _ in 0..3 {
            frames.push(ids.map(|id| session.render(&technique(id)).expect("frame")));
        }
        let mut rays = [[0; 5]; 3];
        for (number, light) in lights.iter().enumerate() {
            let alone = Setup { light: light.clone(), more_lights: Vec::new(), ..together.clone() };
            let kind = if backend == "cpu" { BackendKind::Cpu } else { BackendKind::Gpu };
            let mut session = Session::new(&scene, alone, kind).expect("session");
            session.play(STILL);
            for (i, frames) in frames.iter().enumerate() {
                for (k, (id, frame)) in ids.iter().zip(frames).enumerate() {
                    let expected = session.render(&technique(id)).expect("frame");
                    let found = &frame.lights[number];
                    let place = format!("{backend} light {number} {id} frame {i}");
                    assert!(found.visibility == expected.visibility, "{place}: visibility");
                    assert!(found.mask == expected.mask && found.doubt == expected.doubt, "{place}: mask");
                    assert_eq!((found.rays, found.map_draws), (expected.rays, expected.map_draws), "{place}");
                    rays[i][k] += expected.rays;
                }
            }
        }
        for (i, frames) in frames.iter().enumerate() {
            for (k, frame) in frames.iter().enumerate() {
                assert_eq!((frame.lights.len(), frame.rays), (12, rays[i][k]));
                let packed = frame.packed_masks();
                assert_eq!(packed.len(), if k < 3 { 0 } else { 160 * 100 });
                for (number, light) in frame.lights.iter().enumerate() {
                    let unpacked = packed.iter().map(|p| p.light(number as u32));
                    assert!(unpacked.eq(light.mask.iter().copied()), "{backend} light {number}");
                }
            }
        }
        assert!(frames[2][3].rays * 2 < frames[2][0].rays, "the mask saves rays for all lights together");
    }
}

#[test]
fn a_picture_sums_up_its_lights_and_errors_are_counted_light_by_light() {
    let scene = builtin("cornell");
    let lights = &lights()[..3];
    let together = setup(&scene, lights);
    let mut sessions = vec![Session::new(&scene, together.clone(), BackendKind::Cpu).expect("CPU session")];
    sessions.extend(gpu_session(&scene, together.clone()));
    let mut pictures = Vec::new();
    for session in &mut sessions {
        let truth = session.render(&Technique::RAY).expect("frame");
        let picture = session.shade(&truth).expect("picture");
        for dark in 0..3 {
            let mut less = truth.clone();
            less.lights[dark].visibility.fill(0.0);
            let darker = session.shade(&less).expect("picture");
            let channels = || picture.iter().flatten().zip(darker.iter().flatten());
            assert!(channels().all(|(a, b)| a >= b), "no pixel grows brighter without light {dark}");
            assert!(channels().filter(|(a, b)| a > b).count() > 1000, "light {dark} is seen");
        }
        pictures.push(picture);
    }
    if let [cpu, gpu] = &pictures[..] {
        let far = cpu.iter().flatten().zip(gpu.iter().flatten()).filter(|(a, b)| a.abs_diff(**b) > 1).count();
        assert!(far <= 10, "{far} bytes differ by more than one step");
    }
    let options = CompareOptions { repeats: 1, with_flip: false };
    let never = std::sync::atomic::AtomicBool::new(false);
    let comparison = lt_render::compare(
        &mut sessions[0],
        &[technique("evsm"), Technique::RAY],
        &options,
        &never,
        |_, _, _| {},
    )
    .expect("a comparison");
    let [map, ray] = &comparison.rows[..] else { panic!("two rows") };
    assert_eq!((map.lights.len(), ray.lights.len()), (3, 3));
    let sum: u64 = map.lights.iter().map(|l| l.errors.false_lit + l.errors.false_shadowed).sum();
    assert!(sum > 0 && map.errors.false_lit + map.errors.false_shadowed == sum);
    assert_eq!(map.errors.valid, 3 * comparison.valid_pixels);
    assert_eq!(ray.lights.iter().map(|l| l.rays).sum::<u64>(), ray.frame.rays);
}

/// A light's share of the picture is its share of the intensity; what all of them have in common changes nothing.
#[test]
fn lights_shade_in_proportion_to_their_intensities() {
    let scene = builtin("cornell");
    let picture = |intensities: [f32; 2]| {
        let mut two = [lights()[1].clone(), lights()[4].clone()];
        (two[0].color, two[1].color) = (Vec3::X, Vec3::Z);
        for (light, intensity) in two.iter_mut().zip(intensities) {
            light.intensity = intensity;
        }
        let mut session = Session::new(&scene, setup(&scene, &two), BackendKind::Cpu).expect("CPU session");
        let truth = session.render(&Technique::RAY).expect("frame");
        session.shade(&truth).expect("picture")
    };
    let sums = |picture: Vec<[u8; 4]>| {
        picture.iter().fold([0, 0], |[r, b], p| [r + u64::from(p[0]), b + u64::from(p[2])])
    };
    let [even, red, blue] = [[1.0, 1.0], [3.0, 1.0], [1.0, 3.0]].map(|of| sums(picture(of)));
    assert!(
        red[0] > even[0] && red[1] < even[1] && blue[0] < even[0] && blue[1] > even[1],
        "{even:?} {red:?} {blue:?}"
    );
    assert_eq!(picture([2.0, 2.0]), picture([8.0, 8.0]));
    let dark = sums(picture([0.0, 0.0]));
    assert!(dark[0] < blue[0] && dark[1] < red[1], "only what falls in from everywhere: {dark:?}");
}

#[test]
fn more_lights_than_a_mask_holds_are_refused() {
    let scene = builtin("cornell");
    let with = |count| setup(&scene, &vec![Light::sun(Vec3::NEG_Y); count]);
    assert!(with(42).check().is_ok());
    let Err(RenderError::BadSetup(problem)) = with(43).check() else { panic!("refused") };
    assert!(problem.contains("43") && problem.contains("42"), "{problem}");
    let mut bad = with(3);
    bad.more_lights[1].kind = LightKind::Directional { direction: Vec3::ZERO };
    assert!(bad.check().is_err(), "every light is checked");
}
