//! A scene under construction: materials by name, models as reusable sets of meshes.

use std::ops::Range;

use lt_math::glam::{Affine3A, Vec3};

use super::{model::Model, texture};
use crate::{AlphaMode, Camera, Instance, Light, Material, Scene, Texture, TextureRef, Wrap};

/// Collects what becomes a [`Scene`].
#[derive(Debug, Default)]
pub struct Kit {
    /// What there is so far.
    pub scene: Scene,
}

/// A model stored once, placed many times: its range in `Scene::meshes`.
pub type Stamp = Range<u32>;

impl Kit {
    /// An empty scene of this name.
    pub fn new(name: &str) -> Self {
        Self { scene: Scene { name: name.to_owned(), ..Scene::default() } }
    }

    /// Adds a material.
    pub fn material(&mut self, material: Material) -> u32 {
        self.scene.materials.push(material);
        self.scene.materials.len() as u32 - 1
    }

    /// Adds a plain opaque material.
    pub fn plain(&mut self, name: &str, color: Vec3) -> u32 {
        self.material(Material::opaque(name, color))
    }

    /// Adds an opaque, double-sided white material for thin things without thickness, to be tinted.
    pub fn sheet(&mut self, name: &str) -> u32 {
        self.material(Material { is_double_sided: true, ..Material::opaque(name, Vec3::ONE) })
    }

    /// Adds an opaque material showing a repeating texture, multiplied with `color`.
    pub fn textured(&mut self, name: &str, color: Vec3, image: Texture) -> u32 {
        let texture = self.texture(image, [Wrap::Repeat; 2]);
        self.material(Material { texture, ..Material::opaque(name, color) })
    }

    /// Adds a double-sided material cut out where the texture's alpha is below one half.
    pub fn cutout(&mut self, name: &str, color: Vec3, image: Texture) -> u32 {
        let texture = self.texture(image, [Wrap::ClampToEdge; 2]);
        let alpha = AlphaMode::Mask { cutoff: 0.5 };
        self.material(Material { texture, alpha, is_double_sided: true, ..Material::opaque(name, color) })
    }

    fn texture(&mut self, image: Texture, wrap: [Wrap; 2]) -> Option<TextureRef> {
        let known = self.scene.textures.iter().position(|t| t.name == image.name);
        let index = known.unwrap_or_else(|| {
            self.scene.textures.push(image);
            self.scene.textures.len() - 1
        });
        Some(TextureRef { texture: index as u32, wrap, is_nearest: false })
    }

    /// Stores a model's meshes without placing them.
    pub fn stamp(&mut self, name: &str, model: Model) -> Stamp {
        let first = self.scene.meshes.len() as u32;
        self.scene.meshes.extend(model.into_meshes(name, &self.scene.materials));
        first..self.scene.meshes.len() as u32
    }

    /// Places a stored model.
    pub fn place(&mut self, stamp: &Stamp, transform: Affine3A) {
        self.scene.instances.extend(stamp.clone().map(|mesh| Instance::new(mesh, transform)));
    }

    /// Places a stored model that moves between poses.
    pub fn place_moving(&mut self, stamp: &Stamp, transform: Affine3A) {
        let moving = |mesh| Instance { is_dynamic: true, ..Instance::new(mesh, transform) };
        self.scene.instances.extend(stamp.clone().map(moving));
    }

    /// Stores a model and places it where it was drawn.
    pub fn add(&mut self, name: &str, model: Model) {
        let stamp = self.stamp(name, model);
        self.place(&stamp, Affine3A::IDENTITY);
    }

    /// Sets the sun (`towards_sun` points from the ground to it) and the default view, and hands the scene out.
    pub fn finish(mut self, towards_sun: Vec3, eye: Vec3, target: Vec3, fov_y_deg: f32) -> Scene {
        self.scene.lights.push(Light::sun(-towards_sun));
        self.scene.cameras.push(Camera {
            name: "default".to_owned(),
            eye,
            target,
            up: Vec3::Y,
            fov_y_rad: fov_y_deg.to_radians(),
        });
        self.scene
    }

    /// Bark, shared by every tree.
    pub fn bark(&mut self) -> u32 {
        self.textured("bark", Vec3::ONE, texture::bark())
    }
}
