//! PCF: bilinear percentage-closer filtering, depth tests first and the average after (Reeves et al. 1987).

use crate::gather::lit_fraction;
use crate::sm::DEFAULT_DEPTH_BIAS;
use crate::{ShadowTest, Sm, float};
use glam::Vec4;

/// 2×2 bilinear PCF over a plain depth map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pcf {
    /// Added to the stored depths before the comparison; share of the depth range.
    pub bias: f32,
}

impl Default for Pcf {
    fn default() -> Self {
        Self { bias: DEFAULT_DEPTH_BIAS }
    }
}

impl ShadowTest for Pcf {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        Sm { bias: self.bias }.depth_vector(depth)
    }

    /// 0 or 1, as for [`Sm`]: PCF cannot be filtered beforehand.
    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        Sm { bias: self.bias }.visibility(filtered, receiver_depth)
    }

    /// Σ wᵢ [zᵢ + bias ≥ d]: exact for the footprint, up to the bias (eq. 1).
    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let biased = float::saturate4(depths) + Vec4::splat(self.bias);
        float::saturate(lit_fraction(biased, weights, float::saturate(receiver_depth)))
    }
}
