//! Shading good enough to look at: lights times visibility, sky from above, haze with distance.

use lt_math::glam::{UVec2, Vec3, Vec4};

use crate::{
    abi::{LightParams, Sample, ShadeParams, Sight},
    camera::view_direction,
    evaluate::to_light,
};

/// Sky at the horizon and at the zenith, linear RGB.
const HORIZON: Vec3 = Vec3::new(0.72, 0.80, 0.90);
const ZENITH: Vec3 = Vec3::new(0.22, 0.42, 0.78);
/// Light bounced from the ground, linear RGB.
const BOUNCE: Vec3 = Vec3::new(0.16, 0.14, 0.12);
/// Share of the sky that reaches a surface.
const SKY_STRENGTH: f32 = 0.42;

/// What one light gives to a surface, linear RGB; the sum over all lights goes to [`shade`]. `reaching` is the share of the
/// light that reaches it: visibility times tint.
#[inline]
pub fn light_on(sample: &Sample, reaching: Vec3, p: &ShadeParams) -> Vec3 {
    let to_light = to_light(sample.position, &p.light);
    let facing = sample.shading_normal.dot(to_light.normalize());
    let strength = if facing > 0.0 { facing * falloff(to_light, &p.light) } else { 0.0 };
    if strength > 0.0 { p.light_color.truncate() * (reaching * strength) } else { Vec3::ZERO }
}

/// Colour of a pixel's only sample, sRGB in three bytes from the lowest, alpha 255. `light` is what all lights give: see
/// [`light_on`]. Of the parameters, camera and haze are read.
#[inline]
pub fn shade(at: UVec2, sample: &Sample, light: Vec3, p: &ShadeParams) -> u32 {
    pack_srgb(color(at, sample, light, p))
}

/// A picture's samples in linear light.
pub trait LinearSource: Copy {
    /// Linear RGB of sample `at`.
    fn linear(&self, at: UVec2) -> Vec3;
}

/// Samples and the light that they receive, row by row.
#[derive(Clone, Copy)]
pub struct LitRows<'a> {
    /// Samples.
    pub samples: &'a [Sample],
    /// What all lights give to each: see [`light_on`].
    pub light: &'a [Vec4],
    /// As for [`shade`].
    pub params: &'a ShadeParams,
}

impl LinearSource for LitRows<'_> {
    #[inline]
    fn linear(&self, at: UVec2) -> Vec3 {
        let i = (at.y * self.params.camera.size.x + at.x) as usize;
        color(at, &self.samples[i], self.light[i].truncate(), self.params)
    }
}

/// Finished colours, row by row.
#[derive(Clone, Copy)]
pub struct ColorRows<'a> {
    /// Linear RGB.
    pub colors: &'a [Vec4],
    /// Samples in a row.
    pub width: u32,
}

impl LinearSource for ColorRows<'_> {
    #[inline]
    fn linear(&self, at: UVec2) -> Vec3 {
        self.colors[(at.y * self.width + at.x) as usize].truncate()
    }
}

/// Colour of pixel `px`, the mean over its `grid` of samples, taken before tone and encoding; as from [`shade`].
pub fn shade_mean<S: LinearSource>(px: UVec2, grid: UVec2, source: S) -> u32 {
    let mut sum = Vec3::ZERO;
    let mut i = 0;
    while i < grid.x * grid.y {
        sum += source.linear(px * grid + UVec2::new(i % grid.x, i / grid.x));
        i += 1;
    }
    pack_srgb(sum / (grid.x * grid.y) as f32)
}

/// What one layer of sample `at` adds to its colour, linear RGB: what it scatters, as far as the layers before let it pass; the
/// sky where it is the first that shows nothing. Layers add up to the sample. `light` as for [`shade`].
#[inline]
pub fn layer_color(at: UVec2, sample: &Sample, sight: &Sight, light: Vec3, p: &ShadeParams) -> Vec3 {
    let share = if sample.is_valid() { sample.scattered() } else { 1.0 };
    sight.passes() * (color(at, sample, light, p) * share)
}

/// Linear RGB of sample `at`; `light` and parameters as for [`shade`].
#[inline]
pub fn color(at: UVec2, sample: &Sample, light: Vec3, p: &ShadeParams) -> Vec3 {
    let view = view_direction(at, &p.camera);
    if !sample.is_valid() {
        return sky(view);
    }
    let n = sample.shading_normal;
    let up = 0.5 + 0.5 * n.y;
    let ambient = (HORIZON.lerp(ZENITH, 0.4) * up + BOUNCE * (1.0 - up)) * SKY_STRENGTH;
    // A little form in the shade: surfaces seen edge-on receive less sky.
    let form = 0.8 + 0.2 * n.dot(-view).abs();
    let lit = unpack_albedo(sample.albedo) * (light + ambient * form);
    let distance = (sample.position - p.camera.eye).length();
    let haze = 1.0 - 1.0 / (1.0 + distance * p.light_color.w);
    lit.lerp(HORIZON, haze)
}

/// Share of a light's strength that arrives from `to_light` away: 1 from directional lights, 1 / distance² within a spot
/// light's inner cone, less towards its outer one.
#[inline]
fn falloff(to_light: Vec3, light: &LightParams) -> f32 {
    if light.place.w == 0.0 {
        return 1.0;
    }
    let squared = to_light.dot(to_light);
    let cosine = -to_light.dot(light.axis) / sqrt(squared);
    let width = light.cos_inner - light.cos_outer;
    let cone = if width > 0.0 { unit((cosine - light.cos_outer) / width) } else { 1.0 };
    cone * cone / squared
}

#[inline]
fn sky(view: Vec3) -> Vec3 {
    let height = if view.y > 0.0 { view.y } else { 0.0 };
    HORIZON.lerp(ZENITH, 1.0 - (1.0 - height) * (1.0 - height))
}

/// Linear RGB in [0, 1] to the albedo word of a [`Sample`]: three bytes of square roots.
#[inline]
pub fn pack_albedo(linear: Vec3) -> u32 {
    pack_bytes(Vec3::new(sqrt(unit(linear.x)), sqrt(unit(linear.y)), sqrt(unit(linear.z))))
}

#[inline]
fn unpack_albedo(word: u32) -> Vec3 {
    let root = crate::texture::unorm_bytes(word).truncate();
    root * root
}

#[inline]
fn pack_srgb(linear: Vec3) -> u32 {
    pack_bytes(Vec3::new(srgb(linear.x), srgb(linear.y), srgb(linear.z))) | 0xff00_0000
}

#[inline]
fn pack_bytes(v: Vec3) -> u32 {
    (v.x * 255.0 + 0.5) as u32 | ((v.y * 255.0 + 0.5) as u32) << 8 | ((v.z * 255.0 + 0.5) as u32) << 16
}

/// sRGB encoding within 0.008 (tested) by roots alone, so that CPU and GPU agree on the bits.
#[inline]
fn srgb(linear: f32) -> f32 {
    let x = unit(linear);
    let (r2, r4) = (sqrt(x), sqrt(sqrt(x)));
    unit(0.662_002_7 * r2 + 0.684_122_1 * r4 - 0.323_583_6 * sqrt(r4) - 0.022_541_147 * x)
}

/// Into [0, 1]; NaN becomes 0.
#[inline]
pub(crate) fn unit(x: f32) -> f32 {
    if x > 0.0 { if x < 1.0 { x } else { 1.0 } } else { 0.0 }
}

#[inline]
fn sqrt(x: f32) -> f32 {
    lt_math::float::sqrt(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_formula_is_close_to_srgb() {
        for i in 0..=1000 {
            let x = i as f64 / 1000.0;
            let exact = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
            assert!((f64::from(srgb(x as f32)) - exact).abs() < 0.008, "{x}");
        }
    }

    #[test]
    fn albedo_survives_packing_within_a_byte() {
        for i in 0..=255u32 {
            let root = i as f32 / 255.0;
            assert_eq!(pack_albedo(Vec3::splat(root * root)) & 255, i);
        }
        assert_eq!(pack_albedo(Vec3::new(f32::NAN, -1.0, 2.0)), 255 << 16);
    }
}
