//! Turns the number of doubted pixels into the size of the indirect dispatch.

use lt_math::glam::UVec3;
use spirv_std::spirv;

use crate::doubt::{COUNT, workgroups_for};

/// One invocation.
#[spirv(compute(threads(1)))]
pub fn doubt_dispatch_cs(
    #[spirv(global_invocation_id)] _id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] list: &mut [u32],
) {
    let groups = workgroups_for(list[COUNT]);
    list[0] = groups.x;
    list[1] = groups.y;
    list[2] = 1;
}
