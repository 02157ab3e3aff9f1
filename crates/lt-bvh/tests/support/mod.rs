//! Seeded scenes and rays, shared by tests and benches.
#![allow(dead_code, reason = "each test binary and bench uses a part")]

use lt_bvh::{AnyHit, Bvh, Hit, Opaque, Ray, Scalar, Tracer, Triangle, offset_origin};
use lt_math::glam::{Vec2, Vec3};

/// PCG-XSH-RR (O'Neill 2014).
pub struct Rng(u64);

impl Rng {
    pub fn new(seed: u64) -> Self {
        let mut rng = Rng(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0xda3e_39cb_94b9_5bdb);
        rng.bits();
        rng
    }

    pub fn bits(&mut self) -> u32 {
        let state = self.0;
        self.0 = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((((state >> 18) ^ state) >> 27) as u32).rotate_right((state >> 59) as u32)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16_777_216.0
    }

    pub fn range(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// Uniform in the cube [−1, 1)³.
    pub fn cube(&mut self) -> Vec3 {
        Vec3::new(self.range(-1.0, 1.0), self.range(-1.0, 1.0), self.range(-1.0, 1.0))
    }

    /// Uniform on the unit sphere.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.cube();
            let l = v.length_squared();
            if l > 1e-4 && l < 1.0 {
                return v / l.sqrt();
            }
        }
    }
}

/// Triangles with an optional alpha test.
#[derive(Default)]
pub struct Mesh {
    pub positions: Vec<Vec3>,
    pub indices: Vec<[u32; 3]>,
    /// Per vertex, in the leaf texture.
    pub uvs: Vec<Vec2>,
    /// Per triangle.
    pub is_opaque: Vec<bool>,
}

impl Mesh {
    pub fn triangle(&mut self, corners: [Vec3; 3], is_opaque: bool) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.uvs.extend([Vec2::ZERO, Vec2::X, Vec2::Y]);
        self.indices.push([first, first + 1, first + 2]);
        self.is_opaque.push(is_opaque);
    }

    pub fn quad(&mut self, corner: Vec3, a: Vec3, b: Vec3, is_opaque: bool) {
        let first = self.positions.len() as u32;
        self.positions.extend([corner, corner + a, corner + a + b, corner + b]);
        self.uvs.extend([Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y]);
        self.indices.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        self.is_opaque.extend([is_opaque; 2]);
    }

    pub fn block(&mut self, low: Vec3, high: Vec3) {
        let (x, y, z) = (Vec3::X * (high.x - low.x), Vec3::Y * (high.y - low.y), Vec3::Z * (high.z - low.z));
        for (corner, a, b) in
            [(low, z, y), (low, x, z), (low, y, x), (high, -y, -z), (high, -z, -x), (high, -x, -y)]
        {
            self.quad(corner, a, b, true);
        }
    }

    pub fn build(&self, quality: lt_bvh::BuildQuality) -> Bvh {
        Bvh::build(&self.positions, &self.indices, |i| self.is_opaque[i], quality).expect("indices in range")
    }
}

/// Small triangles at random in the unit cube.
pub fn soup(count: usize, seed: u64) -> Mesh {
    let mut rng = Rng::new(seed);
    let mut mesh = Mesh::default();
    let size = 1.6 / (count as f32).cbrt();
    for _ in 0..count {
        let at = rng.cube();
        mesh.triangle([at, at + rng.cube() * size, at + rng.cube() * size], true);
    }
    mesh
}

/// A ground, towers, and clutter of small boxes between them: triangles big and small.
pub fn city(blocks: usize, seed: u64) -> Mesh {
    let mut rng = Rng::new(seed);
    let mut mesh = Mesh::default();
    mesh.quad(Vec3::new(-1.5, -0.5, -1.5), Vec3::Z * 3.0, Vec3::X * 3.0, true);
    for i in 0..blocks {
        let at = Vec3::new(rng.range(-1.0, 1.0), -0.5, rng.range(-1.0, 1.0));
        let is_tower = i % 16 == 0;
        let half = if is_tower { rng.range(0.01, 0.04) } else { rng.range(0.001, 0.006) };
        let height = if is_tower { rng.range(0.1, 0.7) } else { rng.range(0.002, 0.02) };
        mesh.block(at - Vec3::new(half, 0.0, half), at + Vec3::new(half, height, half));
    }
    mesh
}

/// A ground, and crowns of small alpha-tested leaves.
pub fn foliage(leaves: usize, seed: u64) -> Mesh {
    let mut rng = Rng::new(seed);
    let mut mesh = Mesh::default();
    mesh.quad(Vec3::new(-1.5, -0.5, -1.5), Vec3::Z * 3.0, Vec3::X * 3.0, true);
    let crowns: Vec<(Vec3, f32)> = (0..24)
        .map(|_| {
            (
                Vec3::new(rng.range(-0.9, 0.9), rng.range(-0.2, 0.1), rng.range(-0.9, 0.9)),
                rng.range(0.1, 0.25),
            )
        })
        .collect();
    for i in 0..leaves {
        let (centre, radius) = crowns[i % crowns.len()];
        let at = centre + rng.direction() * radius * rng.unit().cbrt();
        let a = rng.direction() * 0.012;
        let b = a.cross(rng.direction()).normalize_or(Vec3::X) * 0.012;
        mesh.quad(at, a, b, false);
    }
    mesh
}

/// A leaf with holes, as an any-hit callback over slices.
#[derive(Clone, Copy)]
pub struct Leaf<'a> {
    pub triangles: &'a [Triangle],
    pub uvs: &'a [Vec2],
    pub texels: &'a [u8],
}

/// 64×64 alpha: a disc with veins cut out.
pub fn leaf_texels() -> Vec<u8> {
    let texel = |i: usize| {
        let (x, y) = ((i % 64) as f32 / 31.5 - 1.0, (i / 64) as f32 / 31.5 - 1.0);
        let is_in = x * x + y * y < 0.9 && (x * 9.0).sin() * (y * 9.0).sin() < 0.6;
        if is_in { 255 } else { 0 }
    };
    (0..64 * 64).map(texel).collect()
}

impl AnyHit for Leaf<'_> {
    #[inline(always)]
    fn accepts(&self, triangle: u32, u: f32, v: f32) -> bool {
        let [a, b, c] = self.triangles[triangle as usize].indices().map(|i| self.uvs[i as usize]);
        let uv = a * (1.0 - u - v) + b * u + c * v;
        let cell = |x: f32| ((x * 64.0) as usize).min(63);
        self.texels[cell(uv.y) * 64 + cell(uv.x)] >= 128
    }
}

/// Toward the sun.
pub const SUN: Vec3 = Vec3::new(0.45, 0.8, 0.3);

fn bit(i: u32, at: u32) -> u32 {
    i >> at & 1
}

/// Shadow rays of the pixels of a `side`² picture that show a surface facing the sun, in 8×8 tiles in Morton order.
pub fn sun_rays(bvh: &Bvh, side: u32) -> Vec<Ray> {
    let eye = Vec3::new(0.3, 1.1, 2.4);
    let forward = (Vec3::new(0.0, -0.25, 0.0) - eye).normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let mut rays = Vec::new();
    for tile in 0..(side / 8) * (side / 8) {
        for i in 0..64 {
            let x = tile % (side / 8) * 8 + (bit(i, 0) | bit(i, 2) << 1 | bit(i, 4) << 2);
            let y = tile / (side / 8) * 8 + (bit(i, 1) | bit(i, 3) << 1 | bit(i, 5) << 2);
            let to = |p: u32| ((p as f32 + 0.5) / side as f32 - 0.5) * 0.9;
            rays.push(Ray::new(eye, forward + right * to(x) - up * to(y)));
        }
    }
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    Scalar::new(bvh).closest_batch(&rays, Opaque, &mut hits);
    let shadow = |(ray, hit): (&Ray, &Hit)| {
        let t = bvh.triangles().get(hit.triangle as usize)?;
        let normal = (t.v1 - t.v0).cross(t.v2 - t.v0).normalize();
        let facing = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
        let position = ray.origin + ray.direction * hit.t;
        let magnitude = t.low().abs().max(t.high().abs()).max(position.abs()).max_element();
        (facing.dot(SUN) > 0.0).then(|| Ray::new(offset_origin(position, facing, magnitude), SUN.normalize()))
    };
    rays.iter().zip(&hits).filter_map(shadow).collect()
}

/// Each ray's nearest hit.
pub fn closest<A: AnyHit>(tracer: &impl Tracer, rays: &[Ray], any_hit: A) -> Vec<Hit> {
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    tracer.closest_batch(rays, any_hit, &mut hits);
    hits
}

/// Whether each ray is blocked.
pub fn occluded<A: AnyHit>(tracer: &impl Tracer, rays: &[Ray], any_hit: A) -> Vec<bool> {
    let mut blocked = vec![false; rays.len()];
    tracer.occluded_batch(rays, any_hit, &mut blocked);
    blocked
}
