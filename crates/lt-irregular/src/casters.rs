//! The triangles that block, as the ray tracer knows them, and its own test as the last instance.

use crate::block::ASKS;
use crate::exact::Exact;
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::lanes::{Lanes, prefetch};
use lt_bvh::{AnyHit, Node, Ray, RayTest, Triangle};
use lt_math::glam::{Vec3, Vec4};
#[cfg(feature = "std")]
use rayon::prelude::*;

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
    pub(crate) fn prefetch(&self, id: u32) {
        if let Some(triangle) = self.triangles.get((id & !ASKS) as usize) {
            prefetch(triangle);
        }
    }

    /// Where the ray meets the triangle by the ray tracer's own test, whatever that is made of: weights of the second and third vertex.
    #[inline(always)]
    pub(crate) fn meet(&self, ray: &Ray, triangle: u32) -> Option<(f32, f32)> {
        RayTest::new(ray, self.root)?.meet(&self.triangles[triangle as usize])
    }
}

/// What comes of each of a list, in order, on all threads.
pub(crate) fn each<T: Sync, R: Send>(list: &[T], run: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "std")]
    let list = list.par_iter();
    #[cfg(not(feature = "std"))]
    let list = list.iter();
    list.map(run).collect()
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
        let Some(test) = self.test(origin) else { return false };
        let mut triangles = self.casters.triangles.iter().enumerate();
        triangles.any(|(i, triangle)| test.is_blocked_by(triangle, i as u32, self.any_hit))
    }

    /// The ray tracer's own answers about some of several rays, from origins in permuted axes, and one triangle.
    #[inline(always)]
    pub fn blocked<L: Lanes>(
        &self,
        lanes: L,
        view: &View,
        triangle: u32,
        exact: &Exact,
        origin: [L::F; 3],
        mask: u32,
    ) -> u32 {
        let met = exact.meet(lanes, view, origin, mask);
        if A::IS_OPAQUE || met.mask == 0 || self.casters.triangles[triangle as usize].is_opaque() {
            return met.mask;
        }
        let (mut u, mut v) = ([0.0; 16], [0.0; 16]);
        lanes.store(met.u, &mut u);
        lanes.store(met.v, &mut v);
        let (mut rest, mut blocked) = (met.mask, 0);
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize & 15;
            rest &= rest - 1;
            blocked |= u32::from(self.any_hit.accepts(triangle, u[lane], v[lane])) << lane;
        }
        blocked
    }

    /// The test of one ray, to be made once and only if it is needed.
    #[inline(always)]
    pub fn test(&self, origin: Vec3) -> Option<RayTest> {
        RayTest::new(&Ray::to_light(origin, self.light), self.casters.root)
    }
}
