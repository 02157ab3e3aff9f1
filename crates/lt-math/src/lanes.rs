//! Four-lane forms of the scalar float functions, with their very bits: SIMD on CPUs, lane by lane in SPIR-V.
//!
//! [`exp_lane`] and [`floor_lane`] are the same for loops over arrays, which a compiler turns into SIMD of any width: no
//! branch, and no cast that saturates, which x86 has no instruction for.
//!
//! A GPU gains nothing from vectors, and a shader compiler may turn a compare and select into a `min` that hides NaN, so
//! SPIR-V keeps the scalar functions, which look at bits. Tests compare every lane of the CPU form with them.

use glam::Vec4;

#[cfg(not(target_arch = "spirv"))]
mod simd {
    use crate::float::{self, EXP_MAX_ARGUMENT, EXP_MIN_ARGUMENT};
    use glam::Vec4;

    #[inline]
    pub fn saturate4(x: Vec4) -> Vec4 {
        // Comparisons with NaN are false, so that NaN stays itself.
        let x = Vec4::select(x.cmplt(Vec4::ZERO), Vec4::ZERO, x);
        Vec4::select(x.cmpgt(Vec4::ONE), Vec4::ONE, x)
    }

    #[inline]
    pub fn step4(depths: Vec4, receiver_depth: f32) -> Vec4 {
        let d = Vec4::splat(receiver_depth);
        let unblocked = Vec4::select(depths.cmpge(d), Vec4::ONE, depths + d);
        Vec4::select(depths.cmplt(d), Vec4::ZERO, unblocked)
    }

    #[inline]
    pub fn exp4(x: Vec4) -> Vec4 {
        let (least, most) = (Vec4::splat(EXP_MIN_ARGUMENT), Vec4::splat(EXP_MAX_ARGUMENT));
        let clamped = Vec4::select(x.cmplt(least), least, x);
        let clamped = Vec4::select(clamped.cmpgt(most), most, clamped);
        let k = small_floor(clamped * float::LOG2_E + Vec4::splat(0.5));
        let r = (clamped - k * float::LN2_HIGH) - k * float::LN2_LOW;
        let mut p = Vec4::splat(1.0 / 5040.0);
        p = p * r + Vec4::splat(1.0 / 720.0);
        p = p * r + Vec4::splat(1.0 / 120.0);
        p = p * r + Vec4::splat(1.0 / 24.0);
        p = p * r + Vec4::splat(1.0 / 6.0);
        p = p * r + Vec4::splat(0.5);
        p = p * r + Vec4::ONE;
        p = p * r + Vec4::ONE;
        // In k + 127 + 2²³ the exponent's bits are the lowest of the mantissa. A NaN is still one in p.
        let exponent = (k + Vec4::splat(127.0 + 8_388_608.0)).to_array();
        p * Vec4::from_array(exponent.map(|e| f32::from_bits(e.to_bits() << 23)))
    }

    /// The largest integer not above each lane, for magnitudes below 2²²: rounded by an addition, then corrected.
    #[inline]
    fn small_floor(x: Vec4) -> Vec4 {
        let rounder = Vec4::splat(12_582_912.0);
        let nearest = (x + rounder) - rounder;
        nearest - Vec4::select(nearest.cmpgt(x), Vec4::ONE, Vec4::ZERO)
    }
}

/// [`crate::float::floor`] of magnitudes below 2²², without a branch: for loops over many numbers on a CPU.
///
/// Rounded by an addition, then corrected; shader compilers fold that away, so SPIR-V does without.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
pub fn floor_lane(x: f32) -> f32 {
    let nearest = (x + ROUNDER) - ROUNDER;
    let above = if nearest > x { 1.0 } else { 0.0 };
    nearest - above
}

/// An f32 that is a whole number of magnitude below 2²², as an integer: read from the bits of a sum. Anything else gives
/// some number.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
pub fn whole_lane(x: f32) -> i32 {
    ((x + ROUNDER).to_bits() as i32).wrapping_sub(ROUNDER.to_bits() as i32)
}

/// 1.5·2²³: numbers of magnitude below 2²² that are added to it lose their fractions.
#[cfg(not(target_arch = "spirv"))]
const ROUNDER: f32 = 12_582_912.0;

/// [`crate::float::exp`] without a branch, with its bits: for loops over many numbers on a CPU.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
pub fn exp_lane(x: f32) -> f32 {
    use crate::float::{EXP_MAX_ARGUMENT, EXP_MIN_ARGUMENT, LN2_HIGH, LN2_LOW, LOG2_E};
    // Comparisons with NaN are false, so that NaN stays itself.
    let x = if x < EXP_MIN_ARGUMENT { EXP_MIN_ARGUMENT } else { x };
    let x = if x > EXP_MAX_ARGUMENT { EXP_MAX_ARGUMENT } else { x };
    let k = floor_lane(x * LOG2_E + 0.5);
    let r = (x - k * LN2_HIGH) - k * LN2_LOW;
    let mut p = 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    // In k + 127 + 2²³ the exponent's bits are the lowest of the mantissa. A NaN is still one in p.
    p * f32::from_bits((k + (127.0 + 8_388_608.0)).to_bits() << 23)
}

/// [`crate::float::saturate`] of each lane.
#[inline]
pub fn saturate4(x: Vec4) -> Vec4 {
    #[cfg(not(target_arch = "spirv"))]
    return simd::saturate4(x);
    #[cfg(target_arch = "spirv")]
    {
        use crate::float::saturate;
        Vec4::new(saturate(x.x), saturate(x.y), saturate(x.z), saturate(x.w))
    }
}

/// [`crate::float::exp`] of each lane.
#[inline]
pub fn exp4(x: Vec4) -> Vec4 {
    #[cfg(not(target_arch = "spirv"))]
    return simd::exp4(x);
    #[cfg(target_arch = "spirv")]
    {
        use crate::float::exp;
        Vec4::new(exp(x.x), exp(x.y), exp(x.z), exp(x.w))
    }
}

/// Per lane 1 if `depths` ≥ `receiver_depth`, 0 if smaller, NaN if either is NaN.
#[inline]
pub fn step4(depths: Vec4, receiver_depth: f32) -> Vec4 {
    #[cfg(not(target_arch = "spirv"))]
    return simd::step4(depths, receiver_depth);
    #[cfg(target_arch = "spirv")]
    {
        use crate::gather::step;
        let d = receiver_depth;
        Vec4::new(step(depths.x, d), step(depths.y, d), step(depths.z, d), step(depths.w, d))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float::{exp, floor, saturate};
    use crate::gather::step;

    fn assert_same(four: Vec4, lanes: [f32; 4], x: Vec4) {
        for (a, b) in four.to_array().into_iter().zip(lanes) {
            assert!(a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()), "{x}: {a:e} {b:e}");
        }
    }

    const SPECIAL: [f32; 14] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-45,
        -1e-45,
        88.0,
        -87.0,
        89.0,
        -88.0,
        f32::MAX,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];

    #[test]
    fn lanes_have_the_bits_of_the_scalar_functions_at_special_values() {
        for (i, a) in SPECIAL.into_iter().enumerate() {
            for b in SPECIAL {
                let x = Vec4::new(a, b, SPECIAL[(i + 1) % SPECIAL.len()], 0.3);
                assert_same(exp4(x), x.to_array().map(exp), x);
                assert_same(Vec4::from_array(x.to_array().map(exp_lane)), x.to_array().map(exp), x);
                assert_same(saturate4(x), x.to_array().map(saturate), x);
                assert_same(step4(x, b), x.to_array().map(|z| step(z, b)), x);
            }
        }
    }

    #[test]
    fn floor_lane_is_floor_and_whole_lane_its_integer() {
        let fractions = [0.0, 1e-7, 0.25, 0.499_999, 0.5, 0.75, 0.999_999];
        for whole in (-70_000i32..70_000).chain([-4_194_303, -4_194_302, 4_194_302]) {
            for fraction in fractions {
                let x = whole as f32 + fraction;
                assert_eq!(floor_lane(x), floor(x), "{x}");
                assert_eq!(whole_lane(floor(x)), floor(x) as i32, "{x}");
            }
        }
        assert!(floor_lane(f32::NAN).is_nan());
    }

    /// Four million arguments over the whole range, and every half integer of x·log₂e, where the floor is a tie.
    #[test]
    fn exp4_has_the_bits_of_exp_over_its_range() {
        let mut x = -88.5f32;
        while x < 89.0 {
            let four = Vec4::new(x, x + 4.4e-5, x + 8.8e-5, -x);
            assert_same(exp4(four), four.to_array().map(exp), four);
            assert_same(Vec4::from_array(four.to_array().map(exp_lane)), four.to_array().map(exp), four);
            x += 1.7e-4;
        }
        for half in -260..260 {
            let tie = half as f32 * 0.5 * core::f32::consts::LN_2;
            let four = Vec4::new(tie, tie.next_up(), tie.next_down(), tie.next_up().next_up());
            assert_same(exp4(four), four.to_array().map(exp), four);
            assert_same(Vec4::from_array(four.to_array().map(exp_lane)), four.to_array().map(exp), four);
        }
    }
}
