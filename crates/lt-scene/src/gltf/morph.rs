//! Morph targets: weighted displacements added to vertices (glTF 2.0 specification, 3.7.2.2).

use std::collections::BTreeMap;

use lt_math::glam::Vec3;

use super::{
    fault::Fault,
    primitives::{NORMAL, POSITION, Vertices},
};

/// Displacements of one target; empty lists displace nothing.
#[derive(Clone, Debug)]
pub(super) struct Target {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
}

impl Target {
    /// All targets of a primitive.
    pub(super) fn read_all(
        targets: &[BTreeMap<String, usize>],
        vertices: &Vertices<'_, '_>,
    ) -> Result<Vec<Self>, Fault> {
        let read = |(t, attributes): (usize, &BTreeMap<String, usize>)| {
            let place = format!("{}.targets[{t}]", vertices.place);
            let Vertices { accessors, used, count, .. } = *vertices;
            let vertices = Vertices { accessors, used, count, place: &place };
            let displacements = |spec| match vertices.attribute(attributes, spec)? {
                Some(accessor) => vertices.read(accessor, |v: [f32; 3]| Vec3::from(v)),
                None => Ok(Vec::new()),
            };
            Ok(Self { positions: displacements(&POSITION)?, normals: displacements(&NORMAL)? })
        };
        targets.iter().enumerate().map(read).collect()
    }
}

/// Adds the targets to vertices at rest; missing weights count as zero.
pub(super) fn apply(targets: &[Target], weights: &[f32], positions: &mut [Vec3], normals: &mut [Vec3]) {
    for (target, &weight) in targets.iter().zip(weights).filter(|&(_, &weight)| weight != 0.0) {
        let add = |vertices: &mut [Vec3], displacements: &[Vec3]| {
            vertices.iter_mut().zip(displacements).for_each(|(v, &d)| *v += d * weight);
        };
        add(positions, &target.positions);
        add(normals, &target.normals);
    }
}
