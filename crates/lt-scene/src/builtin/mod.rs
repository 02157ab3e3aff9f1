//! Procedural places: nine small worlds grown from a name, a size and a seed.
//!
//! All are in metres with the ground near y = 0, carry one sun (`lights[0]`) and a view (`cameras[0]`), and depend on
//! nothing but size, seed and, for what moves, time. Trigonometry and random numbers are our own (`numbers`, `rng`),
//! so that no platform's mathematics library decides where a vertex lies.

mod cornell;
mod fence;
mod forest;
mod furniture;
mod hairball;
mod house;
mod kit;
mod model;
mod numbers;
mod random;
mod rng;
mod square;
mod street;
mod terrain;
mod texture;
mod town;
mod tree;

use std::ops::RangeInclusive;

use crate::{Camera, CameraPath, Scene, SceneError};

/// What `lt scenes` tells about one procedural place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// What to type.
    pub name: &'static str,
    /// What it shows, one line.
    pub summary: &'static str,
    /// What the number after the colon counts.
    pub size_meaning: &'static str,
    /// The number taken when none is given.
    pub default_size: u32,
    /// The numbers accepted.
    pub sizes: RangeInclusive<u32>,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Street,
    Square,
    Forest,
    Town,
    Fence,
    Cornell,
    Random,
    Hairball,
    Strands,
}

static PLACES: [Place; 9] = [
    Place {
        name: "street",
        summary: "old-town street: façades in grazing sun, balconies, thin overhead wires, bunting, cars, trees",
        size_meaning: "houses",
        default_size: 24,
        sizes: 2..=400,
        kind: Kind::Street,
    },
    Place {
        name: "square",
        summary: "park square: lawns, paths, benches and alpha-masked trees between rows of houses",
        size_meaning: "trees",
        default_size: 72,
        sizes: 1..=2000,
        kind: Kind::Square,
    },
    Place {
        name: "forest",
        summary: "clearing in a wood: alpha-masked firs, beeches and grass, a creature-like knot gliding through",
        size_meaning: "trees",
        default_size: 260,
        sizes: 1..=10_000,
        kind: Kind::Forest,
    },
    Place {
        name: "town",
        summary: "medieval town on rolling ground seen from above, low-poly houses around a church",
        size_meaning: "houses",
        default_size: 1200,
        sizes: 10..=20_000,
        kind: Kind::Town,
    },
    Place {
        name: "fence",
        summary: "picket fence and wire mesh before a brick wall: bars far thinner than a shadow-map texel",
        size_meaning: "pickets",
        default_size: 28,
        sizes: 1..=5000,
        kind: Kind::Fence,
    },
    Place {
        name: "cornell",
        summary: "Cornell box with a skylight, two blocks and a lumpy pebble",
        size_meaning: "rings on the pebble",
        default_size: 48,
        sizes: 3..=1000,
        kind: Kind::Cornell,
    },
    Place {
        name: "random",
        summary: "random triangles of constant total area floating above a floor",
        size_meaning: "triangles",
        default_size: 100_000,
        sizes: 1..=5_000_000,
        kind: Kind::Random,
    },
    Place {
        name: "hairball",
        summary: "ball of curling hairs, 576 triangles each",
        size_meaning: "hairs",
        default_size: 500,
        sizes: 1..=10_000,
        kind: Kind::Hairball,
    },
    Place {
        name: "strands",
        summary: "hair ball of coloured strands that let 90 % of the light through (with --translucent)",
        size_meaning: "hairs",
        default_size: 500,
        sizes: 1..=10_000,
        kind: Kind::Strands,
    },
];

/// A procedural place with its size and seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Builtin {
    place: &'static Place,
    size: u32,
    seed: u64,
}

impl Builtin {
    /// Every place there is, in the order in which to present them.
    pub fn catalogue() -> &'static [Place] {
        &PLACES
    }

    /// Parses `name` or `name:size`; the seed is 1.
    ///
    /// # Errors
    /// An unknown name (the error lists the known ones) or a size that is no number in the place's range.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let (name, size) = match text.split_once(':') {
            Some((name, size)) => (name, Some(size)),
            None => (text, None),
        };
        let Some(place) = PLACES.iter().find(|p| p.name == name) else {
            let known: Vec<&str> = PLACES.iter().map(|p| p.name).collect();
            return Err(SceneError::UnknownScene(format!(
                "{text:?} is neither a .gltf or .glb file nor a built-in scene; the built-in scenes are {}",
                known.join(", ")
            )));
        };
        let size = match size {
            None => place.default_size,
            Some(digits) => digits
                .parse()
                .ok()
                .filter(|n| place.sizes.contains(n))
                .ok_or_else(|| place.bad_size(digits))?,
        };
        Ok(Self { place, size, seed: 1 })
    }

    /// The same place grown from another seed.
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The place at `time_s` seconds; only `forest` moves. Times that are not finite count as 0.
    pub fn pose(&self, time_s: f32) -> Scene {
        let (size, seed) = (self.size, self.seed);
        match self.place.kind {
            Kind::Street => street::grow(size, seed),
            Kind::Square => square::grow(size, seed),
            Kind::Forest => forest::grow(size, seed, if time_s.is_finite() { time_s } else { 0.0 }),
            Kind::Town => town::grow(size, seed),
            Kind::Fence => fence::grow(size, seed),
            Kind::Cornell => cornell::grow(size, seed),
            Kind::Random => random::grow(size, seed),
            Kind::Hairball => hairball::grow(size, seed),
            Kind::Strands => hairball::grow_translucent(size, seed),
        }
    }

    /// The way a camera takes through the place from `start`, which may be any view of it.
    pub fn camera_path(&self, start: Camera) -> CameraPath {
        let still =
            CameraPath { start, dolly: 0.0, truck: 0.0, rise: 0.0, orbit_rad: 0.0, pan_rad: 0.0, sway: 0.0 };
        match self.place.kind {
            // Walking: down the street, across the square, into the clearing.
            Kind::Street => CameraPath { dolly: 0.25, pan_rad: 0.12, sway: 0.01, ..still },
            Kind::Square => CameraPath { dolly: 0.2, truck: 0.1, pan_rad: -0.15, sway: 0.01, ..still },
            Kind::Forest => CameraPath { dolly: 0.15, truck: -0.1, pan_rad: 0.15, sway: 0.02, ..still },
            // Flying over the roofs.
            Kind::Town => CameraPath { dolly: 0.3, rise: 0.05, orbit_rad: 0.2, ..still },
            // Walking along.
            Kind::Fence => CameraPath { truck: 0.5, sway: 0.02, ..still },
            // Around what floats or stands in the middle.
            Kind::Cornell => CameraPath { orbit_rad: 0.3, rise: 0.05, ..still },
            Kind::Random | Kind::Hairball | Kind::Strands => {
                CameraPath { orbit_rad: 0.6, dolly: 0.1, ..still }
            }
        }
    }
}

impl Place {
    fn bad_size(&self, digits: &str) -> SceneError {
        SceneError::UnknownScene(format!(
            "{}:{digits}: the number of {} must be a whole number from {} to {}",
            self.name,
            self.size_meaning,
            self.sizes.start(),
            self.sizes.end()
        ))
    }
}
