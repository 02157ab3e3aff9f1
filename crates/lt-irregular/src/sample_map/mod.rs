//! Alias-free shadow maps (Aila and Laine 2004): the samples sorted in light space, and every triangle held against those that it meets.
//!
//! Samples are cut at the median along x and y in turn until fewer than [`Options::leaf`] are together. A triangle walks down that tree
//! past nodes that it does not touch, nodes nearer to the light than it is, and nodes that are wholly in shadow already (occlusion
//! culling), and settles samples in the leaves. Nothing of it depends on a map's resolution, and building does not depend on triangles.
//!
//! For threads the tree is cut once more: below its first levels lie **parts**, each a tree of its own. Triangles are sorted into the
//! parts that they meet, in their own order and a limited number at a time, and every part takes its own ones. So answers, products
//! and counters are the same for any number of threads.

mod part;
mod sort;
mod visit;

pub use sort::PointOrder;

use crate::block::{BLOCK, Block};
use crate::casters::{Casters, Query, each};
use crate::rect::Rect;
use crate::split::Item;
use crate::tree::items;
use crate::view::{Bounds, View};
use alloc::vec::Vec;
use core::ops::AddAssign;
use lt_bvh::lanes::{Chosen, NodeLanes, SimdLevel, Work};
use lt_bvh::{AnyHit, Ray, Transmit};
use lt_math::glam::{Vec3, Vec4};
use part::{Cover, Part, Tasks};
use visit::{Darken, Paint, Tint};

/// Triangles that are sorted into parts at a time, which bounds memory where large triangles meet every part. The first rounds are
/// short and double: what they bring into shadow is closed to all that come later.
const FIRST_ROUND: usize = 1 << 10;
const LAST_ROUND: usize = 1 << 16;

/// How a [`SampleMap`] is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// A leaf holds fewer samples than this; at least 2. The paper has 64.
    pub leaf: usize,
    /// Parts that threads share out among themselves, a power of two: `2^part_levels`. With 0 the counters are those of the
    /// paper's one tree.
    pub part_levels: u32,
    /// How samples are put in order.
    pub order: PointOrder,
    /// Which instructions are used.
    pub instructions: SimdLevel,
}

impl Default for Options {
    fn default() -> Self {
        Options { leaf: 64, part_levels: 5, order: PointOrder::Median, instructions: SimdLevel::best() }
    }
}

/// What rasterising took, independent of any machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Triangles that a view could see, over all views.
    pub triangles: u64,
    /// Nodes that a triangle was held against.
    pub nodes_visited: u64,
    /// Of these, passed by because all their samples were in shadow.
    pub nodes_culled: u64,
    /// Pairs of sample and triangle that were tested in leaves, samples in shadow left out.
    pub samples_tested: u64,
    /// Of these, left to the ray tracer's own test.
    pub tests_exact: u64,
}

impl AddAssign for Counters {
    fn add_assign(&mut self, other: Self) {
        self.triangles += other.triangles;
        self.nodes_visited += other.nodes_visited;
        self.nodes_culled += other.nodes_culled;
        self.samples_tested += other.samples_tested;
        self.tests_exact += other.tests_exact;
    }
}

/// The alias-free shadow map of Aila and Laine (2004): samples in a tree per view of a light, which every triangle walks.
#[derive(Clone, Debug)]
pub struct SampleMap {
    light: Vec4,
    views: Vec<ViewMap>,
    /// Samples whose rays no view takes: they are put to every triangle.
    strays: Vec<u32>,
    options: Options,
}

/// The samples of one view.
#[derive(Clone, Debug)]
struct ViewMap {
    view: View,
    parts: Vec<Part>,
}

impl SampleMap {
    /// Sorts the rays from `origins` to a homogeneous light (w = 0: a sun, `xyz` towards it; w = 1: a position). `domain` must hold all
    /// triangles of `casters`, and should hold all origins: a ray from elsewhere is put to every triangle.
    pub fn build(
        light: Vec4,
        domain: Bounds,
        casters: Casters<'_>,
        origins: &[Vec3],
        options: Options,
    ) -> Self {
        let options =
            Options { leaf: options.leaf.max(2), part_levels: options.part_levels.min(16), ..options };
        let mut strays = Vec::new();
        let views = View::of_light(light, domain, casters.root).map(|view| {
            let points = sort::points(&view, light, origins, &mut strays);
            ViewMap { view, parts: sort::parts(points, options) }
        });
        let views = views.collect();
        SampleMap { light, views, strays, options }
    }

    /// Nodes of all trees.
    pub fn node_count(&self) -> usize {
        self.parts().map(Part::node_count).sum()
    }

    /// For every leaf with samples a rectangle around them, in light space ([`View::point`]), with their largest nearness: view
    /// after view.
    pub fn leaves(&self) -> impl Iterator<Item = Rect> {
        self.parts().flat_map(Part::leaves)
    }

    fn parts(&self) -> impl Iterator<Item = &Part> {
        self.views.iter().flat_map(|v| &v.parts)
    }

    /// Checks that every leaf holds fewer samples than allowed, every node's bounds hold its samples, and no sample is there twice.
    ///
    /// # Errors
    /// What was found first, in words.
    pub fn validate(&self) -> Result<(), alloc::string::String> {
        let mut seen = Vec::new();
        for part in self.parts() {
            part.validate(self.options.leaf)?;
            seen.extend_from_slice(part.sources());
        }
        seen.extend_from_slice(&self.strays);
        let len = seen.len();
        seen.sort_unstable();
        seen.dedup();
        if seen.len() == len { Ok(()) } else { Err("a sample is in two places".into()) }
    }

    /// Whether each ray is blocked: the ray tracer's own answers, `false` for what is no ray. Stops at the end of the shorter of `origins`
    /// and `out`. `origins` and `casters` must be those it was built over.
    pub fn occluded<A: AnyHit + Sync>(
        &mut self,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
    ) -> Counters {
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(false);
        let query = Query { casters, light: self.light, any_hit };
        let strays = self.strays_of(len);
        let blocked = each(&strays, |&stray| query.is_blocked_by_any(origins[stray]));
        for (stray, blocked) in strays.into_iter().zip(blocked) {
            out[stray] = blocked;
        }
        let counters = self.rasterise(casters, origins, Darken(any_hit));
        for sample in self.parts().flat_map(Part::blocked).filter(|sample| *sample < len) {
            out[sample] = true;
        }
        counters
    }

    /// What all triangles on the way let through of each ray, linear RGB, multiplied in the order of the triangles: the same product as
    /// [`lt_bvh::transmitted`] up to a rounding per factor, white for what is no ray. Lengths, `origins` and `casters` as in
    /// [`SampleMap::occluded`].
    pub fn transmitted<T: Transmit + Sync>(
        &mut self,
        casters: Casters<'_>,
        origins: &[Vec3],
        transmit: T,
        out: &mut [Vec3],
    ) -> Counters {
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(Vec3::ONE);
        let strays = self.strays_of(len);
        let tints = each(&strays, |&stray| {
            let ray = Ray::to_light(origins[stray], self.light);
            (0..casters.triangles.len() as u32).fold(Vec3::ONE, |tint, index| {
                let met = casters.meet(&ray, index);
                met.map_or(tint, |(u, v)| tint * transmit.transmittance(index, u, v))
            })
        });
        for (stray, tint) in strays.into_iter().zip(tints) {
            out[stray] = tint;
        }
        for part in self.views.iter_mut().flat_map(|v| &mut v.parts) {
            part.whiten();
        }
        let counters = self.rasterise(casters, origins, Tint(transmit));
        for (sample, tint) in self.parts().flat_map(Part::tints).filter(|(sample, _)| *sample < len) {
            out[sample] = tint;
        }
        counters
    }

    /// Samples below `len` whose rays no view takes.
    fn strays_of(&self, len: usize) -> Vec<usize> {
        self.strays.iter().map(|&stray| stray as usize).filter(|&stray| stray < len).collect()
    }

    /// Holds every triangle against the samples.
    fn rasterise<P: Paint>(&mut self, casters: Casters<'_>, origins: &[Vec3], paint: P) -> Counters {
        let chosen = Chosen::new(self.options.instructions).unwrap_or(Chosen::Portable);
        let mut counters = Counters::default();
        for ViewMap { view, parts } in &mut self.views {
            parts.iter_mut().for_each(Part::open);
            let items = items(view, casters);
            counters.triangles += items.len() as u64;
            let (mut rest, mut size) = (&items[..], FIRST_ROUND);
            while !rest.is_empty() {
                let (round, later) = rest.split_at(size.min(rest.len()));
                (rest, size) = (later, (2 * size).min(LAST_ROUND));
                let tasks = Tasks::sort(parts, round, &mut counters);
                let scene = Scene { view, casters, origins, paint };
                counters += tasks.run(parts, |part, items| chosen.run(Walk { scene, part, items }));
            }
        }
        counters
    }
}

/// What a triangle is held against samples with.
#[derive(Clone, Copy)]
pub(crate) struct Scene<'a, P> {
    pub view: &'a View,
    pub casters: Casters<'a>,
    pub origins: &'a [Vec3],
    pub paint: P,
}

struct Walk<'a, P> {
    scene: Scene<'a, P>,
    part: &'a mut Part,
    items: &'a [Item],
}

impl<P: Paint> Work for Walk<'_, P> {
    type Output = Counters;
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) -> Counters {
        let mut counters = Counters::default();
        for items in self.items.chunks(BLOCK) {
            let mut ids = [0; BLOCK];
            for (id, item) in ids.iter_mut().zip(items) {
                *id = item.triangle;
            }
            let Scene { view, casters, .. } = self.scene;
            let (block, slivers) = Block::with_slivers(lanes, view, casters, &ids[..items.len()]);
            for (slot, item) in items.iter().enumerate() {
                let cover = Cover::new(view, block.planes(slot), slivers >> slot & 1 == 1);
                self.part.draw(lanes.rays(), &self.scene, item, &cover, &mut counters);
            }
        }
        counters
    }
}
