//! `cargo xtask no-std`: builds the `no_std` crates where no standard library exists.

use std::process::Command;

use anyhow::{Context, Result};

use crate::workspace::{cargo, run as run_command};

/// A bare x86-64 machine, and a microcontroller with 32-bit floats only.
const TARGETS: [&str; 2] = ["x86_64-unknown-none", "thumbv7em-none-eabihf"];

/// The crates that promise to do without `std`.
const CRATES: [&str; 5] = ["lt-math", "lt-mask", "lt-bvh", "lt-irregular", "lt-shaders"];

/// Builds every crate by itself for every target, so that no crate leans on a feature another one enabled.
///
/// # Errors
/// A target cannot be installed, or a crate needs `std` after all.
pub fn run() -> Result<()> {
    for target in TARGETS {
        install(target)?;
        for name in CRATES {
            let mut command = cargo();
            // `rustc --crate-type`: bare targets have no dylib, which lt-shaders also is for rust-gpu.
            command.args(["rustc", "--package", name, "--lib", "--crate-type", "rlib"]);
            command.args(["--no-default-features", "--features", "libm", "--target", target]);
            run_command(&mut command)?;
        }
    }
    Ok(())
}

/// Adds `target` to the toolchain that runs this xtask, if rustc does not find its libraries.
fn install(target: &str) -> Result<()> {
    let output = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--print=target-libdir", "--target", target])
        .output()
        .context("cannot start rustc")?;
    let folder = String::from_utf8_lossy(&output.stdout);
    if std::path::Path::new(folder.trim()).is_dir() {
        return Ok(());
    }
    run_command(Command::new("rustup").args(["target", "add", target]))
        .with_context(|| format!("the target {target} is missing; without rustup, install its core library"))
}
