//! Bilinear footprints: which four texels surround a position, how much each counts, and the blend of four vectors.

use crate::float;
use crate::lanes::step4;
use glam::{IVec2, Vec2, Vec4};

/// The 2×2 texels around a position and their bilinear weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// The texel with the smallest x and y of the four; may lie outside the map, the caller clamps.
    pub texel: IVec2,
    /// Weights in [0, 1] that sum to 1, in the order (x0 y0, x1 y0, x0 y1, x1 y1). NaN for a NaN position.
    pub weights: Vec4,
}

/// The bilinear footprint of `position_texel`, given in texels with texel centres at + 0.5.
///
/// On a texel's centre, that texel has weight 1. NaN positions have NaN weights, hence end in a ray.
#[inline]
pub fn bilinear_footprint(position_texel: Vec2) -> Footprint {
    let x = position_texel.x - 0.5;
    let y = position_texel.y - 0.5;
    let x0 = float::floor(x);
    let y0 = float::floor(y);
    let fx = x - x0;
    let fy = y - y0;
    Footprint {
        texel: IVec2::new(x0 as i32, y0 as i32),
        weights: Vec4::new((1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy),
    }
}

/// `w.x·b0 + w.y·b1 + w.z·b2 + w.w·b3`, each channel summed left to right.
#[inline]
pub fn blend(b0: Vec4, b1: Vec4, b2: Vec4, b3: Vec4, weights: Vec4) -> Vec4 {
    b0 * weights.x + b1 * weights.y + b2 * weights.z + b3 * weights.w
}

/// Σ wᵢ [zᵢ ≥ d]: the weighted share of the four depths that do not block the receiver, before any rounding to [0, 1].
///
/// NaN if any input is NaN.
#[inline]
pub fn lit_fraction(depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
    float::dot4(step4(depths, receiver_depth), weights)
}

/// 1 if `depth` ≥ `receiver_depth`, 0 if smaller, NaN if either is NaN.
#[inline]
pub fn step(depth: f32, receiver_depth: f32) -> f32 {
    if float::is_nan(depth) {
        depth
    } else if float::is_nan(receiver_depth) {
        receiver_depth
    } else if depth < receiver_depth {
        0.0
    } else {
        1.0
    }
}
