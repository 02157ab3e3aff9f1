//! Depth maps in software: the coverage rule of graphics hardware (corners snapped to 1/256 texel, top-left rule,
//! texel centres), the map cut into bands that threads own, holes cut by the alpha test.

use lt_bvh::Triangle;
use lt_bvh::lanes::{Chosen, NodeLanes, Work};
use lt_math::glam::{Vec2, Vec4, Vec4Swizzles};
use lt_shaders::abi::{DepthParams, Material};
use lt_shaders::depth::{corner, map_position, placed_corner};
use rayon::prelude::*;
use std::iter;
use std::ops::Range;

use super::fill::{Band, Prepared, placed, rows_of};
use super::map_tiles::SIDE;
use super::perspective::{self, Polygon};
use crate::{PackedScene, packed::DrawRange};

/// Rows a thread owns, of whole tiles.
const BAND: usize = 64;
/// Triangles sorted into bands at a time, so that the lists stay small however large the scene.
const BATCH: u32 = 1 << 18;
/// Triangles one thread prepares at a time.
const PREPARE: u32 = 1 << 12;
/// Layers of depth that triangles with holes are sorted into.
const LAYERS: usize = 1024;

/// What casters are drawn over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Nothing: depths are 1.
    Empty,
    /// What the map holds.
    Kept,
}

/// Draws casters into `map`: `map_size²` depths, in [tiles](super::map_tiles), each of which keeps the least that fell on it. Returns
/// the rows on which any may have fallen, of whole tiles.
pub fn draw_depths(
    scene: &PackedScene,
    draws: &[DrawRange],
    p: &DepthParams,
    ground: Ground,
    map: &mut [f32],
) -> Range<usize> {
    let grounds = iter::once(ground).chain(iter::repeat(Ground::Kept));
    let batches = batches(&scene.visible_draws(draws, p));
    let drawn = batches.iter().zip(grounds).map(|(batch, ground)| draw_batch(scene, p, batch, ground, map));
    drawn.fold(0..0, joined)
}

/// The least range that holds both; an empty one counts for nothing.
fn joined(a: Range<usize>, b: Range<usize>) -> Range<usize> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b,
        (_, true) => a,
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}

/// Cuts and joins draws into lists of about [`BATCH`] triangles, at least one.
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

/// Prepares a draw's triangles.
struct Prepare<'a> {
    scene: &'a PackedScene,
    p: &'a DepthParams,
    draw: &'a DrawRange,
}

impl Work for Prepare<'_> {
    type Output = Piece;
    #[inline(always)]
    fn run<L: NodeLanes>(self, _: L) -> Piece {
        let Self { scene, p, draw } = self;
        let size = p.map_size as usize;
        let range = draw.first_triangle..draw.first_triangle + draw.triangles;
        let mut piece =
            Piece { triangles: Vec::new(), bands: vec![Vec::new(); size.div_ceil(BAND)], rows: 0..0 };
        for i in range {
            for t in prepare(scene, p, draw, i, &scene.triangles()[i as usize]) {
                let (low, high) = rows_of(&t, size);
                for band in &mut piece.bands[low / BAND..high.div_ceil(BAND)] {
                    band.push(piece.triangles.len() as u32);
                }
                piece.rows = joined(piece.rows, low / SIDE * SIDE..high.next_multiple_of(SIDE));
                piece.triangles.push(t);
            }
        }
        piece
    }
}

fn draw_batch(
    scene: &PackedScene,
    p: &DepthParams,
    draws: &[DrawRange],
    ground: Ground,
    map: &mut [f32],
) -> Range<usize> {
    let size = p.map_size as usize;
    // One by one: on two threads rayon's own shares are quarters, and a thread that is done waits for the other's last.
    let pieces: Vec<Piece> =
        draws.par_iter().with_max_len(1).map(|draw| Chosen::best().run(Prepare { scene, p, draw })).collect();
    let coverage = draws.iter().any(|d| d.has_holes).then(|| scene.coverage(Material::CASTS));
    map.par_chunks_mut(BAND * size).with_max_len(1).enumerate().for_each(|(band, rows)| {
        let members = pieces.iter().flat_map(|p| p.bands[band].iter().map(|&i| &p.triangles[i as usize]));
        let mut triangles: Vec<&Prepared> = members.collect();
        if ground == Ground::Empty {
            rows.fill(1.0);
        }
        // Nearest first where casters have holes: what lies behind then fails the depth test before it costs an alpha
        // test. The map is the same in any order.
        if coverage.is_some() {
            triangles = nearest_first(triangles);
        }
        Chosen::best().run(Band { coverage, first_row: band * BAND, size, rows, triangles: &triangles });
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

#[inline(always)]
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
    // Up to half of what culling leaves lies beside a fine level; on a lamp's map that is left to the cut.
    let size = p.map_size as f32;
    let is_beside =
        |of: fn(&Vec4) -> f32| corners.iter().all(|c| of(c) < 0.0) || corners.iter().all(|c| of(c) > size);
    if !is_perspective && (is_beside(|c| c.x) || is_beside(|c| c.y)) {
        return Parts::None;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::glam::Vec3;
    use lt_math::{LightFrame, LightProjection};

    /// Suns and lamps that see a part of the scene only.
    #[test]
    fn what_no_map_sees_leaves_nothing_to_draw() {
        let (mut left_out, mut drawn) = (0, 0);
        for name in ["town", "street:4", "random:20000"] {
            let posed = lt_scene::Source::open(name, 1).and_then(|s| s.pose(0.0)).expect("a scene");
            let scene = PackedScene::new(&posed).expect("packs");
            let bounds = posed.bounds();
            let (centre, extent) = ((bounds.min + bounds.max) * 0.5, bounds.max - bounds.min);
            for i in 0..6 {
                let frame = LightFrame::from_direction(Vec3::new(0.4 - i as f32 * 0.2, -1.0, 0.3));
                let reach = extent * 0.1;
                let middle = frame.to_light(centre + extent * 0.07 * i as f32);
                let (far, near) = (extent.length(), extent.length() * 1e-3);
                let (projection, near) = match i % 2 {
                    0 => (LightProjection::orthographic(&frame, middle - reach, middle + reach), 0.0),
                    _ => {
                        let eye = centre + extent * 0.1;
                        (LightProjection::perspective(eye, &frame, 0.4, near, far), near)
                    }
                };
                let p = DepthParams { projection, map_size: 256, near, pad0: 0, pad1: 0 };
                let mut is_seen = vec![false; scene.triangles().len()];
                for draw in scene.visible_draws(scene.draws(), &p) {
                    is_seen[draw.first_triangle as usize..][..draw.triangles as usize].fill(true);
                }
                for (at, t) in (0..).zip(scene.triangles()) {
                    let is_drawn = prepare(&scene, &p, &scene.draws()[0], at, t).next().is_some();
                    assert!(is_seen[at as usize] || !is_drawn, "{name} map {i} triangle {at}");
                    left_out += usize::from(!is_seen[at as usize]);
                    drawn += usize::from(is_drawn);
                }
            }
        }
        assert!(left_out > 100_000 && drawn > 5_000, "{left_out} left out, {drawn} drawn");
    }
}
