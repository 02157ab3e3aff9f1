//! Every structure answers as the ray tracer does, bit for bit, on millions of rays, hard ones among them.

mod support;

use lt_bvh::{
    AnyHit, BuildQuality, Bvh, Opaque, Ray, RayTest, Simd, Tracer, occluded_in_light_space, triangles_of,
};
use lt_irregular::{
    Casters, DivideAndConquer, LightBvh, Options, PointOrder, SampleMap, Scratch, SimdLevel, Walk, Workspace,
};
use lt_math::glam::{Vec3, Vec4};
use support::{PLACES, Random, Soup, lights, origins};

/// An alpha test that depends on the barycentric weights.
#[derive(Clone, Copy)]
struct Checks;

impl AnyHit for Checks {
    fn accepts(&self, triangle: u32, u: f32, v: f32) -> bool {
        (((u * 8.0) as u32) ^ ((v * 8.0) as u32) ^ triangle) & 1 == 0
    }
}

fn compare<A: AnyHit + Sync>(label: &str, soup: &Soup, light: Vec4, origins: &[Vec3], any_hit: A) -> usize {
    let bvh =
        Bvh::build(&soup.positions, &soup.triangles, |i| i % 3 != 0, BuildQuality::Fast).expect("builds");
    let rays: Vec<Ray> = origins.iter().map(|&o| Ray::to_light(o, light)).collect();
    let mut expected = vec![false; rays.len()];
    Simd::new(&bvh).occluded_batch(&rays, any_hit, &mut expected);
    for (ray, expected) in rays.iter().zip(&expected).step_by(97) {
        assert_eq!(lt_bvh::occluded(bvh.nodes(), bvh.triangles(), *ray, any_hit), *expected);
    }
    let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
    assert_eq!(Casters::of(bvh.triangles()).root, casters.root, "{label}");
    let judge = |what: &str, found: &[bool]| {
        let wrong: Vec<usize> = (0..rays.len()).filter(|&i| found[i] != expected[i]).collect();
        if let Some(&i) = wrong.first() {
            panic!(
                "{label} {what}: {} of {} differ, first {i}: {:?} expected {}",
                wrong.len(),
                rays.len(),
                rays[i],
                expected[i]
            );
        }
    };
    let tree = LightBvh::build(light, soup.bounds(), casters);
    tree.validate(casters).expect("is valid");
    for instructions in SimdLevel::available() {
        let tree = tree.clone().with_instructions(instructions).expect("available");
        for walk in Walk::ALL {
            let mut found = vec![false; rays.len()];
            tree.occluded_by(walk, casters, origins, any_hit, &mut found, &mut Scratch::default());
            judge(&format!("light BVH, {instructions:?}, {walk:?}"), &found);
        }
    }
    let packed = tree.pack(casters).expect("no scene is so deep");
    packed.validate(&tree, casters).expect("is valid");
    let found: Vec<bool> = rays
        .iter()
        .map(|&ray| {
            let (nodes, triangles) = (bvh.nodes(), bvh.triangles());
            occluded_in_light_space(&packed.rows, nodes, triangles, packed.space, ray, any_hit)
        })
        .collect();
    judge("packed light BVH", &found);
    let mut counted = Vec::new();
    for instructions in SimdLevel::available() {
        for order in [PointOrder::Median, PointOrder::Morton] {
            let options = Options { instructions, order, ..Options::default() };
            let mut map = SampleMap::build(light, soup.bounds(), casters, origins, options);
            map.validate().expect("is valid");
            let mut found = vec![false; rays.len()];
            let counters = map.occluded(casters, origins, any_hit, &mut found);
            judge(&format!("sample map, {instructions:?}, {order:?}"), &found);
            counted.push((order, counters.nodes_visited, counters.samples_tested));
        }
    }
    // How many instructions do it at a time changes nothing that is counted.
    for (order, nodes, samples) in &counted {
        assert!(
            counted.iter().all(|c| c.0 != *order || (c.1, c.2) == (*nodes, *samples)),
            "{label}: {counted:?}"
        );
    }
    let mut workspace = Workspace::default();
    for instructions in SimdLevel::available() {
        let mut found = vec![false; rays.len()];
        let both = DivideAndConquer::new(light, soup.bounds()).with_instructions(instructions);
        both.expect("available").occluded(casters, origins, any_hit, &mut found, &mut workspace);
        judge(&format!("divide and conquer, {instructions:?}"), &found);
    }
    for leaf in [1, 1000] {
        let mut found = vec![false; rays.len()];
        let both = DivideAndConquer::new(light, soup.bounds()).with_leaf(leaf);
        both.occluded(casters, origins, any_hit, &mut found, &mut workspace);
        judge(&format!("divide and conquer, leaves of {leaf}"), &found);
    }
    compare_without_a_tree(label, soup, light, origins, any_hit);
    expected.iter().filter(|b| **b).count()
}

/// Triangles as they are, which nobody has put in the order of a tree's leaves, answer as the tree's do.
fn compare_without_a_tree<A: AnyHit + Sync>(
    label: &str,
    soup: &Soup,
    light: Vec4,
    origins: &[Vec3],
    any_hit: A,
) {
    let triangles = triangles_of(&soup.positions, &soup.triangles, |i| i % 3 != 0).expect("indices in range");
    let casters = Casters::of(&triangles);
    let rays = origins.iter().map(|&o| Ray::to_light(o, light));
    let test = |ray: &Ray| {
        let test = RayTest::new(ray, casters.root.low, casters.root.high)?;
        let mut all = triangles.iter().enumerate();
        Some(all.any(|(i, triangle)| test.is_blocked_by(triangle, i as u32, any_hit)))
    };
    let mut found = vec![false; origins.len()];
    let both = DivideAndConquer::new(light, soup.bounds());
    both.occluded(casters, origins, any_hit, &mut found, &mut Workspace::default());
    for (ray, found) in rays.zip(found).step_by(23) {
        assert_eq!(found, test(&ray).unwrap_or(false), "{label}: {ray:?}");
    }
}

#[test]
fn the_light_bvh_answers_as_the_ray_tracer_does() {
    let mut random = Random(1);
    let mut blocked = 0;
    let mut total = 0;
    for (scale, offset) in PLACES {
        for light in lights(&mut random, scale, offset) {
            let count = [3, 200, 1500][random.below(3)];
            let soup = Soup::mixed(&mut random, count, light.truncate()).moved(scale, offset);
            let starts = origins(&mut random, &soup, light, 4_000);
            let label = format!("scale {scale} offset {offset} light {light} triangles {count}");
            blocked += compare(&label, &soup, light, &starts, Opaque);
            blocked += compare(&label, &soup, light, &starts[..1500], Checks);
            total += starts.len() + 1500;
        }
    }
    println!("{blocked} of {total} blocked");
    assert!(blocked * 10 > total && blocked * 10 < total * 9, "{blocked} of {total}");
}

#[test]
fn rays_from_outside_and_broken_rays_are_answered_too() {
    let mut random = Random(2);
    for light in lights(&mut random, 1.0, Vec3::ZERO) {
        let soup = Soup::mixed(&mut random, 300, light.truncate());
        let mut starts: Vec<Vec3> =
            (0..2000).map(|_| random.vector() * [2.0, 100.0, 1e6][random.below(3)]).collect();
        starts.extend([
            Vec3::NAN,
            Vec3::INFINITY,
            Vec3::new(0.0, f32::NAN, 0.0),
            Vec3::splat(1e16),
            light.truncate(),
        ]);
        // Towards the soup's middle from outside.
        starts.extend((0..2000).map(|_| random.vector() * 0.3 - light.truncate() * random.unit() * 10.0));
        compare(&format!("light {light}"), &soup, light, &starts, Opaque);
    }
}

/// Sets that break structures: they must end, and soon.
#[test]
fn pathological_sets_are_answered() {
    let mut random = Random(3);
    let light = Vec4::new(0.2, 1.0, 0.3, 0.0);
    // Large triangles in one place, with rays from between, below and above.
    let mut coincident = Soup::new();
    (0..10_000).for_each(|_| coincident.push([Vec3::ZERO, Vec3::X * 100.0, Vec3::Z * 100.0]));
    let starts: Vec<Vec3> = (0..3000).map(|_| random.vector() * 60.0).collect();
    compare("coincident", &coincident, light, &starts, Opaque);
    // All rays from one place.
    let soup = Soup::mixed(&mut random, 3000, light.truncate());
    compare("one place", &soup, light, &[Vec3::new(0.1, -0.5, 0.2); 3000], Opaque);
    // Slivers across everything.
    let mut slivers = Soup::new();
    for _ in 0..3000 {
        let (a, b) = (random.vector() * 50.0, random.vector() * 50.0);
        slivers.push([a, b, b + random.vector() * 1e-3]);
    }
    compare("slivers", &slivers, light, &starts, Opaque);
    // Nothing, and what the builder drops: no area, no numbers.
    let mut dropped = Soup::new();
    dropped.push([Vec3::ZERO, Vec3::ZERO, Vec3::ONE]);
    dropped.push([Vec3::NAN, Vec3::X, Vec3::Y]);
    dropped.push([Vec3::ZERO, Vec3::X, Vec3::Y]);
    compare("dropped", &dropped, light, &starts, Opaque);
}

/// A light that lies in a triangle's plane, on its face, an edge or a vertex: all edges may then have the same sign for every ray.
#[test]
fn a_light_within_a_triangle_is_answered_too() {
    let mut random = Random(4);
    let mut blocked = 0;
    for (scale, offset) in PLACES {
        for round in 0..8 {
            let soup = Soup::mixed(&mut random, 40, Vec3::ONE).moved(scale, offset);
            // Of every kind one, those in planes of the axes more often.
            let of = soup.triangles[if round % 2 == 0 { 1 + 8 * random.below(5) } else { random.below(40) }];
            let [a, b, c] = of.map(|v| soup.positions[v as usize]);
            for light in [(a + b + c) / 3.0, a.lerp(b, 0.5), c, a + (b - a) * 1.5] {
                let starts = origins(&mut random, &soup, light.extend(1.0), 400);
                let label = format!("scale {scale} offset {offset} light {light}");
                blocked += compare(&label, &soup, light.extend(1.0), &starts, Opaque);
            }
        }
    }
    assert!(blocked > 1000, "{blocked} blocked");
}

/// Slivers along the sun, of which projections are little more than rounding.
#[test]
fn slivers_along_the_sun_are_answered() {
    let mut random = Random(5);
    let mut blocked = 0;
    for (scale, offset) in PLACES {
        for _ in 0..8 {
            let sun = random.vector();
            let mut soup = Soup::new();
            for _ in 0..60 {
                let (at, size) = (random.vector(), [0.1, 1.0][random.below(2)]);
                let along = sun * size + random.vector() * [0.0, 1e-7, 1e-6, 1e-5][random.below(4)];
                soup.push([at, at + random.vector() * size, at + along]);
            }
            let soup = soup.moved(scale, offset);
            let starts = origins(&mut random, &soup, sun.extend(0.0), 2_000);
            let label = format!("scale {scale} offset {offset} sun {sun}");
            blocked += compare(&label, &soup, sun.extend(0.0), &starts, Opaque);
        }
    }
    assert!(blocked > 1000, "{blocked} blocked");
}
