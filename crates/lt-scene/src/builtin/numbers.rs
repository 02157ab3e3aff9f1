//! Sines, colours and lattice noise from plain arithmetic, so that no platform's libm decides a vertex.

use lt_math::glam::{Affine3A, Mat3, Vec2, Vec3};

/// A full turn, radians.
pub const TAU: f32 = core::f32::consts::TAU;

/// Sine and cosine of an angle in radians: reduction to a quarter turn, then Taylor series in f64.
pub fn sin_cos(angle_rad: f32) -> (f32, f32) {
    let quarter = core::f64::consts::FRAC_PI_2;
    let angle = f64::from(angle_rad);
    let turns = (angle / quarter + 0.5).floor();
    let x = angle - turns * quarter;
    let y = x * x;
    let sine =
        x * (1.0 - y / 6.0 * (1.0 - y / 20.0 * (1.0 - y / 42.0 * (1.0 - y / 72.0 * (1.0 - y / 110.0)))));
    let cosine = 1.0 - y / 2.0 * (1.0 - y / 12.0 * (1.0 - y / 30.0 * (1.0 - y / 56.0 * (1.0 - y / 90.0))));
    let (s, c) = match turns.rem_euclid(4.0) as u32 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    };
    (s as f32, c as f32)
}

/// Sine of an angle in radians.
pub fn sin(angle_rad: f32) -> f32 {
    sin_cos(angle_rad).0
}

/// A move to `origin` after a turn about +Y that takes +Z towards +X.
pub fn standing(origin: Vec3, yaw_rad: f32) -> Affine3A {
    standing_scaled(origin, yaw_rad, Vec3::ONE)
}

/// [`standing`] after a scale along the object's axes.
pub fn standing_scaled(origin: Vec3, yaw_rad: f32, scale: Vec3) -> Affine3A {
    let (s, c) = sin_cos(yaw_rad);
    let turn = Mat3::from_cols(Vec3::new(c, 0.0, -s), Vec3::Y, Vec3::new(s, 0.0, c));
    Affine3A::from_mat3_translation(turn * Mat3::from_diagonal(scale), origin)
}

/// A move to `origin` after the turn about +Y that takes +Z to the horizontal unit vector `forward`.
pub fn turned_to(origin: Vec3, forward: Vec3) -> Affine3A {
    Affine3A::from_mat3_translation(Mat3::from_cols(Vec3::Y.cross(forward), Vec3::Y, forward), origin)
}

/// Two unit vectors that make a right-handed frame with the unit vector `axis` as third.
pub fn across(axis: Vec3) -> (Vec3, Vec3) {
    let helper = if axis.y.abs() < 0.9 { Vec3::Y } else { Vec3::X };
    let u = helper.cross(axis).normalize();
    (u, axis.cross(u))
}

/// Linear colour of an sRGB code such as 0xffaa00 (cubic fit of the transfer curve, error below 0.003).
pub fn srgb(code: u32) -> Vec3 {
    let channel = |shift: u32| {
        let c = (code >> shift & 255) as f32 / 255.0;
        c * (c * (c * 0.305_306 + 0.682_171_1) + 0.012_522_9)
    };
    Vec3::new(channel(16), channel(8), channel(0))
}

/// A value in [0, 1) for each lattice point.
fn lattice(x: i32, y: i32, salt: u32) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77) ^ salt;
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1u32 << 24) as f32
}

/// Value noise in [0, 1], smooth, repeating every `period` cells (0: never).
pub fn noise(p: Vec2, period: i32, salt: u32) -> f32 {
    let cell = p.floor();
    let f = p - cell;
    let w = f * f * (Vec2::splat(3.0) - 2.0 * f);
    let wrap = |i: i32| if period > 0 { i.rem_euclid(period) } else { i };
    let at = |dx: i32, dy: i32| lattice(wrap(cell.x as i32 + dx), wrap(cell.y as i32 + dy), salt);
    let top = at(0, 0) + (at(1, 0) - at(0, 0)) * w.x;
    let bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * w.x;
    top + (bottom - top) * w.y
}

/// Four octaves of [`noise`], about [0, 1].
pub fn fractal_noise(p: Vec2, period: i32, salt: u32) -> f32 {
    let mut sum = 0.0;
    let mut weight = 0.5;
    let mut scale = 1.0;
    for octave in 0..4u32 {
        sum += weight * noise(p * scale, (period as f32 * scale) as i32, salt + octave);
        weight *= 0.5;
        scale *= 2.0;
    }
    sum / 0.9375
}
