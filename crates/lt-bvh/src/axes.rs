//! The axis along which a ray runs fastest, and the coordinates turned so that it becomes z.

use lt_math::glam::Vec3;

/// Rotates the components cyclically so that component `axis` (0 to 2) becomes z.
#[inline(always)]
pub fn permute(v: Vec3, axis: u32) -> Vec3 {
    if axis == 0 {
        Vec3::new(v.y, v.z, v.x)
    } else if axis == 1 {
        Vec3::new(v.z, v.x, v.y)
    } else {
        v
    }
}

/// Axis of the largest component, the first of equals, and that component's sign (1 or −1).
#[inline(always)]
pub fn main_axis(direction: Vec3) -> (u32, f32) {
    let d = direction.abs();
    let (axis, along) = if d.x >= d.y && d.x >= d.z {
        (0, direction.x)
    } else if d.y >= d.z {
        (1, direction.y)
    } else {
        (2, direction.z)
    };
    (axis, if along < 0.0 { -1.0 } else { 1.0 })
}
