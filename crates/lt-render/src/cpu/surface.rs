//! What a triangle shows on a depth map: its depth at a texel's centre, for a tile of neighbours at a time.

use std::ops::Range;

use lt_bvh::lanes::Lanes;
use lt_math::glam::{Vec2, Vec3, Vec4};
use lt_shaders::depth::depth_at;

use super::map_tiles::{SIDE, TEXELS};
use super::marks;

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
    fn depths<L: Lanes>(&self, l: L, x: L::F, y: L::F) -> L::F {
        let (x, y) = (l.sub(x, l.splat(self.origin.x)), l.sub(y, l.splat(self.origin.y)));
        let (along_x, along_y) = (l.mul(x, l.splat(self.gradient.x)), l.mul(y, l.splat(self.gradient.y)));
        let depth = l.add(l.splat(self.origin.z), l.add(along_x, along_y));
        l.min(l.splat(self.high), l.max(l.splat(self.low), depth))
    }
}

/// A triangle on a perspective map.
pub struct Perspective<'a>(pub &'a [Vec4; 3]);

impl Surface for Perspective<'_> {
    #[inline(always)]
    fn depths<L: Lanes>(&self, l: L, x: L::F, y: L::F) -> L::F {
        let (mut xs, mut ys, mut depths) = ([0.0; TEXELS], [0.0; TEXELS], [0.0; TEXELS]);
        l.store(x, &mut xs);
        l.store(y, &mut ys);
        for i in 0..L::WIDTH {
            depths[i] = depth_at(Vec2::new(xs[i], ys[i]), self.0);
        }
        l.load(&depths[..L::WIDTH])
    }
}

/// What a triangle shows on a map.
pub trait Surface {
    /// Its depths at places of the map, texels.
    fn depths<L: Lanes>(&self, l: L, x: L::F, y: L::F) -> L::F;

    /// Draws what is covered of a row of tiles whose first row of texels is `y`.
    #[inline(always)]
    fn draw<L: Lanes>(&self, l: L, tiles: &mut [[f32; TEXELS]], covered: &Covered, y: f32) {
        for tile in covered.tiles.clone() {
            for (part, stored) in tiles[tile].chunks_exact_mut(L::WIDTH).enumerate() {
                let nearer = covered.nearer(l, self, (tile, part), y, stored);
                if nearer.holds != 0 {
                    l.store(l.pick(nearer.holds, nearer.depths, l.load(stored)), stored);
                }
            }
        }
    }

    /// [`Surface::draw`] of the centres that are solid: `solid` gets the x of a tile's first texel and a bit for each texel that is asked
    /// about, and leaves the bits of those that are. Most texels that a leaf falls on are nearer already.
    #[inline(always)]
    fn draw_where<L: Lanes>(
        &self,
        l: L,
        tiles: &mut [[f32; TEXELS]],
        covered: &Covered,
        y: f32,
        solid: impl Fn(f32, u32) -> u32,
    ) {
        for tile in covered.tiles.clone() {
            for (part, stored) in tiles[tile].chunks_exact_mut(L::WIDTH).enumerate() {
                let nearer = covered.nearer(l, self, (tile, part), y, stored);
                if nearer.holds != 0 {
                    let first = part * L::WIDTH;
                    let solid = solid((tile * SIDE) as f32, nearer.holds << first) >> first;
                    l.store(l.pick(solid, nearer.depths, l.load(stored)), stored);
                }
            }
        }
    }
}

/// What is covered of a row of tiles.
pub struct Covered {
    /// Tiles that hold any of it.
    tiles: Range<usize>,
    /// Of every texel of a tile, the first column that is covered in its row.
    low: [f32; TEXELS],
    /// And one past the last.
    high: [f32; TEXELS],
}

/// Depths of a part of a tile, and a bit for each that is meant and nearer than what is stored.
struct Nearer<F> {
    depths: F,
    holds: u32,
}

/// Columns and rows of a tile's texels.
const PLACES: [[f32; TEXELS]; 2] = {
    let mut places = [[0.0; TEXELS]; 2];
    let mut i = 0;
    while i < TEXELS {
        places[0][i] = (i % SIDE) as f32;
        places[1][i] = (i / SIDE) as f32;
        i += 1;
    }
    places
};

impl Covered {
    /// In each row the columns from `low` to `high`, none if that is not higher, all of them in `tiles`.
    #[inline(always)]
    pub fn new(tiles: Range<usize>, low: [f32; SIDE], high: [f32; SIDE]) -> Self {
        let of_texels = |rows: [f32; SIDE]| std::array::from_fn(|i| rows[i / SIDE]);
        Self { tiles, low: of_texels(low), high: of_texels(high) }
    }

    #[inline(always)]
    fn nearer<L: Lanes, S: Surface + ?Sized>(
        &self,
        l: L,
        surface: &S,
        (tile, part): (usize, usize),
        y: f32,
        stored: &[f32],
    ) -> Nearer<L::F> {
        let at = part * L::WIDTH..(part + 1) * L::WIDTH;
        let [columns, rows] = &PLACES;
        // Exact on maps of up to 2²³ texels a side, and so are the centres.
        let column = l.add(l.splat((tile * SIDE) as f32), l.load(&columns[at.clone()]));
        let row = l.add(l.splat(y), l.load(&rows[at.clone()]));
        let half = l.splat(0.5);
        // -0 becomes 0, whose highest bits are free for marks.
        let depths = l.add(surface.depths(l, l.add(column, half), l.add(row, half)), l.splat(0.0));
        let is_covered = l.le(l.load(&self.low[at.clone()]), column) & l.lt(column, l.load(&self.high[at]));
        let mut unmarked = [0.0; TEXELS];
        unmarked.iter_mut().zip(stored).for_each(|(to, texel)| *to = marks::depth(*texel));
        let is_nearer = l.lt(depths, l.load(&unmarked[..L::WIDTH])) & l.le(l.splat(0.0), depths);
        Nearer { depths, holds: is_covered & is_nearer }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_bvh::SimdLevel;
    use lt_bvh::lanes::{Chosen, NodeLanes, Work};

    #[test]
    fn tiles_hold_what_each_texel_is_given() {
        let plane =
            DepthPlane::through(&[[0.0, 0.0, 0.9], [40.0, 0.0, -0.3], [0.0, 9.0, 0.5]].map(Vec3::from));
        let length = 24;
        // The plane by the same operations, one place at a time.
        let at = |x: f32, y: f32| {
            let offset = (x - plane.origin.x) * plane.gradient.x + (y - plane.origin.y) * plane.gradient.y;
            (plane.origin.z + offset).max(plane.low).min(plane.high)
        };
        let before: Vec<[f32; TEXELS]> = (0..length / SIDE)
            .map(|t| std::array::from_fn(|i| ((t * TEXELS + i) * 7 % 11) as f32 / 11.0))
            .collect();
        let mut drawn_at_all = 0;
        for columns in (0..=length).flat_map(|low| (low..=length).map(move |high| low..high)) {
            // Rows of a tile that reach less and less far, the last one not at all.
            let counts: [usize; SIDE] =
                std::array::from_fn(|row| columns.len() * (SIDE - 1 - row) / (SIDE - 1));
            let (low, high) =
                (counts.map(|_| columns.start as f32), counts.map(|n| (columns.start + n) as f32));
            let in_tiles = columns.start / SIDE..columns.end.div_ceil(SIDE);
            let covered = Covered::new(in_tiles, low, high);
            let is_solid = |x: usize, row: usize| !(x + row).is_multiple_of(3);
            for level in SimdLevel::available() {
                let draw = Draw { plane: &plane, covered: &covered, y: 2, before: &before, is_solid };
                let [all, some] = Chosen::new(level).expect("an available level").run(draw);
                for (x, row) in (0..length).flat_map(|x| (0..SIDE).map(move |row| (x, row))) {
                    let (tile, i) = (x / SIDE, row * SIDE + x % SIDE);
                    let (depth, stored) = (at(x as f32 + 0.5, 2.5 + row as f32), before[tile][i]);
                    let is_covered = (columns.start..columns.start + counts[row]).contains(&x);
                    let drawn = is_covered && depth < stored && depth >= 0.0;
                    drawn_at_all += usize::from(drawn);
                    let expected = if drawn { depth } else { stored };
                    assert_eq!(all[tile][i], expected, "{level:?} {columns:?}, {x} {row}");
                    let expected = if drawn && is_solid(x, row) { depth } else { stored };
                    assert_eq!(some[tile][i], expected, "{level:?} {columns:?}, {x} {row}");
                }
            }
        }
        assert!(drawn_at_all > 1000, "{drawn_at_all}");
    }

    /// Draws a row of tiles by either function.
    struct Draw<'a, F> {
        plane: &'a DepthPlane,
        covered: &'a Covered,
        y: usize,
        before: &'a [[f32; TEXELS]],
        is_solid: F,
    }

    impl<F: Fn(usize, usize) -> bool> Work for Draw<'_, F> {
        type Output = [Vec<[f32; TEXELS]>; 2];
        fn run<L: NodeLanes>(self, lanes: L) -> Self::Output {
            let mut drawn = [self.before.to_vec(), self.before.to_vec()];
            let [all, some] = &mut drawn;
            let y = self.y as f32;
            self.plane.draw(lanes.rays(), all, self.covered, y);
            self.plane.draw_where(lanes.rays(), some, self.covered, y, |first, which| {
                let is_solid = |i: usize| (self.is_solid)(first as usize + i % SIDE, i / SIDE);
                (0..TEXELS).filter(|&i| which >> i & 1 == 1 && is_solid(i)).fold(0, |all, i| all | 1 << i)
            });
            drawn
        }
    }
}
