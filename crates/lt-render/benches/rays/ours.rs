//! Our own ways.

use std::cell::RefCell;
use std::ops::Range;

use lt_bvh::{AnyHit, Bvh, Counts, Grouping, Ray, RayOrder, Simd, Tracer, occluded_probed};

use super::Outcome;
use super::measure::{Family, Way};
use super::places::Place;
use super::report::List;

/// Every how many-th ray the shared kernel answers too, for counts and as a check.
const PROBED: usize = 16;

/// The column of a scene with holes whose alpha test is what Embree's filter is: no opacity map is asked first.
pub const BY_TEXTURE: &str = "ours, no opacity maps";

/// Our columns. The first, "ours", is what users get; one named "ours, single" would be set against Embree's single
/// rays, which are set against the first as long as there is none. Residual rays are said to be scattered.
pub fn ways<'a, A: AnyHit + Sync + 'a>(
    place: &'a Place,
    rays: &'a [Ray],
    any_hit: A,
    list: List,
) -> Vec<Box<dyn Way + 'a>> {
    let (bvh, is_scattered) = (place.bvh(), list == List::Residual);
    let simd = || Simd::new(bvh);
    let mut ways: Vec<Box<dyn Way + 'a>> = vec![
        Box::new(Ours { name: "ours", simd: simd(), rays, any_hit, is_scattered }),
        Box::new(Ours {
            name: "ours, single",
            simd: simd().with_grouping(Grouping::Single),
            rays,
            any_hit,
            is_scattered,
        }),
    ];
    if place.has_holes() {
        let any_hit = place.texture_coverage();
        ways.push(Box::new(Ours { name: BY_TEXTURE, simd: simd(), rays, any_hit, is_scattered }));
    }
    ways
}

thread_local! {
    /// What a renderer's threads keep from frame to frame.
    static ORDER: RefCell<RayOrder> = RefCell::default();
}

struct Ours<'a, A> {
    name: &'static str,
    simd: Simd<'a>,
    rays: &'a [Ray],
    any_hit: A,
    is_scattered: bool,
}

impl<A: AnyHit + Sync> Way for Ours<'_, A> {
    fn name(&self) -> &str {
        self.name
    }

    fn family(&self) -> Family {
        Family::Ours
    }

    fn trace(&self, range: Range<usize>, out: &mut [bool]) {
        match self.is_scattered {
            true => ORDER.with_borrow_mut(|order| {
                self.simd.occluded_scattered(&self.rays[range], self.any_hit, out, order);
            }),
            false => self.simd.occluded_batch(&self.rays[range], self.any_hit, out),
        }
    }
}

/// Nodes and triangles that the shared kernel tests per ray, mean over a sixteenth of the rays.
#[derive(Clone, Copy, Debug)]
pub struct MeanCounts {
    pub nodes: f64,
    pub triangles: f64,
}

/// Counts the shared kernel's work.
pub fn mean_counts<A: AnyHit>(bvh: &Bvh, rays: &[Ray], any_hit: A) -> MeanCounts {
    let (mut nodes, mut triangles, mut probed) = (0u64, 0u64, 0u64);
    for ray in rays.iter().step_by(PROBED) {
        let mut counts = Counts::default();
        occluded_probed(bvh.nodes(), bvh.triangles(), *ray, any_hit, &mut counts);
        nodes += u64::from(counts.nodes);
        triangles += u64::from(counts.triangles);
        probed += 1;
    }
    let mean = |sum: u64| sum as f64 / probed.max(1) as f64;
    MeanCounts { nodes: mean(nodes), triangles: mean(triangles) }
}

/// Fails unless `answers` are the shared kernel's own, on a sixteenth of the rays.
pub fn check_against_kernel<A: AnyHit>(bvh: &Bvh, rays: &[Ray], any_hit: A, answers: &[bool]) -> Outcome<()> {
    for (i, ray) in rays.iter().enumerate().step_by(PROBED) {
        if lt_bvh::occluded(bvh.nodes(), bvh.triangles(), *ray, any_hit) != answers[i] {
            return Err(format!("ray {i}: the SIMD tracer and the shared kernel differ on {ray:?}").into());
        }
    }
    Ok(())
}
