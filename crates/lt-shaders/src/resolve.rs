//! The resolve pass: a shadow ray from a visible sample to the light.

use lt_bvh::{AnyHit, Ray, offset_origin};

use crate::{
    abi::{LightParams, Sample},
    geometry::Geometry,
};

/// The ray from just above a sample to the light: t runs to 1 at a point light, without end to a directional one.
#[inline]
pub fn shadow_ray(sample: &Sample, light: &LightParams) -> Ray {
    Ray::to_light(offset_origin(sample.position, sample.normal, sample.magnitude), light.place)
}

/// The truth about one light-facing sample: 1 if the light is seen, 0 if it is blocked.
pub fn trace_visibility<G: Geometry, A: AnyHit>(
    sample: &Sample,
    light: &LightParams,
    geometry: G,
    any_hit: A,
) -> f32 {
    if geometry.is_occluded(shadow_ray(sample, light), any_hit) { 0.0 } else { 1.0 }
}
