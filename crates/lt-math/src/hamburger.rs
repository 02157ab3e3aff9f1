//! The sharpest lit-fraction bound from four moments of depths anywhere on the line (Peters & Klein 2015, Alg. 2).

use crate::float;
use crate::hankel::{HankelFactors, mass_at};

/// Upper bound on P(z ≥ d) over all distributions with the factorised moments.
///
/// NaN if an input is NaN or the moments are, in f32, those of no distribution.
#[inline]
pub fn upper_bound(factors: &HankelFactors, receiver_depth: f32) -> f32 {
    let d = receiver_depth;
    if factors.is_mostly_background() && d > 0.0 {
        return float::saturate(factors.moments().x);
    }
    let others = factors.companions(d);
    let (near, far) = (others.x, others.y);
    // Ordered so that NaN companions fall through to the end instead of counting as lit.
    if d <= near {
        1.0
    } else if d > far {
        float::saturate(mass_at(factors.moments(), d, near, far))
    } else if d > near {
        float::saturate(1.0 - mass_at(factors.moments(), near, d, far))
    } else {
        float::nan_from(near)
    }
}
