//! The rust-gpu compiler backend: checks its nightly, builds it once, keeps it in the user's cache.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use spirv_builder::cargo_cmd::CargoCmd;

use crate::{workspace, workspace::root};

/// The nightly that `rustc_codegen_spirv` [`VERSION`] is built against; no other works.
pub const TOOLCHAIN: &str = "nightly-2026-08-15";

/// The version of `rustc_codegen_spirv`, as pinned in `xtask/codegen-backend/Cargo.toml`.
pub const VERSION: &str = "0.11.0";

/// Set to 1, this lets `build-shaders --check` spend the 7 to 20 minutes of building the backend.
pub const BUILD_VARIABLE: &str = "LT_BUILD_BACKEND";

/// Checks that the nightly is installed together with the compiler's own libraries and sources.
///
/// # Errors
/// Something is missing; the message contains the command that installs it.
pub fn check_toolchain() -> Result<()> {
    let install = format!(
        "install it with\n  rustup toolchain install {TOOLCHAIN} --profile minimal -c rustc-dev -c rust-src -c llvm-tools"
    );
    // Without the two variables, rustup would obey the stable toolchain that runs this xtask, or start a
    // download that nobody asked for.
    let output = Command::new("rustc")
        .args([&format!("+{TOOLCHAIN}"), "--print=sysroot"])
        .env_remove("RUSTUP_TOOLCHAIN")
        .env("RUSTUP_AUTO_INSTALL", "0")
        .output()
        .with_context(|| format!("cannot start rustc; compiling shaders needs rustup and {TOOLCHAIN}"))?;
    ensure!(
        output.status.success(),
        "compiling shaders needs {TOOLCHAIN}, which is not installed; {install}"
    );
    let sysroot = PathBuf::from(String::from_utf8(output.stdout).context("sysroot is not UTF-8")?.trim());
    for (folder, component) in [("lib/rustlib/src", "rust-src"), ("lib/rustlib/rustc-src", "rustc-dev")] {
        ensure!(sysroot.join(folder).is_dir(), "{TOOLCHAIN} lacks the component {component}; {install}");
    }
    Ok(())
}

/// The backend in the cache, if it has been built.
///
/// # Errors
/// The user's cache folder is unknown.
pub fn cached() -> Result<Option<PathBuf>> {
    let library = cache_dir()?.join(library_name());
    Ok(library.is_file().then_some(library))
}

/// The backend, built now if the cache lacks it. [`check_toolchain`] must have passed.
///
/// # Errors
/// The cache cannot be written, or the build fails.
pub fn ensure_built() -> Result<PathBuf> {
    let cache = cache_dir()?;
    fs::create_dir_all(&cache).with_context(|| format!("cannot create {}", cache.display()))?;
    let lock = File::create(cache.join("lock")).context("cannot create the lock of the backend cache")?;
    lock.lock().context("cannot lock the backend cache")?;
    // Looked for under the lock: another process may just have built it.
    let library = cache.join(library_name());
    if !library.is_file() {
        build(&cache, &library)?;
    }
    Ok(library)
}

fn build(cache: &Path, library: &Path) -> Result<()> {
    println!("Building rustc_codegen_spirv {VERSION} into {}: once, 7 to 20 minutes.", cache.display());
    // A fixed folder, so that an interrupted build resumes where it stopped.
    let target = cache.join("target");
    let mut command = Command::from(CargoCmd::new());
    command.current_dir(root().join("xtask/codegen-backend"));
    command
        .arg(format!("+{TOOLCHAIN}"))
        .args(["build", "--release", "--locked", "--target-dir"])
        .arg(&target);
    workspace::run(&mut command)?;
    let built = target.join("release").join(library_name());
    fs::rename(&built, library)
        .with_context(|| format!("cannot move {} to {}", built.display(), library.display()))?;
    fs::remove_dir_all(&target).with_context(|| format!("cannot remove {}", target.display()))
}

fn library_name() -> String {
    format!("{}rustc_codegen_spirv{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// The folder of this backend version for this nightly, below the user's cache folder.
fn cache_dir() -> Result<PathBuf> {
    let variable = |name| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let base = if let Some(dir) = variable("XDG_CACHE_HOME") {
        dir
    } else if let Some(dir) = variable("LOCALAPPDATA") {
        dir
    } else if let Some(home) = variable("HOME") {
        home.join(".cache")
    } else {
        bail!("no cache folder for the shader compiler: set XDG_CACHE_HOME or HOME");
    };
    Ok(base.join("leak-tracing").join(format!("rustc_codegen_spirv-{VERSION}-{TOOLCHAIN}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pinned_package_has_the_version_named_here() {
        let manifest = fs::read_to_string(root().join("xtask/codegen-backend/Cargo.toml")).unwrap();
        assert!(manifest.contains(&format!("rustc_codegen_spirv = \"={VERSION}\"")));
    }
}
