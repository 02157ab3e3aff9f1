//! Cross-crate tests in one binary.

mod batch;
mod cascades;
mod cold;
mod effects;
mod engine;
mod hard;
mod laws;
mod layers;
mod light;
mod light_counts;
mod lights;
mod map_formats;
mod marks;
mod mask;
mod moving_lights;
mod real_scenes;
mod samples;
mod several_lights;
mod translucency;
mod twin;
