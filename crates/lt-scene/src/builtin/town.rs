//! `town`: concentric lanes of low-poly gabled houses on rolling ground around a church, inside a wall.

use lt_math::glam::{Vec2, Vec3};

use super::{
    house::slab,
    kit::Kit,
    model::{Model, Part},
    numbers::{TAU, fractal_noise, noise, sin, sin_cos, srgb, standing, turned_to},
    rng::Rng,
    terrain, texture,
};
use crate::Scene;

/// Radius of the market place and distance between lanes, metres.
const MARKET: f32 = 30.0;
const LANE: f32 = 14.5;
/// Main roads leave in this many directions.
const ROADS: u32 = 7;

#[derive(Clone, Copy)]
struct Materials {
    facade: u32,
    plain: u32,
    tiles: u32,
    stone: u32,
    leaf: u32,
    clock: u32,
}

/// The town with `houses` houses; lanes are added outward until all have a plot.
pub fn grow(houses: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("town");
    let mut rng = Rng::new(seed, 1);
    let mats = Materials {
        facade: kit.textured("facade", Vec3::ONE, texture::facade()),
        plain: kit.textured("wall", Vec3::ONE, texture::plaster()),
        tiles: kit.textured("tiles", Vec3::ONE, texture::tiles()),
        stone: kit.textured("stone", Vec3::ONE, texture::ashlar()),
        leaf: kit.plain("foliage", Vec3::ONE),
        clock: kit.textured("clock", Vec3::ONE, texture::clock()),
    };
    let salt = seed as u32 ^ 0x70c;
    let height = move |p: Vec2| {
        let far = ((p.length() - MARKET * 0.7) / 120.0).clamp(0.0, 1.6);
        (fractal_noise(p / 130.0 + Vec2::splat(64.0), 0, salt) - 0.5) * 34.0 * far - 3.0 * far
    };
    let mut model = Model::new();
    let mut trees = Model::new();
    let mut remaining = houses;
    let mut radius = MARKET + 6.0;
    while remaining > 0 {
        remaining -= lane(&mut model, &mats, radius, remaining, &height, &mut rng);
        gardens(&mut trees, &mats, radius + 0.5 * LANE, &height, &mut rng);
        radius += LANE;
    }
    wall(&mut model, &mats, radius + 2.0, &height);
    church(&mut model, &mats, height(Vec2::ZERO));
    let half = radius * 1.7 + 150.0;
    countryside(&mut trees, &mats, radius + 14.0, half, &height, &mut rng);
    kit.add("town", model);
    kit.add("trees", trees);
    ground(&mut kit, half, radius, &height);
    let reach = (radius / 210.0).clamp(0.4, 3.0);
    kit.finish(
        Vec3::new(-0.72, 0.52, 0.16),
        Vec3::new(40.0, 78.0, 185.0) * reach.min(1.2),
        Vec3::new(-4.0, -2.0, 18.0),
        48.0,
    )
}

/// Distance from the middle of the nearest main road, metres.
fn road_distance(p: Vec2) -> f32 {
    (0..ROADS)
        .map(|i| {
            let (s, c) = sin_cos(i as f32 / ROADS as f32 * TAU);
            let along = Vec2::new(s, c);
            if p.dot(along) > 0.0 { p.perp_dot(along).abs() } else { p.length() }
        })
        .fold(f32::INFINITY, f32::min)
}

/// Houses around one lane; returns how many found a plot.
fn lane(
    model: &mut Model,
    mats: &Materials,
    radius: f32,
    limit: u32,
    height: &impl Fn(Vec2) -> f32,
    rng: &mut Rng,
) -> u32 {
    let mut built = 0;
    let mut angle = rng.range(0.0, 0.2);
    let end = angle + TAU;
    while built < limit {
        let width = rng.range(6.0, 9.5);
        let step = width / radius;
        if angle + step > end {
            break;
        }
        let middle = angle + 0.5 * step;
        angle += step + if rng.chance(0.12) { 4.0 / radius } else { rng.range(0.0, 0.4) / radius };
        let (s, c) = sin_cos(middle);
        let out = Vec2::new(s, c);
        if road_distance(out * radius) < 3.2 + 0.5 * width {
            continue;
        }
        let r = radius + rng.range(-0.7, 0.7);
        let depth = rng.range(6.5, 9.0);
        let storeys = if radius < 90.0 { 2 + rng.below(2) } else { 1 + rng.below(3).min(1) + rng.below(2) };
        let floor =
            [-0.5, 0.5].map(|k| height(out * (r + k * depth))).iter().copied().fold(f32::INFINITY, f32::min);
        let place = Vec3::new(out.x * r, floor, out.y * r);
        let inward = if rng.chance(0.85) { -1.0 } else { 1.0 };
        model.within(turned_to(place, Vec3::new(out.x, 0.0, out.y) * inward), |m| {
            house(m, mats, Vec2::new(width, depth), storeys, rng);
        });
        built += 1;
    }
    built
}

/// A house centred on the origin, its front towards +Z; walls reach below the ground on slopes.
fn house(model: &mut Model, mats: &Materials, size: Vec2, storeys: u32, rng: &mut Rng) {
    let (hx, hz) = (0.5 * size.x, 0.5 * size.y);
    let eaves = storeys as f32 * 2.8 + 0.3;
    let is_gable_front = rng.chance(0.3);
    let color = srgb(rng.pick(&[0xf2e6cc, 0xe8d2a8, 0xe2c6a2, 0xf0ead8, 0xd9c3ae, 0xcdd0c4, 0xe6b98c]));
    let roof = srgb(rng.pick(&[0xb06a50, 0xa4604a, 0xb8785c, 0x9c5c4a, 0xac7050, 0x84746c]));
    let walls = model.on(mats.facade);
    walls.tint(color);
    for (yaw, half_width, away) in [(0u32, hx, hz), (1, hz, hx), (2, hx, hz), (3, hz, hx)] {
        let turn = |x: f32, y: f32, z: f32| match yaw {
            0 => Vec3::new(x, y, z),
            1 => Vec3::new(z, y, -x),
            2 => Vec3::new(-x, y, -z),
            _ => Vec3::new(-z, y, x),
        };
        let bays = (half_width * 2.0 / 2.2).floor().max(1.0);
        let v = |y: f32| -(y - 0.3) / 2.8;
        let (low, high) = (-2.5, eaves);
        walls.polygon(&[
            (turn(-half_width, low, away), Vec2::new(0.0, v(low))),
            (turn(half_width, low, away), Vec2::new(bays, v(low))),
            (turn(half_width, high, away), Vec2::new(bays, v(high))),
            (turn(-half_width, high, away), Vec2::new(0.0, v(high))),
        ]);
    }
    let yaw = if is_gable_front { TAU / 4.0 } else { 0.0 };
    let (along, half_span) = if is_gable_front { (hz, hx) } else { (hx, hz) };
    let rise = half_span * rng.range(0.95, 1.25);
    model.within(standing(Vec3::Y * eaves, yaw), |m| {
        let gable = m.on(mats.plain);
        gable.tint(color * 0.95);
        for side in [-1.0f32, 1.0] {
            let x = along * side;
            let foot = half_span * side;
            gable.face(&[Vec3::new(x, 0.0, foot), Vec3::new(x, 0.0, -foot), Vec3::new(x, rise, 0.0)]);
        }
        let tiles = m.on(mats.tiles);
        tiles.tint(roof * rng.range(0.85, 1.1));
        let over = 0.45;
        let drop = -over * rise / half_span + 0.1;
        let (x, top) = (along + 0.3, rise + 0.1);
        for s in [-1.0f32, 1.0] {
            let low = (half_span + over) * s;
            let p = |x: f32, y: f32, z: f32| Vec3::new(x * s, y, z);
            slab(tiles, [p(-x, drop, low), p(x, drop, low), p(x, top, 0.0), p(-x, top, 0.0)], 0.14);
        }
        let (cx, cz) = (along * rng.range(-0.6, 0.6), half_span * 0.3);
        let chimney = m.on(mats.stone);
        chimney.tint(srgb(0xb98a70));
        chimney.block(Vec3::new(cx - 0.3, rise * 0.4, cz - 0.3), Vec3::new(cx + 0.3, rise + 0.9, cz + 0.3));
    });
}

/// Round trees behind the houses of a lane.
fn gardens(model: &mut Model, mats: &Materials, radius: f32, height: &impl Fn(Vec2) -> f32, rng: &mut Rng) {
    let count = (radius * 0.16) as u32;
    for _ in 0..count {
        let angle = rng.range(0.0, TAU);
        let (s, c) = sin_cos(angle);
        let p = Vec2::new(s, c) * (radius + rng.range(-1.0, 1.0));
        if road_distance(p) > 5.0 {
            blob_tree(model.on(mats.leaf), Vec3::new(p.x, height(p), p.y), rng.range(1.2, 2.0), rng);
        }
    }
}

fn countryside(
    model: &mut Model,
    mats: &Materials,
    from: f32,
    to: f32,
    height: &impl Fn(Vec2) -> f32,
    rng: &mut Rng,
) {
    for _ in 0..420 {
        let angle = rng.range(0.0, TAU);
        let (s, c) = sin_cos(angle);
        let p = Vec2::new(s, c) * rng.range(from, to * 0.98);
        let is_copse = noise(p / 45.0 + Vec2::splat(50.0), 0, 9) > 0.55;
        if is_copse && road_distance(p) > 7.0 {
            blob_tree(model.on(mats.leaf), Vec3::new(p.x, height(p), p.y), rng.range(1.8, 3.2), rng);
        }
    }
}

fn blob_tree(part: &mut Part, at: Vec3, size: f32, rng: &mut Rng) {
    part.tint(srgb(0x5a4838)).tube(&[at - Vec3::Y * 0.5, at + Vec3::Y * (1.4 * size)], |_| 0.12 * size, 4);
    let green = srgb(rng.pick(&[0x5f8038, 0x6f8f42, 0x4f7034, 0x82964a]));
    let crown = at + Vec3::Y * (1.9 * size);
    part.tint(green).ellipsoid(crown, Vec3::new(1.0, 1.2, 1.0) * size, 4, 6);
    let aside = rng.direction() * Vec3::new(0.7, 0.3, 0.7) * size;
    part.tint(green * 1.1).ellipsoid(crown + aside, Vec3::splat(0.62 * size), 3, 5);
}

/// The town wall with its towers, gates left open where roads pass.
fn wall(model: &mut Model, mats: &Materials, radius: f32, height: &impl Fn(Vec2) -> f32) {
    let towers = ROADS * ((radius * TAU / ROADS as f32 / 38.0) as u32).max(2);
    let point = |i: u32| {
        let (s, c) = sin_cos((i as f32 + 0.5) / towers as f32 * TAU);
        let p = Vec2::new(s, c) * radius;
        Vec3::new(p.x, height(p), p.y)
    };
    for i in 0..towers {
        let (a, b) = (point(i), point(i + 1));
        let stone = model.on(mats.stone);
        stone.tint(srgb(0xd8cdb8));
        let foot = a - Vec3::Y * 4.0;
        stone.cylinder(foot, a + Vec3::Y * 9.5, 2.8, 2.6, 16);
        model.on(mats.tiles).tint(srgb(0xa04c36)).cylinder(
            a + Vec3::Y * 9.5,
            a + Vec3::Y * 14.0,
            3.2,
            0.0,
            16,
        );
        if (i + 1) % (towers / ROADS) == 0 {
            // A gatehouse arch spans the road between this tower and the next.
            let (l, r) = (a.lerp(b, 0.42) + Vec3::Y * 2.0, a.lerp(b, 0.58) + Vec3::Y * 2.0);
            let stone = model.on(mats.stone);
            stone.tint(srgb(0xd8cdb8));
            stone.bar(l + Vec3::Y * 4.5, r + Vec3::Y * 4.5, 2.6, 4.0);
            curtain(stone, a, a.lerp(b, 0.42));
            curtain(stone, a.lerp(b, 0.58), b);
        } else {
            curtain(model.on(mats.stone).tint(srgb(0xd8cdb8)), a, b);
        }
    }
}

/// A stretch of wall with merlons.
fn curtain(stone: &mut Part, a: Vec3, b: Vec3) {
    let rise = Vec3::Y * 6.0;
    let out = Vec3::Y.cross(b - a).normalize_or(Vec3::X) * 0.7;
    let deep = Vec3::Y * 4.0;
    stone.face(&[a - deep - out, b - deep - out, b + rise - out, a + rise - out]);
    stone.face(&[b - deep + out, a - deep + out, a + rise + out, b + rise + out]);
    stone.face(&[a + rise - out, b + rise - out, b + rise + out, a + rise + out]);
    let merlons = (a.distance(b) / 2.2) as u32;
    for i in 0..merlons {
        let [p, q] = [0.25, 0.75].map(|k| a.lerp(b, (i as f32 + k) / merlons as f32) + rise + out * 0.7);
        let top = Vec3::Y * 1.1;
        let depth = out * 0.5;
        let corners = [p - depth, q - depth, q + depth, p + depth];
        for k in 0..4 {
            let (c, d) = (corners[k], corners[(k + 1) % 4]);
            stone.face(&[c, d, d + top, c + top]);
        }
        stone.face(&corners.map(|c| c + top));
    }
}

/// Nave, apse, buttresses and a tower with a clock and a spire.
fn church(model: &mut Model, mats: &Materials, ground: f32) {
    model.within(standing(Vec3::new(0.0, ground, 0.0), 0.5), |m| {
        let pale = srgb(0xe9dfc8);
        let stone = m.on(mats.stone);
        stone.tint(pale);
        stone.block(Vec3::new(-5.5, -2.0, -16.0), Vec3::new(5.5, 11.0, 8.0));
        stone.block(Vec3::new(-3.6, -2.0, 8.0), Vec3::new(3.6, 26.0, 15.2));
        for (y, reach) in [(9.0, 0.3), (17.5, 0.3), (25.6, 0.5)] {
            stone.block(
                Vec3::new(-3.6 - reach, y, 8.0 - reach),
                Vec3::new(3.6 + reach, y + 0.5, 15.2 + reach),
            );
        }
        stone.cylinder(Vec3::new(0.0, -2.0, -16.0), Vec3::new(0.0, 9.5, -16.0), 4.6, 4.6, 20);
        for side in [-1.0f32, 1.0] {
            for i in 0..6 {
                let z = -14.5 + 4.2 * i as f32;
                let (a, b) = (5.5 * side, 6.9 * side);
                stone.block(Vec3::new(a.min(b), -2.0, z - 0.45), Vec3::new(a.max(b), 8.5, z + 0.45));
            }
        }
        stone.face(&[Vec3::new(-5.5, 11.0, 8.0), Vec3::new(5.5, 11.0, 8.0), Vec3::new(0.0, 18.5, 8.0)]);
        stone.face(&[Vec3::new(5.5, 11.0, -16.0), Vec3::new(-5.5, 11.0, -16.0), Vec3::new(0.0, 18.5, -16.0)]);
        let roof = m.on(mats.tiles);
        roof.tint(srgb(0x8f4a3a));
        for s in [-1.0f32, 1.0] {
            let p = |x: f32, y: f32, z: f32| Vec3::new(x * s, y, z * s);
            let (z0, z1) = if s > 0.0 { (-16.6, 8.0) } else { (-8.0, 16.6) };
            slab(roof, [p(6.3, 10.1, z1), p(6.3, 10.1, z0), p(0.0, 18.7, z0), p(0.0, 18.7, z1)], 0.25);
        }
        roof.cylinder(Vec3::new(0.0, 9.5, -16.0), Vec3::new(0.0, 15.5, -16.0), 5.2, 0.0, 20);
        roof.tint(srgb(0x5f7f78));
        let (apex, y, half) = (Vec3::new(0.0, 47.0, 11.6), 26.1, 4.1);
        let base = [(-half, half), (half, half), (half, -half), (-half, -half)]
            .map(|(x, z)| Vec3::new(x, y, 11.6 + z));
        for k in 0..4 {
            roof.face(&[base[k], base[(k + 1) % 4], apex]);
        }
        m.on(mats.leaf).tint(srgb(0xd8b040)).cylinder(
            apex - Vec3::Y * 0.5,
            apex + Vec3::Y * 2.5,
            0.12,
            0.06,
            6,
        );
        let glass = srgb(0x2c3540);
        for side in [-1.0f32, 1.0] {
            for i in 0..5 {
                let z = -12.4 + 4.2 * i as f32;
                let x = 5.56 * side;
                let (a, b) = (z + 0.7 * side, z - 0.7 * side);
                let window = [
                    Vec3::new(x, 2.5, a),
                    Vec3::new(x, 2.5, b),
                    Vec3::new(x, 7.6, b),
                    Vec3::new(x, 8.8, z),
                    Vec3::new(x, 7.6, a),
                ];
                m.on(mats.leaf).tint(glass).face(&window);
            }
            let x = 3.66 * side;
            let clock = |r: f32| {
                [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(h, v)| Vec3::new(x, 21.5 + v, 11.6 - h * side))
            };
            m.on(mats.clock).picture(clock(1.6));
        }
        let front =
            [(-1.6, 19.9), (1.6, 19.9), (1.6, 23.1), (-1.6, 23.1)].map(|(x, y)| Vec3::new(x, y, 15.26));
        m.on(mats.clock).picture(front);
        let door = [(-1.3, 0.0), (1.3, 0.0), (1.3, 3.0), (0.0, 4.6), (-1.3, 3.0)]
            .map(|(x, y)| Vec3::new(x, y, 15.26));
        m.on(mats.leaf).tint(srgb(0x5a3a26)).face(&door);
    });
}

/// Ground with the town's plan painted on: paved lanes and roads inside the wall, fields outside.
fn ground(kit: &mut Kit, half: f32, town: f32, height: &impl Fn(Vec2) -> f32) {
    let plan = texture::paint("town plan", 512, |uv| {
        let p = (uv - Vec2::splat(0.5)) * (2.0 * half);
        let r = p.length();
        let grain = 0.08 * (fractal_noise(p / 3.0 + Vec2::splat(500.0), 0, 5) - 0.5);
        let color = if road_distance(p) < 3.2 || r < MARKET {
            texture::code(0xc4b496)
        } else if r < town {
            let lane = (r - MARKET - 6.0) / LANE;
            let is_lane = (lane - lane.floor() - 0.5).abs() > 0.30;
            texture::code(if is_lane { 0xb8a98c } else { 0x8c9a5c })
        } else {
            let field = noise((p / 38.0).floor() + Vec2::splat(200.001), 0, 77);
            let furrow = 0.02 * sin(p.dot(Vec2::new(field, 1.0 - field)) * 2.2);
            let crop = [0x93a558, 0xa9b066, 0xc4b678, 0x7f9a50, 0xb4a46c][(field * 5.0) as usize % 5];
            texture::code(crop) + Vec3::splat(furrow)
        };
        (color + Vec3::splat(grain), 1.0)
    });
    let soil = kit.textured("ground", Vec3::ONE, plan);
    let mut model = Model::new();
    let cells = ((2.0 * half / 10.5) as u32).min(240);
    terrain::heightfield(model.on(soil), half, cells, 0.5 / half, height, |_| Vec3::ONE);
    kit.add("ground", model);
}
