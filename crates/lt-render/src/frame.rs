//! What one frame runs and what comes out of it.

use lt_mask::MaskBits;
use lt_math::glam::Vec3;

/// Kinds of pass, in the order a frame runs them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PassKind {
    /// Primary rays to visible samples; once per view, shared by all techniques.
    Camera,
    /// The tree that rays walk, built or refitted once more ([`Upkeep`](crate::Upkeep)).
    Build,
    /// Casters rasterised from the light.
    DepthMap,
    /// Depths to vectors, blurred along rows.
    FilterX,
    /// Vectors blurred along columns.
    FilterY,
    /// Estimate and doubt.
    Evaluate,
    /// Last frame's rays correct the doubt.
    Mask,
    /// The tree over casters in the light's own space, where it is not kept.
    LightTree,
    /// Truth for the doubted pixels.
    Resolve,
    /// What translucent casters let through to the lit ones.
    Tint,
}

impl PassKind {
    /// Name in reports and GPU labels.
    pub fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Build => "build",
            Self::DepthMap => "depth map",
            Self::FilterX => "filter x",
            Self::FilterY => "filter y",
            Self::Evaluate => "evaluate",
            Self::Mask => "mask",
            Self::LightTree => "light tree",
            Self::Resolve => "resolve",
            Self::Tint => "tint",
        }
    }

    /// Whether it belongs to making the map rather than to shadowing pixels.
    pub fn makes_map(self) -> bool {
        matches!(self, Self::DepthMap | Self::FilterX | Self::FilterY)
    }
}

/// One pass that ran.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// What it was.
    pub kind: PassKind,
    /// Its time, or `None` where the device has no timestamps.
    pub ms: Option<f64>,
}

/// The shadows of one frame, read back.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Per pixel, row by row from the top: 1 lit, 0 blocked, between for unresolved soft estimates. 0 where nothing
    /// is visible or the surface faces away from the light.
    pub visibility: Vec<f32>,
    /// Per pixel, the share of the light that translucent casters let through, linear RGB in [0, 1]; white where nothing
    /// could tint it. Empty where translucency is not traced or nothing is translucent. What reaches a pixel is visibility
    /// times tint.
    pub tint: Vec<Vec3>,
    /// Per pixel: whether the estimate was doubted (and so resolved).
    pub doubt: Vec<bool>,
    /// Shadow rays traced, those of the tint pass included.
    pub rays: u64,
    /// Passes in order, with times.
    pub passes: Vec<Pass>,
    /// Bytes of map storage the technique needed.
    pub map_bytes: u64,
    /// Per pixel, what the temporal mask remembers of this frame; empty without one.
    pub mask: Vec<MaskBits>,
    /// Maps drawn for this frame: 0 where a kept one served.
    pub map_draws: u32,
}
