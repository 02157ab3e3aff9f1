//! The temporal mask on the CPU: histories in blocks, two that take turns.

use lt_mask::{MaskBits, Pattern};
use lt_math::glam::Vec3;
use lt_shaders::abi::{MaskParams, Sample};
use rayon::prelude::*;

use super::asks::Asks;
use super::mask_batch::{BlockPixels, Frames, mask_block};
use super::planes::{BlockBits, PIECE, pack, store_piece};
use super::tiles::{BLOCK, Tiles};
use crate::MaskEffects;

/// What one technique remembers of its last frame, and what it is about to remember of this one.
#[derive(Default)]
pub struct History {
    /// The last frame's bits and this one's, a block each.
    bits: [Vec<BlockBits>; 2],
    /// The same for depths along the view axis, in tile order; empty without the temporal depth test.
    depths: [Vec<f32>; 2],
    /// What the last frame's neighbourhoods ask for.
    asks: Asks,
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

impl History {
    /// Starts a frame: what was this frame becomes the last. Makes what the effects need and frees what they do not.
    pub fn begin(&mut self, tiles: Tiles, effects: Option<MaskEffects>) {
        let blocks = if effects.is_some() { tiles.len() / BLOCK } else { 0 };
        let depths = if effects.is_some_and(|e| e.depth_test) { tiles.len() } else { 0 };
        for buffer in &mut self.bits {
            buffer.resize(blocks, BlockBits::default());
        }
        for buffer in &mut self.depths {
            buffer.resize(depths, 0.0);
        }
        self.current = 1 - self.current;
    }

    /// Runs the mask over all pixels.
    pub fn correct(
        &mut self,
        seen: Seen<'_>,
        p: &MaskParams,
        effects: MaskEffects,
        visibility: &mut [f32],
        is_doubted: &mut [bool],
    ) {
        let [first, second] = &mut self.bits;
        let (last, bits) = if self.current == 1 { (first, second) } else { (second, first) };
        let [first, second] = &mut self.depths;
        let (last_depths, depths) = if self.current == 1 { (first, second) } else { (second, first) };
        let patterns = [p.still_pattern, p.moving_pattern].map(Pattern::from_index);
        self.asks.hear(seen.tiles, last, patterns, p.frame);
        let frames = Frames { tiles: seen.tiles, params: p, effects, asks: &self.asks, last_depths };
        let blocks = seen
            .samples
            .par_chunks(BLOCK)
            .zip(visibility.par_chunks_mut(BLOCK))
            .zip(is_doubted.par_chunks_mut(BLOCK))
            .zip(bits);
        let run = |block: usize, (((samples, visibility), is_doubted), bits), depths: &mut [f32]| {
            let previous = seen.previous.get(block * BLOCK..(block + 1) * BLOCK).unwrap_or(&[]);
            mask_block(
                frames,
                block,
                BlockPixels { samples, previous, visibility, is_doubted, bits, depths },
            );
        };
        if depths.is_empty() {
            blocks.enumerate().for_each(|(block, pixels)| run(block, pixels, &mut []));
        } else {
            let both = blocks.zip(depths.par_chunks_mut(BLOCK)).enumerate();
            both.for_each(|(block, (pixels, depths))| run(block, pixels, depths));
        }
    }

    /// After the resolve pass: remembers what the rays found.
    pub fn learn(&mut self, visibility: &[f32], is_doubted: &[bool]) {
        let blocks = self.bits[self.current]
            .par_iter_mut()
            .zip(visibility.par_chunks(BLOCK))
            .zip(is_doubted.par_chunks(BLOCK));
        blocks.for_each(|((bits, visibility), is_doubted)| {
            let pieces = visibility.as_chunks::<PIECE>().0.iter().zip(is_doubted.as_chunks::<PIECE>().0);
            for (piece, (visibility, is_traced)) in pieces.enumerate() {
                let is_hit = std::array::from_fn(|i| {
                    u8::from(is_traced[i]) & u8::from(lt_mask::is_test_shadowed(visibility[i]))
                });
                store_piece(&mut bits.hit, piece, pack(&is_hit));
            }
        });
    }

    /// This frame's bits, row by row.
    pub fn rows(&self, tiles: Tiles) -> Vec<MaskBits> {
        let tiled: Vec<MaskBits> =
            self.bits[self.current].par_iter().flat_map_iter(BlockBits::in_tile_order).collect();
        tiles.to_rows(&tiled)
    }
}
