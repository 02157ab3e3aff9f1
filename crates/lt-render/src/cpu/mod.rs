//! The CPU backend: the kernels of `lt-shaders` called from rayon over tiles, rays in SIMD below lt-bvh's seam.
//!
//! The same input gives the same bits for any number of threads: every pixel is computed alone, and the only order
//! that matters (the depth test's) is a minimum.

mod batch;
mod history;
mod raster;
mod shortcut;
mod tiles;
mod tint;

use std::time::Instant;

use history::{History, Seen};
use lt_bvh::{AnyHit, Hit, Opaque, Ray, Simd, Tracer};
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, Sm, Vsm};
use lt_shaders::abi::{CameraParams, FilterParams, Material, Sample, ShadeParams, ShadowParams};
use lt_shaders::camera::{
    ColorSource, ColorTextures, NoColorTextures, previous_position, primary_ray, sample_at_hit,
};
use lt_shaders::evaluate::{
    FilteredVectors, GatheredDepths, MapSource as MapView, TestFromParams, evaluate, settle,
};
use lt_shaders::filter::{filter_x, filter_y};
use lt_shaders::geometry::{FlatGeometry, Geometry, InstancedGeometry};
use lt_shaders::resolve::shadow_ray;
use lt_shaders::shade::shade;
use lt_shaders::surface::Coverage;
use rayon::prelude::*;
use tiles::{BLOCK, Tiles};

use crate::packed::Trees;
use crate::{
    Backend, EffectPlan, Frame, FrameJob, MapSource, MapTest, PackedScene, Pass, PassKind, RenderError,
};

pub use batch::{BatchTest, evaluate_batch};

/// See the [module](self).
pub struct CpuBackend {
    scene: PackedScene,
    tiles: Tiles,
    /// In tile order, like the other per-pixel buffers.
    samples: Vec<Sample>,
    /// Where each sample was in the last frame; empty while nothing in the scene moves.
    previous: Vec<Vec3>,
    visibility: Vec<f32>,
    /// Empty while nothing tints light.
    tint: Vec<Vec3>,
    is_doubted: Vec<bool>,
    /// What techniques keep between frames, by the job's slot.
    slots: Vec<Slot>,
    /// The running frame's slot.
    slot: usize,
    rays: u64,
    passes: Vec<Pass>,
}

/// One technique's map and history.
#[derive(Default)]
struct Slot {
    depths: Vec<f32>,
    rows: Vec<Vec4>,
    vectors: Vec<Vec4>,
    history: History,
}

impl CpuBackend {
    /// The depth map that the last frame drew, in rows; empty before the first.
    pub fn depth_map(&self) -> &[f32] {
        &self.slots[self.slot].depths
    }

    /// Takes the scene and prepares its tracer.
    pub fn new(scene: PackedScene) -> Self {
        // The tracer makes its tree on first use: not in the first frame.
        tracer(&scene).occluded_batch(&[Ray::default()], Opaque, &mut [false]);
        Self {
            scene,
            tiles: Tiles::new(UVec2::ZERO),
            samples: Vec::new(),
            previous: Vec::new(),
            visibility: Vec::new(),
            tint: Vec::new(),
            is_doubted: Vec::new(),
            slots: Vec::new(),
            slot: 0,
            rays: 0,
            passes: Vec::new(),
        }
    }
}

fn tracer(scene: &PackedScene) -> Simd<'_> {
    match scene.trees() {
        Trees::Flat(bvh) => Simd::new(bvh),
        Trees::Instanced(bvh) => Simd::instanced(bvh),
    }
}

fn coverage(scene: &PackedScene, required_flags: u32) -> Coverage<'_> {
    Coverage {
        triangles: scene.triangles(),
        vertices: scene.vertices(),
        materials: scene.materials(),
        alpha_texels: scene.alpha_texels(),
        required_flags,
    }
}

impl Backend for CpuBackend {
    fn name(&self) -> &'static str {
        "cpu"
    }

    fn device(&self) -> String {
        format!("{} ({:?})", cpu_model(), tracer(&self.scene).level())
    }

    fn replace_scene(&mut self, scene: PackedScene) -> Result<(), RenderError> {
        tracer(&scene).occluded_batch(&[Ray::default()], Opaque, &mut [false]);
        self.scene = scene;
        Ok(())
    }

    fn camera(&mut self, params: &CameraParams, plan: &EffectPlan) -> Result<Option<f64>, RenderError> {
        self.tiles = Tiles::new(params.size);
        let len = self.tiles.len();
        self.samples.resize(len, Sample::default());
        self.previous.resize(if plan.object_motion { len } else { 0 }, Vec3::ZERO);
        self.visibility.resize(len, 0.0);
        self.is_doubted.resize(len, false);
        let start = Instant::now();
        let covers = coverage(&self.scene, 0);
        let view = View { scene: &self.scene, tiles: self.tiles, params };
        match (plan.alpha_test, plan.color_textures) {
            (false, false) => see(view, Opaque, NoColorTextures, &mut self.samples, &mut self.previous),
            (true, false) => see(view, covers, NoColorTextures, &mut self.samples, &mut self.previous),
            (false, true) => see(view, Opaque, colors(&self.scene), &mut self.samples, &mut self.previous),
            (true, true) => see(view, covers, colors(&self.scene), &mut self.samples, &mut self.previous),
        }
        Ok(Some(milliseconds(start)))
    }

    fn samples(&mut self) -> Result<Vec<Sample>, RenderError> {
        Ok(self.tiles.to_rows(&self.samples))
    }

    fn begin(&mut self, job: &FrameJob) -> Result<(), RenderError> {
        let map_texels = job.map.map_or(0, |m| (m.depth.map_size as usize).pow(2));
        let vector_texels = if job.plan.is_prefiltered() { map_texels } else { 0 };
        self.slot = job.slot;
        if self.slots.len() <= job.slot {
            self.slots.resize_with(job.slot + 1, Slot::default);
        }
        let slot = &mut self.slots[job.slot];
        slot.depths.resize(map_texels, 1.0);
        slot.rows.resize(vector_texels, Vec4::ZERO);
        slot.vectors.resize(vector_texels, Vec4::ZERO);
        slot.history.begin(self.tiles, job.plan.mask);
        self.is_doubted.fill(false);
        self.tint.resize(if job.plan.tint { self.tiles.len() } else { 0 }, Vec3::ONE);
        self.rays = 0;
        self.passes.clear();
        Ok(())
    }

    fn pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError> {
        let start = Instant::now();
        let slot = &mut self.slots[self.slot];
        match (kind, job.map, job.plan.map) {
            (PassKind::DepthMap, Some(map), _) => {
                raster::draw_depths(&self.scene, &map.depth, &mut slot.depths)
            }
            (PassKind::FilterX, Some(map), Some((test, _))) => {
                blur_rows(test, &map.filter, &slot.depths, &mut slot.rows)
            }
            (PassKind::FilterY, Some(map), _) => blur_columns(&map.filter, &slot.rows, &mut slot.vectors),
            (PassKind::Evaluate, _, Some((test, source))) => self.estimate(test, source, job),
            (PassKind::Mask, ..) => self.correct(job),
            (PassKind::Resolve, ..) => self.rays = self.resolve(job),
            (PassKind::Tint, ..) => {
                self.rays += tint::trace(
                    &self.scene,
                    job.shadow.light,
                    &self.samples,
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
        let bytes =
            size_of_val(&slot.depths[..]) + size_of_val(&slot.rows[..]) + size_of_val(&slot.vectors[..]);
        let mut doubt = self.tiles.to_rows(&self.is_doubted);
        if job.plan.trace_all {
            let lit_side = |s: &Sample| !settle(s, job.shadow.light).1;
            let traced: Vec<bool> = self.samples.iter().map(lit_side).collect();
            doubt = self.tiles.to_rows(&traced);
        }
        Ok(Frame {
            visibility: self.tiles.to_rows(&self.visibility),
            tint: if self.tint.is_empty() { Vec::new() } else { self.tiles.to_rows(&self.tint) },
            doubt,
            rays: self.rays,
            passes: std::mem::take(&mut self.passes),
            map_bytes: bytes as u64,
            mask: job.plan.mask.map_or(Vec::new(), |_| slot.history.rows(self.tiles)),
            map_draws: u32::from(job.draws_map),
        })
    }

    fn shade(
        &mut self,
        visibility: &[f32],
        tint: &[Vec3],
        params: &ShadeParams,
    ) -> Result<Vec<[u8; 4]>, RenderError> {
        let (size, tiles) = (self.tiles.size(), self.tiles);
        let mut picture = vec![0u32; tiles.len()];
        picture.par_chunks_mut(BLOCK).zip(self.samples.par_chunks(BLOCK)).enumerate().for_each(
            |(block, (out, samples))| {
                for (i, (word, sample)) in out.iter_mut().zip(samples).enumerate() {
                    if let Some(px) = tiles.pixel(block, i) {
                        let at = (px.y * size.x + px.x) as usize;
                        let reaching = tint.get(at).map_or(Vec3::ONE, |t| *t) * visibility[at];
                        *word = shade(px, sample, reaching, params);
                    }
                }
            },
        );
        Ok(tiles.to_rows(&picture).into_iter().map(u32::to_le_bytes).collect())
    }
}

impl CpuBackend {
    fn estimate(&mut self, test: MapTest, source: MapSource, job: &FrameJob) {
        match test {
            MapTest::Vsm if source == MapSource::Gather => self.estimate_batched::<Vsm>(job),
            MapTest::Evsm if source == MapSource::Gather => self.estimate_batched::<Evsm>(job),
            MapTest::Sm => self.estimate_with::<Sm>(source, job),
            MapTest::Pcf => self.estimate_with::<Pcf>(source, job),
            MapTest::Vsm => self.estimate_with::<Vsm>(source, job),
            MapTest::Esm => self.estimate_with::<Esm>(source, job),
            MapTest::Evsm => self.estimate_with::<Evsm>(source, job),
            MapTest::Msm => self.estimate_with::<MsmHamburger>(source, job),
            MapTest::MsmHausdorff => self.estimate_with::<MsmHausdorff>(source, job),
        }
    }

    fn estimate_batched<T: BatchTest>(&mut self, job: &FrameJob) {
        let depths = &self.slots[self.slot].depths[..];
        let (p, has_doubts) = (&job.shadow, job.plan.doubt_list);
        let blocks = (self.samples.par_chunks(BLOCK))
            .zip(self.visibility.par_chunks_mut(BLOCK))
            .zip(self.is_doubted.par_chunks_mut(BLOCK));
        blocks.for_each(|((samples, lit), doubted)| match has_doubts {
            false => evaluate_batch::<T, false>(samples, p, depths, lit, doubted),
            true => evaluate_batch::<T, true>(samples, p, depths, lit, doubted),
        });
    }

    fn estimate_with<T: TestFromParams>(&mut self, source: MapSource, job: &FrameJob) {
        let slot = &self.slots[self.slot];
        let gathered = GatheredDepths { depths: &slot.depths };
        let filtered = FilteredVectors { vectors: &slot.vectors };
        let (samples, lit, doubted) = (&self.samples[..], &mut self.visibility[..], &mut self.is_doubted[..]);
        match (source, job.plan.doubt_list) {
            (MapSource::Gather, false) => {
                estimate_tiles::<T, _, false>(&job.shadow, gathered, samples, lit, doubted)
            }
            (MapSource::Gather, true) => {
                estimate_tiles::<T, _, true>(&job.shadow, gathered, samples, lit, doubted)
            }
            (MapSource::Prefiltered, false) => {
                estimate_tiles::<T, _, false>(&job.shadow, filtered, samples, lit, doubted);
            }
            (MapSource::Prefiltered, true) => {
                estimate_tiles::<T, _, true>(&job.shadow, filtered, samples, lit, doubted);
            }
        }
    }

    /// The mask pass.
    fn correct(&mut self, job: &FrameJob) {
        let (Some(params), Some(effects)) = (&job.mask, job.plan.mask) else { return };
        let seen = Seen {
            tiles: self.tiles,
            samples: &self.samples,
            previous: if job.plan.object_motion { &self.previous } else { &[] },
        };
        let history = &mut self.slots[self.slot].history;
        history.correct(seen, params, effects, &mut self.visibility, &mut self.is_doubted);
    }

    fn resolve(&mut self, job: &FrameJob) -> u64 {
        let (scene, light, all) = (&self.scene, job.shadow.light, job.plan.trace_all);
        let (samples, doubted, lit) = (&self.samples[..], &self.is_doubted[..], &mut self.visibility[..]);
        let rays = match job.plan.alpha_test {
            true => trace(scene, light, all, coverage(scene, Material::CASTS), samples, doubted, lit),
            false => trace(scene, light, all, Opaque, samples, doubted, lit),
        };
        if job.plan.mask.is_some() {
            self.slots[self.slot].history.learn(&self.visibility, &self.is_doubted);
        }
        rays
    }
}

/// Traces the doubted pixels, or every one that faces the light; returns how many.
fn trace<A: AnyHit + Sync>(
    scene: &PackedScene,
    light: Vec4,
    trace_all: bool,
    any_hit: A,
    samples: &[Sample],
    is_doubted: &[bool],
    visibility: &mut [f32],
) -> u64 {
    let tracer = tracer(scene);
    let blocks =
        visibility.par_chunks_mut(BLOCK).zip(samples.par_chunks(BLOCK)).zip(is_doubted.par_chunks(BLOCK));
    blocks
        .map_init(Batch::default, |batch, ((visibility, samples), is_doubted)| {
            batch.clear();
            for (i, sample) in samples.iter().enumerate() {
                if trace_all {
                    let (verdict, is_settled) = settle(sample, light);
                    visibility[i] = verdict.visibility;
                    if !is_settled {
                        batch.push(i, shadow_ray(sample, light));
                    }
                } else if is_doubted[i] {
                    batch.push(i, shadow_ray(sample, light));
                }
            }
            batch.trace(&tracer, any_hit, visibility)
        })
        .sum()
}

/// The rays of one block and the pixels they belong to.
#[derive(Default)]
struct Batch {
    pixels: Vec<usize>,
    rays: Vec<Ray>,
    is_blocked: Vec<bool>,
}

impl Batch {
    fn clear(&mut self) {
        self.pixels.clear();
        self.rays.clear();
    }

    fn push(&mut self, pixel: usize, ray: Ray) {
        self.pixels.push(pixel);
        self.rays.push(ray);
    }

    fn trace<A: AnyHit>(&mut self, tracer: &Simd<'_>, any_hit: A, visibility: &mut [f32]) -> u64 {
        self.is_blocked.clear();
        self.is_blocked.resize(self.rays.len(), false);
        tracer.occluded_batch(&self.rays, any_hit, &mut self.is_blocked);
        for (&pixel, &is_blocked) in self.pixels.iter().zip(&self.is_blocked) {
            visibility[pixel] = if is_blocked { 0.0 } else { 1.0 };
        }
        self.rays.len() as u64
    }
}

fn estimate_tiles<T: TestFromParams, M: MapView + Sync, const LTT: bool>(
    p: &ShadowParams,
    map: M,
    samples: &[Sample],
    visibility: &mut [f32],
    is_doubted: &mut [bool],
) {
    let blocks =
        samples.par_chunks(BLOCK).zip(visibility.par_chunks_mut(BLOCK)).zip(is_doubted.par_chunks_mut(BLOCK));
    blocks.for_each(|((samples, visibility), is_doubted)| {
        for ((sample, visibility), is_doubted) in samples.iter().zip(visibility).zip(is_doubted) {
            let verdict = evaluate::<T, M, LTT>(sample, p, map);
            *visibility = verdict.visibility;
            *is_doubted = verdict.is_doubted;
        }
    });
}

fn blur_rows(test: MapTest, p: &FilterParams, depths: &[f32], rows: &mut [Vec4]) {
    let each = |kernel: fn(UVec2, &FilterParams, &[f32]) -> Vec4, rows: &mut [Vec4]| {
        map_texels(p.map_size, rows, |texel| kernel(texel, p, depths));
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

fn blur_columns(p: &FilterParams, rows: &[Vec4], vectors: &mut [Vec4]) {
    map_texels(p.map_size, vectors, |texel| filter_y(texel, p, rows));
}

fn map_texels(map_size: u32, out: &mut [Vec4], kernel: impl Fn(UVec2) -> Vec4 + Sync) {
    out.par_chunks_mut(map_size as usize).enumerate().for_each(|(y, row)| {
        for (x, texel) in row.iter_mut().enumerate() {
            *texel = kernel(UVec2::new(x as u32, y as u32));
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

/// The camera pass over all tiles; `previous` is empty, or also gets where every sample was in the last frame.
fn see<A: AnyHit + Sync, C: ColorSource + Sync>(
    view: View<'_>,
    any_hit: A,
    colors: C,
    samples: &mut [Sample],
    previous: &mut [Vec3],
) {
    let scene = view.scene;
    let (nodes, triangles) = (scene.nodes(), scene.triangles());
    match scene.trees() {
        Trees::Flat(_) => {
            see_geometry(view, FlatGeometry { nodes, triangles }, any_hit, colors, samples, previous);
        }
        Trees::Instanced(_) => {
            let geometry =
                InstancedGeometry { nodes, triangles, instances: scene.instances(), root: scene.root() };
            see_geometry(view, geometry, any_hit, colors, samples, previous);
        }
    }
}

fn see_geometry<G: Geometry + Sync, A: AnyHit + Sync, C: ColorSource + Sync>(
    view: View<'_>,
    geometry: G,
    any_hit: A,
    colors: C,
    samples: &mut [Sample],
    previous: &mut [Vec3],
) {
    let View { scene, tiles, params: p } = view;
    let tracer = tracer(scene);
    let see_block = |block: usize, samples: &mut [Sample], previous: &mut [Vec3]| {
        let pixels: Vec<Option<UVec2>> = (0..BLOCK).map(|i| tiles.pixel(block, i)).collect();
        let rays: Vec<Ray> =
            pixels.iter().map(|px| px.map_or(Ray::default(), |px| primary_ray(px, p))).collect();
        let mut hits = vec![Hit::miss(0.0); BLOCK];
        tracer.closest_batch(&rays, any_hit, &mut hits);
        for (sample, hit) in samples.iter_mut().zip(&hits) {
            *sample = sample_at_hit(hit, p, geometry, scene.vertices(), scene.materials(), colors);
        }
        for (previous, hit) in previous.iter_mut().zip(&hits) {
            *previous = previous_position(hit, geometry, scene.previous_positions());
        }
    };
    let blocks = samples.par_chunks_mut(BLOCK);
    if previous.is_empty() {
        blocks.enumerate().for_each(|(block, samples)| see_block(block, samples, &mut []));
    } else {
        let both = blocks.zip(previous.par_chunks_mut(BLOCK)).enumerate();
        both.for_each(|(block, (samples, previous))| see_block(block, samples, previous));
    }
}

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
