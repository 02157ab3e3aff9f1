//! `square`: a park between rows of town houses, its trees and furniture instanced from a few models.

use lt_math::glam::{Vec2, Vec3};

use super::{
    furniture::{self, FurnitureMaterials},
    house::{House, HouseMaterials},
    kit::{Kit, Stamp},
    model::Model,
    numbers::{TAU, sin_cos, srgb, standing, standing_scaled, turned_to},
    rng::Rng,
    texture, tree,
};
use crate::Scene;

const QUARTER: f32 = TAU / 4.0;
const HOUSE_WIDTH: f32 = 8.0;
const PATH_HALF: f32 = 1.5;
const PLAZA: f32 = 7.5;

/// The park's extent and where nothing may be planted.
struct Park {
    half: Vec2,
    eye: Vec2,
}

impl Park {
    /// The park's diagonals are its paths.
    fn path_distance(&self, p: Vec2) -> f32 {
        let direction = self.half.normalize();
        p.perp_dot(direction).abs().min(p.perp_dot(direction * Vec2::new(1.0, -1.0)).abs())
    }

    fn is_plantable(&self, p: Vec2, trees: &[Vec2], spacing: f32) -> bool {
        p.length() > PLAZA + 2.0
            && self.path_distance(p) > PATH_HALF + 1.0
            && (p.distance(self.eye) > 6.0)
            && trees.iter().all(|t| t.distance(p) > spacing)
    }
}

/// The square with `trees` trees; its size follows their number.
pub fn grow(trees: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("square");
    let mut rng = Rng::new(seed, 1);
    let scale = (trees as f32 / 72.0).sqrt().max(0.7);
    let half = Vec2::new(34.0, 25.0) * scale;
    let park = Park { half, eye: half.normalize() * Vec2::new(-1.0, 1.0) * 16.5 + Vec2::new(1.0, 0.9) };
    ground(&mut kit, &park);
    houses(&mut kit, &park, &mut rng);
    plant(&mut kit, &park, trees, &mut rng);
    furnish(&mut kit, &park, &mut rng);
    let eye = park.eye.extend(1.75);
    kit.finish(Vec3::new(-0.62, 0.60, -0.30), Vec3::new(eye.x, eye.z, eye.y), Vec3::new(2.5, 2.7, -3.5), 58.0)
}

fn ground(kit: &mut Kit, park: &Park) {
    let grass = kit.textured("grass", Vec3::ONE, texture::grass());
    let gravel = kit.textured("gravel", srgb(0xf2ece2), texture::gravel());
    let asphalt = kit.textured("asphalt", srgb(0xe4e0da), texture::asphalt());
    let paving = kit.textured("paving", Vec3::ONE, texture::paving());
    let curb = kit.plain("curb", srgb(0xc2bbae));
    let mut model = Model::new();
    let flat = |half: Vec2, y: f32| {
        [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]
            .map(|(x, z)| Vec3::new(x * half.x, y, z * half.y))
    };
    model.on(grass).face(&flat(park.half + Vec2::splat(80.0), -0.2));
    model.on(asphalt).face(&flat(park.half + Vec2::splat(8.5), -0.12));
    // Pavements: around the park, and before the houses.
    let frame = |model: &mut Model, material: u32, inner: Vec2, outer: Vec2, y: f32| {
        let (i, o) = (flat(inner, y), flat(outer, y));
        for k in 0..4 {
            let n = (k + 1) % 4;
            model.on(material).face(&[o[k], o[n], i[n], i[k]]);
        }
    };
    let edge = park.half + Vec2::splat(2.2);
    frame(&mut model, paving, park.half, edge, 0.0);
    let far = park.half + Vec2::splat(8.5);
    frame(&mut model, paving, far, far + Vec2::splat(8.0), 0.0);
    for (half, reach) in [(edge, 0.14), (far, -0.14)] {
        let outer = half + Vec2::splat(reach);
        frame(&mut model, curb, half.min(outer), half.max(outer), 0.002);
        let (top, bottom) = (flat(outer, 0.002), flat(outer, -0.12));
        for k in 0..4 {
            let n = (k + 1) % 4;
            let wall = [bottom[k], bottom[n], top[n], top[k]];
            let wall = if reach > 0.0 { wall } else { [wall[1], wall[0], wall[3], wall[2]] };
            model.on(curb).face(&wall);
        }
    }
    model.on(grass).face(&flat(park.half, 0.03));
    // The diagonals, then the plaza over their crossing.
    for (sign, y) in [(1.0, 0.040), (-1.0, 0.048)] {
        let end = Vec2::new(park.half.x, sign * park.half.y);
        let side = end.normalize().perp() * PATH_HALF;
        let corners = [-end + side, -end - side, end - side, end + side].map(|p| Vec3::new(p.x, y, p.y));
        let mut corners = corners.map(|p| p.clamp(flat(park.half, -9.0)[3], flat(park.half, 9.0)[1]));
        corners.reverse();
        model.on(gravel).face(&corners);
    }
    let disc: Vec<Vec3> = (0..48)
        .map(|i| {
            let (s, c) = sin_cos(-TAU * i as f32 / 48.0);
            Vec3::new(c * PLAZA, 0.056, s * PLAZA)
        })
        .collect();
    model.on(gravel).face(&disc);
    fountain(&mut model, kit);
    kit.add("ground", model);
}

/// A round basin with a tazza on a baluster.
fn fountain(model: &mut Model, kit: &mut Kit) {
    let stone = kit.textured("fountain", srgb(0xe4dccb), texture::plaster());
    let water = kit.plain("water", srgb(0x5f8a98));
    let lathe = |model: &mut Model, material: u32, profile: &[(f32, f32)]| {
        let profile: Vec<Vec2> = profile.iter().map(|&(r, y)| Vec2::new(r, y)).collect();
        model.on(material).lathe(Vec3::ZERO, &profile, 48);
    };
    lathe(
        model,
        stone,
        &[
            (3.1, 0.03),
            (3.1, 0.12),
            (2.85, 0.16),
            (2.8, 0.52),
            (2.92, 0.60),
            (2.92, 0.68),
            (2.6, 0.68),
            (2.6, 0.40),
        ],
    );
    lathe(
        model,
        stone,
        &[
            (0.5, 0.35),
            (0.5, 0.62),
            (0.26, 0.8),
            (0.2, 1.2),
            (0.34, 1.5),
            (0.2, 1.62),
            (0.95, 1.95),
            (1.15, 2.1),
            (1.1, 2.14),
            (0.9, 2.02),
        ],
    );
    lathe(model, stone, &[(0.18, 2.0), (0.14, 2.4), (0.26, 2.62), (0.12, 2.75), (0.16, 2.9), (0.0, 3.25)]);
    lathe(model, water, &[(2.62, 0.50), (0.0, 0.50)]);
    lathe(model, water, &[(1.0, 2.07), (0.0, 2.07)]);
}

/// Rows of six kinds of houses on all four sides, fronts towards the park.
fn houses(kit: &mut Kit, park: &Park, rng: &mut Rng) {
    let mats = HouseMaterials::new(kit);
    let stamps: Vec<Stamp> = (0..7)
        .map(|_| {
            let mut model = Model::new();
            House::random(HOUSE_WIDTH, rng).draw(&mut model, &mats, rng);
            kit.stamp("house", model)
        })
        .collect();
    let front = park.half + Vec2::splat(12.5);
    let mut last = usize::MAX;
    for side in 0..4 {
        let (reach, away) = if side % 2 == 0 { (front.x, front.y) } else { (front.y, front.x) };
        let yaw = side as f32 * QUARTER;
        let (s, c) = sin_cos(yaw);
        let count = (2.0 * reach / HOUSE_WIDTH) as u32;
        for i in 0..count {
            let x = (i as f32 - 0.5 * count as f32) * HOUSE_WIDTH;
            // Local (x, −away) turned by yaw.
            let origin = Vec3::new(c * x - s * away, 0.0, -s * x - c * away);
            let mut kind = rng.below(stamps.len() as u32) as usize;
            if kind == last {
                kind = (kind + 1) % stamps.len();
            }
            last = kind;
            kit.place(&stamps[kind], standing(origin, yaw));
        }
    }
}

fn plant(kit: &mut Kit, park: &Park, count: u32, rng: &mut Rng) {
    let bark = kit.bark();
    let leaf = kit.cutout("leaves", Vec3::ONE, texture::leaves());
    let kinds: Vec<Stamp> = [(9.5, 0xffffff), (8.0, 0xf6ffd8), (10.5, 0xe2f0d0)]
        .iter()
        .map(|&(height, tint)| {
            let mut model = Model::new();
            let twigs = tree::broadleaf_wood(&mut model, bark, height, 3, rng);
            tree::leaf_cards(&mut model, leaf, &twigs, 3, 1.15, srgb(tint), rng);
            kit.stamp("tree", model)
        })
        .collect();
    let mut standing_trees: Vec<Vec2> = Vec::new();
    for _ in 0..count {
        // Darts with a relaxing distance: dense planting stays possible.
        let mut spacing = 5.5;
        let at = loop {
            let p = Vec2::new(rng.range(-1.0, 1.0), rng.range(-1.0, 1.0)) * (park.half - Vec2::splat(1.5));
            if park.is_plantable(p, &standing_trees, spacing) || spacing < 0.1 {
                break p;
            }
            spacing *= 0.97;
        };
        standing_trees.push(at);
        let size = rng.range(0.82, 1.12);
        let scale = Vec3::new(size, size * rng.range(0.9, 1.1), size);
        let place = standing_scaled(Vec3::new(at.x, 0.0, at.y), rng.range(0.0, TAU), scale);
        kit.place(rng.pick_ref(&kinds), place);
    }
}

/// Benches and lamps along the paths and around the plaza, railings around the park, parked cars.
fn furnish(kit: &mut Kit, park: &Park, rng: &mut Rng) {
    let things = FurnitureMaterials::new(kit);
    let stamp = |kit: &mut Kit, name: &str, draw: &dyn Fn(&mut Model)| {
        let mut model = Model::new();
        draw(&mut model);
        kit.stamp(name, model)
    };
    let bench = stamp(kit, "bench", &|m| furniture::bench(m, &things));
    let lamp = stamp(kit, "lamp", &|m| furniture::lamp(m, &things));
    let railing = stamp(kit, "railing", &|m| furniture::railing(m, &things, 2.0, 0.85, 0.14));
    let cars = [0x8d2b28, 0x33506e, 0xd5d0c2, 0x4c6353]
        .map(|color| stamp(kit, "car", &|m| furniture::car(m, &things, srgb(color))));

    for i in 0..12 {
        let (s, c) = sin_cos((i as f32 + 0.5) / 12.0 * TAU);
        let out = Vec2::new(s, c);
        if park.path_distance(out * PLAZA) > PATH_HALF + 0.9 {
            let at = out * (PLAZA - 0.7);
            kit.place(
                &bench,
                standing(Vec3::new(at.x, 0.056, at.y), (i as f32 + 0.5) / 12.0 * TAU + 0.5 * TAU),
            );
        }
        if i % 3 == 0 {
            let (s, c) = sin_cos((i as f32 + 1.0) / 12.0 * TAU);
            kit.place(&lamp, standing(Vec3::new(s * (PLAZA + 0.4), 0.03, c * (PLAZA + 0.4)), 0.0));
        }
    }
    for (sx, sz) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let along = Vec2::new(sx * park.half.x, sz * park.half.y).normalize();
        let side = along.perp();
        let mut s = PLAZA + 3.0;
        while s < park.half.length() - 6.0 {
            let bench_at = along * s + side * (PATH_HALF + 0.45);
            let lamp_at = along * (s + 3.5) - side * (PATH_HALF + 0.35);
            s += 8.0;
            if lamp_at.distance(park.eye).min(bench_at.distance(park.eye)) < 5.0 {
                continue;
            }
            kit.place(
                &bench,
                turned_to(Vec3::new(bench_at.x, 0.03, bench_at.y), Vec3::new(-side.x, 0.0, -side.y)),
            );
            kit.place(&lamp, standing(Vec3::new(lamp_at.x, 0.03, lamp_at.y), 0.0));
        }
    }
    for side in 0..4 {
        let (reach, away) =
            if side % 2 == 0 { (park.half.x, park.half.y) } else { (park.half.y, park.half.x) };
        let yaw = side as f32 * QUARTER;
        let (s, c) = sin_cos(yaw);
        let turned = |x: f32, z: f32| Vec3::new(c * x + s * z, 0.0, -s * x + c * z);
        // Gaps at the corners, where the paths come out.
        let count = ((2.0 * reach - 5.0) / 2.0) as u32;
        for i in 0..count {
            kit.place(&railing, standing(turned(i as f32 * 2.0 - count as f32, away - 0.1), yaw));
        }
        let parked = (reach / 6.0) as u32;
        for i in 0..parked {
            if rng.chance(0.7) {
                let at = turned((i as f32 - 0.5 * parked as f32) * 6.0, away + 3.3) - Vec3::Y * 0.12;
                kit.place(rng.pick_ref(&cars), standing(at, yaw));
            }
        }
    }
}
