//! Fitting the levels of a directional light's map to slices of the view, and keeping those that still serve.
//!
//! A level's box is the smallest light-space box, of a few turns about the light's axis, of what is seen in its slice of the view: of some places
//! where that is known (sample distribution shadow maps, Lauritzen et al. 2011), else of all of the slice as far as the scene reaches. It lies on
//! a lattice of texels that outlives the camera's moves ([`snapped_interval`]). Its depths are those of all of the scene that lies above and
//! below it, so that casters behind the camera keep their shadows. What is seen and lies on no level, since nobody named it, is left to rays, or to
//! the last level where that has a map.

use lt_math::glam::Vec3;
use lt_math::{LightFrame, LightProjection, level_margin_uv, snapped_interval, split_depth};
use lt_scene::Bounds;
use lt_shaders::abi::CameraParams;

use crate::light_fit::{
    KEPT_GROWTH, KEPT_LOOSENESS, LightFit, casters_in_light, depth_margin, in_light, or_unit_box,
    region_in_column, visible_region,
};
use crate::{Cascades, FarLevel, Splits};

/// The first split at least, as a share of the last one's depth.
const NEAREST_SHARE: f32 = 1.0 / 512.0;

/// What part of the places that are seen may lie nearer than the depth from which slices are cut, and farther than the last of several levels with
/// rays behind them. Measured (`ltt-evsm`, 1920×1080, default levels) on street, town and square: with a share of .97, .99 and .995 on the
/// maps, .0347, .0277 and .0273 rays per pixel on street for 255, 311 and 389 wrong ppm; nearer ends from .001 to .02 differ by 2 %; this
/// one gives the first slice more than [`LOST_SHARE`].
const NEARER_SHARE: f32 = 0.02;
/// See [`NEARER_SHARE`].
const FARTHER_SHARE: f32 = 0.01;
/// Part of the places that are seen that a kept level may have lost, and a slice may have without a map: a farther level or rays answer there.
///
/// Of a slice's own places (0.01) the few in a thin one have it drawn again in every other frame: measured (`ltt-evsm`, 960×540, 32 frames), mean ms
/// and maps drawn with that, with 0.01 and with 0.02 of all: quaternius_trees.glb 6.6 (9), 1.4 (3), 1.7 (3); leaves_ao.glb 6.5 (6), 4.7 (5),
/// 3.5 (4); ratboy_hair.glb 12.0 (13), 6.3 (8), 2.8 (4). Rays and errors are the same to 5 %, as is everything on street, town and square.
const LOST_SHARE: f32 = 0.02;

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
    /// Some of the places that are seen, where what lies on no level is left to rays and any are known; else none.
    pub places: &'a [Vec3],
}

impl View<'_> {
    /// Depth along the view.
    fn depth(&self, place: Vec3) -> f32 {
        (place - self.camera.eye).dot(self.camera.forward)
    }

    /// What is seen between two view depths; nothing where that is too little for a map.
    fn slice(&self, scene: Bounds, [near, far]: [f32; 2]) -> Slice {
        if self.places.is_empty() {
            return Slice { points: visible_region(scene, self.camera, Some([near, far])), spare: 0 };
        }
        let is_here = |place: &&Vec3| (near..=far).contains(&self.depth(**place));
        let mut points: Vec<Vec3> = self.places.iter().filter(is_here).copied().collect();
        let spare = (self.places.len() as f32 * LOST_SHARE) as usize;
        // Too few for a map.
        if points.len() <= spare {
            points.clear();
        }
        Slice { points, spare }
    }

    /// The depths between which what is seen lies but for `nearer` and `farther`, shares of it; `None` where no places in front of the
    /// camera are known.
    fn seen_depths(&self, nearer: f32, farther: f32) -> Option<[f32; 2]> {
        let depths = self.places.iter().map(|p| self.depth(*p)).filter(|d| *d > 0.0 && d.is_finite());
        let mut depths: Vec<f32> = depths.collect();
        let last = depths.len().checked_sub(1)?;
        let [near, far] = [nearer, 1.0 - farther].map(|share| (last as f32 * share) as usize);
        let [near, far] = [near, far].map(|at| *depths.select_nth_unstable_by(at, f32::total_cmp).1);
        Some([near, far])
    }
}

/// What is seen between two view depths.
struct Slice {
    /// Corners of a region that holds it, or some of its places.
    points: Vec<Vec3>,
    /// How many of them a level may do without.
    spare: usize,
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
    let bounds = slice_bounds(view, scene, cascades);
    let mut levels = Levels { fits: Vec::new(), draws: Vec::new() };
    for (i, depths) in bounds.windows(2).take(cascades.maps() as usize).enumerate() {
        let is_known = !view.places.is_empty();
        // A last level with a map holds whatever the others have missed.
        let seen = match is_known && i as u32 + 1 == cascades.count {
            true => View { places: &[], ..view }.slice(scene, [0.0, depths[1]]),
            false => view.slice(scene, [depths[0], depths[1]]),
        };
        // Places are some of what is seen: there is more around them.
        let growth = if is_known { KEPT_GROWTH } else { growth };
        let fresh = fit_level(&frame, &seen.points, scene, growth, view.map_size);
        let fit = match kept.get(i) {
            Some(old) if serves(old, &fresh, &seen, view.map_size) => *old,
            _ => {
                // Nothing can ask a level with nothing in its slice.
                if !seen.points.is_empty() {
                    levels.draws.push(i as u32);
                }
                fresh
            }
        };
        levels.fits.push(fit);
    }
    levels
}

/// View depths where slices begin and end: by the depths that are seen, where they are known, else by those that the scene may have, which depend
/// on where the camera is and not on where it looks.
fn slice_bounds(view: View<'_>, scene: Bounds, cascades: &Cascades) -> Vec<f32> {
    let eye = view.camera.eye;
    let end = scene.corners().iter().map(|c| c.distance(eye)).fold(0.0, f32::max).max(f32::MIN_POSITIVE);
    let to_box = eye.clamp(scene.min, scene.max).distance(eye);
    let rays_behind = cascades.far == FarLevel::Rays;
    let seen = view.seen_depths(NEARER_SHARE, if rays_behind { FARTHER_SHARE } else { 0.0 });
    // What is seen ends where the maps do.
    let (near, far, slices) = match seen {
        Some([near, far]) => (near.min(far), far, cascades.maps()),
        None => (to_box, end, cascades.count),
    };
    let near = near.clamp(far * NEAREST_SHARE, far);
    let mut bounds = vec![0.0];
    for i in 1..cascades.count {
        bounds.push(match cascades.splits {
            Splits::Blend(blend) => split_depth(i, slices, near, far, blend),
            Splits::Depths(depths) => depths[i as usize - 1],
        });
    }
    bounds.push(end.max(bounds[bounds.len() - 1]));
    bounds
}

/// Turns about the light's axis that are tried, within a quarter; few, so that a level that is fitted anew mostly keeps its.
const TURNS: u32 = 8;

fn fit_level(frame: &LightFrame, seen: &[Vec3], scene: Bounds, growth: f32, map_size: u32) -> LightFit {
    if seen.is_empty() {
        let nowhere = LightProjection::orthographic(frame, Vec3::ZERO, Vec3::ZERO);
        return LightFit { projection: nowhere, extent_world: Vec3::ZERO, near: 0.0 };
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
    // As wide along both axes: a thin box is left by a small step, and has texels to spare across.
    let widest = (seen.max - seen.min).truncate().max_element();
    let margin = Vec3::splat(widest * growth * 0.5);
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
    LightFit {
        projection: LightProjection::orthographic(&frame, min, max),
        extent_world: max - min,
        near: 0.0,
    }
}

/// Whether a kept level still does what a fresh one would: it holds the slice and the footprints in it.
fn serves(old: &LightFit, fresh: &LightFit, seen: &Slice, map_size: u32) -> bool {
    let margin = level_margin_uv(map_size);
    let (extent, least) = (old.extent_world.truncate(), fresh.extent_world.truncate());
    let is_fine = seen.points.is_empty() || extent.max_element() <= least.max_element() * KEPT_LOOSENESS;
    let is_lost = |p: &&Vec3| !old.projection.project(**p).is_within(margin);
    is_fine && seen.points.iter().filter(is_lost).take(seen.spare + 1).count() <= seen.spare
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::LevelSource;
    use lt_math::glam::UVec2;

    const BOX: Bounds = Bounds { min: Vec3::new(-50.0, 0.0, -80.0), max: Vec3::new(50.0, 20.0, 80.0) };
    const SUN: Vec3 = Vec3::new(0.4, -1.0, 0.25);

    fn camera(eye: Vec3, forward: Vec3) -> CameraParams {
        let forward = forward.normalize();
        let right = forward.cross(Vec3::Y).normalize();
        CameraParams {
            eye,
            forward,
            right: right * 0.8,
            up: right.cross(forward) * 0.5,
            size: UVec2::new(16, 10),
            grid: UVec2::ONE,
            ..bytemuck::Zeroable::zeroed()
        }
    }

    fn view(camera: &CameraParams) -> View<'_> {
        View { scene: BOX, camera, direction: SUN, map_size: 512, places: &[] }
    }

    /// Points of the box that the camera sees, with their view depths.
    fn seen(camera: &CameraParams) -> Vec<(Vec3, f32)> {
        let grid = (0..30 * 12 * 30).map(|i| {
            let share = Vec3::new((i % 30) as f32, (i / 30 % 12) as f32, (i / 360) as f32)
                / Vec3::new(29.0, 11.0, 29.0);
            BOX.min + (BOX.max - BOX.min) * share
        });
        let is_seen = |p: &Vec3| {
            let d = *p - camera.eye;
            let z = d.dot(camera.forward);
            let inside = |axis: Vec3| d.dot(axis).abs() < z * axis.length_squared();
            z > 0.0 && inside(camera.right) && inside(camera.up)
        };
        grid.filter(is_seen).map(|p| (p, (p - camera.eye).dot(camera.forward))).collect()
    }

    fn projections(levels: &Levels) -> Vec<LightProjection> {
        levels.fits.iter().map(|f| f.projection).collect()
    }

    #[test]
    fn what_a_slice_shows_lies_on_its_level_or_a_finer_one() {
        for (eye, forward) in [
            (Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.1, -0.05, -1.0)),
            (Vec3::new(0.0, 300.0, 10.0), Vec3::new(0.01, -1.0, 0.02)),
            (Vec3::new(-200.0, 40.0, 0.0), Vec3::new(1.0, -0.2, 0.1)),
        ] {
            let camera = camera(eye, forward);
            for cascades in [Cascades::levels(1), Cascades::levels(4), Cascades::TRACED_FAR] {
                let levels = keep_levels(view(&camera), &cascades, &[]);
                let bounds = slice_bounds(view(&camera), BOX, &cascades);
                let projections = projections(&levels);
                let maps = lt_math::Levels { projections: &projections, count: cascades.maps() };
                let mut count = 0;
                for (p, z) in seen(&camera).into_iter().filter(|s| s.1 <= bounds[cascades.maps() as usize]) {
                    let found = maps.find(p, 512);
                    let slice =
                        bounds.windows(2).position(|b| z <= b[1]).expect("the last slice ends behind all");
                    assert!(found.point.is_inside && found.level as usize <= slice, "{p} at {z}: {found:?}");
                    count += 1;
                }
                assert!(count > 50 || eye.y > 100.0, "{count}");
            }
        }
    }

    #[test]
    fn all_that_can_shade_a_level_lies_beyond_its_near_plane() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.1, -0.05, -1.0));
        for fit in fit_levels(view(&camera), &Cascades::levels(4)).fits {
            for i in 0..40 * 10 * 40 {
                let share = Vec3::new((i % 40) as f32, (i / 40 % 10) as f32, (i / 400) as f32)
                    / Vec3::new(39.0, 9.0, 39.0);
                let point = fit.projection.project(BOX.min + (BOX.max - BOX.min) * share);
                let is_over =
                    point.uv.cmpge(Vec3::ZERO.truncate()).all() && point.uv.cmple(Vec3::ONE.truncate()).all();
                assert!(!is_over || point.is_inside, "{point:?}");
            }
        }
    }

    #[test]
    fn levels_are_kept_one_by_one() {
        let at = |x: f32| camera(Vec3::new(x, 2.0, 70.0), Vec3::new(0.1, -0.05, -1.0));
        let (first, near, far) = (at(0.0), at(3.0), at(25.0));
        let cascades = Cascades::levels(4);
        let start = keep_levels(view(&first), &cascades, &[]);
        assert_eq!(start.draws, [0, 1, 2, 3]);
        assert!(keep_levels(view(&first), &cascades, &start.fits).draws.is_empty());
        let after = keep_levels(view(&near), &cascades, &start.fits);
        assert!(after.draws.contains(&0) && !after.draws.contains(&3), "{:?}", after.draws);
        for i in 0..4u32 {
            assert_eq!(after.draws.contains(&i), after.fits[i as usize] != start.fits[i as usize]);
        }
        assert!(keep_levels(view(&far), &cascades, &start.fits).draws.len() > after.draws.len());
    }

    /// A street between two rows of houses: what the view may hold is much, what it shows is little.
    fn street() -> Vec<Vec3> {
        let across = |i: u32| Vec3::new((i % 11) as f32 * 0.8 - 4.0, (i / 11 % 5) as f32, 0.0);
        (0..11 * 5 * 60).map(|i| across(i) + Vec3::Z * (65.0 - (i / 55) as f32 * 2.0)).collect()
    }

    #[test]
    fn levels_are_fitted_to_places_that_are_seen() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.0, -0.05, -1.0));
        let places = street();
        let known = View { places: &places, ..view(&camera) };
        for cascades in [Cascades::levels(3), Cascades::TRACED_FAR] {
            let blind = keep_levels(view(&camera), &cascades, &[]);
            let levels = keep_levels(known, &cascades, &[]);
            assert_eq!(levels.draws, [0, 1, 2]);
            let area = |levels: &Levels| -> f32 {
                levels.fits.iter().take(2).map(|fit| fit.extent_world.truncate().element_product()).sum()
            };
            assert!(area(&levels) < area(&blind), "{} of {}", area(&levels), area(&blind));
            let projections = projections(&levels);
            let maps = lt_math::Levels { projections: &projections, count: cascades.maps() };
            let lost = places.iter().filter(|p| !maps.find(**p, 512).point.is_inside).count();
            let spare = if cascades.far == FarLevel::Rays { places.len() / 100 + 55 } else { 0 };
            assert!(lost <= spare, "{lost} of {} places on no level", places.len());
        }
    }

    #[test]
    fn a_kept_level_may_lose_a_fiftieth_of_what_is_seen() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.0, -0.05, -1.0));
        let places = street();
        let start = keep_levels(View { places: &places, ..view(&camera) }, &Cascades::TRACED_FAR, &[]);
        let with_balconies = |count: usize| {
            let balconies = (0..count).map(|i| Vec3::new(30.0, 15.0, 60.0 - 0.01 * i as f32));
            let places: Vec<Vec3> = places.iter().copied().chain(balconies).collect();
            let known = View { places: &places, ..view(&camera) };
            keep_levels(known, &Cascades::TRACED_FAR, &start.fits).draws
        };
        let spare = places.len() / 50;
        assert!(with_balconies(0).is_empty() && with_balconies(spare).is_empty());
        assert_eq!(with_balconies(spare * 2)[0], 0);
    }

    #[test]
    fn a_slice_with_a_fiftieth_of_what_is_seen_has_no_map() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.0, -0.05, -1.0));
        let cascades = Cascades { splits: Splits::Depths([20.0; 15]), ..Cascades::levels(2) };
        let draws = |near: usize| {
            let far = (0..980).map(|i| Vec3::new(0.0, 0.0, 40.0 - 0.1 * i as f32));
            let places: Vec<Vec3> =
                far.chain((0..near).map(|i| Vec3::new(0.0, 0.0, 60.0 - 0.1 * i as f32))).collect();
            keep_levels(View { places: &places, ..view(&camera) }, &cascades, &[]).draws
        };
        assert_eq!((draws(20), draws(40)), (vec![1], vec![0, 1]));
    }

    #[test]
    fn places_behind_the_camera_or_nowhere_leave_all_to_rays() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.0, -0.05, -1.0));
        for place in [Vec3::new(0.0, 2.0, 90.0), Vec3::NAN, Vec3::INFINITY] {
            let levels = keep_levels(View { places: &[place], ..view(&camera) }, &Cascades::TRACED_FAR, &[]);
            assert!(levels.draws.is_empty(), "{place}: {levels:?}");
            assert!(levels.fits.iter().all(|fit| !fit.projection.project(Vec3::ZERO).is_inside));
        }
    }

    #[test]
    fn finer_levels_come_first_and_a_slice_past_the_scene_has_no_map() {
        let camera = camera(Vec3::new(0.0, 2.0, 70.0), Vec3::new(0.0, -0.05, -1.0));
        let fits = fit_levels(view(&camera), &Cascades::levels(4)).fits;
        assert!(
            fits.windows(2).all(
                |w| w[0].extent_world.x * w[0].extent_world.y < w[1].extent_world.x * w[1].extent_world.y
            )
        );
        let past = Cascades { splits: Splits::Depths([1e5; 15]), ..Cascades::levels(2) };
        let levels = fit_levels(view(&camera), &past);
        assert_eq!(levels.draws, [0]);
        assert!(!levels.fits[1].projection.project(Vec3::ZERO).is_inside);
    }
}
