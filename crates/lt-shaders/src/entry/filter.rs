//! Pre-filter: rows per shadow test, columns for all.

use lt_math::glam::{UVec2, UVec3, Vec3Swizzles, Vec4};
use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Vsm};
use spirv_std::spirv;

use super::pixel_index;
use crate::{
    abi::FilterParams,
    filter::{filter_x, filter_y},
};

macro_rules! filter_x_entry {
    ($($name:ident: $test:ty;)*) => {
        $(
            /// Rows: depths to blurred vectors.
            #[spirv(compute(threads(8, 8)))]
            pub fn $name(
                #[spirv(global_invocation_id)] id: UVec3,
                #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &FilterParams,
                #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] depths: &[f32],
                #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &mut [Vec4],
            ) {
                if let Some(i) = pixel_index(id, UVec2::splat(p.map_size)) {
                    rows[i] = filter_x::<$test>(id.xy(), p, depths);
                }
            }
        )*
    };
}

filter_x_entry! {
    filter_x_vsm_cs: Vsm;
    filter_x_esm_cs: Esm;
    filter_x_evsm_cs: Evsm;
    filter_x_msm_cs: MsmHamburger;
    filter_x_msm_hausdorff_cs: MsmHausdorff;
}

/// Columns.
#[spirv(compute(threads(8, 8)))]
pub fn filter_y_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &FilterParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] rows: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vectors: &mut [Vec4],
) {
    if let Some(i) = pixel_index(id, UVec2::splat(p.map_size)) {
        vectors[i] = filter_y(id.xy(), p, rows);
    }
}
