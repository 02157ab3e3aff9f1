//! Several frames of `lt compare`: a camera path or a still view, and what techniques did along it.

use std::sync::atomic::AtomicBool;

use lt_math::glam::Vec3;
use lt_render::{
    Comparison, FrameStats, PlayOptions, RenderError, Row, Sequence, compare_frames, frames_to_settle,
    quantile,
};
use lt_scene::{Camera, CameraPath, Keyframes, Light, Scene};
use serde::Serialize;

use crate::{
    args::CompareArgs,
    numbers::{decimals, factor, grouped, ms, ppm},
    progress::Steps,
    scene_args::Opened,
    table::{self, Align},
};

/// Frames per second of node animations.
const FRAME_RATE: f32 = 60.0;
/// Median motion per frame unless told otherwise, pixels of a picture [`MOTION_WIDTH`] wide.
const DEFAULT_MOTION_PX: f32 = 2.0;
/// The picture width that `--motion` speaks of, so that a path is the same at every size.
const MOTION_WIDTH: f32 = 1920.0;
/// Masks pictured along a path.
const PICTURED_MASKS: usize = 8;

/// What was played.
#[derive(Clone, Debug, Serialize)]
pub struct Playback {
    /// How many frames.
    pub frames: usize,
    /// Nothing moved.
    pub is_still: bool,
    /// Median motion of the first step, pixels of this picture; 0 if still.
    pub motion_px: f64,
    /// Things in the scene moved.
    pub objects_move: bool,
    /// Lights moved.
    pub lights_move: bool,
    /// Techniques with a temporal mask began with a cleared one.
    pub is_cold: bool,
    /// Frames whose masks are kept for pictures.
    pub mask_frames: Vec<usize>,
}

impl Playback {
    /// One line about it.
    pub fn headline(&self) -> String {
        let what = match (self.objects_move, self.lights_move) {
            _ if self.is_still => "nothing moves; errors are the last frame's".to_owned(),
            (objects, lights) => format!(
                "the camera moves by {:.2} px a frame in the median{}{}",
                self.motion_px,
                if objects { ", things move" } else { "" },
                if lights { ", lights move" } else { "" }
            ),
        };
        let start = if self.is_cold { " · from a cleared mask" } else { "" };
        format!("{} frames · {what}{start}", self.frames)
    }
}

/// Median, 95th percentile and largest of something over the frames.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Half the frames have at most this.
    pub median: f64,
    /// 19 of 20 frames have at most this.
    pub p95: f64,
    /// The worst frame.
    pub max: f64,
}

/// The spread of these values; zeros for none.
pub fn spread(values: impl Iterator<Item = f64>) -> Spread {
    let values: Vec<f64> = values.collect();
    Spread {
        median: quantile(values.clone(), 0.5),
        p95: quantile(values.clone(), 0.95),
        max: quantile(values, 1.0),
    }
}

/// Plays the frames.
///
/// # Errors
/// A pose that cannot be read or drawn, or a failing device.
pub fn run(args: &CompareArgs, opened: &mut Opened, frames: usize) -> anyhow::Result<(Comparison, Playback)> {
    let way = Way::new(args, opened)?;
    if let Way::Keyframes(_) = way {
        opened.session.look(&way.at(0))?;
    }
    let lamps = Lamps::new(args, opened);
    let sequence = Sequence { starts_cold: args.cold, ..args.play.sequence(&args.scene, opened) };
    let playback = Playback {
        frames,
        is_still: args.play.still,
        motion_px: lt_render::median_motion_px(&opened.session, &way.at(1)),
        objects_move: sequence.objects_move,
        lights_move: sequence.lights_move,
        is_cold: args.cold,
        mask_frames: pictured(frames),
    };
    opened.session.play(sequence);
    let options = PlayOptions {
        frames,
        is_still: args.play.still,
        with_flip: !args.no_flip,
        mask_frames: playback.mask_frames.clone(),
    };
    let mut steps = Steps::new();
    let mut before = opened.scene.clone();
    let mut failure = None;
    let comparison = compare_frames(
        &mut opened.session,
        &args.techniques(),
        &options,
        |session, frame| {
            if args.play.still {
                return Ok(());
            }
            let camera = way.at(frame);
            let mut keep = |error: anyhow::Error| {
                let problem = error.to_string();
                failure = Some(error);
                RenderError::Build(problem)
            };
            let at_frame = |error: RenderError| match error {
                RenderError::BadSetup(problem) => RenderError::BadSetup(format!("frame {frame}: {problem}")),
                other => other,
            };
            let is_posed = playback.objects_move || lamps.is_animated;
            let now = match is_posed {
                true => Some(args.scene.pose(&opened.source, time_of(args, frame)).map_err(&mut keep)?),
                false => None,
            };
            if playback.lights_move {
                session.relight(&lamps.at(args, now.as_ref(), frame).map_err(&mut keep)?)?;
            }
            match now.filter(|_| playback.objects_move) {
                None => session.look(&camera).map_err(&at_frame),
                Some(now) => {
                    session.advance(&camera, &now, &before).map_err(&at_frame)?;
                    before = now;
                    Ok(())
                }
            }
        },
        &AtomicBool::new(false),
        |done, total, what| steps.at(done, total, what),
    );
    steps.clear();
    match failure {
        Some(error) => Err(error),
        None => Ok((comparison?, playback)),
    }
}

/// The moment of a frame.
fn time_of(args: &CompareArgs, frame: usize) -> f32 {
    args.scene.time + frame as f32 / FRAME_RATE
}

/// Where the camera goes.
enum Way {
    /// Nowhere.
    Still(Camera),
    /// Along a path at this pace.
    Path(CameraPath, f32),
    /// As a file says.
    Keyframes(Keyframes),
}

impl Way {
    fn new(args: &CompareArgs, opened: &Opened) -> anyhow::Result<Self> {
        let start = opened.session.setup().camera.clone();
        if args.play.still {
            return Ok(Self::Still(start));
        }
        if let Some(file) = &args.path {
            return Ok(Self::Keyframes(Keyframes::open(file, start)?));
        }
        let width = opened.session.setup().size.x as f32;
        let path = opened.source.camera_path(start);
        let wanted_px = f64::from(args.motion.unwrap_or(DEFAULT_MOTION_PX) * width / MOTION_WIDTH);
        let pace = lt_render::way_per_frame(&opened.session, &path, wanted_px);
        Ok(Self::Path(path, pace))
    }

    fn at(&self, frame: usize) -> Camera {
        match self {
            Self::Still(camera) => camera.clone(),
            Self::Path(path, pace) => path.at(pace * frame as f32),
            Self::Keyframes(keys) => keys.at(frame as f32 / FRAME_RATE),
        }
    }
}

/// Where the lights go.
struct Lamps {
    start: Vec<Light>,
    /// The scene's animation moves them.
    is_animated: bool,
    center: Vec3,
}

impl Lamps {
    fn new(args: &CompareArgs, opened: &Opened) -> Self {
        let setup = opened.session.setup();
        let is_animated = args.play.animates_lights(&args.scene, opened);
        Self { start: setup.lights().cloned().collect(), is_animated, center: setup.camera.target }
    }

    /// The lights of a frame, of the scene's pose then if they are animated.
    fn at(&self, args: &CompareArgs, scene: Option<&Scene>, frame: usize) -> anyhow::Result<Vec<Light>> {
        let lights = match scene.filter(|_| self.is_animated) {
            Some(scene) => args.scene.lights(scene)?,
            None => self.start.clone(),
        };
        let angle = args.play.light_spin.unwrap_or(0.0).to_radians() * frame as f32;
        Ok(lights.iter().map(|light| light.turned(self.center, angle)).collect())
    }
}

/// Frames spread over all, first and last among them.
fn pictured(frames: usize) -> Vec<usize> {
    let count = frames.min(PICTURED_MASKS);
    let mut all: Vec<usize> = (0..count).map(|i| i * (frames - 1) / (count - 1).max(1)).collect();
    all.dedup();
    all
}

/// A table of what every technique did along the path; with nothing moving, also how many frames it took until as many pixels (or
/// samples) were wrong as in the last one, and how many those are.
pub fn text_table(comparison: &Comparison, flips: &[u64], is_still: bool) -> String {
    let unit = comparison.unit();
    let (rays, left) = (format!("rays /{unit}\nmedian"), format!("wrong {unit}s\nleft"));
    let mut columns = vec![
        ("technique", Align::Left),
        ("false-lit ppm\nmedian", Align::Right),
        ("\np95", Align::Right),
        ("\nmax", Align::Right),
        ("false-shadowed ppm\nmedian", Align::Right),
        ("\np95", Align::Right),
        ("\nmax", Align::Right),
        (&rays[..], Align::Right),
        ("\nmax", Align::Right),
        ("map\ndraws", Align::Right),
        ("flips\nstill", Align::Right),
        ("total ms\nmedian", Align::Right),
        ("\nmax", Align::Right),
        ("\nfirst", Align::Right),
        ("\nlater, mean", Align::Right),
        ("speed-up\nby means", Align::Right),
    ];
    if is_still {
        columns.extend([("settled\nafter", Align::Right), (&left[..], Align::Right)]);
    }
    let row = |(row, &flips): (&Row, &u64)| {
        let mut cells = text_row(row, flips);
        if is_still {
            let left = row.errors.false_lit + row.errors.false_shadowed;
            cells.extend([grouped(frames_to_settle(&row.frames) as u64), grouped(left)]);
        }
        cells
    };
    let rows: Vec<_> = comparison.rows.iter().zip(flips).map(row).collect();
    format!("{}\n{MEANS}\n", table::render(&columns, &rows))
}

/// Why means are told beside medians.
pub const MEANS: &str = "means are over the frames after the first and have what few frames do, such as drawing a map that is then kept; \
    medians leave that out";

fn text_row(row: &Row, flips: u64) -> Vec<String> {
    let frames = &row.frames;
    let lit = spread(frames.iter().map(|f| f.errors.false_lit_ppm()));
    let shadowed = spread(frames.iter().map(|f| f.errors.false_shadowed_ppm()));
    let rays = spread(frames.iter().map(FrameStats::rays_per_pixel));
    let times: Option<Vec<f64>> = frames.iter().map(|f| f.ms(|_| true)).collect();
    let times = times.map(|t| spread(t.into_iter()));
    vec![
        row.technique.to_string(),
        ppm(lit.median),
        ppm(lit.p95),
        ppm(lit.max),
        ppm(shadowed.median),
        ppm(shadowed.p95),
        ppm(shadowed.max),
        decimals(Some(rays.median), 3),
        decimals(Some(rays.max), 3),
        grouped(frames.iter().map(|f| u64::from(f.map_draws)).sum()),
        grouped(flips),
        ms(times.map(|t| t.median)),
        ms(times.map(|t| t.max)),
        ms(row.means.map(|m| m.first_ms)),
        ms(row.means.map(|m| m.later_ms)),
        factor(row.speedup_by_means),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictured_frames_are_spread_and_within() {
        assert_eq!(pictured(2), [0, 1]);
        assert_eq!(pictured(8), [0, 1, 2, 3, 4, 5, 6, 7]);
        let many = pictured(64);
        assert_eq!((many.len(), many[0], many[7]), (8, 0, 63));
        assert!(many.windows(2).all(|w| w[0] < w[1]));
    }

    #[test]
    fn the_table_tells_the_first_frame_and_the_mean_of_the_others() {
        let text = text_table(&crate::fixture::played().0, &[0, 0], false);
        assert!(text.contains("later, mean") && text.contains("31.25  "), "{text}");
        assert!(text.contains("4.50") && text.contains("1.50×"), "{text}");
    }

    #[test]
    fn a_spread_names_the_worst() {
        let s = spread([3.0, 1.0, 2.0].into_iter());
        assert_eq!((s.median, s.max), (2.0, 3.0));
        assert_eq!(spread(std::iter::empty()).max, 0.0);
    }
}
