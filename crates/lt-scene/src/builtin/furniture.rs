//! Street furniture: lamps, benches, cars, bicycles, bollards, planters and café tables, each standing at the origin.

use lt_math::glam::{Vec2, Vec3};

use super::{
    kit::Kit,
    model::Model,
    numbers::{TAU, sin_cos, srgb, standing},
};

/// Materials that furniture shares.
#[derive(Clone, Copy, Debug)]
pub struct FurnitureMaterials {
    iron: u32,
    paint: u32,
    glass: u32,
    wood: u32,
    cloth: u32,
}

impl FurnitureMaterials {
    /// Adds them to a scene.
    pub fn new(kit: &mut Kit) -> Self {
        Self {
            iron: kit.plain("cast iron", srgb(0x2c3431)),
            paint: kit.plain("lacquer", Vec3::ONE),
            glass: kit.plain("tinted glass", srgb(0x2a333b)),
            wood: kit.textured("boards", srgb(0xb08858), super::texture::boards()),
            cloth: kit.sheet("parasol"),
        }
    }
}

/// A lantern on a fluted post, 4.3 m high.
pub fn lamp(model: &mut Model, mats: &FurnitureMaterials) {
    let profile = [
        (0.20, 0.0),
        (0.20, 0.12),
        (0.15, 0.16),
        (0.13, 0.55),
        (0.075, 0.70),
        (0.055, 1.0),
        (0.045, 3.1),
        (0.075, 3.16),
        (0.045, 3.24),
        (0.035, 3.45),
        (0.11, 3.58),
    ];
    let profile: Vec<Vec2> = profile.iter().map(|&(r, y)| Vec2::new(r, y)).collect();
    let iron = model.on(mats.iron);
    iron.lathe(Vec3::ZERO, &profile, 12);
    iron.bar(Vec3::new(-0.32, 3.2, 0.0), Vec3::new(0.32, 3.2, 0.0), 0.025, 0.025);
    let corner = |i: usize, half: f32, y: f32| {
        let (s, c) = sin_cos(TAU * (i as f32 + 0.5) / 4.0);
        Vec3::new(half * c, y, half * s)
    };
    for i in 0..4 {
        iron.bar(corner(i, 0.16, 3.58), corner(i, 0.27, 4.02), 0.022, 0.022);
        iron.face(&[corner(i + 1, 0.32, 4.02), corner(i, 0.32, 4.02), Vec3::new(0.0, 4.28, 0.0)]);
        iron.face(&[corner(i, 0.32, 4.02), corner(i + 1, 0.32, 4.02), Vec3::new(0.0, 4.02, 0.0)]);
    }
    iron.lathe(
        Vec3::new(0.0, 4.26, 0.0),
        &[Vec2::new(0.0, 0.0), Vec2::new(0.04, 0.05), Vec2::new(0.0, 0.13)],
        8,
    );
    let paint = model.on(mats.paint);
    paint.tint(srgb(0xf4ecd0));
    paint.ellipsoid(Vec3::new(0.0, 3.80, 0.0), Vec3::new(0.10, 0.17, 0.10), 8, 10);
}

/// A slatted park bench with cast sides, facing +Z, 1.8 m long.
pub fn bench(model: &mut Model, mats: &FurnitureMaterials) {
    for x in [-0.75, 0.0, 0.75] {
        let iron = model.on(mats.iron);
        iron.bar(Vec3::new(x, 0.0, 0.22), Vec3::new(x, 0.44, 0.20), 0.04, 0.05);
        iron.bar(Vec3::new(x, 0.0, -0.26), Vec3::new(x, 0.46, -0.20), 0.04, 0.05);
        iron.bar(Vec3::new(x, 0.42, 0.22), Vec3::new(x, 0.42, -0.22), 0.04, 0.04);
        iron.bar(Vec3::new(x, 0.44, -0.20), Vec3::new(x, 0.92, -0.34), 0.04, 0.04);
        iron.bar(Vec3::new(x, 0.64, -0.24), Vec3::new(x, 0.62, 0.22), 0.04, 0.03);
        iron.bar(Vec3::new(x, 0.44, 0.20), Vec3::new(x, 0.62, 0.22), 0.03, 0.03);
    }
    let wood = model.on(mats.wood);
    for i in 0..5 {
        let z = 0.20 - 0.095 * i as f32;
        wood.block(Vec3::new(-0.9, 0.44, z - 0.035), Vec3::new(0.9, 0.475, z + 0.035));
    }
    for i in 0..4 {
        let t = i as f32 / 3.0;
        let a = Vec3::new(-0.9, 0.56 + 0.32 * t, -0.215 - 0.10 * t);
        wood.bar(a, a + Vec3::X * 1.8, 0.075, 0.03);
    }
}

/// A small car along +X, about 3.9 m long; `color` is its lacquer.
pub fn car(model: &mut Model, mats: &FurnitureMaterials, color: Vec3) {
    let half_width = 0.82;
    // Side profile: x, sill to shoulder height, and how far the section is drawn in at the shoulder.
    let lower: [(f32, f32, f32); 9] = [
        (-1.95, 0.42, 0.62),
        (-1.90, 0.30, 0.80),
        (-1.55, 0.26, 0.90),
        (-0.75, 0.24, 0.93),
        (0.0, 0.24, 0.93),
        (0.75, 0.24, 0.90),
        (1.45, 0.26, 0.82),
        (1.86, 0.30, 0.70),
        (1.95, 0.42, 0.58),
    ];
    let section = |x: f32, low: f32, high: f32| -> Vec<Vec3> {
        let w = half_width * (1.0 - 0.10 * (x / 1.95) * (x / 1.95) * (x / 1.95).abs());
        [
            (0.86, low),
            (1.0, low + 0.10),
            (1.02, 0.5 * (low + high) + 0.06),
            (0.96, high - 0.04),
            (0.88, high),
            (0.0, high + 0.03),
        ]
        .iter()
        .map(|&(s, y)| Vec3::new(x, y, s * w))
        .collect()
    };
    let rows: Vec<Vec<Vec3>> = lower.iter().map(|&(x, low, high)| section(x, low, high)).collect();
    let cabin_rows: Vec<Vec<Vec3>> =
        [(-1.62, 0.90, 0.9), (-1.15, 1.40, 0.78), (-0.4, 1.47, 0.76), (0.35, 1.40, 0.76), (1.0, 0.90, 0.9)]
            .iter()
            .map(|&(x, top, s)| {
                let w = half_width;
                [
                    Vec3::new(x, 0.88, 0.90 * w),
                    Vec3::new(x, top - 0.05, s * w),
                    Vec3::new(x, top, (s - 0.08) * w),
                    Vec3::new(x, top + 0.02, 0.0),
                ]
                .to_vec()
            })
            .collect();
    for side in [1.0, -1.0] {
        let mirrored = |p: Vec3| Vec3::new(p.x, p.y, p.z * side);
        let mut skin = |material: u32, tint: Vec3, quad: [Vec3; 4]| {
            let part = model.on(material);
            part.tint(tint);
            let q = quad.map(mirrored);
            if side > 0.0 { part.face(&q) } else { part.face(&[q[3], q[2], q[1], q[0]]) }
        };
        for pair in rows.windows(2) {
            for k in 0..5 {
                skin(mats.paint, color, [pair[0][k], pair[1][k], pair[1][k + 1], pair[0][k + 1]]);
            }
        }
        for (end, order) in [(0, [0, 1, 2, 3]), (8, [3, 2, 1, 0])] {
            let r = &rows[end];
            for k in 0..5 {
                let center = |p: Vec3| Vec3::new(p.x, p.y, 0.0);
                let quad = [center(r[k]), r[k], r[k + 1], center(r[k + 1])];
                skin(mats.paint, color * 0.8, order.map(|i: usize| quad[i]));
            }
        }
        for (i, pair) in cabin_rows.windows(2).enumerate() {
            for k in 0..3 {
                let is_glass = k == 0 || i == 0 || i == 3;
                let (material, tint) = if is_glass { (mats.glass, Vec3::ONE) } else { (mats.paint, color) };
                skin(material, tint, [pair[0][k], pair[1][k], pair[1][k + 1], pair[0][k + 1]]);
            }
        }
        // Pillars: x, and how far they lean.
        for (x, lean) in [(-1.15, 0.35), (-0.38, 0.0), (0.42, -0.35)] {
            let z = half_width * 0.86 * side;
            let paint = model.on(mats.paint);
            paint.tint(color);
            paint.bar(
                Vec3::new(x - lean * 0.6, 0.88, z * 1.05),
                Vec3::new(x + lean * 0.4, 1.42, z * 0.90),
                0.06,
                0.06,
            );
        }
        for x in [-1.22, 1.22] {
            wheel(model, mats, Vec3::new(x, 0.31, 0.70 * side), 0.31, 0.16 * side);
        }
        let paint = model.on(mats.paint);
        for (x, tint) in [(1.90, 0xf2efe2), (-1.93, 0x9a1f1c)] {
            paint.tint(srgb(tint)).ellipsoid(
                Vec3::new(x, 0.58, 0.55 * side),
                Vec3::new(0.05, 0.08, 0.13),
                6,
                8,
            );
        }
    }
    let paint = model.on(mats.paint);
    paint.tint(srgb(0x202122));
    paint.block(Vec3::new(-1.85, 0.18, -0.68), Vec3::new(1.85, 0.30, 0.68));
    paint.tint(srgb(0x9a9a96));
    paint.block(Vec3::new(1.90, 0.33, -0.72), Vec3::new(2.0, 0.43, 0.72));
    paint.block(Vec3::new(-2.0, 0.33, -0.72), Vec3::new(-1.90, 0.43, 0.72));
}

/// A tyre with a hub cap; `outward` is the signed width along Z.
fn wheel(model: &mut Model, mats: &FurnitureMaterials, center: Vec3, radius: f32, outward: f32) {
    let face = center + Vec3::Z * outward;
    let paint = model.on(mats.paint);
    paint.tint(srgb(0x1d1d1f)).cylinder(center, face, radius, radius * 0.96, 20);
    paint.tint(srgb(0xb4b4b0)).cylinder(
        face,
        face + Vec3::Z * (0.02 * outward.signum()),
        radius * 0.58,
        radius * 0.5,
        14,
    );
}

/// A bicycle along +X leaning on its stand: hoops, spokes and a tube frame.
pub fn bicycle(model: &mut Model, mats: &FurnitureMaterials, color: Vec3) {
    let hub = [Vec3::new(-0.52, 0.34, 0.0), Vec3::new(0.52, 0.34, 0.0)];
    for center in hub {
        let rim = |angle: f32, r: f32| {
            let (s, c) = sin_cos(angle);
            center + Vec3::new(c, s, 0.0) * r
        };
        let hoop: Vec<Vec3> = (0..=28).map(|i| rim(i as f32 / 28.0 * TAU, 0.33)).collect();
        model.on(mats.iron).tube(&hoop, |_| 0.016, 6);
        for i in 0..14 {
            let foot = rim(i as f32 / 14.0 * TAU + 0.3, 0.02);
            model.on(mats.iron).bar(foot, rim(i as f32 / 14.0 * TAU, 0.32), 0.003, 0.003);
        }
    }
    let pedal = Vec3::new(-0.08, 0.30, 0.0);
    let saddle = Vec3::new(-0.24, 0.84, 0.0);
    let head = Vec3::new(0.36, 0.80, 0.0);
    let paint = model.on(mats.paint);
    paint.tint(color);
    for (a, b) in [
        (hub[0], pedal),
        (hub[0], saddle),
        (pedal, saddle),
        (pedal, head),
        (saddle.lerp(pedal, 0.12), head),
        (hub[1], head),
    ] {
        paint.tube(&[a, b], |_| 0.016, 7);
    }
    let iron = model.on(mats.iron);
    let bars = head + Vec3::new(-0.03, 0.18, 0.0);
    iron.tube(&[head, bars], |_| 0.012, 6);
    iron.tube(
        &[
            bars + Vec3::new(-0.12, 0.0, -0.26),
            bars - Vec3::Z * 0.15,
            bars + Vec3::Z * 0.15,
            bars + Vec3::new(-0.12, 0.0, 0.26),
        ],
        |_| 0.012,
        6,
    );
    iron.tube(&[saddle, saddle + Vec3::Y * 0.1], |_| 0.012, 6);
    iron.ellipsoid(saddle + Vec3::new(-0.03, 0.12, 0.0), Vec3::new(0.14, 0.035, 0.08), 6, 10);
    iron.bar(pedal, Vec3::new(-0.2, 0.0, 0.16), 0.014, 0.014);
    iron.bar(pedal + Vec3::new(0.0, 0.0, -0.09), pedal + Vec3::new(0.15, -0.08, -0.09), 0.02, 0.02);
}

/// A round table with two chairs under a parasol of `color`.
pub fn cafe_table(model: &mut Model, mats: &FurnitureMaterials, color: Vec3) {
    let iron = model.on(mats.iron);
    iron.cylinder(Vec3::ZERO, Vec3::Y * 0.03, 0.26, 0.24, 16);
    iron.tube(&[Vec3::Y * 0.03, Vec3::Y * 2.55], |_| 0.022, 8);
    let paint = model.on(mats.paint);
    paint.tint(srgb(0xe8e2d2)).cylinder(Vec3::Y * 0.71, Vec3::Y * 0.735, 0.36, 0.36, 24);
    let cloth = model.on(mats.cloth);
    let panels = 8;
    for i in 0..panels {
        let rim = |k: u32, r: f32, y: f32| {
            let (s, c) = sin_cos(k as f32 / panels as f32 * TAU);
            Vec3::new(c * r, y, s * r)
        };
        cloth.tint(if i % 2 == 0 { color } else { srgb(0xf4ecdc) });
        cloth.face(&[rim(i + 1, 1.25, 2.18), rim(i, 1.25, 2.18), Vec3::Y * 2.62]);
        cloth.face(&[rim(i + 1, 1.25, 2.02), rim(i, 1.25, 2.02), rim(i, 1.25, 2.18), rim(i + 1, 1.25, 2.18)]);
    }
    for (yaw, away) in [(0.3, 0.72), (3.3, 0.75)] {
        let (s, c) = sin_cos(yaw);
        model.within(standing(Vec3::new(s * away, 0.0, c * away), yaw + 0.5 * TAU), |m| chair(m, mats));
    }
}

/// A bentwood chair facing +Z.
fn chair(model: &mut Model, mats: &FurnitureMaterials) {
    let iron = model.on(mats.iron);
    for (x, z) in [(-0.18, -0.18), (0.18, -0.18), (-0.18, 0.18), (0.18, 0.18)] {
        let top = if z < 0.0 { 0.86 } else { 0.45 };
        iron.bar(Vec3::new(x * 1.1, 0.0, z * 1.1), Vec3::new(x, top, z), 0.022, 0.022);
    }
    for y in [0.62, 0.72, 0.82] {
        iron.bar(Vec3::new(-0.18, y, -0.18), Vec3::new(0.18, y, -0.18), 0.02, 0.04);
    }
    let wood = model.on(mats.wood);
    for i in 0..4 {
        let x = -0.15 + 0.1 * i as f32;
        wood.block(Vec3::new(x - 0.04, 0.45, -0.2), Vec3::new(x + 0.04, 0.468, 0.2));
    }
}

/// A cast bollard, 0.95 m.
pub fn bollard(model: &mut Model, mats: &FurnitureMaterials) {
    let profile =
        [(0.10, 0.0), (0.10, 0.08), (0.065, 0.14), (0.055, 0.72), (0.08, 0.76), (0.05, 0.82), (0.0, 0.95)];
    let profile: Vec<Vec2> = profile.iter().map(|&(r, y)| Vec2::new(r, y)).collect();
    model.on(mats.iron).lathe(Vec3::ZERO, &profile, 12);
}

/// An iron fence of spear-headed bars along +X, `length` metres, with stouter posts at both ends.
pub fn railing(model: &mut Model, mats: &FurnitureMaterials, length: f32, height: f32, spacing: f32) {
    let iron = model.on(mats.iron);
    for y in [0.18, height - 0.22] {
        iron.bar(Vec3::new(0.0, y, 0.0), Vec3::new(length, y, 0.0), 0.02, 0.035);
    }
    let count = (length / spacing) as u32;
    for i in 0..=count {
        let foot = Vec3::X * (length * i as f32 / count.max(1) as f32);
        let is_post = i == 0 || i == count;
        let (size, top) = if is_post { (0.06, height + 0.06) } else { (0.016, height - 0.08) };
        iron.bar(foot, foot + Vec3::Y * top, size, size);
        let tip = [Vec2::new(size * 1.1, 0.0), Vec2::new(size * 0.6, 0.04), Vec2::new(0.0, 0.11)];
        iron.lathe(foot + Vec3::Y * top, &tip, 4);
    }
}
