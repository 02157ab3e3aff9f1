//! The ids that name techniques: a base, and modifiers behind colons, in any order.

use std::{fmt, str::FromStr};

use lt_mask::{Expansion, MAX_REFRESH, Pattern};
use lt_math::LTT_EPSILON;

use crate::{Doubt, Estimate, FarLevel, MapSource, MapTest, Removal, Resolve, Technique, TemporalMask};
use crate::{contradiction, technique::MAX_MAP_SIZE};

/// A technique id that means nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("technique `{id}`: {problem}")]
pub struct TechniqueError {
    /// What was typed.
    pub id: String,
    /// What is wrong and what would be right.
    pub problem: String,
}

impl fmt::Display for Technique {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.map_test() {
            None if self.resolve == Resolve::AliasFree => write!(f, "alias-free")?,
            None => write!(f, "ray")?,
            Some((test, source)) => {
                let prefix = match (self.doubt, self.mask) {
                    (Doubt::Ltt, None) => "ltt-",
                    (_, Some(_)) => "lt-",
                    _ => "",
                };
                write!(f, "{prefix}{}", test.id())?;
                if source == MapSource::Prefiltered {
                    write!(f, ":prefiltered")?;
                }
                if let Some(mask) = self.mask {
                    write_mask(f, &mask, &TemporalMask::recommended(test))?;
                }
                if !self.reuse {
                    write!(f, ":no-reuse")?;
                }
                self.cascades.write(&self.usual_cascades(), f)?;
            }
        }
        match self.resolve.modifier() {
            Some(modifier) if !(self.estimate == Estimate::None && self.resolve == Resolve::AliasFree) => {
                write!(f, ":{modifier}")?;
            }
            _ => {}
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

/// The modifiers that make `mask` of `default`.
fn write_mask(f: &mut fmt::Formatter<'_>, mask: &TemporalMask, default: &TemporalMask) -> fmt::Result {
    let mut base = *default;
    if mask.removal == Removal::Published {
        write!(f, ":published")?;
        base = TemporalMask { moving_pattern: Some(mask.pattern), ..base.published() };
    }
    if mask.removal == Removal::Never {
        write!(f, ":no-rr")?;
    }
    if !mask.expands {
        write!(f, ":no-er")?;
    }
    if let Some(rule) = mask.expansion.filter(|_| mask.expansion != base.expansion) {
        write!(f, ":expand={}", expansion_name(rule))?;
    }
    if mask.pattern != base.pattern {
        write!(f, ":pattern={}", pattern_name(mask.pattern))?;
    }
    if let Some(pattern) = mask.moving_pattern.filter(|_| mask.moving_pattern != base.moving_pattern) {
        write!(f, ":moving={}", pattern_name(pattern))?;
    }
    if mask.refresh > 0 {
        write!(f, ":refresh={}", mask.refresh)?;
    }
    match (mask.depth_test, base.depth_test) {
        (true, false) => write!(f, ":depth-test")?,
        (false, true) => write!(f, ":no-depth-test")?,
        _ => {}
    }
    if base.marks && !mask.marks { write!(f, ":no-marks") } else { Ok(()) }
}

/// Patterns by the names that ids use.
const PATTERNS: [(&str, Pattern); 8] = [
    ("3x3", Pattern::FULL_3X3),
    ("plus", Pattern::PLUS),
    ("cross", Pattern::CROSS),
    ("checkerboard", Pattern::CHECKERBOARD),
    ("alternating", Pattern::ALTERNATING),
    ("gather", Pattern::GATHER_2X2),
    ("5x5", Pattern::FULL_5X5),
    ("diamond", Pattern::DIAMOND),
];

fn pattern_name(pattern: Pattern) -> &'static str {
    PATTERNS.iter().find(|p| p.1 == pattern).map_or("3x3", |p| p.0)
}

fn parse_pattern(key: &str, name: &str) -> Result<Pattern, String> {
    let known: Vec<&str> = PATTERNS.iter().map(|p| p.0).collect();
    PATTERNS
        .iter()
        .find(|p| p.0 == name)
        .map(|p| p.1)
        .ok_or_else(|| format!("`{key}={name}`: no such pattern; known: {}", known.join(", ")))
}

/// Rules of expansion by the names that ids use.
const EXPANSIONS: [(&str, Expansion); 3] =
    [("published", Expansion::PUBLISHED), ("rays", Expansion::RAYS), ("leaks", Expansion::LEAKS)];

fn expansion_name(rule: Expansion) -> &'static str {
    EXPANSIONS.iter().find(|e| e.1 == rule).map_or("published", |e| e.0)
}

impl FromStr for Technique {
    type Err = TechniqueError;

    fn from_str(id: &str) -> Result<Self, TechniqueError> {
        let fail = |problem: String| TechniqueError { id: id.to_owned(), problem };
        let mut parts = id.split(':');
        let base = parts.next().unwrap_or_default();
        let mut technique = base_technique(base).ok_or_else(|| {
            let listed = Self::catalogue().into_iter().chain(Self::in_light_space());
            let known: Vec<String> =
                listed.map(|(t, _)| t.to_string()).filter(|id| !id.contains(':')).collect();
            fail(format!("no such base `{base}`; known: {}", known.join(", ")))
        })?;
        let mut modifiers: Vec<&str> = parts.collect();
        // In the order of the list, whatever the order of the id: some build on others (`published`, then the `pattern` of all).
        let keys = Self::modifiers().map(|m| contradiction::key(m.0));
        modifiers.sort_by_key(|word| (keys.iter().position(|key| *key == contradiction::key(word)), *word));
        let own_resolver = (base == "alias-free").then_some(base);
        let words: Vec<&str> = own_resolver.into_iter().chain(modifiers.iter().copied()).collect();
        if let Some(refusal) = contradiction::find(&words) {
            return Err(fail(refusal));
        }
        for modifier in modifiers {
            apply_modifier(&mut technique, modifier).map_err(&fail)?;
        }
        let cascades = &technique.cascades;
        if cascades.far == FarLevel::Rays && (cascades.count < 2 || technique.doubt == Doubt::Never) {
            return Err(fail(
                "`far=ray` needs rays (an ltt- or lt- technique) and at least cascades=2".into(),
            ));
        }
        Ok(technique)
    }
}

fn base_technique(base: &str) -> Option<Technique> {
    match base {
        "ray" => return Some(Technique::RAY),
        "alias-free" => return Some(Technique { resolve: Resolve::AliasFree, ..Technique::RAY }),
        _ => {}
    }
    type Make = fn(MapTest, MapSource) -> Technique;
    let kinds: [(&str, Make); 3] =
        [("ltt-", Technique::leak_tracing_test), ("lt-", Technique::leak_tracing), ("", Technique::map)];
    let (prefix, make) = kinds.into_iter().find(|k| base.starts_with(k.0))?;
    let test = MapTest::ALL.into_iter().find(|t| t.id() == &base[prefix.len()..])?;
    (prefix.is_empty() || test.is_filterable()).then(|| make(test, MapSource::Gather))
}

fn apply_modifier(technique: &mut Technique, modifier: &str) -> Result<(), String> {
    let (key, value) = modifier.split_once('=').unwrap_or((modifier, ""));
    if modifier.contains('=') && Technique::modifiers().iter().any(|m| m.0 == key) {
        return Err(format!("`{modifier}`: `{key}` takes no value"));
    }
    match key {
        "prefiltered" => match &mut technique.estimate {
            Estimate::Map { test, source } if test.is_filterable() => *source = MapSource::Prefiltered,
            _ => {
                return Err("`prefiltered` needs a filterable map: vsm, esm, evsm, msm, msm-hausdorff".into());
            }
        },
        "light" | "dac" | "space" | "alias-free" if technique.resolve.is_exact() => {
            technique.resolve = match key {
                "light" => Resolve::Light,
                "dac" => Resolve::DivideAndConquer,
                "space" => Resolve::LightSpace,
                _ => Resolve::AliasFree,
            };
        }
        "light" | "dac" | "space" | "alias-free" => {
            return Err(format!("`{key}` needs a technique that traces rays: ray, or ltt-evsm"));
        }
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
        "cascades" | "lambda" | "splits" | "far" if technique.estimate == Estimate::None => {
            return Err(format!("`{key}` needs a technique that draws a map"));
        }
        "no-reuse" if technique.estimate != Estimate::None => technique.reuse = false,
        "no-reuse" => return Err("`no-reuse` needs a technique that draws a map".into()),
        "no-rr" | "no-er" | "expand" | "published" | "pattern" | "moving" | "refresh" | "depth-test"
        | "no-depth-test" | "no-marks" => {
            let Some(mask) = &mut technique.mask else {
                return Err(format!("`{key}` needs a technique with a temporal mask, such as lt-evsm"));
            };
            match key {
                "no-rr" => mask.removal = Removal::Never,
                "no-er" => mask.expands = false,
                "published" => *mask = mask.published(),
                "expand" => {
                    let rule = EXPANSIONS.iter().find(|e| e.0 == value);
                    let known = EXPANSIONS.map(|e| e.0).join(", ");
                    let refusal = || format!("`expand={value}`: no such rule; known: {known}");
                    mask.expansion = Some(rule.ok_or_else(refusal)?.1);
                }
                "pattern" => {
                    mask.pattern = parse_pattern(key, value)?;
                    if mask.removal == Removal::Published {
                        mask.moving_pattern = Some(mask.pattern);
                    }
                }
                "moving" => mask.moving_pattern = Some(parse_pattern(key, value)?),
                "refresh" => {
                    let period = value.parse().ok().filter(|n| (2..=MAX_REFRESH).contains(n));
                    mask.refresh = period.ok_or_else(|| {
                        format!("`refresh={value}` must be a whole number of frames from 2 to {MAX_REFRESH}")
                    })?;
                }
                "no-marks" => mask.marks = false,
                _ => mask.depth_test = key == "depth-test",
            }
        }
        _ => {
            if let Some(result) = technique.cascades.apply(key, value) {
                return result;
            }
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
    fn every_listed_id_parses_back_to_itself() {
        for (technique, _) in Technique::catalogue().into_iter().chain(Technique::in_light_space()) {
            assert_eq!(technique.to_string().parse::<Technique>(), Ok(technique));
        }
    }

    #[test]
    fn an_unknown_base_names_those_that_are() {
        let problem = parse("foo", &[]).unwrap_err();
        assert!(["ray,", "lt-evsm,", "alias-free"].iter().all(|id| problem.contains(id)), "{problem}");
        assert!(!problem.contains("ray:"), "modifiers are none: {problem}");
    }

    #[test]
    fn modifiers_survive_a_round_trip() {
        for id in [
            "ltt-evsm:prefiltered:eps=0.02:map=1024",
            "vsm:prefiltered",
            "sm:no-reuse:map=512",
            "lt-evsm:no-rr:pattern=3x3:moving=5x5:depth-test",
            "lt-msm:prefiltered:no-er:pattern=plus:no-depth-test:no-reuse:eps=0.02",
            "lt-evsm:cascades=6:lambda=0.5:far=map",
            "ltt-vsm:splits=5/20/60.5",
            "ltt-evsm:cascades=1",
            "sm:cascades=3:map=512",
            "lt-esm:published",
            "lt-evsm:no-rr:refresh=16",
            "ray:light",
            "ray:dac",
            "ray:space",
            "alias-free",
            "ltt-vsm:alias-free",
            "lt-evsm:no-reuse:light:eps=0.02",
            "lt-esm:published:pattern=alternating:moving=cross",
            "lt-evsm:expand=rays:moving=3x3",
        ] {
            assert_eq!(id.parse::<Technique>().unwrap().to_string(), id);
        }
    }

    /// Every modifier, some with two meanings.
    const WORDS: [&str; 27] = [
        "prefiltered",
        "eps=0.1",
        "eps=0.2",
        "light",
        "dac",
        "space",
        "alias-free",
        "map=512",
        "cascades=2",
        "lambda=0.5",
        "splits=5/10",
        "far=map",
        "far=ray",
        "no-reuse",
        "no-rr",
        "no-er",
        "expand=published",
        "expand=rays",
        "published",
        "pattern=cross",
        "pattern=plus",
        "moving=diamond",
        "refresh=16",
        "depth-test",
        "no-depth-test",
        "moving=3x3",
        "foo",
    ];
    const BASES: [&str; 6] = ["ray", "alias-free", "sm", "vsm", "ltt-evsm", "lt-evsm"];

    fn parse(base: &str, words: &[&str]) -> Result<Technique, String> {
        let id: Vec<&str> = std::iter::once(base).chain(words.iter().copied()).collect();
        id.join(":").parse().map_err(|e: TechniqueError| e.problem)
    }

    /// Every set of one to three words, repeats among them.
    fn sets() -> impl Iterator<Item = Vec<&'static str>> {
        let one = |from: usize| WORDS[from..].iter().map(|w| vec![*w]);
        let more = |i: usize| (i..WORDS.len()).map(move |j| vec![WORDS[i], WORDS[j]]);
        let most = |i: usize| {
            (i..WORDS.len())
                .flat_map(move |j| (j..WORDS.len()).map(move |k| vec![WORDS[i], WORDS[j], WORDS[k]]))
        };
        one(0).chain((0..WORDS.len()).flat_map(move |i| more(i).chain(most(i))))
    }

    #[test]
    fn any_order_of_modifiers_means_the_same_or_is_refused_alike() {
        for base in BASES {
            for words in sets() {
                let meaning = parse(base, &words);
                for turn in 1..words.len() {
                    let mut other = words.clone();
                    other.rotate_left(turn);
                    assert_eq!(parse(base, &other), meaning, "{base} {words:?}");
                    other.reverse();
                    assert_eq!(parse(base, &other), meaning, "{base} {words:?}");
                }
            }
        }
    }

    #[test]
    fn every_modifier_of_an_accepted_id_counts() {
        for base in BASES {
            // What these bases do by themselves.
            let says_nothing = |word: &str| match word {
                "no-depth-test" | "far=ray" => true,
                _ => word == "far=map" && !base.starts_with('l'),
            };
            for words in sets().filter(|words| !words.iter().any(|w| says_nothing(w))) {
                let Ok(technique) = parse(base, &words) else { continue };
                assert_eq!(technique.to_string().parse(), Ok(technique), "{base} {words:?}");
                for left_out in 0..words.len() {
                    let mut fewer = words.clone();
                    fewer.remove(left_out);
                    assert_ne!(parse(base, &fewer), Ok(technique), "{base} {words:?} without {left_out}");
                }
            }
        }
    }

    #[test]
    fn contradictions_are_refused_by_both_names() {
        for (base, a, b) in [
            ("lt-evsm", "published", "expand=leaks"),
            ("lt-evsm", "no-rr", "published"),
            ("lt-evsm", "no-er", "expand=rays"),
            ("lt-evsm", "no-er", "no-rr"),
            ("ltt-evsm", "splits=5/10", "cascades=2"),
            ("ltt-evsm", "splits=5/10", "lambda=0.5"),
            ("ray", "light", "dac"),
            ("ltt-evsm", "alias-free", "light"),
            ("ltt-evsm", "eps=.1", "eps=.2"),
            ("lt-evsm", "depth-test", "no-depth-test"),
            ("lt-evsm", "no-rr", "no-rr"),
        ] {
            for words in [[a, b], [b, a]] {
                let problem = parse(base, &words).unwrap_err();
                assert!(
                    problem.contains(&format!("`{a}`")) && problem.contains(&format!("`{b}`")),
                    "{problem}"
                );
            }
        }
        assert!(parse("alias-free", &["light"]).unwrap_err().starts_with("`alias-free` and `light`"));
        assert!(parse("ltt-evsm", &["far=ray", "cascades=1"]).is_err());
        assert!(parse("lt-evsm", &["no-rr=no"]).unwrap_err().contains("takes no value"));
    }

    #[test]
    fn nonsense_is_refused_with_a_remedy() {
        for id in [
            "",
            "ltt-sm",
            "lt-pcf",
            "ray:map=64",
            "sm:prefiltered",
            "ltt-vsm:eps=0.7",
            "vsm:map=100",
            "evsm:foo",
            "ltt-evsm:no-rr",
            "lt-evsm:pattern=2x2",
            "lt-evsm:refresh=1",
            "lt-evsm:expand=all",
            "lt-evsm:published:expand=leaks",
            "ltt-evsm:expand=rays",
            "lt-evsm:refresh=257",
            "ltt-evsm:refresh=16",
            "lt-evsm:no-er:no-rr",
            "ray:no-reuse",
            "ray:cascades=2",
            "sm:cascades=0",
            "sm:cascades=17",
            "sm:cascades=2:far=ray",
            "ltt-evsm:cascades=1:far=ray",
            "ltt-evsm:cascades=2:far=sky",
            "sm:splits=5/5",
            "sm:splits=0",
            "sm:splits=1/x",
            "sm:lambda=2",
            "evsm:light",
            "sm:alias-free",
        ] {
            assert!(id.parse::<Technique>().unwrap_err().problem.len() > 20, "{id}");
        }
    }
}
