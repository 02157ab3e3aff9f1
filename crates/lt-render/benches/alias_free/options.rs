//! What to measure, from the command line.

use std::path::PathBuf;

/// Alias-free shadow maps: the paper's tables
#[derive(Clone, Debug, clap::Parser)]
#[command(name = "alias-free")]
pub struct Options {
    /// Numbers of random triangles, separated by commas
    #[arg(long, value_delimiter = ',', default_value = "1000,10000,100000,1000000")]
    pub triangles: Vec<u32>,
    /// Fields of view of the close-ups of 100,000 random triangles, degrees, separated by commas
    #[arg(long, value_delimiter = ',', default_value = "20,8")]
    pub close_ups: Vec<f32>,
    /// Numbers of hairs of the hair balls, 576 triangles each; 0 for none
    #[arg(long, value_delimiter = ',', default_value = "500,5000")]
    pub hairs: Vec<u32>,
    /// Scenes seen with 1 to 32 samples per pixel, separated by commas; none for none
    #[arg(long, value_delimiter = ',', default_value = "street,square,random:100000,random:1000000")]
    pub sampled: Vec<String>,
    /// Timed repeats
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=99))]
    pub repeats: u32,
    /// Folder for alias-free.md, alias-free.svg, and the figures alias-free-zoom.png and alias-free-tree.png
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// What `cargo bench` passes to every bench
    #[arg(long, hide = true)]
    bench: bool,
}
