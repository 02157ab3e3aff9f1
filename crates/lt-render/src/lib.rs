//! Shadows by estimate, doubt and resolve.
//!
//! # Idea
//! A [`Technique`] answers, per pixel, three questions: what does a cheap map say (*estimate*), may that be wrong
//! here (*doubt*), and what is the truth there (*resolve*)? Full ray tracing, shadow maps and leak tracing are all
//! values of that one type. An [`EffectPlan`] lists what a scene, a view and a technique call for; the frame driver
//! runs exactly the passes of the plan. Two backends supply "run this pass": [`cpu`] calls the kernels of
//! `lt-shaders` from rayon, `gpu` (feature `gpu`) dispatches the same kernels compiled to SPIR-V.
//!
//! The CPU backend works on rayon's threads. A caller that only waits for them beside them takes one of their cores for some milliseconds of every
//! other frame where there are as many threads as cores: let it be one of them (`rayon::ThreadPoolBuilder::use_current_thread`), as `lt` does.
//!
//! Visibility is 1 where the light is seen and 0 where it is blocked. Positions are world space, metres or whatever
//! the scene uses: nothing depends on the unit.
//!
//! ```
//! use lt_render::{BackendKind, Session, Setup, Technique};
//! use lt_scene::{Source, builtin::Builtin};
//!
//! let scene = Source::from(Builtin::parse("cornell").unwrap()).pose(0.0).unwrap();
//! let setup = Setup::for_scene(&scene, 64, 64);
//! let mut session = Session::new(&scene, setup, BackendKind::Cpu).unwrap();
//! let truth = session.render(&"ray".parse::<Technique>().unwrap()).unwrap();
//! let hybrid = session.render(&"ltt-evsm".parse::<Technique>().unwrap()).unwrap();
//! assert!(hybrid.rays < truth.rays);
//! ```

mod backend;
mod cascades;
mod compare;
mod contradiction;
pub mod cpu;
mod error;
mod frame;
#[cfg(feature = "gpu")]
pub mod gpu;
mod lamp;
mod levels;
mod light_fit;
mod light_space;
mod map_memory;
mod means;
pub mod metrics;
mod pace;
mod packed;
mod plan;
mod planner;
mod reach;
mod sample_grid;
mod session;
mod setup;
mod technique;
mod technique_id;
mod technique_modifiers;

pub use backend::{Backend, BackendKind, DepthMapJob, FrameJob, ShadedLight};
pub use cascades::{Cascades, FarLevel, MAX_LEVELS, Splits, parse_count};
pub use compare::{
    CompareOptions, Comparison, FrameStats, LightStats, PassTime, PlayOptions, Row, compare, compare_frames,
    flips, frames_to_settle, quantile,
};
pub use error::RenderError;
pub use frame::{Frame, Pass, PassKind};
pub use lamp::LIGHT_JUMP_RAD;
pub use light_fit::{KEPT_GROWTH, LightFit, fit_directional, fit_kept};
pub use lt_mask::MaskBits;
pub use lt_shaders::abi::Sample;
pub use map_memory::{MAX_MAP_BYTES, map_bytes};
pub use means::MeanTimes;
pub use pace::{median_motion_px, way_per_frame};
pub use packed::{
    Culling, DrawRange, MappedCoverage, OpacityMaps, PackStats, PackedScene, Packing, Trees, Upkeep,
};
pub use plan::{Effect, EffectPlan, MaskEffects, Sequence};
pub use planner::{FramePlanner, places_of};
pub use sample_grid::SampleGrid;
pub use session::{SceneInfo, Session};
pub use setup::{MAX_SAMPLES, Setup};
pub use technique::{Doubt, Estimate, MapSource, MapTest, Removal, Resolve, Technique, TemporalMask};
pub use technique_id::TechniqueError;
