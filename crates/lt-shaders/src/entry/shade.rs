//! Shading passes: what each light gives, then the picture.

use lt_math::glam::{UVec3, Vec3, Vec3Swizzles, Vec4};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{Sample, ShadeParams, Sight},
    shade::{ColorRows, LitRows, layer_color, light_on, shade, shade_mean},
};

/// Adds one light to what pixels receive.
#[spirv(compute(threads(8, 8)))]
pub fn light_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] visibility: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] light: &mut [Vec4],
) {
    if let Some(i) = pixel_index(id, p.camera.size) {
        light[i] += light_on(&samples[i], Vec3::splat(visibility[i]), p).extend(0.0);
    }
}

/// Adds one light, tinted on its way.
#[spirv(compute(threads(8, 8)))]
pub fn light_tinted_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] visibility: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] light: &mut [Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] tints: &[Vec4],
) {
    if let Some(i) = pixel_index(id, p.camera.size) {
        light[i] += light_on(&samples[i], tints[i].truncate() * visibility[i], p).extend(0.0);
    }
}

/// One picture word per pixel of one sample.
#[spirv(compute(threads(8, 8)))]
pub fn shade_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] light: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] picture: &mut [u32],
) {
    if let Some(i) = pixel_index(id, p.camera.size) {
        picture[i] = shade(id.xy(), &samples[i], light[i].truncate(), p);
    }
}

/// One picture word per pixel of several samples.
#[spirv(compute(threads(8, 8)))]
pub fn shade_mean_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] light: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] picture: &mut [u32],
) {
    if let Some(i) = pixel_index(id, p.camera.size / p.camera.grid) {
        picture[i] = shade_mean(id.xy(), p.camera.grid, LitRows { samples, light, params: p });
    }
}

/// Adds one layer to the samples' colours.
#[spirv(compute(threads(8, 8)))]
pub fn layer_color_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] light: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] sights: &[Sight],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] colors: &mut [Vec4],
) {
    if let Some(i) = pixel_index(id, p.camera.size) {
        colors[i] += layer_color(id.xy(), &samples[i], &sights[i], light[i].truncate(), p).extend(0.0);
    }
}

/// One picture word per pixel, from finished colours.
#[spirv(compute(threads(8, 8)))]
pub fn color_mean_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadeParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] colors: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] picture: &mut [u32],
) {
    if let Some(i) = pixel_index(id, p.camera.size / p.camera.grid) {
        picture[i] = shade_mean(id.xy(), p.camera.grid, ColorRows { colors, width: p.camera.size.x });
    }
}
