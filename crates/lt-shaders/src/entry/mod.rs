//! SPIR-V entry points: each guards its bounds, unpacks its bindings, calls a pass and stores the result.
//!
//! A variant exists for every set of effects, so that an effect that is off has neither binding nor branch. Bindings
//! are dense from 0 in group 0. Names end in `_cs`, `_vs` or `_fs` and are unique over all modules.

pub mod camera;
pub mod depth;
pub mod doubt;
pub mod evaluate;
pub mod filter;
pub mod gbuffer;
pub mod layers;
pub mod marks;
pub mod mask;
pub mod neighbours;
pub mod resolve;
pub mod shade;
pub mod tint;

use lt_math::glam::{UVec2, UVec3};

/// Index of a sample (or pixel) in row-major buffers, or `None` outside the picture.
fn pixel_index(id: UVec3, size: UVec2) -> Option<usize> {
    if id.x < size.x && id.y < size.y { Some((id.y * size.x + id.x) as usize) } else { None }
}
