//! Layer pass: the next surface along every primary ray, with object motion or without.

use lt_bvh::{Node, Triangle};
use lt_math::glam::{UVec3, Vec3Swizzles, Vec4};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{CameraParams, Material, Sample, Sight, Vertex},
    camera::previous_position,
    geometry::FlatGeometry,
    layers::{Surfaces, layer_at_hit, next_hit},
    surface::Coverage,
};

macro_rules! layer_entry {
    ($name:ident; motion: [$($before:literal $past:literal)?]) => {
        /// Variant of the layer pass.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &CameraParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[Triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[Vertex],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] materials: &[Material],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] samples: &mut [Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] alpha_texels: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] color_texels: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] sights: &mut [Sight],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $before)] before: &[Vec4],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $past)] past: &mut [Vec4],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let geometry = FlatGeometry { nodes, triangles };
                let covers = Coverage { triangles, vertices, materials, alpha_texels, required_flags: 0 };
                let sight = sights[i];
                let hit = next_hit(id.xy(), p, &sight, geometry, covers);
                let surfaces = Surfaces { vertices, materials, alpha_texels, color_texels };
                let (sample, beyond) = layer_at_hit(&hit, p, &sight, geometry, surfaces);
                samples[i] = sample;
                sights[i] = beyond;
                $(past[i] = layer_entry!(@past hit, geometry, before $before).extend(1.0);)?
            }
        }
    };
    (@past $hit:ident, $g:ident, $before:ident $b:literal) => { previous_position(&$hit, $g, $before) };
}

layer_entry!(layer_cs; motion: []);
layer_entry!(layer_motion_cs; motion: [9 10]);
