//! One ray against one triangle, outside of any tree.

use crate::any_hit::AnyHit;
use crate::ray::Ray;
use crate::slab::{Slab, WHOLE_RAY};
use crate::triangle::{Shear, Triangle};
use lt_math::glam::Vec3;

/// A ray ready to be put to triangles one by one, for structures that find their candidates in another way than a tree of boxes.
///
/// The answer of [`occluded`](crate::occluded) is whether [`RayTest::is_blocked_by`] holds for any triangle of the tree.
#[derive(Clone, Copy)]
pub struct RayTest {
    ray: Ray,
    slab: Slab,
    shear: Shear,
}

impl RayTest {
    /// Prepares a ray for the triangles of a tree whose root has the box from `low` to `high` ([`Node::low`](crate::Node::low),
    /// [`Node::high`](crate::Node::high)), which the margins of the test are in proportion to. `None` for a ray that hits nothing
    /// ([`Ray::is_valid`]).
    #[inline]
    pub fn new(ray: &Ray, low: Vec3, high: Vec3) -> Option<Self> {
        ray.is_valid().then(|| RayTest { ray: *ray, slab: Slab::new(ray, low, high), shear: Shear::new(ray) })
    }

    /// Where the ray meets `triangle`, whatever that is made of: weights of its second and third vertex.
    #[inline]
    pub fn meet(&self, triangle: &Triangle) -> Option<(f32, f32)> {
        let hit = self.shear.intersect(&self.ray, &self.slab, triangle, WHOLE_RAY);
        (hit.is_hit && hit.t > self.ray.tmin && hit.t < self.ray.tmax).then_some((hit.u, hit.v))
    }

    /// Whether `triangle`, which `any_hit` knows as `index`, blocks the ray.
    #[inline]
    pub fn is_blocked_by<A: AnyHit>(&self, triangle: &Triangle, index: u32, any_hit: A) -> bool {
        self.meet(triangle).is_some_and(|(u, v)| triangle.is_opaque() || any_hit.accepts(index, u, v))
    }
}
