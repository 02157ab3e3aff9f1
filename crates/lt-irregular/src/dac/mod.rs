//! Divide and conquer over triangles and points together (after Mora, "Naive Ray-Tracing: A Divide-And-Conquer Approach", 2011): no tree
//! is built and nothing is kept but memory.
//!
//! Points are sorted once into cells of about equal numbers, and triangles filed with the cells that they meet (`cells.rs`). A cell is one
//! thread's: its points are halved in the middle of their rectangle, along its longer side; each half takes of the triangles
//! those that overlap its own rectangle and are not all behind its points. Both lists lie in arrays, row by row, and the halves are
//! written behind them. A triangle that covers a rectangle above all of its points finishes them.
//!
//! Memory is bounded by points and triangles: a triangle is filed with at most 64 cells, larger ones are looked at by all; a thread
//! holds a cell's lists, and at most as much again for each of [`DEPTH`] levels; lists only shrink. Time is at worst that of every
//! triangle against every leaf of points.

mod cells;
mod lists;
mod points;
mod rows;

use crate::block::{BLOCK, Block, Spread};
use crate::casters::{Casters, Query, each};
use crate::rect::Rect;
use crate::split::Item;
use crate::tile::{Late, TILE, Tile};
use crate::tree::fill_items;
use crate::view::{Bounds, View};
use alloc::boxed::Box;
use alloc::vec::Vec;
use cells::{CELLS, CHUNK, Chunk, File, Filed, Grid, Sort};
use core::sync::atomic::{AtomicUsize, Ordering};
use lists::Lists;
use lt_bvh::lanes::{Chosen, NodeLanes, SimdLevel, Work, prefetch};
use lt_bvh::{AnyHit, Ray};
use lt_math::glam::{Vec3, Vec4};
use points::{Part, Points};
#[cfg(feature = "std")]
use rayon::prelude::*;
use rows::SLACK;

/// Up to this many points are not divided further: of 64 to 256 the best for each of street, forest and random triangles is at most 11 % faster.
const LEAF: usize = 128;
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
    instructions: SimdLevel,
    leaf: usize,
}

/// What is kept from call to call: memory alone, because fresh pages cost more than what is done with them.
#[derive(Default)]
pub struct Workspace {
    chunks: Vec<Chunk>,
    items: Vec<Item>,
    /// Triangles that all cells look at.
    large: Lists,
    filed: Vec<Filed>,
    threads: Vec<Scratch>,
}

/// Memory of a thread.
#[derive(Default)]
struct Scratch {
    lists: Lists,
    points: Points,
    tile: Box<Tile>,
    blocks: Vec<Block>,
    path: Vec<Step>,
    /// The places of all points that this thread found blocked.
    blocked: Vec<u32>,
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
        DivideAndConquer { light, domain, instructions: SimdLevel::best(), leaf: LEAF }
    }

    /// The same on other instructions; `None` where the processor lacks them.
    pub fn with_instructions(self, instructions: SimdLevel) -> Option<Self> {
        Chosen::new(instructions)?;
        Some(DivideAndConquer { instructions, ..self })
    }

    /// The same with another size of blocks: up to `points` of them, at least one, are not divided further. Into how many cells all points are sorted
    /// before depends on how many there are.
    pub fn with_leaf(self, points: usize) -> Self {
        DivideAndConquer { leaf: points.max(1), ..self }
    }

    /// Whether the ray from each origin to the light is blocked: the ray tracer's own answers, by all threads there are. Stops at the
    /// end of the shorter of `origins` and `out`.
    pub fn occluded<A: AnyHit + Sync>(
        &self,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
        workspace: &mut Workspace,
    ) {
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(false);
        let chosen = Chosen::new(self.instructions).unwrap_or(Chosen::Portable);
        let query = Query { casters, light: self.light, any_hit };
        let views: Vec<View> = View::of_light(self.light, self.domain, casters.root).collect();
        let mut taken = 0;
        for view in &views {
            let scene = Scene { chosen, view, query: &query, origins, leaf: self.leaf };
            taken += scene.solve(workspace, out);
        }
        if taken < len {
            let is_stray = |ray: &Ray| ray.is_valid() && !views.iter().any(|view| view.takes(ray));
            let strays: Vec<usize> =
                (0..len).filter(|&i| is_stray(&Ray::to_light(origins[i], self.light))).collect();
            let blocked = each(&strays, |&stray| query.is_blocked_by_any(origins[stray]));
            for (stray, blocked) in strays.into_iter().zip(blocked) {
                out[stray] = blocked;
            }
        }
    }
}

/// What all problems of a view have in common.
struct Scene<'a, A> {
    chosen: Chosen,
    view: &'a View,
    query: &'a Query<'a, A>,
    origins: &'a [Vec3],
    leaf: usize,
}

/// Both halves of a rectangle with its nearness, the least and the largest, together.
fn union(a: (Rect, f32), b: (Rect, f32)) -> (Rect, f32) {
    let least = if a.0.z < b.0.z { a.0.z } else { b.0.z };
    let most = if a.1 > b.1 { a.1 } else { b.1 };
    (Rect { z: least, ..a.0.union(&b.0) }, most)
}

/// Does something with every chunk of a list and its own memory, on all threads; what comes of it, in order.
fn each_chunk<T: Sync, M: Send, R: Send>(
    list: &[T],
    memory: &mut [M],
    run: impl Fn(usize, &[T], &mut M) -> R + Sync,
) -> Vec<R> {
    #[cfg(feature = "std")]
    let chunks = list.par_chunks(CHUNK).zip(memory.par_iter_mut());
    #[cfg(not(feature = "std"))]
    let chunks = list.chunks(CHUNK).zip(memory.iter_mut());
    chunks.enumerate().map(|(i, (some, memory))| run(i * CHUNK, some, memory)).collect()
}

impl<A: AnyHit + Sync> Scene<'_, A> {
    /// Marks what is blocked; how many rays the view takes.
    fn solve(&self, workspace: &mut Workspace, out: &mut [bool]) -> usize {
        let Workspace { chunks, items, large, filed, threads } = workspace;
        chunks.resize_with(self.origins.len().div_ceil(CHUNK), Chunk::default);
        let (chosen, view) = (self.chosen, self.view);
        let grid = Grid::of(chosen, view, self.origins);
        let bounds = each_chunk(self.origins, chunks, |first, origins, chunk| {
            chosen.run(Sort { view, origins, first, grid: &grid, chunk })
        });
        let taken = chunks.iter().map(Chunk::len).sum();
        let Some((rect, _)) = bounds.into_iter().reduce(union) else { return 0 };
        if taken == 0 {
            return 0;
        }
        let counts: Vec<usize> = (0..CELLS).map(|cell| chunks.iter().map(|c| c.count(cell)).sum()).collect();
        let is_used: Vec<bool> = counts.iter().map(|count| *count > 0).collect();
        fill_items(view, self.query.casters, items);
        filed.resize_with(items.len().div_ceil(CHUNK), Filed::default);
        each_chunk(items, filed, |first, items, filed| {
            chosen.run(File { grid: &grid, is_used: &is_used, rect: &rect, items, first, filed });
        });
        let count = filed.iter().fold(0, |count, filed| count + filed.append_large(items, large, count));
        let large = (&*large, count);
        let (chunks, filed, items) = (&**chunks, &**filed, &**items);
        // Threads take cell after cell, each with memory of its own.
        let next = AtomicUsize::new(0);
        let work = |scratch: &mut Scratch| {
            scratch.blocked.clear();
            loop {
                let cell = next.fetch_add(1, Ordering::Relaxed);
                let Some(&members) = counts.get(cell) else { return };
                if members > 0 {
                    let triangles =
                        chosen.run(Gather { cell, count: members, chunks, filed, items, scratch });
                    chosen.run(Task { scene: self, members, triangles, large, scratch });
                }
            }
        };
        #[cfg(feature = "std")]
        {
            threads.resize_with(rayon::current_num_threads(), Scratch::default);
            threads.par_iter_mut().for_each(work);
        }
        #[cfg(not(feature = "std"))]
        {
            threads.resize_with(1, Scratch::default);
            threads.iter_mut().for_each(work);
        }
        for id in threads.iter().flat_map(|scratch| &scratch.blocked) {
            out[*id as usize] = true;
        }
        taken
    }

    /// Whether a triangle blocks all points within the bounds for sure.
    #[inline(always)]
    fn is_covered<L: NodeLanes>(&self, lanes: L, (rect, far): &(Rect, f32), id: u32) -> bool {
        if !A::IS_OPAQUE && !self.query.casters.triangles[id as usize].is_opaque() {
            return false;
        }
        let block = Block::of(lanes, self.view, self.query.casters, &[id]);
        let (constant, factor) = self.view.depth_tolerance();
        let spread = Spread::new(rect, rect.z, *far, constant + factor * far);
        block.test_rect(lanes, &spread).sure & 1 == 1
    }
}

/// Copies a cell's points, and the triangles filed with it, to the start of a thread's lists; how many triangles.
struct Gather<'a> {
    cell: usize,
    /// Its points.
    count: usize,
    chunks: &'a [Chunk],
    filed: &'a [Filed],
    items: &'a [Item],
    scratch: &'a mut Scratch,
}

impl Work for Gather<'_> {
    type Output = usize;

    #[inline(always)]
    fn run<L: NodeLanes>(self, _: L) -> usize {
        let Scratch { points, lists, .. } = self.scratch;
        points.reserve(self.count);
        let mut at = 0;
        for chunk in self.chunks {
            chunk.append(self.cell, points, at);
            at += chunk.count(self.cell);
        }
        let mut triangles = 0;
        for filed in self.filed {
            triangles += filed.append(self.cell, self.items, lists, triangles);
        }
        triangles
    }
}

/// Solves a cell to its end.
struct Task<'a, A> {
    scene: &'a Scene<'a, A>,
    members: usize,
    triangles: usize,
    /// Those that are filed with no cell, and how many.
    large: (&'a Lists, usize),
    scratch: &'a mut Scratch,
}

impl<A: AnyHit + Sync> Work for Task<'_, A> {
    type Output = ();

    #[inline(always)]
    fn run<L: NodeLanes>(mut self, lanes: L) {
        let rays = lanes.rays();
        let mut path = core::mem::take(&mut self.scratch.path);
        let bounds = self.scratch.points.bounds(rays, 0, self.members);
        let all = Part { start: 0, len: self.members, bounds };
        let (large, count) = self.large;
        let (found, _) = self.scratch.lists.take(rays, Some(large), (0, count), &bounds, self.triangles);
        self.enter(lanes, &mut path, &all, (0, self.triangles + found), self.members + SLACK);
        // A loop and not a recursion: a function that calls itself would not be compiled for the instructions asked for.
        while let Some(step) = path.last_mut() {
            if step.done == 2 {
                path.pop();
                continue;
            }
            if step.done == 0 {
                step.halves = self.scratch.points.halve(rays, step);
            }
            let part = step.halves[step.done];
            step.done += 1;
            if part.len > 0 {
                let (triangles, free) = ((step.first_triangle, step.triangles), step.end());
                self.enter(lanes, &mut path, &part, triangles, free);
            }
        }
        self.scratch.path = path;
    }
}

impl<A: AnyHit + Sync> Task<'_, A> {
    /// Takes of `triangles` those that a part may meet; settles the part, or leaves it to be halved, with room from `free` on.
    #[inline(always)]
    fn enter<L: NodeLanes>(
        &mut self,
        lanes: L,
        path: &mut Vec<Step>,
        part: &Part,
        (first, count): (usize, usize),
        free: usize,
    ) {
        let behind = first + count;
        let Scratch { lists, points, blocked, .. } = &mut *self.scratch;
        let (triangles, cover) = lists.take(lanes.rays(), None, (first, count), &part.bounds, behind);
        if triangles == 0 {
            return;
        }
        if cover.is_some_and(|i| self.scene.is_covered(lanes, &part.bounds, lists.ids[i])) {
            blocked.extend_from_slice(&points.ids[part.start..part.start + part.len]);
        } else if part.len <= self.scene.leaf
            || triangles <= FEW
            || path.len() == DEPTH
            || part.bounds.0.area() == 0.0
        {
            self.leaf(lanes, (part.start, part.len), (behind, triangles));
        } else {
            path.push(Step::new(part, (behind, triangles), free));
        }
    }
}

impl<A: AnyHit> Task<'_, A> {
    /// Holds points against triangles.
    #[inline(always)]
    fn leaf<L: NodeLanes>(&mut self, lanes: L, points: (usize, usize), triangles: (usize, usize)) {
        let scene = self.scene;
        let Scratch { lists, points: all, tile, blocks, blocked: found, .. } = &mut *self.scratch;
        let ids = &lists.ids[triangles.0..triangles.0 + triangles.1];
        let mut ahead = ids.iter();
        ahead.by_ref().take(AHEAD).for_each(|id| scene.query.casters.prefetch(*id));
        blocks.clear();
        for ids in ids.chunks(BLOCK) {
            ahead.by_ref().take(BLOCK).for_each(|id| scene.query.casters.prefetch(*id));
            blocks.push(Block::of(lanes, scene.view, scene.query.casters, ids));
        }
        let tiles = all.ids[points.0..points.0 + points.1].chunks(TILE);
        let mut next = tiles.clone();
        let mut fetch =
            || next.next().into_iter().flatten().for_each(|id| prefetch(&scene.origins[*id as usize]));
        fetch();
        for (ids, start) in tiles.zip((points.0..).step_by(TILE)) {
            fetch();
            let len = ids.len();
            tile.place(lanes.rays(), [&all.x[start..], &all.y[start..], &all.z[start..]], len);
            let (rect, _) = tile.bounds();
            for (i, block) in blocks.iter().enumerate() {
                if lists.meet(lanes, triangles.0 + i * BLOCK, &rect) {
                    tile.hold(lanes, scene.view, scene.query, block, Late { origins: scene.origins, ids });
                    if tile.is_done() {
                        break;
                    }
                }
            }
            let mut blocked = tile.blocked();
            while blocked != 0 {
                let i = blocked.trailing_zeros() as usize;
                blocked &= blocked - 1;
                found.push(ids[i]);
            }
        }
    }
}
