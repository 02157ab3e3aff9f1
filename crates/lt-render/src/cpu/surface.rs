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

    /// Draws some columns of a row; y is the texel centres'.
    #[inline(always)]
    fn draw(&self, row: &mut [f32], columns: Range<usize>, y: f32) {
        for group in Groups::of(row.len(), columns) {
            match row[group.first..].first_chunk_mut::<LANES>() {
                Some(stored) => {
                    let depths = self.depths(group.first, y);
                    for i in 0..LANES {
                        let is_nearer = group.holds(i) & (depths[i] < stored[i]) & (depths[i] >= 0.0);
                        stored[i] = if is_nearer { depths[i] } else { stored[i] };
                    }
                }
                None => self.draw_few(row, group, y, |_, which| which),
            }
        }
    }

    /// [`Surface::draw`] of the centres that are covered: `covered` gets the first centre's x and a bit for each neighbour that is asked
    /// about, and leaves the bits of those that are. Most texels that a leaf falls on are nearer already.
    #[inline(always)]
    fn draw_where(&self, row: &mut [f32], columns: Range<usize>, y: f32, covered: impl Fn(f32, u32) -> u32) {
        for group in Groups::of(row.len(), columns) {
            match row[group.first..].first_chunk_mut::<LANES>() {
                Some(stored) => {
                    let depths = self.depths(group.first, y);
                    let mut nearer = 0u32;
                    for i in 0..LANES {
                        let is_nearer = group.holds(i) & (depths[i] < stored[i]) & (depths[i] >= 0.0);
                        nearer |= u32::from(is_nearer) << i;
                    }
                    if nearer != 0 {
                        let covered = covered(centre(group.first, 0), nearer);
                        for i in 0..LANES {
                            stored[i] = if covered >> i & 1 == 1 { depths[i] } else { stored[i] };
                        }
                    }
                }
                None => self.draw_few(row, group, y, &covered),
            }
        }
    }

    /// Depths at neighbouring centres.
    #[inline(always)]
    fn depths(&self, first: usize, y: f32) -> [f32; LANES] {
        std::array::from_fn(|i| self.at(centre(first, i), y))
    }

    /// A group of a row that is too short for [`LANES`].
    fn draw_few(&self, row: &mut [f32], group: Group, y: f32, covered: impl Fn(f32, u32) -> u32) {
        let first = centre(group.first, 0);
        for (i, stored) in row[group.first..].iter_mut().enumerate() {
            let depth = self.at(centre(group.first, i), y);
            if group.holds(i) && depth < *stored && depth >= 0.0 && covered(first, 1 << i) != 0 {
                *stored = depth;
            }
        }
    }
}

/// The centre of the texel `i` right of another: exact on maps of up to 2²³ texels a side.
#[inline(always)]
fn centre(first: usize, i: usize) -> f32 {
    first as f32 + (i as f32 + 0.5)
}

/// Neighbours in a row from `first` on, of which `count` are meant after the first `skip`.
#[derive(Clone, Copy)]
pub struct Group {
    first: usize,
    skip: u32,
    count: u32,
}

impl Group {
    #[inline(always)]
    fn holds(self, i: usize) -> bool {
        (i as u32).wrapping_sub(self.skip) < self.count
    }
}

/// Columns of a row in groups of [`LANES`] that end in the row.
struct Groups {
    next: usize,
    end: usize,
    /// Where the last group that fits begins.
    last: usize,
}

impl Groups {
    #[inline(always)]
    fn of(row: usize, columns: Range<usize>) -> Self {
        Self { next: columns.start, end: columns.end, last: row.saturating_sub(LANES) }
    }
}

impl Iterator for Groups {
    type Item = Group;
    #[inline(always)]
    fn next(&mut self) -> Option<Group> {
        if self.next >= self.end {
            return None;
        }
        let first = self.next.min(self.last);
        let next = self.end.min(first + LANES);
        let group = Group { first, skip: (self.next - first) as u32, count: (next - self.next) as u32 };
        self.next = next;
        Some(group)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_any_length_hold_what_each_texel_is_given() {
        let plane =
            DepthPlane::through(&[[0.0, 0.0, 0.9], [40.0, 0.0, -0.3], [0.0, 9.0, 0.5]].map(Vec3::from));
        for length in 1..50 {
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
