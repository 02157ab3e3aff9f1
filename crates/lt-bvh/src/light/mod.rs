//! A light's own space, where shadow rays are points: how rays are mapped there, and a tree that points walk.
//!
//! `lt-irregular` builds such trees and proves what their boxes must hold; here is what every pixel does with them, on the CPU and on
//! the GPU.

mod node;
mod space;
mod walk;

pub use node::{LightNode, NODE_ROWS};
pub use space::{LEAST_LENGTH, LightPoint, LightSpace};
pub use walk::{occluded_in_light_space, occluded_in_light_space_probed};
