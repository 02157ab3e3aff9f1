#![no_std]
//! Shadow queries in the light's own space: points against triangles, with the ray tracer's answers bit for bit.

extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod block;
mod casters;
mod lanes;
mod level;
mod light_bvh;
mod planes;
mod rect;
mod split;
mod tree;
mod view;
mod walk;

pub use casters::Casters;
pub use level::Instructions;
pub use light_bvh::{LightBvh, Scratch};
pub use rect::Rect;
pub use view::{Bounds, LightPoint, View};
