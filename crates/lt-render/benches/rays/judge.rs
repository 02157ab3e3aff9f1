//! Where answers differ, who is right: an exact-enough look at the geometry in f64.
//!
//! A ray is *clearly blocked* within a tolerance if some triangle is hit farther than that inside its edges, beyond
//! the ray's start and where the alpha test accepts all around; *clearly lit* if even triangles grown by the tolerance
//! miss it. In between, rounding decides, and tracers may differ. The tolerance is a distance across the ray, in units
//! of 2⁻²⁴ of the largest coordinate of triangle and origin; each differing ray is given the smallest power of two that explains it.

use lt_bvh::{AnyHit, Ray, Triangle};
use lt_math::glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

use super::Outcome;
use super::measure::Measured;
use super::places::Place;

/// Largest tolerance that counts as rounding, in units of 2⁻²⁴ of the largest coordinate: an Embree that is not robust
/// subtracts vertices from origins and multiplies edges, each a few roundings of that size.
const ROUNDING_LIMIT: u32 = 64;
/// The same along the ray near its start, where ray origins are moved off their surface by 16 of these units
/// ([`lt_bvh::ORIGIN_ULPS`] counts in 2⁻²³): a tracer that meets that surface again is wrong by more than rounding.
const START_LIMIT: f64 = 4.0;
/// Rays judged per list; of more, so many are taken evenly.
const JUDGED: usize = 400;

/// How the answers of a list compare.
#[derive(Clone, Debug, Default)]
pub struct Differences {
    /// Per way: rays answered otherwise than by our first way.
    pub per_way: Vec<usize>,
    /// Rays that any way answered otherwise, and how many of them were judged.
    pub rays: usize,
    pub judged: usize,
    /// Of the judged ones, those where rounding decides: at a triangle's edge, at the alpha test, at the ray's start.
    pub at_edge: usize,
    pub at_alpha: usize,
    pub at_start: usize,
    /// Largest tolerance needed among these, in units of 2⁻²⁴.
    pub tolerance: u32,
    /// Judged ones beyond rounding where we are wrong, and where somebody else is.
    pub ours_wrong: usize,
    pub theirs_wrong: usize,
}

/// Counts and judges.
///
/// # Errors
/// Two ways of ours differ: they must agree bit for bit.
pub fn judge(place: &Place, rays: &[Ray], measured: &Measured) -> Outcome<Differences> {
    let reference = &measured.answers[0];
    let mut is_disputed = vec![false; rays.len()];
    let mut differences = Differences::default();
    for (column, answers) in measured.columns.iter().zip(&measured.answers) {
        let mut count = 0;
        for (i, (a, b)) in reference.iter().zip(answers).enumerate() {
            if a != b {
                is_disputed[i] = true;
                count += 1;
            }
        }
        if count > 0 && column.family == super::measure::Family::Ours {
            return Err(
                format!("{}: {count} answers differ from {}", column.name, measured.columns[0].name).into()
            );
        }
        differences.per_way.push(count);
    }
    let disputed: Vec<usize> = (0..rays.len()).filter(|&i| is_disputed[i]).collect();
    differences.rays = disputed.len();
    let step = disputed.len().div_ceil(JUDGED).max(1);
    for &i in disputed.iter().step_by(step) {
        differences.judged += 1;
        match verdict(place, &rays[i]) {
            Verdict::Rounding { cause, tolerance } => {
                differences.tolerance = differences.tolerance.max(tolerance);
                match cause {
                    Cause::Edge => differences.at_edge += 1,
                    Cause::Alpha => differences.at_alpha += 1,
                    Cause::Start => differences.at_start += 1,
                }
            }
            Verdict::Clear { is_blocked } if is_blocked == reference[i] => differences.theirs_wrong += 1,
            Verdict::Clear { .. } => differences.ours_wrong += 1,
        }
    }
    Ok(differences)
}

/// What the tolerance is needed for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cause {
    Edge,
    Alpha,
    Start,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Rounding { cause: Cause, tolerance: u32 },
    Clear { is_blocked: bool },
}

/// A triangle near the ray.
struct Candidate {
    index: u32,
    /// 2⁻²⁴ of the largest coordinate of the triangle and the ray's origin.
    unit: f64,
    /// Distance of the ray from the nearest edge, positive inside.
    inside: f64,
    /// Distance along the ray, and how much of it an error across the ray is worth.
    along: f64,
    slope: f64,
    /// Barycentric weights of the second and third vertex, and what an error across the ray is worth in each.
    weights: [f64; 2],
    weight_slope: [f64; 2],
    is_opaque: bool,
}

fn verdict(place: &Place, ray: &Ray) -> Verdict {
    let direction = ray.direction.as_dvec3().normalize();
    let (right, up) = direction.any_orthonormal_pair();
    let near = |(index, triangle): (usize, &Triangle)| {
        candidate(index as u32, triangle, ray.origin, [right, up, direction])
    };
    let candidates: Vec<Candidate> =
        place.packed.triangles().par_iter().enumerate().filter_map(near).collect();
    let mut tolerance = 1;
    while tolerance <= ROUNDING_LIMIT {
        let at: Vec<_> = candidates.iter().map(|c| c.judge(place, tolerance)).collect();
        let is_clearly_blocked = at.iter().any(|j| j.is_clear);
        let possible = at.iter().find(|j| j.is_possible && !j.is_clear);
        match possible {
            Some(Judged { cause: Some(cause), .. }) if !is_clearly_blocked => {
                return Verdict::Rounding { cause: *cause, tolerance };
            }
            _ => {}
        }
        tolerance *= 2;
    }
    Verdict::Clear { is_blocked: candidates.iter().any(|c| c.judge(place, ROUNDING_LIMIT).is_clear) }
}

fn candidate(
    index: u32,
    triangle: &Triangle,
    origin: Vec3,
    [right, up, forward]: [DVec3; 3],
) -> Option<Candidate> {
    let magnitudes = [origin, triangle.low(), triangle.high()].map(|v| v.abs().max_element());
    let unit = f64::from(magnitudes.into_iter().fold(0.0, f32::max)) * 2f64.powi(-24);
    let reach = unit * f64::from(ROUNDING_LIMIT);
    let corners = [triangle.v0, triangle.v1, triangle.v2].map(|v| v.as_dvec3() - origin.as_dvec3());
    let flat = corners.map(|v| DVec2::new(v.dot(right), v.dot(up)));
    let low = flat[0].min(flat[1]).min(flat[2]) - reach;
    let high = flat[0].max(flat[1]).max(flat[2]) + reach;
    let depths = corners.map(|v| v.dot(forward));
    let farthest = depths[0].max(depths[1]).max(depths[2]);
    if low.cmpgt(DVec2::ZERO).any() || high.cmplt(DVec2::ZERO).any() || farthest < -reach {
        return None;
    }
    let edges = [flat[2] - flat[1], flat[0] - flat[2], flat[1] - flat[0]];
    let area = (flat[1] - flat[0]).perp_dot(flat[2] - flat[0]);
    let sign = if area < 0.0 { -1.0 } else { 1.0 };
    // Twice the area of the triangle that the ray makes with each edge, opposite to vertices 0, 1 and 2.
    let opposite = [0, 1, 2].map(|i| sign * edges[i].perp_dot(-flat[(i + 1) % 3]));
    let lengths = edges.map(|e| e.length().max(f64::MIN_POSITIVE));
    let inside = (0..3).map(|i| opposite[i] / lengths[i]).fold(f64::INFINITY, f64::min);
    if inside < -reach {
        return None;
    }
    let whole = area.abs().max(f64::MIN_POSITIVE);
    let weights = opposite.map(|o| (o / whole).clamp(0.0, 1.0));
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let facing = normal.dot(forward).abs().max(f64::MIN_POSITIVE);
    Some(Candidate {
        index,
        unit,
        inside,
        along: weights[0] * depths[0] + weights[1] * depths[1] + weights[2] * depths[2],
        slope: (normal.length() / facing).min(1e9),
        weights: [weights[1], weights[2]],
        weight_slope: [lengths[1] / whole, lengths[2] / whole],
        is_opaque: triangle.is_opaque(),
    })
}

/// A candidate under one tolerance.
struct Judged {
    is_clear: bool,
    is_possible: bool,
    /// Why it is possible but not clear.
    cause: Option<Cause>,
}

impl Candidate {
    /// Under a tolerance of so many units.
    fn judge(&self, place: &Place, tolerance: u32) -> Judged {
        let distance = self.unit * f64::from(tolerance);
        let (mut any, mut all) = (self.is_opaque, true);
        if !self.is_opaque {
            let coverage = place.coverage();
            for (du, dv) in [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                let at = |i: usize, by: f64| {
                    (self.weights[i] + by * distance * self.weight_slope[i]).clamp(0.0, 1.0) as f32
                };
                let accepts = coverage.accepts(self.index, at(0, du), at(1, dv));
                any |= accepts;
                all &= accepts;
            }
        }
        let start = self.unit * f64::from(tolerance).min(START_LIMIT) * self.slope;
        let is_possible = self.inside > -distance && self.along > -start && any;
        let is_clear = self.inside > distance && self.along > start && all;
        let cause = if self.inside <= distance {
            Cause::Edge
        } else if self.along <= start {
            Cause::Start
        } else {
            Cause::Alpha
        };
        Judged { is_clear, is_possible, cause: (!is_clear).then_some(cause) }
    }
}
