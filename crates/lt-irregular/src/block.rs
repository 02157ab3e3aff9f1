//! Eight triangles side by side, against many points or against one.

use crate::lanes::Lanes;
use crate::planes::{Planes, ROWS};

/// Triangles to a block.
pub(crate) const BLOCK: usize = 8;
/// Bit of an id whose triangle asks the alpha test.
pub(crate) const ASKS: u32 = 0x8000_0000;
/// Id of an empty slot.
pub(crate) const NOBODY: u32 = u32::MAX;

/// Planes of up to eight triangles, row by row, and which triangles they are.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    rows: [[f32; BLOCK]; ROWS],
    /// Index of the triangle, with [`ASKS`]; [`NOBODY`] for none.
    pub ids: [u32; BLOCK],
}

/// Which of several are blocked for sure, and which perhaps.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    pub sure: u32,
    /// Includes those that are sure.
    pub possible: u32,
}

impl Block {
    /// No triangles. An empty slot's planes say "no" everywhere.
    pub const EMPTY: Self = Self { rows: EMPTY_ROWS, ids: [NOBODY; BLOCK] };

    /// Fills a slot.
    #[inline(always)]
    pub fn set(&mut self, slot: usize, planes: &Planes, triangle: u32, asks: bool) {
        for (row, value) in self.rows.iter_mut().zip(planes.0) {
            row[slot] = value;
        }
        self.ids[slot] = triangle | if asks { ASKS } else { 0 };
    }

    /// One slot's planes.
    #[inline(always)]
    pub fn planes(&self, slot: usize) -> Planes {
        Planes(core::array::from_fn(|row| self.rows[row][slot]))
    }

    /// The triangles that block one point.
    #[inline(always)]
    pub fn test_one<L: Lanes>(&self, lanes: L, point: [f32; 3], tolerance: f32) -> Answer {
        let (x, y, z) = (lanes.splat(point[0]), lanes.splat(point[1]), lanes.splat(point[2]));
        let row = |i: usize| &self.rows[i][..];
        let a = lanes.mul_add(lanes.load(row(0)), x, lanes.mul_add(lanes.load(row(1)), y, lanes.load(row(2))));
        let b = lanes.mul_add(lanes.load(row(3)), x, lanes.mul_add(lanes.load(row(4)), y, lanes.load(row(5))));
        let c = lanes.mul_add(lanes.load(row(6)), x, lanes.mul_add(lanes.load(row(7)), y, lanes.load(row(8))));
        let d = lanes.mul_add(lanes.load(row(9)), x, lanes.mul_add(lanes.load(row(10)), y, lanes.load(row(11))));
        let d = lanes.neg_mul_add(lanes.load(row(12)), z, d);
        decide(lanes, a, b, c, d, lanes.splat(tolerance))
    }

    /// What the triangles are to all points of a rectangle (middle and half size) between two nearnesses: `sure` blocks them all,
    /// not `possible` none.
    #[inline(always)]
    pub fn test_rect<L: Lanes>(&self, lanes: L, rect: &Spread) -> Answer {
        let (x, y) = (lanes.splat(rect.x), lanes.splat(rect.y));
        let (w, h) = (lanes.splat(rect.half_x), lanes.splat(rect.half_y));
        let one = lanes.splat(1.0);
        let minus = lanes.splat(-1.0);
        let (mut sure, mut possible) = (L::ALL, L::ALL);
        for edge in 0..3 {
            let (ex, ey) = (lanes.load(&self.rows[3 * edge]), lanes.load(&self.rows[3 * edge + 1]));
            let middle = lanes.mul_add(ex, x, lanes.mul_add(ey, y, lanes.load(&self.rows[3 * edge + 2])));
            let around = lanes.mul_add(lanes.abs(ex), w, lanes.mul(lanes.abs(ey), h));
            sure &= lanes.lt(one, lanes.sub(middle, around));
            possible &= lanes.le(minus, lanes.add(middle, around));
        }
        let (hx, hy, hz) = (lanes.load(&self.rows[9]), lanes.load(&self.rows[10]), lanes.load(&self.rows[12]));
        let middle = lanes.mul_add(hx, x, lanes.mul_add(hy, y, lanes.load(&self.rows[11])));
        let around = lanes.mul_add(lanes.abs(hx), w, lanes.mul(lanes.abs(hy), h));
        let least = lanes.neg_mul_add(hz, lanes.splat(rect.far), lanes.sub(middle, around));
        let most = lanes.neg_mul_add(hz, lanes.splat(rect.near), lanes.add(middle, around));
        let tolerance = lanes.splat(rect.tolerance);
        sure &= lanes.lt(tolerance, least);
        possible &= lanes.le(lanes.sub(lanes.splat(0.0), tolerance), most);
        Answer { sure, possible }
    }
}

/// Rows of a slot without a triangle: no depth reaches the tolerance.
const EMPTY_ROWS: [[f32; BLOCK]; ROWS] = {
    let mut rows = [[0.0; BLOCK]; ROWS];
    rows[11] = [f32::NEG_INFINITY; BLOCK];
    rows
};

/// A rectangle and range of nearness that holds several points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spread {
    pub x: f32,
    pub y: f32,
    /// Half the width, grown for the rounding of the middle.
    pub half_x: f32,
    pub half_y: f32,
    /// Least nearness.
    pub near: f32,
    /// Largest nearness.
    pub far: f32,
    /// Largest depth tolerance.
    pub tolerance: f32,
}

#[inline(always)]
fn decide<L: Lanes>(lanes: L, a: L::F, b: L::F, c: L::F, d: L::F, tolerance: L::F) -> Answer {
    let edge = lanes.min(lanes.min(a, b), c);
    let sure = lanes.lt(lanes.splat(1.0), edge) & lanes.lt(tolerance, d);
    // Not ≤: of a settled point, whose nearness is infinite, both sides may be −∞.
    let possible = lanes.le(lanes.splat(-1.0), edge) & lanes.lt(lanes.sub(lanes.splat(0.0), tolerance), d);
    Answer { sure, possible }
}

/// One triangle's planes, each number in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Spreadout<L: Lanes>([L::F; ROWS]);

impl<L: Lanes> Spreadout<L> {
    #[inline(always)]
    pub fn new(lanes: L, planes: &Planes) -> Self {
        let mut rows = [lanes.splat(0.0); ROWS];
        for (to, from) in rows.iter_mut().zip(planes.0) {
            *to = lanes.splat(from);
        }
        Spreadout(rows)
    }

    /// The points that the triangle blocks; `tolerance` is the depth test's, of each.
    #[inline(always)]
    pub fn test(&self, lanes: L, x: L::F, y: L::F, z: L::F, tolerance: L::F) -> Answer {
        let r = &self.0;
        let a = lanes.mul_add(r[0], x, lanes.mul_add(r[1], y, r[2]));
        let b = lanes.mul_add(r[3], x, lanes.mul_add(r[4], y, r[5]));
        let c = lanes.mul_add(r[6], x, lanes.mul_add(r[7], y, r[8]));
        let d = lanes.neg_mul_add(r[12], z, lanes.mul_add(r[9], x, lanes.mul_add(r[10], y, r[11])));
        decide(lanes, a, b, c, d, tolerance)
    }
}
