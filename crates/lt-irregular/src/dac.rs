//! Divide and conquer over triangles and points together (after Mora, "Naive Ray-Tracing: A Divide-And-Conquer Approach", 2011): no tree
//! is built and nothing is kept.
//!
//! The points are halved in the middle of their rectangle, along its longer side; each half takes of the triangles those that overlap its own
//! rectangle and are not all behind its points. Both lists lie in arrays, row by row, and the halves are written behind them. A triangle that
//! covers a rectangle above all of its points finishes them.
//!
//! Memory is the rectangles of all triangles, and at most as much again for each of [`DEPTH`] levels of each thread's; lists only shrink. Time
//! is at worst that of every triangle against every leaf of points.

use crate::block::{BLOCK, Block, Spread};
use crate::casters::{Casters, Query};
use crate::lanes::{Lanes, Level};
use crate::level::{Chosen, Instructions, Work};
use crate::rect::Rect;
use crate::tile::{TILE, Tile, least, most};
use crate::tree::items;
use crate::view::{Bounds, View};
use alloc::boxed::Box;
use alloc::vec::Vec;
use lt_bvh::{AnyHit, Ray};
use lt_math::glam::{Vec3, Vec4};

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
/// Room behind every list, so that whole registers may be written at its end.
const SLACK: usize = 16;

/// Answers lists of shadow rays to one light from the triangles alone, dividing points and triangles together
/// (after Mora 2011); nothing is built before and nothing kept.
#[derive(Clone, Copy, Debug)]
pub struct DivideAndConquer {
    light: Vec4,
    domain: Bounds,
    instructions: Instructions,
}

/// Rectangles and the triangles that they belong to.
#[derive(Default)]
struct Lists {
    x0: Vec<f32>,
    x1: Vec<f32>,
    y0: Vec<f32>,
    y1: Vec<f32>,
    z: Vec<f32>,
    ids: Vec<u32>,
}

impl Lists {
    fn of(view: &View, casters: Casters<'_>) -> (Self, usize) {
        let items = items(view, casters);
        let mut lists = Lists::default();
        lists.reserve(items.len());
        for (i, item) in items.iter().enumerate() {
            (lists.x0[i], lists.x1[i]) = (item.rect.x0, item.rect.x1);
            (lists.y0[i], lists.y1[i]) = (item.rect.y0, item.rect.y1);
            (lists.z[i], lists.ids[i]) = (item.rect.z, item.triangle);
        }
        (lists, items.len())
    }

    fn reserve(&mut self, end: usize) {
        if self.ids.len() < end + SLACK {
            let len = if self.ids.is_empty() { end } else { end + end / 2 } + SLACK;
            for row in [&mut self.x0, &mut self.x1, &mut self.y0, &mut self.y1, &mut self.z] {
                grow(row, len, 0.0);
            }
            grow(&mut self.ids, len, 0);
        }
    }

    /// Whether any of eight triangles may block points in `rect`.
    #[inline(always)]
    fn meet<E: Lanes>(&self, lanes: E, at: usize, rect: &Rect) -> bool {
        let mask = lanes.le(lanes.load(&self.x0[at..]), lanes.splat(rect.x1))
            & lanes.le(lanes.splat(rect.x0), lanes.load(&self.x1[at..]))
            & lanes.le(lanes.load(&self.y0[at..]), lanes.splat(rect.y1))
            & lanes.le(lanes.splat(rect.y0), lanes.load(&self.y1[at..]))
            & lanes.le(lanes.splat(rect.z), lanes.load(&self.z[at..]));
        mask != 0
    }

    /// Writes those of `from` that may block points in `rect`, of nearness from `rect.z` to `far`, to `to`; how many, and which of
    /// them covers the rectangle, beyond all points, with the largest nearness.
    #[inline(always)]
    fn take<P: Lanes>(
        &mut self,
        lanes: P,
        from: Option<&Lists>,
        start: usize,
        len: usize,
        bounds: &(Rect, f32),
        to: usize,
    ) -> (usize, Option<usize>) {
        self.reserve(to + len);
        let (rect, far) = bounds;
        let far = lanes.splat(*far);
        let mut best: Option<usize> = None;
        let (x0, x1) = (lanes.splat(rect.x0), lanes.splat(rect.x1));
        let (y0, y1) = (lanes.splat(rect.y0), lanes.splat(rect.y1));
        let near = lanes.splat(rect.z);
        let mut end = to;
        for at in (start..start + len).step_by(P::WIDTH) {
            let rows = from.unwrap_or(self);
            let (a0, a1) = (lanes.load(&rows.x0[at..]), lanes.load(&rows.x1[at..]));
            let (b0, b1) = (lanes.load(&rows.y0[at..]), lanes.load(&rows.y1[at..]));
            let z = lanes.load(&rows.z[at..]);
            let mut mask =
                lanes.le(a0, x1) & lanes.le(x0, a1) & lanes.le(b0, y1) & lanes.le(y0, b1) & lanes.le(near, z);
            let left = start + len - at;
            if left < P::WIDTH {
                mask &= (1 << left) - 1;
            }
            if mask != 0 {
                let mut ids = [0; 16];
                ids[..P::WIDTH].copy_from_slice(&rows.ids[at..at + P::WIDTH]);
                lanes.compress(mask, a0, &mut self.x0[end..]);
                lanes.compress(mask, a1, &mut self.x1[end..]);
                lanes.compress(mask, b0, &mut self.y0[end..]);
                lanes.compress(mask, b1, &mut self.y1[end..]);
                lanes.compress(mask, z, &mut self.z[end..]);
                lanes.compress_words(mask, &ids, &mut self.ids[end..]);
                let mut covers = lanes.le(a0, x0)
                    & lanes.le(x1, a1)
                    & lanes.le(b0, y0)
                    & lanes.le(y1, b1)
                    & lanes.lt(far, z);
                covers &= mask;
                while covers != 0 {
                    let i = end + (mask & ((1 << covers.trailing_zeros()) - 1)).count_ones() as usize;
                    covers &= covers - 1;
                    best = if best.is_none_or(|b| self.z[i] > self.z[b]) { Some(i) } else { best };
                }
                end += mask.count_ones() as usize;
            }
        }
        (end - to, best)
    }
}

/// Points, row by row.
#[derive(Default)]
struct Points {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    /// Places in the task.
    ids: Vec<u32>,
}

impl Points {
    fn reserve(&mut self, end: usize) {
        if self.ids.len() < end + SLACK {
            let len = if self.ids.is_empty() { end } else { end + end / 2 } + SLACK;
            for row in [&mut self.x, &mut self.y, &mut self.z] {
                grow(row, len, 0.0);
            }
            grow(&mut self.ids, len, 0);
        }
    }

    /// Takes the points of all rays that the view takes; how many.
    #[inline(always)]
    fn fill<P: Lanes>(&mut self, lanes: P, view: &View, origins: &[Vec3]) -> usize {
        self.reserve(origins.len());
        let [x, y, z] = view.axes();
        let mut len = 0;
        for (chunk, some) in origins.chunks(P::WIDTH).enumerate() {
            // What is not given starts nowhere, which no view takes.
            let mut o = [[f32::NAN; 16]; 3];
            let mut ids = [0; 16];
            for (i, from) in some.iter().enumerate() {
                (o[0][i], o[1][i], o[2][i]) = (from[x], from[y], from[z]);
                ids[i] = (chunk * P::WIDTH + i) as u32;
            }
            let (point, taken) =
                view.points(lanes, [lanes.load(&o[0]), lanes.load(&o[1]), lanes.load(&o[2])]);
            lanes.compress(taken, point[0], &mut self.x[len..]);
            lanes.compress(taken, point[1], &mut self.y[len..]);
            lanes.compress(taken, point[2], &mut self.z[len..]);
            lanes.compress_words(taken, &ids, &mut self.ids[len..]);
            len += taken.count_ones() as usize;
        }
        len
    }

    /// A list of some of the points alone.
    fn part(&self, part: &Part) -> Self {
        let mut alone = Points::default();
        alone.reserve(part.len);
        let (to, from) = (..part.len, part.start..part.start + part.len);
        alone.x[to].copy_from_slice(&self.x[from.clone()]);
        alone.y[to].copy_from_slice(&self.y[from.clone()]);
        alone.z[to].copy_from_slice(&self.z[from.clone()]);
        alone.ids[to].copy_from_slice(&self.ids[from]);
        alone
    }

    /// The rectangle of points with their least nearness, and the largest.
    #[inline(always)]
    fn bounds<P: Lanes>(&self, lanes: P, start: usize, len: usize) -> (Rect, f32) {
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let (mut low, mut high) = ([infinite; 3], [minus; 3]);
        for at in (start..start + len).step_by(P::WIDTH) {
            let given = first(start + len - at);
            let point = [lanes.load(&self.x[at..]), lanes.load(&self.y[at..]), lanes.load(&self.z[at..])];
            for axis in 0..3 {
                low[axis] = lanes.min(lanes.pick(given, point[axis], infinite), low[axis]);
                high[axis] = lanes.max(lanes.pick(given, point[axis], minus), high[axis]);
            }
        }
        around(lanes, low, high)
    }

    /// Writes the points of `from`, or of this very list, that lie below a step's place behind `to`, and the others behind those and some room;
    /// both halves with their bounds.
    #[inline(always)]
    fn halve<P: Lanes>(&mut self, lanes: P, from: Option<&Points>, step: &Step, to: usize) -> [Part; 2] {
        let second = to + step.len + SLACK;
        self.reserve(second + step.len);
        let place = lanes.splat(step.place);
        let mut ends = [to, second];
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let mut reach = [([infinite; 3], [minus; 3]); 2];
        for at in (step.start..step.start + step.len).step_by(P::WIDTH) {
            let rows = from.unwrap_or(self);
            let point = [lanes.load(&rows.x[at..]), lanes.load(&rows.y[at..]), lanes.load(&rows.z[at..])];
            let mut ids = [0; 16];
            ids[..P::WIDTH].copy_from_slice(&rows.ids[at..at + P::WIDTH]);
            let below = lanes.lt(if step.is_y { point[1] } else { point[0] }, place);
            let given = first((step.start + step.len - at).min(P::WIDTH));
            for (half, mask) in [below & given, given & !below].into_iter().enumerate() {
                if mask == 0 {
                    continue;
                }
                let end = ends[half];
                lanes.compress(mask, point[0], &mut self.x[end..]);
                lanes.compress(mask, point[1], &mut self.y[end..]);
                lanes.compress(mask, point[2], &mut self.z[end..]);
                lanes.compress_words(mask, &ids, &mut self.ids[end..]);
                ends[half] += mask.count_ones() as usize;
                let (low, high) = &mut reach[half];
                for axis in 0..3 {
                    low[axis] = lanes.min(lanes.pick(mask, point[axis], infinite), low[axis]);
                    high[axis] = lanes.max(lanes.pick(mask, point[axis], minus), high[axis]);
                }
            }
        }
        let mut parts = [Part::default(); 2];
        for (half, part) in parts.iter_mut().enumerate() {
            let start = [to, second][half];
            let (low, high) = reach[half];
            *part = Part { start, len: ends[half] - start, bounds: around(lanes, low, high) };
        }
        parts
    }
}

/// Some of the points in a list, with their bounds.
#[derive(Clone, Copy)]
struct Part {
    start: usize,
    len: usize,
    bounds: (Rect, f32),
}

impl Default for Part {
    fn default() -> Self {
        Part { start: 0, len: 0, bounds: (Rect::EMPTY, 0.0) }
    }
}

/// The rectangle with the least nearness, and the largest, from those of each lane.
#[inline(always)]
fn around<P: Lanes>(lanes: P, low: [P::F; 3], high: [P::F; 3]) -> (Rect, f32) {
    let rect = Rect {
        x0: least(lanes, low[0]),
        x1: most(lanes, high[0]),
        y0: least(lanes, low[1]),
        y1: most(lanes, high[1]),
        z: least(lanes, low[2]),
    };
    (rect, most(lanes, high[2]))
}

/// Makes a row longer. The first time it comes zeroed from the system, untouched.
fn grow<T: Copy>(row: &mut Vec<T>, len: usize, zero: T) {
    if row.is_empty() {
        *row = alloc::vec![zero; len];
    } else {
        row.resize(len, zero);
    }
}

/// The lowest bits, as many as `count`.
#[inline(always)]
fn first(count: usize) -> u32 {
    if count >= 32 { u32::MAX } else { (1 << count) - 1 }
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
