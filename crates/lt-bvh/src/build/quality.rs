//! How much time a build may take for how fast a tree.

use obvhs::BvhBuildParams;

/// Build time against tracing speed; the hits are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BuildQuality {
    /// For geometry that changes every frame.
    Fast,
    /// For most uses.
    #[default]
    Medium,
    /// For static scenes traced many times.
    Slow,
}

impl BuildQuality {
    /// Every preset, fastest build first.
    pub const ALL: [BuildQuality; 3] = [BuildQuality::Fast, BuildQuality::Medium, BuildQuality::Slow];

    /// How obvhs joins neighbours.
    pub(crate) fn parameters(self) -> BvhBuildParams {
        match self {
            BuildQuality::Fast => BvhBuildParams::very_fast_build(),
            BuildQuality::Medium => {
                BvhBuildParams { reinsertion_batch_ratio: 0.0, ..BvhBuildParams::medium_build() }
            }
            BuildQuality::Slow => BvhBuildParams::very_slow_build(),
        }
    }

    /// Most primitives that are joined to a tree; more are cut first.
    pub(crate) fn most_joined(self) -> usize {
        match self {
            BuildQuality::Fast => usize::MAX,
            BuildQuality::Medium | BuildQuality::Slow => 64,
        }
    }
}
