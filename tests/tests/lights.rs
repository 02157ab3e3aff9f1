//! Spot and point lights: exact where rays answer, no seam between faces, nothing beyond cone and range, CPU like GPU.

use lt_math::glam::{Affine3A, Vec3};
use lt_render::{BackendKind, Frame, Sequence, Session, Setup, Technique};
use lt_scene::{Camera, Light, LightKind, Material, Mesh, Scene};
use lt_tests::{builtin, gpu_session, ppm, twin_ppm};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

fn light(kind: LightKind) -> Light {
    Light { kind, ..Light::sun(Vec3::NEG_Y) }
}

fn point(x: f32, y: f32, z: f32) -> LightKind {
    LightKind::Point { position: Vec3::new(x, y, z), range: f32::INFINITY }
}

fn spot(position: [f32; 3], at: [f32; 3], degrees: f32) -> LightKind {
    let (position, at) = (Vec3::from(position), Vec3::from(at));
    LightKind::Spot {
        position,
        direction: (at - position).normalize(),
        inner_cone_rad: 0.0,
        outer_cone_rad: degrees.to_radians(),
        range: f32::INFINITY,
    }
}

/// A box of this half-size around a point, seen from both sides.
fn cube(at: Vec3, half: f32) -> Mesh {
    let positions =
        (0..8).map(|i| at + half * Vec3::new(sign(i & 1), sign(i >> 1 & 1), sign(i >> 2 & 1))).collect();
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let indices = faces.iter().flat_map(|f| [f[0], f[1], f[2], f[0], f[2], f[3]]).collect();
    Mesh { positions, indices, ..Mesh::default() }
}

fn sign(bit: usize) -> f32 {
    if bit == 0 { -1.0 } else { 1.0 }
}

/// A closed room of half-size 5 seen from a corner; `lid`, if any, is the half-size of a box around the lamp.
fn room(lamp: Vec3, lid: Option<f32>) -> (Scene, Setup) {
    let mut scene = Scene { materials: vec![Material::opaque("wall", Vec3::splat(0.5))], ..Scene::default() };
    scene.place(cube(Vec3::ZERO, 5.0), Affine3A::IDENTITY);
    if let Some(half) = lid {
        scene.place(cube(lamp, half), Affine3A::IDENTITY);
    }
    let camera = Camera {
        name: String::new(),
        eye: Vec3::new(4.5, 4.3, 4.6),
        target: Vec3::new(-1.0, -1.5, -1.2),
        up: Vec3::Y,
        fov_y_rad: 1.6,
    };
    let kind = LightKind::Point { position: lamp, range: f32::INFINITY };
    let setup = Setup { camera, light: light(kind), map_size: 256, ..Setup::for_scene(&scene, 240, 160) };
    (scene, setup)
}

fn sessions(scene: &Scene, setup: &Setup) -> Vec<Session> {
    let cpu = Session::new(scene, setup.clone(), BackendKind::Cpu).expect("CPU session");
    std::iter::once(cpu).chain(gpu_session(scene, setup.clone())).collect()
}

/// Whether a point of the room lies so near to an edge that texels see both its walls: there a map errs as any map does.
fn is_at_an_edge(p: Vec3) -> bool {
    let a = p.abs();
    a.x + a.y + a.z - a.max_element() - a.min_element() > 4.8
}

/// Pixels that two frames put on different sides.
fn other_side(a: &Frame, b: &Frame) -> usize {
    a.visibility.iter().zip(&b.visibility).filter(|(a, b)| (**a >= 0.5) != (**b >= 0.5)).count()
}

/// Pixels away from the room's edges that two frames put on different sides.
fn differing(session: &Session, a: &Frame, b: &Frame) -> usize {
    let pixels = session.samples().iter().zip(a.visibility.iter().zip(&b.visibility));
    pixels.filter(|(s, (a, b))| !is_at_an_edge(s.position) && (**a >= 0.5) != (**b >= 0.5)).count()
}

#[test]
fn no_seam_runs_along_the_faces_of_a_point_light() {
    for lamp in [Vec3::ZERO, Vec3::new(1.0, -2.0, 0.5)] {
        for lid in [None, Some(0.3)] {
            let (scene, setup) = room(lamp, lid);
            for mut session in sessions(&scene, &setup) {
                let truth = session.render(&Technique::RAY).expect("frame");
                let lit = truth.visibility.iter().filter(|v| **v == 1.0).count();
                assert!(if lid.is_none() { lit == 240 * 160 } else { lit < 100 }, "{lit} lit, lid {lid:?}");
                for id in ["sm", "pcf", "vsm", "evsm", "evsm:prefiltered"] {
                    let frame = session.render(&technique(id)).expect("frame");
                    assert_eq!(frame.map_draws, 6);
                    let wrong = differing(&session, &truth, &frame);
                    assert_eq!(wrong, 0, "{id} lamp {lamp} lid {lid:?}");
                }
                let frame = session.render(&technique("ltt-evsm")).expect("frame");
                assert_eq!(differing(&session, &truth, &frame), 0, "lamp {lamp} lid {lid:?}");
                assert!(frame.rays * 50 < truth.rays, "{} of {} rays", frame.rays, truth.rays);
            }
        }
    }
}

#[test]
fn a_spot_light_reaches_what_lies_in_its_cone_and_range() {
    let (scene, mut setup) = room(Vec3::ZERO, None);
    for (degrees, range) in [(10.0f32, f32::INFINITY), (45.0, 6.0), (75.0, f32::INFINITY)] {
        let LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, .. } =
            spot([0.5, 3.0, 0.0], [-1.0, -5.0, -2.0], degrees)
        else {
            panic!("a spot")
        };
        setup.light = light(LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, range });
        for mut session in sessions(&scene, &setup) {
            let truth = session.render(&Technique::RAY).expect("frame");
            let frame = session.render(&technique("ltt-evsm")).expect("frame");
            assert_eq!(frame.map_draws, if degrees > 60.0 { 6 } else { 1 });
            let mut inside = 0;
            for (i, sample) in session.samples().iter().enumerate() {
                let way = sample.position - position;
                let angle = way.angle_between(direction).to_degrees();
                let is_sure = (angle - degrees).abs() > 0.01 && (way.length() - range).abs() > 1e-3;
                let reaches = angle < degrees && way.length() < range;
                inside += usize::from(reaches);
                let expected = if reaches { 1.0 } else { 0.0 };
                assert!(!is_sure || truth.visibility[i] == expected, "{degrees}° pixel {i} at {angle}°");
                assert!(!is_sure || frame.visibility[i] == expected, "{degrees}° pixel {i} at {angle}°");
            }
            assert!(inside > 10 && inside < 240 * 160, "{inside}");
            assert!(truth.rays.abs_diff(inside as u64) < 50, "no ray leaves the cone");
        }
    }
}

/// Beside a wall, in a corner, inside a solid, behind everything, upon a surface, far away, straight overhead.
#[test]
fn a_lamp_in_a_hard_place_is_still_right_in_every_frame() {
    for (place, kind) in [
        ("cornell", point(0.0, 5.4, 2.4)),
        ("cornell", point(0.5, 1e-4, 1.5)),
        ("cornell", point(0.0, -0.06, 0.0)),
        ("cornell", point(2.749, 0.001, -2.749)),
        ("cornell", spot([0.0, 5.0, 0.5], [0.0, 0.0, 0.0], 40.0)),
        ("cornell", spot([0.0, 2.0, -9.0], [0.0, 2.0, -20.0], 40.0)),
        ("street:6", point(0.0, 3.0, 0.0)),
        ("street:6", spot([0.0, 60.0, 0.0], [0.0, 0.0, 0.0], 30.0)),
        ("forest:20", spot([3.0, 8.0, 6.0], [0.0, 0.0, 0.0], 55.0)),
        ("square:8", point(2.0, 4.0, 3.0)),
    ] {
        let scene = builtin(place);
        let setup = Setup { light: light(kind), map_size: 256, ..Setup::for_scene(&scene, 200, 120) };
        let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
        session.play(Sequence { is_played: true, ..Sequence::default() });
        let truth = session.render(&Technique::RAY).expect("frame");
        for id in ["vsm", "evsm", "sm"] {
            let frame = session.render(&technique(id)).expect("frame");
            assert!(frame.visibility.iter().all(|v| (0.0..=1.0).contains(v)), "{place} {id} {kind:?}");
        }
        for id in ["lt-evsm", "lt-msm"] {
            for i in 0..4 {
                let frame = session.render(&technique(id)).expect("frame");
                assert_eq!(truth.visibility, frame.visibility, "{place} {id} frame {i} {kind:?}");
                assert_eq!(frame.map_draws > 0, i == 0, "{place} {id} frame {i}: the maps are kept");
            }
        }
    }
}

#[test]
fn cpu_and_gpu_agree_under_spot_and_point_lights() {
    for (place, kind) in [
        ("cornell", point(0.2, 4.8, 0.6)),
        ("street:4", spot([0.0, 20.0, 5.0], [0.0, 0.0, 0.0], 45.0)),
        ("square:6", point(2.0, 4.0, 3.0)),
        ("forest:12", spot([6.0, 15.0, 9.0], [0.0, 0.0, 0.0], 40.0)),
        ("forest:12", point(1.0, 3.0, 2.0)),
    ] {
        let scene = builtin(place);
        let setup = Setup { light: light(kind), map_size: 512, ..Setup::for_scene(&scene, 320, 200) };
        let mut both = sessions(&scene, &setup);
        if both.len() < 2 {
            return;
        }
        for id in ["ray", "sm", "vsm", "ltt-vsm", "ltt-evsm", "ltt-msm", "lt-evsm"] {
            let [a, b] = [0, 1].map(|i| both[i].render(&technique(id)).expect("frame"));
            let allowed = (320.0 * 200.0 * twin_ppm() * 1e-6) as usize;
            let wrong = other_side(&a, &b);
            let doubts = a.doubt.iter().zip(&b.doubt).filter(|(a, b)| a != b).count();
            assert!(wrong <= allowed && doubts <= allowed, "{place} {id}: {wrong} sides, {doubts} doubts");
            assert_eq!((a.map_bytes, a.map_draws), (b.map_bytes, b.map_draws));
        }
        let truth = both[0].render(&Technique::RAY).expect("frame");
        let pictures = [0, 1].map(|i| both[i].shade(&truth).expect("picture"));
        let bytes = pictures[0].iter().zip(&pictures[1]).flat_map(|(a, b)| a.iter().zip(b));
        let far = bytes.filter(|(a, b)| a.abs_diff(**b) > 1).count();
        let bytes = pictures[0].len() * 4;
        assert!(ppm(far, bytes) <= 2.0 * twin_ppm(), "{place}: {far} bytes differ by more than one step");
    }
}
