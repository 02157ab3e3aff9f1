//! What a triangle does to the samples that it meets: it blocks them, or takes some of their light.

use lt_bvh::{AnyHit, Transmit};
use lt_math::glam::Vec3;

/// What is done to samples.
pub(crate) trait Paint: Copy + Sync {
    /// Whether a triangle that is surely met blocks without being asked.
    fn blocks_unasked(self, is_opaque: bool) -> bool;
    /// What becomes of a sample whose ray meets a triangle with these weights of its second and third vertex; `true` once nothing more can
    /// happen to it.
    fn meet(self, triangle: u32, is_opaque: bool, weights: (f32, f32), tint: Option<&mut Vec3>) -> bool;
}

/// Samples become blocked.
#[derive(Clone, Copy)]
pub(crate) struct Darken<A>(pub A);

impl<A: AnyHit + Sync> Paint for Darken<A> {
    #[inline(always)]
    fn blocks_unasked(self, is_opaque: bool) -> bool {
        A::IS_OPAQUE || is_opaque
    }

    #[inline(always)]
    fn meet(self, triangle: u32, is_opaque: bool, (u, v): (f32, f32), _tint: Option<&mut Vec3>) -> bool {
        is_opaque || self.0.accepts(triangle, u, v)
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

    #[inline(always)]
    fn meet(self, triangle: u32, _is_opaque: bool, (u, v): (f32, f32), tint: Option<&mut Vec3>) -> bool {
        let Some(tint) = tint else { return false };
        *tint *= self.0.transmittance(triangle, u, v);
        *tint == Vec3::ZERO
    }
}
