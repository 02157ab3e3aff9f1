//! Geometry as kernels see it: one world-space tree, or a TLAS over placed trees.

use lt_bvh::{
    AnyHit, Hit, Instance, Node, Ray, Triangle, closest_hit, closest_hit_instanced, occluded,
    occluded_instanced,
};
use lt_math::glam::Vec3;

/// Something rays can be traced against.
pub trait Geometry: Copy {
    /// Nearest hit.
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit;
    /// Whether anything blocks the ray.
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool;
    /// The triangle that was hit, in its tree's space.
    fn triangle(&self, hit: &Hit) -> Triangle;
    /// The triangle that was hit, its corners in world space.
    fn corners_world(&self, hit: &Hit) -> [Vec3; 3];
    /// A point of the hit's tree in world space.
    fn point_to_world(&self, hit: &Hit, point: Vec3) -> Vec3;
    /// A normal of the hit's tree in world space, any length.
    fn normal_to_world(&self, hit: &Hit, normal: Vec3) -> Vec3;
}

/// One tree in world space.
#[derive(Clone, Copy)]
pub struct FlatGeometry<'a> {
    /// The tree; its root is node 0.
    pub nodes: &'a [Node],
    /// Triangles in leaf order.
    pub triangles: &'a [Triangle],
}

impl Geometry for FlatGeometry<'_> {
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit {
        closest_hit(self.nodes, self.triangles, ray, any_hit)
    }
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool {
        occluded(self.nodes, self.triangles, ray, any_hit)
    }
    fn triangle(&self, hit: &Hit) -> Triangle {
        self.triangles[hit.triangle as usize]
    }
    fn corners_world(&self, hit: &Hit) -> [Vec3; 3] {
        let t = self.triangle(hit);
        [t.v0, t.v1, t.v2]
    }
    fn point_to_world(&self, _hit: &Hit, point: Vec3) -> Vec3 {
        point
    }
    fn normal_to_world(&self, _hit: &Hit, normal: Vec3) -> Vec3 {
        normal
    }
}

/// A TLAS over placed trees.
#[derive(Clone, Copy)]
pub struct InstancedGeometry<'a> {
    /// The TLAS and every BLAS.
    pub nodes: &'a [Node],
    /// The triangles of every BLAS.
    pub triangles: &'a [Triangle],
    /// Placed trees in the TLAS's leaf order.
    pub instances: &'a [Instance],
    /// The TLAS's first node.
    pub root: u32,
}

impl Geometry for InstancedGeometry<'_> {
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit {
        closest_hit_instanced(self.nodes, self.triangles, self.instances, self.root, ray, any_hit)
    }
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool {
        occluded_instanced(self.nodes, self.triangles, self.instances, self.root, ray, any_hit)
    }
    fn triangle(&self, hit: &Hit) -> Triangle {
        self.triangles[hit.triangle as usize]
    }
    fn corners_world(&self, hit: &Hit) -> [Vec3; 3] {
        let t = self.triangle(hit);
        let instance = &self.instances[hit.instance as usize];
        [instance.point_to_world(t.v0), instance.point_to_world(t.v1), instance.point_to_world(t.v2)]
    }
    fn point_to_world(&self, hit: &Hit, point: Vec3) -> Vec3 {
        self.instances[hit.instance as usize].point_to_world(point)
    }
    fn normal_to_world(&self, hit: &Hit, normal: Vec3) -> Vec3 {
        // The inverse transpose of object-to-world: the transpose of world-to-object.
        let rows = &self.instances[hit.instance as usize].world_to_object;
        rows[0].truncate() * normal.x + rows[1].truncate() * normal.y + rows[2].truncate() * normal.z
    }
}
