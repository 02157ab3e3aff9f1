//! Perspective cameras, placed in the world (glTF 2.0 specification, 3.10).

use lt_math::glam::{Affine3A, Vec3};

use super::{
    fault::{Fault, pick},
    json::Root,
};
use crate::{Camera, Repairs};

/// A camera as a node refers to it.
#[derive(Clone, Debug)]
pub(super) struct Lens {
    name: String,
    fov_y_rad: f32,
}

impl Lens {
    /// Camera `index` of the file, referred to by `node`, whose name it gets if it has none; orthographic ones are skipped with a note.
    pub(super) fn read(
        root: &Root,
        index: usize,
        node: usize,
        repairs: &mut Repairs,
    ) -> Result<Option<Self>, Fault> {
        let json = pick(&root.cameras, index, "cameras", || format!("nodes[{node}].camera"))?;
        let name = format!("cameras[{index}]");
        match (json.kind.as_str(), &json.perspective) {
            ("perspective", Some(perspective)) => {
                let fov_y_rad = perspective.yfov;
                if !(fov_y_rad > 0.0 && fov_y_rad < std::f32::consts::PI) {
                    return Err(Fault::at(name, format!("yfov {fov_y_rad} is not between 0 and π")));
                }
                let given = json.name.as_ref().or(root.nodes[node].name.as_ref());
                Ok(Some(Self { name: given.cloned().unwrap_or(name), fov_y_rad }))
            }
            ("perspective", None) => Err(Fault::at(name, "has no perspective property")),
            ("orthographic", _) => {
                repairs.notes.push(format!("{name} is orthographic and was skipped"));
                Ok(None)
            }
            (other, _) => Err(Fault::at(name, format!("type {other:?} is not perspective or orthographic"))),
        }
    }

    /// The camera at a node; none if the node's transform leaves it no place, view or up.
    pub(super) fn place(&self, world: &Affine3A) -> Option<Camera> {
        let eye = Some(Vec3::from(world.translation)).filter(|p| p.is_finite())?;
        let forward = Vec3::from(-world.matrix3.z_axis).try_normalize()?;
        let up = Vec3::from(world.matrix3.y_axis).try_normalize()?;
        // Far from the origin one unit is less than the spacing of floats.
        let reach = (eye.abs().max_element() * 1e-3).max(1.0);
        let target = eye + forward * reach;
        target.is_finite().then(|| Camera {
            name: self.name.clone(),
            eye,
            target,
            up,
            fov_y_rad: self.fov_y_rad,
        })
    }
}
