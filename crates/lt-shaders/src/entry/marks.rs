//! Mark pass, after the resolve pass of a mask's list: one map or levels.

use lt_math::glam::{UVec3, Vec4};
use lt_math::{Levels, LightProjection, OneLevel};
use spirv_std::arch::atomic_or;
use spirv_std::memory::{Scope, Semantics};
use spirv_std::spirv;

use lt_mask::{MarksPlace, TexelMarks};

use crate::{
    abi::{Sample, ShadowParams},
    doubt::{COUNT, LIST_START, Listed, slot_of},
    marks::{is_contradicted, stain},
    mask::BitsPlace,
};

#[inline(always)]
fn mark(words: &mut [u32], place: MarksPlace, found: TexelMarks) {
    // SAFETY: an atomic on words that all invocations share, at an index that is checked.
    unsafe {
        atomic_or::<u32, { Scope::Device as u32 }, { Semantics::NONE.bits() }>(
            &mut words[place.word as usize],
            place.bits(found),
        );
    }
}

macro_rules! mark_entry {
    ($name:ident $(, levels $levels:literal)?) => {
        /// Trusted pixels whose ray contradicted the test mark the texels that it read.
        #[spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &ShadowParams,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] list: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bits: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] moving: &[Vec4],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] marks: &mut [u32],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $levels)] levels: &[LightProjection],)?
        ) {
            let slot = slot_of(id);
            if slot < list[COUNT] {
                let listed = Listed::from_word(list[(slot + LIST_START) as usize]);
                let learnt = BitsPlace::of(&p.light).read(bits, listed.pixel);
                if listed.is_trusted && is_contradicted(learnt) {
                    let levels = mark_entry!(@levels p $(, levels $levels)?);
                    let stain = stain(&samples[listed.pixel as usize], p, levels, moving);
                    if stain.is_on_map {
                        let found = TexelMarks::against(learnt.is_test_shadowed());
                        let [a, b, c, d] = MarksPlace::of_footprint(stain.texel, p.map_size, stain.level);
                        mark(marks, a, found);
                        mark(marks, b, found);
                        mark(marks, c, found);
                        mark(marks, d, found);
                    }
                }
            }
        }
    };
    (@levels $p:ident, $levels:ident $binding:literal) => {
        Levels { projections: $levels, count: $p.level_count }
    };
    (@levels $p:ident) => {
        OneLevel { projection: $p.projection }
    };
}

mark_entry!(mark_cs);
mark_entry!(mark_levels_cs, levels 6);
