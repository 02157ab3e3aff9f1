//! `random`: triangles of constant total area above a receiver (the random scenes of Aila and Laine 2004).

use lt_math::glam::{Affine3A, Vec3};
use rayon::prelude::*;

use super::{kit::Kit, numbers::srgb, rng::Rng};
use crate::{Material, Mesh, Scene};

/// Sum of all triangles' areas, square metres, whatever their number.
const TOTAL_AREA: f32 = 24.0;
/// The box they float in.
const LOW: Vec3 = Vec3::new(-3.0, 0.5, -3.0);
const HIGH: Vec3 = Vec3::new(3.0, 4.0, 3.0);
/// Triangles per random stream: fixed, so that the number of threads changes nothing.
const CHUNK: usize = 4096;

/// `count` triangles of equal area, uniformly placed and turned.
pub fn grow(count: u32, seed: u64) -> Scene {
    let mut kit = Kit::new("random");
    let paper = Material { is_double_sided: true, ..Material::opaque("paper", srgb(0xd8b184)) };
    let paper = kit.material(paper);
    let floor = kit.plain("floor", srgb(0xa9b2b6));
    let area = TOTAL_AREA / count as f32;
    let mut positions = vec![Vec3::ZERO; 3 * count as usize];
    positions.par_chunks_mut(3 * CHUNK).enumerate().for_each(|(stream, chunk)| {
        let mut rng = Rng::new(seed, 1 + stream as u64);
        for corners in chunk.as_chunks_mut::<3>().0 {
            *corners = triangle(area, &mut rng);
        }
    });
    let indices = (0..3 * count).collect();
    let mesh = Mesh { name: "triangles".to_owned(), positions, indices, material: paper, ..Mesh::default() };
    kit.scene.place(mesh, Affine3A::IDENTITY);
    let half = 14.0;
    let at = |x: f32, z: f32| Vec3::new(x * half, 0.0, z * half);
    let floor = Mesh {
        name: "floor".to_owned(),
        positions: vec![at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0), at(-1.0, -1.0)],
        indices: vec![0, 1, 2, 0, 2, 3],
        material: floor,
        ..Mesh::default()
    };
    kit.scene.place(floor, Affine3A::IDENTITY);
    kit.finish(Vec3::new(0.45, 1.0, 0.25), Vec3::new(0.0, 5.4, 9.0), Vec3::new(-0.1, 1.3, 0.0), 45.0)
}

/// A triangle of exactly this area (to rounding), not too slender, anywhere in the box.
fn triangle(area: f32, rng: &mut Rng) -> [Vec3; 3] {
    let u = rng.direction();
    let w = rng.direction();
    let across = u.cross(w);
    let v = if across.length_squared() > 0.01 { across.normalize() } else { super::numbers::across(u).0 };
    // Base along u, apex over the base's middle third; height is a random share of the base.
    let ratio = rng.range(0.5, 1.4);
    let base = (2.0 * area / ratio).sqrt();
    let apex = u * (base * rng.range(0.2, 0.8)) + v * (base * ratio);
    let middle = (u * base + apex) / 3.0;
    let center = Vec3::new(rng.range(LOW.x, HIGH.x), rng.range(LOW.y, HIGH.y), rng.range(LOW.z, HIGH.z));
    let foot = center - middle;
    [foot, foot + u * base, foot + apex]
}
