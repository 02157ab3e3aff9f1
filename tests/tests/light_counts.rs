//! What a shadow ray costs as a point of light space, in nodes and triangles that the shared kernels test: `-- --nocapture` prints them.

use lt_bvh::{Counts, Ray, occluded_in_light_space_probed, occluded_probed};
use lt_irregular::{Bounds, Casters, LightBvh};
use lt_math::glam::Vec3;
use lt_render::{PackedScene, Setup, Technique};
use lt_shaders::abi::Material;
use lt_shaders::evaluate::settle;
use lt_shaders::resolve::shadow_ray;
use lt_shaders::surface::Coverage;
use lt_tests::{builtin, cpu_session};

#[test]
fn points_meet_fewer_triangles_than_rays_and_answer_alike() {
    println!("per ray             nodes  triangles    as a point: nodes  triangles");
    for (name, most_nodes) in [("street", 15.0), ("square", 27.0), ("forest", 19.0), ("random:100000", 5.5)] {
        let scene = builtin(name);
        let mut setup = Setup::for_scene(&scene, 320, 180);
        setup.packing.bakes_copies = true;
        let packed = PackedScene::with(&scene, setup.packing).expect("packed");
        let session = cpu_session(&scene, 320, 180);
        let light = session.job(&Technique::RAY).shadow.light;
        let samples = session.samples().iter().filter(|s| !settle(s, &light).1);
        let rays: Vec<Ray> = samples.map(|s| shadow_ray(s, &light)).collect();
        let (nodes, triangles) = (packed.nodes(), packed.triangles());
        let casters = Casters::of_tree(&nodes[0], triangles);
        let (bounds, margin) = (packed.bounds(), Vec3::splat(0.01));
        let domain = Bounds { low: bounds.min - margin, high: bounds.max + margin };
        let tree = LightBvh::build(light.place, domain, casters);
        let tree = tree.pack(casters).expect("is not deep");
        let any_hit = Coverage {
            triangles,
            vertices: packed.vertices(),
            materials: packed.materials(),
            alpha_texels: packed.alpha_texels(),
            required_flags: Material::CASTS,
        };
        let (mut as_rays, mut as_points) = (Counts::default(), Counts::default());
        for ray in &rays {
            assert!(tree.space.takes(ray), "{name} {ray:?}");
            let truth = occluded_probed(nodes, triangles, *ray, any_hit, &mut as_rays);
            let (rows, space) = (&tree.rows, tree.space);
            let found =
                occluded_in_light_space_probed(rows, nodes, triangles, space, *ray, any_hit, &mut as_points);
            assert_eq!(found, truth, "{name} {ray:?}");
        }
        let mean = |count: u32| f64::from(count) / rays.len() as f64;
        println!(
            "{name:<18} {:>6.2} {:>10.2} {:>20.2} {:>10.2}",
            mean(as_rays.nodes),
            mean(as_rays.triangles),
            mean(as_points.nodes),
            mean(as_points.triangles)
        );
        assert!(as_points.triangles < as_rays.triangles, "{name}: {as_points:?} against {as_rays:?}");
        assert!(mean(as_points.nodes) < most_nodes, "{name}: {as_points:?} of {} points", rays.len());
    }
}
