//! SplitMix64 random numbers (Steele, Lea, Flood 2014): the same on every platform, one stream per thing grown.

use lt_math::glam::Vec3;

/// A small generator; integer arithmetic only, so a seed means the same bytes everywhere.
#[derive(Clone, Debug)]
pub struct Rng {
    state: u64,
}

impl Rng {
    /// The stream numbered `stream` of `seed`; streams are independent for all practical purposes.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut start = Self { state: seed ^ stream.wrapping_mul(0xd6e8_feb8_6659_fd93) };
        let state = start.next_u64() ^ stream;
        Self { state }
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let a = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let b = (a ^ (a >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        b ^ (b >> 31)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.next_u64() >> 40) as f32 / (1u32 << 24) as f32
    }

    /// Uniform in [low, high).
    pub fn range(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// Uniform in 0..count; `count` must not be 0.
    pub fn below(&mut self, count: u32) -> u32 {
        (((self.next_u64() >> 32) * u64::from(count)) >> 32) as u32
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f32) -> bool {
        self.unit() < probability
    }

    /// One of a non-empty list, by reference.
    pub fn pick_ref<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len() as u32) as usize]
    }

    /// One of a non-empty list.
    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len() as u32) as usize]
    }

    /// Uniform in the cube [-1, 1)³.
    pub fn in_cube(&mut self) -> Vec3 {
        Vec3::new(self.range(-1.0, 1.0), self.range(-1.0, 1.0), self.range(-1.0, 1.0))
    }

    /// A uniform unit vector, by rejection from the cube.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.in_cube();
            let length_squared = v.length_squared();
            if (0.01..1.0).contains(&length_squared) {
                return v / length_squared.sqrt();
            }
        }
    }
}
