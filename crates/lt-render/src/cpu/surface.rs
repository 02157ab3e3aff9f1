//! What a triangle shows on a depth map: its depth at a texel's centre, for neighbours in a row at a time.

use std::ops::Range;

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

    /// Draws some columns of a row of whole groups of [`LANES`]; y is the texel centres'.
    #[inline(always)]
    fn draw(&self, row: &mut [f32], columns: Range<usize>, y: f32) {
        for (first, stored) in groups(row, &columns) {
            let nearer = Nearer::of(self, first, y, &columns, stored);
            for (i, stored) in stored.iter_mut().enumerate() {
                *stored = if nearer.holds[i] { nearer.depths[i] } else { *stored };
            }
        }
    }

    /// [`Surface::draw`] of the centres that are covered: `covered` gets the first centre's x and a bit for each neighbour that is asked
    /// about, and leaves the bits of those that are. Most texels that a leaf falls on are nearer already.
    #[inline(always)]
    fn draw_where(&self, row: &mut [f32], columns: Range<usize>, y: f32, covered: impl Fn(f32, u32) -> u32) {
        for (first, stored) in groups(row, &columns) {
            let nearer = Nearer::of(self, first, y, &columns, stored);
            let asked =
                nearer.holds.iter().enumerate().fold(0, |bits, (i, &holds)| bits | u32::from(holds) << i);
            if asked != 0 {
                let covered = covered(centre(first, 0), asked);
                for (i, stored) in stored.iter_mut().enumerate() {
                    *stored = if covered >> i & 1 == 1 { nearer.depths[i] } else { *stored };
                }
            }
        }
    }
}

/// The groups of a row that hold some of its columns, each with its first column.
#[inline(always)]
fn groups<'a>(
    row: &'a mut [f32],
    columns: &Range<usize>,
) -> impl Iterator<Item = (usize, &'a mut [f32; LANES])> {
    let first = columns.start / LANES;
    let count = if columns.is_empty() { 0 } else { columns.end.div_ceil(LANES) - first };
    let groups = row.as_chunks_mut().0.iter_mut().enumerate().skip(first).take(count);
    groups.map(|(group, stored)| (group * LANES, stored))
}

/// Depths of a group, and which of them are meant and nearer than what is stored.
struct Nearer {
    depths: [f32; LANES],
    holds: [bool; LANES],
}

impl Nearer {
    #[inline(always)]
    fn of<S: Surface + ?Sized>(
        surface: &S,
        first: usize,
        y: f32,
        columns: &Range<usize>,
        stored: &[f32; LANES],
    ) -> Self {
        // One comparison for both ends of the range.
        let (before, count) = ((first as u32).wrapping_sub(columns.start as u32), columns.len() as u32);
        let depths: [f32; LANES] = std::array::from_fn(|i| surface.at(centre(first, i), y));
        let holds = std::array::from_fn(|i| {
            (before.wrapping_add(i as u32) < count) & (depths[i] < stored[i]) & (depths[i] >= 0.0)
        });
        Self { depths, holds }
    }
}

/// The centre of the texel `i` right of another: exact on maps of up to 2²³ texels a side.
#[inline(always)]
fn centre(first: usize, i: usize) -> f32 {
    first as f32 + (i as f32 + 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold_what_each_texel_is_given() {
        let plane =
            DepthPlane::through(&[[0.0, 0.0, 0.9], [40.0, 0.0, -0.3], [0.0, 9.0, 0.5]].map(Vec3::from));
        for length in [16, 32, 48] {
            let before: Vec<f32> = (0..length).map(|i| (i * 7 % 11) as f32 / 11.0).collect();
            for columns in (0..=length).flat_map(|low| (low..=length).map(move |high| low..high)) {
                let (mut all, mut some) = (before.clone(), before.clone());
                plane.draw(&mut all, columns.clone(), 2.5);
                let is_covered = |x: f32| !(x as usize).is_multiple_of(3);
                plane.draw_where(&mut some, columns.clone(), 2.5, |first, which| {
                    (0..32)
                        .filter(|i| which >> i & 1 == 1 && is_covered(first + *i as f32))
                        .fold(0, |all, i| all | 1 << i)
                });
                for i in 0..length {
                    let depth = plane.at(i as f32 + 0.5, 2.5);
                    let drawn = columns.contains(&i) && depth < before[i] && depth >= 0.0;
                    assert_eq!(all[i], if drawn { depth } else { before[i] }, "{columns:?} of {length}, {i}");
                    let drawn = drawn && is_covered(i as f32 + 0.5);
                    assert_eq!(
                        some[i],
                        if drawn { depth } else { before[i] },
                        "{columns:?} of {length}, {i}"
                    );
                }
            }
        }
    }
}
