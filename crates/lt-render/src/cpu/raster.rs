//! Depth maps in software: the coverage rule of graphics hardware (corners snapped to 1/256 texel, top-left rule,
//! texel centres), the map cut into bands that threads own, holes cut by the alpha test.

use lt_bvh::Triangle;
use lt_math::glam::{Vec2, Vec3, Vec4, Vec4Swizzles};
use lt_shaders::abi::{DepthParams, Material, Vertex};
use lt_shaders::depth::{corner, map_position, placed_corner, weights_at};
use lt_shaders::surface::{blocks, corners_of};
use rayon::prelude::*;
use std::ops::Range;

use super::perspective::{self, Polygon};
use super::surface::{DepthPlane, LANES, Perspective, Surface};
use crate::{PackedScene, packed::DrawRange};

/// Steps per texel that corners are snapped to; every Vulkan driver offers at least 4 bits, most have 8.
const SUBTEXEL: f32 = 256.0;
/// Rows a thread owns.
const BAND: usize = 64;
/// Triangles sorted into bands at a time, so that the lists stay small however large the scene.
const BATCH: u32 = 1 << 18;
/// Triangles one thread prepares at a time.
const PREPARE: u32 = 1 << 12;
/// Depths one thread clears at a time.
const CLEAR: usize = 1 << 16;
/// Layers of depth that triangles with holes are sorted into.
const LAYERS: usize = 1024;
/// Corners farther out than this many texels are clamped, which keeps edge functions inside 63 bits.
const GUARD_TEXELS: f32 = 1.0e6;

/// A triangle ready to be drawn.
#[derive(Clone, Copy)]
struct Prepared {
    /// The triangle's corners in homogeneous texels; z is the depth.
    corners: [Vec4; 3],
    /// The same, snapped, in counter-clockwise order on a y-down map.
    snapped: [[i32; 2]; 3],
    triangle: u32,
    has_holes: bool,
    /// Depth is not linear on the map.
    is_perspective: bool,
}

/// Empties a map: 1 everywhere.
pub fn clear(map: &mut [f32]) {
    map.par_chunks_mut(CLEAR).for_each(|part| part.fill(1.0));
}

/// Draws casters into `map`: `map_size²` depths, row by row, each of which keeps the least that fell on it. Returns the
/// rows that may have changed.
pub fn draw_depths(
    scene: &PackedScene,
    draws: &[DrawRange],
    p: &DepthParams,
    map: &mut [f32],
) -> Range<usize> {
    let seen: Vec<DrawRange> = draws.iter().filter(|draw| may_appear(scene, p, draw)).copied().collect();
    batches(&seen).iter().map(|batch| draw_batch(scene, p, batch, map)).fold(0..0, joined)
}

/// The least range that holds both; an empty one counts for nothing.
fn joined(a: Range<usize>, b: Range<usize>) -> Range<usize> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b,
        (_, true) => a,
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}

/// Whether any of a draw may fall on the map, by the box of its instance; without instances anything may.
fn may_appear(scene: &PackedScene, p: &DepthParams, draw: &DrawRange) -> bool {
    let Some(instance) = scene.instances().get(draw.instance as usize) else { return true };
    let (low, high) = (instance.low_world, instance.high_world);
    let corners: [Vec4; 8] = std::array::from_fn(|i| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
        map_position(&p.projection, Vec3::new(pick(0), pick(1), pick(2)), p.map_size)
    });
    // A texel of margin for rounding. Comparisons are false for NaN, which keeps the draw.
    let size = p.map_size as f32;
    let is_beyond = |beyond: &dyn Fn(Vec4) -> bool| corners.iter().all(|&c| beyond(c));
    // Homogeneous half-spaces: they hold behind the light, too.
    !(is_beyond(&|c| c.x < -c.w)
        || is_beyond(&|c| c.y < -c.w)
        || is_beyond(&|c| c.x > (size + 1.0) * c.w)
        || is_beyond(&|c| c.y > (size + 1.0) * c.w)
        || is_beyond(&|c| c.w <= 0.0)
        || is_beyond(&|c| c.z > 1.0 + 1e-3))
}

/// Cuts and joins draws into lists of about [`BATCH`] triangles.
fn batches(draws: &[DrawRange]) -> Vec<Vec<DrawRange>> {
    let mut batches = vec![Vec::new()];
    let mut room = BATCH;
    for draw in draws {
        let (mut first, end) = (draw.first_triangle, draw.first_triangle + draw.triangles);
        while first < end {
            let triangles = (end - first).min(room).min(PREPARE);
            if let Some(batch) = batches.last_mut() {
                batch.push(DrawRange { first_triangle: first, triangles, ..*draw });
            }
            first += triangles;
            room -= triangles;
            if room == 0 {
                batches.push(Vec::new());
                room = BATCH;
            }
        }
    }
    batches
}

/// Triangles that one thread prepared, and which of them each band of rows meets.
struct Piece {
    triangles: Vec<Prepared>,
    bands: Vec<Vec<u32>>,
    rows: Range<usize>,
}

impl Piece {
    fn of(scene: &PackedScene, p: &DepthParams, draw: &DrawRange) -> Self {
        let size = p.map_size as usize;
        let range = draw.first_triangle..draw.first_triangle + draw.triangles;
        let mut piece =
            Self { triangles: Vec::new(), bands: vec![Vec::new(); size.div_ceil(BAND)], rows: 0..0 };
        for i in range {
            for t in prepare(scene, p, draw, i, &scene.triangles()[i as usize]) {
                let (low, high) = rows_of(&t, size);
                for band in &mut piece.bands[low / BAND..high.div_ceil(BAND)] {
                    band.push(piece.triangles.len() as u32);
                }
                piece.rows = joined(piece.rows, low..high);
                piece.triangles.push(t);
            }
        }
        piece
    }
}

fn draw_batch(scene: &PackedScene, p: &DepthParams, draws: &[DrawRange], map: &mut [f32]) -> Range<usize> {
    let size = p.map_size as usize;
    // One by one: on two threads rayon's own shares are quarters, and a thread that is done waits for the other's last.
    let pieces: Vec<Piece> = draws.par_iter().with_max_len(1).map(|draw| Piece::of(scene, p, draw)).collect();
    let has_holes = draws.iter().any(|d| d.has_holes);
    map.par_chunks_mut(BAND * size).with_max_len(1).enumerate().for_each(|(band, rows)| {
        let members = pieces.iter().flat_map(|p| p.bands[band].iter().map(|&i| &p.triangles[i as usize]));
        let mut draw = |t: &Prepared| draw_triangle(scene, t, band * BAND, size, rows);
        // Nearest first where casters have holes: what lies behind then fails the depth test before it costs an alpha
        // test. The map is the same in any order.
        match has_holes {
            true => nearest_first(members.collect()).into_iter().for_each(&mut draw),
            false => members.for_each(&mut draw),
        }
    });
    pieces.into_iter().map(|p| p.rows).fold(0..0, joined)
}

/// Sorts by the least depth, as finely as [`LAYERS`] tell: a counting sort.
fn nearest_first(members: Vec<&Prepared>) -> Vec<&Prepared> {
    let layer = |t: &Prepared| (t.nearest() * LAYERS as f32) as usize;
    let mut ends = [0; LAYERS + 1];
    members.iter().for_each(|t| ends[layer(t)] += 1);
    let mut total = 0;
    for end in &mut ends {
        total += *end;
        *end = total;
    }
    let mut sorted = members.clone();
    for t in members {
        let end = &mut ends[layer(t)];
        *end -= 1;
        sorted[*end] = t;
    }
    sorted
}

fn prepare(scene: &PackedScene, p: &DepthParams, draw: &DrawRange, index: u32, t: &Triangle) -> Parts {
    let world = |i: u32| match scene.instances() {
        [] => corner(t, i),
        placed => placed_corner(t, i, &placed[draw.instance as usize]),
    };
    let corners = [0, 1, 2].map(|i| map_position(&p.projection, world(i), p.map_size));
    if corners.iter().all(|c| c.z >= 1.0) {
        return Parts::None;
    }
    let has_holes = draw.has_holes && !t.is_opaque();
    let is_perspective = p.near > 0.0;
    let part = |at: [Vec2; 3]| {
        let snapped = placed(at, p.map_size as usize)?;
        Some(Prepared { corners, snapped, triangle: index, has_holes, is_perspective })
    };
    if !is_perspective {
        return Parts::One(part(corners.map(|c| c.xy())));
    }
    match perspective::cut(&corners, p.near, p.map_size as f32) {
        Polygon::Whole(at) => Parts::One(part(at)),
        Polygon::Cut(at) => {
            let fan = (2..at.len()).filter_map(|i| part([at[0], at[i - 1], at[i]]));
            Parts::Many(fan.collect::<Vec<_>>().into_iter())
        }
    }
}

/// Corners snapped and in order; `None` if they cover no texel.
fn placed(at: [Vec2; 3], size: usize) -> Option<[[i32; 2]; 3]> {
    let mut snapped = at.map(|c| [snap(c.x), snap(c.y)]);
    let area = edge(snapped[0], snapped[1], snapped[2]);
    if area == 0 {
        return None;
    }
    if area < 0 {
        snapped.swap(1, 2);
    }
    let is_on_map = [0, 1].iter().all(|&axis| {
        let (low, high) = span(snapped.map(|c| c[axis]), size);
        low < high
    });
    is_on_map.then_some(snapped)
}

/// A coordinate in texels as a whole number of subtexels, ties to even.
fn snap(x: f32) -> i32 {
    let scaled = x.clamp(-GUARD_TEXELS, GUARD_TEXELS) * SUBTEXEL;
    // Adding 1.5·2⁵² rounds an f64 to a whole number without a call.
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    ((f64::from(scaled) + ROUNDER) - ROUNDER) as i32
}

/// What a triangle leaves to be drawn.
enum Parts {
    None,
    One(Option<Prepared>),
    Many(std::vec::IntoIter<Prepared>),
}

impl Iterator for Parts {
    type Item = Prepared;
    fn next(&mut self) -> Option<Prepared> {
        match self {
            Self::None => None,
            Self::One(part) => part.take(),
            Self::Many(parts) => parts.next(),
        }
    }
}

impl Prepared {
    /// The least depth of a corner, in [0, 1].
    fn nearest(&self) -> f32 {
        self.corners.iter().fold(1.0, |least: f32, c| least.min(c.z)).max(0.0)
    }
}

/// Twice the signed area of a triangle of snapped points.
fn edge(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i64 {
    let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// First and one past the last texel row whose centres the triangle may cover.
fn rows_of(t: &Prepared, size: usize) -> (usize, usize) {
    span(t.snapped.map(|c| c[1]), size)
}

/// First and one past the last texel whose centre lies between the least and the greatest of three snapped numbers.
fn span(at: [i32; 3], size: usize) -> (usize, usize) {
    let (low, high) = (at[0].min(at[1]).min(at[2]), at[0].max(at[1]).max(at[2]));
    // A centre lies at 256·i + 128.
    let first = (low + 127) >> 8;
    let last = ((high - 128) >> 8) + 1;
    let clamp = |x: i32| x.clamp(0, size as i32) as usize;
    (clamp(first), clamp(last))
}

/// A line whose left side (≥ 0) is inside: `dx · x + dy · y + at ≥ 0` with x, y in texels.
#[derive(Clone, Copy)]
struct Edge {
    dx: i64,
    dy: i64,
    at: i64,
}

impl Edge {
    /// From a to b, evaluated at texel centres, with the top-left rule as an offset of one unit.
    fn new(a: [i32; 2], b: [i32; 2]) -> Self {
        let [a, b] = [a, b].map(|p| p.map(i64::from));
        let (dx, dy) = (-(b[1] - a[1]), b[0] - a[0]);
        // y points down and the inside is to the right of an edge that goes up.
        let is_top_left = dx > 0 || (dx == 0 && dy > 0);
        let constant = -(dx * a[0] + dy * a[1]) + 128 * (dx + dy);
        Self { dx: dx * 256, dy: dy * 256, at: constant - i64::from(!is_top_left) }
    }

    /// Narrows [low, high) to the columns of a row that lie inside.
    fn narrow(&self, row: i64, low: &mut i64, high: &mut i64) {
        let value = self.dy * row + self.at;
        if self.dx > 0 {
            // dx · x + value ≥ 0 ⇔ x ≥ −value / dx, rounded up.
            *low = (*low).max(-value.div_euclid(self.dx));
        } else if self.dx < 0 {
            *high = (*high).min(value.div_euclid(-self.dx) + 1);
        } else if value < 0 {
            *high = *low;
        }
    }
}

fn draw_triangle(scene: &PackedScene, t: &Prepared, first_row: usize, size: usize, rows: &mut [f32]) {
    match t.is_perspective {
        false => {
            let plane = DepthPlane::through(&t.corners.map(|c| c.truncate()));
            draw_surface(scene, t, &plane, first_row, size, rows);
        }
        true => draw_surface(scene, t, &Perspective(&t.corners), first_row, size, rows),
    }
}

fn draw_surface(
    scene: &PackedScene,
    t: &Prepared,
    surface: &impl Surface,
    first_row: usize,
    size: usize,
    rows: &mut [f32],
) {
    let s = t.snapped;
    let edges = [Edge::new(s[0], s[1]), Edge::new(s[1], s[2]), Edge::new(s[2], s[0])];
    let (low_row, high_row) = rows_of(t, size);
    let (low_column, high_column) = span(s.map(|c| c[0]), size);
    let holes = t.has_holes.then(|| Holes::of(scene, t));
    for row in low_row.max(first_row)..high_row.min(first_row + rows.len() / size) {
        let (mut low, mut high) = (low_column as i64, high_column as i64);
        for e in &edges {
            e.narrow(row as i64, &mut low, &mut high);
        }
        if low >= high {
            continue;
        }
        let depths = &mut rows[(row - first_row) * size..][low as usize..high as usize];
        let y = row as f32 + 0.5;
        for (group, stored) in depths.chunks_mut(LANES).enumerate() {
            let first = low as usize + group * LANES;
            match &holes {
                None => surface.draw(first, y, stored),
                Some(holes) => surface.draw_where(first, y, stored, |centre| holes.is_covered(t, centre)),
            }
        }
    }
}

/// The alpha test of one triangle.
struct Holes<'a> {
    corners: [Vertex; 3],
    material: &'a Material,
    alpha_texels: &'a [u32],
}

impl<'a> Holes<'a> {
    fn of(scene: &'a PackedScene, t: &Prepared) -> Self {
        let corners = corners_of(&scene.triangles()[t.triangle as usize], scene.vertices());
        let material = &scene.materials()[corners[0].material as usize];
        Self { corners, material, alpha_texels: scene.alpha_texels() }
    }

    fn is_covered(&self, t: &Prepared, centre: Vec2) -> bool {
        blocks(self.material, &self.corners, weights_at(centre, &t.corners), self.alpha_texels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(corners: [[f32; 2]; 3], size: usize) -> Vec<bool> {
        let corners = corners.map(|c| Vec4::new(c[0], c[1], 0.5, 1.0));
        let mut snapped = corners.map(|c| [snap(c.x), snap(c.y)]);
        if edge(snapped[0], snapped[1], snapped[2]) < 0 {
            snapped.swap(1, 2);
        }
        let t = Prepared { corners, snapped, triangle: 0, has_holes: false, is_perspective: false };
        let edges = [
            Edge::new(snapped[0], snapped[1]),
            Edge::new(snapped[1], snapped[2]),
            Edge::new(snapped[2], snapped[0]),
        ];
        let mut out = vec![false; size * size];
        let (low_row, high_row) = rows_of(&t, size);
        for row in low_row..high_row {
            let (low, high) = span(snapped.map(|c| c[0]), size);
            let (mut low, mut high) = (low as i64, high as i64);
            edges.iter().for_each(|e| e.narrow(row as i64, &mut low, &mut high));
            for column in low..high {
                out[row * size + column as usize] = true;
            }
        }
        out
    }

    #[test]
    fn a_shared_edge_is_drawn_exactly_once() {
        // Two triangles of a square whose diagonal and sides run through texel centres.
        let a = covered([[0.5, 0.5], [4.5, 0.5], [4.5, 4.5]], 8);
        let b = covered([[0.5, 0.5], [4.5, 4.5], [0.5, 4.5]], 8);
        for (i, (in_a, in_b)) in a.iter().zip(&b).enumerate() {
            let (x, y) = (i % 8, i / 8);
            assert!(!(*in_a && *in_b), "{x},{y} twice");
            assert_eq!(*in_a || *in_b, x < 4 && y < 4, "{x},{y}: top and left edges belong, others do not");
        }
    }

    #[test]
    fn coverage_agrees_with_edge_signs_on_random_triangles() {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1664525).wrapping_add(1013904223);
            (state >> 8) as f32 / 65536.0 / 8.0 - 8.0
        };
        for _ in 0..2000 {
            let c: [[f32; 2]; 3] = std::array::from_fn(|_| [next(), next()]);
            let mask = covered(c, 16);
            for (i, is_in) in mask.iter().enumerate() {
                let p = [i as f64 % 16.0 + 0.5, (i / 16) as f64 + 0.5];
                let d = |a: [f32; 2], b: [f32; 2]| {
                    let q = |x: f32| (f64::from(x) * 256.0).round_ties_even() / 256.0;
                    (q(b[0]) - q(a[0])) * (p[1] - q(a[1])) - (q(b[1]) - q(a[1])) * (p[0] - q(a[0]))
                };
                let s = [d(c[0], c[1]), d(c[1], c[2]), d(c[2], c[0])];
                let strictly = s.iter().all(|x| *x > 0.0) || s.iter().all(|x| *x < 0.0);
                let outside = s.iter().any(|x| *x > 0.0) && s.iter().any(|x| *x < 0.0);
                assert!(!strictly || *is_in);
                assert!(!outside || !*is_in);
            }
        }
    }
}
