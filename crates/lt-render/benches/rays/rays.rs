//! Rays and the pixels that send them.

use lt_bvh::Ray;
use lt_math::glam::UVec2;
use lt_render::Sample;
use lt_shaders::{abi::LightParams, evaluate::settle, resolve::shadow_ray};

/// A list of shadow rays.
#[derive(Clone)]
pub struct RayList {
    pub rays: Vec<Ray>,
    /// Where each one starts.
    pub pixels: Vec<UVec2>,
    /// Size of the picture.
    pub size: UVec2,
}

/// Side of a tile, pixels.
const TILE: u32 = 8;

impl RayList {
    /// The light-facing pixels of a picture in 8×8 tiles, Morton order inside; tiles row by row.
    pub fn of_picture(samples: &[Sample], size: UVec2, light: &LightParams) -> Self {
        let mut list = RayList { rays: Vec::new(), pixels: Vec::new(), size };
        let columns = size.x.div_ceil(TILE);
        for tile in 0..columns * size.y.div_ceil(TILE) {
            let origin = UVec2::new(tile % columns, tile / columns) * TILE;
            for i in 0..TILE * TILE {
                let px = origin + UVec2::new(even_bits(i), even_bits(i >> 1));
                if px.cmpge(size).any() {
                    continue;
                }
                let sample = &samples[(px.y * size.x + px.x) as usize];
                if !settle(sample, light).1 {
                    list.rays.push(shadow_ray(sample, light));
                    list.pixels.push(px);
                }
            }
        }
        list
    }

    /// The rays at these positions.
    pub fn subset(&self, kept: &[usize]) -> Self {
        RayList {
            rays: kept.iter().map(|&i| self.rays[i]).collect(),
            pixels: kept.iter().map(|&i| self.pixels[i]).collect(),
            size: self.size,
        }
    }
}

/// The even bits of a 6-bit number, packed.
fn even_bits(x: u32) -> u32 {
    (x & 1) | (x >> 1 & 2) | (x >> 2 & 4)
}
