//! Texture look-up from plain buffers: wrap modes and bilinear filtering as glTF asks, the same bits everywhere.

use lt_math::float::floor;
use lt_math::glam::{Vec2, Vec4};

use crate::abi::Material;

/// Where a texture lies in a texel buffer, and how it is addressed.
#[derive(Clone, Copy)]
pub struct TextureView {
    /// Index of its first texel.
    pub offset: u32,
    /// Width in the low, height in the high 16 bits, both at least 1.
    pub size: u32,
    /// [`Material`] flags: wrap modes and filter.
    pub flags: u32,
}

/// The four texels around a point and their weights (order: x0y0, x1y0, x0y1, x1y1).
#[derive(Clone, Copy)]
pub struct TexelQuad {
    /// Texel indices into the buffer.
    pub indices: [u32; 4],
    /// Bilinear weights, sum 1.
    pub weights: Vec4,
}

impl TextureView {
    /// The texels that a look-up at `uv` blends. Every index lies inside the texture, whatever `uv` is.
    pub fn quad(&self, uv: Vec2) -> TexelQuad {
        let (width, height) = (self.size & 0xffff, self.size >> 16);
        let is_nearest = self.flags & Material::NEAREST != 0;
        let x = axis(uv.x, width, self.flags >> Material::WRAP_U_SHIFT & 3, is_nearest);
        let y = axis(uv.y, height, self.flags >> Material::WRAP_V_SHIFT & 3, is_nearest);
        let at = |column: u32, row: u32| self.offset + row * width + column;
        TexelQuad {
            indices: [at(x.low, y.low), at(x.high, y.low), at(x.low, y.high), at(x.high, y.high)],
            weights: Vec4::new(
                (1.0 - x.fraction) * (1.0 - y.fraction),
                x.fraction * (1.0 - y.fraction),
                (1.0 - x.fraction) * y.fraction,
                x.fraction * y.fraction,
            ),
        }
    }
}

/// Two neighbouring texels along one axis and the weight of the second.
#[derive(Clone, Copy)]
struct Axis {
    low: u32,
    high: u32,
    fraction: f32,
}

#[inline]
fn axis(coordinate: f32, size: u32, wrap: u32, is_nearest: bool) -> Axis {
    let unit = wrap_to_unit(coordinate, wrap);
    let last = size - 1;
    let position = unit * size as f32;
    if is_nearest {
        let texel = (position as u32).min(last);
        return Axis { low: texel, high: texel, fraction: 0.0 };
    }
    // One texel up, so that the cast never sees a negative number.
    let shifted = position + 0.5;
    let upper = (shifted as u32).min(size);
    let fraction = shifted - upper as f32;
    let before = if wrap == Material::REPEAT { last } else { 0 };
    let after = if wrap == Material::REPEAT { 0 } else { last };
    Axis {
        low: if upper == 0 { before } else { upper - 1 },
        high: if upper > last { after } else { upper },
        fraction,
    }
}

#[inline]
fn wrap_to_unit(coordinate: f32, wrap: u32) -> f32 {
    let unit = if wrap == Material::REPEAT {
        coordinate - floor(coordinate)
    } else if wrap == Material::MIRROR {
        let period = coordinate - 2.0 * floor(coordinate * 0.5);
        if period > 1.0 { 2.0 - period } else { period }
    } else {
        coordinate
    };
    // Comparisons instead of clamp: NaN ends at 0.
    if unit > 0.0 { if unit < 1.0 { unit } else { 1.0 } } else { 0.0 }
}

/// Byte `index` of a buffer of packed bytes, as a fraction of 255.
#[inline]
pub fn unorm_byte(words: &[u32], index: u32) -> f32 {
    ((words[(index >> 2) as usize] >> ((index & 3) * 8)) & 255) as f32 * (1.0 / 255.0)
}

/// The four bytes of a word, lowest first, as fractions of 255.
#[inline]
pub fn unorm_bytes(word: u32) -> Vec4 {
    Vec4::new((word & 255) as f32, (word >> 8 & 255) as f32, (word >> 16 & 255) as f32, (word >> 24) as f32)
        * (1.0 / 255.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(wrap: u32, nearest: bool) -> TextureView {
        let flags = wrap << Material::WRAP_U_SHIFT | wrap << Material::WRAP_V_SHIFT;
        TextureView {
            offset: 0,
            size: 4 | 1 << 16,
            flags: flags | if nearest { Material::NEAREST } else { 0 },
        }
    }

    fn sample(view: TextureView, u: f32) -> f32 {
        let texels = [0.0, 1.0, 2.0, 3.0];
        let quad = view.quad(Vec2::new(u, 0.5));
        (0..4).map(|i| texels[quad.indices[i] as usize] * quad.weights[i]).sum()
    }

    #[test]
    fn texel_centres_return_the_texel() {
        for wrap in [Material::REPEAT, Material::MIRROR, Material::CLAMP] {
            for i in 0..4 {
                assert_eq!(sample(row(wrap, false), (i as f32 + 0.5) / 4.0), i as f32);
                assert_eq!(sample(row(wrap, true), (i as f32 + 0.5) / 4.0), i as f32);
            }
        }
    }

    #[test]
    fn wrap_modes_differ_past_the_edge() {
        assert_eq!(sample(row(Material::REPEAT, false), 1.0), 1.5);
        assert_eq!(sample(row(Material::CLAMP, false), 1.0), 3.0);
        assert_eq!(sample(row(Material::MIRROR, true), 1.2), 3.0);
        assert_eq!(sample(row(Material::REPEAT, true), 1.2), 0.0);
        assert_eq!(sample(row(Material::REPEAT, true), -0.1), 3.0);
    }

    #[test]
    fn no_coordinate_leaves_the_texture() {
        for wrap in [Material::REPEAT, Material::MIRROR, Material::CLAMP] {
            for u in [f32::NAN, f32::INFINITY, -1e30, 1e30, 16777217.0, -0.0, 0.99999994] {
                let quad = row(wrap, false).quad(Vec2::new(u, u));
                assert!(quad.indices.iter().all(|i| *i < 4), "{wrap} {u}");
            }
        }
    }
}
