//! Mask pass: motion (none, camera, objects too) × temporal depth test × rules (ER and RR, ER, RR).

use lt_math::glam::{UVec3, Vec3, Vec3Swizzles, Vec4, Vec4Swizzles};
use spirv_std::arch::IndexUnchecked;
use spirv_std::spirv;

use super::{doubt::list_pixel, pixel_index};
use crate::{
    abi::{MaskParams, Sample},
    doubt::Listed,
    mask::{BitsPlace, DepthHistory, mask, seen_depth},
    neighbours::{Heard, row_words},
};

macro_rules! mask_entry {
    ($name:ident; motion: $motion:literal, depth: $depth:literal [$($last_d:literal $new_d:literal)?],
     past: [$($past:literal)?], rules: $er:literal $rr:literal) => {
        /// Variant of the mask pass; pixels that need a ray join the list.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] local: u32,
            #[spirv(workgroup)] shared: &mut [u32; 2],
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &MaskParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] heard: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bits: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] visibility: &mut [f32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] list: &mut [u32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $last_d)] last_depths: &[f32],
              #[spirv(storage_buffer, descriptor_set = 0, binding = $new_d)] depths: &mut [f32],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $past)] past: &[Vec4],)?
        ) {
            let mut needs_ray = false;
            let mut listed = Listed { pixel: 0, is_trusted: false };
            if let Some(i) = pixel_index(id, p.current.size) {
                let history = mask_entry!(@history heard, p $(, last_depths $last_d)?);
                // SAFETY: the host sizes every buffer to the picture, and i lies in it. A checked index may leave the
                // function before the list's barriers, which WebGPU's uniformity analysis forbids.
                unsafe {
                    let sample = samples.index_unchecked(i);
                    let past_world: Vec3 = mask_entry!(@past sample, i $(, past $past)?);
                    let estimate = *visibility.index_unchecked(i);
                    let masked = mask::<_, $motion, $depth, $er, $rr>(
                        id.xy(), sample, past_world, estimate, p, history,
                    );
                    *visibility.index_unchecked_mut(i) = masked.visibility;
                    let place = BitsPlace::of(&p.light);
                    let at = place.word(i as u32);
                    *bits.index_unchecked_mut(at) = place.light.write(*bits.index_unchecked(at), masked.bits);
                    if place.light.straddles() {
                        let rest = place.light.write_rest(*bits.index_unchecked(at + 1), masked.bits);
                        *bits.index_unchecked_mut(at + 1) = rest;
                    }
                    $(mask_entry!(@keep depths $new_d, i, sample, p);)?
                    needs_ray = masked.needs_ray;
                    listed = Listed { pixel: i as u32, is_trusted: masked.is_trusted };
                }
            }
            list_pixel(needs_ray, listed, local, shared, list);
        }
    };
    (@history $heard:ident, $p:ident, $depths:ident $b:literal) => {
        DepthHistory { words: $heard, depths: $depths, width: $p.current.size.x }
    };
    (@history $heard:ident, $p:ident) => {
        Heard { words: $heard, columns: row_words($p.current.size.x) }
    };
    (@past $sample:ident, $i:ident, $past:ident $b:literal) => { $past.index_unchecked($i).xyz() };
    (@past $sample:ident, $i:ident) => { $sample.position };
    (@keep $depths:ident $b:literal, $i:ident, $sample:ident, $p:ident) => {
        *$depths.index_unchecked_mut($i) = seen_depth($sample, &$p.current)
    };
}

mask_entry!(mask_cs;
    motion: false, depth: false [], past: [], rules: true true);
mask_entry!(mask_er_cs;
    motion: false, depth: false [], past: [], rules: true false);
mask_entry!(mask_rr_cs;
    motion: false, depth: false [], past: [], rules: false true);
mask_entry!(mask_depth_cs;
    motion: false, depth: true [6 7], past: [], rules: true true);
mask_entry!(mask_depth_er_cs;
    motion: false, depth: true [6 7], past: [], rules: true false);
mask_entry!(mask_depth_rr_cs;
    motion: false, depth: true [6 7], past: [], rules: false true);
mask_entry!(mask_motion_cs;
    motion: true, depth: false [], past: [], rules: true true);
mask_entry!(mask_motion_er_cs;
    motion: true, depth: false [], past: [], rules: true false);
mask_entry!(mask_motion_rr_cs;
    motion: true, depth: false [], past: [], rules: false true);
mask_entry!(mask_motion_depth_cs;
    motion: true, depth: true [6 7], past: [], rules: true true);
mask_entry!(mask_motion_depth_er_cs;
    motion: true, depth: true [6 7], past: [], rules: true false);
mask_entry!(mask_motion_depth_rr_cs;
    motion: true, depth: true [6 7], past: [], rules: false true);
mask_entry!(mask_objects_cs;
    motion: true, depth: false [], past: [6], rules: true true);
mask_entry!(mask_objects_er_cs;
    motion: true, depth: false [], past: [6], rules: true false);
mask_entry!(mask_objects_rr_cs;
    motion: true, depth: false [], past: [6], rules: false true);
mask_entry!(mask_objects_depth_cs;
    motion: true, depth: true [6 7], past: [8], rules: true true);
mask_entry!(mask_objects_depth_er_cs;
    motion: true, depth: true [6 7], past: [8], rules: true false);
mask_entry!(mask_objects_depth_rr_cs;
    motion: true, depth: true [6 7], past: [8], rules: false true);
