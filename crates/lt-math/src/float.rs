//! The only place that asks where floats come from (std, libm or SPIR-V), with an `exp` of our own whose bits agree everywhere.
//!
//! `exp` is a range reduction by powers of two (Cody & Waite 1980) followed by a Taylor polynomial of degree 7. Nothing
//! but `+ − ×`, `floor` and integer bits is used, so that CPU and GPU return the same bits.

#[cfg(not(target_arch = "spirv"))]
pub use crate::lanes::{exp_lane, floor_lane, whole_lane};
pub use crate::lanes::{exp4, saturate4};
use glam::Vec4;

/// The largest argument that [`exp`] does not clamp; `exp(88) = 1.65e38` is still finite in f32.
pub const EXP_MAX_ARGUMENT: f32 = 88.0;

/// The smallest argument that [`exp`] does not clamp; `exp(-87) = 1.6e-38` is still a normal f32.
pub const EXP_MIN_ARGUMENT: f32 = -87.0;

/// Stated bound of [`exp`]'s relative error against an exact exponential of the same (clamped) f32 argument.
pub const EXP_MAX_RELATIVE_ERROR: f32 = 2.0e-7;

/// ln 2 in two parts (as in fdlibm): this one has trailing zeros, so that k·LN2_HIGH is exact for |k| ≤ 128.
pub(crate) const LN2_HIGH: f32 = 0.693_145_75;
pub(crate) const LN2_LOW: f32 = 1.428_606_8e-6;
pub(crate) const LOG2_E: f32 = core::f32::consts::LOG2_E;

/// Square root; NaN for negative values on the CPU, undefined there on a GPU: test the sign first.
#[inline]
pub fn sqrt(x: f32) -> f32 {
    num_traits::Float::sqrt(x)
}

/// The largest integer not above `x`; NaN gives NaN, −0 gives 0.
///
/// By a cast instead of the library: without SSE 4.1, which no build may assume, that is a function call per pixel.
#[inline]
pub fn floor(x: f32) -> f32 {
    let has_fraction = x > -8_388_608.0 && x < 8_388_608.0;
    let truncated = (x as i32) as f32;
    let down = if truncated > x { 1.0 } else { 0.0 };
    if has_fraction { truncated - down } else { x }
}

/// Whether `x` is NaN, asked of its bits: a shader compiler that assumes away NaNs cannot remove the question.
#[inline]
pub fn is_nan(x: f32) -> bool {
    (x.to_bits() & 0x7fff_ffff) > 0x7f80_0000
}

/// A NaN made from any value by setting bits, because NaN literals do not survive the way to every GPU.
#[inline]
pub fn nan_from(x: f32) -> f32 {
    f32::from_bits(x.to_bits() | 0x7fc0_0000)
}

/// `x` limited to [0, 1]; a NaN stays a NaN.
#[inline]
#[expect(clippy::manual_clamp, reason = "what `clamp` makes of NaN is undefined in SPIR-V")]
pub fn saturate(x: f32) -> f32 {
    if is_nan(x) {
        x
    } else if x < 0.0 {
        0.0
    } else if x > 1.0 {
        1.0
    } else {
        x
    }
}

/// The larger of the two, or a NaN if either is one.
#[inline]
pub fn max(a: f32, b: f32) -> f32 {
    // A NaN in `a` fails the comparison and is returned.
    if is_nan(b) || b > a { b } else { a }
}

/// The smaller of the two, or a NaN if either is one.
#[inline]
pub fn min(a: f32, b: f32) -> f32 {
    if is_nan(b) || b < a { b } else { a }
}

/// `a.x·b.x + a.y·b.y + a.z·b.z + a.w·b.w`, summed left to right; glam's SIMD order differs between machines.
#[inline]
pub fn dot4(a: Vec4, b: Vec4) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w
}

/// `e^x` for `x` clamped to [[`EXP_MIN_ARGUMENT`], [`EXP_MAX_ARGUMENT`]], within [`EXP_MAX_RELATIVE_ERROR`].
///
/// Never infinite, zero or subnormal. NaN gives NaN.
#[inline]
pub fn exp(x: f32) -> f32 {
    if is_nan(x) {
        return x;
    }
    let x = if x < EXP_MIN_ARGUMENT { EXP_MIN_ARGUMENT } else { x };
    let x = if x > EXP_MAX_ARGUMENT { EXP_MAX_ARGUMENT } else { x };
    let k = floor(x * LOG2_E + 0.5);
    let r = (x - k * LN2_HIGH) - k * LN2_LOW;
    let mut p = 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    let scale = f32::from_bits(((k as i32 + 127) as u32) << 23);
    p * scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exp_stays_within_its_stated_error() {
        let mut worst = 0.0f64;
        let mut x = -87.0f32;
        while x <= 88.0 {
            let reference = f64::from(x).exp();
            worst = worst.max((f64::from(exp(x)) - reference).abs() / reference);
            x += 1.7e-4;
        }
        assert!(worst < f64::from(EXP_MAX_RELATIVE_ERROR), "{worst:e}");
    }

    #[test]
    fn exp_is_exact_at_zero_and_finite_normal_everywhere() {
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(-0.0), 1.0);
        for x in [f32::NEG_INFINITY, -1e30, -88.0, -87.0, 88.0, 89.0, 160.0, f32::MAX, f32::INFINITY] {
            assert!(exp(x).is_normal() && exp(x) > 0.0, "{x}");
        }
        assert_eq!(exp(f32::INFINITY), exp(EXP_MAX_ARGUMENT));
        assert_eq!(exp(f32::NEG_INFINITY), exp(EXP_MIN_ARGUMENT));
    }

    #[test]
    fn nan_goes_through_everything() {
        for x in [f32::NAN, -f32::NAN, nan_from(0.5), nan_from(-3.0), nan_from(f32::INFINITY)] {
            assert!(x.is_nan() && is_nan(x));
            assert!(exp(x).is_nan() && saturate(x).is_nan());
            assert!(max(x, 1.0).is_nan() && max(1.0, x).is_nan());
            assert!(min(x, 1.0).is_nan() && min(1.0, x).is_nan());
        }
        for x in [0.0, -0.0, 1.0, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, 1e-45] {
            assert!(!is_nan(x), "{x}");
        }
    }

    #[test]
    fn saturate_min_and_max_order_numbers() {
        assert_eq!([saturate(-1.0), saturate(0.25), saturate(f32::INFINITY)], [0.0, 0.25, 1.0]);
        assert_eq!([max(1.0, 2.0), max(2.0, 1.0), min(1.0, 2.0), min(2.0, 1.0)], [2.0, 2.0, 1.0, 1.0]);
    }

    #[test]
    fn dot4_sums_left_to_right() {
        // Any other order loses the one: (1e8 − 1e8) + 1 + 0.
        assert_eq!(dot4(Vec4::new(1e8, -1e8, 1.0, 0.0), Vec4::ONE), 1.0);
        assert_eq!(dot4(Vec4::new(1.0, 2.0, 3.0, 4.0), Vec4::new(5.0, 6.0, 7.0, 8.0)), 70.0);
    }
}
