//! What a triangle does to the samples that it meets: it blocks them, or takes some of their light.

use super::Scene;
use lt_bvh::{AnyHit, Ray, Transmit};
use lt_math::glam::Vec3;

/// What is done to samples.
pub(crate) trait Paint: Copy + Sync {
    /// Whether a triangle that is surely met blocks without being asked.
    fn blocks_unasked(self, is_opaque: bool) -> bool;
    /// What a sample becomes that the ray tracer's test is to decide about; `true` once nothing more can happen to it.
    fn meet(self, scene: &Scene<'_, Self>, source: u32, triangle: u32, tint: Option<&mut Vec3>) -> bool;
}

/// Samples become blocked.
#[derive(Clone, Copy)]
pub(crate) struct Block<A>(pub A);

impl<A: AnyHit + Sync> Paint for Block<A> {
    #[inline(always)]
    fn blocks_unasked(self, is_opaque: bool) -> bool {
        A::IS_OPAQUE || is_opaque
    }

    #[inline(never)]
    fn meet(self, scene: &Scene<'_, Self>, source: u32, triangle: u32, _tint: Option<&mut Vec3>) -> bool {
        let ray = Ray::to_light(scene.origins[source as usize], scene.light);
        let is_opaque = scene.casters.triangles[triangle as usize].is_opaque();
        let hit = scene.casters.meet(&ray, triangle);
        hit.is_some_and(|(u, v)| is_opaque || self.0.accepts(triangle, u, v))
    }
}

/// Samples lose light.
#[derive(Clone, Copy)]
pub(crate) struct Tint<T>(pub T);

impl<T: Transmit + Sync> Paint for Tint<T> {
    #[inline(always)]
    fn blocks_unasked(self, _is_opaque: bool) -> bool {
        false
    }

    #[inline(never)]
    fn meet(self, scene: &Scene<'_, Self>, source: u32, triangle: u32, tint: Option<&mut Vec3>) -> bool {
        let ray = Ray::to_light(scene.origins[source as usize], scene.light);
        let (Some(tint), Some((u, v))) = (tint, scene.casters.meet(&ray, triangle)) else { return false };
        *tint *= self.0.transmittance(triangle, u, v);
        *tint == Vec3::ZERO
    }
}
