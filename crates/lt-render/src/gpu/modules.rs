//! The committed shader modules, embedded.

use std::borrow::Cow;

/// One compiled entry point.
#[derive(Clone, Copy, Debug)]
pub struct ShaderModule {
    /// File stem, e.g. `shade_cs`.
    pub name: &'static str,
    /// Entry point inside the module.
    pub entry_point: &'static str,
    /// SPIR-V 1.3, little-endian words.
    pub spirv: &'static [u8],
}

/// Every module of `shaders/manifest.json`, by name.
pub const MODULES: &[ShaderModule] = include!(concat!(env!("OUT_DIR"), "/modules.rs"));

impl ShaderModule {
    /// Finds a module by name.
    pub fn named(name: &str) -> Option<&'static Self> {
        MODULES.iter().find(|m| m.name == name)
    }

    /// Loads it.
    pub fn load(&self, device: &wgpu::Device) -> wgpu::ShaderModule {
        let words: Vec<u32> =
            self.spirv.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.name),
            source: wgpu::ShaderSource::SpirV(Cow::Owned(words)),
        })
    }
}
