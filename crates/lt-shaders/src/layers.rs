//! Layers: surfaces one behind the other along a primary ray, as far as those in front let light through. Each layer is a picture of
//! samples of its own, with shadows of its own (Aila and Laine 2004, §5: semi-transparent receivers); shading puts them
//! together ([`crate::shade::layer_color`]).
//!
//! Layers are found front to back, a pass each, by the same primary ray, whose [`Sight`] says from where it goes on. Of surfaces at the
//! very same distance one is seen. The last layer hides what lies behind it.

use lt_bvh::{AnyHit, FAR, Hit, Ray};
use lt_math::glam::{UVec2, Vec3};

use crate::{
    abi::{CameraParams, Material, Sample, Sight, Vertex},
    camera::{ColorTextures, primary_ray, sample_at_hit},
    geometry::Geometry,
    surface::{barycentric_weights, corners_of, scattering, transmittance},
};

/// The ray that finds the next layer of sample `at`.
#[inline]
pub fn next_ray(at: UVec2, p: &CameraParams, sight: &Sight) -> Ray {
    Ray { tmin: sight.t, ..primary_ray(at, p) }
}

/// What the next layer of sample `at` shows; a miss where nothing more is seen.
pub fn next_hit<G: Geometry, A: AnyHit>(
    at: UVec2,
    p: &CameraParams,
    sight: &Sight,
    geometry: G,
    any_hit: A,
) -> Hit {
    if sight.is_open() { geometry.closest(next_ray(at, p, sight), any_hit) } else { Hit::miss(FAR) }
}

/// Buffers of a scene's surfaces.
#[derive(Clone, Copy)]
pub struct Surfaces<'a> {
    /// Vertex attributes.
    pub vertices: &'a [Vertex],
    /// Materials.
    pub materials: &'a [Material],
    /// Coverage texels, four to a word.
    pub alpha_texels: &'a [u32],
    /// Colour texels, one word each.
    pub color_texels: &'a [u32],
}

/// The layer at a hit, [`Sample::default`] on a miss, and how the sight goes on behind it.
pub fn layer_at_hit<G: Geometry>(
    hit: &Hit,
    p: &CameraParams,
    sight: &Sight,
    geometry: G,
    surfaces: Surfaces<'_>,
) -> (Sample, Sight) {
    let closed = Sight { kept: Vec3::ONE, t: sight.t };
    if !hit.is_hit() {
        return (Sample::default(), closed);
    }
    let Surfaces { vertices, materials, alpha_texels, color_texels } = surfaces;
    let colors = ColorTextures { texels: color_texels };
    let sample = sample_at_hit(hit, p, geometry, vertices, materials, colors);
    if p.layers_behind == 0 {
        return (sample.scattering(1.0), closed);
    }
    let weights = barycentric_weights(hit.u, hit.v);
    let corners = corners_of(&geometry.triangle(hit), vertices);
    let material = materials[corners[0].material as usize];
    let scattered = scattering(&material, &corners, weights, alpha_texels);
    let passes = transmittance(&material, &corners, weights, alpha_texels, color_texels);
    (sample.scattering(scattered), Sight { kept: Vec3::ONE - sight.passes() * passes, t: hit.t })
}
