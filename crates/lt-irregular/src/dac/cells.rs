//! Cells of about as many points each, and which triangles meet them.
//!
//! Few points have fewer cells: one that holds less than a leaf would leave most lanes of it idle. Columns are cut where a sample of the points says that they are equally full, and each column into rows likewise: a horizon does not leave
//! all other points in one cell. Which cell a place lies in does not decrease with its coordinates, so that a triangle's rectangle
//! meets the cells from its least corner's to its largest's, and no other.

use super::lists::Lists;
use super::points::{Points, first};
use super::rows::SLACK;
use crate::rect::Rect;
use crate::split::Item;
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::lanes::{Chosen, Lanes, NodeLanes, Work, prefetch};
use lt_math::glam::Vec3;

/// Most columns, and rows of each.
const SIDE: usize = 32;
/// Most cells.
pub(super) const CELLS: usize = SIDE * SIDE;
/// Rays, or triangles, that one thread sorts together.
pub(super) const CHUNK: usize = 1 << 15;
/// Rays that cells are made by, for each of them.
const SAMPLES: usize = 16;
/// Points that are worth a cell.
const WORTH: usize = 512;
/// Points that are looked ahead for where they will be written.
const AHEAD: usize = 24;
/// A triangle that meets more cells than this is not filed in each: all look at it.
const MOST: usize = 64;

/// Where cells begin.
pub(super) struct Grid {
    /// Least x of the second column and so on; the last is infinite.
    columns: [f32; SIDE],
    /// The same of each column's rows.
    rows: [[f32; SIDE]; SIDE],
}

/// How many of the bounds are not beyond `at`.
#[inline(always)]
fn place<P: Lanes>(lanes: P, bounds: &[f32; SIDE], at: f32) -> usize {
    let at = lanes.splat(at);
    let places = (0..SIDE).step_by(P::WIDTH).map(|i| lanes.le(lanes.load(&bounds[i..]), at).count_ones());
    (places.sum::<u32>() as usize).min(SIDE - 1)
}

/// What cuts sorted numbers into this many parts of one size, at most [`SIDE`].
fn quantiles(sorted: &[f32], parts: usize) -> [f32; SIDE] {
    let mut bounds = [f32::INFINITY; SIDE];
    for (i, bound) in bounds[..parts - 1].iter_mut().enumerate() {
        *bound = sorted.get((i + 1) * sorted.len() / parts).copied().unwrap_or(f32::INFINITY);
    }
    bounds
}

impl Grid {
    /// For the points of these rays.
    pub fn of(chosen: Chosen, view: &View, origins: &[Vec3]) -> Self {
        let step = (origins.len() / (CELLS * SAMPLES)).max(1);
        let some: Vec<Vec3> = origins.iter().step_by(step).copied().collect();
        let mut points = Points::default();
        let count = chosen.run(Fill { view, origins: &some, first: 0, points: &mut points });
        let side = (1..SIDE).find(|side| side * side * WORTH >= count * step).unwrap_or(SIDE);
        let places = points.x[..count].iter().zip(&points.y);
        let mut sample: Vec<[f32; 2]> = places.map(|(x, y)| [*x, *y]).collect();
        sample.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
        let xs: Vec<f32> = sample.iter().map(|s| s[0]).collect();
        let columns = quantiles(&xs, side);
        let mut rows = [[f32::INFINITY; SIDE]; SIDE];
        let mut rest = &sample[..];
        for (rows, end) in rows.iter_mut().zip(columns) {
            let (column, others) = rest.split_at(rest.partition_point(|s| s[0] < end));
            let mut ys: Vec<f32> = column.iter().map(|s| s[1]).collect();
            ys.sort_unstable_by(f32::total_cmp);
            *rows = quantiles(&ys, side);
            rest = others;
        }
        Grid { columns, rows }
    }

    /// The cell that a place lies in.
    #[inline(always)]
    fn cell<P: Lanes>(&self, lanes: P, x: f32, y: f32) -> Cell {
        let column = place(lanes, &self.columns, x);
        let rows = &self.rows[column];
        let row = place(lanes, rows, y);
        let below =
            |bounds: &[f32; SIDE], at: usize| if at == 0 { f32::NEG_INFINITY } else { bounds[at - 1] };
        Cell {
            index: column * SIDE + row,
            x0: below(&self.columns, column),
            x1: self.columns[column],
            y0: below(rows, row),
            y1: rows[row],
        }
    }

    /// The first and last cell of each column that a rectangle meets.
    #[inline(always)]
    fn columns_met<P: Lanes>(
        &self,
        lanes: P,
        rect: &Rect,
    ) -> impl Iterator<Item = core::ops::RangeInclusive<usize>> {
        let columns = place(lanes, &self.columns, rect.x0)..=place(lanes, &self.columns, rect.x1);
        columns.map(move |column| {
            let rows = &self.rows[column];
            column * SIDE + place(lanes, rows, rect.y0)..=column * SIDE + place(lanes, rows, rect.y1)
        })
    }
}

/// A cell and where it lies. Places that follow one another mostly lie in one cell, and to see that they do takes less than to find it.
#[derive(Clone, Copy)]
struct Cell {
    index: usize,
    /// From here.
    x0: f32,
    /// Up to here, and not here.
    x1: f32,
    y0: f32,
    y1: f32,
}

impl Cell {
    /// Holds nothing.
    const NONE: Self =
        Cell { index: 0, x0: f32::INFINITY, x1: f32::INFINITY, y0: f32::INFINITY, y1: f32::INFINITY };

    /// Which of some places lie within.
    #[inline(always)]
    fn members<P: Lanes>(&self, lanes: P, x: P::F, y: P::F) -> u32 {
        lanes.le(lanes.splat(self.x0), x)
            & lanes.lt(x, lanes.splat(self.x1))
            & lanes.le(lanes.splat(self.y0), y)
            & lanes.lt(y, lanes.splat(self.y1))
    }

    /// Whether all of a rectangle does.
    #[inline(always)]
    fn holds(&self, rect: &Rect) -> bool {
        self.x0 <= rect.x0 && rect.x1 < self.x1 && self.y0 <= rect.y0 && rect.y1 < self.y1
    }
}

/// A point on its way to its cell, written in one go: four rows of a cell each would be four places to write to.
#[repr(C, align(16))]
#[derive(Clone, Copy, Default)]
struct Place {
    x: f32,
    y: f32,
    z: f32,
    /// Place in the caller's list.
    id: u32,
}

/// The rays of a part of the caller's list, as points: as they come, then by cell.
#[derive(Default)]
pub(super) struct Chunk {
    points: Points,
    len: usize,
    cells: Vec<u16>,
    sorted: Vec<Place>,
    /// Where each cell's points begin, and where the last one's end.
    starts: Vec<u32>,
}

impl Chunk {
    /// How many points lie in a cell.
    pub fn count(&self, cell: usize) -> usize {
        (self.starts[cell + 1] - self.starts[cell]) as usize
    }

    /// Points that the view takes.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Appends a cell's points to a list that holds `at` of them.
    #[inline(always)]
    pub fn append(&self, cell: usize, to: &mut Points, at: usize) {
        let from = self.starts[cell] as usize..self.starts[cell + 1] as usize;
        let rows = to.x[at..].iter_mut().zip(&mut to.y[at..]).zip(&mut to.z[at..]).zip(&mut to.ids[at..]);
        for ((((x, y), z), id), place) in rows.zip(&self.sorted[from]) {
            (*x, *y, *z, *id) = (place.x, place.y, place.z, place.id);
        }
    }
}

/// Makes points of rays; how many the view takes.
struct Fill<'a> {
    view: &'a View,
    origins: &'a [Vec3],
    /// Place of the first in the caller's list.
    first: usize,
    points: &'a mut Points,
}

impl Work for Fill<'_> {
    type Output = usize;
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) -> usize {
        self.points.fill(lanes.rays(), self.view, self.origins, self.first as u32)
    }
}

/// Makes points of a chunk's rays and sorts them by cell; the rectangle that holds them, with their least nearness, and the largest.
pub(super) struct Sort<'a> {
    pub view: &'a View,
    pub origins: &'a [Vec3],
    /// Place of the first in the caller's list.
    pub first: usize,
    pub grid: &'a Grid,
    pub chunk: &'a mut Chunk,
}

impl Work for Sort<'_> {
    type Output = (Rect, f32);
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) -> (Rect, f32) {
        let Chunk { points, len, cells, sorted, starts } = self.chunk;
        *len = points.fill(lanes.rays(), self.view, self.origins, self.first as u32);
        let len = *len;
        starts.clear();
        starts.resize(CELLS + 1, 0);
        let rays = lanes.rays();
        cells.resize(len + SLACK, 0);
        let mut cell = Cell::NONE;
        for at in (0..len).step_by(L::Rays::WIDTH) {
            let some = &mut cells[at..at + L::Rays::WIDTH];
            let (x, y) = (rays.load(&points.x[at..]), rays.load(&points.y[at..]));
            let mut rest = first(len - at) & L::Rays::ALL;
            let mut members = rest & cell.members(rays, x, y);
            some.fill(cell.index as u16);
            loop {
                starts[cell.index + 1] += members.count_ones();
                rest &= !members;
                if rest == 0 {
                    break;
                }
                let next = rest.trailing_zeros() as usize;
                cell = self.grid.cell(rays, points.x[at + next], points.y[at + next]);
                // The point itself, even if it lay at no number.
                members = rest & (cell.members(rays, x, y) | 1 << next);
                let mut left = members;
                while left != 0 {
                    some[left.trailing_zeros() as usize] = cell.index as u16;
                    left &= left - 1;
                }
            }
        }
        cells.truncate(len);
        for cell in 0..CELLS {
            starts[cell + 1] += starts[cell];
        }
        if sorted.len() < len {
            sorted.resize(len, Place::default());
        }
        let mut next = [0; CELLS];
        next.copy_from_slice(&starts[..CELLS]);
        let rows = points.x.iter().zip(&points.y).zip(&points.z).zip(&points.ids);
        for (i, (cell, (((x, y), z), id))) in cells.iter().zip(rows).enumerate() {
            if let Some(ahead) = cells.get(i + AHEAD) {
                prefetch(&sorted[next[*ahead as usize % CELLS] as usize]);
            }
            let next = &mut next[*cell as usize % CELLS];
            let to = *next as usize;
            *next += 1;
            sorted[to] = Place { x: *x, y: *y, z: *z, id: *id };
        }
        points.bounds(lanes.rays(), 0, len)
    }
}

/// Which of some triangles meet each cell.
#[derive(Default)]
pub(super) struct Filed {
    /// Triangles with their cells, before they are sorted.
    pairs: Vec<(u32, u16)>,
    /// Where each cell's begin in `members`, and where the last one's end.
    starts: Vec<u32>,
    /// Places among the items.
    members: Vec<u32>,
    /// Those that meet more than [`MOST`] cells.
    large: Vec<u32>,
}

impl Filed {
    /// Appends a cell's triangles to a list that holds `at`; how many.
    #[inline(always)]
    pub fn append(&self, cell: usize, items: &[Item], to: &mut Lists, at: usize) -> usize {
        let members = &self.members[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        to.append(members.iter().map(|i| &items[*i as usize]), members.len(), at)
    }

    /// Appends those that all cells look at to a list that holds `at`; how many.
    pub fn append_large(&self, items: &[Item], to: &mut Lists, at: usize) -> usize {
        to.append(self.large.iter().map(|i| &items[*i as usize]), self.large.len(), at)
    }
}

/// Finds the cells that triangles meet.
pub(super) struct File<'a> {
    pub grid: &'a Grid,
    /// Cells that hold points.
    pub is_used: &'a [bool],
    /// The rectangle of all points, with their least nearness.
    pub rect: &'a Rect,
    pub items: &'a [Item],
    /// Place of the first.
    pub first: usize,
    pub filed: &'a mut Filed,
}

impl Work for File<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let File { grid, is_used, rect, items, first, filed } = self;
        let lanes = lanes.rays();
        let Filed { pairs, starts, members, large } = filed;
        starts.clear();
        starts.resize(CELLS + 1, 0);
        large.clear();
        pairs.clear();
        let mut cell = Cell::NONE;
        for (i, item) in items.iter().enumerate() {
            let r = &item.rect;
            let meets = r.x0 <= rect.x1 && rect.x0 <= r.x1 && r.y0 <= rect.y1 && rect.y0 <= r.y1;
            if !meets || r.z < rect.z {
                continue;
            }
            if cell.holds(r) {
                if is_used[cell.index] {
                    pairs.push(((first + i) as u32, cell.index as u16));
                }
                continue;
            }
            cell = grid.cell(lanes, r.x0, r.y0);
            let begin = pairs.len();
            for cell in grid.columns_met(lanes, r).flatten() {
                if is_used[cell] {
                    pairs.push(((first + i) as u32, cell as u16));
                }
                if pairs.len() - begin > MOST {
                    break;
                }
            }
            if pairs.len() - begin > MOST {
                pairs.truncate(begin);
                large.push((first + i) as u32);
            }
        }
        for (_, cell) in pairs.iter() {
            starts[*cell as usize + 1] += 1;
        }
        for cell in 0..CELLS {
            starts[cell + 1] += starts[cell];
        }
        let mut next = [0; CELLS];
        next.copy_from_slice(&starts[..CELLS]);
        members.clear();
        members.resize(pairs.len(), 0);
        for &(item, cell) in pairs.iter() {
            let next = &mut next[cell as usize % CELLS];
            members[*next as usize] = item;
            *next += 1;
        }
    }
}
