//! A frame's mask as planes of bits: a block of 32×32 pixels is 32 words a plane, a row each.
//!
//! Rows of bits are what neighbourhoods are made of by shifts ([`super::asks`]); pixels come and go in tile order, eight
//! by eight, and are turned by [`store_piece`].

use lt_mask::{MaskBits, MaskRow};

use super::tiles::{BLOCK, PIECE, SIDE};

/// The bits of one block; bit x of word y is the pixel at (x, y) in it. Bits outside the picture may be anything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockBits {
    /// ST: the shadow test said shadow.
    pub shadowed: [u32; SIDE as usize],
    /// LTT: a ray was traced.
    pub traced: [u32; SIDE as usize],
    /// RS: it hit something; 0 where none was traced.
    pub hit: [u32; SIDE as usize],
}

impl BlockBits {
    /// The row at `y` < 32.
    #[inline(always)]
    pub fn row(&self, y: u32) -> MaskRow {
        let y = y as usize;
        MaskRow { shadowed: self.shadowed[y], traced: self.traced[y], hit: self.hit[y] }
    }

    /// Piece `piece` < 16 of the three planes, in tile order.
    #[inline(always)]
    pub fn load(&self, piece: usize) -> [u64; 3] {
        [load_piece(&self.shadowed, piece), load_piece(&self.traced, piece), load_piece(&self.hit, piece)]
    }

    /// The inverse of [`BlockBits::load`].
    #[inline(always)]
    pub fn store(&mut self, piece: usize, [shadowed, traced, hit]: [u64; 3]) {
        store_piece(&mut self.shadowed, piece, shadowed);
        store_piece(&mut self.traced, piece, traced);
        store_piece(&mut self.hit, piece, hit);
    }

    /// The whole block in tile order.
    pub fn in_tile_order(&self) -> impl Iterator<Item = MaskBits> + '_ {
        (0..BLOCK).map(|i| {
            let (x, y) = place_in_block(i as u32);
            self.row(y).get(x)
        })
    }
}

/// The column and row of a position in a block.
pub fn place_in_block(index: u32) -> (u32, u32) {
    let even = |bits: u32| (0..5).fold(0, |packed, i| packed | (bits >> (2 * i) & 1) << i);
    (even(index), even(index >> 1))
}

/// Writes 64 bits in tile order as piece `piece` < 16 of a block's rows.
#[inline(always)]
pub fn store_piece(rows: &mut [u32; SIDE as usize], piece: usize, bits: u64) {
    let (x, y) = place_in_block((piece * PIECE) as u32);
    for (row, byte) in rows[y as usize..][..8].iter_mut().zip(rows_of_morton(bits).to_le_bytes()) {
        *row = *row & !(0xff << x) | u32::from(byte) << x;
    }
}

/// The inverse of [`store_piece`].
#[inline(always)]
pub fn load_piece(rows: &[u32; SIDE as usize], piece: usize) -> u64 {
    let (x, y) = place_in_block((piece * PIECE) as u32);
    let mut bytes = [0; 8];
    for (byte, row) in bytes.iter_mut().zip(&rows[y as usize..][..8]) {
        *byte = (row >> x) as u8;
    }
    morton_of_rows(u64::from_le_bytes(bytes))
}

/// 64 bits of an eight by eight square from Morton order (y₂x₂y₁x₁y₀x₀) to rows (y₂y₁y₀x₂x₁x₀): index bits change places
/// two by two.
#[inline(always)]
fn rows_of_morton(bits: u64) -> u64 {
    // x₀y₀x₁y₁x₂y₂ → x₀x₁y₀y₁x₂y₂ → x₀x₁x₂y₁y₀y₂ → x₀x₁x₂y₀y₁y₂, lowest first.
    swap_index_bits::<3, 4>(swap_index_bits::<2, 4>(swap_index_bits::<1, 2>(bits)))
}

/// The inverse of [`rows_of_morton`].
#[inline(always)]
fn morton_of_rows(bits: u64) -> u64 {
    swap_index_bits::<1, 2>(swap_index_bits::<2, 4>(swap_index_bits::<3, 4>(bits)))
}

/// Moves every bit to the index with bits `A` < `B` of its index exchanged.
#[inline(always)]
fn swap_index_bits<const A: u32, const B: u32>(bits: u64) -> u64 {
    let shift = (1 << B) - (1 << A);
    let mask = const { indices_with::<A, B>() };
    let moved = (bits >> shift ^ bits) & mask;
    bits ^ moved ^ moved << shift
}

/// Bits at the indices whose bit `A` is set and bit `B` is not.
const fn indices_with<const A: u32, const B: u32>() -> u64 {
    let (mut mask, mut i) = (0, 0);
    while i < 64 {
        if i >> A & 1 == 1 && i >> B & 1 == 0 {
            mask |= 1 << i;
        }
        i += 1;
    }
    mask
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_turned_to_rows() {
        for piece in 0..BLOCK / PIECE {
            for i in 0..PIECE {
                let mut rows = [0; SIDE as usize];
                store_piece(&mut rows, piece, 1 << i);
                let (x, y) = place_in_block((piece * PIECE + i) as u32);
                let mut expected = [0; SIDE as usize];
                expected[y as usize] = 1 << x;
                assert_eq!(rows, expected, "piece {piece} pixel {i}");
                assert_eq!(load_piece(&rows, piece), 1 << i, "piece {piece} pixel {i}");
                store_piece(&mut rows, piece, 0);
                assert_eq!(rows, [0; SIDE as usize], "a store replaces");
            }
        }
    }

    #[test]
    fn a_pixel_remembers_one_of_the_six_states() {
        let bits = BlockBits {
            shadowed: [0b101_010; SIDE as usize],
            traced: [0b111_100; SIDE as usize],
            hit: [0b011_000; SIDE as usize],
        };
        let states: Vec<_> = (0..6).map(|x| bits.row(7).get(x)).collect();
        let expected = [
            MaskBits::BLACK,
            MaskBits::GREEN,
            MaskBits::RED,
            MaskBits::WHITE,
            MaskBits::PURPLE,
            MaskBits::YELLOW,
        ];
        assert_eq!(states, expected);
        assert_eq!(bits.in_tile_order().nth(1), Some(bits.row(0).get(1)));
        assert_eq!(bits.in_tile_order().nth(2), Some(bits.row(1).get(0)));
    }
}
