//! Deforming meshes: a refit tree answers as a fresh one, bit for bit. And the builder writes the same tree whatever
//! the number of threads.

mod support;

use lt_bvh::{AnyHit, BuildError, BuildQuality, Bvh, Hit, Opaque, Ray, Scalar, Simd, SimdLevel, Triangle};
use lt_math::glam::{Quat, Vec3};
use support::{Leaf, Mesh, Rng, city, closest, foliage, leaf_texels, occluded, soup};

fn rays(count: usize, seed: u64) -> Vec<Ray> {
    let mut rng = Rng::new(seed);
    (0..count).map(|_| Ray::new(rng.cube() * 1.5, rng.direction())).collect()
}

/// Twists the mesh about y, stretches it and shakes every vertex.
fn deformed(mesh: &Mesh, amount: f32, seed: u64) -> Vec<Vec3> {
    let mut rng = Rng::new(seed);
    let stretch = Vec3::ONE + rng.cube() * amount * 0.3;
    let moved = |&p: &Vec3| Quat::from_rotation_y(amount * p.y * 2.0) * p * stretch;
    mesh.positions.iter().map(moved).map(|p| p + rng.cube() * amount * 0.01).collect()
}

/// What a hit says, the triangle named as the caller does.
fn named(bvh: &Bvh, hit: &Hit) -> Option<[u32; 4]> {
    let name = || bvh.sources()[hit.triangle as usize];
    hit.is_hit().then(|| [hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), name()])
}

/// Compares a refit tree with a fresh one on the kernel and on every SIMD level; how many rays hit.
fn assert_same_answers<'a, A: AnyHit>(
    refit: &'a Bvh,
    fresh: &'a Bvh,
    rays: &[Ray],
    any_hit: impl Fn(&'a [Triangle]) -> A,
) -> usize {
    let (a, b) = (any_hit(refit.triangles()), any_hit(fresh.triangles()));
    let expected = closest(&Scalar::new(fresh), rays, b);
    let names: Vec<_> = expected.iter().map(|hit| named(fresh, hit)).collect();
    let blocked: Vec<bool> = names.iter().map(Option::is_some).collect();
    let check = |found: Vec<Hit>, occluded: Vec<bool>| {
        for (i, hit) in found.iter().enumerate() {
            assert_eq!(named(refit, hit), names[i], "{:?}", rays[i]);
        }
        assert_eq!(occluded, blocked);
    };
    let scalar = Scalar::new(refit);
    check(closest(&scalar, rays, a), occluded(&scalar, rays, a));
    for level in SimdLevel::available() {
        let simd = Simd::new(refit).with_level(level).expect("available");
        check(closest(&simd, rays, a), occluded(&simd, rays, a));
    }
    blocked.iter().filter(|b| **b).count()
}

#[test]
fn a_refit_tree_hits_what_a_fresh_one_hits() {
    let texels = leaf_texels();
    let rays = rays(3_000, 5);
    for (kind, mut mesh) in [soup(4_000, 1), city(150, 2), foliage(2_000, 3)].into_iter().enumerate() {
        let rest = mesh.positions.clone();
        for quality in BuildQuality::ALL {
            mesh.positions = rest.clone();
            let mut bvh = mesh.build(quality);
            for (step, amount) in [0.05, 0.4, 2.0].into_iter().enumerate() {
                if step > 0 {
                    // From the second step on, the SIMD tracer's tree exists and is refit too.
                    assert!(!occluded(&Simd::new(&bvh), &rays[..1], Opaque).is_empty());
                }
                let before = closest(&Scalar::new(&bvh), &rays, Opaque);
                let order = bvh.sources().to_vec();
                mesh.positions = deformed(&mesh, amount, step as u64);
                bvh.refit(&mesh.positions, &mesh.indices).unwrap();
                bvh.validate().unwrap();
                assert_eq!(bvh.sources(), order, "triangles keep their names");
                let fresh = mesh.build(quality);
                let uvs = &mesh.uvs;
                let hits = if kind == 2 {
                    let leaf = |triangles| Leaf { triangles, uvs, texels: &texels };
                    assert_same_answers(&bvh, &fresh, &rays, leaf)
                } else {
                    assert_same_answers(&bvh, &fresh, &rays, |_| Opaque)
                };
                assert!(hits > 150, "{hits} hits prove little");
                assert_ne!(before, closest(&Scalar::new(&bvh), &rays, Opaque), "nothing has moved");
                bvh.validate().unwrap();
            }
        }
    }
}

#[test]
fn a_refit_back_and_forth_restores_every_bit() {
    let mut mesh = soup(3_000, 8);
    let mut bvh = mesh.build(BuildQuality::Medium);
    let nodes = bvh.nodes().to_vec();
    let rest = mesh.positions.clone();
    mesh.positions = deformed(&mesh, 1.0, 1);
    bvh.refit(&mesh.positions, &mesh.indices).unwrap();
    assert_ne!(bvh.nodes(), nodes);
    bvh.refit(&rest, &mesh.indices).unwrap();
    assert_eq!(bvh.nodes(), nodes);
}

#[test]
fn copies_made_before_a_refit_stay_as_they_were() {
    let mut mesh = soup(500, 4);
    let rays = rays(2_000, 6);
    let mut bvh = mesh.build(BuildQuality::Fast);
    let copy = bvh.clone();
    let before = closest(&Simd::new(&copy), &rays, Opaque);
    mesh.positions = deformed(&mesh, 1.0, 2);
    bvh.refit(&mesh.positions, &mesh.indices).unwrap();
    assert_eq!(closest(&Simd::new(&copy), &rays, Opaque), before);
    assert_ne!(closest(&Simd::new(&bvh), &rays, Opaque), before);
    copy.validate().unwrap();
}

#[test]
fn a_refit_to_another_mesh_is_refused_and_changes_nothing() {
    let mut mesh = soup(200, 9);
    mesh.triangle([Vec3::ZERO; 3], true);
    let rays = rays(1_000, 7);
    let mut bvh = mesh.build(BuildQuality::Medium);
    let before = closest(&Scalar::new(&bvh), &rays, Opaque);
    let count = mesh.indices.len();
    let mut refuse = |positions: &[Vec3], indices: &[[u32; 3]], expected: BuildError| {
        assert_eq!(bvh.refit(positions, indices), Err(expected));
        assert_eq!(closest(&Scalar::new(&bvh), &rays, Opaque), before);
        bvh.validate().unwrap();
    };
    let fewer = BuildError::OtherTriangleCount { found: count - 1, expected: count };
    refuse(&mesh.positions, &mesh.indices[1..], fewer);
    refuse(&mesh.positions, &[], BuildError::OtherTriangleCount { found: 0, expected: count });
    let (vertex, vertices) = (mesh.positions.len() as u32 - 1, mesh.positions.len() - 1);
    let missing =
        BuildError::VertexOutOfRange { triangle: count - 1, vertex: vertex - 1, vertices: vertices - 1 };
    refuse(&mesh.positions[..vertices - 1], &mesh.indices, missing);
    let mut flat = mesh.positions.clone();
    flat[3 * 17 + 1] = flat[3 * 17];
    refuse(&flat, &mesh.indices, BuildError::OtherTriangleDropped { triangle: 17 });
    let mut infinite = mesh.positions.clone();
    infinite[3 * 5] = Vec3::INFINITY;
    refuse(&infinite, &mesh.indices, BuildError::OtherTriangleDropped { triangle: 5 });
    let mut grown = mesh.positions.clone();
    grown[3 * 200] = Vec3::X;
    grown[3 * 200 + 1] = Vec3::Y;
    refuse(&grown, &mesh.indices, BuildError::OtherTriangleDropped { triangle: 200 });
}

#[test]
fn an_empty_tree_refits_to_an_empty_tree() {
    let mut bvh = Mesh::default().build(BuildQuality::Medium);
    bvh.refit(&[], &[]).unwrap();
    bvh.validate().unwrap();
    let mut points = Mesh::default();
    points.triangle([Vec3::ONE; 3], true);
    let mut bvh = points.build(BuildQuality::Medium);
    bvh.refit(&[Vec3::NAN; 3], &points.indices).unwrap();
    assert_eq!((bvh.dropped().not_finite, bvh.dropped().zero_area), (1, 0));
}

/// Regular and irregular meshes, some with many centres in one place, where sorting has ties to break.
fn meshes() -> [Mesh; 4] {
    let mut same = Mesh::default();
    for i in 0..10_000 {
        let corner = Vec3::splat((i % 3) as f32);
        same.triangle([corner, corner + Vec3::X, corner + Vec3::Y], true);
    }
    [soup(20_000, 11), city(1_500, 12), foliage(8_000, 13), same]
}

#[test]
fn the_tree_is_the_same_for_any_number_of_threads() {
    for (i, mesh) in meshes().iter().enumerate() {
        for quality in BuildQuality::ALL {
            let build = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| mesh.build(quality))
            };
            let expected = build(1);
            expected.validate().unwrap();
            for threads in [2, 3, 7] {
                let found = build(threads);
                assert!(found.nodes() == expected.nodes(), "mesh {i}, {quality:?}, {threads} threads: nodes");
                assert!(
                    found.sources() == expected.sources(),
                    "mesh {i}, {quality:?}, {threads} threads: order"
                );
            }
        }
    }
}
