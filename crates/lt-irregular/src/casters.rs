//! The triangles that block, as the ray tracer knows them, and its own test as the last instance.

use crate::block::ASKS;
use crate::exact::Exact;
use crate::view::{Bounds, View};
use alloc::vec::Vec;
use lt_bvh::lanes::{Lanes, prefetch};
use lt_bvh::{AnyHit, Grid, Node, Ray, RayTest, Triangle};
use lt_math::glam::{Vec3, Vec4};
#[cfg(feature = "std")]
use rayon::prelude::*;

/// Triangles of a task that looks at all of them.
const TASK: usize = 1 << 14;

/// Triangles in any order, and the box of the root of a tree over them, which the ray tracer's margins depend on.
#[derive(Clone, Copy)]
pub struct Casters<'a> {
    /// Box of the root of the ray tracer's tree over `triangles`, whether there is one or not.
    pub root: Bounds,
    /// The triangles, made as the ray tracer's are (`lt_bvh::triangles_of`).
    pub triangles: &'a [Triangle],
}

impl<'a> Casters<'a> {
    /// Of triangles without a tree: looks at all of them for the box that the root of one would have.
    pub fn of(triangles: &'a [Triangle]) -> Self {
        let tasks: Vec<&[Triangle]> = triangles.chunks(TASK).collect();
        let boxes =
            each(&tasks, |task| task.iter().fold(Bounds::EMPTY, |all, t| all.with(t.low()).with(t.high())));
        let all = boxes.into_iter().reduce(|a, b| Bounds { low: a.low.min(b.low), high: a.high.max(b.high) });
        let root = match all {
            Some(Bounds { low, high }) => {
                let step = |axis: usize| Grid::over(low[axis], high[axis]).step() as f32;
                Bounds { low, high: low + Vec3::new(step(0), step(1), step(2)) * 255.0 }
            }
            None => Bounds { low: Vec3::ZERO, high: Vec3::ZERO },
        };
        Casters { root, triangles }
    }

    /// Of the ray tracer's own tree: its root and triangles.
    pub fn of_tree(root: &Node, triangles: &'a [Triangle]) -> Self {
        Casters { root: Bounds { low: root.low(), high: root.high() }, triangles }
    }

    /// Asks for a triangle by its id in a block, that it may have come by the time it is needed.
    #[inline(always)]
    pub(crate) fn prefetch(&self, id: u32) {
        if let Some(triangle) = self.triangles.get((id & !ASKS) as usize) {
            prefetch(triangle);
        }
    }

    /// The ray tracer's test of one ray; none for what is no ray.
    #[inline(always)]
    pub(crate) fn test(&self, ray: &Ray) -> Option<RayTest> {
        RayTest::new(ray, self.root.low, self.root.high)
    }

    /// Where the ray meets the triangle by the ray tracer's own test, whatever that is made of: weights of the second and third vertex.
    #[inline(always)]
    pub(crate) fn meet(&self, ray: &Ray, triangle: u32) -> Option<(f32, f32)> {
        self.test(ray)?.meet(&self.triangles[triangle as usize])
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
        self.casters.test(&Ray::to_light(origin, self.light))
    }
}
