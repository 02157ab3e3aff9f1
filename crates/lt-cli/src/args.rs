//! The command line's grammar.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, value_parser};
use lt_render::{MapSource, Technique, Upkeep};

use crate::{
    frame_args::FrameArgs,
    scene_args::SceneArgs,
    values::{self, TypedTechnique},
};

/// Shadows as right as ray tracing for a fraction of its time: compares techniques and shows where they err
#[derive(Parser, Debug)]
#[command(name = "lt", version, about, arg_required_else_help = true)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// Subcommands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Run techniques side by side: a table, report.html, results.json and images
    Compare(CompareArgs),
    /// Draw one shaded picture by one technique
    Render(RenderArgs),
    /// Print which effects a scene and a technique call for, and why
    Plan(PlanArgs),
    /// List the built-in scenes
    Scenes,
    /// Print what this machine offers: threads, CPU features, GPU adapters, shader modules
    Doctor,
}

impl Command {
    /// How many threads are asked for, if anyone asks.
    pub fn threads(&self) -> Option<u16> {
        match self {
            Command::Compare(CompareArgs { scene, .. })
            | Command::Render(RenderArgs { scene, .. })
            | Command::Plan(PlanArgs { scene, .. }) => scene.threads,
            Command::Scenes | Command::Doctor => None,
        }
    }
}

/// `lt compare`.
#[derive(Args, Debug)]
pub struct CompareArgs {
    /// Scene, view, light and machine.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Technique ids, separated by commas [default: ray, every map, every leak tracing hybrid]
    #[arg(long, value_name = "ID,…", value_delimiter = ',', value_parser = values::technique, help_heading = "Techniques")]
    pub techniques: Vec<TypedTechnique>,
    /// Every technique that has a map, the pre-filtered variants too, and full ray tracing
    #[arg(long, conflicts_with_all = ["techniques", "all_hybrids"], help_heading = "Techniques")]
    pub all: bool,
    /// Full ray tracing and every leak tracing hybrid, the pre-filtered variants too
    #[arg(long, conflicts_with = "techniques", help_heading = "Techniques")]
    pub all_hybrids: bool,
    /// Print every technique id with a line about it, and stop
    #[arg(long, help_heading = "Techniques")]
    pub list: bool,
    /// Timed repeats of every technique, after one to warm up [default: 5]
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=1000), conflicts_with = "frames")]
    pub repeats: Option<u16>,
    /// Frames and what moves in them.
    #[command(flatten)]
    pub play: FrameArgs,
    /// How fast the camera moves: median motion per frame, in pixels of a picture 1920 wide [default: 2]
    #[arg(long, value_name = "PX", requires = "frames", conflicts_with = "still", value_parser = values::motion, help_heading = "Frames")]
    pub motion: Option<f32>,
    /// Take the camera along the keyframes of this text file instead of the scene's own way: lines of seconds, eye x y z, target
    /// x y z and degrees of field of view if wanted; 60 frames per second
    #[arg(long, value_name = "FILE", requires = "frames", conflicts_with_all = ["still", "motion"], help_heading = "Frames")]
    pub path: Option<PathBuf>,
    /// Start techniques with a temporal mask from a cleared one instead of tracing their first frame whole: a diagnostic, which
    /// shows with --still how many frames they take to converge
    #[arg(long, requires = "frames", help_heading = "Frames")]
    pub cold: bool,
    /// Count in every frame what it takes to have all that a technique traces with up to date while everything moves: trees built
    /// anew, or given new boxes where they can be (CPU only)
    #[arg(long, value_name = "HOW", num_args = 0..=1, default_missing_value = "build", require_equals = true)]
    pub rebuild: Option<Rebuild>,
    /// Folder to write into, created if need be
    #[arg(long, value_name = "DIR", default_value = "lt-out")]
    pub out: PathBuf,
    /// Write results.json alone: no images, no report
    #[arg(long)]
    pub brief: bool,
    /// Leave out the perceptual metric FLIP, which takes a second or so per picture
    #[arg(long)]
    pub no_flip: bool,
}

/// How `--rebuild` rebuilds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Rebuild {
    /// Trees are built anew
    Build,
    /// The BVH gets new boxes, a tree in light space is built anew
    Refit,
}

impl CompareArgs {
    /// What every frame does to trees.
    pub fn upkeep(&self) -> Upkeep {
        match self.rebuild {
            None => Upkeep::Kept,
            Some(Rebuild::Build) => Upkeep::Build,
            Some(Rebuild::Refit) => Upkeep::Refit,
        }
    }

    /// The techniques to run, each once, in the order asked for.
    pub fn techniques(&self) -> Vec<Technique> {
        let typed = match (self.all, self.all_hybrids, self.techniques.is_empty()) {
            (true, ..) => everything().map(TypedTechnique::from).collect(),
            (_, true, _) => everything().filter(is_ray_or_hybrid).map(TypedTechnique::from).collect(),
            (.., true) => catalogue().map(TypedTechnique::from).collect(),
            (.., false) => self.techniques.clone(),
        };
        let mut unique = Vec::new();
        for technique in typed.into_iter().map(|t| t.with(self.scene.technique_defaults())) {
            if !unique.contains(&technique) {
                unique.push(technique);
            }
        }
        unique
    }
}

fn catalogue() -> impl Iterator<Item = Technique> {
    Technique::catalogue().into_iter().map(|(technique, _)| technique)
}

fn everything() -> impl Iterator<Item = Technique> {
    catalogue().chain(catalogue().filter_map(|t| prefiltered(&t)))
}

fn prefiltered(technique: &Technique) -> Option<Technique> {
    let (test, _) = technique.map_test().filter(|(test, _)| test.is_filterable())?;
    let estimate = lt_render::Estimate::Map { test, source: MapSource::Prefiltered };
    Some(Technique { estimate, ..*technique })
}

fn is_ray_or_hybrid(technique: &Technique) -> bool {
    technique.resolve.is_exact()
}

/// `lt render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// Scene, view, light and machine.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Technique id (see `lt compare --list`)
    #[arg(long, value_name = "ID", default_value = "ltt-evsm", value_parser = values::technique, help_heading = "Techniques")]
    pub technique: TypedTechnique,
    /// Picture to write, a .png
    #[arg(long, value_name = "FILE", default_value = "shadow.png", value_parser = png_path)]
    pub out: PathBuf,
    /// Also write frame.exr (positions, normals, visibility, reference, doubt; of several layers the first, sample by sample) and
    /// camera.json into this folder
    #[arg(long, value_name = "DIR")]
    pub dump: Option<PathBuf>,
}

fn png_path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_png = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if is_png { Ok(path) } else { Err("pictures are PNG files: end the name in .png".into()) }
}

/// `lt plan`.
#[derive(Args, Debug)]
pub struct PlanArgs {
    /// Scene, view, light and machine.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Frames and what moves in them.
    #[command(flatten)]
    pub play: FrameArgs,
    /// Technique id (see `lt compare --list`)
    #[arg(long, value_name = "ID", default_value = "ltt-evsm", value_parser = values::technique, help_heading = "Techniques")]
    pub technique: TypedTechnique,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    fn compare(words: &[&str]) -> CompareArgs {
        match Cli::try_parse_from(["lt", "compare"].iter().chain(words)).unwrap().command {
            Command::Compare(args) => args,
            other => panic!("{other:?}"),
        }
    }

    fn ids(words: &[&str]) -> Vec<String> {
        compare(words).techniques().iter().map(Technique::to_string).collect()
    }

    #[test]
    fn the_grammar_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn the_default_techniques_are_the_gathering_ones() {
        let expected = "ray sm pcf vsm esm evsm msm msm-hausdorff ltt-vsm ltt-esm ltt-evsm ltt-msm ltt-msm-hausdorff \
             lt-vsm lt-esm lt-evsm lt-msm lt-msm-hausdorff";
        assert_eq!(ids(&[]), expected.split(' ').collect::<Vec<_>>());
    }

    #[test]
    fn all_adds_the_prefiltered_ones() {
        let all = ids(&["--all"]);
        assert_eq!(all.len(), 33);
        assert!(all.contains(&"vsm:prefiltered".into()) && all.contains(&"ltt-msm:prefiltered".into()));
        assert!(!all.contains(&"sm:prefiltered".into()));
        let hybrids = ids(&["--all-hybrids"]);
        assert_eq!(hybrids.len(), 21);
        assert!(hybrids.iter().all(|id| id == "ray" || id.starts_with("ltt-") || id.starts_with("lt-")));
    }

    #[test]
    fn rebuilding_is_building_unless_told_otherwise() {
        assert_eq!(compare(&[]).upkeep(), Upkeep::Kept);
        assert_eq!(compare(&["--rebuild"]).upkeep(), Upkeep::Build);
        assert_eq!(compare(&["--rebuild=refit", "street"]).upkeep(), Upkeep::Refit);
    }

    #[test]
    fn each_technique_runs_once() {
        assert_eq!(ids(&["--techniques", "sm,ray,sm"]), ["sm", "ray"]);
    }

    #[test]
    fn epsilon_reaches_the_hybrids() {
        assert_eq!(
            ids(&["--epsilon", "0.05", "--techniques", "vsm,ltt-vsm,ltt-vsm:eps=0.2"]),
            ["vsm", "ltt-vsm:eps=0.05", "ltt-vsm:eps=0.2"]
        );
    }

    #[test]
    fn bad_usage_is_refused() {
        for words in [
            &["compare", "--techniques", "foo"][..],
            &["compare", "--techniques", ""],
            &["compare", "--all", "--all-hybrids"],
            &["compare", "--repeats", "0"],
            &["compare", "--frames", "1"],
            &["compare", "--still"],
            &["compare", "--frames", "8", "--repeats", "2"],
            &["compare", "--frames", "8", "--still", "--motion", "3"],
            &["compare", "--frames", "8", "--still", "--light-spin", "3"],
            &["compare", "--frames", "8", "--motion", "3", "--path", "walk.txt"],
            &["compare", "--cold"],
            &["plan", "--still"],
            &["plan", "--light-spin", "2"],
            &["compare", "--frames", "8", "--motion", "0"],
            &["render", "street", "--out", "shadow.jpg"],
            &["frobnicate"],
            &[],
        ] {
            assert!(Cli::try_parse_from(["lt"].iter().chain(words)).is_err(), "{words:?}");
        }
    }
}
