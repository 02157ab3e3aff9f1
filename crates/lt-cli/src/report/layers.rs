//! Pictures as layers: the reference, and per technique what lies over it, as data URIs of a bounded total size.

use anyhow::Context;
use base64::{Engine, prelude::BASE64_STANDARD};
use lt_render::{Comparison, Row};
use rayon::prelude::*;
use serde::Serialize;

use crate::{error_map, picture::Picture};

/// Most characters that all data URIs of a report may take together.
pub const BUDGET: usize = 16_000_000;
/// Pixels above which pictures are shown smaller: a little over 1920 × 1080.
const MAX_SHOWN_PIXELS: u64 = 2_100_000;

/// Data URIs of all layers.
#[derive(Debug, Serialize)]
pub struct Layers {
    /// Every how-manieth pixel is shown.
    pub stride: u32,
    reference: String,
    techniques: Vec<TechniqueLayers>,
}

/// What one technique lays over the reference.
#[derive(Debug, Serialize)]
struct TechniqueLayers {
    picture: String,
    errors: String,
    rays: String,
}

impl Layers {
    /// Encodes all layers, thinned as little as the budget allows.
    ///
    /// # Errors
    /// A picture that cannot be encoded.
    pub fn fitting(comparison: &Comparison, is_valid: &[Vec<bool>], budget: usize) -> anyhow::Result<Self> {
        let pixels = u64::from(comparison.size[0]) * u64::from(comparison.size[1]);
        let first = (1..).find(|&s: &u32| pixels / u64::from(s * s) <= MAX_SHOWN_PIXELS).unwrap_or(1);
        let mut layers = Self::encode(comparison, is_valid, first)?;
        // A picture of one pixel always fits, unless the techniques are beyond counting.
        while layers.bytes() > budget && layers.stride < comparison.size[0].max(comparison.size[1]) {
            layers = Self::encode(comparison, is_valid, layers.stride + 1)?;
        }
        Ok(layers)
    }

    fn encode(comparison: &Comparison, is_valid: &[Vec<bool>], stride: u32) -> anyhow::Result<Self> {
        let reference = Picture::new(comparison.size, comparison.reference_picture.clone()).thinned(stride);
        let techniques: anyhow::Result<Vec<_>> = comparison
            .rows
            .par_iter()
            .map(|row| technique_layers(comparison, row, is_valid, stride))
            .collect();
        Ok(Self { stride, reference: data_uri(&reference)?, techniques: techniques? })
    }

    fn bytes(&self) -> usize {
        let of = |t: &TechniqueLayers| t.picture.len() + t.errors.len() + t.rays.len();
        self.reference.len() + self.techniques.iter().map(of).sum::<usize>()
    }
}

fn technique_layers(
    comparison: &Comparison,
    row: &Row,
    is_valid: &[Vec<bool>],
    stride: u32,
) -> anyhow::Result<TechniqueLayers> {
    let changed = Picture::new(comparison.size, changed_pixels(&comparison.reference_picture, &row.picture));
    let errors = error_map::thinned(&error_map::error_marks(comparison, row, is_valid), stride);
    let rays = error_map::thinned(&error_map::ray_marks(comparison, row), stride);
    let layers = || -> anyhow::Result<TechniqueLayers> {
        Ok(TechniqueLayers {
            picture: data_uri(&changed.thinned(stride))?,
            errors: data_uri(&error_map::thickened(&errors))?,
            rays: data_uri(&rays)?,
        })
    };
    layers().with_context(|| format!("report pictures of {}", row.technique))
}

/// The pixels of `picture` that differ from the reference; transparent where they do not.
fn changed_pixels(reference: &[[u8; 4]], picture: &[[u8; 4]]) -> Vec<[u8; 4]> {
    reference.iter().zip(picture).map(|(r, p)| if r == p { error_map::CLEAR } else { *p }).collect()
}

fn data_uri(picture: &Picture) -> anyhow::Result<String> {
    Ok(format!("data:image/png;base64,{}", BASE64_STANDARD.encode(picture.to_png()?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_over_the_reference_gives_the_picture() {
        let (reference, picture) = ([[9, 9, 9, 255], [5, 5, 5, 255]], [[9, 9, 9, 255], [6, 5, 5, 255]]);
        assert_eq!(changed_pixels(&reference, &picture), [error_map::CLEAR, [6, 5, 5, 255]]);
    }

    #[test]
    fn uris_decode_to_the_picture() {
        let picture = Picture::new([2, 1], vec![[1, 2, 3, 255], [4, 5, 6, 255]]);
        let uri = data_uri(&picture).unwrap();
        let bytes = BASE64_STANDARD.decode(uri.strip_prefix("data:image/png;base64,").unwrap()).unwrap();
        assert_eq!(
            image::load_from_memory(&bytes).unwrap().to_rgba8().into_raw(),
            picture.pixels.as_flattened()
        );
    }

    #[test]
    fn noise_is_thinned_until_it_fits() {
        let mut comparison = crate::fixture::comparison();
        let mut state = 1u32;
        let mut noise = || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            [state as u8, (state >> 8) as u8, (state >> 16) as u8, 255]
        };
        comparison.size = [160, 120];
        comparison.reference_picture = (0..160 * 120).map(|_| noise()).collect();
        for row in &mut comparison.rows {
            row.picture = (0..160 * 120).map(|_| noise()).collect();
            row.frame.visibility = vec![1.0; 160 * 120];
            row.frame.doubt = vec![false; 160 * 120];
        }
        comparison.reference.visibility = vec![1.0; 160 * 120];
        let valid = [vec![true; 160 * 120]];
        let full = Layers::fitting(&comparison, &valid, BUDGET).unwrap();
        let half = Layers::fitting(&comparison, &valid, full.bytes() / 2).unwrap();
        assert_eq!((full.stride, half.stride), (1, 2));
        assert!(half.bytes() <= full.bytes() / 2);
    }
}
