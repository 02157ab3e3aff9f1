//! `cargo xtask build-shaders`: compiles, validates and stores every entry point in `shaders/`.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use crate::compile::Compiled;
use crate::manifest::{self, Entry, Manifest};
use crate::{backend, check_shaders, compile, files, module, sources, workspace};

/// Options of the command.
#[derive(clap::Args)]
pub struct Args {
    /// Compare shaders/ with the sources instead of writing it; rebuilds if the compiler is at hand
    #[arg(long)]
    check: bool,
    /// Store this entry point only (last segment of its path); --check goes on failing until a full build
    #[arg(long, value_name = "NAME", conflicts_with = "check")]
    entry: Option<String>,
}

/// The folder of generated modules.
pub fn folder() -> PathBuf {
    workspace::root().join("shaders")
}

/// Runs the command.
///
/// # Errors
/// The compiler is missing or fails, a module is not valid, or (with `--check`) `shaders/` is stale.
pub fn run(args: &Args) -> Result<()> {
    if args.check {
        return check_shaders::run();
    }
    backend::check_toolchain()?;
    let compiled = compile::compile(&backend::ensure_built()?)?;
    manifest::check_unique(compiled.modules.keys().map(String::as_str))?;
    let accepted = judge(&compiled, args.entry.as_deref())?;
    let shaders = folder();
    fs::create_dir_all(&shaders).with_context(|| format!("cannot create {}", shaders.display()))?;
    for (entry, spirv, wgsl) in &accepted {
        let changed = files::replace(&shaders.join(&entry.file), spirv)?
            | files::replace(&shaders.join(&entry.wgsl_file), wgsl.as_bytes())?;
        report(entry, wgsl.len(), changed);
    }
    let entries: Vec<Entry> = accepted.into_iter().map(|(entry, ..)| entry).collect();
    let manifest = if args.entry.is_some() {
        merged(Manifest::read(&shaders).ok(), entries)
    } else {
        let digest = sources::digest(&workspace::root(), &compiled.sources)?;
        Manifest::new(digest, compiled.sources, sorted(entries))
    };
    // Last, so that an interrupted run leaves a folder that --check refuses.
    files::replace(&shaders.join(manifest::FILE), manifest.to_json()?.as_bytes())?;
    for stray in strays(&shaders, &manifest)? {
        fs::remove_file(&stray).with_context(|| format!("cannot remove {}", stray.display()))?;
        println!("removed {}", stray.display());
    }
    let total: u64 = manifest.entries.iter().map(|entry| entry.bytes).sum();
    println!("{} modules, {total} bytes of SPIR-V, in {}", manifest.entries.len(), shaders.display());
    Ok(())
}

/// Validates the modules, or the one named `only`; a single refusal leaves `shaders/` as it was.
fn judge(compiled: &Compiled, only: Option<&str>) -> Result<Vec<(Entry, Vec<u8>, String)>> {
    let mut accepted = Vec::new();
    let mut refused = 0;
    for (entry_point, spirv) in &compiled.modules {
        let name = manifest::entry_name(entry_point)?;
        if only.is_some_and(|only| only != name) {
            continue;
        }
        match module::inspect(spirv) {
            Ok(inspected) => {
                accepted.push((Entry::new(name, spirv, &inspected), spirv.clone(), inspected.wgsl));
            }
            Err(error) => {
                refused += 1;
                eprintln!("{entry_point}: {error:#}");
            }
        }
    }
    ensure!(refused == 0, "{refused} modules refused; shaders/ is unchanged");
    if let (Some(only), true) = (only, accepted.is_empty()) {
        let known: Vec<_> = compiled.modules.keys().map(String::as_str).collect();
        bail!("no entry point is named {only}; there are {}", known.join(", "));
    }
    Ok(accepted)
}

fn report(entry: &Entry, wgsl_bytes: usize, changed: bool) {
    let [x, y, z] = entry.workgroup_size;
    println!(
        "{:<32} {:<8} {:>3} x {:>2} x {:>2} {:>8} B spv {:>8} B wgsl  {}",
        entry.name,
        entry.stage,
        x,
        y,
        z,
        entry.bytes,
        wgsl_bytes,
        if changed { "written" } else { "unchanged" }
    );
}

/// `old` with some entries replaced. Its source digest stays, because the other modules were not renewed.
fn merged(old: Option<Manifest>, new: Vec<Entry>) -> Manifest {
    let mut manifest = old.unwrap_or_else(|| Manifest::new(String::new(), Vec::new(), Vec::new()));
    manifest.entries.retain(|entry| new.iter().all(|other| other.name != entry.name));
    manifest.entries.extend(new);
    manifest.entries = sorted(manifest.entries);
    manifest
}

fn sorted(mut entries: Vec<Entry>) -> Vec<Entry> {
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    entries
}

/// What lies in `shaders` although `manifest` does not name it.
///
/// # Errors
/// The folder cannot be read.
pub fn strays(shaders: &Path, manifest: &Manifest) -> Result<Vec<PathBuf>> {
    let mut strays = Vec::new();
    for item in fs::read_dir(shaders).with_context(|| format!("cannot read {}", shaders.display()))? {
        let item = item?;
        let name = item.file_name();
        let known = name == manifest::FILE
            || name == ".gitattributes"
            || manifest.entries.iter().any(|entry| name == *entry.file || name == *entry.wgsl_file);
        if !known {
            strays.push(item.path());
        }
    }
    strays.sort();
    Ok(strays)
}
