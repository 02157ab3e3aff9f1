//! House tops: eaves and gable roofs, stepped gables, dormers and chimneys.

use lt_math::glam::Vec3;

use super::{House, HouseMaterials, Roof, front::Rect};
use crate::builtin::{
    model::{Model, Part},
    numbers::{srgb, standing},
    rng::Rng,
};

impl House {
    pub(super) fn eaves_roof(&self, model: &mut Model, mats: &HouseMaterials, rng: &mut Rng) {
        let (w, d, e, rise) = (self.width, self.depth, self.eaves(), self.roof_rise());
        let slope = rise / (0.5 * d);
        let over = 0.38;
        let ridge = e + rise + 0.1;
        let low = e - over * slope + 0.1;
        let tiles = model.on(mats.tiles);
        tiles.tint(self.roof_color);
        let eave = |x: f32, z: f32| Vec3::new(x, low, z);
        let top = |x: f32| Vec3::new(x, ridge, -0.5 * d);
        slab(tiles, [eave(-0.03, over), eave(w + 0.03, over), top(w + 0.03), top(-0.03)], 0.12);
        slab(tiles, [eave(w + 0.03, -d - over), eave(-0.03, -d - over), top(-0.03), top(w + 0.03)], 0.12);
        tiles.tint(self.roof_color * 0.9).tube(
            &[top(-0.05) + Vec3::Y * 0.02, top(w + 0.05) + Vec3::Y * 0.02],
            |_| 0.11,
            8,
        );
        let gutter = Vec3::new(0.0, low - 0.05, over + 0.05);
        model.on(mats.iron).tube(&[gutter, gutter + Vec3::X * w], |_| 0.065, 8);
        let count = self.bays / 2;
        for i in 0..count {
            if rng.chance(0.8) {
                let x = (i as f32 + 0.5) / count as f32 * w;
                self.dormer(model, mats, x, e + 0.45, slope);
            }
        }
    }

    fn dormer(&self, model: &mut Model, mats: &HouseMaterials, x: f32, y: f32, slope: f32) {
        let front = -(y - self.eaves()) / slope - 0.1;
        let (half, tall) = (0.62, 1.25);
        let back = front - tall / slope - 0.4;
        let cell = Rect::centred(0.0, 2.0 * half, 0.0, tall);
        let hole = Rect::centred(0.0, 0.86, 0.12, tall - 0.1);
        model.within(standing(Vec3::new(x, y, front), 0.0), |m| {
            self.opening(m, mats, cell, hole, 0.10);
            self.glazing(m, mats, hole, -0.10);
            let reach = back - front;
            let wall = m.on(mats.plaster);
            wall.tint(self.wall * 0.95);
            wall.face(&[
                Vec3::new(half, 0.0, 0.0),
                Vec3::new(half, 0.0, reach),
                Vec3::new(half, tall, reach),
                Vec3::new(half, tall, 0.0),
            ]);
            wall.face(&[
                Vec3::new(-half, 0.0, reach),
                Vec3::new(-half, 0.0, 0.0),
                Vec3::new(-half, tall, 0.0),
                Vec3::new(-half, tall, reach),
            ]);
            wall.face(&[
                Vec3::new(-half, tall, 0.0),
                Vec3::new(half, tall, 0.0),
                Vec3::new(0.0, tall + 0.55, 0.0),
            ]);
            let tiles = m.on(mats.tiles);
            tiles.tint(self.roof_color);
            let (eave, over) = (half + 0.14, 0.16);
            let low = tall - 0.1;
            let far = reach - 0.9;
            let ridge = tall + 0.62;
            let [left, right] = [-eave, eave].map(|x| [Vec3::new(x, low, over), Vec3::new(x, low, far)]);
            let top = [Vec3::new(0.0, ridge, over), Vec3::new(0.0, ridge, far)];
            slab(tiles, [right[0], right[1], top[1], top[0]], 0.06);
            slab(tiles, [left[1], left[0], top[0], top[1]], 0.06);
        });
    }

    pub(super) fn gable_roof(&self, model: &mut Model, mats: &HouseMaterials) {
        let (w, d, e, rise) = (self.width, self.depth, self.eaves(), self.roof_rise());
        let wall = model.on(self.wall_material(mats));
        wall.tint(self.wall);
        let apex = |z: f32| Vec3::new(0.5 * w, e + rise, z);
        wall.face(&[Vec3::new(0.0, e, 0.0), Vec3::new(w, e, 0.0), apex(0.0)]);
        wall.face(&[Vec3::new(w, e, -d), Vec3::new(0.0, e, -d), apex(-d)]);
        let front = if self.roof == Roof::Stepped {
            let steps = 6;
            for i in 0..steps {
                let inset = (i as f32 - 0.15) * 0.5 * w / steps as f32;
                let (x0, x1) = (inset.max(0.0), w - inset.max(0.0));
                let y = e + i as f32 * rise / steps as f32;
                let top = y + rise / steps as f32 + 0.32;
                let wall = model.on(mats.brick);
                wall.tint(self.wall);
                wall.block(Vec3::new(x0, y, -0.32), Vec3::new(x1, top, 0.004));
                let stone = model.on(mats.stone);
                stone.tint(self.trim);
                stone.block(Vec3::new(x0 - 0.04, top, -0.36), Vec3::new(x1 + 0.04, top + 0.07, 0.05));
            }
            -0.33
        } else {
            0.3
        };
        let tiles = model.on(mats.tiles);
        tiles.tint(self.roof_color);
        let over = 0.25;
        let drop = over * rise / (0.5 * w) - 0.1;
        let ridge = |z: f32| apex(z) + Vec3::Y * 0.1;
        let eave = |x: f32, z: f32| Vec3::new(x, e - drop, z);
        slab(tiles, [eave(w + over, front), eave(w + over, -d - 0.2), ridge(-d - 0.2), ridge(front)], 0.12);
        slab(tiles, [eave(-over, -d - 0.2), eave(-over, front), ridge(front), ridge(-d - 0.2)], 0.12);
        let cell = Rect::centred(0.5 * w, 0.9, e + 0.5, e + 1.7);
        model.within(standing(Vec3::new(0.0, 0.0, 0.10), 0.0), |m| self.glazing(m, mats, cell, 0.0));
        let stone = model.on(mats.stone);
        stone.tint(self.trim);
        stone.block(Vec3::new(cell.x0 - 0.12, cell.y0 - 0.12, 0.0), Vec3::new(cell.x1 + 0.12, cell.y0, 0.22));
        stone.block(Vec3::new(cell.x0 - 0.12, cell.y1, 0.0), Vec3::new(cell.x1 + 0.12, cell.y1 + 0.14, 0.20));
        for x in [cell.x0 - 0.12, cell.x1] {
            stone.block(Vec3::new(x, cell.y0, 0.0), Vec3::new(x + 0.12, cell.y1, 0.17));
        }
    }

    pub(super) fn chimneys(&self, model: &mut Model, mats: &HouseMaterials, rng: &mut Rng) {
        let top = self.eaves() + self.roof_rise() + rng.range(0.7, 1.3);
        let z = -0.5 * self.depth - rng.range(-1.2, 1.2);
        let x = if rng.chance(0.5) { 0.35 } else { self.width - 1.25 };
        let (x, z) = if self.roof == Roof::Eaves {
            (x, z)
        } else {
            (0.5 * self.width + rng.range(0.4, 0.8), -0.7 * self.depth)
        };
        let brick = model.on(mats.brick);
        brick.tint(Vec3::splat(0.9));
        brick.block(Vec3::new(x, self.eaves(), z - 0.35), Vec3::new(x + 0.9, top, z + 0.35));
        let stone = model.on(mats.stone);
        stone.tint(Vec3::splat(0.7));
        stone.block(Vec3::new(x - 0.07, top, z - 0.42), Vec3::new(x + 0.97, top + 0.12, z + 0.42));
        for i in 0..2 {
            let foot = Vec3::new(x + 0.25 + 0.4 * i as f32, top + 0.12, z);
            let pot = model.on(mats.paint);
            pot.tint(srgb(0xb0613f)).cylinder(foot, foot + Vec3::Y * 0.45, 0.14, 0.11, 10);
        }
    }
}

/// A plate `thickness` thick under the quadrilateral `top`, counter-clockwise.
pub fn slab(part: &mut Part, top: [Vec3; 4], thickness: f32) {
    let normal = (top[1] - top[0]).cross(top[3] - top[0]).normalize_or(Vec3::Y);
    let below = top.map(|p| p - normal * thickness);
    part.face(&top);
    part.face(&[below[3], below[2], below[1], below[0]]);
    for i in 0..4 {
        let j = (i + 1) % 4;
        part.face(&[below[i], below[j], top[j], top[i]]);
    }
}
