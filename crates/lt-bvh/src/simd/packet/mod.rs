//! Up to 64 rays side by side, ready for one tree.
//!
//! Ray lanes do the kernel's own arithmetic, operation by operation ([`crate::slab`], [`crate::triangle`]), so that a hit
//! found here needs no second opinion. Rays of a packet agree in the signs of their directions and in the
//! largest component, which makes every choice that the kernel makes per ray one per packet.
//!
//! How they meet a node's boxes together is in [`frusta`], one by one in [`record`]; how they meet triangles in [`hits`], and which
//! they cannot meet in [`points`].

mod frusta;
mod hits;
mod points;
mod record;

use super::prepared::{BoxRay, Prepared};
use super::tree::SimdTree;
use crate::lanes::watertight::axes;
use crate::lanes::{Lanes, NodeLanes, prefetch};
use crate::ray::{COORDINATE_LIMIT, Ray};
use crate::slab::{LEAST_COMPONENT, NODE_MARGIN, Slab, Span, TRIANGLE_MARGIN, WHOLE_RAY};
use crate::triangle::Shear;
pub(crate) use frusta::Frusta;
pub(crate) use hits::Weights;
use lt_math::glam::Vec3;
use record::{NO_RECORD, Record};

/// Rays in a packet: one bit each in a mask.
pub(crate) const PACKET: usize = 64;

/// One number of every ray.
type Column = [f32; PACKET];

/// What the rays of a packet have in common: signs of the direction, and its largest component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kind {
    is_negative: [bool; 3],
    axis: usize,
}

/// Directions shorter than this are left to single rays: the reciprocals of longer ones cannot overflow when multiplied by
/// any distance, so that no NaN arises and lanes choose as the kernel's `min` and `max` do.
const SHORTEST: f32 = 1.0e-6;

/// A node's margin in triangles' margins: a power of two, so that one follows from the other exactly.
const NODE_PER_TRIANGLE: f32 = NODE_MARGIN / TRIANGLE_MARGIN;

impl Kind {
    /// `None` for a ray that no packet takes: an invalid one, or one with a very short direction.
    #[inline(always)]
    pub fn of(ray: &Ray) -> Option<Self> {
        let d = ray.direction.abs();
        let axis = if d.x >= d.y && d.x >= d.z {
            0
        } else if d.y >= d.z {
            1
        } else {
            2
        };
        if !(ray.is_valid() && d[axis] >= SHORTEST) {
            return None;
        }
        let d = ray.direction;
        Some(Kind { is_negative: [d.x < 0.0, d.y < 0.0, d.z < 0.0], axis })
    }
}

/// Whether all rays have the direction of the first, a valid one, and origins as valid.
#[inline(always)]
fn are_parallel<L: NodeLanes>(lanes: L, rays: &[Ray]) -> bool {
    // A ray is eight numbers: those of the origin lie between limits, those of the direction at one place, and its ends anywhere.
    let (d, limit) = (rays[0].direction, COORDINATE_LIMIT.next_down());
    let least = lanes.load(&[-limit, -limit, -limit, 0.0, d.x, d.y, d.z, 0.0]);
    let most = lanes.load(&[limit, limit, limit, 0.0, d.x, d.y, d.z, 0.0]);
    let mut all = L::ALL;
    for ray in rays {
        let ray = lanes.load(bytemuck::cast_ref::<Ray, [f32; 8]>(ray));
        all &= lanes.le(least, ray) & lanes.le(ray, most);
    }
    all | ENDS == L::ALL
}

/// Where the ends stand among a ray's numbers.
const ENDS: u32 = 0b1000_1000;

/// Neighbours in a batch that one packet can take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    /// `None` for rays that no packet takes.
    pub kind: Option<Kind>,
    /// How many rays, from the first.
    pub len: usize,
    /// Whether all directions are the same.
    is_parallel: bool,
}

impl Run {
    /// The first of `rays` and those like it that follow, up to a packet's worth.
    #[inline(always)]
    pub fn first<L: NodeLanes>(lanes: L, rays: &[Ray]) -> Self {
        let Some(first) = rays.first() else { return Run { kind: None, len: 0, is_parallel: true } };
        let mut run = Run { kind: Kind::of(first), len: 1, is_parallel: true };
        let most = &rays[..rays.len().min(PACKET)];
        rays.iter().skip(PACKET).take(PACKET).step_by(2).for_each(prefetch);
        if run.kind.is_some() && are_parallel(lanes, most) {
            return Run { len: most.len(), ..run };
        }
        for ray in rays.iter().take(PACKET).skip(1) {
            // Under a sun all directions are the same, and only origins differ.
            let is_same = ray.direction == first.direction;
            let is_alike = if is_same && run.kind.is_some() {
                ray.is_valid()
            } else {
                run.is_parallel &= is_same;
                Kind::of(ray) == run.kind
            };
            if !is_alike {
                break;
            }
            run.len += 1;
        }
        run
    }
}

/// Which children of a node rays meet.
pub(crate) struct Reached {
    /// For each child the mask of the rays that meet it.
    pub rays: [u64; 8],
    /// Those that any ray meets.
    pub children: u32,
}

impl Reached {
    #[inline(always)]
    fn new<L: NodeLanes>(lanes: L, sets: L::Sets) -> Self {
        Reached { rays: lanes.stored_sets(sets), children: lanes.filled(sets) }
    }
}

/// Rays of one kind, prepared for one tree.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Packet {
    origin: [Column; 3],
    inverse: [Column; 3],
    /// Where the ray meets the tree's base planes.
    start: [Column; 3],
    triangle_margin: [Column; 3],
    shear: [Column; 3],
    tmin: Column,
    tmax: Column,
    window_near: Column,
    window_far: Column,
    /// x and y of parallel rays in the plane across them, from the first ray's.
    points: [Column; 2],
    /// The greatest distance along an axis from an origin to the tree's root box.
    reach: f32,
    /// What the test of one ray against eight boxes needs, for the rays of `recorded`.
    records: [Record; PACKET],
    recorded: u64,
    /// As they came.
    rays: [Ray; PACKET],
    kind: Kind,
    /// Whether all directions are the same.
    is_parallel: bool,
    /// Rays in use, from the first.
    len: usize,
}

/// The lanes' worth of a column that starts at ray `at`, a multiple of the width.
#[inline(always)]
fn piece<R: Lanes>(rays: R, column: &Column, at: usize) -> R::F {
    // The mask keeps it within the column without a check.
    let at = at & (PACKET - R::WIDTH);
    rays.load(&column[at..at + R::WIDTH])
}

#[inline(always)]
fn set<R: Lanes>(rays: R, column: &mut Column, at: usize, value: R::F) {
    let at = at & (PACKET - R::WIDTH);
    rays.store(value, &mut column[at..at + R::WIDTH]);
}

/// Bits of the rays `at` to `at + WIDTH` of a mask.
#[inline(always)]
pub(crate) fn bits_at<R: Lanes>(mask: u64, at: usize) -> u32 {
    (mask >> at) as u32 & (u32::MAX >> (32 - R::WIDTH))
}

impl Packet {
    pub fn empty() -> Self {
        let zero = [0.0; PACKET];
        Packet {
            origin: [zero; 3],
            inverse: [zero; 3],
            start: [zero; 3],
            triangle_margin: [zero; 3],
            shear: [zero; 3],
            tmin: zero,
            tmax: zero,
            window_near: [WHOLE_RAY.near; PACKET],
            window_far: [WHOLE_RAY.far; PACKET],
            points: [zero; 2],
            reach: 0.0,
            records: [NO_RECORD; PACKET],
            recorded: 0,
            rays: [Ray::default(); PACKET],
            kind: Kind { is_negative: [false; 3], axis: 0 },
            is_parallel: true,
            len: 0,
        }
    }

    /// Takes the rays of a run that has a kind. Each looks at its window only, where there are `windows`; a packet is given
    /// always some or never.
    #[inline(always)]
    pub fn fill(&mut self, kind: Kind, run: Run, rays: &[Ray], windows: Option<&[Span]>) {
        self.kind = kind;
        self.recorded = 0;
        self.is_parallel = run.is_parallel;
        self.len = run.len.clamp(1, PACKET);
        for (i, ray) in rays.iter().take(self.len).enumerate() {
            for axis in 0..3 {
                self.origin[axis][i] = ray.origin[axis];
            }
            self.tmin[i] = ray.tmin;
            self.tmax[i] = ray.tmax;
            self.rays[i] = *ray;
        }
        if !run.is_parallel {
            for (i, ray) in rays.iter().take(self.len).enumerate() {
                for axis in 0..3 {
                    // Until `prepare` turns it around.
                    self.inverse[axis][i] = ray.direction[axis];
                }
            }
        }
        for (i, window) in windows.unwrap_or_default().iter().take(self.len).enumerate() {
            self.window_near[i] = window.near;
            self.window_far[i] = window.far;
        }
    }

    /// One ray, prepared for the tree.
    #[inline(always)]
    pub fn single<L: NodeLanes>(&self, lanes: L, ray: usize) -> Prepared<L> {
        let i = ray & (PACKET - 1);
        let at = |columns: &[Column; 3]| Vec3::new(columns[0][i], columns[1][i], columns[2][i]);
        let (origin, shear) = (at(&self.origin), at(&self.shear));
        let shear = Shear { origin, axis: self.kind.axis as u32, x: shear.x, y: shear.y, z: shear.z };
        let window = Span { near: self.window_near[i], far: self.window_far[i] };
        let (start, margin) = (at(&self.start), at(&self.triangle_margin) * NODE_PER_TRIANGLE);
        let boxes =
            BoxRay::from_parts(lanes, at(&self.inverse), start - margin, start + margin, self.tmin[i]);
        Prepared::from_parts(lanes, self.rays[i], self.slab(i), shear, boxes, window)
    }

    /// One ray, ready for single boxes of the tree.
    #[inline(always)]
    pub fn slab(&self, ray: usize) -> Slab {
        let i = ray & (PACKET - 1);
        let at = |columns: &[Column; 3]| Vec3::new(columns[0][i], columns[1][i], columns[2][i]);
        let triangle_margin = at(&self.triangle_margin);
        let node_margin = triangle_margin * NODE_PER_TRIANGLE;
        Slab { origin: at(&self.origin), inverse: at(&self.inverse), node_margin, triangle_margin }
    }

    /// One ray, as it came.
    #[inline(always)]
    pub fn ray(&self, ray: usize) -> Ray {
        self.rays[ray & (PACKET - 1)]
    }

    /// How many groups of ray lanes a mask touches.
    #[inline(always)]
    pub fn groups_of<R: Lanes>(mask: u64) -> u32 {
        let mut groups = 0;
        let mut at = 0;
        while at < PACKET {
            groups += u32::from(bits_at::<R>(mask, at) != 0);
            at += R::WIDTH;
        }
        groups
    }

    /// Mask of all rays.
    #[inline(always)]
    pub fn all(&self) -> u64 {
        u64::MAX >> (PACKET - self.len.max(1))
    }

    /// Computes what the tests in `tree` need. At least one ray.
    #[inline(always)]
    pub fn prepare<R: Lanes>(&mut self, rays: R, tree: &SimdTree) {
        self.pad();
        let kind = self.kind;
        let [ix, iy, iz] = axes(kind.axis);
        let zero = rays.splat(0.0);
        let mut at = 0;
        let mut farthest = zero;
        let common = self.rays[0].direction;
        while at < self.len {
            let direction = if self.is_parallel {
                [rays.splat(common.x), rays.splat(common.y), rays.splat(common.z)]
            } else {
                [
                    piece(rays, &self.inverse[0], at),
                    piece(rays, &self.inverse[1], at),
                    piece(rays, &self.inverse[2], at),
                ]
            };
            // `Shear::new`
            let z = direction[iz];
            set(rays, &mut self.shear[0], at, rays.div(direction[ix], z));
            set(rays, &mut self.shear[1], at, rays.div(direction[iy], z));
            set(rays, &mut self.shear[2], at, rays.div(rays.splat(1.0), z));
            // `Slab::new`
            let longest = rays.max(z, rays.sub(zero, z));
            let least = rays.mul(longest, rays.splat(LEAST_COMPONENT));
            let mut reach = zero;
            for axis in 0..3 {
                let o = piece(rays, &self.origin[axis], at);
                let to_low = rays.sub(rays.splat(tree.low[axis]), o);
                let to_high = rays.sub(rays.splat(tree.high[axis]), o);
                reach = rays.max(reach, rays.max(to_low, rays.sub(zero, to_low)));
                reach = rays.max(reach, rays.max(to_high, rays.sub(zero, to_high)));
            }
            farthest = rays.max(farthest, reach);
            let triangle_reach = rays.mul(reach, rays.splat(TRIANGLE_MARGIN));
            for (axis, &d) in direction.iter().enumerate() {
                let magnitude = rays.max(rays.max(d, rays.sub(zero, d)), least);
                let one = rays.splat(if kind.is_negative[axis] { -1.0 } else { 1.0 });
                let inverse = rays.div(one, magnitude);
                let absolute = rays.max(inverse, rays.sub(zero, inverse));
                let o = piece(rays, &self.origin[axis], at);
                let start = rays.mul(rays.sub(rays.splat(tree.base[axis]), o), inverse);
                set(rays, &mut self.inverse[axis], at, inverse);
                set(rays, &mut self.start[axis], at, start);
                set(rays, &mut self.triangle_margin[axis], at, rays.mul(absolute, triangle_reach));
            }
            at += R::WIDTH;
        }
        let mut reaches = [0.0; 16];
        rays.store(farthest, &mut reaches);
        self.reach = reaches.into_iter().fold(0.0, f32::max);
        if self.is_parallel {
            self.place(rays);
        }
    }

    /// Fills the places behind the last ray with copies of the first, which no minimum or maximum notices.
    #[inline(always)]
    fn pad(&mut self) {
        let len = self.len;
        if len == PACKET {
            return;
        }
        let pad = |column: &mut Column| {
            let first = column[0];
            column[len..].fill(first);
        };
        self.origin.iter_mut().for_each(pad);
        self.inverse.iter_mut().for_each(pad);
        pad(&mut self.tmin);
        pad(&mut self.tmax);
    }
}
