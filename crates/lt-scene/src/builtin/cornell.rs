//! `cornell`: the Cornell box with a skylight, two blocks and a pebble; sun falls in through ceiling and open front.

use lt_math::glam::Vec3;

use super::{
    kit::Kit,
    model::Model,
    numbers::{TAU, sin, sin_cos, srgb, standing},
    rng::Rng,
};
use crate::Scene;

/// The box, 5.5 m wide; `detail` rings on the pebble.
pub fn grow(detail: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("cornell");
    let white = kit.plain("white", srgb(0xd2cec4));
    let red = kit.plain("red", srgb(0xb03226));
    let green = kit.plain("green", srgb(0x4f8a3c));
    let ochre = kit.plain("ochre", srgb(0xd2a765));
    let violet = kit.plain("violet", srgb(0x8d86b8));
    let stone = kit.plain("pebble", srgb(0xe9e4d4));
    let floor = kit.plain("floor", srgb(0x9a958c));
    let (half, height, thick) = (2.75, 5.5, 0.12);
    let mut room = Model::new();
    let walls = room.on(white);
    walls.block(Vec3::new(-half, -thick, -half), Vec3::new(half, 0.0, half));
    walls.block(
        Vec3::new(-half - thick, -thick, -half - thick),
        Vec3::new(half + thick, height + thick, -half),
    );
    // The ceiling around a skylight with two glazing bars.
    let (hole, z0, z1) = (1.3, -0.9, 1.5);
    walls.block(Vec3::new(-half, height, -half), Vec3::new(-hole, height + thick, half));
    walls.block(Vec3::new(hole, height, -half), Vec3::new(half, height + thick, half));
    walls.block(Vec3::new(-hole, height, -half), Vec3::new(hole, height + thick, z0));
    walls.block(Vec3::new(-hole, height, z1), Vec3::new(hole, height + thick, half));
    walls.block(Vec3::new(-0.03, height + 0.02, z0), Vec3::new(0.03, height + 0.09, z1));
    let middle = 0.5 * (z0 + z1);
    walls
        .block(Vec3::new(-hole, height + 0.02, middle - 0.03), Vec3::new(hole, height + 0.09, middle + 0.03));
    room.on(red).block(Vec3::new(-half - thick, -thick, -half), Vec3::new(-half, height + thick, half));
    room.on(green).block(Vec3::new(half, -thick, -half), Vec3::new(half + thick, height + thick, half));
    let at = |x: f32, z: f32| Vec3::new(x * 30.0, -thick, z * 30.0);
    room.on(floor).face(&[at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0), at(-1.0, -1.0)]);
    room.within(standing(Vec3::new(-0.95, 0.0, -0.95), 0.3), |m| {
        m.on(ochre).block(Vec3::new(-0.8, 0.0, -0.8), Vec3::new(0.8, 3.2, 0.8));
    });
    room.within(standing(Vec3::new(0.95, 0.0, 0.75), -0.3), |m| {
        m.on(violet).block(Vec3::new(-0.8, 0.0, -0.8), Vec3::new(0.8, 1.6, 0.8));
    });
    pebble(&mut room, stone, Vec3::new(0.95, 2.24, 0.75), detail, seed);
    kit.add("room", room);
    kit.finish(Vec3::new(0.28, 0.70, 0.62), Vec3::new(0.0, 2.75, 9.6), Vec3::new(0.0, 2.7, 0.0), 40.0)
}

/// A sphere with soft lumps from three random waves, normals by finite differences.
fn pebble(model: &mut Model, material: u32, center: Vec3, detail: u32, seed: u64) {
    let mut rng = Rng::new(seed, 1);
    let waves: [(Vec3, f32); 3] =
        core::array::from_fn(|_| (rng.direction() * rng.range(3.0, 6.0), rng.range(0.0, TAU)));
    let point = |polar: f32, around: f32| {
        let (sin_polar, cos_polar) = sin_cos(polar);
        let (s, c) = sin_cos(around);
        let out = Vec3::new(sin_polar * c, -cos_polar, -sin_polar * s);
        let lumps: f32 = waves.iter().map(|&(k, phase)| sin(out.dot(k) + phase)).sum();
        center + out * (0.66 * (1.0 + 0.07 * lumps))
    };
    model.on(material).grid(detail, 2 * detail, |row, column| {
        let (polar, around, step) = (row * TAU * 0.5, column * TAU, 0.002);
        let inside = polar.clamp(0.01, TAU * 0.5 - 0.01);
        let east = point(inside, around + step) - point(inside, around - step);
        let north = point(inside + step, around) - point(inside - step, around);
        // The seam's two edges must be the same points.
        let around = if column >= 1.0 { 0.0 } else { around };
        (point(polar, around), east.cross(north).normalize_or(Vec3::Y))
    });
}
