//! The glTF importer from outside: what it reads, what it refuses, what it survives.
#![allow(clippy::unwrap_used, reason = "a helper that cannot go on fails its test")]

mod builder;
mod fuzz;
mod geometry;
mod malformed;
mod motion;
mod real;
mod surfaces;
