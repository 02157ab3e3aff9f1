//! Alias-free maps: products of what lets light pass, and inputs made to hurt.

use lt_bvh::{BuildQuality, Bvh, Opaque, Ray, Transmit, transmitted};
use lt_irregular::{
    Bounds, Casters, Counters, DivideAndConquer, LightBvh, Options, PointOrder, SampleMap, Scratch,
    SimdLevel, Workspace,
};
use lt_math::glam::{Vec3, Vec4};

const SUN: Vec4 = Vec4::new(0.2, 0.1, 1.0, 0.0);

/// Every triangle lets another share of each colour pass, every seventh nothing.
#[derive(Clone, Copy)]
struct Stained;

impl Transmit for Stained {
    fn transmittance(&self, triangle: u32, u: f32, v: f32) -> Vec3 {
        let share = |n: u32| 0.5 + 0.5 * ((triangle.wrapping_mul(n) >> 7) % 100) as f32 / 100.0;
        let clear = Vec3::new(share(0x9e37_79b9), share(0x85eb_ca6b), 0.9 + 0.05 * (u + v));
        if triangle % 7 == 6 { Vec3::ZERO } else { clear }
    }
}

fn scattered(count: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let at = |i: u32, n: u32| (i.wrapping_mul(n) >> 8) as f32 / 16_777_216.0 * 2.0 - 1.0;
    let vector = |i: u32| Vec3::new(at(i, 0x9e37_79b1), at(i, 0x85eb_ca77), at(i, 0xc2b2_ae3d));
    let positions = (0..count)
        .flat_map(|i| {
            let corner = vector(3 * i + 1);
            [corner, corner + vector(3 * i + 2) * 0.3, corner + vector(3 * i + 3) * 0.3]
        })
        .collect();
    (positions, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
}

fn grid(side: usize, z: f32) -> Vec<Vec3> {
    let at = |i: usize| (i as f32 + 0.37) / side as f32 * 2.0 - 1.0;
    (0..side * side).map(|i| Vec3::new(at(i % side), at(i / side), z)).collect()
}

fn bounds(positions: &[Vec3], origins: &[Vec3]) -> Bounds {
    positions.iter().chain(origins).fold(Bounds::EMPTY, |all, p| all.with(*p))
}

fn build(positions: &[Vec3], triangles: &[[u32; 3]]) -> Bvh {
    Bvh::build(positions, triangles, |_| true, BuildQuality::Fast).expect("builds")
}

fn casters(bvh: &Bvh) -> Casters<'_> {
    Casters::of_tree(&bvh.nodes()[0], bvh.triangles())
}

#[test]
fn light_is_multiplied_as_the_ray_tracer_does() {
    let (positions, triangles) = scattered(400);
    let bvh = build(&positions, &triangles);
    let origins = grid(96, -1.5);
    for light in [SUN, Vec4::new(0.3, -0.2, 2.5, 1.0), Vec4::new(0.1, 0.1, 0.2, 1.0)] {
        let domain = bounds(&positions, &origins);
        let mut all: Vec<Vec<Vec3>> = Vec::new();
        for instructions in SimdLevel::available() {
            for order in [PointOrder::Median, PointOrder::Morton] {
                let options = Options { instructions, order, ..Options::default() };
                let mut map = SampleMap::build(light, domain, casters(&bvh), &origins, options);
                let mut out = vec![Vec3::ZERO; origins.len()];
                map.transmitted(casters(&bvh), &origins, Stained, &mut out);
                all.push(out);
            }
        }
        // Triangles are taken in their own order: nothing else can change a bit.
        assert!(all.iter().all(|out| *out == all[0]), "light {light}");
        let mut tinted = 0;
        for (origin, found) in origins.iter().zip(&all[0]) {
            let ray = Ray::to_light(*origin, light);
            let expected = transmitted(bvh.nodes(), bvh.triangles(), ray, Stained);
            assert!((*found - expected).abs().max_element() <= 1e-5, "{ray:?}: {found}, not {expected}");
            tinted += usize::from(expected != Vec3::ONE && expected != Vec3::ZERO);
        }
        assert!(tinted > 300, "light {light}: {tinted} rays are tinted");
    }
}

/// Rays that a view takes, rays from outside, and what is no ray; buffers full of something else, and too short.
#[test]
fn what_stood_in_a_buffer_does_not_answer() {
    let (positions, triangles) = scattered(400);
    let bvh = build(&positions, &triangles);
    let mut origins = grid(24, -1.5);
    let domain = bounds(&positions, &origins);
    origins.extend([Vec3::new(0.0, 0.0, -4.0), Vec3::splat(9.0), Vec3::NAN, Vec3::INFINITY]);
    for light in [SUN, Vec4::new(0.1, 0.1, 0.2, 1.0), Vec4::ZERO] {
        let mut map = SampleMap::build(light, domain, casters(&bvh), &origins, Options::default());
        let tree = LightBvh::build(light, domain, casters(&bvh));
        let both = DivideAndConquer::new(light, domain);
        let rays: Vec<Ray> = origins.iter().map(|&o| Ray::to_light(o, light)).collect();
        let ask = |ray: &Ray| lt_bvh::occluded(bvh.nodes(), bvh.triangles(), *ray, Opaque);
        let expected: Vec<bool> = rays.iter().map(ask).collect();
        let passed: Vec<Vec3> =
            rays.iter().map(|&ray| transmitted(bvh.nodes(), bvh.triangles(), ray, Stained)).collect();
        for (asked, len) in [(origins.len(), origins.len()), (origins.len(), 100), (100, origins.len())] {
            let (asked, end) = (&origins[..asked], asked.min(len));
            let mut found = [true, false].map(|b| vec![b; len]);
            for found in &mut found {
                map.occluded(casters(&bvh), asked, Opaque, found);
            }
            let mut others = [vec![true; len], vec![true; len]];
            tree.occluded(casters(&bvh), asked, Opaque, &mut others[0], &mut Scratch::default());
            both.occluded(casters(&bvh), asked, Opaque, &mut others[1], &mut Workspace::default());
            for found in found.iter().chain(&others) {
                assert_eq!(found[..end], expected[..end], "light {light}");
            }
            for found in [&found[0], &others[0], &others[1]] {
                assert!(
                    found[end..].iter().all(|b| *b),
                    "light {light}: what nobody asked for is left alone"
                );
            }
            let mut tints = vec![Vec3::splat(9.0); len];
            map.transmitted(casters(&bvh), asked, Stained, &mut tints);
            for (found, expected) in tints[..end].iter().zip(&passed) {
                assert!((*found - *expected).abs().max_element() <= 1e-5, "light {light}: {found}");
            }
            assert!(tints[end..].iter().all(|tint| *tint == Vec3::splat(9.0)), "light {light}");
        }
    }
}

/// Triangles in another order, by the names that they had before.
#[derive(Clone, Copy)]
struct Renamed<'a>(&'a [u32]);

impl Transmit for Renamed<'_> {
    fn transmittance(&self, triangle: u32, u: f32, v: f32) -> Vec3 {
        Stained.transmittance(self.0[triangle as usize], u, v)
    }
}

#[test]
fn casters_in_any_order_let_the_same_light_pass() {
    let (positions, triangles) = scattered(1500);
    let bvh = build(&positions, &triangles);
    let origins = grid(64, -1.5);
    let domain = bounds(&positions, &origins);
    let mut names: Vec<u32> = (0..bvh.triangles().len() as u32).collect();
    for round in 0..4u32 {
        let shuffled: Vec<_> = names.iter().map(|&name| bvh.triangles()[name as usize]).collect();
        let casters = Casters { triangles: &shuffled, ..casters(&bvh) };
        let mut map = SampleMap::build(SUN, domain, casters, &origins, Options::default());
        let mut out = vec![Vec3::ZERO; origins.len()];
        map.transmitted(casters, &origins, Renamed(&names), &mut out);
        for (origin, found) in origins.iter().zip(&out) {
            let ray = Ray::to_light(*origin, SUN);
            let expected = transmitted(bvh.nodes(), bvh.triangles(), ray, Stained);
            assert!(
                (*found - expected).abs().max_element() <= 1e-5,
                "round {round}, {ray:?}: {found}, not {expected}"
            );
        }
        names.sort_by_key(|name| name.wrapping_add(round).wrapping_mul(0x9e37_79b1));
    }
}

#[test]
fn any_number_of_threads_gives_the_same() {
    let (positions, triangles) = scattered(3000);
    let bvh = build(&positions, &triangles);
    let origins = grid(128, -1.5);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("pool");
        pool.install(|| {
            let domain = bounds(&positions, &origins);
            let mut map = SampleMap::build(SUN, domain, casters(&bvh), &origins, Options::default());
            let mut out = vec![false; origins.len()];
            let counters = map.occluded(casters(&bvh), &origins, Opaque, &mut out);
            (out, counters)
        })
    };
    assert_eq!(run(1), run(3));
}

/// What rasterising takes stays in proportion to triangles × depth of the tree, or samples, whatever they are.
fn rasterise(positions: &[Vec3], triangles: &[[u32; 3]], origins: &[Vec3]) -> (Counters, usize, usize) {
    let bvh = build(positions, triangles);
    let domain = bounds(positions, origins);
    let mut map = SampleMap::build(SUN, domain, casters(&bvh), origins, Options::default());
    map.validate().expect("is valid");
    let mut out = vec![false; origins.len()];
    let counters = map.occluded(casters(&bvh), origins, Opaque, &mut out);
    for (origin, out) in origins.iter().zip(&out).step_by(17) {
        let ray = Ray::to_light(*origin, SUN);
        assert_eq!(lt_bvh::occluded(bvh.nodes(), bvh.triangles(), ray, Opaque), *out);
    }
    (counters, out.iter().filter(|b| **b).count(), map.node_count())
}

#[test]
fn ten_thousand_large_triangles_in_one_place_are_the_work_of_one() {
    let positions = [Vec3::new(-9.0, -9.0, 1.0), Vec3::new(9.0, -9.0, 1.0), Vec3::new(0.0, 12.0, 1.0)];
    let (counters, blocked, _) = rasterise(&positions, &[[0, 1, 2]; 10_000], &grid(200, 0.0));
    assert_eq!(blocked, 40_000);
    assert_eq!(counters.samples_tested, 0, "whole nodes lie under the first");
    // The first thousand are sorted into parts before any of them is drawn; of the others each meets a closed root.
    assert!(counters.nodes_visited <= 1024 * 63 + 10_000, "{counters:?}");
}

#[test]
fn all_samples_in_one_place_do_no_harm() {
    let (positions, triangles) = scattered(1000);
    let origins = vec![Vec3::new(0.01, 0.02, -1.5); 30_000];
    let (counters, blocked, nodes) = rasterise(&positions, &triangles, &origins);
    assert!(blocked == 0 || blocked == origins.len(), "one place, one answer: {blocked}");
    assert!(counters.nodes_visited <= 1000 * nodes as u64);
}

#[test]
fn slivers_across_everything_and_broken_triangles_do_no_harm() {
    let mut positions = Vec::new();
    for i in 0..2000 {
        let y = i as f32 / 1000.0 - 1.0;
        positions.extend([
            Vec3::new(-9.0, y, 1.0),
            Vec3::new(9.0, y + 1e-6, 1.0),
            Vec3::new(9.0, y - 0.01, 1.0 + 1e-3),
        ]);
    }
    positions.extend([Vec3::NAN, Vec3::ZERO, Vec3::ZERO, Vec3::INFINITY]);
    let mut triangles: Vec<[u32; 3]> = (0..2000).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    triangles.extend([[6000, 0, 1], [6001, 6002, 6001], [6003, 1, 2]]);
    let finite: Vec<Vec3> = positions.iter().copied().filter(|p| p.is_finite()).collect();
    let origins = grid(150, 0.0);
    let bvh = build(&positions, &triangles);
    assert_eq!(bvh.dropped().not_finite + bvh.dropped().zero_area, 3);
    let (counters, blocked, _) = rasterise(&finite, &triangles[..2000], &origins);
    assert!(blocked > 0 && blocked < origins.len());
    assert!(counters.samples_tested <= 2000 * origins.len() as u64 / 20, "{counters:?}");
}

#[test]
fn nothing_is_blocked_by_nothing() {
    let origins = grid(10, 0.0);
    let (counters, blocked, _) = rasterise(&[], &[], &origins);
    assert_eq!((counters, blocked), (Counters::default(), 0));
    let (positions, triangles) = scattered(10);
    assert_eq!(rasterise(&positions, &triangles, &[]).1, 0);
}
