//! Parsers for the values of options: every one refuses what is not finite or out of range, and says what is right.

use lt_math::glam::{UVec2, Vec3};
use lt_render::{SampleGrid, Technique};

/// Most pixels of a picture: 8K.
const MAX_PIXELS: u64 = 7680 * 4320;
/// Longest side of a picture or a shadow map.
const MAX_SIDE: u32 = 16384;

/// A finite number.
pub fn finite(text: &str) -> Result<f32, String> {
    match text.trim().parse::<f32>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("must be a finite number such as 1.5".into()),
        Err(_) => Err("not a number; write it like 1.5 or -2e3".into()),
    }
}

/// A field of view in degrees, between 0 and 180.
pub fn degrees(text: &str) -> Result<f32, String> {
    finite(text).and_then(|d| match d > 0.0 && d < 180.0 {
        true => Ok(d),
        false => Err("must lie between 0 and 180 degrees, both excluded".into()),
    })
}

/// A speed in pixels per frame.
pub fn motion(text: &str) -> Result<f32, String> {
    finite(text).and_then(|m| match m > 0.0 && m <= 1000.0 {
        true => Ok(m),
        false => Err("must lie above 0 and at most 1000 pixels per frame; for none use --still".into()),
    })
}

/// LTT's ε.
pub fn epsilon(text: &str) -> Result<f32, String> {
    finite(text).and_then(|e| match e > 0.0 && e < 0.5 {
        true => Ok(e),
        false => Err("must lie between 0 and 0.5, both excluded".into()),
    })
}

/// Three finite numbers, `x,y,z`.
pub fn point(text: &str) -> Result<Vec3, String> {
    let parts: Vec<&str> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        return Err(format!("has {} number(s); write three with commas and no spaces: x,y,z", parts.len()));
    };
    Ok(Vec3::new(finite(x)?, finite(y)?, finite(z)?))
}

/// A direction `x,y,z` of any length but zero; returned with its largest component at ±1, which any later
/// normalisation survives.
pub fn direction(text: &str) -> Result<Vec3, String> {
    let v = point(text)?;
    match v.abs().max_element() {
        0.0 => Err("is zero; give the direction in which the light travels, such as -0.5,-1,-0.3".into()),
        // Two steps: a subnormal component has no finite reciprocal.
        largest => Ok(v / largest),
    }
}

/// A picture size, `WxH`.
pub fn size(text: &str) -> Result<UVec2, String> {
    let parsed = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let Some((width, height)) = parsed else {
        return Err("write it as WIDTHxHEIGHT, such as 1280x720".into());
    };
    let sides = 1..=MAX_SIDE;
    if !sides.contains(&width) || !sides.contains(&height) {
        return Err(format!("each side must be 1 to {MAX_SIDE} pixels"));
    }
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(format!("more than {MAX_PIXELS} pixels (7680x4320)"));
    }
    Ok(UVec2::new(width, height))
}

/// A number of samples per pixel.
pub fn samples(text: &str) -> Result<SampleGrid, String> {
    let count = text.parse().map_err(|_| "not a number of samples; write 1, 2, 4, 8, 16 or 32".to_owned())?;
    SampleGrid::of(count).map_err(|e| e.to_string())
}

/// A shadow map resolution.
pub fn map_size(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(size) if (64..=MAX_SIDE).contains(&size) && size.is_multiple_of(64) => Ok(size),
        _ => Err(format!("must be a multiple of 64 from 64 to {MAX_SIDE}")),
    }
}

/// A spot light's cone, half-angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Past which it does not shine.
    pub outer_deg: f32,
    /// Up to which it shines fully.
    pub inner_deg: f32,
}

/// A cone, `outer` or `outer,inner`; the inner one is five sixths of the outer one unless given.
pub fn cone(text: &str) -> Result<Cone, String> {
    let (outer, inner) = text.split_once(',').map_or((text, None), |(outer, inner)| (outer, Some(inner)));
    let outer_deg = finite(outer)?;
    let inner_deg = inner.map_or(Ok(outer_deg * 5.0 / 6.0), finite)?;
    match 0.0 <= inner_deg && inner_deg <= outer_deg && 0.0 < outer_deg && outer_deg < 90.0 {
        true => Ok(Cone { outer_deg, inner_deg }),
        false => Err("must be half-angles with 0 ≤ inner ≤ outer < 90 degrees, such as 30 or 30,20".into()),
    }
}

/// Which of a scene's lights shine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lights {
    /// Every one.
    All,
    /// These, at least one and no one twice.
    Some(Vec<usize>),
}

/// Lights, `all` or indices with commas.
pub fn lights(text: &str) -> Result<Lights, String> {
    if text == "all" {
        return Ok(Lights::All);
    }
    let mut indices = Vec::new();
    for word in text.split(',') {
        let index = word.parse().map_err(|_| "write indices with commas, such as 0,2; or all".to_owned())?;
        if indices.contains(&index) {
            return Err(format!("names {index} twice"));
        }
        indices.push(index);
    }
    Ok(Lights::Some(indices))
}

/// A distance above 0.
pub fn range(text: &str) -> Result<f32, String> {
    finite(text).and_then(|r| if r > 0.0 { Ok(r) } else { Err("must lie above 0".into()) })
}

/// A ground square: its height and, unless it should fit the scene, half its side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Height, scene units.
    pub y: f32,
    /// Half the side, scene units.
    pub half_size: Option<f32>,
}

/// A ground square, `y` or `y,half`.
pub fn ground(text: &str) -> Result<Ground, String> {
    let Some((y, half)) = text.split_once(',') else {
        return Ok(Ground { y: finite(text)?, half_size: None });
    };
    match finite(half)? {
        half if half > 0.0 => Ok(Ground { y: finite(y)?, half_size: Some(half) }),
        _ => Err("half the ground's side must be above 0".into()),
    }
}

/// A technique as typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypedTechnique {
    /// What it means.
    pub technique: Technique,
    /// Whether the id itself sets ε.
    pub sets_epsilon: bool,
    /// Whether the id itself says how many levels its map has.
    pub sets_cascades: bool,
}

/// What options say about techniques whose ids leave it open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Defaults {
    /// LTT's ε.
    pub epsilon: Option<f32>,
    /// Levels of a directional light's map.
    pub cascades: Option<u32>,
}

impl TypedTechnique {
    /// The technique, with what its id leaves open. Ids without a doubt test have no ε, those without a map no levels.
    pub fn with(self, defaults: Defaults) -> Technique {
        let mut technique = self.technique;
        if let Some(epsilon) = defaults.epsilon
            && technique.doubt == lt_render::Doubt::Ltt
            && !self.sets_epsilon
        {
            technique.epsilon = epsilon;
        }
        if let Some(count) = defaults.cascades
            && technique.map_test().is_some()
            && !self.sets_cascades
        {
            technique.cascades = technique.cascades.with_count(count);
        }
        technique
    }
}

impl From<Technique> for TypedTechnique {
    fn from(technique: Technique) -> Self {
        Self { technique, sets_epsilon: false, sets_cascades: false }
    }
}

/// A technique id.
pub fn technique(text: &str) -> Result<TypedTechnique, String> {
    let technique =
        text.trim().parse::<Technique>().map_err(|e| format!("{}; see `lt compare --list`", e.problem))?;
    Ok(TypedTechnique {
        technique,
        sets_epsilon: text.contains(":eps="),
        sets_cascades: text.contains(":cascades=") || text.contains(":splits="),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        for text in ["nan", "inf", "-inf", "1e99", "", "x", "1,2"] {
            assert!(finite(text).is_err(), "{text}");
            assert!(point(&format!("1,{text},2")).is_err(), "{text}");
        }
        assert_eq!(finite("-2.5"), Ok(-2.5));
    }

    #[test]
    fn ranges_hold() {
        assert!(degrees("0").is_err() && degrees("180").is_err() && degrees("60") == Ok(60.0));
        assert!(epsilon("0").is_err() && epsilon("0.5").is_err() && epsilon("0.01") == Ok(0.01));
    }

    #[test]
    fn points_have_three_numbers() {
        assert_eq!(point("1,-2,3.5"), Ok(Vec3::new(1.0, -2.0, 3.5)));
        assert!(point("1,2").is_err() && point("1,2,3,4").is_err() && point("").is_err());
    }

    #[test]
    fn directions_of_any_length_survive() {
        for text in ["0,-1,0", "0,-1e38,0", "0,-1e-40,0", "0,-3e-45,0"] {
            assert_eq!(direction(text), Ok(Vec3::new(0.0, -1.0, 0.0)), "{text}");
        }
        assert!(direction("0,-0,0").is_err());
    }

    #[test]
    fn cones_are_ordered_and_below_a_right_angle() {
        assert_eq!(cone("30"), Ok(Cone { outer_deg: 30.0, inner_deg: 25.0 }));
        assert_eq!(cone("30,0"), Ok(Cone { outer_deg: 30.0, inner_deg: 0.0 }));
        for text in ["0", "90", "30,31", "30,-1", "x", "30,x", ""] {
            assert!(cone(text).is_err(), "{text}");
        }
        assert!(range("0").is_err() && range("-1").is_err() && range("2") == Ok(2.0));
    }

    #[test]
    fn lights_are_indices_or_all() {
        assert_eq!((lights("all"), lights("3,0")), (Ok(Lights::All), Ok(Lights::Some(vec![3, 0]))));
        assert!(["", "x", "1,", "-1", "1,1"].into_iter().all(|text| lights(text).is_err()));
    }

    #[test]
    fn sizes_are_bounded() {
        assert_eq!(size("1280x720"), Ok(UVec2::new(1280, 720)));
        for text in ["0x5", "5x0", "16385x1", "16384x16384", "12", "x", "-1x5", "99999999999x1"] {
            assert!(size(text).is_err(), "{text}");
        }
    }

    #[test]
    fn map_sizes_are_multiples_of_64() {
        assert_eq!((map_size("64"), map_size("16384")), (Ok(64), Ok(16384)));
        assert!(["0", "100", "16448", "-64", "x"].into_iter().all(|text| map_size(text).is_err()));
    }

    #[test]
    fn grounds_may_leave_their_size_open() {
        assert_eq!(ground("-1"), Ok(Ground { y: -1.0, half_size: None }));
        assert_eq!(ground("-1,20"), Ok(Ground { y: -1.0, half_size: Some(20.0) }));
        assert!(ground("0,0").is_err() && ground("0,-1").is_err() && ground("0,1,2").is_err());
    }

    #[test]
    fn options_fill_only_what_an_id_leaves_open() {
        let defaults = Defaults { epsilon: Some(0.2), cascades: Some(3) };
        let with = |id: &str| technique(id).unwrap().with(defaults);
        assert_eq!(with("ltt-evsm").epsilon, 0.2);
        assert_eq!(with("ltt-evsm:eps=0.01").epsilon, 0.01);
        assert_eq!(with("ltt-evsm:splits=2:eps=0.01").cascades.count, 2);
        assert_eq!(with("vsm").to_string(), "vsm:cascades=3");
        assert_eq!(with("ray"), Technique::RAY);
    }
}
