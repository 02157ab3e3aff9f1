//! The three bits that a pixel remembers per light, and Table 1's names for them (Kern et al. 2024, §3.1).

use lt_math::glam::Vec3;

/// ST, LTT and RS of one light at one pixel in the last frame; six of the eight patterns occur.
///
/// RS is kept only where a ray was traced and reads as lit elsewhere, so that equal histories have equal bits.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaskBits(u32);

impl MaskBits {
    /// How many bits one light takes.
    pub const BIT_COUNT: u32 = 3;
    /// The bits that one light may set.
    pub const ALL: u32 = Self::SHADOW_TEST | Self::TRACED | Self::RAY_HIT;

    /// ST: the shadow test says shadow (visibility below ½).
    const SHADOW_TEST: u32 = 1;
    /// LTT: the final decision; a ray was traced.
    const TRACED: u32 = 2;
    /// RS: the ray hit something.
    const RAY_HIT: u32 = 4;

    /// Confidently lit.
    pub const BLACK: Self = Self(0);
    /// Confidently shadowed.
    pub const GREEN: Self = Self(Self::SHADOW_TEST);
    /// The shadow test says shadowed, and the ray agrees.
    pub const WHITE: Self = Self(Self::TRACED | Self::SHADOW_TEST | Self::RAY_HIT);
    /// The shadow test says lit, the ray corrects it to shadowed.
    pub const PURPLE: Self = Self(Self::TRACED | Self::RAY_HIT);
    /// The shadow test says lit, and the ray agrees.
    pub const RED: Self = Self(Self::TRACED);
    /// The shadow test says shadowed, the ray corrects it to lit.
    pub const YELLOW: Self = Self(Self::TRACED | Self::SHADOW_TEST);
    /// The surface faces away from the light; Table 1 gives it the pattern of [`MaskBits::BLACK`].
    pub const FACING_AWAY: Self = Self::BLACK;

    /// A pixel whose estimate was trusted: black or green.
    #[inline]
    pub fn untraced(is_test_shadowed: bool) -> Self {
        if is_test_shadowed { Self::GREEN } else { Self::BLACK }
    }

    /// A pixel whose ray was traced: white, purple, red or yellow.
    #[inline]
    pub fn traced(is_test_shadowed: bool, is_ray_hit: bool) -> Self {
        let mut bits = Self::TRACED;
        if is_test_shadowed {
            bits |= Self::SHADOW_TEST;
        }
        if is_ray_hit {
            bits |= Self::RAY_HIT;
        }
        Self(bits)
    }

    /// Reads the low three bits of `bits`; drops RS where no ray was traced.
    #[inline]
    pub fn from_bits(bits: u32) -> Self {
        if bits & Self::TRACED != 0 { Self(bits & Self::ALL) } else { Self(bits & Self::SHADOW_TEST) }
    }

    /// The three bits, in the low end.
    #[inline]
    pub fn to_bits(self) -> u32 {
        self.0
    }

    /// M_ST: the shadow test said shadow.
    #[inline]
    pub fn is_test_shadowed(self) -> bool {
        self.0 & Self::SHADOW_TEST != 0
    }

    /// M_LTT: a ray was traced.
    #[inline]
    pub fn is_traced(self) -> bool {
        self.0 & Self::TRACED != 0
    }

    /// M_RS: the ray hit; false where none was traced.
    #[inline]
    pub fn is_ray_hit(self) -> bool {
        self.0 & Self::RAY_HIT != 0
    }

    /// The colour that Table 1 names, linear RGB, for debug views.
    pub fn colour(self) -> Vec3 {
        if !self.is_traced() {
            return if self.is_test_shadowed() { Vec3::new(0.0, 1.0, 0.0) } else { Vec3::ZERO };
        }
        let blue = if self.is_ray_hit() { 1.0 } else { 0.0 };
        let green = if self.is_test_shadowed() { 1.0 } else { 0.0 };
        // White and yellow differ in blue, and so do purple and red.
        Vec3::new(1.0, green, blue)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 1 row by row: (LTT, ST, RS), the state, its colour.
    const TABLE_1: [(bool, bool, bool, MaskBits, [f32; 3]); 6] = [
        (false, false, false, MaskBits::BLACK, [0.0, 0.0, 0.0]),
        (false, true, false, MaskBits::GREEN, [0.0, 1.0, 0.0]),
        (true, true, true, MaskBits::WHITE, [1.0, 1.0, 1.0]),
        (true, false, true, MaskBits::PURPLE, [1.0, 0.0, 1.0]),
        (true, false, false, MaskBits::RED, [1.0, 0.0, 0.0]),
        (true, true, false, MaskBits::YELLOW, [1.0, 1.0, 0.0]),
    ];

    #[test]
    fn table_1_holds_row_by_row() {
        for (ltt, st, rs, state, colour) in TABLE_1 {
            let built = if ltt { MaskBits::traced(st, rs) } else { MaskBits::untraced(st) };
            assert_eq!(built, state);
            assert_eq!((state.is_traced(), state.is_test_shadowed(), state.is_ray_hit()), (ltt, st, rs));
            assert_eq!(state.colour(), Vec3::from_array(colour));
            assert_eq!(MaskBits::from_bits(state.to_bits()), state);
        }
    }

    #[test]
    fn the_six_states_are_distinct() {
        for (i, a) in TABLE_1.iter().enumerate() {
            for b in &TABLE_1[i + 1..] {
                assert_ne!(a.3, b.3);
            }
        }
    }

    #[test]
    fn a_ray_result_without_a_ray_is_dropped() {
        for bits in 0..64 {
            let read = MaskBits::from_bits(bits);
            assert!(TABLE_1.iter().any(|row| row.3 == read), "{bits:#b}");
            assert_eq!(read.is_test_shadowed(), bits & 1 != 0);
            assert_eq!(read.is_traced(), bits & 2 != 0);
        }
        assert_eq!(MaskBits::from_bits(4), MaskBits::BLACK);
        assert_eq!(MaskBits::from_bits(5), MaskBits::GREEN);
    }

    #[test]
    fn facing_away_reads_as_black() {
        assert_eq!(MaskBits::FACING_AWAY, MaskBits::BLACK);
        assert_eq!(MaskBits::default(), MaskBits::BLACK);
    }
}
