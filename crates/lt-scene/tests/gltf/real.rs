//! Scenes nobody here made; skipped, saying so, where they are absent.

use std::path::{Path, PathBuf};

use lt_math::glam::Vec3;
use lt_scene::{AlphaMode, Scene, gltf::GltfAsset};

use crate::geometry::corners;

fn scene_file(name: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/scenes");
    let path = folder.join(name);
    if !path.exists() {
        println!("skipped: {} is absent", path.display());
        return None;
    }
    Some(path)
}

fn pose(name: &str, time_s: f32) -> Option<Scene> {
    Some(GltfAsset::open(&scene_file(name)?).unwrap().pose(time_s).unwrap())
}

/// Surface area in the world.
fn area(scene: &Scene) -> f64 {
    let of = |t: &[Vec3]| 0.5 * f64::from((t[1] - t[0]).cross(t[2] - t[0]).length());
    corners(scene).chunks_exact(3).map(of).sum()
}

/// Areas, without skins, were computed by `shared/tools/embree_truth.py`, an independent reader in numpy.
#[test]
fn triangles_drawn_and_dropped_add_up_and_cover_what_another_reader_finds() {
    for (name, triangles, expected_area) in [
        ("sponza.glb", 262_267, Some(12_668.981_8)),
        ("quaternius_trees.glb", 15_980, Some(1_169.706_72)),
        ("leaves_ao.glb", 20_742, Some(1.301_150_17)),
        ("glass_vase_flowers.glb", 14_036, Some(0.135_399_96)),
        ("broken_window.glb", 987, Some(0.485_812_911)),
        ("ratboy_hair.glb", 168_930, Some(1.278_309_64)),
        ("fox.glb", 576, None),
        ("truck_town.glb", 30_477, Some(4_205_790.71)),
        ("cornell_suzanne.glb", 4_006, Some(75.467_116_5)),
    ] {
        let Some(scene) = pose(name, 0.0) else { continue };
        println!(
            "{name}: {} of {triangles}, {:?}, {:?}",
            scene.triangle_count(),
            scene.bounds(),
            scene.repairs
        );
        assert_eq!(scene.triangle_count() + scene.repairs.degenerate_triangles, triangles, "{name}");
        assert_eq!(scene.repairs.singular_instances, 0, "{name}");
        if let Some(expected) = expected_area {
            let found = area(&scene);
            assert!((found / expected - 1.0_f64).abs() < 1e-5, "{name}: {found} is not {expected}");
        }
    }
}

#[test]
fn leaves_and_glass_are_known_as_such() {
    if let Some(leaves) = pose("leaves_ao.glb", 0.0) {
        assert!(
            leaves
                .materials
                .iter()
                .any(|m| m.alpha == AlphaMode::Mask { cutoff: 0.9 } && m.texture.is_some())
        );
    }
    if let Some(vase) = pose("glass_vase_flowers.glb", 0.0) {
        assert!(
            vase.materials.iter().any(|m| m.alpha == AlphaMode::Blend && (m.base_color.w - 0.3).abs() < 0.01)
        );
        assert!(vase.materials.iter().any(|m| m.transmission > 0.0));
    }
    if let Some(room) = pose("cornell_suzanne.glb", 0.0) {
        assert_eq!(room.cameras.len(), 1);
    }
}

#[test]
fn the_fox_moves_and_comes_back() {
    let Some(path) = scene_file("fox.glb") else { return };
    let asset = GltfAsset::open(&path).unwrap();
    let duration = asset.animation_duration_s();
    assert!(duration > 0.5, "{duration}");
    let at = |time_s: f32| asset.pose(time_s).unwrap();
    let (start, middle, again) = (at(0.0), at(0.4 * duration), at(duration));
    assert!(start.instances.iter().all(|i| i.is_dynamic));
    let distance = |a: &Scene, b: &Scene| {
        let pairs = a.meshes[0].positions.iter().zip(&b.meshes[0].positions);
        pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max)
    };
    assert!(distance(&start, &middle) > 1.0);
    assert_eq!(distance(&start, &again), 0.0);
}
