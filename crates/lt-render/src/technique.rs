//! Techniques as data: estimate, doubt, resolve, and the ids that name them.

use std::{fmt, str::FromStr};

use lt_math::LTT_EPSILON;

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
}

/// A way to shadow a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Technique {
    /// What a cheap map says.
    pub estimate: Estimate,
    /// Where that is doubted.
    pub doubt: Doubt,
    /// What answers the doubt.
    pub resolve: Resolve,
    /// LTT's ε, in (0, 0.5).
    pub epsilon: f32,
    /// Map resolution if it differs from the setup's.
    pub map_size: Option<u32>,
}

/// A technique id that means nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("technique `{id}`: {problem}")]
pub struct TechniqueError {
    /// What was typed.
    pub id: String,
    /// What is wrong and what would be right.
    pub problem: String,
}

/// Map resolutions that are accepted: a multiple of 64 up to this.
pub(crate) const MAX_MAP_SIZE: u32 = 16384;

impl Technique {
    /// Full ray tracing.
    pub const RAY: Self = Self {
        estimate: Estimate::None,
        doubt: Doubt::Always,
        resolve: Resolve::Ray,
        epsilon: LTT_EPSILON,
        map_size: None,
    };

    /// A map alone.
    pub const fn map(test: MapTest, source: MapSource) -> Self {
        Self {
            estimate: Estimate::Map { test, source },
            doubt: Doubt::Never,
            resolve: Resolve::None,
            epsilon: LTT_EPSILON,
            map_size: None,
        }
    }

    /// A filterable map, the leak tracing test, and rays.
    pub const fn leak_tracing_test(test: MapTest, source: MapSource) -> Self {
        Self {
            estimate: Estimate::Map { test, source },
            doubt: Doubt::Ltt,
            resolve: Resolve::Ray,
            epsilon: LTT_EPSILON,
            map_size: None,
        }
    }

    /// Every base technique with one line about it.
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
        all
    }

    /// The modifiers an id may carry, with a line each.
    pub fn modifiers() -> [(&'static str, &'static str); 3] {
        [
            ("prefiltered", "blur a map of depth vectors instead of gathering plain depths"),
            ("eps=X", "LTT's ε, 0 < X < 0.5 (default 0.01)"),
            ("map=N", "map resolution, a multiple of 64 up to 16384"),
        ]
    }

    /// Its map test, if it draws a map.
    pub fn map_test(&self) -> Option<(MapTest, MapSource)> {
        match self.estimate {
            Estimate::None => None,
            Estimate::Map { test, source } => Some((test, source)),
        }
    }
}

impl fmt::Display for Technique {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.map_test() {
            None => write!(f, "ray")?,
            Some((test, source)) => {
                let prefix = if self.doubt == Doubt::Ltt { "ltt-" } else { "" };
                write!(f, "{prefix}{}", test.id())?;
                if source == MapSource::Prefiltered {
                    write!(f, ":prefiltered")?;
                }
            }
        }
        if self.epsilon != LTT_EPSILON {
            write!(f, ":eps={}", self.epsilon)?;
        }
        if let Some(size) = self.map_size {
            write!(f, ":map={size}")?;
        }
        Ok(())
    }
}

impl FromStr for Technique {
    type Err = TechniqueError;

    fn from_str(id: &str) -> Result<Self, TechniqueError> {
        let fail = |problem: String| TechniqueError { id: id.to_owned(), problem };
        let mut parts = id.split(':');
        let base = parts.next().unwrap_or_default();
        let mut technique = base_technique(base).ok_or_else(|| {
            let known: Vec<String> = Self::catalogue().iter().map(|(t, _)| t.to_string()).collect();
            fail(format!("no such base `{base}`; known: {}", known.join(", ")))
        })?;
        for modifier in parts {
            apply_modifier(&mut technique, modifier).map_err(&fail)?;
        }
        Ok(technique)
    }
}

fn base_technique(base: &str) -> Option<Technique> {
    if base == "ray" {
        return Some(Technique::RAY);
    }
    let (name, is_hybrid) = match base.strip_prefix("ltt-") {
        Some(rest) => (rest, true),
        None => (base, false),
    };
    let test = MapTest::ALL.into_iter().find(|t| t.id() == name)?;
    match is_hybrid {
        true => test.is_filterable().then(|| Technique::leak_tracing_test(test, MapSource::Gather)),
        false => Some(Technique::map(test, MapSource::Gather)),
    }
}

fn apply_modifier(technique: &mut Technique, modifier: &str) -> Result<(), String> {
    let (key, value) = modifier.split_once('=').unwrap_or((modifier, ""));
    match key {
        "prefiltered" => match &mut technique.estimate {
            Estimate::Map { test, source } if test.is_filterable() => *source = MapSource::Prefiltered,
            _ => {
                return Err("`prefiltered` needs a filterable map: vsm, esm, evsm, msm, msm-hausdorff".into());
            }
        },
        "eps" if technique.doubt == Doubt::Ltt => {
            technique.epsilon = value
                .parse()
                .ok()
                .filter(|e| *e > 0.0 && *e < 0.5)
                .ok_or_else(|| format!("`eps={value}` must be a number between 0 and 0.5"))?;
        }
        "eps" => return Err("`eps` needs a leak tracing technique such as ltt-evsm".into()),
        "map" if technique.estimate != Estimate::None => {
            technique.map_size = Some(parse_map_size(value)?);
        }
        "map" => return Err("`map` needs a technique that draws a map".into()),
        _ => {
            let known: Vec<&str> = Technique::modifiers().iter().map(|m| m.0).collect();
            return Err(format!("unknown modifier `{modifier}`; known: {}", known.join(", ")));
        }
    }
    Ok(())
}

fn parse_map_size(text: &str) -> Result<u32, String> {
    text.parse()
        .ok()
        .filter(|s| (64..=MAX_MAP_SIZE).contains(s) && s % 64 == 0)
        .ok_or_else(|| format!("map size `{text}` must be a multiple of 64 from 64 to {MAX_MAP_SIZE}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_catalogued_id_parses_back_to_itself() {
        for (technique, _) in Technique::catalogue() {
            assert_eq!(technique.to_string().parse::<Technique>(), Ok(technique));
        }
    }

    #[test]
    fn modifiers_survive_a_round_trip() {
        for id in ["ltt-evsm:prefiltered:eps=0.02:map=1024", "vsm:prefiltered", "sm:map=512"] {
            assert_eq!(id.parse::<Technique>().unwrap().to_string(), id);
        }
    }

    #[test]
    fn nonsense_is_refused_with_a_remedy() {
        for id in ["", "ltt-sm", "ray:map=64", "sm:prefiltered", "ltt-vsm:eps=0.7", "vsm:map=100", "evsm:foo"]
        {
            assert!(id.parse::<Technique>().unwrap_err().problem.len() > 20, "{id}");
        }
    }
}
