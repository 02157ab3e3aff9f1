//! The depth map pass: casters projected into the light's map, holes cut by the alpha test.

use lt_bvh::{Instance, Triangle};
use lt_math::LightProjection;
use lt_math::float::dot4;
use lt_math::glam::{Vec2, Vec3, Vec4};

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
#[inline]
pub fn clip_position(projection: &LightProjection, world: Vec3) -> Vec4 {
    let p = world.extend(1.0);
    let w = dot4(projection.row_w, p);
    let (x, y) = (dot4(projection.row_x, p), dot4(projection.row_y, p));
    Vec4::new(2.0 * x - w, w - 2.0 * y, dot4(projection.row_z, p) * w, w)
}

/// Position in texels for the software rasteriser: x right, y down, z the depth. Orthographic maps only.
#[inline]
pub fn map_position(projection: &LightProjection, world: Vec3, map_size: u32) -> Vec3 {
    let p = world.extend(1.0);
    let size = map_size as f32;
    Vec3::new(dot4(projection.row_x, p) * size, dot4(projection.row_y, p) * size, dot4(projection.row_z, p))
}

/// Barycentric weights of a point of the map in a projected triangle (texels), from edge functions; a degenerate
/// triangle gives its first corner.
///
/// Both rasterisers look coverage up at these weights, so that they cut the same holes whatever the hardware's own
/// interpolation rounds to.
#[inline]
pub fn weights_at(point: Vec2, corners: &[Vec3; 3]) -> Vec3 {
    let (a, b, c) =
        (corners[0].truncate() - point, corners[1].truncate() - point, corners[2].truncate() - point);
    let (u, v, w) = (c.perp_dot(b), a.perp_dot(c), b.perp_dot(a));
    let area = u + v + w;
    if area == 0.0 {
        return Vec3::X;
    }
    Vec3::new(u, v, w) / area
}
