//! Records passes into the caller's encoder.

mod camera;
mod depth;
mod mask;
mod shade;

pub use camera::GBuffer;

use std::collections::HashMap;
use std::time::Duration;

use lt_math::glam::UVec2;
use wgpu::BufferUsages as Usage;

use super::buffers::{
    Allocator, DEPTH_BYTES, FrameBuffers, GpuScene, HistoryBuffers, MapBuffers, MarkBuffers, SlotBuffers,
    VECTOR_BYTES,
};
use super::modules::ShaderModule;
use crate::light_space;
use crate::{FrameJob, MapSource, PackedScene, PassKind, RenderError, Resolve};

/// Records shadow passes on a device that the caller owns.
///
/// Nothing is submitted and nothing is read back: [`Recorder::pass`] only adds to an encoder. Pipelines are made on
/// first use and kept. The device needs [`super::STORAGE_BUFFERS`] storage buffers per stage.
pub struct Recorder {
    device: wgpu::Device,
    allocator: Allocator,
    compute: HashMap<String, wgpu::ComputePipeline>,
    render: HashMap<&'static str, wgpu::RenderPipeline>,
}

impl Recorder {
    /// For the caller's device.
    pub fn new(device: &wgpu::Device) -> Self {
        Self {
            device: device.clone(),
            allocator: Allocator::new(device),
            compute: HashMap::new(),
            render: HashMap::new(),
        }
    }

    pub(super) fn allocator(&self) -> &Allocator {
        &self.allocator
    }

    /// Uploads a scene.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer exceeds the device's limits.
    pub fn upload(&self, scene: &PackedScene) -> Result<GpuScene, RenderError> {
        self.allocator.scene(scene)
    }

    /// Plants the tree over all casters in the light's own space that a job with [`Resolve::Light`] walks instead of shooting rays, and
    /// uploads it. One of each of the frame's lights is kept while that light stands still; whether a new one was planted. `packed` must be
    /// what `scene` was uploaded from: a scene that is uploaded anew has no trees.
    ///
    /// The work is the host's (`lt_irregular::LightBvh`, on all threads), and takes about as long as building the ray tracer's tree.
    ///
    /// # Errors
    /// [`RenderError::Unsupported`] for a scene of placed copies ([`crate::Packing::bakes_copies`]); [`RenderError::Gpu`] when a buffer
    /// exceeds the device's limits, or the tree the kernel's.
    pub fn plant_light_tree(
        &self,
        scene: &mut GpuScene,
        packed: &PackedScene,
        job: &FrameJob,
    ) -> Result<bool, RenderError> {
        light_space::check(packed, job)?;
        let (light, number) = (job.shadow.light.place, job.shadow.light.number as usize);
        if scene.light_trees.len() <= number {
            scene.light_trees.resize_with(number + 1, || None);
        }
        let place = &mut scene.light_trees[number];
        if place.as_ref().is_some_and(|tree| tree.light == light) {
            return Ok(false);
        }
        let tree = light_space::tree(packed, light).pack(light_space::casters(packed));
        let tree = tree.map_err(|e| self.allocator.error(format!("{e}: leave `:light` out")))?;
        *place = Some(self.allocator.light_tree(light, &tree)?);
        Ok(true)
    }

    /// Buffers for a view of this many pixels.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer exceeds the device's limits.
    pub fn frame_buffers(&self, size: UVec2) -> Result<FrameBuffers, RenderError> {
        self.allocator.frame(size)
    }

    /// Makes the map and list that a job needs, keeping those of the last frame where they fit, and drops those that it
    /// does not need. Histories and marks turn over: once a frame for each of its jobs.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when they exceed the device's limits.
    pub fn prepare(&self, frame: &mut FrameBuffers, job: &FrameJob) -> Result<(), RenderError> {
        let size = frame.size;
        if frame.slots.len() <= job.slot {
            frame.slots.resize_with(job.slot + 1, SlotBuffers::default);
        }
        let slot = &mut frame.slots[job.slot];
        let (is_prefiltered, has_marks) = (job.plan.is_prefiltered(), job.plan.has_marks());
        match &job.map {
            None => slot.map = None,
            Some(map) => {
                let (map_size, levels) = (map.map_size(), map.levels.len() as u32);
                let fits = |m: &MapBuffers| {
                    (m.size, m.levels) == (map_size, levels)
                        && (m.vectors.is_some(), m.marks.is_some()) == (is_prefiltered, has_marks)
                };
                let maps = match slot.map.take().filter(fits) {
                    Some(maps) => maps,
                    None => self.allocator.map(map_size, levels, (is_prefiltered, has_marks))?,
                };
                let has_room = |rows: &wgpu::Buffer| rows.size() >= maps.texels() * VECTOR_BYTES;
                if is_prefiltered && !frame.blurred_rows.as_ref().is_some_and(has_room) {
                    frame.blurred_rows = Some(self.allocator.blurred_rows(maps.texels())?);
                }
                let maps = slot.map.insert(maps);
                maps.marks.iter_mut().for_each(MarkBuffers::turn);
                if map.keeps_still {
                    let still = maps.still.get_or_insert_with(|| self.allocator.still_maps(map_size, levels));
                    map.draws.iter().for_each(|level| still.is_drawn[*level as usize] = true);
                }
            }
        }
        // The slot of the first light was prepared before this one's.
        let slot = &mut frame.slots[job.history_slot];
        let light = &job.shadow.light;
        match job.plan.mask {
            None => slot.history = None,
            Some(effects) => {
                let wanted = (light.mask_words, effects.depth_test);
                let fits = |h: &HistoryBuffers| (h.words, h.depths.is_some()) == wanted;
                match slot.history.as_mut().filter(|h| fits(h)) {
                    Some(history) if light.number == 0 => history.current = 1 - history.current,
                    Some(_) => {}
                    None => slot.history = Some(self.allocator.history(size, wanted.0, wanted.1)?),
                }
            }
        }
        match job.plan.tint {
            false => frame.tints = None,
            true if frame.tints.is_none() => frame.tints = Some(self.allocator.tints(size)?),
            true => {}
        }
        match job.plan.doubt_list {
            false => frame.doubt = None,
            true if frame.doubt.is_none() => frame.doubt = Some(self.allocator.doubt(size)?),
            true => {}
        }
        Ok(())
    }

    /// Records one pass of a job; [`Recorder::prepare`] comes first.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a uniform cannot be made, or the frame was not prepared for this job.
    pub fn pass(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &FrameBuffers,
        kind: PassKind,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        self.pass_timed(encoder, scene, frame, kind, job).map(|_| ())
    }

    /// [`Recorder::pass`]; what of the host's time is the pass's own work and not that of recording it.
    pub(super) fn pass_timed(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &FrameBuffers,
        kind: PassKind,
        job: &FrameJob,
    ) -> Result<Duration, RenderError> {
        match kind {
            PassKind::Camera => Ok(()),
            PassKind::DepthMap => return self.depth_map(encoder, scene, frame, job),
            PassKind::FilterX | PassKind::FilterY => self.filter(encoder, frame, kind, job),
            PassKind::Evaluate => self.evaluate(encoder, frame, job),
            PassKind::Mask => self.mask(encoder, frame, job),
            // The host's work: see `plant_light_tree`; building anew is refused before a frame begins.
            PassKind::Build | PassKind::LightTree => Ok(()),
            PassKind::Resolve => self.resolve(encoder, scene, frame, job),
            PassKind::Tint => self.tint(encoder, scene, frame, job),
        }
        .map(|()| Duration::ZERO)
    }

    fn unprepared(&self) -> RenderError {
        self.allocator
            .error("the frame was not prepared for this job: call Recorder::prepare first".to_owned())
    }

    fn slot<'a>(&self, frame: &'a FrameBuffers, job: &FrameJob) -> Result<&'a SlotBuffers, RenderError> {
        frame.slots.get(job.slot).ok_or_else(|| self.unprepared())
    }

    /// The history of all lights; none without a mask.
    fn history<'a>(
        &self,
        frame: &'a FrameBuffers,
        job: &FrameJob,
    ) -> Result<Option<&'a HistoryBuffers>, RenderError> {
        frame.slots.get(job.history_slot).map(|s| s.history.as_ref()).ok_or_else(|| self.unprepared())
    }

    fn filter(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBuffers,
        kind: PassKind,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let slot = self.slot(frame, job)?;
        let (Some(map), Some(map_job), Some((test, _))) = (&slot.map, &job.map, job.plan.map) else {
            return Err(self.unprepared());
        };
        let (Some(rows), Some(vectors)) = (&frame.blurred_rows, &map.vectors) else {
            return Err(self.unprepared());
        };
        let uniform = self.allocator.filled("filter", &[map_job.filter], Usage::UNIFORM)?;
        for level in map_job.drawn() {
            let name = match kind {
                PassKind::FilterX => format!("filter_x_{}_cs", test.id().replace('-', "_")),
                _ => "filter_y_cs".to_owned(),
            };
            let vectors_of = |buffer| map.part(buffer, level, VECTOR_BYTES);
            let (from, to) = match kind {
                PassKind::FilterX => (map.part(&map.depths, level, DEPTH_BYTES), vectors_of(rows)),
                _ => (vectors_of(rows), vectors_of(vectors)),
            };
            let resources = [uniform.as_entire_binding(), from, to];
            self.dispatch_resources(encoder, &name, &resources, grid(UVec2::splat(map.size)))?;
        }
        Ok(())
    }

    fn evaluate(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let slot = self.slot(frame, job)?;
        let (Some(map), Some((test, source))) = (&slot.map, job.plan.map) else {
            return Err(self.unprepared());
        };
        let uniform = self.allocator.filled("shadow", &[job.shadow], Usage::UNIFORM)?;
        let is_listed = job.plan.doubt_list && job.plan.mask.is_none();
        let doubt_word = match (is_listed, job.plan.mask) {
            (true, _) => "ltt_",
            (false, Some(_)) => "lt_",
            (false, None) => "",
        };
        let test = test.id().replace('-', "_");
        let (texels, suffix) = match (source, &map.vectors) {
            (MapSource::Prefiltered, Some(vectors)) => (vectors, "_prefiltered"),
            _ => (&map.depths, ""),
        };
        let mut bindings = vec![&uniform, &frame.samples, texels, &frame.visibility];
        if is_listed {
            let doubt = frame.doubt.as_ref().ok_or_else(|| self.unprepared())?;
            encoder.clear_buffer(&doubt.list, 0, Some(16));
            bindings.push(&doubt.list);
        }
        let marks = if job.plan.has_marks() { "_marks" } else { "" };
        bindings.extend(map.marks.as_ref().map(MarkBuffers::read));
        let levels = self.levels(job)?;
        bindings.extend(&levels);
        let search = if levels.is_some() { "_levels" } else { "" };
        let name = format!("evaluate_{doubt_word}{test}{suffix}{search}{marks}_cs");
        self.dispatch(encoder, &name, &bindings, grid(frame.size))
    }

    /// The levels that pixels search, where they do.
    fn levels(&self, job: &FrameJob) -> Result<Option<wgpu::Buffer>, RenderError> {
        let levels = job.searched_levels();
        levels.map(|levels| self.allocator.filled("levels", &levels, Usage::STORAGE)).transpose()
    }

    fn resolve(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let uniform = self.allocator.filled("shadow", &[job.shadow], Usage::UNIFORM)?;
        let history = self.history(frame, job)?;
        let mut name = match (job.plan.trace_all, history) {
            (true, _) => "resolve_all",
            (false, Some(_)) => "resolve_learn",
            (false, None) => "resolve_list",
        }
        .to_owned();
        let mut bindings = vec![&uniform, &frame.samples, &scene.nodes, &scene.triangles, &frame.visibility];
        let doubt = frame.doubt.as_ref();
        if !job.plan.trace_all {
            bindings.push(&doubt.ok_or_else(|| self.unprepared())?.list);
            bindings.extend(history.map(|h| &h.bits[h.current]));
        }
        match (job.plan.resolve, &scene.instances) {
            (Resolve::Light, _) => {
                let trees = scene.light_trees.get(job.shadow.light.number as usize);
                let tree = trees.and_then(Option::as_ref).filter(|t| t.light == job.shadow.light.place);
                let tree = tree.ok_or_else(|| {
                    let problem = "no tree was planted for this light: call Recorder::plant_light_tree first";
                    self.allocator.error(problem.to_owned())
                })?;
                name += "_light";
                bindings.extend([&tree.rows, &tree.space]);
            }
            (_, Some(instances)) if job.plan.instances => {
                name += "_instanced";
                bindings.push(instances);
            }
            _ => {}
        }
        if let (true, Some(alpha_texels)) = (job.plan.alpha_test, &scene.alpha_texels) {
            name += "_alpha";
            bindings.extend([&scene.vertices, &scene.materials, alpha_texels]);
        }
        name += "_cs";
        match doubt {
            Some(doubt) if !job.plan.trace_all => {
                self.dispatch(encoder, "doubt_dispatch_cs", &[&doubt.list], Groups::Fixed(1, 1))?;
                encoder.copy_buffer_to_buffer(&doubt.list, 0, &doubt.dispatch, 0, 16);
                self.dispatch(encoder, &name, &bindings, Groups::Indirect(&doubt.dispatch))?;
                self.mark(encoder, frame, job)
            }
            _ => self.dispatch(encoder, &name, &bindings, grid(frame.size)),
        }
    }

    fn tint(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let (Some([nodes, triangles]), Some(tints)) = (&scene.translucent, &frame.tints) else {
            return Err(self.unprepared());
        };
        let uniform = self.allocator.filled("shadow", &[job.shadow], Usage::UNIFORM)?;
        // Surfaces without a texture do not look at the texels; a binding must exist all the same.
        let no_texels = self.allocator.filled::<u32>("no texels", &[], Usage::STORAGE)?;
        let alpha_texels = scene.alpha_texels.as_ref().unwrap_or(&no_texels);
        let color_texels = scene.color_texels.as_ref().unwrap_or(&no_texels);
        let bindings = [
            &uniform,
            &frame.samples,
            nodes,
            triangles,
            &frame.visibility,
            tints,
            &scene.vertices,
            &scene.materials,
            alpha_texels,
            color_texels,
        ];
        self.dispatch(encoder, "tint_cs", &bindings, grid(frame.size))
    }

    fn dispatch(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        name: &str,
        buffers: &[&wgpu::Buffer],
        groups: Groups<'_>,
    ) -> Result<(), RenderError> {
        let resources: Vec<_> = buffers.iter().map(|b| b.as_entire_binding()).collect();
        self.dispatch_resources(encoder, name, &resources, groups)
    }

    fn dispatch_resources(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        name: &str,
        resources: &[wgpu::BindingResource<'_>],
        groups: Groups<'_>,
    ) -> Result<(), RenderError> {
        let pipeline = self.compute_pipeline(name)?;
        let group = self.bind_group(&pipeline.get_bind_group_layout(0), resources);
        let mut pass = encoder
            .begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some(name), timestamp_writes: None });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        match groups {
            Groups::Fixed(x, y) => pass.dispatch_workgroups(x, y, 1),
            Groups::Indirect(buffer) => pass.dispatch_workgroups_indirect(buffer, 0),
        }
        Ok(())
    }

    fn bind_group(
        &self,
        layout: &wgpu::BindGroupLayout,
        resources: &[wgpu::BindingResource<'_>],
    ) -> wgpu::BindGroup {
        let entries: Vec<_> = resources
            .iter()
            .enumerate()
            .map(|(i, resource)| wgpu::BindGroupEntry { binding: i as u32, resource: resource.clone() })
            .collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
    }

    fn module(&self, name: &str) -> Result<&'static ShaderModule, RenderError> {
        ShaderModule::named(name).ok_or_else(|| {
            self.allocator.error(format!("no shader module `{name}`: run `cargo xtask build-shaders`"))
        })
    }

    fn compute_pipeline(&mut self, name: &str) -> Result<wgpu::ComputePipeline, RenderError> {
        if let Some(pipeline) = self.compute.get(name) {
            return Ok(pipeline.clone());
        }
        let module = self.module(name)?;
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: None,
            module: &module.load(&self.device),
            entry_point: Some(module.entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        self.compute.insert(name.to_owned(), pipeline.clone());
        Ok(pipeline)
    }
}

/// How many workgroups.
#[derive(Clone, Copy)]
enum Groups<'a> {
    Fixed(u32, u32),
    Indirect(&'a wgpu::Buffer),
}

/// Workgroups of 8×8 that cover a picture.
fn grid(size: UVec2) -> Groups<'static> {
    Groups::Fixed(size.x.div_ceil(8), size.y.div_ceil(8))
}
