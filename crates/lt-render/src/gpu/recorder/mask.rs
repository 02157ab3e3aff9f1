//! The mask pass and what its rays leave: histories, and marks in maps.

use lt_math::glam::UVec2;
use lt_shaders::abi::MaskParams;
use lt_shaders::neighbours::row_words;
use wgpu::BufferUsages as Usage;

use super::super::buffers::FrameBuffers;
use super::{Groups, Recorder, grid};
use crate::{FrameJob, RenderError};

impl Recorder {
    /// Records it.
    pub(super) fn mask(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let history = self.history(frame, job)?;
        let (Some(history), Some(p), Some(effects), Some(doubt)) =
            (history, job.mask, job.plan.mask, &frame.doubt)
        else {
            return Err(self.unprepared());
        };
        let uniform = self.allocator.filled("mask", &[p], Usage::UNIFORM)?;
        encoder.clear_buffer(&doubt.list, 0, Some(16));
        let (last, current) = (1 - history.current, history.current);
        if job.clears_history() && p.light.number == 0 {
            encoder.clear_buffer(&history.bits[last], 0, None);
        }
        if p.flags & MaskParams::HAS_HISTORY != 0 {
            let rows = grid(UVec2::new(row_words(frame.size.x), frame.size.y));
            let bindings = [&uniform, &history.bits[last], &history.rows];
            self.dispatch(encoder, "neighbours_row_cs", &bindings, rows)?;
            self.dispatch(encoder, "neighbours_hear_cs", &[&uniform, &history.rows, &history.heard], rows)?;
        }
        let mut name = "mask".to_owned();
        let mut bindings = vec![
            &uniform,
            &frame.samples,
            &history.heard,
            &history.bits[current],
            &frame.visibility,
            &doubt.list,
        ];
        let past = frame.past.as_ref().filter(|_| job.plan.object_motion);
        // A cleared history has nothing to be followed to.
        let follows = p.flags & (MaskParams::HAS_HISTORY | MaskParams::CLEARED) == MaskParams::HAS_HISTORY;
        if job.plan.object_motion && past.is_none() && follows {
            let problem = "the plan counts on things that move, and the frame does not know where they were: import GBuffer::last_positions";
            return Err(self.allocator.error(problem.to_owned()));
        }
        name += match (effects.motion, past) {
            (_, Some(_)) => "_objects",
            (true, None) => "_motion",
            (false, None) => "",
        };
        if let Some(depths) = &history.depths {
            name += "_depth";
            bindings.extend([&depths[last], &depths[current]]);
        }
        bindings.extend(past);
        name += match (effects.expands, effects.removes) {
            (true, true) => "",
            (true, false) => "_er",
            (false, _) => "_rr",
        };
        self.dispatch(encoder, &(name + "_cs"), &bindings, grid(frame.size))
    }

    /// Marks maps where rays of the list contradict them; nothing without marks.
    pub(super) fn mark(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBuffers,
        job: &FrameJob,
    ) -> Result<(), RenderError> {
        let marks = self.slot(frame, job)?.map.as_ref().and_then(|map| map.marks.as_ref());
        let (Some(marks), Some(history), Some(doubt), Some(map)) =
            (marks, self.history(frame, job)?, &frame.doubt, &job.map)
        else {
            return Ok(());
        };
        let uniform = self.allocator.filled("shadow", &[job.shadow], Usage::UNIFORM)?;
        let moving = self.allocator.filled("what moves on maps", &map.moving, Usage::STORAGE)?;
        let bits = &history.bits[history.current];
        encoder.copy_buffer_to_buffer(marks.read(), 0, marks.left(), 0, marks.read().size());
        let mut bindings = vec![&uniform, &frame.samples, &doubt.list, bits, &moving, marks.left()];
        let levels = self.levels(job)?;
        bindings.extend(&levels);
        let name = if levels.is_some() { "mark_levels_cs" } else { "mark_cs" };
        self.dispatch(encoder, name, &bindings, Groups::Indirect(&doubt.dispatch))
    }
}
