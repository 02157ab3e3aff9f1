//! The doubt list: which pixels a ray must answer, compacted on the GPU.
//!
//! Layout in words: three workgroup counts for the indirect dispatch, the number of listed pixels, then the pixels'
//! indices in no particular order. The CPU backend collects the same pixels tile by tile instead.

/// First word of the list proper.
pub const LIST_START: u32 = 4;
/// Word that counts the listed pixels.
pub const COUNT: usize = 3;
/// Pixels one workgroup of the resolve pass takes.
pub const RESOLVE_WORKGROUP: u32 = 64;

/// Words of a list that can hold every pixel.
pub const fn list_words(pixels: u32) -> u32 {
    LIST_START + pixels
}

/// Workgroups that cover `count` listed pixels.
pub fn workgroups_for(count: u32) -> u32 {
    count.div_ceil(RESOLVE_WORKGROUP)
}
