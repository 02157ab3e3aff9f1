//! Lights that move: slowly, and the mask serves on without ever erring where the doubt alone does not; by a jump, and their
//! histories begin anew, but nobody else's.

use lt_math::glam::Vec3;
use lt_render::{
    BackendKind, Frame, Sequence, Session, Setup, Technique, metrics::Verdict, metrics::verdict,
};
use lt_scene::{Light, LightKind, Source};
use lt_tests::{builtin, gpu_session, ppm, twin_ppm};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

const MOVING: Sequence = Sequence {
    is_played: true,
    camera_moves: true,
    objects_move: false,
    lights_move: true,
    starts_cold: false,
};

/// Frames of `ray`, `ltt-evsm` and `lt-evsm` under a light that turns by so many degrees a frame, with or without the camera.
fn play(
    place: &str,
    light: Option<LightKind>,
    degrees: f32,
    way: f32,
    mut each: impl FnMut(usize, [Frame; 3]),
) {
    let source = Source::open(place, 1).expect("a place");
    let scene = source.pose(0.0).expect("a pose");
    let mut setup = Setup { map_size: 512, ..Setup::for_scene(&scene, 320, 180) };
    setup.light.kind = light.unwrap_or(setup.light.kind);
    let (start, center) = (setup.light.clone(), setup.camera.target);
    let path = source.camera_path(setup.camera.clone());
    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    session.play(MOVING);
    for i in 0..8 {
        if i > 0 {
            session.relight(&[start.turned(center, (degrees * i as f32).to_radians())]).expect("a light");
            session.look(&path.at(way * i as f32)).expect("a view");
        }
        each(i, ["ray", "ltt-evsm", "lt-evsm"].map(|id| session.render(&technique(id)).expect("frame")));
    }
}

#[test]
fn under_a_light_that_moves_slowly_the_mask_never_errs_where_the_doubt_alone_does_not() {
    let lamp = LightKind::Point { position: Vec3::new(3.0, 9.0, 6.0), range: f32::INFINITY };
    for (place, light, degrees, way) in [
        ("street:6", None, 0.1, 0.0),
        ("street:6", None, 0.5, 0.0005),
        ("square:8", None, 0.1, 0.0),
        ("fence:12", None, -0.3, 0.0),
        ("street:6", Some(lamp), 0.2, 0.0),
    ] {
        let (mut with, mut without, mut is_cheap) = (0, 0, true);
        play(place, light, degrees, way, |i, [truth, doubt, mask]| {
            let pixels = truth.visibility.iter().zip(doubt.visibility.iter().zip(&mask.visibility));
            for (at, (t, (d, m))) in pixels.enumerate() {
                assert!(verdict(*t, *m) == Verdict::Right || m == d, "{place} frame {i} pixel {at}");
                if i > 0 {
                    with += usize::from(verdict(*t, *m) != Verdict::Right);
                    without += usize::from(verdict(*t, *d) != Verdict::Right);
                }
            }
            is_cheap &= i == 0 || mask.rays * 4 < truth.rays * 3;
        });
        assert!(is_cheap, "{place}: the mask is kept");
        assert!(without > 0 && with * 2 <= without, "{place}: {with} wrong with the mask, {without} without");
    }
}

#[test]
fn a_light_that_jumps_begins_anew_and_the_others_go_on() {
    let scene = builtin("street:6");
    let suns = [Vec3::new(0.4, -1.0, -0.3), Vec3::new(-0.5, -0.8, 0.2)].map(Light::sun);
    let lamp = |x| Light {
        kind: LightKind::Point { position: Vec3::new(x, 6.0, 0.0), range: f32::INFINITY },
        ..suns[0].clone()
    };
    let setup = Setup {
        light: suns[0].clone(),
        more_lights: vec![suns[1].clone(), lamp(0.0)],
        map_size: 256,
        ..Setup::for_scene(&scene, 240, 136)
    };
    let mut sessions = vec![Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("CPU session")];
    sessions.extend(gpu_session(&scene, setup));
    for mut session in sessions {
        session.play(Sequence { camera_moves: false, ..MOVING });
        let id = technique("lt-evsm");
        let jump = |session: &mut Session, lights: [Light; 3], jumping: Option<usize>| {
            session.relight(&lights).expect("lights");
            let truth = session.render(&Technique::RAY).expect("frame");
            let frame = session.render(&id).expect("frame");
            for (i, (t, f)) in truth.lights.iter().zip(&frame.lights).enumerate() {
                let is_new = jumping.is_none_or(|j| j == i);
                assert_eq!(f.rays == t.rays, is_new, "light {i}: {} of {} rays", f.rays, t.rays);
                assert_eq!(f.map_draws > 0, is_new, "light {i}: {} maps", f.map_draws);
                assert_eq!(f.visibility, t.visibility, "light {i}");
            }
        };
        let [first, second] = suns.clone();
        jump(&mut session, [first.clone(), second.clone(), lamp(0.0)], None);
        let turned = first.turned(Vec3::ZERO, 0.5);
        jump(&mut session, [turned.clone(), second.clone(), lamp(0.0)], Some(0));
        jump(&mut session, [turned.clone(), second.clone(), lamp(4.0)], Some(2));
        // Nothing jumps: all histories serve.
        session.relight(&[turned, second, lamp(4.0)]).expect("lights");
        let settled = session.render(&id).expect("frame");
        assert_eq!(settled.map_draws, 0);
        assert!(settled.rays * 2 < session.render(&Technique::RAY).expect("frame").rays);
        assert!(session.relight(&suns).is_err(), "as many lights as before");
    }
}

#[test]
fn cpu_and_gpu_agree_under_a_moving_sun() {
    let scene = builtin("street:4");
    let setup = Setup { map_size: 512, ..Setup::for_scene(&scene, 320, 200) };
    let Some(mut gpu) = gpu_session(&scene, setup.clone()) else { return };
    let mut cpu = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
    for i in 0..5 {
        let light = setup.light.turned(Vec3::ZERO, 0.003 * i as f32);
        let [a, b] = [&mut cpu, &mut gpu].map(|session| {
            if i == 0 {
                session.play(Sequence { camera_moves: false, ..MOVING });
            }
            session.relight(std::slice::from_ref(&light)).expect("a light");
            session.render(&technique("lt-evsm")).expect("frame")
        });
        let sides =
            a.visibility.iter().zip(&b.visibility).filter(|(x, y)| (**x >= 0.5) != (**y >= 0.5)).count();
        assert!(ppm(sides, a.visibility.len()) <= twin_ppm(), "frame {i}: {sides} pixels");
        assert!(a.rays.abs_diff(b.rays) < 50, "frame {i}: {} and {} rays", a.rays, b.rays);
    }
}
