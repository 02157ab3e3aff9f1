#![no_std]
//! Three bits of history per light and pixel, and what they decide: trace a ray, or trust the map.
//!
//! # Idea
//!
//! A filterable shadow map answers with a visibility, and the leak tracing test ([`lt_math::needs_ray`]) sends a ray
//! where that answer is neither clearly lit nor clearly shadowed. Two things still go wrong: casters that fell between
//! texels leave confident answers that are wrong, and doubt that each frame resolves in the same way costs the same ray
//! again and again. Both are visible in the last frame (Kern, Brüll, Grosch 2024, §3.1):
//!
//! - **ER, expand rays:** if any neighbour's ray or shadow test contradicted what this pixel now believes, trace here
//!   too. Correct edges grow along the geometry until they close, within a few frames.
//! - **RR, remove rays:** if all neighbours' histories confirm the shadow test, believe it without a ray.
//!
//! Both rules guess where things move, and both have better relatives here. [`Expansion`] narrows ER to neighbours whose rays
//! contradict, or found their own map wrong: fewer rays for the same errors. And where nothing moved at all, a ray's answer is
//! no guess: [`Evidence::known`] keeps it.
//!
//! What rays found out can also be kept where it holds longest, in the map ([`TexelMarks`]): a map that is kept errs in the same
//! places in every frame, whoever sees them.
//!
//! What no neighbour knows of stays missed; a rolling refresh ([`is_due`]), which is not the paper's, traces every pixel once in a
//! while and so bounds how long.
//!
//! What a pixel remembers is [`MaskBits`]: ST (the shadow test said shadow), LTT (a ray was traced), RS (the ray hit).
//! [`PackedMask`] holds 42 lights in a 128-bit texel, [`reproject()`] finds the pixel's past, [`Pattern`] picks the
//! neighbours, [`decide()`] puts it all in order. [`MaskRow`] and [`Window`] hear the neighbours of 32 pixels at once.
//!
//! # Conventions
//!
//! Visibility is 1 lit, 0 shadowed; ST and RS are true for *shadow*. Pixels count from the top left. Motion leads from
//! this frame to the last. A history that was merely cleared claims "confidently lit" everywhere and misleads ER for
//! good: start with every pixel [`Reprojection::is_valid`] = false, which traces one full frame.
//!
//! Nothing here allocates or panics, and the same code runs in shaders.
//!
//! # Example
//!
//! ```
//! use lt_mask::{Evidence, Expansion, MaskBits, Neighbourhood, Pattern, decide, is_test_shadowed, reproject};
//! use lt_math::glam::{UVec2, Vec2};
//!
//! let size = UVec2::new(4, 4);
//! // Last frame: everything confidently lit, but one ray found a wire that the map had missed.
//! let mut history = [MaskBits::BLACK; 16];
//! history[5] = MaskBits::PURPLE;
//!
//! // Now the map calls pixel (2, 1) lit; it has not moved.
//! let (pixel, visibility, frame) = (UVec2::new(2, 1), 1.0, 0);
//! let place = reproject(pixel, pixel.as_vec2() + 0.5, Vec2::ZERO, size);
//! let mut neighbourhood = Neighbourhood::EMPTY;
//! for i in 0..Pattern::FULL_3X3.neighbour_count() {
//!     let n = Pattern::FULL_3X3.neighbour(i, place.pixel, frame, size);
//!     let bits = history[(n.y * 4 + n.x) as usize];
//!     neighbourhood = neighbourhood.with(bits, is_test_shadowed(visibility), Expansion::LEAKS);
//! }
//! let evidence = Evidence {
//!     is_on_map: true,
//!     is_reprojected: place.is_valid,
//!     is_due: false,
//!     neighbourhood,
//!     allows_removal: false,
//!     known: MaskBits::BLACK,
//! };
//! let decision = decide(visibility, lt_math::LTT_EPSILON, evidence);
//! assert!(decision.needs_ray, "the wire's edge grows to this pixel");
//! assert_eq!(decision.mask_with_ray(true), MaskBits::PURPLE);
//! ```

#[cfg(any(feature = "std", test))]
extern crate std;

mod bits;
mod decide;
mod marks;
mod pack;
mod pattern;
mod refresh;
mod reproject;
mod rows;

pub use bits::MaskBits;
pub use decide::{
    DEPTH_CONSISTENCY_TOLERANCE, Decision, Evidence, Expansion, Neighbourhood, Reason, SHADOW_TEST_THRESHOLD,
    decide, decide_doubt, expands_ray, is_depth_consistent, is_test_shadowed, removes_ray,
};
pub use marks::{MarksPlace, TexelMarks, marks_words};
pub use pack::{LightPlace, MAX_LIGHTS, PackedMask, words_for_lights};
pub use pattern::{Pattern, gather_corner};
pub use refresh::{MAX_REFRESH, is_due, refresh_stride};
pub use reproject::{Reprojection, reproject};
pub use rows::{MaskRow, Offsets, Window, repeat_from};
