//! Eight triangles side by side, against many points or against one.

use crate::casters::Casters;
use crate::planes::{Corners, Planes, ROWS, planes};
use crate::rect::Rect;
use crate::view::View;
use lt_bvh::lanes::Lanes;

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

    /// Of up to eight triangles, named by their place among the casters.
    #[inline(always)]
    pub fn of<E: Lanes>(lanes: E, view: &View, casters: Casters<'_>, ids: &[u32]) -> Self {
        Self::with_slivers(lanes, view, casters, ids).0
    }

    /// The same, and a bit for each that is a sliver ([`planes`]).
    #[inline(always)]
    pub fn with_slivers<E: Lanes>(lanes: E, view: &View, casters: Casters<'_>, ids: &[u32]) -> (Self, u32) {
        let corners = Corners::load(lanes, view, ids.iter().map(|id| &casters.triangles[*id as usize]));
        let (rows, slivers) = planes(lanes, view, &corners);
        let mut block = Self::EMPTY;
        for (to, from) in block.rows.iter_mut().zip(rows) {
            lanes.store(from, to);
        }
        for (slot, &id) in ids.iter().take(BLOCK).enumerate() {
            let asks = !casters.triangles[id as usize].is_opaque();
            block.ids[slot] = id | if asks { ASKS } else { 0 };
        }
        for slot in ids.len()..BLOCK {
            for (row, nothing) in block.rows.iter_mut().zip(&EMPTY_ROWS) {
                row[slot] = nothing[slot];
            }
        }
        (block, slivers)
    }

    /// The triangles, slot by slot.
    pub fn triangles(&self) -> impl Iterator<Item = u32> {
        self.ids.into_iter().filter(|id| *id != NOBODY).map(|id| id & !ASKS)
    }

    /// One slot's planes.
    #[inline(always)]
    pub fn planes(&self, slot: usize) -> Planes {
        let mut planes = Planes([0.0; ROWS]);
        for (to, from) in planes.0.iter_mut().zip(&self.rows) {
            *to = from[slot & (BLOCK - 1)];
        }
        planes
    }

    /// One slot's planes in every lane.
    #[inline(always)]
    pub fn spread_out<L: Lanes>(&self, lanes: L, slot: usize) -> Spreadout<L> {
        Spreadout::new(lanes, &self.planes(slot))
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

    /// What the triangles are to all points within a spread: those `sure` block them all, those not `possible` none.
    #[inline(always)]
    pub fn test_rect<L: Lanes>(&self, lanes: L, spread: &Spread) -> Answer {
        let (x, y) = (lanes.splat(spread.x), lanes.splat(spread.y));
        let (w, h) = (lanes.splat(spread.half_x), lanes.splat(spread.half_y));
        let one = lanes.splat(1.0);
        let minus = lanes.splat(-1.0);
        let (mut sure, mut outside, mut within) = (L::ALL, 0, 0);
        for edge in 0..3 {
            let (ex, ey) = (lanes.load(&self.rows[3 * edge]), lanes.load(&self.rows[3 * edge + 1]));
            let middle = lanes.mul_add(ex, x, lanes.mul_add(ey, y, lanes.load(&self.rows[3 * edge + 2])));
            let around = lanes.mul_add(lanes.abs(ex), w, lanes.mul(lanes.abs(ey), h));
            let positive = lanes.lt(one, lanes.sub(middle, around));
            sure &= positive;
            within |= positive;
            outside |= lanes.lt(lanes.add(middle, around), minus);
        }
        let (hx, hy, hz) =
            (lanes.load(&self.rows[9]), lanes.load(&self.rows[10]), lanes.load(&self.rows[12]));
        let middle = lanes.mul_add(hx, x, lanes.mul_add(hy, y, lanes.load(&self.rows[11])));
        let around = lanes.mul_add(lanes.abs(hx), w, lanes.mul(lanes.abs(hy), h));
        let least = lanes.neg_mul_add(hz, lanes.splat(spread.far), lanes.sub(middle, around));
        let most = lanes.neg_mul_add(hz, lanes.splat(spread.near), lanes.add(middle, around));
        let tolerance = lanes.splat(spread.tolerance);
        sure &= lanes.lt(tolerance, least);
        let is_before = lanes.le(lanes.sub(lanes.splat(0.0), tolerance), most);
        Answer { sure, possible: is_before & !(outside & within) }
    }
}

/// Rows of a slot without a triangle: no depth reaches the tolerance.
const EMPTY_ROWS: [[f32; BLOCK]; ROWS] = {
    let mut rows = [[0.0; BLOCK]; ROWS];
    rows[11] = [f32::NEG_INFINITY; BLOCK];
    rows
};

/// A rectangle and range of nearness that holds several points.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spread {
    x: f32,
    y: f32,
    half_x: f32,
    half_y: f32,
    /// Least nearness.
    near: f32,
    /// Largest nearness.
    far: f32,
    /// Largest depth tolerance.
    tolerance: f32,
}

impl Spread {
    /// Of points in `rect` whose nearness lies from `near` to `far`.
    #[inline(always)]
    pub fn new(rect: &Rect, near: f32, far: f32, tolerance: f32) -> Self {
        let (x, y) = (0.5 * (rect.x0 + rect.x1), 0.5 * (rect.y0 + rect.y1));
        // From the middle as it is rounded to the farther side.
        let half_x = if rect.x1 - x > x - rect.x0 { rect.x1 - x } else { x - rect.x0 };
        let half_y = if rect.y1 - y > y - rect.y0 { rect.y1 - y } else { y - rect.y0 };
        Spread { x, y, half_x, half_y, near, far, tolerance }
    }
}

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
    /// Of planes outside of a block.
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
