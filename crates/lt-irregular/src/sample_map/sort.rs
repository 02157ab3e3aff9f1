//! Samples put in order: by medians, as in the paper, or along a Morton curve.

use super::Options;
use super::part::Part;
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::Ray;
use lt_math::glam::{Vec3, Vec4};

/// How the samples of a view are put in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointOrder {
    /// Cut at the median along x and y in turn: the paper's tree, tight bounds.
    Median,
    /// Sorted by cell along a Morton curve and cut in halves: built in less time, with looser bounds, so that it pays only where
    /// triangles are few (docs/results/alias-free.md).
    Morton,
}

/// A sample on its way into the tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub x: f32,
    pub y: f32,
    pub z: f32,
    pub source: u32,
}

/// Parts of at least this many samples are sorted as tasks of their own.
#[cfg(feature = "std")]
const TASK: usize = 8192;
/// Bits per axis of a cell on the Morton curve: two passes of 10 bits sort it.
const CELL_BITS: u32 = 10;

/// The samples that a view takes; those whose rays leave through it and that it cannot take are added to `strays`.
pub(crate) fn points(view: &View, light: Vec4, origins: &[Vec3], strays: &mut Vec<u32>) -> Vec<Point> {
    let mut out = Vec::new();
    for (source, &origin) in origins.iter().enumerate() {
        let ray = Ray::to_light(origin, light);
        let source = source as u32;
        if view.takes(&ray) {
            let p = view.point(&ray);
            out.push(Point { x: p.x, y: p.y, z: p.z, source });
        } else if view.is_stray(&ray) {
            strays.push(source);
        }
    }
    out
}

/// Sorts the samples into parts.
pub(crate) fn parts(mut points: Vec<Point>, options: Options) -> Vec<Part> {
    // A part smaller than a leaf would be one for nothing.
    let most = (points.len() / options.leaf).max(1).ilog2();
    let levels = options.part_levels.min(most);
    if options.order == PointOrder::Morton {
        points = along_curve(&points);
    }
    let mut slices: Vec<&mut [Point]> = Vec::new();
    cut(&mut points, levels, 0, options.order, &mut slices);
    let build = |points: &mut [Point]| {
        let depth = Part::depth(points.len(), options.leaf);
        if options.order == PointOrder::Median {
            order(points, depth, levels);
        }
        Part::new(points, depth)
    };
    #[cfg(feature = "std")]
    {
        use rayon::prelude::*;
        slices.into_par_iter().map(build).collect()
    }
    #[cfg(not(feature = "std"))]
    slices.into_iter().map(build).collect()
}

/// Cuts in halves `levels` times; `depth` cuts came before.
fn cut<'a>(points: &'a mut [Point], levels: u32, depth: u32, by: PointOrder, out: &mut Vec<&'a mut [Point]>) {
    if levels == 0 {
        out.push(points);
        return;
    }
    if by == PointOrder::Median {
        halve(points, depth);
    }
    let (left, right) = points.split_at_mut(points.len() / 2);
    cut(left, levels - 1, depth + 1, by, out);
    cut(right, levels - 1, depth + 1, by, out);
}

/// Orders samples so that halves of halves are what medians part, `depth` levels deep; `before` cuts came before.
fn order(points: &mut [Point], depth: u32, before: u32) {
    if depth == 0 {
        return;
    }
    halve(points, before);
    let (left, right) = points.split_at_mut(points.len() / 2);
    #[cfg(feature = "std")]
    if left.len() >= TASK {
        rayon::join(|| order(left, depth - 1, before + 1), || order(right, depth - 1, before + 1));
        return;
    }
    order(left, depth - 1, before + 1);
    order(right, depth - 1, before + 1);
}

/// Moves the lower half along x, or y after an odd number of cuts, to the front.
fn halve(points: &mut [Point], cuts: u32) {
    let middle = points.len() / 2;
    if middle == 0 {
        return;
    }
    match cuts % 2 {
        0 => points.select_nth_unstable_by(middle, |a, b| a.x.total_cmp(&b.x)),
        _ => points.select_nth_unstable_by(middle, |a, b| a.y.total_cmp(&b.y)),
    };
}

/// Sorts by cell along a Morton curve over the samples' bounds; of one cell, in the given order.
fn along_curve(points: &[Point]) -> Vec<Point> {
    let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
    for p in points {
        low = [low[0].min(p.x), low[1].min(p.y)];
        high = [high[0].max(p.x), high[1].max(p.y)];
    }
    let cells = (1u32 << CELL_BITS) as f32;
    let scale: [f32; 2] = core::array::from_fn(|axis| {
        let scale = cells / (high[axis] - low[axis]);
        if scale.is_finite() { scale } else { 0.0 }
    });
    let cell = |x: f32, axis: usize| (((x - low[axis]) * scale[axis]) as u32).min((1 << CELL_BITS) - 1);
    let key = |p: &Point| spread(cell(p.x, 0)) | spread(cell(p.y, 1)) << 1;
    let mut keyed: Vec<(u32, Point)> = points.iter().map(|p| (key(p), *p)).collect();
    let mut other = keyed.clone();
    for pass in 0..2 {
        let digit = |key: u32| (key >> (pass * CELL_BITS)) as usize & ((1 << CELL_BITS) - 1);
        let mut starts = [0u32; 1 << CELL_BITS];
        keyed.iter().for_each(|(key, _)| starts[digit(*key)] += 1);
        let mut sum = 0;
        for start in &mut starts {
            (*start, sum) = (sum, sum + *start);
        }
        for item in &keyed {
            let to = &mut starts[digit(item.0)];
            other[*to as usize] = *item;
            *to += 1;
        }
        core::mem::swap(&mut keyed, &mut other);
    }
    keyed.into_iter().map(|(_, p)| p).collect()
}

/// Puts a zero bit between any two of the lowest ten.
fn spread(x: u32) -> u32 {
    let x = (x | x << 8) & 0x00ff_00ff;
    let x = (x | x << 4) & 0x0f0f_0f0f;
    let x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
}
