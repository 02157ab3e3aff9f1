//! Map evaluation in batches: every test, many pixels at a time, below the shared function.
//!
//! [`lt_shaders::evaluate::evaluate`] answers one pixel; this file answers the same for 64 at once, in stages that each
//! run over arrays: settle and project, footprint, gather, bound. Stages are plain loops without branches over numbers,
//! which the compiler turns into SIMD, or explicit lanes where conditions become [`super::bits`]; [`evaluate_batch`] holds them compiled for several instruction sets and takes the
//! best that the processor has. No instruction set contracts a product and a sum, so that every one gives the bits of
//! the shared function. Tests hold that on every built-in scene.
//!
//! What the tests make of footprints is in [`super::answers`].

use lt_bvh::lanes::{Chosen, NodeLanes, Work};
use lt_math::LightProjection;
use lt_shaders::abi::ShadowParams;

use super::answers::BatchTest;
use super::bits;
use super::footprints::{Footprints, Maps, Texels};
use super::samples::Pieces;
use super::tiles::PIECE;

/// Estimate and doubt of many pixels from a map of plain depths.
///
/// `depths` are `p.map_size`², in the order of [`maps_to_tiles`](super::maps_to_tiles); `visibility` has 64 places for each of `pieces`, `doubted` a word of as many bits. Gives the bits of
/// [`evaluate`](lt_shaders::evaluate::evaluate) for each sample, in any order of samples; samples in tile order find their texels in the cache.
///
/// # Panics
/// If the lengths disagree.
pub fn evaluate_batch<T: BatchTest, const LTT: bool>(
    pieces: Pieces<'_>,
    p: &ShadowParams,
    depths: &[f32],
    visibility: &mut [f32],
    doubted: &mut [u64],
) {
    evaluate_on::<T, LTT>(pieces, p, Maps::one(p, Texels::Depths(depths)), visibility, doubted);
}

/// [`evaluate_batch`] from the levels of a directional light, finest first, with the bits of
/// [`evaluate_levels`](lt_shaders::evaluate::evaluate_levels).
///
/// `depths` are `p.map_size`² for each level, in the order of [`maps_to_tiles`](super::maps_to_tiles).
///
/// # Panics
/// If the lengths disagree.
pub fn evaluate_batch_levels<T: BatchTest, const LTT: bool>(
    pieces: Pieces<'_>,
    p: &ShadowParams,
    projections: &[LightProjection],
    depths: &[f32],
    visibility: &mut [f32],
    doubted: &mut [u64],
) {
    evaluate_on::<T, LTT>(
        pieces,
        p,
        Maps::levels(p, projections, Texels::Depths(depths)),
        visibility,
        doubted,
    );
}

/// [`evaluate_batch`] on any maps.
pub(super) fn evaluate_on<T: BatchTest, const LTT: bool>(
    pieces: Pieces<'_>,
    p: &ShadowParams,
    maps: Maps<'_>,
    visibility: &mut [f32],
    doubted: &mut [u64],
) {
    let expected = (p.map_size as usize).pow(2) * maps.projections.len();
    assert!(maps.texels.len() == expected, "{} texels, {expected} expected", maps.texels.len());
    let len = pieces.len();
    assert!(visibility.len() == len * PIECE && doubted.len() == len, "unequal lengths");
    let test = T::from_params(p.test);
    Chosen::best().run(Evaluate::<T, LTT> { test, pieces, p, maps, visibility, doubted });
}

/// The work of [`evaluate_on`].
struct Evaluate<'a, T, const LTT: bool> {
    test: T,
    pieces: Pieces<'a>,
    p: &'a ShadowParams,
    maps: Maps<'a>,
    visibility: &'a mut [f32],
    doubted: &'a mut [u64],
}

impl<T: BatchTest, const LTT: bool> Work for Evaluate<'_, T, LTT> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let Evaluate { test, pieces, p, maps, visibility, doubted } = self;
        let visibility = visibility.as_chunks_mut::<PIECE>().0;
        let mut footprints = Footprints::new();
        for ((piece, visibility), doubted) in pieces.iter().zip(visibility).zip(doubted) {
            footprints.find(lanes.rays(), piece, p, maps);
            // Whole batches of sky, or of what faces away, need no map.
            if footprints.facing.open == 0 {
                bits::paint(lanes.rays(), footprints.facing.lit, visibility);
                *doubted = 0;
                continue;
            }
            if T::PLANE_BIAS_TEXELS > 0.0 {
                footprints.bias_receivers(T::PLANE_BIAS_TEXELS, piece, p, maps);
            }
            let answers = match maps.texels {
                Texels::Depths(depths) => {
                    match maps.marked {
                        Some(_) => footprints.gather::<_, true>(lanes.rays(), depths, T::FROM_RECEIVERS),
                        None => footprints.gather::<_, false>(lanes.rays(), depths, T::FROM_RECEIVERS),
                    }
                    test.visibility_of_footprints::<LTT>(&footprints, p.epsilon)
                }
                Texels::Vectors(vectors) => {
                    maps.marked.into_iter().for_each(|depths| footprints.gather_marks(depths));
                    footprints.filtered(&test, vectors)
                }
            };
            *doubted = footprints.judge::<_, LTT>(lanes.rays(), &answers, p.epsilon, visibility);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::map_tiles::maps_to_tiles;
    use super::super::marks;
    use super::super::samples::SampleRows;
    use super::*;
    use lt_bvh::SimdLevel;
    use lt_math::glam::{UVec2, Vec3, Vec4};
    use lt_math::{Esm, Evsm, MsmHamburger, MsmHausdorff, Pcf, Sm, Vsm};
    use lt_math::{Levels, LightFrame, LightProjection, level_margin_uv};
    use lt_shaders::abi::{LightParams, Sample};
    use lt_shaders::evaluate::{
        FilteredVectors, GatheredDepths, MapSource, Verdict, evaluate, evaluate_levels,
    };
    use lt_shaders::marks::{MarkedDepths, MarkedVectors};

    /// Samples all over a map and around it, of every state, with numbers that are none among them; and a map of layers,
    /// slopes, and depths that are out of range or NaN.
    fn hard_case(count: usize) -> (Vec<Sample>, ShadowParams, Vec<f32>) {
        let mut state = 7u32;
        let mut unit = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        };
        let frame = LightFrame::from_direction(Vec3::new(0.3, -1.0, 0.2));
        let size = 64u32;
        let p = ShadowParams {
            projection: LightProjection::orthographic(&frame, Vec3::splat(-1.0), Vec3::ONE),
            light: LightParams::directional(Vec3::new(-0.28, 0.94, -0.19)),
            test: Vec4::ZERO,
            size: UVec2::ONE,
            map_size: size,
            epsilon: 0.01,
            ..bytemuck::Zeroable::zeroed()
        };
        let depths = (0..size * size)
            .map(|i| match i % 97 {
                0 => f32::NAN,
                1 => -3.0,
                2 => f32::INFINITY,
                _ if i % size < size / 3 => 0.4 + 1e-4 * unit(),
                _ if i % size < size / 2 => 0.2 + 0.004 * (i / size) as f32,
                _ => unit(),
            })
            .collect();
        let special = [f32::NAN, f32::INFINITY, 0.0, -1.0, 1e30];
        let samples = (0..count)
            .map(|i| {
                let mut at = |scale: f32| scale * (2.0 * unit() - 1.0);
                let mut position = Vec3::new(at(1.2), at(1.2), at(1.2));
                let mut normal = Vec3::new(at(1.0), at(1.0) + 0.8, at(1.0));
                match i % 53 {
                    0 => position[i % 3] = special[i % 5],
                    1 => normal[i % 3] = special[i % 5],
                    2 => normal = Vec3::ZERO,
                    _ => {}
                }
                let flags = if i % 31 == 0 { 0 } else { Sample::RECEIVES };
                Sample { position, normal, flags, ..Sample::default() }
            })
            .collect();
        (samples, p, depths)
    }

    fn shared<T: BatchTest, const LTT: bool>(
        samples: &[Sample],
        p: &ShadowParams,
        maps: Maps<'_>,
    ) -> Vec<(f32, bool)> {
        let levels = Levels { projections: maps.projections, count: maps.projections.len() as u32 };
        let words = marks::words(maps.marked.unwrap_or(&[]), p.map_size);
        let unmarked: Vec<f32> = match (maps.texels, maps.marked) {
            (Texels::Depths(depths), Some(_)) => depths.iter().map(|texel| marks::depth(*texel)).collect(),
            (Texels::Depths(depths), None) => depths.to_vec(),
            (Texels::Vectors(_), _) => Vec::new(),
        };
        let depths = &unmarked[..];
        let verdict = |sample: &Sample| match (maps.texels, maps.marked.is_some()) {
            (Texels::Depths(_), false) => of::<T, _, LTT>(sample, p, GatheredDepths { depths }, levels, maps),
            (Texels::Depths(_), true) => {
                of::<T, _, LTT>(sample, p, MarkedDepths { depths, marks: &words }, levels, maps)
            }
            (Texels::Vectors(vectors), false) => {
                of::<T, _, LTT>(sample, p, FilteredVectors { vectors }, levels, maps)
            }
            (Texels::Vectors(vectors), true) => {
                of::<T, _, LTT>(sample, p, MarkedVectors { vectors, marks: &words }, levels, maps)
            }
        };
        samples.iter().map(verdict).map(|verdict| (verdict.visibility, verdict.is_doubted)).collect()
    }

    fn of<T: BatchTest, M: MapSource, const LTT: bool>(
        sample: &Sample,
        p: &ShadowParams,
        map: M,
        levels: Levels<'_>,
        maps: Maps<'_>,
    ) -> Verdict {
        match maps.margin_uv {
            None => evaluate::<T, _, LTT>(sample, p, map),
            Some(_) => evaluate_levels::<T, _, _, LTT>(sample, p, map, levels),
        }
    }

    fn check<T: BatchTest, const LTT: bool>(params: Vec4) {
        for count in [0, 1, PIECE - 1, PIECE, PIECE + 1, 40 * PIECE + 5] {
            let (samples, mut p, depths) = hard_case(count);
            p.test = params;
            let one = [p.projection];
            check_maps::<T, LTT>(&samples, &p, (&one, &depths), None);
            // Levels of other sizes and places, their maps shifted against each other.
            let frame = LightFrame::from_direction(Vec3::new(0.3, -1.0, 0.2));
            let of = |half: f32, at: f32| {
                LightProjection::orthographic(&frame, Vec3::splat(at - half), Vec3::splat(at + half))
            };
            let projections = [of(0.3, 0.1), of(0.5, -0.2), of(1.0, 0.0)];
            let all: Vec<f32> = (0..3 * depths.len()).map(|i| depths[(i + i / 37) % depths.len()]).collect();
            let margin_uv = Some(level_margin_uv(p.map_size));
            check_maps::<T, LTT>(&samples, &p, (&projections, &all), margin_uv);
            // A spot light among the samples, with its own map and two faces of a cube.
            let (eye, cone) = (Vec3::new(0.1, 0.9, -0.2), std::f32::consts::FRAC_PI_4);
            p.light = LightParams {
                place: eye.extend(1.0),
                axis: frame.forward,
                cos_outer: 0.7,
                range_squared: 2.5,
                ..LightParams::directional(Vec3::ZERO)
            };
            let of = |frame| LightProjection::bordered(eye, &frame, cone, (2, p.map_size), 0.0, 3.0);
            let projections = [of(frame), of(LightFrame::of_cube_face(3)), of(LightFrame::of_cube_face(0))];
            check_maps::<T, LTT>(&samples, &p, (&projections, &all), margin_uv);
        }
    }

    /// By depths, and by vectors of them, both in rows.
    fn check_maps<T: BatchTest, const LTT: bool>(
        samples: &[Sample],
        p: &ShadowParams,
        (projections, depths): (&[LightProjection], &[f32]),
        margin_uv: Option<f32>,
    ) {
        let test = T::from_params(p.test);
        let vectors: Vec<Vec4> = depths.iter().map(|&depth| test.depth_vector(depth)).collect();
        for texels in [Texels::Vectors(&vectors), Texels::Depths(depths)] {
            check_texels::<T, LTT>(samples, p, Maps { projections, texels, margin_uv, marked: None });
        }
        if !LTT {
            return;
        }
        // Depths as a raster leaves them, some with marks.
        let drawn = |depth: f32| if depth.is_nan() { 0.3 } else { depth.clamp(0.0, 1.0) };
        let marked = |(i, depth): (usize, &f32)| {
            let marks = if i % 5 == 0 { (i / 5 % 4) as u32 } else { 0 };
            f32::from_bits(drawn(*depth).to_bits() | marks << 30)
        };
        let marked: Vec<f32> = depths.iter().enumerate().map(marked).collect();
        let vectors: Vec<Vec4> = depths.iter().map(|&depth| test.depth_vector(drawn(depth))).collect();
        for texels in [Texels::Vectors(&vectors), Texels::Depths(&marked)] {
            let maps = Maps { projections, texels, margin_uv, marked: Some(&marked) };
            check_texels::<T, LTT>(samples, p, maps);
        }
    }

    fn check_texels<T: BatchTest, const LTT: bool>(samples: &[Sample], p: &ShadowParams, maps: Maps<'_>) {
        let count = samples.len();
        let expected = shared::<T, LTT>(samples, p, maps);
        let (depths, vectors);
        let texels = match maps.texels {
            Texels::Depths(rows) => {
                depths = maps_to_tiles(rows, p.map_size);
                Texels::Depths(&depths)
            }
            Texels::Vectors(rows) => {
                vectors = maps_to_tiles(rows, p.map_size);
                Texels::Vectors(&vectors)
            }
        };
        let marked = maps.marked.map(|rows| maps_to_tiles(rows, p.map_size));
        let maps = Maps { texels, marked: marked.as_deref(), ..maps };
        let test = T::from_params(p.test);
        for level in SimdLevel::available() {
            let rows = SampleRows::of(samples);
            let pieces = rows.pieces();
            let (mut lit, mut words) = (vec![0.25; pieces.len() * PIECE], vec![7; pieces.len()]);
            let (visibility, doubted) = (&mut lit[..], &mut words[..]);
            let work = Evaluate::<T, LTT> { test, pieces, p, maps, visibility, doubted };
            Chosen::new(level).expect("an available level").run(work);
            for (i, (&(v, is_doubted), &lit)) in expected.iter().zip(&lit).enumerate() {
                let doubted = words[i / PIECE] >> (i % PIECE) & 1 != 0;
                let is_same = v.to_bits() == lit.to_bits() || (v.is_nan() && lit.is_nan());
                assert!(
                    is_same && is_doubted == doubted,
                    "{level:?} {i}: {lit} {doubted}, expected {v} {is_doubted}"
                );
            }
        }
        if LTT && count > 1000 && matches!(maps.texels, Texels::Depths(_)) {
            let tally = |f: &dyn Fn(&(f32, bool)) -> bool| expected.iter().filter(|v| f(v)).count();
            let kinds = [tally(&|v| v.1), tally(&|v| !v.1 && v.0 == 1.0), tally(&|v| !v.1 && v.0 == 0.0)];
            assert!(kinds.iter().all(|&count| count > 30), "all kinds occur: {kinds:?}");
        }
    }

    #[test]
    fn vsm_batches_have_the_bits_of_the_shared_function() {
        for min_variance in [0.0, 1e-10, 1e-3] {
            check::<Vsm, false>(Vec4::splat(min_variance));
            check::<Vsm, true>(Vec4::splat(min_variance));
        }
    }

    #[test]
    fn esm_batches_have_the_bits_of_the_shared_function() {
        for exponent in [80.0, 1e9, 60.0] {
            check::<Esm, true>(Vec4::splat(exponent));
        }
        for exponent in [80.0, 0.0, -3.0, f32::NAN] {
            check::<Esm, false>(Vec4::splat(exponent));
        }
    }

    #[test]
    fn moment_batches_have_the_bits_of_the_shared_function() {
        for bias in [6e-5, 0.0, 1e-2] {
            check::<MsmHamburger, false>(Vec4::splat(bias));
            check::<MsmHamburger, true>(Vec4::splat(bias));
            check::<MsmHausdorff, false>(Vec4::splat(bias));
            check::<MsmHausdorff, true>(Vec4::splat(bias));
        }
    }

    #[test]
    fn comparing_batches_have_the_bits_of_the_shared_function() {
        for bias in [0.0, 1e-4, f32::NAN] {
            check::<Sm, false>(Vec4::splat(bias));
            check::<Pcf, false>(Vec4::splat(bias));
        }
        check::<Pcf, true>(Vec4::splat(1e-4));
    }

    #[test]
    fn evsm_batches_have_the_bits_of_the_shared_function() {
        for (up, down, min_variance) in [
            (20.0, 5.0, 1e-10),
            (42.0, 1e9, 0.0),
            (0.0, 5.0, 1e-10),
            (5.0, 40.0, 1e-6),
            (f32::NAN, 5.0, 1e-10),
        ] {
            let params = Vec4::new(up, down, min_variance, 0.0);
            check::<Evsm, false>(params);
            check::<Evsm, true>(params);
        }
    }
}
