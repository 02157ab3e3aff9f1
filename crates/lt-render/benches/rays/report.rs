//! The outcome as text, CSV and Markdown.

use std::fmt;
use std::fmt::Write as _;

use super::builds::Builds;
use super::crossover;
use super::embree::{BUILD_THREADS, Embree};
use super::judge::Differences;
use super::measure::{Column, Family, Measured};
use super::options::Options;
use super::ours::{BY_TEXTURE, MeanCounts};
use super::places::Place;
use super::rebuilt::Rebuilt;
use super::today::today;

/// Which rays of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// Those of every light-facing pixel.
    Primary,
    /// The 5 % nearest to a shadow edge.
    Residual,
}

impl fmt::Display for List {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            List::Primary => "all",
            List::Residual => "residual",
        })
    }
}

/// One list of one scene.
#[derive(Clone, Debug)]
pub struct Row {
    pub scene: String,
    pub triangles: usize,
    pub has_holes: bool,
    pub list: List,
    pub rays: usize,
    pub blocked: usize,
    pub counts: MeanCounts,
    pub columns: Vec<Column>,
    pub differences: Differences,
}

impl Row {
    /// What was measured on a list.
    pub fn new(
        place: &Place,
        list: List,
        rays: usize,
        counts: MeanCounts,
        measured: &Measured,
        differences: Differences,
    ) -> Self {
        Row {
            scene: place.name.clone(),
            triangles: place.packed.triangles().len(),
            has_holes: place.has_holes(),
            list,
            rays,
            blocked: measured.answers[0].iter().filter(|b| **b).count(),
            counts,
            columns: measured.columns.clone(),
            differences,
        }
    }

    /// The fastest column of a family.
    pub fn best(&self, family: Family, rate: fn(&Column) -> f64) -> Option<f64> {
        let rates = self.columns.iter().filter(|c| c.family == family).map(rate);
        rates.reduce(f64::max)
    }

    /// The rate of one column.
    pub fn rate(&self, name: &str, rate: fn(&Column) -> f64) -> Option<f64> {
        self.columns.iter().find(|c| c.name == name).map(rate)
    }
}

/// One thread's median.
pub fn one(column: &Column) -> f64 {
    column.one.median
}

/// Two threads' median.
pub fn two(column: &Column) -> f64 {
    column.two.median
}

/// Everything measured.
pub struct Report {
    conditions: Vec<String>,
    pub rows: Vec<Row>,
    pub build: Option<Builds>,
    /// Frames with everything built anew.
    pub rebuilt: Vec<Rebuilt>,
}

impl Report {
    /// An empty report on this machine.
    pub fn new(options: &Options, embree: Option<&Embree>) -> Self {
        let size = options.size();
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let mut conditions = vec![
            format!("{}, {threads} hardware threads", today()),
            format!(
                "{}×{}, shadow rays of the hit pixels that face the sun, 8×8 tiles in Morton order; Mrays/s; one thread \
                 by its CPU time, two by wall time; medians of {} interleaved rounds after one to warm up",
                size.x, size.y, options.repeats
            ),
            "residual: the 5 % of these rays whose pixels lie nearest to a shadow edge, as a list".to_owned(),
        ];
        conditions.push(match embree {
            Some(embree) => format!(
                "{}; default build quality, {}; streams of 4096; denormals flushed; built on {BUILD_THREADS} threads",
                embree.description,
                if options.robust { "robust traversal" } else { "not robust" }
            ),
            None => "Embree: not measured (`apt-get install libembree-dev`, then `cargo xtask bench-rays`)".to_owned(),
        });
        conditions.push("obvhs: its slowest build, the better of CWBVH and BVH2".to_owned());
        Report { conditions, rows: Vec::new(), build: None, rebuilt: Vec::new() }
    }

    /// Tells the report what it runs on, as a session names it.
    pub fn on_machine(&mut self, name: &str) {
        if self.rows.is_empty() {
            self.conditions.insert(1, format!("{name}, instructions of our tracer in brackets"));
        }
    }

    /// The conditions, one to a line.
    pub fn preamble(&self) -> String {
        self.conditions.join("\n")
    }

    /// Whether we are wrong somewhere, beyond rounding.
    pub fn has_unexplained(&self) -> bool {
        self.rows.iter().any(|row| row.differences.ours_wrong > 0)
    }

    /// One list as text.
    pub fn text_row(&self, row: &Row) -> String {
        let mut text = format!(
            "\n{} · {} triangles{} · {} rays ({}), {:.1} % blocked · shared kernel: {:.1} nodes, {:.1} triangles a ray\n",
            row.scene,
            row.triangles,
            if row.has_holes { ", alpha-tested" } else { "" },
            row.rays,
            row.list,
            100.0 * row.blocked as f64 / row.rays as f64,
            row.counts.nodes,
            row.counts.triangles
        );
        let _ = writeln!(
            text,
            "  {:<30} {:>8} {:>17}  {:>8}  {:>8}",
            "", "1 thread", "least – most", "2 thr.", "differ"
        );
        for (column, differ) in row.columns.iter().zip(&row.differences.per_way) {
            let range = format!("{:.2} – {:.2}", column.one.least, column.one.most);
            let _ = writeln!(
                text,
                "  {:<30} {:>8.2} {range:>17}  {:>8.2}  {differ:>8}",
                column.name, column.one.median, column.two.median
            );
        }
        for (label, rate) in [("1 thread", one as fn(&Column) -> f64), ("2 threads", two)] {
            let [auto, single, by_texture] = ratios(row, rate);
            if let (Some(auto), Some(single)) = (auto, single) {
                let _ = writeln!(
                    text,
                    "  {label}: ours {auto:.2}× Embree's best{}; single {single:.2}× Embree's single",
                    by_texture.map_or_else(String::new, |t| format!(" ({t:.2}× without opacity maps)"))
                );
            }
        }
        text + "  " + &explained(&row.differences)
    }

    /// Builds and ratios as text.
    pub fn text_after(&self) -> String {
        let mut text = String::new();
        if let Some(builds) = &self.build {
            let _ = writeln!(text, "\nbuild {} ({} triangles), two threads", builds.scene, builds.triangles);
            for b in &builds.builds {
                let (least, most) = b.range_ms;
                let _ = writeln!(
                    text,
                    "  {:<30} {:>8.0} ms wall ({least:.0} – {most:.0}), {:.0} ms CPU",
                    b.name, b.wall_ms, b.cpu_ms
                );
            }
        }
        if !self.rebuilt.is_empty() {
            text.push_str(
                "\neverything built anew, ms: Embree's fastest build + best mode, divide and conquer\n",
            );
        }
        for r in &self.rebuilt {
            let _ = writeln!(
                text,
                "  {:<16} {} thread{}  {:>7.1} + {:>6.1} ({}), {:>7.1}: {:.2}×",
                r.scene,
                r.threads,
                if r.threads == 1 { " " } else { "s" },
                r.embree_build,
                r.embree_rays,
                r.mode,
                r.ours,
                r.ratio()
            );
        }
        text.trim_end().to_owned()
    }

    /// Every number, one to a line.
    pub fn csv(&self) -> String {
        let mut text =
            String::from("scene,triangles,list,rays,blocked,way,threads,unit,median,least,most,differ\n");
        for row in &self.rows {
            for (column, differ) in row.columns.iter().zip(&row.differences.per_way) {
                for (threads, rate) in [(1, column.one), (2, column.two)] {
                    let _ = writeln!(
                        text,
                        "{},{},{},{},{},\"{}\",{threads},Mrays/s,{:.4},{:.4},{:.4},{differ}",
                        row.scene,
                        row.triangles,
                        row.list,
                        row.rays,
                        row.blocked,
                        column.name,
                        rate.median,
                        rate.least,
                        rate.most
                    );
                }
            }
        }
        for (scene, triangles, b) in
            self.build.iter().flat_map(|b| b.builds.iter().map(|build| (&b.scene, b.triangles, build)))
        {
            let (least, most) = b.range_ms;
            let _ = writeln!(
                text,
                "{scene},{triangles},build,,,\"{}\",2,ms,{:.1},{least:.1},{most:.1},",
                b.name, b.wall_ms
            );
        }
        for r in &self.rebuilt {
            let ways = [
                ("Embree, fastest build", r.embree_build),
                ("Embree, rays", r.embree_rays),
                ("ours, divide and conquer", r.ours),
            ];
            for (way, ms) in ways {
                let _ = writeln!(
                    text,
                    "{},{},rebuilt,,,\"{way}\",{},ms,{ms:.2},,,",
                    r.scene, r.triangles, r.threads
                );
            }
        }
        text
    }

    /// The tables of docs/results/rays.md.
    pub fn markdown(&self) -> String {
        let mut text = String::new();
        for condition in &self.conditions {
            let _ = writeln!(text, "- {condition}");
        }
        for (list, title) in [(List::Primary, "All rays"), (List::Residual, "Residual rays")] {
            let rows: Vec<&Row> = self.rows.iter().filter(|row| row.list == list).collect();
            for (threads, rate) in [("one thread", one as fn(&Column) -> f64), ("two threads", two)] {
                if let Some(first) = rows.first() {
                    let _ = writeln!(text, "\n### {title}, {threads}\n");
                    table(&mut text, first, &rows, rate);
                }
            }
        }
        if let Some(builds) = &self.build {
            let _ = writeln!(
                text,
                "\n### Build of {} ({} triangles), two threads\n",
                builds.scene, builds.triangles
            );
            text.push_str("| | wall ms | least – most | CPU ms |\n|---|---:|---:|---:|\n");
            for b in &builds.builds {
                let (least, most) = b.range_ms;
                let _ = writeln!(
                    text,
                    "| {} | {:.0} | {least:.0} – {most:.0} | {:.0} |",
                    b.name, b.wall_ms, b.cpu_ms
                );
            }
        }
        if !self.rebuilt.is_empty() {
            text.push_str("\n### Everything built anew\n\nTriangles in the order of the scene's meshes, textures without opacity maps; making triangles of posed meshes is in neither time.\n\n| | threads | Embree's fastest build, ms | its best mode, ms | divide and conquer, ms | ratio |\n|---|---:|---:|---:|---:|---:|\n");
        }
        for r in &self.rebuilt {
            let _ = writeln!(
                text,
                "| {} | {} | {:.1} | {:.1} ({}) | {:.1} | {:.2} |",
                r.scene,
                r.threads,
                r.embree_build,
                r.embree_rays,
                r.mode,
                r.ours,
                r.ratio()
            );
        }
        if let Some(words) = crossover::words(&self.rows, &self.rebuilt) {
            let _ = writeln!(text, "\n{words}");
        }
        text.push_str("\n### Answers\n\n");
        for row in &self.rows {
            let _ = writeln!(
                text,
                "- {}, {}, {} rays ({:.1} % blocked): {}",
                row.scene,
                row.list,
                row.rays,
                100.0 * row.blocked as f64 / row.rays as f64,
                explained(&row.differences)
            );
        }
        text
    }
}

/// Ours against Embree's best, our single rays against its, ours without opacity maps against Embree's best.
fn ratios(row: &Row, rate: fn(&Column) -> f64) -> [Option<f64>; 3] {
    let ratio = |ours: Option<f64>, theirs: Option<f64>| Some(ours? / theirs?);
    [
        ratio(row.rate("ours", rate), row.best(Family::Embree, rate)),
        ratio(row.rate("ours, single", rate).or(row.rate("ours", rate)), row.rate("Embree, single", rate)),
        ratio(row.rate(BY_TEXTURE, rate), row.best(Family::Embree, rate)),
    ]
}

/// A column of the summary table: its heading and its cell.
type Cell<'a> = (String, Box<dyn Fn(&Row) -> String + 'a>);

fn table(text: &mut String, first: &Row, rows: &[&Row], rate: fn(&Column) -> f64) {
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.2}"));
    let mut cells: Vec<Cell> = Vec::new();
    // Some columns are of some scenes only.
    let columns = rows.iter().map(|row| &row.columns).max_by_key(|columns| columns.len());
    for column in columns.into_iter().flatten().filter(|c| c.family != Family::Obvhs) {
        let name = column.name.clone();
        cells.push((name.clone(), Box::new(move |row| number(row.rate(&name, rate)))));
    }
    cells.push(("obvhs".to_owned(), Box::new(move |row| number(row.best(Family::Obvhs, rate)))));
    if first.best(Family::Embree, rate).is_some() {
        cells.push((
            "**ours / Embree's best**".to_owned(),
            Box::new(move |row| format!("**{}**", number(ratios(row, rate)[0]))),
        ));
        if rows.iter().any(|row| ratios(row, rate)[2].is_some()) {
            cells.push((
                "no opacity maps / Embree's best".to_owned(),
                Box::new(move |row| number(ratios(row, rate)[2])),
            ));
        }
        cells.push(("single / single".to_owned(), Box::new(move |row| number(ratios(row, rate)[1]))));
    }
    if first.list == List::Primary {
        cells.push((
            "nodes, triangles a ray".to_owned(),
            Box::new(|row| format!("{:.1}, {:.1}", row.counts.nodes, row.counts.triangles)),
        ));
    }
    let headings: Vec<&str> = cells.iter().map(|(heading, _)| heading.as_str()).collect();
    let _ = writeln!(text, "| | {} |\n|---|{}", headings.join(" | "), "---:|".repeat(headings.len()));
    for row in rows {
        let values: Vec<String> = cells.iter().map(|(_, cell)| cell(row)).collect();
        let _ = writeln!(text, "| {} | {} |", row.scene, values.join(" | "));
    }
}

/// Differences in words.
fn explained(d: &Differences) -> String {
    if d.rays == 0 {
        return "every way answers the same".to_owned();
    }
    let judged = if d.judged < d.rays { format!("; of {} judged", d.judged) } else { String::new() };
    let mut text = format!(
        "{} rays on which answers differ{judged}: {} pass an edge, {} the alpha threshold, {} start on a surface, \
         within {} · 2⁻²⁴ of the largest coordinate",
        d.rays, d.at_edge, d.at_alpha, d.at_start, d.tolerance
    );
    if d.ours_wrong + d.theirs_wrong > 0 {
        let _ = write!(
            text,
            "; beyond rounding: {} where we are wrong, {} where a peer is",
            d.ours_wrong, d.theirs_wrong
        );
    }
    text
}
