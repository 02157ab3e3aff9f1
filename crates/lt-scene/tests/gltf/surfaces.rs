//! Materials, textures, vertex colours, lights, cameras.

use std::fs;

use lt_math::glam::{Vec2, Vec3, Vec4, vec2, vec3};
use lt_scene::{AlphaMode, LightKind, Wrap};
use serde_json::json;
use tempfile::TempDir;

use crate::builder::{Doc, F32, U8, U16, open_in, png};

const RED: [u8; 4] = [255, 0, 0, 255];
const CLEAR: [u8; 4] = [0, 0, 255, 51];

/// The triangle with texture coordinates (0,0), (1,0), (0,1) and a 2×1 texture, red and clear.
fn textured() -> Doc {
    let mut doc = Doc::triangle();
    let uvs = doc.floats("VEC2", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let view = doc.view(&png(2, 1, &[RED, CLEAR]));
    doc.push("images", json!({"bufferView": view, "name": "leaf"}));
    doc.push("samplers", json!({"magFilter": 9728, "wrapS": 33071, "wrapT": 33648}));
    doc.push("textures", json!({"source": 0, "sampler": 0}));
    doc.push("textures", json!({"source": 0}));
    doc.push("materials", json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
    let primitive = &mut doc.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = json!(uvs);
    primitive["material"] = json!(0);
    doc
}

#[test]
fn a_texture_brings_its_texels_wrapping_and_filter() {
    let scene = textured().pose(0.0);
    let texture = &scene.textures[0];
    assert_eq!((texture.width, texture.height, &*texture.texels), (2, 1, &[RED, CLEAR][..]));
    let reference = scene.materials[0].texture.unwrap();
    assert_eq!(reference.wrap, [Wrap::ClampToEdge, Wrap::MirroredRepeat]);
    assert!(reference.is_nearest);
    assert_eq!(scene.meshes[0].uvs, [Vec2::ZERO, Vec2::X, Vec2::Y]);
    let mut doc = textured();
    doc.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = json!(1);
    let reference = doc.pose(0.0).materials[0].texture.unwrap();
    assert_eq!((reference.wrap, reference.is_nearest), ([Wrap::Repeat; 2], false));
}

#[test]
fn images_come_from_files_and_data_uris_too() {
    let doc = textured();
    let folder = TempDir::new().unwrap();
    let bytes = png(1, 1, &[CLEAR]);
    fs::write(folder.path().join("one pixel.png"), &bytes).unwrap();
    let hex: String = bytes.iter().map(|b| format!("%{b:02x}")).collect();
    for uri in ["one%20pixel.png".to_owned(), format!("data:image/png,{hex}")] {
        let mut doc = doc.clone();
        doc.json["images"][0] = json!({"uri": uri});
        let scene = open_in(folder.path(), "a.glb", &doc.glb()).unwrap().pose(0.0).unwrap();
        assert_eq!(&*scene.textures[0].texels, &[CLEAR]);
    }
}

#[test]
fn sixteen_bit_images_become_eight_bit() {
    let mut doc = textured();
    let image =
        image::ImageBuffer::<image::Rgba<u16>, _>::from_raw(1, 1, vec![65535_u16, 0, 257, 32896]).unwrap();
    let mut bytes = std::io::Cursor::new(Vec::new());
    image::DynamicImage::ImageRgba16(image).write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    let view = doc.view(bytes.get_ref());
    doc.json["images"][0]["bufferView"] = json!(view);
    assert_eq!(&*doc.pose(0.0).textures[0].texels, &[[255, 0, 1, 128]]);
}

#[test]
fn images_that_no_base_colour_uses_are_not_even_opened() {
    let mut doc = textured();
    doc.push("images", json!({"uri": "missing.png"}));
    doc.push("textures", json!({"source": 1}));
    doc.json["materials"][0]["normalTexture"] = json!({"index": 2});
    assert_eq!(doc.pose(0.0).textures.len(), 1);
}

#[test]
fn a_texture_transform_is_applied_to_the_coordinates() {
    let mut doc = textured();
    // The extension's own example: the lower left quadrant, rotated.
    doc.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = json!({
        "KHR_texture_transform": {"offset": [0, 1], "rotation": std::f32::consts::FRAC_PI_2, "scale": [0.5, 0.5]}});
    let scene = doc.pose(0.0);
    let expected = [vec2(0.0, 1.0), vec2(0.0, 0.5), vec2(0.5, 1.0)];
    for (found, expected) in scene.meshes[0].uvs.iter().zip(expected) {
        assert!((*found - expected).length() < 1e-6, "{found} is not {expected}");
    }
}

#[test]
fn the_transform_may_choose_another_set_of_quantized_coordinates() {
    let mut doc = textured();
    let bytes = [0_u16, 0, 65535, 0, 0, 32768].map(u16::to_le_bytes).concat();
    let uvs = doc.accessor("VEC2", U16, 3, &bytes);
    doc.json["accessors"][uvs]["normalized"] = json!(true);
    doc.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_3"] = json!(uvs);
    doc.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] =
        json!({"KHR_texture_transform": {"texCoord": 3}});
    assert_eq!(doc.pose(0.0).meshes[0].uvs, [Vec2::ZERO, Vec2::X, vec2(0.0, 32768.0 / 65535.0)]);
}

#[test]
fn coverage_and_translucency_are_kept() {
    let mut doc = Doc::triangle();
    doc.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    doc.json["extensionsRequired"] = json!(["KHR_materials_transmission", "KHR_materials_emissive_strength"]);
    let factor = json!({"baseColorFactor": [0.5, 0.25, 0, 0.75]});
    doc.json["materials"] = json!([
        {"name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.9, "doubleSided": true, "pbrMetallicRoughness": factor},
        {"alphaMode": "MASK"},
        {"alphaMode": "BLEND"},
        {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.6},
                        "KHR_materials_emissive_strength": {"emissiveStrength": 4}}, "emissiveFactor": [1, 0, 0.5]},
        {"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.25, 0, 0.75]}, "ACME_x": 7}},
    ]);
    let materials = doc.pose(0.0).materials;
    let alphas: Vec<AlphaMode> = materials.iter().map(|m| m.alpha).collect();
    let [mask9, mask5] = [0.9, 0.5].map(|cutoff| AlphaMode::Mask { cutoff });
    assert_eq!(alphas, [mask9, mask5, AlphaMode::Blend, AlphaMode::Opaque, AlphaMode::Opaque]);
    assert_eq!((materials[0].name.as_str(), materials[0].is_double_sided), ("leaf", true));
    assert_eq!(materials[0].base_color, Vec4::new(0.5, 0.25, 0.0, 0.75));
    assert_eq!(materials[4].base_color, materials[0].base_color);
    assert_eq!((materials[3].transmission, materials[3].emissive), (0.6, vec3(4.0, 0.0, 2.0)));
    assert_eq!(Doc::triangle().pose(0.0).materials[0].base_color, Vec4::ONE, "default material");
}

#[test]
fn vertex_colours_of_every_format_become_bytes() {
    let mut doc = Doc::triangle();
    let bytes = doc.accessor("VEC4", U8, 3, &[255, 0, 0, 51, 0, 255, 0, 102, 0, 0, 255, 153]);
    doc.json["accessors"][bytes]["normalized"] = json!(true);
    let rgb: Vec<u8> = [1.0_f32, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 9.0].map(f32::to_le_bytes).concat();
    let rgb = doc.accessor("VEC3", F32, 3, &rgb);
    let mut colors = |accessor: usize| {
        doc.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = json!(accessor);
        doc.pose(0.0).meshes[0].colors.clone()
    };
    assert_eq!(colors(bytes), [[255, 0, 0, 51], [0, 255, 0, 102], [0, 0, 255, 153]]);
    assert_eq!(colors(rgb), [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]]);
}

#[test]
fn what_cannot_be_shown_is_noted() {
    let mut doc = textured();
    doc.json["meshes"][0]["primitives"][0]["attributes"] = json!({"POSITION": 0});
    doc.json["meshes"][0]["primitives"].as_array_mut().unwrap().push(json!({"attributes": {}}));
    doc.json["cameras"] = json!([{"type": "orthographic", "orthographic": {}}]);
    doc.json["nodes"][0]["camera"] = json!(0);
    let notes = doc.pose(0.0).repairs.summary().unwrap();
    for expected in ["lacks TEXCOORD_0", "has no POSITION", "cameras[0] is orthographic"] {
        assert!(notes.contains(expected), "{notes}");
    }
}

#[test]
fn lights_and_cameras_stand_where_their_nodes_do() {
    let mut doc = Doc::triangle();
    let h = std::f32::consts::FRAC_1_SQRT_2;
    doc.json["extensionsRequired"] = json!(["KHR_lights_punctual"]);
    doc.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.5, 0], "intensity": 3},
        {"type": "point", "name": "bulb", "range": 9},
        {"type": "spot", "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}}]}});
    let light = |i: usize| json!({"KHR_lights_punctual": {"light": i}});
    doc.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 0.75, "znear": 0.1}}]);
    // A quarter turn about x takes −z to +y: everything looks up.
    doc.json["nodes"] = json!([
        {"translation": [1, 2, 3], "rotation": [h, 0, 0, h], "scale": [5, 5, 5], "children": [1, 2, 3, 4]},
        {"extensions": light(0), "name": "sky"}, {"extensions": light(1)}, {"extensions": light(2)},
        {"camera": 0, "name": "eye", "mesh": 0},
    ]);
    let scene = doc.pose(0.0);
    let place = vec3(1.0, 2.0, 3.0);
    let near = |a: Vec3, b: Vec3| (a - b).length() < 1e-5;
    let LightKind::Directional { direction } = scene.lights[0].kind else { panic!() };
    assert!(near(direction, Vec3::Y), "{direction}");
    assert_eq!((scene.lights[0].name.as_str(), scene.lights[0].intensity), ("sky", 3.0));
    assert_eq!(scene.lights[0].color, vec3(1.0, 0.5, 0.0));
    let LightKind::Point { position, range } = scene.lights[1].kind else { panic!() };
    assert!(near(position, place) && range == 9.0 && scene.lights[1].name == "bulb");
    let LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, range } = scene.lights[2].kind
    else {
        panic!()
    };
    assert!(near(position, place) && near(direction, Vec3::Y) && range == f32::INFINITY);
    assert_eq!((inner_cone_rad, outer_cone_rad), (0.25, 0.5));
    let camera = &scene.cameras[0];
    assert!(near(camera.eye, place) && near(camera.target, place + Vec3::Y) && near(camera.up, Vec3::Z));
    assert_eq!((camera.name.as_str(), camera.fov_y_rad), ("eye", 0.75));
}

#[test]
fn extras_say_what_casts_and_receives() {
    let mut doc = Doc::triangle();
    doc.json["nodes"][0]["extras"] = json!({"castShadow": false, "children": "none of it"});
    doc.json["nodes"][0]["children"] = json!([1, 2]);
    doc.push("nodes", json!({"mesh": 0, "extras": {"receiveShadow": false, "castShadow": true}}));
    doc.push("nodes", json!({"mesh": 0, "extras": [1, 2]}));
    let scene = doc.pose(0.0);
    let flags: Vec<_> = scene.instances.iter().map(|i| (i.casts_shadow, i.receives_shadow)).collect();
    assert_eq!(flags, [(false, true), (true, false), (true, true)], "children inherit nothing");
    assert_eq!(scene.repairs.summary(), None);
}

#[test]
fn extras_of_other_types_are_noted_by_their_node() {
    let mut doc = Doc::triangle();
    doc.json["nodes"][0]["extras"] = json!({"castShadow": 0, "receiveShadow": null});
    let scene = doc.pose(0.0);
    assert!(scene.instances[0].casts_shadow && scene.instances[0].receives_shadow);
    let notes = scene.repairs.summary().unwrap();
    for expected in ["nodes[0].extras.castShadow is 0", "nodes[0].extras.receiveShadow is null"] {
        assert!(notes.contains(expected), "{notes}");
    }
}
