//! An orthonormal frame around a direction without degenerate cases (Duff et al. 2017, after Frisvad 2012).

use crate::float;
use glam::Vec3;

/// Three perpendicular unit vectors in world space, `right` × `up` = `forward`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightFrame {
    /// The light map's u axis.
    pub right: Vec3,
    /// Against the light map's v axis.
    pub up: Vec3,
    /// The way light travels; depth grows along it.
    pub forward: Vec3,
}

impl LightFrame {
    /// The frame whose `forward` is the unit vector along `direction`, any length and any orientation.
    ///
    /// Zero, infinite and NaN directions give the frame of a light shining straight down, (0, −1, 0).
    pub fn from_direction(direction: Vec3) -> Self {
        let n = normalize_or_down(direction);
        let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        Self {
            right: Vec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            up: Vec3::new(b, sign + n.y * n.y * a, -n.y),
            forward: n,
        }
    }

    /// The frame that looks through `face` (0…5 = +X, −X, +Y, −Y, +Z, −Z; larger counts as 5) of a cube map, with the
    /// axes that Vulkan, D3D and WebGPU give cube faces.
    pub fn of_cube_face(face: u32) -> Self {
        let (right, up, forward) = match face {
            0 => (Vec3::NEG_Z, Vec3::Y, Vec3::X),
            1 => (Vec3::Z, Vec3::Y, Vec3::NEG_X),
            2 => (Vec3::X, Vec3::NEG_Z, Vec3::Y),
            3 => (Vec3::X, Vec3::Z, Vec3::NEG_Y),
            4 => (Vec3::X, Vec3::Y, Vec3::Z),
            _ => (Vec3::NEG_X, Vec3::Y, Vec3::NEG_Z),
        };
        Self { right, up, forward }
    }

    /// The frame turned about `forward` by this angle, from `right` towards `up`.
    #[cfg(not(target_arch = "spirv"))]
    pub fn rolled(&self, angle_rad: f32) -> Self {
        let (sin, cos) = num_traits::Float::sin_cos(angle_rad);
        Self {
            right: self.right * cos + self.up * sin,
            up: self.up * cos - self.right * sin,
            forward: self.forward,
        }
    }

    /// `p` in this frame: (along right, along up, along forward).
    #[inline]
    pub fn to_light(&self, p: Vec3) -> Vec3 {
        Vec3::new(self.right.dot(p), self.up.dot(p), self.forward.dot(p))
    }
}

/// The cube face (0…5 = +X, −X, +Y, −Y, +Z, −Z) that `direction` leaves through; of equal axes, the first.
#[inline]
pub fn cube_face_of_direction(direction: Vec3) -> u32 {
    let a = direction.abs();
    if a.x >= a.y && a.x >= a.z {
        if direction.x >= 0.0 { 0 } else { 1 }
    } else if a.y >= a.z {
        if direction.y >= 0.0 { 2 } else { 3 }
    } else if direction.z >= 0.0 {
        4
    } else {
        5
    }
}

fn normalize_or_down(direction: Vec3) -> Vec3 {
    // Dividing by the largest part first keeps the squares of tiny and huge directions in range.
    let a = direction.abs();
    let largest = float::max(a.x, float::max(a.y, a.z));
    let scaled = direction / largest;
    let length = float::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
    if largest > 0.0 && (1.0..2.0).contains(&length) { scaled / length } else { Vec3::NEG_Y }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// How far the frame is from orthonormal and right-handed.
    fn defect(f: &LightFrame) -> f32 {
        let unit = |v: Vec3| (v.length() - 1.0).abs();
        let lengths = unit(f.right).max(unit(f.up)).max(unit(f.forward));
        let angles = f.right.dot(f.up).abs().max(f.up.dot(f.forward).abs()).max(f.right.dot(f.forward).abs());
        lengths.max(angles).max((f.right.cross(f.up) - f.forward).length())
    }

    proptest! {
        #[test]
        fn frames_are_orthonormal_and_right_handed(
            x in -1.0f32..1.0, y in -1.0f32..1.0, z in -1.0f32..1.0, exponent in -30i32..30
        ) {
            let direction = Vec3::new(x, y, z) * 10f32.powi(exponent);
            prop_assume!(direction.abs().max_element() > 1e-35);
            let frame = LightFrame::from_direction(direction);
            prop_assert!(defect(&frame) < 2e-6, "{frame:?}");
            prop_assert!(frame.forward.dot(Vec3::new(x, y, z)) > 0.0);
        }
    }

    #[test]
    fn axes_and_their_surroundings_are_not_degenerate() {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z] {
            for tilt in [Vec3::ZERO, Vec3::splat(1e-7), Vec3::splat(-1e-4), Vec3::new(1e-20, -1e-20, 0.0)] {
                let frame = LightFrame::from_direction(axis + tilt);
                assert!(defect(&frame) < 2e-6, "{axis} {tilt} {frame:?}");
                assert!((frame.forward - axis).length() < 1e-3);
            }
        }
    }

    #[test]
    fn no_direction_shines_down() {
        for bad in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY, Vec3::new(f32::NEG_INFINITY, 0.0, 1.0)] {
            let frame = LightFrame::from_direction(bad);
            assert_eq!(frame.forward, Vec3::NEG_Y, "{bad}");
            assert!(defect(&frame) < 2e-6);
        }
    }

    #[test]
    fn a_rolled_frame_is_one_and_looks_the_same_way() {
        let frame = LightFrame::from_direction(Vec3::new(0.3, -1.0, 0.2));
        for angle in [0.0, 0.4, 1.6, -3.0] {
            let rolled = frame.rolled(angle);
            assert!(defect(&rolled) < 1e-6 && rolled.forward == frame.forward);
            assert!((rolled.right.dot(frame.right) - angle.cos()).abs() < 1e-6);
        }
    }

    #[test]
    fn cube_faces_are_frames_around_their_axis() {
        for face in 0..6 {
            let frame = LightFrame::of_cube_face(face);
            assert_eq!(defect(&frame), 0.0);
            assert_eq!(cube_face_of_direction(frame.forward), face);
            assert_eq!(cube_face_of_direction(frame.forward + 0.9 * frame.right - 0.9 * frame.up), face);
        }
    }
}
