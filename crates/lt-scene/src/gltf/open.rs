//! Loads a file: container, buffers, then everything that shown nodes refer to.

use std::{collections::HashSet, path::Path};

use lt_math::glam::DVec3;

use super::{
    accessors::Accessors,
    animation::Animation,
    budget::Budget,
    buffers::Buffers,
    cameras::Lens,
    container,
    extras::Shadows,
    fault::{Fault, pick},
    files::Files,
    images,
    json::{self, Root},
    lights::Lamp,
    materials::{self, Surface},
    nodes::Hierarchy,
    pose::{Asset, Load},
    primitives::{Primitive, PrimitiveReader},
    skin::Skin,
};
use crate::Repairs;

/// Reads and checks the file at `path`.
pub(super) fn open(path: &Path) -> Result<Asset, Fault> {
    let bytes = container::read_file(path)?;
    let (text, chunk) = container::split(&bytes)?;
    let root = &json::parse(text)?;
    let mut repairs = Repairs::default();
    let hierarchy = Hierarchy::read(root, &mut repairs)?;
    let mut files = Files::beside(path);
    let buffers = Buffers::load(root, chunk, &mut files)?;
    let accessors = Accessors::new(root, &buffers);
    let (surfaces, images) = materials::read(root, &mut repairs)?;
    let loads = loads(root, &hierarchy, &mut repairs)?;
    let budget = Budget::for_bytes(buffers.total_bytes());
    let mut reader =
        PrimitiveReader { root, accessors: &accessors, surfaces: &surfaces, budget: budget.clone(), repairs };
    let meshes = meshes(&mut reader, &loads)?;
    let skins = (0..root.skins.len())
        .map(|i| Skin::read(root, &accessors, i, &mut reader.budget))
        .collect::<Result<Vec<_>, _>>()?;
    check_joints(&loads, &meshes, &skins)?;
    let weights = weights(root, &loads, &mut reader.budget)?;
    let PrimitiveReader { budget: mut left, mut repairs, .. } = reader;
    let animation = Animation::read(root, &accessors, &hierarchy, &weights, &mut left, &mut repairs)?;
    let textures = images::decode(root, &images, &buffers, &mut files)?;
    let materials = with_default(surfaces, &meshes).into_iter().map(|s| s.material).collect();
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let mut asset = Asset {
        name,
        hierarchy,
        loads,
        weights,
        meshes,
        skins,
        animation,
        materials,
        textures,
        repairs,
        origin: DVec3::ZERO,
        budget,
    };
    asset.origin = asset.near_origin();
    if asset.origin != DVec3::ZERO {
        let note = format!(
            "far from the file's origin: all places, given ones too, are relative to {}",
            asset.origin
        );
        asset.repairs.notes.push(note);
    }
    Ok(asset)
}

/// What shown nodes carry, every reference checked.
fn loads(root: &Root, hierarchy: &Hierarchy, repairs: &mut Repairs) -> Result<Vec<Load>, Fault> {
    let load = |(i, node): (usize, &json::Node)| {
        let place = |field: &str| format!("nodes[{i}].{field}");
        if let Some(mesh) = node.mesh {
            pick(&root.meshes, mesh, "meshes", || place("mesh"))?;
        }
        if let Some(skin) = node.skin {
            pick(&root.skins, skin, "skins", || place("skin"))?;
        }
        if !hierarchy.is_shown[i] {
            return Ok(Load::default());
        }
        let lens = match node.camera {
            Some(camera) => Lens::read(root, camera, i, repairs)?,
            None => None,
        };
        let lamp = match &node.extensions.light {
            Some(light) => Some(Lamp::read(root, light.light, i)?),
            None => None,
        };
        let shadows = Shadows::read(node, i, repairs);
        Ok(Load { mesh: node.mesh, skin: node.skin, shadows, lens, lamp })
    };
    root.nodes.iter().enumerate().map(load).collect()
}

/// The primitives of every mesh that is shown.
fn meshes(reader: &mut PrimitiveReader<'_, '_>, loads: &[Load]) -> Result<Vec<Vec<Primitive>>, Fault> {
    let mut is_used = vec![false; reader.root.meshes.len()];
    loads.iter().filter_map(|load| load.mesh).for_each(|mesh| is_used[mesh] = true);
    let read = |(i, is_used): (usize, bool)| if is_used { reader.mesh(i) } else { Ok(Vec::new()) };
    is_used.into_iter().enumerate().map(read).collect()
}

/// Every joint that a shown mesh follows must be in the skin it is shown with.
fn check_joints(loads: &[Load], meshes: &[Vec<Primitive>], skins: &[Skin]) -> Result<(), Fault> {
    let mut checked = HashSet::new();
    for (i, load) in loads.iter().enumerate() {
        let (Some(mesh), Some(skin)) = (load.mesh, load.skin) else { continue };
        if !checked.insert((mesh, skin)) {
            continue;
        }
        for influences in meshes[mesh].iter().filter_map(|p| p.influences.as_ref()) {
            influences.check(skins[skin].joints.len(), || format!("nodes[{i}].skin (skins[{skin}])"))?;
        }
    }
    Ok(())
}

/// Morph weights at rest by node: as many as the mesh has targets; the node's own come before the mesh's.
fn weights(root: &Root, loads: &[Load], budget: &mut Budget) -> Result<Vec<Vec<f32>>, Fault> {
    let of = |(i, load): (usize, &Load)| {
        let Some(mesh) = load.mesh.map(|m| &root.meshes[m]) else { return Ok(Vec::new()) };
        let targets = mesh.primitives.iter().map(|p| p.targets.len()).max().unwrap_or(0);
        budget.charge(targets as u64, || format!("nodes[{i}].weights"))?;
        let given = root.nodes[i].weights.as_ref().unwrap_or(&mesh.weights);
        if given.iter().any(|w| !w.is_finite()) {
            return Err(Fault::at(format!("nodes[{i}].weights"), "not finite"));
        }
        let mut weights: Vec<f32> = given.iter().copied().take(targets).collect();
        weights.resize(targets, 0.0);
        Ok(weights)
    };
    loads.iter().enumerate().map(of).collect()
}

/// Adds the default material if a primitive needs it.
fn with_default(mut surfaces: Vec<Surface>, meshes: &[Vec<Primitive>]) -> Vec<Surface> {
    let count = surfaces.len() as u32;
    if meshes.iter().flatten().any(|p| p.mesh.material == count) {
        surfaces.push(Surface::plain());
    }
    surfaces
}
