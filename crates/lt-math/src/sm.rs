//! SM: the plain depth test at the nearest texel (Williams 1978).

use crate::gather::step;
use crate::{ShadowTest, float};
use glam::Vec4;

/// Default depth bias of [`Sm`] and [`crate::Pcf`], as a share of the light's depth range.
///
/// The only parameter here that depends on the scene: texels of a slanted surface differ by more than their neighbours'
/// spacing. 1e-3 is 10 cm over 100 m, a usual compromise between acne and detached shadows.
pub const DEFAULT_DEPTH_BIAS: f32 = 1.0e-3;

/// Plain shadow map: stores z, lit where z + bias ≥ d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sm {
    /// Added to the stored depth before the comparison; share of the depth range.
    pub bias: f32,
}

impl Default for Sm {
    fn default() -> Self {
        Self { bias: DEFAULT_DEPTH_BIAS }
    }
}

impl ShadowTest for Sm {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        Vec4::new(float::saturate(depth), 0.0, 0.0, 0.0)
    }

    /// 0 or 1. Blended depths are not a probability: this compares with whatever mean the blend left.
    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        step(filtered.x + self.bias, float::saturate(receiver_depth))
    }

    /// 0 or 1, by the texel with the largest weight; of equal weights, the first.
    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let weight_sum = weights.x + weights.y + weights.z + weights.w;
        if float::is_nan(weight_sum) {
            return weight_sum;
        }
        let mut depth = depths.x;
        let mut largest = weights.x;
        if weights.y > largest {
            depth = depths.y;
            largest = weights.y;
        }
        if weights.z > largest {
            depth = depths.z;
            largest = weights.z;
        }
        if weights.w > largest {
            depth = depths.w;
        }
        self.visibility(self.depth_vector(depth), receiver_depth)
    }
}
