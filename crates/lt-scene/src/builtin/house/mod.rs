//! Town houses: what distinguishes one from the next, and their plain walls.
//!
//! Local frame: the façade stands in the plane z = 0 facing +Z, x runs from 0 to the width, y is up from the pavement.

mod front;
mod roof;

use lt_math::glam::Vec3;

use super::{kit::Kit, model::Model, numbers::srgb, rng::Rng, texture};

pub use roof::slab;

/// Materials that houses share.
#[derive(Clone, Copy, Debug)]
pub struct HouseMaterials {
    plaster: u32,
    brick: u32,
    stone: u32,
    paint: u32,
    glass: u32,
    tiles: u32,
    iron: u32,
    cloth: u32,
}

impl HouseMaterials {
    /// Adds them to a scene.
    pub fn new(kit: &mut Kit) -> Self {
        Self {
            plaster: kit.textured("plaster", Vec3::ONE, texture::plaster()),
            brick: kit.textured("brick", Vec3::ONE, texture::brick()),
            stone: kit.textured("stone", srgb(0xf0e6d2), texture::plaster()),
            paint: kit.plain("paint", Vec3::ONE),
            glass: kit.textured("window", Vec3::ONE, texture::window()),
            tiles: kit.textured("tiles", Vec3::ONE, texture::tiles()),
            iron: kit.plain("iron", srgb(0x2e3032)),
            cloth: kit.sheet("awning"),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Roof {
    /// Ridge along the street.
    Eaves,
    /// Ridge across the street behind a triangular gable.
    Gable,
    /// Ridge across the street behind a stepped gable.
    Stepped,
}

/// What distinguishes one house from the next.
#[derive(Clone, Debug)]
pub struct House {
    width: f32,
    depth: f32,
    storeys: u32,
    bays: u32,
    is_brick: bool,
    wall: Vec3,
    trim: Vec3,
    roof: Roof,
    roof_color: Vec3,
    shutters: Option<Vec3>,
    has_balcony: bool,
    is_shop: bool,
    accent: Vec3,
}

const GROUND_STOREY: f32 = 3.5;
const UPPER_STOREY: f32 = 2.95;

const WALLS: [u32; 9] =
    [0xf0e2c4, 0xe9c99a, 0xdba67c, 0xd9b8a6, 0xcfd3c0, 0xb9c8cf, 0xf3ead9, 0xc98d6b, 0xe6d38f];
const ROOFS: [u32; 5] = [0xb0654c, 0xa05a46, 0xb87656, 0x747174, 0x905848];
const ACCENTS: [u32; 7] = [0x2f5d50, 0x7a2f2b, 0x2c4a6e, 0x54683a, 0x8a5a2b, 0x5b3a55, 0x1f4f5a];

impl House {
    /// A house of this façade width, everything else drawn from `rng`.
    pub fn random(width: f32, rng: &mut Rng) -> Self {
        let is_brick = rng.chance(0.25);
        let wall = srgb(rng.pick(&WALLS));
        let is_gabled = width < 9.0 && rng.chance(0.45);
        let roof = match (is_gabled, is_brick) {
            (false, _) => Roof::Eaves,
            (true, true) => Roof::Stepped,
            (true, false) => Roof::Gable,
        };
        Self {
            width,
            depth: rng.range(9.0, 11.0),
            storeys: 2 + rng.below(3),
            bays: ((width / 2.1) as u32).clamp(2, 6),
            is_brick,
            wall: if is_brick { Vec3::splat(rng.range(0.85, 1.0)) } else { wall },
            trim: srgb(rng.pick(&[0xfaf6ec, 0xf4ecdc, 0xe8e2d4])),
            roof,
            roof_color: srgb(rng.pick(&ROOFS)),
            shutters: (!is_brick && rng.chance(0.45)).then(|| srgb(rng.pick(&ACCENTS))),
            has_balcony: rng.chance(0.45),
            is_shop: rng.chance(0.45),
            accent: srgb(rng.pick(&ACCENTS)),
        }
    }

    /// Height of the eaves above the pavement, metres.
    pub fn eaves(&self) -> f32 {
        GROUND_STOREY + (self.storeys - 1) as f32 * UPPER_STOREY + 0.35
    }

    /// Draws the house at the model's frame.
    pub fn draw(&self, model: &mut Model, mats: &HouseMaterials, rng: &mut Rng) {
        self.storeys_front(model, mats, rng);
        self.shell(model, mats);
        self.bands(model, mats);
        match self.roof {
            Roof::Eaves => self.eaves_roof(model, mats, rng),
            Roof::Gable | Roof::Stepped => self.gable_roof(model, mats),
        }
        self.chimneys(model, mats, rng);
    }

    fn wall_material(&self, mats: &HouseMaterials) -> u32 {
        if self.is_brick { mats.brick } else { mats.plaster }
    }

    /// Side and back walls.
    fn shell(&self, model: &mut Model, mats: &HouseMaterials) {
        let (w, d, e) = (self.width, self.depth, self.eaves());
        let wall = model.on(self.wall_material(mats));
        wall.tint(self.wall * 0.92);
        wall.face(&[
            Vec3::new(w, 0.0, -d),
            Vec3::new(0.0, 0.0, -d),
            Vec3::new(0.0, e, -d),
            Vec3::new(w, e, -d),
        ]);
        for (x, z0, z1) in [(0.0, -d, 0.0), (w, 0.0, -d)] {
            let mut side = vec![Vec3::new(x, 0.0, z0), Vec3::new(x, 0.0, z1), Vec3::new(x, e, z1)];
            if self.roof == Roof::Eaves {
                side.push(Vec3::new(x, e + self.roof_rise(), -0.5 * d));
            }
            side.push(Vec3::new(x, e, z0));
            wall.face(&side);
        }
    }

    /// Plinth, string courses, cornice and a downpipe.
    fn bands(&self, model: &mut Model, mats: &HouseMaterials) {
        let stone = model.on(mats.stone);
        stone.tint(self.trim);
        let mut band = |y0: f32, y1: f32, reach: f32| {
            stone.block(Vec3::new(0.0, y0, 0.0), Vec3::new(self.width, y1, reach));
        };
        band(GROUND_STOREY - 0.14, GROUND_STOREY, 0.10);
        for storey in 2..self.storeys {
            let y = GROUND_STOREY + (storey - 1) as f32 * UPPER_STOREY;
            band(y - 0.08, y, 0.06);
        }
        let e = self.eaves();
        band(e - 0.26, e - 0.13, 0.12);
        band(e - 0.13, e, 0.24);
        let x = self.width - 0.09;
        model.on(mats.iron).tube(&[Vec3::new(x, 0.15, 0.13), Vec3::new(x, e - 0.05, 0.13)], |_| 0.045, 7);
    }

    fn roof_rise(&self) -> f32 {
        match self.roof {
            Roof::Eaves => 0.36 * self.depth,
            Roof::Gable | Roof::Stepped => 0.55 * self.width,
        }
    }
}
