//! ESM: exponential shadow maps (Annen et al. 2008, Salvi 2008).

use crate::{ShadowTest, float};
use glam::Vec4;

/// The leak tracing paper's exponent c on depths in [0, 1].
///
/// Its reference program rescales depths to [−1, 1], where 80 acts as 160 here; we keep the printed meaning.
pub const DEFAULT_ESM_EXPONENT: f32 = 80.0;

/// Larger exponents are clamped: e^{c(z−1)} must stay a normal f32 for z = 0.
pub const MAX_ESM_EXPONENT: f32 = 84.0;

/// Exponential shadow map: answers min(1, Σ w e^{c(z−d)}), the Markov bound on the lit fraction.
///
/// The paper prints `max` for `min`: a misprint. The filtered form stores e^{c(z−1)}, which lies in (1e-37, 1] where the
/// paper's e^{cz} reaches 5.5e34; the scale cancels in the answer. The gather form takes the exponential of the
/// difference and never a ratio of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Esm {
    /// c ≥ 0 per depth range; clamped at [`MAX_ESM_EXPONENT`].
    pub exponent: f32,
}

impl Default for Esm {
    fn default() -> Self {
        Self { exponent: DEFAULT_ESM_EXPONENT }
    }
}

impl Esm {
    /// The exponent that is used.
    #[inline]
    pub fn clamped_exponent(&self) -> f32 {
        float::min(self.exponent, MAX_ESM_EXPONENT)
    }
}

impl ShadowTest for Esm {
    fn depth_vector(&self, depth: f32) -> Vec4 {
        Vec4::new(float::exp(self.clamped_exponent() * (float::saturate(depth) - 1.0)), 0.0, 0.0, 0.0)
    }

    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32 {
        let d = float::saturate(receiver_depth);
        float::saturate(filtered.x * float::exp(self.clamped_exponent() * (1.0 - d)))
    }

    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let c = self.clamped_exponent();
        let d = float::saturate(receiver_depth);
        let ratios = float::exp4(c * (float::saturate4(depths) - Vec4::splat(d)));
        float::saturate(float::dot4(ratios, weights))
    }
}
