//! `street`: a winding old-town street under wires and bunting, its left façades in grazing sun.

use lt_math::glam::{Vec2, Vec3};

use super::{
    furniture::{self, FurnitureMaterials},
    house::{House, HouseMaterials},
    kit::Kit,
    model::{Model, Part, hanging},
    numbers::{sin, sin_cos, srgb, standing, turned_to},
    rng::Rng,
    texture, tree,
};
use crate::Scene;

/// Half the roadway and the distance from the middle to the façades, metres.
const CURB: f32 = 3.1;
const FACADE: f32 = 5.9;
const STEP: f32 = 1.0;

/// The street's middle line, walked in steps of one metre towards −Z.
struct Route {
    points: Vec<Vec3>,
}

impl Route {
    fn new(length: f32) -> Self {
        let mut at = Vec3::ZERO;
        let points = (0..=(length / STEP) as u32 + 2)
            .map(|i| {
                let here = at;
                let (s, c) = sin_cos(Self::heading(i as f32 * STEP));
                at += Vec3::new(s, 0.0, -c) * STEP;
                here
            })
            .collect();
        Self { points }
    }

    /// Clockwise angle from −Z at distance `s`, radians.
    fn heading(s: f32) -> f32 {
        0.62 * sin((s - 14.0) / 46.0)
    }

    /// The point at distance `s`, `side` metres to the right, `height` above the road's edge.
    fn at(&self, s: f32, side: f32, height: f32) -> Vec3 {
        let place = (s / STEP).clamp(0.0, (self.points.len() - 2) as f32);
        let i = place as usize;
        let middle = self.points[i].lerp(self.points[i + 1], place - i as f32);
        let (sn, cs) = sin_cos(Self::heading(s));
        middle + Vec3::new(cs, 0.0, sn) * side + Vec3::Y * height
    }

    /// Draws a strip from `left` to `right` of the middle, following the route.
    fn strip(&self, part: &mut Part, [s0, s1]: [f32; 2], left: Vec2, right: Vec2, texture_scale: f32) {
        let count = ((s1 - s0) / 2.0) as u32;
        let across = left.distance(right) * texture_scale;
        for i in 0..count {
            let [a, b] = [i, i + 1].map(|k| s0 + (s1 - s0) * k as f32 / count as f32);
            let point = |s: f32, edge: Vec2| self.at(s, edge.x, edge.y);
            let uv = |s: f32, u: f32| Vec2::new(u, -s * texture_scale);
            part.polygon(&[
                (point(a, left), uv(a, 0.0)),
                (point(a, right), uv(a, across)),
                (point(b, right), uv(b, across)),
                (point(b, left), uv(b, 0.0)),
            ]);
        }
    }
}

/// Grows the street with `houses` houses in all.
pub fn grow(houses: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("street");
    let mats = HouseMaterials::new(&mut kit);
    let things = FurnitureMaterials::new(&mut kit);
    let mut rng = Rng::new(seed, 1);
    let per_side = houses.div_ceil(2);
    // Houses are at most 9.6 m wide; the road runs on past the last.
    let route = Route::new(per_side as f32 * 9.6 + 40.0);

    let mut end = 0.0f32;
    let mut eaves = Vec::new();
    for side in [-1.0f32, 1.0] {
        let count = if side < 0.0 { per_side } else { houses - per_side };
        let mut s = rng.range(0.0, 1.5);
        for _ in 0..count {
            let width = rng.range(6.6, 9.6);
            let (a, b) = (route.at(s, side * FACADE, 0.15), route.at(s + width, side * FACADE, 0.15));
            let house = House::random(a.distance(b), &mut rng);
            // Seen from the street a house runs left to right: up the street on the left, down it on the right.
            let (origin, far) = if side < 0.0 { (a, b) } else { (b, a) };
            let along = far - origin;
            let mut model = Model::new();
            model.frame = turned_to(origin, along.normalize_or(Vec3::X).cross(Vec3::Y));
            house.draw(&mut model, &mats, &mut rng);
            kit.add("house", model);
            eaves.push((side, s + 0.5 * width, house.eaves()));
            s += width;
        }
        end = end.max(s);
    }

    ground(&mut kit, &route, end);
    overhead(&mut kit, &things, &route, &eaves, end, &mut rng);
    furnish(&mut kit, &things, &route, end, &mut rng);
    kit.finish(Vec3::new(0.24, 0.62, 0.62), route.at(9.0, 1.3, 1.75), route.at(34.0, -0.6, 3.1), 62.0)
}

fn ground(kit: &mut Kit, route: &Route, end: f32) {
    let road = kit.textured("asphalt", srgb(0xe8e4de), texture::asphalt());
    let paving = kit.textured("paving", Vec3::ONE, texture::paving());
    let curb = kit.plain("curb", srgb(0xb9b2a6));
    let grass = kit.textured("grass", Vec3::ONE, texture::grass());
    let mark = kit.plain("road paint", srgb(0xdedacb));
    let mut model = Model::new();
    let span = [0.0, end + 30.0];
    let crown = Vec2::new(0.0, 0.06);
    route.strip(model.on(road), span, Vec2::new(-CURB, 0.0), crown, 0.4);
    route.strip(model.on(road), span, crown, Vec2::new(CURB, 0.0), 0.4);
    let (top, back) = (0.13, 0.15);
    for side in [-1.0, 1.0] {
        let at = |x: f32, y: f32| Vec2::new(side * x, y);
        let lip = CURB + 0.14;
        let mut strip = |material: u32, near: Vec2, far: Vec2, scale: f32| {
            let (l, r) = if side < 0.0 { (far, near) } else { (near, far) };
            route.strip(model.on(material), span, l, r, scale);
        };
        strip(curb, at(CURB, 0.0), at(CURB + 0.02, top), 1.0);
        strip(curb, at(CURB + 0.02, top), at(lip, top), 1.0);
        strip(paving, at(lip, top), at(FACADE + 1.5, back), 0.8);
    }
    let dashes = ((end + 20.0) / 5.0) as u32;
    for i in 0..dashes {
        let s = i as f32 * 5.0;
        route.strip(model.on(mark), [s, s + 2.0], Vec2::new(-0.06, 0.066), Vec2::new(0.06, 0.066), 1.0);
    }
    let middle = route.at(0.5 * end, 0.0, 0.0);
    let half = end + 60.0;
    let at = |x: f32, z: f32| Vec3::new(middle.x + x * half, -0.05, middle.z + z * half);
    model.on(grass).face(&[at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0), at(-1.0, -1.0)]);
    kit.add("ground", model);
}

/// Wires along and across the street, lamps hung from them, and bunting.
fn overhead(
    kit: &mut Kit,
    things: &FurnitureMaterials,
    route: &Route,
    eaves: &[(f32, f32, f32)],
    end: f32,
    rng: &mut Rng,
) {
    let wire = kit.plain("wire", srgb(0x1e1e20));
    let cloth = kit.sheet("cloth");
    let height = |side: f32, s: f32| {
        let nearest =
            eaves.iter().filter(|e| e.0 == side).min_by(|a, b| (a.1 - s).abs().total_cmp(&(b.1 - s).abs()));
        nearest.map_or(6.0, |e| e.2)
    };
    let mut model = Model::new();
    let crossings = (end / 7.0) as u32;
    for i in 0..crossings {
        let s = 3.0 + i as f32 * 7.0;
        let skew = rng.range(-2.0, 2.0);
        let anchor = |side: f32, s: f32| route.at(s, side * FACADE, (height(side, s) - 0.8).min(7.2));
        let (a, b) = (anchor(-1.0, s), anchor(1.0, s + skew));
        let path = hanging(a, b, rng.range(0.25, 0.6), 24);
        model.on(wire).tube(&path, |_| 0.003, 4);
        match i % 3 {
            0 => hung_lamp(&mut model, wire, cloth, path[12]),
            1 => bunting(&mut model, cloth, &path, rng),
            _ => {}
        }
    }
    // Two service lines swing from bracket to bracket along the right-hand fronts, one along the left.
    for (side, up, out) in [(1.0f32, 6.1, 0.55), (1.0, 5.8, 0.62), (-1.0, 6.3, 0.5)] {
        let spans = (end / 11.0) as u32;
        for i in 0..spans {
            let [a, b] = [i, i + 1].map(|k| route.at(2.0 + k as f32 * 11.0, side * (FACADE - out), up));
            model.on(wire).tube(&hanging(a, b, 0.35, 20), |_| 0.0025, 4);
            let wall = route.at(2.0 + i as f32 * 11.0, side * (FACADE + 0.1), up - 0.1);
            model.on(wire).bar(wall, a, 0.03, 0.03);
        }
    }
    kit.add("overhead", model);
    let mut lamp = Model::new();
    furniture::lamp(&mut lamp, things);
    let lamp = kit.stamp("lamp", lamp);
    let mut s = 8.0;
    let mut side = -1.0;
    while s < end {
        kit.place(&lamp, standing(route.at(s, side * (CURB + 0.45), 0.13), -Route::heading(s)));
        s += 9.0;
        side = -side;
    }
}

fn hung_lamp(model: &mut Model, wire: u32, shade: u32, at: Vec3) {
    model.on(wire).bar(at, at - Vec3::Y * 0.35, 0.008, 0.008);
    let foot = at - Vec3::Y * 0.72;
    let bell = [(0.27, 0.0), (0.25, 0.06), (0.13, 0.20), (0.05, 0.30), (0.03, 0.38), (0.0, 0.40)];
    let bell: Vec<Vec2> = bell.iter().map(|&(r, y)| Vec2::new(r, y)).collect();
    model.on(shade).tint(srgb(0x3f5a54)).lathe(foot, &bell, 14);
    model.on(shade).tint(srgb(0xf7f0d8)).ellipsoid(foot, Vec3::new(0.11, 0.13, 0.11), 6, 10);
}

fn bunting(model: &mut Model, cloth: u32, path: &[Vec3], rng: &mut Rng) {
    let colors = [0xc8473c, 0xf0c24b, 0x3f7f8c, 0xf3ead6, 0x6f8f4a];
    let part = model.on(cloth);
    for (i, pair) in path.windows(2).enumerate() {
        let swing = Vec3::new(rng.range(-0.08, 0.08), 0.0, rng.range(-0.08, 0.08));
        let tip = pair[0].lerp(pair[1], 0.42) - Vec3::Y * 0.36 + swing;
        part.tint(srgb(colors[i % colors.len()]));
        part.face(&[pair[0], tip, pair[0].lerp(pair[1], 0.84)]);
    }
}

/// Trees, cars, bicycles, tables, bollards and area railings along both pavements.
fn furnish(kit: &mut Kit, things: &FurnitureMaterials, route: &Route, end: f32, rng: &mut Rng) {
    let bark = kit.bark();
    let leaf = kit.sheet("leaf");
    let trees: Vec<_> = (0..2)
        .map(|_| {
            let mut model = Model::new();
            let twigs = tree::broadleaf_wood(&mut model, bark, rng.range(5.2, 6.0), 2, rng);
            tree::single_leaves(&mut model, leaf, &twigs, 22, 0.62, rng);
            kit.stamp("tree", model)
        })
        .collect();
    let cars: Vec<_> = [0x9c2f2a, 0x2f4f6b, 0xd9d4c6, 0x54685a, 0xc99a3c]
        .iter()
        .map(|&color| {
            let mut model = Model::new();
            furniture::car(&mut model, things, srgb(color));
            kit.stamp("car", model)
        })
        .collect();
    let mut bicycle = Model::new();
    furniture::bicycle(&mut bicycle, things, srgb(0x2e6d6a));
    let bicycle = kit.stamp("bicycle", bicycle);
    let mut table = Model::new();
    furniture::cafe_table(&mut table, things, srgb(0xb5483a));
    let table = kit.stamp("table", table);
    let mut bollard = Model::new();
    furniture::bollard(&mut bollard, things);
    let bollard = kit.stamp("bollard", bollard);
    let mut railing = Model::new();
    furniture::railing(&mut railing, things, 2.4, 0.95, 0.12);
    let railing = kit.stamp("railing", railing);

    let along = |s: f32| core::f32::consts::FRAC_PI_2 - Route::heading(s);
    let mut s = 14.0;
    let mut turn = 0u32;
    while s < end - 3.0 {
        let walk = CURB + 0.5;
        match turn % 4 {
            0 => {
                kit.place(rng.pick_ref(&trees), standing(route.at(s, walk + 0.2, 0.13), rng.range(0.0, 6.2)))
            }
            1 => {
                let lane = CURB - 0.95;
                kit.place(rng.pick_ref(&cars), standing(route.at(s, lane, 0.02), along(s)));
                if rng.chance(0.6) {
                    kit.place(rng.pick_ref(&cars), standing(route.at(s + 5.0, lane, 0.02), along(s + 5.0)));
                }
            }
            2 => {
                for k in 0..2 {
                    kit.place(
                        &table,
                        standing(route.at(s + k as f32 * 2.9, -(walk + 0.7), 0.14), rng.range(0.0, 6.2)),
                    );
                }
            }
            _ => {
                kit.place(&bicycle, standing(route.at(s, -(walk + 0.05), 0.13), along(s) + 0.15));
                kit.place(&railing, standing(route.at(s + 2.0, walk, 0.13), along(s + 3.2)));
                for k in 0..4 {
                    let at = s + 1.5 + k as f32 * 1.4;
                    kit.place(&bollard, standing(route.at(at, -(CURB + 0.35), 0.13), 0.0));
                }
            }
        }
        s += 4.6;
        turn += 1;
    }
    // A foreground group so that the first glance meets detail.
    kit.place(&table, standing(route.at(14.2, -(CURB + 1.3), 0.14), 0.4));
    kit.place(&bicycle, standing(route.at(13.0, CURB + 0.55, 0.13), along(13.0) - 0.1));
}
