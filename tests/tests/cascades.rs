//! Cascades: no seam between levels, no doubt at their edges, only what left its box is drawn anew.

use lt_math::glam::{Affine3A, Vec3};
use lt_render::{BackendKind, Sequence, Session, Setup, Technique};
use lt_scene::{Camera, Light, Material, Mesh, Scene, Source};
use lt_tests::{cpu_session, gpu_session};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

/// A square of this half-size at height y, facing up.
fn square(y: f32, half: f32) -> Mesh {
    let corner = |x: f32, z: f32| Vec3::new(x * half, y, z * half);
    Mesh {
        positions: vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)],
        indices: vec![0, 1, 2, 0, 2, 3],
        ..Mesh::default()
    }
}

/// A plain that the camera sees from its feet to far away; a roof, if any, shades all that is in view.
fn plain(has_roof: bool, sun: Vec3) -> (Scene, Setup) {
    let mut scene =
        Scene { materials: vec![Material::opaque("plain", Vec3::splat(0.5))], ..Scene::default() };
    scene.place(square(0.0, 200.0), Affine3A::IDENTITY);
    let roof = if has_roof { square(30.0, 800.0) } else { square(30.0, 1.0) };
    scene.place(roof, Affine3A::from_translation(Vec3::new(0.0, 0.0, if has_roof { 0.0 } else { 900.0 })));
    let camera = Camera {
        name: String::new(),
        eye: Vec3::new(0.0, 2.0, 0.0),
        target: Vec3::new(40.0, 0.5, -100.0),
        up: Vec3::Y,
        fov_y_rad: 1.0,
    };
    let setup = Setup { camera, light: Light::sun(sun), map_size: 256, ..Setup::for_scene(&scene, 320, 200) };
    (scene, setup)
}

const SUNS: [Vec3; 3] = [Vec3::NEG_Y, Vec3::new(0.3, -1.0, -0.2), Vec3::new(-1.0, -0.6, 0.7)];

#[test]
fn no_line_of_light_or_shade_runs_between_levels() {
    for sun in SUNS {
        for has_roof in [false, true] {
            let (scene, setup) = plain(has_roof, sun);
            let cpu = Session::new(&scene, setup.clone(), BackendKind::Cpu).expect("session");
            for mut session in std::iter::once(cpu).chain(gpu_session(&scene, setup)) {
                let truth = session.render(&technique("ray")).expect("frame").visibility;
                for id in [
                    "sm:cascades=5",
                    "pcf:cascades=5",
                    "vsm:cascades=5",
                    "evsm:cascades=4",
                    "evsm:splits=3/9/27",
                ] {
                    let frame = session.render(&technique(id)).expect("frame");
                    let wrong = truth
                        .iter()
                        .zip(&frame.visibility)
                        .filter(|(t, v)| (**t >= 0.5) != (**v >= 0.5))
                        .count();
                    assert_eq!(wrong, 0, "{id} sun {sun} roof {has_roof}");
                }
                for id in ["ltt-evsm:cascades=5:far=map", "ltt-vsm:cascades=3:far=map"] {
                    let frame = session.render(&technique(id)).expect("frame");
                    assert_eq!(frame.rays, 0, "{id} sun {sun} roof {has_roof}: every pixel lies on a level");
                    let wrong = truth.iter().zip(&frame.visibility).filter(|(t, v)| t != v).count();
                    assert_eq!(wrong, 0, "{id} sun {sun} roof {has_roof}");
                }
            }
        }
    }
}

#[test]
fn rays_answer_all_that_lies_on_no_level() {
    let (scene, setup) = plain(true, SUNS[1]);
    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
    let truth = session.render(&technique("ray")).expect("frame");
    let near = session.render(&technique("ltt-evsm:splits=5/10")).expect("frame");
    assert!(near.rays > 0 && near.rays < truth.rays, "{} of {}", near.rays, truth.rays);
    assert_eq!(near.map_draws, 2);
    assert_eq!(truth.visibility, near.visibility);
}

/// Every caster counts, wherever it stands: behind the camera, above the view, beside it.
#[test]
fn casters_out_of_sight_keep_their_shadows() {
    for sun in [Vec3::new(0.4, -0.5, -1.0), Vec3::new(-0.4, -0.2, 1.0)] {
        let (mut scene, setup) = plain(false, sun);
        scene.place(
            square(60.0, 25.0),
            Affine3A::from_translation(-sun * 120.0 + Vec3::new(20.0, 0.0, -60.0)),
        );
        let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
        let truth = session.render(&technique("ray")).expect("frame");
        assert!(truth.visibility.iter().filter(|v| **v == 0.0).count() > 100, "something is shaded");
        let frame = session.render(&technique("lt-evsm:cascades=4:far=map")).expect("frame");
        assert_eq!(truth.visibility, frame.visibility);
    }
}

#[test]
fn turning_on_the_spot_draws_little_and_stays_right() {
    let source = Source::open("street:6", 1).expect("a place");
    let scene = source.pose(0.0).expect("a pose");
    let mut session = cpu_session(&scene, 240, 136);
    session.play(Sequence {
        is_played: true,
        camera_moves: true,
        objects_move: false,
        lights_move: false,
        starts_cold: false,
    });
    let camera = session.setup().camera.clone();
    let way = camera.target - camera.eye;
    let (mut kept, mut drawn) = (0, 0);
    for i in 0..12 {
        if i > 0 {
            let turn = lt_math::glam::Quat::from_rotation_y(0.004 * i as f32);
            session.look(&Camera { target: camera.eye + turn * way, ..camera.clone() }).expect("a view");
        }
        kept += session.render(&technique("ltt-evsm:cascades=3:far=map:map=512")).expect("frame").map_draws;
        drawn += session
            .render(&technique("ltt-evsm:cascades=3:far=map:map=512:no-reuse"))
            .expect("frame")
            .map_draws;
    }
    assert_eq!(drawn, 36);
    assert!((3..=9).contains(&kept), "{kept} maps drawn");
}
