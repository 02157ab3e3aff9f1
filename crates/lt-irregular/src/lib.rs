#![no_std]
//! Shadow queries in the light's own space: points against triangles, with the ray tracer's answers bit for bit.
//!
//! # The idea
//!
//! All shadow rays of a sun are parallel, and all rays to a lamp meet in it. In the light's own space ([`View`]) such a ray is a **point**,
//! "is it blocked?" is "does a triangle contain the point in 2D and lie beyond it?", bounds are rectangles with a nearness, and nothing
//! divides. Structures over triangles, over points or over both then answer the same question.
//!
//! # One arithmetic
//!
//! A ray's answer in this project is a function of ray and triangle alone: that of the ray tracer's watertight test, f32 rounding
//! included. Here the question is first put to planes in light space (`planes.rs`), which say *surely inside and beyond*, *surely not*, or
//! *unsure*: within a proven bound on all rounding of both computations. What is unsure is put to the ray tracer's own test
//! (`lt_bvh::RayTest`, or `lt_bvh::lanes::watertight` for several rays side by side), with the very ray that it would shoot. So every structure on every instruction set gives the ray tracer's bits **by
//! construction**, alpha-tested casters included: those always ask it, for the barycentric weights.
//!
//! # Structures
//!
//! - [`LightBvh`]: a tree over the triangles, for a light and casters that stand still. [`PackedLightBvh`] is the same for the kernel that
//!   CPU and GPU share (`lt_bvh::occluded_in_light_space`).
//! - [`DivideAndConquer`]: both lists divided together and nothing kept, for frames in which everything moves.
//! - [`SampleMap`]: a tree over the points, which every triangle walks: the alias-free shadow map of Aila and Laine (2004).
//!
//! # Conventions
//!
//! Lights are homogeneous (w = 0: a sun, `xyz` towards it; w = 1: a position). Rays are those of `lt_bvh::Ray::to_light`. Triangles are
//! the ray tracer's ([`Casters`]) and are named by their place there, which is how an `AnyHit` knows them.

extern crate alloc;
// Tests share their cases with those in tests/, which know the crate by its name.
#[cfg(test)]
extern crate self as lt_irregular;
#[cfg(feature = "std")]
extern crate std;

mod block;
mod casters;
mod dac;
mod exact;
mod hexagon;
mod light_bvh;
mod packed;
mod planes;
mod rect;
mod sample_map;
mod split;
mod tile;
mod tree;
mod validate;
mod view;
mod walk;

pub use casters::Casters;
pub use dac::{DivideAndConquer, Workspace};
pub use light_bvh::{LightBvh, Scratch, Walk};
pub use lt_bvh::LightPoint;
pub use lt_bvh::SimdLevel;
pub use packed::{PackedLightBvh, Unpackable};
pub use rect::Rect;
pub use sample_map::{Counters, Options, PointOrder, SampleMap};
pub use validate::Invalid;
pub use view::{Bounds, View};
