//! A scene as the kernels read it: trees, vertices, materials and texels in flat buffers.
//!
//! Meshes placed once are baked into one world-space tree. Meshes placed several times keep a tree of their own under
//! a TLAS, unless the scene is small enough that copies cost less than a second level of traversal.

mod coverage;
mod culling;
mod meshes;
mod moving;
mod opacity;
mod textures;
mod upkeep;

use std::sync::OnceLock;

use lt_bvh::{BuildQuality, Bvh, Dropped, Instance, InstancedBvh, Node, Placement, Triangle};
use lt_math::glam::{Affine3A, Vec4};
use lt_scene::{Bounds, Scene};
use lt_shaders::abi::{DepthParams, Material, Vertex};
use lt_shaders::surface::Coverage;
use rayon::prelude::*;

use crate::RenderError;
use culling::Runs;
use textures::PackedMaterials;

pub use coverage::MappedCoverage;
pub use opacity::OpacityMaps;
pub use upkeep::Upkeep;

/// Scenes up to this many triangles (copies counted) are baked whole: below it the memory that a TLAS saves is
/// taken not to be worth its second level of traversal. Chosen by judgement, not by measurement.
const BAKE_ALL_LIMIT: usize = 500_000;

/// Sizes that the plan and reports speak of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackStats {
    /// Triangles over all instances.
    pub triangles: u64,
    /// Of these, with holes (or cut off from casting), so that hits ask the alpha test.
    pub masked_triangles: u64,
    /// Instances in the scene.
    pub instances: u64,
    /// Meshes kept once and placed several times.
    pub instanced_meshes: u64,
    /// Coverage texels.
    pub alpha_texel_bytes: u64,
    /// Colour texels.
    pub color_texel_bytes: u64,
    /// Trees, triangles and instances.
    pub bvh_bytes: u64,
    /// Triangles no ray can hit.
    pub dropped: u64,
    /// Triangles of casters that let light through in part, over all instances.
    pub translucent_triangles: u64,
    /// Whether these tint the light; else they block it or not, like any other.
    pub is_translucency_traced: bool,
    /// Surfaces that the camera may see behind the first one; 0 where nothing is translucent.
    pub layers_behind: u32,
}

/// One range of the depth map pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrawRange {
    /// First triangle in the shared buffer.
    pub first_triangle: u32,
    /// Triangles.
    pub triangles: u32,
    /// Index into the instances where there is a TLAS.
    pub instance: u32,
    /// Whether any of them has holes.
    pub has_holes: bool,
}

/// Boxes of casters.
#[derive(Clone, Debug)]
pub struct Culling {
    bounds: Vec<Bounds>,
    instances: Vec<Instance>,
}

impl Culling {
    /// [`PackedScene::visible_draws`].
    pub fn visible_draws(&self, draws: &[DrawRange], p: &DepthParams) -> Vec<DrawRange> {
        culling::visible(|run| self.bounds[run as usize], &self.instances, draws, p)
    }
}

/// Trees of a scene.
#[derive(Clone, Debug)]
pub enum Trees {
    /// One tree in world space.
    Flat(Bvh),
    /// A TLAS over placed trees.
    Instanced(InstancedBvh),
}

/// How a scene is packed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Packing {
    /// Translucent casters tint light: they block none of it, and have a tree of their own. Else coverage is binary.
    pub traces_translucency: bool,
    /// Copies become triangles of the one tree in world space, however many: what resolvers in light space need.
    pub bakes_copies: bool,
    /// How many surfaces more the camera may see behind the first, through translucent ones; 0 for none. Needs
    /// `traces_translucency`; makes copies baked, and a blended surface be seen wherever its alpha is not 0.
    pub layers_behind: u32,
}

/// A scene in the kernels' buffers.
#[derive(Clone, Debug)]
pub struct PackedScene {
    trees: Trees,
    vertices: Vec<Vertex>,
    materials: Vec<Material>,
    alpha_texels: Vec<u32>,
    color_texels: Vec<u32>,
    draws: Vec<DrawRange>,
    still_draws: Vec<DrawRange>,
    moving_draws: Vec<DrawRange>,
    runs: Runs,
    bounds: Bounds,
    stats: PackStats,
    previous_positions: Vec<Vec4>,
    translucent: Option<Bvh>,
    /// Made on first use.
    opacity: OnceLock<OpacityMaps>,
    /// Scenes up to this many triangles, copies counted, are baked whole.
    bake_limit: usize,
}

impl PackedScene {
    /// Packs a posed scene and builds its trees. Coverage is binary: a translucent surface blocks light or does not.
    ///
    /// # Errors
    /// [`RenderError::Build`] for indices out of range or a singular instance transform, which importers and
    /// generators never hand over.
    pub fn new(scene: &Scene) -> Result<Self, RenderError> {
        Self::with(scene, Packing::default())
    }

    /// Packs a posed scene in another way than the usual.
    ///
    /// # Errors
    /// As [`PackedScene::new`].
    pub fn with(scene: &Scene, packing: Packing) -> Result<Self, RenderError> {
        let Packing { traces_translucency, bakes_copies, layers_behind } = packing;
        let bake_limit = if bakes_copies || layers_behind > 0 { usize::MAX } else { BAKE_ALL_LIMIT };
        let textures = textures::pack(scene);
        let materials = textures::pack_materials(scene, &textures, packing);
        let groups = meshes::group(scene, bake_limit);
        let mut vertices = Vec::new();
        let mut bvhs = Vec::new();
        let mut holes = Vec::new();
        for group in &groups {
            let soup = meshes::soup(scene, group, &materials, vertices.len());
            holes.push(soup.has_holes.iter().filter(|h| **h).count() as u64);
            let bvh =
                Bvh::build(&soup.positions, &soup.triangles, |i| !soup.has_holes[i], BuildQuality::Medium)
                    .map_err(|e| RenderError::Build(e.to_string()))?;
            bvhs.push(bvh);
            // The build is where memory peaks: the attributes come after it.
            drop(soup);
            meshes::push_vertices(scene, group, &materials, &mut vertices);
        }
        let casters = meshes::translucent_casters(scene);
        let translucent = match traces_translucency && !casters.members.is_empty() {
            true => Some(translucent_tree(scene, &casters, &materials, &mut vertices)?),
            false => None,
        };
        let mut stats = PackStats {
            translucent_triangles: casters.members.iter().map(|&i| triangles_of(scene, i)).sum(),
            is_translucency_traced: traces_translucency,
            layers_behind: if casters.members.is_empty() { 0 } else { layers_behind },
            triangles: scene.triangle_count() as u64,
            instances: scene.instances.len() as u64,
            instanced_meshes: groups.iter().filter(|g| g.is_instanced).count() as u64,
            alpha_texel_bytes: textures.alpha_texels.len() as u64 * 4,
            color_texel_bytes: textures.color_texels.len() as u64 * 4,
            ..PackStats::default()
        };
        for ((group, bvh), holes) in groups.iter().zip(&bvhs).zip(&holes) {
            let copies = if group.is_instanced { group.members.len() as u64 } else { 1 };
            stats.masked_triangles += holes * copies;
            let Dropped { not_finite, zero_area } = bvh.dropped();
            stats.dropped += (not_finite + zero_area) as u64 * copies;
        }
        let (trees, draws) = assemble(scene, &groups, bvhs, &holes)?;
        let mut packed = Self {
            trees,
            vertices,
            materials: materials.packed,
            alpha_texels: textures.alpha_texels,
            color_texels: textures.color_texels,
            draws,
            still_draws: Vec::new(),
            moving_draws: Vec::new(),
            runs: Runs::default(),
            bounds: scene.bounds(),
            stats,
            previous_positions: Vec::new(),
            translucent,
            opacity: OnceLock::new(),
            bake_limit,
        };
        packed.stats.bvh_bytes = (size_of_val(packed.nodes())
            + size_of_val(packed.triangles())
            + size_of_val(packed.instances())
            + packed.translucent.as_ref().map_or(0, |b| size_of_val(b.nodes()) + size_of_val(b.triangles())))
            as u64;
        packed.runs = Runs::new(packed.triangles().len());
        let moving = moving::moving_vertices(scene, &groups);
        (packed.still_draws, packed.moving_draws) = moving::split(&packed.draws, packed.triangles(), &moving);
        Ok(packed)
    }

    /// The packed `scene`, with the positions that its vertices had in the pose `before`.
    ///
    /// # Errors
    /// [`RenderError::Build`] where the poses have not the same instances with as many vertices each.
    pub fn after(mut self, scene: &Scene, before: &Scene) -> Result<Self, RenderError> {
        let mut positions = Vec::with_capacity(self.vertices.len());
        for group in meshes::group(scene, self.bake_limit) {
            if !meshes::push_positions(before, &group, &mut positions, scene) {
                return Err(RenderError::Build("two poses of the scene differ in their vertices".to_owned()));
            }
        }
        self.previous_positions = positions;
        Ok(self)
    }

    /// Positions of the vertices in the last pose, in their tree's space (`w` is 1), indexed as
    /// [`PackedScene::vertices`]; empty without [`PackedScene::after`].
    pub fn previous_positions(&self) -> &[Vec4] {
        &self.previous_positions
    }

    /// Sizes.
    pub fn stats(&self) -> &PackStats {
        &self.stats
    }

    /// World bounds of everything drawn.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The trees.
    pub fn trees(&self) -> &Trees {
        &self.trees
    }

    /// Translucent casters in world space, where they tint light. They are among the other trees too, for the camera to
    /// see, but cast nothing there.
    pub fn translucent(&self) -> Option<&Bvh> {
        self.translucent.as_ref()
    }

    /// Nodes of all trees; a TLAS, if any, comes last, its root at [`PackedScene::root`].
    pub fn nodes(&self) -> &[Node] {
        match &self.trees {
            Trees::Flat(b) => b.nodes(),
            Trees::Instanced(b) => b.nodes(),
        }
    }

    /// Triangles of all trees in leaf order.
    pub fn triangles(&self) -> &[Triangle] {
        match &self.trees {
            Trees::Flat(b) => b.triangles(),
            Trees::Instanced(b) => b.triangles(),
        }
    }

    /// Placed trees in the TLAS's leaf order; empty without one.
    pub fn instances(&self) -> &[Instance] {
        match &self.trees {
            Trees::Flat(_) => &[],
            Trees::Instanced(b) => b.instances(),
        }
    }

    /// The node where traversal starts.
    pub fn root(&self) -> u32 {
        match &self.trees {
            Trees::Flat(_) => 0,
            Trees::Instanced(b) => b.tlas_root(),
        }
    }

    /// Vertex attributes, indexed by the triangles' vertex indices.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Surfaces.
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// Coverage texels, four to a word.
    pub fn alpha_texels(&self) -> &[u32] {
        &self.alpha_texels
    }

    /// The alpha test for rays on the CPU; a surface counts only if its flags hold `required_flags` ([`Coverage::required_flags`]). The
    /// first call makes the opacity maps.
    pub fn coverage(&self, required_flags: u32) -> MappedCoverage<'_> {
        let (triangles, vertices) = (self.triangles(), self.vertices());
        let (materials, alpha_texels) = (self.materials(), self.alpha_texels());
        let maps =
            self.opacity.get_or_init(|| OpacityMaps::new(triangles, vertices, materials, alpha_texels));
        let coverage = Coverage { triangles, vertices, materials, alpha_texels, required_flags };
        MappedCoverage { coverage, maps }
    }

    /// Colour texels, one word each.
    pub fn color_texels(&self) -> &[u32] {
        &self.color_texels
    }

    /// What the depth map pass draws.
    pub fn draws(&self) -> &[DrawRange] {
        &self.draws
    }

    /// The parts of such draws that may fall on a map: what is left out has no effect on it.
    pub fn visible_draws(&self, draws: &[DrawRange], p: &DepthParams) -> Vec<DrawRange> {
        let bounds_of = |run| self.runs.bounds(self.triangles(), run);
        culling::visible(bounds_of, self.instances(), draws, p)
    }

    /// What [`PackedScene::visible_draws`] goes by, for those who keep the scene elsewhere.
    pub fn culling(&self) -> Culling {
        Culling { bounds: self.runs.all(self.triangles()), instances: self.instances().to_vec() }
    }

    /// The part of [`PackedScene::draws`] that stands still in every pose.
    pub fn still_draws(&self) -> &[DrawRange] {
        &self.still_draws
    }

    /// The part of [`PackedScene::draws`] that moves.
    pub fn moving_draws(&self) -> &[DrawRange] {
        &self.moving_draws
    }

    /// World bounds of the casters that move, where they are now.
    pub fn moving_bounds(&self) -> Bounds {
        // A placed tree may hold more than what moves: its own box will not do.
        let joined = |a: Bounds, b: Bounds| Bounds { min: a.min.min(b.min), max: a.max.max(b.max) };
        let of_run = |run: &[Triangle]| {
            run.iter().flat_map(|t| [t.v0, t.v1, t.v2]).fold(Bounds::EMPTY, Bounds::including)
        };
        let of_draw = |draw: &DrawRange| {
            let all = draw.first_triangle as usize..(draw.first_triangle + draw.triangles) as usize;
            let runs = self.triangles()[all].par_chunks(4096);
            let bounds = runs.map(of_run).reduce(|| Bounds::EMPTY, joined);
            match self.instances().get(draw.instance as usize) {
                Some(placed) if !bounds.is_empty() => {
                    let corners = bounds.corners().map(|c| placed.point_to_world(c));
                    corners.into_iter().fold(Bounds::EMPTY, Bounds::including)
                }
                _ => bounds,
            }
        };
        self.moving_draws.par_iter().map(of_draw).reduce(|| Bounds::EMPTY, joined)
    }
}

fn triangles_of(scene: &Scene, instance: usize) -> u64 {
    scene.meshes[scene.instances[instance].mesh as usize].triangle_count() as u64
}

/// The tree of translucent casters; its vertices follow the others.
fn translucent_tree(
    scene: &Scene,
    casters: &meshes::Group,
    materials: &PackedMaterials,
    vertices: &mut Vec<Vertex>,
) -> Result<Bvh, RenderError> {
    let soup = meshes::soup(scene, casters, materials, vertices.len());
    let bvh = Bvh::build(&soup.positions, &soup.triangles, |_| true, BuildQuality::Medium)
        .map_err(|e| RenderError::Build(e.to_string()))?;
    meshes::push_vertices(scene, casters, materials, vertices);
    Ok(bvh)
}

fn assemble(
    scene: &Scene,
    groups: &[meshes::Group],
    mut bvhs: Vec<Bvh>,
    holes: &[u64],
) -> Result<(Trees, Vec<DrawRange>), RenderError> {
    let is_flat = groups.iter().all(|g| !g.is_instanced);
    if is_flat && bvhs.len() == 1 {
        let bvh = bvhs.remove(0);
        let triangles = bvh.triangles().len() as u32;
        let draw = DrawRange { first_triangle: 0, triangles, instance: 0, has_holes: holes[0] > 0 };
        return Ok((Trees::Flat(bvh), vec![draw]));
    }
    let mut placements = Vec::new();
    for (blas, group) in groups.iter().enumerate() {
        match group.is_instanced {
            false => placements.push(Placement { blas: blas as u32, object_to_world: Affine3A::IDENTITY }),
            true => placements.extend(
                group
                    .members
                    .iter()
                    .map(|&i| Placement { blas: blas as u32, object_to_world: scene.instances[i].transform }),
            ),
        }
    }
    let tree = InstancedBvh::build(&bvhs, &placements).map_err(|e| RenderError::Build(e.to_string()))?;
    let draws = tree
        .instances()
        .iter()
        .enumerate()
        .map(|(index, instance)| {
            let blas = placements[instance.source as usize].blas as usize;
            DrawRange {
                first_triangle: instance.first_triangle,
                triangles: bvhs[blas].triangles().len() as u32,
                instance: index as u32,
                has_holes: holes[blas] > 0,
            }
        })
        .collect();
    Ok((Trees::Instanced(tree), draws))
}
