//! Procedural places.
use crate::{Scene, SceneError};
/// A procedural place with its size and seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Builtin {
    seed: u64,
}
impl Builtin {
    /// Parses `name` or `name:size`.
    ///
    /// # Errors
    /// Unknown name or size out of range.
    pub fn parse(_text: &str) -> Result<Self, SceneError> { Ok(Self { seed: 1 }) }
    /// The same place grown from another seed.
    pub fn with_seed(self, seed: u64) -> Self { Self { seed } }
    /// The place at `time_s` seconds.
    pub fn pose(&self, _time_s: f32) -> Scene { Scene::default() }
}
