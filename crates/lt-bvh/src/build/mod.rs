//! Construction: triangles and placements to the buffers of the shared kernel.

mod binary;
mod blas;
mod bounds;
mod collapse;
mod cut;
mod emit;
mod error;
mod quality;
mod quantize;
mod refit;
mod tlas;
mod validate;
mod wide;

pub(crate) use binary::{BinaryTree, split};
pub(crate) use blas::triangle_bounds;
pub use blas::{Bvh, Dropped, triangles_of};
pub(crate) use bounds::Bounds;
pub(crate) use collapse::{LeafCost, WIDTH, WideChild};
pub(crate) use emit::{Emitted, Encoder, Held};
pub use error::BuildError;
pub use quality::BuildQuality;
pub(crate) use tlas::instance_bounds;
pub use tlas::{InstancedBvh, Placement};
pub use validate::Invalid;
pub(crate) use wide::wide_tree;
