//! The doubt list: pixels join it, and its length becomes the size of the indirect dispatch.

use lt_math::glam::UVec3;
use spirv_std::arch::{IndexUnchecked, atomic_i_add, workgroup_memory_barrier_with_group_sync};
use spirv_std::memory::{Scope, Semantics};
use spirv_std::spirv;

use crate::doubt::{COUNT, LIST_START, Listed, workgroups_for};

/// Appends the doubted pixels of a workgroup to the list, with one atomic on it per workgroup. Every invocation of the
/// group calls this once, in uniform control flow.
///
/// The CPU backend collects its list per tile instead of in workgroup memory.
#[inline(always)]
pub fn list_pixel(is_doubted: bool, listed: Listed, local: u32, shared: &mut [u32; 2], list: &mut [u32]) {
    if local == 0 {
        shared[0] = 0;
    }
    workgroup_memory_barrier_with_group_sync();
    let mut slot = 0;
    if is_doubted {
        // SAFETY: an atomic on workgroup memory that every invocation of the group shares.
        slot = unsafe {
            atomic_i_add::<u32, { Scope::Workgroup as u32 }, { Semantics::NONE.bits() }>(&mut shared[0], 1)
        };
    }
    workgroup_memory_barrier_with_group_sync();
    if local == 0 {
        // SAFETY: an atomic on the list's counter, word COUNT, which the host always allocates.
        shared[1] = unsafe {
            atomic_i_add::<u32, { Scope::Device as u32 }, { Semantics::NONE.bits() }>(
                list.index_unchecked_mut(COUNT),
                shared[0],
            )
        };
    }
    workgroup_memory_barrier_with_group_sync();
    if is_doubted {
        // SAFETY: the list holds LIST_START words and one for every pixel.
        unsafe { *list.index_unchecked_mut((LIST_START + shared[1] + slot) as usize) = listed.to_word() };
    }
}

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
