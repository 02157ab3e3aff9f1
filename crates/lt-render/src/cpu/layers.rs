//! The layer pass on the CPU: what lies behind translucent surfaces, one layer after the other, rays in blocks.

use lt_bvh::{Hit, Ray, Tracer};
use lt_math::glam::{UVec2, Vec3};
use lt_shaders::abi::{CameraParams, Sample, Sight};
use lt_shaders::camera::previous_position;
use lt_shaders::geometry::FlatGeometry;
use lt_shaders::layers::{Surfaces, layer_at_hit, next_ray};
use lt_shaders::shade::{LinearSource, color, layer_color, light_on};
use rayon::prelude::*;

use super::samples::{Kept, Look, Points, SampleRows, keep, points};
use super::tiles::{BLOCK, PIECE, Tiles};
use super::{View, resize, tracer};
use crate::ShadedLight;

/// One layer of what the camera sees, in tile order.
#[derive(Default)]
pub struct Seen {
    pub rows: SampleRows,
    /// What shading alone reads of each sample.
    pub looks: Vec<Look>,
    /// Where each sample was in the last frame; empty while nothing in the scene moves.
    pub previous: Vec<Points>,
    /// What lies before each sample, nothing in the first layer; empty where that is the only one.
    pub sights: Vec<Sight>,
}

impl Seen {
    /// Makes room for so many samples, and drops what is not needed.
    pub fn resize(&mut self, len: usize, object_motion: bool, has_layers: bool) {
        resize(&mut self.rows.heads, len / PIECE);
        resize(&mut self.rows.positions, len / PIECE);
        resize(&mut self.rows.parts, len / PIECE);
        resize(&mut self.looks, len);
        resize(&mut self.previous, if object_motion { len / PIECE } else { 0 });
        resize(&mut self.sights, if has_layers { len } else { 0 });
    }

    /// One sample, whole.
    pub fn sample(&self, i: usize) -> Sample {
        self.rows.pieces().piece(i / PIECE).shaded_sample(i % PIECE, &self.looks[i])
    }
}

/// Finds all layers, the first one first. The scene is packed for layers, into one tree.
pub fn see(view: View<'_>, seen: &mut [Seen]) {
    let View { scene, tiles, .. } = view;
    let geometry = FlatGeometry { nodes: scene.nodes(), triangles: scene.triangles() };
    let surfaces = Surfaces {
        vertices: scene.vertices(),
        materials: scene.materials(),
        alpha_texels: scene.alpha_texels(),
        color_texels: scene.color_texels(),
    };
    let mut hits = vec![Hit::miss(0.0); tiles.len()];
    let mut beyond = vec![Sight::default(); tiles.len()];
    for layer in 0..seen.len() {
        let p = CameraParams { layers_behind: (seen.len() - 1 - layer) as u32, ..*view.params };
        let Seen { rows, looks, previous, sights } = &mut seen[layer];
        trace(View { params: &p, ..view }, sights, &mut hits);
        let found = hits.par_chunks(PIECE).zip(sights.par_chunks(PIECE));
        let rows = rows.heads.par_iter_mut().zip(&mut rows.positions).zip(&mut rows.parts);
        let pieces = rows.zip(looks.par_chunks_mut(PIECE)).zip(beyond.par_chunks_mut(PIECE));
        pieces.zip(found).for_each(|(((((head, position), parts), looks), beyond), (hits, sights))| {
            let mut samples = [Sample::default(); PIECE];
            for (((sample, beyond), sight), hit) in samples.iter_mut().zip(beyond).zip(sights).zip(hits) {
                (*sample, *beyond) = layer_at_hit(hit, &p, sight, geometry, surfaces);
            }
            Kept { head: *head, position: *position, parts: *parts } = keep(&samples, looks);
        });
        // Empty where nothing moves.
        previous.par_iter_mut().zip(hits.par_chunks(PIECE)).for_each(|(previous, hits)| {
            let before = |hit| previous_position(hit, geometry, scene.previous_positions());
            *previous = points(hits.iter().map(before));
        });
        if let Some(next) = seen.get_mut(layer + 1) {
            next.sights.copy_from_slice(&beyond);
        }
    }
}

/// The hits of one layer; a miss where nothing more is seen.
fn trace(view: View<'_>, sights: &[Sight], hits: &mut [Hit]) {
    let View { scene, tiles, params } = view;
    let (tracer, covers) = (tracer(scene), scene.coverage(0));
    let blocks = hits.par_chunks_mut(BLOCK).zip(sights.par_chunks(BLOCK)).enumerate();
    blocks.for_each(|(block, (hits, sights))| {
        let ray = |(i, sight): (usize, &Sight)| match tiles.pixel(block, i) {
            Some(at) if sight.is_open() => next_ray(at, params, sight),
            // Without direction: hits nothing.
            _ => Ray::default(),
        };
        let rays: Vec<Ray> = sights.iter().enumerate().map(ray).collect();
        tracer.closest_batch(&rays, covers, hits);
    });
}

/// All layers and the lights that reach them, front to back.
#[derive(Clone, Copy)]
pub struct LitTiles<'a> {
    /// The order of samples.
    pub tiles: Tiles,
    /// What is seen.
    pub seen: &'a [Seen],
    /// The lights of each layer, at least one.
    pub lights: &'a [Vec<ShadedLight<'a>>],
}

impl LinearSource for LitTiles<'_> {
    fn linear(&self, at: UVec2) -> Vec3 {
        let (i, row_by_row) = (self.tiles.index(at), (at.y * self.tiles.size().x + at.x) as usize);
        let layers = self.seen.iter().zip(self.lights).map(|(seen, lights)| {
            let sample = &seen.sample(i);
            let given = |l: &ShadedLight<'_>| {
                let reaching = l.tint.get(row_by_row).map_or(Vec3::ONE, |t| *t) * l.visibility[row_by_row];
                light_on(sample, reaching, &l.params)
            };
            let light = lights.iter().fold(Vec3::ZERO, |sum, l| sum + given(l));
            match seen.sights.get(i) {
                Some(sight) => layer_color(at, sample, sight, light, &lights[0].params),
                None => color(at, sample, light, &lights[0].params),
            }
        });
        layers.fold(Vec3::ZERO, |sum, layer| sum + layer)
    }
}
