//! Up to 64 rays side by side, and how a packet of them meets boxes and triangles.
//!
//! Ray lanes do the kernel's own arithmetic, operation by operation ([`crate::slab`], [`crate::triangle`]), so that a hit
//! found here needs no second opinion. Rays of a packet agree in the signs of their directions and in the
//! largest component, which makes every choice that the kernel makes per ray one per packet.

use super::lanes::{Lanes, NodeLanes};
use super::prepared::{BoxRay, Prepared};
use super::tree::{Block, SimdTree, WideNode};
use crate::ray::Ray;
use crate::slab::{LEAST_COMPONENT, NODE_MARGIN, Slab, Span, TRIANGLE_MARGIN};
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

    /// What kind the first of `rays` is of, and how many follow it, up to a packet's worth, that are of the same.
    #[inline(always)]
    pub fn run(rays: &[Ray]) -> (Option<Self>, usize) {
        let Some(first) = rays.first() else { return (None, 0) };
        let kind = Self::of(first);
        let others = rays.iter().take(PACKET).skip(1).take_while(|ray| Self::of(ray) == kind);
        (kind, 1 + others.count())
    }
}

/// Rays of one kind, prepared for one tree.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Packet {
    origin: [Column; 3],
    inverse: [Column; 3],
    /// Where the ray meets the tree's base planes, less and plus the node margin.
    near: [Column; 3],
    far: [Column; 3],
    triangle_margin: [Column; 3],
    shear: [Column; 3],
    tmin: Column,
    tmax: Column,
    window_near: Column,
    window_far: Column,
    /// As they came.
    rays: [Ray; PACKET],
    kind: Kind,
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

/// Bounds of everything that a packet's box test depends on.
#[derive(Clone, Copy)]
pub(crate) struct Frustum<L: Lanes> {
    /// Origins from the tree's base, as the entry planes and as the exit planes see them worst.
    origin_near: [L::F; 3],
    origin_far: [L::F; 3],
    inverse_low: [L::F; 3],
    inverse_high: [L::F; 3],
    margin: [L::F; 3],
    tmin: L::F,
    tmax: L::F,
    entry: [usize; 3],
    is_parallel: bool,
}

#[inline(always)]
fn least(column: &Column) -> f32 {
    let mut lanes = [column[0]; 16];
    for chunk in column.chunks_exact(16) {
        for i in 0..16 {
            lanes[i] = if chunk[i] < lanes[i] { chunk[i] } else { lanes[i] };
        }
    }
    lanes.iter().fold(lanes[0], |a, &b| if b < a { b } else { a })
}

#[inline(always)]
fn most(column: &Column) -> f32 {
    let mut lanes = [column[0]; 16];
    for chunk in column.chunks_exact(16) {
        for i in 0..16 {
            lanes[i] = if chunk[i] > lanes[i] { chunk[i] } else { lanes[i] };
        }
    }
    lanes.iter().fold(lanes[0], |a, &b| if b > a { b } else { a })
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
fn bits_at<R: Lanes>(mask: u64, at: usize) -> u32 {
    (mask >> at) as u32 & (u32::MAX >> (32 - R::WIDTH))
}

impl Packet {
    pub fn empty() -> Self {
        let zero = [0.0; PACKET];
        Packet {
            origin: [zero; 3],
            inverse: [zero; 3],
            near: [zero; 3],
            far: [zero; 3],
            triangle_margin: [zero; 3],
            shear: [zero; 3],
            tmin: zero,
            tmax: zero,
            window_near: zero,
            window_far: zero,
            rays: [Ray::default(); PACKET],
            kind: Kind { is_negative: [false; 3], axis: 0 },
            len: 0,
        }
    }

    /// Takes up to [`PACKET`] rays of one kind, each of which looks at its window only. At least one ray.
    #[inline(always)]
    pub fn fill(&mut self, kind: Kind, rays: &[Ray], windows: &[Span]) {
        self.kind = kind;
        self.len = 0;
        for ((ray, window), i) in rays.iter().zip(windows).zip(0..PACKET) {
            for axis in 0..3 {
                self.origin[axis][i] = ray.origin[axis];
                // Until `prepare` turns it around.
                self.inverse[axis][i] = ray.direction[axis];
            }
            self.tmin[i] = ray.tmin;
            self.tmax[i] = ray.tmax;
            self.window_near[i] = window.near;
            self.window_far[i] = window.far;
            self.rays[i] = *ray;
            self.len = i + 1;
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
        // Twice a triangle's margin is a node's, exactly.
        let node_margin = triangle_margin * 2.0;
        Slab { origin: at(&self.origin), inverse: at(&self.inverse), node_margin, triangle_margin }
    }

    /// One ray, ready for the boxes of a node.
    #[inline(always)]
    pub fn boxes<L: NodeLanes>(&self, lanes: L, ray: usize) -> BoxRay<L> {
        let i = ray & (PACKET - 1);
        let at = |columns: &[Column; 3]| Vec3::new(columns[0][i], columns[1][i], columns[2][i]);
        BoxRay::from_parts(lanes, at(&self.inverse), at(&self.near), at(&self.far), self.tmin[i])
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
        while at < PACKET {
            let direction = [
                piece(rays, &self.inverse[0], at),
                piece(rays, &self.inverse[1], at),
                piece(rays, &self.inverse[2], at),
            ];
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
            let node_reach = rays.mul(reach, rays.splat(NODE_MARGIN));
            let triangle_reach = rays.mul(reach, rays.splat(TRIANGLE_MARGIN));
            for axis in 0..3 {
                let d = direction[axis];
                let magnitude = rays.max(rays.max(d, rays.sub(zero, d)), least);
                let one = rays.splat(if kind.is_negative[axis] { -1.0 } else { 1.0 });
                let inverse = rays.div(one, magnitude);
                let absolute = rays.max(inverse, rays.sub(zero, inverse));
                let node_margin = rays.mul(absolute, node_reach);
                let o = piece(rays, &self.origin[axis], at);
                let start = rays.mul(rays.sub(rays.splat(tree.base[axis]), o), inverse);
                set(rays, &mut self.inverse[axis], at, inverse);
                set(rays, &mut self.near[axis], at, rays.sub(start, node_margin));
                set(rays, &mut self.far[axis], at, rays.add(start, node_margin));
                set(rays, &mut self.triangle_margin[axis], at, rays.mul(absolute, triangle_reach));
            }
            at += R::WIDTH;
        }
    }

    /// Fills the places behind the last ray with copies of the first, which no minimum or maximum notices.
    #[inline(always)]
    fn pad(&mut self) {
        let len = self.len;
        let pad = |column: &mut Column| {
            let first = column[0];
            column[len..].fill(first);
        };
        self.origin.iter_mut().for_each(pad);
        self.inverse.iter_mut().for_each(pad);
        pad(&mut self.tmin);
        pad(&mut self.tmax);
        pad(&mut self.window_near);
        pad(&mut self.window_far);
    }

    /// Bounds of the packet for its box test; `tree` is that of [`Packet::prepare`].
    #[inline(always)]
    pub fn frustum<L: Lanes>(&self, lanes: L, tree: &SimdTree) -> Frustum<L> {
        let zero = lanes.splat(0.0);
        let mut frustum = Frustum {
            origin_near: [zero; 3],
            origin_far: [zero; 3],
            inverse_low: [zero; 3],
            inverse_high: [zero; 3],
            margin: [zero; 3],
            tmin: lanes.splat(least(&self.tmin)),
            tmax: lanes.splat(most(&self.tmax)),
            entry: [0; 3],
            is_parallel: true,
        };
        for axis in 0..3 {
            let is_negative = self.kind.is_negative[axis];
            let (low, high) = (least(&self.origin[axis]), most(&self.origin[axis]));
            let (near, far) = if is_negative { (low, high) } else { (high, low) };
            let (inverse_low, inverse_high) = (least(&self.inverse[axis]), most(&self.inverse[axis]));
            frustum.origin_near[axis] = lanes.splat(near - tree.base[axis]);
            frustum.origin_far[axis] = lanes.splat(far - tree.base[axis]);
            frustum.inverse_low[axis] = lanes.splat(inverse_low);
            frustum.inverse_high[axis] = lanes.splat(inverse_high);
            // Twice a triangle's margin is a node's.
            frustum.margin[axis] = lanes.splat(most(&self.triangle_margin[axis]) * 2.0);
            frustum.entry[axis] = 2 * axis + usize::from(is_negative);
            frustum.is_parallel &= inverse_low == inverse_high;
        }
        frustum
    }

    /// Which rays of `mask` meet the box of a node's child between their ends.
    #[inline(always)]
    pub fn meets<R: Lanes>(&self, rays: R, node: &WideNode, child: usize, mask: u64) -> u64 {
        let k = self.kind.is_negative;
        let plane = |index: usize| node.planes[index][child & 7];
        let nx = rays.splat(plane(usize::from(k[0])));
        let ny = rays.splat(plane(2 + usize::from(k[1])));
        let nz = rays.splat(plane(4 + usize::from(k[2])));
        let fx = rays.splat(plane(usize::from(!k[0])));
        let fy = rays.splat(plane(2 + usize::from(!k[1])));
        let fz = rays.splat(plane(4 + usize::from(!k[2])));
        let mut found = 0;
        let mut at = 0;
        while at < PACKET {
            if bits_at::<R>(mask, at) != 0 {
                let ix = piece(rays, &self.inverse[0], at);
                let iy = piece(rays, &self.inverse[1], at);
                let iz = piece(rays, &self.inverse[2], at);
                let ex = rays.mul_add(nx, ix, piece(rays, &self.near[0], at));
                let ey = rays.mul_add(ny, iy, piece(rays, &self.near[1], at));
                let ez = rays.mul_add(nz, iz, piece(rays, &self.near[2], at));
                let lx = rays.mul_add(fx, ix, piece(rays, &self.far[0], at));
                let ly = rays.mul_add(fy, iy, piece(rays, &self.far[1], at));
                let lz = rays.mul_add(fz, iz, piece(rays, &self.far[2], at));
                let entry = rays.max(rays.max(ex, ey), rays.max(ez, piece(rays, &self.tmin, at)));
                let exit = rays.min(rays.min(lx, ly), rays.min(lz, piece(rays, &self.tmax, at)));
                found |= u64::from(rays.le(entry, exit)) << at;
            }
            at += R::WIDTH;
        }
        found & mask
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
                    let sz = piece(rays, &self.shear[2], at);
                    let (az, bz, cz) = (rays.mul(sz, a.2), rays.mul(sz, b.2), rays.mul(sz, c.2));
                    let ab = rays.add(rays.mul(u, az), rays.mul(v, bz));
                    let sum = rays.add(rays.add(u, v), w);
                    let t = rays.div(rays.add(ab, rays.mul(w, cz)), sum);
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

type Projected<R> = (<R as Lanes>::F, <R as Lanes>::F, <R as Lanes>::F);

/// `Shear::apply` less the scaling of z.
#[inline(always)]
fn project<R: Lanes>(
    rays: R,
    block: Block,
    (vertex, lane): (usize, usize),
    axes: (usize, usize, usize),
    origin: Projected<R>,
    shear: (R::F, R::F),
) -> Projected<R> {
    let depth = rays.sub(rays.splat(block.coordinate(vertex, axes.2, lane)), origin.2);
    let x = rays.sub(rays.splat(block.coordinate(vertex, axes.0, lane)), origin.0);
    let y = rays.sub(rays.splat(block.coordinate(vertex, axes.1, lane)), origin.1);
    (rays.sub(x, rays.mul(shear.0, depth)), rays.sub(y, rays.mul(shear.1, depth)), depth)
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

impl<L: NodeLanes> Frustum<L> {
    /// Which children any ray of the packet may meet.
    #[inline(always)]
    pub fn test(&self, lanes: L, node: &WideNode) -> u32 {
        let (nx, ny, nz) = (self.near(lanes, node, 0), self.near(lanes, node, 1), self.near(lanes, node, 2));
        let (fx, fy, fz) = (self.far(lanes, node, 0), self.far(lanes, node, 1), self.far(lanes, node, 2));
        let entry = lanes.max(lanes.max(nx, ny), lanes.max(nz, self.tmin));
        let exit = lanes.min(lanes.min(fx, fy), lanes.min(fz, self.tmax));
        lanes.le(entry, exit)
    }

    #[inline(always)]
    fn near(&self, lanes: L, node: &WideNode, axis: usize) -> L::F {
        let from = lanes.sub(lanes.load(&node.planes[self.entry[axis]]), self.origin_near[axis]);
        let mut t = lanes.mul(from, self.inverse_low[axis]);
        if !self.is_parallel {
            t = lanes.min(t, lanes.mul(from, self.inverse_high[axis]));
        }
        lanes.sub(t, self.margin[axis])
    }

    #[inline(always)]
    fn far(&self, lanes: L, node: &WideNode, axis: usize) -> L::F {
        let from = lanes.sub(lanes.load(&node.planes[self.entry[axis] ^ 1]), self.origin_far[axis]);
        let mut t = lanes.mul(from, self.inverse_low[axis]);
        if !self.is_parallel {
            t = lanes.max(t, lanes.mul(from, self.inverse_high[axis]));
        }
        lanes.add(t, self.margin[axis])
    }
}
