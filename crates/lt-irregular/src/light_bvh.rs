//! The light BVH: a tree over the triangles in light space, kept while light and triangles stand still.

use crate::casters::{Casters, Query};
use crate::lanes::Level;
use crate::level::{Chosen, Instructions, Work};
use crate::tree::Tree;
use crate::validate::Invalid;
use crate::view::{Bounds, View};
use crate::walk::Stream;
use alloc::vec::Vec;
use lt_bvh::AnyHit;
use lt_math::glam::{Vec3, Vec4};

/// Points to a stream.
const STREAM: usize = 4096;

/// A tree per view of a light; see the [module](self).
#[derive(Clone, Debug)]
pub struct LightBvh {
    light: Vec4,
    trees: Vec<Tree>,
    chosen: Instructions,
}

/// Memory of a thread that asks; reused from batch to batch.
#[derive(Default)]
pub struct Scratch {
    stream: Stream,
}

impl LightBvh {
    /// Builds for a homogeneous light (w = 0: a sun, `xyz` towards it; w = 1: a position). `domain` must hold all triangles, and
    /// should hold all origins: a ray from elsewhere is put to every triangle.
    pub fn build(light: Vec4, domain: Bounds, casters: Casters<'_>) -> Self {
        let trees =
            View::of_light(light, domain, casters.root).map(|view| Tree::build(view, casters)).collect();
        LightBvh { light, trees, chosen: Instructions::best() }
    }

    /// The same on other instructions; `None` where the processor lacks them.
    pub fn with_instructions(self, instructions: Instructions) -> Option<Self> {
        Chosen::new(instructions)?;
        Some(LightBvh { chosen: instructions, ..self })
    }

    /// Checks the trees over these triangles.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate(&self, casters: Casters<'_>) -> Result<(), Invalid> {
        self.trees.iter().try_for_each(|tree| tree.validate(casters))
    }

    /// Whether the ray from each origin to the light is blocked: the ray tracer's own answers. Stops at the end of the shorter of
    /// `origins` and `out`. `casters` must be those it was built over.
    pub fn occluded<A: AnyHit>(
        &self,
        casters: Casters<'_>,
        origins: &[Vec3],
        any_hit: A,
        out: &mut [bool],
        scratch: &mut Scratch,
    ) {
        let chosen = Chosen::new(self.chosen).unwrap_or(Chosen::Portable);
        for (origins, out) in origins.chunks(STREAM).zip(out.chunks_mut(STREAM)) {
            chosen.run(Ask { bvh: self, casters, origins, any_hit, out, scratch });
        }
    }
}

struct Ask<'a, A> {
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
    fn run<L: Level>(self, level: L) {
        let Ask { bvh, casters, origins, any_hit, out, scratch } = self;
        let len = origins.len().min(out.len());
        let (origins, out) = (&origins[..len], &mut out[..len]);
        out.fill(false);
        for tree in &bvh.trees {
            let query = Query { casters, light: bvh.light, any_hit };
            scratch.stream.fill(&tree.view, bvh.light, origins, 0);
            scratch.stream.walk(level, tree, &query);
            for i in scratch.stream.blocked() {
                out[i] = true;
            }
            for (i, origin) in Stream::strays(&tree.view, bvh.light, origins) {
                out[i] = query.is_blocked_by_any(origin);
            }
        }
    }
}
