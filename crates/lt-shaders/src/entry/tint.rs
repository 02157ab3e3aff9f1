//! Tint pass.

use lt_bvh::{Node, Triangle};
use lt_math::glam::{UVec3, Vec4};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{Material, Sample, ShadowParams, Vertex},
    resolve::trace_tint,
    surface::Translucence,
};

/// What translucent casters let through to every pixel that light reaches.
#[spirv(compute(threads(8, 8)))]
pub fn tint_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] visibility: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] tints: &mut [Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] vertices: &[Vertex],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] alpha_texels: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] color_texels: &[u32],
) {
    if let Some(i) = pixel_index(id, p.size) {
        let casters = Translucence { triangles, vertices, materials, alpha_texels, color_texels };
        tints[i] = trace_tint(&samples[i], &p.light, visibility[i], nodes, casters).extend(1.0);
    }
}
