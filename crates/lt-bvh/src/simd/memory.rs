//! Memory that is read here and there: large pages where the system grants them on request.
//!
//! A ray through a million triangles touches a page per node, and a pixel's texels lie a page apart. Larger pages are found sooner.

use bytemuck::Zeroable;
use rayon::prelude::*;
use std::vec::Vec;

/// Below this, in bytes, pages of ordinary size do.
#[cfg(target_os = "linux")]
const LARGE: usize = 4 << 20;

/// So many zeros, in large pages if they are many and the system has them. Untouched until written, so that threads that
/// write pieces of it share the cost of paging it in. Growing it moves it to ordinary memory.
pub fn zeroed<T: Zeroable>(len: usize) -> Vec<T> {
    let buffer = bytemuck::zeroed_vec(len);
    #[cfg(target_os = "linux")]
    if size_of::<T>() * len >= LARGE {
        ask_for_large_pages(&buffer);
    }
    buffer
}

/// `of` every index below `len`, computed by all threads, in such memory.
pub(crate) fn filled<T: Zeroable + Send>(len: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut all = zeroed(len);
    all.par_iter_mut().with_min_len(1 << 12).enumerate().for_each(|(i, to)| *to = of(i));
    all
}

#[cfg(target_os = "linux")]
fn ask_for_large_pages<T>(buffer: &Vec<T>) {
    const PAGE: usize = 2 << 20;
    let begin = buffer.as_ptr() as usize;
    let end = begin + buffer.capacity() * size_of::<T>();
    let (begin, end) = (begin.next_multiple_of(PAGE), end & !(PAGE - 1));
    if begin < end {
        // SAFETY: the range lies within the buffer's own memory, and the advice changes how that is paged, not what
        // it holds. A refusal costs nothing but speed.
        unsafe { libc::madvise(begin as *mut libc::c_void, end - begin, libc::MADV_HUGEPAGE) };
    }
}
