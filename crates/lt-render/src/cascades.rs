//! How a directional light's map is cut into levels: as data, and as the modifiers of a technique's id.

use std::fmt;

use lt_math::DEFAULT_SPLIT_BLEND;

/// Levels that one light may have.
pub const MAX_LEVELS: u32 = 16;

/// Where one level ends and the next begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Splits {
    /// Between logarithmic and linear: the share of the logarithmic, in \[0, 1\]; see [`lt_math::split_depth`].
    Blend(f32),
    /// View depths, ascending; the first `count − 1` are used.
    Depths([f32; MAX_LEVELS as usize - 1]),
}

/// What answers in the last level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FarLevel {
    /// A map like the others.
    Map,
    /// Rays: it has no map, and what lies in no other level is doubted.
    Rays,
}

/// The levels of a directional light's map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cascades {
    /// Levels, the last included; 1 is one map for all that the camera sees.
    pub count: u32,
    /// Where they are cut.
    pub splits: Splits,
    /// What answers in the last.
    pub far: FarLevel,
}

impl Cascades {
    /// One map.
    pub const ONE: Self = Self::levels(1);

    /// This many levels, every one with a map, cut by the usual blend.
    pub const fn levels(count: u32) -> Self {
        Self { count, splits: Splits::Blend(DEFAULT_SPLIT_BLEND), far: FarLevel::Map }
    }

    /// What leaves least to rays for three maps' cost, as in Kern et al. 2024: four levels, the last one traced.
    pub const TRACED_FAR: Self = Self { far: FarLevel::Rays, ..Self::levels(4) };

    /// The same with this many levels; one level is one map.
    pub fn with_count(self, count: u32) -> Self {
        let far = if count == 1 { FarLevel::Map } else { self.far };
        let splits = match self.splits {
            Splits::Depths(_) => Splits::Blend(DEFAULT_SPLIT_BLEND),
            blend => blend,
        };
        Self { count, far, splits }
    }

    /// How many maps are drawn.
    pub fn maps(&self) -> u32 {
        match self.far {
            FarLevel::Map => self.count,
            FarLevel::Rays => self.count - 1,
        }
    }

    /// Takes one modifier of a technique's id, without its colon. `None` if it is not about cascades.
    pub(crate) fn apply(&mut self, key: &str, value: &str) -> Option<Result<(), String>> {
        Some(match key {
            "cascades" => parse_count(value)
                .map(|count| *self = self.with_count(count))
                .map_err(|problem| format!("`cascades={value}` {problem}")),
            "lambda" => number(value, 0.0..=1.0)
                .map(|blend| self.splits = Splits::Blend(blend))
                .ok_or_else(|| format!("`lambda={value}` must be a number from 0 to 1")),
            "splits" => parse_depths(value).map(|(depths, count)| {
                self.splits = Splits::Depths(depths);
                self.count = count;
            }),
            "far" => match value {
                "map" => {
                    self.far = FarLevel::Map;
                    Ok(())
                }
                "ray" => {
                    self.far = FarLevel::Rays;
                    Ok(())
                }
                _ => Err(format!("`far={value}` must be map or ray")),
            },
            _ => return None,
        })
    }

    /// Writes the modifiers that tell these cascades from `usual`.
    pub(crate) fn write(&self, usual: &Self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.splits {
            Splits::Depths(depths) => {
                let words: Vec<String> =
                    depths[..self.count as usize - 1].iter().map(f32::to_string).collect();
                write!(f, ":splits={}", words.join("/"))?;
            }
            Splits::Blend(blend) => {
                if self.count != usual.count {
                    write!(f, ":cascades={}", self.count)?;
                }
                if self.splits != usual.splits {
                    write!(f, ":lambda={blend}")?;
                }
            }
        }
        // One level is one map in any case.
        if self.far != usual.far && self.count > 1 {
            write!(f, ":far={}", if self.far == FarLevel::Map { "map" } else { "ray" })?;
        }
        Ok(())
    }
}

/// A number of levels.
///
/// # Errors
/// In words, what would be right.
pub fn parse_count(text: &str) -> Result<u32, String> {
    text.parse()
        .ok()
        .filter(|n| (1..=MAX_LEVELS).contains(n))
        .ok_or_else(|| format!("must be a whole number of levels from 1 to {MAX_LEVELS}"))
}

fn number(text: &str, range: std::ops::RangeInclusive<f32>) -> Option<f32> {
    text.parse().ok().filter(|x| range.contains(x))
}

/// Ascending view depths with slashes between; also how many levels they make.
fn parse_depths(text: &str) -> Result<([f32; MAX_LEVELS as usize - 1], u32), String> {
    let problem = || {
        format!("`splits={text}` must be 1 to {} ascending depths above 0: splits=5/20/60", MAX_LEVELS - 1)
    };
    let numbers: Option<Vec<f32>> = text.split('/').map(|word| number(word, 0.0..=1e30)).collect();
    let numbers = numbers.ok_or_else(problem)?;
    let mut depths = [0.0; MAX_LEVELS as usize - 1];
    let is_ascending = numbers[0] > 0.0 && numbers.windows(2).all(|w| w[0] < w[1]);
    if !is_ascending || numbers.len() > depths.len() {
        return Err(problem());
    }
    depths[..numbers.len()].copy_from_slice(&numbers);
    Ok((depths, numbers.len() as u32 + 1))
}
