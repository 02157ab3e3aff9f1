//! Eight-bit grids: 256 lines along an axis, a power of two apart, between which boxes are rounded outward.
//!
//! Lines are f32 numbers relative to the first, and rounding never carries a number past one of those. So a coordinate that lies beyond
//! a line still does after its difference to the first line was rounded, and tests on the grid lose nothing.

/// Lines at `low + i · step`, i from 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Where the first line is.
    pub low: f32,
    /// Biased exponent, as in f32, of the distance between lines: 1 to 254.
    pub exponent: u32,
}

impl Grid {
    /// The finest grid from `low` that reaches `high`, both finite and `low ≤ high`.
    pub fn over(low: f32, high: f32) -> Self {
        let extent = f64::from(high) - f64::from(low);
        let mut exponent = 1;
        if extent > 0.0 {
            // The exponent field of extent / 255, rebiased from f64 to f32, is at most one too low.
            let biased = ((extent / 255.0).to_bits() >> 52) as i64 - 1023 + 127;
            exponent = biased.clamp(1, 254) as u32;
        }
        let mut grid = Grid { low, exponent };
        while grid.exponent < 254 && grid.step() * 255.0 < extent {
            grid.exponent += 1;
        }
        grid
    }

    /// The distance between lines.
    pub fn step(&self) -> f64 {
        f64::from(f32::from_bits(self.exponent << 23))
    }

    /// Steps from the first line.
    fn steps(&self, x: f32) -> f64 {
        // A power of two: multiplying by the inverse is exact.
        (f64::from(x) - f64::from(self.low)) * self.step().recip()
    }

    /// The last line at or below `x`, which must not lie below the first.
    pub fn line_below(&self, x: f32) -> u32 {
        (self.steps(x) as u32).min(255)
    }

    /// The first line at or above `x`; the last where `x` lies beyond it.
    pub fn line_above(&self, x: f32) -> u32 {
        let steps = self.steps(x);
        let line = steps as u32;
        line.saturating_add(u32::from(f64::from(line) < steps)).min(255)
    }
}

/// Byte `index` of a word, the lowest first.
#[inline(always)]
pub(crate) fn byte(word: u32, index: u32) -> u32 {
    (word >> (index * 8)) & 0xff
}
