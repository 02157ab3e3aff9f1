//! The estimate of a technique, chosen once a frame: by test, by source of depths, by levels, in batches where there is such a form.

use lt_math::glam::Vec4;
use lt_math::{
    Esm, Evsm, LevelSource, Levels, LightProjection, MsmHamburger, MsmHausdorff, OneLevel, Pcf, Sm, Vsm,
};
use lt_shaders::abi::ShadowParams;
use lt_shaders::evaluate::{
    FilteredVectors, GatheredDepths, MapSource as MapView, TestFromParams, evaluate_levels,
};

use super::batch::{BatchTest, evaluate_on};
use super::footprints::Maps;
use super::samples::SampleRows;
use super::tiles::PIECE;
use crate::{MapSource, MapTest};

/// Estimate and doubt of a block's samples.
pub(super) type Estimator<'a> = Box<dyn Fn(&[SampleRows], &mut [f32], &mut [bool]) + Sync + 'a>;

/// What a frame's evaluate pass reads.
#[derive(Clone, Copy)]
pub(super) struct LightMaps<'a> {
    pub p: &'a ShadowParams,
    /// Those of a directional light that are searched; `None` for the one map in `p`.
    pub levels: Option<&'a [LightProjection]>,
    /// Plain depths, map after map.
    pub depths: &'a [f32],
    /// Pre-filtered vectors, map after map.
    pub vectors: &'a [Vec4],
}

impl<'a> LightMaps<'a> {
    /// The estimate by a test, with doubts or without.
    pub fn estimator(self, test: MapTest, source: MapSource, has_doubts: bool) -> Estimator<'a> {
        match test {
            MapTest::Vsm if source == MapSource::Gather => self.batched::<Vsm>(has_doubts),
            MapTest::Evsm if source == MapSource::Gather => self.batched::<Evsm>(has_doubts),
            MapTest::Sm => self.any_source::<Sm>(source, has_doubts),
            MapTest::Pcf => self.any_source::<Pcf>(source, has_doubts),
            MapTest::Vsm => self.any_source::<Vsm>(source, has_doubts),
            MapTest::Esm => self.any_source::<Esm>(source, has_doubts),
            MapTest::Evsm => self.any_source::<Evsm>(source, has_doubts),
            MapTest::Msm => self.any_source::<MsmHamburger>(source, has_doubts),
            MapTest::MsmHausdorff => self.any_source::<MsmHausdorff>(source, has_doubts),
        }
    }

    fn batched<T: BatchTest>(self, has_doubts: bool) -> Estimator<'a> {
        match has_doubts {
            false => self.batched_as::<T, false>(),
            true => self.batched_as::<T, true>(),
        }
    }

    fn batched_as<T: BatchTest, const LTT: bool>(self) -> Estimator<'a> {
        let LightMaps { p, depths, .. } = self;
        let maps = match self.levels {
            None => Maps::one(p, depths),
            Some(projections) => Maps::levels(p, projections, depths),
        };
        Box::new(move |rows, visibility, is_doubted| {
            evaluate_on::<T, LTT>(rows, p, maps, visibility, is_doubted);
        })
    }

    fn any_source<T: TestFromParams>(self, source: MapSource, has_doubts: bool) -> Estimator<'a> {
        match source {
            MapSource::Gather => self.any_levels::<T, _>(GatheredDepths { depths: self.depths }, has_doubts),
            MapSource::Prefiltered => {
                self.any_levels::<T, _>(FilteredVectors { vectors: self.vectors }, has_doubts)
            }
        }
    }

    fn any_levels<T: TestFromParams, M: MapView + Sync + 'a>(
        self,
        map: M,
        has_doubts: bool,
    ) -> Estimator<'a> {
        let one = OneLevel { projection: self.p.projection };
        let levels =
            |projections: &'a [LightProjection]| Levels { projections, count: projections.len() as u32 };
        match (self.levels, has_doubts) {
            (None, false) => self.one_by_one::<T, M, _, false>(map, one),
            (None, true) => self.one_by_one::<T, M, _, true>(map, one),
            (Some(all), false) => self.one_by_one::<T, M, _, false>(map, levels(all)),
            (Some(all), true) => self.one_by_one::<T, M, _, true>(map, levels(all)),
        }
    }

    fn one_by_one<T, M, L, const LTT: bool>(self, map: M, levels: L) -> Estimator<'a>
    where
        T: TestFromParams,
        M: MapView + Sync + 'a,
        L: LevelSource + Sync + 'a,
    {
        Box::new(move |rows, visibility, is_doubted| {
            let samples = rows.iter().flat_map(|rows| (0..PIECE).map(|i| rows.sample(i)));
            for ((sample, visibility), is_doubted) in samples.zip(visibility).zip(is_doubted) {
                let verdict = evaluate_levels::<T, M, L, LTT>(&sample, self.p, map, levels);
                *visibility = verdict.visibility;
                *is_doubted = verdict.is_doubted;
            }
        })
    }
}
