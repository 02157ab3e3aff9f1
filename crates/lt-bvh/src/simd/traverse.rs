//! Single rays down the wide tree.

use super::prepared::{Aim, BoxRay, Prepared};
use super::tree::{LEAF, Part, ROOT, STACK, SimdTree};
use crate::any_hit::AnyHit;
use crate::instance::Instance;
use crate::lanes::NodeLanes;
use crate::ray::{FAR, Hit, NONE, Ray};
use crate::slab::{Slab, Span, WHOLE_RAY};
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
    /// The block of triangles, and its instance, that blocked the last ray, if that was blocked: its neighbour is likely
    /// blocked there too, and a ray that is blocked at all may be told so by any blocker.
    blocker: u32,
    blocking_instance: u32,
    /// Of the last ray.
    aim: Aim,
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
            aim: Aim::new(Vec3::Z),
        }
    }
}

/// Pushes the links of `mask` onto `links`; the new length.
#[inline(always)]
fn push<L: NodeLanes>(
    lanes: L,
    mask: u32,
    children: &[u32; 8],
    links: &mut [u32; STACK],
    len: usize,
) -> usize {
    if let Some(top) = links.get_mut(len..len + 8) {
        lanes.compress_words(mask, children, top);
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

/// The lanes as an array.
#[inline(always)]
fn stored<L: NodeLanes>(lanes: L, from: L::F) -> [f32; 8] {
    let mut to = [0.0; 8];
    lanes.store(from, &mut to);
    to
}

/// Whether the subtree at `link` blocks the ray, and the block that does.
#[inline(always)]
pub(crate) fn blocker<L: NodeLanes, A: AnyHit>(
    lanes: L,
    part: Part,
    prepared: &Prepared<L>,
    link: u32,
    any_hit: A,
    scratch: &mut Scratch,
) -> u32 {
    let links = &mut scratch.links;
    let nodes = part.tree.nodes.as_slice();
    let tmax = lanes.splat(prepared.ray.tmax);
    let mut link = link;
    let mut len = 0;
    loop {
        if link & LEAF == 0 {
            let node = &nodes[link as usize];
            let (_, mask) = prepared.boxes.test(lanes, node, tmax);
            if mask != 0 {
                // The last child goes on at once, the others wait. They are written one by one: a wide store would have to
                // reach the cache before a link could be read back from it.
                let last = 31 - mask.leading_zeros();
                link = node.children[last as usize & 7];
                let mut rest = mask & !(1 << last);
                while rest != 0 {
                    links[len] = node.children[rest.trailing_zeros() as usize & 7];
                    rest &= rest - 1;
                    len += 1;
                }
                continue;
            }
        } else if prepared.is_blocked_by(lanes, part, link, any_hit) {
            return link;
        }
        if len == 0 {
            return NONE;
        }
        len -= 1;
        link = links[len];
    }
}

/// Nearest hit in a tree of triangles, given the best one so far.
#[inline(always)]
fn nearest<L: NodeLanes, A: AnyHit>(
    lanes: L,
    part: Part,
    prepared: &Prepared<L>,
    instance: u32,
    any_hit: A,
    mut best: Hit,
    links: &mut [u32; STACK],
    entries: &mut [f32; STACK],
) -> Hit {
    links[0] = ROOT;
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
            len = push_sorted(mask, &node.children, &stored(lanes, entry), links, entries, len);
        } else {
            best = prepared.nearest_of(lanes, part, link, instance, any_hit, best);
        }
    }
    best
}

/// [`crate::occluded`] on the wide tree.
#[inline(always)]
pub(crate) fn occluded<L: NodeLanes, A: AnyHit>(
    lanes: L,
    part: Part,
    ray: Ray,
    any_hit: A,
    scratch: &mut Scratch,
) -> bool {
    if scratch.aim.is_of(&ray) {
        if !ray.starts_validly() {
            return false;
        }
    } else {
        if !ray.is_valid() {
            return false;
        }
        scratch.aim = Aim::new(ray.direction);
    }
    let prepared = Prepared::aimed(lanes, &scratch.aim, ray, part.tree, WHOLE_RAY);
    let last = scratch.blocker;
    if last != NONE && prepared.is_blocked_by(lanes, part, last, any_hit) {
        return true;
    }
    let found = blocker(lanes, part, &prepared, ROOT, any_hit, scratch);
    scratch.blocker = found;
    found != NONE
}

/// [`crate::closest_hit`] on the wide tree.
#[inline(always)]
pub(crate) fn closest<L: NodeLanes, A: AnyHit>(
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
    /// The ray in the space of an instance, and the stretch of it that counts there; `None` where the instance's box is not
    /// met before `tmax`, or the ray is beyond what the kernel takes. `slab` is the ray's in the tree of instances.
    #[inline(always)]
    pub fn enter(&self, slab: &Slab, ray: &Ray, tmax: f32, index: u32) -> Option<(Ray, Span)> {
        let instance = &self.instances[index as usize];
        let window = instance.window(slab);
        if !(window.near <= window.far && window.near <= tmax && window.far >= ray.tmin) {
            return None;
        }
        let object = instance.to_object(ray);
        object.is_valid().then_some((object, window))
    }

    /// The tree of an instance and the ray ready for it; see [`Instanced::enter`].
    #[inline(always)]
    fn prepare<L: NodeLanes>(
        &self,
        lanes: L,
        slab: &Slab,
        ray: &Ray,
        tmax: f32,
        index: u32,
    ) -> Option<(Part<'a>, Prepared<L>)> {
        let (object, window) = self.enter(slab, ray, tmax, index)?;
        let part = self.parts[index as usize];
        Some((part, Prepared::new(lanes, object, part.tree, window)))
    }
}

/// [`crate::occluded_instanced`] on wide trees.
#[inline(always)]
pub(crate) fn occluded_instanced<L: NodeLanes, A: AnyHit>(
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
        && let Some((part, prepared)) = scene.prepare(lanes, &slab, &ray, ray.tmax, scratch.blocking_instance)
        && prepared.is_blocked_by(lanes, part, last, any_hit)
    {
        return true;
    }
    let boxes = BoxRay::new(lanes, &slab, scene.tlas.base, ray.tmin);
    let tmax = lanes.splat(ray.tmax);
    scratch.instance_links[0] = ROOT;
    let mut len = 1;
    while len > 0 {
        len -= 1;
        let link = scratch.instance_links[len];
        if link & LEAF == 0 {
            let node = &scene.tlas.nodes[link as usize];
            let (_, mask) = boxes.test(lanes, node, tmax);
            len = push(lanes, mask, &node.children, &mut scratch.instance_links, len);
        } else if let Some((part, prepared)) = scene.prepare(lanes, &slab, &ray, ray.tmax, link & !LEAF) {
            let found = blocker(lanes, part, &prepared, ROOT, any_hit, scratch);
            if found != NONE {
                scratch.blocker = found;
                scratch.blocking_instance = link & !LEAF;
                return true;
            }
        }
    }
    scratch.blocker = NONE;
    false
}

/// [`crate::closest_hit_instanced`] on wide trees.
#[inline(always)]
pub(crate) fn closest_instanced<L: NodeLanes, A: AnyHit>(
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
    scratch.instance_links[0] = ROOT;
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
            let entry = stored(lanes, entry);
            let (links, entries) = (&mut scratch.instance_links, &mut scratch.instance_entries);
            len = push_sorted(mask, &node.children, &entry, links, entries, len);
        } else if let Some((part, prepared)) = scene.prepare(lanes, &slab, &ray, best.t, link & !LEAF) {
            let (links, entries) = (&mut scratch.links, &mut scratch.entries);
            best = nearest(lanes, part, &prepared, link & !LEAF, any_hit, best, links, entries);
        }
    }
    best
}
