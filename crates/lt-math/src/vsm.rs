//! VSM: variance shadow maps (Donnelly & Lauritzen 2006).

use crate::{ShadowTest, chebyshev, float};
use glam::Vec4;

/// The least variance of depth, in squared shares of the depth range, for [`Vsm`] and [`crate::Evsm`].
///
/// 1e-10 is the leak tracing paper's. A receiver on its own caster differs from the map by rounding, about 1e-7: this
/// variance keeps it lit (v > 0.99) up to 1e-6, and in doubt up to 1e-4.
pub const DEFAULT_MIN_VARIANCE: f32 = 1.0e-10;

/// Variance shadow map: stores (z, z²), answers by the Chebyshev bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vsm {
    /// Lower limit of the variance, in squared depth; 0 gives the pure bound.
    pub min_variance: f32,
}

impl Default for Vsm {
    fn default() -> Self {
        Self { min_variance: DEFAULT_MIN_VARIANCE }
    }
}

impl ShadowTest for Vsm {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        let z = float::saturate(depth);
        Vec4::new(z, z * z, 0.0, 0.0)
    }

    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        let d = float::saturate(receiver_depth);
        float::saturate(chebyshev::from_raw_moments(filtered.x, filtered.y, d, self.min_variance))
    }

    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let d = float::saturate(receiver_depth);
        let offsets = float::saturate4(depths) - Vec4::splat(d);
        float::saturate(chebyshev::from_offsets(offsets, weights, self.min_variance))
    }
}
