//! One ray against eight boxes or eight triangles at a time.
//!
//! SIMD only proposes. Boxes are tested with the node margin of [`crate::slab`], so they cut off nothing that
//! counts; triangles by the edge functions and t; and each triangle that passes is put to the shared kernel's
//! own test, which decides. So every path gives the kernel's bits, whatever it proposes in whatever order.

use super::tree::{Block, Part, WideNode};
use crate::any_hit::AnyHit;
use crate::axes::permute;
use crate::lanes::NodeLanes;
use crate::lanes::watertight::{Edges, Vector, axes, plane_t, spread};
use crate::ray::{Hit, Ray};
use crate::slab::{Slab, Span, reciprocal};
use crate::triangle::{Shear, is_nearer};
use lt_math::glam::Vec3;

// No closure here may touch lanes: a closure does not inherit the instruction set that its caller is compiled for,
// and unless it is inlined in time, eight-wide operations become calls.

/// A ray spread over lanes for the box test.
#[derive(Clone, Copy)]
pub(crate) struct BoxRay<L: NodeLanes> {
    inverse: [L::F; 3],
    near: [L::F; 3],
    far: [L::F; 3],
    /// Index of the entry plane per axis.
    entry: [usize; 3],
    tmin: L::F,
}

impl<L: NodeLanes> BoxRay<L> {
    #[inline(always)]
    pub fn new(lanes: L, slab: &Slab, base: Vec3, tmin: f32) -> Self {
        let start = (base - slab.origin) * slab.inverse;
        let (near, far) = (start - slab.node_margin, start + slab.node_margin);
        Self::from_parts(lanes, slab.inverse, near, far, tmin)
    }

    /// From what is prepared already: the reciprocal direction, and where the ray meets the tree's base planes, less and
    /// plus the node margin.
    #[inline(always)]
    pub fn from_parts(lanes: L, inverse: Vec3, near: Vec3, far: Vec3, tmin: f32) -> Self {
        BoxRay {
            inverse: spread(lanes, inverse),
            near: spread(lanes, near),
            far: spread(lanes, far),
            entry: [
                usize::from(inverse.x < 0.0),
                2 + usize::from(inverse.y < 0.0),
                4 + usize::from(inverse.z < 0.0),
            ],
            tmin: lanes.splat(tmin),
        }
    }

    /// Where the ray enters each child, and which children it meets before `tmax`.
    #[inline(always)]
    pub fn test(&self, lanes: L, node: &WideNode, tmax: L::F) -> (L::F, u32) {
        let (nx, ny, nz) = (self.near(lanes, node, 0), self.near(lanes, node, 1), self.near(lanes, node, 2));
        let (fx, fy, fz) = (self.far(lanes, node, 0), self.far(lanes, node, 1), self.far(lanes, node, 2));
        let entry = lanes.max(lanes.max(nx, ny), lanes.max(nz, self.tmin));
        let exit = lanes.min(lanes.min(fx, fy), lanes.min(fz, tmax));
        (entry, lanes.le(entry, exit))
    }

    #[inline(always)]
    fn near(&self, lanes: L, node: &WideNode, axis: usize) -> L::F {
        let planes = lanes.load(&node.planes[self.entry[axis]]);
        lanes.mul_add(planes, self.inverse[axis], self.near[axis])
    }

    #[inline(always)]
    fn far(&self, lanes: L, node: &WideNode, axis: usize) -> L::F {
        let planes = lanes.load(&node.planes[self.entry[axis] ^ 1]);
        lanes.mul_add(planes, self.inverse[axis], self.far[axis])
    }
}

/// A ray spread over lanes for the triangle test.
#[derive(Clone, Copy)]
struct TriangleRay<L: NodeLanes> {
    /// The axes that become x, y and z, and the origin along them.
    axes: [usize; 3],
    origin: Vector<L>,
    shear: Vector<L>,
    tmin: L::F,
    tmax: L::F,
}

impl<L: NodeLanes> TriangleRay<L> {
    #[inline(always)]
    fn new(lanes: L, shear: &Shear, ray: &Ray) -> Self {
        TriangleRay {
            axes: axes(shear.axis as usize),
            origin: spread(lanes, permute(shear.origin, shear.axis)),
            shear: spread(lanes, Vec3::new(shear.x, shear.y, shear.z)),
            tmin: lanes.splat(ray.tmin),
            tmax: lanes.splat(ray.tmax),
        }
    }

    /// The triangles of a block that pass the kernel's arithmetic but for its test of their own boxes: at least all
    /// that the ray hits.
    #[inline(always)]
    fn test(&self, lanes: L, block: Block) -> u32 {
        let rows = [block.rows(self.axes[0]), block.rows(self.axes[1]), block.rows(self.axes[2])];
        let triangles = [vertex(lanes, rows, 0), vertex(lanes, rows, 1), vertex(lanes, rows, 2)];
        let edges = Edges::new(lanes, triangles, self.origin, [self.shear[0], self.shear[1]]);
        let inside = edges.hold(lanes) & block.lanes();
        if inside == 0 {
            return 0;
        }
        let t = plane_t(lanes, triangles, self.origin, self.shear);
        inside & lanes.le(self.tmin, t) & lanes.le(t, self.tmax)
    }
}

/// One vertex of eight triangles, in the axes of a ray.
#[inline(always)]
fn vertex<L: NodeLanes>(lanes: L, rows: [[&[f32]; 3]; 3], vertex: usize) -> Vector<L> {
    [lanes.load(rows[0][vertex]), lanes.load(rows[1][vertex]), lanes.load(rows[2][vertex])]
}

/// What follows from a direction alone: rays to a sun share it.
#[derive(Clone, Copy)]
pub(crate) struct Aim {
    direction: Vec3,
    inverse: Vec3,
    /// Of a ray from the origin.
    shear: Shear,
}

impl Aim {
    /// Along a valid direction.
    #[inline(always)]
    pub fn new(direction: Vec3) -> Self {
        Aim { direction, inverse: reciprocal(direction), shear: Shear::along(Vec3::ZERO, direction) }
    }

    /// Whether it is that of a ray.
    #[inline(always)]
    pub fn is_of(&self, ray: &Ray) -> bool {
        self.direction == ray.direction
    }
}

/// A ray ready for one tree.
pub(crate) struct Prepared<L: NodeLanes> {
    pub ray: Ray,
    slab: Slab,
    shear: Shear,
    triangles: TriangleRay<L>,
    pub boxes: BoxRay<L>,
    window: Span,
}

impl<L: NodeLanes> Prepared<L> {
    #[inline(always)]
    pub fn new(lanes: L, ray: Ray, tree: &super::tree::SimdTree, window: Span) -> Self {
        Self::aimed(lanes, &Aim::new(ray.direction), ray, tree, window)
    }

    /// The same, given its aim.
    #[inline(always)]
    pub fn aimed(lanes: L, aim: &Aim, ray: Ray, tree: &super::tree::SimdTree, window: Span) -> Self {
        let slab = Slab::from_inverse(ray.origin, aim.inverse, tree.low, tree.high);
        let shear = Shear { origin: ray.origin, ..aim.shear };
        let boxes = BoxRay::new(lanes, &slab, tree.base, ray.tmin);
        Self::from_parts(lanes, ray, slab, shear, boxes, window)
    }

    /// From what is prepared already.
    #[inline(always)]
    pub fn from_parts(lanes: L, ray: Ray, slab: Slab, shear: Shear, boxes: BoxRay<L>, window: Span) -> Self {
        Prepared { ray, slab, shear, triangles: TriangleRay::new(lanes, &shear, &ray), boxes, window }
    }

    /// Whether a block of triangles blocks the ray.
    #[inline(always)]
    pub fn is_blocked_by<A: AnyHit>(&self, lanes: L, part: Part, block: u32, any_hit: A) -> bool {
        let block = part.tree.block(block);
        let mut candidates = self.triangles.test(lanes, block);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize & 7;
            candidates &= candidates - 1;
            let index = part.first_triangle + block.triangle(lane);
            let triangle = &part.triangles[index as usize];
            let hit = self.shear.intersect(&self.ray, &self.slab, triangle, self.window);
            let is_hit = hit.is_hit && hit.t > self.ray.tmin && hit.t < self.ray.tmax;
            if is_hit && (triangle.is_opaque() || any_hit.accepts(index, hit.u, hit.v)) {
                return true;
            }
        }
        false
    }

    /// The better of `best` and the hits in a block of triangles.
    #[inline(always)]
    pub fn nearest_of<A: AnyHit>(
        &self,
        lanes: L,
        part: Part,
        block: u32,
        instance: u32,
        any_hit: A,
        mut best: Hit,
    ) -> Hit {
        let block = part.tree.block(block);
        let mut candidates = self.triangles.test(lanes, block);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize & 7;
            candidates &= candidates - 1;
            let index = part.first_triangle + block.triangle(lane);
            let triangle = &part.triangles[index as usize];
            let hit = self.shear.intersect(&self.ray, &self.slab, triangle, self.window);
            let is_hit = hit.is_hit && hit.t > self.ray.tmin && is_nearer(hit.t, index, instance, &best);
            if is_hit && (triangle.is_opaque() || any_hit.accepts(index, hit.u, hit.v)) {
                best = Hit { t: hit.t, u: hit.u, v: hit.v, triangle: index, instance };
            }
        }
        best
    }
}
