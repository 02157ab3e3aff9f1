//! A mesh with its tree, in the buffers that the shared kernel traverses.

use super::binary::BinaryTree;
use super::bounds::Bounds;
use super::error::BuildError;
use super::quality::BuildQuality;
use super::quantize::NODE_LEAF;
use super::refit::refit;
use super::validate::{Invalid, validate_tree};
use super::wide::KernelTree;
use crate::node::Node;
use crate::ray::COORDINATE_LIMIT;
use crate::simd::{Part, SimdTree, memory};
use crate::triangle::Triangle;
use lt_math::glam::Vec3;
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};
use std::vec;
use std::vec::Vec;

/// Triangles left out of a tree because no ray can hit them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dropped {
    /// With a coordinate that is NaN, infinite or not below [`COORDINATE_LIMIT`] in magnitude.
    pub not_finite: usize,
    /// With all three vertices on one line.
    pub zero_area: usize,
}

/// Triangles and the tree over them.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    triangles: Vec<Triangle>,
    sources: Vec<u32>,
    dropped: Dropped,
    depth: usize,
    wide: Arc<Wide>,
}

/// What the SIMD tracer makes its tree from, and the tree once it is made.
#[derive(Debug)]
pub(crate) struct Wide {
    /// Over the triangles in leaf order; `None` when there are none.
    binary: Option<Arc<BinaryTree>>,
    root: Node,
    tree: OnceLock<SimdTree>,
}

impl Wide {
    fn new(binary: Option<BinaryTree>, root: Node) -> Arc<Self> {
        Arc::new(Wide { binary: binary.map(Arc::new), root, tree: OnceLock::new() })
    }

    /// The same over triangles that have moved. A tree that was not made yet need not be: it will be made from them.
    fn refit(&self, triangles: &[Triangle], root: Node) -> Arc<Self> {
        let tree = self.tree.get().map_or_else(OnceLock::new, |tree| tree.refit(triangles, &root).into());
        Arc::new(Wide { binary: self.binary.clone(), root, tree })
    }

    /// The tree over the mesh's `triangles`, in leaf order.
    pub fn tree(&self, triangles: &[Triangle]) -> &SimdTree {
        self.tree.get_or_init(|| SimdTree::of_triangles(self.binary.as_deref(), triangles, &self.root))
    }
}

/// Vertices that may be named: the top bit of an index is [`Triangle::NON_OPAQUE`].
const INDEX_LIMIT: usize = 1 << 31;

/// Triangles of one tree: what the link of a block of the SIMD tree can count.
const TRIANGLE_LIMIT: usize = crate::simd::MOST_TRIANGLES;

/// What becomes of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    Kept,
    NotFinite,
    ZeroArea,
    OutOfRange,
}

fn fate(positions: &[Vec3], triangle: [u32; 3]) -> Fate {
    if triangle.iter().any(|&vertex| vertex as usize >= positions.len()) {
        return Fate::OutOfRange;
    }
    let corners = triangle.map(|vertex| positions[vertex as usize]);
    if !is_usable(&corners) {
        Fate::NotFinite
    } else if !has_area(corners) {
        Fate::ZeroArea
    } else {
        Fate::Kept
    }
}

/// The triangles that rays can hit, and how many they cannot.
fn usable(positions: &[Vec3], indices: &[[u32; 3]]) -> Result<(Vec<u32>, Dropped), BuildError> {
    let fates: Vec<Fate> = indices.par_iter().map(|&triangle| fate(positions, triangle)).collect();
    let (mut sources, mut dropped) = (Vec::with_capacity(indices.len()), Dropped::default());
    for (triangle, fate) in fates.into_iter().enumerate() {
        match fate {
            Fate::Kept => sources.push(triangle as u32),
            Fate::NotFinite => dropped.not_finite += 1,
            Fate::ZeroArea => dropped.zero_area += 1,
            Fate::OutOfRange => {
                let vertices = positions.len();
                let is_outside = |&vertex: &u32| vertex as usize >= vertices;
                let vertex = indices[triangle].into_iter().find(is_outside).unwrap_or_default();
                return Err(BuildError::VertexOutOfRange { triangle, vertex, vertices });
            }
        }
    }
    Ok((sources, dropped))
}

/// The triangles that rays can hit in the caller's order, what indices they have there, and how many are left out.
fn kept(
    positions: &[Vec3],
    indices: &[[u32; 3]],
    is_opaque: impl Fn(usize) -> bool,
) -> Result<(Vec<Triangle>, Vec<u32>, Dropped), BuildError> {
    let (sources, dropped) = usable(positions, indices)?;
    // Gathered once in the caller's order: the leaf order jumps about, and would miss the cache at every step.
    let is_opaque: Vec<bool> = sources.iter().map(|&source| is_opaque(source as usize)).collect();
    let triangles =
        memory::filled(sources.len(), |i| triangle_of(positions, indices[sources[i] as usize], is_opaque[i]));
    Ok((triangles, sources, dropped))
}

/// The triangles of a mesh as [`Bvh::build`] takes them and as its arguments say, in the caller's order and without a tree: what structures
/// start from that ask the ray tracer's own test of triangles that they find in other ways.
///
/// # Errors
/// [`BuildError::VertexOutOfRange`].
pub fn triangles_of(
    positions: &[Vec3],
    indices: &[[u32; 3]],
    is_opaque: impl Fn(usize) -> bool,
) -> Result<Vec<Triangle>, BuildError> {
    kept(positions, indices, is_opaque).map(|(triangles, ..)| triangles)
}

/// A triangle with its vertices turned around so that the first lies opposite the longest edge, as the triangle test asks.
fn triangle_of(positions: &[Vec3], indices: [u32; 3], is_opaque: bool) -> Triangle {
    let [a, b, c] = indices.map(|vertex| positions[vertex as usize].as_dvec3());
    let opposite = [(c - b).length_squared(), (a - c).length_squared(), (b - a).length_squared()];
    let [i0, i1, i2] = if opposite[0] >= opposite[1] && opposite[0] >= opposite[2] {
        indices
    } else if opposite[1] >= opposite[2] {
        [indices[1], indices[2], indices[0]]
    } else {
        [indices[2], indices[0], indices[1]]
    };
    let [v0, v1, v2] = [i0, i1, i2].map(|vertex| positions[vertex as usize]);
    let flag = if is_opaque { 0 } else { Triangle::NON_OPAQUE };
    Triangle { v0, i0: i0 | flag, v1, i1, v2, i2 }
}

/// Exact for coordinates of like magnitude: differences and products of f32 fit f64.
fn has_area([a, b, c]: [Vec3; 3]) -> bool {
    let (a, b, c) = (a.as_dvec3(), b.as_dvec3(), c.as_dvec3());
    (b - a).cross(c - a) != lt_math::glam::DVec3::ZERO
}

fn is_usable(corners: &[Vec3; 3]) -> bool {
    corners.iter().all(|v| v.to_array().iter().all(|x| x.abs() < COORDINATE_LIMIT))
}

impl Bvh {
    /// Builds a tree over triangles `indices` into `positions`.
    ///
    /// `is_opaque` is asked once for each triangle index: `false` for those whose hits the
    /// [`AnyHit`](crate::AnyHit) callback judges. Triangles that no ray can hit are left out and counted in
    /// [`Bvh::dropped`]. Any finite input builds, however degenerate: where the preferred builder grows a
    /// tree deeper than [`MAX_DEPTH`](crate::MAX_DEPTH), a balanced one takes its place.
    ///
    /// # Errors
    /// [`BuildError::VertexOutOfRange`] and [`BuildError::TooMany`].
    pub fn build(
        positions: &[Vec3],
        indices: &[[u32; 3]],
        is_opaque: impl Fn(usize) -> bool,
        quality: BuildQuality,
    ) -> Result<Bvh, BuildError> {
        let found = positions.len().max(indices.len());
        if found >= INDEX_LIMIT {
            return Err(BuildError::TooMany { found, limit: INDEX_LIMIT - 1 });
        }
        if indices.len() > TRIANGLE_LIMIT {
            return Err(BuildError::TooMany { found: indices.len(), limit: TRIANGLE_LIMIT });
        }
        let (kept, sources, dropped) = kept(positions, indices, is_opaque)?;
        if sources.is_empty() {
            let nodes = vec![Node::default()];
            let wide = Wide::new(None, nodes[0]);
            return Ok(Bvh { nodes, triangles: Vec::new(), sources, dropped, depth: 1, wide });
        }
        let boxes: Vec<Bounds> = memory::filled(kept.len(), |i| triangle_bounds(&kept[i]));
        let tree = KernelTree::build(&boxes, quality, NODE_LEAF);
        drop(boxes);
        Ok(Bvh {
            wide: Wide::new(Some(tree.binary), tree.nodes[0]),
            nodes: tree.nodes,
            triangles: memory::filled(kept.len(), |i| kept[tree.order[i] as usize]),
            sources: memory::filled(kept.len(), |i| sources[tree.order[i] as usize]),
            dropped,
            depth: tree.depth,
        })
    }

    /// Moves the tree to where the vertices are now: new boxes on the same topology, several times faster than a build.
    ///
    /// `indices` name the vertices of the triangles that the tree was built over, in the same order; opaque triangles
    /// stay opaque. Hits are those of a fresh build, and keep their triangle indices. The tree gets slower to trace the
    /// more the mesh deforms, since triangles that part stay in common boxes; then build anew. An
    /// [`InstancedBvh`](crate::InstancedBvh) keeps the copy that it was built with.
    ///
    /// # Errors
    /// [`BuildError::OtherTriangleCount`], [`BuildError::VertexOutOfRange`], and [`BuildError::OtherTriangleDropped`]
    /// where a build would now drop other triangles. After one nothing has changed.
    pub fn refit(&mut self, positions: &[Vec3], indices: &[[u32; 3]]) -> Result<(), BuildError> {
        let expected = self.sources.len() + self.dropped.not_finite + self.dropped.zero_area;
        if indices.len() != expected {
            return Err(BuildError::OtherTriangleCount { found: indices.len(), expected });
        }
        let (usable, dropped) = usable(positions, indices)?;
        let mut was_kept = vec![false; indices.len()];
        self.sources.iter().for_each(|&source| was_kept[source as usize] = true);
        let mut is_kept = vec![false; indices.len()];
        usable.iter().for_each(|&source| is_kept[source as usize] = true);
        if let Some(triangle) = (0..indices.len()).find(|&i| was_kept[i] != is_kept[i]) {
            return Err(BuildError::OtherTriangleDropped { triangle });
        }
        self.dropped = dropped;
        if self.triangles.is_empty() {
            return Ok(());
        }
        self.triangles.par_iter_mut().zip(&self.sources).for_each(|(triangle, &source)| {
            *triangle = triangle_of(positions, indices[source as usize], triangle.is_opaque());
        });
        let triangles = &self.triangles;
        self.nodes = refit(&self.nodes, |i| triangle_bounds(&triangles[i as usize]));
        self.wide = self.wide.refit(triangles, self.nodes[0]);
        Ok(())
    }

    /// Nodes for [`closest_hit`](crate::closest_hit) and [`occluded`](crate::occluded), the root first; never
    /// empty.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Triangles in leaf order, which is how hits name them.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// For each triangle in leaf order, its index in the `indices` it was built from.
    pub fn sources(&self) -> &[u32] {
        &self.sources
    }

    /// What was left out.
    pub fn dropped(&self) -> Dropped {
        self.dropped
    }

    /// Levels of the tree, counting the root: at most [`MAX_DEPTH`](crate::MAX_DEPTH).
    pub fn depth(&self) -> usize {
        self.depth
    }

    pub(crate) fn wide(&self) -> &Arc<Wide> {
        &self.wide
    }

    pub(crate) fn simd_part(&self) -> Part<'_> {
        Part { tree: self.wide.tree(&self.triangles), triangles: &self.triangles, first_triangle: 0 }
    }

    /// Box of everything; empty (low > high) without triangles.
    pub(crate) fn bounds(&self) -> Bounds {
        self.triangles.iter().fold(Bounds::EMPTY, |all, t| all.union(&triangle_bounds(t)))
    }

    /// Checks that the tree holds every triangle once, in boxes that contain it, within [`MAX_DEPTH`](crate::MAX_DEPTH)
    /// levels; the SIMD tracer's tree too, where one has been made.
    ///
    /// # Errors
    /// The first fault found, naming its node.
    pub fn validate(&self) -> Result<(), Invalid> {
        let boxes: Vec<Bounds> = self.triangles.par_iter().map(triangle_bounds).collect();
        validate_tree(&self.nodes, &boxes)?;
        self.wide.tree.get().map_or(Ok(()), |tree| tree.validate(&self.triangles))
    }
}

pub(crate) fn triangle_bounds(triangle: &Triangle) -> Bounds {
    Bounds { low: triangle.low(), high: triangle.high() }
}
