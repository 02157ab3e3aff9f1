//! `cargo xtask papers`: the tables of the works that this project unites, ours beside theirs.

use std::ffi::OsString;

use anyhow::{Result, ensure};

use crate::{bench_rays, documents, leak_tracing, workspace};

/// Whose tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Paper {
    /// Aila and Laine 2004: Table 1, close-ups, the hair ball, samples per pixel, Figures 3 and 4; then light BVH and divide and
    /// conquer beside Embree (`cargo xtask bench-rays`)
    AliasFree,
    /// Kern, Brüll and Grosch 2024: Tables 2 and 3, Figures 8 and 10, the scale test
    LeakTracing,
}

impl Paper {
    /// Name of its page under docs/results, without ending; also of what measuring writes.
    fn page(self) -> &'static str {
        match self {
            Paper::AliasFree => "alias-free",
            Paper::LeakTracing => "leak-tracing",
        }
    }

    /// Pictures of the page.
    fn pictures(self) -> &'static [&'static str] {
        match self {
            Paper::AliasFree => &["alias-free.svg", "alias-free-zoom.png", "alias-free-tree.png"],
            Paper::LeakTracing => &["leak-tracing.svg"],
        }
    }
}

/// Options of the command; those that it does not know itself go to the measuring program.
#[derive(clap::Args)]
pub struct Args {
    /// Which paper
    paper: Paper,
    /// Measure little, for a look in about a minute
    #[arg(long, conflicts_with = "docs")]
    quick: bool,
    /// Also put tables and plot into docs/results, which should hold a full run on a quiet machine
    #[arg(long)]
    docs: bool,
    /// alias-free: leave out the tables beside Embree's, which take minutes
    #[arg(long)]
    no_peers: bool,
    /// Options of the measuring program (alias-free: see `-- --help`)
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "OPTIONS")]
    rest: Vec<OsString>,
}

/// The generated part of a page lies between these lines.
const MARKS: [&str; 2] = ["<!-- cargo xtask papers: begin -->", "<!-- cargo xtask papers: end -->"];

/// Runs the command.
///
/// # Errors
/// The measuring program cannot be built, fails, or finds wrong answers; or a result cannot be written.
pub fn run(args: &Args) -> Result<()> {
    let out = workspace::root().join("lt-out/papers");
    match args.paper {
        Paper::AliasFree => {
            let mut command = workspace::cargo();
            command.args([
                "bench",
                "--package",
                "lt-render",
                "--no-default-features",
                "--bench",
                "alias_free",
            ]);
            command.arg("--").arg("--out").arg(&out);
            if args.quick {
                command.args([
                    "--triangles",
                    "1000,10000",
                    "--close-ups",
                    "8",
                    "--hairs",
                    "50",
                    "--sampled",
                    "random:10000",
                    "--repeats",
                    "1",
                ]);
            }
            workspace::run(command.args(&args.rest))?;
            if !args.no_peers {
                bench_rays::run(&bench_rays::Args::for_papers(args.quick, args.docs))?;
            }
        }
        Paper::LeakTracing => {
            ensure!(args.rest.is_empty(), "papers leak-tracing has no options of its own: {:?}", args.rest);
            leak_tracing::run(args.quick, &out)?;
        }
    }
    let results = workspace::root().join("docs/results");
    let name = args.paper.page();
    let (text, pictures) = (format!("{name}.md"), args.paper.pictures());
    if args.docs {
        documents::renew(&results.join(&text), &out.join(&text), MARKS)?;
        for picture in pictures {
            documents::copy(&out.join(picture), &results.join(picture))?;
        }
        println!("renewed: {}, {}", results.join(&text).display(), pictures.join(", "));
    } else {
        println!("written: {}, {}", out.join(&text).display(), pictures.join(", "));
    }
    Ok(())
}
