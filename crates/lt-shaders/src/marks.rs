//! Marks in a map ([`lt_mask::TexelMarks`]): how the evaluate pass reads them, and which texels a ray that contradicts leaves them on.

use lt_mask::{MarksPlace, MaskBits, TexelMarks};
use lt_math::glam::{IVec2, Vec2, Vec4};
use lt_math::{Footprint, LevelSource, bilinear_footprint};

use crate::abi::{Sample, ShadowParams};
use crate::evaluate::{FilteredVectors, GatheredDepths, MapSource, TestFromParams};

/// What the words of maps ([`MarksPlace`]) hold of a footprint.
#[inline]
fn marks_of(words: &[u32], texel: IVec2, map_size: u32, level: u32) -> TexelMarks {
    let [a, b, c, d] = MarksPlace::of_footprint(texel, map_size, level);
    let read = |place: MarksPlace| place.read(words[place.word as usize]);
    read(a).and(read(b)).and(read(c).and(read(d)))
}

/// [`GatheredDepths`] with marks.
#[derive(Clone, Copy)]
pub struct MarkedDepths<'a> {
    /// See [`GatheredDepths::depths`].
    pub depths: &'a [f32],
    /// A 16th as many words.
    pub marks: &'a [u32],
}

impl MapSource for MarkedDepths<'_> {
    fn visibility<T: TestFromParams>(
        &self,
        test: T,
        footprint: Footprint,
        map_size: u32,
        level: u32,
        depth: f32,
    ) -> f32 {
        GatheredDepths { depths: self.depths }.visibility(test, footprint, map_size, level, depth)
    }
    #[inline]
    fn marks(&self, texel: IVec2, map_size: u32, level: u32) -> TexelMarks {
        marks_of(self.marks, texel, map_size, level)
    }
}

/// [`FilteredVectors`] with marks.
#[derive(Clone, Copy)]
pub struct MarkedVectors<'a> {
    /// See [`FilteredVectors::vectors`].
    pub vectors: &'a [Vec4],
    /// A 16th as many words.
    pub marks: &'a [u32],
}

impl MapSource for MarkedVectors<'_> {
    fn visibility<T: TestFromParams>(
        &self,
        test: T,
        footprint: Footprint,
        map_size: u32,
        level: u32,
        depth: f32,
    ) -> f32 {
        FilteredVectors { vectors: self.vectors }.visibility(test, footprint, map_size, level, depth)
    }
    #[inline]
    fn marks(&self, texel: IVec2, map_size: u32, level: u32) -> TexelMarks {
        marks_of(self.marks, texel, map_size, level)
    }
}

/// The part of a map on which things that move are drawn: least and greatest texture coordinates.
///
/// What a ray contradicts there may be their doing, and gone in the next frame: it leaves no marks, or everything that they ever passed
/// would be traced for good.
#[inline]
pub fn is_stirred(uv: Vec2, moving: Vec4, map_size: u32) -> bool {
    // The footprint reaches a texel to either side.
    let margin = 1.0 / map_size as f32;
    uv.x + margin >= moving.x
        && uv.y + margin >= moving.y
        && uv.x - margin <= moving.z
        && uv.y - margin <= moving.w
}

/// No part of a map: [`is_stirred`] nowhere.
pub const UNSTIRRED: Vec4 = Vec4::new(2.0, 2.0, -2.0, -2.0);

/// Whether a ray contradicted a shadow test: what it says is in `bits`, of a pixel that was traced.
#[inline]
pub fn is_contradicted(bits: MaskBits) -> bool {
    bits.is_test_shadowed() != bits.is_ray_hit()
}

/// A footprint that is to be marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stain {
    /// Whether there is one: on a map, and nothing that moves near it.
    pub is_on_map: bool,
    /// The map.
    pub level: u32,
    /// The footprint's upper left texel, which may lie beyond the map's edge.
    pub texel: IVec2,
}

/// The footprint that was read for a sample whose ray contradicts the test.
///
/// `moving` has a part of every level ([`is_stirred`]).
#[inline]
pub fn stain<L: LevelSource>(sample: &Sample, p: &ShadowParams, levels: L, moving: &[Vec4]) -> Stain {
    let found = levels.find(sample.position, p.map_size);
    let footprint = bilinear_footprint(found.point.uv * Vec2::splat(p.map_size as f32));
    let mut is_on_map = found.point.is_inside;
    if is_on_map {
        is_on_map = !is_stirred(found.point.uv, moving[found.level as usize], p.map_size);
    }
    Stain { is_on_map, level: found.level, texel: footprint.texel }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::LightParams;
    use crate::evaluate::{Verdict, evaluate, recall};
    use bytemuck::Zeroable;
    use lt_mask::marks_words;
    use lt_math::glam::Vec3;
    use lt_math::{LightFrame, LightProjection, OneLevel, Vsm};
    use std::vec;

    const SIZE: u32 = 16;

    /// A sun from above on a floor two units wide.
    fn params() -> ShadowParams {
        let frame = LightFrame::from_direction(Vec3::NEG_Y);
        ShadowParams {
            projection: LightProjection::orthographic(&frame, Vec3::splat(-1.0), Vec3::ONE),
            light: LightParams::directional(Vec3::Y),
            test: Vec4::splat(1e-6),
            map_size: SIZE,
            epsilon: 0.01,
            ..ShadowParams::zeroed()
        }
    }

    fn floor(x: f32, z: f32) -> Sample {
        Sample {
            position: Vec3::new(x, 0.0, z),
            normal: Vec3::Y,
            flags: Sample::RECEIVES,
            ..Sample::default()
        }
    }

    #[test]
    fn what_a_ray_contradicted_is_doubted_from_then_on_and_nothing_else() {
        let p = params();
        let levels = OneLevel { projection: p.projection };
        // Lit everywhere, says the map.
        let depths = vec![1.0; (SIZE * SIZE) as usize];
        let mut marks = vec![0; marks_words(u64::from(SIZE * SIZE)) as usize];
        let at = |sample: &Sample, marks: &[u32]| {
            evaluate::<Vsm, _, true>(sample, &p, MarkedDepths { depths: &depths, marks })
        };
        let wrong = floor(0.3, 0.1);
        assert_eq!((at(&wrong, &marks).visibility, at(&wrong, &marks).is_doubted), (1.0, false));
        let stain = stain(&wrong, &p, levels, &[UNSTIRRED]);
        assert!(stain.is_on_map);
        for place in MarksPlace::of_footprint(stain.texel, SIZE, stain.level) {
            marks[place.word as usize] |= place.bits(TexelMarks::against(false));
        }
        let recalled = at(&wrong, &marks);
        assert_eq!((recalled.visibility, recalled.is_doubted), (Verdict::RECALLED_LIT, true));
        // A texel is an eighth: a footprint reaches two of them.
        for (x, is_near) in [(0.3 + 0.12, true), (0.3 - 0.12, true), (0.3 + 0.26, false), (0.3 - 0.26, false)]
        {
            assert_eq!(at(&floor(x, 0.1), &marks).is_doubted, is_near, "{x}");
        }
        let marks = vec![!0u32 / 3 * 2; marks.len()];
        assert!(!at(&wrong, &marks).is_doubted, "these were wrong about shadows");
    }

    #[test]
    fn a_mark_doubts_only_what_was_trusted() {
        let lit = Verdict { visibility: 1.0, is_doubted: false };
        let shadowed = Verdict { visibility: 0.0, is_doubted: false };
        let between = Verdict { visibility: 0.3, is_doubted: true };
        assert_eq!(recall(lit, TexelMarks::LIT).visibility, Verdict::RECALLED_LIT);
        assert_eq!(recall(shadowed, TexelMarks::SHADOWED).visibility, Verdict::RECALLED_SHADOWED);
        assert_eq!(recall(lit, TexelMarks::SHADOWED), lit);
        assert_eq!(recall(shadowed, TexelMarks::LIT), shadowed);
        assert_eq!(recall(between, TexelMarks::LIT.and(TexelMarks::SHADOWED)), between);
        const { assert!(Verdict::RECALLED_LIT < 1.0 && Verdict::RECALLED_SHADOWED > 0.0) };
    }

    #[test]
    fn nothing_is_marked_off_the_map_nor_where_things_move() {
        let p = params();
        let levels = OneLevel { projection: p.projection };
        assert!(!stain(&floor(3.0, 0.0), &p, levels, &[UNSTIRRED]).is_on_map);
        let uv = p.projection.project(floor(0.5, 0.5).position).uv;
        let around = |margin: f32| Vec4::new(uv.x - margin, uv.y - margin, uv.x + margin, uv.y + margin);
        let marked = |x: f32| stain(&floor(x, 0.5), &p, levels, &[around(0.1)]).is_on_map;
        assert!(!marked(0.5) && !marked(0.5 + 0.2) && !marked(0.5 + 0.3), "a footprint reaches in");
        assert!(marked(0.5 - 0.4) && marked(0.5 + 0.4));
    }
}
