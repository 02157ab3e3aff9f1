//! Moment vectors (z, z², z³, z⁴) and the bias that pulls them away from the edge of the solvable set.

use crate::float;
use glam::Vec4;

/// The paper's moment bias for f32 maps (Peters & Klein 2015 use 3e-5 for 16 bits).
pub const DEFAULT_MOMENT_BIAS: f32 = 3.0e-6;

/// The moments (z, z², z³, z⁴) of a single depth, limited to [0, 1] first; NaN stays NaN.
#[inline]
pub fn moments_of_depth(depth: f32) -> Vec4 {
    let z = float::saturate(depth);
    let z2 = z * z;
    Vec4::new(z, z2, z2 * z, z2 * z2)
}

/// `moments` moved by the share `bias` towards ½, the moments of a coin toss between depths 0 and 1 (Peters & Klein
/// 2015, Alg. 2, step 1).
#[inline]
pub fn bias_moments(moments: Vec4, bias: f32) -> Vec4 {
    moments * (1.0 - bias) + Vec4::splat(0.5 * bias)
}
