//! The caller's textures in, the caller's texture out.

use lt_math::glam::{UVec3, Vec3Swizzles, Vec4};
use spirv_std::{Image, spirv};

use super::pixel_index;
use crate::{
    abi::{CameraParams, Sample},
    gbuffer::sample_from_texels,
};

/// Position and normal textures to visible samples.
#[spirv(compute(threads(8, 8)))]
pub fn gbuffer_import_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &CameraParams,
    #[spirv(descriptor_set = 0, binding = 1)] positions: &Image!(2D, type = f32, sampled, depth = false),
    #[spirv(descriptor_set = 0, binding = 2)] normals: &Image!(2D, type = f32, sampled, depth = false),
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] samples: &mut [Sample],
) {
    if let Some(i) = pixel_index(id, p.size) {
        let position: Vec4 = positions.fetch(id.xy());
        let normal: Vec4 = normals.fetch(id.xy());
        samples[i] = sample_from_texels(position, normal);
    }
}

/// Position, normal and last position textures to visible samples and where they were in the last frame.
#[spirv(compute(threads(8, 8)))]
pub fn gbuffer_import_motion_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &CameraParams,
    #[spirv(descriptor_set = 0, binding = 1)] positions: &Image!(2D, type = f32, sampled, depth = false),
    #[spirv(descriptor_set = 0, binding = 2)] normals: &Image!(2D, type = f32, sampled, depth = false),
    #[spirv(descriptor_set = 0, binding = 3)] last_positions: &Image!(
         2D,
         type = f32,
         sampled,
         depth = false
     ),
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] samples: &mut [Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] past: &mut [Vec4],
) {
    if let Some(i) = pixel_index(id, p.size) {
        let position: Vec4 = positions.fetch(id.xy());
        let normal: Vec4 = normals.fetch(id.xy());
        let last: Vec4 = last_positions.fetch(id.xy());
        samples[i] = sample_from_texels(position, normal);
        past[i] = last;
    }
}

/// Visibility to a texture.
#[spirv(compute(threads(8, 8)))]
pub fn visibility_export_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &CameraParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] visibility: &[f32],
    #[spirv(descriptor_set = 0, binding = 2)] target: &Image!(
        2D,
        format = r32f,
        sampled = false,
        depth = false
    ),
) {
    if let Some(i) = pixel_index(id, p.size) {
        // SAFETY: the pixel lies inside the picture, and the target has the picture's size.
        unsafe { target.write(id.xy(), visibility[i]) };
    }
}
