//! Light sources.

use lt_math::glam::{Quat, Vec3};

/// Shape and place of a light, world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// Parallel light.
    Directional {
        /// Unit direction in which the light travels.
        direction: Vec3,
    },
    /// Shines everywhere from a point.
    Point {
        /// Position.
        position: Vec3,
        /// Distance past which it has no effect; infinite if unlimited.
        range: f32,
    },
    /// Shines into a cone.
    Spot {
        /// Position.
        position: Vec3,
        /// Unit axis along which the light travels.
        direction: Vec3,
        /// Half-angle up to which it shines fully, radians.
        inner_cone_rad: f32,
        /// Half-angle past which it does not shine, radians, below π/2.
        outer_cone_rad: f32,
        /// Distance past which it has no effect; infinite if unlimited.
        range: f32,
    },
}

/// One light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// For messages and reports; may be empty.
    pub name: String,
    /// Kind and place.
    pub kind: LightKind,
    /// Linear RGB colour.
    pub color: Vec3,
    /// Lux for directional lights, candela for the others.
    pub intensity: f32,
}

impl Light {
    /// The same light turned by this many radians around the vertical through `center`, to the right as seen from above.
    pub fn turned(&self, center: Vec3, angle_rad: f32) -> Self {
        let turn = Quat::from_rotation_y(-angle_rad);
        let around = |p: Vec3| center + turn * (p - center);
        let kind = match self.kind {
            LightKind::Directional { direction } => LightKind::Directional { direction: turn * direction },
            LightKind::Point { position, range } => LightKind::Point { position: around(position), range },
            LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, range } => {
                LightKind::Spot {
                    position: around(position),
                    direction: turn * direction,
                    inner_cone_rad,
                    outer_cone_rad,
                    range,
                }
            }
        };
        Self { kind, ..self.clone() }
    }

    /// The same, giving no light.
    pub(crate) fn darkened(self) -> Self {
        Self { intensity: 0.0, ..self }
    }

    /// A white directional light travelling along `direction` (any finite non-zero length).
    pub fn sun(direction: Vec3) -> Self {
        // Components of 1e-30 square to 0, those of 1e30 to infinity. Divided, since a subnormal one has no finite reciprocal; and not
        // where squares are sound, since that would round the usual directions twice.
        let is_sound = (1e-30..1e30).contains(&direction.length_squared());
        let scale = if is_sound { 1.0 } else { direction.abs().max_element() };
        let direction = (direction / scale).normalize();
        Self {
            name: "sun".to_owned(),
            kind: LightKind::Directional { direction },
            color: Vec3::ONE,
            intensity: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_suns_direction_may_have_any_finite_length() {
        for length in [f32::from_bits(1), 1e-40, 1e-30, 1.0, 1e30, f32::MAX] {
            let LightKind::Directional { direction } = Light::sun(Vec3::new(0.0, -length, 0.0)).kind else {
                panic!("a sun");
            };
            assert_eq!(direction, Vec3::NEG_Y, "{length}");
        }
    }

    #[test]
    fn lights_turn_around_the_vertical_to_the_right() {
        let quarter = std::f32::consts::FRAC_PI_2;
        let kind = LightKind::Point { position: Vec3::new(3.0, 5.0, 1.0), range: 7.0 };
        let lamp = Light { kind, ..Light::sun(Vec3::NEG_Z) };
        let LightKind::Point { position, range } = lamp.turned(Vec3::new(1.0, 0.0, 1.0), quarter).kind else {
            panic!("still a point light");
        };
        assert!((position - Vec3::new(1.0, 5.0, 3.0)).length() < 1e-5 && range == 7.0, "{position}");
        let LightKind::Directional { direction } = Light::sun(Vec3::NEG_Z).turned(Vec3::ONE, quarter).kind
        else {
            panic!("still a sun");
        };
        assert!((direction - Vec3::X).length() < 1e-6, "north becomes east: {direction}");
    }
}
