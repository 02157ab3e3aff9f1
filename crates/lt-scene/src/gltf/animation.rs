//! Keyframe animation: step, linear and cubic spline interpolation (glTF 2.0 specification, 3.11 and appendix C).

use std::{
    collections::{HashMap, HashSet},
    sync::Arc,
};

use lt_math::glam::{Quat, Vec3};

use super::{
    accessors::{Accessors, Component, Wanted},
    budget::Budget,
    fault::{Fault, pick},
    json::{self, Root},
    nodes::{Hierarchy, Local, unit},
};
use crate::Repairs;

/// Types of rotations and weights.
const NORMALIZED_OR_FLOAT: &[Component] = Component::NUMBERS;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Interpolation {
    Step,
    Linear,
    CubicSpline,
}

impl Interpolation {
    fn parse(name: Option<&str>, place: impl FnOnce() -> String) -> Result<Self, Fault> {
        match name {
            None | Some("LINEAR") => Ok(Self::Linear),
            Some("STEP") => Ok(Self::Step),
            Some("CUBICSPLINE") => Ok(Self::CubicSpline),
            Some(other) => Err(Fault::at(place(), format!("{other:?} is not LINEAR, STEP or CUBICSPLINE"))),
        }
    }
}

/// What a channel moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Translation,
    Rotation,
    Scale,
    Weights,
}

/// The values of one property over time.
#[derive(Clone, Debug)]
struct Channel {
    node: usize,
    property: Property,
    interpolation: Interpolation,
    /// Ascending, at least one, seconds.
    times: Arc<[f32]>,
    /// `width` values per key, three times that for splines: in-tangent, value, out-tangent.
    values: Arc<[f32]>,
    width: usize,
}

/// The file's first animation.
#[derive(Clone, Debug)]
pub(super) struct Animation {
    channels: Vec<Channel>,
    /// Last keyframe over all channels, seconds.
    pub(super) duration_s: f32,
}

/// Everything that an animation can change.
pub(super) struct Posture {
    pub(super) locals: Vec<Local>,
    /// Morph target weights by node; empty where the node's mesh has none.
    pub(super) weights: Vec<Vec<f32>>,
}

impl Animation {
    /// Reads the first animation, if there is one. `weights` gives the number of morph targets by node.
    pub(super) fn read(
        root: &Root,
        accessors: &Accessors<'_>,
        hierarchy: &Hierarchy,
        weights: &[Vec<f32>],
        budget: &mut Budget,
        repairs: &mut Repairs,
    ) -> Result<Option<Self>, Fault> {
        let Some(json) = root.animations.first() else { return Ok(None) };
        let mut reader = Reader { accessors, budget, cache: HashMap::new(), ordered: HashSet::new() };
        let mut channels = Vec::new();
        for (c, channel) in json.channels.iter().enumerate() {
            let place = format!("animations[0].channels[{c}]");
            let Some(node) = channel.target.node else { continue };
            pick(&root.nodes, node, "nodes", || format!("{place}.target.node"))?;
            let property = match channel.target.path.as_str() {
                "translation" => Property::Translation,
                "rotation" => Property::Rotation,
                "scale" => Property::Scale,
                "weights" => Property::Weights,
                other => {
                    repairs.notes.push(format!("{place}: target path {other:?} ignored"));
                    continue;
                }
            };
            if property != Property::Weights && matches!(hierarchy.rest[node], Local::Matrix(_)) {
                let problem = format!("moves nodes[{node}], which has a matrix: re-export it with TRS");
                return Err(Fault::at(place, problem));
            }
            let sampler = pick(&json.samplers, channel.sampler, "animations[0].samplers", || {
                format!("{place}.sampler")
            })?;
            if property == Property::Weights && weights[node].is_empty() {
                continue;
            }
            let place = format!("animations[0].samplers[{}]", channel.sampler);
            channels.extend(reader.channel(sampler, node, property, weights[node].len(), &place)?);
        }
        let ends = channels.iter().filter_map(|c| c.times.last().copied());
        let duration_s = ends.fold(0.0, f32::max);
        Ok(Some(Self { channels, duration_s }))
    }

    /// Nodes whose place changes, and nodes whose morph weights change.
    pub(super) fn moved(&self, nodes: usize) -> (Vec<bool>, Vec<bool>) {
        let mut moved = (vec![false; nodes], vec![false; nodes]);
        for channel in self.channels.iter().filter(|c| c.times.len() > 1) {
            let marks = if channel.property == Property::Weights { &mut moved.1 } else { &mut moved.0 };
            marks[channel.node] = true;
        }
        moved
    }

    /// Changes `posture` to `time_s`, wrapped to the duration; a time that is not finite counts as 0.
    pub(super) fn apply(&self, time_s: f32, posture: &mut Posture) {
        let wrapped = time_s.rem_euclid(self.duration_s);
        let time_s = if wrapped.is_finite() { wrapped } else { 0.0 };
        for channel in &self.channels {
            if channel.property == Property::Weights {
                let weights = &mut posture.weights[channel.node];
                for (i, weight) in weights.iter_mut().enumerate() {
                    [*weight] = channel.sample(time_s, i, lerp);
                }
                continue;
            }
            let Local::Trs(trs) = &mut posture.locals[channel.node] else { continue };
            match channel.property {
                Property::Translation => trs.translation = Vec3::from(channel.sample(time_s, 0, lerp)),
                Property::Scale => trs.scale = Vec3::from(channel.sample(time_s, 0, lerp)),
                _ => trs.rotation = unit(channel.sample(time_s, 0, slerp)).unwrap_or(trs.rotation),
            }
        }
    }
}

/// Component-wise interpolation.
fn lerp<const N: usize>(a: [f32; N], b: [f32; N], s: f32) -> [f32; N] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * s)
}

/// Along the shorter arc; quaternions of any length.
fn slerp(a: [f32; 4], b: [f32; 4], s: f32) -> [f32; 4] {
    let [a, b] = [a, b].map(|q| unit(q).unwrap_or(Quat::IDENTITY));
    a.slerp(b, s).to_array()
}

impl Channel {
    /// The same with its last key alone where all of them say the same: exporters bake what stands still, too.
    fn thinned(self) -> Self {
        let is_spline = self.interpolation == Interpolation::CubicSpline;
        let per_key = self.values.len() / self.times.len();
        let first = &self.values[..per_key];
        let is_level = !is_spline
            || first[..self.width].iter().chain(&first[2 * self.width..]).all(|tangent| *tangent == 0.0);
        if !is_level || self.values.chunks_exact(per_key).any(|key| key != first) {
            return self;
        }
        let times = self.times[self.times.len() - 1..].into();
        Self { times, values: first.into(), ..self }
    }

    /// Values `at..at + N` of a key at `time_s`, held constant outside the keys.
    fn sample<const N: usize>(
        &self,
        time_s: f32,
        at: usize,
        linear: impl Fn([f32; N], [f32; N], f32) -> [f32; N],
    ) -> [f32; N] {
        let is_spline = self.interpolation == Interpolation::CubicSpline;
        let value = |key: usize, part: usize| -> [f32; N] {
            let row = if is_spline { 3 * key + part } else { key };
            std::array::from_fn(|i| self.values.get(row * self.width + at + i).copied().unwrap_or(0.0))
        };
        const IN_TANGENT: usize = 0;
        const VALUE: usize = 1;
        const OUT_TANGENT: usize = 2;
        let after = self.times.partition_point(|&t| t <= time_s);
        if after == 0 || after == self.times.len() {
            return value(after.saturating_sub(1), VALUE);
        }
        let key = after - 1;
        let span = self.times[after] - self.times[key];
        let s = ((time_s - self.times[key]) / span).clamp(0.0, 1.0);
        match self.interpolation {
            Interpolation::Step => value(key, VALUE),
            Interpolation::Linear => linear(value(key, VALUE), value(after, VALUE), s),
            Interpolation::CubicSpline => {
                let (v0, v1) = (value(key, VALUE), value(after, VALUE));
                let (out0, in1) = (value(key, OUT_TANGENT), value(after, IN_TANGENT));
                let (s2, s3) = (s * s, s * s * s);
                std::array::from_fn(|i| {
                    (2.0 * s3 - 3.0 * s2 + 1.0) * v0[i]
                        + span * (s3 - 2.0 * s2 + s) * out0[i]
                        + (3.0 * s2 - 2.0 * s3) * v1[i]
                        + span * (s3 - s2) * in1[i]
                })
            }
        }
    }
}

struct Reader<'s, 'a> {
    accessors: &'s Accessors<'a>,
    budget: &'s mut Budget,
    /// Decoded accessors; samplers often share their times.
    cache: HashMap<usize, Arc<[f32]>>,
    /// Accessors known to hold ascending times.
    ordered: HashSet<usize>,
}

impl Reader<'_, '_> {
    /// A channel, or none if it has no keys.
    fn channel(
        &mut self,
        sampler: &json::AnimationSampler,
        node: usize,
        property: Property,
        targets: usize,
        place: &str,
    ) -> Result<Option<Channel>, Fault> {
        let interpolation =
            Interpolation::parse(sampler.interpolation.as_deref(), || format!("{place}.interpolation"))?;
        let times = self.times(sampler.input, &format!("{place}.input"))?;
        let (kind, components, width): (_, &[Component], _) = match property {
            Property::Translation | Property::Scale => ("VEC3", &[Component::F32], 3),
            Property::Rotation => ("VEC4", NORMALIZED_OR_FLOAT, 4),
            Property::Weights => ("SCALAR", NORMALIZED_OR_FLOAT, targets),
        };
        let place = format!("{place}.output");
        let wanted = Wanted { place: &place, kinds: &[kind], components };
        let values = self.floats(sampler.output, &wanted)?;
        let per_key = width * if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        let expected = times.len().checked_mul(per_key);
        if expected != Some(values.len()) {
            let (keys, found) = (times.len(), values.len());
            let problem = format!("expected {keys} keys of {per_key} numbers, found {found} numbers");
            return Err(Fault::at(place, problem));
        }
        let channel = Channel { node, property, interpolation, times, values, width };
        Ok((!channel.times.is_empty()).then(|| channel.thinned()))
    }

    fn times(&mut self, index: usize, place: &str) -> Result<Arc<[f32]>, Fault> {
        let wanted = Wanted { place, kinds: &["SCALAR"], components: &[Component::F32] };
        let times = self.floats(index, &wanted)?;
        if self.ordered.insert(index)
            && let Some(i) = times.windows(2).position(|w| w[0] > w[1])
        {
            let problem = format!("keyframe {} is before the one preceding it", i + 1);
            return Err(Fault::at(format!("accessors[{index}]"), problem));
        }
        Ok(times)
    }

    /// All numbers of an accessor.
    fn floats(&mut self, index: usize, wanted: &Wanted<'_>) -> Result<Arc<[f32]>, Fault> {
        let accessor = self.accessors.open(index, wanted)?;
        if let Some(values) = self.cache.get(&index) {
            return Ok(Arc::clone(values));
        }
        let components = accessor.components();
        let numbers = (accessor.count() as u64).saturating_mul(components as u64);
        self.budget.charge(numbers, || wanted.place.to_owned())?;
        let mut values = Vec::with_capacity(numbers as usize);
        for i in 0..accessor.count() {
            values.extend_from_slice(&accessor.finite::<4>(i)?[..components]);
        }
        let values: Arc<[f32]> = values.into();
        self.cache.insert(index, Arc::clone(&values));
        Ok(values)
    }
}
