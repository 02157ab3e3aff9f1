//! Makes small glTF files in memory.

use std::{fs, path::Path};

use lt_scene::{Scene, SceneError, gltf::GltfAsset};
use serde_json::{Value, json};
use tempfile::TempDir;

pub const I8: u32 = 5120;
pub const U8: u32 = 5121;
pub const I16: u32 = 5122;
pub const U16: u32 = 5123;
pub const U32: u32 = 5125;
pub const F32: u32 = 5126;

/// A document and its binary chunk.
#[derive(Clone)]
pub struct Doc {
    pub json: Value,
    pub bin: Vec<u8>,
}

pub fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

impl Doc {
    pub fn new() -> Self {
        Self { json: json!({"asset": {"version": "2.0"}}), bin: Vec::new() }
    }

    /// One triangle (0,0,0), (1,0,0), (0,1,0) at one node.
    pub fn triangle() -> Self {
        let mut doc = Self::new();
        let positions = doc.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        doc.mesh(json!({"attributes": {"POSITION": positions}}));
        doc.push("nodes", json!({"mesh": 0}));
        doc
    }

    pub fn push(&mut self, list: &str, value: Value) -> usize {
        if self.json.get(list).is_none() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().unwrap();
        list.push(value);
        list.len() - 1
    }

    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        let offset = self.bin.len();
        self.bin.extend_from_slice(bytes);
        self.push("bufferViews", json!({"buffer": 0, "byteOffset": offset, "byteLength": bytes.len()}))
    }

    pub fn accessor(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        let view = self.view(bytes);
        let accessor = json!({"bufferView": view, "type": kind, "componentType": component, "count": count});
        self.push("accessors", accessor)
    }

    pub fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let width = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        self.accessor(kind, F32, values.len() / width, &floats(values))
    }

    pub fn mesh(&mut self, primitive: Value) -> usize {
        self.push("meshes", json!({"primitives": [primitive]}))
    }

    /// The JSON with its buffer's length filled in.
    pub fn finished(&self) -> Value {
        let mut json = self.json.clone();
        if json.get("buffers").is_none() && !self.bin.is_empty() {
            json["buffers"] = json!([{"byteLength": self.bin.len()}]);
        }
        json
    }

    pub fn glb(&self) -> Vec<u8> {
        let mut text = self.finished().to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bin = self.bin.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let length = 12 + 8 + text.len() + 8 + bin.len();
        let mut glb = b"glTF".to_vec();
        for word in [2, length as u32, text.len() as u32, 0x4E4F_534A] {
            glb.extend(word.to_le_bytes());
        }
        glb.extend(text);
        for word in [bin.len() as u32, 0x004E_4942] {
            glb.extend(word.to_le_bytes());
        }
        glb.extend(bin);
        glb
    }

    pub fn open(&self) -> Result<GltfAsset, SceneError> {
        open_bytes(&self.glb())
    }

    pub fn pose(&self, time_s: f32) -> Scene {
        self.open().unwrap().pose(time_s).unwrap()
    }

    /// The message of the error that opening or posing must give.
    pub fn refusal(&self) -> String {
        refusal(&self.glb())
    }
}

pub fn open_bytes(bytes: &[u8]) -> Result<GltfAsset, SceneError> {
    let folder = TempDir::new().unwrap();
    open_in(folder.path(), "scene.glb", bytes)
}

pub fn open_in(folder: &Path, name: &str, bytes: &[u8]) -> Result<GltfAsset, SceneError> {
    let path = folder.join(name);
    fs::write(&path, bytes).unwrap();
    GltfAsset::open(&path)
}

pub fn refusal(bytes: &[u8]) -> String {
    match open_bytes(bytes).and_then(|asset| asset.pose(0.5)) {
        Ok(_) => panic!("accepted"),
        Err(error) => error.to_string(),
    }
}

/// A PNG of RGBA texels.
pub fn png(width: u32, height: u32, texels: &[[u8; 4]]) -> Vec<u8> {
    let image = image::RgbaImage::from_raw(width, height, texels.concat()).unwrap();
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}
