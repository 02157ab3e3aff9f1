//! The alpha test on the CPU: opacity maps first, the texture where they do not know.

use lt_bvh::AnyHit;
use lt_math::glam::{Vec2, Vec3, Vec4};
use lt_shaders::abi::{Material, Vertex};
use lt_shaders::depth::weights_at;
use lt_shaders::surface::{Coverage, blocks, corners_of};

use super::opacity::{OpacityMap, OpacityMaps};

/// The alpha test of the CPU's rays: [`Coverage`], asked where the maps do not know.
#[derive(Clone, Copy)]
pub struct MappedCoverage<'a> {
    pub(super) coverage: Coverage<'a>,
    pub(super) maps: &'a OpacityMaps,
}

impl<'a> MappedCoverage<'a> {
    /// Where a triangle blocks light, whatever flags are required.
    #[inline]
    pub(crate) fn of(&self, triangle: u32) -> TriangleCoverage<'a> {
        let corners = corners_of(&self.coverage.triangles[triangle as usize], self.coverage.vertices);
        TriangleCoverage {
            map: self.maps.of(triangle),
            material: &self.coverage.materials[corners[0].material as usize],
            corners,
            alpha_texels: self.coverage.alpha_texels,
        }
    }
}

impl AnyHit for MappedCoverage<'_> {
    #[inline]
    fn accepts(&self, triangle: u32, u: f32, v: f32) -> bool {
        match self.maps.verdict(triangle, u, v) {
            Some(covers) => covers,
            None => self.coverage.accepts(triangle, u, v),
        }
    }
}

/// Where one triangle blocks light ([`lt_shaders::surface::blocks`]).
#[derive(Clone, Copy)]
pub(crate) struct TriangleCoverage<'a> {
    map: Option<OpacityMap<'a>>,
    corners: [Vertex; 3],
    material: &'a Material,
    alpha_texels: &'a [u32],
}

impl TriangleCoverage<'_> {
    /// Bits of `which` at whose points the triangle, seen on a map, blocks light. Bits are those of four by four texels, row by row; `first` is the
    /// centre of the first one. `on_map`: the corners in homogeneous texels.
    #[inline(always)]
    pub fn blocked(&self, on_map: &[Vec4; 3], first: Vec2, which: u32) -> u32 {
        let (mut rest, mut blocked) = (which, 0);
        while rest != 0 {
            let i = rest.trailing_zeros();
            rest &= rest - 1;
            let weights = weights_at(first + of_tile(i), on_map);
            // The map knows points of the triangle only; coverage is that of snapped corners, and may reach beyond.
            let is_within = weights.cmpge(Vec3::ZERO).all();
            let known = match &self.map {
                Some(map) if is_within => map.verdict(map.cell(weights.y, weights.z)),
                _ => None,
            };
            blocked |= u32::from(known.unwrap_or_else(|| self.blocks(weights))) << i;
        }
        blocked
    }

    /// What the texture says.
    fn blocks(&self, weights: Vec3) -> bool {
        blocks(self.material, &self.corners, weights, self.alpha_texels)
    }
}

/// How far a texel of four by four is from the first.
#[inline(always)]
fn of_tile(texel: u32) -> Vec2 {
    Vec2::new((texel & 3) as f32, (texel >> 2) as f32)
}

#[cfg(test)]
mod tests {
    use lt_scene::Source;

    use super::*;
    use crate::PackedScene;

    #[test]
    fn texels_are_blocked_where_the_texture_blocks_them() {
        for name in ["fence", "square:4"] {
            let packed = PackedScene::new(&Source::open(name, 1).unwrap().pose(0.0).unwrap()).unwrap();
            let covers = packed.coverage(Material::CASTS);
            let asking = packed.triangles().iter().enumerate().filter(|(_, t)| !t.is_opaque());
            let (mut state, mut blocked, mut beside) = (1u32, 0, 0);
            let mut number = |range: f32| {
                state = state.wrapping_mul(1664525).wrapping_add(1013904223);
                (state >> 8) as f32 / 16777216.0 * range
            };
            for (triangle, _) in asking.step_by(7) {
                let of = covers.of(triangle as u32);
                for _ in 0..40 {
                    // One in four is seen in perspective.
                    let w = if number(4.0) < 1.0 { 0.5 } else { 1.0 };
                    let corners = [1.0, w, 1.0].map(|w| Vec4::new(number(40.0), number(40.0), 0.5, w));
                    let (first, which) =
                        (Vec2::new(0.5 + number(30.0).floor(), 0.5 + number(40.0).floor()), 0xbeef);
                    let got = of.blocked(&corners, first, which);
                    for i in 0..16u32 {
                        let weights = weights_at(first + of_tile(i), &corners);
                        let truth = which >> i & 1 == 1 && of.blocks(weights);
                        assert_eq!(got >> i & 1 == 1, truth, "{name} {triangle}: {corners:?} {first} {i}");
                        blocked += u32::from(truth);
                        beside += u32::from(weights.min_element() < 0.0 && truth);
                    }
                }
            }
            assert!(blocked > 1000 && beside > 100, "{name}: {blocked}, {beside}");
        }
    }
}
