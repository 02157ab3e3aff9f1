//! Which casters a depth map can see: by the boxes of placed trees, then by those of runs of triangles, whose order is spatial.

use std::sync::OnceLock;

use lt_bvh::{Instance, Triangle};
use lt_math::glam::{DVec3, DVec4, Vec3, Vec4};
use lt_scene::Bounds;
use lt_shaders::abi::DepthParams;
use rayon::prelude::*;

use super::DrawRange;

/// Triangles in a run. Larger runs reach farther over a level's edge, smaller ones cost more tests.
const RUN: u32 = 128;
/// Runs that one thread tests at a time.
const SHARE: usize = 256;
/// What coordinates in f32 may be off by, relative to the largest terms that they are sums of.
const ROUNDING: f64 = 1e-6;

/// Boxes of runs of triangles, each made when it is first asked for.
#[derive(Clone, Debug, Default)]
pub struct Runs(Vec<OnceLock<Bounds>>);

impl Runs {
    /// Of so many triangles.
    pub fn new(triangles: usize) -> Self {
        Self(vec![OnceLock::new(); triangles.div_ceil(RUN as usize)])
    }

    /// The box of a run of these triangles.
    pub fn bounds(&self, triangles: &[Triangle], run: u32) -> Bounds {
        *self.0[run as usize].get_or_init(|| {
            let first = (run * RUN) as usize;
            let run = &triangles[first..triangles.len().min(first + RUN as usize)];
            let corners = run.iter().flat_map(|t| [t.v0, t.v1, t.v2]);
            corners.fold(Bounds::EMPTY, |b, c| Bounds { min: b.min.min(c), max: b.max.max(c) })
        })
    }

    /// All boxes.
    pub fn all(&self, triangles: &[Triangle]) -> Vec<Bounds> {
        (0..self.0.len() as u32).into_par_iter().map(|run| self.bounds(triangles, run)).collect()
    }
}

/// The parts of `draws` that may fall on a map, in their order. What is left out has no effect on it.
pub fn visible(
    bounds_of: impl Fn(u32) -> Bounds + Sync,
    instances: &[Instance],
    draws: &[DrawRange],
    p: &DepthParams,
) -> Vec<DrawRange> {
    let map = Sides::of(p);
    // The sides that runs are held against, and their number for each run; what needs no test has none.
    let mut spaces: Vec<Sides> = Vec::new();
    let mut asked: Vec<(DrawRange, Option<u32>)> = Vec::new();
    for draw in draws {
        let instance = instances.get(draw.instance as usize);
        let sight = instance.map_or(Sight::Part, |i| map.see(i.low_world, i.high_world));
        match sight {
            Sight::Nothing => {}
            Sight::Part if draw.triangles > RUN => {
                let space = Some(spaces.len() as u32);
                spaces.push(instance.map_or(map, |i| map.placed(i)));
                asked.extend(runs_of(draw).map(|run| (run, space)));
            }
            _ => asked.push((*draw, None)),
        }
    }
    let may_appear = |(run, space): &&(DrawRange, Option<u32>)| {
        space.is_none_or(|space| {
            let bounds = bounds_of(run.first_triangle / RUN);
            spaces[space as usize].see(bounds.min, bounds.max) != Sight::Nothing
        })
    };
    joined(asked.par_iter().with_min_len(SHARE).filter(may_appear).map(|(run, _)| *run).collect())
}

/// A draw cut where runs end.
fn runs_of(draw: &DrawRange) -> impl Iterator<Item = DrawRange> {
    let end = draw.first_triangle + draw.triangles;
    let mut first = draw.first_triangle;
    let draw = *draw;
    std::iter::from_fn(move || {
        let next = ((first / RUN + 1) * RUN).min(end);
        let run = DrawRange { first_triangle: first, triangles: next - first, ..draw };
        first = next;
        (run.triangles > 0).then_some(run)
    })
}

/// Joins what follows each other in one draw.
fn joined(draws: Vec<DrawRange>) -> Vec<DrawRange> {
    let mut all: Vec<DrawRange> = Vec::new();
    for draw in draws {
        match all.last_mut() {
            Some(last)
                if last.first_triangle + last.triangles == draw.first_triangle
                    && (last.instance, last.has_holes) == (draw.instance, draw.has_holes) =>
            {
                last.triangles += draw.triangles;
            }
            _ => all.push(draw),
        }
    }
    all
}

/// What a map sees of a box.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sight {
    Nothing,
    Part,
    All,
}

/// A half-space: x, y, z, 1 of a point in it give at least 0 with `plane`, up to what f32 rounds.
#[derive(Clone, Copy)]
struct Side {
    plane: DVec4,
    rounding: f64,
}

/// A map's sides. They are homogeneous, and so hold behind the light too.
#[derive(Clone, Copy)]
struct Sides([Side; 6]);

impl Sides {
    fn of(p: &DepthParams) -> Self {
        let row = |r: Vec4| r.as_dvec4();
        let (x, y) = (row(p.projection.row_x), row(p.projection.row_y));
        let (z, w) = (row(p.projection.row_z), row(p.projection.row_w));
        // A texel to spare, and a thousandth of the depth: corners are rounded to the grid of subtexels.
        let spare = w / f64::from(p.map_size);
        let planes = [x + spare, y + spare, w + spare - x, w + spare - y, w, DVec4::W * 1.001 - z];
        Self(planes.map(|plane| Side { plane, rounding: plane.w.abs() * ROUNDING }))
    }

    /// The same in the space of a placed tree.
    fn placed(self, instance: &Instance) -> Self {
        let rows = instance.object_to_world.map(|r| r.as_dvec4());
        let origin = DVec3::new(rows[0].w, rows[1].w, rows[2].w);
        Self(self.0.map(|Side { plane, rounding }| Side {
            plane: rows[0] * plane.x + rows[1] * plane.y + rows[2] * plane.z + DVec4::W * plane.w,
            rounding: rounding + plane.truncate().abs().dot(origin.abs()) * ROUNDING,
        }))
    }

    fn see(&self, low: Vec3, high: Vec3) -> Sight {
        let (low, high) = (low.as_dvec3(), high.as_dvec3());
        let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
        let farthest = low.abs().max(high.abs());
        let mut sight = Sight::All;
        for Side { plane, rounding } in &self.0 {
            let normal = plane.truncate();
            let at = normal.dot(centre) + plane.w;
            let reach = normal.abs().dot(half);
            let rounding = rounding + normal.abs().dot(farthest) * ROUNDING;
            // Comparisons are false for what is no number, so that it is drawn.
            if at + reach + rounding < 0.0 {
                return Sight::Nothing;
            }
            if at - reach < rounding {
                sight = Sight::Part;
            }
        }
        sight
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::{LightFrame, LightProjection};

    fn triangle_at(place: Vec3) -> Triangle {
        Triangle { v0: place, v1: place + Vec3::X * 0.1, v2: place + Vec3::Y * 0.1, ..Triangle::default() }
    }

    /// A sun along −z on a map of x and y in 0 … 8.
    fn sun() -> DepthParams {
        let frame = LightFrame::from_direction(Vec3::NEG_Z);
        let corners = Bounds { min: Vec3::ZERO, max: Vec3::splat(8.0) }.corners().map(|c| frame.to_light(c));
        let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), c| (l.min(*c), h.max(*c)));
        let projection = LightProjection::orthographic(&frame, low, high);
        DepthParams { projection, map_size: 64, near: 0.0, pad0: 0, pad1: 0 }
    }

    fn draw(first_triangle: u32, triangles: u32) -> DrawRange {
        DrawRange { first_triangle, triangles, instance: 0, has_holes: false }
    }

    #[test]
    fn runs_beside_the_map_are_left_out_and_the_others_joined() {
        // Five runs and a bit: on the map, beside it, beyond its far end, two on it, a few on it.
        let place = |i: usize| match i / RUN as usize {
            1 => Vec3::new(9.0, 1.0, 1.0),
            2 => Vec3::new(1.0, 1.0, -3.0),
            run => Vec3::new(run as f32, 2.0, 3.0),
        };
        let count = 5 * RUN as usize + 7;
        let triangles: Vec<Triangle> = (0..count).map(|i| triangle_at(place(i))).collect();
        let runs = Runs::new(count);
        let visible = |draws: &[DrawRange]| visible(|run| runs.bounds(&triangles, run), &[], draws, &sun());
        assert_eq!(visible(&[draw(0, count as u32)]), [draw(0, RUN), draw(3 * RUN, 2 * RUN + 7)]);
        // A draw may begin and end anywhere.
        assert_eq!(visible(&[draw(5, 4 * RUN)]), [draw(5, RUN - 5), draw(3 * RUN, RUN + 5)]);
        assert_eq!(visible(&[draw(RUN + 1, 2 * RUN - 1)]), []);
        // Short ones are not worth a test.
        assert_eq!(visible(&[draw(RUN + 1, 9), draw(RUN + 20, 9)]), [draw(RUN + 1, 9), draw(RUN + 20, 9)]);
        assert_eq!(visible(&[]), []);
    }

    #[test]
    fn placed_trees_are_tested_where_they_stand() {
        let triangles: Vec<Triangle> =
            (0..2 * RUN).map(|i| triangle_at(Vec3::X * (i / RUN) as f32 * 4.0)).collect();
        let runs = Runs::new(triangles.len());
        let at = |x: f32| Instance {
            object_to_world: [Vec4::new(1.0, 0.0, 0.0, x), Vec4::new(0.0, 1.0, 0.0, 2.0), Vec4::Z],
            low_world: Vec3::new(x, 2.0, 0.0),
            high_world: Vec3::new(x + 4.1, 2.1, 0.0),
            ..Instance::default()
        };
        // Wholly on the map, one run on either side of its edges, beside it.
        let instances = [at(1.0), at(6.0), at(-2.0), at(20.0)];
        let draws = [0, 1, 2, 3].map(|instance| DrawRange { instance, ..draw(0, 2 * RUN) });
        let bounds = runs.all(&triangles);
        let seen = visible(|run| bounds[run as usize], &instances, &draws, &sun());
        let of = |instance, first, count| DrawRange { instance, ..draw(first, count) };
        assert_eq!(seen, [of(0, 0, 2 * RUN), of(1, 0, RUN), of(2, RUN, RUN)]);
    }

    #[test]
    fn what_is_no_number_is_drawn() {
        let triangles: Vec<Triangle> = (0..2 * RUN).map(|_| triangle_at(Vec3::ZERO)).collect();
        let mut p = sun();
        p.projection.row_x.w = f32::NAN;
        let draws = [draw(0, 2 * RUN)];
        let runs = Runs::new(triangles.len());
        assert_eq!(visible(|run| runs.bounds(&triangles, run), &[], &draws, &p), draws);
    }
}
