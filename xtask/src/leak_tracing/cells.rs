//! Cells: runs of `lt compare` whose results are kept, so that work that was stopped goes on where it was.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use anyhow::{Context, Result, ensure};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Deserialize;

use crate::{files, workspace};

/// One run of `lt compare`.
pub struct Cell {
    /// Its arguments, scene first.
    pub args: Vec<String>,
}

impl Cell {
    /// From words parted by blanks.
    pub fn new(words: &str) -> Self {
        Self { args: words.split_whitespace().map(str::to_owned).collect() }
    }

    /// As one would type it.
    pub fn command(&self) -> String {
        format!("lt compare {}", self.args.join(" "))
    }
}

/// What `results.json` tells, as far as it is read here.
#[derive(Clone, Debug, Deserialize)]
pub struct Results {
    pub device: String,
    pub threads: u32,
    pub rows: Vec<Row>,
}

/// One technique.
#[derive(Clone, Debug, Deserialize)]
pub struct Row {
    pub technique: String,
    pub path: Over,
}

/// One technique over the frames.
#[derive(Clone, Debug, Deserialize)]
pub struct Over {
    pub map_draws: u32,
    pub frames_to_settle: Option<u32>,
    pub frames: Vec<Frame>,
}

/// One technique in one frame.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Frame {
    pub false_lit_ppm: f64,
    pub false_shadowed_ppm: f64,
    pub rays_per_pixel: f64,
    pub total_ms: f64,
}

impl Frame {
    /// Wrong on either side, ppm.
    pub fn wrong_ppm(&self) -> f64 {
        self.false_lit_ppm + self.false_shadowed_ppm
    }
}

impl Results {
    /// The row of a technique.
    ///
    /// # Errors
    /// There is none.
    pub fn row(&self, technique: &str) -> Result<&Row> {
        let found = self.rows.iter().find(|r| r.technique == technique);
        found.with_context(|| format!("lt gave no row for {technique}"))
    }
}

/// Runs cells and keeps what they found.
pub struct Keeper {
    program: PathBuf,
    /// Of the program: another one may find something else.
    digest: String,
    folder: PathBuf,
}

impl Keeper {
    /// Builds `lt`.
    ///
    /// # Errors
    /// It cannot be built, or the folder for results cannot be made.
    pub fn new() -> Result<Self> {
        workspace::run(workspace::cargo().args(["build", "--release", "--package", "lt-cli"]))?;
        let target = workspace::target_dir()?;
        let program = target.join(format!("release/lt{}", std::env::consts::EXE_SUFFIX));
        let bytes = fs::read(&program).with_context(|| format!("cannot read {}", program.display()))?;
        let folder = target.join("papers/leak-tracing");
        fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
        Ok(Self { program, digest: files::sha256(&bytes), folder })
    }

    /// Results of all cells, in order; those that an earlier run finished with the same program, machine and arguments are taken
    /// from there.
    ///
    /// # Errors
    /// A run that fails, with what it said, or a file that cannot be read or written.
    pub fn measure(&self, cells: &[Cell]) -> Result<Vec<Results>> {
        let bar = ProgressBar::new(cells.len() as u64);
        let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {wide_msg}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.enable_steady_tick(Duration::from_millis(500));
        let mut all = Vec::new();
        for cell in cells {
            bar.set_message(cell.args.join(" "));
            all.push(self.results(cell).with_context(|| format!("`{}`", cell.command()))?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(all)
    }

    fn results(&self, cell: &Cell) -> Result<Results> {
        let kept = self.folder.join(format!("{}.json", self.key(cell)));
        if !kept.exists() {
            self.run(cell, &kept)?;
        }
        let text = fs::read_to_string(&kept).with_context(|| format!("cannot read {}", kept.display()))?;
        serde_json::from_str(&text)
            .with_context(|| format!("{} is not what lt writes: delete it", kept.display()))
    }

    /// Names everything that determines a cell's results.
    fn key(&self, cell: &Cell) -> String {
        let threads = std::thread::available_parallelism().map_or(0, usize::from);
        let cpu = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = cpu.lines().find(|l| l.starts_with("model name")).unwrap_or_default().to_owned();
        files::sha256(format!("{}\n{model}\n{threads}\n{:?}", self.digest, cell.args).as_bytes())
    }

    fn run(&self, cell: &Cell, kept: &Path) -> Result<()> {
        let out = self.folder.join("running");
        let mut command = Command::new(&self.program);
        command.current_dir(workspace::root()).arg("compare").args(&cell.args).arg("--brief");
        command.arg("--out").arg(&out).stdout(Stdio::null()).stderr(Stdio::piped());
        let ran = command.output().context("cannot start lt")?;
        let said = String::from_utf8_lossy(&ran.stderr);
        ensure!(ran.status.success(), "{}: {}", ran.status, said.trim());
        let results = out.join("results.json");
        let bytes = fs::read(&results).with_context(|| format!("cannot read {}", results.display()))?;
        files::replace(kept, &bytes).map(drop)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_changes_with_program_and_arguments() {
        let keeper = |digest: &str| Keeper {
            program: PathBuf::new(),
            digest: digest.to_owned(),
            folder: PathBuf::new(),
        };
        let (a, b) = (Cell::new("street --frames 4"), Cell::new("street --frames 5"));
        assert_eq!(keeper("x").key(&a), keeper("x").key(&Cell::new("street  --frames 4")));
        assert_ne!(keeper("x").key(&a), keeper("x").key(&b));
        assert_ne!(keeper("x").key(&a), keeper("y").key(&a));
    }

    #[test]
    fn results_are_read_by_technique() {
        let frame = r#"{"false_lit_ppm":1.0,"false_shadowed_ppm":2.0,"rays_per_pixel":0.5,"total_ms":3.0}"#;
        let text = format!(
            r#"{{"device":"d","threads":2,"rows":[{{"technique":"ray","path":{{"map_draws":0,"frames_to_settle":null,
            "frames":[{frame}]}}}}]}}"#
        );
        let results: Results = serde_json::from_str(&text).unwrap();
        assert_eq!(results.row("ray").unwrap().path.frames[0].wrong_ppm(), 3.0);
        assert!(results.row("sm").is_err());
    }
}
