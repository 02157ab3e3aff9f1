//! The SIMD tracer: the widest instructions the processor has, chosen at run time.

mod lanes;
mod layout;
pub mod memory;
mod packet;
mod packet_walk;
mod prepared;
mod refit;
mod traverse;
mod tree;
mod visits;

use crate::any_hit::AnyHit;
use crate::build::{Bvh, InstancedBvh, instance_bounds};
use crate::ray::{Hit, Ray};
use crate::tracer::Tracer;
use lanes::{NodeLanes, Portable};
use std::vec::Vec;
use traverse::{Instanced, Scratch};
pub(crate) use tree::{MOST_TRIANGLES, Part, SimdTree};

/// Instruction sets that the SIMD tracer knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SimdLevel {
    /// What every processor of the target has.
    Portable,
    /// AVX2 and FMA, BMI1, BMI2, LZCNT and POPCNT.
    Avx2,
    /// AVX-512F and AVX-512VL besides.
    Avx512,
}

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

#[derive(Clone, Copy)]
enum Chosen {
    Portable(Portable),
    #[cfg(target_arch = "x86_64")]
    Avx2(lanes::x86::Avx2),
    #[cfg(target_arch = "x86_64")]
    Avx512(lanes::x86::Avx512),
}

impl SimdLevel {
    /// Every level that this processor runs, the slowest first; never empty.
    pub fn available() -> Vec<SimdLevel> {
        let all = [SimdLevel::Portable, SimdLevel::Avx2, SimdLevel::Avx512];
        all.into_iter().filter(|level| level.choose().is_some()).collect()
    }

    fn choose(self) -> Option<Chosen> {
        match self {
            SimdLevel::Portable => Some(Chosen::Portable(Portable)),
            #[cfg(target_arch = "x86_64")]
            SimdLevel::Avx2 => lanes::x86::Avx2::detect().map(Chosen::Avx2),
            #[cfg(target_arch = "x86_64")]
            SimdLevel::Avx512 => lanes::x86::Avx512::detect().map(Chosen::Avx512),
            #[cfg(not(target_arch = "x86_64"))]
            SimdLevel::Avx2 | SimdLevel::Avx512 => None,
        }
    }
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
        let mut simd = Simd {
            scene,
            chosen: Chosen::Portable(Portable),
            level: SimdLevel::Portable,
            grouping: Grouping::Packets,
        };
        for level in SimdLevel::available() {
            if let Some(chosen) = level.choose() {
                (simd.chosen, simd.level) = (chosen, level);
            }
        }
        simd
    }

    /// The same tracer on other instructions, to compare or to test; `None` where the processor lacks them.
    pub fn with_level(self, level: SimdLevel) -> Option<Self> {
        let chosen = level.choose()?;
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

/// A batch of rays, what is traced and what is asked. Each kind is compiled by itself: in one function for all of them, inner loops
/// would keep in memory what fits into registers.
trait Batch {
    fn run<L: NodeLanes>(self, lanes: L);
}

/// What is traced, as batches take it.
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

impl<A: AnyHit> Batch for OccludedSingly<'_, Part<'_>, A> {
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::occluded(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

impl<A: AnyHit> Batch for OccludedSingly<'_, Instanced<'_>, A> {
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

impl<A: AnyHit> Batch for OccludedInPackets<'_, Part<'_>, A> {
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        packet_walk::occluded(lanes, self.scene, self.rays, self.any_hit, self.out);
    }
}

impl<A: AnyHit> Batch for OccludedInPackets<'_, Instanced<'_>, A> {
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

impl<A: AnyHit> Batch for Closest<'_, Part<'_>, A> {
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::closest(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

impl<A: AnyHit> Batch for Closest<'_, Instanced<'_>, A> {
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut scratch = Scratch::new();
        for (ray, out) in self.rays.iter().zip(self.out) {
            *out = traverse::closest_instanced(lanes, self.scene, *ray, self.any_hit, &mut scratch);
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx2<B: Batch>(lanes: lanes::x86::Avx2, batch: B) {
    batch.run(lanes);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx512<B: Batch>(lanes: lanes::x86::Avx512, batch: B) {
    batch.run(lanes);
}

impl Simd<'_> {
    fn view(&self) -> View<'_> {
        match &self.scene {
            Scene::World(part) => View::World(*part),
            Scene::Instanced { scene, tlas, parts } => {
                View::Instanced(Instanced { tlas, instances: scene.instances(), parts })
            }
        }
    }

    fn run<B: Batch>(&self, batch: B) {
        match self.chosen {
            Chosen::Portable(lanes) => batch.run(lanes),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx2(lanes) => unsafe { run_avx2(lanes, batch) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx512(lanes) => unsafe { run_avx512(lanes, batch) },
        }
    }
}

impl Tracer for Simd<'_> {
    fn occluded_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [bool]) {
        let len = rays.len().min(out.len());
        let (rays, out) = (&rays[..len], &mut out[..len]);
        match (self.view(), self.grouping) {
            (View::World(scene), Grouping::Single) => self.run(OccludedSingly { scene, rays, any_hit, out }),
            (View::World(scene), Grouping::Packets) => {
                self.run(OccludedInPackets { scene, rays, any_hit, out })
            }
            (View::Instanced(scene), Grouping::Single) => {
                self.run(OccludedSingly { scene, rays, any_hit, out })
            }
            (View::Instanced(scene), Grouping::Packets) => {
                self.run(OccludedInPackets { scene, rays, any_hit, out });
            }
        }
    }

    fn closest_batch<A: AnyHit>(&self, rays: &[Ray], any_hit: A, out: &mut [Hit]) {
        match self.view() {
            View::World(scene) => self.run(Closest { scene, rays, any_hit, out }),
            View::Instanced(scene) => self.run(Closest { scene, rays, any_hit, out }),
        }
    }
}
