//! obvhs's own traversals, over its slowest and best builds, triangles in leaf order and its own triangle test.

use std::ops::Range;
use std::time::Duration;

use lt_bvh::{AnyHit, Bvh, Ray};
use lt_math::glam::{Vec3, Vec3A};
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::rt_triangle::RtTriangle;
use obvhs::{BvhBuildParams, triangle::Triangle};

use super::measure::{Family, Way};

/// A triangle in leaf order, its index in ours, and whether it needs no asking.
type Placed = (RtTriangle, u32, bool);

/// Both trees over our triangles.
pub struct Obvhs {
    cwbvh: CwBvh,
    cwbvh_triangles: Vec<Placed>,
    bvh2: Bvh2,
    bvh2_triangles: Vec<Placed>,
}

impl Obvhs {
    /// Builds over the triangles of `ours`.
    pub fn new(ours: &Bvh) -> Self {
        let corner = |v: Vec3| Vec3A::from(v);
        let triangles: Vec<Triangle> = ours
            .triangles()
            .iter()
            .map(|t| Triangle { v0: corner(t.v0), v1: corner(t.v1), v2: corner(t.v2) })
            .collect();
        let best = BvhBuildParams::very_slow_build();
        let cwbvh = build_cwbvh_from_tris(&triangles, best, &mut Duration::default());
        let bvh2 = build_bvh2_from_tris(&triangles, best, &mut Duration::default());
        let placed = |&i: &u32| {
            (RtTriangle::from(&triangles[i as usize]), i, ours.triangles()[i as usize].is_opaque())
        };
        let cwbvh_triangles = cwbvh.primitive_indices.iter().map(placed).collect();
        let bvh2_triangles = bvh2.primitive_indices.iter().map(placed).collect();
        Self { cwbvh, cwbvh_triangles, bvh2, bvh2_triangles }
    }

    /// Both traversals.
    pub fn ways<'a, A: AnyHit + Sync + 'a>(&'a self, rays: &'a [Ray], any_hit: A) -> Vec<Box<dyn Way + 'a>> {
        let way =
            |is_wide| -> Box<dyn Way + 'a> { Box::new(Traversal { trees: self, is_wide, rays, any_hit }) };
        vec![way(true), way(false)]
    }
}

struct Traversal<'a, A> {
    trees: &'a Obvhs,
    /// CWBVH or BVH2.
    is_wide: bool,
    rays: &'a [Ray],
    any_hit: A,
}

impl<A: AnyHit + Sync> Way for Traversal<'_, A> {
    fn name(&self) -> &str {
        if self.is_wide { "obvhs, CWBVH" } else { "obvhs, BVH2" }
    }

    fn family(&self) -> Family {
        Family::Obvhs
    }

    fn trace(&self, range: Range<usize>, out: &mut [bool]) {
        let trees = self.trees;
        for (ray, out) in self.rays[range].iter().zip(out) {
            let ray = obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), ray.tmin, ray.tmax);
            *out = if self.is_wide {
                !trees.cwbvh.ray_traverse_miss(ray, |r, i| hit(&trees.cwbvh_triangles[i], r, self.any_hit))
            } else {
                !trees.bvh2.ray_traverse_miss(ray, |r, i| hit(&trees.bvh2_triangles[i], r, self.any_hit))
            };
        }
    }
}

fn hit<A: AnyHit>(triangle: &Placed, ray: &obvhs::ray::Ray, any_hit: A) -> f32 {
    let (shape, index, is_opaque) = triangle;
    let t = shape.intersect(ray);
    if t < ray.tmax && !is_opaque {
        let weights = shape.compute_barycentric(ray);
        return if any_hit.accepts(*index, weights.x, weights.y) { t } else { f32::INFINITY };
    }
    t
}
