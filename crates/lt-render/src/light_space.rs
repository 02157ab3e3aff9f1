//! The resolvers in the light's own space (lt-irregular): the rays' answers without a ray.

use lt_bvh::{AnyHit, Transmit};
use lt_irregular::{Bounds, Casters, DivideAndConquer, LightBvh, Options, SampleMap, Workspace};
use lt_math::glam::{Vec3, Vec4};

use crate::packed::Trees;
use crate::{FrameJob, PackedScene, RenderError, Resolve};

/// Share of a scene's size by which its box is widened, so that it holds the ray origins just above the surfaces.
const MARGIN: f32 = 1e-4;

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
    Casters { root: &scene.nodes()[scene.root() as usize], triangles: scene.triangles() }
}

fn domain(scene: &PackedScene) -> Bounds {
    let bounds = scene.bounds();
    let margin = Vec3::splat((bounds.max - bounds.min).max_element() * MARGIN);
    Bounds { low: bounds.min - margin, high: bounds.max + margin }
}

/// The tree over a scene for a homogeneous light.
pub(crate) fn tree(scene: &PackedScene, light: Vec4) -> LightBvh {
    LightBvh::build(light, domain(scene), casters(scene))
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
