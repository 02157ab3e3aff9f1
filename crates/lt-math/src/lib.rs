#![no_std]
//! Shadow mathematics on plain values: what a map stores, what it answers, and when not to believe it.
//!
//! # Idea
//!
//! A shadow map knows depths at texel centres; a receiver falls between them. A *filterable* map turns each depth into a
//! small vector, lets any filter blend the vectors, and reads from the blend an upper bound on the share of the
//! footprint that does not block the receiver. Such bounds err to one side only: they may leak light, never invent
//! shadow. The leak tracing test makes use of that: an answer near 0 or 1 is believed, all else gets a ray
//! ([`needs_ray`]; Kern, Brüll, Grosch 2024).
//!
//! | kind | stores b(z) | answers by |
//! |---|---|---|
//! | [`Sm`] | z | comparison at the nearest texel |
//! | [`Pcf`] | z | weighted comparisons |
//! | [`Vsm`] | z, z² | [`chebyshev`] |
//! | [`Esm`] | e^{c(z−1)} | Markov's bound |
//! | [`Evsm`] | e^{c₊z}, its square, −e^{−c₋z}, its square | the smaller of two [`chebyshev`] bounds |
//! | [`MsmHamburger`] | z, z², z³, z⁴ | [`hamburger`] |
//! | [`MsmHausdorff`] | z, z², z³, z⁴ | [`hausdorff`] |
//!
//! All implement [`ShadowTest`], which asks them in two ways: from filtered vectors, and from the four plain depths of a
//! 2×2 gather. The second needs no special map, and nothing cancels there: VSM and EVSM compute their variance, MSM its
//! determinants ([`six_atoms`]), from differences of depths. It is the same bound, biases included.
//!
//! # Conventions
//!
//! - Visibility: 1 lit, 0 shadowed. Depth: linear along the light's axis, 0 near, 1 far; values outside count as the end.
//! - uv: [0, 1]² with v downwards; texel centres at + 0.5; footprints in the order (x0 y0, x1 y0, x0 y1, x1 y1).
//! - Several maps of one light are levels ([`LevelSource`]): cascades, or the faces of a cube. Level 0 is the finest.
//! - World positions are f32, relative to an origin near the viewer ([`LightProjection`]).
//! - NaN: goes in, comes out, and becomes a ray. Nothing hides one in a `min`, `max` or `clamp`; unsolvable moments
//!   (of filtered maps) answer NaN on purpose. Tests for NaN look at bits, because shader compilers may assume that NaNs do not exist.
//! - Sums have a fixed order, and [`float::exp`] is our own: CPU and GPU can agree to the bit.
//!
//! `no_std`, no allocation, no panics. Enable `std` (default) or `libm`; SPIR-V needs neither.
//!
//! # Example
//!
//! ```
//! use lt_math::glam::{Vec3, Vec4};
//! use lt_math::{Evsm, LTT_EPSILON, LightFrame, LightProjection, ShadowTest, bilinear_footprint, needs_ray};
//!
//! // A sun straight overhead, its map covering 20 × 20 units and 10 units of depth.
//! let frame = LightFrame::from_direction(Vec3::NEG_Y);
//! let projection = LightProjection::orthographic(&frame, Vec3::new(-10.0, -10.0, -5.0), Vec3::new(10.0, 10.0, 5.0));
//!
//! let receiver = projection.project(Vec3::new(1.3, 0.0, -2.0));
//! assert!(receiver.is_inside);
//! let footprint = bilinear_footprint(receiver.uv * 1024.0);
//!
//! // The four texels at footprint.texel: all blocked, none blocked, and an edge.
//! let visibility = |depths| Evsm::default().visibility_of_gather(depths, footprint.weights, receiver.depth);
//! assert!(visibility(Vec4::splat(0.2)) < LTT_EPSILON);
//! assert_eq!(visibility(Vec4::splat(0.9)), 1.0);
//! assert!(needs_ray(visibility(Vec4::new(0.2, 0.9, 0.2, 0.9)), LTT_EPSILON));
//! assert!(needs_ray(f32::NAN, LTT_EPSILON));
//! ```

#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm", target_arch = "spirv")))]
compile_error!("lt-math needs floats from somewhere: enable feature `std` (default) or `libm`");

pub use glam;

mod cascade;
pub mod chebyshev;
mod esm;
mod evsm;
pub mod float;
mod gather;
mod gaussian;
pub mod hamburger;
pub mod hankel;
pub mod hausdorff;
mod lanes;
mod light_frame;
mod light_space;
mod ltt;
pub mod moments;
mod msm;
mod pcf;
mod shadow_test;
pub mod six_atoms;
mod sm;
mod vsm;

pub use cascade::{DEFAULT_SPLIT_BLEND, LevelPoint, LevelSource, Levels, OneLevel, level_margin_uv};
#[cfg(not(target_arch = "spirv"))]
pub use cascade::{snapped_interval, split_depth};
pub use esm::{DEFAULT_ESM_EXPONENT, Esm, MAX_ESM_EXPONENT};
pub use evsm::{
    DEFAULT_NEGATIVE_EXPONENT, DEFAULT_POSITIVE_EXPONENT, Evsm, MAX_EVSM_EXPONENT, MAX_EVSM_EXPONENT_F16,
};
pub use gather::{Footprint, bilinear_footprint, blend, lit_fraction};
pub use gaussian::{GAUSSIAN_MAX_RADIUS, gaussian_weight, gaussian_weights};
pub use light_frame::{LightFrame, cube_face_of_direction};
pub use light_space::{LightPoint, LightProjection};
pub use ltt::{LTT_EPSILON, needs_ray};
pub use msm::{MsmHamburger, MsmHausdorff};
pub use pcf::Pcf;
pub use shadow_test::ShadowTest;
pub use sm::{DEFAULT_DEPTH_BIAS, Sm};
pub use vsm::{DEFAULT_MIN_VARIANCE, Vsm};
