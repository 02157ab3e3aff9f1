//! A posed scene.

use lt_math::glam::{Affine3A, DVec3, Vec3};

use crate::{Camera, Instance, Light, LightKind, Material, Mesh, Texture};

/// Axis-aligned box; empty when `min > max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest corner.
    pub min: Vec3,
    /// Largest corner.
    pub max: Vec3,
}

impl Bounds {
    /// Contains nothing.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Whether it contains nothing.
    pub fn is_empty(&self) -> bool {
        self.min.cmpgt(self.max).any()
    }

    /// Whether `p` lies in it, its surface included; not so for NaN.
    pub fn contains(&self, p: Vec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// The smallest box that also holds `p`; a point that is not finite is ignored.
    pub fn including(self, p: Vec3) -> Self {
        if !p.is_finite() {
            return self;
        }
        Self { min: self.min.min(p), max: self.max.max(p) }
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vec3; 8] {
        core::array::from_fn(|i| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            Vec3::new(pick(0), pick(1), pick(2))
        })
    }
}

/// What an importer had to mend, counted so that nobody is surprised by a missing triangle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Triangles of zero area dropped.
    pub degenerate_triangles: usize,
    /// Primitives skipped because they hold no triangles (points, lines).
    pub non_triangle_primitives: usize,
    /// Instances dropped because their transform cannot be inverted; those that move shrink to a grain meanwhile instead.
    pub singular_instances: usize,
    /// Normals of zero or non-finite length replaced by none.
    pub bad_normals: usize,
    /// Other mends, in words.
    pub notes: Vec<String>,
}

impl Repairs {
    /// One line naming what was mended, or `None` if nothing was.
    pub fn summary(&self) -> Option<String> {
        let counted = [
            (self.degenerate_triangles, "zero-area triangles dropped"),
            (self.non_triangle_primitives, "point or line primitives skipped"),
            (self.singular_instances, "instances with a singular transform dropped"),
            (self.bad_normals, "unusable normals ignored"),
        ];
        let words: Vec<String> = counted
            .iter()
            .filter(|(n, _)| *n > 0)
            .map(|(n, what)| format!("{n} {what}"))
            .chain(self.notes.iter().cloned())
            .collect();
        (!words.is_empty()).then(|| words.join("; "))
    }
}

/// Everything that is drawn at one moment.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Short name for reports: the built-in's id or the file's stem.
    pub name: String,
    /// Triangle meshes.
    pub meshes: Vec<Mesh>,
    /// Placed meshes.
    pub instances: Vec<Instance>,
    /// Surfaces.
    pub materials: Vec<Material>,
    /// Images.
    pub textures: Vec<Texture>,
    /// Lights; may be empty, callers then add one.
    pub lights: Vec<Light>,
    /// Cameras; may be empty, callers then frame the bounds.
    pub cameras: Vec<Camera>,
    /// What was mended on import.
    pub repairs: Repairs,
    /// Where in the file's world the origin of all these places lies; not zero where that is far from the scene, since places in f32 are
    /// the coarser the farther they lie from 0.
    pub origin: DVec3,
}

impl Scene {
    /// Triangles over all instances (an instanced mesh counts each time).
    pub fn triangle_count(&self) -> usize {
        self.instances.iter().map(|i| self.meshes[i.mesh as usize].triangle_count()).sum()
    }

    /// World bounds of everything drawn.
    pub fn bounds(&self) -> Bounds {
        self.instances.iter().fold(Bounds::EMPTY, |all, i| {
            self.meshes[i.mesh as usize]
                .positions
                .iter()
                .fold(all, |b, &p| b.including(i.transform.transform_point3(p)))
        })
    }

    /// Makes everything this many times as large around the origin: meshes where they are placed, lights and their ranges,
    /// cameras. Intensities stay as they are.
    pub fn scale(&mut self, factor: f32) {
        let larger = Affine3A::from_scale(Vec3::splat(factor));
        self.origin *= f64::from(factor);
        for instance in &mut self.instances {
            instance.transform = larger * instance.transform;
        }
        for camera in &mut self.cameras {
            camera.eye *= factor;
            camera.target *= factor;
        }
        for light in &mut self.lights {
            match &mut light.kind {
                LightKind::Directional { .. } => {}
                LightKind::Point { position, range } | LightKind::Spot { position, range, .. } => {
                    *position *= factor;
                    *range *= factor;
                }
            }
        }
    }

    /// Adds a mesh and one static instance of it at `transform`.
    pub fn place(&mut self, mesh: Mesh, transform: Affine3A) {
        let index = self.meshes.len() as u32;
        self.meshes.push(mesh);
        self.instances.push(Instance::new(index, transform));
    }

    /// Adds a horizontal square at height `y` with this half-size, centred below the scene's bounds.
    pub fn add_ground(&mut self, y: f32, half_size: f32) {
        let bounds = self.bounds();
        let center = if bounds.is_empty() { Vec3::ZERO } else { (bounds.min + bounds.max) * 0.5 };
        let material = self.materials.len() as u32;
        self.materials.push(Material::opaque("ground", Vec3::splat(0.45)));
        let corner = |sx: f32, sz: f32| Vec3::new(center.x + sx * half_size, y, center.z + sz * half_size);
        let mesh = Mesh {
            name: "ground".to_owned(),
            positions: vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)],
            indices: vec![0, 1, 2, 0, 2, 3],
            material,
            ..Mesh::default()
        };
        self.place(mesh, Affine3A::IDENTITY);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_grows_with_its_scene() {
        let mut scene = crate::Source::open("cornell", 1).and_then(|s| s.pose(0.0)).expect("a place");
        let position = Vec3::new(1.0, 2.0, 3.0);
        let kind = LightKind::Point { position, range: 4.0 };
        scene.lights.push(Light { kind, ..Light::sun(Vec3::NEG_Y) });
        let (before, eye) = (scene.bounds(), scene.cameras[0].eye);
        scene.scale(1000.0);
        let after = scene.bounds();
        assert!((after.max - before.max * 1000.0).abs().max_element() < 1.0, "{}", after.max);
        assert_eq!(scene.cameras[0].eye, eye * 1000.0);
        let larger = LightKind::Point { position: position * 1000.0, range: 4000.0 };
        assert_eq!(scene.lights.last().map(|l| l.kind), Some(larger));
    }
}
