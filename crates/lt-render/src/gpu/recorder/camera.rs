//! What the camera sees, traced or taken from the caller, and the visibility that goes back to the caller.

use lt_math::glam::UVec2;
use lt_shaders::abi::CameraParams;
use wgpu::BufferUsages as Usage;

use super::super::buffers::{FrameBuffers, GpuScene, LayerBuffers};
use super::{Recorder, grid};
use crate::{EffectPlan, RenderError};

/// What an engine has rasterised: float textures of the frame's size, read texel by texel.
#[derive(Clone, Copy, Debug)]
pub struct GBuffer<'a> {
    /// World positions; w: the largest absolute coordinate of the triangle's vertices, or 0 for the position's own. A position should lie on
    /// its triangle as exactly as f32 says: rays start some 8 units in the last place of w away from it.
    pub positions: &'a wgpu::TextureView,
    /// Unit geometric normals that face the camera, zero where nothing is visible; w: 0 where the surface receives shadows, anything else
    /// where it does not.
    pub normals: &'a wgpu::TextureView,
    /// World positions of the same points of surfaces in the last frame; `None` while nothing in the scene moves. Points that did not move
    /// have the very bits of `positions`.
    pub last_positions: Option<&'a wgpu::TextureView>,
}

impl Recorder {
    /// Traces primary rays into the frame's samples; where the plan has layers, into those of each, of which the first is shown.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer exceeds the device's limits.
    pub fn camera(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &mut FrameBuffers,
        p: &CameraParams,
        plan: &EffectPlan,
    ) -> Result<(), RenderError> {
        if plan.layers > 1 {
            return self.layers(encoder, scene, frame, p, plan);
        }
        self.keep_past(frame, plan.object_motion)?;
        let mut name = "camera".to_owned();
        let uniform = self.allocator.filled("camera", &[*p], Usage::UNIFORM)?;
        let mut bindings =
            vec![&uniform, &scene.nodes, &scene.triangles, &scene.vertices, &scene.materials, &frame.samples];
        let effects = [
            (plan.instances, "_instanced", &scene.instances),
            (plan.alpha_test, "_alpha", &scene.alpha_texels),
            (plan.color_textures, "_color", &scene.color_texels),
        ];
        for (is_on, suffix, buffer) in effects {
            if let (true, Some(buffer)) = (is_on, buffer) {
                name += suffix;
                bindings.push(buffer);
            }
        }
        if let (Some(before), Some(past)) = (&scene.previous_positions, &frame.past) {
            name += "_motion";
            bindings.extend([before, past]);
        }
        self.dispatch(encoder, &(name + "_cs"), &bindings, grid(frame.size))
    }

    /// Finds layer after layer of what the camera sees.
    fn layers(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        scene: &GpuScene,
        frame: &mut FrameBuffers,
        p: &CameraParams,
        plan: &EffectPlan,
    ) -> Result<(), RenderError> {
        let fits = |layer: &LayerBuffers| layer.past.is_some() == plan.object_motion;
        if frame.layers.len() != plan.layers as usize || !frame.layers.iter().all(fits) {
            let made = (0..plan.layers).map(|_| self.allocator.layer(frame.size, plan.object_motion));
            frame.layers = made.collect::<Result<_, _>>()?;
        }
        let sights = self.allocator.sights(frame.size)?;
        // Surfaces without a texture do not look at the texels; a binding must exist all the same.
        let no_texels = self.allocator.filled::<u32>("no texels", &[], Usage::STORAGE)?;
        let alpha_texels = scene.alpha_texels.as_ref().unwrap_or(&no_texels);
        let color_texels = scene.color_texels.as_ref().unwrap_or(&no_texels);
        for (i, layer) in frame.layers.iter().enumerate() {
            let p = CameraParams { layers_behind: plan.layers - 1 - i as u32, ..*p };
            let uniform = self.allocator.filled("layer", &[p], Usage::UNIFORM)?;
            encoder.copy_buffer_to_buffer(&sights, 0, &layer.sights, 0, sights.size());
            let mut bindings = vec![
                &uniform,
                &scene.nodes,
                &scene.triangles,
                &scene.vertices,
                &scene.materials,
                &layer.samples,
                alpha_texels,
                color_texels,
                &sights,
            ];
            let mut name = "layer_cs";
            if let (Some(before), Some(past)) = (&scene.previous_positions, &layer.past) {
                name = "layer_motion_cs";
                bindings.extend([before, past]);
            }
            self.dispatch(encoder, name, &bindings, grid(frame.size))?;
        }
        frame.show_layer(0);
        Ok(())
    }

    /// Turns the caller's own G-buffer into the frame's samples.
    ///
    /// A temporal mask takes a position to be seen at its pixel's centre by the job's camera. Where an engine shifts its pixels (TAA), its
    /// camera may leave the shift out: places in the last frame are then off by as much, less than a pixel.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer exceeds the device's limits.
    pub fn import_gbuffer(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &mut FrameBuffers,
        gbuffer: GBuffer<'_>,
    ) -> Result<(), RenderError> {
        self.keep_past(frame, gbuffer.last_positions.is_some())?;
        let uniform = self.size_uniform(frame.size)?;
        let textures = [Some(gbuffer.positions), Some(gbuffer.normals), gbuffer.last_positions];
        let mut resources = vec![uniform.as_entire_binding()];
        resources.extend(textures.into_iter().flatten().map(wgpu::BindingResource::TextureView));
        resources.push(frame.samples.as_entire_binding());
        resources.extend(frame.past.iter().map(wgpu::Buffer::as_entire_binding));
        let name = if frame.past.is_some() { "gbuffer_import_motion_cs" } else { "gbuffer_import_cs" };
        self.dispatch_resources(encoder, name, &resources, grid(frame.size))
    }

    /// Makes room for where samples were in the last frame, or gives it back.
    fn keep_past(&self, frame: &mut FrameBuffers, is_wanted: bool) -> Result<(), RenderError> {
        frame.past = match (is_wanted, frame.past.take()) {
            (false, _) => None,
            (true, Some(buffer)) => Some(buffer),
            (true, None) => Some(self.allocator.past(frame.size)?),
        };
        Ok(())
    }

    /// Writes the frame's visibility (1 lit, 0 blocked) into the caller's `R32Float` storage texture of the frame's
    /// size.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer exceeds the device's limits.
    pub fn export_visibility(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBuffers,
        target: &wgpu::TextureView,
    ) -> Result<(), RenderError> {
        let uniform = self.size_uniform(frame.size)?;
        let resources = [
            uniform.as_entire_binding(),
            frame.visibility.as_entire_binding(),
            wgpu::BindingResource::TextureView(target),
        ];
        self.dispatch_resources(encoder, "visibility_export_cs", &resources, grid(frame.size))
    }

    /// The export and import kernels read the size alone of their parameters.
    fn size_uniform(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let p = CameraParams { size, ..bytemuck::Zeroable::zeroed() };
        self.allocator.filled("size", &[p], Usage::UNIFORM)
    }
}
