//! The node hierarchy, flattened to parents-first order without recursion (glTF 2.0 specification, 3.5).

use lt_math::glam::{Affine3A, DAffine3, DMat3, DVec3, Mat3A, Mat4, Quat, Vec3};

use super::{
    fault::{Fault, pick},
    json::{self, Root},
};
use crate::Repairs;

/// Translation, rotation and scale, applied in the order scale, rotation, translation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trs {
    pub(super) translation: Vec3,
    /// Unit.
    pub(super) rotation: Quat,
    pub(super) scale: Vec3,
}

/// Where a node stands relative to its parent.
#[derive(Clone, Copy, Debug)]
pub(super) enum Local {
    Matrix(Affine3A),
    Trs(Trs),
}

impl Local {
    fn to_affine(self) -> DAffine3 {
        match self {
            Self::Matrix(m) => {
                let columns = [m.matrix3.x_axis, m.matrix3.y_axis, m.matrix3.z_axis].map(|c| c.as_dvec3());
                let matrix3 = DMat3::from_cols(columns[0], columns[1], columns[2]);
                DAffine3 { matrix3, translation: m.translation.as_dvec3() }
            }
            Self::Trs(t) => DAffine3::from_scale_rotation_translation(
                t.scale.as_dvec3(),
                t.rotation.as_dquat(),
                t.translation.as_dvec3(),
            ),
        }
    }
}

/// All nodes, as they are at rest.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    pub(super) parents: Vec<Option<usize>>,
    /// Every node once, parents before children.
    pub(super) order: Vec<usize>,
    /// Whether the node belongs to the scene that is shown.
    pub(super) is_shown: Vec<bool>,
    /// Relative to the parent, without animation.
    pub(super) rest: Vec<Local>,
}

impl Hierarchy {
    pub(super) fn read(root: &Root, repairs: &mut Repairs) -> Result<Self, Fault> {
        let parents = parents(root)?;
        let tops: Vec<usize> = (0..parents.len()).filter(|&i| parents[i].is_none()).collect();
        let order = parents_first(root, &tops);
        if order.len() < parents.len() {
            let mut is_reached = vec![false; parents.len()];
            order.iter().for_each(|&i| is_reached[i] = true);
            let lost = is_reached.iter().position(|&reached| !reached).unwrap_or(0);
            return Err(Fault::at(
                format!("nodes[{lost}]"),
                "is its own ancestor, or a cycle's: remove the cycle",
            ));
        }
        let is_shown = shown(root, &tops)?;
        let rest =
            (0..root.nodes.len()).map(|i| local(&root.nodes[i], i, repairs)).collect::<Result<_, _>>()?;
        Ok(Self { parents, order, is_shown, rest })
    }

    /// World transform of every node, given every node's transform relative to its parent: in f64, since a node far from the origin may hold
    /// what is small and near together.
    pub(super) fn world(&self, locals: &[Local]) -> Vec<DAffine3> {
        let mut world = vec![DAffine3::IDENTITY; locals.len()];
        for &i in &self.order {
            let local = locals[i].to_affine();
            world[i] = self.parents[i].map_or(local, |p| world[p] * local);
        }
        world
    }

    /// Spreads a mark from nodes to all their descendants.
    pub(super) fn inherit(&self, mut marks: Vec<bool>) -> Vec<bool> {
        for &i in &self.order {
            marks[i] |= self.parents[i].is_some_and(|p| marks[p]);
        }
        marks
    }
}

/// The same transform into a world whose origin is this.
pub(super) fn relative_to(origin: DVec3, world: &DAffine3) -> Affine3A {
    let m = &world.matrix3;
    Affine3A {
        matrix3: Mat3A::from_cols(m.x_axis.as_vec3a(), m.y_axis.as_vec3a(), m.z_axis.as_vec3a()),
        translation: (world.translation - origin).as_vec3a(),
    }
}

/// Each node's parent; a node with two is refused, which also keeps shared subtrees from multiplying.
fn parents(root: &Root) -> Result<Vec<Option<usize>>, Fault> {
    let mut parents: Vec<Option<usize>> = vec![None; root.nodes.len()];
    for (i, node) in root.nodes.iter().enumerate() {
        for (c, &child) in node.children.iter().enumerate() {
            let place = || format!("nodes[{i}].children[{c}]");
            pick(&root.nodes, child, "nodes", place)?;
            if let Some(other) = parents[child].replace(i) {
                let problem =
                    format!("nodes[{child}] already is a child of nodes[{other}]: a node has one parent");
                return Err(Fault::at(place(), problem));
            }
        }
    }
    Ok(parents)
}

/// What can be reached from these nodes, breadth first. Every node has one parent, so none comes twice unless `tops`
/// hold one another's descendants.
fn parents_first(root: &Root, tops: &[usize]) -> Vec<usize> {
    let mut order = tops.to_vec();
    let mut next = 0;
    while let Some(&i) = order.get(next) {
        order.extend(&root.nodes[i].children);
        next += 1;
    }
    order
}

/// The nodes of the default scene, else of the first one, else all.
fn shown(root: &Root, tops: &[usize]) -> Result<Vec<bool>, Fault> {
    let mut is_shown = vec![false; root.nodes.len()];
    let mut open = match root.scene {
        Some(index) => pick(&root.scenes, index, "scenes", || "scene".to_owned())?.nodes.clone(),
        None => root.scenes.first().map_or_else(|| tops.to_vec(), |scene| scene.nodes.clone()),
    };
    let index = root.scene.unwrap_or(0);
    while let Some(i) = open.pop() {
        let node = pick(&root.nodes, i, "nodes", || format!("scenes[{index}].nodes"))?;
        if !std::mem::replace(&mut is_shown[i], true) {
            open.extend(&node.children);
        }
    }
    Ok(is_shown)
}

fn local(node: &json::Node, index: usize, repairs: &mut Repairs) -> Result<Local, Fault> {
    if let Some(matrix) = &node.matrix {
        return local_matrix(matrix, || format!("nodes[{index}].matrix")).map(Local::Matrix);
    }
    let translation = Vec3::from(node.translation.unwrap_or([0.0; 3]));
    let scale = Vec3::from(node.scale.unwrap_or([1.0; 3]));
    let rotation = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    if !(translation.is_finite() && scale.is_finite() && rotation.iter().all(|v| v.is_finite())) {
        return Err(Fault::at(format!("nodes[{index}]"), "translation, rotation or scale is not finite"));
    }
    let rotation = unit(rotation).unwrap_or_else(|| {
        repairs.notes.push(format!("nodes[{index}].rotation has no length and was ignored"));
        Quat::IDENTITY
    });
    Ok(Local::Trs(Trs { translation, rotation, scale }))
}

fn local_matrix(matrix: &[f32; 16], place: impl FnOnce() -> String) -> Result<Affine3A, Fault> {
    if matrix.iter().any(|v| !v.is_finite()) {
        return Err(Fault::at(place(), "not finite"));
    }
    let last_row = [matrix[3], matrix[7], matrix[11], matrix[15]];
    if last_row.iter().zip([0.0, 0.0, 0.0, 1.0]).any(|(v, expected)| (v - expected).abs() > 1e-5) {
        return Err(Fault::at(
            place(),
            format!("last row is {last_row:?}, expected [0, 0, 0, 1]: not affine"),
        ));
    }
    Ok(Affine3A::from_mat4(Mat4::from_cols_array(matrix)))
}

/// A quaternion of unit length, unless it has none.
pub(super) fn unit(xyzw: [f32; 4]) -> Option<Quat> {
    let length = xyzw.iter().map(|&v| f64::from(v) * f64::from(v)).sum::<f64>().sqrt();
    let is_usable = length.is_finite() && length > 0.0;
    is_usable.then(|| Quat::from_array(xyzw.map(|v| (f64::from(v) / length) as f32)))
}

/// Whether a transform is finite and far enough from flat to be inverted in single precision.
pub(super) fn is_invertible(transform: &Affine3A) -> bool {
    /// |det| over the product of the columns' lengths: 1 for a rotation, rounding noise for a flat matrix.
    const LEAST_RELATIVE_DETERMINANT: f64 = 1e-7;
    let m = transform.matrix3;
    let column = |i: usize| m.col(i).to_array().map(f64::from);
    let [a, b, c] = [column(0), column(1), column(2)];
    let determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
        + c[0] * (a[1] * b[2] - a[2] * b[1]);
    let lengths: f64 = [a, b, c].iter().map(|v| v.iter().map(|x| x * x).sum::<f64>().sqrt()).product();
    transform.is_finite()
        && determinant.abs() > LEAST_RELATIVE_DETERMINANT * lengths
        && transform.inverse().is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flat_and_overflowing_transforms_are_singular_small_and_mirrored_ones_are_not() {
        let turn = Quat::from_rotation_y(0.7) * Quat::from_rotation_x(0.3);
        let scaled =
            |s: Vec3| Affine3A::from_quat(turn) * Affine3A::from_scale(s) * Affine3A::from_quat(turn);
        assert!(!is_invertible(&scaled(Vec3::new(1.0, 1.0, 0.0))));
        assert!(!is_invertible(&scaled(Vec3::ZERO)));
        assert!(!is_invertible(&Affine3A::from_scale(Vec3::splat(f32::INFINITY))));
        assert!(!is_invertible(&Affine3A::from_scale(Vec3::splat(1e-39))));
        assert!(is_invertible(&scaled(Vec3::new(1.0, -1.0, 1e-3))));
        assert!(is_invertible(&scaled(Vec3::splat(1e-6))));
    }
}
