//! 8-bit pictures and their PNG form.

use std::io::{Seek, Write};

use anyhow::Context;
use image::{ExtendedColorType, ImageEncoder, codecs::png};

/// sRGB pixels with alpha, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width · height` pixels.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// Wraps pixels of that size.
    pub fn new([width, height]: [u32; 2], pixels: Vec<[u8; 4]>) -> Self {
        Self { width, height, pixels }
    }

    /// Writes it as PNG, without an alpha channel if all of it is opaque.
    ///
    /// # Errors
    /// What the writer reports, or a pixel count that does not fit the size.
    pub fn write_png(&self, to: &mut (impl Write + Seek)) -> anyhow::Result<()> {
        let is_opaque = self.pixels.iter().all(|p| p[3] == 255);
        let expected = self.width as usize * self.height as usize;
        anyhow::ensure!(self.pixels.len() == expected, "{} pixels instead of {expected}", self.pixels.len());
        let encoder =
            png::PngEncoder::new_with_quality(to, png::CompressionType::Default, png::FilterType::Adaptive);
        let (bytes, color) = match is_opaque {
            true => (self.pixels.iter().flat_map(|p| [p[0], p[1], p[2]]).collect(), ExtendedColorType::Rgb8),
            false => (self.pixels.as_flattened().to_vec(), ExtendedColorType::Rgba8),
        };
        encoder.write_image(&bytes, self.width, self.height, color).context("PNG encoding")
    }

    /// Its PNG bytes.
    ///
    /// # Errors
    /// As [`Picture::write_png`].
    pub fn to_png(&self) -> anyhow::Result<Vec<u8>> {
        let mut bytes = std::io::Cursor::new(Vec::new());
        self.write_png(&mut bytes)?;
        Ok(bytes.into_inner())
    }

    /// Every `stride`-th pixel of every `stride`-th row.
    pub fn thinned(&self, stride: u32) -> Self {
        let (width, height) = (self.width.div_ceil(stride), self.height.div_ceil(stride));
        let pixels = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x * stride, y * stride)))
            .map(|(x, y)| self.pixels[y as usize * self.width as usize + x as usize])
            .collect();
        Self { width, height, pixels }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn png_gives_the_pixels_back() {
        for alpha in [255, 7] {
            let pixels = [[1, 2, 3, 255], [4, 5, 6, 255], [7, 8, 9, alpha], [0, 0, 0, 255], [9; 4], [255; 4]];
            let picture = Picture::new([3, 2], pixels.to_vec());
            let read = image::load_from_memory(&picture.to_png().unwrap()).unwrap().to_rgba8();
            assert_eq!(read.dimensions(), (3, 2));
            assert_eq!(read.into_raw(), picture.pixels.as_flattened());
        }
    }

    #[test]
    fn a_wrong_pixel_count_is_an_error() {
        assert!(Picture::new([2, 2], vec![[0; 4]; 3]).to_png().is_err());
    }

    #[test]
    fn thinning_keeps_the_corner() {
        let picture = Picture::new([3, 3], (0..9).map(|i| [i; 4]).collect());
        assert_eq!(picture.thinned(2), Picture::new([2, 2], [0, 2, 6, 8].map(|i| [i; 4]).to_vec()));
        assert_eq!(picture.thinned(1), picture);
    }
}
