//! Every structure answers as the ray tracer does, bit for bit, on millions of rays, hard ones among them.

use lt_bvh::{AnyHit, BuildQuality, Bvh, Opaque, Ray, Simd, Tracer};
use lt_irregular::{
    Bounds, Casters, DivideAndConquer, Instructions, LightBvh, Options, PointOrder, SampleMap, Scratch, Walk,
};
use lt_math::glam::{Vec3, Vec4};

/// A small generator of numbers (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 16_777_216.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// In [−1, 1)³.
    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}

/// A soup of triangles.
struct Soup {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Soup {
    fn new() -> Self {
        Soup { positions: Vec::new(), triangles: Vec::new() }
    }

    fn push(&mut self, corners: [Vec3; 3]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.triangles.push([first, first + 1, first + 2]);
    }

    /// All kinds of triangles in a cube of half side 1: small, large, slivers, in planes of the axes and of `light`.
    fn mixed(random: &mut Random, count: usize, light: Vec3) -> Self {
        let mut soup = Soup::new();
        for i in 0..count {
            let at = random.vector();
            let size = [0.02, 0.1, 0.5, 1.0][random.below(4)];
            let (mut a, mut b) = (random.vector() * size, random.vector() * size);
            match i % 8 {
                // A sliver, sometimes as thin as f32 allows.
                0 => {
                    b = a * random.unit() + random.vector() * size * [1e-2, 1e-4, 1e-6, 1e-8][random.below(4)]
                }
                // In a plane of two axes.
                1 => {
                    let axis = random.below(3);
                    (a[axis], b[axis]) = (0.0, 0.0);
                }
                // Along the light, nearly or fully.
                2 => {
                    b = light.normalize_or_zero() * size
                        + random.vector() * [0.0, 1e-6, 1e-3][random.below(3)]
                }
                // A tiny one.
                3 => (a, b) = (a * 1e-4, b * 1e-4),
                _ => {}
            }
            soup.push([at, at + a, at + b]);
        }
        soup
    }

    fn moved(mut self, scale: f32, offset: Vec3) -> Self {
        self.positions.iter_mut().for_each(|p| *p = *p * scale + offset);
        self
    }

    fn bounds(&self) -> Bounds {
        self.positions.iter().fold(Bounds::EMPTY, |all, p| all.with(*p))
    }
}

/// Where rays start: anywhere, exactly on vertices, edges and faces, there and a little towards or off the light, below and above.
fn origins(random: &mut Random, soup: &Soup, light: Vec4, count: usize) -> Vec<Vec3> {
    let bounds = soup.bounds();
    let size = bounds.high - bounds.low;
    let mut out = Vec::with_capacity(count);
    for i in 0..count {
        let t = soup.triangles[random.below(soup.triangles.len())].map(|v| soup.positions[v as usize]);
        let to_light = |p: Vec3| light.truncate() - p * light.w;
        let on = match random.below(4) {
            0 => t[0],
            1 => t[0].lerp(t[1], random.unit()),
            2 => {
                let (u, v) = (random.unit(), random.unit());
                t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v * (1.0 - u)
            }
            _ => (t[0] + t[1] + t[2]) / 3.0,
        };
        out.push(match i % 4 {
            0 => bounds.low + size * Vec3::new(random.unit(), random.unit(), random.unit()),
            1 => on,
            // As a receiver's origin is: off its surface by some roundings.
            2 => {
                let normal = (t[1] - t[0]).cross(t[2] - t[0]).normalize_or_zero();
                lt_bvh::offset_origin(
                    on,
                    if normal.dot(to_light(on)) < 0.0 { -normal } else { normal },
                    on.abs().max_element(),
                )
            }
            // Exactly before or behind a vertex or edge, as seen from the light.
            _ => {
                let away = to_light(on).normalize_or_zero() * size.max_element() * (random.unit() - 0.7);
                (on - away).clamp(bounds.low, bounds.high)
            }
        });
    }
    out
}

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
    let casters = Casters { root: &bvh.nodes()[0], triangles: bvh.triangles() };
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
    for instructions in Instructions::available() {
        let tree = tree.clone().with_instructions(instructions).expect("available");
        for walk in Walk::ALL {
            let mut found = vec![false; rays.len()];
            tree.occluded_by(walk, casters, origins, any_hit, &mut found, &mut Scratch::default());
            judge(&format!("light BVH, {instructions:?}, {walk:?}"), &found);
        }
    }
    let mut counted = Vec::new();
    for instructions in Instructions::available() {
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
    for instructions in Instructions::available() {
        let mut found = vec![false; rays.len()];
        let both = DivideAndConquer::new(light, soup.bounds()).with_instructions(instructions);
        both.expect("available").occluded(casters, origins, any_hit, &mut found);
        judge(&format!("divide and conquer, {instructions:?}"), &found);
    }
    expected.iter().filter(|b| **b).count()
}

/// Suns along axes, diagonals and anything; lights within and around.
fn lights(random: &mut Random, scale: f32, offset: Vec3) -> Vec<Vec4> {
    let mut lights: Vec<Vec4> =
        [Vec3::Y, Vec3::NEG_X, Vec3::Z, Vec3::ONE, Vec3::new(1.0, -1.0, 1e-8), Vec3::new(0.3, 1e-20, 0.2)]
            .into_iter()
            .map(|d| d.extend(0.0))
            .collect();
    lights.extend((0..6).map(|_| random.vector().extend(0.0)));
    lights.extend((0..6).map(|_| (random.vector() * scale * 1.5 + offset).extend(1.0)));
    lights
}

#[test]
fn the_light_bvh_answers_as_the_ray_tracer_does() {
    let mut random = Random(1);
    let mut blocked = 0;
    let mut total = 0;
    for (scale, offset) in [
        (1.0, Vec3::ZERO),
        (1e3, Vec3::ZERO),
        (1e-3, Vec3::ZERO),
        (1.0, Vec3::new(500.0, -20.0, 8000.0)),
        (40.0, Vec3::new(1e5, 1e3, -3e5)),
        (1e-12, Vec3::ZERO),
        (1e12, Vec3::ZERO),
    ] {
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
