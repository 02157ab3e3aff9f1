//! A shadow ray, as a point of light space, through a tree of boxes there; what it finds is put to the ray tracer's own test.
//!
//! A box there is compared with seven planes, and none is looked at beyond the light. The answer is [`occluded`](crate::occluded)'s, because
//! what decides is the same test of the same triangles; boxes must hold every point that this test might say yes to
//! (`lt_irregular::PackedLightBvh` has the proof).

use crate::any_hit::AnyHit;
use crate::light::node::triangle_in;
use crate::light::{LightNode, LightSpace};
use crate::node::Node;
use crate::probe::{NoProbe, Probe};
use crate::ray::{NONE, Ray};
use crate::slab::WHOLE_RAY;
use crate::traverse::{MAX_DEPTH, occluded_probed};
use crate::triangle::{Shear, Triangle};
use lt_math::glam::UVec4;

/// Whether anything blocks a shadow ray to the light of `space`: [`occluded`](crate::occluded)'s answer, found in a tree over the light's
/// own space.
///
/// `rows` hold [`LightNode`]s, [`NODE_ROWS`](crate::NODE_ROWS) each, and behind them the triangles of leaves, eight to two rows. `nodes` and `triangles` are
/// the ray tracer's; rays that are no points of the space ([`LightSpace::takes`]) walk its tree.
pub fn occluded_in_light_space<A: AnyHit>(
    rows: &[UVec4],
    nodes: &[Node],
    triangles: &[Triangle],
    space: LightSpace,
    ray: Ray,
    any_hit: A,
) -> bool {
    occluded_in_light_space_probed(rows, nodes, triangles, space, ray, any_hit, &mut NoProbe)
}

/// [`occluded_in_light_space`], telling `probe` of every test.
pub fn occluded_in_light_space_probed<A: AnyHit, P: Probe>(
    rows: &[UVec4],
    nodes: &[Node],
    triangles: &[Triangle],
    space: LightSpace,
    ray: Ray,
    any_hit: A,
    probe: &mut P,
) -> bool {
    if !ray.is_valid() {
        return false;
    }
    if !space.takes(&ray) {
        return occluded_probed(nodes, triangles, ray, any_hit, probe);
    }
    let (point, root) = space.point(&ray);
    if root == NONE {
        return false;
    }
    let diagonal = space.diagonal(&point);
    let slab = nodes[0].slab(&ray);
    let shear = Shear::new(&ray);
    // Siblings still to visit: the first of eight, and a bit for each in the lowest byte.
    let mut stack = [0u32; MAX_DEPTH];
    let mut len = 0;
    let mut group = root << 8 | 1;
    let mut is_blocked = false;
    // Loops end at their foot: threads in step then run no body for nothing where all are done.
    loop {
        // Down to a leaf whose boxes hold the point, by itself, so that threads in step come to test triangles together.
        let mut hits = 0;
        let mut ids = 0;
        loop {
            let node = LightNode::load(rows, (group >> 8) + group.trailing_zeros());
            probe.node();
            group &= group - 1;
            let holders = node.holders(&point, diagonal);
            if node.is_leaf() {
                hits = holders;
                ids = node.first();
            } else if holders != 0 {
                if group & 0xff != 0 && len < MAX_DEPTH {
                    stack[len] = group;
                    len += 1;
                }
                group = node.first() << 8 | holders;
            }
            if group & 0xff == 0 {
                group = 0;
                if len > 0 {
                    len -= 1;
                    group = stack[len];
                }
            }
            if hits != 0 || group == 0 {
                break;
            }
        }
        if hits != 0 {
            loop {
                let index = triangle_in(rows, ids, hits.trailing_zeros());
                hits &= hits - 1;
                probe.triangle();
                let triangle = &triangles[index as usize];
                let hit = shear.intersect(&ray, &slab, triangle, WHOLE_RAY);
                let is_met = hit.is_hit && hit.t > ray.tmin && hit.t < ray.tmax;
                if is_met && (triangle.is_opaque() || any_hit.accepts(index, hit.u, hit.v)) {
                    is_blocked = true;
                    hits = 0;
                    group = 0;
                }
                if hits == 0 {
                    break;
                }
            }
        }
        if group == 0 {
            break;
        }
    }
    is_blocked
}
