//! Laws, f64 references and the hard cases of the numerics page, for every kind of shadow map.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod hard_cases;
mod laws;
mod reference;
mod support;
mod tables;
