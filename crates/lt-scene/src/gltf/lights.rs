//! Lights (KHR_lights_punctual), placed in the world.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use lt_math::glam::{Affine3A, Vec3};

use super::{
    fault::{Fault, pick},
    json::Root,
};
use crate::{Light, LightKind};

/// Widest outer half-angle of a spot light: a little below the right angle that the extension allows.
const MAX_CONE_RAD: f32 = FRAC_PI_2 - 1e-3;

#[derive(Clone, Copy, Debug)]
enum Shape {
    Directional,
    Point,
    Spot { inner_cone_rad: f32, outer_cone_rad: f32 },
}

/// A light as a node refers to it.
#[derive(Clone, Debug)]
pub(super) struct Lamp {
    name: String,
    shape: Shape,
    color: Vec3,
    intensity: f32,
    range: f32,
}

impl Lamp {
    /// Light `index` of the file, referred to by `node`, whose name it gets if it has none.
    pub(super) fn read(root: &Root, index: usize, node: usize) -> Result<Self, Fault> {
        const LIST: &str = "extensions.KHR_lights_punctual.lights";
        let json = pick(&root.lights, index, LIST, || {
            format!("nodes[{node}].extensions.KHR_lights_punctual.light")
        })?;
        let fault = |problem: String| Fault::at(format!("{LIST}[{index}]"), problem);
        let shape = match json.kind.as_str() {
            "directional" => Shape::Directional,
            "point" => Shape::Point,
            "spot" => {
                let inner = json.spot.inner_cone_angle.unwrap_or(0.0);
                let outer = json.spot.outer_cone_angle.unwrap_or(FRAC_PI_4);
                if !(inner >= 0.0 && outer > inner && outer <= FRAC_PI_2 + 1e-4) {
                    let problem =
                        format!("cone angles {inner} and {outer}: expected 0 ≤ inner < outer ≤ π/2");
                    return Err(fault(problem));
                }
                let outer_cone_rad = outer.min(MAX_CONE_RAD);
                Shape::Spot { inner_cone_rad: inner.min(outer_cone_rad), outer_cone_rad }
            }
            other => return Err(fault(format!("type {other:?} is not directional, point or spot"))),
        };
        let color = Vec3::from(json.color.unwrap_or([1.0; 3]));
        let intensity = json.intensity.unwrap_or(1.0);
        if !(color.is_finite() && color.cmpge(Vec3::ZERO).all() && intensity.is_finite() && intensity >= 0.0)
        {
            return Err(fault(format!("color {color} or intensity {intensity} is negative or not finite")));
        }
        let range = json.range.unwrap_or(f32::INFINITY);
        if range.is_nan() || range <= 0.0 {
            return Err(fault(format!("range {range} is not positive")));
        }
        let name = json.name.clone().or_else(|| root.nodes[node].name.clone());
        let name = name.unwrap_or_else(|| format!("lights[{index}]"));
        Ok(Self { name, shape, color, intensity, range })
    }

    /// What it is called.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// The light at a node; none if the node's transform leaves it no direction or no place.
    pub(super) fn place(&self, world: &Affine3A) -> Option<Light> {
        let position = Some(Vec3::from(world.translation)).filter(|p| p.is_finite())?;
        let direction = Vec3::from(-world.matrix3.z_axis).try_normalize();
        let range = self.range;
        let kind = match self.shape {
            Shape::Directional => LightKind::Directional { direction: direction? },
            Shape::Point => LightKind::Point { position, range },
            Shape::Spot { inner_cone_rad, outer_cone_rad } => {
                LightKind::Spot { position, direction: direction?, inner_cone_rad, outer_cone_rad, range }
            }
        };
        Some(Light { name: self.name.clone(), kind, color: self.color, intensity: self.intensity })
    }
}
