//! Trees: tapered branches split recursively, foliage as cut-out cards or single leaves at the twigs.

use lt_math::glam::{Vec2, Vec3};

use super::{
    model::Model,
    numbers::{TAU, across, sin_cos, srgb},
    rng::Rng,
};

/// A twig's end: where foliage grows and which way it points.
type Twig = (Vec3, Vec3);

/// A broad-leaved tree's wood; returns the twigs. `height` in metres, `levels` of branching above the trunk.
pub fn broadleaf_wood(model: &mut Model, bark: u32, height: f32, levels: u32, rng: &mut Rng) -> Vec<Twig> {
    let mut twigs = Vec::new();
    let trunk = Branch {
        foot: Vec3::ZERO,
        along: Vec3::Y,
        length: height * 0.42,
        radius: height * 0.022,
        level: levels,
    };
    let mut growing = vec![trunk];
    while let Some(branch) = growing.pop() {
        branch.grow(model, bark, levels, rng, &mut growing, &mut twigs);
    }
    twigs
}

struct Branch {
    foot: Vec3,
    along: Vec3,
    length: f32,
    radius: f32,
    level: u32,
}

impl Branch {
    fn grow(
        &self,
        model: &mut Model,
        bark: u32,
        levels: u32,
        rng: &mut Rng,
        growing: &mut Vec<Self>,
        twigs: &mut Vec<Twig>,
    ) {
        let is_trunk = self.level == levels;
        let segments = if is_trunk { 6 } else { 3 };
        let mut path = vec![self.foot];
        let mut along = self.along;
        for _ in 0..segments {
            let lift = if is_trunk { Vec3::ZERO } else { Vec3::Y * 0.12 };
            let wander = if is_trunk { 0.06 } else { 0.16 };
            along = (along + rng.in_cube() * wander + lift).normalize_or(Vec3::Y);
            let end = path[path.len() - 1] + along * (self.length / segments as f32);
            path.push(end);
        }
        let taper = if is_trunk { 0.45 } else { 0.6 };
        let flare = |t: f32| if is_trunk { 0.5 * (1.0 - 6.0 * t).max(0.0) } else { 0.0 };
        let sides = [4, 5, 7, 10][self.level.min(3) as usize];
        model.on(bark).tube(&path, |t| self.radius * (1.0 - taper * t + flare(t)), sides);
        let tip = path[segments];
        if self.level == 0 {
            twigs.push((tip, along));
            twigs.push((path[segments / 2 + 1].lerp(path[segments / 2], 0.5), along));
            return;
        }
        let children = if is_trunk { 6 } else { 4 };
        let spin = rng.range(0.0, TAU);
        for i in 0..children {
            let (u, v) = across(along);
            let (s, c) = sin_cos(spin + i as f32 * 2.4);
            let steep = if i == 0 { 0.25 } else { rng.range(0.75, 1.15) };
            let out = (along + (u * c + v * s) * steep).normalize_or(Vec3::Y);
            // The trunk's boughs start below its tip, others at the tip or half way.
            let t = if i == 0 { 1.0 } else { 1.0 - rng.range(0.0, if is_trunk { 0.45 } else { 0.5 }) };
            let place = t * segments as f32;
            let at = (place as usize).min(segments - 1);
            growing.push(Self {
                foot: path[at].lerp(path[at + 1], place - at as f32),
                along: out,
                length: self.length * rng.range(0.58, 0.78) * if is_trunk { 0.95 } else { 0.85 },
                radius: self.radius * if i == 0 { 0.55 } else { 0.42 },
                level: self.level - 1,
            });
        }
    }
}

/// The middle of the crown that these twigs make up.
fn crown_center(twigs: &[Twig]) -> Vec3 {
    twigs.iter().map(|t| t.0).sum::<Vec3>() / twigs.len().max(1) as f32
}

/// Cut-out leaf cards of `size` metres at every twig, shaded as one round crown.
pub fn leaf_cards(
    model: &mut Model,
    material: u32,
    twigs: &[Twig],
    cards: u32,
    size: f32,
    tint: Vec3,
    rng: &mut Rng,
) {
    let center = crown_center(twigs) - Vec3::Y * 0.8;
    let part = model.on(material);
    for &(tip, along) in twigs {
        for _ in 0..cards {
            let up = (along + rng.direction() * 0.9).normalize_or(Vec3::Y);
            let side = up.cross(rng.direction()).normalize_or(Vec3::X);
            let half = size * rng.range(0.38, 0.58);
            let foot = tip + rng.in_cube() * (0.35 * size) - up * (0.6 * half);
            let normal = ((tip - center).normalize_or(Vec3::Y) + rng.in_cube() * 0.35).normalize_or(Vec3::Y);
            part.tint(tint * rng.range(0.8, 1.15));
            let (right, top) = (side * half, up * (2.0 * half));
            part.card([foot - right, foot + right, foot + right + top, foot - right + top], normal);
        }
    }
}

/// Single opaque leaves, `count` around each twig: every one a folded rhombus.
pub fn single_leaves(
    model: &mut Model,
    material: u32,
    twigs: &[Twig],
    count: u32,
    spread: f32,
    rng: &mut Rng,
) {
    let center = crown_center(twigs) - Vec3::Y * 0.5;
    let part = model.on(material);
    for &(tip, _) in twigs {
        for _ in 0..count {
            let at = tip + rng.direction() * (spread * rng.unit());
            let along = rng.direction();
            let side = along.cross(rng.direction()).normalize_or(Vec3::X);
            let length = rng.range(0.13, 0.22);
            let normal = ((at - center).normalize_or(Vec3::Y) + rng.in_cube() * 0.5).normalize_or(Vec3::Y);
            part.tint(srgb(rng.pick(&[0x5d7f35, 0x6f9340, 0x86a44c, 0x4f7030])) * rng.range(0.85, 1.15));
            let (a, b) = (at - along * length, at + along * length);
            let half = side * (0.42 * length);
            part.card([a, at - half, b, at + half], normal);
        }
    }
}

/// A fir of this height: a trunk and drooping whorls of cut-out branches.
pub fn fir(model: &mut Model, bark: u32, branch: u32, height: f32, tint: Vec3, rng: &mut Rng) {
    let lean = rng.in_cube() * Vec3::new(0.02, 0.0, 0.02) * height;
    let path: Vec<Vec3> = (0..=6).map(|i| (Vec3::Y * height + lean) * (i as f32 / 6.0)).collect();
    let base = height * 0.017;
    model.on(bark).tube(&path, |t| base * (1.0 - 0.94 * t) + 0.01, 9);
    let whorls = (height * 1.5) as u32;
    let part = model.on(branch);
    for whorl in 0..whorls {
        let t = 0.16 + 0.83 * whorl as f32 / whorls as f32;
        let reach = height * 0.24 * (1.0 - t).max(0.05) * rng.range(0.8, 1.15) + 0.3;
        let count = 6 + ((1.0 - t) * 4.0) as u32;
        let spin = rng.range(0.0, TAU);
        for i in 0..count {
            let (s, c) = sin_cos(spin + (i as f32 + rng.range(-0.25, 0.25)) / count as f32 * TAU);
            let out = Vec3::new(c, 0.0, s);
            let side = Vec3::new(-s, 0.0, c);
            let foot = path[6] * (t + rng.range(-0.015, 0.015));
            let droop = reach * rng.range(0.25, 0.5) * (1.0 - 0.9 * t);
            let tip = foot + out * reach - Vec3::Y * (droop - 0.1 * reach);
            let middle = foot.lerp(tip, 0.5) + Vec3::Y * (0.16 * reach);
            let half = side * (reach * 0.34);
            let normal = (out + Vec3::Y * 0.8).normalize();
            part.tint(tint * rng.range(0.78, 1.15));
            bent_card(part, [foot, middle, tip], half, normal);
            // A second, upright card gives the branch thickness seen from the side.
            let upright = Vec3::Y * (reach * 0.2);
            bent_card(part, [foot, middle, tip], upright, (normal - side * 0.3).normalize());
        }
    }
}

/// A cut-out branch along three points, `half` to either side, the texture growing from the first.
fn bent_card(part: &mut super::model::Part, spine: [Vec3; 3], half: Vec3, normal: Vec3) {
    part.smooth();
    let rows: Vec<[u32; 2]> = (0..3)
        .map(|i| {
            let v = 1.0 - 0.5 * i as f32;
            [(-1.0, 0.0), (1.0, 1.0)].map(|(s, u)| part.vertex(spine[i] + half * s, normal, Vec2::new(u, v)))
        })
        .collect();
    for pair in rows.windows(2) {
        part.triangle(pair[0][0], pair[0][1], pair[1][1]);
        part.triangle(pair[0][0], pair[1][1], pair[1][0]);
    }
}
