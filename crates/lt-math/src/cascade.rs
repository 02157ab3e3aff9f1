//! Cascades: a directional light's map in several levels, each finer than the next, and the level that a point asks.
//!
//! Levels are chosen by containment: the first whose box holds the point and the texels around it. So a level serves more
//! than its own slice of the view, neighbouring levels overlap, and no footprint hangs over an edge: no seams.

use crate::light_space::{LightPoint, LightProjection};
use glam::Vec3;

/// Share of the logarithmic splits, the rest is linear (the reference program of Kern et al. 2024).
pub const DEFAULT_SPLIT_BLEND: f32 = 0.85;

/// How many sizes of a level lie within a factor of two.
#[cfg(not(target_arch = "spirv"))]
const SIZES_PER_OCTAVE: f64 = 8.0;

/// View depth where slice `index` of `count` begins, by Zhang et al. 2006 (practical split scheme): `blend` times the
/// logarithmic split plus 1 − `blend` times the linear one between 0 < `near` < `far`.
///
/// `index` 0 gives `near`, `count` gives `far`. Not so for senseless arguments, whose answer means nothing.
#[cfg(not(target_arch = "spirv"))]
pub fn split_depth(index: u32, count: u32, near: f32, far: f32, blend: f32) -> f32 {
    let share = index as f32 / count as f32;
    let logarithmic = near * num_traits::Float::powf(far / near, share);
    let linear = near + (far - near) * share;
    blend * logarithmic + (1.0 - blend) * linear
}

/// An interval that holds `min` … `max` grown by the share `growth`, from a family in which neighbours agree on texels.
///
/// Its length is `texels` steps of a size 2^(k/8), k whole, and its ends are multiples of that step. While the camera
/// moves, a level that is fitted anew mostly keeps its step: the same texels cover the same places, and nothing shimmers.
/// It is at most 2^⅛ longer than asked for, and four steps. Empty or infinite intervals come back as they are.
#[cfg(not(target_arch = "spirv"))]
pub fn snapped_interval(min: f32, max: f32, growth: f32, texels: u32) -> (f32, f32) {
    let (low, high) = (f64::from(min), f64::from(max));
    let wanted = (high - low) * (1.0 + f64::from(growth));
    if !(wanted > 0.0 && wanted.is_finite() && texels > 4) {
        return (min, max);
    }
    // Two texels more at each end: flooring takes up to one from the upper, and footprints reach half a texel further.
    let least = wanted / f64::from(texels - 4);
    let class = num_traits::Float::ceil(num_traits::Float::log2(least) * SIZES_PER_OCTAVE);
    let step = num_traits::Float::exp2(class / SIZES_PER_OCTAVE);
    let middle = (low + high) * 0.5;
    let first = num_traits::Float::floor((middle - step * f64::from(texels) * 0.5) / step);
    ((first * step) as f32, ((first + f64::from(texels)) * step) as f32)
}

/// Where a point lies on the level that answers for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelPoint {
    /// Number of the level; any where the point is on none.
    pub level: u32,
    /// Place on that level; `is_inside` is false where no level holds the point.
    pub point: LightPoint,
}

/// The maps of one light.
pub trait LevelSource: Copy {
    /// Whether levels may be those of spot and point lights, whose footprints are not the same size everywhere.
    const MAY_BE_PERSPECTIVE: bool;
    /// The level that answers for a world position, on maps of `map_size`² texels.
    fn find(&self, position: Vec3, map_size: u32) -> LevelPoint;
    /// A level's projection.
    fn projection(&self, level: u32) -> LightProjection;
}

/// The one map of a directional light. All of it answers: its fit leaves a margin.
#[derive(Clone, Copy)]
pub struct OneLevel {
    /// World to map.
    pub projection: LightProjection,
}

impl LevelSource for OneLevel {
    const MAY_BE_PERSPECTIVE: bool = false;
    #[inline]
    fn find(&self, position: Vec3, _map_size: u32) -> LevelPoint {
        LevelPoint { level: 0, point: self.projection.project(position) }
    }
    #[inline]
    fn projection(&self, _level: u32) -> LightProjection {
        self.projection
    }
}

/// Cascades, finest first, or the faces of a cube: the first that holds a point and the texels around it answers.
#[derive(Clone, Copy)]
pub struct Levels<'a> {
    /// World to each map.
    pub projections: &'a [LightProjection],
    /// How many of them count.
    pub count: u32,
}

impl LevelSource for Levels<'_> {
    const MAY_BE_PERSPECTIVE: bool = true;
    #[inline]
    fn find(&self, position: Vec3, map_size: u32) -> LevelPoint {
        let margin = level_margin_uv(map_size);
        let mut found =
            LevelPoint { level: 0, point: LightPoint { uv: glam::Vec2::ZERO, depth: 0.0, is_inside: false } };
        let mut level = 0;
        while level < self.count && !found.point.is_inside {
            let point = self.projections[level as usize].project(position);
            found = LevelPoint { level, point: LightPoint { is_inside: point.is_within(margin), ..point } };
            level += 1;
        }
        found
    }
    #[inline]
    fn projection(&self, level: u32) -> LightProjection {
        self.projections[level as usize]
    }
}

/// How far from a level's edge it begins to answer: where all four texels of a footprint lie on the map.
#[inline]
pub fn level_margin_uv(map_size: u32) -> f32 {
    0.5 / map_size as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::light_frame::LightFrame;
    use proptest::prelude::*;

    #[test]
    fn splits_run_from_near_to_far_and_crowd_near_the_camera() {
        for blend in [0.0, DEFAULT_SPLIT_BLEND, 1.0] {
            let splits: std::vec::Vec<f32> = (0..=4).map(|i| split_depth(i, 4, 0.5, 128.0, blend)).collect();
            assert!((splits[0] - 0.5).abs() < 1e-4 && (splits[4] - 128.0).abs() < 1e-2, "{splits:?}");
            assert!(splits.windows(2).all(|w| w[0] < w[1]));
        }
        assert!((split_depth(2, 4, 0.5, 128.0, 1.0) - 8.0).abs() < 1e-3, "a geometric mean");
        assert!((split_depth(2, 4, 0.5, 128.0, 0.0) - 64.25).abs() < 1e-3, "an arithmetic mean");
    }

    proptest! {
        #[test]
        fn snapped_intervals_hold_what_they_must_and_not_much_more(
            min in -1e3f32..1e3, length in 1e-2f32..1e3, growth in 0.0f32..0.5, k in 1u32..64
        ) {
            let texels = 64 * k;
            let (low, high) = snapped_interval(min, min + length, growth, texels);
            let half = length * growth * 0.5;
            let slack = 1e-6 * (min.abs() + length) + 2e-3 * length;
            prop_assert!(low <= min - half * 0.9 + slack && high >= min + length + half * 0.9 - slack);
            prop_assert!(f64::from(high - low) <= f64::from(length) * f64::from(1.0 + growth) * 1.091 * 64.0 / 60.0 * 1.01);
        }

        #[test]
        fn small_moves_leave_the_texels_where_they_were(min in -100.0f32..100.0, shift in -0.01f32..0.01) {
            let (a, b) = (snapped_interval(min, min + 10.0, 0.15, 512), snapped_interval(min + shift, min + 10.0 + shift, 0.15, 512));
            let step = f64::from(a.1 - a.0) / 512.0;
            let moved = f64::from(b.0 - a.0) / step;
            prop_assert!((moved - moved.round()).abs() < 0.02 && moved.abs() <= 1.02, "{moved}");
        }
    }

    #[test]
    fn empty_and_infinite_intervals_are_left_alone() {
        for (min, max) in [(1.0, 1.0), (2.0, 1.0), (f32::NEG_INFINITY, 0.0), (0.0, f32::INFINITY)] {
            assert_eq!(snapped_interval(min, max, 0.15, 512), (min, max));
        }
        assert!(snapped_interval(f32::NAN, 1.0, 0.15, 512).0.is_nan());
    }

    #[test]
    fn the_finest_level_that_holds_the_footprint_answers() {
        let frame = LightFrame::from_direction(Vec3::NEG_Y);
        let of = |half: f32| LightProjection::orthographic(&frame, Vec3::splat(-half), Vec3::splat(half));
        let projections = [of(1.0), of(4.0), of(16.0)];
        let levels = Levels { projections: &projections, count: 3 };
        let at = |x: f32| levels.find(Vec3::new(x, 0.0, 0.0), 64);
        assert_eq!((at(0.5).level, at(3.0).level, at(-10.0).level), (0, 1, 2));
        assert!(at(0.5).point.is_inside && !at(17.0).point.is_inside && !at(f32::NAN).point.is_inside);
        // Half a texel of the first level is 1/64: there its footprints end.
        assert_eq!((at(1.0 - 0.99 / 64.0).level, at(1.0 - 1.01 / 64.0).level), (1, 0));
        assert_eq!(levels.find(Vec3::ZERO, 64).point, projections[0].project(Vec3::ZERO));
        assert!(!Levels { projections: &projections, count: 0 }.find(Vec3::ZERO, 64).point.is_inside);
    }
}
