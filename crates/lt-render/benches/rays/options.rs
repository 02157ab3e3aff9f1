//! What to measure, from the command line.

use std::path::PathBuf;

use clap::Parser;
use lt_math::glam::UVec2;

/// Occlusion rays and builds: ours, Embree's (if LT_EMBREE_LIBRARY names its library), obvhs's
#[derive(Clone, Debug, Parser)]
#[command(name = "rays")]
pub struct Options {
    /// Scenes, separated by commas
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "street,town,square,forest,random:1000,random:10000,random:100000,random:1000000"
    )]
    pub scenes: Vec<String>,
    /// Measured rounds, after one to warm up
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(1..=99))]
    pub repeats: u32,
    /// 640×360 and three rounds: minutes become seconds, and noise grows
    #[arg(long)]
    pub quick: bool,
    /// Give Embree its robust (watertight, slower) traversal
    #[arg(long)]
    pub robust: bool,
    /// Scene whose build is timed
    #[arg(long, value_name = "SCENE", default_value = "random:1000000")]
    build: String,
    /// Time no build
    #[arg(long)]
    no_build: bool,
    /// Folder for rays.csv, rays.md, rays.svg and crossover.svg
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Turn over one answer in a thousand of the last peer's: fails unless nine in ten are judged wrong by more than rounding
    #[arg(long)]
    pub self_test: bool,
    /// What `cargo bench` passes to every bench
    #[arg(long = "bench", hide = true)]
    _bench: bool,
}

impl Options {
    /// The arguments of this process; ends it on bad ones.
    pub fn from_command_line() -> Self {
        let mut options = Self::parse();
        if options.quick {
            options.repeats = options.repeats.min(3);
        }
        options
    }

    /// Size of the picture whose pixels send the rays.
    pub fn size(&self) -> UVec2 {
        if self.quick { UVec2::new(640, 360) } else { UVec2::new(1920, 1080) }
    }

    /// The scene whose build is timed.
    pub fn build(&self) -> Option<&str> {
        (!self.no_build).then_some(self.build.as_str())
    }
}
