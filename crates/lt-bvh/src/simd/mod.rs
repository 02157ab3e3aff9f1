//! The SIMD tracer: the widest instructions the processor has, chosen at run time.

mod layout;
pub mod memory;
mod order;
mod packet;
mod packet_walk;
mod prepared;
mod refit;
mod traverse;
mod tree;
mod visits;

use crate::any_hit::AnyHit;
use crate::build::{Bvh, InstancedBvh, instance_bounds};
use crate::lanes::{Chosen, NodeLanes, SimdLevel, Work};
use crate::ray::{Hit, Ray};
use crate::tracer::Tracer;
pub use order::RayOrder;
use order::{Arrange, MOST};
use std::vec::Vec;
use traverse::{Instanced, Scratch};
pub(crate) use tree::{MOST_TRIANGLES, Part, SimdTree};

/// How the SIMD tracer takes the occlusion rays of a batch; the answers are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Grouping {
    /// One by one, eight boxes or triangles at a time.
    Single,
    /// 64 at a time: eight or sixteen rays per box or triangle, or one by one where few rays meet the same boxes, so that
    /// big triangles and small ones, neighbours and scattered rays need no other choice.
    Packets,
}

impl Grouping {
    /// Every grouping.
    pub const ALL: [Grouping; 2] = [Grouping::Single, Grouping::Packets];
}

/// What is traced.
enum Scene<'a> {
    World(Part<'a>),
    Instanced { scene: &'a InstancedBvh, tlas: SimdTree, parts: Vec<Part<'a>> },
}

/// Traces batches on wide trees of its own, with the shared kernel's hits bit for bit.
///
/// The wide tree of a mesh is made when it is first asked for and kept with the mesh, so a tracer per frame
/// costs only the tree over its instances.
pub struct Simd<'a> {
    scene: Scene<'a>,
    chosen: Chosen,
    level: SimdLevel,
    grouping: Grouping,
}

impl<'a> Simd<'a> {
    /// For the triangles of one tree in world space.
    pub fn new(bvh: &'a Bvh) -> Self {
        Self::over(Scene::World(bvh.simd_part()))
    }

    /// For placed meshes.
    pub fn instanced(scene: &'a InstancedBvh) -> Self {
        let boxes: Vec<_> = scene.instances().iter().map(instance_bounds).collect();
        let root = &scene.nodes()[scene.tlas_root() as usize];
        let tlas = SimdTree::of_instances(scene.binary(), &boxes, root);
        Self::over(Scene::Instanced { scene, tlas, parts: scene.simd_parts() })
    }

    fn over(scene: Scene<'a>) -> Self {
        let level = SimdLevel::best();
        let chosen = Chosen::new(level).unwrap_or(Chosen::Portable);
        Simd { scene, chosen, level, grouping: Grouping::Packets }
    }

    /// The same tracer on other instructions, to compare or to test; `None` where the processor lacks them.
    pub fn with_level(self, level: SimdLevel) -> Option<Self> {
        let chosen = Chosen::new(level)?;
        Some(Simd { chosen, level, ..self })
    }

    /// The same tracer with another grouping of occlusion rays.
    pub fn with_grouping(self, grouping: Grouping) -> Self {
        Simd { grouping, ..self }
    }

    /// The instructions in use: the widest that the processor has, unless told otherwise.
    pub fn level(&self) -> SimdLevel {
        self.level
    }
}

/// What is traced, as batches take it. Each kind is work compiled by itself: in one function for all of them, inner loops would keep in
/// memory what fits into registers.
#[derive(Clone, Copy)]
enum View<'a> {
    World(Part<'a>),
    Instanced(Instanced<'a>),
}

/// Occlusion of rays one by one.
struct OccludedSingly<'b, S, A> {
    scene: S,
    rays: &'b [Ray],
    any_hit: A,
    out: &'b mut [bool],
}

impl<A: AnyHit> Work for OccludedSingly<'_, Part<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::occluded(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

impl<A: AnyHit> Work for OccludedSingly<'_, Instanced<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::occluded_instanced(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

/// Occlusion of rays in packets.
struct OccludedInPackets<'b, S, A> {
    scene: S,
    rays: &'b [Ray],
    any_hit: A,
    out: &'b mut [bool],
}

impl<A: AnyHit> Work for OccludedInPackets<'_, Part<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        packet_walk::occluded(lanes, self.scene, self.rays, self.any_hit, self.out);
    }
}

impl<A: AnyHit> Work for OccludedInPackets<'_, Instanced<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        packet_walk::occluded_instanced(lanes, self.scene, self.rays, self.any_hit, self.out);
    }
}

/// Nearest hits.
struct Closest<'b, S, A> {
    scene: S,
    rays: &'b [Ray],
    any_hit: A,
    out: &'b mut [Hit],
}

impl<A: AnyHit> Work for Closest<'_, Part<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::closest(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

impl<A: AnyHit> Work for Closest<'_, Instanced<'_>, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::closest_instanced(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

impl Simd<'_> {
    /// [`Tracer::occluded_batch`] of rays that come from here and there, such as those that a shadow map left open: where they are many and
    /// parallel, they are brought into `order` first.
    pub fn occluded_scattered<A: AnyHit>(
        &self,
        rays: &[Ray],
        any_hit: A,
        out: &mut [bool],
        order: &mut RayOrder,
    ) {
        for (rays, out) in rays.chunks(MOST).zip(out.chunks_mut(MOST)) {
            let len = rays.len().min(out.len());
            let (rays, out) = (&rays[..len], &mut out[..len]);
            if self.grouping == Grouping::Single || !order::serves(rays) {
                self.occluded_batch(rays, any_hit, out);
                continue;
            }
            self.chosen.run(Arrange { order, rays });
            let (sorted, is_blocked) = order.batch(len);
            self.occluded_batch(sorted, any_hit, is_blocked);
            order.deliver(out);
        }
    }

    fn view(&self) -> View<'_> {
        match &self.scene {
            Scene::World(part) => View::World(*part),
            Scene::Instanced { scene, tlas, parts } => {
                View::Instanced(Instanced { tlas, instances: scene.instances(), parts })
            }
        }
    }
}

impl Tracer for Simd<'_> {
    fn occluded_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [bool]) {
        let len = rays.len().min(out.len());
        let (rays, out) = (&rays[..len], &mut out[..len]);
        match (self.view(), self.grouping) {
            (View::World(scene), Grouping::Single) => {
                self.chosen.run(OccludedSingly { scene, rays, any_hit, out })
            }
            (View::World(scene), Grouping::Packets) => {
                self.chosen.run(OccludedInPackets { scene, rays, any_hit, out })
            }
            (View::Instanced(scene), Grouping::Single) => {
                self.chosen.run(OccludedSingly { scene, rays, any_hit, out })
            }
            (View::Instanced(scene), Grouping::Packets) => {
                self.chosen.run(OccludedInPackets { scene, rays, any_hit, out });
            }
        }
    }

    fn closest_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [Hit]) {
        match self.view() {
            View::World(scene) => self.chosen.run(Closest { scene, rays, any_hit, out }),
            View::Instanced(scene) => self.chosen.run(Closest { scene, rays, any_hit, out }),
        }
    }
}
