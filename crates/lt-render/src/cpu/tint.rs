//! The tint pass, by rays or by what resolves the frame's doubt.
//!
//! Of rays most meet nothing translucent, which the SIMD tracer finds out; the shared kernel follows the others. The alias-free map takes all
//! samples at once. What else resolves in light space knows no transmittance and leaves this to rays.

use lt_bvh::{Bvh, Opaque, Ray, Simd, Tracer};
use lt_irregular::Casters;
use lt_math::glam::Vec3;
use lt_shaders::abi::LightParams;
use lt_shaders::resolve::{may_be_tinted, shadow_ray, trace_tint};
use lt_shaders::surface::Translucence;
use rayon::prelude::*;

use super::samples::Pieces;
use super::tiles::{BLOCK, PIECES};
use crate::light_space::transmitted;
use crate::{FrameJob, PackedScene, Resolve};

/// Fills in what translucent casters let through to each sample; returns how many rays that took.
pub fn trace(
    scene: &PackedScene,
    job: &FrameJob,
    pieces: Pieces<'_>,
    visibility: &[f32],
    tint: &mut [Vec3],
) -> u64 {
    let light = &job.shadow.light;
    let Some(bvh) = scene.translucent() else { return 0 };
    let casters = Translucence {
        triangles: bvh.triangles(),
        vertices: scene.vertices(),
        materials: scene.materials(),
        alpha_texels: scene.alpha_texels(),
        color_texels: scene.color_texels(),
    };
    if job.plan.resolve == Resolve::AliasFree {
        let reached = |&i: &usize| may_be_tinted(&pieces.sample(i), light, visibility[i]);
        let pixels: Vec<usize> = (0..visibility.len()).into_par_iter().filter(reached).collect();
        let origins: Vec<Vec3> =
            pixels.par_iter().map(|&i| shadow_ray(&pieces.sample(i), light).origin).collect();
        let mut passes = vec![Vec3::ONE; pixels.len()];
        let triangles = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
        transmitted(scene, triangles, light.place, &origins, casters, &mut passes);
        tint.fill(Vec3::ONE);
        for (&pixel, passes) in pixels.iter().zip(&passes) {
            tint[pixel] = *passes;
        }
        return pixels.len() as u64;
    }
    let blocks = tint.par_chunks_mut(BLOCK).zip(visibility.par_chunks(BLOCK)).enumerate();
    let of_block = |block: usize| pieces.range(block * PIECES..(block + 1) * PIECES);
    blocks.map(|(i, (tint, lit))| trace_block(bvh, casters, light, of_block(i), lit, tint)).sum()
}

fn trace_block(
    bvh: &Bvh,
    casters: Translucence<'_>,
    light: &LightParams,
    pieces: Pieces<'_>,
    visibility: &[f32],
    tint: &mut [Vec3],
) -> u64 {
    tint.fill(Vec3::ONE);
    let reached: Vec<usize> =
        (0..tint.len()).filter(|&i| may_be_tinted(&pieces.sample(i), light, visibility[i])).collect();
    let rays: Vec<Ray> = reached.iter().map(|&i| shadow_ray(&pieces.sample(i), light)).collect();
    let mut meets = vec![false; rays.len()];
    Simd::new(bvh).occluded_batch(&rays, Opaque, &mut meets);
    for (&i, _) in reached.iter().zip(&meets).filter(|(_, meets)| **meets) {
        tint[i] = trace_tint(&pieces.sample(i), light, visibility[i], bvh.nodes(), casters);
    }
    rays.len() as u64
}
