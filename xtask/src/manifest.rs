//! `shaders/manifest.json`: which module holds which entry point, and what it was compiled from.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use serde::{Deserialize, Serialize};

use crate::module::Inspected;
use crate::{backend, compile, files};

/// Version of the layout below.
pub const SCHEMA: u32 = 1;

/// The file's name within `shaders/`.
pub const FILE: &str = "manifest.json";

/// Everything a reader of `shaders/` has to know.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Says that the folder is generated, and by what.
    pub generated_by: String,
    /// [`SCHEMA`].
    pub schema: u32,
    /// The nightly that compiled the modules.
    pub toolchain: String,
    /// Version of the compiler backend.
    pub rustc_codegen_spirv: String,
    /// rust-gpu's name of the target.
    pub target: String,
    /// Options of the compiler backend.
    pub backend_args: Vec<String>,
    /// [`crate::sources::digest`] of `sources`.
    pub source_sha256: String,
    /// Files that the compiler read, relative to the root of the checkout, sorted.
    pub sources: Vec<String>,
    /// One per module, sorted by name.
    pub entries: Vec<Entry>,
}

/// One entry point and its two modules.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Last segment of the entry point's path: unique, and the stem of both files.
    pub name: String,
    /// The SPIR-V module's file name.
    pub file: String,
    /// Length of the SPIR-V module.
    pub bytes: u64,
    /// Digest of the SPIR-V module.
    pub sha256: String,
    /// The entry point's name in the SPIR-V module, as wgpu wants it.
    pub entry_point: String,
    /// The WGSL module's file name.
    pub wgsl_file: String,
    /// Digest of the WGSL module.
    pub wgsl_sha256: String,
    /// The entry point's name in the WGSL module.
    pub wgsl_entry_point: String,
    /// `compute`, `vertex` or `fragment`.
    pub stage: String,
    /// Invocations per workgroup; zeros unless the stage is `compute`.
    pub workgroup_size: [u32; 3],
}

impl Manifest {
    /// A manifest by this xtask's compiler and options.
    pub fn new(source_sha256: String, sources: Vec<String>, entries: Vec<Entry>) -> Self {
        Self {
            generated_by: "cargo xtask build-shaders".to_owned(),
            schema: SCHEMA,
            toolchain: backend::TOOLCHAIN.to_owned(),
            rustc_codegen_spirv: backend::VERSION.to_owned(),
            target: compile::TARGET.to_owned(),
            backend_args: compile::BACKEND_ARGS.iter().map(|arg| (*arg).to_owned()).collect(),
            source_sha256,
            sources,
            entries,
        }
    }

    /// Reads the manifest in the folder `shaders`.
    ///
    /// # Errors
    /// The file is missing or does not have the layout of [`Manifest`].
    pub fn read(shaders: &Path) -> Result<Self> {
        let path = shaders.join(FILE);
        let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        serde_json::from_str(&text).with_context(|| format!("cannot understand {}", path.display()))
    }

    /// The text of the file.
    ///
    /// # Errors
    /// None in practice: every field can be written as JSON.
    pub fn to_json(&self) -> Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }
}

impl Entry {
    /// Describes a module that [`crate::module::inspect`] has accepted.
    pub fn new(name: &str, spirv: &[u8], inspected: &Inspected) -> Self {
        Self {
            name: name.to_owned(),
            file: format!("{name}.spv"),
            bytes: spirv.len() as u64,
            sha256: files::sha256(spirv),
            entry_point: inspected.entry_point.clone(),
            wgsl_file: format!("{name}.wgsl"),
            wgsl_sha256: files::sha256(inspected.wgsl.as_bytes()),
            wgsl_entry_point: inspected.wgsl_entry_point.clone(),
            stage: inspected.stage.to_owned(),
            workgroup_size: inspected.workgroup_size,
        }
    }
}

/// The file name for an entry point such as `entry::evaluate::ltt_vsm_cs`: its last segment.
///
/// # Errors
/// The segment is not a plain identifier in lower case, which some file systems would confuse.
pub fn entry_name(entry_point: &str) -> Result<&str> {
    let name = entry_point.rsplit("::").next().unwrap_or(entry_point);
    let plain = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_';
    ensure!(!name.is_empty() && name.bytes().all(plain), "{entry_point}: name it in lower-case letters");
    Ok(name)
}

/// Fails if two of `entry_points` would be stored under one name.
///
/// # Errors
/// Two entry points end in the same segment, or one has no usable name.
pub fn check_unique<'a>(entry_points: impl Iterator<Item = &'a str>) -> Result<()> {
    let mut seen = std::collections::BTreeMap::new();
    for entry_point in entry_points {
        if let Some(other) = seen.insert(entry_name(entry_point)?, entry_point) {
            bail!("{other} and {entry_point} end in the same name; rename one of the two functions");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_segment_names_the_file() {
        assert_eq!(entry_name("entry::evaluate::ltt_vsm_cs").unwrap(), "ltt_vsm_cs");
        assert_eq!(entry_name("main_cs").unwrap(), "main_cs");
    }

    #[test]
    fn names_unfit_for_files_are_errors() {
        for bad in ["", "entry::", "entry::A_cs", "../x", "a b"] {
            assert!(entry_name(bad).is_err(), "{bad:?}");
        }
    }

    #[test]
    fn two_entries_of_one_name_are_an_error() {
        assert!(check_unique(["a::x_cs", "b::x_cs"].into_iter()).is_err());
        assert!(check_unique(["a::x_cs", "b::y_cs"].into_iter()).is_ok());
    }
}
