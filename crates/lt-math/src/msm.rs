//! MSM: moment shadow maps with the Hamburger and the Hausdorff bound (Peters & Klein 2015).

use crate::hankel::HankelFactors;
use crate::moments::{DEFAULT_MOMENT_BIAS, bias_moments, moments_of_depth};
use crate::{ShadowTest, float, hamburger, hausdorff, six_atoms};
use glam::Vec4;

/// Moment shadow map answered by the Hamburger bound: stores (z, z², z³, z⁴).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MsmHamburger {
    /// Share by which the moments move towards ½ before solving; larger is more stable and less sharp.
    ///
    /// The gather form is biased alike, but solves without cancellation: see [`crate::six_atoms`].
    pub moment_bias: f32,
}

/// Moment shadow map answered by the Hausdorff bound, which also uses that depths lie in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MsmHausdorff {
    /// Share by which the moments move towards ½ before solving; larger is more stable and less sharp.
    ///
    /// The gather form is biased alike, but solves without cancellation: see [`crate::six_atoms`].
    pub moment_bias: f32,
}

impl Default for MsmHamburger {
    fn default() -> Self {
        Self { moment_bias: DEFAULT_MOMENT_BIAS }
    }
}

impl Default for MsmHausdorff {
    fn default() -> Self {
        Self { moment_bias: DEFAULT_MOMENT_BIAS }
    }
}

impl ShadowTest for MsmHamburger {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        moments_of_depth(depth)
    }

    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        let factors = HankelFactors::new(bias_moments(filtered, self.moment_bias));
        hamburger::upper_bound(&factors, float::saturate(receiver_depth))
    }

    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        six_atoms::hamburger_upper_bound(depths, weights, receiver_depth, self.moment_bias)
    }
}

impl ShadowTest for MsmHausdorff {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        moments_of_depth(depth)
    }

    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        let factors = HankelFactors::new(bias_moments(filtered, self.moment_bias));
        hausdorff::upper_bound(&factors, float::saturate(receiver_depth))
    }

    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        six_atoms::hausdorff_upper_bound(depths, weights, receiver_depth, self.moment_bias)
    }
}
