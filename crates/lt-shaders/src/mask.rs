//! The mask pass: last frame's rays correct this frame's doubts (Kern et al. 2024, §3.1).
//!
//! It comes after any estimate with any doubt and reads of them one number per pixel, [`Verdict::visibility`]. Four
//! effects are chosen when a variant is made: `MOTION` (the camera or something seen moves), `DEPTH` (the temporal depth
//! test), `EXPANDS` (ER) and `REMOVES` (RR, as published or by known answers). One that is off costs neither a branch nor a read.

use lt_mask::{
    Evidence, LightPlace, MaskBits, Neighbourhood, Reprojection, decide_doubt, is_depth_consistent, is_due,
    is_test_shadowed, reproject,
};
use lt_math::glam::{UVec2, Vec2, Vec3};

use crate::{
    abi::{CameraParams, LightParams, MaskParams, Sample},
    evaluate::{Verdict, is_recalled, settle},
    neighbours::{Heard, row_words},
    sampling::sample_place,
};

/// What the last frame left behind.
pub trait HistorySource: Copy {
    /// Whether anyone around a pixel on the screen contradicts a shadow test, by the pattern of pixels that stand still or that have
    /// moved.
    fn asks(&self, pixel: UVec2, is_test_shadowed: bool, has_moved: bool) -> bool;
    /// What a pixel's own ray found, whatever the shadow test said; [`MaskBits::BLACK`] where none was traced.
    fn ray(&self, pixel: UVec2) -> MaskBits;
    /// The depth along the view axis that was seen there; read under the temporal depth test only.
    fn depth(&self, pixel: UVec2) -> f32;
}

/// Where one light's bits lie in a picture's masks, `words` to a pixel ([`LightParams::mask_words`]), row by row.
#[derive(Clone, Copy)]
pub struct BitsPlace {
    /// Among a pixel's words.
    pub light: LightPlace,
    /// Words of a pixel.
    pub words: u32,
}

impl BitsPlace {
    /// Of this light.
    #[inline]
    pub fn of(light: &LightParams) -> Self {
        Self { light: LightPlace::of(light.number), words: light.mask_words }
    }

    /// The first word of pixel `i` that holds the light's bits; the next one holds the rest where they straddle.
    #[inline]
    pub fn word(self, i: u32) -> usize {
        (i * self.words + self.light.word) as usize
    }

    /// The bits of pixel `i`.
    #[inline]
    pub fn read(self, bits: &[u32], i: u32) -> MaskBits {
        let at = self.word(i);
        let next = if self.light.straddles() { bits[at + 1] } else { 0 };
        self.light.read(bits[at], next)
    }
}

/// Neighbours and depths, row by row.
#[derive(Clone, Copy)]
pub struct DepthHistory<'a> {
    /// See [`Heard::words`].
    pub words: &'a [u32],
    /// `width · height` depths.
    pub depths: &'a [f32],
    /// Pixels in a row.
    pub width: u32,
}

impl<'a> DepthHistory<'a> {
    /// All but the depths.
    #[inline]
    fn heard(&self) -> Heard<'a> {
        Heard { words: self.words, columns: row_words(self.width) }
    }
}

impl HistorySource for DepthHistory<'_> {
    #[inline]
    fn asks(&self, pixel: UVec2, is_test_shadowed: bool, has_moved: bool) -> bool {
        self.heard().asks(pixel, is_test_shadowed, has_moved)
    }
    #[inline]
    fn ray(&self, pixel: UVec2) -> MaskBits {
        self.heard().ray(pixel)
    }
    #[inline]
    fn depth(&self, pixel: UVec2) -> f32 {
        self.depths[(pixel.y * self.width + pixel.x) as usize]
    }
}

/// One pixel after the mask.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Masked {
    /// 0 or 1; what the resolve pass overwrites where a ray is needed.
    pub visibility: f32,
    /// Trace a ray.
    pub needs_ray: bool,
    /// Whether the test was sure of itself: if a ray contradicts it, the map is to be marked ([`crate::marks`]).
    pub is_trusted: bool,
    /// What to remember, if a ray that is traced finds the light: see [`bits_after_ray`].
    pub bits: MaskBits,
}

/// What to remember after a ray that found this visibility; `before` is [`Masked::bits`].
#[inline]
pub fn bits_after_ray(before: MaskBits, visibility: f32) -> MaskBits {
    MaskBits::traced(before.is_test_shadowed(), is_test_shadowed(visibility))
}

/// Remembers what the ray of pixel `i` found; see [`bits_after_ray`].
#[inline]
pub fn learn(bits: &mut [u32], place: BitsPlace, i: u32, visibility: f32) {
    let after = bits_after_ray(place.read(bits, i), visibility);
    let at = place.word(i);
    bits[at] = place.light.write(bits[at], after);
    if place.light.straddles() {
        bits[at + 1] = place.light.write_rest(bits[at + 1], after);
    }
}

/// Depth of a world point along a camera's view axis.
#[inline]
pub fn view_depth(position: Vec3, camera: &CameraParams) -> f32 {
    (position - camera.eye).dot(camera.forward)
}

/// What the next frame's depth test compares with: the depth of what is seen, 0 where nothing is.
#[inline]
pub fn seen_depth(sample: &Sample, camera: &CameraParams) -> f32 {
    if sample.is_valid() { view_depth(sample.position, camera) } else { 0.0 }
}

/// Where a world point in front of a camera appears, in pixels from the picture's top left corner.
///
/// A point behind the camera or beside its eye gives infinity, NaN or a place that mirrors it: ask [`view_depth`] first.
#[inline]
pub fn place_px(position: Vec3, camera: &CameraParams) -> Vec2 {
    let to = position - camera.eye;
    // One division a place; the two others are the frame's.
    let nearness = 1.0 / to.dot(camera.forward);
    let right = camera.right * (1.0 / camera.right.length_squared());
    let up = camera.up * (1.0 / camera.up.length_squared());
    let x = to.dot(right) * nearness;
    let y = to.dot(up) * nearness;
    Vec2::new((x + 1.0) * (0.5 * camera.size.x as f32), (1.0 - y) * (0.5 * camera.size.y as f32))
}

/// Finds a pixel in the last frame.
#[inline]
fn find<H: HistorySource, const MOTION: bool, const DEPTH: bool>(
    px: UVec2,
    sample: &Sample,
    previous_position: Vec3,
    p: &MaskParams,
    history: H,
) -> Reprojection {
    let mut place = Reprojection { pixel: px, is_valid: true, has_moved: false };
    let rests = || p.flags & MaskParams::CAMERA_RESTS != 0 && previous_position == sample.position;
    if MOTION && !rests() {
        // A surface is seen where its sample lies: no second projection, and its rounding, is needed for that.
        let from = sample_place(px, p.current.grid);
        place = reproject(px, from, place_px(previous_position, &p.previous) - from, p.current.size);
        // Behind the last camera a projection is mirrored, and may fall on the screen.
        place.is_valid = place.is_valid && view_depth(previous_position, &p.previous) > 0.0;
    }
    if DEPTH && place.is_valid {
        let expected = view_depth(previous_position, &p.previous);
        place.is_valid = is_depth_consistent(expected, history.depth(place.pixel), p.depth_tolerance);
    }
    place.is_valid = place.is_valid && p.flags & MaskParams::HAS_HISTORY != 0;
    place
}

/// Decides one pixel: estimate and doubt in, ray or no ray out.
///
/// `estimate` is [`Verdict::visibility`] under a doubt test. `previous_position` is where the visible point was in the last
/// frame, world space; read under `MOTION` and `DEPTH` only.
pub fn mask<
    H: HistorySource,
    const MOTION: bool,
    const DEPTH: bool,
    const EXPANDS: bool,
    const REMOVES: bool,
>(
    px: UVec2,
    sample: &Sample,
    previous_position: Vec3,
    estimate: f32,
    p: &MaskParams,
    history: H,
) -> Masked {
    let (verdict, is_settled) = settle(sample, &p.light);
    if is_settled {
        let (visibility, bits) = (verdict.visibility, MaskBits::FACING_AWAY);
        return Masked { visibility, needs_ray: false, is_trusted: false, bits };
    }
    let st = is_test_shadowed(estimate);
    let is_doubted = estimate > 0.0 && estimate < 1.0;
    let place = find::<H, MOTION, DEPTH>(px, sample, previous_position, p, history);
    let removal = REMOVES && p.flags & MaskParams::REMOVES_AS_PUBLISHED != 0;
    let keeps = REMOVES && p.flags & MaskParams::KEEPS_ANSWERS != 0 && place.is_valid && !place.has_moved;
    let known = if keeps { history.ray(px) } else { MaskBits::BLACK };
    let mut neighbourhood = Neighbourhood::EMPTY;
    // Only what may change the decision is read: neighbours of a trusted pixel for ER, of a doubted one for RR.
    let is_open = if is_doubted { removal } else { EXPANDS };
    if is_open && place.is_valid && !known.is_traced() {
        let any_expands = history.asks(place.pixel, st, place.has_moved);
        // Over the states that occur, eqs. 6 and 8 negate each other; rays are removed as published under ER as published.
        neighbourhood = Neighbourhood { any_expands, all_remove: !any_expands };
    }
    let decision = decide_doubt(
        st,
        is_doubted,
        Evidence {
            is_on_map: estimate != Verdict::UNJUDGED,
            is_reprojected: place.is_valid,
            is_due: is_due(px, p.frame, p.refresh),
            neighbourhood,
            allows_removal: removal,
            known,
        },
    );
    let bits = if decision.needs_ray { decision.mask_with_ray(false) } else { decision.mask_without_ray() };
    Masked {
        visibility: decision.snapped_visibility(),
        needs_ray: decision.needs_ray,
        is_trusted: !is_doubted || is_recalled(estimate),
        bits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::LightParams;
    use crate::neighbours::{HEARD_WORDS, hear_all};
    use lt_mask::{Expansion, Offsets, Pattern};
    use lt_math::glam::UVec4;

    const SIZE: UVec2 = UVec2::new(4, 3);

    fn camera(eye: Vec3) -> CameraParams {
        CameraParams {
            eye,
            root: 0,
            right: Vec3::X * 4.0 / 3.0,
            layers_behind: 0,
            up: Vec3::Y,
            pad1: 0,
            forward: Vec3::NEG_Z,
            pad2: 0,
            size: SIZE,
            grid: UVec2::ONE,
        }
    }

    fn params(previous_eye: Vec3) -> MaskParams {
        MaskParams {
            current: camera(Vec3::ZERO),
            previous: camera(previous_eye),
            light: LightParams::directional(Vec3::Z),
            frame: 0,
            still: Offsets::of(Pattern::FULL_3X3, 0).0,
            moving: Offsets::of(Pattern::FULL_3X3, 0).0,
            flags: MaskParams::HAS_HISTORY | MaskParams::KEEPS_ANSWERS,
            depth_tolerance: 0.1,
            refresh: 0,
            expansion: Expansion::PUBLISHED.to_index(),
            ..bytemuck::Zeroable::zeroed()
        }
    }

    /// A wall at distance 3 whose point appears at the centre of `px`.
    fn wall(px: UVec2) -> Sample {
        let x = (px.x as f32 + 0.5) / 4.0 * 2.0 - 1.0;
        let y = 1.0 - (px.y as f32 + 0.5) / 3.0 * 2.0;
        Sample {
            position: Vec3::new(x * 4.0 / 3.0, y, -1.0) * 3.0,
            normal: Vec3::Z,
            flags: Sample::RECEIVES,
            ..Sample::default()
        }
    }

    fn decide<const M: bool, const D: bool>(
        px: UVec2,
        estimate: f32,
        p: &MaskParams,
        bits: &[u32],
        depths: &[f32],
    ) -> Masked {
        let sample = wall(px);
        decide_from::<M, D>(px, &sample, sample.position, estimate, p, bits, depths)
    }

    /// All passes of the mask.
    fn decide_from<const M: bool, const D: bool>(
        px: UVec2,
        sample: &Sample,
        before: Vec3,
        estimate: f32,
        p: &MaskParams,
        bits: &[u32],
        depths: &[f32],
    ) -> Masked {
        const ROWS: usize = SIZE.y as usize;
        let (mut rows, mut words) = ([UVec4::ZERO; ROWS], [0; ROWS * HEARD_WORDS as usize]);
        hear_all(bits, p, &mut rows, &mut words);
        let history = DepthHistory { words: &words, depths, width: SIZE.x };
        mask::<_, M, D, true, true>(px, sample, before, estimate, p, history)
    }

    const AT: UVec2 = UVec2::new(1, 1);

    #[test]
    fn without_history_every_pixel_is_traced() {
        let p = MaskParams { flags: 0, ..params(Vec3::ZERO) };
        for estimate in [0.0, 0.3, Verdict::UNJUDGED, 1.0] {
            assert!(decide::<false, false>(AT, estimate, &p, &[0; 12], &[3.0; 12]).needs_ray);
        }
    }

    #[test]
    fn a_purple_neighbour_expands_and_a_quiet_one_does_not() {
        let p = params(Vec3::ZERO);
        let mut bits = [0; 12];
        assert!(!decide::<false, false>(AT, 1.0, &p, &bits, &[]).needs_ray);
        bits[0] = MaskBits::PURPLE.to_bits();
        let masked = decide::<false, false>(AT, 1.0, &p, &bits, &[]);
        assert!(masked.needs_ray && masked.visibility == 1.0);
        assert_eq!(bits_after_ray(masked.bits, 0.0), MaskBits::PURPLE);
        assert_eq!(bits_after_ray(masked.bits, 1.0), MaskBits::RED);
    }

    #[test]
    fn answers_are_kept_where_nothing_moved_and_rays_removed_elsewhere_only_as_published() {
        let still = params(Vec3::ZERO);
        let bits = [MaskBits::RED.to_bits(); 12];
        for estimate in [0.0, 0.7, Verdict::UNJUDGED] {
            let kept = decide::<true, false>(AT, estimate, &still, &bits, &[]);
            assert_eq!((kept.needs_ray, kept.visibility), (false, 1.0));
            assert_eq!(kept.bits, if estimate < 0.5 { MaskBits::YELLOW } else { MaskBits::RED });
        }
        let untraced = [MaskBits::BLACK.to_bits(); 12];
        assert!(decide::<true, false>(AT, 0.7, &still, &untraced, &[]).needs_ray, "nothing is known");
        let moving = params(Vec3::new(1e-4, 0.0, 0.0));
        assert!(decide::<true, false>(AT, 0.7, &moving, &bits, &[]).needs_ray);
        let published =
            MaskParams { flags: MaskParams::HAS_HISTORY | MaskParams::REMOVES_AS_PUBLISHED, ..moving };
        let removed = decide::<true, false>(AT, 0.7, &published, &bits, &[]);
        assert_eq!((removed.needs_ray, removed.visibility, removed.bits), (false, 1.0, MaskBits::BLACK));
    }

    #[test]
    fn a_narrower_rule_hears_fewer_neighbours() {
        for (rule, state, asks) in [
            (Expansion::PUBLISHED, MaskBits::GREEN, true),
            (Expansion::RAYS, MaskBits::GREEN, false),
            (Expansion::RAYS, MaskBits::WHITE, true),
            (Expansion::LEAKS, MaskBits::WHITE, false),
            (Expansion::LEAKS, MaskBits::PURPLE, true),
        ] {
            let p = MaskParams { expansion: rule.to_index(), ..params(Vec3::ZERO) };
            let mut bits = [0; 12];
            bits[0] = state.to_bits();
            assert_eq!(decide::<false, false>(AT, 1.0, &p, &bits, &[]).needs_ray, asks, "{rule:?} {state:?}");
        }
    }

    #[test]
    fn what_no_map_judged_is_traced_whatever_the_history() {
        let bits = [MaskBits::RED.to_bits(); 12];
        let published = MaskParams::HAS_HISTORY | MaskParams::REMOVES_AS_PUBLISHED;
        let p = MaskParams { flags: published, ..params(Vec3::ZERO) };
        assert!(decide::<false, false>(AT, Verdict::UNJUDGED, &p, &bits, &[]).needs_ray);
    }

    #[test]
    fn motion_finds_the_pixel_where_it_was() {
        // The last camera stood one pixel's width (at distance 3) to the left: the wall was one pixel further right.
        let p = params(Vec3::new(-2.0, 0.0, 0.0));
        let sample = wall(AT);
        let places = [&p.previous, &p.current].map(|camera| place_px(sample.position, camera));
        assert!((places[0] - Vec2::new(2.5, 1.5)).length() < 1e-5, "{places:?}");
        assert!((places[1] - Vec2::new(1.5, 1.5)).length() < 1e-5, "{places:?}");
        assert!(
            decide::<true, false>(UVec2::new(3, 1), 1.0, &p, &[0; 12], &[]).needs_ray,
            "came in from outside"
        );
        assert!(!decide::<true, false>(AT, 1.0, &p, &[0; 12], &[]).needs_ray);
    }

    /// The two cameras differ by what a compiler's rounding might make of them.
    #[test]
    fn a_camera_at_rest_moves_nothing_whatever_its_projections_round_to() {
        let moving =
            MaskParams { moving: Offsets::of(Pattern::PLUS, 0).0, ..params(Vec3::new(1e-5, 0.0, 0.0)) };
        let resting = MaskParams { flags: moving.flags | MaskParams::CAMERA_RESTS, ..moving };
        let red = [MaskBits::RED.to_bits(); 12];
        assert!(decide::<true, false>(AT, 0.7, &moving, &red, &[]).needs_ray);
        assert!(!decide::<true, false>(AT, 0.7, &resting, &red, &[]).needs_ray);
        let sample = wall(AT);
        let before = sample.position + Vec3::X * 1e-3;
        assert!(decide_from::<true, false>(AT, &sample, before, 0.7, &resting, &red, &[]).needs_ray);
    }

    #[test]
    fn what_was_behind_the_last_camera_was_not_seen() {
        let p = params(Vec3::new(0.0, 0.0, -4.0));
        assert!(decide::<true, false>(AT, 1.0, &p, &[0; 12], &[]).needs_ray);
    }

    #[test]
    fn another_depth_was_another_surface() {
        let p = params(Vec3::ZERO);
        assert!(!decide::<false, true>(AT, 1.0, &p, &[0; 12], &[3.1; 12]).needs_ray);
        assert!(decide::<false, true>(AT, 1.0, &p, &[0; 12], &[2.0; 12]).needs_ray);
        assert!(decide::<false, true>(AT, 1.0, &p, &[0; 12], &[0.0; 12]).needs_ray, "sky was there");
    }

    #[test]
    fn surfaces_that_face_away_need_nothing() {
        let p = MaskParams { light: LightParams::directional(Vec3::NEG_Z), ..params(Vec3::ZERO) };
        let masked = decide::<false, false>(AT, 0.3, &p, &[7; 12], &[]);
        assert_eq!((masked.needs_ray, masked.visibility, masked.bits), (false, 0.0, MaskBits::BLACK));
    }

    #[test]
    fn a_refresh_traces_a_quiet_pixel_in_its_turn() {
        let quiet = params(Vec3::ZERO);
        let turns = (0..8u32).filter(|&frame| {
            let p = MaskParams { frame, refresh: 4, ..quiet };
            decide::<false, false>(AT, 1.0, &p, &[0; 12], &[]).needs_ray
        });
        assert_eq!(turns.count(), 2);
    }

    /// A light's bits are found among those of others, in two words of a pixel where they straddle.
    #[test]
    fn each_light_reads_its_own_history() {
        for (light, count) in [(0, 12), (9, 12), (10, 12), (11, 12), (10, 42), (21, 42), (41, 42)] {
            let words = lt_mask::words_for_lights(count);
            let mut bits = [0; 48];
            let mut masks = [lt_mask::PackedMask::default(); 12];
            masks[0] = masks[0].with_light(light, MaskBits::PURPLE);
            for (i, mask) in masks.iter().enumerate() {
                let all = mask.0.to_array();
                bits[i * words as usize..][..words as usize].copy_from_slice(&all[..words as usize]);
            }
            for asking in 0..count {
                let quiet = params(Vec3::ZERO);
                let light_params = LightParams { number: asking, mask_words: words, ..quiet.light };
                let p = MaskParams { light: light_params, ..quiet };
                assert_eq!(decide::<false, false>(AT, 1.0, &p, &bits, &[]).needs_ray, asking == light);
            }
        }
    }
}
