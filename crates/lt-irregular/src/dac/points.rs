//! Lists of points, and how they are halved.

use super::Step;
use super::rows::{SLACK, grow};
use crate::rect::Rect;
use crate::tile::around;
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::lanes::Lanes;
use lt_math::glam::Vec3;

/// Points, row by row.
#[derive(Default)]
pub(super) struct Points {
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// Places in the caller's list.
    pub ids: Vec<u32>,
}

impl Points {
    pub fn reserve(&mut self, end: usize) {
        if self.ids.len() < end + SLACK {
            let len = if self.ids.is_empty() { end } else { end + end / 2 } + SLACK;
            for row in [&mut self.x, &mut self.y, &mut self.z] {
                grow(row, len, 0.0);
            }
            grow(&mut self.ids, len, 0);
        }
    }

    /// Takes the points of all rays that the view takes, the first of which is ray `first`; how many.
    #[inline(always)]
    pub fn fill<P: Lanes>(&mut self, lanes: P, view: &View, origins: &[Vec3], first: u32) -> usize {
        self.reserve(origins.len());
        let [x, y, z] = view.axes();
        let mut len = 0;
        let mut ids: [u32; 16] = core::array::from_fn(|i| first + i as u32);
        let mut rest = [Vec3::NAN; 16];
        for some in origins.chunks(P::WIDTH) {
            let whole = if some.len() == P::WIDTH {
                some
            } else {
                // What is not given starts nowhere, which no view takes.
                rest[..some.len()].copy_from_slice(some);
                &rest
            };
            let o = lanes.load_vectors(whole);
            let (point, taken) = view.points(lanes, [o[x], o[y], o[z]]);
            lanes.compress(taken, point[0], &mut self.x[len..]);
            lanes.compress(taken, point[1], &mut self.y[len..]);
            lanes.compress(taken, point[2], &mut self.z[len..]);
            lanes.compress_words(taken, &ids, &mut self.ids[len..]);
            len += taken.count_ones() as usize;
            ids.iter_mut().for_each(|id| *id += P::WIDTH as u32);
        }
        len
    }

    /// The rectangle of points with their least nearness, and the largest.
    #[inline(always)]
    pub fn bounds<P: Lanes>(&self, lanes: P, start: usize, len: usize) -> (Rect, f32) {
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let (mut low, mut high) = ([infinite; 3], [minus; 3]);
        for at in (start..start + len).step_by(P::WIDTH) {
            let given = first(start + len - at);
            let point = [lanes.load(&self.x[at..]), lanes.load(&self.y[at..]), lanes.load(&self.z[at..])];
            for axis in 0..3 {
                low[axis] = lanes.min(lanes.pick(given, point[axis], infinite), low[axis]);
                high[axis] = lanes.max(lanes.pick(given, point[axis], minus), high[axis]);
            }
        }
        around(lanes, low, high)
    }

    /// Writes the points that lie below a step's place into the room behind the list, and the others behind those; both halves with
    /// their bounds.
    #[inline(always)]
    pub fn halve<P: Lanes>(&mut self, lanes: P, step: &Step) -> [Part; 2] {
        let to = step.free;
        let second = to + step.len + SLACK;
        self.reserve(second + step.len);
        let place = lanes.splat(step.place);
        let mut ends = [to, second];
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let mut reach = [([infinite; 3], [minus; 3]); 2];
        for at in (step.start..step.start + step.len).step_by(P::WIDTH) {
            let point = [lanes.load(&self.x[at..]), lanes.load(&self.y[at..]), lanes.load(&self.z[at..])];
            let mut ids = [0; 16];
            ids[..P::WIDTH].copy_from_slice(&self.ids[at..at + P::WIDTH]);
            let below = lanes.lt(if step.is_y { point[1] } else { point[0] }, place);
            let given = first((step.start + step.len - at).min(P::WIDTH));
            for (half, mask) in [below & given, given & !below].into_iter().enumerate() {
                if mask == 0 {
                    continue;
                }
                let end = ends[half];
                lanes.compress(mask, point[0], &mut self.x[end..]);
                lanes.compress(mask, point[1], &mut self.y[end..]);
                lanes.compress(mask, point[2], &mut self.z[end..]);
                lanes.compress_words(mask, &ids, &mut self.ids[end..]);
                ends[half] += mask.count_ones() as usize;
                let (low, high) = &mut reach[half];
                for axis in 0..3 {
                    low[axis] = lanes.min(lanes.pick(mask, point[axis], infinite), low[axis]);
                    high[axis] = lanes.max(lanes.pick(mask, point[axis], minus), high[axis]);
                }
            }
        }
        let mut parts = [Part::default(); 2];
        for (half, part) in parts.iter_mut().enumerate() {
            let start = [to, second][half];
            let (low, high) = reach[half];
            *part = Part { start, len: ends[half] - start, bounds: around(lanes, low, high) };
        }
        parts
    }
}

/// Some of the points in a list, with their bounds.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub start: usize,
    pub len: usize,
    pub bounds: (Rect, f32),
}

impl Default for Part {
    fn default() -> Self {
        Part { start: 0, len: 0, bounds: (Rect::EMPTY, 0.0) }
    }
}

/// The lowest bits, as many as `count`.
#[inline(always)]
pub(super) fn first(count: usize) -> u32 {
    if count >= 32 { u32::MAX } else { (1 << count) - 1 }
}
