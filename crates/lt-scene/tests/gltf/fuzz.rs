//! Damaged files are refused or read, never a panic.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::builder::{Doc, U8, open_in, png};

/// A bit of everything.
fn everything() -> Doc {
    let mut doc = Doc::triangle();
    let normals = doc.floats("VEC3", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let uvs = doc.floats("VEC2", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let joints = doc.accessor("VEC4", U8, 3, &[0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]);
    let weights = doc.floats("VEC4", &[1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    let indices = doc.accessor("SCALAR", U8, 4, &[0, 1, 2, 0]);
    let times = doc.floats("SCALAR", &[0.0, 1.0]);
    let moves = doc.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
    let fades = doc.floats("SCALAR", &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let slots = doc.view(&[1]);
    let values = doc.view(&[0; 12]);
    let pixels = doc.view(&png(1, 1, &[[1, 2, 3, 4]]));
    doc.json["accessors"][0]["sparse"] = json!({"count": 1, "values": {"bufferView": values},
        "indices": {"bufferView": slots, "componentType": U8}});
    doc.json["images"] = json!([{"bufferView": pixels}]);
    doc.json["samplers"] = json!([{"wrapS": 33071}]);
    doc.json["textures"] = json!([{"source": 0, "sampler": 0}]);
    doc.json["materials"] = json!([{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
        "extensions": {"KHR_texture_transform": {"rotation": 1, "texCoord": 0}}}}}]);
    doc.json["meshes"][0]["primitives"][0] = json!({"mode": 5, "indices": indices, "material": 0,
        "attributes": {"POSITION": 0, "NORMAL": normals, "TEXCOORD_0": uvs, "JOINTS_0": joints, "WEIGHTS_0": weights},
        "targets": [{"POSITION": 0}]});
    doc.json["nodes"] = json!([{"children": [1, 2]}, {"mesh": 0, "skin": 0, "weights": [0.5], "camera": 0},
        {"translation": [0, 0, 1], "mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}]);
    doc.json["skins"] = json!([{"joints": [0, 2]}]);
    doc.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1}}]);
    doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "spot"}]}});
    doc.json["scenes"] = json!([{"nodes": [0]}]);
    doc.json["animations"] = json!([{"channels": [
            {"sampler": 0, "target": {"node": 2, "path": "translation"}},
            {"sampler": 1, "target": {"node": 1, "path": "weights"}}],
        "samplers": [{"input": times, "output": moves},
                     {"input": times, "output": fades, "interpolation": "CUBICSPLINE"}]}]);
    doc
}

/// Opens and poses; checks what a scene promises if that succeeds. Returns whether it did.
fn survives(folder: &TempDir, bytes: &[u8]) -> bool {
    let posed = open_in(folder.path(), "f.glb", bytes).and_then(|asset| asset.pose(0.25));
    let Ok(scene) = posed else { return false };
    for mesh in &scene.meshes {
        let vertices = mesh.positions.len();
        assert!(mesh.positions.iter().all(|p| p.is_finite()));
        assert!(mesh.indices.iter().all(|&i| (i as usize) < vertices) && mesh.indices.len() % 3 == 0);
        assert!(
            [mesh.normals.len(), mesh.uvs.len(), mesh.colors.len()].iter().all(|&n| n == 0 || n == vertices)
        );
        assert!(mesh.normals.iter().all(|n| n.is_normalized()));
        assert!((mesh.material as usize) < scene.materials.len());
    }
    for instance in &scene.instances {
        assert!((instance.mesh as usize) < scene.meshes.len() && instance.transform.inverse().is_finite());
    }
    let textures = scene.materials.iter().filter_map(|m| m.texture);
    assert!(textures.into_iter().all(|t| (t.texture as usize) < scene.textures.len()));
    true
}

/// Thousands of cases, or as many as PROPTEST_CASES says if that is more; the same ones every time.
fn runner() -> TestRunner {
    let config = Config::default();
    let config = Config { cases: config.cases.max(3000), failure_persistence: None, ..config };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

#[test]
fn the_sound_file_loads() {
    assert!(survives(&TempDir::new().unwrap(), &everything().glb()));
}

#[test]
fn truncation_at_any_length_is_refused() {
    let folder = TempDir::new().unwrap();
    let glb = everything().glb();
    for length in 0..glb.len() {
        assert!(!survives(&folder, &glb[..length]), "{length} bytes were accepted");
    }
    // Truncated, but with a header that agrees.
    for length in 12..glb.len() {
        let mut bytes = glb[..length].to_vec();
        bytes[8..12].copy_from_slice(&(length as u32).to_le_bytes());
        survives(&folder, &bytes);
    }
}

#[test]
fn changed_bytes_never_panic() {
    let folder = TempDir::new().unwrap();
    let glb = everything().glb();
    let changes = prop::collection::vec((0..glb.len(), any::<u8>()), 1..6);
    let check = |changes: Vec<(usize, u8)>| {
        let mut bytes = glb.clone();
        changes.iter().for_each(|&(at, value)| bytes[at] = value);
        survives(&folder, &bytes);
        Ok(())
    };
    runner().run(&changes, check).unwrap();
}

#[test]
fn changed_json_never_panics() {
    let folder = TempDir::new().unwrap();
    let doc = everything();
    let json = doc.finished();
    let mut paths = Vec::new();
    collect_paths(&json, String::new(), &mut paths);
    paths.retain(|path| !path.is_empty());
    let values = prop::sample::select(vec![
        json!(null),
        json!(-1),
        json!(0),
        json!(1),
        json!(2),
        json!(3),
        json!(7.5),
        json!(1e39),
        json!(65536),
        json!(4_294_967_296_u64),
        json!(u64::MAX),
        json!("SCALAR"),
        json!("MAT4"),
        json!("LINEAR"),
        json!([]),
        json!([0, 0, 0]),
        json!([1, 2]),
        json!({}),
        json!({"POSITION": 1}),
        json!(true),
    ]);
    let changes = prop::collection::vec((prop::sample::select(paths), values), 1..4);
    let check = |changes: Vec<(String, Value)>| {
        let mut changed = doc.clone();
        changed.json = json.clone();
        for (path, value) in changes {
            if let Some(slot) = changed.json.pointer_mut(&path) {
                *slot = value;
            }
        }
        survives(&folder, &changed.glb());
        Ok(())
    };
    runner().run(&changes, check).unwrap();
}

fn collect_paths(value: &Value, path: String, paths: &mut Vec<String>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(k, v)| collect_paths(v, format!("{path}/{k}"), paths)),
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, v)| collect_paths(v, format!("{path}/{i}"), paths));
        }
        _ => {}
    }
    paths.push(path);
}
