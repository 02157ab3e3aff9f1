//! Where a technique errs, on which side, and where it asked a ray: marks over a dimmed grey picture.

use lt_render::{
    Comparison, Row,
    metrics::{Verdict, verdict},
};

use crate::picture::Picture;

/// Lit though blocked: orange, as light leaking in.
pub const FALSE_LIT: [u8; 4] = [255, 140, 26, 255];
/// Blocked though lit: blue (the pair survives colour blindness).
pub const FALSE_SHADOWED: [u8; 4] = [48, 130, 255, 255];
/// A pixel that cost a ray.
pub const RAY: [u8; 4] = [40, 200, 120, 255];
/// No mark.
pub const CLEAR: [u8; 4] = [0; 4];

/// Marks of wrong pixels over nothing: transparent where the technique is right or nothing is visible. Where several samples,
/// layers or lights are wrong, the first one's mark. `is_valid` has a picture for each layer.
pub fn error_marks(comparison: &Comparison, row: &Row, is_valid: &[Vec<bool>]) -> Picture {
    let mut pixels = clear_pixels(comparison);
    let layers = comparison.reference.each_layer().iter().zip(row.frame.each_layer());
    for (is_valid, (truth, frame)) in is_valid.iter().zip(layers) {
        for (truth, frame) in truth.each_light().iter().zip(frame.each_light()) {
            let visibilities = truth.visibility.iter().zip(&frame.visibility);
            for (i, (&valid, (&truth, &visibility))) in is_valid.iter().zip(visibilities).enumerate() {
                let pixel = &mut pixels[comparison.samples.pixel_of(i, comparison.size[0])];
                *pixel = match verdict(truth, visibility) {
                    Verdict::FalseLit if valid && *pixel == CLEAR => FALSE_LIT,
                    Verdict::FalseShadowed if valid && *pixel == CLEAR => FALSE_SHADOWED,
                    _ => *pixel,
                };
            }
        }
    }
    Picture::new(comparison.size, pixels)
}

/// Marks over nothing of pixels with a doubted sample, in any layer.
pub fn ray_marks(comparison: &Comparison, row: &Row) -> Picture {
    let traces = row.technique.resolve.is_exact();
    let mut pixels = clear_pixels(comparison);
    for layer in row.frame.each_layer() {
        for (i, _) in layer.doubt.iter().enumerate().filter(|(_, is_doubted)| **is_doubted && traces) {
            pixels[comparison.samples.pixel_of(i, comparison.size[0])] = RAY;
        }
    }
    Picture::new(comparison.size, pixels)
}

fn clear_pixels(comparison: &Comparison) -> Vec<[u8; 4]> {
    vec![CLEAR; comparison.size[0] as usize * comparison.size[1] as usize]
}

/// The picture in grey at less than half its brightness, under the marks.
pub fn over_dimmed(marks: &Picture, picture: &[[u8; 4]]) -> Picture {
    let under = |&[r, g, b, _]: &[u8; 4]| {
        // Rec. 601 luma, scaled by 0.45.
        let grey = (u32::from(r) * 299 + u32::from(g) * 587 + u32::from(b) * 114) * 45 / 100_000;
        [grey as u8, grey as u8, grey as u8, 255]
    };
    let pixels =
        marks.pixels.iter().zip(picture).map(|(m, p)| if *m == CLEAR { under(p) } else { *m }).collect();
    Picture { pixels, ..*marks }
}

/// Marks at `1 / stride` of the size: a block shows the first mark in it, so that none is lost.
pub fn thinned(marks: &Picture, stride: u32) -> Picture {
    let (width, height) = (marks.width.div_ceil(stride), marks.height.div_ceil(stride));
    let mut pixels = vec![CLEAR; width as usize * height as usize];
    for (i, mark) in marks.pixels.iter().enumerate().filter(|(_, m)| **m != CLEAR) {
        let (x, y) = (i as u32 % marks.width / stride, i as u32 / marks.width / stride);
        let block = &mut pixels[y as usize * width as usize + x as usize];
        if *block == CLEAR {
            *block = *mark;
        }
    }
    Picture { width, height, pixels }
}

/// Marks grown by a pixel in all eight directions, so that a single one can be seen; marks never hide marks.
pub fn thickened(marks: &Picture) -> Picture {
    let (width, height) = (marks.width as usize, marks.height as usize);
    let mut grown = marks.clone();
    for (i, mark) in marks.pixels.iter().enumerate().filter(|(_, m)| **m != CLEAR) {
        let (x, y) = (i % width, i / width);
        for ny in y.saturating_sub(1)..(y + 2).min(height) {
            for nx in x.saturating_sub(1)..(x + 2).min(width) {
                let neighbour = &mut grown.pixels[ny * width + nx];
                if *neighbour == CLEAR {
                    *neighbour = *mark;
                }
            }
        }
    }
    grown
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marks(rows: &[&str]) -> Picture {
        let color = |b| match b {
            b'o' => FALSE_LIT,
            b'b' => FALSE_SHADOWED,
            _ => CLEAR,
        };
        let pixels = rows.iter().flat_map(|r| r.bytes().map(color)).collect();
        Picture::new([rows[0].len() as u32, rows.len() as u32], pixels)
    }

    #[test]
    fn a_pixel_shows_what_any_of_its_samples_is() {
        // Four by two samples are two pixels; the one sample that `sm` gets wrong lies in the second.
        let samples = lt_render::SampleGrid::of(4).unwrap();
        let comparison = Comparison { size: [2, 1], samples, ..crate::fixture::comparison() };
        assert_eq!(error_marks(&comparison, &comparison.rows[1], &[vec![true; 8]]), marks(&[".o"]));
        assert_eq!(ray_marks(&comparison, &comparison.rows[0]).pixels, [RAY; 2]);
    }

    #[test]
    fn thinning_loses_no_mark() {
        assert_eq!(thinned(&marks(&["....", ".b..", "....", "...o", "o..."]), 2), marks(&["b.", ".o", "o."]));
    }

    #[test]
    fn thickening_spares_other_marks() {
        assert_eq!(thickened(&marks(&["o..b", "....", "...."])), marks(&["oobb", "oobb", "...."]));
    }

    #[test]
    fn only_unmarked_pixels_are_dimmed() {
        let shown = over_dimmed(&marks(&["o."]), &[[200, 200, 200, 255]; 2]);
        assert_eq!(shown.pixels, [FALSE_LIT, [90, 90, 90, 255]]);
    }
}
