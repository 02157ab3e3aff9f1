//! What the passes of a technique's next frame need: the frames of a view that changes, planned one after the other, whoever runs them.
//!
//! [`crate::Session`] plans so for its backend. An engine plans so for what it records itself (`gpu::Recorder`):
//!
//! ```
//! use lt_render::{FramePlanner, PackedScene, Sequence, Setup, Technique};
//! use lt_scene::Source;
//!
//! let scene = Source::open("cornell", 1).unwrap().pose(0.0).unwrap();
//! let packed = PackedScene::new(&scene).unwrap();
//! let mut planner = FramePlanner::new(&packed, Setup::for_scene(&scene, 64, 64)).unwrap();
//! planner.play(Sequence { is_played: true, camera_moves: true, ..Sequence::default() });
//! let technique: Technique = "lt-evsm".parse().unwrap();
//! let first = &planner.next_frame(&technique)[0];
//! assert!(first.map_draws() > 0);
//! let mut camera = planner.setup().camera.clone();
//! camera.eye.x += 0.01;
//! planner.look(&camera).unwrap();
//! // The maps of the first frame serve the second one.
//! assert_eq!(planner.next_frame(&technique)[0].map_draws(), 0);
//! ```

use std::collections::HashMap;

use lt_mask::{DEPTH_CONSISTENCY_TOLERANCE, Offsets};
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_scene::{Bounds, Camera, Light, LightKind};
use lt_shaders::abi::{
    CameraParams, DepthParams, FilterParams, LightParams, MaskParams, Sample, ShadowParams,
};

use crate::backend::{DepthMapJob, test_params};
use crate::reach::{encloses, place_on, reach_of};
use crate::{
    EffectPlan, FrameJob, LightFit, PackStats, PackedScene, Removal, RenderError, Resolve, Sequence, Setup,
    Technique, TemporalMask, Upkeep, fit_directional,
    lamp::{LightChange, is_jump, lamp_levels, light_params_of},
    levels::{Levels, View, fit_levels, keep_levels},
    light_fit::fit_kept,
};

/// Standard deviation of the pre-filter's Gaussian, texels.
const FILTER_SIGMA: f32 = 1.0;

/// Plans frame after frame of one scene, view and light, or several in turn.
///
/// A technique with a temporal mask takes every [`FramePlanner::next_frame`] as its next frame; the first, and the first after a view
/// that it did not draw, starts without history. [`FramePlanner::look`], [`FramePlanner::repose`] and [`FramePlanner::relight`] change
/// the view between frames.
pub struct FramePlanner {
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
    /// Some of the places that are seen.
    seen: Vec<Vec3>,
    has_all_resolvers: bool,
}

/// What planning and fitting need of a scene.
struct PackedSummary {
    bounds: Bounds,
    /// A box of all casters in every pose since `play`: kept maps are fitted to it.
    reach: Bounds,
    /// A box of the casters that ever move, where they are now.
    moving: Bounds,
    stats: PackStats,
    root: u32,
}

impl PackedSummary {
    fn of(packed: &PackedScene, reach: Bounds) -> Self {
        Self {
            bounds: packed.bounds(),
            reach,
            moving: packed.moving_bounds(),
            stats: *packed.stats(),
            root: packed.root(),
        }
    }
}

/// What one technique keeps between frames for one light; the backend holds its buffers.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    /// Storage in the backend; 0 belongs to all techniques that keep nothing.
    index: usize,
    /// The last frame, if it can still be followed.
    pub(crate) last: Option<LastFrame>,
    /// Frames drawn, to steer patterns.
    frame: u32,
}

/// A slot's last frame.
#[derive(Clone, Debug)]
pub(crate) struct LastFrame {
    view: u64,
    pose: u64,
    camera: CameraParams,
    light: LightKind,
    /// The levels of the light's map and their size; empty without a map.
    pub(crate) levels: (Vec<LightFit>, u32),
    /// A box of all casters that the levels' depths were fitted to.
    casters: Bounds,
}

impl FramePlanner {
    /// For a scene as it was packed.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for a setup that cannot be drawn.
    pub fn new(scene: &PackedScene, setup: Setup) -> Result<Self, RenderError> {
        setup.check()?;
        Ok(Self {
            camera: camera_params(&setup, scene.root()),
            scene: PackedSummary::of(scene, scene.bounds()),
            setup,
            view: 0,
            pose: 0,
            sequence: Sequence::default(),
            slots: HashMap::new(),
            seen: Vec::new(),
            has_all_resolvers: true,
        })
    }

    /// Whether what runs the frames has every [`Resolve`], as the CPU has, or rays and the light BVH alone; at first it has.
    pub(crate) fn set_resolvers(&mut self, has_all: bool) {
        self.has_all_resolvers = has_all;
    }

    /// Says what will change between frames, which decides what techniques plan for; forgets all that they kept.
    pub fn play(&mut self, sequence: Sequence) {
        self.sequence = sequence;
        self.scene.reach = self.scene.bounds;
        for slot in self.slots.values_mut() {
            *slot = Slot { last: None, frame: 0, ..*slot };
        }
    }

    /// What was last told to [`FramePlanner::play`].
    pub fn sequence(&self) -> Sequence {
        self.sequence
    }

    /// View and lights.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The view's camera, as kernels take it.
    pub fn camera(&self) -> &CameraParams {
        &self.camera
    }

    /// Looks from another camera: the next view.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for a camera that cannot be drawn; nothing has changed then.
    pub fn look(&mut self, camera: &Camera) -> Result<(), RenderError> {
        let setup = Setup { camera: camera.clone(), ..self.setup.clone() };
        setup.check()?;
        self.camera = camera_params(&setup, self.scene.root);
        self.setup = setup;
        self.view += 1;
        self.sequence.camera_moves = true;
        Ok(())
    }

    /// Takes the next pose of the scene, packed anew: casters have moved. [`FramePlanner::look`] comes after it, from the same place too.
    pub fn repose(&mut self, scene: &PackedScene) {
        self.scene = PackedSummary::of(scene, reach_of(self.scene.reach, scene.bounds()));
        self.pose += 1;
        self.sequence.objects_move = true;
    }

    /// Changes the lights, as many as there are, from the next frame on; histories and maps of those that stay as they are
    /// serve on, and so do histories of those that move slowly ([`crate::LIGHT_JUMP_RAD`]).
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] for another number of lights, or for a light that cannot be drawn; nothing has changed then.
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

    /// Some of the places that are seen ([`places_of`]), world space, some thousands at most and spread evenly over the picture, those of the last
    /// frame if need be; empty where nobody knows any.
    ///
    /// The levels of a sun's map are fitted to them where rays answer what lies on no level, so that texels are not spent on what is hidden or
    /// beside the view: a half to a third of the doubts. Without any they are fitted to all that the view may hold. What a lamp's motion means
    /// for the mask is judged from the median distance to them, without any from the middle of the scene.
    pub fn see(&mut self, places: Vec<Vec3>) {
        self.seen = places;
    }

    /// The effects a technique calls for here, under the first light.
    pub fn plan(&self, technique: &Technique) -> EffectPlan {
        self.plan_under(technique, (0, &self.setup.light), 0)
    }

    pub(crate) fn plan_under(
        &self,
        technique: &Technique,
        (number, light): (u32, &Light),
        layer: u32,
    ) -> EffectPlan {
        let map_size = self.setup.map_size;
        let technique = &Technique { resolve: self.resolver(technique.resolve), ..*technique };
        let plan = EffectPlan::for_scene(&self.scene.stats, &light.kind, technique, map_size, self.sequence)
            .among_lights(self.setup.lights().count());
        // Rays to all lights walk one tree, and all layers' whatever there is.
        let is_done = layer > 0 || (number > 0 && technique.resolve == Resolve::Ray);
        EffectPlan { upkeep: if is_done { Upkeep::Kept } else { self.setup.upkeep }, ..plan }
    }

    /// The structure in light space, where it is left to us, that there is and that what is kept from frame to frame calls for.
    fn resolver(&self, resolve: Resolve) -> Resolve {
        match (resolve, self.setup.upkeep) {
            (Resolve::LightSpace, _) if !self.has_all_resolvers => Resolve::Light,
            (Resolve::LightSpace, upkeep) if upkeep != Upkeep::Kept => Resolve::DivideAndConquer,
            _ => resolve,
        }
    }

    /// Where the first light's one map of this many texels a side looks, if it is a directional one.
    pub fn light_fit(&self, map_size: u32) -> LightFit {
        fit_directional(self.scene.bounds, &self.camera, sun_direction(&self.setup.light.kind), map_size)
    }

    /// A box of all casters.
    pub fn bounds(&self) -> Bounds {
        self.scene.bounds
    }

    /// What the passes of a technique's next frame need, a job for each light, on the first layer. The frame counts as drawn: what it keeps
    /// is what the one after it finds, so that all of its passes ([`FrameJob::passes`]) must run.
    pub fn next_frame(&mut self, technique: &Technique) -> Vec<FrameJob> {
        let lights: Vec<Light> = self.setup.lights().cloned().collect();
        let next = |(number, light): (u32, &Light)| {
            let plan = self.plan_under(technique, (number, light), 0);
            let (job, slot) = self.next_job(technique, plan, (number, light), 0);
            self.keep(technique, (number, 0), slot);
            job
        };
        (0..).zip(&lights).map(next).collect()
    }

    /// What the passes of a technique's next frame under the first light need; nothing is kept of it.
    pub fn job(&self, technique: &Technique) -> FrameJob {
        self.next_job(technique, self.plan(technique), (0, &self.setup.light), 0).0
    }

    /// The median distance of what is seen from a point.
    pub(crate) fn usual_distance(&self, from: Vec3) -> f32 {
        if self.seen.is_empty() && !self.scene.bounds.is_empty() {
            return ((self.scene.bounds.min + self.scene.bounds.max) * 0.5).distance(from);
        }
        crate::quantile(self.seen.iter().map(|at| f64::from(at.distance(from))).collect(), 0.5) as f32
    }

    /// Remembers what a frame that was drawn keeps, under a light and on a layer.
    pub(crate) fn keep(&mut self, technique: &Technique, (light, layer): (u32, u32), slot: Slot) {
        if slot.index > 0 {
            self.slots.insert((technique.to_string(), light, layer), slot);
        }
    }

    /// The next frame of a technique under one light, and what it keeps once that is drawn.
    pub(crate) fn next_job(
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
            moving: match plan.has_marks() {
                true => levels.fits.iter().map(|fit| place_on(&fit.projection, self.scene.moving)).collect(),
                false => Vec::new(),
            },
            keeps_still: plan.reuse && self.sequence.objects_move,
            filter: FilterParams { test, map_size, sigma: FILTER_SIGMA, pad: UVec2::ZERO },
        });
        let change = slot.last.as_ref().map(|l| LightChange {
            has_moved: l.light != light.kind,
            is_jump: is_jump(&l.light, &light.kind, |from| self.usual_distance(from)),
        });
        let maps = (&levels.fits[..], map_size);
        let mask = technique
            .mask
            .map(|m| self.mask_params(&m, &slot, maps, (for_kernels, change), plan.has_marks()));
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
            // Where nothing traces what lies on no level, levels must hold all that may be seen.
            let places = if plan.doubt_list { &self.seen[..] } else { &[] };
            let view = View { scene, camera, direction, map_size, places };
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
        mask: &TemporalMask,
        slot: &Slot,
        map: (&[LightFit], u32),
        (light, change): (LightParams, Option<LightChange>),
        has_marks: bool,
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
        let (expansion, moving_pattern) = mask.rules_for(has_holes, drawn_anew, has_marks);
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

/// Most places that [`places_of`] takes of a picture.
const PLACES: usize = 4_096;

/// Places for [`FramePlanner::see`] of a picture's samples, row by row: those on a square grid, some thousands.
pub fn places_of(samples: &[Sample], width: usize) -> impl Iterator<Item = Vec3> {
    let step = (samples.len() as f64 / PLACES as f64).sqrt().ceil().max(1.0) as usize;
    let is_on_grid = move |line: usize| line % step == step / 2;
    let rows = samples.chunks(width.max(1)).enumerate().filter(move |(y, _)| is_on_grid(*y));
    let seen =
        rows.flat_map(move |(_, row)| row.iter().skip(step / 2).step_by(step)).filter(|s| s.is_valid());
    seen.map(|s| s.position)
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
