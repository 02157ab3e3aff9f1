//! Every path against brute force, and every SIMD path against the shared kernel, bit for bit.

mod support;

use lt_bvh::{
    AnyHit, BuildQuality, Bvh, Grouping, Hit, InstancedBvh, NONE, Opaque, Placement, Ray, RayOrder, Scalar,
    Simd, SimdLevel, Triangle, closest_hit,
};
use lt_math::glam::{Affine3A, DVec3, Quat, Vec3};
use support::{Leaf, Mesh, Rng, city, closest, foliage, leaf_texels, occluded, soup, sun_rays};

/// Rays of every kind through a scene about the size of the unit cube.
fn rays_of_all_kinds(count: usize, seed: u64) -> Vec<Ray> {
    let mut rng = Rng::new(seed);
    let ray = |i: usize| {
        let origin = rng.cube() * 1.5;
        let direction = match i % 8 {
            0 => [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z][i / 8 % 6],
            // In a plane of two axes, and almost.
            1 => Vec3::new(rng.range(-1.0, 1.0), 0.0, rng.range(-1.0, 1.0)),
            2 => Vec3::new(rng.range(-1.0, 1.0), 1e-30, -1e-12),
            // Grazing the ground.
            3 => Vec3::new(rng.range(-1.0, 1.0), rng.range(-1e-4, 1e-4), rng.range(-1.0, 1.0)),
            _ => rng.direction() * rng.range(0.01, 100.0),
        };
        let ray = Ray::new(origin, direction);
        if i.is_multiple_of(5) {
            Ray { tmin: rng.range(0.0, 0.5), tmax: rng.range(0.3, 2.0), ..ray }
        } else {
            ray
        }
    };
    (0..count).map(ray).collect()
}

fn bits(hit: &Hit) -> [u32; 5] {
    [hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), hit.triangle, hit.instance]
}

/// Fails at the first ray whose answers differ.
fn assert_same_hits(found: &[Hit], expected: &[Hit], rays: &[Ray], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        assert_eq!(bits(a), bits(b), "{what}: ray {i}, {:?}: {a:?} against {b:?}", rays[i]);
    }
}

/// SIMD at every level against the kernel, closest and occluded, and each occluded against closest.
fn assert_agreement<'a, A: AnyHit>(
    scalar: &Scalar,
    simd: impl Fn() -> Simd<'a>,
    rays: &[Ray],
    any_hit: A,
) -> usize {
    let expected = closest(scalar, rays, any_hit);
    let blocked: Vec<bool> = expected.iter().map(Hit::is_hit).collect();
    assert_eq!(occluded(scalar, rays, any_hit), blocked, "occluded and closest of the kernel");
    for level in SimdLevel::available() {
        let simd_at = |level| simd().with_level(level).expect("an available level");
        let simd = simd_at(level);
        let what = format!("{level:?}");
        assert_same_hits(&closest(&simd, rays, any_hit), &expected, rays, &what);
        for grouping in Grouping::ALL {
            let simd = simd_at(level).with_grouping(grouping);
            assert!(occluded(&simd, rays, any_hit) == blocked, "{what} occluded, {grouping:?}");
            let mut scattered = vec![false; rays.len()];
            simd.occluded_scattered(rays, any_hit, &mut scattered, &mut RayOrder::default());
            assert!(scattered == blocked, "{what} scattered, {grouping:?}");
        }
    }
    blocked.iter().filter(|b| **b).count()
}

/// The nearest hit by an independent test of every triangle.
fn brute_force(bvh: &Bvh, rays: &[Ray]) -> Vec<Hit> {
    let nearest = |ray: &Ray| {
        let mut best = Hit::miss(ray.tmax);
        for (index, triangle) in bvh.triangles().iter().enumerate() {
            let Some((t, u, v)) = reference_hit(triangle, ray) else { continue };
            if t > f64::from(ray.tmin) && t < f64::from(best.t) {
                best = Hit { t: t as f32, u: u as f32, v: v as f32, triangle: index as u32, instance: NONE };
            }
        }
        best
    };
    rays.iter().map(nearest).collect()
}

/// Möller & Trumbore 1997 in f64: an independent test.
fn reference_hit(triangle: &Triangle, ray: &Ray) -> Option<(f64, f64, f64)> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let v0 = triangle.v0.as_dvec3();
    let (e1, e2): (DVec3, DVec3) = (triangle.v1.as_dvec3() - v0, triangle.v2.as_dvec3() - v0);
    let p = d.cross(e2);
    let det = e1.dot(p);
    let s = o - v0;
    let u = s.dot(p) / det;
    let q = s.cross(e1);
    let v = d.dot(q) / det;
    let t = e2.dot(q) / det;
    (det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0).then_some((t, u, v))
}

#[test]
fn every_preset_agrees_with_brute_force_in_f64() {
    for mesh in [soup(300, 1), city(20, 2), foliage(150, 3)] {
        for quality in BuildQuality::ALL {
            let bvh = mesh.build(quality);
            bvh.validate().unwrap();
            let rays = rays_of_all_kinds(6_000, 4);
            let found = closest(&Scalar::new(&bvh), &rays, Opaque);
            let expected = brute_force(&bvh, &rays);
            // An f32 test may differ from an f64 one only for rays within rounding of an edge or of tmin, tmax.
            let differ = |(a, b): &(&Hit, &Hit)| {
                a.is_hit() != b.is_hit() || (a.t - b.t).abs() > 1e-4 * a.t.abs().max(1e-2)
            };
            let wrong = found.iter().zip(&expected).filter(differ).count();
            let hits = found.iter().filter(|hit| hit.is_hit()).count();
            assert!(hits > 300, "{hits} hits show too little");
            assert!(wrong <= 3, "{wrong} of {} rays differ at {quality:?}", rays.len());
        }
    }
}

#[test]
fn every_preset_gives_the_same_hits() {
    let mesh = city(300, 5);
    let rays = rays_of_all_kinds(50_000, 6);
    let by_source = |quality| {
        let bvh = mesh.build(quality);
        let mut hits = closest(&Scalar::new(&bvh), &rays, Opaque);
        for hit in &mut hits {
            // Coplanar duplicates tie at the same t, and which index is lowest depends on the leaf order.
            (hit.u, hit.v, hit.triangle) = (0.0, 0.0, u32::from(hit.is_hit()));
        }
        hits
    };
    let expected = by_source(BuildQuality::Fast);
    assert_same_hits(&by_source(BuildQuality::Medium), &expected, &rays, "medium");
    assert_same_hits(&by_source(BuildQuality::Slow), &expected, &rays, "slow");
}

#[test]
fn simd_answers_with_the_kernels_bits_on_every_kind_of_scene_and_ray() {
    for (mesh, least) in [(soup(5_000, 1), 50_000), (city(1_500, 2), 20_000), (foliage(6_000, 3), 20_000)] {
        let bvh = mesh.build(BuildQuality::Medium);
        let mut rays = rays_of_all_kinds(200_000, 7);
        rays.extend(sun_rays(&bvh, 256));
        let hits = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Opaque);
        assert!(hits > least, "{hits} hits show too little");
    }
}

/// Triangles as small as the distance of rays: packets fall apart into rays that share nodes and nothing else.
#[test]
fn packets_that_fall_apart_answer_with_the_kernels_bits() {
    let bvh = soup(60_000, 5).build(BuildQuality::Fast);
    let rays = sun_rays(&bvh, 128);
    // Every seventh: neighbours in the list are none in the picture, as in a list of doubted pixels.
    let scattered: Vec<Ray> = (0..7).flat_map(|first| rays.iter().skip(first).step_by(7).copied()).collect();
    for rays in [rays, scattered, rays_to_a_point(11)] {
        let hits = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Opaque);
        assert!(hits > rays.len() / 50, "{hits} hits of {} rays show too little", rays.len());
    }
}

#[test]
fn simd_answers_with_the_kernels_bits_under_an_alpha_test() {
    let mesh = foliage(6_000, 3);
    let bvh = mesh.build(BuildQuality::Medium);
    let texels = leaf_texels();
    let leaf = Leaf { triangles: bvh.triangles(), uvs: &mesh.uvs, texels: &texels };
    let mut rays = rays_of_all_kinds(200_000, 8);
    rays.extend(sun_rays(&bvh, 256));
    let opaque = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Opaque);
    let tested = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, leaf);
    assert!(tested < opaque && tested > opaque / 4, "{tested} of {opaque}: the callback has no effect");
}

#[derive(Clone, Copy)]
struct Never;

impl AnyHit for Never {
    fn accepts(&self, _: u32, _: f32, _: f32) -> bool {
        false
    }
}

#[test]
fn opaque_triangles_never_reach_the_callback() {
    let bvh = soup(500, 1).build(BuildQuality::Medium);
    let rays = rays_of_all_kinds(20_000, 9);
    let hits = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Never);
    assert!(hits > 1_000);
    let mut mesh = soup(500, 1);
    mesh.is_opaque.fill(false);
    let bvh = mesh.build(BuildQuality::Medium);
    assert_eq!(assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Never), 0);
}

/// Placements with rotation, uneven and mirrored scale.
fn placements(count: usize, meshes: u32, seed: u64) -> Vec<Placement> {
    let mut rng = Rng::new(seed);
    let placement = |i: usize| {
        let mut scale = Vec3::new(rng.range(0.05, 0.4), rng.range(0.05, 0.4), rng.range(0.05, 0.4));
        if i.is_multiple_of(3) {
            scale.x = -scale.x;
        }
        let rotation = Quat::from_axis_angle(rng.direction(), rng.range(0.0, 6.0));
        let object_to_world = Affine3A::from_scale_rotation_translation(scale, rotation, rng.cube());
        Placement { blas: i as u32 % meshes, object_to_world }
    };
    (0..count).map(placement).collect()
}

#[test]
fn instances_agree_with_their_flattened_triangles() {
    let meshes = [soup(60, 1), city(5, 2)];
    let blases: Vec<Bvh> = meshes.iter().map(|m| m.build(BuildQuality::Medium)).collect();
    let placed = placements(20, 2, 3);
    let scene = InstancedBvh::build(&blases, &placed).unwrap();
    scene.validate().unwrap();
    let mut flat = Mesh::default();
    for placement in &placed {
        for t in blases[placement.blas as usize].triangles() {
            let corners = [t.v0, t.v1, t.v2].map(|v| placement.object_to_world.transform_point3(v));
            flat.triangle(corners, true);
        }
    }
    let rays = rays_of_all_kinds(40_000, 4);
    let found = closest(&Scalar::instanced(&scene), &rays, Opaque);
    let flat = flat.build(BuildQuality::Medium);
    let expected = closest(&Scalar::new(&flat), &rays, Opaque);
    let differ =
        |(a, b): &(&Hit, &Hit)| a.is_hit() != b.is_hit() || (a.t - b.t).abs() > 1e-4 * a.t.abs().max(1e-2);
    let wrong = found.iter().zip(&expected).filter(differ).count();
    let hits = found.iter().filter(|hit| hit.is_hit()).count();
    assert!(hits > 5_000, "{hits} hits show too little");
    assert!(wrong < 10, "{wrong} of {} rays differ", rays.len());
    for hit in found.iter().filter(|hit| hit.is_hit()) {
        let blas = placed[scene.instances()[hit.instance as usize].source as usize].blas as usize;
        let first = scene.first_triangle(blas).unwrap();
        let held = first..first + blases[blas].triangles().len() as u32;
        assert!(held.contains(&hit.triangle));
    }
}

/// Rays of neighbours toward a point light, tile by tile, some of them unusable: packets whose rays differ in direction.
fn rays_to_a_point(seed: u64) -> Vec<Ray> {
    let mut rng = Rng::new(seed);
    let light = Vec3::new(0.3, 1.4, -0.2);
    let mut rays = Vec::new();
    for _ in 0..1_500 {
        let corner = Vec3::new(rng.range(-1.0, 1.0), rng.range(-1.0, 1.2), rng.range(-1.0, 1.0));
        for i in 0..61 {
            let origin = corner + Vec3::new((i % 8) as f32, (i / 8) as f32 * 0.3, (i / 8) as f32) * 0.004;
            let direction = if rng.unit() < 0.01 { Vec3::NAN } else { light - origin };
            rays.push(Ray { tmax: 1.0, ..Ray::new(origin, direction) });
        }
    }
    rays
}

#[test]
fn packets_toward_a_point_answer_with_the_kernels_bits() {
    let rays = rays_to_a_point(11);
    let mesh = foliage(6_000, 3);
    let bvh = mesh.build(BuildQuality::Medium);
    let texels = leaf_texels();
    let leaf = Leaf { triangles: bvh.triangles(), uvs: &mesh.uvs, texels: &texels };
    let opaque = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Opaque);
    let tested = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, leaf);
    assert!(
        opaque > 10_000 && tested < opaque && tested > opaque / 4,
        "{tested} of {opaque} show too little"
    );
    let bvh = soup(5_000, 1).build(BuildQuality::Medium);
    let hits = assert_agreement(&Scalar::new(&bvh), || Simd::new(&bvh), &rays, Opaque);
    assert!(hits > 10_000, "{hits} hits show too little");
}

#[test]
fn packets_answer_with_the_kernels_bits_on_instances() {
    let meshes = [soup(500, 1), city(20, 2), foliage(300, 3), Mesh::default()];
    let blases: Vec<Bvh> = meshes.iter().map(|m| m.build(BuildQuality::Medium)).collect();
    let scene = InstancedBvh::build(&blases, &placements(100, 4, 5)).unwrap();
    let to_a_point = rays_to_a_point(12);
    let sun = Vec3::new(0.2, 1.0, -0.4);
    let to_a_sun: Vec<Ray> = to_a_point.iter().map(|ray| Ray::new(ray.origin, sun)).collect();
    for rays in [to_a_point, to_a_sun] {
        let hits = assert_agreement(&Scalar::instanced(&scene), || Simd::instanced(&scene), &rays, Opaque);
        assert!(hits > 10_000, "{hits} hits show too little");
    }
}

#[test]
fn simd_answers_with_the_kernels_bits_on_instances() {
    let meshes = [soup(500, 1), city(20, 2), foliage(300, 3), Mesh::default()];
    let blases: Vec<Bvh> = meshes.iter().map(|m| m.build(BuildQuality::Medium)).collect();
    let mut scene = InstancedBvh::build(&blases, &placements(100, 4, 5)).unwrap();
    let rays = rays_of_all_kinds(200_000, 6);
    for seed in [7, 8] {
        let hits = assert_agreement(&Scalar::instanced(&scene), || Simd::instanced(&scene), &rays, Opaque);
        assert!(hits > 20_000, "{hits} hits show too little");
        scene.place(&placements(100, 4, seed)).unwrap();
        scene.validate().unwrap();
    }
}

#[test]
fn ties_go_to_the_lowest_triangle_then_the_lowest_instance() {
    let mut mesh = Mesh::default();
    for _ in 0..40 {
        mesh.triangle([Vec3::ZERO, Vec3::X, Vec3::Y], true);
    }
    let bvh = mesh.build(BuildQuality::Medium);
    let ray = Ray::new(Vec3::new(0.2, 0.2, 1.0), -Vec3::Z);
    assert_eq!(closest_hit(bvh.nodes(), bvh.triangles(), ray, Opaque).triangle, 0);
    let placement = Placement { blas: 0, object_to_world: Affine3A::IDENTITY };
    let scene = InstancedBvh::build(&[bvh], &[placement; 9]).unwrap();
    let hits = closest(&Scalar::instanced(&scene), &[ray], Opaque);
    assert_eq!((hits[0].triangle, hits[0].instance), (0, 0));
    assert_agreement(&Scalar::instanced(&scene), || Simd::instanced(&scene), &[ray], Opaque);
}
