//! The triangles that block, as the ray tracer knows them, and its own test as the last instance.

use crate::block::ASKS;
use crate::lanes::{Lanes, Level};
use crate::view::{Rays, View, permute};
use lt_bvh::{AnyHit, Node, Ray, RayTest, Triangle};
use lt_math::glam::{Vec3, Vec4};

/// Triangles in the ray tracer's leaf order and the root of its tree, which its margins depend on.
#[derive(Clone, Copy)]
pub struct Casters<'a> {
    /// Root of the ray tracer's tree over `triangles`.
    pub root: &'a Node,
    /// The triangles.
    pub triangles: &'a [Triangle],
}

impl Casters<'_> {
    /// Asks for a triangle by its id in a block, that it may have come by the time it is needed.
    #[inline(always)]
    pub(crate) fn prefetch<L: Level>(&self, level: L, id: u32) {
        if let Some(triangle) = self.triangles.get((id & !ASKS) as usize) {
            level.prefetch(triangle);
        }
    }

    /// Where the ray meets the triangle by the ray tracer's own test, whatever that is made of: weights of the second and third vertex.
    #[inline(always)]
    pub(crate) fn meet(&self, ray: &Ray, triangle: u32) -> Option<(f32, f32)> {
        RayTest::new(ray, self.root)?.meet(&self.triangles[triangle as usize])
    }
}

/// What is asked about rays to one light.
#[derive(Clone, Copy)]
pub(crate) struct Query<'a, A> {
    pub casters: Casters<'a>,
    pub light: Vec4,
    pub any_hit: A,
}

impl<A: AnyHit> Query<'_, A> {
    /// The ray tracer's own answer about one ray and all triangles, one after another.
    #[inline(never)]
    pub fn is_blocked_by_any(&self, origin: Vec3) -> bool {
        (0..self.casters.triangles.len()).any(|i| self.is_blocked(origin, i as u32))
    }

    /// The ray tracer's own answer about one ray and one triangle.
    #[inline(never)]
    pub fn is_blocked(&self, origin: Vec3, triangle: u32) -> bool {
        let ray = Ray::to_light(origin, self.light);
        let test = RayTest::new(&ray, self.casters.root);
        test.is_some_and(|t| {
            t.is_blocked_by(&self.casters.triangles[triangle as usize], triangle, self.any_hit)
        })
    }
}

/// One triangle's plane by the ray tracer's own arithmetic, to be held against several rays at a time.
///
/// The operations and their order are those of lt-bvh/src/triangle.rs, `plane_t`, so that a t that does not count here does not
/// count there. Nearly all rays that the depth plane cannot decide start on the very triangle, and end here.
#[derive(Clone, Copy)]
pub(crate) struct Plane {
    v0: Vec3,
    normal: Vec3,
    axis: u32,
    sign: f32,
    /// Of parallel rays: 1 / direction.z, and the denominator.
    parallel: Option<(f32, f32)>,
}

impl Plane {
    #[inline(always)]
    pub fn new(view: &View, triangle: &Triangle) -> Self {
        let e = permute(triangle.v1 - triangle.v0, view.axis);
        let f = permute(triangle.v2 - triangle.v0, view.axis);
        let n = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
        let parallel = match view.rays {
            Rays::Parallel { shear, .. } => Some((shear.z, n.x * shear.x + n.y * shear.y + n.z)),
            Rays::Converging { .. } => None,
        };
        Plane { v0: triangle.v0, normal: n, axis: view.axis, sign: view.sign, parallel }
    }

    /// The lanes whose ray may meet the plane before its end. `origin` in permuted axes, `point` in light space.
    #[inline(always)]
    pub fn meets<L: Lanes>(&self, lanes: L, origin: [L::F; 3], point: [L::F; 3]) -> u32 {
        let v0 = permute(self.v0, self.axis);
        let n = self.normal;
        let (nx, ny, nz) = (lanes.splat(n.x), lanes.splat(n.y), lanes.splat(n.z));
        let distance = lanes.add(
            lanes.add(
                lanes.mul(nx, lanes.sub(lanes.splat(v0.x), origin[0])),
                lanes.mul(ny, lanes.sub(lanes.splat(v0.y), origin[1])),
            ),
            lanes.mul(nz, lanes.sub(lanes.splat(v0.z), origin[2])),
        );
        let zero = lanes.splat(0.0);
        match self.parallel {
            Some((z, slope)) => {
                let t = lanes.div(lanes.mul(lanes.splat(z), distance), lanes.splat(slope));
                lanes.lt(zero, t)
            }
            None => {
                let slope = lanes.add(lanes.add(lanes.mul(nx, point[0]), lanes.mul(ny, point[1])), nz);
                // Nearness is ±1 / direction.z to the last bit.
                let z = lanes.mul(point[2], lanes.splat(self.sign));
                let t = lanes.div(lanes.mul(z, distance), slope);
                lanes.lt(zero, t) & lanes.lt(t, lanes.splat(1.0))
            }
        }
    }

    /// The same for one ray.
    #[inline(always)]
    pub fn meets_one(&self, origin: Vec3, point: [f32; 3]) -> bool {
        let o = permute(origin, self.axis);
        let from = permute(self.v0, self.axis) - o;
        let n = self.normal;
        let distance = n.x * from.x + n.y * from.y + n.z * from.z;
        match self.parallel {
            Some((z, slope)) => z * distance / slope > 0.0,
            None => {
                let t = point[2] * self.sign * distance / (n.x * point[0] + n.y * point[1] + n.z);
                t > 0.0 && t < 1.0
            }
        }
    }
}
