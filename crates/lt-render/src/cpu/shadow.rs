//! The passes over pixels, block by block: estimate, correct and resolve one block while its samples are in the cache.
//!
//! No pass reads what an earlier one wrote of another pixel (the mask reads the *last* frame's neighbours), so that the
//! order of blocks is free, and a block may run through all passes before the next begins. A pass's time is then its share
//! of the threads' time, times the time that all took.

use std::time::Instant;

use lt_bvh::{AnyHit, Opaque, Ray, RayOrder, Simd, Tracer};
use lt_irregular::{Casters, LightBvh, Scratch, Workspace};
use lt_math::glam::Vec3;
use lt_shaders::abi::{LightParams, Material};
use lt_shaders::resolve::shadow_ray;
use rayon::prelude::*;

use super::bits::places;
use super::estimator::{Estimator, LightMaps};
use super::history::Memory;
use super::marks::{Stained, Stains};
use super::mask_batch::{BlockPixels, Frames, mask_block};
use super::samples::{Pieces, Points};
use super::tiles::{BLOCK, PIECE, PIECES};
use super::{CpuBackend, milliseconds, tracer};
use crate::light_space::{casters, occluded};
use crate::{FrameJob, PackedScene, PassKind, Resolve};

/// Times of the passes over pixels.
#[derive(Clone, Copy, Debug, Default)]
pub struct PixelMs {
    evaluate: f64,
    mask: f64,
    resolve: f64,
}

impl PixelMs {
    /// The time of one of them.
    pub fn of(&self, kind: PassKind) -> Option<f64> {
        match kind {
            PassKind::Evaluate => Some(self.evaluate),
            PassKind::Mask => Some(self.mask),
            PassKind::Resolve => Some(self.resolve),
            _ => None,
        }
    }
}

impl CpuBackend {
    /// Runs the frame's passes over pixels.
    pub(super) fn shadow(&mut self, job: &FrameJob) {
        let start = Instant::now();
        let slot = &mut self.slots[self.slot];
        let levels = job.searched_levels();
        let (levels, depths, vectors) = (levels.as_deref(), &slot.depths[..], &slot.vectors[..]);
        let has_marks = job.plan.has_marks();
        let maps = LightMaps { p: &job.shadow, levels, depths, vectors, has_marks };
        let estimator = job.plan.map.map(|(test, source)| maps.estimator(test, source, job.plan.doubt_list));
        let open = match (&job.mask, job.plan.mask) {
            (Some(params), Some(effects)) => Some(slot.history.open(self.tiles, params, effects)),
            _ => None,
        };
        let (frames, memories) = match open {
            Some(open) => (Some(open.frames), open.blocks),
            None => (None, Vec::new()),
        };
        let listen_ms = milliseconds(start);
        let light = job.shadow.light;
        let moving = job.map.as_ref().map_or(&[][..], |map| &map.moving);
        let stains = has_marks.then_some(Stains { maps, moving });
        let resolver = match (job.plan.resolve, self.light_trees.of(&light)) {
            (Resolve::DivideAndConquer | Resolve::AliasFree, _) => Resolver::Later,
            (Resolve::Light, Some(tree)) => Resolver::Tree { tree, casters: casters(&self.scene) },
            _ => Resolver::Rays(tracer(&self.scene)),
        };
        let passes = Passes {
            resolver,
            light,
            estimator,
            frames,
            stains,
            traces_all: job.plan.trace_all,
            traces_doubted: job.plan.doubt_list,
        };
        let mut memories: Vec<Option<Memory<'_>>> = memories.into_iter().map(Some).collect();
        memories.resize_with(self.tiles.len() / BLOCK, || None);
        let seen = &self.seen[self.layer];
        let previous: &[Points] = if job.plan.object_motion { &seen.previous } else { &[] };
        let groups = memories
            .par_chunks_mut(GROUP)
            .zip(self.visibility.par_chunks_mut(GROUP * BLOCK))
            .zip(self.doubted.par_chunks_mut(GROUP * PIECES))
            .enumerate();
        let pieces = seen.rows.pieces();
        let groups = groups.map(|(index, ((memories, visibility), doubted))| Group {
            first: index * GROUP,
            pieces: pieces.range(index * GROUP * PIECES..index * GROUP * PIECES + memories.len() * PIECES),
            previous: previous.get(index * GROUP * PIECES..).unwrap_or(&[]),
            visibility,
            doubted,
            memories,
        });
        let start = Instant::now();
        let totals = match job.plan.alpha_test {
            true => passes.run(groups, self.scene.coverage(Material::CASTS)),
            false => passes.run(groups, Opaque),
        };
        let (wall, all) = (milliseconds(start), totals.seconds.iter().sum::<f64>());
        let [evaluate, mask, resolve] = totals.seconds.map(|s| if all > 0.0 { wall * s / all } else { 0.0 });
        let start = Instant::now();
        let is_later = matches!(passes.resolver, Resolver::Later);
        let mut stained = totals.stained;
        self.rays = totals.rays;
        if is_later {
            let later = Later { scene: &self.scene, job, pieces, stains };
            let workspace = &mut self.workspace;
            (self.rays, stained) =
                later.resolve(&mut self.visibility, &self.doubted, &mut memories, workspace);
        }
        drop(passes);
        slot.mark(&stained, job.shadow.map_size);
        let later_ms = milliseconds(start);
        self.pixel_ms = Some(PixelMs { evaluate, mask: mask + listen_ms, resolve: resolve + later_ms });
    }
}

/// The resolve pass of resolvers that want all of a frame's rays at once.
struct Later<'a> {
    scene: &'a PackedScene,
    job: &'a FrameJob,
    pieces: Pieces<'a>,
    stains: Option<Stains<'a>>,
}

impl Later<'_> {
    /// Answers the doubted pixels, and lets memories learn of it; how many they are, and what is to be marked.
    fn resolve(
        &self,
        visibility: &mut [f32],
        doubted: &[u64],
        memories: &mut [Option<Memory<'_>>],
        workspace: &mut Workspace,
    ) -> (u64, Vec<Stained>) {
        let light = &self.job.shadow.light;
        let sample = |i: usize| self.pieces.sample(i);
        let of_piece = |(piece, &bits): (usize, &u64)| places(bits).map(move |i| piece * PIECE + i);
        let pixels: Vec<usize> = doubted.par_iter().enumerate().flat_map_iter(of_piece).collect();
        let origins: Vec<Vec3> = pixels.par_iter().map(|&i| shadow_ray(&sample(i), light).origin).collect();
        let mut is_blocked = vec![false; origins.len()];
        let (resolve, to) = (self.job.plan.resolve, (&mut is_blocked[..], workspace));
        match self.job.plan.alpha_test {
            true => {
                let any_hit = self.scene.coverage(Material::CASTS);
                occluded(self.scene, resolve, light.place, &origins, any_hit, to);
            }
            false => occluded(self.scene, resolve, light.place, &origins, Opaque, to),
        }
        for (&pixel, &is_blocked) in pixels.iter().zip(&is_blocked) {
            visibility[pixel] = if is_blocked { 0.0 } else { 1.0 };
        }
        let blocks = visibility.par_chunks(BLOCK).zip(memories).enumerate();
        let stained = blocks.flat_map_iter(|(block, (visibility, memory))| {
            let mut stained = Vec::new();
            if let Some(memory) = memory {
                let pieces = self.pieces.range(block * PIECES..(block + 1) * PIECES);
                learn(memory, pieces, visibility, self.stains, &mut stained);
            }
            stained
        });
        let stained = stained.collect();
        (pixels.len() as u64, stained)
    }
}

/// Lets a block's memory learn of its rays, and finds what they tell to mark.
fn learn(
    memory: &mut Memory<'_>,
    pieces: Pieces<'_>,
    visibility: &[f32],
    stains: Option<Stains<'_>>,
    stained: &mut Vec<Stained>,
) {
    memory.learn(visibility);
    if let Some(stains) = stains {
        stains.of_block(pieces, memory, stained);
    }
}

/// What answers a block's rays.
enum Resolver<'a> {
    /// The ray tracer.
    Rays(Simd<'a>),
    /// A tree in the light's own space.
    Tree { tree: &'a LightBvh, casters: Casters<'a> },
    /// Something that answers all blocks at once, after them.
    Later,
}

/// Blocks of a group, whose rays are traced together. Measured on the street at 1920×1080, two threads: from 1 block to 8 the resolve pass
/// goes from 8.4 to 5.7 ms (`ltt-evsm`) and from 10.5 to 8.2 (`lt-evsm`).
const GROUP: usize = 8;

/// Most groups that a thread takes at once. On two threads rayon's own shares are quarters of the picture, and a thread that is done early waits for
/// the other's last one: a frame took up to a fifth longer.
const SHARE: usize = 4;

/// Some blocks, one after the other.
struct Group<'a, 'm> {
    /// The first block.
    first: usize,
    pieces: Pieces<'a>,
    previous: &'a [Points],
    visibility: &'a mut [f32],
    doubted: &'a mut [u64],
    memories: &'a mut [Option<Memory<'m>>],
}

impl Group<'_, '_> {
    fn block(&mut self, number: usize) -> Block<'_> {
        let range = number * BLOCK..(number + 1) * BLOCK;
        let pieces = number * PIECES..(number + 1) * PIECES;
        Block {
            index: self.first + number,
            pieces: self.pieces.range(pieces.clone()),
            previous: self.previous.get(pieces.clone()).unwrap_or(&[]),
            visibility: &mut self.visibility[range],
            doubted: &mut self.doubted[pieces],
            memory: self.memories[number].as_mut().map(Memory::reborrow),
        }
    }
}

/// A block's pixels on their way through the passes.
struct Block<'a> {
    index: usize,
    pieces: Pieces<'a>,
    previous: &'a [Points],
    visibility: &'a mut [f32],
    doubted: &'a mut [u64],
    memory: Option<Memory<'a>>,
}

/// What a thread's blocks took.
#[derive(Default)]
struct Totals {
    /// Evaluate, mask, resolve.
    seconds: [f64; 3],
    rays: u64,
    stained: Vec<Stained>,
}

impl Totals {
    fn plus(mut self, other: Self) -> Self {
        self.seconds.iter_mut().zip(other.seconds).for_each(|(a, b)| *a += b);
        self.stained.extend(other.stained);
        Self { rays: self.rays + other.rays, ..self }
    }
}

/// The passes of a frame, for any block.
struct Passes<'a> {
    resolver: Resolver<'a>,
    light: LightParams,
    estimator: Option<Estimator<'a>>,
    frames: Option<Frames<'a>>,
    stains: Option<Stains<'a>>,
    traces_all: bool,
    traces_doubted: bool,
}

impl Passes<'_> {
    fn run<'b, 'm: 'b, A: AnyHit + Sync>(
        &self,
        groups: impl IndexedParallelIterator<Item = Group<'b, 'm>>,
        any_hit: A,
    ) -> Totals {
        groups
            .with_max_len(SHARE)
            .map_init(Rays::default, |rays, group| self.run_group(group, any_hit, rays))
            .reduce(Totals::default, Totals::plus)
    }

    fn run_group<A: AnyHit>(&self, mut group: Group<'_, '_>, any_hit: A, rays: &mut Rays) -> Totals {
        rays.clear();
        let (mut seconds, mut stained) = ([0.0; 3], Vec::new());
        for number in 0..group.memories.len() {
            let block = self.run_block(group.block(number), rays.of_block(number));
            seconds.iter_mut().zip(block).for_each(|(sum, s)| *sum += s);
        }
        let start = Instant::now();
        if rays.resolve(&self.resolver, !self.traces_all, any_hit, group.visibility) {
            let blocks = group.visibility.chunks(BLOCK).zip(&mut *group.memories).enumerate();
            blocks.for_each(|(block, (visibility, memory))| {
                if let Some(memory) = memory {
                    let pieces = group.pieces.range(block * PIECES..(block + 1) * PIECES);
                    learn(memory, pieces, visibility, self.stains, &mut stained);
                }
            });
        }
        seconds[2] += start.elapsed().as_secs_f64();
        Totals { seconds, rays: rays.rays.len() as u64, stained }
    }

    /// Estimates, doubts and corrects, and collects the rays that are left to trace.
    fn run_block(&self, block: Block<'_>, mut rays: RaysOfBlock<'_>) -> [f64; 3] {
        let Block { index, pieces, previous, visibility, doubted, mut memory } = block;
        let start = Instant::now();
        match &self.estimator {
            Some(estimate) => estimate(pieces, visibility, doubted),
            None => doubted.fill(0),
        }
        let estimated = Instant::now();
        if let (Some(frames), Some(Memory { bits, depths, trusted })) = (self.frames, &mut memory) {
            mask_block(
                frames,
                index,
                BlockPixels { pieces, previous, visibility, doubted, bits, depths, trusted },
            );
        }
        let corrected = Instant::now();
        if self.traces_all {
            let all = pieces.iter().zip(visibility.as_chunks_mut::<PIECE>().0).zip(&mut *doubted);
            for ((samples, visibility), doubted) in all {
                let facing = samples.facing(&self.light);
                *doubted = facing.open;
                for (i, visibility) in visibility.iter_mut().enumerate() {
                    *visibility = if facing.lit >> i & 1 != 0 { 1.0 } else { 0.0 };
                }
            }
        }
        if self.traces_all || self.traces_doubted {
            let asking = || pieces.iter().zip(&*doubted).enumerate().filter(|(_, (_, bits))| **bits != 0);
            // What nobody has read before: all of it is on its way when the first is needed.
            asking().for_each(|(_, (samples, _))| samples.prefetch());
            for (piece, (samples, &bits)) in asking() {
                for i in places(bits) {
                    rays.push(piece * PIECE + i, shadow_ray(&samples.sample(i), &self.light));
                }
            }
        }
        let collected = Instant::now();
        [estimated - start, corrected - estimated, collected - corrected].map(|d| d.as_secs_f64())
    }
}

/// The rays of a group, as one of its blocks adds to them.
struct RaysOfBlock<'a> {
    rays: &'a mut Rays,
    first_pixel: usize,
}

impl RaysOfBlock<'_> {
    fn push(&mut self, pixel: usize, ray: Ray) {
        self.rays.pixels.push(self.first_pixel + pixel);
        self.rays.rays.push(ray);
    }
}

/// The rays of a group of blocks and the pixels they belong to.
#[derive(Default)]
struct Rays {
    pixels: Vec<usize>,
    rays: Vec<Ray>,
    is_blocked: Vec<bool>,
    order: RayOrder,
    /// For a tree in light space.
    origins: Vec<Vec3>,
    scratch: Scratch,
}

impl Rays {
    fn clear(&mut self) {
        self.pixels.clear();
        self.rays.clear();
    }

    /// For a group's block to add its own.
    fn of_block(&mut self, number: usize) -> RaysOfBlock<'_> {
        RaysOfBlock { rays: self, first_pixel: number * BLOCK }
    }

    /// Answers them, unless that is for later; whether it did.
    fn resolve<A: AnyHit>(
        &mut self,
        resolver: &Resolver<'_>,
        is_scattered: bool,
        any_hit: A,
        visibility: &mut [f32],
    ) -> bool {
        self.is_blocked.clear();
        self.is_blocked.resize(self.rays.len(), false);
        match resolver {
            Resolver::Later => return false,
            Resolver::Rays(tracer) if is_scattered => {
                tracer.occluded_scattered(&self.rays, any_hit, &mut self.is_blocked, &mut self.order);
            }
            Resolver::Rays(tracer) => tracer.occluded_batch(&self.rays, any_hit, &mut self.is_blocked),
            Resolver::Tree { tree, casters } => {
                self.origins.clear();
                self.origins.extend(self.rays.iter().map(|r| r.origin));
                tree.occluded(*casters, &self.origins, any_hit, &mut self.is_blocked, &mut self.scratch);
            }
        }
        for (&pixel, &is_blocked) in self.pixels.iter().zip(&self.is_blocked) {
            visibility[pixel] = if is_blocked { 0.0 } else { 1.0 };
        }
        true
    }
}
