//! The resolve pass in the light's own space: the rays' answers without a ray.

use lt_bvh::{AnyHit, offset_origin};
use lt_irregular::{Bounds, Casters, LightBvh, Scratch};
use lt_math::glam::{Vec3, Vec4};
use lt_shaders::abi::Sample;
use lt_shaders::evaluate::settle;
use rayon::prelude::*;

use super::tiles::BLOCK;
use crate::packed::Trees;
use crate::{PackedScene, RenderError};

/// Share of a scene's size by which its box is widened, so that it holds the ray origins just above the surfaces.
const MARGIN: f32 = 1e-4;

/// Which pixels are to be answered.
pub(super) struct Todo<'a> {
    pub light: Vec4,
    /// Every pixel that faces the light, not only the doubted ones.
    pub trace_all: bool,
    pub samples: &'a [Sample],
    pub is_doubted: &'a [bool],
}

fn casters(scene: &PackedScene) -> Casters<'_> {
    Casters { root: &scene.nodes()[scene.root() as usize], triangles: scene.triangles() }
}

/// The tree over a scene for a homogeneous light.
///
/// # Errors
/// [`RenderError::Unsupported`] for a scene of placed copies: the tree is over triangles in world space.
pub(super) fn tree(scene: &PackedScene, light: Vec4) -> Result<LightBvh, RenderError> {
    if matches!(scene.trees(), Trees::Instanced(_)) {
        return Err(RenderError::Unsupported(
            "the resolver `light` needs a scene baked into one tree, and this one has placed copies: use rays".to_owned(),
        ));
    }
    let bounds = scene.bounds();
    let margin = Vec3::splat((bounds.max - bounds.min).max_element() * MARGIN);
    let domain = Bounds { low: bounds.min - margin, high: bounds.max + margin };
    Ok(LightBvh::build(light, domain, casters(scene)))
}

/// Answers the pixels; returns how many.
pub(super) fn resolve<A: AnyHit + Sync>(
    scene: &PackedScene,
    tree: &LightBvh,
    todo: &Todo<'_>,
    any_hit: A,
    visibility: &mut [f32],
) -> u64 {
    let blocks = visibility
        .par_chunks_mut(BLOCK)
        .zip(todo.samples.par_chunks(BLOCK))
        .zip(todo.is_doubted.par_chunks(BLOCK));
    let one = |batch: &mut Batch, ((visibility, samples), is_doubted): ((&mut [f32], &[Sample]), &[bool])| {
        batch.pixels.clear();
        batch.origins.clear();
        for (i, sample) in samples.iter().enumerate() {
            let is_asked = if todo.trace_all {
                let (verdict, is_settled) = settle(sample, todo.light);
                visibility[i] = verdict.visibility;
                !is_settled
            } else {
                is_doubted[i]
            };
            if is_asked {
                batch.pixels.push(i);
                batch.origins.push(offset_origin(sample.position, sample.normal, sample.magnitude));
            }
        }
        batch.is_blocked.resize(batch.origins.len(), false);
        tree.occluded(casters(scene), &batch.origins, any_hit, &mut batch.is_blocked, &mut batch.scratch);
        for (&pixel, &is_blocked) in batch.pixels.iter().zip(&batch.is_blocked) {
            visibility[pixel] = if is_blocked { 0.0 } else { 1.0 };
        }
        batch.origins.len() as u64
    };
    blocks.map_init(Batch::default, one).sum()
}

/// The points of one block and the pixels they belong to.
#[derive(Default)]
struct Batch {
    pixels: Vec<usize>,
    origins: Vec<Vec3>,
    is_blocked: Vec<bool>,
    scratch: Scratch,
}
