//! An order for rays that come from here and there: side by side across their common direction.
//!
//! Rays of one picture's shadow edges follow one another on the picture, and lie far apart before the light wherever one thing hides
//! another. Put along a Z-shaped curve in the plane across the light's direction (Morton 1966), packets of 64 meet fewer boxes. Finding the order takes
//! some 5 ns a ray, most of it the first look at the rays; docs/results/rays.md has what it gains.

use crate::lanes::{NodeLanes, Work};
use crate::ray::Ray;
use lt_math::glam::{Mat4, Vec3};
use std::vec;
use std::vec::Vec;

/// Most rays that are put in order together: their places are two bytes each, and both copies of them fit into a second-level cache.
pub(crate) const MOST: usize = 4096;
/// Fewer do not repay it: they fill few packets.
const LEAST: usize = 1024;
/// Bits of a cell's place along each axis. With 11, sorted by in two passes, packets are no better.
const BITS: u32 = 6;
const CELLS: usize = 1 << (2 * BITS);
/// Rays whose places are found together.
const GROUP: usize = 16;

/// Whether up to [`MOST`] rays are many, and parallel as far as a look at three of them tells. Any rays may be put in order; it serves
/// parallel ones.
pub(super) fn serves(rays: &[Ray]) -> bool {
    let len = rays.len();
    (LEAST..=MOST).contains(&len)
        && rays[0].direction == rays[len / 2].direction
        && rays[0].direction == rays[len - 1].direction
}

/// Rays in an order of their own, and where they came from: work memory for [`Simd::occluded_scattered`](super::Simd::occluded_scattered), some 200 KB
/// once rays were put in order, best kept from call to call.
#[derive(Default)]
pub struct RayOrder {
    rays: Vec<Ray>,
    from: Vec<u16>,
    is_blocked: Vec<bool>,
    /// Places across the direction, then cells.
    places: [Vec<f32>; 2],
    cells: Vec<u16>,
    counts: Vec<u16>,
}

impl RayOrder {
    /// Allocates on first use: many callers never have rays enough.
    fn make_room(&mut self) {
        if self.rays.is_empty() {
            *self = RayOrder {
                rays: vec![Ray::default(); MOST],
                from: vec![0; MOST],
                is_blocked: vec![false; MOST],
                places: [vec![0.0; MOST], vec![0.0; MOST]],
                cells: vec![0; MOST],
                counts: vec![0; CELLS],
            };
        }
    }

    /// The rays in order, and room for their answers.
    pub(super) fn batch(&mut self, len: usize) -> (&[Ray], &mut [bool]) {
        (&self.rays[..len], &mut self.is_blocked[..len])
    }

    /// Brings the answers back to where the rays came from.
    pub(super) fn deliver(&self, out: &mut [bool]) {
        for (&from, &is_blocked) in self.from.iter().zip(&self.is_blocked).take(out.len()) {
            out[usize::from(from)] = is_blocked;
        }
    }

    /// Finds places across the first ray's direction; least and largest along both axes.
    #[inline(always)]
    fn find_places(&mut self, rays: &[Ray]) -> [[f32; 2]; 2] {
        let (u, v) = axes_across(rays[0].direction);
        let [(ux, uy, uz), (vx, vy, vz)] = [u, v].map(|axis| (axis.x, axis.y, axis.z));
        let [us, vs] = &mut self.places;
        let (mut least, mut most) = ([[f32::MAX; GROUP]; 2], [[f32::MIN; GROUP]; 2]);
        let (groups, rest) = rays.as_chunks::<GROUP>();
        let mut last = [Ray { origin: rays[0].origin, ..Ray::default() }; GROUP];
        last[..rest.len()].copy_from_slice(rest);
        let last = (!rest.is_empty()).then_some(&last);
        let places = us.as_chunks_mut::<GROUP>().0.iter_mut().zip(vs.as_chunks_mut::<GROUP>().0);
        for (rays, (us, vs)) in groups.iter().chain(last).zip(places) {
            let [mut x, mut y, mut z] = [[0.0; GROUP]; 3];
            for (group, four) in rays.as_chunks::<4>().0.iter().enumerate() {
                let [a, b, c, d] =
                    four.each_ref().map(|ray| bytemuck::cast_ref::<Ray, [[f32; 4]; 2]>(ray)[0].into());
                let four = Mat4::from_cols(a, b, c, d).transpose();
                x[4 * group..4 * group + 4].copy_from_slice(&four.x_axis.to_array());
                y[4 * group..4 * group + 4].copy_from_slice(&four.y_axis.to_array());
                z[4 * group..4 * group + 4].copy_from_slice(&four.z_axis.to_array());
            }
            for i in 0..GROUP {
                us[i] = x[i] * ux + y[i] * uy + z[i] * uz;
                vs[i] = x[i] * vx + y[i] * vy + z[i] * vz;
            }
            for (k, places) in [us, vs].into_iter().enumerate() {
                for i in 0..GROUP {
                    // Comparisons with NaN are false.
                    least[k][i] = if places[i] < least[k][i] { places[i] } else { least[k][i] };
                    most[k][i] = if places[i] > most[k][i] { places[i] } else { most[k][i] };
                }
            }
        }
        [0, 1].map(|k| {
            let least = least[k].iter().fold(f32::MAX, |a, &b| a.min(b));
            [least, most[k].iter().fold(f32::MIN, |a, &b| a.max(b))]
        })
    }

    /// Finds each ray's cell along the curve.
    #[inline(always)]
    fn find_cells(&mut self, len: usize, limits: [[f32; 2]; 2]) {
        const SIDE: f32 = (1u32 << BITS) as f32;
        let scale = limits.map(|[least, most]| SIDE / (most - least).max(f32::MIN_POSITIVE));
        let [us, vs] = &self.places;
        let places = us.as_chunks::<GROUP>().0.iter().zip(vs.as_chunks::<GROUP>().0);
        let cells = self.cells.as_chunks_mut::<GROUP>().0.iter_mut().take(len.div_ceil(GROUP));
        for (cells, (us, vs)) in cells.zip(places) {
            for i in 0..GROUP {
                let (u, v) =
                    (spread((us[i] - limits[0][0]) * scale[0]), spread((vs[i] - limits[1][0]) * scale[1]));
                cells[i] = (u | v << 1) as u16;
            }
        }
    }

    /// Counting sort by cells.
    #[inline(always)]
    fn sort(&mut self, rays: &[Ray]) {
        let cells = &self.cells[..rays.len()];
        self.counts.fill(0);
        for &cell in cells {
            self.counts[usize::from(cell)] += 1;
        }
        let mut first = 0;
        for count in &mut self.counts {
            (*count, first) = (first, first + *count);
        }
        let from = &mut self.from[..rays.len()];
        for (i, &cell) in cells.iter().enumerate() {
            let place = &mut self.counts[usize::from(cell)];
            from[usize::from(*place)] = i as u16;
            *place += 1;
        }
        for (ray, &from) in self.rays.iter_mut().zip(&*from) {
            *ray = rays[usize::from(from)];
        }
    }
}

/// Bits of a place in cells, of which the lowest [`BITS`] count, with room for another's between them. Places that are no numbers have some cell, too.
#[inline(always)]
fn spread(place: f32) -> u32 {
    const LAST: f32 = ((1u32 << BITS) - 1) as f32;
    // Comparisons with NaN are false.
    let place = if place > 0.0 { place } else { 0.0 };
    let place = if place < LAST { place } else { LAST };
    // The lowest bits of the sum's mantissa are the place, rounded.
    let x = (place + ROUNDER).to_bits() & ((1 << BITS) - 1);
    let x = (x | x << 4) & 0x0f0f;
    let x = (x | x << 2) & 0x3333;
    (x | x << 1) & 0x5555
}

/// 2²³: a whole number added to it is its mantissa.
const ROUNDER: f32 = 8_388_608.0;

/// Two unit vectors across a direction and each other; anything for one that has none.
fn axes_across(direction: Vec3) -> (Vec3, Vec3) {
    let along = direction.normalize_or(Vec3::Z);
    along.any_orthonormal_pair()
}

/// Puts rays in order.
pub(crate) struct Arrange<'a> {
    pub order: &'a mut RayOrder,
    pub rays: &'a [Ray],
}

impl Work for Arrange<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, _: L) {
        let Arrange { order, rays } = self;
        order.make_room();
        let limits = order.find_places(rays);
        order.find_cells(rays.len(), limits);
        order.sort(rays);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::Chosen;

    fn rays(len: usize) -> Vec<Ray> {
        let mut state = 3u32;
        let mut unit = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        };
        let direction = Vec3::new(0.3, 0.9, -0.2);
        (0..len).map(|_| Ray::new(Vec3::new(unit(), unit(), unit()) * 10.0, direction)).collect()
    }

    #[test]
    fn every_ray_is_there_once_and_its_answer_comes_back() {
        for len in [LEAST, LEAST + 1, 2000, MOST - 1, MOST] {
            let mut rays = rays(len);
            rays[7].origin.x = f32::NAN;
            rays[8].origin.y = f32::INFINITY;
            rays[len - 1].origin.z = -1e30;
            let mut order = RayOrder::default();
            Chosen::best().run(Arrange { order: &mut order, rays: &rays });
            let mut seen = vec![false; len];
            for (ray, &from) in order.rays.iter().zip(&order.from).take(len) {
                assert!(!core::mem::replace(&mut seen[usize::from(from)], true), "{from} twice");
                let (a, b): ([u32; 8], [u32; 8]) =
                    (bytemuck::cast(*ray), bytemuck::cast(rays[usize::from(from)]));
                assert_eq!(a, b);
            }
            let (sorted, answers) = order.batch(len);
            let is_high = |ray: &Ray| ray.origin.y > 5.0;
            sorted.iter().zip(answers).for_each(|(ray, answer)| *answer = is_high(ray));
            let mut out = vec![false; len];
            order.deliver(&mut out);
            assert!(rays.iter().zip(&out).all(|(ray, &answer)| answer == is_high(ray)));
        }
    }

    #[test]
    fn neighbours_in_order_lie_side_by_side() {
        let rays = rays(MOST);
        let mut order = RayOrder::default();
        Chosen::best().run(Arrange { order: &mut order, rays: &rays });
        let (u, v) = axes_across(rays[0].direction);
        let extent = |rays: &[Ray]| {
            let of = |axis: Vec3| {
                let along = |ray: &Ray| ray.origin.dot(axis);
                let (least, most) =
                    rays.iter().map(along).fold((f32::MAX, f32::MIN), |(a, b), x| (a.min(x), b.max(x)));
                most - least
            };
            of(u) + of(v)
        };
        let mean = |rays: &[Ray]| rays.chunks(64).map(extent).sum::<f32>() / 64.0;
        assert!(mean(&order.rays) < 0.3 * mean(&rays), "{} of {}", mean(&order.rays), mean(&rays));
    }

    #[test]
    fn only_many_parallel_rays_are_served() {
        let many = rays(MOST);
        assert!(serves(&many) && serves(&many[..LEAST]));
        assert!(!serves(&many[..LEAST - 1]) && !serves(&[]));
        let mut turned = many;
        turned[MOST - 1].direction.x = 1.0;
        assert!(!serves(&turned));
    }
}
