//! Generated textures: lattice noise and small patterns, tiling unless said otherwise.
//!
//! They depend on nothing, so each is painted once a run and shared by every pose.

use std::sync::OnceLock;

use lt_math::glam::{Vec2, Vec3};
use rayon::prelude::*;

use super::{
    numbers::{TAU, fractal_noise, noise, sin_cos},
    rng::Rng,
};
use crate::Texture;

/// Fills an image from sRGB colour and alpha in [0, 1], given texel centres in [0, 1]².
pub fn paint(name: &str, size: u32, shade: impl Fn(Vec2) -> (Vec3, f32) + Sync) -> Texture {
    let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    let texels: Vec<[u8; 4]> = (0..size * size)
        .into_par_iter()
        .map(|i| {
            let at = Vec2::new((i % size) as f32 + 0.5, (i / size) as f32 + 0.5) / size as f32;
            let (color, alpha) = shade(at);
            [byte(color.x), byte(color.y), byte(color.z), byte(alpha)]
        })
        .collect();
    Texture { name: name.to_owned(), width: size, height: size, texels: texels.into() }
}

/// sRGB colour of a code such as 0xffaa00, in [0, 1].
pub fn code(code: u32) -> Vec3 {
    Vec3::new((code >> 16 & 255) as f32, (code >> 8 & 255) as f32, (code & 255) as f32) / 255.0
}

/// Roughcast: nearly white, to be tinted.
pub fn plaster() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("plaster", 128, |p| {
            let stain = fractal_noise(p * 4.0, 4, 1) - 0.5;
            let grain = noise(p * 64.0, 64, 5) - 0.5;
            (Vec3::splat(0.93 + 0.10 * stain + 0.05 * grain), 1.0)
        })
    })
    .clone()
}

/// Running-bond courses of `columns` × `rows` blocks between joints; each block has its own shade.
fn courses(p: Vec2, columns: i32, rows: i32, joint: Vec2, salt: u32) -> (bool, f32) {
    let row = (p.y * rows as f32).floor();
    let shift = 0.5 * (row as i32 % 2) as f32;
    let q = Vec2::new(p.x * columns as f32 + shift, p.y * rows as f32);
    let f = q - q.floor();
    let is_joint = f.x < joint.x || f.y < joint.y;
    let block = Vec2::new((q.x.floor() as i32).rem_euclid(columns) as f32, row);
    (is_joint, noise(block + Vec2::splat(0.001), 0, salt))
}

/// Brickwork, to be tinted; one tile covers 1 m × 1 m.
pub fn brick() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("brick", 256, |p| {
            let (is_joint, shade) = courses(p, 4, 12, Vec2::new(0.05, 0.14), 11);
            let grain = 0.08 * (noise(p * 64.0, 64, 3) - 0.5);
            let brick = code(0xb0604a).lerp(code(0x8f4a3a), shade) + Vec3::splat(grain);
            (if is_joint { code(0xb5a797) } else { brick }, 1.0)
        })
    })
    .clone()
}

/// Roof tiles in overlapping rows, light, to be tinted; one tile of texture covers 1 m × 1 m.
pub fn tiles() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("tiles", 256, |p| {
            let (_, shade) = courses(p, 5, 4, Vec2::ZERO, 23);
            let row = (p.y * 4.0).floor();
            let x = p.x * 5.0 + 0.5 * (row as i32 % 2) as f32;
            let hump = (x - x.floor() - 0.5).abs() * 2.0;
            let down = p.y * 4.0 - row;
            let light =
                0.92 - 0.22 * hump * hump - 0.35 * ((down - 0.82).max(0.0) / 0.18) + 0.16 * (shade - 0.5);
            (Vec3::splat(light), 1.0)
        })
    })
    .clone()
}

/// Asphalt: dark speckle; one tile covers a few metres.
pub fn asphalt() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("asphalt", 256, |p| {
            let patch = fractal_noise(p * 4.0, 4, 31) - 0.5;
            let grit = noise(p * 128.0, 128, 37) - 0.5;
            (code(0x6a6764) + Vec3::splat(0.10 * patch + 0.09 * grit), 1.0)
        })
    })
    .clone()
}

/// Square paving slabs, three to the metre across, to be tinted.
pub fn paving() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("paving", 256, |p| {
            let (is_joint, shade) = courses(p, 2, 3, Vec2::new(0.025, 0.04), 41);
            let grain = 0.05 * (noise(p * 64.0, 64, 43) - 0.5);
            let slab = code(0xb8b0a4) + Vec3::splat(0.10 * (shade - 0.5) + grain);
            (if is_joint { code(0x8c857b) } else { slab }, 1.0)
        })
    })
    .clone()
}

/// Lawn or meadow from above.
pub fn grass() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("grass", 256, |p| {
            let patch = fractal_noise(p * 4.0, 4, 51);
            let blade = noise(p * Vec2::new(128.0, 64.0), 64, 53) - 0.5;
            let color = code(0x5d7a36).lerp(code(0x86984a), patch) + Vec3::splat(0.10 * blade);
            (color, 1.0)
        })
    })
    .clone()
}

/// Trodden gravel and earth.
pub fn gravel() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("gravel", 256, |p| {
            let patch = fractal_noise(p * 4.0, 4, 61);
            let stone = noise(p * 96.0, 96, 67) - 0.5;
            (code(0xc2b08c).lerp(code(0xa8946f), patch) + Vec3::splat(0.12 * stone), 1.0)
        })
    })
    .clone()
}

/// Forest floor: needles, moss and earth.
pub fn forest_floor() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("forest floor", 256, |p| {
            let moss = fractal_noise(p * 6.0, 6, 71);
            let litter = noise(p * Vec2::new(96.0, 64.0), 32, 73) - 0.5;
            let earth = code(0x947a56).lerp(code(0x76894a), ((moss - 0.38) * 4.0).clamp(0.0, 1.0));
            (earth + Vec3::splat(0.14 * litter), 1.0)
        })
    })
    .clone()
}

/// Bark: furrows along v.
pub fn bark() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("bark", 128, |p| {
            let furrow = fractal_noise(p * Vec2::new(16.0, 4.0), 4, 81);
            (code(0x54453a).lerp(code(0x8d7b68), furrow), 1.0)
        })
    })
    .clone()
}

/// Weathered boards, four to the tile, along v.
pub fn boards() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("boards", 128, |p| {
            let board = p.x * 4.0;
            let grain = fractal_noise(p * Vec2::new(32.0, 4.0), 4, 91) - 0.5;
            let shade = noise(Vec2::new(board.floor() + 0.001, 0.0), 0, 97) - 0.5;
            let gap = if board - board.floor() < 0.06 { 0.35 } else { 0.0 };
            (Vec3::splat(0.86 + 0.2 * grain + 0.14 * shade - gap), 1.0)
        })
    })
    .clone()
}

/// A window pane with drawn curtains: sky at the top, dark room below. Not tiling.
pub fn window() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("window", 64, |p| {
            let reflection = code(0x9fb6c8).lerp(code(0x3c4a56), (p.y * 1.6).min(1.0));
            let side = (p.x - 0.5).abs() * 2.0;
            let drape = 0.62 + 0.22 * p.y * p.y;
            let fold = 0.85 + 0.15 * sin_cos(side * 40.0).0;
            let color = if side > drape { reflection.lerp(code(0xcfc6b4) * fold, 0.55) } else { reflection };
            (color, 1.0)
        })
    })
    .clone()
}

/// The nearest leaf covering `p` among leaves of (stalk, direction, length, width), and how far along it is.
fn leaf_at(p: Vec2, leaves: &[(Vec2, Vec2, f32, f32)]) -> Option<(usize, f32, f32)> {
    leaves.iter().enumerate().rev().find_map(|(i, &(stalk, along, length, width))| {
        let q = p - stalk;
        let t = q.dot(along) / length;
        let side = q.perp_dot(along) / width;
        // Width swells to the middle and tapers to a point.
        let half = 2.0 * (t * (1.0 - t)).max(0.0) * (1.25 - 0.5 * t);
        (t > 0.0 && t < 1.0 && side.abs() < half).then_some((i, t, side))
    })
}

/// A twig with its leaves on transparent ground: alpha 0 or 1, growing from the bottom middle. Not tiling.
pub fn leaves() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        let mut rng = Rng::new(0x1eaf, 0);
        let mut cluster = Vec::new();
        for i in 0..46 {
            let t = i as f32 / 46.0;
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let stem = Vec2::new(0.5 + 0.06 * sin_cos(t * 5.0).0, 0.96 - 0.80 * t);
            let (s, c) = sin_cos(side * rng.range(0.25, 1.5));
            let outward = Vec2::new(s, -c);
            let stalk = stem + outward * rng.range(0.0, 0.28) * (1.0 - t * 0.6);
            let (s, c) = sin_cos(side * rng.range(-0.3, 1.9));
            let length = rng.range(0.13, 0.20);
            cluster.push((stalk, Vec2::new(s, -c), length, length * 0.42));
        }
        cluster.retain(|&(stalk, along, length, _)| {
            let tip = stalk + along * length;
            tip.min(stalk).min_element() > 0.02 && tip.max(stalk).max_element() < 0.98
        });
        let shades: Vec<f32> = cluster.iter().map(|_| rng.unit()).collect();
        paint("leaves", 256, |p| {
            let base = code(0x5f7f33);
            match leaf_at(p, &cluster) {
                Some((i, t, side)) => {
                    let vein = if side.abs() < 0.05 { 0.06 } else { 0.0 };
                    let color =
                        code(0x557630).lerp(code(0x94ad52), shades[i]) + Vec3::splat(vein + 0.06 * (t - 0.5));
                    (color, 1.0)
                }
                None => {
                    let stem = Vec2::new(0.5 + 0.06 * sin_cos((0.96 - p.y) / 0.80 * 5.0).0, p.y);
                    let is_stem = p.y > 0.2 && (p.x - stem.x).abs() < 0.008;
                    if is_stem { (code(0x5a4a30), 1.0) } else { (base, 0.0) }
                }
            }
        })
    })
    .clone()
}

/// A fir branch: needles both sides of a stem, growing from the bottom middle. Not tiling.
pub fn needles() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        let mut rng = Rng::new(0xf1e, 0);
        let mut twigs = vec![(Vec2::new(0.5, 0.99), Vec2::new(0.0, -1.0), 0.96)];
        for i in 0..12 {
            let t = i as f32 / 12.0;
            for side in [-1.0, 1.0] {
                let (s, c) = sin_cos(side * rng.range(0.75, 1.05));
                twigs.push((
                    Vec2::new(0.5, 0.94 - 0.78 * t),
                    Vec2::new(s, -c),
                    (0.46 - 0.36 * t) * rng.range(0.85, 1.1),
                ));
            }
        }
        paint("needles", 256, |p| {
            let base = code(0x4c6c38);
            for (i, &(root, along, length)) in twigs.iter().enumerate() {
                let q = p - root;
                let t = q.dot(along);
                let side = q.perp_dot(along).abs();
                let reach = 0.046 * (1.0 - 0.5 * t / length);
                if t > 0.0 && t < length && side < reach {
                    // Needles lean forward: stripes in the sheared coordinate.
                    let stripe = (t - side * 0.8) * 62.0;
                    if side < 0.006 || stripe - stripe.floor() < 0.62 {
                        let shade = noise(Vec2::new(i as f32 + 0.001, stripe.floor()), 0, 7);
                        return (base.lerp(code(0x86a05c), shade * 0.8 + 0.4 * side / reach - 0.2), 1.0);
                    }
                }
            }
            (base, 0.0)
        })
    })
    .clone()
}

/// A tuft of grass blades rooted along the bottom edge. Not tiling.
pub fn blades() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        let mut rng = Rng::new(0x6ba5, 0);
        let blades: Vec<(f32, f32, f32, f32, f32)> = (0..34)
            .map(|_| {
                let root = rng.range(0.15, 0.85);
                let lean = (root - 0.5) * 0.5 + rng.range(-0.22, 0.22);
                (root, lean, rng.range(0.45, 0.97), rng.range(0.010, 0.018), rng.unit())
            })
            .collect();
        paint("blades", 256, |p| {
            let height = 1.0 - p.y;
            let hit = blades.iter().rev().find(|&&(root, lean, top, width, _)| {
                let t = height / top;
                t < 1.0 && (p.x - root - lean * t * t).abs() < width * (1.0 - t * t)
            });
            match hit {
                Some(&(.., shade)) => {
                    let tone = code(0x55752e).lerp(code(0x9caa55), shade * 0.6 + 0.4 * height);
                    (tone, 1.0)
                }
                None => (code(0x6c8638), 0.0),
            }
        })
    })
    .clone()
}

/// A clock face with twelve marks and two hands. Not tiling.
pub fn clock() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("clock", 128, |p| {
            let q = (p - Vec2::splat(0.5)) * 2.0;
            let radius = q.length();
            let is_mark = (0..12).any(|hour| {
                let (s, c) = sin_cos(hour as f32 / 12.0 * TAU);
                (q - Vec2::new(s, c) * 0.8).length() < 0.07
            });
            let hand = |angle: f32, length: f32| {
                let (s, c) = sin_cos(angle);
                let along = Vec2::new(s, -c);
                q.dot(along) > 0.0 && q.dot(along) < length && q.perp_dot(along).abs() < 0.04
            };
            let is_dark = is_mark || hand(0.9, 0.75) || hand(5.3, 0.5) || radius > 0.92;
            (if is_dark { code(0x2b2a2c) } else { code(0xf1ead6) }, 1.0)
        })
    })
    .clone()
}

/// One bay of a half-timbered storey with its window, to be tinted; tiles per bay and storey.
pub fn facade() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("facade", 64, |p| {
            let from_middle = Vec2::new((p.x - 0.5).abs(), p.y);
            let is_beam = p.x < 0.05 || p.x > 0.95 || p.y > 0.93 || (p.y - 0.02).abs() < 0.03;
            let is_brace = p.y > 0.66 && (from_middle.x - 0.5 + (p.y - 0.66) * 0.5).abs() < 0.03;
            let is_frame = from_middle.x < 0.22 && p.y > 0.20 && p.y < 0.66;
            let is_pane = from_middle.x < 0.18
                && from_middle.x > 0.02
                && p.y > 0.24
                && p.y < 0.62
                && (p.y - 0.40).abs() > 0.015;
            let color = if is_pane {
                code(0x46525c)
            } else if is_frame {
                code(0xf4f0e6)
            } else if is_beam || is_brace {
                code(0x86705a)
            } else {
                code(0xf4f0ea)
            };
            (color, 1.0)
        })
    })
    .clone()
}

/// Coursed ashlar, light, to be tinted.
pub fn ashlar() -> Texture {
    static ONCE: OnceLock<Texture> = OnceLock::new();
    ONCE.get_or_init(|| {
        paint("ashlar", 128, |p| {
            let (is_joint, shade) = courses(p, 2, 4, Vec2::new(0.03, 0.06), 111);
            let grain = 0.05 * (noise(p * 32.0, 32, 113) - 0.5);
            let light = if is_joint { 0.72 } else { 0.86 + 0.12 * (shade - 0.5) + grain };
            (Vec3::splat(light), 1.0)
        })
    })
    .clone()
}
