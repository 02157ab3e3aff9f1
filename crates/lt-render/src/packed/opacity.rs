//! Opacity maps: what the alpha test says of whole cells of a triangle, so that most hits need neither vertices nor texels.
//!
//! A triangle's barycentric square is cut into side × side cells; a cell is **opaque** where every hit in it covers, **clear** where none
//! does, and mixed otherwise, which leaves the answer to the texture. (GPUs know them as opacity micromaps; Gruen, Benthin, Woop, "Sub-Triangle
//! Opacity Masks for Faster Ray Tracing of Transparent Objects", HPG 2020.) Verdicts are exact, rounding included, so that no answer
//! depends on them: alpha lies between the least and largest texel that a hit in the cell may blend, and a verdict keeps a margin that is far above all
//! rounding of `lt_shaders::surface::covers`.
//!
//! Triangles with the same texture coordinates, vertex alphas and material share a map: a wood of 290,000 leaf cards has fourteen. Of those
//! that share with few others the map has fewer cells, so that making maps takes time in proportion to the triangles.

use std::collections::HashMap;

use lt_bvh::Triangle;
use lt_math::glam::{UVec2, Vec2};
use lt_shaders::abi::{Material, Vertex};
use lt_shaders::surface::corners_of;
use lt_shaders::texture::unorm_byte;
use rayon::prelude::*;

/// Least and largest cells to a side; powers of two, so that a hit's cell is found without rounding.
const SIDES: [u32; 2] = [4, 256];
/// Texels to a cell's side, where there are cells enough.
const CELL_TEXELS: f32 = 1.0;
/// Cells per triangle that shares a map.
const CELLS_PER_TRIANGLE: usize = 32;
/// Cells that touch more texels than this are mixed without a look.
const MOST_TEXELS: i64 = 1024;
/// Words of all maps together; triangles whose map would come after have none.
const MOST_WORDS: usize = 1 << 24;
/// Largest magnitude of a texture coordinate that is mapped.
const COORDINATE_LIMIT: f32 = 4096.0;
/// Margin of texture coordinates in units of their magnitudes, and of alpha: over eight roundings each.
const MARGIN: f64 = 1e-6;

const CLEAR: u32 = 1;
const OPAQUE: u32 = 2;

/// Cells to a word, two bits each.
const PER_WORD: u32 = 16;
/// Bits of a place that hold log₂ of the side; the first word lies above.
const SIDE_BITS: u32 = 4;
/// Place of a triangle without a map.
const NOWHERE: u32 = 0;

/// The maps of a scene's triangles.
#[derive(Clone, Debug, Default)]
pub struct OpacityMaps {
    /// By triangle: first word and log₂ of the side; [`NOWHERE`] for none.
    places: Vec<u32>,
    words: Vec<u32>,
}

/// What makes two triangles the same to the alpha test.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Key {
    /// u and v of the three vertices, as bits.
    coordinates: [[u32; 2]; 3],
    alphas: [u8; 3],
    material: u32,
}

/// Some of the triangles, each with the number of its key among those that they have; 0 is none.
struct Numbered {
    numbers: Vec<u32>,
    /// Keys, and how many of the triangles have them.
    found: Vec<(Key, usize)>,
}

impl OpacityMaps {
    /// Maps for the triangles that ask the alpha test, in the order of `triangles`. Surfaces that do not cast have none.
    pub(super) fn new(
        triangles: &[Triangle],
        vertices: &[Vertex],
        materials: &[Material],
        alpha_texels: &[u32],
    ) -> Self {
        /// Triangles to a task.
        const TASK: usize = 1 << 14;
        let tasks: Vec<Numbered> = triangles
            .par_chunks(TASK)
            .map(|triangles| {
                let mut numbers: HashMap<Key, u32> = HashMap::new();
                let mut found: Vec<(Key, usize)> = Vec::new();
                let number = |triangle: &Triangle| {
                    let Some(key) = Key::of(triangle, vertices, materials) else { return 0 };
                    let number = *numbers.entry(key).or_insert_with(|| {
                        found.push((key, 0));
                        found.len() as u32
                    });
                    found[number as usize - 1].1 += 1;
                    number
                };
                let numbered = triangles.iter().map(number).collect();
                Numbered { numbers: numbered, found }
            })
            .collect();
        let mut index: HashMap<Key, usize> = HashMap::new();
        let mut keys: Vec<(Key, usize)> = Vec::new();
        for (key, count) in tasks.iter().flat_map(|task| &task.found) {
            let at = *index.entry(*key).or_insert_with(|| {
                keys.push((*key, 0));
                keys.len() - 1
            });
            keys[at].1 += count;
        }
        let maps: Vec<_> = keys
            .par_iter()
            .map(|(key, count)| {
                let sheet = Sheet::new(key, &materials[key.material as usize], alpha_texels)?;
                let side = sheet.side(*count)?;
                Some((side.ilog2(), sheet.cells(side)))
            })
            .collect();
        // Word 0 is nobody's.
        let mut words = vec![0];
        let places: Vec<u32> = maps
            .into_iter()
            .map(|map| match map {
                Some((log, cells)) if words.len() + cells.len() <= MOST_WORDS => {
                    let place = (words.len() as u32) << SIDE_BITS | log;
                    words.extend(cells);
                    place
                }
                _ => NOWHERE,
            })
            .collect();
        let places = tasks
            .par_iter()
            .flat_map_iter(|task| {
                let of_task: Vec<u32> = task.found.iter().map(|(key, _)| places[index[key]]).collect();
                task.numbers.iter().map(move |n| n.checked_sub(1).map_or(NOWHERE, |n| of_task[n as usize]))
            })
            .collect();
        OpacityMaps { places, words }
    }

    /// What the alpha test says of a hit at barycentric `u` and `v`, where the triangle's map knows it.
    #[inline]
    pub fn verdict(&self, triangle: u32, u: f32, v: f32) -> Option<bool> {
        self.of(triangle).and_then(|map| map.verdict(map.cell(u, v)))
    }

    /// The map of a triangle, if it has one.
    #[inline]
    pub(super) fn of(&self, triangle: u32) -> Option<OpacityMap<'_>> {
        let place = self.places[triangle as usize];
        (place != NOWHERE).then(|| OpacityMap {
            log: place & ((1 << SIDE_BITS) - 1),
            words: &self.words[(place >> SIDE_BITS) as usize..],
        })
    }
}

/// What the alpha test says of the cells of one triangle.
#[derive(Clone, Copy)]
pub(super) struct OpacityMap<'a> {
    /// log₂ of the cells to a side.
    log: u32,
    /// Its words, and others' after them.
    words: &'a [u32],
}

impl OpacityMap<'_> {
    /// The cell that holds a hit at barycentric `u` and `v` in the triangle.
    #[inline(always)]
    pub(super) fn cell(&self, u: f32, v: f32) -> u32 {
        let side = 1u32 << self.log;
        let at = |weight: f32| ((weight * side as f32) as u32).min(side - 1);
        at(v) << self.log | at(u)
    }

    /// Whether hits in a cell cover, where the map knows it.
    #[inline(always)]
    pub(super) fn verdict(&self, cell: u32) -> Option<bool> {
        let word = self.words[(cell / PER_WORD) as usize];
        match word >> (cell % PER_WORD * 2) & 3 {
            OPAQUE => Some(true),
            CLEAR => Some(false),
            _ => None,
        }
    }
}

impl Key {
    /// `None` for a triangle that does not ask, or that does not cast.
    fn of(triangle: &Triangle, vertices: &[Vertex], materials: &[Material]) -> Option<Self> {
        if triangle.is_opaque() {
            return None;
        }
        let corners = corners_of(triangle, vertices);
        let material = corners[0].material;
        let casts = materials[material as usize].flags & Material::CASTS != 0;
        casts.then(|| Key {
            coordinates: corners.map(|c| [c.u.to_bits(), c.v.to_bits()]),
            alphas: corners.map(|c| (c.color >> 24) as u8),
            material,
        })
    }
}

/// A triangle's texture and alphas over its barycentric square.
struct Sheet<'a> {
    material: &'a Material,
    texels: &'a [u32],
    /// Texture coordinates of the corners and how much they and sums of them may be off.
    coordinates: [Vec2; 3],
    margin: [f64; 2],
    alphas: [u8; 3],
    size: UVec2,
}

impl<'a> Sheet<'a> {
    /// `None` where numbers are such that no verdict would be safe.
    fn new(key: &Key, material: &'a Material, texels: &'a [u32]) -> Option<Self> {
        let coordinates = key.coordinates.map(|[u, v]| Vec2::new(f32::from_bits(u), f32::from_bits(v)));
        let is_usable = coordinates.iter().all(|c| c.is_finite() && c.abs().max_element() < COORDINATE_LIMIT)
            && material.base_color.w >= 0.0
            && material.base_color.w.is_finite();
        let sum = |axis: usize| coordinates.iter().map(|c| f64::from(c[axis].abs())).sum::<f64>();
        let margin = [MARGIN * (1.0 + sum(0)), MARGIN * (1.0 + sum(1))];
        let size = UVec2::new(material.alpha_size & 0xffff, material.alpha_size >> 16);
        is_usable.then_some(Sheet { material, texels, coordinates, margin, alphas: key.alphas, size })
    }

    /// Cells to a side for a map that `count` triangles share; `None` if that is too few to be of use.
    fn side(&self, count: usize) -> Option<u32> {
        let [a, b, c] = self.coordinates;
        let extent = (b - a).abs().max((c - a).abs()).max((c - b).abs()) * self.size.as_vec2();
        let wanted = (extent.max_element() / CELL_TEXELS).ceil() as u32;
        let paid_for = (count * CELLS_PER_TRIANGLE).isqrt() as u32;
        let [least, most] = SIDES;
        let side = wanted.next_power_of_two().clamp(least, most);
        let side = side.min(1 << paid_for.ilog2());
        (side >= least).then_some(side)
    }

    fn cells(&self, side: u32) -> Vec<u32> {
        let mut words = vec![0; (side * side).div_ceil(PER_WORD) as usize];
        for cell in 0..side * side {
            let (i, j) = (cell % side, cell / side);
            // Beyond the third edge nothing is hit but by rounding.
            if i + j < side {
                words[(cell / PER_WORD) as usize] |= self.verdict(i, j, side) << (cell % PER_WORD * 2);
            }
        }
        words
    }

    fn verdict(&self, i: u32, j: u32, side: u32) -> u32 {
        let at = |i: u32| f64::from(i) / f64::from(side);
        let corners = [(at(i), at(j)), (at(i + 1), at(j)), (at(i), at(j + 1)), (at(i + 1), at(j + 1))];
        // The fourth corner of a cell that the third edge cuts lies beyond it.
        let corners = &corners[..if i + j + 1 == side { 3 } else { 4 }];
        let range = |values: [f64; 3]| {
            let blended =
                corners.iter().map(|(u, v)| values[0] * (1.0 - u - v) + values[1] * u + values[2] * v);
            blended.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let [mut least, mut most] = range(self.alphas.map(|a| f64::from(a) / 255.0));
        if self.material.alpha_size != 0 {
            let axis = |axis: usize| {
                let [low, high] = range(self.coordinates.map(|c| f64::from(c[axis])));
                let size = f64::from(self.size[axis]);
                let first = ((low - self.margin[axis]) * size - 0.5).floor() as i64;
                let last = ((high + self.margin[axis]) * size - 0.5).floor() as i64 + 1;
                (first, last)
            };
            let (columns, rows) = (axis(0), axis(1));
            if (columns.1 - columns.0 + 1) * (rows.1 - rows.0 + 1) > MOST_TEXELS {
                return 0;
            }
            let [low, high] = self.texel_range(columns, rows);
            (least, most) = (least * low, most * high);
        }
        let scale = f64::from(self.material.base_color.w);
        let cutoff = f64::from(self.material.cutoff);
        let margin = 8.0 * MARGIN * (scale + cutoff.abs());
        if cutoff <= 0.0 || least * scale - margin >= cutoff {
            OPAQUE
        } else if most * scale + margin < cutoff {
            CLEAR
        } else {
            0
        }
    }

    /// The least and largest of some texels, as fractions; counted on past the texture's edges.
    fn texel_range(&self, columns: (i64, i64), rows: (i64, i64)) -> [f64; 2] {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for y in rows.0..=rows.1 {
            let row = wrapped(y, self.size.y, self.material.flags >> Material::WRAP_V_SHIFT & 3);
            for x in columns.0..=columns.1 {
                let column = wrapped(x, self.size.x, self.material.flags >> Material::WRAP_U_SHIFT & 3);
                let index = self.material.alpha_offset + row * self.size.x + column;
                let value = f64::from(unorm_byte(self.texels, index));
                range = [range[0].min(value), range[1].max(value)];
            }
        }
        range
    }
}

/// The texel that is meant by one counted on past the edges.
fn wrapped(texel: i64, size: u32, wrap: u32) -> u32 {
    let size = i64::from(size);
    let within = if wrap == Material::REPEAT {
        texel.rem_euclid(size)
    } else if wrap == Material::MIRROR {
        let at = texel.rem_euclid(2 * size);
        if at < size { at } else { 2 * size - 1 - at }
    } else {
        texel.clamp(0, size - 1)
    };
    within as u32
}

#[cfg(test)]
mod tests {
    use lt_bvh::AnyHit;
    use lt_math::glam::Vec4;
    use lt_scene::Source;
    use lt_shaders::surface::Coverage;

    use super::*;
    use crate::PackedScene;

    /// Cells of all triangles, and what the texture says at their corners and middles, of hits in the triangle.
    #[test]
    fn verdicts_are_those_of_the_texture() {
        for name in ["fence", "square"] {
            let packed = PackedScene::new(&Source::open(name, 1).unwrap().pose(0.0).unwrap()).unwrap();
            let covers = packed.coverage(Material::CASTS);
            let (mut known, mut asked) = (0, 0);
            let asking = packed.triangles().iter().enumerate().filter(|(_, t)| !t.is_opaque());
            for (triangle, _) in asking.step_by(997) {
                for step in 0..=513 * 513u32 {
                    let (u, v) = ((step % 513) as f32 / 512.0, (step / 513) as f32 / 512.0);
                    if u + v > 1.0 || step % 7 != triangle as u32 % 7 {
                        continue;
                    }
                    asked += 1;
                    let verdict = covers.maps.verdict(triangle as u32, u, v);
                    known += usize::from(verdict.is_some());
                    let truth = covers.coverage.accepts(triangle as u32, u, v);
                    assert!(verdict.is_none_or(|v| v == truth), "{name}: triangle {triangle} at {u}, {v}");
                }
            }
            assert!(asked > 0 && known * 10 > asked * 7, "{name}: {known} of {asked} are known");
        }
    }

    /// Wrapping, mirroring, clamping; the corners lie far outside and on seams.
    #[test]
    fn verdicts_hold_across_the_edges_of_a_texture() {
        let texels = [0xff00_00ff, 0x00ff_ff00, 0xffff_0000, 0x80ff_7f00];
        let mut mixed = 0;
        for wrap in [Material::REPEAT, Material::MIRROR, Material::CLAMP] {
            for nearest in [0, Material::NEAREST] {
                let material = Material {
                    base_color: Vec4::ONE,
                    cutoff: 0.5,
                    alpha_size: 4 | 4 << 16,
                    flags: Material::CASTS
                        | wrap << Material::WRAP_U_SHIFT
                        | wrap << Material::WRAP_V_SHIFT
                        | nearest,
                    ..Material::default()
                };
                for (i, corners) in [
                    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
                    [[-1.5, 0.25], [0.5, -2.0], [3.0, 1.0]],
                    [[100.125, -7.0], [101.125, -7.0], [100.125, -6.5]],
                    [[0.3, 0.3], [0.31, 0.3], [0.3, 0.32]],
                ]
                .into_iter()
                .enumerate()
                {
                    let vertices: Vec<Vertex> = corners
                        .iter()
                        .map(|&[u, v]| Vertex { u, v, color: 0xffff_ffff, ..Vertex::default() })
                        .collect();
                    let triangle = Triangle { i0: Triangle::NON_OPAQUE, i1: 1, i2: 2, ..Triangle::default() };
                    let triangles = vec![triangle; 600];
                    let maps = OpacityMaps::new(&triangles, &vertices, &[material], &texels);
                    let coverage = Coverage {
                        triangles: &triangles,
                        vertices: &vertices,
                        materials: &[material],
                        alpha_texels: &texels,
                        required_flags: Material::CASTS,
                    };
                    for step in 0..=1000 * 1000u32 {
                        let (u, v) = ((step % 1001) as f32 / 1000.0, (step / 1001) as f32 / 1000.0);
                        if u + v > 1.0 {
                            continue;
                        }
                        match maps.verdict(599, u, v) {
                            Some(verdict) => {
                                let truth = coverage.accepts(599, u, v);
                                assert_eq!(verdict, truth, "wrap {wrap}, corners {i}, at {u}, {v}");
                            }
                            None => mixed += 1,
                        }
                    }
                }
            }
        }
        assert!(mixed > 0);
    }

    #[test]
    fn odd_numbers_have_no_map() {
        let nan = Vertex { u: f32::NAN, ..Vertex::default() };
        let triangle = Triangle { i0: Triangle::NON_OPAQUE, ..Triangle::default() };
        let casts = Material { flags: Material::CASTS, cutoff: 0.5, ..Material::default() };
        let silent = Material { flags: 0, ..casts };
        let verdict = |vertex, material: Material| {
            OpacityMaps::new(&[triangle], &[vertex], &[material], &[]).verdict(0, 0.25, 0.25)
        };
        assert_eq!(verdict(nan, casts), None);
        assert_eq!(verdict(Vertex::default(), silent), None);
        assert_eq!(verdict(Vertex::default(), casts), Some(false), "vertex alpha is 0");
    }
}
