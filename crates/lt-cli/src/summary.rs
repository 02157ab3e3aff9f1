//! What was run, on what: the facts that head the table, the results file and the report.

use lt_render::Session;
use lt_scene::{Light, LightKind};
use serde::Serialize;

use crate::{
    command_line,
    numbers::{grouped, ms},
};

/// A view, for those who want to see the same.
#[derive(Clone, Debug, Serialize)]
pub struct View {
    /// Camera position, world space.
    pub eye: [f32; 3],
    /// The point it looks at.
    pub target: [f32; 3],
    /// Which way is up.
    pub up: [f32; 3],
    /// Full vertical field of view, degrees.
    pub fov_deg: f32,
    /// Direction in which the light travels; none for a light that has no single one.
    pub light_dir: Option<[f32; 3]>,
    /// Where a spot or point light stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light_pos: Option<[f32; 3]>,
    /// Half-angle of a spot light's cone, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cone_deg: Option<f32>,
    /// Further lights.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub more_lights: Vec<LightView>,
}

/// A light, for those who want to see the same.
#[derive(Clone, Debug, Serialize)]
pub struct LightView {
    /// Direction in which it travels; none for a light that has no single one.
    pub light_dir: Option<[f32; 3]>,
    /// Where a spot or point light stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light_pos: Option<[f32; 3]>,
    /// Half-angle of a spot light's cone, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cone_deg: Option<f32>,
}

impl LightView {
    /// Of this light.
    fn of(light: &Light) -> Self {
        let (light_pos, light_dir, cone_deg) = match light.kind {
            LightKind::Directional { direction } => (None, Some(direction.to_array()), None),
            LightKind::Point { position, .. } => (Some(position.to_array()), None, None),
            LightKind::Spot { position, direction, outer_cone_rad, .. } => {
                (Some(position.to_array()), Some(direction.to_array()), Some(outer_cone_rad.to_degrees()))
            }
        };
        Self { light_dir, light_pos, cone_deg }
    }
}

/// The facts of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Scene name.
    pub scene: String,
    /// Triangles over all instances.
    pub triangles: u64,
    /// Placed meshes.
    pub instances: u64,
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Samples of each pixel, which is what rates and rays count.
    pub samples_per_pixel: u32,
    /// Layers that the camera may see, one behind the other.
    pub layers: u32,
    /// `cpu` or `gpu`.
    pub backend: &'static str,
    /// Name of the processor or adapter.
    pub device: String,
    /// CPU threads.
    pub threads: usize,
    /// Milliseconds to pack the scene and build its BVH.
    pub bvh_ms: f64,
    /// Bytes of the BVH.
    pub bvh_bytes: u64,
    /// Milliseconds to find the visible samples, once; missing without timestamps.
    pub camera_ms: Option<f64>,
    /// Triangles that no ray can hit.
    pub dropped_triangles: u64,
    /// Default shadow map resolution.
    pub map_size: u32,
    /// Camera and light.
    pub view: View,
    /// The command to type again.
    pub command: String,
    /// Version of `lt`.
    pub version: &'static str,
}

impl Summary {
    /// Collects the facts.
    pub fn of(scene: &str, session: &Session) -> Self {
        let (info, setup) = (session.info(), session.setup());
        Self {
            scene: scene.to_owned(),
            triangles: info.stats.triangles,
            instances: info.stats.instances,
            size: setup.size.to_array(),
            samples_per_pixel: setup.samples.count(),
            layers: session.layers().len() as u32,
            backend: session.backend_name(),
            device: session.device_name(),
            threads: rayon::current_num_threads(),
            bvh_ms: info.build_ms,
            bvh_bytes: info.stats.bvh_bytes,
            camera_ms: info.camera_ms,
            dropped_triangles: info.stats.dropped,
            map_size: setup.map_size,
            view: View::of(setup),
            command: command_line::current(),
            version: env!("CARGO_PKG_VERSION"),
        }
    }

    /// Size, samples and layers of the picture.
    pub fn picture(&self) -> String {
        let [width, height] = self.size;
        let mut words = format!("{width}×{height}");
        if self.samples_per_pixel > 1 {
            words += &format!(", {} samples per pixel", self.samples_per_pixel);
        }
        if self.layers > 1 {
            words += &format!(", {} layers", self.layers);
        }
        words
    }

    /// One line about scene, size, device and BVH.
    pub fn headline(&self) -> String {
        let plural = if self.threads == 1 { "" } else { "s" };
        format!(
            "{} · {} triangles · {} · {} ({}) · {} thread{plural} · BVH {} ms",
            self.scene,
            grouped(self.triangles),
            self.picture(),
            self.backend,
            self.device,
            self.threads,
            ms(Some(self.bvh_ms)),
        )
    }
}

impl View {
    /// Camera and lights of a setup.
    pub fn of(setup: &lt_render::Setup) -> Self {
        let camera = &setup.camera;
        let LightView { light_dir, light_pos, cone_deg } = LightView::of(&setup.light);
        Self {
            eye: camera.eye.to_array(),
            target: camera.target.to_array(),
            up: camera.up.to_array(),
            fov_deg: camera.fov_y_rad.to_degrees(),
            light_dir,
            light_pos,
            cone_deg,
            more_lights: setup.more_lights.iter().map(LightView::of).collect(),
        }
    }

    /// Every light.
    pub fn lights(&self) -> Vec<LightView> {
        let first =
            LightView { light_dir: self.light_dir, light_pos: self.light_pos, cone_deg: self.cone_deg };
        std::iter::once(first).chain(self.more_lights.iter().cloned()).collect()
    }
}
