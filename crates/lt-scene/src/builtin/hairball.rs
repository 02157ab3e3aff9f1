//! `hairball`: curling strands of 576 triangles each around a core (the hair ball of Aila and Laine 2004), and `strands`:
//! the same of coloured strands, each of whose triangles takes away a tenth of the light.

use lt_math::glam::{Affine3A, Vec3};
use rayon::prelude::*;

use super::{
    kit::Kit,
    model::Model,
    numbers::{TAU, across, sin_cos, srgb},
    rng::Rng,
};
use crate::{Material, Mesh, Scene};

/// Cross-section corners and lengthwise pieces: 3 · 96 · 2 = 576 triangles.
const SIDES: usize = 3;
const PIECES: usize = 96;
const VERTICES: usize = SIDES * (PIECES + 1);
/// Where the ball's centre floats, metres.
const CENTER: Vec3 = Vec3::new(0.0, 1.25, 0.0);

/// Share of the light that a triangle of a coloured strand takes away (Aila and Laine 2004).
const OPACITY: f32 = 0.1;
/// What colour the rest takes, sRGB: strands of all six alternate.
const COLORS: [u32; 6] = [0xe02020, 0xe0a010, 0x60c020, 0x10b0b0, 0x2040e0, 0xb020c0];

/// `hairs` opaque strands, each from its own random stream.
pub fn grow(hairs: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("hairball");
    let hair = kit.plain("hair", srgb(0xb9824f));
    ball(kit, hairs, seed, hair, Vec::new())
}

/// The same strands, coloured and translucent.
pub fn grow_translucent(hairs: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("strands");
    let material = Material { transmission: 1.0, ..Material::opaque("strand", Vec3::ONE) };
    let hair = kit.material(material);
    let color = |strand: usize| {
        let passes = Vec3::splat(1.0 - OPACITY) + srgb(COLORS[strand % COLORS.len()]) * OPACITY;
        let [r, g, b] = (passes * 255.0).round().to_array().map(|c| c as u8);
        [r, g, b, 255]
    };
    let colors = (0..hairs as usize).flat_map(|i| std::iter::repeat_n(color(i), VERTICES)).collect();
    ball(kit, hairs, seed, hair, colors)
}

fn ball(mut kit: Kit, hairs: u32, seed: u64, hair: u32, colors: Vec<[u8; 4]>) -> Scene {
    let core = kit.plain("core", srgb(0x80583a));
    let floor = kit.plain("floor", srgb(0xb8b4ac));
    let count = hairs as usize;
    // Finer the more there are, so that the ball stays a ball of hair at any number.
    let thickness = (0.0042 * (500.0 / hairs as f32).sqrt()).clamp(0.0009, 0.012);
    let mut positions = vec![Vec3::ZERO; count * VERTICES];
    let mut normals = vec![Vec3::Y; count * VERTICES];
    positions.par_chunks_mut(VERTICES).zip(normals.par_chunks_mut(VERTICES)).enumerate().for_each(
        |(i, (positions, normals))| strand(positions, normals, thickness, &mut Rng::new(seed, 1 + i as u64)),
    );
    let indices = (0..hairs).flat_map(|i| strand_indices(i * VERTICES as u32)).collect();
    let name = "hair".to_owned();
    let mesh = Mesh { name, positions, normals, colors, indices, material: hair, ..Mesh::default() };
    kit.scene.place(mesh, Affine3A::IDENTITY);
    let mut model = Model::new();
    model.on(core).ellipsoid(CENTER, Vec3::splat(0.13), 24, 40);
    let at = |x: f32, z: f32| Vec3::new(x * 9.0, 0.0, z * 9.0);
    model.on(floor).face(&[at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0), at(-1.0, -1.0)]);
    kit.add("stand", model);
    kit.finish(Vec3::new(0.55, 1.0, 0.35), Vec3::new(0.2, 2.9, 3.9), Vec3::new(-0.15, 0.95, 0.0), 40.0)
}

/// One strand: a walk outward whose direction curls about a slowly turning axis.
fn strand(positions: &mut [Vec3], normals: &mut [Vec3], thickness: f32, rng: &mut Rng) {
    let root = rng.direction();
    let mut along = root;
    let mut curl = rng.direction();
    let length = rng.range(0.8, 1.3);
    let turn = rng.range(1.6, 4.2) / PIECES as f32;
    let radius = thickness * rng.range(0.8, 1.2);
    let mut at = CENTER + root * 0.12;
    for (piece, (p, n)) in positions.chunks_mut(SIDES).zip(normals.chunks_mut(SIDES)).enumerate() {
        let (u, v) = across(along);
        let taper = radius * (1.0 - 0.8 * piece as f32 / PIECES as f32);
        for side in 0..SIDES {
            let (s, c) = sin_cos(side as f32 / SIDES as f32 * TAU);
            n[side] = u * c + v * s;
            p[side] = at + n[side] * taper;
        }
        curl = (curl + rng.in_cube() * 0.25).normalize_or(Vec3::X);
        let pull = (root - along) * 0.02;
        along = (along + curl.cross(along) * (turn * 1.6) + pull).normalize_or(root);
        at += along * (length / PIECES as f32);
        at.y = at.y.max(0.02);
    }
}

/// The triangles of the strand whose vertices start at `first`.
fn strand_indices(first: u32) -> impl Iterator<Item = u32> {
    let sides = SIDES as u32;
    (0..PIECES as u32).flat_map(move |piece| {
        (0..sides).flat_map(move |side| {
            let next = (side + 1) % sides;
            let [low, high] = [piece, piece + 1].map(|k| first + k * sides);
            [low + side, low + next, high + next, low + side, high + next, high + side]
        })
    })
}
