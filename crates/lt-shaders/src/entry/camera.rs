//! Camera pass: instances × alpha test × colour textures × object motion.

use lt_bvh::{Instance, Node, Opaque, Triangle};
use lt_math::glam::{UVec3, Vec3Swizzles, Vec4};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{CameraParams, Material, Sample, Vertex},
    camera::{ColorTextures, NoColorTextures, closest, previous_position, sample_at_hit},
    geometry::{FlatGeometry, InstancedGeometry},
    surface::Coverage,
};

macro_rules! camera_entry {
    ($name:ident; instances: [$($instances:literal)?], alpha: [$($alpha:literal)?], colors: [$($colors:literal)?],
     motion: [$($before:literal $past:literal)?]) => {
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
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $before)] before: &[Vec4],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $past)] past: &mut [Vec4],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let geometry = camera_entry!(@geometry p, nodes, triangles $(, instances $instances)?);
                let any_hit = camera_entry!(@any_hit triangles, vertices, materials $(, alpha_texels $alpha)?);
                let colors = camera_entry!(@colors $(color_texels $colors)?);
                let hit = closest(id.xy(), p, geometry, any_hit);
                samples[i] = sample_at_hit(&hit, p, geometry, vertices, materials, colors);
                $(past[i] = camera_entry!(@past hit, geometry, before $before).extend(1.0);)?
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
    (@past $hit:ident, $g:ident, $before:ident $b:literal) => { previous_position(&$hit, $g, $before) };
}

camera_entry!(camera_cs; instances: [], alpha: [], colors: [], motion: []);
camera_entry!(camera_color_cs; instances: [], alpha: [], colors: [6], motion: []);
camera_entry!(camera_alpha_cs; instances: [], alpha: [6], colors: [], motion: []);
camera_entry!(camera_alpha_color_cs; instances: [], alpha: [6], colors: [7], motion: []);
camera_entry!(camera_instanced_cs; instances: [6], alpha: [], colors: [], motion: []);
camera_entry!(camera_instanced_color_cs; instances: [6], alpha: [], colors: [7], motion: []);
camera_entry!(camera_instanced_alpha_cs; instances: [6], alpha: [7], colors: [], motion: []);
camera_entry!(camera_instanced_alpha_color_cs; instances: [6], alpha: [7], colors: [8], motion: []);
camera_entry!(camera_motion_cs; instances: [], alpha: [], colors: [], motion: [6 7]);
camera_entry!(camera_color_motion_cs; instances: [], alpha: [], colors: [6], motion: [7 8]);
camera_entry!(camera_alpha_motion_cs; instances: [], alpha: [6], colors: [], motion: [7 8]);
camera_entry!(camera_alpha_color_motion_cs; instances: [], alpha: [6], colors: [7], motion: [8 9]);
camera_entry!(camera_instanced_motion_cs; instances: [6], alpha: [], colors: [], motion: [7 8]);
camera_entry!(camera_instanced_color_motion_cs; instances: [6], alpha: [], colors: [7], motion: [8 9]);
camera_entry!(camera_instanced_alpha_motion_cs; instances: [6], alpha: [7], colors: [], motion: [8 9]);
camera_entry!(camera_instanced_alpha_color_motion_cs; instances: [6], alpha: [7], colors: [8], motion: [9 10]);
