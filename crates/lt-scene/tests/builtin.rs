//! Every procedural place: named, bounded, valid, reproducible.

use std::{
    collections::hash_map::DefaultHasher,
    hash::{Hash, Hasher},
};

use lt_scene::{LightKind, Scene, SceneError, builtin::Builtin};

/// A small size of each place, so that a debug build tests all of them in seconds.
fn small(name: &str) -> Builtin {
    let size = match name {
        "street" => 6,
        "square" => 8,
        "forest" => 20,
        "town" => 60,
        "random" => 5000,
        "hairball" | "strands" => 12,
        _ => 10,
    };
    Builtin::parse(&format!("{name}:{size}")).expect("a size in range")
}

fn names() -> impl Iterator<Item = &'static str> {
    Builtin::catalogue().iter().map(|p| p.name)
}

/// All that makes up the scene, bit for bit.
fn digest(scene: &Scene) -> u64 {
    let mut h = DefaultHasher::new();
    let bits = |v: &[f32], h: &mut DefaultHasher| v.iter().for_each(|f| f.to_bits().hash(h));
    for m in &scene.meshes {
        m.positions.iter().for_each(|p| bits(&p.to_array(), &mut h));
        m.normals.iter().for_each(|p| bits(&p.to_array(), &mut h));
        m.uvs.iter().for_each(|p| bits(&p.to_array(), &mut h));
        (&m.colors, &m.indices, m.material, &m.name).hash(&mut h);
    }
    for i in &scene.instances {
        bits(&i.transform.to_cols_array(), &mut h);
        (i.mesh, i.is_dynamic).hash(&mut h);
    }
    scene.textures.iter().for_each(|t| t.texels.hash(&mut h));
    format!("{:?} {:?} {:?}", scene.materials, scene.lights, scene.cameras).hash(&mut h);
    h.finish()
}

fn assert_valid(name: &str, scene: &Scene) {
    assert!(scene.triangle_count() > 0, "{name}: empty");
    for m in &scene.meshes {
        let n = m.positions.len();
        assert_eq!(m.indices.len() % 3, 0, "{name}/{}", m.name);
        assert!(m.indices.iter().all(|&i| (i as usize) < n), "{name}/{}: index", m.name);
        assert!((m.material as usize) < scene.materials.len(), "{name}/{}: material", m.name);
        for (what, len) in [("normals", m.normals.len()), ("uvs", m.uvs.len()), ("colors", m.colors.len())] {
            assert!(len == 0 || len == n, "{name}/{}: {len} {what} for {n} vertices", m.name);
        }
        assert!(m.positions.iter().all(|p| p.is_finite()), "{name}/{}: position", m.name);
        assert!(m.normals.iter().all(|v| (v.length() - 1.0).abs() < 1e-3), "{name}/{}: normal", m.name);
        assert!(m.uvs.iter().all(|v| v.is_finite()), "{name}/{}: uv", m.name);
        for t in m.indices.as_chunks::<3>().0 {
            let [a, b, c] = t.map(|i| m.positions[i as usize].as_dvec3());
            assert!(
                (b - a).cross(c - a).length() > 0.0,
                "{name}/{}: triangle {a} {b} {c} has no area",
                m.name
            );
        }
        let material = &scene.materials[m.material as usize];
        assert_eq!(material.texture.is_some(), !m.uvs.is_empty(), "{name}/{}: uvs", m.name);
    }
    for i in &scene.instances {
        assert!((i.mesh as usize) < scene.meshes.len());
        assert!(i.transform.is_finite() && i.transform.matrix3.determinant() > 1e-6, "{name}: transform");
    }
    for t in &scene.textures {
        assert_eq!(t.texels.len(), (t.width * t.height) as usize, "{name}: texture {}", t.name);
    }
    assert!(
        scene.materials.iter().filter_map(|m| m.texture).all(|t| (t.texture as usize) < scene.textures.len())
    );
    let LightKind::Directional { direction } = scene.lights[0].kind else { panic!("{name}: no sun") };
    assert!(direction.is_normalized() && direction.y < -0.1, "{name}: the sun stands too low");
    let camera = &scene.cameras[0];
    assert!(camera.eye.is_finite() && camera.eye.distance(camera.target) > 0.1, "{name}: camera");
}

#[test]
fn every_place_is_valid_at_its_default_size() {
    for name in names() {
        assert_valid(name, &Builtin::parse(name).unwrap().pose(0.0));
    }
}

#[test]
fn every_place_is_valid_at_its_least_size_and_for_other_seeds() {
    for place in Builtin::catalogue() {
        let least = Builtin::parse(&format!("{}:{}", place.name, place.sizes.start())).unwrap();
        assert_valid(place.name, &least.pose(0.0));
        for seed in [0, 2, u64::MAX] {
            assert_valid(place.name, &small(place.name).with_seed(seed).pose(1.5));
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_bytes_and_another_seed_does_not() {
    for name in names() {
        let [a, again, other] = [7, 7, 8].map(|seed| digest(&small(name).with_seed(seed).pose(0.25)));
        assert_eq!(a, again, "{name}");
        assert_ne!(a, other, "{name}");
    }
}

#[test]
fn time_moves_dynamic_instances_and_nothing_else() {
    for name in names() {
        let [start, later] = [0.0, 2.0].map(|t| small(name).pose(t));
        for (a, b) in start.instances.iter().zip(&later.instances) {
            assert_eq!(
                a.transform != b.transform,
                a.is_dynamic,
                "{name}: {}",
                start.meshes[a.mesh as usize].name
            );
        }
        let moves = start.instances.iter().any(|i| i.is_dynamic);
        assert_eq!(moves, name == "forest", "{name}");
        assert_eq!(digest(&small(name).pose(f32::NAN)), digest(&start), "{name}");
    }
}

#[test]
fn size_changes_what_it_says() {
    let count = |text: &str| Builtin::parse(text).unwrap().pose(0.0).triangle_count();
    assert_eq!(count("random:1234"), 1234 + 2);
    let hairs = |n: u32| count(&format!("hairball:{n}"));
    assert_eq!(hairs(9) - hairs(4), 5 * 576);
    for name in ["street", "square", "forest", "town", "fence", "cornell"] {
        assert!(count(&format!("{name}:40")) > count(&format!("{name}:10")), "{name}");
    }
}

#[test]
fn random_triangles_keep_their_total_area() {
    for n in [1, 10, 5000] {
        let scene = Builtin::parse(&format!("random:{n}")).unwrap().pose(0.0);
        let mesh = &scene.meshes[0];
        let area: f64 = mesh
            .indices
            .as_chunks::<3>()
            .0
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| mesh.positions[i as usize].as_dvec3());
                0.5 * (b - a).cross(c - a).length()
            })
            .sum();
        assert!((area - 24.0).abs() < 0.05, "{n} triangles cover {area} m²");
    }
}

#[test]
fn unknown_names_list_the_known_ones() {
    for text in ["", "strasse", "street2", ":5", "Street"] {
        let Err(SceneError::UnknownScene(message)) = Builtin::parse(text) else {
            panic!("{text:?} was accepted")
        };
        assert!(names().all(|name| message.contains(name)), "{message}");
    }
}

#[test]
fn sizes_out_of_range_name_the_range() {
    for place in Builtin::catalogue() {
        let (least, most) = (place.sizes.start(), place.sizes.end());
        for size in [
            (least - 1).to_string(),
            (most + 1).to_string(),
            String::new(),
            "-1".into(),
            "1e3".into(),
            "99999999999".into(),
        ] {
            let Err(SceneError::UnknownScene(message)) = Builtin::parse(&format!("{}:{size}", place.name))
            else {
                panic!("{}:{size} was accepted", place.name)
            };
            assert!(message.contains(&least.to_string()) && message.contains(&most.to_string()), "{message}");
        }
        assert!(place.sizes.contains(&place.default_size));
    }
}
