//! Helpers of the cross-crate tests: sessions, GPU availability, comparison of pictures and counts.
//!
//! GPU tests run on whatever adapter wgpu finds (lavapipe in CI). Without one they print that they were skipped and why;
//! with `LT_REQUIRE_GPU` set in the environment a missing adapter is a failure.

pub mod textures;

use std::sync::OnceLock;

use lt_render::{BackendKind, RenderError, Session, Setup};
use lt_scene::{Scene, Source};

/// Environment variable that turns a missing GPU into a failure.
pub const REQUIRE_GPU: &str = "LT_REQUIRE_GPU";

/// CPU and GPU counts may differ by this many ppm of the picture's pixels: one documented bound for all twin tests.
///
/// 20 with a software driver, which rounds as the CPU does but for the last bit of a rasterised depth. Hardware also contracts products and
/// sums and divides within 2.5 units of the last place, so that samples themselves differ, and pictures as small as the tests' have many
/// edges: 250 (on an H100 at 320×200, 109 seen).
pub fn twin_ppm() -> f64 {
    if is_on_hardware() { 250.0 } else { 20.0 }
}

/// Whether GPU tests run on anything but a software driver.
pub fn is_on_hardware() -> bool {
    static IS_HARDWARE: OnceLock<bool> = OnceLock::new();
    *IS_HARDWARE.get_or_init(lt_render::gpu::has_hardware_adapter)
}

/// A built-in scene at time 0.
///
/// # Panics
/// When the name is no built-in scene.
pub fn builtin(name: &str) -> Scene {
    Source::open(name, 1).and_then(|s| s.pose(0.0)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// A CPU session on a scene, at a size.
///
/// # Panics
/// When the session cannot be made.
pub fn cpu_session(scene: &Scene, width: u32, height: u32) -> Session {
    Session::new(scene, Setup::for_scene(scene, width, height), BackendKind::Cpu).expect("CPU session")
}

/// A GPU session, or `None` (said on stderr) where there is no adapter.
///
/// # Panics
/// When there is none although [`REQUIRE_GPU`] is set, or on any other error.
pub fn gpu_session(scene: &Scene, setup: Setup) -> Option<Session> {
    match Session::new(scene, setup, BackendKind::Gpu) {
        Ok(session) => Some(session),
        Err(RenderError::NoAdapter(reason)) if std::env::var_os(REQUIRE_GPU).is_none() => {
            eprintln!("skipped: no GPU adapter ({reason})");
            None
        }
        Err(e) => panic!("GPU session: {e}"),
    }
}

/// How many positions differ; NaN differs from everything, itself included.
///
/// # Panics
/// When the lengths differ or nothing is compared: such a comparison would say nothing.
pub fn count_different(a: &[f32], b: &[f32], tolerance: f32) -> usize {
    assert_eq!(a.len(), b.len(), "lengths differ");
    assert!(!a.is_empty(), "nothing to compare");
    let is_close = |x: f32, y: f32| (x - y).abs() <= tolerance;
    a.iter().zip(b).filter(|(x, y)| !is_close(**x, **y)).count()
}

/// Parts per million.
pub fn ppm(count: usize, of: usize) -> f64 {
    count as f64 * 1e6 / of.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_changed_value_on_either_side_is_seen() {
        assert_eq!(count_different(&[0.0, 1.0], &[0.0, 1.0], 0.0), 0);
        assert_eq!(count_different(&[0.0, 0.5], &[0.0, 1.0], 0.1), 1);
        assert_eq!(count_different(&[0.0, 1.0], &[0.0, 0.5], 0.1), 1);
    }

    #[test]
    fn nan_matches_nothing() {
        assert_eq!(count_different(&[f32::NAN], &[f32::NAN], 1e9), 1);
        assert_eq!(count_different(&[0.0], &[f32::NAN], 1e9), 1);
    }

    #[test]
    #[should_panic(expected = "lengths differ")]
    fn unequal_lengths_are_refused() {
        count_different(&[0.0], &[], 0.0);
    }

    #[test]
    #[should_panic(expected = "nothing to compare")]
    fn an_empty_comparison_is_refused() {
        count_different(&[], &[], 0.0);
    }
}
