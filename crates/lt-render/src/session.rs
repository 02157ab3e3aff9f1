//! The frame driver: one scene, one view, one light or several in turn; the passes of a plan in order, on any backend.

use std::{collections::HashMap, time::Instant};

use lt_mask::{DEPTH_CONSISTENCY_TOLERANCE, Offsets};
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_scene::{Bounds, Camera, Light, LightKind, Scene};
use lt_shaders::abi::{
    CameraParams, DepthParams, FilterParams, LightParams, MaskParams, Sample, ShadeParams, ShadowParams,
};

use crate::backend::{DepthMapJob, test_params};
use crate::{
    Backend, BackendKind, EffectPlan, Frame, FrameJob, LightFit, PackStats, PackedScene, Removal,
    RenderError, Resolve, Sequence, Setup, ShadedLight, Technique, Upkeep,
    cpu::CpuBackend,
    fit_directional,
    lamp::{LightChange, is_jump, lamp_levels, light_params_of},
    levels::{Levels, View, fit_levels, keep_levels},
    light_fit::fit_kept,
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
/// Samples looked at for a median distance.
const DISTANCE_SAMPLES: usize = 20_000;
/// Haze at a distance of one scene diagonal.
const HAZE: f32 = 0.22;

/// A prepared scene that techniques are run on.
///
/// A technique with a temporal mask sees every [`Session::render`] as its next frame; the first, and the first after a view
/// that it did not draw, starts without history. [`Session::look`] and [`Session::advance`] change the view between frames.
pub struct Session {
    scene: PackedSummary,
    setup: Setup,
    camera: CameraParams,
    /// Counts views: a history or map of the view before this one can be followed.
    view: u64,
    /// Counts poses: what casters stood still since.
    pose: u64,
    sequence: Sequence,
    /// What techniques that keep something kept, by id, light and layer.
    slots: HashMap<(String, u32, u32), Slot>,
    /// Layer by layer, at least one.
    samples: Vec<Vec<Sample>>,
    info: SceneInfo,
    backend: Box<dyn Backend>,
}

/// What planning and fitting need of a scene once the backend owns its buffers.
struct PackedSummary {
    bounds: Bounds,
    /// A box of all casters in every pose since `play`: kept maps are fitted to it.
    reach: Bounds,
    stats: PackStats,
    root: u32,
}

impl PackedSummary {
    fn of(packed: &PackedScene, reach: Bounds) -> Self {
        Self { bounds: packed.bounds(), reach, stats: *packed.stats(), root: packed.root() }
    }
}

/// What one technique keeps between frames for one light; the backend holds its buffers.
#[derive(Clone, Debug)]
struct Slot {
    /// Storage in the backend; 0 belongs to all techniques that keep nothing.
    index: usize,
    /// The last frame, if it can still be followed.
    last: Option<LastFrame>,
    /// Frames drawn, to steer patterns.
    frame: u32,
}

/// A slot's last frame.
#[derive(Clone, Debug)]
struct LastFrame {
    view: u64,
    pose: u64,
    camera: CameraParams,
    light: LightKind,
    /// The levels of the light's map and their size; empty without a map.
    levels: (Vec<LightFit>, u32),
    /// A box of all casters that the levels' depths were fitted to.
    casters: Bounds,
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
        let summary = PackedSummary::of(&packed, packed.bounds());
        let camera = camera_params(&setup, packed.root());
        let mut backend = make_backend(packed, backend)?;
        let plan = EffectPlan::for_scene(
            &summary.stats,
            &setup.light.kind,
            &Technique::RAY,
            setup.map_size,
            Sequence::default(),
        );
        let camera_ms = backend.camera(&camera, &plan)?;
        let samples = backend.samples()?;
        let info = SceneInfo { stats: summary.stats, build_ms, camera_ms };
        Ok(Self {
            scene: summary,
            setup,
            camera,
            view: 0,
            pose: 0,
            sequence: Sequence::default(),
            slots: HashMap::new(),
            samples,
            info,
            backend,
        })
    }

    /// Says what will change between frames, which decides what techniques plan for; forgets all that they kept.
    pub fn play(&mut self, sequence: Sequence) {
        self.sequence = sequence;
        self.scene.reach = self.scene.bounds;
        for slot in self.slots.values_mut() {
            *slot = Slot { last: None, frame: 0, ..*slot };
        }
    }

    /// What was last told to [`Session::play`].
    pub fn sequence(&self) -> Sequence {
        self.sequence
    }

    /// Looks from another camera: the next view. Runs the camera pass.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for a camera that cannot be drawn; [`RenderError::Gpu`] when the device fails.
    pub fn look(&mut self, camera: &Camera) -> Result<(), RenderError> {
        let setup = Setup { camera: camera.clone(), ..self.setup.clone() };
        setup.check()?;
        self.camera = camera_params(&setup, self.scene.root);
        self.setup = setup;
        self.view += 1;
        self.sequence.camera_moves = true;
        let mut plan = self.plan(&Technique::RAY);
        plan.object_motion = self.sequence.objects_move;
        self.info.camera_ms = self.backend.camera(&self.camera, &plan)?;
        self.samples = self.backend.samples()?;
        Ok(())
    }

    /// Takes the next pose of the scene, packs it and builds its trees anew, and looks from another camera. `before` is
    /// the pose of the last view, for motion vectors.
    ///
    /// # Errors
    /// As [`Session::look`]; [`RenderError::Build`] where the poses differ in more than positions.
    pub fn advance(&mut self, camera: &Camera, scene: &Scene, before: &Scene) -> Result<(), RenderError> {
        let start = Instant::now();
        let packed = PackedScene::with(scene, self.setup.packing)?.after(scene, before)?;
        self.info.build_ms = start.elapsed().as_secs_f64() * 1e3;
        self.info.stats = *packed.stats();
        self.scene = PackedSummary::of(&packed, reach_of(self.scene.reach, packed.bounds()));
        self.backend.replace_scene(packed)?;
        self.pose += 1;
        self.sequence.objects_move = true;
        self.look(camera)
    }

    /// Changes the lights, as many as there are, from the next frame on; histories and maps of those that stay as they are
    /// serve on, and so do histories of those that move slowly ([`crate::LIGHT_JUMP_RAD`]).
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for another number of lights, or for a light that cannot be drawn.
    pub fn relight(&mut self, lights: &[Light]) -> Result<(), RenderError> {
        let count = self.setup.lights().count();
        let (Some((first, more)), true) = (lights.split_first(), lights.len() == count) else {
            return Err(RenderError::BadSetup(format!("{} lights in place of {count}", lights.len())));
        };
        let setup = Setup { light: first.clone(), more_lights: more.to_vec(), ..self.setup.clone() };
        setup.check()?;
        self.sequence.lights_move |= setup.lights().map(|l| l.kind).ne(self.setup.lights().map(|l| l.kind));
        self.setup = setup;
        Ok(())
    }

    /// View and lights.
    pub fn setup(&self) -> &Setup {
        &self.setup
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
        self.plan_under(technique, (0, &self.setup.light), 0)
    }

    fn plan_under(&self, technique: &Technique, (number, light): (u32, &Light), layer: u32) -> EffectPlan {
        let map_size = self.setup.map_size;
        let technique = &Technique { resolve: self.resolver(technique.resolve), ..*technique };
        let plan = EffectPlan::for_scene(&self.scene.stats, &light.kind, technique, map_size, self.sequence);
        // Rays to all lights walk one tree, and all layers' whatever there is.
        let is_done = layer > 0 || (number > 0 && technique.resolve == Resolve::Ray);
        EffectPlan { upkeep: if is_done { Upkeep::Kept } else { self.setup.upkeep }, ..plan }
    }

    /// The structure in light space, where it is left to us, that this backend has and that what is kept from frame to frame calls for.
    fn resolver(&self, resolve: Resolve) -> Resolve {
        match (resolve, self.setup.upkeep) {
            (Resolve::LightSpace, _) if !self.backend.has_all_resolvers() => Resolve::Light,
            (Resolve::LightSpace, upkeep) if upkeep != Upkeep::Kept => Resolve::DivideAndConquer,
            _ => resolve,
        }
    }

    /// Where the first light's one map of this many texels a side looks, if it is a directional one.
    pub fn light_fit(&self, map_size: u32) -> LightFit {
        fit_directional(self.scene.bounds, &self.camera, sun_direction(&self.setup.light.kind), map_size)
    }

    /// Runs the passes of the technique's plan for every light and reads the frame back.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails or the map does not fit it.
    pub fn render(&mut self, technique: &Technique) -> Result<Frame, RenderError> {
        let lights: Vec<Light> = self.setup.lights().cloned().collect();
        let mut layers = vec![Vec::new(); self.samples.len()];
        for (number, light) in lights.iter().enumerate() {
            let light = (number as u32, light);
            for (layer, frames) in layers.iter_mut().enumerate() {
                let layer = layer as u32;
                let plan = self.plan_under(technique, light, layer);
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
        let light = self.setup.light.clone();
        self.render_light(technique, plan, (0, &light), 0)
    }

    fn render_light(
        &mut self,
        technique: &Technique,
        plan: EffectPlan,
        light: (u32, &Light),
        layer: u32,
    ) -> Result<Frame, RenderError> {
        let (job, slot) = self.next_job(technique, plan, light, layer);
        self.backend.begin(&job)?;
        for kind in job.passes() {
            self.backend.pass(kind, &job)?;
        }
        let frame = self.backend.finish(&job)?;
        // Only a frame that was drawn is a last frame.
        if slot.index > 0 {
            self.slots.insert((technique.to_string(), light.0, layer), slot);
        }
        Ok(frame)
    }

    /// The picture with the frame's visibility and tint, pixels row by row, sRGB; the mean over a pixel's samples, all layers together.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] when the device fails.
    pub fn shade<'a>(&mut self, frame: &'a Frame) -> Result<Vec<[u8; 4]>, RenderError> {
        let size = self.scene.bounds.max - self.scene.bounds.min;
        let haze =
            if self.scene.bounds.is_empty() { 0.0 } else { HAZE / size.length().max(f32::MIN_POSITIVE) };
        let lights = |frame: &'a Frame| -> Vec<ShadedLight<'a>> {
            let count = frame.each_light().len() as f32;
            let shaded = |(of, light): (&'a Frame, &Light)| {
                // Lights share a sun's strength, so that many of them do not blind.
                let strength = SUN_STRENGTH * self.brightness(&light.kind) / count;
                let params = ShadeParams {
                    camera: self.camera,
                    light: light_params_of(light, 0, 1),
                    light_color: (light.color * strength).extend(haze),
                };
                ShadedLight { params, visibility: &of.visibility, tint: &of.tint }
            };
            frame.each_light().iter().zip(self.setup.lights()).map(shaded).collect()
        };
        let layers: Vec<Vec<ShadedLight<'_>>> = frame.each_layer().iter().map(lights).collect();
        self.backend.shade(&layers)
    }

    /// Strength at distance 1 with which a spot or point light brings a sun's light to half of what is seen; 1 for a sun.
    fn brightness(&self, light: &LightKind) -> f32 {
        let (LightKind::Point { position, .. } | LightKind::Spot { position, .. }) = *light else {
            return 1.0;
        };
        self.usual_distance(position).powi(2)
    }

    /// The median distance of what is seen from a point.
    fn usual_distance(&self, from: Vec3) -> f32 {
        let stride = (self.samples().len() / DISTANCE_SAMPLES).max(1);
        let seen = self.samples().iter().step_by(stride).filter(|s| s.is_valid());
        crate::quantile(seen.map(|s| f64::from(s.position.distance(from))).collect(), 0.5) as f32
    }

    /// What the passes of a technique need in its next frame under the first light, on the first layer, for callers that record them
    /// themselves.
    /// They keep slots: the job's map and history are those of the last frame that this session itself drew.
    pub fn job(&self, technique: &Technique) -> FrameJob {
        self.next_job(technique, self.plan(technique), (0, &self.setup.light), 0).0
    }

    /// The next frame of a technique under one light, and what it keeps once that is drawn.
    fn next_job(
        &self,
        technique: &Technique,
        mut plan: EffectPlan,
        (number, light): (u32, &Light),
        layer: u32,
    ) -> (FrameJob, Slot) {
        let mut slot = self.slot(technique, &plan, (number, layer));
        let count = 1 + self.setup.more_lights.len() as u32;
        let for_kernels = light_params_of(light, number, count);
        // Drawn once more, the same view is its own past: nothing has moved since.
        plan.object_motion &= slot.last.as_ref().is_none_or(|l| l.view != self.view);
        let map_size = technique.map_size.unwrap_or(self.setup.map_size);
        let last =
            slot.last.as_ref().filter(|l| plan.reuse && l.levels.1 == map_size && l.light == light.kind);
        // A caster outside the box that the kept maps were drawn of may lie before their near planes.
        let kept = last.filter(|l| encloses(l.casters, self.scene.bounds)).map_or(&[][..], |l| &l.levels.0);
        let casters = if plan.reuse { self.scene.reach } else { self.scene.bounds };
        let mut levels = self.levels((technique, &plan), &light.kind, casters, (map_size, kept));
        // Where maps are not kept, the first layer's are still there.
        if layer > 0 && slot.index == 0 {
            levels.draws.clear();
        }
        let casters = match last {
            Some(last) if levels.draws.is_empty() => last.casters,
            _ => casters,
        };
        let has_moved = last.is_some_and(|l| l.pose != self.pose);
        let can_refresh = |level: &u32| {
            has_moved && !levels.draws.contains(level) && levels.fits[*level as usize].extent_world.x > 0.0
        };
        let refreshes = (0..levels.fits.len() as u32).filter(can_refresh).collect();
        let projection = levels.fits.first().map_or(bytemuck::Zeroable::zeroed(), |fit| fit.projection);
        let test = technique.map_test().map_or(Vec4::ZERO, |(test, _)| test_params(test));
        let shadow = ShadowParams {
            projection,
            light: for_kernels,
            test,
            size: self.setup.size_in_samples(),
            map_size,
            epsilon: technique.epsilon,
            root: self.scene.root,
            level_count: levels.fits.len() as u32,
            pad0: 0,
            pad1: 0,
        };
        let depth_params = |fit: &LightFit| DepthParams {
            projection: fit.projection,
            map_size,
            near: fit.near,
            pad0: 0,
            pad1: 0,
        };
        let map = technique.map_test().map(|_| DepthMapJob {
            levels: levels.fits.iter().map(depth_params).collect(),
            draws: levels.draws,
            refreshes,
            keeps_still: plan.reuse && self.sequence.objects_move,
            filter: FilterParams { test, map_size, sigma: FILTER_SIGMA, pad: UVec2::ZERO },
        });
        let change = slot.last.as_ref().map(|l| LightChange {
            has_moved: l.light != light.kind,
            is_jump: is_jump(&l.light, &light.kind, |from| self.usual_distance(from)),
        });
        let maps = (&levels.fits[..], map_size);
        let mask = technique.mask.map(|m| self.mask_params(&m, &slot, maps, (for_kernels, change)));
        let first =
            self.slots.get(&(technique.to_string(), 0, layer)).map_or(slot.index, |first| first.index);
        let history_slot = if slot.index == 0 { 0 } else { first };
        let job = FrameJob { plan, shadow, map, mask, slot: slot.index, history_slot, layer };
        slot.frame = slot.frame.wrapping_add(1);
        slot.last = Some(LastFrame {
            view: self.view,
            pose: self.pose,
            camera: self.camera,
            light: light.kind,
            levels: (levels.fits, map_size),
            casters,
        });
        (job, slot)
    }

    /// Where the maps of a technique look in its next frame, and which of them must be drawn.
    fn levels(
        &self,
        (technique, plan): (&Technique, &EffectPlan),
        light: &LightKind,
        scene: Bounds,
        (map_size, kept): (u32, &[LightFit]),
    ) -> Levels {
        let (camera, direction) = (&self.camera, sun_direction(light));
        if plan.map.is_none() {
            return Levels { fits: Vec::new(), draws: Vec::new() };
        }
        if plan.perspective {
            return lamp_levels(light, scene, map_size, kept);
        }
        if technique.cascades.count > 1 {
            let view = View { scene, camera, direction, map_size };
            return match plan.reuse {
                true => keep_levels(view, &technique.cascades, kept),
                false => fit_levels(view, &technique.cascades),
            };
        }
        match kept.first().filter(|fit| fit.serves(scene, camera, direction, map_size)) {
            Some(fit) => Levels { fits: vec![*fit], draws: Vec::new() },
            None if plan.reuse => {
                Levels { fits: vec![fit_kept(scene, camera, direction, map_size)], draws: vec![0] }
            }
            None => {
                Levels { fits: vec![fit_directional(scene, camera, direction, map_size)], draws: vec![0] }
            }
        }
    }

    /// What a technique kept, less what this view cannot follow.
    fn slot(&self, technique: &Technique, plan: &EffectPlan, (light, layer): (u32, u32)) -> Slot {
        if plan.mask.is_none() && !plan.reuse {
            return Slot { index: 0, last: None, frame: 0 };
        }
        let mut slot = self.slots.get(&(technique.to_string(), light, layer)).cloned().unwrap_or(Slot {
            index: self.slots.len() + 1,
            last: None,
            frame: 0,
        });
        slot.last = slot.last.filter(|l| self.view - l.view <= 1);
        slot
    }

    fn mask_params(
        &self,
        mask: &crate::TemporalMask,
        slot: &Slot,
        map: (&[LightFit], u32),
        (light, change): (LightParams, Option<LightChange>),
    ) -> MaskParams {
        let last = slot.last.as_ref().filter(|_| change.is_some_and(|c| !c.is_jump));
        let has_light_moved = change.is_some_and(|c| c.has_moved);
        // Only the first frame after `play`: a view that was missed is another matter.
        let is_cold = self.sequence.starts_cold && slot.frame == 0;
        let casters_rest = !has_light_moved && last.is_some_and(|l| l.pose == self.pose);
        let bytes = bytemuck::bytes_of::<CameraParams>;
        let camera_rests = last.is_some_and(|l| bytes(&l.camera) == bytes(&self.camera));
        let is_published = mask.removal == Removal::Published;
        let mut flags = 0;
        for (flag, is_set) in [
            (MaskParams::HAS_HISTORY, last.is_some() || is_cold),
            (MaskParams::CLEARED, is_cold),
            (MaskParams::REMOVES_AS_PUBLISHED, is_published),
            (MaskParams::KEEPS_ANSWERS, mask.removal == Removal::Known && casters_rest && camera_rests),
            (MaskParams::CAMERA_RESTS, camera_rests),
        ] {
            flags |= if is_set { flag } else { 0 };
        }
        let same_map = |l: &LastFrame| (&l.levels.0[..], l.levels.1) == map;
        let drawn_anew = has_light_moved || !last.is_some_and(same_map);
        let has_holes = self.scene.stats.masked_triangles > 0;
        let (expansion, moving_pattern) = mask.rules_for(has_holes, drawn_anew);
        // Under a light or casters that move, shadows move over pixels that do not.
        let still_pattern = if casters_rest || is_published { mask.pattern } else { moving_pattern };
        MaskParams {
            current: self.camera,
            previous: last.map_or(self.camera, |l| l.camera),
            light,
            still: Offsets::of(still_pattern, slot.frame).0,
            moving: Offsets::of(moving_pattern, slot.frame).0,
            frame: slot.frame,
            flags,
            // A cleared history saw no depths: any agrees.
            depth_tolerance: if is_cold { 3.0e38 } else { DEPTH_CONSISTENCY_TOLERANCE },
            refresh: mask.refresh,
            expansion: expansion.to_index(),
            ..bytemuck::Zeroable::zeroed()
        }
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

/// How much larger than its casters a box is made that they have left, so that their next step does not leave it again.
const REACH_GROWTH: f32 = 0.1;

/// A box that holds what `before` holds, and `now`; with some room around if that is more than before.
fn reach_of(before: Bounds, now: Bounds) -> Bounds {
    if now.is_empty() || encloses(before, now) {
        return before;
    }
    let all = before.including(now.min).including(now.max);
    let room = (all.max - all.min) * (REACH_GROWTH * 0.5);
    all.including(now.min - room).including(now.max + room)
}

/// Whether one box lies in another, surfaces included.
fn encloses(outer: Bounds, inner: Bounds) -> bool {
    outer.contains(inner.min) && outer.contains(inner.max)
}

fn sun_direction(light: &LightKind) -> Vec3 {
    match *light {
        LightKind::Directional { direction } | LightKind::Spot { direction, .. } => direction.normalize(),
        LightKind::Point { .. } => Vec3::NEG_Y,
    }
}

/// The camera's frame; any direction works, straight up and down too.
pub(crate) fn camera_params(setup: &Setup, root: u32) -> CameraParams {
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
        layers_behind: 0,
        up: up * half_height,
        pad1: 0,
        forward,
        pad2: 0,
        size: setup.size_in_samples(),
        grid: setup.samples.size(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_scene::Source;

    /// A level that is drawn anew sees other parts of thin things, and decides otherwise; what rays found must survive it.
    #[test]
    fn a_still_view_stays_right_while_levels_are_drawn_anew() {
        for place in ["street:6", "square:8", "forest:20"] {
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
            session.next_job(technique, session.plan(technique), (0, &session.setup.light), 0);
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
        let has_holes = session.scene.stats.masked_triangles > 0;
        mask.expansion = of.rules_for(has_holes, true).0.to_index();
        session.backend.begin(&job).expect("frame");
        for kind in job.passes() {
            session.backend.pass(kind, &job).expect("pass");
        }
        session.slots.insert((technique.to_string(), 0, 0), slot);
        session.backend.finish(&job).expect("frame")
    }
}
