//! Puts a scene together at one moment: world transforms, then morphing, then skinning.

use std::collections::HashMap;

use lt_math::glam::{Affine3A, DVec3, Quat, Vec3};

use super::{
    animation::{Animation, Posture},
    budget::Budget,
    cameras::Lens,
    extras::Shadows,
    fault::Fault,
    lights::Lamp,
    morph,
    nodes::{Hierarchy, is_invertible, relative_to},
    primitives::Primitive,
    skin::Skin,
    triangles::drop_degenerate,
};
use crate::{Bounds, Instance, Light, Material, Mesh, Repairs, Scene, Texture};

/// What hangs on a node that is shown.
#[derive(Clone, Debug, Default)]
pub(super) struct Load {
    pub(super) mesh: Option<usize>,
    pub(super) skin: Option<usize>,
    pub(super) shadows: Shadows,
    pub(super) lens: Option<Lens>,
    pub(super) lamp: Option<Lamp>,
}

/// Everything in a file, ready to be posed.
#[derive(Clone, Debug)]
pub(super) struct Asset {
    pub(super) name: String,
    pub(super) hierarchy: Hierarchy,
    /// By node.
    pub(super) loads: Vec<Load>,
    /// Morph weights at rest, by node.
    pub(super) weights: Vec<Vec<f32>>,
    /// By mesh; empty for meshes that no shown node uses.
    pub(super) meshes: Vec<Vec<Primitive>>,
    pub(super) skins: Vec<Skin>,
    pub(super) animation: Option<Animation>,
    pub(super) materials: Vec<Material>,
    pub(super) textures: Vec<Texture>,
    pub(super) repairs: Repairs,
    /// What places are told relative to.
    pub(super) origin: DVec3,
    /// Granted to every pose.
    pub(super) budget: Budget,
}

impl Asset {
    /// Nodes that the animation moves, themselves or with what they hang on, and nodes whose morph weights it changes; empty without one.
    fn moved(&self) -> (Vec<bool>, Vec<bool>) {
        let nodes = self.hierarchy.rest.len();
        let marks = self.animation.as_ref().map(|a| a.moved(nodes));
        marks.map_or_else(Default::default, |(moved, morphed)| (self.hierarchy.inherit(moved), morphed))
    }

    /// The middle of what is shown at rest, in whole units, where that lies so far from the file's origin that f32 would tell its parts badly apart;
    /// else the origin.
    pub(super) fn near_origin(&self) -> DVec3 {
        let world = self.hierarchy.world(&self.hierarchy.rest);
        // Once for each mesh and skin, not for each node that has one: nodes may share large ones by the thousand.
        let joined = |all: Bounds, p: &Primitive| all.including(p.bounds.min).including(p.bounds.max);
        let meshes: Vec<Bounds> = self.meshes.iter().map(|m| m.iter().fold(Bounds::EMPTY, joined)).collect();
        let skins =
            self.skins.iter().map(|s| reach_of(s.joints.iter().map(|&joint| world[joint].translation)));
        let skins: Vec<[DVec3; 2]> = skins.collect();
        let shown = self.loads.iter().zip(&world).filter_map(|(load, at)| {
            Some(match (load.mesh?, load.skin) {
                (_, Some(skin)) => skins[skin],
                (mesh, None) if meshes[mesh].is_empty() => NOWHERE,
                (mesh, None) => {
                    reach_of(meshes[mesh].corners().into_iter().map(|c| at.transform_point3(c.as_dvec3())))
                }
            })
        });
        let [low, high] = shown.fold(NOWHERE, |[low, high], [l, h]| [low.min(l), high.max(h)]);
        let (middle, reach) = ((low + high) * 0.5, (high - low).max_element() * 0.5);
        let is_far = middle.is_finite() && middle.abs().max_element() > FAR * reach;
        if is_far { middle.round() } else { DVec3::ZERO }
    }

    /// Whether the animation moves a light.
    pub(super) fn moves_lights(&self) -> bool {
        self.moved().0.iter().zip(&self.loads).any(|(&is_moved, load)| is_moved && load.lamp.is_some())
    }

    /// The scene at `time_s`.
    pub(super) fn pose(&self, time_s: f32) -> Result<Scene, Fault> {
        let mut posture = Posture { locals: self.hierarchy.rest.clone(), weights: self.weights.clone() };
        if let Some(animation) = &self.animation {
            animation.apply(time_s, &mut posture);
        }
        let world = self.hierarchy.world(&posture.locals);
        let world: Vec<Affine3A> = world.iter().map(|w| relative_to(self.origin, w)).collect();
        let (moved, morphed) = self.moved();
        let at = |marks: &Vec<bool>, node: usize| marks.get(node).copied().unwrap_or(false);
        let mut posing = Posing {
            asset: self,
            skins: self
                .skins
                .iter()
                .map(|s| Joints {
                    matrices: s.matrices(&world),
                    is_dynamic: s.joints.iter().any(|&j| at(&moved, j)),
                })
                .collect(),
            scene: Scene {
                name: self.name.clone(),
                materials: self.materials.clone(),
                textures: self.textures.clone(),
                repairs: self.repairs.clone(),
                origin: self.origin,
                ..Scene::default()
            },
            shared: HashMap::new(),
            budget: self.budget.clone(),
        };
        let shown = self.hierarchy.order.iter().filter(|&&i| self.hierarchy.is_shown[i]);
        for &node in shown {
            let load = &self.loads[node];
            if let Some(lamp) = &load.lamp {
                posing.place_lamp(lamp, &world[node], at(&moved, node));
            }
            posing.scene.cameras.extend(load.lens.as_ref().and_then(|l| l.place(&world[node])));
            if let Some(mesh) = load.mesh {
                let state = NodeState {
                    node,
                    world: world[node],
                    weights: &posture.weights[node],
                    is_moved: at(&moved, node),
                    is_morphed: at(&morphed, node),
                };
                posing.place(mesh, load.skin, &state)?;
            }
        }
        Ok(posing.scene)
    }
}

/// The joints of a skin at this moment.
struct Joints {
    matrices: Vec<Affine3A>,
    is_dynamic: bool,
}

/// A node at this moment.
struct NodeState<'a> {
    node: usize,
    world: Affine3A,
    weights: &'a [f32],
    is_moved: bool,
    is_morphed: bool,
}

struct Posing<'a> {
    asset: &'a Asset,
    skins: Vec<Joints>,
    scene: Scene,
    /// Scene meshes of primitives that nothing deforms, by file mesh and primitive.
    shared: HashMap<(usize, usize), u32>,
    budget: Budget,
}

impl Posing<'_> {
    /// Adds a light. One that moves is there at all times, and dark while its node leaves it no direction or no place; others are dropped
    /// then, and noted.
    fn place_lamp(&mut self, lamp: &Lamp, world: &Affine3A, is_moved: bool) {
        match (lamp.place(world), is_moved) {
            (Some(light), _) => self.scene.lights.push(light),
            (None, true) => self.scene.lights.extend(lamp.place(&Affine3A::IDENTITY).map(Light::darkened)),
            (None, false) => {
                let note =
                    format!("light {:?} dropped: its node leaves it no direction or no place", lamp.name());
                self.scene.repairs.notes.push(note);
            }
        }
    }

    /// Adds one instance for each primitive of a mesh. Which meshes and instances are made, and in which order, does not depend on
    /// the time.
    fn place(&mut self, mesh: usize, skin: Option<usize>, state: &NodeState<'_>) -> Result<(), Fault> {
        let asset = self.asset;
        for (p, primitive) in asset.meshes[mesh].iter().enumerate() {
            let node = state.node;
            self.budget.charge(1, || format!("nodes[{node}].mesh"))?;
            let skin = skin.filter(|_| primitive.influences.is_some());
            let has_weight = state.is_morphed || asset.weights[node].iter().any(|&w| w != 0.0);
            let is_morphed = !primitive.targets.is_empty() && has_weight;
            let is_deformed = skin.is_some() || is_morphed;
            let (index, bounds) = if is_deformed {
                self.deformed(primitive, skin, state)?
            } else {
                (self.shared(mesh, p, primitive), primitive.bounds)
            };
            let (transform, is_moved) = match skin {
                Some(skin) => (Affine3A::IDENTITY, self.skins[skin].is_dynamic),
                None => (state.world, state.is_moved),
            };
            let is_placeable = is_invertible(&transform)
                && (bounds.is_empty()
                    || bounds.corners().iter().all(|&c| transform.transform_point3(c).is_finite()));
            let transform = match (is_placeable, is_moved) {
                (true, _) => transform,
                (false, true) => shrunk(&transform, bounds),
                (false, false) => {
                    self.scene.repairs.singular_instances += 1;
                    continue;
                }
            };
            let is_dynamic = is_moved || (is_morphed && state.is_morphed);
            let Shadows { casts, receives } = asset.loads[node].shadows;
            let still = Instance::new(index, transform);
            self.scene.instances.push(Instance {
                casts_shadow: casts,
                receives_shadow: receives,
                is_dynamic,
                ..still
            });
        }
        Ok(())
    }

    fn shared(&mut self, mesh: usize, index: usize, primitive: &Primitive) -> u32 {
        *self.shared.entry((mesh, index)).or_insert_with(|| {
            self.scene.meshes.push(primitive.mesh.clone());
            self.scene.meshes.len() as u32 - 1
        })
    }

    /// A mesh of its own, morphed in object space and, if there is a skin, taken to the world by its joints.
    fn deformed(
        &mut self,
        primitive: &Primitive,
        skin: Option<usize>,
        state: &NodeState<'_>,
    ) -> Result<(u32, Bounds), Fault> {
        let rest = &primitive.mesh;
        let place = || format!("nodes[{}].mesh", state.node);
        let work =
            rest.positions.len() as u64 * (1 + primitive.targets.len() as u64) + rest.indices.len() as u64;
        self.budget.charge(work, place)?;
        let mut mesh = rest.clone();
        morph::apply(&primitive.targets, state.weights, &mut mesh.positions, &mut mesh.normals);
        if let (Some(skin), Some(influences)) = (skin, &primitive.influences) {
            influences.apply(&self.skins[skin].matrices, &mut mesh.positions, &mut mesh.normals);
        }
        if let Some(i) = mesh.positions.iter().position(|p| !p.is_finite()) {
            return Err(Fault::at(
                place(),
                format!("vertex {i} of {:?} is not finite once posed", mesh.name),
            ));
        }
        normalize(&mut mesh, &mut self.scene.repairs);
        self.scene.repairs.degenerate_triangles += drop_degenerate(&mut mesh.indices, &mesh.positions);
        let bounds = mesh.positions.iter().fold(Bounds::EMPTY, |b, &p| b.including(p));
        self.scene.meshes.push(mesh);
        Ok((self.scene.meshes.len() as u32 - 1, bounds))
    }
}

/// How many times as far from the file's origin as it is large a scene lies that is told relative to its own middle.
const FAR: f64 = 64.0;

/// The box of no points.
const NOWHERE: [DVec3; 2] = [DVec3::INFINITY, DVec3::NEG_INFINITY];

/// The box of points.
fn reach_of(points: impl Iterator<Item = DVec3>) -> [DVec3; 2] {
    points.fold(NOWHERE, |[low, high], at| [low.min(at), high.max(at)])
}

/// World units that something too flat to be placed still measures.
const SHRUNK: f32 = 1e-9;

/// What is left of a moving instance while its transform cannot be inverted, as files hide things by a scale of 0: a grain where its node is,
/// so that whatever follows it keeps its number.
fn shrunk(transform: &Affine3A, bounds: Bounds) -> Affine3A {
    let place = Vec3::from(transform.translation);
    let extent = bounds.min.abs().max(bounds.max.abs()).max_element();
    let scale = if extent.is_finite() { SHRUNK / extent.max(1.0) } else { SHRUNK };
    Affine3A::from_scale_rotation_translation(
        Vec3::splat(scale),
        Quat::IDENTITY,
        if place.is_finite() { place } else { Vec3::ZERO },
    )
}

/// Makes normals unit again, or drops them all, counted, if one has no length left.
fn normalize(mesh: &mut Mesh, repairs: &mut Repairs) {
    let normals: Vec<Option<Vec3>> = mesh.normals.iter().map(|n| n.try_normalize()).collect();
    let bad = normals.iter().filter(|n| n.is_none()).count();
    repairs.bad_normals += bad;
    mesh.normals = if bad == 0 { normals.into_iter().flatten().collect() } else { Vec::new() };
}
