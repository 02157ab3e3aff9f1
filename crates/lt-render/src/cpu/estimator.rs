//! The estimate of a technique, chosen once a frame: by test, by what the maps hold, by levels.

use lt_math::glam::Vec4;
use lt_math::{Esm, Evsm, LightProjection, MsmHamburger, MsmHausdorff, Pcf, Sm, Vsm};
use lt_shaders::abi::ShadowParams;

use super::answers::BatchTest;
use super::batch::evaluate_on;
use super::footprints::{Maps, Texels};
use super::samples::Pieces;
use crate::{MapSource, MapTest};

/// Estimate and doubt of a block's samples.
pub(super) type Estimator<'a> = Box<dyn Fn(Pieces<'_>, &mut [f32], &mut [u64]) + Sync + 'a>;

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
    /// Whether the depths' [marks](super::marks) count.
    pub has_marks: bool,
}

impl<'a> LightMaps<'a> {
    /// The estimate by a test, with doubts or without.
    pub fn estimator(self, test: MapTest, source: MapSource, has_doubts: bool) -> Estimator<'a> {
        match test {
            MapTest::Sm => self.from::<Sm>(source, has_doubts),
            MapTest::Pcf => self.from::<Pcf>(source, has_doubts),
            MapTest::Vsm => self.from::<Vsm>(source, has_doubts),
            MapTest::Esm => self.from::<Esm>(source, has_doubts),
            MapTest::Evsm => self.from::<Evsm>(source, has_doubts),
            MapTest::Msm => self.from::<MsmHamburger>(source, has_doubts),
            MapTest::MsmHausdorff => self.from::<MsmHausdorff>(source, has_doubts),
        }
    }

    fn from<T: BatchTest>(self, source: MapSource, has_doubts: bool) -> Estimator<'a> {
        match has_doubts {
            false => self.batched::<T, false>(source),
            true => self.batched::<T, true>(source),
        }
    }

    fn batched<T: BatchTest, const LTT: bool>(self, source: MapSource) -> Estimator<'a> {
        let p = self.p;
        let texels = match source {
            MapSource::Gather => Texels::Depths(self.depths),
            MapSource::Prefiltered => Texels::Vectors(self.vectors),
        };
        let maps = match self.levels {
            None => Maps::one(p, texels),
            Some(projections) => Maps::levels(p, projections, texels),
        };
        let maps = Maps { marked: self.has_marks.then_some(self.depths), ..maps };
        Box::new(move |pieces, visibility, doubted| {
            evaluate_on::<T, LTT>(pieces, p, maps, visibility, doubted);
        })
    }
}
