//! Our ways in light space.

use std::cell::RefCell;
use std::ops::Range;
use std::time::Instant;

use lt_bvh::{AnyHit, Grouping, Ray, Simd, Tracer};
use lt_irregular::{Bounds, Casters, LightBvh, Scratch};
use lt_math::glam::Vec4;

use super::measure::{Family, Way};
use super::places::Place;

/// The light BVH of a place.
pub struct Prebuilt<'a> {
    place: &'a Place,
    bvh: LightBvh,
}

impl<'a> Prebuilt<'a> {
    pub fn new(place: &'a Place) -> Self {
        let light: Vec4 = place.rays.rays[0].direction.extend(0.0);
        let casters = casters(place);
        let bounds = place.rays.rays.iter().fold(domain(place), |b, r| b.with(r.origin));
        let start = Instant::now();
        let bvh = LightBvh::build(light, bounds, casters);
        eprintln!("light BVH: {:.1} ms", start.elapsed().as_secs_f64() * 1e3);
        Prebuilt { place, bvh }
    }

    pub fn ways<'b, A: AnyHit + Sync + 'b>(&'b self, rays: &'b [Ray], any_hit: A) -> Vec<Box<dyn Way + 'b>> {
        vec![
            Box::new(Rays { simd: Simd::new(self.place.bvh()).with_grouping(Grouping::Packets), rays, any_hit }),
            Box::new(Streams { prebuilt: self, rays, any_hit }),
        ]
    }
}

fn casters(place: &Place) -> Casters<'_> {
    Casters { root: &place.packed.nodes()[0], triangles: place.packed.triangles() }
}

fn domain(place: &Place) -> Bounds {
    let b = place.packed.bounds();
    Bounds { low: b.min, high: b.max }
}

struct Rays<'a, A> {
    simd: Simd<'a>,
    rays: &'a [Ray],
    any_hit: A,
}

impl<A: AnyHit + Sync> Way for Rays<'_, A> {
    fn name(&self) -> &str {
        "ours, rays"
    }
    fn family(&self) -> Family {
        Family::Obvhs
    }
    fn trace(&self, range: Range<usize>, out: &mut [bool]) {
        self.simd.occluded_batch(&self.rays[range], self.any_hit, out);
    }
}

struct Streams<'a, A> {
    prebuilt: &'a Prebuilt<'a>,
    rays: &'a [Ray],
    any_hit: A,
}

thread_local! {
    static SCRATCH: RefCell<(Scratch, Vec<lt_math::glam::Vec3>)> = RefCell::default();
}

impl<A: AnyHit + Sync> Way for Streams<'_, A> {
    fn name(&self) -> &str {
        "light BVH"
    }
    fn family(&self) -> Family {
        Family::Ours
    }
    fn trace(&self, range: Range<usize>, out: &mut [bool]) {
        SCRATCH.with_borrow_mut(|(scratch, origins)| {
            origins.clear();
            origins.extend(self.rays[range].iter().map(|r| r.origin));
            let casters = casters(self.prebuilt.place);
            self.prebuilt.bvh.occluded(casters, origins, self.any_hit, out, scratch);
        });
    }
}
