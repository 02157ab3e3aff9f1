//! Input that breaks tracers: nothing, one thing, many of the same, NaN, infinity, extreme shapes and scales.

mod support;

use lt_bvh::{
    BuildError, BuildQuality, Bvh, COORDINATE_LIMIT, Counts, Dropped, InstancedBvh, MAX_DEPTH, Node, Opaque,
    Placement, Ray, Simd, Tracer, Triangle, closest_hit, closest_hit_probed, occluded,
};
use lt_math::glam::{Affine3A, Vec3};
use support::{Mesh, Rng, soup};

const DOWN: Ray = Ray { origin: Vec3::new(0.2, 0.2, 1.0), tmin: 0.0, direction: Vec3::NEG_Z, tmax: 3.0e38 };

fn one() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.triangle([Vec3::ZERO, Vec3::X, Vec3::Y], true);
    mesh
}

fn is_blocked(bvh: &Bvh, ray: Ray) -> bool {
    let mut out = [false];
    Simd::new(bvh).occluded_batch(&[ray], Opaque, &mut out);
    let kernel = occluded(bvh.nodes(), bvh.triangles(), ray, Opaque);
    assert_eq!(kernel, out[0]);
    assert_eq!(kernel, closest_hit(bvh.nodes(), bvh.triangles(), ray, Opaque).is_hit());
    kernel
}

#[test]
fn an_empty_scene_blocks_nothing() {
    for quality in BuildQuality::ALL {
        let bvh = Mesh::default().build(quality);
        bvh.validate().unwrap();
        assert_eq!(bvh.nodes().len(), 1);
        assert!(!is_blocked(&bvh, DOWN));
    }
    assert!(!occluded(&[], &[], DOWN, Opaque));
    assert!(!occluded(&[Node::default()], &[], DOWN, Opaque));
    let scene = InstancedBvh::build(&[], &[]).unwrap();
    scene.validate().unwrap();
    let mut out = [true];
    Simd::instanced(&scene).occluded_batch(&[DOWN], Opaque, &mut out);
    assert!(!out[0]);
}

#[test]
fn one_triangle_is_hit_where_it_is() {
    for quality in BuildQuality::ALL {
        let bvh = one().build(quality);
        bvh.validate().unwrap();
        let hit = closest_hit(bvh.nodes(), bvh.triangles(), DOWN, Opaque);
        assert_eq!((hit.t, hit.triangle, bvh.sources()[0]), (1.0, 0, 0));
        assert!((hit.u - 0.2).abs() < 1e-6 && (hit.v - 0.2).abs() < 1e-6);
        assert!(!is_blocked(&bvh, Ray { origin: Vec3::new(0.6, 0.6, 1.0), ..DOWN }));
    }
}

#[test]
fn both_ends_of_a_ray_are_exclusive() {
    let bvh = one().build(BuildQuality::Medium);
    assert!(!is_blocked(&bvh, Ray { tmax: 1.0, ..DOWN }));
    assert!(is_blocked(&bvh, Ray { tmax: 1.0000001, ..DOWN }));
    assert!(!is_blocked(&bvh, Ray { tmin: 1.0, ..DOWN }));
    assert!(is_blocked(&bvh, Ray { tmin: 0.9999999, ..DOWN }));
    assert!(is_blocked(&bvh, Ray { tmax: f32::INFINITY, ..DOWN }));
    assert!(!is_blocked(&bvh, Ray { origin: Vec3::new(0.2, 0.2, 0.0), ..DOWN }), "starts on the triangle");
    assert!(!is_blocked(&bvh, Ray { tmin: 2.0, tmax: 0.0, ..DOWN }));
}

#[test]
fn rays_that_are_not_rays_hit_nothing() {
    let bvh = soup(1_000, 1).build(BuildQuality::Medium);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e16, -3e38] {
        for axis in 0..3 {
            let mut ray = Ray::new(Vec3::ZERO, Vec3::X);
            ray.origin[axis] = bad;
            assert!(!is_blocked(&bvh, ray));
            let mut ray = Ray::new(Vec3::ZERO, Vec3::X);
            ray.direction[axis] = bad;
            assert!(!is_blocked(&bvh, ray));
        }
    }
    assert!(!is_blocked(&bvh, Ray::new(Vec3::ZERO, Vec3::ZERO)));
    assert!(!is_blocked(&bvh, Ray { tmin: f32::NAN, ..DOWN }));
    assert!(!is_blocked(&bvh, Ray { tmax: f32::NAN, ..DOWN }));
}

#[test]
fn triangles_that_no_ray_can_hit_are_dropped_and_counted() {
    let mut mesh = one();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, COORDINATE_LIMIT] {
        mesh.triangle([Vec3::ZERO, Vec3::X, Vec3::new(0.0, bad, 0.0)], true);
    }
    mesh.triangle([Vec3::ONE; 3], true);
    mesh.triangle([Vec3::ZERO, Vec3::ONE, Vec3::ONE * 2.0], true);
    mesh.triangle([Vec3::ZERO, Vec3::X, Vec3::X], true);
    let bvh = mesh.build(BuildQuality::Medium);
    bvh.validate().unwrap();
    assert_eq!(bvh.dropped(), Dropped { not_finite: 4, zero_area: 3 });
    assert_eq!(bvh.triangles().len(), 1);
    assert!(is_blocked(&bvh, DOWN));
}

#[test]
fn a_triangle_with_two_equal_corners_is_never_hit_even_in_the_kernel() {
    let bvh = one().build(BuildQuality::Medium);
    let mut rng = Rng::new(3);
    for i in 0..30_000 {
        let (a, b) = (rng.cube(), rng.cube());
        let [v0, v1, v2] = [[a, a, b], [a, b, a], [b, a, a]][i % 3];
        let triangle = Triangle { v0, v1, v2, ..Triangle::default() };
        // At the edge itself.
        let target = a + (b - a) * rng.unit();
        let ray = Ray::new(target + rng.direction(), Vec3::ZERO);
        let ray = Ray { direction: target - ray.origin, ..ray };
        assert!(!occluded(bvh.nodes(), &[triangle], ray, Opaque));
    }
}

#[test]
fn bad_indices_and_placements_are_errors_that_name_them() {
    let error = Bvh::build(&[Vec3::ZERO], &[[0, 0, 7]], |_| true, BuildQuality::Fast).unwrap_err();
    assert_eq!(error, BuildError::VertexOutOfRange { triangle: 0, vertex: 7, vertices: 1 });
    let blases = [one().build(BuildQuality::Fast)];
    let place = |blas, object_to_world| InstancedBvh::build(&blases, &[Placement { blas, object_to_world }]);
    assert_eq!(
        place(3, Affine3A::IDENTITY).unwrap_err(),
        BuildError::BlasOutOfRange { placement: 0, blas: 3, count: 1 }
    );
    let singular = [
        Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0)),
        Affine3A::from_scale(Vec3::splat(1e-30)),
        Affine3A::from_scale(Vec3::splat(f32::NAN)),
        Affine3A::from_translation(Vec3::splat(f32::INFINITY)),
        Affine3A::from_translation(Vec3::splat(1e30)),
    ];
    for matrix in singular {
        assert_eq!(place(0, matrix).unwrap_err(), BuildError::Singular { placement: 0 });
    }
    let mut scene = place(0, Affine3A::IDENTITY).unwrap();
    let before = scene.nodes().to_vec();
    scene.place(&[Placement { blas: 0, object_to_world: singular[0] }]).unwrap_err();
    assert_eq!(before, scene.nodes(), "a failed place leaves the scene as it was");
}

/// Shapes that make bad trees.
fn pathological() -> Vec<(&'static str, Mesh)> {
    let mut rng = Rng::new(5);
    let mut same = Mesh::default();
    let mut nested = Mesh::default();
    let mut line = Mesh::default();
    let mut doubling = Mesh::default();
    let mut needles = Mesh::default();
    for i in 0..10_000 {
        same.triangle([Vec3::ZERO, Vec3::X, Vec3::Y], true);
        if i >= 3_000 {
            continue;
        }
        // Equal centroids, every size.
        let s = 1.0 + i as f32;
        nested.triangle([Vec3::new(-s, -s, 0.0), Vec3::new(s, -s, 0.0), Vec3::new(0.0, 2.0 * s, 0.0)], true);
        let at = Vec3::X * i as f32 * 1e-3;
        line.triangle([at, at + Vec3::Y * 1e-6, at + Vec3::Z * 1e6], true);
        let big = 1.01f32.powi(i);
        doubling.triangle([Vec3::X * big, Vec3::Y * big, Vec3::Z * big], true);
        let a = rng.direction();
        needles.triangle([a * -1e3, a * 1e3, a * 1e3 + Vec3::splat(1e-4)], true);
    }
    vec![
        ("10,000 coincident", same),
        ("equal centroids", nested),
        ("huge aspect", line),
        ("exponential sizes", doubling),
        ("needles through one point", needles),
    ]
}

#[test]
fn pathological_scenes_build_within_the_stack_and_trace() {
    for (name, mesh) in pathological() {
        for quality in BuildQuality::ALL {
            let bvh = mesh.build(quality);
            bvh.validate().unwrap_or_else(|e| panic!("{name}: {e}"));
            assert!(bvh.depth() <= MAX_DEPTH, "{name}");
            let mut rng = Rng::new(7);
            for _ in 0..50 {
                is_blocked(&bvh, Ray::new(rng.cube() * 3.0, rng.direction()));
            }
            let mut counts = Counts::default();
            closest_hit_probed(bvh.nodes(), bvh.triangles(), DOWN, Opaque, &mut counts);
            assert!(counts.triangles as usize <= bvh.triangles().len(), "{name}");
        }
    }
}

#[test]
fn hits_are_the_same_at_every_scale_that_is_a_power_of_two() {
    let rays: Vec<Ray> = {
        let mut rng = Rng::new(2);
        (0..3_000).map(|_| Ray::new(rng.cube() * 1.5, rng.direction())).collect()
    };
    let count = |scale: f32| {
        let mut mesh = soup(1_000, 1);
        mesh.positions.iter_mut().for_each(|p| *p *= scale);
        let bvh = mesh.build(BuildQuality::Medium);
        bvh.validate().unwrap();
        let scaled = rays.iter().map(|r| Ray { origin: r.origin * scale, ..*r });
        scaled.filter(|r| is_blocked(&bvh, *r)).count()
    };
    let expected = count(1.0);
    assert!(expected > 100);
    for power in [-40, -20, 20, 40] {
        assert_eq!(count(2.0f32.powi(power)), expected, "scale 2^{power}");
    }
}
