//! Evaluate pass: every shadow test × gathered or pre-filtered × with or without the leak tracing test × one map or levels; for the mask
//! pass with or without marks.

use lt_math::glam::{UVec3, Vec4};
use lt_math::{Esm, Evsm, Levels, LightProjection, MsmHamburger, MsmHausdorff, OneLevel, Pcf, Sm, Vsm};
use spirv_std::arch::IndexUnchecked;
use spirv_std::spirv;

use super::{doubt::list_pixel, pixel_index};
use crate::{
    abi::{Sample, ShadowParams},
    doubt::Listed,
    evaluate::{FilteredVectors, GatheredDepths, Verdict, evaluate_levels},
    marks::{MarkedDepths, MarkedVectors},
};

macro_rules! levels {
    ($p:ident, $levels:ident $binding:literal) => {
        Levels { projections: $levels, count: $p.level_count }
    };
    ($p:ident) => {
        OneLevel { projection: $p.projection }
    };
}

macro_rules! map_entry {
    ($name:ident, $test:ty, $texel:ty, $source:expr $(, levels $levels:literal)?) => {
        /// The estimate alone.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] map: &[$texel],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] visibility: &mut [f32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $levels)] levels: &[LightProjection],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let levels = levels!(p $(, levels $levels)?);
                visibility[i] =
                    evaluate_levels::<$test, _, _, false>(&samples[i], p, $source(map), levels).visibility;
            }
        }
    };
}

macro_rules! ltt_entry {
    ($name:ident, $test:ty, $texel:ty, $source:expr $(, levels $levels:literal)?) => {
        /// Estimate and doubt; doubted pixels join the list.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] local: u32,
            #[spirv(workgroup)] shared: &mut [u32; 2],
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] map: &[$texel],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] visibility: &mut [f32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] list: &mut [u32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $levels)] levels: &[LightProjection],)?
        ) {
            let mut is_doubted = false;
            let mut index = 0;
            if let Some(i) = pixel_index(id, p.size) {
                // SAFETY: the host sizes `samples` and `visibility` to the picture, and i lies in it. A checked index
                // may leave the function before the list's barriers, which WebGPU's uniformity analysis forbids.
                let sample = unsafe { samples.index_unchecked(i) };
                let levels = levels!(p $(, levels $levels)?);
                let verdict: Verdict = evaluate_levels::<$test, _, _, true>(sample, p, $source(map), levels);
                // SAFETY: as above.
                unsafe { *visibility.index_unchecked_mut(i) = verdict.visibility };
                is_doubted = verdict.is_doubted;
                index = i as u32;
            }
            list_pixel(is_doubted, Listed { pixel: index, is_trusted: false }, local, shared, list);
        }
    };
}

macro_rules! judged_entry {
    ($name:ident, $test:ty, $texel:ty, $source:expr $(, marks $marks:literal)? $(, levels $levels:literal)?) => {
        /// Estimate and doubt in one number, for the mask pass.
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] map: &[$texel],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] visibility: &mut [f32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $marks)] marks: &[u32],)?
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $levels)] levels: &[LightProjection],)?
        ) {
            if let Some(i) = pixel_index(id, p.size) {
                let levels = levels!(p $(, levels $levels)?);
                let map = judged_entry!(@map $source, map $(, marks $marks)?);
                visibility[i] = evaluate_levels::<$test, _, _, true>(&samples[i], p, map, levels).visibility;
            }
        }
    };
    (@map $source:expr, $map:ident, $marks:ident $binding:literal) => {
        $source($map, $marks)
    };
    (@map $source:expr, $map:ident) => {
        $source($map)
    };
}

fn gathered(depths: &[f32]) -> GatheredDepths<'_> {
    GatheredDepths { depths }
}

fn filtered(vectors: &[Vec4]) -> FilteredVectors<'_> {
    FilteredVectors { vectors }
}

fn marked_depths<'a>(depths: &'a [f32], marks: &'a [u32]) -> MarkedDepths<'a> {
    MarkedDepths { depths, marks }
}

fn marked_vectors<'a>(vectors: &'a [Vec4], marks: &'a [u32]) -> MarkedVectors<'a> {
    MarkedVectors { vectors, marks }
}

macro_rules! filterable {
    ($($test:ty: $gather:ident $filtered:ident $ltt_gather:ident $ltt_filtered:ident
        $lt_gather:ident $lt_filtered:ident $marked_gather:ident $marked_filtered:ident
        $(, levels $level:literal $late_level:literal)?;)*) => {
        $(
            map_entry!($gather, $test, f32, gathered $(, levels $level)?);
            map_entry!($filtered, $test, Vec4, filtered $(, levels $level)?);
            ltt_entry!($ltt_gather, $test, f32, gathered $(, levels $late_level)?);
            ltt_entry!($ltt_filtered, $test, Vec4, filtered $(, levels $late_level)?);
            judged_entry!($lt_gather, $test, f32, gathered $(, levels $level)?);
            judged_entry!($lt_filtered, $test, Vec4, filtered $(, levels $level)?);
            judged_entry!($marked_gather, $test, f32, marked_depths, marks 4 $(, levels $late_level)?);
            judged_entry!($marked_filtered, $test, Vec4, marked_vectors, marks 4 $(, levels $late_level)?);
        )*
    };
}

map_entry!(evaluate_sm_cs, Sm, f32, gathered);
map_entry!(evaluate_sm_levels_cs, Sm, f32, gathered, levels 4);
map_entry!(evaluate_pcf_cs, Pcf, f32, gathered);
map_entry!(evaluate_pcf_levels_cs, Pcf, f32, gathered, levels 4);
filterable! {
    Vsm: evaluate_vsm_cs evaluate_vsm_prefiltered_cs
        evaluate_ltt_vsm_cs evaluate_ltt_vsm_prefiltered_cs
        evaluate_lt_vsm_cs evaluate_lt_vsm_prefiltered_cs
        evaluate_lt_vsm_marks_cs evaluate_lt_vsm_prefiltered_marks_cs;
    Vsm: evaluate_vsm_levels_cs evaluate_vsm_prefiltered_levels_cs
        evaluate_ltt_vsm_levels_cs evaluate_ltt_vsm_prefiltered_levels_cs
        evaluate_lt_vsm_levels_cs evaluate_lt_vsm_prefiltered_levels_cs
        evaluate_lt_vsm_levels_marks_cs evaluate_lt_vsm_prefiltered_levels_marks_cs, levels 4 5;
    Esm: evaluate_esm_cs evaluate_esm_prefiltered_cs
        evaluate_ltt_esm_cs evaluate_ltt_esm_prefiltered_cs
        evaluate_lt_esm_cs evaluate_lt_esm_prefiltered_cs
        evaluate_lt_esm_marks_cs evaluate_lt_esm_prefiltered_marks_cs;
    Esm: evaluate_esm_levels_cs evaluate_esm_prefiltered_levels_cs
        evaluate_ltt_esm_levels_cs evaluate_ltt_esm_prefiltered_levels_cs
        evaluate_lt_esm_levels_cs evaluate_lt_esm_prefiltered_levels_cs
        evaluate_lt_esm_levels_marks_cs evaluate_lt_esm_prefiltered_levels_marks_cs, levels 4 5;
    Evsm: evaluate_evsm_cs evaluate_evsm_prefiltered_cs
        evaluate_ltt_evsm_cs evaluate_ltt_evsm_prefiltered_cs
        evaluate_lt_evsm_cs evaluate_lt_evsm_prefiltered_cs
        evaluate_lt_evsm_marks_cs evaluate_lt_evsm_prefiltered_marks_cs;
    Evsm: evaluate_evsm_levels_cs evaluate_evsm_prefiltered_levels_cs
        evaluate_ltt_evsm_levels_cs evaluate_ltt_evsm_prefiltered_levels_cs
        evaluate_lt_evsm_levels_cs evaluate_lt_evsm_prefiltered_levels_cs
        evaluate_lt_evsm_levels_marks_cs evaluate_lt_evsm_prefiltered_levels_marks_cs, levels 4 5;
    MsmHamburger: evaluate_msm_cs evaluate_msm_prefiltered_cs
        evaluate_ltt_msm_cs evaluate_ltt_msm_prefiltered_cs
        evaluate_lt_msm_cs evaluate_lt_msm_prefiltered_cs
        evaluate_lt_msm_marks_cs evaluate_lt_msm_prefiltered_marks_cs;
    MsmHamburger: evaluate_msm_levels_cs evaluate_msm_prefiltered_levels_cs
        evaluate_ltt_msm_levels_cs evaluate_ltt_msm_prefiltered_levels_cs
        evaluate_lt_msm_levels_cs evaluate_lt_msm_prefiltered_levels_cs
        evaluate_lt_msm_levels_marks_cs evaluate_lt_msm_prefiltered_levels_marks_cs, levels 4 5;
    MsmHausdorff: evaluate_msm_hausdorff_cs evaluate_msm_hausdorff_prefiltered_cs
        evaluate_ltt_msm_hausdorff_cs evaluate_ltt_msm_hausdorff_prefiltered_cs
        evaluate_lt_msm_hausdorff_cs evaluate_lt_msm_hausdorff_prefiltered_cs
        evaluate_lt_msm_hausdorff_marks_cs evaluate_lt_msm_hausdorff_prefiltered_marks_cs;
    MsmHausdorff: evaluate_msm_hausdorff_levels_cs evaluate_msm_hausdorff_prefiltered_levels_cs
        evaluate_ltt_msm_hausdorff_levels_cs evaluate_ltt_msm_hausdorff_prefiltered_levels_cs
        evaluate_lt_msm_hausdorff_levels_cs evaluate_lt_msm_hausdorff_prefiltered_levels_cs
        evaluate_lt_msm_hausdorff_levels_marks_cs evaluate_lt_msm_hausdorff_prefiltered_levels_marks_cs, levels 4 5;
}
