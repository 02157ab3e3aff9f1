//! Skins: linear blend skinning (glTF 2.0 specification, 3.7.3).

use std::collections::BTreeMap;

use lt_math::glam::{Affine3A, Mat3A, Mat4, Vec3, Vec3A};

use super::{
    accessors::{Accessors, Component, Wanted},
    budget::Budget,
    fault::{Fault, pick},
    json::Root,
    primitives::{AttributeSpec, Vertices},
};
use crate::Repairs;

/// Components of JOINTS_n.
const JOINT_TYPES: &[Component] = &[Component::U8, Component::U16];

/// Which joints move the vertices of a primitive.
#[derive(Clone, Debug)]
pub(super) struct Influences {
    /// Influences of one vertex.
    per_vertex: usize,
    /// Joint numbers and weights, `per_vertex` for each vertex; the weights of a vertex add up to one.
    joints: Vec<(u32, f32)>,
    /// Largest joint number that has weight.
    last_joint: u32,
}

impl Influences {
    /// Reads JOINTS_n and WEIGHTS_n for every n, if there are any.
    pub(super) fn read(
        attributes: &BTreeMap<String, usize>,
        vertices: &Vertices<'_, '_>,
        repairs: &mut Repairs,
    ) -> Result<Option<Self>, Fault> {
        let mut sets = Vec::new();
        loop {
            let [joints, weights] = ["JOINTS", "WEIGHTS"].map(|name| format!("{name}_{}", sets.len()));
            let spec = AttributeSpec { name: &joints, kinds: &["VEC4"], components: JOINT_TYPES };
            let Some(joints) = vertices.attribute(attributes, &spec)? else { break };
            let spec = AttributeSpec { name: &weights, kinds: &["VEC4"], components: Component::NUMBERS };
            let missing = || Fault::at(format!("{}.{weights}", vertices.place), "missing beside its JOINTS");
            let weights = vertices.attribute(attributes, &spec)?.ok_or_else(missing)?;
            sets.push((joints, weights));
        }
        if sets.is_empty() {
            return Ok(None);
        }
        let per_vertex = 4 * sets.len();
        let mut influences = Vec::with_capacity(per_vertex * vertices.used.len());
        let mut unbound = 0_usize;
        for &vertex in vertices.used {
            let start = influences.len();
            for (joints, weights) in &sets {
                let weights = weights.finite::<4>(vertex as usize)?.map(|w| w.max(0.0));
                influences.extend(joints.integers::<4>(vertex as usize).into_iter().zip(weights));
            }
            unbound += usize::from(!normalize(&mut influences[start..]));
        }
        if unbound > 0 {
            let note =
                format!("{}: {unbound} vertices without weights bound to their first joint", vertices.place);
            repairs.notes.push(note);
        }
        let weighty = influences.iter().filter(|(_, weight)| *weight > 0.0);
        let last_joint = weighty.map(|(joint, _)| *joint).max().unwrap_or(0);
        Ok(Some(Self { per_vertex, joints: influences, last_joint }))
    }

    /// Whether every joint that has weight exists among `joints`.
    pub(super) fn check(&self, joints: usize, place: impl FnOnce() -> String) -> Result<(), Fault> {
        let last = self.last_joint as usize;
        if last < joints {
            return Ok(());
        }
        Err(Fault::at(place(), format!("vertices follow joint {last}, but the skin has {joints} joints")))
    }

    /// Moves vertices from object space to where the joint matrices take them; normals that lose their length turn
    /// zero.
    pub(super) fn apply(&self, matrices: &[Affine3A], positions: &mut [Vec3], normals: &mut [Vec3]) {
        for (v, influences) in self.joints.chunks_exact(self.per_vertex).enumerate() {
            let mut blended = Affine3A { matrix3: Mat3A::ZERO, translation: Vec3A::ZERO };
            for &(joint, weight) in influences.iter().filter(|(_, weight)| *weight > 0.0) {
                if let Some(m) = matrices.get(joint as usize) {
                    blended.matrix3 += m.matrix3 * weight;
                    blended.translation += m.translation * weight;
                }
            }
            if let Some(p) = positions.get_mut(v) {
                *p = blended.transform_point3(*p);
            }
            if let Some(n) = normals.get_mut(v) {
                *n = normal_matrix(&blended.matrix3).mul_vec3(*n);
            }
        }
    }
}

/// Scales weights to a sum of one. Without any weight the first joint gets it, and false is returned.
fn normalize(influences: &mut [(u32, f32)]) -> bool {
    let sum: f64 = influences.iter().map(|(_, w)| f64::from(*w)).sum();
    if sum > 0.0 {
        influences.iter_mut().for_each(|(_, w)| *w = (f64::from(*w) / sum) as f32);
        return true;
    }
    if let Some((_, weight)) = influences.first_mut() {
        *weight = 1.0;
    }
    false
}

/// The cofactors of `m`: its inverse transpose up to a positive factor or, for mirrors, a negative one that is
/// undone. Unlike an inverse they exist for flat matrices too.
fn normal_matrix(m: &Mat3A) -> Mat3A {
    let (a, b, c) = (m.x_axis, m.y_axis, m.z_axis);
    let cofactors = Mat3A::from_cols(b.cross(c), c.cross(a), a.cross(b));
    cofactors * if a.dot(b.cross(c)) < 0.0 { -1.0 } else { 1.0 }
}

/// Joints with the matrices that undo their rest pose.
#[derive(Clone, Debug)]
pub(super) struct Skin {
    /// Node numbers.
    pub(super) joints: Vec<usize>,
    inverse_bind: Vec<Affine3A>,
}

impl Skin {
    pub(super) fn read(
        root: &Root,
        accessors: &Accessors<'_>,
        index: usize,
        budget: &mut Budget,
    ) -> Result<Self, Fault> {
        let json = &root.skins[index];
        let joints = json.joints.clone();
        for (j, &joint) in joints.iter().enumerate() {
            pick(&root.nodes, joint, "nodes", || format!("skins[{index}].joints[{j}]"))?;
        }
        let place = format!("skins[{index}].inverseBindMatrices");
        budget.charge(4 * joints.len() as u64, || place.clone())?;
        let Some(accessor) = json.inverse_bind_matrices else {
            return Ok(Self { inverse_bind: vec![Affine3A::IDENTITY; joints.len()], joints });
        };
        let wanted = Wanted { place: &place, kinds: &["MAT4"], components: &[Component::F32] };
        let accessor = accessors.open(accessor, &wanted)?;
        if accessor.count() < joints.len() {
            let problem = format!("{} matrices for {} joints", accessor.count(), joints.len());
            return Err(Fault::at(place, problem));
        }
        let matrix = |i| accessor.finite::<16>(i).map(|m| Affine3A::from_mat4(Mat4::from_cols_array(&m)));
        let inverse_bind = (0..joints.len()).map(matrix).collect::<Result<_, _>>()?;
        Ok(Self { joints, inverse_bind })
    }

    /// From object space to the world, per joint.
    pub(super) fn matrices(&self, world: &[Affine3A]) -> Vec<Affine3A> {
        self.joints.iter().zip(&self.inverse_bind).map(|(&joint, bind)| world[joint] * *bind).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normal_stays_perpendicular_under_shear_and_keeps_its_side_under_mirroring() {
        let shear = Mat3A::from_cols(Vec3A::X, Vec3A::new(1.0, 1.0, 0.0), Vec3A::Z);
        let tangent = shear.mul_vec3(Vec3::X);
        assert!(normal_matrix(&shear).mul_vec3(Vec3::Y).dot(tangent).abs() < 1e-6);
        let mirror = Mat3A::from_diagonal(Vec3::new(-1.0, 1.0, 1.0));
        assert!(normal_matrix(&mirror).mul_vec3(Vec3::Y).dot(Vec3::Y) > 0.0);
    }
}
