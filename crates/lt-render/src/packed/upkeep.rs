//! What it takes to have everything that a technique traces with up to date in a frame in which all casters move.

use std::time::Instant;

use lt_bvh::{BuildQuality, Bvh, Opaque, Ray, Simd, Tracer, triangles_of};
use lt_irregular::Casters;
use lt_math::glam::Vec3;

use super::{OpacityMaps, PackedScene, Trees};
use crate::{RenderError, Resolve};

/// What a frame does to the structures that its technique traces with. What answers in light space starts from the triangles alone, but
/// those must be made of vertices that have moved, and be looked at for their box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Upkeep {
    /// Nothing: they are made before, outside of any frame's time.
    #[default]
    Kept,
    /// The ray tracer's trees get new boxes on their old topology; a tree in light space, which has no such thing, is built anew.
    Refit,
    /// All are built anew.
    Build,
}

impl PackedScene {
    /// Builds or refits the one tree of the scene once more, all that tracing makes on first use included; the time that took, ms. What is
    /// built is as good as what the scene has, and is dropped: leaves in another order would be other names to all who know the triangles.
    ///
    /// For a resolver in light space, which asks no tree, the triangles alone are made anew. Nor does it have opacity maps made: they are filed by
    /// triangle and depend on texture coordinates, so that they stand as long as triangles are not put in another order.
    ///
    /// # Errors
    /// [`RenderError::Unsupported`] for a scene of placed copies ([`crate::Packing::bakes_copies`]); [`RenderError::Build`] as for packing.
    pub fn keep_up(&mut self, upkeep: Upkeep, resolve: Resolve) -> Result<f64, RenderError> {
        let (positions, indices, asks) = self.soup();
        let Trees::Flat(bvh) = &mut self.trees else {
            return Err(RenderError::Unsupported(
                "rebuilding every frame needs a scene packed into one tree: set `Packing::bakes_copies`"
                    .to_owned(),
            ));
        };
        let failed = |e: lt_bvh::BuildError| RenderError::Build(e.to_string());
        let start = Instant::now();
        match upkeep {
            Upkeep::Kept => {}
            _ if resolve.is_in_light_space() => {
                let triangles = triangles_of(&positions, &indices, |i| !asks[i]).map_err(failed)?;
                std::hint::black_box(Casters::of(&triangles).root);
            }
            Upkeep::Refit => bvh.refit(&positions, &indices).map_err(failed)?,
            Upkeep::Build => {
                let new =
                    Bvh::build(&positions, &indices, |i| !asks[i], BuildQuality::Medium).map_err(failed)?;
                // The tracer makes its own tree on first use.
                Simd::new(&new).occluded_batch(&[Ray::default()], Opaque, &mut [false]);
                if self.stats.masked_triangles > 0 {
                    OpacityMaps::new(new.triangles(), &self.vertices, &self.materials, &self.alpha_texels);
                }
            }
        }
        Ok(start.elapsed().as_secs_f64() * 1e3)
    }

    /// What the one tree was built from: positions and triangles by the caller's vertex indices, and which of them ask the alpha test.
    fn soup(&self) -> (Vec<Vec3>, Vec<[u32; 3]>, Vec<bool>) {
        let Trees::Flat(bvh) = &self.trees else { return Default::default() };
        let len = bvh.sources().len() + bvh.dropped().not_finite + bvh.dropped().zero_area;
        let mut positions = vec![Vec3::ZERO; self.vertices.len()];
        // What was dropped is a point here, and dropped again.
        let (mut indices, mut asks) = (vec![[0; 3]; len], vec![false; len]);
        for (triangle, &source) in bvh.triangles().iter().zip(bvh.sources()) {
            let corners = triangle.indices();
            for (index, position) in corners.into_iter().zip([triangle.v0, triangle.v1, triangle.v2]) {
                positions[index as usize] = position;
            }
            indices[source as usize] = corners;
            asks[source as usize] = !triangle.is_opaque();
        }
        (positions, indices, asks)
    }
}

#[cfg(test)]
mod tests {
    use lt_scene::Source;

    use super::*;
    use crate::Packing;

    #[test]
    fn a_scene_that_was_kept_up_is_what_it_was() {
        for name in ["fence", "cornell"] {
            let scene = Source::open(name, 1).unwrap().pose(0.0).unwrap();
            let packing = Packing { bakes_copies: true, ..Packing::default() };
            let mut packed = PackedScene::with(&scene, packing).unwrap();
            let before = packed.triangles().to_vec();
            for upkeep in [Upkeep::Build, Upkeep::Refit] {
                for resolve in [Resolve::Ray, Resolve::DivideAndConquer] {
                    assert!(packed.keep_up(upkeep, resolve).unwrap() > 0.0, "{name}: {upkeep:?} {resolve:?}");
                    assert_eq!(packed.triangles(), before, "{name}: {upkeep:?} {resolve:?}");
                    let Trees::Flat(bvh) = packed.trees() else { panic!("baked") };
                    bvh.validate().unwrap();
                }
            }
        }
    }
}
