//! Spot and point lights: what kernels need of them, and their maps.
//!
//! A point light has a map for every face of a cube, a spot light one for its cone, or the cube's where the cone is so wide
//! that one map would waste its texels. These maps look the same way whatever the camera does.

use lt_math::glam::Vec3;
use lt_math::{LightFrame, LightProjection};
use lt_scene::{Bounds, Light, LightKind};
use lt_shaders::abi::LightParams;

use crate::LightFit;
use crate::levels::Levels;
use crate::light_fit::{KEPT_LOOSENESS, or_unit_box};

/// Faces of a cube.
const FACES: u32 = 6;
/// Half-angle up to which a spot light has one map, radians: at 60° a texel at the edge is 4 times as large as in the middle.
const WIDEST_CONE_RAD: f32 = 1.05;
/// Texels outside a face or cone on each side, so that footprints at its edge find all of theirs.
const BORDER_TEXELS: u32 = 2;
/// Least distance that a map draws, as a share of the largest.
pub(crate) const NEAR_SHARE: f32 = 1e-6;
/// Stands for an unlimited range, squared.
const UNLIMITED: f32 = 3.0e38;

/// How many maps a light has besides the levels of a directional one; `None` for that.
pub(crate) fn lamp_maps(light: &LightKind) -> Option<u32> {
    match *light {
        LightKind::Directional { .. } => None,
        LightKind::Spot { outer_cone_rad, .. } if outer_cone_rad <= WIDEST_CONE_RAD => Some(1),
        LightKind::Spot { .. } | LightKind::Point { .. } => Some(FACES),
    }
}

/// Turn of a light between two frames, radians, up to which it counts as moving; further is a jump, after which what its rays
/// found before says nothing any more, and every pixel is traced anew. See docs/results/leak-tracing.md.
pub const LIGHT_JUMP_RAD: f32 = 0.035;

/// What became of a light since the last frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightChange {
    /// It is not what it was.
    pub has_moved: bool,
    /// So much that its history is worth nothing.
    pub is_jump: bool,
}

/// Whether a light changed by more than a slow motion: it turned by more than [`LIGHT_JUMP_RAD`] about itself or, seen from the
/// usual distance of what it shines on, about that; or it became another light.
pub(crate) fn is_jump(before: &LightKind, now: &LightKind, usual_distance: impl Fn(Vec3) -> f32) -> bool {
    let turns = |a: Vec3, b: Vec3| a.angle_between(b) > LIGHT_JUMP_RAD;
    let goes = |a: Vec3, b: Vec3| a != b && a.distance(b) > LIGHT_JUMP_RAD * usual_distance(b);
    match (*before, *now) {
        (LightKind::Directional { direction: a }, LightKind::Directional { direction: b }) => turns(a, b),
        (LightKind::Point { position: a, range }, LightKind::Point { position: b, range: range_now }) => {
            range != range_now || goes(a, b)
        }
        (
            LightKind::Spot { position: a, direction: axis, inner_cone_rad: _, outer_cone_rad, range },
            LightKind::Spot {
                position: b,
                direction: axis_now,
                inner_cone_rad: _,
                outer_cone_rad: outer_now,
                range: range_now,
            },
        ) => range != range_now || outer_cone_rad != outer_now || turns(axis, axis_now) || goes(a, b),
        _ => true,
    }
}

/// Light number `number` of `count`, for kernels.
pub(crate) fn light_params_of(light: &Light, number: u32, count: u32) -> LightParams {
    LightParams { number, mask_words: lt_mask::words_for_lights(count), ..light_params(light) }
}

/// A frame's only light, for kernels.
fn light_params(light: &Light) -> LightParams {
    let squared = |range: f32| (range * range).min(UNLIMITED);
    match light.kind {
        LightKind::Directional { direction } => LightParams::directional(-direction.normalize()),
        LightKind::Point { position, range } => LightParams {
            place: position.extend(1.0),
            range_squared: squared(range),
            ..LightParams::directional(Vec3::ZERO)
        },
        LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, range } => LightParams {
            place: position.extend(1.0),
            axis: direction.normalize(),
            cos_outer: outer_cone_rad.cos(),
            range_squared: squared(range),
            cos_inner: inner_cone_rad.cos(),
            ..LightParams::directional(Vec3::ZERO)
        },
    }
}

/// The maps of a spot or point light. Those of `kept` (of the same light) stay while they reach as far as the scene and not
/// much further; the others must be drawn, except where there is no scene to see.
pub(crate) fn lamp_levels(light: &LightKind, scene: Bounds, map_size: u32, kept: &[LightFit]) -> Levels {
    let mut levels = Levels { fits: Vec::new(), draws: Vec::new() };
    for (i, fresh) in fits(light, or_unit_box(scene), map_size).into_iter().enumerate() {
        let (least, most) = (fresh.extent_world.z, fresh.extent_world.z * KEPT_LOOSENESS);
        let still_serves = |old: &&LightFit| (least..=most).contains(&old.extent_world.z);
        let old = kept.get(i).filter(still_serves);
        if old.is_none() && fresh.near > 0.0 {
            levels.draws.push(i as u32);
        }
        levels.fits.push(old.copied().unwrap_or(fresh));
    }
    levels
}

fn fits(light: &LightKind, scene: Bounds, map_size: u32) -> Vec<LightFit> {
    let cube = |eye, range| {
        let face = |i| (LightFrame::of_cube_face(i), std::f32::consts::FRAC_PI_4);
        (0..FACES).map(face).map(|(frame, cone)| fit(eye, &frame, cone, range, scene, map_size)).collect()
    };
    match *light {
        LightKind::Directional { .. } => Vec::new(),
        LightKind::Point { position, range } => cube(position, range),
        LightKind::Spot { position, range, .. } if lamp_maps(light) == Some(FACES) => cube(position, range),
        LightKind::Spot { position, direction, outer_cone_rad, range, .. } => {
            let frame = LightFrame::from_direction(direction);
            vec![fit(position, &frame, outer_cone_rad, range, scene, map_size)]
        }
    }
}

fn fit(eye: Vec3, frame: &LightFrame, cone_rad: f32, range: f32, scene: Bounds, map_size: u32) -> LightFit {
    let farthest = scene.corners().iter().map(|c| frame.forward.dot(*c - eye)).fold(0.0, f32::max);
    // A little further, so that rounding leaves nothing of the scene behind.
    let far = (farthest * 1.001).min(range);
    if far <= 0.0 {
        let nowhere = LightProjection::orthographic(frame, Vec3::ZERO, Vec3::ZERO);
        return LightFit { projection: nowhere, extent_world: Vec3::ZERO, near: 0.0 };
    }
    let projection = LightProjection::bordered(eye, frame, cone_rad, (BORDER_TEXELS, map_size), 0.0, far);
    let width = 2.0 * far * cone_rad.tan();
    LightFit { projection, extent_world: Vec3::new(width, width, far), near: far * NEAR_SHARE }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::{LevelSource, Levels as Maps};

    const ROOM: Bounds = Bounds { min: Vec3::splat(-5.0), max: Vec3::splat(5.0) };

    #[test]
    fn all_that_a_light_reaches_lies_on_one_of_its_maps() {
        let eye = Vec3::new(1.0, 2.0, -3.0);
        let spot = |degrees: f32| LightKind::Spot {
            position: eye,
            direction: Vec3::new(0.2, -1.0, 0.3).normalize(),
            inner_cone_rad: 0.0,
            outer_cone_rad: degrees.to_radians(),
            range: 9.0,
        };
        let point = LightKind::Point { position: eye, range: f32::INFINITY };
        for (kind, maps) in [(point, 6), (spot(10.0), 1), (spot(59.0), 1), (spot(80.0), 6)] {
            let light = Light { name: String::new(), kind, color: Vec3::ONE, intensity: 1.0 };
            let params = light_params(&light);
            let levels = lamp_levels(&kind, ROOM, 128, &[]);
            assert_eq!((levels.fits.len(), lamp_maps(&kind)), (maps, Some(maps as u32)));
            let projections: Vec<_> = levels.fits.iter().map(|f| f.projection).collect();
            let all = Maps { projections: &projections, count: maps as u32 };
            let mut reached = 0;
            for i in 0..21 * 21 * 21 {
                let p = Vec3::new((i % 21) as f32, (i / 21 % 21) as f32, (i / 441) as f32) * 0.5 - 5.0;
                if p != eye && lt_shaders::evaluate::reaches(eye - p, &params) {
                    reached += 1;
                    assert!(all.find(p, 128).point.is_inside, "{p} {kind:?}");
                }
            }
            assert!(reached > 20, "{reached}");
            assert!(lamp_levels(&kind, ROOM, 128, &levels.fits).draws.is_empty(), "kept");
        }
    }

    #[test]
    fn faces_that_look_away_from_everything_are_not_drawn() {
        let beside = LightKind::Point { position: Vec3::new(20.0, 0.0, 0.0), range: f32::INFINITY };
        let levels = lamp_levels(&beside, ROOM, 128, &[]);
        assert!(!levels.draws.contains(&0) && levels.draws.contains(&1), "{:?}", levels.draws);
        let short = LightKind::Point { position: Vec3::ZERO, range: 2.0 };
        assert!(lamp_levels(&short, ROOM, 128, &[]).fits.iter().all(|f| f.extent_world.z == 2.0));
    }
}
