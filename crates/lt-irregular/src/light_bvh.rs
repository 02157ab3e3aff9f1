//! The light BVH: a tree over the triangles in light space, kept while light and triangles stand still.

use crate::casters::{Casters, Query};
use crate::tile::{TILE, Tile};
use crate::tree::Tree;
use crate::validate::Invalid;
use crate::view::{Bounds, View};
use crate::walk::Stream;
use alloc::boxed::Box;
use alloc::vec::Vec;
use lt_bvh::lanes::{Chosen, NodeLanes, SimdLevel, Work};
use lt_bvh::{AnyHit, Ray};
use lt_math::glam::{Vec3, Vec4};

/// Points to a stream.
const STREAM: usize = 4096;

/// How points go through a tree; the answers are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Walk {
    /// 64 neighbours at a time under one rectangle: best where casters are larger than what a tile sees of them.
    Tiles,
    /// A whole batch at a time, thinned out on the way down: best where they are smaller.
    Streams,
}

impl Walk {
    /// Every way.
    pub const ALL: [Walk; 2] = [Walk::Tiles, Walk::Streams];
}

/// A tree over the triangles in light space, one per view of a light, for a light and casters that stand still.
#[derive(Clone, Debug)]
pub struct LightBvh {
    light: Vec4,
    trees: Vec<Tree>,
    chosen: SimdLevel,
}

/// Memory of a thread that asks; reused from batch to batch.
#[derive(Default)]
pub struct Scratch {
    stream: Stream,
    tile: Box<Tile>,
}

impl LightBvh {
    /// Builds for a homogeneous light (w = 0: a sun, `xyz` towards it; w = 1: a position). `domain` must hold all triangles, and
    /// should hold all origins: a ray from elsewhere is put to every triangle.
    pub fn build(light: Vec4, domain: Bounds, casters: Casters<'_>) -> Self {
        let trees =
            View::of_light(light, domain, casters.root).map(|view| Tree::build(view, casters)).collect();
        LightBvh { light, trees, chosen: SimdLevel::best() }
    }

    /// The same on other instructions; `None` where the processor lacks them.
    pub fn with_instructions(self, instructions: SimdLevel) -> Option<Self> {
        Chosen::new(instructions)?;
        Some(LightBvh { chosen: instructions, ..self })
    }

    /// One tree per view.
    pub(crate) fn trees(&self) -> &[Tree] {
        &self.trees
    }

    /// Checks the trees over these triangles.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate(&self, casters: Casters<'_>) -> Result<(), Invalid> {
        self.trees.iter().try_for_each(|tree| tree.validate(casters))
    }

    /// Whether the ray from each origin to the light is blocked: the ray tracer's own answers. Stops at the end of the shorter of
    /// `origins` and `out`. `casters` must be those it was built over. Origins are best in an order where neighbours follow one
    /// another, such as 8×8 pixels in Morton order.
    pub fn occluded<A: AnyHit>(
        &self,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
        scratch: &mut Scratch,
    ) {
        self.occluded_by(Walk::Tiles, casters, origins, any_hit, out, scratch);
    }

    /// [`LightBvh::occluded`], told how to walk.
    pub fn occluded_by<A: AnyHit>(
        &self,
        walk: Walk,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
        scratch: &mut Scratch,
    ) {
        let chosen = Chosen::new(self.chosen).unwrap_or(Chosen::Portable);
        for (origins, out) in origins.chunks(STREAM).zip(out.chunks_mut(STREAM)) {
            chosen.run(Ask { walk, bvh: self, casters, origins, any_hit, out, scratch });
        }
    }
}

struct Ask<'a, A> {
    walk: Walk,
    bvh: &'a LightBvh,
    casters: Casters<'a>,
    origins: &'a [Vec3],
    any_hit: A,
    out: &'a mut [bool],
    scratch: &'a mut Scratch,
}

impl<A: AnyHit> Work for Ask<'_, A> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let Ask { walk, bvh, casters, origins, any_hit, out, scratch } = self;
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(false);
        let mut taken = 0;
        for tree in &bvh.trees {
            let query = Query { casters, light: bvh.light, any_hit };
            match walk {
                Walk::Tiles => {
                    for (origins, out) in origins.chunks(TILE).zip(out.chunks_mut(TILE)) {
                        let tile = &mut *scratch.tile;
                        tile.fill(lanes.rays(), &tree.view, origins);
                        taken += tile.members().count_ones() as usize;
                        tile.walk(lanes, tree, &query);
                        let blocked = tile.blocked();
                        for (i, out) in out.iter_mut().enumerate() {
                            *out |= blocked >> i & 1 == 1;
                        }
                    }
                }
                Walk::Streams => {
                    taken += scratch.stream.fill(lanes.rays(), &tree.view, origins);
                    scratch.stream.walk(lanes, tree, &query);
                    for i in scratch.stream.blocked() {
                        out[i] = true;
                    }
                }
            }
        }
        if taken < len {
            bvh.strays(casters, origins, any_hit, out);
        }
    }
}

impl LightBvh {
    /// Answers rays that no view takes.
    #[inline(never)]
    fn strays<A: AnyHit>(&self, casters: Casters<'_>, origins: &[Vec3], any_hit: A, out: &mut [bool]) {
        let query = Query { casters, light: self.light, any_hit };
        for (&origin, out) in origins.iter().zip(out) {
            let ray = Ray::to_light(origin, self.light);
            if ray.is_valid() && !self.trees.iter().any(|tree| tree.view.takes(&ray)) {
                *out = query.is_blocked_by_any(origin);
            }
        }
    }
}
