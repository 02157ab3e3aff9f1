//! Divide and conquer over triangles and points together (after Mora, "Naive Ray-Tracing: A Divide-And-Conquer Approach", 2011): no tree
//! is built and nothing is kept.
//!
//! The points are halved in the middle of their rectangle, along its longer side; each half takes of the triangles those that overlap its own
//! rectangle and are not all behind its points. Both lists lie in arrays, row by row, and the halves are written behind them. A triangle that
//! covers a rectangle above all of its points finishes them.
//!
//! Memory is the rectangles of all triangles, and at most as much again for each of [`DEPTH`] levels of each thread's; lists only shrink. Time
//! is at worst that of every triangle against every leaf of points.

mod lists;
mod points;
mod rows;

use crate::block::{BLOCK, Block, Spread};
use crate::casters::{Casters, Query};
use crate::lanes::Level;
use crate::level::{Chosen, Instructions, Work};
use crate::rect::Rect;
use crate::tile::{TILE, Tile};
use crate::view::{Bounds, View};
use alloc::boxed::Box;
use alloc::vec::Vec;
use lists::Lists;
use lt_bvh::{AnyHit, Ray};
use lt_math::glam::{Vec3, Vec4};
use points::{Part, Points};
use rows::SLACK;

/// Up to this many points are not divided further.
const LEAF: usize = 128;
/// Up to this many points are one thread's.
const TASK: usize = 1 << 15;
/// Levels of division; what is left then is a leaf, however large.
const DEPTH: usize = 40;
/// Fewer triangles than this are not worth dividing the points for.
const FEW: usize = 24;
/// Triangles that are fetched before they are needed.
const AHEAD: usize = 32;

/// Answers lists of shadow rays to one light from the triangles alone, dividing points and triangles together
/// (after Mora 2011); nothing is built before and nothing kept.
#[derive(Clone, Copy, Debug)]
pub struct DivideAndConquer {
    light: Vec4,
    domain: Bounds,
    instructions: Instructions,
}

/// Memory of a thread.
#[derive(Default)]
struct Scratch {
    lists: Lists,
    points: Points,
    tile: Box<Tile>,
    origins: Vec<Vec3>,
    blocks: Vec<Block>,
}

/// Points that are being halved, and their triangles.
struct Step {
    start: usize,
    len: usize,
    first_triangle: usize,
    triangles: usize,
    /// Where they are cut.
    is_y: bool,
    place: f32,
    /// Where in the list there is room.
    free: usize,
    /// The halves, once there are any, and how many of them are done.
    halves: [Part; 2],
    done: usize,
}

impl Step {
    fn new(part: &Part, triangles: (usize, usize), free: usize) -> Self {
        let (rect, _) = &part.bounds;
        let is_y = rect.y1 - rect.y0 > rect.x1 - rect.x0;
        let place = if is_y { 0.5 * rect.y0 + 0.5 * rect.y1 } else { 0.5 * rect.x0 + 0.5 * rect.x1 };
        Step {
            start: part.start,
            len: part.len,
            first_triangle: triangles.0,
            triangles: triangles.1,
            is_y,
            place,
            free,
            halves: [Part::default(); 2],
            done: 0,
        }
    }

    /// Where there is room behind both halves.
    fn end(&self) -> usize {
        self.halves[1].start + self.halves[1].len + SLACK
    }
}

impl DivideAndConquer {
    /// For a homogeneous light (w = 0: a sun, `xyz` towards it; w = 1: a position). `domain` must hold all triangles, and should hold all
    /// origins: a ray from elsewhere is put to every triangle.
    pub fn new(light: Vec4, domain: Bounds) -> Self {
        DivideAndConquer { light, domain, instructions: Instructions::best() }
    }

    /// The same on other instructions; `None` where the processor lacks them.
    pub fn with_instructions(self, instructions: Instructions) -> Option<Self> {
        Chosen::new(instructions)?;
        Some(DivideAndConquer { instructions, ..self })
    }

    /// Whether the ray from each origin to the light is blocked: the ray tracer's own answers, by all threads there are. Stops at the
    /// end of the shorter of `origins` and `out`.
    pub fn occluded<A: AnyHit + Sync>(
        &self,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
    ) {
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(false);
        let chosen = Chosen::new(self.instructions).unwrap_or(Chosen::Portable);
        let query = Query { casters, light: self.light, any_hit };
        let mut taken = 0;
        for view in View::of_light(self.light, self.domain, casters.root) {
            let scene = Scene { chosen, view: &view, query: &query, origins };
            let problem = chosen.run(Root { view: &view, casters, origins });
            taken += problem.points.1;
            for id in scene.solve(problem, 0) {
                out[id as usize] = true;
            }
        }
        if taken < len {
            for (&origin, out) in origins.iter().zip(out) {
                let ray = Ray::to_light(origin, self.light);
                let mut views = View::of_light(self.light, self.domain, casters.root);
                if ray.is_valid() && !views.any(|view| view.takes(&ray)) {
                    *out = query.is_blocked_by_any(origin);
                }
            }
        }
    }
}

/// Points and triangles that may meet, with how many they are.
struct Problem {
    points: (Points, usize),
    triangles: (Lists, usize),
    bounds: (Rect, f32),
}

/// What is known of half a problem.
enum Half {
    /// No point is blocked.
    Clear,
    /// All points are, by their places.
    Blocked(Vec<u32>),
    Open(Box<Problem>),
}

/// What all problems of a view have in common.
struct Scene<'a, A> {
    chosen: Chosen,
    view: &'a View,
    query: &'a Query<'a, A>,
    origins: &'a [Vec3],
}

impl<A: AnyHit + Sync> Scene<'_, A> {
    /// The places of all blocked points.
    fn solve(&self, problem: Problem, depth: usize) -> Vec<u32> {
        if problem.points.1 == 0 || problem.triangles.1 == 0 {
            return Vec::new();
        }
        if problem.points.1 <= TASK || depth == DEPTH {
            return self.chosen.run(Task::new(self, problem));
        }
        let Problem { points, triangles, bounds } = problem;
        let halves = self.chosen.run(Halve { points: &points, bounds });
        drop(points);
        let solve =
            |points: (Points, Part)| match self.chosen.run(Narrow { scene: self, points, all: &triangles }) {
                Half::Clear => Vec::new(),
                Half::Blocked(places) => places,
                Half::Open(half) => self.solve(*half, depth + 1),
            };
        let [a, b] = halves;
        #[cfg(feature = "std")]
        let (mut lower, upper) = rayon::join(|| solve(a), || solve(b));
        #[cfg(not(feature = "std"))]
        let (mut lower, upper) = (solve(a), solve(b));
        lower.extend(upper);
        lower
    }

    /// Whether a triangle blocks all points within the bounds for sure.
    #[inline(always)]
    fn is_covered<L: Level>(&self, level: L, (rect, far): &(Rect, f32), id: u32) -> bool {
        if !A::IS_OPAQUE && !self.query.casters.triangles[id as usize].is_opaque() {
            return false;
        }
        let block = Block::of(level.eight(), self.view, self.query.casters, &[id]);
        let (constant, factor) = self.view.depth_tolerance();
        let spread = Spread::new(rect, rect.z, *far, constant + factor * far);
        block.test_rect(level.eight(), &spread).sure & 1 == 1
    }
}

/// Makes the first problem of a view: all its points and triangles.
struct Root<'a> {
    view: &'a View,
    casters: Casters<'a>,
    origins: &'a [Vec3],
}

impl Work for Root<'_> {
    type Output = Problem;
    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Problem {
        let mut points = Points::default();
        let len = points.fill(level.points(), self.view, self.origins);
        let bounds = points.bounds(level.points(), 0, len);
        let triangles = if len == 0 { Default::default() } else { Lists::of(self.view, self.casters) };
        Problem { points: (points, len), triangles, bounds }
    }
}

/// Cuts the points of a problem in two.
struct Halve<'a> {
    points: &'a (Points, usize),
    bounds: (Rect, f32),
}

impl Work for Halve<'_> {
    type Output = [(Points, Part); 2];
    #[inline(always)]
    fn run<L: Level>(self, level: L) -> [(Points, Part); 2] {
        let (from, len) = self.points;
        let step = Step::new(&Part { start: 0, len: *len, bounds: self.bounds }, (0, 0), 0);
        let mut both = Points::default();
        let [lower, upper] = both.halve(level.points(), Some(from), &step, step.free);
        let other = both.part(&upper);
        [(both, lower), (other, Part { start: 0, ..upper })]
    }
}

/// Finds the triangles that half of a problem may meet.
struct Narrow<'a, A> {
    scene: &'a Scene<'a, A>,
    points: (Points, Part),
    all: &'a (Lists, usize),
}

impl<A: AnyHit + Sync> Work for Narrow<'_, A> {
    type Output = Half;
    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Half {
        let (mut points, Part { len, bounds, .. }) = self.points;
        if len == 0 {
            return Half::Clear;
        }
        let (all, count) = self.all;
        let mut lists = Lists::default();
        let (count, cover) = lists.take(level.points(), Some(all), 0, *count, &bounds, 0);
        if count == 0 {
            return Half::Clear;
        }
        if cover.is_some_and(|i| self.scene.is_covered(level, &bounds, lists.ids[i])) {
            points.ids.truncate(len);
            return Half::Blocked(points.ids);
        }
        Half::Open(Box::new(Problem { points: (points, len), triangles: (lists, count), bounds }))
    }
}

/// Solves a problem to its end.
struct Task<'a, A> {
    scene: &'a Scene<'a, A>,
    members: usize,
    triangles: usize,
    bounds: (Rect, f32),
    scratch: Scratch,
    blocked: Vec<u32>,
}

impl<'a, A: AnyHit + Sync> Task<'a, A> {
    fn new(scene: &'a Scene<'a, A>, problem: Problem) -> Self {
        let Problem { points: (points, members), triangles: (lists, triangles), bounds } = problem;
        let scratch = Scratch { points, lists, ..Scratch::default() };
        Task { scene, members, triangles, bounds, scratch, blocked: Vec::new() }
    }
}

impl<A: AnyHit + Sync> Work for Task<'_, A> {
    /// The places of all blocked points.
    type Output = Vec<u32>;

    #[inline(always)]
    fn run<L: Level>(mut self, level: L) -> Vec<u32> {
        let lanes = level.points();
        // A loop and not a recursion: a function that calls itself would not be compiled for the instructions asked for.
        let all = Part { start: 0, len: self.members, bounds: self.bounds };
        let mut path = alloc::vec![Step::new(&all, (0, self.triangles), self.members + SLACK)];
        while let Some(depth) = path.len().checked_sub(1) {
            let step = &mut path[depth];
            if step.done == 2 {
                path.pop();
                continue;
            }
            if step.done == 0 {
                step.halves = self.scratch.points.halve(lanes, None, step, step.free);
            }
            let part = step.halves[step.done];
            step.done += 1;
            if part.len == 0 {
                continue;
            }
            let behind = step.first_triangle + step.triangles;
            let (triangles, cover) = self.scratch.lists.take(
                lanes,
                None,
                step.first_triangle,
                step.triangles,
                &part.bounds,
                behind,
            );
            if triangles == 0 {
                continue;
            }
            let (start, end) = (part.start, part.start + part.len);
            if cover.is_some_and(|i| self.scene.is_covered(level, &part.bounds, self.scratch.lists.ids[i])) {
                self.blocked.extend_from_slice(&self.scratch.points.ids[start..end]);
            } else if part.len <= LEAF || triangles <= FEW || depth == DEPTH || part.bounds.0.area() == 0.0 {
                self.leaf(level, (start, part.len), (behind, triangles));
            } else {
                let free = step.end();
                path.push(Step::new(&part, (behind, triangles), free));
            }
        }
        self.blocked
    }
}

impl<A: AnyHit> Task<'_, A> {
    /// Holds points against triangles.
    #[inline(always)]
    fn leaf<L: Level>(&mut self, level: L, points: (usize, usize), triangles: (usize, usize)) {
        let scene = self.scene;
        let Scratch { lists, points: all, tile, origins, blocks, .. } = &mut self.scratch;
        let ids = &lists.ids[triangles.0..triangles.0 + triangles.1];
        let mut ahead = ids.iter();
        ahead.by_ref().take(AHEAD).for_each(|id| scene.query.casters.prefetch(level, *id));
        blocks.clear();
        for ids in ids.chunks(BLOCK) {
            ahead.by_ref().take(BLOCK).for_each(|id| scene.query.casters.prefetch(level, *id));
            blocks.push(Block::of(level.eight(), scene.view, scene.query.casters, ids));
        }
        for ids in all.ids[points.0..points.0 + points.1].chunks(TILE) {
            origins.clear();
            origins.extend(ids.iter().map(|id| scene.origins[*id as usize]));
            tile.fill(level.points(), scene.view, origins);
            let (rect, _) = tile.bounds();
            for (i, block) in blocks.iter().enumerate() {
                if lists.meet(level.eight(), triangles.0 + i * BLOCK, &rect) {
                    tile.hold(level, scene.view, scene.query, block);
                    if tile.is_done() {
                        break;
                    }
                }
            }
            let mut blocked = tile.blocked();
            while blocked != 0 {
                let i = blocked.trailing_zeros() as usize;
                blocked &= blocked - 1;
                self.blocked.push(ids[i]);
            }
        }
    }
}
