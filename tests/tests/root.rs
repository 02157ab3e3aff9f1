//! Cross-crate tests in one binary.

mod batch;
mod effects;
mod hard;
mod laws;
mod light;
mod mask;
mod real_scenes;
mod translucency;
mod twin;
