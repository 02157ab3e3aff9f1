//! The temporal mask on the CPU: histories in blocks, two that take turns.

use lt_mask::{Expansion, MaskBits, Offsets};
use lt_shaders::abi::MaskParams;
use rayon::prelude::*;

use super::asks::Asks;
use super::bits::pack;
use super::mask_batch::Frames;
use super::planes::{BlockBits, load_piece, store_piece};
use super::tiles::{BLOCK, PIECE, PIECES, Tiles};
use crate::MaskEffects;

/// What one technique remembers of its last frame, and what it is about to remember of this one.
#[derive(Default)]
pub struct History {
    /// The last frame's bits and this one's, a block each.
    bits: [Vec<BlockBits>; 2],
    /// The same for depths along the view axis, in tile order; empty without the temporal depth test.
    depths: [Vec<f32>; 2],
    /// This frame's, see [`Memory::trusted`].
    trusted: Vec<u64>,
    /// What the last frame's neighbourhoods ask for.
    asks: Asks,
    /// Which of the two is this frame's.
    current: usize,
}

/// A history in a frame's midst.
pub struct Open<'a> {
    /// What the mask reads.
    pub frames: Frames<'a>,
    /// What it writes, by block.
    pub blocks: Vec<Memory<'a>>,
}

/// What one block remembers of this frame.
pub struct Memory<'a> {
    /// The three bits.
    pub bits: &'a mut BlockBits,
    /// Depths along the view axis; empty without the temporal depth test.
    pub depths: &'a mut [f32],
    /// Who is traced although the test was sure, a word for each piece; empty without marks.
    pub trusted: &'a mut [u64],
}

impl Memory<'_> {
    /// The same for a shorter time.
    pub fn reborrow(&mut self) -> Memory<'_> {
        Memory { bits: self.bits, depths: self.depths, trusted: self.trusted }
    }

    /// Of a piece: who the test took for shadowed, and whose ray contradicts a test that was sure.
    pub fn contradicted(&self, piece: usize) -> [u64; 2] {
        let trusted = self.trusted.get(piece).copied().unwrap_or(0);
        if trusted == 0 {
            return [0; 2];
        }
        let [shadowed, traced, hit] = self.bits.load(piece);
        [shadowed, trusted & traced & (shadowed ^ hit)]
    }

    /// After the block's rays: remembers what they found, and what was known without them.
    pub fn learn(&mut self, visibility: &[f32]) {
        for (piece, visibility) in visibility.as_chunks::<PIECE>().0.iter().enumerate() {
            let traced = load_piece(&self.bits.traced, piece);
            if traced == 0 {
                // Nothing was hit, as the mask has noted.
                continue;
            }
            let is_shadowed = std::array::from_fn(|i| u8::from(lt_mask::is_test_shadowed(visibility[i])));
            store_piece(&mut self.bits.hit, piece, traced & pack(&is_shadowed));
        }
    }
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
        let has_marks = effects.is_some_and(|e| e.marks);
        self.trusted.resize(if has_marks { tiles.len() / PIECE } else { 0 }, 0);
        self.current = 1 - self.current;
    }

    /// Makes the last frame one that trusted its map everywhere and found light.
    pub fn clear(&mut self) {
        self.bits[1 - self.current].fill(BlockBits::default());
    }

    /// Hears the last frame's neighbourhoods, and opens this frame's memory for [`super::mask_batch::mask_block`] to fill.
    pub fn open<'a>(&'a mut self, tiles: Tiles, params: &'a MaskParams, effects: MaskEffects) -> Open<'a> {
        let [first, second] = &mut self.bits;
        let (last, bits) = if self.current == 1 { (first, second) } else { (second, first) };
        let [first, second] = &mut self.depths;
        let (last_depths, depths) = if self.current == 1 { (first, second) } else { (second, first) };
        let offsets = [params.still, params.moving].map(Offsets);
        self.asks.hear(tiles, last, Expansion::from_index(params.expansion), offsets);
        let frames = Frames { tiles, params, effects, asks: &self.asks, last, last_depths };
        let (mut depths, mut trusted) = (depths.chunks_mut(BLOCK), self.trusted.chunks_mut(PIECES));
        let blocks = bits.iter_mut().map(|bits| {
            let (depths, trusted) = (depths.next(), trusted.next());
            Memory { bits, depths: depths.unwrap_or(&mut []), trusted: trusted.unwrap_or(&mut []) }
        });
        Open { frames, blocks: blocks.collect() }
    }

    /// This frame's bits, row by row.
    pub fn rows(&self, tiles: Tiles) -> Vec<MaskBits> {
        let tiled: Vec<MaskBits> =
            self.bits[self.current].par_iter().flat_map_iter(BlockBits::in_tile_order).collect();
        tiles.to_rows(&tiled)
    }
}
