//! Meshes placed many times: BLASes joined in shared buffers, and a tree over the placements.

use super::binary::BinaryTree;
use super::blas::{Bvh, Wide};
use super::bounds::Bounds;
use super::collapse::LeafCost;
use super::error::BuildError;
use super::quality::BuildQuality;
use super::validate::{Invalid, validate_tree};
use super::wide::KernelTree;
use crate::instance::Instance;
use crate::node::Node;
use crate::ray::COORDINATE_LIMIT;
use crate::simd::{Part, SimdTree};
use crate::triangle::Triangle;
use lt_math::glam::{Affine3A, DAffine3, DMat3, Vec4};
use std::sync::Arc;
use std::vec::Vec;

/// One instance per leaf: each costs a transformed ray and a tree of its own.
const INSTANCE_LEAF: LeafCost = LeafCost { capacity: 1, fixed: 0.0, each: 2.0 };

/// Roundings allowed for in an instance's box: those of two f32 matrices, a transformed ray and the triangle test.
const INSTANCE_ROUNDINGS: f64 = 16.0 / 16_777_216.0;

/// A mesh put somewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Index of the BLAS.
    pub blas: u32,
    /// Affine map from the mesh's space to world space; any that can be inverted, mirrored ones too.
    pub object_to_world: Affine3A,
}

/// Where a BLAS lies in the shared buffers.
#[derive(Clone, Debug)]
struct Section {
    root: u32,
    first_triangle: u32,
    triangles: u32,
    bounds: Bounds,
    wide: Arc<Wide>,
}

/// All BLASes and the TLAS over their placements, in the shared kernel's buffers.
#[derive(Clone, Debug)]
pub struct InstancedBvh {
    nodes: Vec<Node>,
    triangles: Vec<Triangle>,
    instances: Vec<Instance>,
    sections: Vec<Section>,
    tlas_root: u32,
    /// Over the instances in leaf order; `None` when there are none.
    binary: Option<BinaryTree>,
}

impl InstancedBvh {
    /// Joins `blases` and builds a TLAS over `placements` of them.
    ///
    /// # Errors
    /// [`BuildError::BlasOutOfRange`], [`BuildError::Singular`] and [`BuildError::TooMany`].
    pub fn build(blases: &[Bvh], placements: &[Placement]) -> Result<Self, BuildError> {
        let mut joined = InstancedBvh {
            nodes: Vec::new(),
            triangles: Vec::new(),
            instances: Vec::new(),
            sections: Vec::new(),
            tlas_root: 0,
            binary: None,
        };
        for blas in blases {
            let (root, first_triangle) = (joined.nodes.len() as u32, joined.triangles.len() as u32);
            joined.nodes.extend_from_slice(blas.nodes());
            joined.triangles.extend_from_slice(blas.triangles());
            joined.sections.push(Section {
                root,
                first_triangle,
                triangles: blas.triangles().len() as u32,
                bounds: blas.bounds(),
                wide: blas.wide().clone(),
            });
            check_count(joined.nodes.len().max(joined.triangles.len()))?;
        }
        joined.tlas_root = joined.nodes.len() as u32;
        joined.place(placements)?;
        Ok(joined)
    }

    /// Builds the TLAS anew over other placements of the same BLASes, which stay where they are in the buffers:
    /// only nodes from [`tlas_root`](Self::tlas_root) on and the instances change.
    ///
    /// # Errors
    /// As [`build`](Self::build); after one nothing has changed.
    pub fn place(&mut self, placements: &[Placement]) -> Result<(), BuildError> {
        check_count(placements.len())?;
        let mut instances = Vec::with_capacity(placements.len());
        for (index, placement) in placements.iter().enumerate() {
            let part = self.sections.get(placement.blas as usize).ok_or(BuildError::BlasOutOfRange {
                placement: index,
                blas: placement.blas,
                count: self.sections.len(),
            })?;
            // A mesh without triangles has no box and nothing to hit.
            if part.bounds.low.cmple(part.bounds.high).all() {
                instances.push(instance(index, placement, part)?);
            }
        }
        self.nodes.truncate(self.tlas_root as usize);
        if instances.is_empty() {
            self.nodes.push(Node::default());
            self.instances = instances;
            self.binary = None;
            return Ok(());
        }
        let boxes: Vec<Bounds> = instances.iter().map(instance_bounds).collect();
        let tree = KernelTree::build(&boxes, BuildQuality::Fast, INSTANCE_LEAF);
        self.binary = Some(tree.binary);
        self.instances = tree.order.iter().map(|&from| instances[from as usize]).collect();
        self.nodes.extend(tree.nodes);
        Ok(())
    }

    /// Nodes of every BLAS, then those of the TLAS.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Triangles of every BLAS, one after the other, each in leaf order.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Instances in leaf order, which is how hits name them.
    pub fn instances(&self) -> &[Instance] {
        &self.instances
    }

    /// Index of the TLAS's root among the nodes.
    pub fn tlas_root(&self) -> u32 {
        self.tlas_root
    }

    /// Index among the triangles of the first one of a BLAS.
    pub fn first_triangle(&self, blas: usize) -> Option<u32> {
        self.sections.get(blas).map(|part| part.first_triangle)
    }

    /// The wide tree of each instance.
    pub(crate) fn simd_parts(&self) -> Vec<Part<'_>> {
        let trees: Vec<&SimdTree> = self.sections.iter().map(|s| s.wide.tree(self.section(s))).collect();
        let by_root = |root: u32| self.sections.partition_point(|s| s.root < root);
        let part = |i: &Instance| Part {
            tree: trees[by_root(i.root)],
            triangles: &self.triangles,
            first_triangle: i.first_triangle,
        };
        self.instances.iter().map(part).collect()
    }

    fn section(&self, section: &Section) -> &[Triangle] {
        let first = section.first_triangle as usize;
        &self.triangles[first..first + section.triangles as usize]
    }

    pub(crate) fn binary(&self) -> Option<&BinaryTree> {
        self.binary.as_ref()
    }

    /// Checks the TLAS as [`Bvh::validate`] does a BLAS; node numbers count from the TLAS's root.
    ///
    /// # Errors
    /// The first fault found, naming its node.
    pub fn validate(&self) -> Result<(), Invalid> {
        let boxes: Vec<Bounds> = self.instances.iter().map(instance_bounds).collect();
        validate_tree(&self.nodes[self.tlas_root as usize..], &boxes)
    }
}

fn check_count(found: usize) -> Result<(), BuildError> {
    const LIMIT: usize = (1 << 31) - 1;
    if found > LIMIT { Err(BuildError::TooMany { found, limit: LIMIT }) } else { Ok(()) }
}

pub(crate) fn instance_bounds(instance: &Instance) -> Bounds {
    Bounds { low: instance.low_world, high: instance.high_world }
}

fn rows(map: &DAffine3) -> [Vec4; 3] {
    let m = map.matrix3.transpose();
    let t = map.translation;
    [m.x_axis.extend(t.x).as_vec4(), m.y_axis.extend(t.y).as_vec4(), m.z_axis.extend(t.z).as_vec4()]
}

fn absolute(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.x_axis.abs(), m.y_axis.abs(), m.z_axis.abs())
}

fn instance(index: usize, placement: &Placement, part: &Section) -> Result<Instance, BuildError> {
    let singular = BuildError::Singular { placement: index };
    let m = placement.object_to_world;
    let to_world = DAffine3 { matrix3: m.matrix3.as_dmat3(), translation: m.translation.as_dvec3() };
    if !to_world.is_finite() || to_world.matrix3.determinant() == 0.0 {
        return Err(singular);
    }
    let to_object = to_world.inverse();
    let (low, high) = (part.bounds.low.as_dvec3(), part.bounds.high.as_dvec3());
    // The box of a mapped box is its mapped centre and its extent under the absolute matrix.
    let centre = to_world.transform_point3((low + high) * 0.5);
    let extent = absolute(to_world.matrix3) * ((high - low) * 0.5);
    let reach = centre.abs() + extent;
    // A world position as large as these maps to object space with this error, which maps back to this margin.
    let object_error = absolute(to_object.matrix3) * reach + to_object.translation.abs();
    let margin = (absolute(to_world.matrix3) * object_error + reach) * INSTANCE_ROUNDINGS;
    let instance = Instance {
        world_to_object: rows(&to_object),
        object_to_world: rows(&to_world),
        low_world: (centre - extent - margin).as_vec3(),
        root: part.root,
        high_world: (centre + extent + margin).as_vec3(),
        first_triangle: part.first_triangle,
        source: index as u32,
        padding: [0; 3],
    };
    let usable = |x: f32| x.abs() < COORDINATE_LIMIT;
    let rows = instance.world_to_object.iter().chain(&instance.object_to_world);
    let fits = rows.flat_map(|row| row.to_array()).all(usable)
        && instance.low_world.to_array().into_iter().all(usable)
        && instance.high_world.to_array().into_iter().all(usable);
    if fits { Ok(instance) } else { Err(singular) }
}
