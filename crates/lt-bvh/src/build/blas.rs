//! A mesh with its tree, in the buffers that the shared kernel traverses.

use super::binary::BinaryTree;
use super::bounds::Bounds;
use super::collapse::WideTree;
use super::error::BuildError;
use super::quality::BuildQuality;
use super::quantize::{NODE_LEAF, quantize};
use super::validate::{Invalid, validate_tree};
use crate::node::Node;
use crate::ray::COORDINATE_LIMIT;
use crate::simd::{Part, SimdTree};
use crate::traverse::MAX_DEPTH;
use crate::triangle::Triangle;
use lt_math::glam::Vec3;
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
    binary: Option<BinaryTree>,
    root: Node,
    tree: OnceLock<SimdTree>,
}

impl Wide {
    fn new(binary: Option<BinaryTree>, root: Node) -> Arc<Self> {
        Arc::new(Wide { binary, root, tree: OnceLock::new() })
    }

    /// The tree over the mesh's `triangles`, in leaf order.
    pub fn tree(&self, triangles: &[Triangle]) -> &SimdTree {
        self.tree.get_or_init(|| SimdTree::of_triangles(self.binary.as_ref(), triangles, &self.root))
    }
}

/// Vertices that may be named: the top bit of an index is [`Triangle::NON_OPAQUE`].
const INDEX_LIMIT: usize = 1 << 31;

fn corners(positions: &[Vec3], triangle: usize, indices: [u32; 3]) -> Result<[Vec3; 3], BuildError> {
    let corner = |vertex: u32| {
        let vertices = positions.len();
        positions.get(vertex as usize).copied().ok_or(BuildError::VertexOutOfRange {
            triangle,
            vertex,
            vertices,
        })
    };
    Ok([corner(indices[0])?, corner(indices[1])?, corner(indices[2])?])
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
    /// tree deeper than [`MAX_DEPTH`], a balanced one takes its place.
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
        let mut dropped = Dropped::default();
        let mut kept = Vec::with_capacity(indices.len());
        let mut sources = Vec::with_capacity(indices.len());
        for (index, &[i0, i1, i2]) in indices.iter().enumerate() {
            let corners = corners(positions, index, [i0, i1, i2])?;
            if !is_usable(&corners) {
                dropped.not_finite += 1;
            } else if !has_area(corners) {
                dropped.zero_area += 1;
            } else {
                let flag = if is_opaque(index) { 0 } else { Triangle::NON_OPAQUE };
                let [v0, v1, v2] = corners;
                kept.push(Triangle { v0, i0: i0 | flag, v1, i1, v2, i2 });
                sources.push(index as u32);
            }
        }
        Ok(Self::over(kept, sources, dropped, quality))
    }

    fn over(kept: Vec<Triangle>, sources: Vec<u32>, dropped: Dropped, quality: BuildQuality) -> Bvh {
        if kept.is_empty() {
            let nodes = vec![Node::default()];
            let wide = Wide::new(None, nodes[0]);
            return Bvh { nodes, triangles: kept, sources, dropped, depth: 1, wide };
        }
        let boxes: Vec<Bounds> = kept.iter().map(triangle_bounds).collect();
        let mut binary = BinaryTree::build(&boxes, quality);
        let mut bounds = binary.bounds(&boxes);
        let mut wide = WideTree::collapse(&binary, &bounds, NODE_LEAF);
        if wide.depth > MAX_DEPTH {
            binary = BinaryTree::balanced(&boxes);
            bounds = binary.bounds(&boxes);
            wide = WideTree::collapse(&binary, &bounds, NODE_LEAF);
        }
        let quantized = quantize(&wide, &binary, &bounds);
        let mut new_index = vec![0; kept.len()];
        for (to, &from) in quantized.order.iter().enumerate() {
            new_index[from as usize] = to as u32;
        }
        binary.rename(&new_index);
        Bvh {
            wide: Wide::new(Some(binary), quantized.nodes[0]),
            nodes: quantized.nodes,
            triangles: quantized.order.iter().map(|&from| kept[from as usize]).collect(),
            sources: quantized.order.iter().map(|&from| sources[from as usize]).collect(),
            dropped,
            depth: wide.depth,
        }
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

    /// Levels of the tree, counting the root: at most [`MAX_DEPTH`].
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

    /// Checks that the tree holds every triangle once, in boxes that contain it, within [`MAX_DEPTH`] levels.
    ///
    /// # Errors
    /// The first fault found, naming its node.
    pub fn validate(&self) -> Result<(), Invalid> {
        let boxes: Vec<Bounds> = self.triangles.iter().map(triangle_bounds).collect();
        validate_tree(&self.nodes, &boxes)
    }
}

pub(crate) fn triangle_bounds(triangle: &Triangle) -> Bounds {
    Bounds { low: triangle.low(), high: triangle.high() }
}
