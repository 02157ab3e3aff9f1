//! Cross-crate tests in one binary.

mod batch;
mod cascades;
mod effects;
mod hard;
mod laws;
mod light;
mod lights;
mod mask;
mod real_scenes;
mod translucency;
mod twin;
