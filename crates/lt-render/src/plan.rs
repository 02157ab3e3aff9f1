//! Which effects a scene, a view and a technique call for: the frame driver runs exactly these.

use lt_scene::LightKind;

use crate::lamp::lamp_maps;
use crate::{Doubt, FarLevel, MapSource, MapTest, PackStats, PassKind, Removal, Resolve, Technique, Upkeep};

/// One effect, needed or not, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Name, e.g. `alpha test`.
    pub name: &'static str,
    /// Whether this frame needs it.
    pub is_on: bool,
    /// Why, in words with numbers.
    pub reason: String,
    /// What it costs when on (passes, bindings, bytes), in words with numbers.
    pub cost: String,
}

/// What changes between the frames of a session.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sequence {
    /// Several frames are played, so that what is kept between them pays.
    pub is_played: bool,
    /// The camera moves.
    pub camera_moves: bool,
    /// Things in the scene move.
    pub objects_move: bool,
    /// Lights move.
    pub lights_move: bool,
    /// Techniques with a temporal mask begin with a cleared one, instead of tracing every pixel of their first frame: a
    /// diagnostic that shows how a history grows from nothing.
    pub starts_cold: bool,
}

/// Which parts of the temporal mask run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaskEffects {
    /// Pixels are looked for where they were.
    pub motion: bool,
    /// The last frame's depths are kept and compared.
    pub depth_test: bool,
    /// ER.
    pub expands: bool,
    /// RR.
    pub removes: bool,
    /// Rays that contradict a test that was sure mark the map, which is kept.
    pub marks: bool,
}

/// The plan of one frame.
///
/// The switches select kernel variants: an effect that is off has no pass, no binding, no buffer and no branch.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectPlan {
    /// Casters with holes: rays and map fragments look up coverage.
    pub alpha_test: bool,
    /// Meshes placed more than once: rays walk a TLAS.
    pub instances: bool,
    /// Base colour textures: the camera pass looks up colours.
    pub color_textures: bool,
    /// A depth map is drawn, for this test.
    pub map: Option<(MapTest, MapSource)>,
    /// Maps of the light: levels of a cascade, faces of a cube, or one.
    pub levels: u32,
    /// Lines of sight meet in the light: maps of spot and point lights.
    pub perspective: bool,
    /// Every pixel looks for its level; off, one map answers all.
    pub level_search: bool,
    /// Doubted pixels are compacted into a list.
    pub doubt_list: bool,
    /// Every light-facing pixel is traced, without a list.
    pub trace_all: bool,
    /// What answers the doubt; never [`Resolve::LightSpace`], which has settled for one of two.
    pub resolve: Resolve,
    /// What the frame does to the structures that it traces with.
    pub upkeep: Upkeep,
    /// The last frame corrects the doubt.
    pub mask: Option<MaskEffects>,
    /// The camera pass also finds where every visible point was in the last frame.
    pub object_motion: bool,
    /// The map is kept while it covers what the camera sees.
    pub reuse: bool,
    /// Light is tinted by translucent casters.
    pub tint: bool,
    /// Layers of what the camera sees, each with shadows of its own; 1 for what is nearest alone.
    pub layers: u32,
    /// The same, listed for people.
    pub effects: Vec<Effect>,
}

impl EffectPlan {
    /// Inspects the input.
    pub fn for_scene(
        s: &PackStats,
        light: &LightKind,
        technique: &Technique,
        map_size: u32,
        sequence: Sequence,
    ) -> Self {
        let map = technique.map_test();
        let resolve = technique.resolve.in_frames(sequence);
        let doubt_list = technique.doubt == Doubt::Ltt && technique.resolve.is_exact();
        let trace_all = technique.doubt == Doubt::Always;
        let size = technique.map_size.unwrap_or(map_size);
        let is_prefiltered = matches!(map, Some((_, MapSource::Prefiltered)));
        let lamp = lamp_maps(light);
        let maps = lamp.unwrap_or(technique.cascades.maps());
        let levels = if map.is_some() { maps } else { 0 };
        let has_cascades = lamp.is_none() && technique.cascades.count > 1;
        let reuse = map.is_some() && technique.reuse && sequence.is_played;
        let map_bytes = u64::from(levels) * u64::from(size) * u64::from(size);
        let mut plan = Self {
            alpha_test: s.masked_triangles > 0,
            instances: s.instanced_meshes > 0,
            color_textures: s.color_texel_bytes > 0,
            map,
            levels,
            perspective: lamp.is_some(),
            level_search: lamp.is_some() || has_cascades,
            doubt_list,
            trace_all,
            resolve,
            upkeep: Upkeep::Kept,
            mask: technique.mask.map(|m| MaskEffects {
                motion: sequence.camera_moves || sequence.objects_move,
                depth_test: m.depth_test,
                expands: m.expands,
                removes: m.removal != Removal::Never,
                marks: m.marks && reuse,
            }),
            object_motion: technique.mask.is_some() && sequence.objects_move,
            reuse,
            tint: s.is_translucency_traced && s.translucent_triangles > 0,
            layers: 1 + s.layers_behind,
            effects: Vec::new(),
        };
        let (mask, object_motion) = (plan.mask, plan.object_motion);
        let mut list = |name, is_on, reason: String, cost: String| {
            plan.effects.push(Effect { name, is_on, reason, cost });
        };
        list(
            "alpha test",
            s.masked_triangles > 0,
            format!("{} of {} triangles have holes", s.masked_triangles, s.triangles),
            format!(
                "3 bindings, {} of coverage texels, a fragment stage in the depth map",
                bytes(s.alpha_texel_bytes)
            ),
        );
        list(
            "instances",
            s.instanced_meshes > 0,
            format!("{} meshes are placed more than once, {} times in all", s.instanced_meshes, s.instances),
            format!("1 binding, a TLAS over {} instances", s.instances),
        );
        list(
            "colour textures",
            s.color_texel_bytes > 0,
            format!("{} of base colour texels in use", bytes(s.color_texel_bytes)),
            "1 binding in the camera pass".to_owned(),
        );
        list(
            "depth map",
            map.is_some(),
            map.map_or("the technique asks no map".to_owned(), |(t, _)| format!("estimate is {}", t.id())),
            format!("1 pass, {}", bytes(map_bytes * 4)),
        );
        list(
            "cascades",
            has_cascades,
            match (technique.cascades.count, technique.cascades.far) {
                _ if lamp.is_some() => "the light is not a directional one".to_owned(),
                (1, _) => "one map for all that the camera sees".to_owned(),
                (n, FarLevel::Map) => format!("{n} levels, each with a map"),
                (n, FarLevel::Rays) => format!("{n} levels, the last one traced"),
            },
            "1 binding, a projection a level and pixel, a map a level".to_owned(),
        );
        list(
            "perspective maps",
            lamp.is_some() && map.is_some(),
            match lamp {
                None => "the light is directional".to_owned(),
                Some(1) => "a spot light: one map".to_owned(),
                Some(n) => format!("light goes all ways: the {n} faces of a cube"),
            },
            "a fragment stage for depths, 1 binding, a projection a map and pixel".to_owned(),
        );
        list(
            "pre-filter",
            is_prefiltered,
            if is_prefiltered {
                "blurred depth vectors asked for"
            } else {
                "vectors are made from gathered depths"
            }
            .to_owned(),
            format!("2 passes, {} and as much again that techniques share", bytes(map_bytes * 16)),
        );
        list(
            "doubt list",
            doubt_list,
            if doubt_list { "LTT doubts some pixels" } else { "nothing is doubted pixel by pixel" }
                .to_owned(),
            "1 pass, 4 bytes a pixel, an indirect dispatch".to_owned(),
        );
        list(
            "rays",
            resolve == Resolve::Ray,
            match technique.doubt {
                Doubt::Never => "the estimate stands as it is",
                Doubt::Always => "every light-facing pixel is doubted",
                Doubt::Ltt => "doubted pixels are resolved by rays",
            }
            .to_owned(),
            "1 pass, the BVH".to_owned(),
        );
        list(
            "light tree",
            resolve == Resolve::Light,
            match resolve {
                Resolve::None => "the estimate stands as it is",
                Resolve::Ray => "rays walk the BVH",
                Resolve::Light => "rays are points in the light's own space",
                _ if technique.resolve == Resolve::LightSpace => {
                    "it would serve one frame: divide and conquer"
                }
                _ => "the resolver keeps nothing",
            }
            .to_owned(),
            "a pass of the host when light or casters have moved, 75 bytes a triangle".to_owned(),
        );
        list(
            "translucent casters",
            s.is_translucency_traced && s.translucent_triangles > 0,
            match (s.translucent_triangles, s.is_translucency_traced) {
                (0, _) => "nothing lets light through in part".to_owned(),
                (n, true) => format!("{n} of {} triangles let light through in part", s.triangles),
                (n, false) => {
                    format!(
                        "{n} of {} triangles would, but coverage is binary: see --translucent",
                        s.triangles
                    )
                }
            },
            "1 pass, 16 bytes a pixel, a BVH of translucent casters alone, a ray per lit pixel".to_owned(),
        );
        list(
            "layers",
            s.layers_behind > 0,
            match (s.layers_behind, s.translucent_triangles) {
                (_, 0) => "nothing lets light through in part".to_owned(),
                (0, _) => "the camera sees what is nearest alone: see --layers".to_owned(),
                (n, _) => format!("up to {n} surfaces are seen behind the first"),
            },
            "all passes once more a layer, 64 bytes a sample and layer".to_owned(),
        );
        let no_mask = || "the technique has no temporal mask".to_owned();
        list(
            "static map reuse",
            reuse,
            match (map, technique.reuse, sequence) {
                (None, ..) => "the technique asks no map",
                (_, false, _) => "the technique draws its map every frame",
                (_, _, Sequence { is_played: false, .. }) => "a single frame",
                (_, _, Sequence { objects_move: true, .. }) => {
                    "several frames; casters that move are drawn over those at rest"
                }
                _ => "several frames, casters at rest",
            }
            .to_owned(),
            "the map's box grown by 15 %; saves the map's passes".to_owned(),
        );
        list(
            "temporal mask",
            mask.is_some(),
            mask.map_or_else(no_mask, |_| "last frame's rays correct the doubt".to_owned()),
            "1 pass, 2 × 4 bytes a pixel (3 bits a light)".to_owned(),
        );
        list(
            "ray removal",
            mask.is_some_and(|m| m.removes),
            match technique.mask.map(|m| m.removal) {
                None => no_mask(),
                Some(Removal::Never) => "the technique removes no rays".to_owned(),
                Some(Removal::Known) => "where camera, pixel, light and casters stand still".to_owned(),
                Some(Removal::Published) => "everywhere, as published".to_owned(),
            },
            "reads a pixel's own history, or as published its neighbours'".to_owned(),
        );
        list(
            "marks",
            mask.is_some_and(|m| m.marks),
            match (technique.mask, reuse) {
                (None, _) => no_mask(),
                (Some(m), _) if !m.marks => "the technique leaves none".to_owned(),
                (Some(_), false) => "no map is kept, and marks would go with it".to_owned(),
                (Some(_), true) => {
                    "where a ray contradicts a test that was sure, the map remembers it".to_owned()
                }
            },
            format!("on the GPU 1 pass, 1 binding and 2 × {}; on the CPU no memory", bytes(map_bytes / 4)),
        );
        list(
            "rolling refresh",
            technique.mask.is_some_and(|m| m.refresh > 0),
            match technique.mask.map(|m| m.refresh) {
                None => no_mask(),
                Some(0) => "the technique trusts its history".to_owned(),
                Some(n) => format!("every pixel is traced once in {n} frames"),
            },
            "a ray for one pixel in as many".to_owned(),
        );
        list(
            "temporal depth test",
            mask.is_some_and(|m| m.depth_test),
            match mask {
                None => no_mask(),
                Some(m) if m.depth_test => "new surfaces are told from old ones by depth".to_owned(),
                Some(_) => "the technique trusts the motion vectors".to_owned(),
            },
            "1 read, 2 × 4 bytes a pixel".to_owned(),
        );
        list(
            "motion vectors",
            mask.is_some_and(|m| m.motion),
            match mask {
                None => no_mask(),
                Some(m) if m.motion => "the camera or something seen moves".to_owned(),
                Some(_) => "nothing moves: every pixel is its own past".to_owned(),
            },
            "two projections a pixel, no buffer".to_owned(),
        );
        list(
            "object motion",
            object_motion,
            if sequence.objects_move { "things in the scene move" } else { "nothing in the scene moves" }
                .to_owned(),
            "2 bindings in the camera pass, 16 bytes a pixel and a vertex".to_owned(),
        );
        plan
    }

    /// The same, listing also that its light is one of so many, at least 1.
    pub(crate) fn among_lights(mut self, count: usize) -> Self {
        self.effects.push(Effect {
            name: "several lights",
            is_on: count > 1,
            reason: match count {
                1 => "one light shines: see --lights, --light-pos".to_owned(),
                n => format!("{n} lights shine"),
            },
            cost: "all passes but the camera's once more a light, and its maps".to_owned(),
        });
        self
    }

    /// Whether rays mark the map: see [`MaskEffects::marks`].
    pub fn has_marks(&self) -> bool {
        self.mask.is_some_and(|m| m.marks)
    }

    /// Whether a map of depth vectors is blurred.
    pub fn is_prefiltered(&self) -> bool {
        matches!(self.map, Some((_, MapSource::Prefiltered)))
    }

    /// The passes of a frame, in order. The camera pass is not among them: it runs once per view.
    pub fn passes(&self) -> Vec<PassKind> {
        let mut passes = Vec::new();
        if self.upkeep != Upkeep::Kept && self.resolve != Resolve::None {
            passes.push(PassKind::Build);
        }
        // Before all passes over pixels: a backend may run these together.
        if self.resolve == Resolve::Light {
            passes.push(PassKind::LightTree);
        }
        if let Some((_, source)) = self.map {
            passes.push(PassKind::DepthMap);
            if source == MapSource::Prefiltered {
                passes.extend([PassKind::FilterX, PassKind::FilterY]);
            }
            passes.push(PassKind::Evaluate);
        }
        if self.mask.is_some() {
            passes.push(PassKind::Mask);
        }
        if self.doubt_list || self.trace_all {
            passes.push(PassKind::Resolve);
        }
        if self.tint {
            passes.push(PassKind::Tint);
        }
        passes
    }
}

fn bytes(n: u64) -> String {
    match n {
        0..1024 => format!("{n} B"),
        1024..1048576 => format!("{:.0} KiB", n as f64 / 1024.0),
        _ => format!("{:.1} MiB", n as f64 / 1048576.0),
    }
}
