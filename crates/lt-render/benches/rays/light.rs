//! The light BVH of lt-irregular on the same rays: their origins become points in the light's own space, which is in the time.

use std::cell::RefCell;
use std::ops::Range;

use lt_bvh::{AnyHit, Ray};
use lt_irregular::{Bounds, Casters, LightBvh, Scratch};
use lt_math::glam::{Vec3, Vec4};

use super::Outcome;
use super::measure::{Family, Way};
use super::places::Place;

/// Heading of its column.
pub const NAME: &str = "ours, light BVH";

/// The tree of a place; not made within a measured time.
pub struct Tree<'a> {
    casters: Casters<'a>,
    light: Vec4,
    tree: LightBvh,
}

impl<'a> Tree<'a> {
    /// Builds it for the place's sun.
    ///
    /// # Errors
    /// The tree is not sound.
    pub fn new(place: &'a Place) -> Outcome<Self> {
        let rays = &place.rays.rays;
        let light = rays.first().map_or(Vec3::Y, |ray| ray.direction).extend(0.0);
        let bounds = place.packed.bounds();
        let domain =
            rays.iter().fold(Bounds { low: bounds.min, high: bounds.max }, |b, ray| b.with(ray.origin));
        let casters = Casters::of_tree(&place.packed.nodes()[0], place.packed.triangles());
        let tree = LightBvh::build(light, domain, casters);
        tree.validate(casters)?;
        Ok(Tree { casters, light, tree })
    }

    /// The column for rays to the place's sun.
    pub fn way<'b, A: AnyHit + Sync + 'b>(&'b self, rays: &'b [Ray], any_hit: A) -> Box<dyn Way + 'b> {
        debug_assert!(rays.iter().all(|ray| ray.direction == self.light.truncate()), "one sun");
        Box::new(Points { tree: self, rays, any_hit })
    }
}

struct Points<'a, A> {
    tree: &'a Tree<'a>,
    rays: &'a [Ray],
    any_hit: A,
}

thread_local! {
    static MEMORY: RefCell<(Vec<Vec3>, Scratch)> = RefCell::default();
}

impl<A: AnyHit + Sync> Way for Points<'_, A> {
    fn name(&self) -> &str {
        NAME
    }

    fn family(&self) -> Family {
        Family::Ours
    }

    fn trace(&self, range: Range<usize>, out: &mut [bool]) {
        MEMORY.with_borrow_mut(|(origins, scratch)| {
            origins.clear();
            origins.extend(self.rays[range].iter().map(|ray| ray.origin));
            self.tree.tree.occluded(self.tree.casters, origins, self.any_hit, out, scratch);
        });
    }
}
