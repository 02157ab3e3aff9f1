//! Pictures of what the passes found: lights added up, then layers, then the mean over a pixel's samples.

use lt_math::glam::UVec2;
use lt_shaders::abi::ShadeParams;
use wgpu::BufferUsages as Usage;

use super::super::buffers::FrameBuffers;
use super::{Recorder, grid};
use crate::RenderError;

impl Recorder {
    /// Adds a light to what the frame's samples receive: after the passes of its job, when visibility, and tint if there is
    /// one, are the light's.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer cannot be made.
    pub fn add_light(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &mut FrameBuffers,
        p: &ShadeParams,
    ) -> Result<(), RenderError> {
        let uniform = self.allocator.filled("shade", &[*p], Usage::UNIFORM)?;
        // New buffers are zero.
        let light = match frame.light.take() {
            Some(light) => light,
            None => self.allocator.light(frame.size)?,
        };
        let mut bindings = vec![&uniform, &frame.samples, &frame.visibility, &light];
        bindings.extend(&frame.tints);
        let name = if frame.tints.is_some() { "light_tinted_cs" } else { "light_cs" };
        self.dispatch(encoder, name, &bindings, grid(frame.size))?;
        frame.light = Some(light);
        Ok(())
    }

    /// Adds the layer that is shown, with the lights added so far, to the samples' colours, and forgets the lights.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a buffer cannot be made, no light was added, or the camera sees no layers.
    pub fn add_layer(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &mut FrameBuffers,
        p: &ShadeParams,
    ) -> Result<(), RenderError> {
        let uniform = self.allocator.filled("shade", &[*p], Usage::UNIFORM)?;
        let light = frame.light.take().ok_or_else(|| self.unprepared())?;
        // New buffers are zero.
        let colors = match frame.colors.take() {
            Some(colors) => colors,
            None => self.allocator.light(frame.size)?,
        };
        let layer = frame.layers.get(frame.layer).ok_or_else(|| self.unprepared())?;
        let bindings = [&uniform, &layer.samples, &light, &layer.sights, &colors];
        self.dispatch(encoder, "layer_color_cs", &bindings, grid(frame.size))?;
        frame.colors = Some(colors);
        Ok(())
    }

    /// Shades the frame's samples with the lights, or the layers, added so far into `picture`, one sRGB word per pixel, the mean over its samples,
    /// and forgets them.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when a uniform cannot be made, or no light was added.
    pub fn shade(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &mut FrameBuffers,
        picture: &wgpu::Buffer,
        p: &ShadeParams,
    ) -> Result<(), RenderError> {
        let uniform = self.allocator.filled("shade", &[*p], Usage::UNIFORM)?;
        let pixels = p.camera.size / p.camera.grid;
        if let Some(colors) = frame.colors.take() {
            return self.dispatch(encoder, "color_mean_cs", &[&uniform, &colors, picture], grid(pixels));
        }
        let light = frame.light.take().ok_or_else(|| self.unprepared())?;
        let bindings = [&uniform, &frame.samples, &light, picture];
        let name = if p.camera.grid == UVec2::ONE { "shade_cs" } else { "shade_mean_cs" };
        self.dispatch(encoder, name, &bindings, grid(pixels))
    }
}
