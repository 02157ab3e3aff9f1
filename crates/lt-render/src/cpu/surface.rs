//! What a triangle shows on a depth map: its depth at a texel's centre, for neighbours in a row at a time.

use lt_math::glam::{Vec2, Vec3, Vec4};
use lt_shaders::depth::depth_at;

/// Texels of a row that are compared together.
pub const LANES: usize = 16;

/// Depth as a linear function of the place on the map, never past the corners' own depths.
pub struct DepthPlane {
    origin: Vec3,
    gradient: Vec2,
    low: f32,
    high: f32,
}

impl DepthPlane {
    /// Through a triangle's corners, in texels and depth.
    pub fn through(corners: &[Vec3; 3]) -> Self {
        let (a, b) = ((corners[1] - corners[0]).as_dvec3(), (corners[2] - corners[0]).as_dvec3());
        let area = a.x * b.y - a.y * b.x;
        let gradient = match area == 0.0 {
            true => Vec2::ZERO,
            false => {
                Vec2::new(((a.z * b.y - b.z * a.y) / area) as f32, ((b.z * a.x - a.z * b.x) / area) as f32)
            }
        };
        let z = corners.map(|c| c.z);
        Self { origin: corners[0], gradient, low: z[0].min(z[1]).min(z[2]), high: z[0].max(z[1]).max(z[2]) }
    }
}

impl Surface for DepthPlane {
    #[inline(always)]
    fn at(&self, x: f32, y: f32) -> f32 {
        let offset = (x - self.origin.x) * self.gradient.x + (y - self.origin.y) * self.gradient.y;
        let depth = self.origin.z + offset;
        let depth = if depth < self.low { self.low } else { depth };
        if depth > self.high { self.high } else { depth }
    }
}

/// A triangle on a perspective map.
pub struct Perspective<'a>(pub &'a [Vec4; 3]);

impl Surface for Perspective<'_> {
    #[inline(always)]
    fn at(&self, x: f32, y: f32) -> f32 {
        depth_at(Vec2::new(x, y), self.0)
    }
}

/// What a triangle shows on a map.
pub trait Surface {
    /// Its depth at a place of the map, texels.
    fn at(&self, x: f32, y: f32) -> f32;

    /// Draws neighbours in a row, the first of them texel `first`; y is their centres'.
    #[inline(always)]
    fn draw(&self, first: usize, y: f32, stored: &mut [f32]) {
        for (i, stored) in stored.iter_mut().enumerate() {
            let depth = self.at((first + i) as f32 + 0.5, y);
            *stored = if depth < *stored && depth >= 0.0 { depth } else { *stored };
        }
    }

    /// [`Surface::draw`] of the centres that are covered. Most texels that a leaf falls on are nearer already: the
    /// others are found together.
    #[inline(always)]
    fn draw_where(&self, first: usize, y: f32, stored: &mut [f32], is_covered: impl Fn(Vec2) -> bool) {
        let mut depths = [0.0; LANES];
        let mut nearer = 0u32;
        for (i, (depth, stored)) in depths.iter_mut().zip(&*stored).enumerate() {
            *depth = self.at((first + i) as f32 + 0.5, y);
            nearer |= u32::from(*depth < *stored && *depth >= 0.0) << i;
        }
        while nearer != 0 {
            let i = nearer.trailing_zeros() as usize;
            nearer &= nearer - 1;
            if is_covered(Vec2::new((first + i) as f32 + 0.5, y)) {
                stored[i] = depths[i];
            }
        }
    }
}
