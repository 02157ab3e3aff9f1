//! The frame driver: one scene, one view, one light; the passes of a plan in order, on any backend.

use std::time::Instant;

use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_scene::{LightKind, Scene};
use lt_shaders::abi::{CameraParams, DepthParams, FilterParams, Sample, ShadeParams, ShadowParams};

use crate::backend::{DepthMapJob, test_params};
use crate::{
    Backend, BackendKind, EffectPlan, Frame, FrameJob, LightFit, PackStats, PackedScene, RenderError, Setup,
    Technique, cpu::CpuBackend, fit_directional,
};

/// What preparing the scene took.
#[derive(Clone, Copy, Debug, Default)]
pub struct SceneInfo {
    /// Sizes of the packed scene.
    pub stats: PackStats,
    /// Packing and building all trees.
    pub build_ms: f64,
    /// The camera pass, or `None` without timestamps.
    pub camera_ms: Option<f64>,
}

/// Standard deviation of the pre-filter's Gaussian, texels.
const FILTER_SIGMA: f32 = 1.0;
/// Radiance of a sun of intensity 1 in the shaded pictures.
const SUN_STRENGTH: f32 = 1.25;
/// Haze at a distance of one scene diagonal.
const HAZE: f32 = 0.22;

/// A prepared scene that techniques are run on.
pub struct Session {
    scene: PackedSummary,
    setup: Setup,
    camera: CameraParams,
    samples: Vec<Sample>,
    info: SceneInfo,
    backend: Box<dyn Backend>,
}

/// What planning and fitting need of a scene once the backend owns its buffers.
struct PackedSummary {
    bounds: lt_scene::Bounds,
    stats: PackStats,
    root: u32,
}

impl Session {
    /// Packs the scene, builds its trees, and runs the camera pass.
    ///
    /// # Errors
    /// A setup that cannot be drawn, a scene whose trees cannot be built, no adapter, or a scene too large for it.
    pub fn new(scene: &Scene, setup: Setup, backend: BackendKind) -> Result<Self, RenderError> {
        setup.check()?;
        let start = Instant::now();
        let packed = PackedScene::new(scene)?;
        let build_ms = start.elapsed().as_secs_f64() * 1e3;
        let summary = PackedSummary { bounds: packed.bounds(), stats: *packed.stats(), root: packed.root() };
        let camera = camera_params(&setup, packed.root());
        let mut backend = make_backend(packed, backend)?;
        let plan = EffectPlan::for_scene(&summary.stats, &Technique::RAY, setup.map_size);
        let camera_ms = backend.camera(&camera, &plan)?;
        let samples = backend.samples()?;
        let info = SceneInfo { stats: summary.stats, build_ms, camera_ms };
        Ok(Self { scene: summary, setup, camera, samples, info, backend })
    }

    /// View and light.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Visible samples, row by row from the top.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// What preparing took.
    pub fn info(&self) -> &SceneInfo {
        &self.info
    }

    /// `cpu` or `gpu`.
    pub fn backend_name(&self) -> &'static str {
        self.backend.name()
    }

    /// Processor or adapter.
    pub fn device_name(&self) -> String {
        self.backend.device()
    }

    /// The effects a technique calls for here.
    pub fn plan(&self, technique: &Technique) -> EffectPlan {
        EffectPlan::for_scene(&self.scene.stats, technique, self.setup.map_size)
    }

    /// Where the light's map of this many texels a side looks.
    pub fn light_fit(&self, map_size: u32) -> LightFit {
        fit_directional(self.scene.bounds, &self.camera, sun_direction(&self.setup), map_size)
    }

    /// Runs the passes of the technique's plan and reads the frame back.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails or the map does not fit it.
    pub fn render(&mut self, technique: &Technique) -> Result<Frame, RenderError> {
        self.render_plan(technique, self.plan(technique))
    }

    /// Runs a plan that differs from the technique's own, to show what an effect is worth. Effects that the scene
    /// needs must stay on.
    ///
    /// # Errors
    /// As [`Session::render`].
    pub fn render_plan(&mut self, technique: &Technique, plan: EffectPlan) -> Result<Frame, RenderError> {
        let job = self.job_of(technique, plan);
        self.backend.begin(&job)?;
        for kind in job.plan.passes() {
            self.backend.pass(kind, &job)?;
        }
        self.backend.finish(&job)
    }

    /// The picture with this visibility, row by row, sRGB.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    pub fn shade(&mut self, visibility: &[f32]) -> Result<Vec<[u8; 4]>, RenderError> {
        let light = &self.setup.light;
        let size = self.scene.bounds.max - self.scene.bounds.min;
        let haze =
            if self.scene.bounds.is_empty() { 0.0 } else { HAZE / size.length().max(f32::MIN_POSITIVE) };
        let params = ShadeParams {
            camera: self.camera,
            light: homogeneous_light(&self.setup),
            light_color: (light.color * SUN_STRENGTH).extend(haze),
        };
        self.backend.shade(visibility, &params)
    }

    /// What the passes of a technique need, for callers that record them themselves.
    pub fn job(&self, technique: &Technique) -> FrameJob {
        self.job_of(technique, self.plan(technique))
    }

    fn job_of(&self, technique: &Technique, plan: EffectPlan) -> FrameJob {
        let map_size = technique.map_size.unwrap_or(self.setup.map_size);
        let fit = self.light_fit(map_size);
        let test = technique.map_test().map_or(Vec4::ZERO, |(test, _)| test_params(test));
        let shadow = ShadowParams {
            projection: fit.projection,
            light: homogeneous_light(&self.setup),
            test,
            size: self.setup.size,
            map_size,
            epsilon: technique.epsilon,
            root: self.scene.root,
            pad0: 0,
            pad1: 0,
            pad2: 0,
        };
        let map = technique.map_test().map(|_| DepthMapJob {
            depth: DepthParams { projection: fit.projection, map_size, pad0: 0, pad1: 0, pad2: 0 },
            filter: FilterParams { test, map_size, sigma: FILTER_SIGMA, pad: UVec2::ZERO },
        });
        FrameJob { plan, shadow, map }
    }
}

fn make_backend(packed: PackedScene, kind: BackendKind) -> Result<Box<dyn Backend>, RenderError> {
    match kind {
        BackendKind::Cpu => Ok(Box::new(CpuBackend::new(packed))),
        #[cfg(feature = "gpu")]
        BackendKind::Gpu => Ok(Box::new(crate::gpu::GpuBackend::new(&packed)?)),
        #[cfg(feature = "gpu")]
        BackendKind::Auto if crate::gpu::has_hardware_adapter() => {
            Ok(Box::new(crate::gpu::GpuBackend::new(&packed)?))
        }
        #[cfg(not(feature = "gpu"))]
        BackendKind::Gpu => {
            Err(RenderError::NoAdapter("this program was built without the feature `gpu`".to_owned()))
        }
        BackendKind::Auto => Ok(Box::new(CpuBackend::new(packed))),
    }
}

fn sun_direction(setup: &Setup) -> Vec3 {
    match setup.light.kind {
        LightKind::Directional { direction } | LightKind::Spot { direction, .. } => direction.normalize(),
        LightKind::Point { .. } => Vec3::NEG_Y,
    }
}

fn homogeneous_light(setup: &Setup) -> Vec4 {
    match setup.light.kind {
        LightKind::Directional { direction } => (-direction.normalize()).extend(0.0),
        LightKind::Point { position, .. } | LightKind::Spot { position, .. } => position.extend(1.0),
    }
}

/// The camera's frame; any direction works, straight up and down too.
fn camera_params(setup: &Setup, root: u32) -> CameraParams {
    let c = &setup.camera;
    let forward = (c.target - c.eye).normalize();
    let right = forward.cross(c.up).try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
    let up = right.cross(forward);
    let half_height = (c.fov_y_rad * 0.5).tan();
    let half_width = half_height * setup.size.x as f32 / setup.size.y as f32;
    CameraParams {
        eye: c.eye,
        root,
        right: right * half_width,
        pad0: 0,
        up: up * half_height,
        pad1: 0,
        forward,
        pad2: 0,
        size: setup.size,
        pad3: UVec2::ZERO,
    }
}
