//! What every kind of shadow map must be able to do: turn depths into vectors, and vectors into visibility.

use crate::gather::blend;
use glam::Vec4;

/// One kind of shadow map: what it stores and how it answers. Implementers are plain parameters.
///
/// Depths grow away from the light: 0 at its near plane, 1 at its far plane. Depths outside that range (a clear value,
/// a receiver beyond the far plane) count as 0 or 1. Visibility is 1 where lit and 0 where shadowed.
///
/// Answers of the filterable kinds are upper bounds on the lit fraction of the footprint: they may be too bright, never
/// too dark.
pub trait ShadowTest: Copy {
    /// The vector b(z) that this map stores for `depth` in [0, 1]; unused channels are 0.
    fn depth_vector(&self, depth: f32) -> Vec4;

    /// Visibility in [0, 1] of a receiver at `receiver_depth`, from depth vectors that any kernel of weights summing to
    /// 1 has blended.
    ///
    /// NaN only if an input is NaN or the bound's equations cannot be solved in f32: [`crate::needs_ray`] then asks for
    /// a ray.
    fn visibility(&self, filtered: Vec4, receiver_depth: f32) -> f32;

    /// Visibility in [0, 1] of a receiver at `receiver_depth`, from the four plain depths of a 2×2 gather and their
    /// bilinear weights (non-negative, sum 1, same order): paper §3.2.
    ///
    /// NaN as in [`ShadowTest::visibility`].
    fn visibility_of_gather(&self, depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
        let filtered = blend(
            self.depth_vector(depths.x),
            self.depth_vector(depths.y),
            self.depth_vector(depths.z),
            self.depth_vector(depths.w),
            weights,
        );
        self.visibility(filtered, receiver_depth)
    }
}
