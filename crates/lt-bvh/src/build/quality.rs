//! How much time a build may take for how fast a tree.

use obvhs::BvhBuildParams;

/// Build time against tracing speed; the hits are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BuildQuality {
    /// All triangles joined from below by obvhs, without the cut by surface area from the top down that the others begin with: rays visit a
    /// third to a half more nodes. That saves little since cuts are fast: 705 ms in place of 720 for a million small triangles on two
    /// threads (docs/results/rays.md). Where geometry changes every frame, [`Bvh::refit`](crate::Bvh::refit) takes half of either.
    Fast,
    /// For most uses.
    #[default]
    Medium,
    /// For static scenes traced many times.
    Slow,
}

impl BuildQuality {
    /// Every preset, the least thorough first.
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
