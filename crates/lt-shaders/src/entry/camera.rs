//! Camera pass: instances × alpha test × colour textures.

use lt_bvh::{Instance, Node, Opaque, Triangle};
use lt_math::glam::{UVec3, Vec3Swizzles};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{CameraParams, Material, Sample, Vertex},
    camera::{ColorTextures, NoColorTextures, visible_sample},
    geometry::{FlatGeometry, InstancedGeometry},
    surface::Coverage,
};

macro_rules! camera_entry {
    ($name:ident; instances: [$($instances:literal)?], alpha: [$($alpha:literal)?], colors: [$($colors:literal)?]) => {
        /// Variant of the camera pass.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &CameraParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[Triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[Vertex],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] materials: &[Material],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] samples: &mut [Sample],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $instances)] instances: &[Instance],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $alpha)] alpha_texels: &[u32],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $colors)] color_texels: &[u32],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let geometry = camera_entry!(@geometry p, nodes, triangles $(, instances $instances)?);
                let any_hit = camera_entry!(@any_hit triangles, vertices, materials $(, alpha_texels $alpha)?);
                let colors = camera_entry!(@colors $(color_texels $colors)?);
                samples[i] = visible_sample(id.xy(), p, geometry, vertices, materials, any_hit, colors);
            }
        }
    };
    (@geometry $p:ident, $n:ident, $t:ident, $i:ident $b:literal) => {
        InstancedGeometry { nodes: $n, triangles: $t, instances: $i, root: $p.root }
    };
    (@geometry $p:ident, $n:ident, $t:ident) => { FlatGeometry { nodes: $n, triangles: $t } };
    (@any_hit $t:ident, $v:ident, $m:ident, $a:ident $b:literal) => {
        Coverage { triangles: $t, vertices: $v, materials: $m, alpha_texels: $a, required_flags: 0 }
    };
    (@any_hit $t:ident, $v:ident, $m:ident) => { Opaque };
    (@colors $c:ident $b:literal) => { ColorTextures { texels: $c } };
    (@colors) => { NoColorTextures };
}

camera_entry!(camera_cs; instances: [], alpha: [], colors: []);
camera_entry!(camera_color_cs; instances: [], alpha: [], colors: [6]);
camera_entry!(camera_alpha_cs; instances: [], alpha: [6], colors: []);
camera_entry!(camera_alpha_color_cs; instances: [], alpha: [6], colors: [7]);
camera_entry!(camera_instanced_cs; instances: [6], alpha: [], colors: []);
camera_entry!(camera_instanced_color_cs; instances: [6], alpha: [], colors: [7]);
camera_entry!(camera_instanced_alpha_cs; instances: [6], alpha: [7], colors: []);
camera_entry!(camera_instanced_alpha_color_cs; instances: [6], alpha: [7], colors: [8]);
