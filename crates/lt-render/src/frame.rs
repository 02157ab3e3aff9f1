//! What one frame runs and what comes out of it.

use lt_mask::{MaskBits, PackedMask};
use lt_math::glam::Vec3;

/// Kinds of pass, in the order a frame runs them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PassKind {
    /// Primary rays to visible samples; once per view, shared by all techniques.
    Camera,
    /// What is traced with, made once more ([`Upkeep`](crate::Upkeep)): the tree that rays walk, or the triangles that points are held against.
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
    /// Truth for the doubted pixels, and what it teaches history and map.
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
///
/// What is said of a pixel here is said of a sample where pixels have several ([`Setup::samples`](crate::Setup::samples)): the
/// picture of all samples, row by row.
///
/// Of several lights, [`Frame::lights`] holds each one's own, and the rest sums them up.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Per pixel, row by row from the top: 1 lit, 0 blocked, between for unresolved soft estimates. 0 where nothing
    /// is visible or the surface faces away from the light. The mean over several lights.
    pub visibility: Vec<f32>,
    /// Per pixel, the share of the light that translucent casters let through, linear RGB in [0, 1]; white where nothing
    /// could tint it. Empty where translucency is not traced or nothing is translucent, and over several lights. What
    /// reaches a pixel is visibility times tint.
    pub tint: Vec<Vec3>,
    /// Per pixel: whether the estimate was doubted (and so resolved), for any of several lights.
    pub doubt: Vec<bool>,
    /// Shadow rays traced, those of the tint pass included.
    pub rays: u64,
    /// Passes in order, with times; each kind once, however many lights it ran for.
    pub passes: Vec<Pass>,
    /// Bytes of map storage the technique needed.
    pub map_bytes: u64,
    /// Per pixel, what the temporal mask remembers of this frame; empty without one. The first of several lights': for all of
    /// them see [`Frame::packed_masks`].
    pub mask: Vec<MaskBits>,
    /// Maps drawn for this frame: 0 where a kept one served.
    pub map_draws: u32,
    /// Each light's shadows, where several shine; empty for one.
    pub lights: Vec<Frame>,
    /// Each layer's shadows, front to back, where the camera sees several; empty for one.
    pub layers: Vec<Frame>,
}

impl Frame {
    /// Sums up the shadows of several lights, at least one, in the same view.
    pub fn of_lights(lights: Vec<Frame>) -> Self {
        let pixels = lights.iter().map(|l| l.visibility.len()).max().unwrap_or(0);
        let share = 1.0 / lights.len().max(1) as f32;
        let mean = |i: usize| lights.iter().map(|l| l.visibility[i]).sum::<f32>() * share;
        Self {
            visibility: (0..pixels).map(mean).collect(),
            tint: Vec::new(),
            doubt: (0..pixels).map(|i| lights.iter().any(|l| l.doubt[i])).collect(),
            rays: lights.iter().map(|l| l.rays).sum(),
            passes: summed_passes(&lights),
            map_bytes: lights.iter().map(|l| l.map_bytes).sum(),
            mask: lights.first().map_or(Vec::new(), |l| l.mask.clone()),
            map_draws: lights.iter().map(|l| l.map_draws).sum(),
            lights,
            layers: Vec::new(),
        }
    }

    /// Sums up the shadows of several layers, front to back, of the same view under the same lights. What is said of samples, and
    /// of several lights, is said of the first layer's. One layer alone is its own sum; none give `None`.
    pub fn of_layers(layers: Vec<Frame>) -> Option<Self> {
        if layers.len() <= 1 {
            return layers.into_iter().next();
        }
        let first = layers[0].clone();
        let lights = first
            .lights
            .iter()
            .enumerate()
            .map(|(i, light)| Frame { rays: layers.iter().map(|l| l.lights[i].rays).sum(), ..light.clone() });
        Some(Self {
            lights: lights.collect(),
            rays: layers.iter().map(|l| l.rays).sum(),
            passes: summed_passes(&layers),
            map_bytes: layers.iter().map(|l| l.map_bytes).sum(),
            map_draws: layers.iter().map(|l| l.map_draws).sum(),
            layers,
            ..first
        })
    }

    /// Each layer's shadows, front to back: its own if there is one layer.
    pub fn each_layer(&self) -> &[Frame] {
        if self.layers.is_empty() { std::slice::from_ref(self) } else { &self.layers }
    }

    /// Each light's shadows, in the first layer: its own if there is one light.
    pub fn each_light(&self) -> &[Frame] {
        if self.lights.is_empty() { std::slice::from_ref(self) } else { &self.lights }
    }

    /// Per pixel, what the temporal mask remembers of every light; empty without a mask.
    pub fn packed_masks(&self) -> Vec<PackedMask> {
        let mut packed = vec![PackedMask::default(); self.mask.len()];
        for (light, frame) in self.each_light().iter().enumerate() {
            for (packed, bits) in packed.iter_mut().zip(&frame.mask) {
                *packed = packed.with_light(light as u32, *bits);
            }
        }
        packed
    }
}

/// The passes of all frames, each kind once, times added up.
fn summed_passes(frames: &[Frame]) -> Vec<Pass> {
    let mut kinds: Vec<PassKind> = frames.iter().flat_map(|f| &f.passes).map(|p| p.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let pass = |kind| {
        let all = frames.iter().flat_map(|f| &f.passes).filter(|p| p.kind == kind);
        Pass { kind, ms: all.map(|p| p.ms).sum() }
    };
    kinds.into_iter().map(pass).collect()
}
