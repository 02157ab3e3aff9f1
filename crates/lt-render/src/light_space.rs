//! The resolvers in the light's own space (lt-irregular): the rays' answers without a ray.

use lt_bvh::{AnyHit, ORIGIN_ULPS, Transmit};
use lt_irregular::{Bounds, Casters, DivideAndConquer, LightBvh, Options, SampleMap, Workspace};
use lt_math::glam::{Vec3, Vec4};

use crate::light_fit::or_unit_box;
use crate::packed::Trees;
use crate::{FrameJob, PackedScene, RenderError, Resolve};

/// Share of a scene's size by which its box is widened at least.
const MARGIN: f32 = 1e-4;
/// What it is widened by at least in units of 2⁻²³ of the scene's largest coordinate: ray origins lie that many of [`ORIGIN_ULPS`] above
/// their surfaces, which far from the coordinates' own origin is more than any share of the scene's size; as much again for rounding.
const MARGIN_ULPS: f32 = 2.0 * ORIGIN_ULPS;

/// Refuses scenes that have no one tree in world space.
///
/// # Errors
/// [`RenderError::Unsupported`] for a scene of placed copies.
pub(crate) fn check(scene: &PackedScene, job: &FrameJob) -> Result<(), RenderError> {
    match (job.plan.resolve.modifier(), scene.trees()) {
        (Some(resolver), Trees::Instanced(_)) => Err(RenderError::Unsupported(format!(
            "the resolver `{resolver}` needs a scene packed into one tree, and this one has placed copies: set `Packing::bakes_copies`"
        ))),
        _ => Ok(()),
    }
}

/// All triangles, as the resolvers take them.
pub(crate) fn casters(scene: &PackedScene) -> Casters<'_> {
    Casters::of_tree(&scene.nodes()[scene.root() as usize], scene.triangles())
}

/// The scene's box with the ray origins just above its surfaces: a ray from outside is put to every triangle.
fn domain(scene: &PackedScene) -> Bounds {
    let bounds = or_unit_box(scene.bounds());
    let magnitude = bounds.min.abs().max(bounds.max.abs()).max_element();
    let size = (bounds.max - bounds.min).max_element();
    let margin = Vec3::splat((size * MARGIN).max(magnitude * (MARGIN_ULPS / 8_388_608.0)));
    Bounds { low: bounds.min - margin, high: bounds.max + margin }
}

/// The tree over a scene for a homogeneous light.
pub(crate) fn tree(scene: &PackedScene, light: Vec4) -> LightBvh {
    LightBvh::build(light, domain(scene), casters(scene))
}

/// What a light's tree took, which all techniques walk: each is charged for it once, whoever comes first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planted {
    ms: f64,
    charged: Vec<usize>,
}

impl Planted {
    /// Of a tree that was just planted.
    pub fn in_ms(ms: f64) -> Self {
        Self { ms, charged: Vec::new() }
    }

    /// Milliseconds that the technique of a slot ([`FrameJob::slot`]) has to answer for in this frame.
    pub fn charge(&mut self, slot: usize) -> f64 {
        if self.charged.contains(&slot) {
            return 0.0;
        }
        self.charged.push(slot);
        self.ms
    }
}

/// Answers all of a frame's rays at once, by a resolver that keeps nothing but memory.
pub(crate) fn occluded<A: AnyHit + Sync>(
    scene: &PackedScene,
    resolve: Resolve,
    light: Vec4,
    origins: &[Vec3],
    any_hit: A,
    (out, workspace): (&mut [bool], &mut Workspace),
) {
    let (casters, domain) = (casters(scene), domain(scene));
    if resolve == Resolve::AliasFree {
        SampleMap::build(light, domain, casters, origins, Options::default())
            .occluded(casters, origins, any_hit, out);
    } else {
        DivideAndConquer::new(light, domain).occluded(casters, origins, any_hit, out, workspace);
    }
}

/// What translucent casters let through of the rays from these origins, by an alias-free map.
pub(crate) fn transmitted<T: Transmit + Sync>(
    scene: &PackedScene,
    casters: Casters<'_>,
    light: Vec4,
    origins: &[Vec3],
    transmit: T,
    out: &mut [Vec3],
) {
    SampleMap::build(light, domain(scene), casters, origins, Options::default())
        .transmitted(casters, origins, transmit, out);
}

#[cfg(test)]
mod tests {
    use lt_bvh::{Ray, offset_origin};
    use lt_irregular::View;
    use lt_math::glam::Affine3A;
    use lt_scene::{Mesh, Scene};

    use super::*;

    /// A flat roof, 100 units wide, with its middle here.
    fn roof(middle: Vec3) -> PackedScene {
        let corners = [[-50.0, -50.0], [-50.0, 50.0], [50.0, 50.0], [50.0, -50.0]];
        let positions = corners.map(|[x, z]| middle + Vec3::new(x, 0.0, z)).to_vec();
        let mesh = Mesh { positions, indices: vec![0, 1, 2, 0, 2, 3], ..Mesh::default() };
        let mut scene = Scene::default();
        scene.materials.push(lt_scene::Material::opaque("roof", Vec3::ONE));
        scene.place(mesh, Affine3A::IDENTITY);
        PackedScene::new(&scene).unwrap()
    }

    /// Nobody's ray is put to every triangle, however far from the coordinates' own origin a scene lies.
    #[test]
    fn views_take_the_rays_of_a_flat_roof_wherever_it_stands() {
        for middle in [Vec3::ZERO, Vec3::new(2e4, 30.0, 0.0), Vec3::new(0.0, -3e6, 1e5), Vec3::splat(1e8)] {
            let scene = roof(middle);
            let root = casters(&scene).root;
            for light in
                [Vec4::new(0.2, 1.0, 0.1, 0.0), (middle + Vec3::Y * (90.0 + middle.y.abs())).extend(1.0)]
            {
                let views: Vec<View> = View::of_light(light, domain(&scene), root).collect();
                for triangle in scene.triangles() {
                    let corners = [triangle.v0, triangle.v1, triangle.v2];
                    let magnitude = corners.iter().fold(0.0f32, |most, p| most.max(p.abs().max_element()));
                    for position in corners.into_iter().chain([(corners[0] + corners[1]) * 0.5]) {
                        let ray = Ray::to_light(offset_origin(position, Vec3::Y, magnitude), light);
                        assert!(ray.origin.y > middle.y, "{middle}: lies on the roof");
                        assert!(
                            views.iter().any(|view| view.takes(&ray)),
                            "{middle}, light {light}: {ray:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_scene_of_nothing_has_a_box() {
        let scene = PackedScene::new(&Scene::default()).unwrap();
        assert!(domain(&scene).contains(Vec3::ZERO));
    }
}
