//! Shared by the tests and by the example `centred_variance`.

pub mod measure;
pub mod random;
