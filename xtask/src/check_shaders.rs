//! `cargo xtask build-shaders --check`: proves that `shaders/` belongs to the sources.
//!
//! Without the shader compiler, by digests: the manifest's source digest against the tree, each module's digest,
//! naga's verdict, and the WGSL written again from the SPIR-V. With it, also by compiling and comparing bytes.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::compile::{self, Compiled};
use crate::manifest::{Entry, Manifest};
use crate::{backend, build_shaders, files, module, sources, workspace};

const REMEDY: &str = "run `cargo xtask build-shaders` and commit shaders/";

/// Runs the check and says on standard output which of its two parts ran.
///
/// # Errors
/// `shaders/` is stale, or [`backend::BUILD_VARIABLE`] demands a rebuild that cannot run.
pub fn run() -> Result<()> {
    let shaders = build_shaders::folder();
    let manifest = Manifest::read(&shaders).context(REMEDY)?;
    let mut problems = by_digest(&workspace::root(), &shaders, &manifest)?;
    println!("shaders: digests, validity and WGSL of {} modules compared", manifest.entries.len());
    // Stale sources make every module differ; one message is enough.
    if problems.is_empty()
        && let Some(backend) = compiler()?
    {
        problems = by_rebuild(&manifest, &shaders, &compile::compile(&backend)?)?;
        println!("shaders: compiled again and compared byte for byte");
    }
    if problems.is_empty() {
        println!("shaders: fresh");
        return Ok(());
    }
    for problem in &problems {
        eprintln!("shaders: {problem}");
    }
    bail!("shaders/ is stale: {REMEDY}")
}

/// The backend, if comparing bytes is possible without building it first or was asked for.
fn compiler() -> Result<Option<PathBuf>> {
    let demanded = std::env::var(backend::BUILD_VARIABLE).is_ok_and(|value| value == "1");
    let cached = backend::cached().ok().flatten();
    if !demanded && cached.is_none() {
        println!(
            "shaders: NOT compiled again: the shader compiler is not in the cache ({}=1 builds it)",
            backend::BUILD_VARIABLE
        );
        return Ok(None);
    }
    match backend::check_toolchain() {
        Ok(()) => backend::ensure_built().map(Some),
        Err(error) if demanded => Err(error),
        Err(error) => {
            println!("shaders: NOT compiled again: {error:#}");
            Ok(None)
        }
    }
}

/// What is wrong with `shaders` as far as stable Rust can tell.
fn by_digest(root: &Path, shaders: &Path, manifest: &Manifest) -> Result<Vec<String>> {
    let mut problems = Vec::new();
    match sources::digest(root, &manifest.sources) {
        Ok(digest) if digest == manifest.source_sha256 => {}
        Ok(_) => problems.push("the sources have changed since the modules were compiled".to_owned()),
        Err(error) => problems.push(format!("{error:#}")),
    }
    let expected =
        Manifest::new(manifest.source_sha256.clone(), manifest.sources.clone(), manifest.entries.clone());
    if *manifest != expected {
        problems.push("the manifest names another compiler, target or schema than this xtask".to_owned());
    }
    if manifest.entries.is_empty() {
        problems.push("the manifest has no entries".to_owned());
    }
    for entry in &manifest.entries {
        if let Err(error) = check_entry(shaders, entry) {
            problems.push(format!("{}: {error:#}", entry.name));
        }
    }
    for stray in build_shaders::strays(shaders, manifest)? {
        problems.push(format!("{} is not in the manifest", stray.display()));
    }
    Ok(problems)
}

fn check_entry(shaders: &Path, entry: &Entry) -> Result<()> {
    let spirv = fs::read(shaders.join(&entry.file)).with_context(|| format!("cannot read {}", entry.file))?;
    let inspected = module::inspect(&spirv)?;
    if Entry::new(&entry.name, &spirv, &inspected) != *entry {
        bail!("{} and its WGSL translation do not match the manifest", entry.file);
    }
    let wgsl = fs::read(shaders.join(&entry.wgsl_file))
        .with_context(|| format!("cannot read {}", entry.wgsl_file))?;
    if files::sha256(&wgsl) != entry.wgsl_sha256 {
        bail!("{} is not the translation of {}", entry.wgsl_file, entry.file);
    }
    Ok(())
}

/// What differs between `shaders` and a fresh compilation.
fn by_rebuild(manifest: &Manifest, shaders: &Path, compiled: &Compiled) -> Result<Vec<String>> {
    let mut problems = Vec::new();
    if compiled.sources != manifest.sources {
        problems.push("the compiler read other files than the manifest lists".to_owned());
    }
    for entry in &manifest.entries {
        match compiled.modules.get(&entry.entry_point) {
            None => problems.push(format!("{} no longer exists", entry.entry_point)),
            Some(spirv) if *spirv != fs::read(shaders.join(&entry.file))? => {
                problems.push(format!("{} compiles to other bytes than {}", entry.entry_point, entry.file));
            }
            Some(_) => {}
        }
    }
    for entry_point in compiled.modules.keys() {
        if manifest.entries.iter().all(|entry| entry.entry_point != *entry_point) {
            problems.push(format!("{entry_point} is not in the manifest"));
        }
    }
    Ok(problems)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifest;

    /// A checkout with one source file and one module in `shaders/`.
    struct Checkout {
        dir: tempfile::TempDir,
        manifest: Manifest,
    }

    impl Checkout {
        fn new() -> Self {
            let dir = tempfile::tempdir().unwrap();
            let root = dir.path();
            fs::create_dir_all(root.join("crates/a/src")).unwrap();
            fs::create_dir(root.join("shaders")).unwrap();
            fs::write(root.join("crates/a/src/lib.rs"), "fn a() {}").unwrap();
            fs::write(root.join("crates/a/Cargo.toml"), "[package]").unwrap();
            fs::write(root.join("Cargo.lock"), "").unwrap();
            let spirv = module::tests::minimal();
            let inspected = module::inspect(&spirv).unwrap();
            fs::write(root.join("shaders/main.spv"), &spirv).unwrap();
            fs::write(root.join("shaders/main.wgsl"), &inspected.wgsl).unwrap();
            fs::write(root.join("shaders").join(manifest::FILE), "").unwrap();
            let sources = vec!["crates/a/src/lib.rs".to_owned()];
            let digest = sources::digest(root, &sources).unwrap();
            let entry = Entry::new("main", &spirv, &inspected);
            let manifest = Manifest::new(digest, sources, vec![entry]);
            Self { dir, manifest }
        }

        fn problems(&self) -> Vec<String> {
            let root = self.dir.path();
            by_digest(root, &root.join("shaders"), &self.manifest).unwrap()
        }

        fn problems_after(path: &str, content: &[u8]) -> Vec<String> {
            let checkout = Self::new();
            fs::write(checkout.dir.path().join(path), content).unwrap();
            checkout.problems()
        }

        fn rebuilt(&self, modules: &[(&str, Vec<u8>)]) -> Vec<String> {
            let modules = modules.iter().map(|(name, spirv)| ((*name).to_owned(), spirv.clone())).collect();
            let compiled = Compiled { modules, sources: self.manifest.sources.clone() };
            by_rebuild(&self.manifest, &self.dir.path().join("shaders"), &compiled).unwrap()
        }
    }

    #[test]
    fn a_fresh_checkout_has_no_problems() {
        let checkout = Checkout::new();
        assert_eq!(checkout.problems(), Vec::<String>::new());
        assert!(checkout.rebuilt(&[("main", module::tests::minimal())]).is_empty());
    }

    #[test]
    fn each_kind_of_change_is_found() {
        let mut other = module::tests::minimal();
        let end = other.len();
        other[end - 4..].copy_from_slice(&[0; 4]);
        for (path, content) in [
            ("crates/a/src/lib.rs", &b"fn b() {}"[..]),
            ("crates/a/Cargo.toml", b"[lib]"),
            ("shaders/main.spv", b""),
            ("shaders/main.spv", &other),
            ("shaders/main.wgsl", b""),
            ("shaders/stray.spv", b""),
        ] {
            assert_eq!(Checkout::problems_after(path, content).len(), 1, "{path}");
        }
    }

    #[test]
    fn a_wrong_manifest_is_found() {
        let mut checkout = Checkout::new();
        checkout.manifest.entries[0].workgroup_size = [1; 3];
        checkout.manifest.toolchain = "stable".to_owned();
        assert_eq!(checkout.problems().len(), 2);
        checkout.manifest.entries.clear();
        assert!(checkout.problems().iter().any(|problem| problem.contains("no entries")));
    }

    #[test]
    fn a_different_rebuild_is_found() {
        let checkout = Checkout::new();
        let spirv = module::tests::minimal;
        assert_eq!(checkout.rebuilt(&[]).len(), 1, "entry gone");
        assert_eq!(checkout.rebuilt(&[("main", vec![])]).len(), 1, "other bytes");
        assert_eq!(checkout.rebuilt(&[("main", spirv()), ("new", spirv())]).len(), 1, "entry not stored");
    }
}
