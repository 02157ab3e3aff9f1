//! Materials: coverage, base colour, translucency (glTF 2.0 specification, 3.9, and KHR extensions).

use std::collections::HashMap;

use lt_math::glam::{Mat2, Vec2, Vec3, Vec4};

use super::{
    fault::{Fault, pick},
    json::{self, Root},
};
use crate::{AlphaMode, Material, Repairs, TextureRef, UvTransform, Wrap};

/// Which texture coordinates a material reads, and how it transforms them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct UvUse {
    /// The n of `TEXCOORD_n`.
    pub(super) set: u32,
    pub(super) transform: UvTransform,
}

/// A material and its texture coordinates.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    pub(super) material: Material,
    pub(super) uv: Option<UvUse>,
}

impl Surface {
    /// What a primitive without a material is made of (3.7.2.1).
    pub(super) fn plain() -> Self {
        Self { material: Material::opaque("default", Vec3::ONE), uv: None }
    }
}

/// Reads all materials; also the images that their base colours use, in the order of `TextureRef::texture`.
pub(super) fn read(root: &Root, repairs: &mut Repairs) -> Result<(Vec<Surface>, Vec<usize>), Fault> {
    let mut reader = Reader { root, repairs, images: Vec::new(), slots: HashMap::new() };
    let surfaces = (0..root.materials.len()).map(|i| reader.surface(i)).collect::<Result<_, _>>()?;
    Ok((surfaces, reader.images))
}

struct Reader<'a> {
    root: &'a Root,
    repairs: &'a mut Repairs,
    images: Vec<usize>,
    slots: HashMap<usize, u32>,
}

impl Reader<'_> {
    fn surface(&mut self, index: usize) -> Result<Surface, Fault> {
        let json = &self.root.materials[index];
        let place = format!("materials[{index}]");
        let (factor, texture) = match &json.extensions.specular_glossiness {
            Some(sg) => (sg.diffuse_factor, &sg.diffuse_texture),
            None => {
                let pbr = &json.pbr_metallic_roughness;
                (pbr.base_color_factor, &pbr.base_color_texture)
            }
        };
        let texture = match texture {
            Some(info) => self.texture(info, &format!("{place}.baseColorTexture"))?,
            None => None,
        };
        let material = Material {
            name: json.name.clone().unwrap_or_else(|| place.clone()),
            base_color: self.base_color(factor, &place)?,
            texture: texture.map(|(texture, _)| texture),
            alpha: alpha_mode(json, &place)?,
            is_double_sided: json.double_sided,
            transmission: self.transmission(json, &place)?,
            emissive: emissive(json, &place)?,
        };
        Ok(Surface { material, uv: texture.map(|(_, uv)| uv) })
    }

    fn base_color(&mut self, factor: Option<[f32; 4]>, place: &str) -> Result<Vec4, Fault> {
        let color = Vec4::from(factor.unwrap_or([1.0; 4]));
        if !color.is_finite() {
            return Err(Fault::at(format!("{place}.baseColorFactor"), "not finite"));
        }
        let clamped = color.clamp(Vec4::ZERO, Vec4::ONE);
        if clamped != color {
            self.repairs.notes.push(format!("{place}.baseColorFactor clamped to [0, 1]"));
        }
        Ok(clamped)
    }

    fn transmission(&mut self, json: &json::Material, place: &str) -> Result<f32, Fault> {
        let Some(transmission) = &json.extensions.transmission else { return Ok(0.0) };
        if transmission.transmission_texture.is_some() {
            self.repairs.notes.push(format!("{place}: transmission texture ignored, its factor kept"));
        }
        let factor = transmission.transmission_factor.unwrap_or(0.0);
        finite(factor, || format!("{place}.transmissionFactor")).map(|f| f.clamp(0.0, 1.0))
    }

    /// A texture without a source image, which only an optional extension could supply, is ignored with a note.
    fn texture(
        &mut self,
        info: &json::TextureInfo,
        place: &str,
    ) -> Result<Option<(TextureRef, UvUse)>, Fault> {
        let name = format!("textures[{}]", info.index);
        let texture = pick(&self.root.textures, info.index, "textures", || format!("{place}.index"))?;
        let Some(image) = texture.source else {
            self.repairs.notes.push(format!("{name} has no PNG or JPEG source and was ignored"));
            return Ok(None);
        };
        pick(&self.root.images, image, "images", || format!("{name}.source"))?;
        let slot = *self.slots.entry(image).or_insert_with(|| {
            self.images.push(image);
            self.images.len() as u32 - 1
        });
        let sampler = match texture.sampler {
            Some(i) => pick(&self.root.samplers, i, "samplers", || format!("{name}.sampler"))?.clone(),
            None => json::Sampler::default(),
        };
        let wrap = |code: Option<u32>| match code {
            None | Some(10497) => Ok(Wrap::Repeat),
            Some(33648) => Ok(Wrap::MirroredRepeat),
            Some(33071) => Ok(Wrap::ClampToEdge),
            Some(other) => Err(Fault::at(format!("{name}.sampler"), format!("{other} is not a wrap mode"))),
        };
        let wrap = [wrap(sampler.wrap_s)?, wrap(sampler.wrap_t)?];
        let reference = TextureRef { texture: slot, wrap, is_nearest: sampler.mag_filter == Some(9728) };
        Ok(Some((reference, uv_use(info, place)?)))
    }
}

/// KHR_texture_transform. Its GLSL and its example disagree on which way a rotation turns; the example ("lower left
/// quadrant"), its prose (counter-clockwise, v pointing down) and every viewer agree on this one.
fn uv_use(info: &json::TextureInfo, place: &str) -> Result<UvUse, Fault> {
    let transform = info.extensions.transform.clone().unwrap_or_default();
    let scale = Vec2::from(transform.scale.unwrap_or([1.0; 2]));
    let offset = Vec2::from(transform.offset.unwrap_or([0.0; 2]));
    let (sin, cos) = transform.rotation.unwrap_or(0.0).sin_cos();
    let matrix = Mat2::from_cols(Vec2::new(cos, -sin) * scale.x, Vec2::new(sin, cos) * scale.y);
    if !(matrix.is_finite() && offset.is_finite()) {
        return Err(Fault::at(format!("{place}.KHR_texture_transform"), "not finite"));
    }
    let set = transform.tex_coord.unwrap_or(info.tex_coord);
    Ok(UvUse { set, transform: UvTransform { matrix, offset } })
}

fn alpha_mode(json: &json::Material, place: &str) -> Result<AlphaMode, Fault> {
    match json.alpha_mode.as_deref() {
        None | Some("OPAQUE") => Ok(AlphaMode::Opaque),
        Some("BLEND") => Ok(AlphaMode::Blend),
        Some("MASK") => {
            let cutoff = finite(json.alpha_cutoff.unwrap_or(0.5), || format!("{place}.alphaCutoff"))?;
            Ok(AlphaMode::Mask { cutoff: cutoff.max(0.0) })
        }
        Some(other) => {
            Err(Fault::at(format!("{place}.alphaMode"), format!("{other:?} is not OPAQUE, MASK or BLEND")))
        }
    }
}

fn emissive(json: &json::Material, place: &str) -> Result<Vec3, Fault> {
    let factor = Vec3::from(json.emissive_factor.unwrap_or([0.0; 3]));
    let strength = json.extensions.emissive_strength.as_ref().and_then(|e| e.emissive_strength);
    let emissive = (factor * strength.unwrap_or(1.0)).max(Vec3::ZERO);
    if !(emissive.is_finite() && factor.is_finite()) {
        return Err(Fault::at(format!("{place}.emissiveFactor"), "not finite"));
    }
    Ok(emissive)
}

fn finite(value: f32, place: impl FnOnce() -> String) -> Result<f32, Fault> {
    if value.is_finite() { Ok(value) } else { Err(Fault::at(place(), "not finite")) }
}
