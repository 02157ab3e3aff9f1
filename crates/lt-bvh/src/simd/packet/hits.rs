//! How a packet's rays hit triangles: eight or sixteen rays per triangle, by all of the kernel's arithmetic.

use super::super::lanes::Lanes;
use super::super::tree::Block;
use super::{Column, PACKET, Packet, axes, bits_at, piece, set};
use lt_math::glam::Vec3;

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

impl Packet {
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
