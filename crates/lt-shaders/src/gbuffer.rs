//! An engine's own G-buffer as visible samples.

use lt_math::glam::{Vec3, Vec4};

use crate::abi::Sample;

/// A sample from a position texel (world xyz; w = largest absolute world coordinate of the triangle's vertices, or 0
/// to use the position's own) and a normal texel (unit geometric normal facing the camera, zero where nothing is
/// visible; w = 0 where the surface receives shadows, anything else where it does not).
#[inline]
pub fn sample_from_texels(position: Vec4, normal: Vec4) -> Sample {
    let p = position.truncate();
    let own = p.abs().max_element();
    Sample {
        position: p,
        magnitude: if position.w > own { position.w } else { own },
        normal: normal.truncate(),
        flags: if normal.w == 0.0 { Sample::RECEIVES } else { 0 },
        shading_normal: if normal.truncate() == Vec3::ZERO { Vec3::Y } else { normal.truncate() },
        albedo: 0x00ff_ffff,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_say_where_a_surface_lies_and_whether_it_receives_shadows() {
        let (position, normal) = (Vec4::new(1.0, -3.0, 2.0, 0.0), Vec4::new(0.0, 1.0, 0.0, 0.0));
        let sample = sample_from_texels(position, normal);
        assert_eq!((sample.position, sample.magnitude), (Vec3::new(1.0, -3.0, 2.0), 3.0));
        assert!(sample.is_valid() && sample.flags & Sample::RECEIVES != 0);
        assert_eq!(sample_from_texels(position.with_w(7.0), normal).magnitude, 7.0);
        assert_eq!(sample_from_texels(position, normal.with_w(1.0)).flags & Sample::RECEIVES, 0);
        assert!(!sample_from_texels(position, Vec4::ZERO).is_valid());
    }
}
