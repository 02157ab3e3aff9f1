//! Memory that is read here and there: large pages where the system grants them on request.
//!
//! A ray through a million triangles touches a page per node, and a pixel's texels lie a page apart. Larger pages are found sooner.

use bytemuck::Zeroable;
use rayon::prelude::*;
#[cfg(target_os = "linux")]
use std::mem::MaybeUninit;
use std::vec::Vec;

/// Below this, in bytes, pages of ordinary size do.
#[cfg(target_os = "linux")]
const LARGE: usize = 4 << 20;

/// Bytes to which the system's allocator aligns unasked; up to there it has zeros that nobody has touched.
#[cfg(target_os = "linux")]
const PLAIN: usize = 16;

/// So many zeros, in large pages if they are many and the system has them. Untouched until written where `T` is aligned to 16 bytes at most, so that
/// threads that write pieces of it share the cost of paging it in. Growing it moves it to ordinary memory.
pub fn zeroed<T: Zeroable + Send>(len: usize) -> Vec<T> {
    #[cfg(target_os = "linux")]
    if size_of::<T>().saturating_mul(len) >= LARGE {
        return in_large_pages(len);
    }
    bytemuck::zeroed_vec(len)
}

/// What asks for more alignment than the allocator gives unasked, [`PLAIN`] bytes, is zeroed by hand, which pages it in: the request must come before.
#[cfg(target_os = "linux")]
fn in_large_pages<T: Zeroable + Send>(len: usize) -> Vec<T> {
    if align_of::<T>() <= PLAIN {
        let buffer: Vec<T> = bytemuck::zeroed_vec(len);
        ask_for_large_pages(buffer.as_ptr(), len);
        return buffer;
    }
    let mut buffer: Vec<T> = Vec::with_capacity(len);
    ask_for_large_pages(buffer.as_ptr(), len);
    let room = &mut buffer.spare_capacity_mut()[..len];
    room.par_chunks_mut(1 << 12).for_each(|room| room.fill_with(|| MaybeUninit::new(T::zeroed())));
    // SAFETY: all `len` of them have just been written.
    unsafe { buffer.set_len(len) };
    buffer
}

/// `of` every index below `len`, computed by all threads, in such memory.
pub(crate) fn filled<T: Zeroable + Send>(len: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut all = zeroed(len);
    all.par_iter_mut().with_min_len(1 << 12).enumerate().for_each(|(i, to)| *to = of(i));
    all
}

#[cfg(target_os = "linux")]
fn ask_for_large_pages<T>(buffer: *const T, len: usize) {
    const PAGE: usize = 2 << 20;
    let begin = buffer as usize;
    let end = begin + len * size_of::<T>();
    let (begin, end) = (begin.next_multiple_of(PAGE), end & !(PAGE - 1));
    if begin < end {
        // SAFETY: the range lies within the buffer's own memory, and the advice changes how that is paged, not what
        // it holds. A refusal costs nothing but speed.
        unsafe { libc::madvise(begin as *mut libc::c_void, end - begin, libc::MADV_HUGEPAGE) };
    }
}
