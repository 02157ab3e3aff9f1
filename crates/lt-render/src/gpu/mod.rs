//! The wgpu backend: a library that records into the caller's encoder, and the one caller that `lt` is.
//!
//! An engine keeps its own device, queue and textures:
//!
//! 1. [`Recorder::new`] with its device; [`Recorder::upload`] a [`PackedScene`]; [`Recorder::frame_buffers`].
//! 2. Per frame [`Recorder::import_gbuffer`] (or [`Recorder::camera`]), [`Recorder::prepare`], then
//!    [`Recorder::pass`] for every pass of the plan, and [`Recorder::export_visibility`]; all on its own encoder.
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
pub use recorder::Recorder;

use lt_math::glam::UVec2;
use lt_shaders::abi::{CameraParams, Sample, ShadeParams};
use lt_shaders::doubt::{COUNT, LIST_START};
use lt_shaders::evaluate::settle;
use timestamps::Timestamps;

use crate::{Backend, EffectPlan, Frame, FrameJob, PackedScene, Pass, PassKind, RenderError};

/// Runs frames on a device of its own and reads them back.
pub struct GpuBackend {
    device: wgpu::Device,
    queue: wgpu::Queue,
    device_name: String,
    recorder: Recorder,
    scene: GpuScene,
    frame: FrameBuffers,
    samples: Vec<Sample>,
    encoder: Option<wgpu::CommandEncoder>,
    timestamps: Option<Timestamps>,
    kinds: Vec<PassKind>,
}

impl GpuBackend {
    /// Opens the best adapter and uploads the scene.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`], or [`RenderError::Gpu`] when the scene does not fit.
    pub fn new(scene: &PackedScene) -> Result<Self, RenderError> {
        let (adapter, device, queue) = open()?;
        let info = adapter.get_info();
        let recorder = Recorder::new(&device);
        let scene = recorder.upload(scene)?;
        let frame = recorder.frame_buffers(UVec2::ONE)?;
        let timestamps = Timestamps::new(&device, &queue);
        let device_name = format!("{} ({}, {})", info.name, info.backend, info.driver_info);
        Ok(Self {
            device,
            queue,
            device_name,
            recorder,
            scene,
            frame,
            samples: Vec::new(),
            encoder: None,
            timestamps,
            kinds: Vec::new(),
        })
    }

    fn new_encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") })
    }

    fn mark(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if let Some(t) = &mut self.timestamps {
            t.mark(encoder);
        }
    }

    /// Submits, and returns the time of each marked pass.
    fn submit(&mut self, mut encoder: wgpu::CommandEncoder) -> Result<Vec<Option<f64>>, RenderError> {
        if let Some(t) = &self.timestamps {
            t.resolve(&mut encoder);
        }
        self.queue.submit([encoder.finish()]);
        let Some(t) = &self.timestamps else { return Ok(vec![None; self.kinds.len()]) };
        let (buffer, bytes) = t.buffer();
        let ticks: Vec<u64> = self.recorder.allocator().read(&self.queue, buffer, bytes)?;
        Ok(t.milliseconds(&ticks).into_iter().map(Some).collect())
    }

    fn restart(&mut self) {
        self.kinds.clear();
        if let Some(t) = &mut self.timestamps {
            t.restart();
        }
    }

    fn pixels(&self) -> u64 {
        u64::from(self.frame.size.x) * u64::from(self.frame.size.y)
    }

    /// Doubted pixels and rays of the frame that was just run.
    fn doubt(&self, job: &FrameJob) -> Result<(Vec<bool>, u64), RenderError> {
        if job.plan.trace_all {
            let traced: Vec<bool> = self.samples.iter().map(|s| !settle(s, job.shadow.light).1).collect();
            let rays = traced.iter().filter(|t| **t).count() as u64;
            return Ok((traced, rays));
        }
        let mut doubt = vec![false; self.pixels() as usize];
        let Some(buffers) = self.frame.doubt.as_ref().filter(|_| job.plan.doubt_list) else { return Ok((doubt, 0)) };
        let list: Vec<u32> = self.recorder.allocator().read(&self.queue, &buffers.list, buffers.list.size())?;
        let count = list[COUNT] as usize;
        for &pixel in list[LIST_START as usize..].iter().take(count) {
            doubt[pixel as usize] = true;
        }
        Ok((doubt, count as u64))
    }
}

impl Backend for GpuBackend {
    fn name(&self) -> &'static str {
        "gpu"
    }

    fn device(&self) -> String {
        self.device_name.clone()
    }

    fn camera(&mut self, params: &CameraParams, plan: &EffectPlan) -> Result<Option<f64>, RenderError> {
        self.frame = self.recorder.frame_buffers(params.size)?;
        self.restart();
        self.kinds.push(PassKind::Camera);
        let mut encoder = self.new_encoder();
        self.mark(&mut encoder);
        self.recorder.camera(&mut encoder, &self.scene, &self.frame, params, plan)?;
        self.mark(&mut encoder);
        let times = self.submit(encoder)?;
        let bytes = self.pixels() * size_of::<Sample>() as u64;
        self.samples = self.recorder.allocator().read(&self.queue, &self.frame.samples, bytes)?;
        Ok(times.first().copied().flatten())
    }

    fn samples(&mut self) -> Result<Vec<Sample>, RenderError> {
        Ok(self.samples.clone())
    }

    fn begin(&mut self, job: &FrameJob) -> Result<(), RenderError> {
        self.recorder.prepare(&mut self.frame, job)?;
        self.restart();
        self.encoder = Some(self.new_encoder());
        Ok(())
    }

    fn pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError> {
        let mut encoder = self.encoder.take().unwrap_or_else(|| self.new_encoder());
        self.kinds.push(kind);
        self.mark(&mut encoder);
        self.recorder.pass(&mut encoder, &self.scene, &self.frame, kind, job)?;
        self.mark(&mut encoder);
        self.encoder = Some(encoder);
        Ok(())
    }

    fn finish(&mut self, job: &FrameJob) -> Result<Frame, RenderError> {
        let encoder = self.encoder.take().unwrap_or_else(|| self.new_encoder());
        let times = self.submit(encoder)?;
        let passes = self.kinds.iter().zip(times).map(|(&kind, ms)| Pass { kind, ms }).collect();
        let bytes = self.pixels() * 4;
        let visibility = self.recorder.allocator().read(&self.queue, &self.frame.visibility, bytes)?;
        let (doubt, rays) = self.doubt(job)?;
        let map_bytes = self.frame.map.as_ref().filter(|_| job.map.is_some()).map_or(0, |m| m.bytes());
        Ok(Frame { visibility, doubt, rays, passes, map_bytes })
    }

    fn shade(&mut self, visibility: &[f32], params: &ShadeParams) -> Result<Vec<[u8; 4]>, RenderError> {
        self.queue.write_buffer(&self.frame.visibility, 0, bytemuck::cast_slice(visibility));
        let bytes = self.pixels() * 4;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let picture = self.recorder.allocator().empty("picture", bytes, usage)?;
        let mut encoder = self.new_encoder();
        self.recorder.shade(&mut encoder, &self.frame, &picture, params)?;
        self.queue.submit([encoder.finish()]);
        let words: Vec<u32> = self.recorder.allocator().read(&self.queue, &picture, bytes)?;
        Ok(words.into_iter().map(u32::to_le_bytes).collect())
    }
}
