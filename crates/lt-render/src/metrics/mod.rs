//! How wrong a picture is: counts of wrong pixels first, perceptual distance second.

mod clusters;
mod errors;
mod flip;

pub use clusters::largest_cluster;
pub use errors::{Errors, Verdict, errors, errors_by_light, verdict};
pub use flip::flip_mean;
