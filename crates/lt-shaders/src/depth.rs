//! The depth map pass: casters projected into the light's map, holes cut by the alpha test.

use lt_bvh::{Instance, Triangle};
use lt_math::LightProjection;
use lt_math::float::dot4;
use lt_math::glam::{Vec2, Vec3, Vec4, Vec4Swizzles};

use crate::abi::{DepthParams, Material, Vertex};
use crate::surface::{blocks, corners_of};

/// Corner 0, 1 or 2 of a triangle.
#[inline]
pub fn corner(triangle: &Triangle, index: u32) -> Vec3 {
    if index == 0 {
        triangle.v0
    } else if index == 1 {
        triangle.v1
    } else {
        triangle.v2
    }
}

/// World position of a corner of a placed triangle.
#[inline]
pub fn placed_corner(triangle: &Triangle, index: u32, instance: &Instance) -> Vec3 {
    instance.point_to_world(corner(triangle, index))
}

/// Homogeneous clip-space position for the hardware rasteriser: y up, depth in [0, 1], as WebGPU has it
/// (naga turns y over for Vulkan).
///
/// The depth of a perspective map is not linear on it, so that hardware cannot interpolate it: its fragments compute theirs
/// ([`depth_at`]), and z here only cuts off what is nearer than [`DepthParams::near`].
#[inline]
pub fn clip_position(d: &DepthParams, world: Vec3) -> Vec4 {
    let (projection, p) = (&d.projection, world.extend(1.0));
    let w = dot4(projection.row_w, p);
    let (x, y) = (dot4(projection.row_x, p), dot4(projection.row_y, p));
    let z = if d.near > 0.0 { d.near } else { dot4(projection.row_z, p) * w };
    Vec4::new(2.0 * x - w, w - 2.0 * y, z, w)
}

/// Homogeneous position in texels: x/w right, y/w down; z is the depth, not to be divided. On directional maps w is 1.
#[inline]
pub fn map_position(projection: &LightProjection, world: Vec3, map_size: u32) -> Vec4 {
    let p = world.extend(1.0);
    let size = map_size as f32;
    Vec4::new(
        dot4(projection.row_x, p) * size,
        dot4(projection.row_y, p) * size,
        dot4(projection.row_z, p),
        dot4(projection.row_w, p),
    )
}

/// A triangle's corners on a map ([`map_position`]).
#[inline]
pub fn on_map(p: &DepthParams, triangle: &Triangle) -> [Vec4; 3] {
    let place = |i| map_position(&p.projection, corner(triangle, i), p.map_size);
    [place(0), place(1), place(2)]
}

/// The same of a placed triangle.
#[inline]
pub fn placed_on_map(p: &DepthParams, triangle: &Triangle, instance: &Instance) -> [Vec4; 3] {
    let place = |i| map_position(&p.projection, placed_corner(triangle, i, instance), p.map_size);
    [place(0), place(1), place(2)]
}

/// Whether a triangle with these corners on the map blocks light at a point of it (texels): whether it has no hole there.
#[inline]
pub fn blocks_at(
    point: Vec2,
    on_map: &[Vec4; 3],
    triangle: &Triangle,
    vertices: &[Vertex],
    materials: &[Material],
    alpha_texels: &[u32],
) -> bool {
    let corners = corners_of(triangle, vertices);
    blocks(&materials[corners[0].material as usize], &corners, weights_at(point, on_map), alpha_texels)
}

/// Barycentric weights, in space, of what a triangle shows at a point of the map (texels), from homogeneous edge functions
/// (Olano and Greer 1997): corners may lie behind the light. A degenerate triangle gives its first corner.
///
/// Both rasterisers look coverage up at these weights, so that they cut the same holes whatever the hardware's own
/// interpolation rounds to.
#[inline]
pub fn weights_at(point: Vec2, corners: &[Vec4; 3]) -> Vec3 {
    let from = |corner: Vec4| corner.xy() - point * corner.w;
    let (a, b, c) = (from(corners[0]), from(corners[1]), from(corners[2]));
    let (u, v, w) = (c.perp_dot(b), a.perp_dot(c), b.perp_dot(a));
    let area = u + v + w;
    if area == 0.0 {
        return Vec3::X;
    }
    Vec3::new(u, v, w) / area
}

/// Depth of what a triangle shows at a point of a perspective map, never past the corners' own depths nor out of [0, 1].
#[inline]
pub fn depth_at(point: Vec2, corners: &[Vec4; 3]) -> f32 {
    let weights = weights_at(point, corners);
    let z = Vec3::new(corners[0].z, corners[1].z, corners[2].z);
    let depth = weights.x * z.x + weights.y * z.y + weights.z * z.z;
    let lesser = |a: f32, b: f32| if a < b { a } else { b };
    let greater = |a: f32, b: f32| if a > b { a } else { b };
    let low = greater(lesser(lesser(z.x, z.y), z.z), 0.0);
    let high = lesser(greater(greater(z.x, z.y), z.z), 1.0);
    // Written so that a sliver's NaN gives its nearest corner.
    if depth > low { if depth < high { depth } else { high } } else { low }
}
