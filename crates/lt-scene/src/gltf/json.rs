//! The parts of glTF's JSON that matter here, typed, every element parsed on its own so that a fault names it.
//!
//! Not the `gltf` crate: its index types wrap around at 2³² without a word, its GLB reader subtracts before it
//! checks, and its animation targets must name a node, which the specification leaves open.

use std::collections::BTreeMap;

use serde::{Deserialize, de::DeserializeOwned};
use serde_json::Value;

use super::fault::Fault;

/// Extensions that may be required: honoured, or without influence on shape and coverage.
const KNOWN_EXTENSIONS: &[&str] = &[
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",
];

/// What to do about a required extension that is not known.
const REMEDIES: &[(&str, &str)] = &[
    ("KHR_draco_mesh_compression", "re-export without Draco mesh compression"),
    ("EXT_meshopt_compression", "re-export without meshopt compression"),
    ("KHR_meshopt_compression", "re-export without meshopt compression"),
    ("KHR_texture_basisu", "re-export with PNG or JPEG textures instead of KTX2"),
    ("EXT_texture_webp", "re-export with PNG or JPEG textures instead of WebP"),
    ("EXT_texture_avif", "re-export with PNG or JPEG textures instead of AVIF"),
    ("MSFT_texture_dds", "re-export with PNG or JPEG textures instead of DDS"),
    ("EXT_mesh_gpu_instancing", "re-export without GPU instancing, one node per instance"),
];

macro_rules! json_struct {
    ($(#[$doc:meta])* $name:ident { $($(#[$attr:meta])* $field:ident: $type:ty),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, Default, Deserialize)]
        #[serde(rename_all = "camelCase")]
        pub(super) struct $name { $($(#[$attr])* pub(super) $field: $type,)* }
    };
}

json_struct!(Document {
    asset: Asset,
    scene: Option<usize>,
    #[serde(default)] extensions_required: Vec<String>,
    #[serde(default)] accessors: Vec<Value>,
    #[serde(default)] animations: Vec<Value>,
    #[serde(default)] buffers: Vec<Value>,
    #[serde(default)] buffer_views: Vec<Value>,
    #[serde(default)] cameras: Vec<Value>,
    #[serde(default)] images: Vec<Value>,
    #[serde(default)] materials: Vec<Value>,
    #[serde(default)] meshes: Vec<Value>,
    #[serde(default)] nodes: Vec<Value>,
    #[serde(default)] samplers: Vec<Value>,
    #[serde(default)] scenes: Vec<Value>,
    #[serde(default)] skins: Vec<Value>,
    #[serde(default)] textures: Vec<Value>,
    #[serde(default)] extensions: DocumentExtensions,
});
json_struct!(Asset { version: String, min_version: Option<String>, });
json_struct!(DocumentExtensions {
    #[serde(rename = "KHR_lights_punctual")] lights: Option<LightList>,
});
json_struct!(LightList { #[serde(default)] lights: Vec<Value>, });
json_struct!(Buffer { byte_length: usize, uri: Option<String>, });
json_struct!(BufferView {
    buffer: usize,
    #[serde(default)] byte_offset: usize,
    byte_length: usize,
    byte_stride: Option<usize>,
});
json_struct!(Accessor {
    buffer_view: Option<usize>,
    #[serde(default)] byte_offset: usize,
    component_type: u32,
    #[serde(default)] normalized: bool,
    count: usize,
    #[serde(rename = "type")] kind: String,
    sparse: Option<Sparse>,
});
json_struct!(Sparse { count: usize, indices: SparseIndices, values: SparseValues });
json_struct!(SparseIndices {
    buffer_view: usize,
    #[serde(default)]
    byte_offset: usize,
    component_type: u32,
});
json_struct!(SparseValues {
    buffer_view: usize,
    #[serde(default)]
    byte_offset: usize,
});
json_struct!(Mesh { name: Option<String>, primitives: Vec<Primitive>, #[serde(default)] weights: Vec<f32>, });
json_struct!(Primitive {
    attributes: BTreeMap<String, usize>,
    indices: Option<usize>,
    material: Option<usize>,
    mode: Option<u32>,
    #[serde(default)] targets: Vec<BTreeMap<String, usize>>,
});
json_struct!(Node {
    name: Option<String>,
    #[serde(default)] children: Vec<usize>,
    matrix: Option<[f32; 16]>,
    translation: Option<[f32; 3]>,
    rotation: Option<[f32; 4]>,
    scale: Option<[f32; 3]>,
    mesh: Option<usize>,
    skin: Option<usize>,
    camera: Option<usize>,
    weights: Option<Vec<f32>>,
    #[serde(default)] extras: Value,
    #[serde(default)] extensions: NodeExtensions,
});
json_struct!(NodeExtensions { #[serde(rename = "KHR_lights_punctual")] light: Option<NodeLight>, });
json_struct!(NodeLight { light: usize });
json_struct!(Scene { #[serde(default)] nodes: Vec<usize>, });
json_struct!(Skin { inverse_bind_matrices: Option<usize>, joints: Vec<usize>, });
json_struct!(Animation { channels: Vec<Channel>, samplers: Vec<AnimationSampler>, });
json_struct!(Channel { sampler: usize, target: ChannelTarget });
json_struct!(ChannelTarget { node: Option<usize>, path: String, });
json_struct!(AnimationSampler { input: usize, output: usize, interpolation: Option<String>, });
json_struct!(Camera {
    name: Option<String>,
    #[serde(rename = "type")] kind: String,
    perspective: Option<Perspective>,
});
json_struct!(Perspective { yfov: f32 });
json_struct!(Light {
    name: Option<String>,
    #[serde(rename = "type")] kind: String,
    color: Option<[f32; 3]>,
    intensity: Option<f32>,
    range: Option<f32>,
    #[serde(default)] spot: Spot,
});
json_struct!(Spot { inner_cone_angle: Option<f32>, outer_cone_angle: Option<f32>, });
json_struct!(Image { name: Option<String>, uri: Option<String>, buffer_view: Option<usize>, });
json_struct!(Texture { sampler: Option<usize>, source: Option<usize>, });
json_struct!(Sampler { mag_filter: Option<u32>, wrap_s: Option<u32>, wrap_t: Option<u32>, });
json_struct!(TextureInfo {
    index: usize,
    #[serde(default)]
    tex_coord: u32,
    #[serde(default)]
    extensions: TextureInfoExtensions,
});
json_struct!(TextureInfoExtensions {
    #[serde(rename = "KHR_texture_transform")] transform: Option<TextureTransform>,
});
json_struct!(TextureTransform {
    offset: Option<[f32; 2]>,
    rotation: Option<f32>,
    scale: Option<[f32; 2]>,
    tex_coord: Option<u32>,
});
json_struct!(Material {
    name: Option<String>,
    #[serde(default)] pbr_metallic_roughness: MetallicRoughness,
    emissive_factor: Option<[f32; 3]>,
    alpha_mode: Option<String>,
    alpha_cutoff: Option<f32>,
    #[serde(default)] double_sided: bool,
    #[serde(default)] extensions: MaterialExtensions,
});
json_struct!(MetallicRoughness { base_color_factor: Option<[f32; 4]>, base_color_texture: Option<TextureInfo>, });
json_struct!(MaterialExtensions {
    #[serde(rename = "KHR_materials_transmission")] transmission: Option<Transmission>,
    #[serde(rename = "KHR_materials_emissive_strength")] emissive_strength: Option<EmissiveStrength>,
    #[serde(rename = "KHR_materials_pbrSpecularGlossiness")] specular_glossiness: Option<SpecularGlossiness>,
});
json_struct!(Transmission { transmission_factor: Option<f32>, transmission_texture: Option<TextureInfo>, });
json_struct!(EmissiveStrength { emissive_strength: Option<f32>, });
json_struct!(SpecularGlossiness { diffuse_factor: Option<[f32; 4]>, diffuse_texture: Option<TextureInfo>, });

/// A parsed document.
#[derive(Clone, Debug, Default)]
pub(super) struct Root {
    pub(super) scene: Option<usize>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) animations: Vec<Animation>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) buffer_views: Vec<BufferView>,
    pub(super) cameras: Vec<Camera>,
    pub(super) images: Vec<Image>,
    pub(super) lights: Vec<Light>,
    pub(super) materials: Vec<Material>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) nodes: Vec<Node>,
    pub(super) samplers: Vec<Sampler>,
    pub(super) scenes: Vec<Scene>,
    pub(super) skins: Vec<Skin>,
    pub(super) textures: Vec<Texture>,
}

/// Parses the JSON text and refuses what needs another reader.
pub(super) fn parse(text: &[u8]) -> Result<Root, Fault> {
    let document: Document = serde_json::from_slice(text)
        .map_err(|e| Fault::at("JSON", format!("{e}; is this a glTF 2.0 file?")))?;
    check_version(&document.asset)?;
    check_extensions(&document.extensions_required)?;
    let lights = document.extensions.lights.map(|l| l.lights).unwrap_or_default();
    Ok(Root {
        scene: document.scene,
        accessors: list("accessors", document.accessors)?,
        animations: list("animations", document.animations)?,
        buffers: list("buffers", document.buffers)?,
        buffer_views: list("bufferViews", document.buffer_views)?,
        cameras: list("cameras", document.cameras)?,
        images: list("images", document.images)?,
        lights: list("extensions.KHR_lights_punctual.lights", lights)?,
        materials: list("materials", document.materials)?,
        meshes: list("meshes", document.meshes)?,
        nodes: list("nodes", document.nodes)?,
        samplers: list("samplers", document.samplers)?,
        scenes: list("scenes", document.scenes)?,
        skins: list("skins", document.skins)?,
        textures: list("textures", document.textures)?,
    })
}

fn list<T: DeserializeOwned>(name: &str, values: Vec<Value>) -> Result<Vec<T>, Fault> {
    let parse =
        |(i, v)| serde_json::from_value(v).map_err(|e| Fault::at(format!("{name}[{i}]"), e.to_string()));
    values.into_iter().enumerate().map(parse).collect()
}

fn check_version(asset: &Asset) -> Result<(), Fault> {
    let needed = asset.min_version.as_deref();
    let is_readable = asset.version.split('.').next() == Some("2") && needed.is_none_or(|v| v == "2.0");
    if is_readable {
        return Ok(());
    }
    let found = needed.unwrap_or(&asset.version);
    Err(Fault::at("asset.version", format!("{found:?} is not 2.0: re-export as glTF 2.0")))
}

fn check_extensions(required: &[String]) -> Result<(), Fault> {
    let Some(unknown) = required.iter().find(|e| !KNOWN_EXTENSIONS.contains(&e.as_str())) else {
        return Ok(());
    };
    let known = REMEDIES.iter().find(|(name, _)| name == unknown).map(|(_, remedy)| (*remedy).to_owned());
    let remedy = known.unwrap_or_else(|| format!("re-export without {unknown}"));
    Err(Fault::Extension { extension: unknown.clone(), remedy })
}
