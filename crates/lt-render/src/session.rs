//! The frame driver: one scene, one view, one light or several in turn; the passes of a plan in order, on any backend.

use std::time::Instant;

use lt_scene::{Camera, Light, LightKind, Scene};
use lt_shaders::abi::{Sample, ShadeParams};

use crate::{
    Backend, BackendKind, EffectPlan, Frame, FrameJob, FramePlanner, LightFit, PackStats, PackedScene,
    RenderError, Sequence, Setup, ShadedLight, Technique, cpu::CpuBackend, lamp::light_params_of, places_of,
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

/// Radiance of a sun of intensity 1 in the shaded pictures.
const SUN_STRENGTH: f32 = 1.25;
/// Haze at a distance of one scene diagonal.
const HAZE: f32 = 0.22;

/// A prepared scene that techniques are run on.
///
/// A technique with a temporal mask sees every [`Session::render`] as its next frame; the first, and the first after a view
/// that it did not draw, starts without history. [`Session::look`] and [`Session::advance`] change the view between frames.
pub struct Session {
    planner: FramePlanner,
    /// Layer by layer, at least one.
    samples: Vec<Vec<Sample>>,
    info: SceneInfo,
    backend: Box<dyn Backend>,
}

impl Session {
    /// Packs the scene, builds its trees, and runs the camera pass.
    ///
    /// # Errors
    /// A setup that cannot be drawn, a scene whose trees cannot be built, no adapter, or a scene too large for it.
    pub fn new(scene: &Scene, setup: Setup, backend: BackendKind) -> Result<Self, RenderError> {
        setup.check()?;
        let start = Instant::now();
        let packed = PackedScene::with(scene, setup.packing)?;
        let build_ms = start.elapsed().as_secs_f64() * 1e3;
        let stats = *packed.stats();
        let mut planner = FramePlanner::new(&packed, setup)?;
        let backend = make_backend(packed, backend)?;
        planner.set_resolvers(backend.has_all_resolvers());
        let info = SceneInfo { stats, build_ms, camera_ms: None };
        let mut session = Self { planner, samples: Vec::new(), info, backend };
        session.see(&session.plan(&Technique::RAY))?;
        Ok(session)
    }

    /// Runs the camera pass.
    fn see(&mut self, plan: &EffectPlan) -> Result<(), RenderError> {
        self.info.camera_ms = self.backend.camera(self.planner.camera(), plan)?;
        self.samples = self.backend.samples()?;
        let width = self.setup().size_in_samples().x as usize;
        let seen = self.samples.iter().flat_map(|layer| places_of(layer, width)).collect();
        self.planner.see(seen);
        Ok(())
    }

    /// Says what will change between frames, which decides what techniques plan for; forgets all that they kept.
    pub fn play(&mut self, sequence: Sequence) {
        self.planner.play(sequence);
    }

    /// What was last told to [`Session::play`].
    pub fn sequence(&self) -> Sequence {
        self.planner.sequence()
    }

    /// Looks from another camera: the next view. Runs the camera pass.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for a camera that cannot be drawn; [`RenderError::Gpu`] when the device fails.
    pub fn look(&mut self, camera: &Camera) -> Result<(), RenderError> {
        self.planner.look(camera)?;
        let mut plan = self.plan(&Technique::RAY);
        plan.object_motion = self.sequence().objects_move;
        self.see(&plan)
    }

    /// Takes the next pose of the scene, packs it and builds its trees anew, and looks from another camera. `before` is
    /// the pose of the last view, for motion vectors.
    ///
    /// # Errors
    /// As [`Session::look`]; [`RenderError::Build`] where the poses differ in more than positions.
    pub fn advance(&mut self, camera: &Camera, scene: &Scene, before: &Scene) -> Result<(), RenderError> {
        let start = Instant::now();
        let packed = PackedScene::with(scene, self.setup().packing)?.after(scene, before)?;
        self.info.build_ms = start.elapsed().as_secs_f64() * 1e3;
        self.info.stats = *packed.stats();
        self.planner.repose(&packed);
        self.backend.replace_scene(packed)?;
        self.look(camera)
    }

    /// Changes the lights, as many as there are, from the next frame on; histories and maps of those that stay as they are
    /// serve on, and so do histories of those that move slowly ([`crate::LIGHT_JUMP_RAD`]).
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for another number of lights, or for a light that cannot be drawn.
    pub fn relight(&mut self, lights: &[Light]) -> Result<(), RenderError> {
        self.planner.relight(lights)
    }

    /// View and lights.
    pub fn setup(&self) -> &Setup {
        self.planner.setup()
    }

    /// Visible samples, row by row from the top: those of all pixels as one picture ([`Setup::size_in_samples`]). Of several
    /// layers, the first.
    pub fn samples(&self) -> &[Sample] {
        &self.samples[0]
    }

    /// Visible samples of each layer, front to back: what is seen through what translucent surfaces; at least one.
    pub fn layers(&self) -> &[Vec<Sample>] {
        &self.samples
    }

    /// Layer by layer, whether each sample shows anything.
    pub fn valid_samples(&self) -> Vec<Vec<bool>> {
        self.samples.iter().map(|layer| layer.iter().map(Sample::is_valid).collect()).collect()
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

    /// The effects a technique calls for here, under the first light.
    pub fn plan(&self, technique: &Technique) -> EffectPlan {
        self.planner.plan(technique)
    }

    /// Where the first light's one map of this many texels a side looks, if it is a directional one.
    pub fn light_fit(&self, map_size: u32) -> LightFit {
        self.planner.light_fit(map_size)
    }

    /// Runs the passes of the technique's plan for every light and reads the frame back.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails or the map does not fit it.
    pub fn render(&mut self, technique: &Technique) -> Result<Frame, RenderError> {
        let lights: Vec<Light> = self.setup().lights().cloned().collect();
        let mut layers = vec![Vec::new(); self.samples.len()];
        for (number, light) in lights.iter().enumerate() {
            let light = (number as u32, light);
            for (layer, frames) in layers.iter_mut().enumerate() {
                let layer = layer as u32;
                let plan = self.planner.plan_under(technique, light, layer);
                frames.push(self.render_light(technique, plan, light, layer)?);
            }
        }
        let of_lights = |mut frames: Vec<Frame>| match frames.len() {
            1 => frames.remove(0),
            _ => Frame::of_lights(frames),
        };
        let layers = layers.into_iter().map(of_lights).collect();
        Frame::of_layers(layers).ok_or_else(|| RenderError::BadSetup("a view without layers".to_owned()))
    }

    /// Runs a plan that differs from the technique's own, under the first light and on the first layer alone, to show what an effect is
    /// worth.
    /// Effects that the scene needs must stay on.
    ///
    /// # Errors
    /// As [`Session::render`].
    pub fn render_plan(&mut self, technique: &Technique, plan: EffectPlan) -> Result<Frame, RenderError> {
        let light = self.setup().light.clone();
        self.render_light(technique, plan, (0, &light), 0)
    }

    fn render_light(
        &mut self,
        technique: &Technique,
        plan: EffectPlan,
        light: (u32, &Light),
        layer: u32,
    ) -> Result<Frame, RenderError> {
        let (job, slot) = self.planner.next_job(technique, plan, light, layer);
        self.backend.begin(&job)?;
        for kind in job.passes() {
            self.backend.pass(kind, &job)?;
        }
        let frame = self.backend.finish(&job)?;
        // Only a frame that was drawn is a last frame.
        self.planner.keep(technique, (light.0, layer), slot);
        Ok(frame)
    }

    /// The picture with the frame's visibility and tint, pixels row by row, sRGB; the mean over a pixel's samples, all layers together.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    pub fn shade<'a>(&mut self, frame: &'a Frame) -> Result<Vec<[u8; 4]>, RenderError> {
        let bounds = self.planner.bounds();
        let size = bounds.max - bounds.min;
        let haze = if bounds.is_empty() { 0.0 } else { HAZE / size.length().max(f32::MIN_POSITIVE) };
        let strengths = self.strengths();
        let lights = |frame: &'a Frame| -> Vec<ShadedLight<'a>> {
            let shaded = |((of, light), strength): ((&'a Frame, &Light), &f32)| {
                let params = ShadeParams {
                    camera: *self.planner.camera(),
                    light: light_params_of(light, 0, 1),
                    light_color: (light.color * strength).extend(haze),
                };
                ShadedLight { params, visibility: &of.visibility, tint: &of.tint }
            };
            frame.each_light().iter().zip(self.setup().lights()).zip(&strengths).map(shaded).collect()
        };
        let layers: Vec<Vec<ShadedLight<'_>>> = frame.each_layer().iter().map(lights).collect();
        self.backend.shade(&layers)
    }

    /// With what each light is shaded, at distance 1 from a lamp: in proportion to intensities, and so that together they bring a sun's light
    /// to what is seen at the usual distance.
    fn strengths(&self) -> Vec<f32> {
        let lux = |light: &Light| match light.kind {
            LightKind::Directional { .. } => light.intensity,
            LightKind::Point { position, .. } | LightKind::Spot { position, .. } => {
                light.intensity / self.planner.usual_distance(position).powi(2).max(f32::MIN_POSITIVE)
            }
        };
        let all: f32 = self.setup().lights().map(lux).sum();
        let share = |light: &Light| if all > 0.0 { SUN_STRENGTH * (light.intensity / all) } else { 0.0 };
        self.setup().lights().map(share).collect()
    }

    /// What the passes of a technique need in its next frame under the first light, on the first layer. Nothing is kept of it: see
    /// [`FramePlanner`] for callers that record frame after frame themselves.
    pub fn job(&self, technique: &Technique) -> FrameJob {
        self.planner.job(technique)
    }
}

fn make_backend(packed: PackedScene, kind: BackendKind) -> Result<Box<dyn Backend>, RenderError> {
    match kind {
        BackendKind::Cpu => Ok(Box::new(CpuBackend::new(packed))),
        #[cfg(feature = "gpu")]
        BackendKind::Gpu => Ok(Box::new(crate::gpu::GpuBackend::new(packed)?)),
        #[cfg(feature = "gpu")]
        BackendKind::Auto if crate::gpu::has_hardware_adapter() => {
            Ok(Box::new(crate::gpu::GpuBackend::new(packed)?))
        }
        #[cfg(not(feature = "gpu"))]
        BackendKind::Gpu => {
            Err(RenderError::NoAdapter("this program was built without the feature `gpu`".to_owned()))
        }
        BackendKind::Auto => Ok(Box::new(CpuBackend::new(packed))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_scene::Source;

    /// A level that is drawn anew sees other parts of thin things, and decides otherwise; what rays found must survive it.
    #[test]
    fn a_still_view_stays_right_while_levels_are_drawn_anew() {
        for place in ["street:7", "square:8", "forest:20"] {
            let scene = Source::open(place, 1).and_then(|s| s.pose(0.0)).expect("a place");
            let setup = Setup { map_size: 256, ..Setup::for_scene(&scene, 240, 136) };
            let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
            session.play(Sequence { is_played: true, ..Sequence::default() });
            let truth = session.render(&Technique::RAY).expect("frame");
            // With what rays found kept, and without: then expanded rays alone must do.
            for id in ["lt-evsm", "lt-evsm:no-rr"] {
                let technique: Technique = id.parse().expect("an id");
                for i in 0..10usize {
                    let frame = match i % 3 {
                        2 => render_shifted(&mut session, &technique, i / 3),
                        _ => session.render(&technique).expect("frame"),
                    };
                    let pixels = truth.visibility.iter().zip(&frame.visibility);
                    assert_eq!(pixels.filter(|(t, v)| t != v).count(), 0, "{place} {id} frame {i}");
                    let drawn = [3, 0, 1, 0, 0, 1, 0, 0, 1, 0][i];
                    assert_eq!(frame.map_draws, drawn, "{place} {id} frame {i}");
                }
            }
        }
    }

    /// The next frame, in which one level is fitted half a texel off where it was.
    fn render_shifted(session: &mut Session, technique: &Technique, level: usize) -> Frame {
        let (mut job, mut slot) =
            session.planner.next_job(technique, session.plan(technique), (0, &session.setup().light), 0);
        let shift = |projection: &mut lt_math::LightProjection| {
            projection.row_x.w += 0.5 / 256.0;
            projection.row_y.w -= 0.5 / 256.0;
        };
        let map = job.map.as_mut().expect("maps");
        shift(&mut map.levels[level].projection);
        map.draws = vec![level as u32];
        shift(&mut slot.last.as_mut().expect("a last frame").levels.0[level].projection);
        // As for any level that is drawn anew.
        let (mask, of) = (job.mask.as_mut().expect("a mask"), technique.mask.expect("a mask"));
        let has_holes = session.info().stats.masked_triangles > 0;
        mask.expansion = of.rules_for(has_holes, true, true).0.to_index();
        session.backend.begin(&job).expect("frame");
        for kind in job.passes() {
            session.backend.pass(kind, &job).expect("pass");
        }
        session.planner.keep(technique, (0, 0), slot);
        session.backend.finish(&job).expect("frame")
    }
}
