//! Fitting the levels of a directional light's map to slices of the view, and keeping those that still serve.
//!
//! A level's box is the smallest light-space box, of a few turns about the light's axis, of its slice of the view as far as
//! the scene reaches. It lies on a lattice of texels that outlives the camera's moves ([`snapped_interval`]). Its depths are
//! those of all of the scene that lies above and below it, so that casters behind the camera keep their shadows.

use lt_math::glam::Vec3;
use lt_math::{LightFrame, LightProjection, level_margin_uv, snapped_interval, split_depth};
use lt_scene::Bounds;
use lt_shaders::abi::CameraParams;

use crate::light_fit::{
    KEPT_GROWTH, KEPT_LOOSENESS, LightFit, casters_in_light, depth_margin, in_light, or_unit_box,
    region_in_column, visible_region,
};
use crate::{Cascades, Splits};

/// The first split at least, as a share of the last one's depth.
const NEAREST_SHARE: f32 = 1.0 / 512.0;

/// What levels are fitted to.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// The scene's box.
    pub scene: Bounds,
    /// Who looks.
    pub camera: &'a CameraParams,
    /// The way light travels.
    pub direction: Vec3,
    /// Texels along a map's side.
    pub map_size: u32,
}

/// The levels of a frame, finest first, and which of them must be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    /// Where every level looks.
    pub fits: Vec<LightFit>,
    /// Levels whose maps must be drawn, ascending.
    pub draws: Vec<u32>,
}

/// Fits the maps of `cascades` to a view, for this frame alone.
pub fn fit_levels(view: View<'_>, cascades: &Cascades) -> Levels {
    levels_with(view, cascades, 0.0, &[])
}

/// Fits maps that are to be kept: boxes grown by [`KEPT_GROWTH`]; a level of `kept` stays while it covers its slice and is
/// not much coarser than a new one would be.
pub fn keep_levels(view: View<'_>, cascades: &Cascades, kept: &[LightFit]) -> Levels {
    levels_with(view, cascades, KEPT_GROWTH, kept)
}

fn levels_with(view: View<'_>, cascades: &Cascades, growth: f32, kept: &[LightFit]) -> Levels {
    let scene = or_unit_box(view.scene);
    let frame = LightFrame::from_direction(view.direction);
    let bounds = slice_bounds(scene, view.camera.eye, cascades);
    let mut levels = Levels { fits: Vec::new(), draws: Vec::new() };
    for (i, slice) in bounds.windows(2).take(cascades.maps() as usize).enumerate() {
        let seen = visible_region(scene, view.camera, Some([slice[0], slice[1]]));
        let fresh = fit_level(&frame, &seen, scene, growth, view.map_size);
        let fit = match kept.get(i) {
            Some(old) if serves(old, &fresh, &seen, view.map_size) => *old,
            _ => {
                // Nothing can ask a level with nothing in its slice.
                if !seen.is_empty() {
                    levels.draws.push(i as u32);
                }
                fresh
            }
        };
        levels.fits.push(fit);
    }
    levels
}

/// View depths where slices begin and end. They depend on where the camera is, not on where it looks.
fn slice_bounds(scene: Bounds, eye: Vec3, cascades: &Cascades) -> Vec<f32> {
    let far = scene.corners().iter().map(|c| c.distance(eye)).fold(0.0, f32::max).max(f32::MIN_POSITIVE);
    let to_box = eye.clamp(scene.min, scene.max).distance(eye);
    let near = to_box.clamp(far * NEAREST_SHARE, far);
    let mut bounds = vec![0.0];
    for i in 1..cascades.count {
        bounds.push(match cascades.splits {
            Splits::Blend(blend) => split_depth(i, cascades.count, near, far, blend),
            Splits::Depths(depths) => depths[i as usize - 1],
        });
    }
    bounds.push(far.max(bounds[bounds.len() - 1]));
    bounds
}

/// Turns about the light's axis that are tried, within a quarter; few, so that a level that is fitted anew mostly keeps its.
const TURNS: u32 = 8;

fn fit_level(frame: &LightFrame, seen: &[Vec3], scene: Bounds, growth: f32, map_size: u32) -> LightFit {
    if seen.is_empty() {
        let nowhere = LightProjection::orthographic(frame, Vec3::ZERO, Vec3::ZERO);
        return LightFit { projection: nowhere, extent_world: Vec3::ZERO };
    }
    let area = |b: &Bounds| (b.max - b.min).truncate().element_product();
    let turned = |i: u32| {
        let frame = frame.rolled(i as f32 * std::f32::consts::FRAC_PI_2 / TURNS as f32);
        (in_light(&frame, seen), frame)
    };
    let (seen, frame) = (1..TURNS)
        .map(turned)
        .fold(turned(0), |best, next| if area(&next.0) < area(&best.0) { next } else { best });
    let casters = casters_in_light(scene, &frame);
    let margin = (seen.max - seen.min) * (growth * 0.5);
    // Nothing lies outside the scene: growing past it would waste texels.
    let (min, max) = ((seen.min - margin).max(casters.min), (seen.max + margin).min(casters.max));
    // A slice may touch the scene's box in a point or an edge.
    let least = (casters.max - casters.min).max_element() * 1e-5;
    let across = |axis: usize| {
        let middle = (min[axis] + max[axis]) * 0.5;
        let half = ((max[axis] - min[axis]) * 0.5).max(least);
        snapped_interval(middle - half, middle + half, 0.0, map_size)
    };
    let (x, y) = (across(0), across(1));
    let column = in_light(&frame, &region_in_column(scene, &frame, x, y));
    let depths = if column.is_empty() { casters } else { column };
    let margin = depth_margin(depths);
    let (min, max) = (Vec3::new(x.0, y.0, depths.min.z - margin), Vec3::new(x.1, y.1, depths.max.z + margin));
    LightFit { projection: LightProjection::orthographic(&frame, min, max), extent_world: max - min }
}

/// Whether a kept level still does what a fresh one would: it holds the slice and the footprints in it.
fn serves(old: &LightFit, fresh: &LightFit, seen: &[Vec3], map_size: u32) -> bool {
    let margin = level_margin_uv(map_size);
    let (extent, least) = (old.extent_world.truncate(), fresh.extent_world.truncate());
    let is_fine = seen.is_empty() || extent.max_element() <= least.max_element() * KEPT_LOOSENESS;
    is_fine && seen.iter().all(|&p| old.projection.project(p).is_within(margin))
}
