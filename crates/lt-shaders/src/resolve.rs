//! The resolve pass: a shadow ray from a visible sample to the light. The tint pass: what translucent casters leave of it.

use lt_bvh::{AnyHit, Node, Ray, offset_origin, transmitted};
use lt_math::glam::Vec3;

use crate::{
    abi::{LightParams, Sample},
    evaluate::settle,
    geometry::Occluder,
    surface::Translucence,
};

/// The ray from just above a sample to the light: t runs to 1 at a point light, without end to a directional one.
#[inline]
pub fn shadow_ray(sample: &Sample, light: &LightParams) -> Ray {
    Ray::to_light(offset_origin(sample.position, sample.normal, sample.magnitude), light.place)
}

/// The truth about one light-facing sample: 1 if the light is seen, 0 if it is blocked.
pub fn trace_visibility<G: Occluder, A: AnyHit>(
    sample: &Sample,
    light: &LightParams,
    geometry: G,
    any_hit: A,
) -> f32 {
    if geometry.is_occluded(shadow_ray(sample, light), any_hit) { 0.0 } else { 1.0 }
}

/// Whether translucent casters may tint the light that reaches a sample: some does, and shadows fall on it.
#[inline]
pub fn may_be_tinted(sample: &Sample, light: &LightParams, visibility: f32) -> bool {
    visibility > 0.0 && !settle(sample, light).1
}

/// The share of the light that translucent casters let through to a sample, linear RGB in [0, 1]; white where nothing
/// could tint it. `nodes` is a tree of translucent casters alone.
pub fn trace_tint(
    sample: &Sample,
    light: &LightParams,
    visibility: f32,
    nodes: &[Node],
    casters: Translucence<'_>,
) -> Vec3 {
    if !may_be_tinted(sample, light, visibility) {
        return Vec3::ONE;
    }
    transmitted(nodes, casters.triangles, shadow_ray(sample, light), casters)
}
