//! Compiles `crates/lt-shaders` to one SPIR-V module per entry point with rust-gpu.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use spirv_builder::SpirvBuilder;

use crate::{backend, prune, strip, workspace};

/// The one target that loads through naga and by passthrough without validation messages.
pub const TARGET: &str = "spirv-unknown-spv1.3";

/// Arguments of the backend: spirv-opt stays off, because it replaces `a / 3` by a multiplication and factors
/// `a * b + a * c`, after which GPU and CPU no longer compute the same bits.
pub const BACKEND_ARGS: &[&str] = &["--no-spirv-opt"];

/// What one compilation gave.
pub struct Compiled {
    /// SPIR-V without source text, by full entry-point name, for example `entry::evaluate::ltt_vsm_cs`.
    pub modules: BTreeMap<String, Vec<u8>>,
    /// Files of this workspace that the compiler read, relative to its root, with forward slashes, sorted.
    pub sources: Vec<String>,
}

/// Compiles the shader crate with `backend`, a library from [`backend::ensure_built`].
///
/// # Errors
/// The compilation fails (rustc has printed why), or its products cannot be read.
pub fn compile(backend: &Path) -> Result<Compiled> {
    let target_dir = workspace::target_dir()?.join("spirv");
    let mut builder = SpirvBuilder::new(workspace::root().join("crates/lt-shaders"), TARGET)
        .multimodule(true)
        .shader_crate_default_features(false)
        .rustc_codegen_spirv_location(backend)
        .target_dir_path(&target_dir);
    builder.toolchain_overwrite = Some(backend::TOOLCHAIN.to_owned());
    builder.extra_args = BACKEND_ARGS.iter().map(|arg| (*arg).to_owned()).collect();

    let result = builder.build().context("rust-gpu could not compile crates/lt-shaders")?;
    let mut modules = BTreeMap::new();
    for (entry, path) in result.module.unwrap_multi() {
        let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        let bytes = strip::strip(&bytes)
            .and_then(|stripped| prune::prune(&stripped))
            .with_context(|| format!("in {}", path.display()))?;
        modules.insert(entry.clone(), bytes);
    }
    ensure!(!modules.is_empty(), "crates/lt-shaders has no entry points");
    let depfile = target_dir.join(TARGET).join("release/lt_shaders.spv.d");
    let listed =
        fs::read_to_string(&depfile).with_context(|| format!("cannot read {}", depfile.display()))?;
    let sources = sources_below(&listed, &workspace::root());
    ensure!(!sources.is_empty(), "{} names no source of this checkout", depfile.display());
    Ok(Compiled { modules, sources })
}

/// The `.rs` files below `root` that a dependency file of cargo names, relative, sorted, without repeats.
fn sources_below(depfile: &str, root: &Path) -> Vec<String> {
    // One rule per line, `target: path path …`; a space within a path is written as `\ `.
    let words = depfile.replace("\\ ", "\0");
    let paths = words.split_whitespace().map(|word| PathBuf::from(word.replace('\0', " ")));
    let below = paths.filter_map(|path| {
        let relative = path.strip_prefix(root).ok()?.to_str()?.replace('\\', "/");
        relative.ends_with(".rs").then_some(relative)
    });
    below.collect::<BTreeSet<_>>().into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_sources_of_this_checkout_are_kept_and_sorted() {
        let depfile =
            "/t/lt.spv.json: /cache/lib.so /my\\ work/b.rs /my\\ work/a.rs /other/c.rs /my\\ work/a.rs\n";
        assert_eq!(sources_below(depfile, Path::new("/my work")), ["a.rs", "b.rs"]);
    }
}
