//! How fast to walk a path, so that the picture moves by a wanted number of pixels per frame.

use lt_scene::{Camera, CameraPath};
use lt_shaders::mask::{place_px, view_depth};

use crate::{SampleGrid, Session, Setup, planner::camera_params, quantile};

/// Samples looked at: enough for a median, few enough to ask many cameras.
const SAMPLES: usize = 20_000;
/// Halvings of the interval in which the pace lies.
const HALVINGS: usize = 40;

/// Median way in pixels, over the pixels with geometry, that the picture moves if `camera` looks next; 0 if nothing is
/// visible. Things at rest are assumed.
pub fn median_motion_px(session: &Session, camera: &Camera) -> f64 {
    let in_pixels = Setup { samples: SampleGrid::ONE, ..session.setup().clone() };
    let now = camera_params(&in_pixels, 0);
    let next = camera_params(&Setup { camera: camera.clone(), ..in_pixels }, 0);
    let stride = (session.samples().len() / SAMPLES).max(1);
    let seen = session.samples().iter().step_by(stride).filter(|s| s.is_valid());
    let motions = seen
        .filter(|s| view_depth(s.position, &next) > 0.0)
        .map(|s| f64::from((place_px(s.position, &next) - place_px(s.position, &now)).length()));
    quantile(motions.filter(|m| m.is_finite()).collect(), 0.5)
}

/// The way per frame at which the first step along `path` moves the picture by `motion_px` pixels in the median.
///
/// The session looks from the path's start. A path that moves nothing gives the longest way tried, 1.
pub fn way_per_frame(session: &Session, path: &CameraPath, motion_px: f64) -> f32 {
    let (mut low, mut high) = (0.0f32, 1.0f32);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if median_motion_px(session, &path.at(middle)) < motion_px {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BackendKind;
    use lt_scene::{Source, builtin::Builtin};

    #[test]
    fn the_pace_found_moves_the_picture_as_asked() {
        for name in ["cornell", "street:4", "fence"] {
            let source = Source::from(Builtin::parse(name).expect("a scene"));
            let scene = source.pose(0.0).expect("a pose");
            let setup = Setup::for_scene(&scene, 160, 90);
            let path = source.camera_path(setup.camera.clone());
            let session = Session::new(&scene, setup, BackendKind::Cpu).expect("a session");
            assert_eq!(median_motion_px(&session, &path.at(0.0)), 0.0, "{name}");
            let way = way_per_frame(&session, &path, 0.5);
            let moved = median_motion_px(&session, &path.at(way));
            assert!((moved - 0.5).abs() < 0.02, "{name}: {moved}");
        }
    }
}
