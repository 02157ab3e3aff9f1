//! Rectangles with two corners cut off, parallel to the light plane's picture of the axis that the light looks along.
//!
//! Scenes are built along the world's axes, and light space keeps two of these as its own. Walls that stand along the third are slanted
//! there, and fill half of their rectangle. A third pair of sides, in the coordinate c = a·X + b·Y that does not change along the third
//! axis ([`LightSpace::diagonal`]), bounds them as closely as the ray tracer's boxes do. Under a positioned light that axis has many
//! directions, and any c will do.
//!
//! Margins are those of rectangles (`rect.rs`), once for X and once for Y: the reasons are the same in any direction of the plane. For slivers
//! c is bounded by the rectangle itself.

use crate::block::BLOCK;
use crate::casters::Casters;
use crate::planes::EPSILON;
use crate::rect::{CLIP, MARGIN, Rect, rects_and_slivers};
use crate::view::{Rays, View};
use alloc::vec::Vec;
use lt_bvh::lanes::{Chosen, NodeLanes, Work};
use lt_bvh::{LightPoint, LightSpace, Triangle, permute};

/// Triangles that a thread takes at a time; a multiple of [`BLOCK`].
const TASK: usize = 4096;

/// A rectangle with a nearness, and the range of c in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hexagon {
    pub rect: Rect,
    /// Least c.
    pub low: f32,
    /// Largest c.
    pub high: f32,
}

impl Hexagon {
    pub const EMPTY: Self = Self { rect: Rect::EMPTY, low: f32::INFINITY, high: f32::NEG_INFINITY };

    pub fn is_empty(&self) -> bool {
        self.rect.x0 > self.rect.x1
    }

    pub fn union(&self, other: &Self) -> Self {
        Hexagon {
            rect: self.rect.union(&other.rect),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn of(view: &View, space: &LightSpace, triangle: &Triangle, rect: Rect, is_sliver: bool) -> Self {
        if rect.x0 > rect.x1 {
            return Self::EMPTY;
        }
        let rect = match view.rays {
            Rays::Parallel { .. } => rect,
            // Slopes of a whole face end at 1, which a division on a GPU may miss.
            Rays::Converging { .. } => rect.widened(16.0 * EPSILON),
        };
        let c = |x: f32, y: f32| space.diagonal(&LightPoint { x, y, z: 0.0 });
        let corners = [c(rect.x0, rect.y0), c(rect.x0, rect.y1), c(rect.x1, rect.y0), c(rect.x1, rect.y1)];
        let around = Self::over(rect, corners.into_iter(), 0.0);
        if is_sliver {
            return around;
        }
        let vertices = [triangle.v0, triangle.v1, triangle.v2];
        let (points, margin) = match view.rays {
            Rays::Parallel { shear, middle, .. } => {
                let point =
                    |v| LightPoint::parallel(permute(v, view.axis), middle, shear.truncate(), view.sign);
                (vertices.map(point), MARGIN * view.size)
            }
            Rays::Converging { light } => {
                let ways = vertices.map(|v| light - permute(v, view.axis));
                let ends = ways.map(|d| d.z * view.sign);
                let near = ends[0].min(ends[1]).min(ends[2]) - MARGIN * view.reach;
                if near <= CLIP * view.size {
                    return around;
                }
                let points = ways.map(|d| LightPoint::converging(d, view.sign));
                (points, 2.0 * MARGIN * view.reach / near + 16.0 * EPSILON)
            }
        };
        let margin = margin * (space.diagonal.x.abs() + space.diagonal.y.abs());
        let within = Self::over(rect, points.iter().map(|p| space.diagonal(p)), margin);
        Hexagon { rect, low: around.low.max(within.low), high: around.high.min(within.high) }
    }

    /// With a range over some c.
    fn over(rect: Rect, values: impl Iterator<Item = f32>, margin: f32) -> Self {
        let (low, high) = values
            .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        Hexagon { rect, low: low - margin, high: high + margin }
    }
}

/// The hexagon of every triangle, empty where the view does not see it. The same on all instructions.
pub(crate) fn hexagons(view: &View, casters: Casters<'_>) -> Vec<Hexagon> {
    let chosen = Chosen::best();
    let space = view.space();
    let mut all = alloc::vec![Hexagon::EMPTY; casters.triangles.len()];
    let one = |(triangles, hexagons): (&[Triangle], &mut [Hexagon])| {
        chosen.run(Hexagons { view, space: &space, triangles, hexagons });
    };
    #[cfg(feature = "std")]
    {
        use rayon::prelude::*;
        casters.triangles.par_chunks(TASK).zip(all.par_chunks_mut(TASK)).for_each(one);
    }
    #[cfg(not(feature = "std"))]
    casters.triangles.chunks(TASK).zip(all.chunks_mut(TASK)).for_each(one);
    all
}

/// Fills in the hexagons of some triangles.
struct Hexagons<'a> {
    view: &'a View,
    space: &'a LightSpace,
    triangles: &'a [Triangle],
    hexagons: &'a mut [Hexagon],
}

impl Work for Hexagons<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        for (triangles, hexagons) in self.triangles.chunks(BLOCK).zip(self.hexagons.chunks_mut(BLOCK)) {
            let (rects, slivers) = rects_and_slivers(lanes, self.view, triangles);
            for (slot, (hexagon, triangle)) in hexagons.iter_mut().zip(triangles).enumerate() {
                let is_sliver = slivers >> slot & 1 == 1;
                *hexagon = Hexagon::of(self.view, self.space, triangle, rects[slot], is_sliver);
            }
        }
    }
}
