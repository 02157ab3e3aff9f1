#![no_std]
//! Shadow passes as plain functions, and the SPIR-V entry points that call them.
//!
//! # Idea
//! Every pass is one function over small `Copy` views: [`camera::sample_at_hit`], [`evaluate::evaluate`], [`mask::mask`], [`marks::stain`],
//! [`resolve::trace_visibility`], [`filter::filter_x`], [`shade::shade`]. The CPU backend calls it from rayon; the entry points in `entry` (compiled
//! only for SPIR-V, by `cargo xtask build-shaders`) unpack bindings and call it too. Nothing is written twice.
//!
//! The compiled modules are committed in `shaders/` beside a manifest of hashes, as SPIR-V and, translated by naga,
//! as WGSL.
//!
//! ```
//! use lt_math::{Vsm, glam::{Vec3, Vec4}, LightFrame, LightProjection};
//! use lt_shaders::{abi::{LightParams, Sample, ShadowParams}, evaluate::{GatheredDepths, evaluate}};
//!
//! // A sun from above, a map of 64² texels that saw a caster at depth 0.25 everywhere.
//! let frame = LightFrame::from_direction(Vec3::NEG_Y);
//! let projection = LightProjection::orthographic(&frame, Vec3::splat(-1.0), Vec3::splat(1.0));
//! let params = ShadowParams {
//!     projection, light: LightParams::directional(Vec3::Y), test: Vec4::new(1e-6, 0.0, 0.0, 0.0), size: [1, 1].into(),
//!     map_size: 64, epsilon: 0.01, root: 0, level_count: 1, pad0: 0, pad1: 0,
//! };
//! let floor = Sample { position: Vec3::ZERO, normal: Vec3::Y, flags: Sample::RECEIVES, ..Sample::default() };
//! let depths = vec![0.25; 64 * 64];
//! let verdict = evaluate::<Vsm, _, true>(&floor, &params, GatheredDepths { depths: &depths });
//! assert_eq!((verdict.visibility, verdict.is_doubted), (0.0, false));
//! ```

#[cfg(all(feature = "std", not(target_arch = "spirv")))]
extern crate std;

pub mod abi;
pub mod camera;
pub mod depth;
pub mod doubt;
#[cfg(target_arch = "spirv")]
pub mod entry;
pub mod evaluate;
pub mod filter;
pub mod gbuffer;
pub mod geometry;
pub mod layers;
pub mod marks;
pub mod mask;
pub mod neighbours;
pub mod resolve;
pub mod sampling;
pub mod shade;
pub mod surface;
pub mod texture;
