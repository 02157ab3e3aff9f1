//! One broken file per line, and what its error must name.

use std::fs;

use lt_scene::SceneError;
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::builder::{Doc, U8, U32, open_in, png, refusal};

type Break = fn(&mut Doc);

/// What is done to a sound triangle, and words that the message must have.
const CASES: &[(&str, Break, &[&str])] = &[
    ("mesh index", |d| d.json["nodes"][0]["mesh"] = json!(3), &["nodes[0].mesh", "meshes[3]", "has 1"]),
    (
        "index past 2^32",
        |d| d.json["nodes"][0]["mesh"] = json!(1_u64 << 32),
        &["nodes[0].mesh", "4294967296"],
    ),
    ("negative index", |d| d.json["nodes"][0]["mesh"] = json!(-1), &["nodes[0]", "-1"]),
    (
        "accessor index",
        |d| primitive(d)["attributes"]["POSITION"] = json!(9),
        &["primitives[0].POSITION", "accessors[9]"],
    ),
    ("material index", |d| primitive(d)["material"] = json!(2), &["primitives[0].material", "materials[2]"]),
    ("mode", |d| primitive(d)["mode"] = json!(7), &["primitives[0].mode", "7"]),
    (
        "view index",
        |d| d.json["accessors"][0]["bufferView"] = json!(5),
        &["accessors[0].bufferView", "bufferViews[5]"],
    ),
    (
        "buffer index",
        |d| d.json["bufferViews"][0]["buffer"] = json!(1),
        &["bufferViews[0].buffer", "buffers[1]"],
    ),
    (
        "view range",
        |d| d.json["bufferViews"][0]["byteLength"] = json!(37),
        &["bufferViews[0]", "37", "36 bytes"],
    ),
    (
        "view overflow",
        |d| d.json["bufferViews"][0]["byteOffset"] = json!(u64::MAX),
        &["bufferViews[0]", "outside"],
    ),
    (
        "accessor offset",
        |d| d.json["accessors"][0]["byteOffset"] = json!(4),
        &["accessors[0]", "byteOffset 4", "need 36"],
    ),
    (
        "accessor count",
        |d| d.json["accessors"][0]["count"] = json!(4_000_000_000_u64),
        &["accessors[0]", "48000000000"],
    ),
    (
        "count times stride",
        |d| d.json["accessors"][0]["count"] = json!(u64::MAX),
        &["accessors[0]", "more than can be counted"],
    ),
    (
        "stride",
        |d| d.json["bufferViews"][0]["byteStride"] = json!(8),
        &["accessors[0]", "byteStride 8", "12 bytes"],
    ),
    ("stride overflow", |d| d.json["bufferViews"][0]["byteStride"] = json!(u64::MAX), &["accessors[0]"]),
    ("component type", |d| d.json["accessors"][0]["componentType"] = json!(5124), &["accessors[0]", "5124"]),
    ("element type", |d| d.json["accessors"][0]["type"] = json!("VEC2"), &["POSITION", "VEC2", "VEC3"]),
    ("no element type", |d| d.json["accessors"][0]["type"] = json!("VEC5"), &["accessors[0]", "VEC5"]),
    ("huge zeros", huge_zeros, &["primitives[0].indices", "elements"]),
    ("NaN position", |d| float(d, 4, f32::NAN), &["accessors[0]", "element 1", "NaN"]),
    ("infinite position", |d| float(d, 6, f32::NEG_INFINITY), &["accessors[0]", "element 2", "-inf"]),
    (
        "index past vertices",
        |d| indices(d, U8, &[0, 1, 3]),
        &["primitives[0].indices", "element 2", "is 3", "3 vertices"],
    ),
    ("index restart", |d| indices(d, U32, &[0xFF; 12]), &["primitives[0].indices", "4294967295"]),
    ("short attribute", short_normals, &["primitives[0].NORMAL", "2 elements", "POSITION 3"]),
    ("self child", |d| d.json["nodes"][0]["children"] = json!([0]), &["nodes[0]", "cycle"]),
    (
        "cycle",
        |d| d.json["nodes"] = json!([{"children": [1]}, {"children": [2]}, {"children": [1]}]),
        &["nodes[2].children[0]", "one parent"],
    ),
    (
        "lone cycle",
        |d| d.json["nodes"] = json!([{}, {"children": [2]}, {"children": [1]}]),
        &["nodes[1]", "cycle"],
    ),
    (
        "two parents",
        |d| d.json["nodes"] = json!([{"children": [2]}, {"children": [2]}, {}]),
        &["nodes[1].children[0]", "nodes[0]"],
    ),
    (
        "child twice",
        |d| d.json["nodes"] = json!([{"children": [1, 1]}, {}]),
        &["nodes[0].children[1]", "one parent"],
    ),
    ("doubling graph", doubling_graph, &["nodes[0].children[1]", "one parent"]),
    ("child index", |d| d.json["nodes"][0]["children"] = json!([8]), &["nodes[0].children[0]", "nodes[8]"]),
    ("scene index", |d| d.json["scene"] = json!(1), &["scene", "scenes[1]", "has 0"]),
    ("scene node", |d| d.json["scenes"] = json!([{"nodes": [4]}]), &["scenes[0].nodes", "nodes[4]"]),
    (
        "infinite translation",
        |d| d.json["nodes"][0]["translation"] = json!([1e39, 0, 0]),
        &["nodes[0]", "not finite"],
    ),
    (
        "projective matrix",
        |d| d.json["nodes"][0]["matrix"] = json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
        &["nodes[0].matrix", "affine"],
    ),
    ("short matrix", |d| d.json["nodes"][0]["matrix"] = json!([1, 0]), &["nodes[0]", "length"]),
    ("sparse order", |d| sparse(d, &[1, 1], 2), &["accessors[0].sparse.indices", "element 1"]),
    ("sparse range", |d| sparse(d, &[0, 3], 2), &["accessors[0].sparse.indices", "element 3"]),
    ("sparse count", |d| sparse(d, &[0, 1], 4_000_000_000), &["accessors[0].sparse.indices", "4000000000"]),
    ("skin index", |d| d.json["nodes"][0]["skin"] = json!(0), &["nodes[0].skin", "skins[0]"]),
    ("joint index", |d| d.json["skins"] = json!([{"joints": [7]}]), &["skins[0].joints[0]", "nodes[7]"]),
    ("joint past skin", joint_past_skin, &["nodes[0].skin", "joint 1", "1 joints"]),
    ("joints without weights", joints_without_weights, &["primitives[0].WEIGHTS_0", "missing"]),
    ("few bind matrices", few_bind_matrices, &["skins[0].inverseBindMatrices", "0 matrices for 1"]),
    (
        "animated node",
        |d| animation(d, json!({"node": 5, "path": "scale"}), 2),
        &["animations[0].channels[0].target.node"],
    ),
    (
        "key count",
        |d| animation(d, json!({"node": 0, "path": "scale"}), 1),
        &["animations[0].samplers[0].output", "2 keys"],
    ),
    (
        "key order",
        |d| {
            animation(d, json!({"node": 0, "path": "scale"}), 2);
            d.bin[36..40].fill(0x42);
        },
        &["accessors[1]", "keyframe 1"],
    ),
    (
        "spline keys",
        |d| {
            animation(d, json!({"node": 0, "path": "scale"}), 2);
            d.json["animations"][0]["samplers"][0]["interpolation"] = json!("CUBICSPLINE");
        },
        &["samplers[0].output", "9 numbers"],
    ),
    (
        "interpolation",
        |d| {
            animation(d, json!({"node": 0, "path": "scale"}), 2);
            d.json["animations"][0]["samplers"][0]["interpolation"] = json!("BOUNCE");
        },
        &["samplers[0].interpolation", "BOUNCE"],
    ),
    (
        "sampler index",
        |d| {
            animation(d, json!({"node": 0, "path": "scale"}), 2);
            d.json["animations"][0]["channels"][0]["sampler"] = json!(4);
        },
        &["channels[0].sampler", "samplers[4]"],
    ),
    (
        "animated matrix",
        |d| {
            animation(d, json!({"node": 0, "path": "scale"}), 2);
            d.json["nodes"][0]["matrix"] = json!([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
        },
        &["channels[0]", "nodes[0]", "matrix"],
    ),
    ("posed overflow", posed_overflow, &["nodes[0].mesh", "vertex 1", "not finite"]),
    ("no image", |d| image(d, b""), &["images[0] (leaf)", "PNG or JPEG"]),
    ("broken image", |d| image(d, b"\x89PNG\r\n\x1a\nnonsense"), &["images[0] (leaf)"]),
    (
        "truncated image",
        |d| {
            let png = png(8, 8, &[[7, 8, 9, 255]; 64]);
            image(d, &png[..png.len() - 20]);
        },
        &["images[0] (leaf)"],
    ),
    ("huge image", |d| image(d, &huge_png(60_000, 60_000)), &["images[0] (leaf)", "16384"]),
    ("large image", |d| image(d, &huge_png(16_000, 16_000)), &["images[0] (leaf)"]),
    (
        "image index",
        |d| {
            image(d, b"");
            d.json["textures"][0]["source"] = json!(3);
        },
        &["textures[0].source", "images[3]"],
    ),
    (
        "texture index",
        |d| {
            image(d, b"");
            d.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = json!(2);
        },
        &["materials[0].baseColorTexture.index", "textures[2]"],
    ),
    (
        "wrap mode",
        |d| {
            image(d, b"");
            d.json["samplers"] = json!([{"wrapS": 1}]);
            d.json["textures"][0]["sampler"] = json!(0);
        },
        &["textures[0].sampler", "1 is not a wrap mode"],
    ),
    (
        "alpha mode",
        |d| d.json["materials"] = json!([{"alphaMode": "GHOST"}]),
        &["materials[0].alphaMode", "GHOST"],
    ),
    (
        "infinite cutoff",
        |d| d.json["materials"] = json!([{"alphaMode": "MASK", "alphaCutoff": 1e39}]),
        &["materials[0].alphaCutoff"],
    ),
    (
        "camera",
        |d| {
            d.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 4}}]);
            d.json["nodes"][0]["camera"] = json!(0);
        },
        &["cameras[0]", "yfov 4"],
    ),
    (
        "light",
        |d| light(d, json!({"type": "spot", "spot": {"innerConeAngle": 2}})),
        &["KHR_lights_punctual.lights[0]", "cone"],
    ),
    (
        "light index",
        |d| {
            light(d, json!({"type": "point"}));
            d.json["extensions"]["KHR_lights_punctual"]["lights"] = json!([]);
        },
        &["nodes[0].extensions.KHR_lights_punctual.light", "lights[0]"],
    ),
    ("version", |d| d.json["asset"]["version"] = json!("1.0"), &["asset.version", "1.0", "re-export"]),
    ("no asset", |d| d.json = json!({}), &["JSON", "asset"]),
    (
        "unknown extension",
        |d| d.json["extensionsRequired"] = json!(["KHR_texture_transform", "ACME_magic"]),
        &["extensionsRequired", "ACME_magic"],
    ),
    (
        "Draco",
        |d| d.json["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]),
        &["KHR_draco_mesh_compression", "re-export without Draco"],
    ),
    (
        "WebP",
        |d| d.json["extensionsRequired"] = json!(["EXT_texture_webp"]),
        &["EXT_texture_webp", "PNG or JPEG"],
    ),
    (
        "short buffer",
        |d| d.json["buffers"] = json!([{"byteLength": 99}]),
        &["buffers[0]", "expected 99", "found 36"],
    ),
    (
        "second chunk",
        |d| d.json["buffers"] = json!([{"byteLength": 36}, {"byteLength": 1}]),
        &["buffers[1]", "neither"],
    ),
    ("missing file", |d| buffer_uri(d, "gone.bin"), &["gone.bin"]),
    ("absolute path", |d| buffer_uri(d, "/etc/passwd"), &["buffers[0].uri", "/etc/passwd", "folder"]),
    ("climbing path", |d| buffer_uri(d, "../../x.bin"), &["buffers[0].uri", "../../x.bin", "folder"]),
    ("encoded climb", |d| buffer_uri(d, "%2e%2e%2Fx.bin"), &["buffers[0].uri", "folder"]),
    ("encoded absolute", |d| buffer_uri(d, "%2Fetc/passwd"), &["buffers[0].uri", "folder"]),
    ("scheme", |d| buffer_uri(d, "file:///etc/passwd"), &["buffers[0].uri", "not a relative path"]),
    ("web", |d| buffer_uri(d, "https://example.org/x.bin"), &["buffers[0].uri", "not a relative path"]),
    ("folder", |d| buffer_uri(d, "."), &["not a regular file"]),
    ("bad UTF-8", |d| buffer_uri(d, "%ff"), &["buffers[0].uri", "UTF-8"]),
    ("NUL", |d| buffer_uri(d, "a%00b"), &["buffers[0].uri", "names no file"]),
    ("data URI", |d| buffer_uri(d, "data:;base64,%%%"), &["buffers[0].uri", "base64"]),
];

fn primitive(doc: &mut Doc) -> &mut Value {
    &mut doc.json["meshes"][0]["primitives"][0]
}

fn float(doc: &mut Doc, index: usize, value: f32) {
    doc.bin[4 * index..4 * index + 4].copy_from_slice(&value.to_le_bytes());
}

fn indices(doc: &mut Doc, component: u32, bytes: &[u8]) {
    let accessor = doc.accessor("SCALAR", component, 3, bytes);
    primitive(doc)["indices"] = json!(accessor);
}

fn huge_zeros(doc: &mut Doc) {
    doc.json["accessors"][0] = json!({"type": "VEC3", "componentType": 5126, "count": 4_000_000_000_u64});
}

fn short_normals(doc: &mut Doc) {
    let normals = doc.floats("VEC3", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    primitive(doc)["attributes"]["NORMAL"] = json!(normals);
}

/// Each of 64 nodes has the next one twice: 2⁶⁴ paths.
fn doubling_graph(doc: &mut Doc) {
    doc.json["nodes"] =
        (0..64).map(|i| json!({"children": [i + 1, i + 1]})).chain([json!({"mesh": 0})]).collect();
}

fn sparse(doc: &mut Doc, indices: &[u8], count: u64) {
    let indices = doc.view(indices);
    let values = doc.view(&[0; 24]);
    doc.json["accessors"][0]["sparse"] = json!({"count": count, "values": {"bufferView": values},
        "indices": {"bufferView": indices, "componentType": U8}});
}

fn joint_past_skin(doc: &mut Doc) {
    let joints = doc.accessor("VEC4", U8, 3, &[1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    let weights = doc.floats("VEC4", &[1.0; 12]);
    primitive(doc)["attributes"]["JOINTS_0"] = json!(joints);
    primitive(doc)["attributes"]["WEIGHTS_0"] = json!(weights);
    doc.json["skins"] = json!([{"joints": [0]}]);
    doc.json["nodes"][0]["skin"] = json!(0);
}

fn joints_without_weights(doc: &mut Doc) {
    joint_past_skin(doc);
    primitive(doc)["attributes"].as_object_mut().unwrap().remove("WEIGHTS_0");
}

fn few_bind_matrices(doc: &mut Doc) {
    let matrices = doc.floats("MAT4", &[]);
    doc.json["skins"] = json!([{"joints": [0], "inverseBindMatrices": matrices}]);
}

/// Keys at 0 s and 1 s, with values for `keys` of them.
fn animation(doc: &mut Doc, target: Value, keys: usize) {
    let input = doc.floats("SCALAR", &[0.0, 1.0]);
    let output = doc.floats("VEC3", &vec![1.0; 3 * keys]);
    doc.push(
        "animations",
        json!({"channels": [{"sampler": 0, "target": target}], "samplers": [{"input": input, "output": output}]}),
    );
}

fn posed_overflow(doc: &mut Doc) {
    let target = doc.floats("VEC3", &[0.0, 0.0, 0.0, 3e38, 0.0, 0.0, 0.0, 0.0, 0.0]);
    primitive(doc)["targets"] = json!([{"POSITION": target}]);
    doc.json["nodes"][0]["weights"] = json!([2]);
}

fn image(doc: &mut Doc, bytes: &[u8]) {
    let view = doc.view(bytes);
    doc.json["images"] = json!([{"bufferView": view, "name": "leaf"}]);
    doc.json["textures"] = json!([{"source": 0}]);
    doc.json["materials"] = json!([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]);
}

/// A PNG whose header claims this size.
fn huge_png(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = png(1, 1, &[[0; 4]]);
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let crc = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&crc.to_be_bytes());
    bytes
}

fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc: u32, &b| (0..8).fold(crc ^ u32::from(b), step))
}

fn light(doc: &mut Doc, light: Value) {
    doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [light]}});
    doc.json["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
}

fn buffer_uri(doc: &mut Doc, uri: &str) {
    doc.json["buffers"] = json!([{"byteLength": 36, "uri": uri}]);
}

#[test]
fn every_malformed_file_is_refused_by_naming_the_place() {
    let mut failures = Vec::new();
    for (name, break_it, words) in CASES {
        let mut doc = Doc::triangle();
        break_it(&mut doc);
        let message = doc.refusal();
        let is_named = message.contains("scene.glb") || message.contains(words[0]);
        if !is_named || words.iter().any(|w| !message.contains(w)) {
            failures.push(format!("{name}: {message:?} lacks one of {words:?}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn broken_containers_say_what_was_expected_and_found() {
    let glb = Doc::triangle().glb();
    let with = |at: usize, word: u32| {
        let mut bytes = glb.clone();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        bytes
    };
    let longer = [glb.clone(), vec![0; 4]].concat();
    let (length, half) = (glb.len(), glb.len() / 2);
    let expected = format!("expected a file of {length} bytes, found ");
    for (bytes, words) in [
        (Vec::new(), "empty"),
        (glb[..7].to_vec(), "expected 12 bytes, found 7"),
        (glb[..half].to_vec(), &*format!("{expected}{half}")),
        (longer, &*format!("{expected}{}", length + 4)),
        (with(4, 1), "version 1"),
        (with(8, 3), "expected a file of 3 bytes"),
        (with(12, 0xFFFF_FFF0), "GLB chunk 0 at byte 12: expected 4294967280 bytes"),
        (with(16, 7), "expected JSON, found chunk type 0x00000007"),
        (b"not json".to_vec(), "JSON: expected"),
        (b"[1, 2".to_vec(), "JSON"),
        (vec![b'['; 100_000], "JSON"),
    ] {
        let message = refusal(&bytes);
        assert!(message.contains(words), "{message:?} lacks {words:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_folder_is_refused() {
    let (folder, outside) = (TempDir::new().unwrap(), TempDir::new().unwrap());
    let mut doc = Doc::triangle();
    fs::write(outside.path().join("x.bin"), &doc.bin).unwrap();
    std::os::unix::fs::symlink(outside.path().join("x.bin"), folder.path().join("x.bin")).unwrap();
    std::os::unix::fs::symlink(outside.path(), folder.path().join("sub")).unwrap();
    for uri in ["x.bin", "sub/x.bin"] {
        buffer_uri(&mut doc, uri);
        let error = open_in(folder.path(), "scene.glb", &doc.glb()).unwrap_err().to_string();
        assert!(error.contains("through a link"), "{error}");
    }
}

#[test]
fn shared_data_cannot_unfold_without_bound() {
    // A million vertices of zeros with ten thousand morph targets.
    let mut doc = Doc::triangle();
    let zeros = doc.push("accessors", json!({"type": "VEC3", "componentType": 5126, "count": 1_000_000}));
    let target = json!({"POSITION": zeros});
    let targets: Vec<_> = std::iter::repeat_n(target, 10_000).collect();
    doc.json["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": zeros}, "targets": targets}]}]);
    let message = doc.refusal();
    assert!(message.contains("meshes[0].primitives[0]") && message.contains("split it"), "{message}");
}

#[test]
fn errors_have_the_right_kind() {
    let mut doc = Doc::triangle();
    doc.json["extensionsRequired"] = json!(["ACME_magic"]);
    assert!(matches!(doc.open(), Err(SceneError::UnsupportedExtension { .. })));
    doc.json = json!({});
    assert!(matches!(doc.open(), Err(SceneError::Malformed { .. })));
    let missing = lt_scene::gltf::GltfAsset::open("no/such/file.glb".as_ref());
    assert!(matches!(missing, Err(SceneError::Io { .. })));
}
