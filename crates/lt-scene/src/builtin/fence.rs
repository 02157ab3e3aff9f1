//! `fence`: a picket fence and a wire mesh in front of a wall, the case where tracing cracks heals slowest.

use lt_math::glam::{Vec2, Vec3};

use super::{
    kit::Kit,
    model::Model,
    numbers::{TAU, sin_cos, srgb, standing},
    rng::Rng,
    texture, tree,
};
use crate::Scene;

/// A garden corner with `bars` pickets, and half as many wires each way in the mesh beside them.
pub fn grow(bars: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("fence");
    let mut rng = Rng::new(seed, 1);
    let wood = kit.textured("boards", srgb(0xf2eee2), texture::boards());
    let wire = kit.plain("wire", srgb(0x77797a));
    let brick = kit.textured("brick", Vec3::ONE, texture::brick());
    let stone = kit.textured("coping", srgb(0xd8d0c0), texture::plaster());
    let grass = kit.textured("grass", Vec3::ONE, texture::grass());
    let gravel = kit.textured("gravel", srgb(0xe6e0d6), texture::gravel());
    let clay = kit.plain("clay", srgb(0xb9673f));
    let leaf = kit.cutout("leaves", Vec3::ONE, texture::leaves());
    let mut model = Model::new();

    let flat = |x0: f32, x1: f32, z0: f32, z1: f32, y: f32| {
        [Vec3::new(x0, y, z1), Vec3::new(x1, y, z1), Vec3::new(x1, y, z0), Vec3::new(x0, y, z0)]
    };
    model.on(grass).face(&flat(-30.0, 30.0, -30.0, 30.0, 0.0));
    model.on(gravel).face(&flat(-30.0, 30.0, -1.9, 0.35, 0.012));
    model.on(brick).block(Vec3::new(-30.0, 0.0, -2.6), Vec3::new(30.0, 2.2, -2.3));
    for i in 0..60 {
        let x = -30.0 + i as f32;
        model.on(stone).block(Vec3::new(x + 0.005, 2.2, -2.68), Vec3::new(x + 0.995, 2.32, -2.22));
    }

    let span = 3.0;
    pickets(&mut model, wood, -span, bars, span * 2.0 / 3.0 + 1.0, &mut rng);
    mesh_panel(&mut model, wire, 0.15, 3.15, bars / 2 + 1);
    for (x, z) in [(-2.2, -1.6), (-1.4, -1.95), (1.6, -1.75), (2.5, -1.5)] {
        pot(&mut model, clay, leaf, Vec3::new(x, 0.0, z), &mut rng);
    }
    kit.add("fence", model);
    let bark = kit.bark();
    let mut shrub = Model::new();
    let twigs = tree::broadleaf_wood(&mut shrub, bark, 4.6, 2, &mut rng);
    tree::leaf_cards(&mut shrub, leaf, &twigs, 3, 0.8, Vec3::ONE, &mut rng);
    let shrub = kit.stamp("tree", shrub);
    for (x, z) in [(-4.6, -4.4), (0.6, -5.2), (4.9, -4.2)] {
        kit.place(&shrub, standing(Vec3::new(x, 0.0, z), rng.range(0.0, TAU)));
    }
    kit.finish(Vec3::new(0.42, 0.58, 0.70), Vec3::new(-0.9, 1.55, 3.9), Vec3::new(0.15, 0.72, -1.2), 50.0)
}

/// Pointed pickets on two rails, from `x0` over `span` metres.
fn pickets(model: &mut Model, wood: u32, x0: f32, bars: u32, span: f32, rng: &mut Rng) {
    let pitch = span / bars as f32;
    let width = (0.55 * pitch).min(0.09);
    let part = model.on(wood);
    for y in [0.28, 0.82] {
        part.block(Vec3::new(x0, y, -0.045), Vec3::new(x0 + span, y + 0.07, -0.012));
    }
    for i in 0..bars {
        let x = x0 + (i as f32 + 0.5) * pitch;
        let (half, top) = (0.5 * width, 1.08 + rng.range(-0.012, 0.012));
        let profile = [
            Vec2::new(x - half, 0.04),
            Vec2::new(x + half, 0.04),
            Vec2::new(x + half, top - width),
            Vec2::new(x, top),
            Vec2::new(x - half, top - width),
        ];
        part.tint(Vec3::splat(rng.range(0.9, 1.0)));
        part.extrusion(&profile, -0.012, 0.012);
    }
}

/// A frame of posts with `wires` thin verticals and as many horizontals as keep the cells square.
fn mesh_panel(model: &mut Model, wire: u32, x0: f32, x1: f32, wires: u32) {
    let height = 1.25;
    let part = model.on(wire);
    for x in [x0, 0.5 * (x0 + x1), x1] {
        part.cylinder(Vec3::new(x, 0.0, 0.0), Vec3::new(x, height + 0.06, 0.0), 0.028, 0.028, 12);
    }
    let pitch = (x1 - x0) / wires as f32;
    let thickness = (0.05 * pitch).clamp(0.0008, 0.004);
    for i in 1..wires {
        let x = x0 + i as f32 * pitch;
        part.bar(Vec3::new(x, 0.05, 0.0), Vec3::new(x, height, 0.0), thickness, thickness);
    }
    let rows = ((height - 0.05) / pitch) as u32;
    for i in 0..=rows {
        let y = 0.05 + (height - 0.05) * i as f32 / rows.max(1) as f32;
        part.bar(Vec3::new(x0, y, 0.004), Vec3::new(x1, y, 0.004), thickness, thickness);
    }
}

/// A flower pot with a leafy plant.
fn pot(model: &mut Model, clay: u32, leaf: u32, at: Vec3, rng: &mut Rng) {
    let profile = [
        (0.0, 0.02),
        (0.14, 0.0),
        (0.20, 0.30),
        (0.23, 0.30),
        (0.23, 0.37),
        (0.20, 0.37),
        (0.18, 0.32),
        (0.0, 0.31),
    ];
    let profile: Vec<Vec2> = profile.iter().map(|&(r, y)| Vec2::new(r, y)).collect();
    model.on(clay).lathe(at, &profile, 20);
    let part = model.on(leaf);
    for _ in 0..14 {
        let (s, c) = sin_cos(rng.range(0.0, TAU));
        let out = Vec3::new(c, rng.range(0.8, 2.2), s).normalize();
        let side = out.cross(Vec3::Y).normalize_or(Vec3::X) * 0.2;
        let foot = at + Vec3::Y * 0.3;
        let tip = foot + out * rng.range(0.4, 0.6);
        part.tint(Vec3::splat(rng.range(0.85, 1.1)));
        part.card([foot - side, foot + side, tip + side, tip - side], (out + Vec3::Y).normalize());
    }
}
