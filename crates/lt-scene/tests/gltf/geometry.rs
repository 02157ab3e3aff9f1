//! Triangles, accessors, hierarchy, buffers.

use std::fs;

use lt_math::glam::{DVec3, Vec3, vec3};
use lt_scene::{LightKind, Scene, gltf::GltfAsset};
use serde_json::json;
use tempfile::TempDir;

use crate::builder::{Doc, F32, I8, I16, U8, U16, U32, floats, open_in};

/// World positions of all corners.
pub fn corners(scene: &Scene) -> Vec<Vec3> {
    let of = |i: &lt_scene::Instance| {
        let (mesh, transform) = (&scene.meshes[i.mesh as usize], i.transform);
        mesh.indices
            .iter()
            .map(|&v| transform.transform_point3(mesh.positions[v as usize]))
            .collect::<Vec<_>>()
    };
    scene.instances.iter().flat_map(of).collect()
}

pub fn assert_close(found: &[Vec3], expected: &[Vec3]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (f, e) in found.iter().zip(expected) {
        assert!((*f - *e).abs().max_element() < 1e-5, "{found:?} is not {expected:?}");
    }
}

#[test]
fn every_mode_and_index_width_gives_the_same_square() {
    let square = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let modes: [(u32, &[u32]); 3] = [(4, &[0, 1, 2, 2, 1, 3]), (5, &[0, 1, 2, 3]), (6, &[2, 0, 1, 3])];
    for (mode, indices) in modes {
        for component in [U8, U16, U32] {
            let mut doc = Doc::new();
            let positions = doc.floats("VEC3", &square);
            let bytes: Vec<u8> = match component {
                U8 => indices.iter().map(|&i| i as u8).collect(),
                U16 => indices.iter().flat_map(|&i| (i as u16).to_le_bytes()).collect(),
                _ => indices.iter().flat_map(|&i| i.to_le_bytes()).collect(),
            };
            let indices = doc.accessor("SCALAR", component, indices.len(), &bytes);
            doc.mesh(json!({"attributes": {"POSITION": positions}, "indices": indices, "mode": mode}));
            doc.push("nodes", json!({"mesh": 0}));
            let found = corners(&doc.pose(0.0));
            assert_eq!(found.len(), 6, "mode {mode}");
            for t in found.chunks(3) {
                assert_eq!((t[1] - t[0]).cross(t[2] - t[0]), Vec3::Z, "mode {mode} turns a triangle over");
            }
        }
    }
    assert_eq!(Doc::triangle().pose(0.0).triangle_count(), 1, "without indices");
}

#[test]
fn sparse_elements_replace_zeros_and_data() {
    for has_base in [false, true] {
        let mut doc = Doc::new();
        let base = [9.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let view = doc.view(&floats(&base));
        let indices = doc.view(&[0, 2]);
        let values = doc.view(&floats(&[5.0, 0.0, 0.0, 0.0, 7.0, 0.0]));
        let mut accessor = json!({"type": "VEC3", "componentType": F32, "count": 3, "sparse": {"count": 2,
            "indices": {"bufferView": indices, "componentType": U8}, "values": {"bufferView": values}}});
        if has_base {
            accessor["bufferView"] = json!(view);
        }
        let positions = doc.push("accessors", accessor);
        doc.mesh(json!({"attributes": {"POSITION": positions}}));
        doc.push("nodes", json!({"mesh": 0}));
        let middle = if has_base { Vec3::X } else { Vec3::ZERO };
        assert_close(&corners(&doc.pose(0.0)), &[vec3(5.0, 0.0, 0.0), middle, vec3(0.0, 7.0, 0.0)]);
    }
}

#[test]
fn quantized_and_strided_positions_are_read() {
    let mut doc = Doc::triangle();
    doc.json["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let view = doc.view(&[0, 0, 0, 99, 127, 0, 0, 99, 0, 0x81, 0, 99]);
    doc.json["bufferViews"][view]["byteStride"] = json!(4);
    doc.json["accessors"][0] =
        json!({"bufferView": view, "type": "VEC3", "componentType": I8, "normalized": true, "count": 3});
    assert_close(&corners(&doc.pose(0.0)), &[Vec3::ZERO, Vec3::X, Vec3::NEG_Y]);
    let view = doc.view(&[0_i16, 0, 0, 300, 0, 0, 0, -20, 0].map(i16::to_le_bytes).concat());
    doc.json["accessors"][0] = json!({"bufferView": view, "type": "VEC3", "componentType": I16, "count": 3});
    assert_close(&corners(&doc.pose(0.0)), &[Vec3::ZERO, Vec3::X * 300.0, Vec3::Y * -20.0]);
}

#[test]
fn nodes_multiply_down_the_tree_and_share_their_mesh() {
    let mut doc = Doc::triangle();
    let quarter = std::f32::consts::FRAC_1_SQRT_2;
    doc.json["nodes"] = json!([
        {"translation": [10, 0, 0], "rotation": [0, 0, quarter, quarter], "children": [1, 2]},
        {"mesh": 0, "scale": [2, 2, 2]},
        {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 5, 1]},
    ]);
    let scene = doc.pose(0.0);
    assert_eq!((scene.meshes.len(), scene.instances.len()), (1, 2));
    let expected = [
        vec3(10.0, 0.0, 0.0),
        vec3(10.0, 2.0, 0.0),
        vec3(8.0, 0.0, 0.0),
        vec3(10.0, 0.0, 5.0),
        vec3(10.0, 1.0, 5.0),
        vec3(9.0, 0.0, 5.0),
    ];
    assert_close(&corners(&scene), &expected);
    assert!(scene.instances.iter().all(|i| !i.is_dynamic));
}

#[test]
fn only_the_default_scene_is_shown() {
    let mut doc = Doc::triangle();
    doc.json["nodes"] = json!([{"mesh": 0}, {"mesh": 0, "translation": [1, 0, 0]}]);
    assert_eq!(doc.pose(0.0).instances.len(), 2);
    doc.json["scenes"] = json!([{"nodes": [0]}, {"nodes": [1]}]);
    assert_eq!(corners(&doc.pose(0.0))[0], Vec3::ZERO);
    doc.json["scene"] = json!(1);
    assert_eq!(corners(&doc.pose(0.0))[0], Vec3::X);
}

#[test]
fn degenerate_triangles_points_and_flat_nodes_are_dropped_and_counted() {
    let mut doc = Doc::triangle();
    let indices = doc.accessor("SCALAR", U8, 8, &[0, 1, 2, 0, 0, 1, 1, 2]);
    doc.json["meshes"][0]["primitives"][0]["indices"] = json!(indices);
    doc.json["meshes"][0]["primitives"].as_array_mut().unwrap().push(json!({"attributes": {}, "mode": 0}));
    doc.push("nodes", json!({"mesh": 0, "scale": [1, 0, 1]}));
    let scene = doc.pose(0.0);
    assert_eq!((scene.triangle_count(), scene.instances.len()), (1, 1));
    let repairs = &scene.repairs;
    assert_eq!(repairs.degenerate_triangles, 1);
    assert_eq!(repairs.non_triangle_primitives, 1);
    assert_eq!(repairs.singular_instances, 1);
    assert_eq!(repairs.notes.len(), 1, "two indices are left over: {:?}", repairs.notes);
}

/// A scene far from its file's origin is the same scene, in places that f32 holds.
#[test]
fn far_scenes_are_told_relative_to_their_own_middle() {
    let scene_at = |far: [f64; 3]| {
        let mut doc = Doc::triangle();
        doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point"}]}});
        let camera = json!({"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}});
        doc.push("cameras", camera);
        doc.json["nodes"][0] = json!({"mesh": 0, "translation": [0.25, 0.5, -1.0], "scale": [3, 3, 3]});
        doc.push(
            "nodes",
            json!({"translation": [0.1, 0.2, 0.3], "extensions": {"KHR_lights_punctual": {"light": 0}}}),
        );
        doc.push("nodes", json!({"translation": [0.7, 0.2, 4.3], "camera": 0}));
        doc.push("nodes", json!({"translation": far, "children": [0, 1, 2]}));
        doc.json["scenes"] = json!([{"nodes": [3]}]);
        doc.pose(0.0)
    };
    let near = scene_at([0.0; 3]);
    assert_eq!((near.origin, near.repairs.summary()), (DVec3::ZERO, None));
    for far in [[8000.0, 0.0, -8000.0], [6.0e6, 300.0, 6.0e6], [0.0, 1e9, 0.0]] {
        let scene = scene_at(far);
        let shift = DVec3::from(far) - scene.origin;
        assert!(shift.abs().max_element() < 4.0 && scene.origin == scene.origin.round(), "{shift}");
        // Whole units, so that places keep their bits up to the shift's own rounding.
        let is_same = |a: Vec3, b: Vec3| (a - shift.as_vec3()).abs_diff_eq(b, 2e-6);
        let place = |scene: &Scene| scene.instances[0].transform;
        assert_eq!(place(&scene).matrix3, place(&near).matrix3);
        assert!(is_same(place(&scene).translation.into(), place(&near).translation.into()), "{far:?}");
        let lamp = |scene: &Scene| match scene.lights[0].kind {
            LightKind::Point { position, .. } => position,
            _ => Vec3::NAN,
        };
        assert!(is_same(lamp(&scene), lamp(&near)), "{far:?}");
        assert!(is_same(scene.cameras[0].eye, near.cameras[0].eye), "{far:?}");
        assert!(scene.repairs.summary().is_some_and(|s| s.contains("relative to")));
    }
    // Large scenes may lie beside the origin.
    assert_eq!(scene_at([50.0, 0.0, 0.0]).origin, DVec3::ZERO);
}

#[test]
fn vertices_that_no_triangle_uses_are_left_out() {
    let mut doc = Doc::new();
    let positions = [9e9, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let positions = doc.floats("VEC3", &positions);
    let normals = doc.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let indices = doc.accessor("SCALAR", U8, 3, &[1, 2, 3]);
    doc.mesh(json!({"attributes": {"POSITION": positions, "NORMAL": normals}, "indices": indices}));
    doc.push("nodes", json!({"mesh": 0}));
    let scene = doc.pose(0.0);
    assert_eq!(scene.bounds().max, vec3(1.0, 1.0, 0.0));
    assert_eq!(scene.meshes[0].normals, [Vec3::Z; 3]);
    assert_eq!(scene.repairs.summary(), None);
    doc.json["accessors"][normals]["bufferView"] = json!(positions);
    let scene = doc.pose(0.0);
    assert!(scene.meshes[0].normals.is_empty());
    assert_eq!(scene.repairs.bad_normals, 1);
}

#[test]
fn buffers_come_from_data_uris_and_from_files_inside_the_folder() {
    let doc = Doc::triangle();
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("sub dir")).unwrap();
    fs::write(folder.path().join("sub dir/data.bin"), &doc.bin).unwrap();
    let hex: String = doc.bin.iter().map(|b| format!("%{b:02X}")).collect();
    for uri in
        ["sub%20dir/data.bin".to_owned(), "./sub dir/../sub dir/data.bin".to_owned(), format!("data:,{hex}")]
    {
        let mut json = doc.finished();
        json["buffers"][0]["uri"] = json!(uri);
        let asset = open_in(folder.path(), "scene.gltf", json.to_string().as_bytes()).unwrap();
        assert_eq!(asset.pose(0.0).unwrap().triangle_count(), 1, "{uri}");
    }
}

#[test]
fn the_file_gives_the_scene_its_name() {
    let folder = TempDir::new().unwrap();
    let asset = open_in(folder.path(), "my town.glb", &Doc::triangle().glb()).unwrap();
    assert_eq!(asset.pose(f32::NAN).unwrap().name, "my town");
    assert_eq!(asset.animation_duration_s(), 0.0);
    assert!(format!("{:?}", asset.clone()).contains("my town.glb"));
    assert!(GltfAsset::open(folder.path()).unwrap_err().to_string().contains("not a regular file"));
}

#[test]
fn a_hundred_thousand_nested_nodes_load() {
    let mut doc = Doc::triangle();
    let last = 100_000;
    let chain = (0..last).map(|i| json!({"children": [i + 1], "translation": [0, 0, 1]}));
    doc.json["nodes"] = chain.chain([json!({"mesh": 0})]).collect();
    let scene = doc.pose(0.0);
    assert_eq!(f64::from(corners(&scene)[0].z) + scene.origin.z, f64::from(last));
}
