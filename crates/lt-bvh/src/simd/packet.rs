//! Up to 64 rays side by side, and how a packet of them meets boxes and triangles.
//!
//! Ray lanes do the kernel's own arithmetic, operation by operation ([`crate::slab`], [`crate::triangle`]), so that a hit
//! found here needs no second opinion. Rays of a packet agree in the signs of their directions and in the
//! largest component, which makes every choice that the kernel makes per ray one per packet.

use super::lanes::{Lanes, NodeLanes};
use super::prepared::{BoxRay, Prepared};
use super::tree::{Block, SimdTree, WideNode};
use crate::ray::Ray;
use crate::slab::{LEAST_COMPONENT, NODE_MARGIN, Slab, Span, TRIANGLE_MARGIN, WHOLE_RAY};
use crate::triangle::Shear;
use lt_math::glam::Vec3;

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
    pub fn first(rays: &[Ray]) -> Self {
        let Some(first) = rays.first() else { return Run { kind: None, len: 0, is_parallel: true } };
        let mut run = Run { kind: Kind::of(first), len: 1, is_parallel: true };
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
    /// As they came.
    rays: [Ray; PACKET],
    kind: Kind,
    /// Whether all directions are the same.
    is_parallel: bool,
    /// Rays in use, from the first.
    len: usize,
}

/// Barycentric weights of the second and third vertex, per ray.
pub(crate) struct Weights {
    pub u: Column,
    pub v: Column,
}

impl Weights {
    pub fn none() -> Self {
        Weights { u: [0.0; PACKET], v: [0.0; PACKET] }
    }
}

/// Most groups of ray lanes in a packet.
const GROUPS: usize = PACKET / 8;

/// Bounds of everything that a box test depends on, for each group of ray lanes.
#[derive(Clone, Copy)]
pub(crate) struct Frusta<L: Lanes> {
    /// Where the origin of a group's rays lies, as the entry planes and as the exit planes see it worst. For parallel rays
    /// what is to be added to a plane's distance in units of t, else the origin itself, from the tree's base.
    near: [[f32; GROUPS]; 3],
    far: [[f32; GROUPS]; 3],
    inverse_low: [L::F; 3],
    inverse_high: [L::F; 3],
    margin: [L::F; 3],
    tmin: L::F,
    tmax: L::F,
    entry: [usize; 3],
    is_parallel: bool,
}

/// The planes of a node's children where rays enter and leave: for parallel rays in units of t, with the node margin, else
/// as the node has them.
pub(crate) struct Planes {
    near: [[f32; 8]; 3],
    far: [[f32; 8]; 3],
}

impl Planes {
    pub fn none() -> Self {
        Planes { near: [[0.0; 8]; 3], far: [[0.0; 8]; 3] }
    }
}

/// Smallest and largest of the first `len` numbers, a multiple of eight of them read.
#[inline(always)]
fn extremes(numbers: &[f32], len: usize) -> (f32, f32) {
    let (mut low, mut high) = ([numbers[0]; 8], [numbers[0]; 8]);
    for eight in numbers.chunks_exact(8).take(len.div_ceil(8)) {
        for i in 0..8 {
            low[i] = if eight[i] < low[i] { eight[i] } else { low[i] };
            high[i] = if eight[i] > high[i] { eight[i] } else { high[i] };
        }
    }
    let mut half = 4;
    while half > 0 {
        for i in 0..half {
            low[i] = if low[i + half] < low[i] { low[i + half] } else { low[i] };
            high[i] = if high[i + half] > high[i] { high[i + half] } else { high[i] };
        }
        half /= 2;
    }
    (low[0], high[0])
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
        Prepared::from_parts(self.rays[i], self.slab(i), shear, self.boxes(lanes, i), window)
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

    /// One ray, ready for the boxes of a node.
    #[inline(always)]
    pub fn boxes<L: NodeLanes>(&self, lanes: L, ray: usize) -> BoxRay<L> {
        let i = ray & (PACKET - 1);
        let at = |columns: &[Column; 3]| Vec3::new(columns[0][i], columns[1][i], columns[2][i]);
        let (start, margin) = (at(&self.start), at(&self.triangle_margin) * NODE_PER_TRIANGLE);
        BoxRay::from_parts(lanes, at(&self.inverse), start - margin, start + margin, self.tmin[i])
    }

    /// One ray, as it came.
    #[inline(always)]
    pub fn ray(&self, ray: usize) -> Ray {
        self.rays[ray & (PACKET - 1)]
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
        let (ix, iy, iz) = axes(kind.axis);
        let zero = rays.splat(0.0);
        let mut at = 0;
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

    /// Bounds of the packet's groups for their box tests; `tree` is that of [`Packet::prepare`].
    #[inline(always)]
    pub fn frusta<L: NodeLanes>(&self, lanes: L, tree: &SimdTree) -> Frusta<L> {
        let zero = lanes.splat(0.0);
        let mut frusta = Frusta {
            near: [[0.0; GROUPS]; 3],
            far: [[0.0; GROUPS]; 3],
            inverse_low: [zero; 3],
            inverse_high: [zero; 3],
            margin: [zero; 3],
            tmin: lanes.splat(extremes(&self.tmin, self.len).0),
            tmax: lanes.splat(extremes(&self.tmax, self.len).1),
            entry: [0; 3],
            is_parallel: self.is_parallel,
        };
        for axis in 0..3 {
            let is_negative = self.kind.is_negative[axis];
            let first = self.inverse[axis][0];
            let (low, high) =
                if self.is_parallel { (first, first) } else { extremes(&self.inverse[axis], self.len) };
            let margin = extremes(&self.triangle_margin[axis], self.len).1 * NODE_PER_TRIANGLE;
            frusta.inverse_low[axis] = lanes.splat(low);
            frusta.inverse_high[axis] = lanes.splat(high);
            frusta.margin[axis] = lanes.splat(margin);
            frusta.entry[axis] = 2 * axis + usize::from(is_negative);
            let mut at = 0;
            while at < self.len {
                let width = <L::Rays as Lanes>::WIDTH;
                let (least, most) = extremes(&self.origin[axis][at..at + width], width);
                let (near, far) = if is_negative { (least, most) } else { (most, least) };
                let (near, far) = (near - tree.base[axis], far - tree.base[axis]);
                let group = at / width;
                (frusta.near[axis][group], frusta.far[axis][group]) =
                    if self.is_parallel { (-(near * first), -(far * first)) } else { (near, far) };
                at += width;
            }
        }
        frusta
    }

    /// Which rays of the group that starts at `at` meet the box of a child between the packet's ends.
    #[inline(always)]
    pub fn meets<R: Lanes>(
        &self,
        rays: R,
        planes: &Planes,
        child: usize,
        at: usize,
        ends: (R::F, R::F),
    ) -> u32 {
        let child = child & 7;
        let mut entry = ends.0;
        let mut exit = ends.1;
        for axis in 0..3 {
            let near = rays.splat(planes.near[axis][child]);
            let far = rays.splat(planes.far[axis][child]);
            let start = piece(rays, &self.start[axis], at);
            if self.is_parallel {
                entry = rays.max(entry, rays.add(near, start));
                exit = rays.min(exit, rays.add(far, start));
            } else {
                let inverse = piece(rays, &self.inverse[axis], at);
                let margin =
                    rays.mul(piece(rays, &self.triangle_margin[axis], at), rays.splat(NODE_PER_TRIANGLE));
                entry = rays.max(entry, rays.sub(rays.mul_add(near, inverse, start), margin));
                exit = rays.min(exit, rays.add(rays.mul_add(far, inverse, start), margin));
            }
        }
        rays.le(entry, exit)
    }

    /// The packet's ends: the least tmin and the greatest tmax.
    #[inline(always)]
    pub fn ends<R: Lanes>(&self, rays: R) -> (R::F, R::F) {
        (rays.splat(extremes(&self.tmin, self.len).0), rays.splat(extremes(&self.tmax, self.len).1))
    }

    /// Which rays of `mask` hit a triangle of a block, by all of the kernel's arithmetic. The barycentric weights of their
    /// hits go to `weights`, if asked for.
    #[inline(always)]
    pub fn hits<R: Lanes, const WEIGHTS: bool>(
        &self,
        rays: R,
        block: Block,
        lane: usize,
        mask: u64,
        weights: &mut Weights,
    ) -> u64 {
        let (ix, iy, iz) = axes(self.kind.axis);
        let lane = lane & 7;
        let mut found = 0;
        let mut at = 0;
        while at < PACKET {
            if bits_at::<R>(mask, at) != 0 {
                let ox = piece(rays, &self.origin[ix], at);
                let oy = piece(rays, &self.origin[iy], at);
                let oz = piece(rays, &self.origin[iz], at);
                let sx = piece(rays, &self.shear[0], at);
                let sy = piece(rays, &self.shear[1], at);
                let a = project(rays, block, (0, lane), (ix, iy, iz), (ox, oy, oz), (sx, sy));
                let b = project(rays, block, (1, lane), (ix, iy, iz), (ox, oy, oz), (sx, sy));
                let c = project(rays, block, (2, lane), (ix, iy, iz), (ox, oy, oz), (sx, sy));
                let (u, v, w) = (cross(rays, c, b), cross(rays, a, c), cross(rays, b, a));
                let zero = rays.splat(0.0);
                let lowest = rays.min(rays.min(u, v), w);
                let highest = rays.max(rays.max(u, v), w);
                let inside = (rays.le(zero, lowest) | rays.le(highest, zero)) & bits_at::<R>(mask, at);
                if inside != 0 {
                    let sum = rays.add(rays.add(u, v), w);
                    // Where all three are zero the triangle is seen edge-on, and nothing is hit.
                    let inside = inside & (rays.lt(sum, zero) | rays.lt(zero, sum));
                    let t = self.plane_t(rays, block, lane, at);
                    let between = self.is_between(rays, t, at);
                    if inside & between != 0 {
                        let in_box = self.in_box(rays, block, lane, t, at);
                        found |= u64::from(inside & between & in_box) << at;
                        if WEIGHTS {
                            set(rays, &mut weights.u, at, rays.div(v, sum));
                            set(rays, &mut weights.v, at, rays.div(w, sum));
                        }
                    }
                }
            }
            at += R::WIDTH;
        }
        found
    }

    /// t at which the group's rays meet the triangle's plane, as the kernel computes it.
    #[inline(always)]
    fn plane_t<R: Lanes>(&self, rays: R, block: Block, lane: usize, at: usize) -> R::F {
        let (ix, iy, iz) = axes(self.kind.axis);
        let vertex = |vertex: usize| {
            let along = |axis: usize| block.coordinate(vertex, axis, lane);
            Vec3::new(along(ix), along(iy), along(iz))
        };
        let v0 = vertex(0);
        let (e, f) = (vertex(1) - v0, vertex(2) - v0);
        let normal = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
        let (nx, ny, nz) = (rays.splat(normal.x), rays.splat(normal.y), rays.splat(normal.z));
        let x = rays.sub(rays.splat(v0.x), piece(rays, &self.origin[ix], at));
        let y = rays.sub(rays.splat(v0.y), piece(rays, &self.origin[iy], at));
        let z = rays.sub(rays.splat(v0.z), piece(rays, &self.origin[iz], at));
        let distance = rays.add(rays.add(rays.mul(nx, x), rays.mul(ny, y)), rays.mul(nz, z));
        let along_x = rays.mul(nx, piece(rays, &self.shear[0], at));
        let along_y = rays.mul(ny, piece(rays, &self.shear[1], at));
        let slope = rays.add(rays.add(along_x, along_y), nz);
        rays.div(rays.mul(piece(rays, &self.shear[2], at), distance), slope)
    }

    /// A bit per lane where t lies between the ends of the ray.
    #[inline(always)]
    fn is_between<R: Lanes>(&self, rays: R, t: R::F, at: usize) -> u32 {
        rays.lt(piece(rays, &self.tmin, at), t) & rays.lt(t, piece(rays, &self.tmax, at))
    }

    /// The kernel's last condition: that the ray passes the triangle's own widened box, within its window, and that t
    /// clamped to that stretch is still between its ends.
    #[inline(always)]
    fn in_box<R: Lanes>(&self, rays: R, block: Block, lane: usize, t: R::F, at: usize) -> u32 {
        let mut near = piece(rays, &self.window_near, at);
        let mut far = piece(rays, &self.window_far, at);
        for axis in 0..3 {
            let (p, q, r) = (
                block.coordinate(0, axis, lane),
                block.coordinate(1, axis, lane),
                block.coordinate(2, axis, lane),
            );
            let (low, high) = (p.min(q).min(r), p.max(q).max(r));
            let (first, last) = if self.kind.is_negative[axis] { (high, low) } else { (low, high) };
            let o = piece(rays, &self.origin[axis], at);
            let inverse = piece(rays, &self.inverse[axis], at);
            let margin = piece(rays, &self.triangle_margin[axis], at);
            // Along a ray of known sign, min(a, b) is the entry plane's.
            let entry = rays.mul(rays.sub(rays.splat(first), o), inverse);
            let exit = rays.mul(rays.sub(rays.splat(last), o), inverse);
            near = rays.max(near, rays.sub(entry, margin));
            far = rays.min(far, rays.add(exit, margin));
        }
        let clamped = rays.min(rays.max(t, near), far);
        rays.le(near, far) & self.is_between(rays, clamped, at)
    }
}

type Projected<R> = (<R as Lanes>::F, <R as Lanes>::F);

/// `Shear::apply`.
#[inline(always)]
fn project<R: Lanes>(
    rays: R,
    block: Block,
    (vertex, lane): (usize, usize),
    axes: (usize, usize, usize),
    origin: (R::F, R::F, R::F),
    shear: (R::F, R::F),
) -> Projected<R> {
    let depth = rays.sub(rays.splat(block.coordinate(vertex, axes.2, lane)), origin.2);
    let x = rays.sub(rays.splat(block.coordinate(vertex, axes.0, lane)), origin.0);
    let y = rays.sub(rays.splat(block.coordinate(vertex, axes.1, lane)), origin.1);
    (rays.sub(x, rays.mul(shear.0, depth)), rays.sub(y, rays.mul(shear.1, depth)))
}

/// The kernel's edge function by the direct formula: the same value, in other order of vertices too.
#[inline(always)]
fn cross<R: Lanes>(rays: R, p: Projected<R>, q: Projected<R>) -> R::F {
    rays.sub(rays.mul(p.0, q.1), rays.mul(p.1, q.0))
}

/// The axes that the kernel calls x, y and z when `axis` is the direction's largest component.
#[inline(always)]
fn axes(axis: usize) -> (usize, usize, usize) {
    if axis == 0 {
        (1, 2, 0)
    } else if axis == 1 {
        (2, 0, 1)
    } else {
        (0, 1, 2)
    }
}

impl<L: NodeLanes> Frusta<L> {
    /// Reads a node's planes for [`Frusta::test`] and [`Packet::meets`].
    #[inline(always)]
    pub fn read(&self, lanes: L, node: &WideNode, planes: &mut Planes) {
        for axis in 0..3 {
            let near = lanes.load(&node.planes[self.entry[axis]]);
            let far = lanes.load(&node.planes[self.entry[axis] ^ 1]);
            if self.is_parallel {
                let (inverse, margin) = (self.inverse_low[axis], self.margin[axis]);
                lanes.store(lanes.sub(lanes.mul(near, inverse), margin), &mut planes.near[axis]);
                lanes.store(lanes.add(lanes.mul(far, inverse), margin), &mut planes.far[axis]);
            } else {
                lanes.store(near, &mut planes.near[axis]);
                lanes.store(far, &mut planes.far[axis]);
            }
        }
    }

    /// Which children any ray of a group may meet.
    #[inline(always)]
    pub fn test(&self, lanes: L, planes: &Planes, group: usize) -> u32 {
        let group = group & (GROUPS - 1);
        let mut entry = self.tmin;
        let mut exit = self.tmax;
        for axis in 0..3 {
            let near = lanes.load(&planes.near[axis]);
            let far = lanes.load(&planes.far[axis]);
            let (near_origin, far_origin) =
                (lanes.splat(self.near[axis][group]), lanes.splat(self.far[axis][group]));
            if self.is_parallel {
                entry = lanes.max(entry, lanes.add(near, near_origin));
                exit = lanes.min(exit, lanes.add(far, far_origin));
            } else {
                let (near, far) = (lanes.sub(near, near_origin), lanes.sub(far, far_origin));
                let (low, high) = (self.inverse_low[axis], self.inverse_high[axis]);
                let first = lanes.min(lanes.mul(near, low), lanes.mul(near, high));
                let last = lanes.max(lanes.mul(far, low), lanes.mul(far, high));
                entry = lanes.max(entry, lanes.sub(first, self.margin[axis]));
                exit = lanes.min(exit, lanes.add(last, self.margin[axis]));
            }
        }
        lanes.le(entry, exit)
    }
}
