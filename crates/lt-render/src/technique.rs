//! Techniques as data: estimate, doubt, resolve.

use lt_mask::{Expansion, Pattern};
use lt_math::LTT_EPSILON;

use crate::{Cascades, Sequence};

/// How a map answers the shadow test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapTest {
    /// Nearest depth, biased.
    Sm,
    /// Percentage-closer filtering of the 2×2 tests, biased.
    Pcf,
    /// Variance shadow map.
    Vsm,
    /// Exponential shadow map.
    Esm,
    /// Exponential variance shadow map.
    Evsm,
    /// Moment shadow map, Hamburger bound.
    Msm,
    /// Moment shadow map, Hausdorff bound.
    MsmHausdorff,
}

impl MapTest {
    /// Every test, in the order reports list them.
    pub const ALL: [Self; 7] =
        [Self::Sm, Self::Pcf, Self::Vsm, Self::Esm, Self::Evsm, Self::Msm, Self::MsmHausdorff];

    /// Id as typed: `vsm`.
    pub fn id(self) -> &'static str {
        match self {
            Self::Sm => "sm",
            Self::Pcf => "pcf",
            Self::Vsm => "vsm",
            Self::Esm => "esm",
            Self::Evsm => "evsm",
            Self::Msm => "msm",
            Self::MsmHausdorff => "msm-hausdorff",
        }
    }

    /// Whether its depth vectors may be filtered before the test (and so whether LTT has a meaning).
    pub fn is_filterable(self) -> bool {
        !matches!(self, Self::Sm | Self::Pcf)
    }
}

/// Where the filtered depth vector comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapSource {
    /// Four plain depths gathered per pixel, turned into vectors there.
    Gather,
    /// A map of vectors, blurred once by a separable Gaussian.
    Prefiltered,
}

/// What a cheap map says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Estimate {
    /// Nothing.
    None,
    /// A shadow map.
    Map {
        /// The shadow test.
        test: MapTest,
        /// Gathered or pre-filtered.
        source: MapSource,
    },
}

/// Where the estimate may be wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Doubt {
    /// Nowhere.
    Never,
    /// Everywhere.
    Always,
    /// Where the leak tracing test says so: ε < v̂ < 1 − ε, NaN, or outside the map.
    Ltt,
}

/// What answers a doubted pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Resolve {
    /// Nothing.
    None,
    /// A ray through the world-space BVH, alpha-tested.
    Ray,
    /// The same answer from a tree over the triangles in the light's own space (`lt_irregular::LightBvh`), kept while light and
    /// casters stand still.
    Light,
    /// The same answer from dividing points and triangles together (`lt_irregular::DivideAndConquer`); CPU only.
    DivideAndConquer,
    /// The same answer by the light BVH or by divide and conquer, whichever fits the frame ([`Resolve::in_frames`]).
    LightSpace,
    /// The same answer from triangles drawn at the points themselves: the alias-free shadow map of Aila and Laine 2004
    /// (`lt_irregular::SampleMap`); CPU only.
    AliasFree,
}

impl Resolve {
    /// Whether it finds the truth about pixels.
    pub fn is_exact(self) -> bool {
        self != Resolve::None
    }

    /// Whether it works in the light's own space: on scenes packed with [`Packing::bakes_copies`](crate::Packing) alone.
    pub fn is_in_light_space(self) -> bool {
        matches!(self, Resolve::Light | Resolve::DivideAndConquer | Resolve::LightSpace | Resolve::AliasFree)
    }

    /// What works in the frames of a sequence: [`Resolve::LightSpace`] settles for one of two, all others stay what they are.
    ///
    /// That is the light BVH where it serves more than one frame, and divide and conquer where it would have to be planted for one alone: planting it
    /// takes longer than dividing all points of a picture, and walking it less, in every scene measured (docs/results/alias-free.md, "Which
    /// structure").
    pub fn in_frames(self, sequence: Sequence) -> Self {
        let stands = sequence.is_played && !sequence.objects_move && !sequence.lights_move;
        match self {
            Resolve::LightSpace if stands => Resolve::Light,
            Resolve::LightSpace => Resolve::DivideAndConquer,
            other => other,
        }
    }

    /// The modifier that asks for it; none for rays, which need no asking for.
    pub fn modifier(self) -> Option<&'static str> {
        match self {
            Resolve::None | Resolve::Ray => None,
            Resolve::Light => Some("light"),
            Resolve::DivideAndConquer => Some("dac"),
            Resolve::LightSpace => Some("space"),
            Resolve::AliasFree => Some("alias-free"),
        }
    }
}

/// Where the temporal mask saves rays that the doubt asks for (RR).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Removal {
    /// Nowhere.
    Never,
    /// Where camera, pixel, light and casters stand exactly still: there the last frame's ray answers (`lt_mask::Evidence::known`).
    Known,
    /// Wherever all neighbours agree, as published (eq. 8): where pixels move this adds wrong ones. Without the paper's guard (§3.4), which keeps
    /// rays where a moving caster's depth is in the footprint: one map holds both here.
    Published,
}

/// Corrects a doubt by the last frame's rays (Kern et al. 2024, §3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TemporalMask {
    /// ER: trace where a neighbour's history contradicts the estimate.
    pub expands: bool,
    /// Whose histories contradict; `None` leaves it to the scene ([`TemporalMask::rules_for`]).
    pub expansion: Option<Expansion>,
    /// RR: where doubted pixels get no ray.
    pub removal: Removal,
    /// Neighbours asked where pixels stand still.
    pub pattern: Pattern,
    /// Neighbours asked where pixels move; `None` leaves it to the scene ([`TemporalMask::rules_for`]).
    pub moving_pattern: Option<Pattern>,
    /// Frames in which every pixel is traced once, on a rolling pattern (`lt_mask::is_due`); 0 for no such refresh.
    pub refresh: u32,
    /// The temporal depth test: a pixel where the last frame saw another surface counts as not found.
    pub depth_test: bool,
    /// Rays that contradict a test that was sure mark the map, while it is kept (`lt_mask::TexelMarks`).
    pub marks: bool,
}

impl TemporalMask {
    /// What holds in motion too: see docs/results/leak-tracing.md.
    ///
    /// The depth test is on for the tests that the paper calls for it: ESM and MSM.
    pub const fn recommended(test: MapTest) -> Self {
        Self {
            expands: true,
            expansion: None,
            removal: Removal::Known,
            pattern: Pattern::GATHER_2X2,
            moving_pattern: None,
            refresh: 0,
            depth_test: matches!(test, MapTest::Esm | MapTest::Msm | MapTest::MsmHausdorff),
            marks: true,
        }
    }

    /// The paper's rules as published: eqs. 6 and 8 wherever pixels are, by one pattern.
    pub(crate) fn published(self) -> Self {
        Self {
            removal: Removal::Published,
            expansion: Some(Expansion::PUBLISHED),
            moving_pattern: Some(self.pattern),
            marks: false,
            ..self
        }
    }

    /// Who is heard where pixels move, and which neighbours are asked.
    ///
    /// A map that is `drawn_anew`, or a light that moves, changes shadow tests everywhere, which only the published rule hears. Else rays are
    /// spent where they were needed: around pixels whose map was wrong, fewer where it `has_marks`; or, where casters have
    /// holes and edges are everywhere, around every ray that contradicts. Measured in docs/results/leak-tracing.md.
    pub fn rules_for(&self, has_holes: bool, drawn_anew: bool, has_marks: bool) -> (Expansion, Pattern) {
        let (expansion, pattern) = match (drawn_anew, has_holes, has_marks) {
            (true, false, _) => (Expansion::PUBLISHED, Pattern::FULL_3X3),
            (true, true, _) => (Expansion::PUBLISHED, Pattern::DIAMOND),
            (false, false, true) => (Expansion::LEAKS, Pattern::DIAMOND),
            (false, false, false) => (Expansion::LEAKS, Pattern::FULL_5X5),
            (false, true, _) => (Expansion::RAYS, Pattern::FULL_5X5),
        };
        let expansion = if drawn_anew { expansion } else { self.expansion.unwrap_or(expansion) };
        (expansion, self.moving_pattern.unwrap_or(pattern))
    }
}

/// A way to shadow a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Technique {
    /// What a cheap map says.
    pub estimate: Estimate,
    /// Where that is doubted.
    pub doubt: Doubt,
    /// What last frame's rays make of the doubt; needs one that [`Resolve::is_exact`].
    pub mask: Option<TemporalMask>,
    /// What answers the doubt.
    pub resolve: Resolve,
    /// Whether a map is kept from frame to frame while it covers what the camera sees; else it is drawn every frame.
    pub reuse: bool,
    /// Levels of a directional light's map.
    pub cascades: Cascades,
    /// LTT's ε, in (0, 0.5).
    pub epsilon: f32,
    /// Map resolution if it differs from the setup's.
    pub map_size: Option<u32>,
}

/// Map resolutions that are accepted: a multiple of 64 up to this.
pub(crate) const MAX_MAP_SIZE: u32 = 16384;

impl Technique {
    /// Full ray tracing.
    pub const RAY: Self = Self {
        estimate: Estimate::None,
        doubt: Doubt::Always,
        mask: None,
        resolve: Resolve::Ray,
        reuse: true,
        cascades: Cascades::ONE,
        epsilon: LTT_EPSILON,
        map_size: None,
    };

    /// A map alone.
    pub const fn map(test: MapTest, source: MapSource) -> Self {
        Self {
            estimate: Estimate::Map { test, source },
            doubt: Doubt::Never,
            mask: None,
            resolve: Resolve::None,
            reuse: true,
            cascades: Cascades::ONE,
            epsilon: LTT_EPSILON,
            map_size: None,
        }
    }

    /// A filterable map, the leak tracing test, and rays.
    pub const fn leak_tracing_test(test: MapTest, source: MapSource) -> Self {
        Self {
            estimate: Estimate::Map { test, source },
            doubt: Doubt::Ltt,
            mask: None,
            resolve: Resolve::Ray,
            reuse: true,
            cascades: Cascades::TRACED_FAR,
            epsilon: LTT_EPSILON,
            map_size: None,
        }
    }

    /// Leak tracing whole: a filterable map, the leak tracing test, the temporal mask, and rays.
    pub const fn leak_tracing(test: MapTest, source: MapSource) -> Self {
        let mut technique = Self::leak_tracing_test(test, source);
        technique.mask = Some(TemporalMask::recommended(test));
        technique
    }

    /// What answers every pixel in the light's own space in place of rays, with one line about each.
    pub fn in_light_space() -> Vec<(Self, String)> {
        let of = |(resolve, words): (Resolve, &str)| (Self { resolve, ..Self::RAY }, words.to_owned());
        [
            (
                Resolve::AliasFree,
                "alias-free shadow map: triangles drawn at the pixels' own places, ray's answers without a ray \
                 (CPU)",
            ),
            (
                Resolve::Light,
                "ray's answers from a tree in the light's own space, kept while light and casters stand still",
            ),
            (
                Resolve::DivideAndConquer,
                "ray's answers by dividing pixels and triangles together, nothing kept (CPU)",
            ),
            (
                Resolve::LightSpace,
                "ray:light where light and casters stand still over several frames, else ray:dac; on the GPU \
                 ray:light",
            ),
        ]
        .map(of)
        .to_vec()
    }

    /// Every base technique that draws a map or traces rays, with one line about it.
    pub fn catalogue() -> Vec<(Self, String)> {
        let mut all = vec![(Self::RAY, "full ray tracing: every light-facing pixel".to_owned())];
        for test in MapTest::ALL {
            let words = match test {
                MapTest::Sm => "shadow map, nearest texel, biased",
                MapTest::Pcf => "shadow map, 2×2 percentage-closer filtering, biased",
                MapTest::Vsm => "variance shadow map (Chebyshev bound)",
                MapTest::Esm => "exponential shadow map",
                MapTest::Evsm => "exponential variance shadow map (two Chebyshev bounds)",
                MapTest::Msm => "moment shadow map (Hamburger bound)",
                MapTest::MsmHausdorff => "moment shadow map (Hausdorff bound)",
            };
            all.push((Self::map(test, MapSource::Gather), words.to_owned()));
        }
        for test in MapTest::ALL.into_iter().filter(|t| t.is_filterable()) {
            let words = format!("{} where it is sure, rays where the leak tracing test doubts it", test.id());
            all.push((Self::leak_tracing_test(test, MapSource::Gather), words));
        }
        for test in MapTest::ALL.into_iter().filter(|t| t.is_filterable()) {
            let words = format!("leak tracing: ltt-{} corrected by the last frame's rays", test.id());
            all.push((Self::leak_tracing(test, MapSource::Gather), words));
        }
        all
    }

    /// The cascades of its base.
    pub(crate) fn usual_cascades(&self) -> Cascades {
        if self.doubt == Doubt::Ltt { Cascades::TRACED_FAR } else { Cascades::ONE }
    }

    /// Its map test, if it draws a map.
    pub fn map_test(&self) -> Option<(MapTest, MapSource)> {
        match self.estimate {
            Estimate::None => None,
            Estimate::Map { test, source } => Some((test, source)),
        }
    }
}
