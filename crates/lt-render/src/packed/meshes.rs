//! Which meshes are baked and which are instanced, and their triangles as builders want them.

use std::collections::BTreeMap;

use lt_math::glam::{Affine3A, Mat3, Vec3, Vec4};
use lt_scene::{Mesh, Scene};
use lt_shaders::{abi::Vertex, surface::octahedral_encode};

use super::textures::PackedMaterials;

/// Instances that share one tree: every placement of one mesh, or all that are baked.
pub struct Group {
    /// Indices into `Scene::instances`.
    pub members: Vec<usize>,
    /// Whether the tree stays in object space and is placed once per member.
    pub is_instanced: bool,
}

/// Triangles of one tree.
pub struct Soup {
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: whether hits must ask the alpha test.
    pub has_holes: Vec<bool>,
}

/// Sorts instances into trees; the baked ones come first. Always at least one group.
pub fn group(scene: &Scene, bake_all_limit: usize) -> Vec<Group> {
    let mut uses: BTreeMap<(u32, bool, bool, bool), Vec<usize>> = BTreeMap::new();
    for (i, instance) in scene.instances.iter().enumerate() {
        let key = (instance.mesh, instance.casts_shadow, instance.receives_shadow, instance.is_dynamic);
        uses.entry(key).or_default().push(i);
    }
    let bake_all = scene.triangle_count() <= bake_all_limit;
    // What moves is baked: motion vectors then need the last positions of vertices alone, not of instances.
    let (baked, instanced): (Vec<_>, Vec<_>) = uses
        .into_iter()
        .map(|(key, members)| (key.3, members))
        .partition(|(is_dynamic, members)| bake_all || *is_dynamic || members.len() == 1);
    let [baked, instanced] = [baked, instanced].map(|uses| uses.into_iter().map(|u| u.1));
    let mut groups: Vec<Group> = instanced.map(|members| Group { members, is_instanced: true }).collect();
    let members: Vec<usize> = baked.flatten().collect();
    if !members.is_empty() || groups.is_empty() {
        groups.insert(0, Group { members, is_instanced: false });
    }
    groups
}

/// Every placement of a caster that lets light through in part, baked.
pub fn translucent_casters(scene: &Scene) -> Group {
    let is_one = |&i: &usize| {
        let instance = &scene.instances[i];
        let mesh = &scene.meshes[instance.mesh as usize];
        instance.casts_shadow && scene.materials[mesh.material as usize].is_translucent()
    };
    Group { members: (0..scene.instances.len()).filter(is_one).collect(), is_instanced: false }
}

/// The triangles of a group, in world space if it is baked. Their indices count from `first_vertex`, so `positions` is
/// padded in front: only its tail is used.
pub fn soup(scene: &Scene, group: &Group, materials: &PackedMaterials, first_vertex: usize) -> Soup {
    let mut soup =
        Soup { positions: vec![Vec3::ZERO; first_vertex], triangles: Vec::new(), has_holes: Vec::new() };
    for part in parts(scene, group, materials) {
        let has_holes = materials.has_holes(part.material, part.mesh);
        let first = soup.positions.len() as u32;
        soup.positions.extend(part.mesh.positions.iter().map(|&p| part.transform.transform_point3(p)));
        let triangles = part.mesh.indices.chunks_exact(3);
        soup.triangles.extend(triangles.map(|t| [t[0] + first, t[1] + first, t[2] + first]));
        soup.has_holes.resize(soup.triangles.len(), has_holes);
    }
    soup
}

/// Appends the positions that a group's vertices had in another pose, in the order of [`soup`]; false if that pose has not
/// the same vertices.
pub fn push_positions(pose: &Scene, group: &Group, positions: &mut Vec<Vec4>, now: &Scene) -> bool {
    let members = if group.is_instanced { &group.members[..1] } else { &group.members[..] };
    for &member in members {
        let vertices_in = |scene: &Scene| {
            scene.instances.get(member).map(|i| scene.meshes[i.mesh as usize].positions.len())
        };
        if vertices_in(pose) != vertices_in(now) {
            return false;
        }
        let instance = &pose.instances[member];
        let transform = if group.is_instanced { Affine3A::IDENTITY } else { instance.transform };
        let mesh = &pose.meshes[instance.mesh as usize];
        positions.extend(mesh.positions.iter().map(|&p| transform.transform_point3(p).extend(1.0)));
    }
    true
}

/// Appends the attributes of a group's vertices, in the order of [`soup`].
pub fn push_vertices(scene: &Scene, group: &Group, materials: &PackedMaterials, vertices: &mut Vec<Vertex>) {
    for part in parts(scene, group, materials) {
        push_mesh(part.mesh, part.transform, part.material, vertices);
    }
}

/// One mesh of a group's tree.
struct Part<'a> {
    mesh: &'a Mesh,
    /// Into the tree's space.
    transform: Affine3A,
    /// Variant of its material.
    material: u32,
}

fn parts<'a>(
    scene: &'a Scene,
    group: &'a Group,
    materials: &'a PackedMaterials,
) -> impl Iterator<Item = Part<'a>> {
    let members = if group.is_instanced { &group.members[..1] } else { &group.members[..] };
    members.iter().map(move |&member| {
        let instance = &scene.instances[member];
        let mesh = &scene.meshes[instance.mesh as usize];
        Part {
            mesh,
            transform: if group.is_instanced { Affine3A::IDENTITY } else { instance.transform },
            material: materials.variant(mesh.material, instance.casts_shadow, instance.receives_shadow),
        }
    })
}

fn push_mesh(mesh: &Mesh, transform: Affine3A, material: u32, vertices: &mut Vec<Vertex>) {
    let normal_matrix = Mat3::from(transform.matrix3).inverse().transpose();
    vertices.extend((0..mesh.positions.len()).map(|i| {
        let normal = mesh
            .normals
            .get(i)
            .and_then(|&n| (normal_matrix * n).try_normalize())
            .map_or(Vertex::NO_NORMAL, octahedral_encode);
        let uv = mesh.uvs.get(i).copied().unwrap_or_default();
        let color = mesh.colors.get(i).map_or(u32::MAX, |c| u32::from_le_bytes(*c));
        Vertex { u: uv.x, v: uv.y, normal, color, material }
    }));
}
