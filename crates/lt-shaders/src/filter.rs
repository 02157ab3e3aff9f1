//! The pre-filter: depths to vectors, blurred by a separable Gaussian in two passes.

use lt_math::gaussian_weight;
use lt_math::glam::{UVec2, Vec4};

use crate::{abi::FilterParams, evaluate::TestFromParams};

/// Taps to each side of the centre.
pub const RADIUS: i32 = 2;

#[inline]
fn clamped(base: u32, offset: i32, size: u32) -> u32 {
    (base as i32 + offset).clamp(0, size as i32 - 1) as u32
}

/// First pass: the depths along a row, as vectors, blurred.
pub fn filter_x<T: TestFromParams>(texel: UVec2, p: &FilterParams, depths: &[f32]) -> Vec4 {
    let test = T::from_params(p.test);
    let mut sum = Vec4::ZERO;
    let mut total = 0.0;
    let mut k = -RADIUS;
    while k <= RADIUS {
        let weight = gaussian_weight(k, p.sigma);
        let at = texel.y * p.map_size + clamped(texel.x, k, p.map_size);
        sum += test.depth_vector(depths[at as usize]) * weight;
        total += weight;
        k += 1;
    }
    sum / total
}

/// Second pass: the vectors along a column, blurred.
#[inline]
pub fn filter_y(texel: UVec2, p: &FilterParams, rows: &[Vec4]) -> Vec4 {
    let mut sum = Vec4::ZERO;
    let mut total = 0.0;
    let mut k = -RADIUS;
    while k <= RADIUS {
        let weight = gaussian_weight(k, p.sigma);
        let at = clamped(texel.y, k, p.map_size) * p.map_size + texel.x;
        sum += rows[at as usize] * weight;
        total += weight;
        k += 1;
    }
    sum / total
}
