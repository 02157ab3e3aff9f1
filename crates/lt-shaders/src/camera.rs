//! The camera pass: one primary ray per sample of a pixel becomes a visible sample.

use lt_bvh::{AnyHit, Hit, Ray};
use lt_math::glam::{UVec2, Vec3, Vec4};

use crate::{
    abi::{CameraParams, Material, Sample, Vertex},
    geometry::Geometry,
    sampling::sample_place,
    shade::pack_albedo,
    surface::{barycentric_weights, corners_of, octahedral_decode, plain_color, texture_color},
};

/// Where a sample's colour comes from.
pub trait ColorSource: Copy {
    /// Texture colour of a surface at a point, linear RGB; white without a texture.
    fn texture_color(&self, material: &Material, corners: &[Vertex; 3], weights: Vec3) -> Vec3;
}

/// The scene has no colour textures.
#[derive(Clone, Copy)]
pub struct NoColorTextures;

impl ColorSource for NoColorTextures {
    fn texture_color(&self, _material: &Material, _corners: &[Vertex; 3], _weights: Vec3) -> Vec3 {
        Vec3::ONE
    }
}

/// Colour texels, one word each.
#[derive(Clone, Copy)]
pub struct ColorTextures<'a> {
    /// All textures, one after the other.
    pub texels: &'a [u32],
}

impl ColorSource for ColorTextures<'_> {
    fn texture_color(&self, material: &Material, corners: &[Vertex; 3], weights: Vec3) -> Vec3 {
        texture_color(material, corners, weights, self.texels)
    }
}

/// Direction of the primary ray of sample `at`, not normalised: length 1 along the view axis.
#[inline]
pub fn primary_direction(at: UVec2, p: &CameraParams) -> Vec3 {
    let place = sample_place(at, p.grid);
    let x = place.x / p.size.x as f32 * 2.0 - 1.0;
    let y = 1.0 - place.y / p.size.y as f32 * 2.0;
    p.forward + p.right * x + p.up * y
}

/// Unit direction from the eye through sample `at`.
#[inline]
pub fn view_direction(at: UVec2, p: &CameraParams) -> Vec3 {
    primary_direction(at, p).normalize()
}

/// The primary ray of sample `at`.
#[inline]
pub fn primary_ray(at: UVec2, p: &CameraParams) -> Ray {
    Ray::new(p.eye, primary_direction(at, p))
}

/// What the primary ray of sample `at` hits first.
pub fn closest<G: Geometry, A: AnyHit>(at: UVec2, p: &CameraParams, geometry: G, any_hit: A) -> Hit {
    geometry.closest(primary_ray(at, p), any_hit)
}

/// Describes what a primary ray hit; [`Sample::default`] on a miss.
pub fn sample_at_hit<G: Geometry, C: ColorSource>(
    hit: &Hit,
    p: &CameraParams,
    geometry: G,
    vertices: &[Vertex],
    materials: &[Material],
    colors: C,
) -> Sample {
    if !hit.is_hit() {
        return Sample::default();
    }
    let weights = barycentric_weights(hit.u, hit.v);
    let world = geometry.corners_world(hit);
    let position = world[0] * weights.x + world[1] * weights.y + world[2] * weights.z;
    let extent = world[0].abs().max(world[1].abs()).max(world[2].abs());
    // Scaled before the cross product: tiny triangles must not underflow, nor huge ones overflow.
    let (edge1, edge2) = (world[1] - world[0], world[2] - world[0]);
    let cross = (edge1 / edge1.abs().max_element()).cross(edge2 / edge2.abs().max_element());
    let to_eye = p.eye - position;
    let face = facing(cross.normalize(), to_eye);
    let corners = corners_of(&geometry.triangle(hit), vertices);
    let material = materials[corners[0].material as usize];
    let albedo =
        plain_color(&material, &corners, weights) * colors.texture_color(&material, &corners, weights);
    Sample {
        position,
        magnitude: extent.max_element(),
        normal: face,
        flags: if material.flags & Material::RECEIVES != 0 { Sample::RECEIVES } else { 0 },
        shading_normal: shading_normal(&corners, weights, hit, geometry, face),
        albedo: pack_albedo(albedo),
    }
}

/// Where the point that a primary ray hit was in the last frame, world space; the camera's own `position` of a surface at
/// rest, bit for bit. Zero on a miss.
///
/// `previous` holds the last positions of the vertices in their tree's space. Placed trees are taken to stand still: what
/// moves is baked.
pub fn previous_position<G: Geometry>(hit: &Hit, geometry: G, previous: &[Vec4]) -> Vec3 {
    if !hit.is_hit() {
        return Vec3::ZERO;
    }
    let weights = barycentric_weights(hit.u, hit.v);
    let i = geometry.triangle(hit).indices();
    // No closure: it would hold the geometry by reference, which rust-gpu cannot take apart for naga.
    let (v0, v1, v2) = (previous[i[0] as usize], previous[i[1] as usize], previous[i[2] as usize]);
    geometry.point_to_world(hit, v0.truncate()) * weights.x
        + geometry.point_to_world(hit, v1.truncate()) * weights.y
        + geometry.point_to_world(hit, v2.truncate()) * weights.z
}

fn shading_normal<G: Geometry>(
    corners: &[Vertex; 3],
    weights: Vec3,
    hit: &Hit,
    geometry: G,
    face: Vec3,
) -> Vec3 {
    if corners[0].normal == Vertex::NO_NORMAL {
        return face;
    }
    let blended = octahedral_decode(corners[0].normal) * weights.x
        + octahedral_decode(corners[1].normal) * weights.y
        + octahedral_decode(corners[2].normal) * weights.z;
    let world = geometry.normal_to_world(hit, blended);
    let length = world.length();
    if length > 0.0 { facing(world / length, face) } else { face }
}

#[inline]
fn facing(normal: Vec3, toward: Vec3) -> Vec3 {
    if normal.dot(toward) < 0.0 { -normal } else { normal }
}
