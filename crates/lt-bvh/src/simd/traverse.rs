//! One ray against the wide tree: eight boxes or eight triangles per step.
//!
//! SIMD only proposes. Boxes are tested with the node margin of [`crate::slab`], so they cut off nothing that
//! counts; triangles by the edge functions and t; and each triangle that passes is put to the shared kernel's
//! own test, which decides. So every path gives the kernel's bits, whatever it proposes in whatever order.

use super::lanes::Lanes;
use super::tree::{LEAF, STACK, SimdTree, WideNode};
use crate::any_hit::AnyHit;
use crate::instance::Instance;
use crate::ray::{FAR, Hit, NONE, Ray};
use crate::slab::{Slab, Span};
use crate::triangle::{Shear, Triangle, is_nearer};
use lt_math::glam::Vec3;

/// Work memory of a batch, and what the last ray teaches the next.
pub(crate) struct Scratch {
    /// Links still to visit in a tree.
    links: [u32; STACK],
    /// Where the ray enters each of them.
    entries: [f32; STACK],
    /// The same for the tree of instances.
    instance_links: [u32; STACK],
    instance_entries: [f32; STACK],
    /// The block of triangles, and its instance, that blocked the last ray: its neighbour is likely blocked
    /// there too, and a ray that is blocked at all may be told so by any blocker.
    blocker: u32,
    blocking_instance: u32,
}

impl Scratch {
    pub fn new() -> Self {
        Scratch {
            links: [0; STACK],
            entries: [0.0; STACK],
            instance_links: [0; STACK],
            instance_entries: [0.0; STACK],
            blocker: NONE,
            blocking_instance: NONE,
        }
    }
}

/// A tree with the triangles its leaves name.
#[derive(Clone, Copy)]
pub(crate) struct Part<'a> {
    pub tree: &'a SimdTree,
    /// All triangles, and the first of this tree.
    pub triangles: &'a [Triangle],
    pub first_triangle: u32,
}

// No closure here may touch lanes: a closure does not inherit the instruction set that its caller is compiled for,
// and unless it is inlined in time, eight-wide operations become calls.

#[inline(always)]
fn spread<L: Lanes>(lanes: L, v: Vec3) -> [L::F; 3] {
    [lanes.splat(v.x), lanes.splat(v.y), lanes.splat(v.z)]
}

/// A ray spread over lanes for the box test.
#[derive(Clone, Copy)]
struct BoxRay<L: Lanes> {
    inverse: [L::F; 3],
    near: [L::F; 3],
    far: [L::F; 3],
    /// Index of the entry plane per axis.
    entry: [usize; 3],
    tmin: L::F,
}

impl<L: Lanes> BoxRay<L> {
    #[inline(always)]
    fn new(lanes: L, slab: &Slab, base: Vec3, tmin: f32) -> Self {
        let start = (base - slab.origin) * slab.inverse;
        let (near, far) = (start - slab.node_margin, start + slab.node_margin);
        BoxRay {
            inverse: spread(lanes, slab.inverse),
            near: spread(lanes, near),
            far: spread(lanes, far),
            entry: [
                usize::from(slab.inverse.x < 0.0),
                2 + usize::from(slab.inverse.y < 0.0),
                4 + usize::from(slab.inverse.z < 0.0),
            ],
            tmin: lanes.splat(tmin),
        }
    }

    /// Where the ray enters each child, and which children it meets before `tmax`.
    #[inline(always)]
    fn test(&self, lanes: L, node: &WideNode, tmax: L::F) -> (L::F, u32) {
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
struct TriangleRay<L: Lanes> {
    axes: [usize; 3],
    origin: [L::F; 3],
    x: L::F,
    y: L::F,
    z: L::F,
    tmin: L::F,
    tmax: L::F,
}

impl<L: Lanes> TriangleRay<L> {
    #[inline(always)]
    fn new(lanes: L, shear: &Shear, ray: &Ray) -> Self {
        let z = shear.axis as usize;
        let axes = if z == 0 {
            [1, 2, 0]
        } else if z == 1 {
            [2, 0, 1]
        } else {
            [0, 1, 2]
        };
        let o = shear.origin;
        let permuted = Vec3::new(o[axes[0]], o[axes[1]], o[axes[2]]);
        TriangleRay {
            axes,
            origin: spread(lanes, permuted),
            x: lanes.splat(shear.x),
            y: lanes.splat(shear.y),
            z: lanes.splat(shear.z),
            tmin: lanes.splat(ray.tmin),
            tmax: lanes.splat(ray.tmax),
        }
    }

    /// The triangles of a block that pass the kernel's arithmetic but for its test of their own boxes: at least all
    /// that the ray hits.
    #[inline(always)]
    fn test(&self, lanes: L, vertices: &[[[f32; 8]; 3]; 3]) -> u32 {
        let a = self.project(lanes, &vertices[0]);
        let b = self.project(lanes, &vertices[1]);
        let c = self.project(lanes, &vertices[2]);
        let (u, v, w) = (cross(lanes, c, b), cross(lanes, a, c), cross(lanes, b, a));
        let zero = lanes.splat(0.0);
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        let inside = lanes.le(zero, least) | lanes.le(most, zero);
        if inside == 0 {
            return 0;
        }
        let (az, bz, cz) = (lanes.mul(self.z, a.2), lanes.mul(self.z, b.2), lanes.mul(self.z, c.2));
        let ab = lanes.add(lanes.mul(u, az), lanes.mul(v, bz));
        let sum = lanes.add(lanes.add(u, v), w);
        let t = lanes.div(lanes.add(ab, lanes.mul(w, cz)), sum);
        inside & lanes.le(self.tmin, t) & lanes.le(t, self.tmax)
    }

    /// x and y of eight vertices in the ray's frame, by the kernel's arithmetic, and z before its scaling.
    #[inline(always)]
    fn project(&self, lanes: L, vertex: &[[f32; 8]; 3]) -> (L::F, L::F, L::F) {
        let depth = lanes.sub(lanes.load(&vertex[self.axes[2]]), self.origin[2]);
        let x = lanes.sub(lanes.load(&vertex[self.axes[0]]), self.origin[0]);
        let y = lanes.sub(lanes.load(&vertex[self.axes[1]]), self.origin[1]);
        (lanes.sub(x, lanes.mul(self.x, depth)), lanes.sub(y, lanes.mul(self.y, depth)), depth)
    }
}

/// The kernel's edge function by the direct formula: the same value, in other order of vertices too.
#[inline(always)]
fn cross<L: Lanes>(lanes: L, p: (L::F, L::F, L::F), q: (L::F, L::F, L::F)) -> L::F {
    lanes.sub(lanes.mul(p.0, q.1), lanes.mul(p.1, q.0))
}

/// A ray ready for one tree.
struct Prepared<L: Lanes> {
    ray: Ray,
    slab: Slab,
    shear: Shear,
    boxes: BoxRay<L>,
    triangles: TriangleRay<L>,
    window: Span,
}

impl<L: Lanes> Prepared<L> {
    #[inline(always)]
    fn new(lanes: L, ray: Ray, tree: &SimdTree, window: Span) -> Self {
        let slab = Slab::new(&ray, tree.low, tree.high);
        let shear = Shear::new(&ray);
        let boxes = BoxRay::new(lanes, &slab, tree.base, ray.tmin);
        Prepared { ray, slab, shear, boxes, triangles: TriangleRay::new(lanes, &shear, &ray), window }
    }

    /// Whether a block of triangles blocks the ray.
    #[inline(always)]
    fn is_blocked_by<A: AnyHit>(&self, lanes: L, part: Part, block: u32, any_hit: A) -> bool {
        let block = &part.tree.blocks[block as usize];
        let mut candidates = self.triangles.test(lanes, &block.vertices);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize & 7;
            candidates &= candidates - 1;
            let index = part.first_triangle + block.triangles[lane];
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
    fn nearest_of<A: AnyHit>(
        &self,
        lanes: L,
        part: Part,
        block: u32,
        instance: u32,
        any_hit: A,
        mut best: Hit,
    ) -> Hit {
        let block = &part.tree.blocks[block as usize];
        let mut candidates = self.triangles.test(lanes, &block.vertices);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize & 7;
            candidates &= candidates - 1;
            let index = part.first_triangle + block.triangles[lane];
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

/// Pushes the links of `mask` onto `links`; the new length.
#[inline(always)]
fn push<L: Lanes>(lanes: L, mask: u32, children: &[u32; 8], links: &mut [u32; STACK], len: usize) -> usize {
    if let Some(top) = links[len..].first_chunk_mut() {
        lanes.compress(mask, children, top);
    }
    len + mask.count_ones() as usize
}

/// Pushes the links of `mask` with their entries, the nearest last; the new length.
#[inline(always)]
fn push_sorted(
    mask: u32,
    children: &[u32; 8],
    entry: &[f32; 8],
    links: &mut [u32; STACK],
    entries: &mut [f32; STACK],
    len: usize,
) -> usize {
    let (mut mask, mut end) = (mask, len);
    while mask != 0 {
        let lane = mask.trailing_zeros() as usize & 7;
        mask &= mask - 1;
        let mut at = end;
        while at > len && entries[at - 1] < entry[lane] {
            links[at] = links[at - 1];
            entries[at] = entries[at - 1];
            at -= 1;
        }
        links[at] = children[lane];
        entries[at] = entry[lane];
        end += 1;
    }
    end
}

/// Whether a tree of triangles blocks the ray, and the block that does.
#[inline(always)]
fn blocker<L: Lanes, A: AnyHit>(
    lanes: L,
    part: Part,
    prepared: &Prepared<L>,
    any_hit: A,
    links: &mut [u32; STACK],
) -> u32 {
    let tmax = lanes.splat(prepared.ray.tmax);
    links[0] = 0;
    let mut len = 1;
    while len > 0 {
        len -= 1;
        let link = links[len];
        if link & LEAF == 0 {
            let node = &part.tree.nodes[link as usize];
            let (_, mask) = prepared.boxes.test(lanes, node, tmax);
            len = push(lanes, mask, &node.children, links, len);
        } else if prepared.is_blocked_by(lanes, part, link & !LEAF, any_hit) {
            return link & !LEAF;
        }
    }
    NONE
}

/// Nearest hit in a tree of triangles, given the best one so far.
#[inline(always)]
fn nearest<L: Lanes, A: AnyHit>(
    lanes: L,
    part: Part,
    prepared: &Prepared<L>,
    instance: u32,
    any_hit: A,
    mut best: Hit,
    links: &mut [u32; STACK],
    entries: &mut [f32; STACK],
) -> Hit {
    links[0] = 0;
    entries[0] = -FAR;
    let mut len = 1;
    while len > 0 {
        len -= 1;
        let link = links[len];
        if entries[len] > best.t {
            continue;
        }
        if link & LEAF == 0 {
            let node = &part.tree.nodes[link as usize];
            let (entry, mask) = prepared.boxes.test(lanes, node, lanes.splat(best.t));
            len = push_sorted(mask, &node.children, &lanes.store(entry), links, entries, len);
        } else {
            best = prepared.nearest_of(lanes, part, link & !LEAF, instance, any_hit, best);
        }
    }
    best
}

/// The part of a ray that a tree without instances looks at.
const WHOLE_RAY: Span = Span { near: -FAR, far: FAR };

/// [`crate::occluded`] on the wide tree.
#[inline(always)]
pub(crate) fn occluded<L: Lanes, A: AnyHit>(
    lanes: L,
    part: Part,
    ray: Ray,
    any_hit: A,
    scratch: &mut Scratch,
) -> bool {
    if !ray.is_valid() {
        return false;
    }
    let prepared = Prepared::new(lanes, ray, part.tree, WHOLE_RAY);
    let last = scratch.blocker;
    if last != NONE && prepared.is_blocked_by(lanes, part, last, any_hit) {
        return true;
    }
    let found = blocker(lanes, part, &prepared, any_hit, &mut scratch.links);
    if found != NONE {
        scratch.blocker = found;
    }
    found != NONE
}

/// [`crate::closest_hit`] on the wide tree.
#[inline(always)]
pub(crate) fn closest<L: Lanes, A: AnyHit>(
    lanes: L,
    part: Part,
    ray: Ray,
    any_hit: A,
    scratch: &mut Scratch,
) -> Hit {
    let best = Hit::miss(ray.tmax);
    if !ray.is_valid() {
        return best;
    }
    let prepared = Prepared::new(lanes, ray, part.tree, WHOLE_RAY);
    nearest(lanes, part, &prepared, NONE, any_hit, best, &mut scratch.links, &mut scratch.entries)
}

/// The tree of instances and the tree of each.
#[derive(Clone, Copy)]
pub(crate) struct Instanced<'a> {
    pub tlas: &'a SimdTree,
    pub instances: &'a [Instance],
    /// By instance.
    pub parts: &'a [Part<'a>],
}

impl<'a> Instanced<'a> {
    /// The tree and the ray in the space of an instance; `None` where its box is not met or the ray is beyond
    /// what the kernel takes.
    #[inline(always)]
    fn enter<L: Lanes>(
        &self,
        lanes: L,
        slab: &Slab,
        ray: &Ray,
        tmax: f32,
        index: u32,
    ) -> Option<(Part<'a>, Prepared<L>)> {
        let instance = &self.instances[index as usize];
        let window = instance.window(slab);
        if !(window.near <= window.far && window.near <= tmax && window.far >= ray.tmin) {
            return None;
        }
        let object = instance.to_object(ray);
        let part = self.parts[index as usize];
        if !object.is_valid() {
            return None;
        }
        Some((part, Prepared::new(lanes, object, part.tree, window)))
    }
}

/// [`crate::occluded_instanced`] on wide trees.
#[inline(always)]
pub(crate) fn occluded_instanced<L: Lanes, A: AnyHit>(
    lanes: L,
    scene: Instanced,
    ray: Ray,
    any_hit: A,
    scratch: &mut Scratch,
) -> bool {
    if !ray.is_valid() {
        return false;
    }
    let slab = Slab::new(&ray, scene.tlas.low, scene.tlas.high);
    let last = scratch.blocker;
    if last != NONE
        && let Some((part, prepared)) = scene.enter(lanes, &slab, &ray, ray.tmax, scratch.blocking_instance)
        && prepared.is_blocked_by(lanes, part, last, any_hit)
    {
        return true;
    }
    let boxes = BoxRay::new(lanes, &slab, scene.tlas.base, ray.tmin);
    let tmax = lanes.splat(ray.tmax);
    scratch.instance_links[0] = 0;
    let mut len = 1;
    while len > 0 {
        len -= 1;
        let link = scratch.instance_links[len];
        if link & LEAF == 0 {
            let node = &scene.tlas.nodes[link as usize];
            let (_, mask) = boxes.test(lanes, node, tmax);
            len = push(lanes, mask, &node.children, &mut scratch.instance_links, len);
        } else if let Some((part, prepared)) = scene.enter(lanes, &slab, &ray, ray.tmax, link & !LEAF) {
            let found = blocker(lanes, part, &prepared, any_hit, &mut scratch.links);
            if found != NONE {
                scratch.blocker = found;
                scratch.blocking_instance = link & !LEAF;
                return true;
            }
        }
    }
    false
}

/// [`crate::closest_hit_instanced`] on wide trees.
#[inline(always)]
pub(crate) fn closest_instanced<L: Lanes, A: AnyHit>(
    lanes: L,
    scene: Instanced,
    ray: Ray,
    any_hit: A,
    scratch: &mut Scratch,
) -> Hit {
    let mut best = Hit::miss(ray.tmax);
    if !ray.is_valid() {
        return best;
    }
    let slab = Slab::new(&ray, scene.tlas.low, scene.tlas.high);
    let boxes = BoxRay::new(lanes, &slab, scene.tlas.base, ray.tmin);
    scratch.instance_links[0] = 0;
    scratch.instance_entries[0] = -FAR;
    let mut len = 1;
    while len > 0 {
        len -= 1;
        let link = scratch.instance_links[len];
        if scratch.instance_entries[len] > best.t {
            continue;
        }
        if link & LEAF == 0 {
            let node = &scene.tlas.nodes[link as usize];
            let (entry, mask) = boxes.test(lanes, node, lanes.splat(best.t));
            let entry = lanes.store(entry);
            let (links, entries) = (&mut scratch.instance_links, &mut scratch.instance_entries);
            len = push_sorted(mask, &node.children, &entry, links, entries, len);
        } else if let Some((part, prepared)) = scene.enter(lanes, &slab, &ray, best.t, link & !LEAF) {
            let (links, entries) = (&mut scratch.links, &mut scratch.entries);
            best = nearest(lanes, part, &prepared, link & !LEAF, any_hit, best, links, entries);
        }
    }
    best
}
