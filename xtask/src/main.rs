//! Project chores as programs: CI runs the same commands that a developer runs.
//!
//! - `cargo xtask build-shaders` compiles `crates/lt-shaders` to SPIR-V and WGSL in `shaders/`; `--check`
//!   proves that what is committed there belongs to the sources.
//! - `cargo xtask bench-rays` measures occlusion rays and builds beside Intel Embree's and obvhs's.
//! - `cargo xtask papers alias-free` and `leak-tracing` measure the tables of a paper, ours beside its own.
//! - `cargo xtask no-std` builds the `no_std` crates for targets that have no standard library.
//! - `cargo xtask ci` is the gate: format, lints, documentation, `no-std`, shader freshness.
//!
//! Everything here runs on stable Rust; only compiling shaders asks for a nightly.

mod backend;
mod bench_rays;
mod build_shaders;
mod check_shaders;
mod ci;
mod compile;
mod documents;
mod files;
mod leak_tracing;
mod manifest;
mod module;
mod no_std;
mod papers;
mod prune;
mod sources;
mod strip;
mod workspace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Project chores", version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Compile crates/lt-shaders into shaders/ (needs a nightly, which it names if missing)
    BuildShaders(build_shaders::Args),
    /// Measure occlusion rays and builds beside Embree's (if libembree-dev is installed) and obvhs's
    BenchRays(bench_rays::Args),
    /// Measure the tables of a paper, ours beside its own
    Papers(papers::Args),
    /// Build the no_std crates for x86_64-unknown-none and thumbv7em-none-eabihf
    NoStd,
    /// Run every check that gates a change, except the tests
    Ci,
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::BuildShaders(args) => build_shaders::run(&args),
        Command::BenchRays(args) => bench_rays::run(&args),
        Command::Papers(args) => papers::run(&args),
        Command::NoStd => no_std::run(),
        Command::Ci => ci::run(),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
