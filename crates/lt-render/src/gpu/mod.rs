//! The wgpu backend: a library that records into the caller's encoder, and the one caller that `lt` is.
//!
//! An engine keeps its own device, queue and textures:
//!
//! 1. [`Recorder::new`] with its device; [`Recorder::upload`] a [`PackedScene`]; [`Recorder::frame_buffers`]; a
//!    [`crate::FramePlanner`] for the same scene.
//! 2. Per frame [`Recorder::import_gbuffer`] (or [`Recorder::camera`]), and for each job of [`crate::FramePlanner::next_frame`]
//!    [`Recorder::prepare`], [`Recorder::plant_light_tree`] for `light` as resolver, [`Recorder::pass`] for every pass of
//!    [`FrameJob::passes`], and [`Recorder::export_visibility`]; all on its own encoder.
//!
//! `examples/engine.rs` of this crate does so.
//!
//! Nothing is submitted, waited for or read back by the recorder. [`GpuBackend`] does those for the frame driver.

mod adapter;
mod buffers;
mod modules;
mod recorder;
mod timestamps;

pub use adapter::{AdapterReport, OPTIONAL_FEATURES, STORAGE_BUFFERS, adapters, has_hardware_adapter, open};
pub use buffers::{FrameBuffers, GpuScene};
pub use modules::{MODULES, ShaderModule};
pub use recorder::{GBuffer, Recorder};

use std::time::{Duration, Instant};

use lt_mask::MaskBits;
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_shaders::abi::{CameraParams, Sample};
use lt_shaders::doubt::{COUNT, LIST_START, Listed};
use lt_shaders::evaluate::settle;
use lt_shaders::mask::BitsPlace;
use lt_shaders::resolve::may_be_tinted;
use timestamps::Timestamps;

use crate::{
    Backend, EffectPlan, Frame, FrameJob, PackedScene, Pass, PassKind, RenderError, Resolve, ShadedLight,
    Upkeep,
    light_space::{self, Planted},
};

/// For how long a frame is run before its times count. Between frames the host reads back and compares, and processors slow down when idle:
/// an H100 to a fifth.
const WARM_UP: Duration = Duration::from_millis(200);

/// Runs frames on a device of its own and reads them back.
pub struct GpuBackend {
    device: wgpu::Device,
    queue: wgpu::Queue,
    device_name: String,
    recorder: Recorder,
    /// What the scene on the device was uploaded from: trees in light space are planted from it.
    packed: PackedScene,
    scene: GpuScene,
    /// By light number, what the tree took that the scene holds for it.
    planted: Vec<Planted>,
    frame: FrameBuffers,
    /// Layer by layer.
    samples: Vec<Vec<Sample>>,
    encoder: Option<wgpu::CommandEncoder>,
    timestamps: Option<Timestamps>,
    /// A software driver: its timestamps do not bracket the work between them (seen with Mesa 22.3's lavapipe once a
    /// render pass has run), so passes are submitted one by one and timed by the host's clock.
    is_software: bool,
    passes: Vec<Recorded>,
}

/// A pass of the running frame.
#[derive(Clone, Copy)]
struct Recorded {
    kind: PassKind,
    /// What the host did for it before, as part of it.
    host_ms: f64,
    /// What else it took; open where only timestamps can tell it.
    ms: Option<f64>,
}

impl Recorded {
    fn pass(&self) -> Pass {
        Pass { kind: self.kind, ms: self.ms.map(|ms| self.host_ms + ms) }
    }
}

impl GpuBackend {
    /// Opens the best adapter and uploads the scene.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`], or [`RenderError::Gpu`] when the scene does not fit.
    pub fn new(packed: PackedScene) -> Result<Self, RenderError> {
        let (adapter, device, queue) = open()?;
        let info = adapter.get_info();
        let recorder = Recorder::new(&device);
        let scene = recorder.upload(&packed)?;
        let frame = recorder.frame_buffers(UVec2::ONE)?;
        let is_software = info.device_type == wgpu::DeviceType::Cpu;
        let timestamps = if is_software { None } else { Timestamps::new(&device, &queue) };
        let device_name = format!("{} ({}, {})", info.name, info.backend, info.driver_info);
        Ok(Self {
            device,
            queue,
            device_name,
            recorder,
            packed,
            scene,
            planted: Vec::new(),
            frame,
            samples: Vec::new(),
            encoder: None,
            timestamps,
            is_software,
            passes: Vec::new(),
        })
    }

    fn new_encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") })
    }

    /// Records one pass between timestamps, or runs it at once on a software driver. `record` says what of the host's time is the pass's.
    fn timed(
        &mut self,
        kind: PassKind,
        record: impl FnOnce(&mut Self, &mut wgpu::CommandEncoder) -> Result<Duration, RenderError>,
    ) -> Result<(), RenderError> {
        let mut encoder = self.encoder.take().unwrap_or_else(|| self.new_encoder());
        if let Some(t) = &mut self.timestamps {
            t.mark(&mut encoder);
        }
        let host_ms = milliseconds(record(self, &mut encoder)?);
        if let Some(t) = &mut self.timestamps {
            t.mark(&mut encoder);
        }
        let mut ms = None;
        if self.is_software {
            let start = Instant::now();
            self.queue.submit([encoder.finish()]);
            self.recorder.allocator().wait()?;
            ms = Some(milliseconds(start.elapsed()));
        } else {
            self.encoder = Some(encoder);
        }
        self.passes.push(Recorded { kind, host_ms, ms });
        Ok(())
    }

    /// Submits what is recorded and fills in the passes' times.
    fn submit(&mut self) -> Result<Vec<Pass>, RenderError> {
        let mut passes = std::mem::take(&mut self.passes);
        let all = |passes: Vec<Recorded>| passes.iter().map(Recorded::pass).collect();
        let Some(mut encoder) = self.encoder.take() else { return Ok(all(passes)) };
        if let Some(t) = &self.timestamps {
            t.resolve(&mut encoder);
        }
        self.queue.submit([encoder.finish()]);
        if let Some(t) = &self.timestamps {
            let (buffer, bytes) = t.buffer();
            let ticks: Vec<u64> = self.recorder.allocator().read(&self.queue, buffer, bytes)?;
            let untimed = passes.iter_mut().filter(|pass| pass.ms.is_none());
            for (pass, ms) in untimed.zip(t.milliseconds(&ticks)) {
                pass.ms = Some(ms);
            }
        }
        Ok(all(passes))
    }

    /// [`GpuBackend::submit`] for a frame, again and again until a processor that had idled runs at its full clock again: each pass gives what it gave
    /// before, and the last times count. A software driver's processor needs none of that.
    fn submit_warm(&mut self, job: &FrameJob) -> Result<Vec<Pass>, RenderError> {
        let start = Instant::now();
        let mut passes = self.submit()?;
        while self.timestamps.is_some() && start.elapsed() < WARM_UP {
            self.restart();
            for pass in &passes {
                match pass.kind {
                    PassKind::LightTree => {
                        self.passes.push(Recorded { kind: pass.kind, host_ms: 0.0, ms: pass.ms });
                    }
                    kind => self.record_pass(kind, job)?,
                }
            }
            passes = self.submit()?;
            tracing::trace!(?passes, "again");
        }
        Ok(passes)
    }

    fn record_pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError> {
        self.timed(kind, |this, encoder| {
            this.recorder.pass_timed(encoder, &this.scene, &this.frame, kind, job)
        })
    }

    fn restart(&mut self) {
        self.passes.clear();
        if let Some(t) = &mut self.timestamps {
            t.restart();
        }
    }

    /// What the mask remembers of the job's light, row by row; empty without one.
    fn mask(&self, job: &FrameJob) -> Result<Vec<MaskBits>, RenderError> {
        let Some(history) = &self.frame.slots[job.history_slot].history else { return Ok(Vec::new()) };
        let (buffer, place) = (&history.bits[history.current], BitsPlace::of(&job.shadow.light));
        let words: Vec<u32> = self.recorder.allocator().read(&self.queue, buffer, buffer.size())?;
        Ok((0..self.pixels() as u32).map(|i| place.read(&words, i)).collect())
    }

    /// Adds a light to what the samples of the layer that is shown receive.
    fn add_light(&mut self, light: &ShadedLight<'_>) -> Result<(), RenderError> {
        self.queue.write_buffer(&self.frame.visibility, 0, bytemuck::cast_slice(light.visibility));
        self.frame.tints = match light.tint {
            [] => None,
            tint => {
                let buffer = self.recorder.allocator().tints(self.frame.size)?;
                let rows: Vec<Vec4> = tint.iter().map(|t| t.extend(1.0)).collect();
                self.queue.write_buffer(&buffer, 0, bytemuck::cast_slice(&rows));
                Some(buffer)
            }
        };
        let mut encoder = self.new_encoder();
        self.recorder.add_light(&mut encoder, &mut self.frame, &light.params)?;
        self.queue.submit([encoder.finish()]);
        Ok(())
    }

    /// Samples of the picture.
    fn pixels(&self) -> u64 {
        u64::from(self.frame.size.x) * u64::from(self.frame.size.y)
    }

    /// Doubted pixels and rays of the frame that was just run.
    fn doubt(&self, job: &FrameJob) -> Result<(Vec<bool>, u64), RenderError> {
        if job.plan.trace_all {
            let samples = &self.samples[job.layer as usize];
            let traced: Vec<bool> = samples.iter().map(|s| !settle(s, &job.shadow.light).1).collect();
            let rays = traced.iter().filter(|t| **t).count() as u64;
            return Ok((traced, rays));
        }
        let mut doubt = vec![false; self.pixels() as usize];
        let Some(buffers) = self.frame.doubt.as_ref().filter(|_| job.plan.doubt_list) else {
            return Ok((doubt, 0));
        };
        let list: Vec<u32> =
            self.recorder.allocator().read(&self.queue, &buffers.list, buffers.list.size())?;
        let count = list[COUNT] as usize;
        for &word in list[LIST_START as usize..].iter().take(count) {
            doubt[Listed::from_word(word).pixel as usize] = true;
        }
        Ok((doubt, count as u64))
    }
}

impl Backend for GpuBackend {
    fn name(&self) -> &'static str {
        "gpu"
    }

    fn has_all_resolvers(&self) -> bool {
        false
    }

    fn device(&self) -> String {
        self.device_name.clone()
    }

    fn replace_scene(&mut self, scene: PackedScene) -> Result<(), RenderError> {
        self.scene = self.recorder.upload(&scene)?;
        self.packed = scene;
        Ok(())
    }

    fn camera(&mut self, params: &CameraParams, plan: &EffectPlan) -> Result<Option<f64>, RenderError> {
        // The next view of the same size: maps and histories stay.
        if self.frame.size != params.size {
            self.frame = self.recorder.frame_buffers(params.size)?;
        }
        self.restart();
        self.timed(PassKind::Camera, |this, encoder| {
            this.recorder.camera(encoder, &this.scene, &mut this.frame, params, plan).map(|()| Duration::ZERO)
        })?;
        let passes = self.submit()?;
        let bytes = self.pixels() * size_of::<Sample>() as u64;
        self.samples.clear();
        for layer in 0..plan.layers {
            self.frame.show_layer(layer);
            self.samples.push(self.recorder.allocator().read(&self.queue, &self.frame.samples, bytes)?);
        }
        Ok(passes.first().and_then(|p| p.ms))
    }

    fn samples(&mut self) -> Result<Vec<Vec<Sample>>, RenderError> {
        Ok(self.samples.clone())
    }

    fn begin(&mut self, job: &FrameJob) -> Result<(), RenderError> {
        let resolve = job.plan.resolve;
        if let Some(resolver) = resolve.modifier().filter(|_| resolve != Resolve::Light) {
            let problem = format!(
                "has no resolver `{resolver}`: use `light`, which gives the same answers, or --backend cpu"
            );
            return Err(RenderError::Gpu { device: self.device_name.clone(), problem });
        }
        light_space::check(&self.packed, job)?;
        if job.plan.upkeep != Upkeep::Kept {
            let problem = "does not rebuild trees (--rebuild): use --backend cpu".to_owned();
            return Err(RenderError::Gpu { device: self.device_name.clone(), problem });
        }
        self.frame.show_layer(job.layer);
        self.recorder.prepare(&mut self.frame, job)?;
        self.restart();
        Ok(())
    }

    fn pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError> {
        if kind == PassKind::LightTree {
            let (start, number) = (Instant::now(), job.shadow.light.number as usize);
            if self.recorder.plant_light_tree(&mut self.scene, &self.packed, job)? {
                if self.planted.len() <= number {
                    self.planted.resize_with(number + 1, Planted::default);
                }
                self.planted[number] = Planted::in_ms(milliseconds(start.elapsed()));
            }
            let host_ms = self.planted[number].charge(job.slot);
            self.passes.push(Recorded { kind, host_ms, ms: Some(0.0) });
            return Ok(());
        }
        self.record_pass(kind, job)
    }

    fn finish(&mut self, job: &FrameJob) -> Result<Frame, RenderError> {
        let passes = self.submit_warm(job)?;
        let bytes = self.pixels() * 4;
        let visibility = self.recorder.allocator().read(&self.queue, &self.frame.visibility, bytes)?;
        let (doubt, mut rays) = self.doubt(job)?;
        let tint: Vec<Vec3> = match &self.frame.tints {
            None => Vec::new(),
            Some(buffer) => {
                let rows: Vec<Vec4> = self.recorder.allocator().read(&self.queue, buffer, bytes * 4)?;
                let reached = self.samples[job.layer as usize].iter().zip(&visibility);
                rays += reached.filter(|(s, v)| may_be_tinted(s, &job.shadow.light, **v)).count() as u64;
                rows.into_iter().map(Vec4::truncate).collect()
            }
        };
        let slot = &self.frame.slots[job.slot];
        let map_bytes = slot.map.as_ref().filter(|_| job.map.is_some()).map_or(0, |m| m.bytes());
        let mask = self.mask(job)?;
        let (map_draws, lights, layers) = (job.map_draws(), Vec::new(), Vec::new());
        Ok(Frame { visibility, tint, doubt, rays, passes, map_bytes, mask, map_draws, lights, layers })
    }

    fn shade(&mut self, layers: &[Vec<ShadedLight<'_>>]) -> Result<Vec<[u8; 4]>, RenderError> {
        let Some(first) = layers.first().and_then(|lights| lights.first()) else { return Ok(Vec::new()) };
        for (layer, lights) in layers.iter().enumerate() {
            self.frame.show_layer(layer as u32);
            lights.iter().try_for_each(|light| self.add_light(light))?;
            if !self.frame.layers.is_empty() {
                let mut encoder = self.new_encoder();
                self.recorder.add_layer(&mut encoder, &mut self.frame, &first.params)?;
                self.queue.submit([encoder.finish()]);
            }
        }
        let bytes = self.pixels() * 4 / u64::from(first.params.camera.grid.element_product());
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let picture = self.recorder.allocator().empty("picture", bytes, usage)?;
        let mut encoder = self.new_encoder();
        self.recorder.shade(&mut encoder, &mut self.frame, &picture, &first.params)?;
        self.queue.submit([encoder.finish()]);
        let words: Vec<u32> = self.recorder.allocator().read(&self.queue, &picture, bytes)?;
        Ok(words.into_iter().map(u32::to_le_bytes).collect())
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
