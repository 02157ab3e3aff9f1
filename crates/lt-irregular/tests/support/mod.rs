//! Triangles and rays made to hurt.

use std::vec::Vec;

use lt_irregular::Bounds;
use lt_math::glam::{Vec3, Vec4};

/// A small generator of numbers (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 16_777_216.0
    }

    /// Less than `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// In [−1, 1)³.
    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}

/// A soup of triangles.
pub struct Soup {
    /// Vertices, three to a triangle.
    pub positions: Vec<Vec3>,
    /// Indices of vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Soup {
    /// Empty.
    pub fn new() -> Self {
        Soup { positions: Vec::new(), triangles: Vec::new() }
    }

    /// One more triangle.
    pub fn push(&mut self, corners: [Vec3; 3]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.triangles.push([first, first + 1, first + 2]);
    }

    /// All kinds of triangles in a cube of half side 1: small, large, slivers, in planes of the axes and of `light`.
    pub fn mixed(random: &mut Random, count: usize, light: Vec3) -> Self {
        let mut soup = Soup::new();
        for i in 0..count {
            let at = random.vector();
            let size = [0.02, 0.1, 0.5, 1.0][random.below(4)];
            let (mut a, mut b) = (random.vector() * size, random.vector() * size);
            match i % 8 {
                // A sliver, sometimes as thin as f32 allows.
                0 => {
                    b = a * random.unit() + random.vector() * size * [1e-2, 1e-4, 1e-6, 1e-8][random.below(4)]
                }
                // In a plane of two axes.
                1 => {
                    let axis = random.below(3);
                    (a[axis], b[axis]) = (0.0, 0.0);
                }
                // Along the light, nearly or fully.
                2 => {
                    b = light.normalize_or_zero() * size
                        + random.vector() * [0.0, 1e-6, 1e-3][random.below(3)]
                }
                // A tiny one.
                3 => (a, b) = (a * 1e-4, b * 1e-4),
                _ => {}
            }
            soup.push([at, at + a, at + b]);
        }
        soup
    }

    /// Scaled, then moved.
    pub fn moved(mut self, scale: f32, offset: Vec3) -> Self {
        self.positions.iter_mut().for_each(|p| *p = *p * scale + offset);
        self
    }

    /// The box of all vertices.
    pub fn bounds(&self) -> Bounds {
        self.positions.iter().fold(Bounds::EMPTY, |all, p| all.with(*p))
    }
}

/// Where rays start: anywhere, exactly on vertices, edges and faces, there and a little towards or off the light, below and above.
pub fn origins(random: &mut Random, soup: &Soup, light: Vec4, count: usize) -> Vec<Vec3> {
    let bounds = soup.bounds();
    let size = bounds.high - bounds.low;
    let mut out = Vec::with_capacity(count);
    for i in 0..count {
        let t = soup.triangles[random.below(soup.triangles.len())].map(|v| soup.positions[v as usize]);
        let to_light = |p: Vec3| light.truncate() - p * light.w;
        let on = match random.below(4) {
            0 => t[0],
            1 => t[0].lerp(t[1], random.unit()),
            2 => {
                let (u, v) = (random.unit(), random.unit());
                t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v * (1.0 - u)
            }
            _ => (t[0] + t[1] + t[2]) / 3.0,
        };
        out.push(match i % 4 {
            0 => bounds.low + size * Vec3::new(random.unit(), random.unit(), random.unit()),
            1 => on,
            // As a receiver's origin is: off its surface by some roundings.
            2 => {
                let normal = (t[1] - t[0]).cross(t[2] - t[0]).normalize_or_zero();
                lt_bvh::offset_origin(
                    on,
                    if normal.dot(to_light(on)) < 0.0 { -normal } else { normal },
                    on.abs().max_element(),
                )
            }
            // Exactly before or behind a vertex or edge, as seen from the light.
            _ => {
                let away = to_light(on).normalize_or_zero() * size.max_element() * (random.unit() - 0.7);
                (on - away).clamp(bounds.low, bounds.high)
            }
        });
    }
    out
}

/// Scales and offsets of scenes, near, far, tiny and huge.
pub const PLACES: [(f32, Vec3); 7] = [
    (1.0, Vec3::ZERO),
    (1e3, Vec3::ZERO),
    (1e-3, Vec3::ZERO),
    (1.0, Vec3::new(500.0, -20.0, 8000.0)),
    (40.0, Vec3::new(1e5, 1e3, -3e5)),
    (1e-12, Vec3::ZERO),
    (1e12, Vec3::ZERO),
];

/// Suns along axes, diagonals and anything; lights within and around.
pub fn lights(random: &mut Random, scale: f32, offset: Vec3) -> Vec<Vec4> {
    let mut lights: Vec<Vec4> =
        [Vec3::Y, Vec3::NEG_X, Vec3::Z, Vec3::ONE, Vec3::new(1.0, -1.0, 1e-8), Vec3::new(0.3, 1e-20, 0.2)]
            .into_iter()
            .map(|d| d.extend(0.0))
            .collect();
    lights.extend((0..6).map(|_| random.vector().extend(0.0)));
    lights.extend((0..6).map(|_| (random.vector() * scale * 1.5 + offset).extend(1.0)));
    lights
}
