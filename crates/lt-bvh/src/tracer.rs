//! The seam under which a CPU tracer may be fast: batches of rays in, the shared kernel's answers out.

use crate::any_hit::AnyHit;
use crate::build::{Bvh, InstancedBvh};
use crate::instance::{Instance, closest_hit_instanced, occluded_instanced};
use crate::node::Node;
use crate::ray::{Hit, Ray};
use crate::traverse::{closest_hit, occluded};
use crate::triangle::Triangle;

/// Traces batches of rays.
///
/// Every implementation answers with the bits of the shared kernel, ray by ray. Batches are best a tile of
/// neighbouring rays each, in an order where neighbours follow one another (8×8 pixels in Morton order, say):
/// implementations may share work among them.
pub trait Tracer {
    /// Whether each ray is blocked. Stops at the end of the shorter of `rays` and `out`.
    fn occluded_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [bool]);

    /// Each ray's nearest hit. Stops at the end of the shorter of `rays` and `out`.
    fn closest_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [Hit]);
}

/// Traces ray by ray with the shared kernel itself.
#[derive(Clone, Copy)]
pub struct Scalar<'a> {
    nodes: &'a [Node],
    triangles: &'a [Triangle],
    /// The instances and the TLAS's root, of a tree that has any.
    tlas: Option<(&'a [Instance], u32)>,
}

impl<'a> Scalar<'a> {
    /// For the triangles of one tree in world space.
    pub fn new(bvh: &'a Bvh) -> Self {
        Scalar { nodes: bvh.nodes(), triangles: bvh.triangles(), tlas: None }
    }

    /// For placed meshes.
    pub fn instanced(scene: &'a InstancedBvh) -> Self {
        let tlas = Some((scene.instances(), scene.tlas_root()));
        Scalar { nodes: scene.nodes(), triangles: scene.triangles(), tlas }
    }
}

impl Tracer for Scalar<'_> {
    fn occluded_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [bool]) {
        for (&ray, out) in rays.iter().zip(out) {
            *out = match self.tlas {
                Some((instances, root)) => {
                    occluded_instanced(self.nodes, self.triangles, instances, root, ray, any_hit)
                }
                None => occluded(self.nodes, self.triangles, ray, any_hit),
            };
        }
    }

    fn closest_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [Hit]) {
        for (&ray, out) in rays.iter().zip(out) {
            *out = match self.tlas {
                Some((instances, root)) => {
                    closest_hit_instanced(self.nodes, self.triangles, instances, root, ray, any_hit)
                }
                None => closest_hit(self.nodes, self.triangles, ray, any_hit),
            };
        }
    }
}
