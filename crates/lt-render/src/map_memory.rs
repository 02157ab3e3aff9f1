//! What the maps of techniques that are played side by side take of memory.
//!
//! A technique that follows its last frame keeps maps of its own for every light and layer; the others draw theirs in one place, one
//! after the other. The blurred rows of a pre-filter are lent to whoever is filtering.

use std::collections::BTreeSet;

use crate::{EffectPlan, RenderError, Session, Technique};

/// Most bytes of all maps of techniques that are compared. Along a path all there are take 3.5 GiB of 2048² texels, and 14 of 4096².
pub const MAX_MAP_BYTES: u64 = 16 << 30;

/// Bytes of a depth, and of a vector of depths.
const DEPTH: u64 = 4;
const VECTOR: u64 = 16;

/// Bytes that a plan's maps take: those that stay with it, and those of the rows that it is lent.
fn bytes_of(plan: &EffectPlan, map_size: u32, objects_move: bool) -> (u64, u64) {
    let texels = u64::from(plan.levels) * u64::from(map_size).pow(2);
    let depths = if plan.reuse && objects_move { 2 * DEPTH } else { DEPTH };
    let vectors = if plan.is_prefiltered() { VECTOR } else { 0 };
    (texels * (depths + vectors), texels * vectors)
}

/// Bytes of all maps once each of these techniques has drawn a frame of the session, as the session's sequence and lights have them keep
/// maps. What a technique keeps that is not among them is not counted, nor are marks on the GPU, an eighth of the depths.
pub fn map_bytes(session: &Session, techniques: &[Technique]) -> u64 {
    let (setup, sequence) = (session.setup(), session.sequence());
    let (mut kept, mut passing, mut rows) = (0, 0, 0);
    let mut seen = BTreeSet::new();
    for technique in techniques.iter().filter(|technique| seen.insert(technique.to_string())) {
        let size = technique.map_size.unwrap_or(setup.map_size);
        for light in setup.lights() {
            let plan = EffectPlan::for_scene(&session.info().stats, &light.kind, technique, size, sequence);
            let (own, lent) = bytes_of(&plan, size, sequence.objects_move);
            if plan.reuse || plan.mask.is_some() {
                kept += own * u64::from(plan.layers);
            } else {
                passing = own.max(passing);
            }
            rows = lent.max(rows);
        }
    }
    kept + passing + rows
}

/// Refuses techniques whose maps would exceed [`MAX_MAP_BYTES`].
///
/// # Errors
/// [`RenderError::BadSetup`] with what they need and what would need less.
pub(crate) fn check(session: &Session, techniques: &[Technique]) -> Result<(), RenderError> {
    let needed = map_bytes(session, techniques);
    if needed <= MAX_MAP_BYTES {
        return Ok(());
    }
    let gib = |bytes: u64| bytes as f64 / f64::from(1 << 30);
    Err(RenderError::BadSetup(format!(
        "the maps of {} techniques need {:.1} GiB together, more than {:.0}: compare fewer techniques at a time, or use a smaller --map-size \
         than {}",
        techniques.len(),
        gib(needed),
        gib(MAX_MAP_BYTES),
        session.setup().map_size
    )))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use lt_scene::{Scene, Source};

    use super::*;
    use crate::{
        BackendKind, CompareOptions, MapSource, PlayOptions, Sequence, Setup, compare, compare_frames,
    };

    const PLAYED: Sequence = Sequence {
        is_played: true,
        camera_moves: false,
        objects_move: false,
        lights_move: false,
        starts_cold: false,
    };

    fn scene() -> Scene {
        Source::open("cornell", 1).unwrap().pose(0.0).unwrap()
    }

    fn session(map_size: u32, more_lights: usize) -> Session {
        let scene = scene();
        let mut setup = Setup { map_size, ..Setup::for_scene(&scene, 32, 18) };
        setup.more_lights = vec![setup.light.clone(); more_lights];
        Session::new(&scene, setup, BackendKind::Cpu).unwrap()
    }

    /// All techniques there are.
    fn all() -> Vec<Technique> {
        let gathered = Technique::catalogue().into_iter().map(|(technique, _)| technique);
        let blurred = gathered.clone().filter_map(|technique| {
            let (test, _) = technique.map_test().filter(|(test, _)| test.is_filterable())?;
            let estimate = crate::Estimate::Map { test, source: MapSource::Prefiltered };
            Some(Technique { estimate, ..technique })
        });
        gathered.chain(blurred).collect()
    }

    #[test]
    fn what_is_said_beforehand_is_what_is_drawn() {
        let techniques: Vec<Technique> =
            ["ray", "sm", "vsm:prefiltered", "ltt-msm:prefiltered", "lt-evsm", "lt-vsm:map=64"]
                .map(|id| id.parse().unwrap())
                .to_vec();
        let (texels, small) = (128 * 128, 64 * 64);
        // Bytes that each draws, and of these the rows that it is lent.
        let bytes = [0, 4 * texels, 36 * texels, 3 * 36 * texels, 3 * 4 * texels, 3 * 4 * small];
        let lent = [0, 0, 16 * texels, 3 * 16 * texels, 0, 0];
        for is_played in [false, true] {
            let mut session = session(128, 0);
            session.play(Sequence { is_played, ..PLAYED });
            let drawn: Vec<u64> = techniques.iter().map(|t| session.render(t).unwrap().map_bytes).collect();
            assert_eq!(drawn, bytes);
            let own = |i: usize| bytes[i] - lent[i];
            // The first four keep nothing of a single frame: one place for them, the largest of which is the fourth.
            let kept: u64 = (if is_played { 0..6 } else { 3..6 }).map(own).sum();
            assert_eq!(map_bytes(&session, &techniques), kept + lent[3]);
            let twice = [&techniques[..], &techniques].concat();
            assert_eq!(map_bytes(&session, &twice), kept + lent[3], "the same twice");
        }
    }

    #[test]
    fn every_light_has_maps_of_its_own_and_what_stands_still_is_kept_apart() {
        let technique = ["lt-evsm".parse().unwrap()];
        let one = map_bytes(&session(128, 0), &technique);
        assert_eq!(map_bytes(&session(128, 2), &technique), 3 * one);
        let mut moving = session(128, 0);
        moving.play(Sequence { objects_move: true, ..PLAYED });
        assert_eq!(map_bytes(&moving, &technique), 2 * one);
    }

    #[test]
    fn maps_that_exceed_the_bound_are_refused_before_anything_is_drawn() {
        let stop = AtomicBool::new(true);
        let frames = PlayOptions { frames: 2, is_still: true, with_flip: false, mask_frames: Vec::new() };
        let mut large = session(8192, 0);
        large.play(PLAYED);
        let nothing = |_: &mut Session, _| Ok(());
        let refused = compare_frames(&mut large, &all(), &frames, nothing, &stop, |_, _, what| {
            panic!("{what}");
        });
        let problem = refused.expect_err("too much").to_string();
        assert!(problem.contains("GiB") && problem.contains("--map-size"), "{problem}");
        // All of 4096² fit, and so does the largest map of a single frame: there it is the caller who stops.
        let mut usual = session(4096, 0);
        usual.play(PLAYED);
        assert!(map_bytes(&usual, &all()) > MAX_MAP_BYTES / 2);
        check(&usual, &all()).unwrap();
        let once = CompareOptions { repeats: 1, with_flip: false };
        let mut many = session(8192, 7);
        let masked: Technique = "lt-msm:prefiltered".parse().unwrap();
        let refused = compare(&mut many, &[masked], &once, &stop, |_, _, what| panic!("{what}"));
        assert!(matches!(refused, Err(RenderError::BadSetup(_))), "eight lights' masks keep their maps");
        let stopped = compare(&mut many, &[Technique::RAY], &once, &stop, |_, _, _| {});
        assert!(matches!(stopped, Err(RenderError::Cancelled)));
    }
}
