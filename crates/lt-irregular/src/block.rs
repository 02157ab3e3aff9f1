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
        let a =
            lanes.mul_add(lanes.load(row(0)), x, lanes.mul_add(lanes.load(row(1)), y, lanes.load(row(2))));
        let b =
            lanes.mul_add(lanes.load(row(3)), x, lanes.mul_add(lanes.load(row(4)), y, lanes.load(row(5))));
        let c =
            lanes.mul_add(lanes.load(row(6)), x, lanes.mul_add(lanes.load(row(7)), y, lanes.load(row(8))));
        let d =
            lanes.mul_add(lanes.load(row(9)), x, lanes.mul_add(lanes.load(row(10)), y, lanes.load(row(11))));
        let d = lanes.neg_mul_add(lanes.load(row(12)), z, d);
        decide(lanes, a, b, c, d, lanes.splat(tolerance))
    }
}

/// Rows of a slot without a triangle: no depth reaches the tolerance.
const EMPTY_ROWS: [[f32; BLOCK]; ROWS] = {
    let mut rows = [[0.0; BLOCK]; ROWS];
    rows[11] = [f32::NEG_INFINITY; BLOCK];
    rows
};

#[inline(always)]
fn decide<L: Lanes>(lanes: L, a: L::F, b: L::F, c: L::F, d: L::F, tolerance: L::F) -> Answer {
    let least = lanes.min(lanes.min(a, b), c);
    let most = lanes.max(lanes.max(a, b), c);
    let one = lanes.splat(1.0);
    let sure = lanes.lt(one, least) & lanes.lt(tolerance, d);
    // Not ≤: of a settled point, whose nearness is infinite, both sides may be −∞.
    let is_before = lanes.lt(lanes.sub(lanes.splat(0.0), tolerance), d);
    let possible = (lanes.le(lanes.splat(-1.0), least) | lanes.le(most, one)) & is_before;
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
