//! Resolve pass: every light-facing pixel, the doubted ones of a list, or those and a memory of them; rays in
//! one tree, among instances or in the light's own space × alpha test.

use lt_bvh::{Instance, LightSpace, Node, Opaque, Triangle};
use lt_math::glam::{UVec3, UVec4};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::{Material, Sample, ShadowParams, Vertex},
    doubt::{COUNT, LIST_START, Listed, slot_of},
    evaluate::settle,
    geometry::{FlatGeometry, InstancedGeometry, LightGeometry},
    mask::{BitsPlace, learn},
    resolve::trace_visibility,
    surface::Coverage,
};

macro_rules! geometry {
    ($p:ident, $n:ident, $t:ident, $r:ident $rb:literal, $s:ident $sb:literal) => {
        LightGeometry { rows: $r, nodes: $n, triangles: $t, space: *$s }
    };
    ($p:ident, $n:ident, $t:ident, $i:ident $b:literal) => {
        InstancedGeometry { nodes: $n, triangles: $t, instances: $i, root: $p.root }
    };
    ($p:ident, $n:ident, $t:ident) => {
        FlatGeometry { nodes: $n, triangles: $t }
    };
}

macro_rules! any_hit {
    ($t:ident, $v:ident $bv:literal, $m:ident $bm:literal, $a:ident $ba:literal) => {
        Coverage {
            triangles: $t,
            vertices: $v,
            materials: $m,
            alpha_texels: $a,
            required_flags: Material::CASTS,
        }
    };
    ($t:ident) => {
        Opaque
    };
}

macro_rules! resolve_entries {
    ($all:ident, $list:ident, $learn:ident; instances: [$($i0:literal, $i1:literal, $i2:literal)?],
     light: [$($r0:literal $s0:literal, $r1:literal $s1:literal, $r2:literal $s2:literal)?],
     alpha: [$($v0:literal $m0:literal $a0:literal, $v1:literal $m1:literal $a1:literal,
        $v2:literal $m2:literal $a2:literal)?]) => {
        /// Traces every light-facing pixel.
        #[spirv(compute(threads(8, 8)))]
        pub fn $all(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] visibility: &mut [f32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $i0)] instances: &[Instance],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $r0)] rows: &[UVec4],
              #[spirv(uniform, descriptor_set = 0, binding = $s0)] space: &LightSpace,)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $v0)] vertices: &[Vertex],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $m0)] materials: &[Material],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $a0)] alpha_texels: &[u32],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let sample = samples[i];
                let (verdict, is_settled) = settle(&sample, &p.light);
                let geometry = geometry!(p, nodes, triangles $(, instances $i0)? $(, rows $r0, space $s0)?);
                let any_hit = any_hit!(triangles $(, vertices $v0, materials $m0, alpha_texels $a0)?);
                visibility[i] = if is_settled {
                    verdict.visibility
                } else {
                    trace_visibility(&sample, &p.light, geometry, any_hit)
                };
            }
        }

        /// Traces the listed pixels.
        #[spirv(compute(threads(64)))]
        pub fn $list(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] visibility: &mut [f32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] list: &[u32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $i1)] instances: &[Instance],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $r1)] rows: &[UVec4],
              #[spirv(uniform, descriptor_set = 0, binding = $s1)] space: &LightSpace,)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $v1)] vertices: &[Vertex],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $m1)] materials: &[Material],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $a1)] alpha_texels: &[u32],)?
        ) {
            let slot = slot_of(id);
            if slot < list[COUNT] {
                let i = Listed::from_word(list[(slot + LIST_START) as usize]).pixel as usize;
                let geometry = geometry!(p, nodes, triangles $(, instances $i1)? $(, rows $r1, space $s1)?);
                let any_hit = any_hit!(triangles $(, vertices $v1, materials $m1, alpha_texels $a1)?);
                visibility[i] = trace_visibility(&samples[i], &p.light, geometry, any_hit);
            }
        }

        /// Traces the listed pixels and remembers what the rays found.
        #[spirv(compute(threads(64)))]
        pub fn $learn(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] visibility: &mut [f32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] list: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] bits: &mut [u32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $i2)] instances: &[Instance],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $r2)] rows: &[UVec4],
              #[spirv(uniform, descriptor_set = 0, binding = $s2)] space: &LightSpace,)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $v2)] vertices: &[Vertex],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $m2)] materials: &[Material],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $a2)] alpha_texels: &[u32],)?
        ) {
            let slot = slot_of(id);
            if slot < list[COUNT] {
                let i = Listed::from_word(list[(slot + LIST_START) as usize]).pixel as usize;
                let geometry = geometry!(p, nodes, triangles $(, instances $i2)? $(, rows $r2, space $s2)?);
                let any_hit = any_hit!(triangles $(, vertices $v2, materials $m2, alpha_texels $a2)?);
                visibility[i] = trace_visibility(&samples[i], &p.light, geometry, any_hit);
                learn(bits, BitsPlace::of(&p.light), i as u32, visibility[i]);
            }
        }
    };
}

resolve_entries!(resolve_all_cs, resolve_list_cs, resolve_learn_cs; instances: [], light: [], alpha: []);
resolve_entries!(resolve_all_alpha_cs, resolve_list_alpha_cs, resolve_learn_alpha_cs;
    instances: [], light: [], alpha: [5 6 7, 6 7 8, 7 8 9]);
resolve_entries!(resolve_all_instanced_cs, resolve_list_instanced_cs, resolve_learn_instanced_cs;
    instances: [5, 6, 7], light: [], alpha: []);
resolve_entries!(resolve_all_instanced_alpha_cs, resolve_list_instanced_alpha_cs, resolve_learn_instanced_alpha_cs;
    instances: [5, 6, 7], light: [], alpha: [6 7 8, 7 8 9, 8 9 10]);
resolve_entries!(resolve_all_light_cs, resolve_list_light_cs, resolve_learn_light_cs;
    instances: [], light: [5 6, 6 7, 7 8], alpha: []);
resolve_entries!(resolve_all_light_alpha_cs, resolve_list_light_alpha_cs, resolve_learn_light_alpha_cs;
    instances: [], light: [5 6, 6 7, 7 8], alpha: [7 8 9, 8 9 10, 9 10 11]);
