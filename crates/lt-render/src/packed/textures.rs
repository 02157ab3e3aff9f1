//! Materials and texels: coverage at full resolution, colour reduced to what a picture needs.

use std::collections::BTreeMap;

use lt_scene::{AlphaMode, Mesh, Scene, Texture, TextureRef, Wrap};
use lt_shaders::abi::Material;

use super::Packing;

/// Colour textures are halved until neither side is longer. Coverage never is.
const MAX_COLOR_SIDE: u32 = 512;

/// Texels of all textures in use and where each lies.
#[derive(Default)]
pub struct PackedTextures {
    pub alpha_texels: Vec<u32>,
    pub color_texels: Vec<u32>,
    /// By texture index: offset in bytes of `alpha_texels`, and size word.
    alpha: BTreeMap<u32, (u32, u32)>,
    /// By texture index: offset in words of `color_texels`, and size word.
    color: BTreeMap<u32, (u32, u32)>,
    /// By texture index: the smallest alpha in it, 0 to 1.
    least_alpha: BTreeMap<u32, f32>,
}

/// Gathers the texels that materials of placed meshes use.
pub fn pack(scene: &Scene) -> PackedTextures {
    let mut packed = PackedTextures::default();
    let mut alpha_bytes: Vec<u8> = Vec::new();
    for instance in &scene.instances {
        let material = &scene.materials[scene.meshes[instance.mesh as usize].material as usize];
        let Some(TextureRef { texture, .. }) = material.texture else { continue };
        let image = &scene.textures[texture as usize];
        if material.cutoff().is_some() && !packed.alpha.contains_key(&texture) {
            packed.alpha.insert(texture, (alpha_bytes.len() as u32, size_word(image.width, image.height)));
            alpha_bytes.extend(image.texels.iter().map(|t| t[3]));
            let least = image.texels.iter().map(|t| t[3]).min().unwrap_or(255);
            packed.least_alpha.insert(texture, f32::from(least) / 255.0);
        }
        packed.color.entry(texture).or_insert_with(|| {
            let (width, height, texels) = reduced(image);
            let offset = packed.color_texels.len() as u32;
            packed.color_texels.extend(texels.iter().map(|t| u32::from_le_bytes(*t)));
            (offset, size_word(width, height))
        });
    }
    alpha_bytes.resize(alpha_bytes.len().next_multiple_of(4), 0);
    packed.alpha_texels =
        alpha_bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    packed
}

fn size_word(width: u32, height: u32) -> u32 {
    width | height << 16
}

/// Halves an image by box filter until it fits; odd sides drop their last row or column.
fn reduced(image: &Texture) -> (u32, u32, Vec<[u8; 4]>) {
    let (mut width, mut height, mut texels) = (image.width, image.height, image.texels.to_vec());
    while width.max(height) > MAX_COLOR_SIDE {
        let (w, h) = ((width / 2).max(1), (height / 2).max(1));
        let at = |x: u32, y: u32| texels[(y.min(height - 1) * width + x.min(width - 1)) as usize];
        let average = |x: u32, y: u32| -> [u8; 4] {
            let four =
                [at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1)];
            std::array::from_fn(|c| (four.iter().map(|t| u32::from(t[c])).sum::<u32>().div_ceil(4)) as u8)
        };
        let halved = (0..h).flat_map(|y| (0..w).map(move |x| (x, y))).map(|(x, y)| average(x, y)).collect();
        (width, height, texels) = (w, h, halved);
    }
    (width, height, texels)
}

/// Kernel materials: four variants of each scene material, by what its instance casts and receives.
pub struct PackedMaterials {
    pub packed: Vec<Material>,
    /// Per scene material: the smallest texture alpha times factor.
    least_alpha: Vec<f32>,
    /// Per scene material: whether it may block light.
    may_cast: Vec<bool>,
}

/// Least alpha at which a blended surface is a layer; below it the nearest texels are clear.
const LEAST_SEEN_ALPHA: f32 = 0.5 / 255.0;

/// Translates the scene's materials. Where translucency is traced, translucent ones block no light.
pub fn pack_materials(scene: &Scene, textures: &PackedTextures, packing: Packing) -> PackedMaterials {
    let mut out = PackedMaterials { packed: Vec::new(), least_alpha: Vec::new(), may_cast: Vec::new() };
    for material in &scene.materials {
        let mut base = Material {
            base_color: material.base_color,
            cutoff: match material.alpha {
                AlphaMode::Blend if packing.layers_behind > 0 => LEAST_SEEN_ALPHA,
                _ => material.cutoff().unwrap_or(0.0),
            },
            flags: if material.alpha == AlphaMode::Blend { Material::BLENDS } else { 0 },
            transmission: material.transmission,
            ..Material::default()
        };
        let mut least = material.base_color.w;
        if let Some(used) = material.texture {
            base.flags |= wrap_flags(used);
            if let Some(&(offset, size)) = textures.alpha.get(&used.texture) {
                (base.alpha_offset, base.alpha_size) = (offset, size);
                least *= textures.least_alpha[&used.texture];
            }
            if let Some(&(offset, size)) = textures.color.get(&used.texture) {
                (base.color_offset, base.color_size) = (offset, size);
            }
        }
        out.least_alpha.push(least);
        out.may_cast.push(!(packing.traces_translucency && material.is_translucent()));
        for variant in 0..4 {
            out.packed.push(Material { flags: base.flags | variant, ..base });
        }
    }
    out
}

const _: () = assert!(Material::CASTS == 1 && Material::RECEIVES == 2);

impl PackedMaterials {
    /// Index of a scene material's variant.
    pub fn variant(&self, material: u32, casts: bool, receives: bool) -> u32 {
        let casts = casts && self.may_cast[material as usize];
        material * 4 + u32::from(casts) * Material::CASTS + u32::from(receives) * Material::RECEIVES
    }

    /// Whether hits on a mesh with this variant must ask the alpha test: it does not cast, or some point of it may
    /// fall below the cut-off.
    pub fn has_holes(&self, variant: u32, mesh: &Mesh) -> bool {
        let material = &self.packed[variant as usize];
        let least_vertex = mesh.colors.iter().map(|c| c[3]).min().unwrap_or(255);
        let least = self.least_alpha[variant as usize / 4] * f32::from(least_vertex) / 255.0;
        // Blending may round a hair below the least of its inputs.
        let may_fall_below = material.cutoff > 0.0 && least < material.cutoff * 1.00001;
        material.flags & Material::CASTS == 0 || may_fall_below
    }
}

fn wrap_flags(used: TextureRef) -> u32 {
    let mode = |w: Wrap| match w {
        Wrap::Repeat => Material::REPEAT,
        Wrap::MirroredRepeat => Material::MIRROR,
        Wrap::ClampToEdge => Material::CLAMP,
    };
    mode(used.wrap[0]) << Material::WRAP_U_SHIFT
        | mode(used.wrap[1]) << Material::WRAP_V_SHIFT
        | if used.is_nearest { Material::NEAREST } else { 0 }
}
