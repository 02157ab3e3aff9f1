//! The mask pass in batches: 64 pixels at a time, in stages over arrays, with the bits of [`lt_shaders::mask::mask`].
//!
//! What the shared function reads neighbour by neighbour is one bit of [`Asks`] here, and its rules are words of [`super::bits`]. The stages are loops without
//! branches, compiled for several instruction sets as [`super::batch`]'s are: place in the last frame, ask, decide.

use lt_bvh::lanes::{self, Chosen, NodeLanes, Work};
use lt_math::glam::UVec2;
use lt_shaders::abi::MaskParams;
use lt_shaders::evaluate::Verdict;
use lt_shaders::neighbours::asking_word;

use super::asks::Asks;
use super::bits::{less, more, pack, paint, same};
use super::heads::Facing;
use super::places::{IN_PIECE, Places, depth_along, in_this_frame};
use super::planes::{BlockBits, place_in_block};
use super::samples::{Pieces, Points};
use super::tiles::{PIECE, SIDE, Tiles};
use crate::MaskEffects;

/// What the kernel knows of both frames.
#[derive(Clone, Copy)]
pub struct Frames<'a> {
    /// The order of pixels.
    pub tiles: Tiles,
    /// Cameras, light, flags. Patterns are [`Asks`]'s matter.
    pub params: &'a MaskParams,
    /// Which parts of the kernel run.
    pub effects: MaskEffects,
    /// The last frame's neighbourhoods.
    pub asks: &'a Asks,
    /// The last frame's bits, a block each.
    pub last: &'a [BlockBits],
    /// The last frame's depths in tile order; empty without the temporal depth test.
    pub last_depths: &'a [f32],
}

/// One block's pixels in tile order, [`super::tiles::BLOCK`] of each.
pub struct BlockPixels<'a> {
    /// Visible samples.
    pub pieces: Pieces<'a>,
    /// Where they were in the last frame; empty if only the camera moves.
    pub previous: &'a [Points],
    /// The estimate; becomes 0 or 1.
    pub visibility: &'a mut [f32],
    /// Becomes who needs a ray, a word for each piece.
    pub doubted: &'a mut [u64],
    /// Becomes what to remember if every ray finds the light.
    pub bits: &'a mut BlockBits,
    /// Becomes what the next frame's depth test compares with; empty without it.
    pub depths: &'a mut [f32],
    /// Becomes who is traced although the test was sure, a word for each piece; empty without marks.
    pub trusted: &'a mut [u64],
}

/// Runs the mask over block `block`, by the best instructions that the processor has.
pub fn mask_block(frames: Frames<'_>, block: usize, pixels: BlockPixels<'_>) {
    Chosen::best().run(Mask { frames, block, pixels })
}

/// The work of [`mask_block`].
struct Mask<'a> {
    frames: Frames<'a>,
    block: usize,
    pixels: BlockPixels<'a>,
}

impl Work for Mask<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let effects = self.frames.effects;
        match (effects.motion, effects.depth_test) {
            (false, false) => self.mask_all::<_, false, false>(lanes.rays()),
            (false, true) => self.mask_all::<_, false, true>(lanes.rays()),
            (true, false) => self.mask_all::<_, true, false>(lanes.rays()),
            (true, true) => self.mask_all::<_, true, true>(lanes.rays()),
        }
    }
}

impl Mask<'_> {
    #[inline(always)]
    fn mask_all<L: lanes::Lanes, const MOTION: bool, const DEPTH: bool>(self, lanes: L) {
        let Mask { frames, block, pixels } = self;
        let Frames { tiles, params: p, effects, .. } = frames;
        let BlockPixels { pieces, previous, visibility, doubted, bits, depths, trusted } = pixels;
        let origin = tiles.origin(block);
        let turns = (p.refresh != 0).then(|| Turns::of(p.refresh, p.frame));
        // All ones where a condition of the whole frame holds.
        let when = |holds: bool| if holds { !0u64 } else { 0 };
        let has_flag = |flag| p.flags & flag != 0;
        let (has_history, expands) = (when(has_flag(MaskParams::HAS_HISTORY)), when(effects.expands));
        let may_remove = when(effects.removes && has_flag(MaskParams::REMOVES_AS_PUBLISHED));
        let keeps_answers = effects.removes && has_flag(MaskParams::KEEPS_ANSWERS);
        let pieces = pieces.iter().zip(visibility.as_chunks_mut::<PIECE>().0).zip(doubted);
        for (piece, ((samples, estimates), doubted)) in pieces.enumerate() {
            let Facing { open, lit } = samples.facing(&p.light);
            if DEPTH {
                let depths = &mut depths[piece * PIECE..][..PIECE];
                let (depth, valid) = (depth_along(samples.position(), &p.current), samples.valid());
                for i in 0..PIECE {
                    depths[i] = if valid[i] { depth[i] } else { 0.0 };
                }
            }
            if open == 0 {
                paint(lanes, lit, estimates);
                *doubted = 0;
                bits.store(piece, [0; 3]);
                if effects.marks {
                    trusted[piece] = 0;
                }
                continue;
            }
            let before = previous.get(piece).unwrap_or(samples.position());
            let mut places = in_this_frame(tiles, origin, piece);
            let due = turns.as_ref().map_or(0, |turns| turns.due(origin, piece));
            if MOTION {
                places.follow(lanes, samples.position(), before, p);
            }
            if DEPTH {
                places.compare_depths(tiles, frames.last_depths, &depth_along(before, &p.previous), p);
            }
            let [_, last_rays, last_hits] =
                if keeps_answers { frames.last[block].load(piece) } else { [0; 3] };
            let shadowed = less(lanes, estimates, lt_mask::SHADOW_TEST_THRESHOLD);
            let is_between = more(lanes, estimates, 0.0) & less(lanes, estimates, 1.0);
            let unjudged = same(lanes, estimates, &[Verdict::UNJUDGED; PIECE]);
            let asked = ask(lanes, frames, &places, shadowed);
            let unseen = !(places.valid & has_history);
            let known = last_rays & !(unseen | places.moved | due);
            let removes = may_remove & !asked;
            let by_rule = is_between & !removes | !is_between & expands & asked;
            let traced = open & !known & (unjudged | unseen | due | by_rule);
            let kept = open & known;
            if effects.marks {
                let recalled = same(lanes, estimates, &[Verdict::RECALLED_LIT; PIECE])
                    | same(lanes, estimates, &[Verdict::RECALLED_SHADOWED; PIECE]);
                trusted[piece] = traced & (!is_between | recalled);
            }
            let dark = known & last_hits | !known & shadowed;
            paint(lanes, open & !dark | lit, estimates);
            *doubted = traced;
            bits.store(piece, [open & shadowed, traced | kept, kept & last_hits]);
        }
    }
}

/// [`lt_mask::is_due`] of pieces, with one division for all of a piece's pixels.
struct Turns {
    period: u32,
    frame: u32,
    /// How far each pixel's turn is from that of the piece's first pixel, below the period.
    offsets: [u32; PIECE],
}

impl Turns {
    fn of(period: u32, frame: u32) -> Self {
        let [columns, rows] = &IN_PIECE;
        let stride = lt_mask::refresh_stride(period);
        let offset = |i: usize| (columns[i] + rows[i] * stride) % period;
        Self { period, frame, offsets: std::array::from_fn(offset) }
    }

    #[inline(always)]
    fn due(&self, origin: UVec2, piece: usize) -> u64 {
        let corner = place_in_block((piece * PIECE) as u32);
        let (x, y) = (origin.x + corner.0, origin.y + corner.1);
        let period = self.period;
        let first = (x + y * lt_mask::refresh_stride(period) + self.frame % period) % period;
        pack(&self.offsets.map(|offset| u8::from((first + offset == 0) | (first + offset == period))))
    }
}

/// Whose neighbourhood contradicts their shadow test.
#[inline(always)]
fn ask<L: lanes::Lanes>(lanes: L, frames: Frames<'_>, places: &Places, shadowed: u64) -> u64 {
    let words = frames.asks.rows().as_flattened();
    let columns = frames.tiles.columns();
    let mut at = [0; PIECE];
    for (half, at) in at.as_chunks_mut::<32>().0.iter_mut().enumerate() {
        let [shadowed, moved] = [shadowed, places.moved].map(|bits| (bits >> (32 * half)) as u32);
        let (xs, ys) = (&places.x[32 * half..][..32], &places.y[32 * half..][..32]);
        for i in 0..32 {
            let is_set = |bits: u32| bits >> i as u32 & 1 != 0;
            let row = ((ys[i] / SIDE) * columns + xs[i] / SIDE) * SIDE + ys[i] % SIDE;
            at[i] = row * 4 + asking_word(is_set(shadowed), is_set(moved));
        }
    }
    let mut asked = [0; PIECE];
    for first in (0..PIECE).step_by(L::WIDTH) {
        lanes.gather_words(words, &at[first..], &mut asked[first..]);
    }
    for (asked, x) in asked.iter_mut().zip(&places.x) {
        *asked = *asked >> (x % SIDE) & 1;
    }
    pack(&asked.map(|asked| asked as u8))
}

#[cfg(test)]
mod tests {
    use super::super::history::History;
    use super::super::samples::{SampleRows, points};
    use super::super::tiles::{BLOCK, PIECES};
    use super::*;
    use lt_bvh::SimdLevel;
    use lt_mask::{Expansion, MaskBits, Offsets, Pattern};
    use lt_math::glam::{UVec4, Vec3};
    use lt_shaders::abi::{CameraParams, LightParams, Sample};
    use lt_shaders::marks::is_contradicted;
    use lt_shaders::mask::{DepthHistory, bits_after_ray, mask, seen_depth};
    use lt_shaders::neighbours::{HEARD_WORDS, hear_all, row_words};

    fn camera(size: UVec2, eye: Vec3) -> CameraParams {
        CameraParams {
            eye,
            right: Vec3::new(1.3, 0.1, 0.0),
            up: Vec3::new(-0.05, 0.8, 0.02),
            forward: Vec3::new(0.02, 0.01, -1.0),
            size,
            // Some pictures have several samples a pixel.
            grid: if size.x.is_multiple_of(4) { UVec2::new(4, 2) } else { UVec2::ONE },
            ..bytemuck::Zeroable::zeroed()
        }
    }

    fn random(seed: u32) -> impl FnMut() -> f32 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        }
    }

    /// A picture's samples, where they were, and their estimates, of all kinds, row by row; a few are no numbers.
    fn hard_case(size: UVec2, unit: &mut impl FnMut() -> f32) -> (Vec<Sample>, Vec<Vec3>, Vec<f32>) {
        let camera = camera(size, Vec3::ZERO);
        let (mut samples, mut previous, mut estimates) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..size.x * size.y {
            let (x, y) = ((i % size.x) as f32 + 0.5, (i / size.x) as f32 + 0.5);
            let (x, y) = (x / size.x as f32 * 2.0 - 1.0, 1.0 - y / size.y as f32 * 2.0);
            let mut position = (camera.forward + camera.right * x + camera.up * y) * (2.0 + 3.0 * unit());
            let mut normal = Vec3::new(unit() - 0.5, unit() - 0.5, unit() + 0.1);
            match i % 61 {
                0 => normal = Vec3::ZERO,
                1 => position.x = f32::NAN,
                2 => position.y = f32::INFINITY,
                3 => position = -position,
                _ => {}
            }
            let flags = if i % 37 == 0 { 0 } else { Sample::RECEIVES };
            samples.push(Sample { position, normal, flags, ..Sample::default() });
            previous.push(if i % 3 == 0 {
                position
            } else {
                position + Vec3::new(unit(), unit(), unit()) * 0.2
            });
            estimates.push(match (unit() * 8.0) as u32 {
                0..3 => 0.0,
                3..6 => 1.0,
                6 => unit(),
                _ => {
                    let recalled = [Verdict::RECALLED_LIT, Verdict::RECALLED_SHADOWED];
                    [Verdict::UNJUDGED, f32::NAN, recalled[0], recalled[1]][i as usize % 4]
                }
            });
        }
        (samples, previous, estimates)
    }

    fn to_tiles<T: Copy + Default>(tiles: Tiles, rows: &[T]) -> Vec<T> {
        let at = |i: usize| tiles.pixel(i / BLOCK, i % BLOCK);
        let read = |px: UVec2| rows[(px.y * tiles.size().x + px.x) as usize];
        (0..tiles.len()).map(|i| at(i).map_or(T::default(), read)).collect()
    }

    fn pieces_of(all: &[Vec3]) -> Vec<Points> {
        all.chunks(PIECE).map(|piece| points(piece.iter().copied())).collect()
    }

    fn shared<const M: bool, const D: bool>(
        case: &(Vec<Sample>, Vec<Vec3>, Vec<f32>),
        p: &MaskParams,
        effects: MaskEffects,
        history: DepthHistory<'_>,
        i: usize,
    ) -> lt_shaders::mask::Masked {
        let px = UVec2::new(i as u32 % history.width, i as u32 / history.width);
        let (sample, before, v) = (&case.0[i], case.1[i], case.2[i]);
        match (effects.expands, effects.removes) {
            (true, true) => mask::<_, M, D, true, true>(px, sample, before, v, p, history),
            (true, false) => mask::<_, M, D, true, false>(px, sample, before, v, p, history),
            (false, true) => mask::<_, M, D, false, true>(px, sample, before, v, p, history),
            (false, false) => mask::<_, M, D, false, false>(px, sample, before, v, p, history),
        }
    }

    /// Three frames of random samples, each decided by the history that the one before left, rays and all.
    fn check(size: UVec2, p: &MaskParams, effects: MaskEffects, object_motion: bool) -> [usize; 2] {
        let tiles = Tiles::new(size);
        let mut unit = random(size.x + p.still.x + 31 * p.flags);
        let (mut bits, mut depths) = (vec![0u32; (size.x * size.y) as usize], vec![]);
        depths.resize(bits.len(), 0.0f32);
        let mut history = History::default();
        let mut tally = [0; 2];
        for frame in 0..3 {
            let mut case = hard_case(size, &mut unit);
            if !object_motion {
                case.1 = case.0.iter().map(|s| s.position).collect();
            }
            let p = MaskParams { frame, flags: if frame == 0 { 0 } else { p.flags }, ..*p };
            let mut rows = vec![UVec4::ZERO; (row_words(size.x) * size.y) as usize];
            let mut words = vec![0; rows.len() * HEARD_WORDS as usize];
            hear_all(&bits, &p, &mut rows, &mut words);
            let last = DepthHistory { words: &words, depths: &depths, width: size.x };
            let expected: Vec<_> = (0..bits.len())
                .map(|i| match (effects.motion, effects.depth_test) {
                    (false, false) => shared::<false, false>(&case, &p, effects, last, i),
                    (false, true) => shared::<false, true>(&case, &p, effects, last, i),
                    (true, false) => shared::<true, false>(&case, &p, effects, last, i),
                    (true, true) => shared::<true, true>(&case, &p, effects, last, i),
                })
                .collect();
            let rays: Vec<f32> = expected
                .iter()
                .map(|m| if m.needs_ray { f32::from(u8::from(unit() > 0.4)) } else { m.visibility })
                .collect();
            let rows = SampleRows::of(&to_tiles(tiles, &case.0));
            let previous = if object_motion { pieces_of(&to_tiles(tiles, &case.1)) } else { Vec::new() };
            let (mut lit, mut doubted) = (to_tiles(tiles, &case.2), vec![0; tiles.len() / PIECE]);
            history.begin(tiles, Some(effects));
            let seen_rays = to_tiles(tiles, &rays);
            let mut contradicted = Vec::new();
            let mut open = history.open(tiles, &p, effects);
            for (block, memory) in open.blocks.iter_mut().enumerate() {
                let range = block * BLOCK..(block + 1) * BLOCK;
                let pixels = BlockPixels {
                    pieces: rows.pieces().range(block * PIECES..(block + 1) * PIECES),
                    previous: previous.get(block * PIECES..(block + 1) * PIECES).unwrap_or(&[]),
                    visibility: &mut lit[range.clone()],
                    doubted: &mut doubted[block * PIECES..][..PIECES],
                    bits: memory.bits,
                    depths: memory.depths,
                    trusted: memory.trusted,
                };
                mask_block(open.frames, block, pixels);
                memory.learn(&seen_rays[range]);
                contradicted.extend((0..PIECES).map(|piece| memory.contradicted(piece)[1]));
            }
            let as_rows = |words: &[u64]| {
                let of_pixel = |i: usize| words[i / PIECE] >> (i % PIECE) & 1 != 0;
                tiles.to_rows(&(0..tiles.len()).map(of_pixel).collect::<Vec<_>>())
            };
            let (lit, doubted, contradicted) =
                (tiles.to_rows(&lit), as_rows(&doubted), as_rows(&contradicted));
            let learnt = history.rows(tiles);
            for (i, m) in expected.iter().enumerate() {
                let decided = (lit[i], doubted[i]);
                assert_eq!((m.visibility, m.needs_ray), decided, "{size} {effects:?} {p:?} pixel {i}");
                let after = if m.needs_ray { bits_after_ray(m.bits, rays[i]) } else { m.bits };
                assert_eq!(after, learnt[i], "{size} {effects:?} {p:?} pixel {i}");
                let marks = effects.marks && m.needs_ray && m.is_trusted && is_contradicted(after);
                assert_eq!(marks, contradicted[i], "{size} {effects:?} {p:?} pixel {i}");
                tally[usize::from(m.needs_ray)] += 1;
            }
            bits = learnt.into_iter().map(MaskBits::to_bits).collect();
            depths = case.0.iter().map(|s| seen_depth(s, &p.current)).collect();
        }
        tally
    }

    #[test]
    fn batches_decide_as_the_shared_function_for_all_patterns_effects_and_borders() {
        let mut tally = [0; 2];
        for size in [UVec2::new(64, 32), UVec2::new(35, 33), UVec2::new(7, 40)] {
            for pattern in Pattern::ALL {
                for bits in 0..32u32 {
                    let flag = |i: u32| bits >> i & 1 == 1;
                    let effects = MaskEffects {
                        motion: flag(0),
                        depth_test: flag(1),
                        expands: flag(2),
                        removes: flag(3) || !flag(2),
                        marks: bits % 3 != 0,
                    };
                    // Rays are removed as published, answers kept, neither, or (no technique does) both.
                    let removal = [MaskParams::REMOVES_AS_PUBLISHED, MaskParams::KEEPS_ANSWERS, 0, 6];
                    let expansion = if removal[bits as usize % 4] & 2 != 0 { 0 } else { bits % 3 };
                    let p = MaskParams {
                        current: camera(size, Vec3::ZERO),
                        previous: camera(size, if flag(4) { Vec3::ZERO } else { Vec3::new(0.1, 0.05, 0.3) }),
                        light: LightParams::directional(Vec3::new(0.1, 0.2, 1.0)),
                        still: Offsets::of(pattern, 1).0,
                        moving: Offsets::of(Pattern::ALL[(bits % 8) as usize], 1).0,
                        flags: MaskParams::HAS_HISTORY
                            | removal[bits as usize % 4]
                            | if flag(4) { MaskParams::CAMERA_RESTS } else { 0 },
                        expansion,
                        depth_tolerance: 0.3,
                        refresh: if pattern == Pattern::PLUS { bits % 7 } else { 0 },
                        ..bytemuck::Zeroable::zeroed()
                    };
                    let counts = check(size, &p, effects, flag(4));
                    tally = [tally[0] + counts[0], tally[1] + counts[1]];
                }
            }
        }
        assert!(tally.iter().all(|&n| n > 100_000), "both occur: {tally:?}");
    }

    #[test]
    fn every_instruction_set_decides_alike() {
        let size = UVec2::new(45, 33);
        let tiles = Tiles::new(size);
        let case = hard_case(size, &mut random(3));
        let (rows, previous) =
            (SampleRows::of(&to_tiles(tiles, &case.0)), pieces_of(&to_tiles(tiles, &case.1)));
        let mut unit = random(9);
        let last: Vec<BlockBits> = (0..tiles.len() / BLOCK)
            .map(|_| {
                let mut rows = || std::array::from_fn(|_| (unit() * 65536.0) as u32 * 65537);
                let (shadowed, traced) = (rows(), rows());
                BlockBits { shadowed, traced, hit: traced }
            })
            .collect();
        let p = MaskParams {
            current: camera(size, Vec3::ZERO),
            previous: camera(size, Vec3::new(0.1, 0.05, 0.3)),
            light: LightParams::directional(Vec3::new(0.1, 0.2, 1.0)),
            flags: MaskParams::HAS_HISTORY | MaskParams::REMOVES_AS_PUBLISHED | MaskParams::KEEPS_ANSWERS,
            depth_tolerance: 0.3,
            ..bytemuck::Zeroable::zeroed()
        };
        let mut asks = Asks::default();
        let offsets = [Pattern::GATHER_2X2, Pattern::FULL_3X3].map(|p| Offsets::of(p, 1));
        asks.hear(tiles, &last, Expansion::PUBLISHED, offsets);
        let last_depths: Vec<f32> = (0..tiles.len()).map(|i| 2.0 + (i % 5) as f32 * 0.7).collect();
        let effects =
            MaskEffects { motion: true, depth_test: true, expands: true, removes: true, marks: true };
        let frames =
            Frames { tiles, params: &p, effects, asks: &asks, last: &last, last_depths: &last_depths };
        let by = |run: &dyn Fn(usize, BlockPixels<'_>)| {
            let mut all = Vec::new();
            for block in 0..tiles.len() / BLOCK {
                let range = block * BLOCK..(block + 1) * BLOCK;
                let mut visibility = to_tiles(tiles, &case.2)[range.clone()].to_vec();
                let (mut doubted, mut trusted, mut depths) =
                    (vec![7; PIECES], vec![7; PIECES], vec![0.0; BLOCK]);
                let mut bits = BlockBits::default();
                let pixels = BlockPixels {
                    pieces: rows.pieces().range(block * PIECES..(block + 1) * PIECES),
                    previous: &previous[block * PIECES..(block + 1) * PIECES],
                    visibility: &mut visibility,
                    doubted: &mut doubted,
                    bits: &mut bits,
                    depths: &mut depths,
                    trusted: &mut trusted,
                };
                run(block, pixels);
                all.push((
                    visibility,
                    doubted,
                    trusted,
                    bits,
                    depths.iter().map(|d| d.to_bits()).collect::<Vec<_>>(),
                ));
            }
            all
        };
        let portable = by(&|block, pixels| Chosen::Portable.run(Mask { frames, block, pixels }));
        assert!(by(&|block, pixels| mask_block(frames, block, pixels)) == portable);
        for level in SimdLevel::available() {
            let chosen = Chosen::new(level).expect("an available level");
            assert!(by(&|block, pixels| chosen.run(Mask { frames, block, pixels })) == portable, "{level:?}");
        }
    }
}
