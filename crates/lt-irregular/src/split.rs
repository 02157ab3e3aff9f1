//! Where to cut a set of rectangles in two: the surface-area heuristic over bins (Wald 2007), with area measured in the light's plane.
//!
//! A point meets a rectangle with the probability of its area, so no other measure is right here; and work comes in blocks of eight
//! triangles, so sides are counted in blocks.

use crate::block::BLOCK;
use crate::rect::Rect;

/// A triangle on its way into a tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item {
    pub rect: Rect,
    pub triangle: u32,
}

/// Bins per axis.
const BINS: usize = 16;

#[derive(Clone, Copy)]
struct Bin {
    rect: Rect,
    count: usize,
}

const NO_BIN: Bin = Bin { rect: Rect::EMPTY, count: 0 };

/// Twice the centre of an item along x or y.
#[inline(always)]
fn centre(item: &Item, axis: usize) -> f32 {
    if axis == 0 { item.rect.x0 + item.rect.x1 } else { item.rect.y0 + item.rect.y1 }
}

#[inline(always)]
fn bin_of(centre: f32, low: f32, scale: f32) -> usize {
    (((centre - low) * scale) as usize).min(BINS - 1)
}

/// Reorders at least two items so that the first part and the rest make good children; the length of the first part, which
/// neither takes all nor none.
pub(crate) fn split(items: &mut [Item]) -> usize {
    let mut best: Option<(f32, usize, f32, f32, usize)> = None;
    let mut low = [f32::INFINITY; 2];
    let mut high = [f32::NEG_INFINITY; 2];
    for item in items.iter() {
        for axis in 0..2 {
            let c = centre(item, axis);
            low[axis] = if c < low[axis] { c } else { low[axis] };
            high[axis] = if c > high[axis] { c } else { high[axis] };
        }
    }
    let scale: [f32; 2] = core::array::from_fn(|axis| BINS as f32 / (high[axis] - low[axis]));
    let is_wide: [bool; 2] = core::array::from_fn(|axis| high[axis] > low[axis] && scale[axis].is_finite());
    let mut bins = [[NO_BIN; BINS]; 2];
    for item in items.iter() {
        for axis in 0..2 {
            if is_wide[axis] {
                let bin = &mut bins[axis][bin_of(centre(item, axis), low[axis], scale[axis])];
                bin.rect = bin.rect.union(&item.rect);
                bin.count += 1;
            }
        }
    }
    for axis in (0..2).filter(|&axis| is_wide[axis]) {
        let bins = &bins[axis];
        let mut right = [0.0; BINS];
        let (mut rect, mut count) = (Rect::EMPTY, 0);
        for i in (1..BINS).rev() {
            rect = rect.union(&bins[i].rect);
            count += bins[i].count;
            right[i] = rect.area() * count.div_ceil(BLOCK) as f32;
        }
        let (mut rect, mut count) = (Rect::EMPTY, 0);
        for i in 1..BINS {
            rect = rect.union(&bins[i - 1].rect);
            count += bins[i - 1].count;
            let cost = rect.area() * count.div_ceil(BLOCK) as f32 + right[i];
            if count > 0 && count < items.len() && best.is_none_or(|b| cost < b.0) {
                best = Some((cost, axis, low[axis], scale[axis], i));
            }
        }
    }
    let Some((_, axis, low, scale, at)) = best else {
        // All in one place: any halves are as good.
        return items.len() / 2;
    };
    partition(items, |item| bin_of(centre(item, axis), low, scale) < at)
}

/// Moves the items that satisfy `is_first` to the front; how many they are.
fn partition(items: &mut [Item], is_first: impl Fn(&Item) -> bool) -> usize {
    let (mut i, mut end) = (0, items.len());
    while i < end {
        if is_first(&items[i]) {
            i += 1;
        } else {
            end -= 1;
            items.swap(i, end);
        }
    }
    i
}
