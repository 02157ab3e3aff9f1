//! House fronts: recessed windows, doors, shopfronts, awnings, balconies, shutters and flower boxes.

use lt_math::glam::{Vec2, Vec3};

use super::{GROUND_STOREY, House, HouseMaterials, UPPER_STOREY};
use crate::builtin::{
    model::{Model, Part},
    numbers::{sin_cos, srgb, standing},
    rng::Rng,
};

/// How deep panes lie behind the wall, metres.
const REVEAL: f32 = 0.17;

impl House {
    pub(super) fn storeys_front(&self, model: &mut Model, mats: &HouseMaterials, rng: &mut Rng) {
        let bay = self.width / self.bays as f32;
        let door_bay = rng.below(self.bays);
        for storey in 0..self.storeys {
            let y0 = if storey == 0 { 0.0 } else { GROUND_STOREY + (storey - 1) as f32 * UPPER_STOREY };
            let y1 = if storey == 0 { GROUND_STOREY } else { y0 + UPPER_STOREY };
            let y1 = if storey + 1 == self.storeys { self.eaves() } else { y1 };
            for i in 0..self.bays {
                let cell = Rect::new(i as f32 * bay, (i + 1) as f32 * bay, y0, y1);
                match (storey, i == door_bay, self.is_shop) {
                    (0, true, _) => self.door(model, mats, cell),
                    (0, false, true) => self.shop_window(model, mats, cell),
                    _ => self.window(model, mats, cell, storey, rng),
                }
            }
        }
        if self.is_shop {
            self.awning(model, mats, rng);
        }
        if self.has_balcony && self.storeys > 2 {
            let width = (bay * 2.0).min(self.width - 0.8);
            let left = (0.5 * (self.width - width)).max(0.3);
            self.balcony(model, mats, left, left + width, GROUND_STOREY + UPPER_STOREY * rng.below(2) as f32);
        }
    }

    fn window(&self, model: &mut Model, mats: &HouseMaterials, cell: Rect, storey: u32, rng: &mut Rng) {
        let width = (cell.width() * 0.52).min(1.15);
        let sill = cell.y0 + if storey == 0 { 1.0 } else { 0.75 };
        let hole = Rect::centred(cell.center_x(), width, sill, (sill + 1.65).min(cell.y1 - 0.35));
        self.opening(model, mats, cell, hole, REVEAL);
        self.glazing(model, mats, hole, -REVEAL);
        let (l, r) = (hole.x0, hole.x1);
        let stone = model.on(mats.stone);
        stone.tint(self.trim);
        stone.block(Vec3::new(l - 0.14, hole.y0 - 0.10, -0.10), Vec3::new(r + 0.14, hole.y0, 0.14));
        stone.block(Vec3::new(l - 0.13, hole.y0, 0.0), Vec3::new(l, hole.y1, 0.045));
        stone.block(Vec3::new(r, hole.y0, 0.0), Vec3::new(r + 0.13, hole.y1, 0.045));
        stone.block(Vec3::new(l - 0.13, hole.y1, 0.0), Vec3::new(r + 0.13, hole.y1 + 0.16, 0.06));
        stone.block(Vec3::new(l - 0.17, hole.y1 + 0.16, 0.0), Vec3::new(r + 0.17, hole.y1 + 0.22, 0.13));
        if let (Some(color), true) = (self.shutters, storey > 0) {
            let leaf = (0.5 * width).min(0.5 * (cell.width() - width) - 0.15);
            for side in [l - 0.14 - leaf, r + 0.14] {
                shutter(model, mats, Rect::new(side, side + leaf, hole.y0, hole.y1), color);
            }
        } else if storey > 0 && rng.chance(0.35) {
            flower_box(model, mats, hole, rng);
        }
    }

    /// The wall of `cell` around `hole`, and the four reveals.
    pub(super) fn opening(
        &self,
        model: &mut Model,
        mats: &HouseMaterials,
        cell: Rect,
        hole: Rect,
        depth: f32,
    ) {
        let wall = model.on(self.wall_material(mats));
        wall.tint(self.wall);
        let mut panel = |r: Rect| wall.face(&r.corners(0.0));
        panel(Rect::new(cell.x0, hole.x0, cell.y0, cell.y1));
        panel(Rect::new(hole.x1, cell.x1, cell.y0, cell.y1));
        panel(Rect::new(hole.x0, hole.x1, cell.y0, hole.y0));
        panel(Rect::new(hole.x0, hole.x1, hole.y1, cell.y1));
        let reveal = model.on(mats.plaster);
        reveal.tint(self.wall * 0.95);
        let front = hole.corners(0.0);
        let back = hole.corners(-depth);
        for i in 0..4 {
            let j = (i + 1) % 4;
            reveal.face(&[front[i], front[j], back[j], back[i]]);
        }
    }

    /// Frame, mullion, transom and pane at depth `z`.
    pub(super) fn glazing(&self, model: &mut Model, mats: &HouseMaterials, hole: Rect, z: f32) {
        model.on(mats.glass).picture(hole.corners(z));
        let paint = model.on(mats.paint);
        paint.tint(self.trim);
        let (near, bar) = (z + 0.06, 0.06);
        let mut block = |x0: f32, x1: f32, y0: f32, y1: f32, front: f32| {
            paint.block(Vec3::new(x0, y0, z), Vec3::new(x1, y1, front));
        };
        block(hole.x0, hole.x0 + bar, hole.y0, hole.y1, near);
        block(hole.x1 - bar, hole.x1, hole.y0, hole.y1, near);
        block(hole.x0 + bar, hole.x1 - bar, hole.y0, hole.y0 + bar, near);
        block(hole.x0 + bar, hole.x1 - bar, hole.y1 - bar, hole.y1, near);
        let cx = hole.center_x();
        block(cx - 0.035, cx + 0.035, hole.y0 + bar, hole.y1 - bar, near);
        let transom = hole.y0 + 0.68 * (hole.y1 - hole.y0);
        block(hole.x0 + bar, hole.x1 - bar, transom - 0.025, transom + 0.025, near - 0.01);
    }

    fn door(&self, model: &mut Model, mats: &HouseMaterials, cell: Rect) {
        let hole = Rect::centred(cell.center_x(), 1.12, 0.30, 2.95);
        self.opening(model, mats, cell, hole, 0.28);
        let top = 2.42;
        model.on(mats.glass).picture(Rect::new(hole.x0, hole.x1, top, hole.y1).corners(-0.24));
        let paint = model.on(mats.paint);
        paint.tint(self.accent);
        paint.block(Vec3::new(hole.x0, hole.y0, -0.28), Vec3::new(hole.x1, top, -0.20));
        for row in 0..3 {
            for column in 0..2 {
                let x = hole.x0 + 0.12 + column as f32 * 0.47;
                let y = hole.y0 + 0.16 + row as f32 * 0.66;
                paint.tint(self.accent * 1.25);
                paint.block(Vec3::new(x, y, -0.20), Vec3::new(x + 0.40, y + 0.52, -0.175));
            }
        }
        let stone = model.on(mats.stone);
        stone.tint(self.trim);
        stone.block(Vec3::new(hole.x0 - 0.06, top, -0.28), Vec3::new(hole.x1 + 0.06, top + 0.08, -0.12));
        for x in [hole.x0 - 0.24, hole.x1] {
            stone.block(Vec3::new(x, 0.0, 0.0), Vec3::new(x + 0.24, 3.0, 0.09));
        }
        stone.block(Vec3::new(hole.x0 - 0.3, 3.0, 0.0), Vec3::new(hole.x1 + 0.3, 3.15, 0.22));
        stone.tint(Vec3::splat(0.8));
        stone.block(Vec3::new(hole.x0 - 0.1, 0.0, -0.28), Vec3::new(hole.x1 + 0.1, 0.30, 0.02));
        stone.block(Vec3::new(hole.x0 - 0.1, 0.0, 0.02), Vec3::new(hole.x1 + 0.1, 0.15, 0.34));
        let handle = Vec3::new(hole.x1 - 0.1, 1.3, -0.2);
        model.on(mats.iron).cylinder(handle, handle + Vec3::Z * 0.06, 0.022, 0.03, 8);
    }

    fn shop_window(&self, model: &mut Model, mats: &HouseMaterials, cell: Rect) {
        let hole = Rect::new(cell.x0 + 0.16, cell.x1 - 0.16, 0.62, 2.75);
        self.opening(model, mats, cell, hole, 0.12);
        self.glazing(model, mats, hole, -0.12);
        let paint = model.on(mats.paint);
        paint.tint(self.accent);
        paint.block(Vec3::new(cell.x0 + 0.04, 0.0, 0.0), Vec3::new(cell.x0 + 0.16, 2.85, 0.07));
        paint.block(Vec3::new(cell.x1 - 0.16, 0.0, 0.0), Vec3::new(cell.x1 - 0.04, 2.85, 0.07));
        paint.block(Vec3::new(cell.x0 + 0.16, 0.08, 0.0), Vec3::new(cell.x1 - 0.16, 0.54, 0.05));
    }

    /// The signboard and a striped, scalloped awning.
    fn awning(&self, model: &mut Model, mats: &HouseMaterials, rng: &mut Rng) {
        let paint = model.on(mats.paint);
        paint.tint(self.accent * 0.8);
        paint.block(Vec3::new(0.1, 2.86, 0.0), Vec3::new(self.width - 0.1, 3.30, 0.09));
        let stripes = ((self.width - 0.6) / 0.32) as u32;
        let step = (self.width - 0.6) / stripes as f32;
        let (reach, top, bottom) = (rng.range(1.0, 1.35), 2.98, 2.45);
        let cloth = model.on(mats.cloth);
        for i in 0..stripes {
            let (x0, x1) = (0.3 + i as f32 * step, 0.3 + (i + 1) as f32 * step);
            cloth.tint(if i % 2 == 0 { self.accent * 1.5 } else { srgb(0xf6efe0) });
            let sheet = [
                Vec3::new(x0, bottom, reach),
                Vec3::new(x1, bottom, reach),
                Vec3::new(x1, top, 0.1),
                Vec3::new(x0, top, 0.1),
            ];
            cloth.face(&sheet);
            let middle = 0.5 * (x0 + x1);
            let hem = [
                Vec3::new(x0, bottom, reach),
                Vec3::new(x0 + 0.04, bottom - 0.17, reach),
                Vec3::new(middle, bottom - 0.22, reach),
                Vec3::new(x1 - 0.04, bottom - 0.17, reach),
                Vec3::new(x1, bottom, reach),
            ];
            cloth.face(&hem);
        }
        let iron = model.on(mats.iron);
        for x in [0.32, self.width - 0.32] {
            iron.bar(Vec3::new(x, 2.2, 0.0), Vec3::new(x, bottom, reach), 0.025, 0.025);
        }
    }

    fn balcony(&self, model: &mut Model, mats: &HouseMaterials, x0: f32, x1: f32, floor: f32) {
        let reach = 0.95;
        let stone = model.on(mats.stone);
        stone.tint(self.trim);
        stone.block(Vec3::new(x0, floor - 0.14, 0.0), Vec3::new(x1, floor, reach));
        for x in [x0 + 0.15, x1 - 0.33] {
            let profile =
                [Vec2::new(0.0, -0.55), Vec2::new(0.16, -0.5), Vec2::new(0.75, -0.14), Vec2::new(0.0, -0.14)];
            // The bracket's profile lies in the zy plane.
            model.within(standing(Vec3::new(x, floor, 0.0), -core::f32::consts::FRAC_PI_2), |m| {
                let stone = m.on(mats.stone);
                stone.tint(self.trim);
                stone.extrusion(&profile, -0.18, 0.0);
            });
        }
        let iron = model.on(mats.iron);
        let rail = |iron: &mut Part, a: Vec3, b: Vec3| {
            let top = Vec3::Y * 1.0;
            iron.bar(a + top, b + top, 0.05, 0.035);
            iron.bar(a + Vec3::Y * 0.08, b + Vec3::Y * 0.08, 0.02, 0.03);
            let count = (a.distance(b) / 0.13) as u32;
            for i in 0..=count {
                let foot = a.lerp(b, i as f32 / count as f32);
                let post = if i == 0 || i == count { 0.035 } else { 0.014 };
                iron.bar(foot, foot + top, post, post);
            }
        };
        let front = reach - 0.05;
        rail(iron, Vec3::new(x0 + 0.04, floor, front), Vec3::new(x1 - 0.04, floor, front));
        rail(iron, Vec3::new(x0 + 0.04, floor, 0.0), Vec3::new(x0 + 0.04, floor, front));
        rail(iron, Vec3::new(x1 - 0.04, floor, 0.0), Vec3::new(x1 - 0.04, floor, front));
    }
}

/// A louvred shutter leaf lying against the wall.
fn shutter(model: &mut Model, mats: &HouseMaterials, leaf: Rect, color: Vec3) {
    let paint = model.on(mats.paint);
    paint.tint(color);
    let (near, bar) = (0.085, 0.055);
    let mut block = |x0: f32, x1: f32, y0: f32, y1: f32| {
        paint.block(Vec3::new(x0, y0, 0.03), Vec3::new(x1, y1, near));
    };
    block(leaf.x0, leaf.x0 + bar, leaf.y0, leaf.y1);
    block(leaf.x1 - bar, leaf.x1, leaf.y0, leaf.y1);
    block(leaf.x0 + bar, leaf.x1 - bar, leaf.y0, leaf.y0 + bar);
    block(leaf.x0 + bar, leaf.x1 - bar, leaf.y1 - bar, leaf.y1);
    paint.tint(color * 0.75);
    let slats = 11;
    for i in 0..slats {
        let y = leaf.y0 + bar + (leaf.height() - 2.0 * bar) * (i as f32 + 0.5) / slats as f32;
        let (s, c) = sin_cos(0.7);
        let half = Vec3::new(0.0, c, -s) * 0.055;
        let [a, b] = [leaf.x0 + bar, leaf.x1 - bar].map(|x| Vec3::new(x, y, 0.055));
        paint.face(&[a - half, b - half, b + half, a + half]);
    }
}

/// A box of geraniums on the sill.
fn flower_box(model: &mut Model, mats: &HouseMaterials, hole: Rect, rng: &mut Rng) {
    let paint = model.on(mats.paint);
    let (y, z) = (hole.y0 + 0.02, 0.16);
    paint.tint(srgb(0x7a4a2e));
    paint.block(Vec3::new(hole.x0 + 0.05, y, z - 0.09), Vec3::new(hole.x1 - 0.05, y + 0.17, z + 0.09));
    let leaves = model.on(mats.cloth);
    for _ in 0..36 {
        let center = Vec3::new(
            rng.range(hole.x0 + 0.05, hole.x1 - 0.05),
            y + rng.range(0.10, 0.36),
            z + rng.range(-0.06, 0.14),
        );
        let petal = rng.chance(0.35);
        leaves.tint(srgb(if petal {
            rng.pick(&[0xc62b3a, 0xd8506a, 0xf0e8e0])
        } else {
            rng.pick(&[0x4d7a34, 0x6b8f3e])
        }));
        let size = if petal { 0.045 } else { 0.065 };
        let u = rng.direction();
        let v = u.cross(rng.direction()).normalize_or(Vec3::Y);
        leaves.face(&[
            center - u * size,
            center - v * size * 0.7,
            center + u * size,
            center + v * size * 0.7,
        ]);
    }
}

/// A rectangle in the façade plane, metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub(super) x0: f32,
    pub(super) x1: f32,
    pub(super) y0: f32,
    pub(super) y1: f32,
}

impl Rect {
    pub(super) fn new(x0: f32, x1: f32, y0: f32, y1: f32) -> Self {
        Self { x0, x1, y0, y1 }
    }

    pub(super) fn centred(x: f32, width: f32, y0: f32, y1: f32) -> Self {
        Self::new(x - 0.5 * width, x + 0.5 * width, y0, y1)
    }

    fn width(self) -> f32 {
        self.x1 - self.x0
    }

    fn height(self) -> f32 {
        self.y1 - self.y0
    }

    fn center_x(self) -> f32 {
        0.5 * (self.x0 + self.x1)
    }

    /// Counter-clockwise seen from +Z, from the bottom left.
    pub(super) fn corners(self, z: f32) -> [Vec3; 4] {
        [
            Vec3::new(self.x0, self.y0, z),
            Vec3::new(self.x1, self.y0, z),
            Vec3::new(self.x1, self.y1, z),
            Vec3::new(self.x0, self.y1, z),
        ]
    }
}
