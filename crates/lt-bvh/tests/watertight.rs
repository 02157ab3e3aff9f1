//! Closed meshes do not leak, and ray origins do not hit their own surface.

mod support;

use lt_bvh::{BuildQuality, Hit, Opaque, Ray, Scalar, Simd, Tracer, closest_hit, occluded, offset_origin};
use lt_math::glam::{DVec3, Vec3};
use support::{Mesh, Rng, city};

/// A closed sphere of 4·n² triangles per octant pair, with shared vertices.
fn sphere(rings: u32, sectors: u32, centre: Vec3, radius: f32) -> Mesh {
    let mut mesh = Mesh::default();
    let point = |ring: u32, sector: u32| {
        let polar = std::f32::consts::PI * ring as f32 / rings as f32;
        let around = std::f32::consts::TAU * (sector % sectors) as f32 / sectors as f32;
        // The poles are one vertex each.
        let s = if ring == 0 || ring == rings { 0.0 } else { polar.sin() };
        centre + Vec3::new(s * around.cos(), polar.cos(), s * around.sin()) * radius
    };
    for ring in 0..rings {
        for sector in 0..sectors {
            let (a, b) = (point(ring, sector), point(ring, sector + 1));
            let (c, d) = (point(ring + 1, sector + 1), point(ring + 1, sector));
            mesh.triangle([a, b, c], true);
            mesh.triangle([a, c, d], true);
        }
    }
    mesh
}

/// Rays from inside through vertices, along edges and through points of edges.
fn rays_at_edges(mesh: &Mesh, from: Vec3, count: usize, seed: u64) -> Vec<Ray> {
    let mut rng = Rng::new(seed);
    (0..count)
        .map(|i| {
            let t = mesh.indices[rng.bits() as usize % mesh.indices.len()];
            let (a, b) = (mesh.positions[t[0] as usize], mesh.positions[t[1 + i % 2] as usize]);
            let target = match i % 4 {
                0 => a,
                1 => (a + b) * 0.5,
                _ => a + (b - a) * rng.unit(),
            };
            let start = from + (target - from) * rng.range(0.0, 0.5) * (i % 3) as f32 * 0.5;
            Ray::new(start, target - start)
        })
        .collect()
}

fn misses(mesh: &Mesh, rays: &[Ray]) -> usize {
    let bvh = mesh.build(BuildQuality::Medium);
    let mut blocked = vec![false; rays.len()];
    let mut leaks = 0;
    Scalar::new(&bvh).occluded_batch(rays, Opaque, &mut blocked);
    leaks += blocked.iter().filter(|b| !**b).count();
    Simd::new(&bvh).occluded_batch(rays, Opaque, &mut blocked);
    leaks + blocked.iter().filter(|b| !**b).count()
}

#[test]
fn three_million_rays_at_the_edges_of_closed_spheres_do_not_leak() {
    for (centre, radius, seed) in [
        (Vec3::ZERO, 1.0, 1),
        (Vec3::new(0.3, -0.2, 0.1), 1e-3, 2),
        (Vec3::new(500.0, 8_000.0, -300.0), 40.0, 3),
    ] {
        let mesh = sphere(48, 96, centre, radius);
        let rays = rays_at_edges(&mesh, centre, 1_000_000, seed);
        assert_eq!(misses(&mesh, &rays), 0, "of a sphere of radius {radius} at {centre}");
    }
}

#[test]
fn rays_at_the_edges_of_a_box_do_not_leak() {
    // Every edge lies in two box planes, and rays along an axis graze them.
    let mut mesh = Mesh::default();
    mesh.block(Vec3::splat(-0.7), Vec3::new(0.3, 0.9, 0.4));
    let mut rays = rays_at_edges(&mesh, Vec3::new(0.1, 0.2, -0.1), 300_000, 4);
    let mut rng = Rng::new(5);
    for i in 0..300_000 {
        let direction = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z][i % 6];
        rays.push(Ray::new(rng.cube() * 0.3, direction));
    }
    assert_eq!(misses(&mesh, &rays), 0);
}

#[test]
fn a_mesh_with_a_hole_leaks_there() {
    let mut mesh = sphere(48, 96, Vec3::ZERO, 1.0);
    let removed = mesh.indices.swap_remove(2_000).map(|i| mesh.positions[i as usize]);
    let ray = Ray::new(Vec3::ZERO, (removed[0] + removed[1] + removed[2]) / 3.0);
    assert_eq!(misses(&mesh, &[ray]), 2, "once for each path");
}

#[test]
fn rays_in_the_plane_of_a_box_side_are_handled() {
    let mesh = city(50, 1);
    let bvh = mesh.build(BuildQuality::Medium);
    let mut rays = Vec::new();
    for t in bvh.triangles() {
        for direction in [Vec3::X, Vec3::Y, Vec3::Z] {
            rays.push(Ray::new(t.v0 - direction * 3.0, direction));
            rays.push(Ray::new(t.v0, t.v1 - t.v0));
        }
    }
    let (mut a, mut b) = (vec![Hit::miss(0.0); rays.len()], vec![Hit::miss(0.0); rays.len()]);
    Scalar::new(&bvh).closest_batch(&rays, Opaque, &mut a);
    Simd::new(&bvh).closest_batch(&rays, Opaque, &mut b);
    assert!(a == b);
}

/// A random triangle of a scene of a scale around an offset, a point on it found by a ray, and its face normal.
fn surface(rng: &mut Rng, scale: f32, offset: f32) -> Option<(Mesh, Vec3, Vec3, f32)> {
    let centre = Vec3::new(offset, -0.7 * offset, 0.3 * offset);
    let size = scale * 10.0f32.powf(rng.range(-2.0, 0.0));
    let at = centre + rng.cube() * scale;
    let corners = [at, at + rng.cube() * size, at + rng.cube() * size];
    let mut mesh = Mesh::default();
    mesh.triangle(corners, true);
    let [a, b, c] = corners.map(|v| v.as_dvec3());
    let normal: DVec3 = (b - a).cross(c - a);
    let longest = (b - a).length().max((c - a).length()).max((c - b).length());
    // Slivers of vertex rounding have no normal to speak of.
    if normal.length() < 0.02 * longest * longest {
        return None;
    }
    let normal = normal.normalize().as_vec3();
    let bvh = mesh.build(BuildQuality::Fast);
    let (u, v) = (rng.range(0.05, 0.45), rng.range(0.05, 0.45));
    let target = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
    let eye = target + rng.direction() * scale * 3.0;
    let ray = Ray::new(eye, (target - eye).normalize());
    let hit = closest_hit(bvh.nodes(), bvh.triangles(), ray, Opaque);
    if !hit.is_hit() {
        return None;
    }
    let [p, q, r] = corners;
    let position = p + (q - p) * hit.u + (r - p) * hit.v;
    let facing = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
    let all = corners.iter().fold(position.abs(), |m, v| m.max(v.abs()));
    Some((mesh, position, facing, all.max_element()))
}

/// Self-hits of grazing rays with the offset scaled by `factor`.
fn self_hits(factor: f32) -> (usize, usize) {
    let mut rng = Rng::new(11);
    let (mut wrong, mut asked) = (0, 0);
    let mut cases: Vec<(f32, f32)> = (-6..=6).map(|power| (10.0f32.powi(power), 0.0)).collect();
    cases.extend([(1.0, 500.0), (1.0, 8_000.0), (100.0, 8_000.0), (1e3, 6e6), (1e5, 6e6)]);
    for (scale, offset) in cases {
        for _ in 0..4_000 {
            let Some((mesh, position, normal, magnitude)) = surface(&mut rng, scale, offset) else {
                continue;
            };
            let bvh = mesh.build(BuildQuality::Fast);
            let origin = offset_origin(position, normal, magnitude * factor);
            for _ in 0..4 {
                // N·L from 0.1 down to nothing.
                let along = rng.direction().cross(normal).normalize_or(normal.any_orthogonal_vector());
                let sine = 10.0f32.powf(rng.range(-6.0, -1.0));
                let ray = Ray::new(origin, (along + normal * sine).normalize());
                asked += 1;
                wrong += usize::from(occluded(bvh.nodes(), bvh.triangles(), ray, Opaque));
            }
        }
    }
    (wrong, asked)
}

#[test]
fn offset_origins_do_not_hit_their_own_surface_at_any_scale_with_a_margin_of_four() {
    let (wrong, asked) = self_hits(0.25);
    assert!(asked > 100_000);
    assert_eq!(wrong, 0, "of {asked} with a quarter of the offset");
    assert!(self_hits(0.03).0 > asked / 100, "with next to no offset this test must fail");
}
