//! How maps lie in memory on the CPU: tiles of four by four texels, left to right and from the top down, row by row inside.
//!
//! A tile of depths is one line of the cache. The footprints of neighbouring pixels lie on half as many lines as they do where
//! a map lies row by row, and a small triangle is drawn in fewer steps.

use bytemuck::Zeroable;
use lt_bvh::memory;

/// Texels along a tile's side.
pub const SIDE: usize = 4;
/// Texels of a tile.
pub const TEXELS: usize = SIDE * SIDE;

/// The place in memory of a map's texel; maps have `map_size` texels a side, a multiple of four.
#[inline(always)]
pub fn index(x: u32, y: u32, map_size: u32) -> u32 {
    row_start(y, map_size) + column_start(x)
}

/// What a texel's row adds to [`index`].
#[inline(always)]
pub fn row_start(y: u32, map_size: u32) -> u32 {
    (y >> 2).wrapping_mul(map_size << 2) + ((y & 3) << 2)
}

/// What a texel's column adds to [`index`].
#[inline(always)]
pub fn column_start(x: u32) -> u32 {
    (x >> 2 << 4) | (x & 3)
}

/// A row of a map, left to right.
pub fn row<T: Copy>(tiles: &[T], y: u32, map_size: u32) -> impl Iterator<Item = T> {
    let first = row_start(y, map_size) as usize;
    (0..map_size).map(move |x| tiles[first + column_start(x) as usize])
}

/// Maps of `map_size`² texels, one after the other, from rows to tiles: how [`evaluate_batch`](super::evaluate_batch) wants them.
///
/// # Panics
/// If `map_size` is no multiple of four, or `rows` are no whole maps.
pub fn maps_to_tiles<T: Zeroable + Copy + Send>(rows: &[T], map_size: u32) -> Vec<T> {
    let mut tiles = memory::zeroed(rows.len());
    places(rows.len(), map_size).for_each(|(in_tiles, in_rows)| tiles[in_tiles] = rows[in_rows]);
    tiles
}

/// The inverse of [`maps_to_tiles`].
///
/// # Panics
/// If `map_size` is no multiple of four, or `tiles` are no whole maps.
pub fn maps_to_rows<T: Zeroable + Copy + Send>(tiles: &[T], map_size: u32) -> Vec<T> {
    let mut rows = memory::zeroed(tiles.len());
    places(tiles.len(), map_size).for_each(|(in_tiles, in_rows)| rows[in_rows] = tiles[in_tiles]);
    rows
}

/// Of every texel of maps, `len` together, its places in tiles and in rows.
fn places(len: usize, map_size: u32) -> impl Iterator<Item = (usize, usize)> {
    let size = map_size as usize;
    assert!(size.is_multiple_of(SIDE), "maps of {size} texels a side have no tiles of {SIDE}");
    assert!(len.is_multiple_of(size * size), "{len} texels are no whole maps of {size} a side");
    (0..len).map(move |i| {
        let (x, y) = (i % size, i / size);
        // The rows of all maps follow one another, in tiles as well.
        (index(x as u32, y as u32, map_size) as usize, i)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_hold_every_texel_once_and_lead_back_to_rows() {
        let rows: Vec<u32> = (0..2 * 64 * 64).collect();
        let tiles = maps_to_tiles(&rows, 64);
        assert_eq!(maps_to_rows(&tiles, 64), rows);
        assert!((0..64).all(|y| row(&tiles, y, 64).eq((64 * y)..(64 * y + 64))));
        // The second tile of the second row of tiles, on the second map.
        let first = 4096 + 4 * 64 + 4;
        let tile = &tiles[4096 + (16 + 1) * TEXELS..][..TEXELS];
        assert!((0..TEXELS).all(|i| tile[i] == (first + i / SIDE * 64 + i % SIDE) as u32), "{tile:?}");
        assert!(maps_to_tiles::<f32>(&[], 64).is_empty() && maps_to_rows::<f32>(&[], 0).is_empty());
    }
}
