//! Stack traversal of one compressed wide tree, in groups of children (Ylitie, Karras, Laine 2017, algorithm 1).

use crate::any_hit::AnyHit;
use crate::fold::{Blocked, Fold, Product};
use crate::node::{INNER_BITS, Node, octant};
use crate::probe::{NoProbe, Probe};
use crate::ray::{Hit, NONE, Ray};
use crate::slab::{Span, WHOLE_RAY};
use crate::transmit::Transmit;
use crate::triangle::{Shear, Triangle, is_nearer};
use lt_math::glam::Vec3;

/// Levels of a tree that a traversal can hold; builders return an error for (and validation rejects) more.
pub const MAX_DEPTH: usize = 32;

/// A tree inside shared buffers: its links count from `root` and `first_primitive`.
#[derive(Clone, Copy)]
pub(crate) struct Tree {
    pub root: u32,
    pub first_primitive: u32,
}

/// Nodes still to visit: groups of siblings, as first sibling and hit mask over the parent's inner mask.
pub(crate) struct Stack {
    first: [u32; MAX_DEPTH],
    mask: [u32; MAX_DEPTH],
    len: usize,
    /// The group at hand.
    group: u32,
    group_mask: u32,
}

/// The root's group: one sibling, hit.
const ROOT_GROUP: u32 = 0x8000_0000;

impl Stack {
    #[inline(always)]
    pub fn new(root: u32) -> Self {
        Stack { first: [0; MAX_DEPTH], mask: [0; MAX_DEPTH], len: 0, group: root, group_mask: ROOT_GROUP }
    }

    /// The next node in order, [`NONE`] when none is left.
    #[inline(always)]
    pub fn next(&mut self, octant: u32) -> u32 {
        if self.group_mask & INNER_BITS == 0 {
            if self.len == 0 {
                return NONE;
            }
            self.len -= 1;
            self.group = self.first[self.len];
            self.group_mask = self.mask[self.len];
        }
        let bit = 31 - self.group_mask.leading_zeros();
        let slot = (bit - 24) ^ octant;
        let siblings_before = (self.group_mask & !(u32::MAX << slot) & 0xff).count_ones();
        self.group_mask &= !(1 << bit);
        self.group + siblings_before
    }

    /// Turns to the children `first…` of the node just taken, leaving its siblings for later.
    #[inline(always)]
    pub fn descend(&mut self, first: u32, hits: u32, inner_mask: u32) {
        if hits & INNER_BITS == 0 {
            return;
        }
        if self.group_mask & INNER_BITS != 0 && self.len < MAX_DEPTH {
            self.first[self.len] = self.group;
            self.mask[self.len] = self.group_mask;
            self.len += 1;
        }
        self.group = first;
        self.group_mask = (hits & INNER_BITS) | inner_mask;
    }
}

/// Nearest hit in one tree, given the best one so far.
#[inline(always)]
pub(crate) fn closest_in_tree<A: AnyHit, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    tree: Tree,
    instance: u32,
    ray: Ray,
    window: Span,
    any_hit: A,
    mut best: Hit,
    probe: &mut P,
) -> Hit {
    if !ray.is_valid() || tree.root as usize >= nodes.len() {
        return best;
    }
    let slab = nodes[tree.root as usize].slab(&ray);
    let shear = Shear::new(&ray);
    // The root forms a group by itself whose only hit bit must come out as slot 0.
    let octant = octant(&slab);
    let mut stack = Stack::new(tree.root);
    let mut at = stack.next(7);
    while at != NONE {
        let node = &nodes[at as usize];
        probe.node();
        let hits = node.hits(&slab, octant, ray.tmin, best.t);
        stack.descend(tree.root + node.links.x, hits, node.inner_mask());
        let mut leaves = hits & !INNER_BITS;
        while leaves != 0 {
            let index = tree.first_primitive + node.links.y + leaves.trailing_zeros();
            leaves &= leaves - 1;
            probe.triangle();
            let triangle = &triangles[index as usize];
            let hit = shear.intersect(&ray, &slab, triangle, window);
            if hit.is_hit && hit.t > ray.tmin && is_nearer(hit.t, index, instance, &best) {
                let counts = triangle.is_opaque() || any_hit.accepts(index, hit.u, hit.v);
                if counts {
                    best = Hit { t: hit.t, u: hit.u, v: hit.v, triangle: index, instance };
                }
            }
        }
        at = stack.next(octant);
    }
    best
}

/// Follows a ray through every hit in one tree, in any order, until `F` says that no further one matters.
#[inline(always)]
pub(crate) fn fold_in_tree<F: Fold<C>, C: Copy, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    tree: Tree,
    ray: Ray,
    window: Span,
    callback: C,
    mut state: F::State,
    probe: &mut P,
) -> F::State {
    if !ray.is_valid() || tree.root as usize >= nodes.len() {
        return state;
    }
    let slab = nodes[tree.root as usize].slab(&ray);
    let shear = Shear::new(&ray);
    let octant = octant(&slab);
    let mut stack = Stack::new(tree.root);
    let mut at = stack.next(7);
    while at != NONE {
        let node = &nodes[at as usize];
        probe.node();
        let hits = node.hits(&slab, octant, ray.tmin, ray.tmax);
        stack.descend(tree.root + node.links.x, hits, node.inner_mask());
        let mut leaves = hits & !INNER_BITS;
        while leaves != 0 {
            let index = tree.first_primitive + node.links.y + leaves.trailing_zeros();
            leaves &= leaves - 1;
            probe.triangle();
            let triangle = &triangles[index as usize];
            let hit = shear.intersect(&ray, &slab, triangle, window);
            if hit.is_hit && hit.t > ray.tmin && hit.t < ray.tmax {
                state = F::meet(&callback, state, triangle.is_opaque(), index, hit.u, hit.v);
                if F::is_over(state) {
                    return state;
                }
            }
        }
        at = stack.next(octant);
    }
    state
}

/// Nearest hit of a world-space ray in the tree whose root is `nodes[0]`.
///
/// `triangles` in leaf order as the builder made them. An empty `nodes` is an empty scene.
pub fn closest_hit<A: AnyHit>(nodes: &[Node], triangles: &[Triangle], ray: Ray, any_hit: A) -> Hit {
    closest_hit_probed(nodes, triangles, ray, any_hit, &mut NoProbe)
}

/// [`closest_hit`], telling `probe` of every test.
pub fn closest_hit_probed<A: AnyHit, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    ray: Ray,
    any_hit: A,
    probe: &mut P,
) -> Hit {
    let tree = Tree { root: 0, first_primitive: 0 };
    let best = Hit::miss(ray.tmax);
    closest_in_tree(nodes, triangles, tree, NONE, ray, WHOLE_RAY, any_hit, best, probe)
}

/// Whether anything in the tree whose root is `nodes[0]` blocks a world-space ray; the first hit ends it.
pub fn occluded<A: AnyHit>(nodes: &[Node], triangles: &[Triangle], ray: Ray, any_hit: A) -> bool {
    occluded_probed(nodes, triangles, ray, any_hit, &mut NoProbe)
}

/// [`occluded`], telling `probe` of every test.
pub fn occluded_probed<A: AnyHit, P: Probe>(
    nodes: &[Node],
    triangles: &[Triangle],
    ray: Ray,
    any_hit: A,
    probe: &mut P,
) -> bool {
    let tree = Tree { root: 0, first_primitive: 0 };
    fold_in_tree::<Blocked, _, _>(nodes, triangles, tree, ray, WHOLE_RAY, any_hit, false, probe)
}

/// The light that a world-space ray leaves of white after all that it meets in the tree whose root is `nodes[0]`: the
/// product of what every hit lets through, linear RGB in [0, 1].
///
/// Hits are multiplied in the tree's order, so that another tree over the same triangles may differ by a rounding
/// (2⁻²⁴ of the product) per hit.
pub fn transmitted<T: Transmit>(nodes: &[Node], triangles: &[Triangle], ray: Ray, transmit: T) -> Vec3 {
    let tree = Tree { root: 0, first_primitive: 0 };
    fold_in_tree::<Product, _, _>(nodes, triangles, tree, ray, WHOLE_RAY, transmit, Vec3::ONE, &mut NoProbe)
}
