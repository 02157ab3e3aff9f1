//! The seam between the frame driver and what runs its passes.

use std::{fmt, str::FromStr};

use lt_math::LightProjection;
use lt_math::glam::{Vec3, Vec4};
use lt_shaders::abi::{
    CameraParams, DepthParams, FilterParams, MaskParams, Sample, ShadeParams, ShadowParams,
};

use crate::{EffectPlan, Frame, MapTest, PackedScene, PassKind, RenderError};

/// Which backend to use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BackendKind {
    /// The kernels on rayon, rays by SIMD.
    #[default]
    Cpu,
    /// The kernels through wgpu.
    Gpu,
    /// The GPU if there is a real one, else the CPU. A software driver is never picked.
    Auto,
}

impl FromStr for BackendKind {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "cpu" => Ok(Self::Cpu),
            "gpu" => Ok(Self::Gpu),
            "auto" => Ok(Self::Auto),
            _ => Err(format!("backend `{text}`: must be cpu, gpu or auto")),
        }
    }
}

impl fmt::Display for BackendKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cpu => "cpu",
            Self::Gpu => "gpu",
            Self::Auto => "auto",
        })
    }
}

/// What the depth map and filter passes draw.
#[derive(Clone, Debug)]
pub struct DepthMapJob {
    /// The raster pass of every level, finest first; at least one, all of one size.
    pub levels: Vec<DepthParams>,
    /// Levels that are drawn in this frame, ascending; the others' maps, in the slot, are still good.
    pub draws: Vec<u32>,
    /// Of the others, those in which casters may have moved: what stands still is in the slot's map already, by the same
    /// projection, and what moves must be drawn anew.
    pub refreshes: Vec<u32>,
    /// Of every level, the part on which casters that move are drawn ([`lt_shaders::marks::is_stirred`]); empty without marks.
    pub moving: Vec<Vec4>,
    /// Whether what stands still is to be remembered apart, for refreshes in later frames.
    pub keeps_still: bool,
    /// The blur passes.
    pub filter: FilterParams,
}

impl DepthMapJob {
    /// Texels along a map's side.
    pub fn map_size(&self) -> u32 {
        self.filter.map_size
    }

    /// Levels whose maps change in this frame, in no order.
    pub fn drawn(&self) -> impl Iterator<Item = u32> {
        self.draws.iter().chain(&self.refreshes).copied()
    }

    /// Where a level's texels lie in a buffer of all levels.
    pub fn texels(&self, level: u32) -> std::ops::Range<usize> {
        let (first, size) = (level as usize, (self.map_size() as usize).pow(2));
        first * size..(first + 1) * size
    }

    /// World to map, for every level.
    pub fn projections(&self) -> Vec<LightProjection> {
        self.levels.iter().map(|level| level.projection).collect()
    }
}

/// Everything the passes of one frame need.
#[derive(Clone, Debug)]
pub struct FrameJob {
    /// Variants: which effects are on.
    pub plan: EffectPlan,
    /// Light, map and test.
    pub shadow: ShadowParams,
    /// The map, if the plan draws one.
    pub map: Option<DepthMapJob>,
    /// The temporal mask's frame, if the plan has one.
    pub mask: Option<MaskParams>,
    /// Which storage keeps map and history between frames: 0 for techniques that keep nothing, else the technique's own for
    /// this light.
    pub slot: usize,
    /// The slot of the technique's first light. A backend that packs the histories of all lights into one keeps it there, and
    /// turns it over when the first light ([`lt_shaders::abi::LightParams::number`] 0) begins a frame.
    pub history_slot: usize,
    /// Which layer of what the camera sees the passes run on, from the front.
    pub layer: u32,
}

impl FrameJob {
    /// The passes of this frame, in order: the plan's, less those that would draw a map anew that still serves, or build once more what the
    /// first of several lights has built for all of them.
    pub fn passes(&self) -> Vec<PassKind> {
        let draws = self.map.as_ref().is_some_and(|m| m.drawn().next().is_some());
        let builds = self.shadow.light.number == 0;
        let runs = |kind: &PassKind| match kind {
            PassKind::Build => builds,
            kind => draws || !kind.makes_map(),
        };
        self.plan.passes().into_iter().filter(runs).collect()
    }

    /// The levels that pixels search, where the plan has them search.
    pub fn searched_levels(&self) -> Option<Vec<LightProjection>> {
        self.map.as_ref().filter(|_| self.plan.level_search).map(DepthMapJob::projections)
    }

    /// Whether the history that this frame reads must be cleared before.
    pub fn clears_history(&self) -> bool {
        self.mask.is_some_and(|m| m.flags & MaskParams::CLEARED != 0)
    }

    /// How many maps are drawn whole in this frame.
    pub fn map_draws(&self) -> u32 {
        self.map.as_ref().map_or(0, |m| m.draws.len() as u32)
    }
}

/// Runs passes. The order of passes is the driver's alone.
pub trait Backend {
    /// `cpu` or `gpu`.
    fn name(&self) -> &'static str;

    /// The processor or adapter, for reports.
    fn device(&self) -> String;

    /// Whether it has every [`crate::Resolve`]; else rays and the light BVH alone.
    fn has_all_resolvers(&self) -> bool;

    /// Takes another pose of the scene in place of the last one; maps and histories stay.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when it does not fit the device.
    fn replace_scene(&mut self, scene: PackedScene) -> Result<(), RenderError>;

    /// Runs the camera pass and keeps the samples. Returns its time, or `None` without timestamps.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    fn camera(&mut self, params: &CameraParams, plan: &EffectPlan) -> Result<Option<f64>, RenderError>;

    /// The samples of the last camera pass, layer by layer from the front, row by row from the top.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    fn samples(&mut self) -> Result<Vec<Vec<Sample>>, RenderError>;

    /// Starts a frame.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the map does not fit the device.
    fn begin(&mut self, job: &FrameJob) -> Result<(), RenderError>;

    /// Runs one pass of the frame.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    fn pass(&mut self, kind: PassKind, job: &FrameJob) -> Result<(), RenderError>;

    /// Ends the frame and reads it back.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    fn finish(&mut self, job: &FrameJob) -> Result<Frame, RenderError>;

    /// Shades the samples of all layers, each under its lights, at least one, and gives the pixels' means, sRGB.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    fn shade(&mut self, layers: &[Vec<ShadedLight<'_>>]) -> Result<Vec<[u8; 4]>, RenderError>;
}

/// A light and how much of it reaches each pixel.
#[derive(Clone, Copy, Debug)]
pub struct ShadedLight<'a> {
    /// Camera and haze, the same for all lights of a picture, and the light.
    pub params: ShadeParams,
    /// Sample by sample, row by row.
    pub visibility: &'a [f32],
    /// Likewise; empty for white.
    pub tint: &'a [Vec3],
}

/// A test's default parameters in the order its kernel reads them (`lt_shaders::evaluate::TestFromParams`).
pub(crate) fn test_params(test: MapTest) -> Vec4 {
    use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, Sm, Vsm};
    match test {
        MapTest::Sm => Vec4::new(Sm::default().bias, 0.0, 0.0, 0.0),
        MapTest::Pcf => Vec4::new(Pcf::default().bias, 0.0, 0.0, 0.0),
        MapTest::Vsm => Vec4::new(Vsm::default().min_variance, 0.0, 0.0, 0.0),
        MapTest::Esm => Vec4::new(Esm::default().exponent, 0.0, 0.0, 0.0),
        MapTest::Evsm => {
            let e = Evsm::default();
            Vec4::new(e.positive_exponent, e.negative_exponent, e.min_variance, 0.0)
        }
        MapTest::Msm => Vec4::new(MsmHamburger::default().moment_bias, 0.0, 0.0, 0.0),
        MapTest::MsmHausdorff => Vec4::new(MsmHausdorff::default().moment_bias, 0.0, 0.0, 0.0),
    }
}
