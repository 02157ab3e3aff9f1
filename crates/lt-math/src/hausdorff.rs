//! The sharpest lit-fraction bound from four moments of depths known to lie in [0, 1] (Peters & Klein 2015, Alg. 3).

use crate::hankel::{HankelFactors, mass_at};
use crate::{float, hamburger};
use glam::Vec4;

/// Upper bound on P(z ≥ d) over all distributions on [0, 1] with the factorised moments; never above the Hamburger bound.
///
/// NaN if an input is NaN or the moments are, in f32, those of no distribution.
#[inline]
pub fn upper_bound(factors: &HankelFactors, receiver_depth: f32) -> f32 {
    let d = receiver_depth;
    if factors.is_mostly_background() {
        return hamburger::upper_bound(factors, d);
    }
    let others = factors.companions(d);
    if others.x >= 0.0 && others.y <= 1.0 {
        hamburger::upper_bound(factors, d)
    } else if float::is_nan(others.x) {
        others.x
    } else {
        // In exact numbers the second is never smaller; near the ends of [0, 1] rounding may spoil the first.
        float::min(endpoint_upper_bound(factors, d), hamburger::upper_bound(factors, d))
    }
}

/// Below this, `E[x(x−1)(x−d)]` is rounding: nothing lies strictly between the support's other depths 0, d and 1.
///
/// 2⁻²¹, eight roundings of numbers up to 1. A footprint whose depths all equal d, biased, gives exactly 0.
const INNER_NOISE: f32 = 4.768_371_6e-7;

/// Receivers nearer than this are left to the Hamburger bound: the mass on depth 0 is rounding over d, here half of LTT's
/// ε.
const NEAREST_DEPTH: f32 = 1.0e-4;

/// The bound where the unrestricted extreme case would leave [0, 1]: its support is then {0, inner, d, 1} instead.
fn endpoint_upper_bound(factors: &HankelFactors, d: f32) -> f32 {
    let b = factors.moments();
    if d < NEAREST_DEPTH {
        return 1.0;
    }
    // p(x) = x(x−1)(x−d) vanishes on all but `inner`, so that E[x·p(x)] = inner·E[p(x)].
    let at_inner = b.z - (1.0 + d) * b.y + d * b.x;
    let inner = (b.w - (1.0 + d) * b.z + d * b.y) / at_inner;
    if at_inner.abs() <= INNER_NOISE {
        float::saturate(1.0 - mass_at(b, 0.0, d, 1.0))
    } else if inner > 0.0 && inner < d {
        float::saturate(1.0 - cubic_mass(b, 0.0, inner, d, 1.0) - cubic_mass(b, inner, 0.0, d, 1.0))
    } else if inner > d && inner < 1.0 {
        float::saturate(1.0 - cubic_mass(b, 0.0, inner, d, 1.0))
    } else {
        float::nan_from(inner)
    }
}

/// The mass on `at` of the distribution with the given moments on {`at`, `u`, `v`, `w`}.
fn cubic_mass(moments: Vec4, at: f32, u: f32, v: f32, w: f32) -> f32 {
    let b = moments;
    let above = b.z - (u + v + w) * b.y + (u * v + u * w + v * w) * b.x - u * v * w;
    above / ((at - u) * (at - v) * (at - w))
}
