//! `forest`: a clearing among instanced firs and beeches, tufts of grass, and a serpent circling through the air.

use lt_math::glam::{Vec2, Vec3};

use super::{
    kit::{Kit, Stamp},
    model::{Model, Part},
    numbers::{TAU, fractal_noise, sin, sin_cos, srgb, standing, standing_scaled},
    rng::Rng,
    terrain, texture, tree,
};
use crate::Scene;

/// The clearing's radius and the serpent's orbit, metres.
const CLEARING: f32 = 10.5;
const ORBIT: f32 = 5.0;
/// Seconds per round.
const ROUND_S: f32 = 16.0;
/// Where the viewer stands in the clearing.
const EYE: Vec2 = Vec2::new(2.6, 12.6);

/// The wood with `trees` trees at `time_s` seconds.
pub fn grow(trees: u32, seed: u64, time_s: f32) -> Scene {
    let mut kit = Kit::new("forest");
    let mut rng = Rng::new(seed, 1);
    let half = 34.0f32.max((trees as f32 * 9.0).sqrt() * 0.5 + 14.0);
    let salt = seed as u32 ^ 0x5eed;
    let height = move |p: Vec2| {
        let far = ((p.length() - CLEARING * 0.6) / 22.0).clamp(0.0, 1.0);
        (fractal_noise(p / 19.0 + Vec2::splat(100.0), 0, salt) - 0.42) * (0.5 + 5.5 * far) + 1.8 * far
    };
    let soil = kit.textured("soil", Vec3::ONE, texture::forest_floor());
    let mut model = Model::new();
    let cells = (half * 2.2) as u32;
    terrain::heightfield(model.on(soil), half + 12.0, cells.min(700), 0.5, height, |p| {
        let meadow = (1.0 - (p.length() - 4.0) / 9.0).clamp(0.0, 1.0);
        srgb(0xf0e8d8).lerp(srgb(0xe6f2bc), meadow)
    });
    kit.add("terrain", model);
    plant(&mut kit, trees, half, &height, &mut rng);
    undergrowth(&mut kit, half.min(30.0), &height, &mut rng);
    serpent(&mut kit, time_s, height(Vec2::ZERO));
    let stand = |p: Vec2, up: f32| Vec3::new(p.x, height(p) + up, p.y);
    kit.finish(Vec3::new(-0.40, 1.05, 0.45), stand(EYE, 1.75), stand(Vec2::new(-0.6, 0.0), 2.6), 60.0)
}

fn plant(kit: &mut Kit, count: u32, half: f32, height: &impl Fn(Vec2) -> f32, rng: &mut Rng) {
    let bark = kit.bark();
    let leaf = kit.cutout("leaves", Vec3::ONE, texture::leaves());
    let branch = kit.cutout("needles", Vec3::ONE, texture::needles());
    let mut kinds: Vec<Stamp> = Vec::new();
    for (tall, tint) in [(15.0, 0xffffff), (18.0, 0xe4f0e4), (11.0, 0xf4ffe4)] {
        let mut model = Model::new();
        tree::fir(&mut model, bark, branch, tall, srgb(tint), rng);
        kinds.push(kit.stamp("fir", model));
    }
    for (tall, tint) in [(12.0, 0xf4ffd8), (14.0, 0xffffff)] {
        let mut model = Model::new();
        let twigs = tree::broadleaf_wood(&mut model, bark, tall, 3, rng);
        tree::leaf_cards(&mut model, leaf, &twigs, 2, 1.35, srgb(tint), rng);
        kinds.push(kit.stamp("beech", model));
    }
    let mut taken: Vec<Vec2> = Vec::new();
    for _ in 0..count {
        let mut spacing = 2.8;
        let at = loop {
            let p = Vec2::new(rng.range(-half, half), rng.range(-half, half));
            // Hashing neighbours is not worth it: the wood is small, and darts near the viewer matter most.
            let is_clear = p.length() > CLEARING
                && p.distance(EYE) > 7.0
                && p.perp_dot(EYE.normalize()).abs() > 4.0 * f32::from(p.dot(EYE) > 0.0 && p.length() < 26.0);
            if spacing < 0.2 || is_clear && taken.iter().rev().take(2000).all(|t| t.distance(p) > spacing) {
                break p;
            }
            spacing *= 0.985;
        };
        taken.push(at);
        let size = rng.range(0.75, 1.2);
        let ground = Vec3::new(at.x, height(at) - 0.08, at.y);
        kit.place(rng.pick_ref(&kinds), standing_scaled(ground, rng.range(0.0, TAU), Vec3::splat(size)));
    }
}

/// Grass where the light falls, boulders, a fallen trunk and toadstools.
fn undergrowth(kit: &mut Kit, reach: f32, height: &impl Fn(Vec2) -> f32, rng: &mut Rng) {
    let blades = kit.cutout("grass blades", Vec3::ONE, texture::blades());
    let rock = kit.textured("rock", srgb(0xa8a49c), texture::plaster());
    let flesh = kit.plain("toadstool", Vec3::ONE);
    let bark = kit.bark();
    let mut model = Model::new();
    let on_ground = |p: Vec2| Vec3::new(p.x, height(p), p.y);
    for _ in 0..9000 {
        let (s, c) = sin_cos(rng.range(0.0, TAU));
        let p = Vec2::new(s, c) * (reach * rng.unit().sqrt());
        // Thinner in the wood than in the clearing.
        if rng.chance(0.25 + 0.75 * (1.0 - (p.length() - 7.0) / 12.0).clamp(0.0, 1.0)) {
            tuft(model.on(blades), on_ground(p), rng);
        }
    }
    for _ in 0..16 {
        let (s, c) = sin_cos(rng.range(0.0, TAU));
        let p = Vec2::new(s, c) * rng.range(6.5, 16.0);
        if p.distance(EYE) > 4.0 {
            boulder(model.on(rock), on_ground(p), rng.range(0.25, 0.75), rng);
        }
    }
    let ends = [Vec2::new(-7.4, 4.2), Vec2::new(-3.0, 7.2)].map(|p| on_ground(p) + Vec3::Y * 0.28);
    model.on(bark).cylinder(ends[0], ends[1], 0.34, 0.27, 18);
    let stub = ends[0].lerp(ends[1], 0.6);
    model.on(bark).cylinder(stub, stub + Vec3::new(0.3, 0.75, -0.2), 0.09, 0.05, 9);
    for _ in 0..26 {
        let t = rng.unit();
        let p = Vec2::new(-7.4 + 4.4 * t + rng.range(0.3, 1.1), 4.2 + 3.0 * t + rng.range(0.2, 0.9));
        toadstool(model.on(flesh), on_ground(p), rng.range(0.07, 0.17));
    }
    kit.add("undergrowth", model);
}

/// Two crossed cards of blades.
fn tuft(part: &mut Part, foot: Vec3, rng: &mut Rng) {
    let (s, c) = sin_cos(rng.range(0.0, TAU));
    let size = rng.range(0.22, 0.5);
    let up = Vec3::new(rng.range(-0.15, 0.15), 1.0, rng.range(-0.15, 0.15)) * size;
    part.tint(Vec3::splat(rng.range(0.75, 1.15)).clamp(Vec3::ZERO, Vec3::ONE));
    let foot = foot - Vec3::Y * 0.03;
    let to_eye = Vec3::new(EYE.x - foot.x, 0.0, EYE.y - foot.z).normalize_or(Vec3::Z);
    let normal = (Vec3::Y + to_eye * 0.3).normalize();
    for across in [Vec3::new(c, 0.0, s), Vec3::new(-s, 0.0, c)] {
        let side = across * (0.6 * size);
        part.card([foot - side, foot + side, foot + side + up, foot - side + up], normal);
    }
}

fn boulder(part: &mut Part, at: Vec3, size: f32, rng: &mut Rng) {
    let waves: [Vec3; 3] = core::array::from_fn(|_| rng.direction() * rng.range(1.5, 4.0));
    let point = move |polar: f32, around: f32| {
        let (sp, cp) = sin_cos(polar);
        let (s, c) = sin_cos(around);
        let out = Vec3::new(sp * c, -cp * 0.7, -sp * s);
        let lumps: f32 = waves.iter().map(|k| sin(out.dot(*k) * 2.0)).sum();
        at + out * (size * (1.0 + 0.1 * lumps))
    };
    part.tint(Vec3::splat(rng.range(0.75, 1.0)));
    part.grid(14, 22, |row, column| {
        let (polar, around) = (row * TAU * 0.5, if column >= 1.0 { 0.0 } else { column * TAU });
        let inside = polar.clamp(0.02, 0.5 * TAU - 0.02);
        let east = point(inside, around + 0.01) - point(inside, around - 0.01);
        let north = point(inside + 0.01, around) - point(inside - 0.01, around);
        (point(polar, around), east.cross(north).normalize_or(Vec3::Y))
    });
}

fn toadstool(part: &mut Part, at: Vec3, size: f32) {
    part.tint(srgb(0xf0e8d8)).lathe(
        at - Vec3::Y * 0.02,
        &[Vec2::new(0.2, 0.0), Vec2::new(0.14, 1.0)].map(|p| p * size),
        10,
    );
    let cap = [(0.0, 0.95), (0.62, 0.92), (0.68, 1.02), (0.45, 1.34), (0.0, 1.48)];
    part.tint(srgb(0xb8392b)).lathe(at, &cap.map(|(r, y)| Vec2::new(r, y) * size), 12);
}

/// A rigid serpent bent along its own orbit: turning it about the clearing's middle makes it swim.
fn serpent(kit: &mut Kit, time_s: f32, ground: f32) {
    let skin = kit.textured("scales", srgb(0x6cc0a4), texture::tiles());
    let horn = kit.plain("horn", Vec3::ONE);
    let fin_skin = kit.sheet("fins");
    let spine = |t: f32| {
        let angle = t * 0.78 * TAU;
        let (s, c) = sin_cos(angle);
        let wave = sin(angle * 5.0);
        Vec3::new(
            s * (ORBIT + 0.25 * wave),
            2.5 + 0.55 * sin(angle * 5.0 + 1.2) + 0.5 * t,
            c * (ORBIT + 0.25 * wave),
        )
    };
    let girth =
        |t: f32| 0.02 + 0.40 * (t * 1.35).min(1.0) * (1.0 - 0.45 * ((t - 0.86) / 0.14).clamp(0.0, 1.0));
    let rings = 560;
    let path: Vec<Vec3> = (0..=rings).map(|i| spine(i as f32 / rings as f32)).collect();
    let mut model = Model::new();
    model.on(skin).tube(&path, girth, 36);
    // The head, drawn in its own frame looking along +Z.
    let head = path[rings];
    let forward = (path[rings] - path[rings - 6]).normalize_or(Vec3::Z);
    let flat = Vec3::new(forward.x, 0.0, forward.z).normalize_or(Vec3::Z);
    model.within(super::numbers::turned_to(head, flat), |m| {
        m.on(skin).ellipsoid(Vec3::new(0.0, 0.06, 0.25), Vec3::new(0.36, 0.30, 0.55), 24, 36);
        m.on(skin).ellipsoid(Vec3::new(0.0, 0.02, 0.72), Vec3::new(0.24, 0.16, 0.38), 20, 30);
        m.on(skin).ellipsoid(Vec3::new(0.0, -0.18, 0.60), Vec3::new(0.20, 0.07, 0.40), 16, 28);
        for side in [-1.0, 1.0] {
            let part = m.on(horn);
            part.tint(srgb(0xf2d65a)).ellipsoid(
                Vec3::new(0.25 * side, 0.20, 0.50),
                Vec3::splat(0.085),
                14,
                20,
            );
            part.tint(srgb(0x16140f)).ellipsoid(
                Vec3::new(0.30 * side, 0.21, 0.54),
                Vec3::splat(0.045),
                10,
                14,
            );
            let curve: Vec<Vec3> = (0..=12)
                .map(|i| {
                    let t = i as f32 / 12.0;
                    Vec3::new(side * (0.16 + 0.22 * t), 0.26 + 0.55 * t - 0.15 * t * t, 0.1 - 0.75 * t)
                })
                .collect();
            part.tint(srgb(0xe9dcc0)).tube(&curve, |t| 0.065 * (1.0 - 0.93 * t), 12);
            let whisker: Vec<Vec3> = (0..=20)
                .map(|i| {
                    let t = i as f32 / 20.0;
                    Vec3::new(side * (0.2 + 0.7 * t), 0.0 + 0.35 * sin(t * 5.0) * t, 1.0 - 1.3 * t)
                })
                .collect();
            part.tint(srgb(0xe9dcc0)).tube(&whisker, |t| 0.018 * (1.0 - 0.8 * t), 6);
        }
    });
    // A ridge of fins along the back.
    for i in (20..rings - 12).step_by(7) {
        let t = i as f32 / rings as f32;
        let along = (path[i + 1] - path[i - 1]).normalize_or(Vec3::X);
        let root = path[i] + Vec3::Y * (girth(t) * 0.94);
        let size = 0.16 + 0.5 * girth(t);
        let part = model.on(fin_skin);
        part.tint(srgb(0xd9803a));
        let fin = [
            root - along * (0.34 * size),
            root + along * (0.34 * size),
            root + Vec3::Y * size - along * (0.55 * size),
        ];
        part.face(&fin);
    }
    let stamp = kit.stamp("serpent", model);
    let turn = (time_s / ROUND_S).rem_euclid(1.0) * TAU;
    kit.place_moving(&stamp, standing(Vec3::Y * ground, turn));
}
