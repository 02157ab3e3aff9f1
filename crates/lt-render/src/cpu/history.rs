//! The temporal mask on the CPU: histories in tile order, two that take turns.

use lt_mask::MaskBits;
use lt_math::glam::{UVec2, Vec3};
use lt_shaders::abi::{MaskParams, Sample};
use lt_shaders::mask::{HistorySource, bits_after_ray, mask, seen_depth};
use rayon::prelude::*;

use super::tiles::{BLOCK, Tiles};
use crate::MaskEffects;

/// What one technique remembers of its last frame, and what it is about to remember of this one.
#[derive(Default)]
pub struct History {
    /// The last frame's bits and this one's, a byte a pixel.
    bits: [Vec<u8>; 2],
    /// The same for depths along the view axis; empty without the temporal depth test.
    depths: [Vec<f32>; 2],
    /// Which of the two is this frame's.
    current: usize,
}

/// What the camera pass found, in tile order.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// The order.
    pub tiles: Tiles,
    /// Visible samples.
    pub samples: &'a [Sample],
    /// Where they were in the last frame; empty if only the camera moves.
    pub previous: &'a [Vec3],
}

/// The last frame as the kernel reads it.
#[derive(Clone, Copy)]
struct Last<'a> {
    tiles: Tiles,
    bits: &'a [u8],
    depths: &'a [f32],
}

impl HistorySource for Last<'_> {
    #[inline]
    fn bits(&self, pixel: UVec2) -> MaskBits {
        MaskBits::from_bits(u32::from(self.bits[self.tiles.index(pixel)]))
    }
    #[inline]
    fn depth(&self, pixel: UVec2) -> f32 {
        self.depths[self.tiles.index(pixel)]
    }
}

impl History {
    /// Starts a frame: what was this frame becomes the last. Makes what the effects need and frees what they do not.
    pub fn begin(&mut self, tiles: Tiles, effects: Option<MaskEffects>) {
        let bits = if effects.is_some() { tiles.len() } else { 0 };
        let depths = if effects.is_some_and(|e| e.depth_test) { tiles.len() } else { 0 };
        for buffer in &mut self.bits {
            buffer.resize(bits, 0);
        }
        for buffer in &mut self.depths {
            buffer.resize(depths, 0.0);
        }
        self.current = 1 - self.current;
    }

    /// Runs the mask kernel over all pixels.
    pub fn correct(
        &mut self,
        seen: Seen<'_>,
        p: &MaskParams,
        effects: MaskEffects,
        visibility: &mut [f32],
        is_doubted: &mut [bool],
    ) {
        match (effects.motion, effects.depth_test) {
            (false, false) => self.with_rules::<false, false>(seen, p, effects, visibility, is_doubted),
            (false, true) => self.with_rules::<false, true>(seen, p, effects, visibility, is_doubted),
            (true, false) => self.with_rules::<true, false>(seen, p, effects, visibility, is_doubted),
            (true, true) => self.with_rules::<true, true>(seen, p, effects, visibility, is_doubted),
        }
    }

    fn with_rules<const MOTION: bool, const DEPTH: bool>(
        &mut self,
        seen: Seen<'_>,
        p: &MaskParams,
        effects: MaskEffects,
        visibility: &mut [f32],
        is_doubted: &mut [bool],
    ) {
        match (effects.expands, effects.removes) {
            (true, true) => self.run::<MOTION, DEPTH, true, true>(seen, p, visibility, is_doubted),
            (true, false) => self.run::<MOTION, DEPTH, true, false>(seen, p, visibility, is_doubted),
            (false, _) => self.run::<MOTION, DEPTH, false, true>(seen, p, visibility, is_doubted),
        }
    }

    fn run<const MOTION: bool, const DEPTH: bool, const EXPANDS: bool, const REMOVES: bool>(
        &mut self,
        seen: Seen<'_>,
        p: &MaskParams,
        visibility: &mut [f32],
        is_doubted: &mut [bool],
    ) {
        let [first, second] = &mut self.bits;
        let (last_bits, bits) = if self.current == 1 { (first, second) } else { (second, first) };
        let [first, second] = &mut self.depths;
        let (last_depths, depths) = if self.current == 1 { (first, second) } else { (second, first) };
        let last = Last { tiles: seen.tiles, bits: last_bits, depths: last_depths };
        let blocks = seen
            .samples
            .par_chunks(BLOCK)
            .zip(visibility.par_chunks_mut(BLOCK))
            .zip(is_doubted.par_chunks_mut(BLOCK))
            .zip(bits.par_chunks_mut(BLOCK));
        blocks.enumerate().for_each(|(block, (((samples, visibility), is_doubted), bits))| {
            for (i, sample) in samples.iter().enumerate() {
                let Some(px) = seen.tiles.pixel(block, i) else { continue };
                let previous = seen.previous.get(block * BLOCK + i).copied().unwrap_or(sample.position);
                let masked =
                    mask::<_, MOTION, DEPTH, EXPANDS, REMOVES>(px, sample, previous, visibility[i], p, last);
                visibility[i] = masked.visibility;
                is_doubted[i] = masked.needs_ray;
                bits[i] = masked.bits.to_bits() as u8;
            }
        });
        if DEPTH {
            let both = depths.par_chunks_mut(BLOCK).zip(seen.samples.par_chunks(BLOCK));
            both.for_each(|(depths, samples)| {
                for (depth, sample) in depths.iter_mut().zip(samples) {
                    *depth = seen_depth(sample, &p.current);
                }
            });
        }
    }

    /// After the resolve pass: remembers what the rays found.
    pub fn learn(&mut self, visibility: &[f32], is_doubted: &[bool]) {
        let bits = self.bits[self.current].par_chunks_mut(BLOCK);
        let blocks = bits.zip(visibility.par_chunks(BLOCK)).zip(is_doubted.par_chunks(BLOCK));
        blocks.for_each(|((bits, visibility), is_doubted)| {
            for ((bits, &visibility), &is_traced) in bits.iter_mut().zip(visibility).zip(is_doubted) {
                if is_traced {
                    let before = MaskBits::from_bits(u32::from(*bits));
                    *bits = bits_after_ray(before, visibility).to_bits() as u8;
                }
            }
        });
    }

    /// This frame's bits, row by row.
    pub fn rows(&self, tiles: Tiles) -> Vec<MaskBits> {
        let words = tiles.to_rows(&self.bits[self.current]);
        words.into_iter().map(|b| MaskBits::from_bits(u32::from(b))).collect()
    }
}
