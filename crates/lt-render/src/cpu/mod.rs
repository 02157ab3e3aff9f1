//! The CPU backend: the kernels of `lt-shaders` called from rayon over tiles, rays in SIMD below lt-bvh's seam.
//!
//! The same input gives the same bits for any number of threads: every pixel is computed alone, and the only order
//! that matters (the depth test's) is a minimum.

mod answers;
mod asks;
mod batch;
mod bits;
mod estimator;
mod fill;
mod footprints;
mod heads;
mod history;
mod kept_map;
mod layers;
mod light_trees;
mod map_tiles;
mod marks;
mod mask_batch;
mod perspective;
mod places;
mod planes;
mod raster;
mod samples;
mod shadow;
mod shortcut;
mod surface;
mod tiles;
mod tint;

use std::time::Instant;

use bytemuck::Zeroable;
use heads::Head;
use history::History;
use kept_map::{Draw, StillMap};
use layers::{LitTiles, Seen};
use light_trees::LightTrees;
use lt_bvh::{AnyHit, Hit, Opaque, Ray, Simd, Tracer, memory};
use lt_irregular::Workspace;
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Vsm};
use lt_shaders::abi::{CameraParams, FilterParams, Sample};
use lt_shaders::camera::{
    ColorSource, ColorTextures, NoColorTextures, previous_position, primary_ray, sample_at_hit,
};
use lt_shaders::filter::{filter_x, filter_y};
use lt_shaders::geometry::{FlatGeometry, Geometry, InstancedGeometry};
use lt_shaders::shade::shade_mean;
use marks::Stained;
use rayon::prelude::*;
use samples::{Kept, Look, Parts, Points, keep, points};
use shadow::PixelMs;
use tiles::{BLOCK, PIECE, PIECES, Tiles};

use crate::light_space;
use crate::packed::Trees;
use crate::{
    Backend, EffectPlan, Frame, FrameJob, MapTest, PackedScene, Pass, PassKind, RenderError, ShadedLight,
    Upkeep,
};

pub use answers::BatchTest;
pub use batch::{evaluate_batch, evaluate_batch_levels};
pub use map_tiles::{maps_to_rows, maps_to_tiles};
pub use samples::{Pieces, SampleRows};

/// See the [module](self).
pub struct CpuBackend {
    scene: PackedScene,
    tiles: Tiles,
    /// Layers, front to back, in tile order like the other buffers of samples.
    seen: Vec<Seen>,
    /// The running frame's layer.
    layer: usize,
    visibility: Vec<f32>,
    /// Empty while nothing tints light.
    tint: Vec<Vec3>,
    /// Who is doubted, or traced where all are: a bit each, by pieces.
    doubted: Vec<u64>,
    /// What techniques keep between frames, by the job's slot.
    slots: Vec<Slot>,
    /// The running frame's slot.
    slot: usize,
    /// Blurred rows between the passes of a pre-filter, which no slot keeps; as many as the largest map of all slots.
    rows: Vec<Vec4>,
    rays: u64,
    passes: Vec<Pass>,
    /// Times of the running frame's passes over pixels, once they have run.
    pixel_ms: Option<PixelMs>,
    /// None after the scene has changed.
    light_trees: LightTrees,
    /// For divide and conquer, which keeps nothing else.
    workspace: Workspace,
}

/// One technique's map and history.
#[derive(Default)]
struct Slot {
    depths: Vec<f32>,
    /// Of every level, what stands still.
    still: Vec<StillMap>,
    vectors: Vec<Vec4>,
    history: History,
}

impl Slot {
    /// Marks texels of maps of `map_size`² texels, and of what stands still in them.
    fn mark(&mut self, stained: &[Stained], map_size: u32) {
        let texels = (map_size as usize).pow(2);
        for stained in stained {
            stained.mark(&mut self.depths[stained.texel]);
            if let Some(still) = self.still.get_mut(stained.texel / texels) {
                still.mark(stained.texel % texels, *stained);
            }
        }
    }
}

impl CpuBackend {
    /// The depth maps of the last frame, level after level, each in the order of [`maps_to_tiles`]; empty before the first.
    pub fn depth_maps(&self) -> Vec<f32> {
        self.slots[self.slot].depths.iter().map(|texel| marks::depth(*texel)).collect()
    }

    /// Takes the scene and prepares its tracer.
    pub fn new(scene: PackedScene) -> Self {
        prepare(&scene);
        Self {
            scene,
            tiles: Tiles::new(UVec2::ZERO),
            seen: Vec::new(),
            layer: 0,
            visibility: Vec::new(),
            tint: Vec::new(),
            doubted: Vec::new(),
            slots: Vec::new(),
            slot: 0,
            rows: Vec::new(),
            rays: 0,
            passes: Vec::new(),
            pixel_ms: None,
            light_trees: LightTrees::default(),
            workspace: Workspace::default(),
        }
    }
}

/// Makes what tracing needs and would else be made in the first frame: the tracer's tree and the opacity maps.
fn prepare(scene: &PackedScene) {
    tracer(scene).occluded_batch(&[Ray::default()], Opaque, &mut [false]);
    if scene.stats().masked_triangles > 0 {
        scene.coverage(0);
    }
}

/// Makes a buffer one of zeros where it has another length: what a picture or a map holds is not another's.
fn resize<T: Zeroable + Send>(buffer: &mut Vec<T>, len: usize) {
    if buffer.len() != len {
        *buffer = memory::zeroed(len);
    }
}

fn tracer(scene: &PackedScene) -> Simd<'_> {
    match scene.trees() {
        Trees::Flat(bvh) => Simd::new(bvh),
        Trees::Instanced(bvh) => Simd::instanced(bvh),
    }
}

impl Backend for CpuBackend {
    fn name(&self) -> &'static str {
        "cpu"
    }

    fn has_all_resolvers(&self) -> bool {
        true
    }

    fn device(&self) -> String {
        format!("{} ({:?})", cpu_model(), tracer(&self.scene).level())
    }

    fn replace_scene(&mut self, scene: PackedScene) -> Result<(), RenderError> {
        prepare(&scene);
        self.scene = scene;
        self.light_trees = LightTrees::default();
        Ok(())
    }

    fn camera(&mut self, params: &CameraParams, plan: &EffectPlan) -> Result<Option<f64>, RenderError> {
        self.tiles = Tiles::new(params.size);
        let len = self.tiles.len();
        let layers = plan.layers as usize;
        self.seen.resize_with(layers, Seen::default);
        self.seen.iter_mut().for_each(|seen| seen.resize(len, plan.object_motion, layers > 1));
        resize(&mut self.visibility, len);
        self.doubted.resize(len / PIECE, 0);
        let start = Instant::now();
        let covers = self.scene.coverage(0);
        let view = View { scene: &self.scene, tiles: self.tiles, params };
        match (&mut self.seen[..], plan.alpha_test, plan.color_textures) {
            ([one], false, false) => see(view, Opaque, NoColorTextures, one),
            ([one], true, false) => see(view, covers, NoColorTextures, one),
            ([one], false, true) => see(view, Opaque, colors(&self.scene), one),
            ([one], true, true) => see(view, covers, colors(&self.scene), one),
            (all, ..) => layers::see(view, all),
        }
        Ok(Some(milliseconds(start)))
    }

    fn samples(&mut self) -> Result<Vec<Vec<Sample>>, RenderError> {
        let whole = |seen: &Seen| -> Vec<Sample> { (0..self.tiles.len()).map(|i| seen.sample(i)).collect() };
        Ok(self.seen.iter().map(|seen| self.tiles.to_rows(&whole(seen))).collect())
    }

    fn begin(&mut self, job: &FrameJob) -> Result<(), RenderError> {
        light_space::check(&self.scene, job)?;
        let map_texels = job.map.as_ref().map_or(0, |m| (m.map_size() as usize).pow(2) * m.levels.len());
        let vector_texels = if job.plan.is_prefiltered() { map_texels } else { 0 };
        (self.slot, self.layer) = (job.slot, job.layer as usize);
        if self.slots.len() <= job.slot {
            self.slots.resize_with(job.slot + 1, Slot::default);
        }
        let slot = &mut self.slots[job.slot];
        resize(&mut slot.depths, map_texels);
        resize(&mut slot.vectors, vector_texels);
        if self.rows.len() < vector_texels {
            self.rows = memory::zeroed(vector_texels);
        }
        slot.history.begin(self.tiles, job.plan.mask);
        if job.clears_history() {
            slot.history.clear();
        }
        self.tint.resize(if job.plan.tint { self.tiles.len() } else { 0 }, Vec3::ONE);
        self.rays = 0;
        self.passes.clear();
        self.pixel_ms = None;
        // Waking threads that had nothing to do between frames takes milliseconds on a virtual machine, and is no part of a pass. That of threads
        // which a pass lets sleep is the next one's, or a frame of many passes would be spared what a frame of one is not.
        rayon::broadcast(|_| ());
        Ok(())
    }

    fn pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError> {
        let start = Instant::now();
        let slot = &mut self.slots[self.slot];
        match (kind, &job.map, job.plan.map) {
            (PassKind::Build, ..) => {
                // Timed inside: what it is built from is prepared first.
                let ms = Some(self.scene.keep_up(job.plan.upkeep, job.plan.resolve)?);
                self.passes.push(Pass { kind, ms });
                return Ok(());
            }
            (PassKind::DepthMap, Some(map), _) => {
                slot.still.resize_with(map.levels.len(), StillMap::default);
                let whole = if map.keeps_still { Draw::Whole } else { Draw::Once };
                let draws = map.draws.iter().map(|level| (level, whole));
                for (&level, draw) in draws.chain(map.refreshes.iter().map(|level| (level, Draw::Moving))) {
                    let (params, depths) = (&map.levels[level as usize], &mut slot.depths[map.texels(level)]);
                    slot.still[level as usize].draw(draw, &self.scene, params, depths);
                }
            }
            (PassKind::FilterX, Some(map), Some((test, _))) => map.drawn().for_each(|level| {
                let at = map.texels(level);
                blur_rows(test, &map.filter, &slot.depths[at.clone()], &mut self.rows[at]);
            }),
            (PassKind::FilterY, Some(map), _) => map.drawn().for_each(|level| {
                let at = map.texels(level);
                blur_columns(&map.filter, &self.rows[at.clone()], &mut slot.vectors[at]);
            }),
            (PassKind::LightTree, ..) => {
                let is_kept = job.plan.upkeep == Upkeep::Kept;
                let ms = self.light_trees.plant(&self.scene, &job.shadow.light, is_kept, job.slot);
                self.passes.push(Pass { kind, ms: Some(ms) });
                return Ok(());
            }
            (PassKind::Evaluate | PassKind::Mask | PassKind::Resolve, ..) => {
                // The first of these runs all of them.
                if self.pixel_ms.is_none() {
                    self.shadow(job);
                }
                let ms = self.pixel_ms.and_then(|ms| ms.of(kind));
                self.passes.push(Pass { kind, ms });
                return Ok(());
            }
            (PassKind::Tint, ..) => {
                self.rays += tint::trace(
                    &self.scene,
                    job,
                    self.seen[self.layer].rows.pieces(),
                    &self.visibility,
                    &mut self.tint,
                );
            }
            _ => {}
        }
        self.passes.push(Pass { kind, ms: Some(milliseconds(start)) });
        Ok(())
    }

    fn finish(&mut self, job: &FrameJob) -> Result<Frame, RenderError> {
        let slot = &self.slots[self.slot];
        let bytes = size_of_val(&slot.depths[..])
            + slot.still.iter().map(StillMap::bytes).sum::<usize>()
            // As many rows as vectors, lent to it.
            + 2 * size_of_val(&slot.vectors[..]);
        let doubt: Vec<bool> =
            self.doubted.iter().flat_map(|bits| (0..PIECE).map(move |i| bits >> i & 1 != 0)).collect();
        Ok(Frame {
            visibility: self.tiles.to_rows(&self.visibility),
            tint: if self.tint.is_empty() { Vec::new() } else { self.tiles.to_rows(&self.tint) },
            doubt: self.tiles.to_rows(&doubt),
            rays: self.rays,
            passes: std::mem::take(&mut self.passes),
            map_bytes: bytes as u64,
            mask: job.plan.mask.map_or(Vec::new(), |_| slot.history.rows(self.tiles)),
            map_draws: job.map_draws(),
            lights: Vec::new(),
            layers: Vec::new(),
        })
    }

    fn shade(&mut self, layers: &[Vec<ShadedLight<'_>>]) -> Result<Vec<[u8; 4]>, RenderError> {
        let Some(first) = layers.first().and_then(|lights| lights.first()) else { return Ok(Vec::new()) };
        let (lit, grid) =
            (LitTiles { tiles: self.tiles, seen: &self.seen, lights: layers }, first.params.camera.grid);
        let pixels = self.tiles.size() / grid;
        let row = |y| (0..pixels.x).map(move |x| shade_mean(UVec2::new(x, y), grid, lit).to_le_bytes());
        Ok((0..pixels.y).into_par_iter().flat_map_iter(row).collect())
    }
}

/// From [tiles](map_tiles) to rows, each of which the kernel sees as a map of its own.
fn blur_rows(test: MapTest, p: &FilterParams, depths: &[f32], rows: &mut [Vec4]) {
    let each = |kernel: fn(UVec2, &FilterParams, &[f32]) -> Vec4, rows: &mut [Vec4]| {
        let rows = rows.par_chunks_mut(p.map_size as usize).enumerate();
        rows.for_each_init(Vec::new, |row_depths, (y, row)| {
            row_depths.clear();
            row_depths.extend(map_tiles::row(depths, y as u32, p.map_size).map(marks::depth));
            for (x, vector) in row.iter_mut().enumerate() {
                *vector = kernel(UVec2::new(x as u32, 0), p, row_depths);
            }
        });
    };
    match test {
        MapTest::Vsm => each(filter_x::<Vsm>, rows),
        MapTest::Esm => each(filter_x::<Esm>, rows),
        MapTest::Evsm => each(filter_x::<Evsm>, rows),
        MapTest::Msm => each(filter_x::<MsmHamburger>, rows),
        MapTest::MsmHausdorff => each(filter_x::<MsmHausdorff>, rows),
        // The technique parser refuses these: a biased test has no vectors to filter.
        MapTest::Sm | MapTest::Pcf => {}
    }
}

/// From rows to [tiles](map_tiles).
fn blur_columns(p: &FilterParams, rows: &[Vec4], vectors: &mut [Vec4]) {
    let size = p.map_size as usize;
    vectors.par_chunks_mut(map_tiles::SIDE * size).enumerate().for_each(|(tile_row, tiles)| {
        for (tile, vectors) in tiles.as_chunks_mut::<{ map_tiles::TEXELS }>().0.iter_mut().enumerate() {
            for (i, vector) in vectors.iter_mut().enumerate() {
                let at = |tile: usize, i: usize| (tile * map_tiles::SIDE + i) as u32;
                let texel = UVec2::new(at(tile, i % map_tiles::SIDE), at(tile_row, i / map_tiles::SIDE));
                *vector = filter_y(texel, p, rows);
            }
        }
    });
}

fn colors(scene: &PackedScene) -> ColorTextures<'_> {
    ColorTextures { texels: scene.color_texels() }
}

/// What the camera pass looks at and from where.
#[derive(Clone, Copy)]
struct View<'a> {
    scene: &'a PackedScene,
    tiles: Tiles,
    params: &'a CameraParams,
}

/// The camera pass over all tiles; `seen.previous` is empty, or also gets where every sample was in the last frame.
fn see<A: AnyHit + Sync, C: ColorSource + Sync>(view: View<'_>, any_hit: A, colors: C, seen: &mut Seen) {
    let scene = view.scene;
    let (nodes, triangles) = (scene.nodes(), scene.triangles());
    match scene.trees() {
        Trees::Flat(_) => {
            see_geometry(view, FlatGeometry { nodes, triangles }, any_hit, colors, seen);
        }
        Trees::Instanced(_) => {
            let geometry =
                InstancedGeometry { nodes, triangles, instances: scene.instances(), root: scene.root() };
            see_geometry(view, geometry, any_hit, colors, seen);
        }
    }
}

fn see_geometry<G: Geometry + Sync, A: AnyHit + Sync, C: ColorSource + Sync>(
    view: View<'_>,
    geometry: G,
    any_hit: A,
    colors: C,
    seen: &mut Seen,
) {
    let View { scene, tiles, params: p } = view;
    let tracer = tracer(scene);
    let see_block = |block: usize, rows: Rows<'_>, looks: &mut [Look], previous: &mut [Points]| {
        let pixels: Vec<Option<UVec2>> = (0..BLOCK).map(|i| tiles.pixel(block, i)).collect();
        let rays: Vec<Ray> =
            pixels.iter().map(|px| px.map_or(Ray::default(), |px| primary_ray(px, p))).collect();
        let mut hits = vec![Hit::miss(0.0); BLOCK];
        tracer.closest_batch(&rays, any_hit, &mut hits);
        let rows = rows.0.iter_mut().zip(rows.1).zip(rows.2);
        let pieces = rows.zip(looks.chunks_exact_mut(PIECE)).zip(hits.as_chunks::<PIECE>().0);
        for ((((head, position), parts), looks), hits) in pieces {
            let samples =
                hits.map(|hit| sample_at_hit(&hit, p, geometry, scene.vertices(), scene.materials(), colors));
            Kept { head: *head, position: *position, parts: *parts } = keep(&samples, looks);
        }
        for (previous, hits) in previous.iter_mut().zip(hits.chunks_exact(PIECE)) {
            let before = |hit| previous_position(hit, geometry, scene.previous_positions());
            *previous = points(hits.iter().map(before));
        }
    };
    let Seen { rows, looks, previous, .. } = seen;
    let heads = rows.heads.par_chunks_mut(PIECES);
    let rows = heads.zip(rows.positions.par_chunks_mut(PIECES)).zip(rows.parts.par_chunks_mut(PIECES));
    let rows = rows.map(|((heads, positions), parts)| (heads, positions, parts));
    let blocks = rows.zip(looks.par_chunks_mut(BLOCK));
    if previous.is_empty() {
        blocks.enumerate().for_each(|(block, (rows, looks))| see_block(block, rows, looks, &mut []));
    } else {
        let all = blocks.zip(previous.par_chunks_mut(PIECES)).enumerate();
        all.for_each(|(block, ((rows, looks), previous))| see_block(block, rows, looks, previous));
    }
}

/// A block's heads, positions and parts.
type Rows<'a> = (&'a mut [Head], &'a mut [Points], &'a mut [Parts]);

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// The processor's own name where the system tells it.
fn cpu_model() -> String {
    let from_proc = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|l| l.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    from_proc.unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}
