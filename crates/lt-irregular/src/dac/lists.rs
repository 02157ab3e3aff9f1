//! Lists of triangles' rectangles.

use super::rows::{SLACK, grow};
use crate::rect::Rect;
use crate::split::Item;
use alloc::vec::Vec;
use lt_bvh::lanes::Lanes;

/// Rectangles and the triangles that they belong to.
#[derive(Default)]
pub(super) struct Lists {
    pub x0: Vec<f32>,
    pub x1: Vec<f32>,
    pub y0: Vec<f32>,
    pub y1: Vec<f32>,
    pub z: Vec<f32>,
    pub ids: Vec<u32>,
}

impl Lists {
    /// Writes `len` triangles behind the first `at`; how many.
    #[inline(always)]
    pub fn append<'a>(&mut self, items: impl Iterator<Item = &'a Item>, len: usize, at: usize) -> usize {
        self.reserve(at + len);
        let rows = self.x0[at..].iter_mut().zip(&mut self.x1[at..]).zip(&mut self.y0[at..]);
        let rows = rows.zip(&mut self.y1[at..]).zip(&mut self.z[at..]).zip(&mut self.ids[at..]);
        for ((((((x0, x1), y0), y1), z), id), item) in rows.zip(items) {
            (*x0, *x1, *y0, *y1) = (item.rect.x0, item.rect.x1, item.rect.y0, item.rect.y1);
            (*z, *id) = (item.rect.z, item.triangle);
        }
        len
    }

    pub fn reserve(&mut self, end: usize) {
        if self.ids.len() < end + SLACK {
            let len = if self.ids.is_empty() { end } else { end + end / 2 } + SLACK;
            for row in [&mut self.x0, &mut self.x1, &mut self.y0, &mut self.y1, &mut self.z] {
                grow(row, len, 0.0);
            }
            grow(&mut self.ids, len, 0);
        }
    }

    /// Whether any of eight triangles may block points in `rect`.
    #[inline(always)]
    pub fn meet<E: Lanes>(&self, lanes: E, at: usize, rect: &Rect) -> bool {
        let mask = lanes.le(lanes.load(&self.x0[at..]), lanes.splat(rect.x1))
            & lanes.le(lanes.splat(rect.x0), lanes.load(&self.x1[at..]))
            & lanes.le(lanes.load(&self.y0[at..]), lanes.splat(rect.y1))
            & lanes.le(lanes.splat(rect.y0), lanes.load(&self.y1[at..]))
            & lanes.le(lanes.splat(rect.z), lanes.load(&self.z[at..]));
        mask != 0
    }

    /// Writes those triangles of `from`, or of this very list, that may block points in `rect`, of nearness from `rect.z` to `far`, to `to`; how
    /// many, and which of them covers the rectangle, beyond all points, with the largest nearness.
    #[inline(always)]
    pub fn take<P: Lanes>(
        &mut self,
        lanes: P,
        from: Option<&Lists>,
        (start, len): (usize, usize),
        bounds: &(Rect, f32),
        to: usize,
    ) -> (usize, Option<usize>) {
        self.reserve(to + len);
        let (rect, far) = bounds;
        let far = lanes.splat(*far);
        let mut best: Option<usize> = None;
        let (x0, x1) = (lanes.splat(rect.x0), lanes.splat(rect.x1));
        let (y0, y1) = (lanes.splat(rect.y0), lanes.splat(rect.y1));
        let near = lanes.splat(rect.z);
        let mut end = to;
        for at in (start..start + len).step_by(P::WIDTH) {
            let rows = from.unwrap_or(self);
            let (a0, a1) = (lanes.load(&rows.x0[at..]), lanes.load(&rows.x1[at..]));
            let (b0, b1) = (lanes.load(&rows.y0[at..]), lanes.load(&rows.y1[at..]));
            let z = lanes.load(&rows.z[at..]);
            let mut mask =
                lanes.le(a0, x1) & lanes.le(x0, a1) & lanes.le(b0, y1) & lanes.le(y0, b1) & lanes.le(near, z);
            let left = start + len - at;
            if left < P::WIDTH {
                mask &= (1 << left) - 1;
            }
            if mask != 0 {
                let mut ids = [0; 16];
                ids[..P::WIDTH].copy_from_slice(&rows.ids[at..at + P::WIDTH]);
                lanes.compress(mask, a0, &mut self.x0[end..]);
                lanes.compress(mask, a1, &mut self.x1[end..]);
                lanes.compress(mask, b0, &mut self.y0[end..]);
                lanes.compress(mask, b1, &mut self.y1[end..]);
                lanes.compress(mask, z, &mut self.z[end..]);
                lanes.compress_words(mask, &ids, &mut self.ids[end..]);
                let mut covers = lanes.le(a0, x0)
                    & lanes.le(x1, a1)
                    & lanes.le(b0, y0)
                    & lanes.le(y1, b1)
                    & lanes.lt(far, z);
                covers &= mask;
                while covers != 0 {
                    let i = end + (mask & ((1 << covers.trailing_zeros()) - 1)).count_ones() as usize;
                    covers &= covers - 1;
                    best = if best.is_none_or(|b| self.z[i] > self.z[b]) { Some(i) } else { best };
                }
                end += mask.count_ones() as usize;
            }
        }
        (end - to, best)
    }
}
