//! The depth map pass: what is drawn of a light's maps, and the pipelines that draw it.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use lt_mask::marks_words;
use lt_shaders::abi::DepthParams;
use wgpu::BufferUsages as Usage;

use super::super::buffers::{FrameBuffers, GpuScene, MapBuffers, MarkBuffers, WORD_BYTES};
use super::Recorder;
use crate::{DepthMapJob, DrawRange, FrameJob, RenderError};

impl Recorder {
    /// Records it; how long the host took to find out what maps see, which no timestamp tells.
    pub(super) fn depth_map(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<Duration, RenderError> {
        let slot = self.slot(frame, job)?;
        let (Some(map), Some(map_job)) = (&slot.map, &job.map) else { return Err(self.unprepared()) };
        let mut culling = Duration::ZERO;
        // Marks are as old as what stands still.
        let is_anew = |level: &u32| map_job.draws.contains(level) || scene.moving_draws.is_empty();
        for level in map_job.drawn().filter(is_anew) {
            let bytes = marks_words(map_job.texels(level).len() as u64) * WORD_BYTES;
            let marks = map.marks.as_ref().map(MarkBuffers::read);
            marks.into_iter().for_each(|m| encoder.clear_buffer(m, u64::from(level) * bytes, Some(bytes)));
        }
        for level in map_job.drawn() {
            culling += self.draw_depths(encoder, scene, map, map_job, level)?;
            encoder.copy_texture_to_buffer(
                wgpu::TexelCopyTextureInfo {
                    aspect: wgpu::TextureAspect::DepthOnly,
                    ..map.texture.texture().as_image_copy()
                },
                wgpu::TexelCopyBufferInfo {
                    buffer: &map.depths,
                    layout: wgpu::TexelCopyBufferLayout {
                        offset: u64::from(level) * u64::from(map.size) * u64::from(map.size) * 4,
                        bytes_per_row: Some(map.size * 4),
                        rows_per_image: None,
                    },
                },
                map.texture.texture().size(),
            );
        }
        Ok(culling)
    }

    /// Draws a level into the maps' texture, whole or what moves over what stands still: the lesser depth of both, as if drawn whole.
    fn draw_depths(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        map: &MapBuffers,
        job: &DepthMapJob,
        level: u32,
    ) -> Result<Duration, RenderError> {
        let p = &job.levels[level as usize];
        let empty = wgpu::LoadOp::Clear(1.0);
        let still =
            map.still.as_ref().filter(|s| s.is_drawn[level as usize] && !scene.moving_draws.is_empty());
        let Some(still) = still else {
            return self.draw_casters(encoder, scene, map, p, (&scene.draws, empty));
        };
        let target = map.texture.texture().as_image_copy();
        let layer = wgpu::Origin3d { x: 0, y: 0, z: level };
        let kept = wgpu::TexelCopyTextureInfo { origin: layer, ..still.texture.as_image_copy() };
        let mut culling = Duration::ZERO;
        if job.draws.contains(&level) {
            culling += self.draw_casters(encoder, scene, map, p, (&scene.still_draws, empty))?;
            encoder.copy_texture_to_texture(target, kept, map.texture.texture().size());
        } else {
            encoder.copy_texture_to_texture(kept, target, map.texture.texture().size());
        }
        Ok(culling + self.draw_casters(encoder, scene, map, p, (&scene.moving_draws, wgpu::LoadOp::Load))?)
    }

    /// Draws some casters into the maps' texture; how long it took to leave out what the map does not see.
    fn draw_casters(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        map: &MapBuffers,
        p: &DepthParams,
        (draws, load): (&[DrawRange], wgpu::LoadOp<f32>),
    ) -> Result<Duration, RenderError> {
        let uniform = self.allocator.filled("depth map", &[*p], Usage::UNIFORM)?;
        let start = Instant::now();
        let draws = scene.culling.visible_draws(draws, p);
        let culling = start.elapsed();
        let mut variants: HashMap<&str, (wgpu::RenderPipeline, wgpu::BindGroup)> = HashMap::new();
        for draw in &draws {
            let name = depth_variant(p.near > 0.0, scene.instances.is_some(), draw.has_holes);
            if !variants.contains_key(name) {
                let pipeline = self.depth_pipeline(name)?;
                let mut buffers = vec![&uniform, &scene.triangles];
                buffers.extend(&scene.instances);
                if draw.has_holes {
                    buffers.extend([&scene.vertices, &scene.materials]);
                    buffers.extend(&scene.alpha_texels);
                }
                let resources: Vec<_> = buffers.iter().map(|b| b.as_entire_binding()).collect();
                let group = self.bind_group(&pipeline.get_bind_group_layout(0), &resources);
                variants.insert(name, (pipeline, group));
            }
        }
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("depth map"),
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &map.texture,
                depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        });
        for draw in &draws {
            let (pipeline, group) =
                &variants[depth_variant(p.near > 0.0, scene.instances.is_some(), draw.has_holes)];
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, group, &[]);
            let first = draw.first_triangle * 3;
            pass.draw(first..first + draw.triangles * 3, draw.instance..draw.instance + 1);
        }
        Ok(culling)
    }

    fn depth_pipeline(&mut self, name: &'static str) -> Result<wgpu::RenderPipeline, RenderError> {
        if let Some(pipeline) = self.render.get(name) {
            return Ok(pipeline.clone());
        }
        let pipeline = self.make_depth_pipeline(name)?;
        self.render.insert(name, pipeline.clone());
        Ok(pipeline)
    }

    fn make_depth_pipeline(&self, name: &str) -> Result<wgpu::RenderPipeline, RenderError> {
        let is_perspective = name.starts_with("depth_perspective");
        // The stage that tells fragments their triangle.
        let vertex = match (is_perspective, name.contains("instanced")) {
            (false, _) => self.module(&format!("{name}_vs"))?,
            (true, false) => self.module("depth_alpha_vs")?,
            (true, true) => self.module("depth_instanced_alpha_vs")?,
        };
        let has_fragments = is_perspective || name.ends_with("alpha");
        let fragment = if has_fragments { Some(self.module(&format!("{name}_fs"))?) } else { None };
        let fragment = fragment.map(|f| (f.load(&self.device), f.entry_point));
        Ok(self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(name),
            layout: None,
            vertex: wgpu::VertexState {
                module: &vertex.load(&self.device),
                entry_point: Some(vertex.entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            // Both faces cast.
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: wgpu::TextureFormat::Depth32Float,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Less),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: fragment.as_ref().map(|(module, entry_point)| wgpu::FragmentState {
                module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[],
            }),
            multiview_mask: None,
            cache: None,
        }))
    }
}

fn depth_variant(is_perspective: bool, is_instanced: bool, has_holes: bool) -> &'static str {
    match (is_perspective, is_instanced, has_holes) {
        (false, false, false) => "depth",
        (false, false, true) => "depth_alpha",
        (false, true, false) => "depth_instanced",
        (false, true, true) => "depth_instanced_alpha",
        (true, false, false) => "depth_perspective",
        (true, false, true) => "depth_perspective_alpha",
        (true, true, false) => "depth_perspective_instanced",
        (true, true, true) => "depth_perspective_instanced_alpha",
    }
}
