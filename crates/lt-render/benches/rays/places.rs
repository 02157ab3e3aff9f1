//! A scene baked into one world-space tree, and the shadow rays of its view.

use lt_bvh::{Bvh, Triangle};
use lt_math::glam::UVec2;
use lt_render::{BackendKind, MappedCoverage, PackedScene, Session, Setup, Technique, Trees};
use lt_scene::{Instance, Scene, Source};
use lt_shaders::abi::Material;
use lt_shaders::surface::Coverage;

use super::Outcome;
use super::rays::RayList;

/// A scene to measure on.
pub struct Place {
    pub name: String,
    /// Processor and instructions.
    pub device: String,
    pub packed: PackedScene,
    pub rays: RayList,
    /// The triangles in the order of the scene's meshes, for what is built anew: sorting them into a tree's leaves is part of a build.
    pub in_mesh_order: Vec<Triangle>,
}

impl Place {
    /// Opens a scene and traces its view.
    pub fn open(name: &str, size: UVec2) -> Outcome<Self> {
        let scene = posed(name)?;
        let session = Session::new(&scene, Setup::for_scene(&scene, size.x, size.y), BackendKind::Cpu)?;
        let light = session.job(&Technique::RAY).shadow.light;
        let rays = RayList::of_picture(session.samples(), size, &light);
        let device = session.device_name();
        drop(session);
        let packed = PackedScene::new(&scene)?;
        match packed.trees() {
            Trees::Flat(bvh) => {
                let mut order: Vec<usize> = (0..bvh.triangles().len()).collect();
                order.sort_unstable_by_key(|&i| bvh.sources()[i]);
                let in_mesh_order = order.into_iter().map(|i| bvh.triangles()[i]).collect();
                Ok(Place { name: name.to_owned(), device, packed, rays, in_mesh_order })
            }
            Trees::Instanced(_) => Err(format!("{name}: baked, yet it has instances").into()),
        }
    }

    /// The one tree.
    pub fn bvh(&self) -> &Bvh {
        match self.packed.trees() {
            Trees::Flat(bvh) => bvh,
            Trees::Instanced(_) => unreachable!("refused by open"),
        }
    }

    /// Whether any triangle asks the alpha test.
    pub fn has_holes(&self) -> bool {
        self.packed.stats().masked_triangles > 0
    }

    /// The alpha test of shadow rays on triangles in the order of meshes, by the texture alone as in Embree's filter: opacity maps would have to
    /// be made before.
    pub fn plain_coverage(&self) -> Coverage<'_> {
        self.coverage_of(&self.in_mesh_order)
    }

    /// The same on triangles in the order of the tree's leaves.
    pub fn texture_coverage(&self) -> Coverage<'_> {
        self.coverage_of(self.packed.triangles())
    }

    fn coverage_of<'a>(&'a self, triangles: &'a [Triangle]) -> Coverage<'a> {
        Coverage {
            triangles,
            vertices: self.packed.vertices(),
            materials: self.packed.materials(),
            alpha_texels: self.packed.alpha_texels(),
            required_flags: Material::CASTS,
        }
    }

    /// The alpha test of shadow rays.
    pub fn coverage(&self) -> MappedCoverage<'_> {
        self.packed.coverage(Material::CASTS)
    }
}

/// A scene at time 0 with every instance turned into a mesh of its own, so that all tracers see one world-space tree.
pub fn posed(name: &str) -> Outcome<Scene> {
    let scene = Source::open(name, 1).and_then(|s| s.pose(0.0))?;
    let mut out = Scene { meshes: Vec::new(), instances: Vec::new(), ..scene.clone() };
    for instance in &scene.instances {
        let mut mesh = scene.meshes[instance.mesh as usize].clone();
        mesh.positions.iter_mut().for_each(|p| *p = instance.transform.transform_point3(*p));
        mesh.normals.clear();
        let placed = Instance { mesh: out.meshes.len() as u32, transform: Default::default(), ..*instance };
        out.instances.push(placed);
        out.meshes.push(mesh);
    }
    Ok(out)
}
