//! The resolve pass: a shadow ray from a visible sample to the light.

use lt_bvh::{AnyHit, FAR, Ray, offset_origin};
use lt_math::glam::Vec4;

use crate::{abi::Sample, evaluate::to_light, geometry::Geometry};

/// The ray from just above a sample to the light: t runs to 1 at a point light, without end to a directional one.
#[inline]
pub fn shadow_ray(sample: &Sample, light: Vec4) -> Ray {
    let origin = offset_origin(sample.position, sample.normal, sample.magnitude);
    let tmax = if light.w == 0.0 { FAR } else { 1.0 };
    Ray { origin, tmin: 0.0, direction: to_light(origin, light), tmax }
}

/// The truth about one light-facing sample: 1 if the light is seen, 0 if it is blocked.
pub fn trace_visibility<G: Geometry, A: AnyHit>(
    sample: &Sample,
    light: Vec4,
    geometry: G,
    any_hit: A,
) -> f32 {
    if geometry.is_occluded(shadow_ray(sample, light), any_hit) { 0.0 } else { 1.0 }
}
