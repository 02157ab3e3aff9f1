//! Triangles drawn into a band of a map's rows, by the texel centres that they cover; compiled once per set of instructions.

use lt_bvh::lanes::{Lanes, NodeLanes, Work};
use lt_math::glam::{Vec2, Vec4};

use super::map_tiles::{SIDE, TEXELS};
use super::surface::{Covered, DepthPlane, Perspective, Surface};
use crate::packed::MappedCoverage;

/// Steps per texel that corners are snapped to; every Vulkan driver offers at least 4 bits, most have 8.
const SUBTEXEL: f32 = 256.0;
/// 1.5·2⁵², which added and taken away rounds an f64 to a whole number without a call.
const ROUNDER: f64 = 6_755_399_441_055_744.0;
/// Corners farther out than this many texels are clamped, which keeps edge functions inside 63 bits.
const GUARD_TEXELS: f32 = 1.0e6;

/// A triangle ready to be drawn.
#[derive(Clone, Copy)]
pub struct Prepared {
    /// The triangle's corners in homogeneous texels; z is the depth.
    pub corners: [Vec4; 3],
    /// The same, snapped, in counter-clockwise order on a y-down map.
    pub snapped: [[i32; 2]; 3],
    pub triangle: u32,
    pub has_holes: bool,
    /// Depth is not linear on the map.
    pub is_perspective: bool,
}

impl Prepared {
    /// The least depth of a corner, in [0, 1].
    pub fn nearest(&self) -> f32 {
        self.corners.iter().fold(1.0, |least: f32, c| least.min(c.z)).max(0.0)
    }
}

/// Corners snapped and in order; `None` if they cover no texel.
#[inline(always)]
pub fn placed(at: [Vec2; 3], size: usize) -> Option<[[i32; 2]; 3]> {
    let mut snapped = at.map(|c| [snap(c.x), snap(c.y)]);
    let area = edge(snapped[0], snapped[1], snapped[2]);
    if area == 0 {
        return None;
    }
    if area < 0 {
        snapped.swap(1, 2);
    }
    let is_on_map = [0, 1].iter().all(|&axis| {
        let (low, high) = span(snapped.map(|c| c[axis]), size);
        low < high
    });
    is_on_map.then_some(snapped)
}

/// A coordinate in texels as a whole number of subtexels, ties to even.
#[inline(always)]
fn snap(x: f32) -> i32 {
    let scaled = x.clamp(-GUARD_TEXELS, GUARD_TEXELS) * SUBTEXEL;
    ((f64::from(scaled) + ROUNDER) - ROUNDER) as i32
}

/// Twice the signed area of a triangle of snapped points.
#[inline(always)]
fn edge(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i64 {
    let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// First and one past the last texel row whose centres the triangle may cover.
#[inline(always)]
pub fn rows_of(t: &Prepared, size: usize) -> (usize, usize) {
    span(t.snapped.map(|c| c[1]), size)
}

/// First and one past the last texel whose centre lies between the least and the greatest of three snapped numbers.
#[inline(always)]
pub fn span(at: [i32; 3], size: usize) -> (usize, usize) {
    let (low, high) = (at[0].min(at[1]).min(at[2]), at[0].max(at[1]).max(at[2]));
    // A centre lies at 256·i + 128.
    let first = (low + 127) >> 8;
    let last = ((high - 128) >> 8) + 1;
    let clamp = |x: i32| x.clamp(0, size as i32) as usize;
    (clamp(first), clamp(last))
}

/// Columns of a row of tiles' rows: the first and one past the last, whole numbers.
struct Columns {
    low: [f64; SIDE],
    high: [f64; SIDE],
}

impl Columns {
    /// The texels that they cover.
    #[inline(always)]
    fn covered(&self) -> Covered {
        let (mut low, mut high) = (self.low[0], self.high[0]);
        for row in 1..SIDE {
            low = if self.low[row] < low { self.low[row] } else { low };
            high = if self.high[row] > high { self.high[row] } else { high };
        }
        let tiles = if low < high { low as usize / SIDE..(high as usize).div_ceil(SIDE) } else { 0..0 };
        Covered::new(tiles, self.low.map(|x| x as f32), self.high.map(|x| x as f32))
    }
}

/// A line whose left side (≥ 0) is inside: `dx · x + dy · y + at ≥ 0` in texels x, y. All are whole numbers far below 2⁵³, and so exact.
#[derive(Clone, Copy)]
struct Edge {
    dx: f64,
    dy: f64,
    at: f64,
}

impl Edge {
    /// From a to b, evaluated at texel centres, with the top-left rule as an offset of one unit.
    fn new(a: [i32; 2], b: [i32; 2]) -> Self {
        let [a, b] = [a, b].map(|p| p.map(i64::from));
        let (dx, dy) = (-(b[1] - a[1]), b[0] - a[0]);
        // y points down and the inside is to the right of an edge that goes up.
        let is_top_left = dx > 0 || (dx == 0 && dy > 0);
        let constant = -(dx * a[0] + dy * a[1]) + 128 * (dx + dy) - i64::from(!is_top_left);
        // 256 · (dx · x + dy · y) + constant ≥ 0, in steps of 256.
        Self { dx: dx as f64, dy: dy as f64, at: (constant >> 8) as f64 }
    }

    /// Narrows rows from `first` on to the columns that lie inside.
    #[inline(always)]
    fn narrow(&self, first: f64, columns: &mut Columns) {
        let Columns { low, high } = columns;
        let values: [f64; SIDE] = std::array::from_fn(|i| self.dy * (first + i as f64) + self.at);
        // A quotient of whole numbers below 2⁵³ never rounds up to a whole number.
        if self.dx > 0.0 {
            // dx · x + value ≥ 0 ⇔ x ≥ −value / dx, rounded up.
            for i in 0..SIDE {
                let least = -floor(values[i] / self.dx);
                low[i] = if least > low[i] { least } else { low[i] };
            }
        } else if self.dx < 0.0 {
            for i in 0..SIDE {
                let end = floor(values[i] / -self.dx) + 1.0;
                high[i] = if end < high[i] { end } else { high[i] };
            }
        } else {
            for i in 0..SIDE {
                high[i] = if values[i] < 0.0 { 0.0 } else { high[i] };
            }
        }
    }
}

/// The greatest whole number that is not above x, for |x| < 2⁵¹, on any processor without a call.
#[inline(always)]
fn floor(x: f64) -> f64 {
    let nearest = (x + ROUNDER) - ROUNDER;
    if nearest > x { nearest - 1.0 } else { nearest }
}

/// Whole rows of a map's [tiles](super::map_tiles) that one thread owns, and what to draw there.
pub struct Band<'a> {
    /// The alpha test, where a caster has holes.
    pub coverage: Option<MappedCoverage<'a>>,
    pub first_row: usize,
    /// Texels to a side of the map.
    pub size: usize,
    pub rows: &'a mut [f32],
    pub triangles: &'a [&'a Prepared],
}

impl Work for Band<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(mut self, lanes: L) {
        for t in self.triangles {
            match t.is_perspective {
                false => {
                    self.fill(lanes.rays(), t, &DepthPlane::through(&t.corners.map(|c| c.truncate())));
                }
                true => self.fill(lanes.rays(), t, &Perspective(&t.corners)),
            }
        }
    }
}

impl Band<'_> {
    #[inline(always)]
    fn fill<L: Lanes>(&mut self, lanes: L, t: &Prepared, surface: &impl Surface) {
        let s = t.snapped;
        let edges = [Edge::new(s[0], s[1]), Edge::new(s[1], s[2]), Edge::new(s[2], s[0])];
        let (low_row, high_row) = rows_of(t, self.size);
        let (low_column, high_column) = span(s.map(|c| c[0]), self.size);
        let end = self.first_row + self.rows.len() / self.size;
        let holes = t.has_holes.then(|| self.coverage.map(|c| c.of(t.triangle))).flatten();
        let tile_rows = low_row.max(self.first_row) / SIDE..high_row.min(end).div_ceil(SIDE);
        let (tiles, across) = (self.rows.as_chunks_mut::<TEXELS>().0, self.size / SIDE);
        for tile_row in tile_rows {
            // Rows of the tiles that the triangle does not reach are narrowed to nothing.
            let first = tile_row * SIDE;
            let mut columns = Columns { low: [low_column as f64; SIDE], high: [high_column as f64; SIDE] };
            edges.iter().for_each(|e| e.narrow(first as f64, &mut columns));
            let tiles = &mut tiles[(first - self.first_row) / SIDE * across..][..across];
            let (covered, y) = (columns.covered(), first as f32);
            match &holes {
                None => surface.draw(lanes, tiles, &covered, y),
                Some(holes) => surface.draw_where(lanes, tiles, &covered, y, |x, which| {
                    holes.blocked(&t.corners, Vec2::new(x, y) + 0.5, which)
                }),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::map_tiles::maps_to_rows;
    use super::*;
    use lt_bvh::lanes::Chosen;

    /// Which texels of a map are drawn, row by row.
    fn covered(corners: [[f32; 2]; 3], size: usize) -> Vec<bool> {
        let at = corners.map(Vec2::from);
        let corners = at.map(|c| c.extend(0.5).extend(1.0));
        let Some(snapped) = placed(at, size) else { return vec![false; size * size] };
        let t = Prepared { corners, snapped, triangle: 0, has_holes: false, is_perspective: false };
        let mut map = vec![1.0; size * size];
        let band = Band { coverage: None, first_row: 0, size, rows: &mut map, triangles: &[&t] };
        Chosen::best().run(band);
        maps_to_rows(&map, size as u32).iter().map(|depth| *depth < 1.0).collect()
    }

    #[test]
    fn a_shared_edge_is_drawn_exactly_once() {
        // Two triangles of a square whose diagonal and sides run through texel centres.
        let a = covered([[0.5, 0.5], [4.5, 0.5], [4.5, 4.5]], 8);
        let b = covered([[0.5, 0.5], [4.5, 4.5], [0.5, 4.5]], 8);
        for (i, (in_a, in_b)) in a.iter().zip(&b).enumerate() {
            let (x, y) = (i % 8, i / 8);
            assert!(!(*in_a && *in_b), "{x},{y} twice");
            assert_eq!(*in_a || *in_b, x < 4 && y < 4, "{x},{y}: top and left edges belong, others do not");
        }
    }

    #[test]
    fn coverage_agrees_with_edge_signs_on_random_triangles() {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1664525).wrapping_add(1013904223);
            (state >> 8) as f32 / 65536.0 / 8.0 - 8.0
        };
        let mut drawn = 0;
        for round in 0..4000 {
            let c: [[f32; 2]; 3] = std::array::from_fn(|_| [next(), next()]);
            // Half of them on a coarse grid, whose edges run along axes and through centres.
            let c = if round % 2 == 0 { c } else { c.map(|p| p.map(|x| (x * 0.5).round() * 2.0 + 0.5)) };
            drawn += covered(c, 16).iter().filter(|is_in| **is_in).count();
            let mask = covered(c, 16);
            for (i, is_in) in mask.iter().enumerate() {
                let p = [i as f64 % 16.0 + 0.5, (i / 16) as f64 + 0.5];
                let d = |a: [f32; 2], b: [f32; 2]| {
                    let q = |x: f32| (f64::from(x) * 256.0).round_ties_even() / 256.0;
                    (q(b[0]) - q(a[0])) * (p[1] - q(a[1])) - (q(b[1]) - q(a[1])) * (p[0] - q(a[0]))
                };
                let s = [d(c[0], c[1]), d(c[1], c[2]), d(c[2], c[0])];
                let strictly = s.iter().all(|x| *x > 0.0) || s.iter().all(|x| *x < 0.0);
                let outside = s.iter().any(|x| *x > 0.0) && s.iter().any(|x| *x < 0.0);
                assert!(!strictly || *is_in);
                assert!(!outside || !*is_in);
            }
        }
        assert!(drawn > 10_000, "{drawn}");
    }
}
