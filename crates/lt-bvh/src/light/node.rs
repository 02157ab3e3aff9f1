//! Eight boxes of light space in 80 bytes, and a point against all of them.
//!
//! Planes lie on the ray tracer's grids of eight bits per axis ([`Grid`]). A point is rounded to lines of the grid once, and is then
//! compared with four planes at a time inside a word.

use crate::grid::{Grid, byte};
use crate::light::LightPoint;
use bytemuck::{Pod, Zeroable};
use lt_math::glam::{UVec2, UVec4};

/// Rows of 16 bytes to a node.
pub const NODE_ROWS: u32 = 5;

/// Up to eight children in 80 bytes. All are nodes, one after the other, or all are triangles.
///
/// A child's box is a rectangle in x and y, a range of the third coordinate of places ([`LightSpace::diagonal`](crate::LightSpace)), and
/// a largest nearness. The last line of the grid of nearness stands for all beyond it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct LightNode {
    /// Bits of where the grids begin: of x, y, the third coordinate, nearness.
    pub low: UVec4,
    /// Lower planes in x of children 0 to 3 and 4 to 7, then upper planes. A slot without a child has them the wrong way round.
    pub x: UVec4,
    /// The same in y.
    pub y: UVec4,
    /// The same in the third coordinate.
    pub diagonal: UVec4,
    /// Largest nearness of children 0 to 3 and 4 to 7; exponents of the grids, from the low byte; the first child, or [`LightNode::LEAF`]
    /// and the row with the first four triangles.
    pub rest: UVec4,
}

const _: () = assert!(size_of::<LightNode>() == NODE_ROWS as usize * 16);

/// The highest bit of every byte.
const HIGH: u32 = 0x8080_8080;

/// Sets the highest bit of every byte for which that of `a` is at most that of `b`, unsigned; other bits are anything.
#[inline(always)]
fn at_most(a: u32, b: u32) -> u32 {
    // Without the highest bits no byte borrows of the next.
    let of_rest = (b | HIGH).wrapping_sub(a & !HIGH);
    (b & !a) | (!(a ^ b) & of_rest)
}

/// Sets the highest bit of every byte whose planes a point, given by the lines around it, lies between.
#[inline(always)]
fn between(lower: u32, point: UVec2, upper: u32) -> u32 {
    at_most(lower, point.x) & at_most(point.y, upper)
}

/// The highest bits of four bytes, as the lowest four bits.
#[inline(always)]
fn gathered(bytes: u32) -> u32 {
    ((bytes & HIGH) >> 7).wrapping_mul(0x0102_0408) >> 24
}

/// A coordinate between lines of a grid, in every byte of a word: the line below it, and the one above.
#[inline(always)]
fn lines(x: f32, low_bits: u32, exponent: u32) -> UVec2 {
    let offset = x - f32::from_bits(low_bits);
    let step = f32::from_bits(exponent << 23);
    let last = 255.0 * step;
    // Outside of the grid, on its border.
    let steps = if offset > 0.0 { if offset < last { offset / step } else { 255.0 } } else { 0.0 };
    let below = steps as u32;
    let above = if (below as f32) < steps { below + 1 } else { below };
    UVec2::new(below.wrapping_mul(0x0101_0101), above.wrapping_mul(0x0101_0101))
}

impl LightNode {
    /// Bit of the last word: the children are triangles.
    pub const LEAF: u32 = 1 << 31;

    /// The node at an index, counted in nodes, of a buffer of rows.
    #[inline(always)]
    pub fn load(rows: &[UVec4], index: u32) -> Self {
        let at = (index * NODE_ROWS) as usize;
        LightNode {
            low: rows[at],
            x: rows[at + 1],
            y: rows[at + 2],
            diagonal: rows[at + 3],
            rest: rows[at + 4],
        }
    }

    /// The grid of x, y, the third coordinate, or nearness.
    pub fn grid(&self, axis: usize) -> Grid {
        Grid { low: f32::from_bits(self.low[axis]), exponent: byte(self.rest.z, axis as u32) }
    }

    /// Whether the children are triangles.
    #[inline(always)]
    pub fn is_leaf(&self) -> bool {
        self.rest.w & Self::LEAF != 0
    }

    /// The first child, or the row with a leaf's first triangles.
    #[inline(always)]
    pub fn first(&self) -> u32 {
        self.rest.w & !Self::LEAF
    }

    /// The children whose box holds a point with this third coordinate, a bit each. A point outside of the node may be found in a child at
    /// its border.
    #[inline(always)]
    pub fn holders(&self, point: &LightPoint, diagonal: f32) -> u32 {
        let exponents = self.rest.z;
        let x = lines(point.x, self.low.x, byte(exponents, 0));
        let y = lines(point.y, self.low.y, byte(exponents, 1));
        let d = lines(diagonal, self.low.z, byte(exponents, 2));
        let z = lines(point.z, self.low.w, byte(exponents, 3));
        let first = between(self.x.x, x, self.x.z)
            & between(self.y.x, y, self.y.z)
            & between(self.diagonal.x, d, self.diagonal.z)
            & at_most(z.y, self.rest.x);
        let second = between(self.x.y, x, self.x.w)
            & between(self.y.y, y, self.y.w)
            & between(self.diagonal.y, d, self.diagonal.w)
            & at_most(z.y, self.rest.y);
        gathered(first) | gathered(second) << 4
    }

    /// Exact ends of every slot's box: least and largest x, y and third coordinate, and largest nearness. Least beyond largest where there is
    /// none.
    pub fn ends(&self) -> [[f64; 7]; 8] {
        let grids = [0, 1, 2, 3].map(|axis| self.grid(axis));
        core::array::from_fn(|slot| {
            let (half, at) = (slot / 4, slot as u32 % 4);
            let line = |axis: usize, word: u32| {
                f64::from(grids[axis].low) + grids[axis].step() * f64::from(byte(word, at))
            };
            let mut ends = [f64::INFINITY; 7];
            for (axis, row) in [self.x, self.y, self.diagonal].into_iter().enumerate() {
                (ends[2 * axis], ends[2 * axis + 1]) = (line(axis, row[half]), line(axis, row[2 + half]));
            }
            if byte(self.rest[half], at) < 255 {
                ends[6] = line(3, self.rest[half]);
            }
            ends
        })
    }

    /// The triangle in a slot of a leaf.
    pub fn triangle(&self, rows: &[UVec4], slot: u32) -> u32 {
        triangle_in(rows, self.first(), slot)
    }
}

/// The triangle in a slot of the leaf whose triangles begin at a row.
#[inline(always)]
pub(crate) fn triangle_in(rows: &[UVec4], first: u32, slot: u32) -> u32 {
    let row = rows[(first + (slot >> 2)) as usize];
    let pair = if slot & 2 == 0 { (row.x, row.y) } else { (row.z, row.w) };
    if slot & 1 == 0 { pair.0 } else { pair.1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_compared_side_by_side() {
        let mut state = 1u32;
        for _ in 0..20_000 {
            let mut word = || {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                // Small, large and equal bytes.
                state.rotate_left(11) & [u32::MAX, 0x0f0f_0f0f, 0xffff_0000][(state >> 30) as usize % 3]
            };
            let (a, b) = (word(), word());
            let expected = (0..4).fold(0, |mask, i| mask | u32::from(byte(a, i) <= byte(b, i)) << i);
            assert_eq!(gathered(at_most(a, b)), expected, "{a:08x} {b:08x}");
        }
        assert_eq!(gathered(at_most(0x80ff_00ff, 0x7fff_00fe)), 0b0110);
    }

    #[test]
    fn what_lies_between_planes_is_found_between_their_lines() {
        for (low, high) in [(0.0f32, 1.0f32), (-3.0, 1e-3), (1e5, 1.0001e5), (-1e-12, 1e-12), (7.0, 7.0)] {
            let grid = Grid::over(low, high);
            for i in 0..=1000 {
                let x = low + (high - low) * (i as f32 / 1000.0);
                let found = lines(x, low.to_bits(), grid.exponent);
                // A box from x to x, rounded outward, holds x.
                assert!(byte(found.x, 0) >= grid.line_below(x), "{low} {high} {x}");
                assert!(byte(found.y, 3) <= grid.line_above(x), "{low} {high} {x}");
            }
            let outside = [
                lines(low - 1.0, low.to_bits(), grid.exponent),
                lines(high * 2.0 + 1e9, low.to_bits(), grid.exponent),
            ];
            assert_eq!(outside, [UVec2::ZERO, UVec2::MAX]);
        }
    }
}
