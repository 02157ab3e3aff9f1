#![no_std]
//! lt-math
#[cfg(feature = "std")]
extern crate std;
pub use glam;
