//! Geometry as kernels see it: one world-space tree, a TLAS over placed trees, or a tree in a light's own space.

use lt_bvh::{
    AnyHit, Hit, Instance, LightSpace, Node, Ray, Triangle, closest_hit, closest_hit_instanced, occluded,
    occluded_in_light_space, occluded_instanced,
};
use lt_math::glam::{UVec4, Vec3};

/// Something that blocks shadow rays.
pub trait Occluder: Copy {
    /// Whether anything blocks the ray.
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool;
}

/// Something rays can be traced against.
pub trait Geometry: Occluder {
    /// Nearest hit.
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit;
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

impl Occluder for FlatGeometry<'_> {
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool {
        occluded(self.nodes, self.triangles, ray, any_hit)
    }
}

impl Geometry for FlatGeometry<'_> {
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit {
        closest_hit(self.nodes, self.triangles, ray, any_hit)
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

/// One tree in world space, and one in a light's own space for the rays to that light.
#[derive(Clone, Copy)]
pub struct LightGeometry<'a> {
    /// The tree in light space, as `lt_bvh::occluded_in_light_space` takes it.
    pub rows: &'a [UVec4],
    /// The tree in world space, for rays that are no points of the light's space; its root is node 0.
    pub nodes: &'a [Node],
    /// Triangles in the leaf order of the tree in world space.
    pub triangles: &'a [Triangle],
    /// How rays become points.
    pub space: LightSpace,
}

impl Occluder for LightGeometry<'_> {
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool {
        occluded_in_light_space(self.rows, self.nodes, self.triangles, self.space, ray, any_hit)
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

impl Occluder for InstancedGeometry<'_> {
    fn is_occluded<A: AnyHit>(&self, ray: Ray, any_hit: A) -> bool {
        occluded_instanced(self.nodes, self.triangles, self.instances, self.root, ray, any_hit)
    }
}

impl Geometry for InstancedGeometry<'_> {
    fn closest<A: AnyHit>(&self, ray: Ray, any_hit: A) -> Hit {
        closest_hit_instanced(self.nodes, self.triangles, self.instances, self.root, ray, any_hit)
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
