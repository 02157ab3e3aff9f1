//! Animation, skins and morph targets against positions worked out by hand.

use std::f32::consts::FRAC_1_SQRT_2;

use lt_math::glam::{Vec3, vec3};
use lt_scene::{LightKind, Scene};
use serde_json::json;

use crate::{
    builder::{Doc, I8, I16, U8, U16},
    geometry::{assert_close, corners},
};

/// A triangle whose node's `path` takes `values` at 1 s, 2 s and 4 s.
fn animated(path: &str, kind: &str, values: &[f32], interpolation: &str) -> Doc {
    let mut doc = Doc::triangle();
    let output = doc.floats(kind, values);
    animate(&mut doc, path, output, interpolation);
    doc
}

fn animate(doc: &mut Doc, path: &str, output: usize, interpolation: &str) {
    let input = doc.floats("SCALAR", &[1.0, 2.0, 4.0]);
    doc.push(
        "animations",
        json!({"channels": [{"sampler": 0, "target": {"node": 0, "path": path}}],
               "samplers": [{"input": input, "output": output, "interpolation": interpolation}]}),
    );
}

/// Where the triangle's second corner, (1, 0, 0) at rest, is at a time.
fn second_corner(doc: &Doc, time_s: f32) -> Vec3 {
    corners(&doc.pose(time_s))[1]
}

fn assert_path(doc: &Doc, expected: &[(f32, Vec3)]) {
    for &(time_s, place) in expected {
        let found = second_corner(doc, time_s);
        assert!((found - place).length() < 2e-4, "at {time_s} s: {found} is not {place}");
    }
}

#[test]
fn steps_hold_lines_connect_and_time_wraps() {
    let keys = [0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 8.0, 0.0];
    let at = |y: f32| vec3(1.0, y, 0.0);
    let step = animated("translation", "VEC3", &keys, "STEP");
    assert_path(&step, &[(0.0, at(0.0)), (1.9, at(0.0)), (2.0, at(4.0)), (3.9, at(4.0)), (4.0, at(0.0))]);
    let linear = animated("translation", "VEC3", &keys, "LINEAR");
    assert_path(&linear, &[(0.5, at(0.0)), (1.5, at(2.0)), (3.0, at(6.0)), (7.0, at(6.0)), (-1.0, at(6.0))]);
    assert_eq!(linear.open().unwrap().animation_duration_s(), 4.0);
    assert!(linear.pose(0.0).instances[0].is_dynamic);
    let scale = animated("scale", "VEC3", &[1.0, 1.0, 1.0, 3.0, 1.0, 1.0, 3.0, 1.0, 1.0], "LINEAR");
    assert_path(&scale, &[(1.5, vec3(2.0, 0.0, 0.0))]);
}

#[test]
fn lights_ride_on_what_carries_them() {
    let keys = [0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 8.0, 0.0];
    let mut doc = animated("translation", "VEC3", &keys, "LINEAR");
    doc.json["extensions"] =
        json!({"KHR_lights_punctual": {"lights": [{"type": "spot"}, {"type": "directional"}]}});
    doc.json["nodes"][0]["children"] = json!([1, 2]);
    let light = |i: usize| json!({"KHR_lights_punctual": {"light": i}});
    doc.push("nodes", json!({"translation": [1, 0, 0], "extensions": light(0)}));
    doc.push("nodes", json!({"extensions": light(1)}));
    for (time_s, y) in [(0.5, 0.0), (1.5, 2.0), (3.0, 6.0)] {
        let lights = doc.pose(time_s).lights;
        let LightKind::Spot { position, direction, .. } = lights[0].kind else { panic!("{lights:?}") };
        assert!((position - vec3(1.0, y, 0.0)).length() < 1e-5 && direction == Vec3::NEG_Z, "{position}");
        assert_eq!(lights[1].kind, LightKind::Directional { direction: Vec3::NEG_Z }, "a sun has no place");
    }
    assert!(doc.open().unwrap().moves_lights());
    doc.json["nodes"][0]["children"] = json!([]);
    assert!(!doc.open().unwrap().moves_lights(), "they hang on nothing that moves");
    // A quarter turn of the node about x by the first key, none by the second.
    let turns = [FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let mut doc = animated("rotation", "VEC4", &turns, "LINEAR");
    doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "directional"}]}});
    doc.json["nodes"][0]["extensions"] = light(0);
    let half = vec3(0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2);
    for (time_s, expected) in [(0.5, Vec3::Y), (1.5, half), (3.0, Vec3::NEG_Z)] {
        let LightKind::Directional { direction } = doc.pose(time_s).lights[0].kind else { panic!() };
        assert!((direction - expected).length() < 1e-5, "at {time_s} s: {direction}");
    }
}

#[test]
fn what_is_baked_at_rest_does_not_move() {
    let rest = |kind: &str| animated("translation", "VEC3", &[2.0, 3.0, 4.0].repeat(3), kind);
    let rows = [[0.0; 3], [2.0, 3.0, 4.0], [0.0; 3]].concat().repeat(3);
    let mut bent = rows.clone();
    bent[8] = 0.5;
    for (doc, moves) in [
        (rest("LINEAR"), false),
        (rest("STEP"), false),
        (animated("translation", "VEC3", &rows, "CUBICSPLINE"), false),
        (animated("translation", "VEC3", &bent, "CUBICSPLINE"), true),
    ] {
        let mut doc = doc;
        doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point"}]}});
        doc.json["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
        let asset = doc.open().unwrap();
        assert_eq!((asset.moves_lights(), doc.pose(0.0).instances[0].is_dynamic), (moves, moves));
        assert_eq!(asset.animation_duration_s(), 4.0);
        assert_path(&doc, &[(0.5, vec3(3.0, 3.0, 4.0)), (2.0, vec3(3.0, 3.0, 4.0))]);
    }
}

#[test]
fn splines_follow_their_tangents() {
    // Between 2 s and 4 s: value 1 with out-tangent 3, value 2 with in-tangent −1. At the middle (appendix C):
    // ½·1 + 2·⅛·3 + ½·2 − 2·⅛·(−1) = 2.5.
    let row = |tangent_in: f32, value: f32, tangent_out: f32| {
        [[tangent_in, 0.0, 0.0], [value, 0.0, 0.0], [tangent_out, 0.0, 0.0]].concat()
    };
    let keys = [row(0.0, 0.0, 0.0), row(0.0, 1.0, 3.0), row(-1.0, 2.0, 0.0)].concat();
    let doc = animated("translation", "VEC3", &keys, "CUBICSPLINE");
    assert_path(&doc, &[(1.0, Vec3::X), (2.0, vec3(2.0, 0.0, 0.0)), (3.0, vec3(3.5, 0.0, 0.0))]);
    // A straight line is its own spline: from (0, 0) to (1, 1) with slope 1.
    let keys = [row(1.0, 0.0, 1.0), row(1.0, 1.0, 0.5), row(0.5, 2.0, 0.0)].concat();
    let doc = animated("translation", "VEC3", &keys, "CUBICSPLINE");
    assert_path(&doc, &[(1.25, vec3(1.25, 0.0, 0.0)), (3.0, vec3(2.5, 0.0, 0.0))]);
}

#[test]
fn rotations_take_the_short_way_in_every_number_format() {
    let h = FRAC_1_SQRT_2;
    // None, a quarter turn about z, the same quarter turn negated.
    let keys = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, h, h, 0.0, 0.0, -h, -h];
    let expected = [(1.0, Vec3::X), (1.5, vec3(h, h, 0.0)), (2.0, Vec3::Y), (3.0, Vec3::Y)];
    assert_path(&animated("rotation", "VEC4", &keys, "LINEAR"), &expected);
    let scaled = |max: f32| keys.map(|v| (v * max).round() as i32);
    let shorts: Vec<u8> = scaled(32767.0).iter().flat_map(|&v| (v as i16).to_le_bytes()).collect();
    let bytes: Vec<u8> = scaled(127.0).iter().map(|&v| v as i8 as u8).collect();
    for (component, bytes) in [(I16, &shorts), (I8, &bytes)] {
        let mut doc = Doc::triangle();
        let output = doc.accessor("VEC4", component, 3, bytes);
        doc.json["accessors"][output]["normalized"] = json!(true);
        animate(&mut doc, "rotation", output, "LINEAR");
        assert_path(&doc, &expected);
    }
}

/// The triangle hangs on two joints at x = 0 and x = 2, its second corner half on each.
fn skinned(weights: &[f32]) -> Doc {
    let mut doc = Doc::triangle();
    let normals = doc.floats("VEC3", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let joints = doc.accessor("VEC4", U8, 3, &[0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]);
    let weights = doc.floats("VEC4", weights);
    let identity = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let mut second = identity;
    second[12] = -2.0;
    let binds = doc.floats("MAT4", &[identity, second].concat());
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = json!(normals);
    attributes["JOINTS_0"] = json!(joints);
    attributes["WEIGHTS_0"] = json!(weights);
    doc.json["nodes"] = json!([
        {"children": [2]},
        {"mesh": 0, "skin": 0, "translation": [100, 0, 0]},
        {"translation": [2, 0, 0]},
    ]);
    doc.json["skins"] = json!([{"joints": [0, 2], "inverseBindMatrices": binds}]);
    doc
}

const HALF: [f32; 12] = [1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

#[test]
fn a_skin_at_rest_changes_nothing_and_ignores_its_own_node() {
    let scene = skinned(&HALF).pose(0.0);
    assert_close(&corners(&scene), &[Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert!(!scene.instances[0].is_dynamic);
    let doubled = HALF.map(|w| w * 2.0);
    assert_close(&corners(&skinned(&doubled).pose(0.0)), &[Vec3::ZERO, Vec3::X, Vec3::Y]);
}

#[test]
fn a_skin_blends_its_joints() {
    let mut doc = skinned(&HALF);
    // The second joint turns a quarter about z and rises by 4.
    doc.json["nodes"][2] =
        json!({"translation": [2, 0, 4], "rotation": [0, 0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]});
    // By it alone (1,0,0) − (2,0,0) = (−1,0,0) turns to (0,−1,0), then (2,−1,4); halfway from (1,0,0).
    assert_close(&corners(&doc.pose(0.0)), &[Vec3::ZERO, vec3(1.5, -0.5, 2.0), Vec3::Y]);
    // The first joint tips everything about x: y becomes z, and the normal −y.
    doc.json["nodes"][0]["rotation"] = json!([FRAC_1_SQRT_2, 0, 0, FRAC_1_SQRT_2]);
    let scene = doc.pose(0.0);
    assert_close(&corners(&scene), &[Vec3::ZERO, vec3(1.5, -2.0, -0.5), Vec3::Z]);
    assert_close(&scene.meshes[0].normals[..1], &[Vec3::NEG_Y]);
}

#[test]
fn an_animated_joint_makes_the_skin_dynamic() {
    let mut doc = skinned(&HALF);
    let output = doc.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0]);
    animate(&mut doc, "translation", output, "LINEAR");
    let scene = doc.pose(1.5);
    assert!(scene.instances[0].is_dynamic);
    assert_close(&corners(&scene), &[Vec3::Y, vec3(1.0, 1.0, 0.0), vec3(0.0, 2.0, 0.0)]);
}

#[test]
fn weights_as_normalized_integers_blend_alike() {
    let bytes: Vec<u8> = HALF.iter().map(|w| (w * 255.0).round() as u8).collect();
    let shorts: Vec<u8> = HALF.iter().flat_map(|w| ((w * 65535.0).round() as u16).to_le_bytes()).collect();
    for (component, bytes) in [(U8, &bytes), (U16, &shorts)] {
        let mut doc = skinned(&HALF);
        doc.json["nodes"][2] = json!({"translation": [2, 0, 4]});
        let weights = doc.accessor("VEC4", component, 3, bytes);
        doc.json["accessors"][weights]["normalized"] = json!(true);
        doc.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = json!(weights);
        assert_close(&corners(&doc.pose(0.0)), &[Vec3::ZERO, vec3(1.0, 0.0, 2.0), Vec3::Y]);
    }
}

/// Two targets: the second corner moves by +x, or by +z.
fn morphing() -> Doc {
    let mut doc = Doc::triangle();
    let right = doc.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let out = doc.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    doc.json["meshes"][0]["primitives"][0]["targets"] = json!([{"POSITION": right}, {"POSITION": out}]);
    doc
}

#[test]
fn morph_weights_come_from_the_mesh_then_the_node_then_the_animation() {
    let mut doc = morphing();
    assert_path(&doc, &[(0.0, Vec3::X)]);
    doc.json["meshes"][0]["weights"] = json!([2, 0]);
    assert_path(&doc, &[(0.0, vec3(3.0, 0.0, 0.0))]);
    doc.json["nodes"][0]["weights"] = json!([0, 0.5]);
    assert_path(&doc, &[(0.0, vec3(1.0, 0.0, 0.5))]);
    assert!(!doc.pose(0.0).instances[0].is_dynamic);
    let output = doc.floats("SCALAR", &[0.0, 0.0, 1.0, 4.0, 1.0, 0.0]);
    animate(&mut doc, "weights", output, "LINEAR");
    assert_path(&doc, &[(1.5, vec3(1.5, 0.0, 2.0)), (3.0, vec3(2.0, 0.0, 2.0))]);
    assert!(doc.pose(0.0).instances[0].is_dynamic);
}

#[test]
fn animated_weights_may_be_normalized_bytes_and_splines() {
    let mut doc = morphing();
    let output = doc.accessor("SCALAR", U8, 6, &[0, 0, 255, 0, 0, 255]);
    doc.json["accessors"][output]["normalized"] = json!(true);
    animate(&mut doc, "weights", output, "LINEAR");
    assert_path(&doc, &[(2.0, vec3(2.0, 0.0, 0.0)), (1.5, vec3(1.5, 0.0, 0.0))]);
    let mut doc = morphing();
    let key = |a: f32, b: f32| [0.0, 0.0, a, b, 0.0, 0.0];
    let output = doc.floats("SCALAR", &[key(0.0, 0.0), key(1.0, 2.0), key(0.0, 0.0)].concat());
    animate(&mut doc, "weights", output, "CUBICSPLINE");
    assert_path(&doc, &[(1.5, vec3(1.5, 0.0, 1.0)), (2.0, vec3(2.0, 0.0, 2.0))]);
}

#[test]
fn things_keep_their_number_while_they_vanish() {
    let keys = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let mut doc = animated("scale", "VEC3", &keys, "STEP");
    let again = doc.json["meshes"][0].clone();
    doc.push("meshes", again);
    doc.push("nodes", json!({"mesh": 1}));
    doc.json["extensions"] =
        json!({"KHR_lights_punctual": {"lights": [{"type": "directional"}, {"type": "point"}]}});
    doc.json["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
    doc.push("nodes", json!({"extensions": {"KHR_lights_punctual": {"light": 1}}}));
    let (before, during) = (doc.pose(1.0), doc.pose(2.5));
    for scene in [&before, &during] {
        assert_eq!((scene.instances.len(), scene.lights.len(), scene.repairs.summary()), (2, 2, None));
        assert_eq!(scene.instances[1].mesh, before.instances[1].mesh);
        assert!(scene.instances[0].is_dynamic);
    }
    let size = |scene: &Scene| scene.instances[0].transform.transform_vector3(Vec3::ONE).length();
    assert!(size(&before) > 1.0 && size(&during) > 0.0 && size(&during) < 1e-8);
    assert_eq!([before.lights[0].intensity, during.lights[0].intensity], [1.0, 0.0]);
    assert_eq!(during.lights[1], before.lights[1]);
}

#[test]
fn a_light_that_is_left_no_direction_is_dropped_and_noted() {
    let mut doc = Doc::triangle();
    doc.json["extensions"] =
        json!({"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "sun"}]}});
    doc.push("nodes", json!({"scale": [0, 0, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}));
    let scene = doc.pose(0.0);
    assert!(scene.lights.is_empty());
    assert!(scene.repairs.summary().is_some_and(|s| s.contains("\"sun\"")), "{:?}", scene.repairs);
}

#[test]
fn weights_of_a_mesh_without_targets_may_be_animated_in_vain() {
    let doc = animated("weights", "SCALAR", &[0.0, 1.0, 0.0], "LINEAR");
    assert_path(&doc, &[(2.0, Vec3::X)]);
}
