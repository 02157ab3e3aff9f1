//! A tiny comparison for the tests of table, results and report.

use lt_math::glam::Vec3;
use lt_render::{
    Comparison, Effect, EffectPlan, Frame, FrameStats, LightStats, MaskBits, MeanTimes, PassKind, PassTime,
    Row, SampleGrid, Technique, metrics,
};

use crate::{
    play::Playback,
    summary::{Summary, View},
};

/// Facts of a run that never was.
pub fn summary() -> Summary {
    Summary {
        scene: "box <&> \"quotes\"".into(),
        triangles: 12,
        instances: 1,
        size: [4, 2],
        samples_per_pixel: 1,
        layers: 1,
        backend: "cpu",
        device: "test".into(),
        threads: 2,
        bvh_ms: 1.5,
        bvh_bytes: 640,
        camera_ms: Some(0.5),
        dropped_triangles: 0,
        map_size: 64,
        view: View {
            eye: Vec3::ZERO.to_array(),
            target: Vec3::X.to_array(),
            up: Vec3::Y.to_array(),
            fov_deg: 55.0,
            light_dir: Some([0.0, -1.0, 0.0]),
            light_pos: None,
            cone_deg: None,
            more_lights: Vec::new(),
        },
        command: "lt compare box".into(),
        version: "0.0.0",
    }
}

/// `ray` and an `sm` that lights one blocked pixel.
pub fn comparison() -> Comparison {
    let truth = vec![1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
    let mut leaking = truth.clone();
    leaking[2] = 1.0;
    let reference = frame(truth, true);
    let rows = vec![row("ray", &reference, 8.0, 8), row("sm", &frame(leaking, false), 2.0, 0)];
    Comparison {
        size: [4, 2],
        samples: SampleGrid::ONE,
        valid_pixels: 8,
        reference_picture: picture(&reference),
        reference,
        rows,
    }
}

/// The same over two frames; `sm` stands in for a technique with a mask, pictured in the second.
pub fn played() -> (Comparison, Playback) {
    let mut comparison = comparison();
    for (i, row) in comparison.rows.iter_mut().enumerate() {
        row.means = Some(MeanTimes { first_ms: 31.25, later_ms: 4.5, all_ms: 17.875 });
        row.speedup_by_means = Some(1.5);
        row.frames = (0..2)
            .map(|at| FrameStats {
                lights: vec![LightStats { errors: row.errors, rays: row.frame.rays }],
                errors: row.errors,
                rays: row.frame.rays,
                map_draws: 1,
                passes: Vec::new(),
                flips: None,
                mask: (i == 1 && at == 1).then(|| vec![MaskBits::PURPLE; 8]),
            })
            .collect();
    }
    let playback = Playback {
        frames: 2,
        is_still: false,
        motion_px: 2.0,
        objects_move: false,
        lights_move: false,
        is_cold: false,
        mask_frames: vec![1],
    };
    (comparison, playback)
}

fn frame(visibility: Vec<f32>, doubt: bool) -> Frame {
    let doubt = vec![doubt; visibility.len()];
    Frame {
        visibility,
        tint: Vec::new(),
        doubt,
        rays: 0,
        passes: Vec::new(),
        map_bytes: 0,
        mask: Vec::new(),
        map_draws: 0,
        lights: Vec::new(),
        layers: Vec::new(),
    }
}

fn picture(frame: &Frame) -> Vec<[u8; 4]> {
    let shade = |&v: &f32| [(v * 200.0) as u8 + 20; 3];
    frame.visibility.iter().map(shade).map(|[r, g, b]| [r, g, b, 255]).collect()
}

fn row(id: &str, frame: &Frame, ms: f64, rays: u64) -> Row {
    let truth = [1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
    let effect = Effect { name: "rays", is_on: rays > 0, reason: "a test".into(), cost: "1 pass".into() };
    Row {
        technique: id.parse::<Technique>().unwrap(),
        plan: EffectPlan {
            alpha_test: false,
            instances: false,
            color_textures: false,
            map: None,
            levels: 1,
            perspective: false,
            level_search: false,
            doubt_list: false,
            trace_all: rays > 0,
            upkeep: lt_render::Upkeep::Kept,
            resolve: lt_render::Resolve::Ray,
            mask: None,
            object_motion: false,
            reuse: false,
            tint: false,
            layers: 1,
            effects: vec![effect],
        },
        rays_per_pixel: rays as f64 / 8.0,
        rays,
        errors: metrics::errors([4, 2], &[true; 8], &truth, &frame.visibility),
        lights: Vec::new(),
        flip_mean: Some(0.25),
        passes: vec![PassTime { kind: PassKind::Evaluate, median_ms: Some(ms), p95_ms: Some(ms * 1.1) }],
        map_ms: Some(0.0),
        shadow_ms: Some(ms),
        total_ms: Some(ms),
        speedup_over_ray: Some(8.0 / ms),
        means: None,
        speedup_by_means: None,
        map_bytes: 0,
        frame: Frame { rays, ..frame.clone() },
        picture: picture(frame),
        frames: Vec::new(),
    }
}
