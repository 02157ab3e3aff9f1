//! Where a camera goes: a start, and how it moves from there.

use lt_math::glam::{Quat, Vec3};

use crate::Camera;

/// A smooth way of a camera that never ends: its start, and what changes per unit of way.
///
/// Lengths are in distances from the eye to its target at the start, so that a path fits a scene of any size. How fast
/// the way is walked is the caller's choice: see [`CameraPath::at`].
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    /// Where it begins.
    pub start: Camera,
    /// Moves eye and target along the view, kept level (perpendicular to `up`).
    pub dolly: f32,
    /// Moves eye and target to the right.
    pub truck: f32,
    /// Moves eye and target up.
    pub rise: f32,
    /// Turns the eye around its target, radians, to the right (seen from the eye).
    pub orbit_rad: f32,
    /// Turns the target around the eye, radians, to the right.
    pub pan_rad: f32,
    /// Rocks the eye to the right and back, as a walker does: amplitude, one cycle per unit of way.
    pub sway: f32,
}

impl CameraPath {
    /// A slow orbit around what the camera looks at, drawing nearer: for any view of any scene.
    pub fn around_target(start: Camera) -> Self {
        Self { start, dolly: 0.12, truck: 0.0, rise: 0.02, orbit_rad: 0.6, pan_rad: 0.05, sway: 0.0 }
    }

    /// The camera after `way` units.
    ///
    /// A `way` of 0 gives the start itself, bit for bit. A camera that looks along its `up` has no level direction and
    /// moves along an arbitrary one.
    pub fn at(&self, way: f32) -> Camera {
        let start = &self.start;
        if way == 0.0 {
            return start.clone();
        }
        let up = start.up.try_normalize().unwrap_or(Vec3::Y);
        let view = start.target - start.eye;
        let distance = view.length();
        let right = view.cross(up).try_normalize().unwrap_or_else(|| up.any_orthonormal_vector());
        let level = up.cross(right);
        let sway = self.sway * (way * std::f32::consts::TAU).sin();
        let step = (level * self.dolly + right * self.truck + up * self.rise) * way + right * sway;
        let turned = Quat::from_axis_angle(up, self.orbit_rad * way) * -view;
        let target = start.target + step * distance;
        let eye = target + turned;
        let target = eye + Quat::from_axis_angle(up, -self.pan_rad * way) * (target - eye);
        Camera { eye, target, ..start.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn start() -> Camera {
        Camera {
            name: String::new(),
            eye: Vec3::new(1.0, 2.0, 8.0),
            target: Vec3::new(1.0, 2.0, 0.0),
            up: Vec3::Y,
            fov_y_rad: 1.0,
        }
    }

    const STILL: CameraPath = CameraPath {
        start: Camera { name: String::new(), eye: Vec3::ZERO, target: Vec3::Z, up: Vec3::Y, fov_y_rad: 1.0 },
        dolly: 0.0,
        truck: 0.0,
        rise: 0.0,
        orbit_rad: 0.0,
        pan_rad: 0.0,
        sway: 0.0,
    };

    #[test]
    fn no_way_is_the_start_itself() {
        assert_eq!(CameraPath::around_target(start()).at(0.0), start());
    }

    #[test]
    fn each_part_moves_as_it_says() {
        let at = |path: CameraPath| {
            let c = CameraPath { start: start(), ..path }.at(0.5);
            (c.eye, c.target)
        };
        let near = |a: (Vec3, Vec3), b: (Vec3, Vec3)| {
            assert!((a.0 - b.0).length() < 1e-4 && (a.1 - b.1).length() < 1e-4, "{a:?} {b:?}");
        };
        let (eye, target) = (start().eye, start().target);
        near(at(CameraPath { dolly: 1.0, ..STILL }), (eye - Vec3::Z * 4.0, target - Vec3::Z * 4.0));
        near(at(CameraPath { truck: 1.0, ..STILL }), (eye + Vec3::X * 4.0, target + Vec3::X * 4.0));
        near(at(CameraPath { rise: 1.0, ..STILL }), (eye + Vec3::Y * 4.0, target + Vec3::Y * 4.0));
        let quarter = std::f32::consts::PI;
        near(at(CameraPath { orbit_rad: quarter, ..STILL }), (target + Vec3::X * 8.0, target));
        near(at(CameraPath { pan_rad: quarter, ..STILL }), (eye, eye + Vec3::X * 8.0));
    }

    #[test]
    fn an_orbit_keeps_its_distance_and_every_camera_can_be_drawn() {
        let path = CameraPath { start: start(), orbit_rad: 1.0, ..STILL };
        for i in 0..50 {
            let camera = path.at(i as f32 * 0.1);
            assert!(((camera.eye - camera.target).length() - 8.0).abs() < 1e-3);
        }
        let down = Camera { target: start().eye - Vec3::Y, ..start() };
        let moved = CameraPath::around_target(down).at(1.0);
        assert!(moved.eye.is_finite() && moved.target.is_finite() && moved.eye != moved.target);
    }
}
