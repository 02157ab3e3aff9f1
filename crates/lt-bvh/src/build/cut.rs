//! The upper part of a tree, from the top down: each node is cut in two where the surface-area cost is least among a few planes
//! across each axis (Wald 2007, "On Fast Construction of SAH-based Bounding Volume Hierarchies").
//!
//! PLOC joins neighbours from below and knows nothing of what lies farther off: good where few are left to join, poor at the top,
//! which all rays pass.

use super::bounds::Bounds;
use crate::simd::memory;
use bytemuck::Zeroable;
use lt_math::glam::{Vec3A, Vec4};
use obvhs::Boundable;
use obvhs::aabb::Aabb;
use rayon::prelude::*;
use std::vec::Vec;

/// Planes per axis, plus one.
const BINS: usize = 16;
/// Items that one thread handles at once.
const TASK: usize = 1 << 15;
/// Levels after which halves are taken as they lie. Others shrink the longest side by far before.
const DEEPEST: usize = 64;

/// A primitive's box, and which primitive it is.
#[derive(Clone, Copy, Zeroable)]
pub(crate) struct Item {
    /// w: bits of [`NORMAL`] and the index.
    low: Vec4,
    /// w: 0.
    high: Vec4,
}

/// Set in the word of an index, which arithmetic on four lanes meets: else it would be a denormal number, which is slow.
const NORMAL: u32 = 0x4000_0000;

impl Item {
    /// Of a primitive below 2³⁰.
    pub fn new(low: Vec3A, high: Vec3A, primitive: u32) -> Self {
        Item { low: low.extend(f32::from_bits(NORMAL | primitive)), high: high.extend(0.0) }
    }

    pub fn primitive(&self) -> u32 {
        self.low.w.to_bits() & !NORMAL
    }

    fn low(&self) -> Vec3A {
        Vec3A::from_vec4(self.low)
    }

    fn high(&self) -> Vec3A {
        Vec3A::from_vec4(self.high)
    }

    /// Twice the centre.
    fn centre(&self) -> Vec3A {
        self.low() + self.high()
    }
}

impl Boundable for Item {
    fn aabb(&self) -> Aabb {
        Aabb::new(self.low(), self.high())
    }
}

/// The box of some points; `low > high` where there are none.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    low: Vec3A,
    high: Vec3A,
}

impl Span {
    const EMPTY: Span = Span { low: Vec3A::INFINITY, high: Vec3A::NEG_INFINITY };

    fn with(self, low: Vec3A, high: Vec3A) -> Self {
        Span { low: self.low.min(low), high: self.high.max(high) }
    }

    fn union(self, other: Span) -> Self {
        self.with(other.low, other.high)
    }

    /// Half the surface area in units of which `unit` make 1 of length.
    fn half_area(self, unit: f32) -> f32 {
        let d = (self.high - self.low) * unit;
        d.x * d.y + d.y * d.z + d.z * d.x
    }

    /// Of the centres of `items`.
    pub fn of_centres(items: &[Item]) -> Self {
        let of = |items: &[Item]| {
            items.iter().fold(Span::EMPTY, |span, item| span.with(item.centre(), item.centre()))
        };
        items.par_chunks(TASK).map(of).reduce(|| Span::EMPTY, |a, b| a.union(b))
    }
}

/// Where centres fall among bins.
#[derive(Clone, Copy)]
struct Grid {
    low: Vec3A,
    scale: Vec3A,
}

impl Grid {
    /// Over the centres' span; all in bin 0 along an axis in which they do not differ.
    fn new(centres: Span) -> Self {
        let extent = centres.high - centres.low;
        let scale = Vec3A::splat(BINS as f32 * 0.999) / extent;
        Grid { low: centres.low, scale: Vec3A::select(extent.cmpgt(Vec3A::ZERO), scale, Vec3A::ZERO) }
    }

    /// The bins of a centre by axis.
    #[inline(always)]
    fn bins(&self, centre: Vec3A) -> [usize; 3] {
        // Added to a number this large, another is rounded to an integer in the low bits.
        const ROUND: f32 = 12_582_912.0;
        let at = ((centre - self.low) * self.scale - 0.5) + ROUND;
        at.to_array().map(|x| x.to_bits() as usize % BINS)
    }
}

/// What lies in each bin of each axis.
#[derive(Clone, Copy)]
struct Bins {
    spans: [[Span; BINS]; 3],
    counts: [[u32; BINS]; 3],
}

impl Bins {
    const EMPTY: Bins = Bins { spans: [[Span::EMPTY; BINS]; 3], counts: [[0; BINS]; 3] };

    fn of(items: &[Item], grid: Grid) -> Self {
        if items.len() > TASK {
            return items
                .par_chunks(TASK)
                .map(|items| Self::of(items, grid))
                .reduce(|| Self::EMPTY, Self::plus);
        }
        let mut bins = Self::EMPTY;
        for item in items {
            let (low, high) = (item.low(), item.high());
            for (axis, bin) in grid.bins(item.centre()).into_iter().enumerate() {
                let span = &mut bins.spans[axis][bin];
                *span = span.with(low, high);
                bins.counts[axis][bin] += 1;
            }
        }
        bins
    }

    fn plus(mut self, other: Bins) -> Self {
        for axis in 0..3 {
            for bin in 0..BINS {
                self.spans[axis][bin] = self.spans[axis][bin].union(other.spans[axis][bin]);
                self.counts[axis][bin] += other.counts[axis][bin];
            }
        }
        self
    }

    /// The axis and the first bin on the right of the cheapest cut, if any has something on both sides.
    fn cheapest(&self) -> Option<(usize, usize)> {
        let all = self.spans[0].iter().fold(Span::EMPTY, |all, span| all.union(*span));
        let unit = (all.high - all.low).max_element().recip();
        let mut cheapest = (f32::INFINITY, None);
        for axis in 0..3 {
            let (spans, counts) = (&self.spans[axis], &self.counts[axis]);
            let mut costs = [f32::INFINITY; BINS];
            let (mut right, mut count) = (Span::EMPTY, 0);
            for bin in (1..BINS).rev() {
                right = right.union(spans[bin]);
                count += counts[bin];
                if count > 0 {
                    costs[bin] = right.half_area(unit) * count as f32;
                }
            }
            let (mut left, mut count) = (Span::EMPTY, 0);
            for bin in 1..BINS {
                left = left.union(spans[bin - 1]);
                count += counts[bin - 1];
                if count > 0 {
                    let cost = left.half_area(unit) * count as f32 + costs[bin];
                    if cost < cheapest.0 {
                        cheapest = (cost, Some((axis, bin)));
                    }
                }
            }
        }
        cheapest.1
    }
}

/// Items that belong together, and what their centres span.
pub(crate) struct Group<'a> {
    pub items: &'a mut [Item],
    centres: Span,
    level: usize,
}

impl<'a> Group<'a> {
    /// Everything.
    pub fn new(items: &'a mut [Item]) -> Self {
        let centres = Span::of_centres(items);
        Group { items, centres, level: 0 }
    }

    /// Two groups of at least one item each, of at least two.
    pub fn cut(self) -> (Self, Self) {
        let Group { items, centres, level } = self;
        let grid = Grid::new(centres);
        let cut = if level < DEEPEST { Bins::of(items, grid).cheapest() } else { None };
        let (at, spans) = match cut {
            Some((axis, bin)) => partition(items, |item| grid.bins(item.centre())[axis] < bin),
            None => (items.len() / 2, [centres; 2]),
        };
        let (left, right) = items.split_at_mut(at);
        let group = |items, centres| Group { items, centres, level: level + 1 };
        (group(left, spans[0]), group(right, spans[1]))
    }
}

/// Brings items of the left side to the front; how many there are, and what the centres of either side span.
fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> (usize, [Span; 2]) {
    let (mut begin, mut end) = (0, items.len());
    let mut spans = [Span::EMPTY; 2];
    while begin < end {
        let centre = items[begin].centre();
        if is_left(&items[begin]) {
            spans[0] = spans[0].with(centre, centre);
            begin += 1;
        } else {
            spans[1] = spans[1].with(centre, centre);
            end -= 1;
            items.swap(begin, end);
        }
    }
    (begin, spans)
}

/// What `boxes` bound, in order.
pub(crate) fn items(boxes: &[Bounds]) -> Vec<Item> {
    memory::filled(boxes.len(), |i| Item::new(boxes[i].low.into(), boxes[i].high.into(), i as u32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::glam::Vec3;
    use std::vec;

    fn cubes(lows: impl Iterator<Item = Vec3>) -> Vec<Item> {
        items(&lows.map(|low| Bounds { low, high: low + Vec3::ONE }).collect::<Vec<_>>())
    }

    fn primitives(group: &Group) -> Vec<u32> {
        let mut primitives: Vec<u32> = group.items.iter().map(Item::primitive).collect();
        primitives.sort_unstable();
        primitives
    }

    #[test]
    fn clusters_are_parted_whatever_the_scale() {
        for scale in [1e-9, 1.0, 1e12] {
            let far = |i: u32| if i.is_multiple_of(3) { 100.0 } else { 0.0 };
            let low = |i| Vec3::new(i as f32 % 7.0, far(i), i as f32 % 5.0);
            let mut items = cubes((0..60).map(low));
            items.iter_mut().for_each(|item| {
                *item = Item::new(item.low() * scale, item.high() * scale, item.primitive());
            });
            let (near, far) = Group::new(&mut items).cut();
            assert_eq!(primitives(&far), (0..60).step_by(3).collect::<Vec<u32>>());
            assert_eq!(near.items.len(), 40);
        }
    }

    #[test]
    fn both_sides_hold_something_until_single_items_are_left() {
        let mut equal = cubes(core::iter::repeat_n(Vec3::ZERO, 9));
        let mut in_a_row = cubes((0..200).map(|i| Vec3::X * 1.7f32.powi(i % 150)));
        for items in [&mut equal, &mut in_a_row] {
            let all = items.len();
            let (mut pending, mut parted) = (vec![Group::new(items)], 0);
            while let Some(group) = pending.pop() {
                if group.items.len() == 1 {
                    parted += 1;
                    continue;
                }
                let (left, right) = group.cut();
                assert!(!left.items.is_empty() && !right.items.is_empty() && right.level < DEEPEST + 9);
                pending.extend([left, right]);
            }
            assert_eq!(parted, all);
        }
    }

    #[test]
    fn centres_of_a_side_are_those_of_its_items() {
        let mut items = cubes((0..100).map(|i| Vec3::new((i * 37 % 101) as f32, (i * 11 % 17) as f32, 0.0)));
        let (left, right) = Group::new(&mut items).cut();
        for group in [left, right] {
            let span = Span::of_centres(group.items);
            assert_eq!((group.centres.low, group.centres.high), (span.low, span.high));
        }
    }
}
