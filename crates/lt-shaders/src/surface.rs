//! Surfaces at a hit: coverage (the alpha test inside the traversal), transmittance, colour, shading normal.

use lt_bvh::{AnyHit, Transmit, Triangle};
use lt_math::glam::{Vec2, Vec3, Vec4};

use crate::{
    abi::{Material, Vertex},
    shade::unit,
    texture::{TextureView, unorm_byte, unorm_bytes},
};

/// The vertices of a triangle blended at a point.
#[inline]
pub fn texture_coordinate(corners: &[Vertex; 3], weights: Vec3) -> Vec2 {
    Vec2::new(corners[0].u, corners[0].v) * weights.x
        + Vec2::new(corners[1].u, corners[1].v) * weights.y
        + Vec2::new(corners[2].u, corners[2].v) * weights.z
}

/// Vertex colour blended at a point, linear RGBA.
#[inline]
pub fn vertex_color(corners: &[Vertex; 3], weights: Vec3) -> Vec4 {
    unorm_bytes(corners[0].color) * weights.x
        + unorm_bytes(corners[1].color) * weights.y
        + unorm_bytes(corners[2].color) * weights.z
}

/// Vertex alpha blended at a point.
#[inline]
pub fn vertex_alpha(corners: &[Vertex; 3], weights: Vec3) -> f32 {
    let alphas = Vec3::new(
        (corners[0].color >> 24) as f32,
        (corners[1].color >> 24) as f32,
        (corners[2].color >> 24) as f32,
    );
    (alphas.x * weights.x + alphas.y * weights.y + alphas.z * weights.z) * (1.0 / 255.0)
}

/// Weights of the three vertices from barycentric u and v.
#[inline]
pub fn barycentric_weights(u: f32, v: f32) -> Vec3 {
    Vec3::new(1.0 - u - v, u, v)
}

/// The vertices of a triangle.
#[inline]
pub fn corners_of(triangle: &Triangle, vertices: &[Vertex]) -> [Vertex; 3] {
    let indices = triangle.indices();
    [vertices[indices[0] as usize], vertices[indices[1] as usize], vertices[indices[2] as usize]]
}

/// Alpha of a point of a surface that has any: factor × texture × vertex alpha (glTF 2.0, §3.9.4).
#[inline]
pub fn alpha(material: &Material, corners: &[Vertex; 3], weights: Vec3, alpha_texels: &[u32]) -> f32 {
    let mut alpha = material.base_color.w * vertex_alpha(corners, weights);
    if material.alpha_size != 0 {
        let view =
            TextureView { offset: material.alpha_offset, size: material.alpha_size, flags: material.flags };
        let quad = view.quad(texture_coordinate(corners, weights));
        alpha *= unorm_byte(alpha_texels, quad.indices[0]) * quad.weights.x
            + unorm_byte(alpha_texels, quad.indices[1]) * quad.weights.y
            + unorm_byte(alpha_texels, quad.indices[2]) * quad.weights.z
            + unorm_byte(alpha_texels, quad.indices[3]) * quad.weights.w;
    }
    alpha
}

/// Whether a surface covers a point: its alpha against the cut-off (glTF 2.0, §3.9.4).
#[inline]
pub fn covers(material: &Material, corners: &[Vertex; 3], weights: Vec3, alpha_texels: &[u32]) -> bool {
    material.cutoff <= 0.0 || alpha(material, corners, weights, alpha_texels) >= material.cutoff
}

/// Share of a point of a surface that it covers, in [0, 1]: its alpha where it blends, else all or nothing.
#[inline]
fn covered_share(material: &Material, corners: &[Vertex; 3], weights: Vec3, alpha_texels: &[u32]) -> f32 {
    if material.cutoff <= 0.0 {
        return 1.0;
    }
    let alpha = alpha(material, corners, weights, alpha_texels);
    if material.flags & Material::BLENDS != 0 {
        unit(alpha)
    } else if alpha >= material.cutoff {
        1.0
    } else {
        0.0
    }
}

/// Share of the light that a point of a surface scatters, in [0, 1]: of what is covered all but its transmission.
#[inline]
pub fn scattering(material: &Material, corners: &[Vertex; 3], weights: Vec3, alpha_texels: &[u32]) -> f32 {
    unit(covered_share(material, corners, weights, alpha_texels) * (1.0 - material.transmission))
}

/// Share of the light that passes a point of a surface, linear RGB in [0, 1].
///
/// What is not covered lets all light pass, what is covered its transmission times its base colour
/// (KHR_materials_transmission, without refraction or roughness). A blended surface covers its alpha's share of a point,
/// any other all or nothing.
#[inline]
pub fn transmittance(
    material: &Material,
    corners: &[Vertex; 3],
    weights: Vec3,
    alpha_texels: &[u32],
    color_texels: &[u32],
) -> Vec3 {
    let covered = covered_share(material, corners, weights, alpha_texels);
    let color =
        plain_color(material, corners, weights) * texture_color(material, corners, weights, color_texels);
    let passes = color * (covered * material.transmission) + Vec3::splat(1.0 - covered);
    Vec3::new(unit(passes.x), unit(passes.y), unit(passes.z))
}

/// What translucent casters let through, for traversal.
#[derive(Clone, Copy)]
pub struct Translucence<'a> {
    /// Triangles of the translucent casters' tree in leaf order.
    pub triangles: &'a [Triangle],
    /// Vertex attributes.
    pub vertices: &'a [Vertex],
    /// Materials.
    pub materials: &'a [Material],
    /// Coverage texels, four to a word.
    pub alpha_texels: &'a [u32],
    /// Colour texels, one word each.
    pub color_texels: &'a [u32],
}

impl Transmit for Translucence<'_> {
    fn transmittance(&self, triangle: u32, u: f32, v: f32) -> Vec3 {
        let corners = corners_of(&self.triangles[triangle as usize], self.vertices);
        let material = self.materials[corners[0].material as usize];
        let weights = barycentric_weights(u, v);
        transmittance(&material, &corners, weights, self.alpha_texels, self.color_texels)
    }
}

/// Whether a surface blocks light at a point: it casts, and it covers the point.
#[inline]
pub fn blocks(material: &Material, corners: &[Vertex; 3], weights: Vec3, alpha_texels: &[u32]) -> bool {
    material.flags & Material::CASTS != 0 && covers(material, corners, weights, alpha_texels)
}

/// Alpha test for traversal: which hits count, for rays of one purpose.
#[derive(Clone, Copy)]
pub struct Coverage<'a> {
    /// Triangles in leaf order.
    pub triangles: &'a [Triangle],
    /// Vertex attributes.
    pub vertices: &'a [Vertex],
    /// Materials.
    pub materials: &'a [Material],
    /// Coverage texels, four to a word.
    pub alpha_texels: &'a [u32],
    /// A surface counts only if its flags hold all of these: [`Material::CASTS`] for shadow rays, 0 for camera rays.
    pub required_flags: u32,
}

impl AnyHit for Coverage<'_> {
    fn accepts(&self, triangle: u32, u: f32, v: f32) -> bool {
        let corners = corners_of(&self.triangles[triangle as usize], self.vertices);
        let material = self.materials[corners[0].material as usize];
        material.flags & self.required_flags == self.required_flags
            && covers(&material, &corners, barycentric_weights(u, v), self.alpha_texels)
    }
}

/// Colour of a surface without texture, linear RGB.
#[inline]
pub fn plain_color(material: &Material, corners: &[Vertex; 3], weights: Vec3) -> Vec3 {
    material.base_color.truncate() * vertex_color(corners, weights).truncate()
}

/// Colour of the surface's texture at a point, linear RGB (decoded from sRGB by squaring); white without one.
#[inline]
pub fn texture_color(
    material: &Material,
    corners: &[Vertex; 3],
    weights: Vec3,
    color_texels: &[u32],
) -> Vec3 {
    if material.color_size == 0 {
        return Vec3::ONE;
    }
    let view =
        TextureView { offset: material.color_offset, size: material.color_size, flags: material.flags };
    let quad = view.quad(texture_coordinate(corners, weights));
    let encoded = unorm_bytes(color_texels[quad.indices[0] as usize]) * quad.weights.x
        + unorm_bytes(color_texels[quad.indices[1] as usize]) * quad.weights.y
        + unorm_bytes(color_texels[quad.indices[2] as usize]) * quad.weights.z
        + unorm_bytes(color_texels[quad.indices[3] as usize]) * quad.weights.w;
    let rgb = encoded.truncate();
    rgb * rgb
}

/// A unit vector from its octahedral encoding (Cigolle et al. 2014): two 16-bit signed fractions.
#[inline]
pub fn octahedral_decode(word: u32) -> Vec3 {
    let x = ((word << 16) as i32 >> 16) as f32 * (1.0 / 32767.0);
    let y = (word as i32 >> 16) as f32 * (1.0 / 32767.0);
    let z = 1.0 - x.abs() - y.abs();
    let folded = if z < 0.0 { -z } else { 0.0 };
    let shift = |c: f32| if c < 0.0 { c + folded } else { c - folded };
    Vec3::new(shift(x), shift(y), z).normalize()
}

/// The octahedral encoding of a unit vector; see [`octahedral_decode`]. Never yields [`Vertex::NO_NORMAL`].
#[cfg(not(target_arch = "spirv"))]
#[inline]
pub fn octahedral_encode(n: Vec3) -> u32 {
    let n = n / (n.x.abs() + n.y.abs() + n.z.abs());
    let (mut x, mut y) = (n.x, n.y);
    if n.z < 0.0 {
        (x, y) = ((1.0 - n.y.abs()).copysign(n.x), (1.0 - n.x.abs()).copysign(n.y));
    }
    let quantise =
        |c: f32| (lt_math::float::floor(c * 32767.0 + 0.5) as i32).clamp(-32767, 32767) as u32 & 0xffff;
    quantise(x) | quantise(y) << 16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn octahedral_normals_survive_within_a_ten_thousandth() {
        for i in 0..5000u32 {
            let a = i as f32 * 2.399_963;
            let z = 1.0 - 2.0 * (i as f32 + 0.5) / 5000.0;
            let r = (1.0 - z * z).sqrt();
            let n = Vec3::new(r * a.cos(), r * a.sin(), z);
            let word = octahedral_encode(n);
            assert_ne!(word, Vertex::NO_NORMAL);
            assert!((octahedral_decode(word) - n).length() < 1e-4, "{n}");
        }
    }

    #[test]
    fn what_is_covered_lets_its_transmission_pass_and_the_rest_everything() {
        let corner = Vertex { color: 0xffff_ffff, ..Vertex::default() };
        let through = |m: &Material| transmittance(m, &[corner; 3], Vec3::splat(1.0 / 3.0), &[], &[]);
        let glass = Material {
            base_color: Vec4::new(0.5, 1.0, 0.25, 0.75),
            transmission: 0.5,
            ..Material::default()
        };
        assert_eq!(through(&glass), Vec3::new(0.25, 0.5, 0.125));
        let blended = Material { cutoff: 0.5, flags: Material::BLENDS, ..glass };
        assert_eq!(through(&blended), Vec3::new(0.1875, 0.375, 0.09375) + 0.25);
        let masked = |w| Material { base_color: glass.base_color.truncate().extend(w), cutoff: 0.5, ..glass };
        assert_eq!(through(&masked(0.4)), Vec3::ONE);
        assert_eq!(through(&masked(0.5)), through(&glass));
        let opaque = Material { transmission: 0.0, ..glass };
        assert_eq!(through(&opaque), Vec3::ZERO);
        let scattered = |m: &Material| scattering(m, &[corner; 3], Vec3::splat(1.0 / 3.0), &[]);
        assert_eq!([glass, blended, masked(0.4), opaque].map(|m| scattered(&m)), [0.5, 0.375, 0.0, 1.0]);
        let broken = Material { base_color: Vec4::NAN, ..glass };
        assert_eq!(through(&broken), Vec3::ZERO);
    }

    #[test]
    fn coverage_is_factor_times_texture_times_vertex_alpha() {
        let corner = Vertex { color: 0xffff_ffff, ..Vertex::default() };
        let half = Vertex { color: 0x80ff_ffff, ..Vertex::default() };
        let mut material = Material { base_color: Vec4::ONE, cutoff: 0.5, ..Material::default() };
        let centre = Vec3::splat(1.0 / 3.0);
        assert!(covers(&material, &[corner; 3], centre, &[]));
        material.base_color.w = 0.9;
        assert!(!covers(&material, &[half; 3], centre, &[]));
        material.alpha_size = 1 | 1 << 16;
        assert!(covers(&material, &[corner; 3], centre, &[255]));
        assert!(!covers(&material, &[corner; 3], centre, &[100]));
        material.cutoff = 0.0;
        assert!(covers(&material, &[half; 3], centre, &[0]));
    }
}
