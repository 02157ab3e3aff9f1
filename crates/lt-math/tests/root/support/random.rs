//! Seeded random footprints for measurements and laws (SplitMix64, Steele et al. 2014).

use lt_math::bilinear_footprint;
use lt_math::glam::{Vec2, Vec4};

/// A generator whose sequence depends on the seed alone.
pub struct Random(u64);

impl Random {
    /// Starts the sequence of `seed`.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [0, 1), a multiple of 2⁻²⁴.
    pub fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 16_777_216.0
    }

    /// The bilinear weights of a random place.
    pub fn weights(&mut self) -> Vec4 {
        let place = Vec2::new(self.unit(), self.unit());
        bilinear_footprint(place).weights
    }

    /// Four depths, each one of two random layers.
    pub fn two_layers(&mut self) -> Vec4 {
        let (a, b) = (self.unit(), self.unit());
        let mut pick = || if self.unit() < 0.5 { a } else { b };
        Vec4::new(pick(), pick(), pick(), pick())
    }

    /// Four independent depths.
    pub fn four_depths(&mut self) -> Vec4 {
        Vec4::new(self.unit(), self.unit(), self.unit(), self.unit())
    }
}
