#![no_std]
//! lt-bvh

#[cfg(feature = "std")]
extern crate std;

mod any_hit;
#[cfg(feature = "build")]
mod build;
mod instance;
mod node;
mod offset;
mod probe;
mod ray;
#[cfg(feature = "build")]
mod simd;
mod slab;
#[cfg(feature = "build")]
mod tracer;
mod traverse;
mod triangle;

pub use any_hit::{AnyHit, Opaque};
#[cfg(feature = "build")]
pub use build::{BuildError, BuildQuality, Bvh, Dropped, InstancedBvh, Invalid, Placement};
pub use instance::{
    Instance, closest_hit_instanced, closest_hit_instanced_probed, occluded_instanced,
    occluded_instanced_probed,
};
pub use node::Node;
pub use offset::{ORIGIN_ULPS, offset_origin};
pub use probe::{Counts, NoProbe, Probe};
pub use ray::{COORDINATE_LIMIT, FAR, Hit, NONE, Ray};
#[cfg(feature = "build")]
pub use simd::{Simd, SimdLevel};
#[cfg(feature = "build")]
pub use tracer::{Scalar, Tracer};
pub use traverse::{MAX_DEPTH, closest_hit, closest_hit_probed, occluded, occluded_probed};
pub use triangle::Triangle;
