#![no_std]
//! Wide BVHs, watertight triangles, occlusion rays: one traversal for the CPU and the GPU.
//!
//! # The idea
//!
//! A ray's answer is a **function of the ray and the triangles alone**. Trees, orders of traversal and instruction
//! sets only change how fast it comes. Three rules make that hold bit for bit:
//!
//! 1. The triangle test is watertight (Woop, Benthin, Wald 2013) and decides by arithmetic that neighbours share.
//! 2. A hit counts only if the ray also meets the triangle's own box, widened by a margin that covers all
//!    rounding; nodes are widened by twice as much, so no node test can cut off a hit that counts.
//! 3. Of hits at the same t the lowest triangle index wins, then the lowest instance.
//!
//! The **shared kernel** ([`closest_hit`], [`occluded`] and their `_instanced` forms) is `no_std`, needs no allocator
//! and compiles to SPIR-V. It walks eight-wide nodes of 80 bytes ([`Node`]; Ylitie, Karras, Laine 2017). On the CPU,
//! feature `build` adds construction with obvhs (`Bvh`, `InstancedBvh`) and, behind the `Tracer` seam, SIMD
//! traversals ([`lanes`]) on trees of their own: single rays, whose tests propose triangles that the kernel's own test accepts or
//! rejects, and packets of 64 (`Grouping`), which repeat the kernel's arithmetic with rays side by side and become
//! streams where they fall apart. Rays that the caller calls scattered (`Simd::occluded_scattered`) are put in order before.
//!
//! # Conventions
//!
//! - A ray is `origin + t · direction` for `tmin < t < tmax`, exclusive at both ends; `direction` has any length.
//! - Triangles are two-sided. `u` and `v` are the weights of `v1` and `v2`.
//! - Triangles and instances are in leaf order, and hits name them by it. `Bvh::sources` and `Instance::source`
//!   lead back to the caller's order.
//! - Triangles flagged [`Triangle::NON_OPAQUE`] ask an [`AnyHit`] inside the traversal; a struct of slices, passed by
//!   value, works on the GPU too.
//! - Shadow rays to one light may be points of the light's own space ([`LightSpace`]) and walk a tree there
//!   ([`occluded_in_light_space`]): the same answers.
//! - [`transmitted`] follows a shadow ray through everything that it meets and multiplies what each hit lets through
//!   ([`Transmit`]).
//! - Bad rays (NaN, magnitudes of 1e15 and more) hit nothing. Bad triangles are dropped by the builder and counted.
//! - An empty tree is one zeroed [`Node`].
//!
//! # Example
//!
#![cfg_attr(feature = "build", doc = "```")]
#![cfg_attr(not(feature = "build"), doc = "```ignore")]
//! use lt_bvh::{BuildQuality, Bvh, Opaque, Ray, Simd, Tracer, occluded, offset_origin};
//! use lt_math::glam::Vec3;
//!
//! let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
//! let bvh = Bvh::build(&positions, &[[0, 1, 2]], |_| true, BuildQuality::Medium)?;
//! bvh.validate()?;
//!
//! // From a receiver below the triangle toward a sun above it.
//! let origin = offset_origin(Vec3::new(0.2, 0.2, -1.0), Vec3::Z, 1.0);
//! let ray = Ray::new(origin, Vec3::Z);
//! assert!(occluded(bvh.nodes(), bvh.triangles(), ray, Opaque));
//!
//! // The same for a batch, as fast as this processor can.
//! let mut blocked = [false];
//! Simd::new(&bvh).occluded_batch(&[ray], Opaque, &mut blocked);
//! assert_eq!(blocked, [true]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "std")]
extern crate std;

mod any_hit;
mod axes;
#[cfg(feature = "build")]
mod build;
mod fold;
mod grid;
mod instance;
#[cfg(not(target_arch = "spirv"))]
pub mod lanes;
mod light;
mod node;
mod offset;
mod probe;
mod ray;
#[cfg(feature = "build")]
mod simd;
mod single;
mod slab;
#[cfg(feature = "build")]
mod tracer;
mod transmit;
mod traverse;
mod triangle;

pub use any_hit::{AnyHit, Opaque};
pub use axes::{main_axis, permute};
#[cfg(feature = "build")]
pub use build::{BuildError, BuildQuality, Bvh, Dropped, InstancedBvh, Invalid, Placement, triangles_of};
pub use grid::Grid;
pub use instance::{
    Instance, closest_hit_instanced, closest_hit_instanced_probed, occluded_instanced,
    occluded_instanced_probed,
};
#[cfg(not(target_arch = "spirv"))]
pub use lanes::SimdLevel;
pub use light::{
    LEAST_LENGTH, LightNode, LightPoint, LightSpace, NODE_ROWS, occluded_in_light_space,
    occluded_in_light_space_probed,
};
pub use node::Node;
pub use offset::{ORIGIN_ULPS, offset_origin};
pub use probe::{Counts, NoProbe, Probe};
pub use ray::{COORDINATE_LIMIT, FAR, Hit, NONE, Ray};
#[cfg(feature = "build")]
pub use simd::{Grouping, RayOrder, Simd, memory};
pub use single::RayTest;
pub use slab::{LEAST_COMPONENT, TRIANGLE_MARGIN, reciprocal};
#[cfg(feature = "build")]
pub use tracer::{Scalar, Tracer};
pub use transmit::Transmit;
pub use traverse::{MAX_DEPTH, closest_hit, closest_hit_probed, occluded, occluded_probed, transmitted};
pub use triangle::Triangle;
