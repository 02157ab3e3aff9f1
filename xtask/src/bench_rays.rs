//! `cargo xtask bench-rays`: our occlusion rays and builds beside Intel Embree's and obvhs's, in one process.
//!
//! The measuring program is the bench `rays` of lt-render. It loads Embree through a small library of our own,
//! `xtask/embree/embree.cpp`, which is compiled here if the system has Embree 3; without it the program measures the
//! rest. Nothing but this command compiles or needs either.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::{documents, workspace};

/// Options of the command; those that it does not know itself go to the measuring program.
#[derive(clap::Args)]
pub struct Args {
    /// Folder for rays.csv, rays.md, rays.svg and crossover.svg
    #[arg(long, value_name = "FOLDER", default_value = FOLDER)]
    out: PathBuf,
    /// Also put table and plot into docs/results, which should hold a full run on a quiet machine
    #[arg(long)]
    docs: bool,
    /// Options of the measuring program, such as `--scenes street,forest --repeats 5 --quick` (see `-- --help`)
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "OPTIONS")]
    rest: Vec<OsString>,
}

impl Args {
    /// The whole measurement, or a look in seconds.
    pub fn for_papers(quick: bool, docs: bool) -> Self {
        let rest = match quick {
            true => &["--quick", "--no-build", "--scenes", "random:1000,random:10000"][..],
            false => &[],
        };
        Args { out: FOLDER.into(), docs, rest: rest.iter().map(OsString::from).collect() }
    }
}

/// Where results go.
const FOLDER: &str = "lt-out/rays";

/// The measuring program takes the library's path from here.
const LIBRARY_VARIABLE: &str = "LT_EMBREE_LIBRARY";

/// How to get Embree.
const INSTALL: &str = "apt-get install libembree-dev";

/// The generated part of docs/results/rays.md lies between these lines.
const MARKS: [&str; 2] = ["<!-- cargo xtask bench-rays: begin -->", "<!-- cargo xtask bench-rays: end -->"];

/// Runs the command.
///
/// # Errors
/// The measuring program cannot be built, fails, or finds wrong answers; or a result cannot be written.
pub fn run(args: &Args) -> Result<()> {
    let out = workspace::root().join(&args.out);
    let mut command = workspace::cargo();
    command.args([
        "bench",
        "--package",
        "lt-render",
        "--no-default-features",
        "--bench",
        "rays",
        "--",
        "--out",
    ]);
    command.arg(&out).args(&args.rest).env_remove(LIBRARY_VARIABLE);
    match compile()? {
        Some(library) => {
            command.env(LIBRARY_VARIABLE, library);
        }
        None => println!("Embree's columns are left out; to get them: {INSTALL}"),
    }
    workspace::run(&mut command)?;
    if args.docs {
        publish(&out, &workspace::root().join("docs/results"))?;
    }
    Ok(())
}

/// The C++ side as a shared library, or `None` (and a word why) without a C++ compiler or without Embree 3.
///
/// # Errors
/// The system has both, yet our source does not compile.
fn compile() -> Result<Option<PathBuf>> {
    let folder = workspace::target_dir()?.join("embree");
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let compiler = std::env::var_os("CXX").filter(|c| !c.is_empty()).unwrap_or_else(|| "c++".into());
    // Asked apart from our source, so that a mistake in that is not taken for a missing library.
    let probe = folder.join("probe.cpp");
    fs::write(
        &probe,
        "#include <embree3/rtcore.h>\nint main() { rtcReleaseDevice(rtcNewDevice(nullptr)); }\n",
    )
    .context("cannot write the probe for Embree")?;
    let mut attempt = Command::new(&compiler);
    attempt.arg(&probe).arg("-o").arg(folder.join("probe")).arg("-lembree3");
    match attempt.output() {
        Err(error) => {
            println!("no C++ compiler: {}: {error}", compiler.to_string_lossy());
            return Ok(None);
        }
        Ok(output) if !output.status.success() => {
            let text = String::from_utf8_lossy(&output.stderr);
            let reason = text.lines().find(|line| line.contains("error")).unwrap_or("it does not compile");
            println!("no Embree 3: {reason}");
            return Ok(None);
        }
        Ok(_) => {}
    }
    let library =
        folder.join(format!("{}lt_embree{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX));
    let mut command = Command::new(&compiler);
    command.args(["-std=c++17", "-O3", "-march=native", "-Wall", "-Wextra", "-shared", "-fPIC"]);
    // The alpha test must round as ours does.
    command.arg("-ffp-contract=off");
    command.arg(workspace::root().join("xtask/embree/embree.cpp"));
    command.arg("-o").arg(&library).arg("-lembree3");
    workspace::run(&mut command)?;
    Ok(Some(library))
}

/// Puts table and plot into docs/results.
fn publish(out: &Path, results: &Path) -> Result<()> {
    documents::renew(&results.join("rays.md"), &out.join("rays.md"), MARKS)?;
    for name in ["rays.svg", "crossover.svg", "rays.csv"] {
        documents::copy(&out.join(name), &results.join(name))?;
    }
    println!("renewed: {}, rays.svg, crossover.svg, rays.csv", results.join("rays.md").display());
    Ok(())
}
