//! The two passes before the mask pass: histories as words, and what the words around ask for.

use lt_math::glam::{UVec2, UVec3, UVec4, Vec3Swizzles};
use spirv_std::spirv;

use crate::{
    abi::MaskParams,
    neighbours::{hear, keep, row, row_words},
};

/// One invocation for 32 pixels of a row.
#[spirv(compute(threads(8, 8)))]
pub fn neighbours_row_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &MaskParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] bits: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &mut [UVec4],
) {
    if is_inside(id, p) {
        rows[(id.y * row_words(p.current.size.x) + id.x) as usize] = row(id.xy(), bits, p);
    }
}

/// One invocation for 32 pixels of a row.
#[spirv(compute(threads(8, 8)))]
pub fn neighbours_hear_cs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &MaskParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] rows: &[UVec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &mut [u32],
) {
    if is_inside(id, p) {
        keep(id.xy(), hear(id.xy(), rows, p), rows, p, words);
    }
}

fn is_inside(id: UVec3, p: &MaskParams) -> bool {
    let UVec2 { x, y } = p.current.size;
    id.x < row_words(x) && id.y < y
}
