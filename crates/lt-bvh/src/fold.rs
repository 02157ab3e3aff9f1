//! What a ray gathers on its way: a value that every hit may change, in any order, until it can change no more.

use crate::any_hit::AnyHit;
use crate::transmit::Transmit;
use lt_math::glam::Vec3;

/// A way to gather a value from hits whose order does not matter, asking a callback of type `C`.
///
/// The callback stays an argument of its own, and state is passed by value: a callback that holds slices inside another
/// struct, or behind a second reference, does not compile to valid SPIR-V.
pub(crate) trait Fold<C> {
    /// What is gathered.
    type State: Copy;
    /// The state after a hit on the triangle at `index`, at barycentric weights `u` and `v`.
    fn meet(callback: &C, state: Self::State, is_opaque: bool, index: u32, u: f32, v: f32) -> Self::State;
    /// Whether no further hit can change the state.
    fn is_over(state: Self::State) -> bool;
}

/// Whether anything that the alpha callback accepts was hit.
pub(crate) struct Blocked;

impl<A: AnyHit> Fold<A> for Blocked {
    type State = bool;
    #[inline(always)]
    fn meet(any_hit: &A, _state: bool, is_opaque: bool, index: u32, u: f32, v: f32) -> bool {
        is_opaque || any_hit.accepts(index, u, v)
    }
    #[inline(always)]
    fn is_over(state: bool) -> bool {
        state
    }
}

/// The product of what all hits let through.
pub(crate) struct Product;

impl<T: Transmit> Fold<T> for Product {
    type State = Vec3;
    #[inline(always)]
    fn meet(transmit: &T, state: Vec3, _is_opaque: bool, index: u32, u: f32, v: f32) -> Vec3 {
        state * transmit.transmittance(index, u, v)
    }
    #[inline(always)]
    fn is_over(state: Vec3) -> bool {
        state == Vec3::ZERO
    }
}
