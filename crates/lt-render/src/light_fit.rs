//! Fitting a directional light's map to what the camera can see of the scene.
//!
//! Receivers are the part of the scene's box inside the view pyramid; the map's sides and far plane enclose them. The
//! near plane encloses the whole scene, so that casters behind the camera keep their shadows.

use lt_math::glam::{Vec3, Vec3Swizzles};
use lt_math::{LightFrame, LightProjection};
use lt_scene::Bounds;
use lt_shaders::abi::CameraParams;

/// Where a light's map looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightFit {
    /// World to map.
    pub projection: LightProjection,
    /// World size of the map along its x and y, and of its depth range; of perspective maps at their far end.
    pub extent_world: Vec3,
    /// Least distance along the axis of a spot or point light that is drawn; 0 for directional lights.
    pub near: f32,
}

/// Texels of margin on each side: a footprint at the border still finds its neighbours.
const MARGIN_TEXELS: f32 = 2.0;
/// Part of the depth range added at each end, so that no caster is clipped by rounding.
const DEPTH_MARGIN: f32 = 1e-3;

/// How much wider than what the camera sees a map is fitted that is to be kept (Kern et al. 2024: 15 %).
pub const KEPT_GROWTH: f32 = 0.15;
/// A kept map is given up once it is this much wider than a new one would be: its texels are too coarse by then.
pub(crate) const KEPT_LOOSENESS: f32 = 1.5;

/// Fits a map of `map_size`² texels to a light travelling along `direction`.
///
/// A camera that sees nothing of the scene gets the whole scene; an empty scene gets a unit box.
pub fn fit_directional(scene: Bounds, camera: &CameraParams, direction: Vec3, map_size: u32) -> LightFit {
    let frame = LightFrame::from_direction(direction);
    fit_box(&frame, receivers_in_light(scene, camera, &frame), casters_in_light(scene, &frame), map_size)
}

/// [`fit_directional`] with a box grown by [`KEPT_GROWTH`], for a map that is kept while [`LightFit::serves`].
pub fn fit_kept(scene: Bounds, camera: &CameraParams, direction: Vec3, map_size: u32) -> LightFit {
    let frame = LightFrame::from_direction(direction);
    let seen = receivers_in_light(scene, camera, &frame);
    let margin = (seen.max - seen.min) * (KEPT_GROWTH * 0.5);
    let casters = casters_in_light(scene, &frame);
    // Nothing lies outside the scene: growing past it would waste texels.
    let grown =
        Bounds { min: (seen.min - margin).max(casters.min), max: (seen.max + margin).min(casters.max) };
    fit_box(&frame, grown, casters, map_size)
}

impl LightFit {
    /// Whether a map drawn for this fit still serves a camera: it covers all that the camera sees, and is not much coarser
    /// than a new one would be.
    pub fn serves(&self, scene: Bounds, camera: &CameraParams, direction: Vec3, map_size: u32) -> bool {
        let scene = or_unit_box(scene);
        let seen = visible_region(scene, camera, None);
        let points = if seen.is_empty() { scene.corners().to_vec() } else { seen };
        let covers = points.iter().all(|&p| self.projection.project(p).is_inside);
        let fresh = fit_kept(scene, camera, direction, map_size);
        covers
            && self.extent_world.xy().max_element() <= fresh.extent_world.xy().max_element() * KEPT_LOOSENESS
    }
}

pub(crate) fn or_unit_box(scene: Bounds) -> Bounds {
    if scene.is_empty() { Bounds { min: Vec3::NEG_ONE, max: Vec3::ONE } } else { scene }
}

pub(crate) fn in_light(frame: &LightFrame, points: &[Vec3]) -> Bounds {
    points.iter().fold(Bounds::EMPTY, |b, &p| b.including(frame.to_light(p)))
}

pub(crate) fn casters_in_light(scene: Bounds, frame: &LightFrame) -> Bounds {
    in_light(frame, &or_unit_box(scene).corners())
}

fn receivers_in_light(scene: Bounds, camera: &CameraParams, frame: &LightFrame) -> Bounds {
    let scene = or_unit_box(scene);
    let seen = visible_region(scene, camera, None);
    if seen.is_empty() { in_light(frame, &scene.corners()) } else { in_light(frame, &seen) }
}

/// A map whose sides and far plane enclose `receivers` and whose near plane encloses `casters`, both in the light's frame.
fn fit_box(frame: &LightFrame, receivers: Bounds, casters: Bounds, map_size: u32) -> LightFit {
    let (mut min, mut max) = (receivers.min, receivers.max);
    min.z = casters.min.z;
    // A flat or tiny region still needs a box with an inside.
    let least = least_length(casters);
    let texel = ((max - min).xy().max_element().max(least)) / map_size as f32;
    let margin =
        Vec3::new(MARGIN_TEXELS * texel, MARGIN_TEXELS * texel, ((max.z - min.z) * DEPTH_MARGIN).max(least));
    min -= margin;
    max += margin;
    LightFit {
        projection: LightProjection::orthographic(frame, min, max),
        extent_world: max - min,
        near: 0.0,
    }
}

/// A length that is small beside the scene and still survives rounding.
fn least_length(casters: Bounds) -> f32 {
    let largest = casters.min.abs().max(casters.max.abs()).max_element();
    ((casters.max - casters.min).max_element() * 1e-5).max(largest * 1e-6).max(1e-30)
}

/// How far past the casters' own depths a level reaches, so that rounding clips none.
pub(crate) fn depth_margin(casters: Bounds) -> f32 {
    ((casters.max.z - casters.min.z) * DEPTH_MARGIN).max(least_length(casters))
}

/// Corner points of the convex region that lies in the scene's box, in the view pyramid and, if asked, between two view
/// depths; empty if nothing does.
pub(crate) fn visible_region(scene: Bounds, camera: &CameraParams, slice: Option<[f32; 2]>) -> Vec<Vec3> {
    let planes = view_planes(camera, slice);
    let mut points: Vec<Vec3> =
        box_faces(scene).into_iter().flat_map(|face| clip(face, planes.iter().copied())).collect();
    match slice {
        None => {
            if scene.contains(camera.eye) {
                points.push(camera.eye);
            }
            for (x, y) in CORNERS {
                let edge = camera.forward + camera.right * x + camera.up * y;
                points.extend(segment_in_box(camera.eye, edge, scene).into_iter().flatten());
            }
        }
        // Corners of an intersection lie on a face of one body inside the other.
        Some(depths) => {
            points.extend(slice_faces(camera, depths).into_iter().flat_map(|f| clip(f, box_planes(scene))))
        }
    }
    points
}

/// Corner points of the part of the scene's box inside a light's map, however far along the light; empty if there is none.
pub(crate) fn region_in_column(scene: Bounds, frame: &LightFrame, x: (f32, f32), y: (f32, f32)) -> Vec<Vec3> {
    let sides = [
        Plane { normal: frame.right, point: frame.right * x.0 },
        Plane { normal: -frame.right, point: frame.right * x.1 },
        Plane { normal: frame.up, point: frame.up * y.0 },
        Plane { normal: -frame.up, point: frame.up * y.1 },
    ];
    let mut points: Vec<Vec3> =
        box_faces(scene).into_iter().flat_map(|face| clip(face, sides.into_iter())).collect();
    // The column's own edges, where they run through the box.
    for (x, y) in [(x.0, y.0), (x.0, y.1), (x.1, y.0), (x.1, y.1)] {
        let middle = (scene.min + scene.max) * 0.5;
        let on_edge = frame.right * x + frame.up * y + frame.forward * frame.forward.dot(middle);
        let reach = (scene.max - scene.min).length();
        let start = on_edge - frame.forward * reach;
        points.extend(segment_in_box(start, frame.forward, scene).into_iter().flatten());
    }
    points
}

/// Signs of a picture's corners in order around it.
const CORNERS: [(f32, f32); 4] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];

/// A half-space: what lies along `normal` from `point`.
#[derive(Clone, Copy)]
struct Plane {
    normal: Vec3,
    point: Vec3,
}

/// The view's four side planes, and the plane through the eye or those of a slice.
fn view_planes(camera: &CameraParams, slice: Option<[f32; 2]>) -> Vec<Plane> {
    let (r, u, f) = (camera.right, camera.up, camera.forward);
    let (rr, uu) = (r / r.length_squared(), u / u.length_squared());
    let mut planes: Vec<Plane> =
        [f, f - rr, f + rr, f - uu, f + uu].map(|normal| Plane { normal, point: camera.eye }).to_vec();
    if let Some([near, far]) = slice {
        planes[0].point = camera.eye + f * near;
        planes.push(Plane { normal: -f, point: camera.eye + f * far });
    }
    planes
}

fn box_planes(b: Bounds) -> impl Iterator<Item = Plane> {
    [Vec3::X, Vec3::Y, Vec3::Z]
        .into_iter()
        .flat_map(move |axis| [Plane { normal: axis, point: b.min }, Plane { normal: -axis, point: b.max }])
}

/// The six faces of the view between two depths.
fn slice_faces(camera: &CameraParams, depths: [f32; 2]) -> Vec<Vec<Vec3>> {
    let [near, far] = depths.map(|depth| {
        CORNERS.map(|(x, y)| camera.eye + (camera.forward + camera.right * x + camera.up * y) * depth)
    });
    let side = |i: usize| vec![near[i], near[(i + 1) % 4], far[(i + 1) % 4], far[i]];
    vec![near.to_vec(), far.to_vec(), side(0), side(1), side(2), side(3)]
}

fn box_faces(b: Bounds) -> [Vec<Vec3>; 6] {
    let c = b.corners();
    [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
        .map(|f| f.map(|i| c[i]).to_vec())
}

/// Sutherland–Hodgman.
fn clip(mut polygon: Vec<Vec3>, planes: impl Iterator<Item = Plane>) -> Vec<Vec3> {
    for plane in planes {
        let side = |p: Vec3| plane.normal.dot(p - plane.point);
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for i in 0..polygon.len() {
            let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            let (sa, sb) = (side(a), side(b));
            if sa >= 0.0 {
                kept.push(a);
            }
            if (sa < 0.0) != (sb < 0.0) {
                kept.push(a + (b - a) * (sa / (sa - sb)));
            }
        }
        polygon = kept;
    }
    polygon
}

/// Where a ray enters and leaves a box.
fn segment_in_box(origin: Vec3, direction: Vec3, b: Bounds) -> [Option<Vec3>; 2] {
    let (mut near, mut far) = (0.0f32, f32::MAX);
    for axis in 0..3 {
        if direction[axis] == 0.0 {
            if origin[axis] < b.min[axis] || origin[axis] > b.max[axis] {
                return [None, None];
            }
            continue;
        }
        let (t0, t1) =
            ((b.min[axis] - origin[axis]) / direction[axis], (b.max[axis] - origin[axis]) / direction[axis]);
        near = near.max(t0.min(t1));
        far = far.min(t0.max(t1));
    }
    if near > far { [None, None] } else { [Some(origin + direction * near), Some(origin + direction * far)] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::glam::UVec2;

    fn camera(eye: Vec3, forward: Vec3) -> CameraParams {
        let right = forward.cross(Vec3::Y).normalize();
        let up = right.cross(forward);
        CameraParams {
            eye,
            root: 0,
            right,
            layers_behind: 0,
            up,
            pad1: 0,
            forward,
            pad2: 0,
            size: UVec2::ONE,
            grid: UVec2::ONE,
        }
    }

    const BOX: Bounds = Bounds { min: Vec3::splat(-10.0), max: Vec3::splat(10.0) };

    #[test]
    fn what_the_camera_sees_lies_inside_the_map() {
        let cam = camera(Vec3::new(0.0, 2.0, 5.0), Vec3::new(0.0, -0.3, -1.0).normalize());
        let fit = fit_directional(BOX, &cam, Vec3::new(0.3, -1.0, 0.2), 1024);
        let mut seen = 0;
        for i in 0..20 * 20 * 20 {
            let p = Vec3::new((i % 20) as f32 - 9.5, (i / 20 % 20) as f32 - 9.5, (i / 400) as f32 - 9.5);
            let d = p - cam.eye;
            let z = d.dot(cam.forward);
            if z > 0.0 && d.dot(cam.right).abs() < z && d.dot(cam.up).abs() < z {
                seen += 1;
                assert!(fit.projection.project(p).is_inside, "{p}");
            }
        }
        assert!(seen > 100);
    }

    #[test]
    fn a_kept_map_serves_nearby_cameras_and_not_distant_ones() {
        let at = |x: f32, z: f32| camera(Vec3::new(x, 2.0, z), Vec3::new(0.0, -0.3, -1.0).normalize());
        let sun = Vec3::new(0.3, -1.0, 0.2);
        let start = at(0.0, 5.0);
        let fit = fit_kept(BOX, &start, sun, 1024);
        assert!(fit.serves(BOX, &start, sun, 1024));
        assert!(fit.serves(BOX, &at(0.2, 4.8), sun, 1024));
        let turned = camera(start.eye, Vec3::new(0.0, -0.3, 1.0).normalize());
        assert!(!fit.serves(BOX, &turned, sun, 1024), "looks elsewhere");
        let near = camera(Vec3::new(0.0, -9.0, -8.0), Vec3::new(0.0, -0.9, -0.2).normalize());
        assert!(!fit.serves(BOX, &near, sun, 1024), "sees so little that a new map is much finer");
        assert!(!fit_directional(BOX, &start, sun, 1024).serves(BOX, &at(0.0, 9.0), sun, 1024), "not grown");
    }

    #[test]
    fn every_caster_lies_beyond_the_near_plane() {
        let cam = camera(Vec3::new(0.0, 0.0, -9.0), Vec3::NEG_Z);
        let fit = fit_directional(BOX, &cam, Vec3::new(0.0, -1.0, -1.0), 512);
        for corner in BOX.corners() {
            assert!(fit.projection.project(corner).depth >= 0.0);
        }
    }

    #[test]
    fn a_camera_that_looks_away_and_an_empty_scene_still_give_a_map() {
        let away = camera(Vec3::splat(100.0), Vec3::X);
        assert!(fit_directional(BOX, &away, Vec3::NEG_Y, 64).projection.project(Vec3::ZERO).is_inside);
        assert!(
            fit_directional(Bounds::EMPTY, &away, Vec3::NEG_Y, 64).projection.project(Vec3::ZERO).is_inside
        );
        let point = Bounds { min: Vec3::ONE, max: Vec3::ONE };
        assert!(fit_directional(point, &away, Vec3::NEG_Y, 64).projection.project(Vec3::ONE).is_inside);
    }
}
