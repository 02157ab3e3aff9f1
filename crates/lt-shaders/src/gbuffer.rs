//! An engine's own G-buffer as visible samples.

use lt_math::glam::{Vec3, Vec4};

use crate::abi::Sample;

/// A sample from a position texel (world xyz; w = largest absolute world coordinate of the triangle's vertices, or 0
/// to use the position's own) and a normal texel (unit geometric normal facing the camera; zero where nothing is
/// visible). All such surfaces receive shadows.
#[inline]
pub fn sample_from_texels(position: Vec4, normal: Vec4) -> Sample {
    let p = position.truncate();
    let own = p.abs().max_element();
    Sample {
        position: p,
        magnitude: if position.w > own { position.w } else { own },
        normal: normal.truncate(),
        flags: Sample::RECEIVES,
        shading_normal: if normal.truncate() == Vec3::ZERO { Vec3::Y } else { normal.truncate() },
        albedo: 0x00ff_ffff,
    }
}
