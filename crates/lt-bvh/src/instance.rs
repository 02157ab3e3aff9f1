//! Two levels: a tree of instances, each a placed tree of its own (TLAS over BLAS).

use crate::any_hit::AnyHit;
use crate::fold::Blocked;
use crate::node::{INNER_BITS, Node, octant};
use crate::probe::{NoProbe, Probe};
use crate::ray::{Hit, NONE, Ray};
use crate::slab::{Slab, Span};
use crate::traverse::{Stack, Tree, closest_in_tree, fold_in_tree};
use crate::triangle::Triangle;
use bytemuck::{Pod, Zeroable};
use lt_math::glam::{Vec3, Vec4};

/// A placed BLAS.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Instance {
    /// Rows of the affine map from world space to the BLAS's space.
    pub world_to_object: [Vec4; 3],
    /// Rows of the affine map from the BLAS's space to world space.
    pub object_to_world: [Vec4; 3],
    /// Lower corner of the world-space box, widened for the rounding of the two maps.
    pub low_world: Vec3,
    /// First node of the BLAS in the shared node buffer.
    pub root: u32,
    /// Upper corner of the world-space box.
    pub high_world: Vec3,
    /// First triangle of the BLAS in the shared triangle buffer.
    pub first_triangle: u32,
    /// The caller's index of this instance: the TLAS sorts its instances.
    pub source: u32,
    /// Zero.
    pub padding: [u32; 3],
}

const _: () = assert!(size_of::<Instance>() == 144);

#[inline(always)]
fn transform(rows: &[Vec4; 3], v: Vec4) -> Vec3 {
    Vec3::new(rows[0].dot(v), rows[1].dot(v), rows[2].dot(v))
}

impl Instance {
    /// The ray in the BLAS's space; t means the same in both.
    #[inline(always)]
    pub fn to_object(&self, ray: &Ray) -> Ray {
        Ray {
            origin: transform(&self.world_to_object, ray.origin.extend(1.0)),
            direction: transform(&self.world_to_object, ray.direction.extend(0.0)),
            ..*ray
        }
    }

    /// A point of the BLAS's space, in world space.
    #[inline(always)]
    pub fn point_to_world(&self, point: Vec3) -> Vec3 {
        transform(&self.object_to_world, point.extend(1.0))
    }

    /// Where the ray passes this instance's world box. Only what lies there is looked at, whichever boxes of
    /// the TLAS lead here.
    #[inline(always)]
    pub(crate) fn window(&self, slab: &Slab) -> Span {
        slab.span(self.low_world, self.high_world)
    }

    #[inline(always)]
    pub(crate) fn tree(&self) -> Tree {
        Tree { root: self.root, first_primitive: self.first_triangle }
    }
}

/// Nearest hit of a world-space ray among all instances under the TLAS whose root is `nodes[tlas_root]`.
///
/// `nodes` holds the TLAS and every BLAS, `triangles` all their triangles, `instances` in the TLAS's leaf order.
/// `Hit::triangle` indexes `triangles`, `Hit::instance` indexes `instances`.
pub fn closest_hit_instanced<A: AnyHit>(
    nodes: &[Node],
    triangles: &[Triangle],
    instances: &[Instance],
    tlas_root: u32,
    ray: Ray,
    any_hit: A,
) -> Hit {
    closest_hit_instanced_probed(nodes, triangles, instances, tlas_root, ray, any_hit, &mut NoProbe)
}

/// [`closest_hit_instanced`], telling `probe` of every test.
pub fn closest_hit_instanced_probed<A: AnyHit, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    instances: &[Instance],
    tlas_root: u32,
    ray: Ray,
    any_hit: A,
    probe: &mut P,
) -> Hit {
    let mut best = Hit::miss(ray.tmax);
    if !ray.is_valid() || tlas_root as usize >= nodes.len() {
        return best;
    }
    let slab = nodes[tlas_root as usize].slab(&ray);
    let octant = octant(&slab);
    let mut stack = Stack::new(tlas_root);
    let mut at = stack.next(7);
    while at != NONE {
        let node = &nodes[at as usize];
        probe.node();
        let hits = node.hits(&slab, octant, ray.tmin, best.t);
        stack.descend(tlas_root + node.links.x, hits, node.inner_mask());
        let mut leaves = hits & !INNER_BITS;
        while leaves != 0 {
            let index = node.links.y + leaves.trailing_zeros();
            leaves &= leaves - 1;
            let instance = &instances[index as usize];
            let window = instance.window(&slab);
            if window.near <= window.far && window.near <= best.t && window.far >= ray.tmin {
                let object = instance.to_object(&ray);
                let tree = instance.tree();
                best = closest_in_tree(nodes, triangles, tree, index, object, window, any_hit, best, probe);
            }
        }
        at = stack.next(octant);
    }
    best
}

/// Whether any instance under the TLAS whose root is `nodes[tlas_root]` blocks a world-space ray.
///
/// Buffers as in [`closest_hit_instanced`].
pub fn occluded_instanced<A: AnyHit>(
    nodes: &[Node],
    triangles: &[Triangle],
    instances: &[Instance],
    tlas_root: u32,
    ray: Ray,
    any_hit: A,
) -> bool {
    occluded_instanced_probed(nodes, triangles, instances, tlas_root, ray, any_hit, &mut NoProbe)
}

/// [`occluded_instanced`], telling `probe` of every test.
pub fn occluded_instanced_probed<A: AnyHit, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    instances: &[Instance],
    tlas_root: u32,
    ray: Ray,
    any_hit: A,
    probe: &mut P,
) -> bool {
    let mut is_blocked = false;
    if !ray.is_valid() || tlas_root as usize >= nodes.len() {
        return is_blocked;
    }
    let slab = nodes[tlas_root as usize].slab(&ray);
    let octant = octant(&slab);
    let mut stack = Stack::new(tlas_root);
    let mut at = stack.next(7);
    while at != NONE {
        let node = &nodes[at as usize];
        probe.node();
        let hits = node.hits(&slab, octant, ray.tmin, ray.tmax);
        stack.descend(tlas_root + node.links.x, hits, node.inner_mask());
        let mut leaves = hits & !INNER_BITS;
        while leaves != 0 {
            let index = node.links.y + leaves.trailing_zeros();
            leaves &= leaves - 1;
            let instance = &instances[index as usize];
            let window = instance.window(&slab);
            if window.near <= window.far && window.near <= ray.tmax && window.far >= ray.tmin {
                let object = instance.to_object(&ray);
                let tree = instance.tree();
                is_blocked = fold_in_tree::<Blocked, _, _>(
                    nodes, triangles, tree, object, window, any_hit, is_blocked, probe,
                );
                if is_blocked {
                    return true;
                }
            }
        }
        at = stack.next(octant);
    }
    false
}
