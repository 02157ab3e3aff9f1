//! Markdown of all that was measured, the paper's figures beside ours.

use std::fmt::Write;

use lt_irregular::SimdLevel;

use super::today::today;
use super::{hair, random, samples};

/// The paper's Table 1: nodes visited, occlusion-culled, samples tested (thousands), then ms of tree, triangles and total.
const PAPER: [(u32, [f64; 3], [u32; 3]); 4] = [
    (1_000, [91.0, 5.3, 458.0], [400, 145, 675]),
    (10_000, [471.0, 5.4, 513.0], [402, 381, 913]),
    (100_000, [3_200.0, 5.8, 506.0], [391, 1568, 2089]),
    (1_000_000, [23_000.0, 6.8, 501.0], [408, 8102, 8640]),
];

/// All tables.
pub fn markdown(
    rows: &[random::Row],
    close: &[random::Row],
    hair: &[hair::Row],
    sampled: &[samples::Row],
) -> String {
    let mut out = String::new();
    let threads = rayon::current_num_threads();
    let _ = writeln!(
        out,
        "{}, {} ({:?}), {threads} threads. Every answer was compared with the ray tracer's: none differs.\n",
        today(),
        std::env::consts::ARCH,
        SimdLevel::best()
    );
    if !rows.is_empty() {
        let _ = writeln!(
            out,
            "Random triangles of constant total area, 1024×768, the paper's one tree of medians (thousands; the paper's in \
             brackets):\n"
        );
        counters(&mut out, rows);
        let _ = writeln!(out, "\nTimes, ms, one thread (the paper's, on a 1.6 GHz Pentium, in brackets):\n");
        times(&mut out, rows);
        let _ = writeln!(out, "\nEverything built anew, ms, {threads} threads:\n");
        anew(&mut out, rows);
    }
    if !close.is_empty() {
        let _ = writeln!(out, "\nClose-ups:\n");
        counters(&mut out, close);
        out.push('\n');
        times(&mut out, close);
    }
    if !hair.is_empty() {
        let _ = writeln!(
            out,
            "\nHair balls of translucent strands, RGB transmittance, 1536×1088, {threads} threads:\n"
        );
        hairs(&mut out, hair);
    }
    if !sampled.is_empty() {
        let size = samples::SIZE;
        let _ = writeln!(
            out,
            "\n### Samples per pixel\n\nMilliseconds of a frame, {}×{} pixels, {threads} threads; in brackets, times what one sample \
             takes. `ray` and `ray:light` walk trees built before, `ray:dac` and `alias-free` build all of theirs every time:\n",
            size.x, size.y
        );
        sampled.iter().for_each(|row| per_sample(&mut out, row));
    }
    out
}

fn per_sample(out: &mut String, row: &samples::Row) {
    let ids = samples::TECHNIQUES.map(|id| format!("`{id}`")).join(" | ");
    let _ = writeln!(out, "| {} | {ids} |\n|---|{}", row.name, "---|".repeat(samples::TECHNIQUES.len()));
    for (count, ms) in samples::COUNTS.iter().zip(&row.ms) {
        let cells: Vec<String> =
            ms.iter().zip(&row.ms[0]).map(|(ms, one)| format!("{ms:.1} ({:.1})", ms / one)).collect();
        let _ = writeln!(out, "| {count} | {} |", cells.join(" | "));
    }
    out.push('\n');
}

fn thousands(n: u64) -> String {
    match n {
        0..100_000 => format!("{:.1}", n as f64 / 1e3),
        _ => format!("{:.0}", n as f64 / 1e3),
    }
}

/// The paper's figures for a scene; close-ups have their own views, for which it gives none.
fn paper_of(row: &random::Row) -> Option<([f64; 3], [u32; 3])> {
    let is_whole = !row.name.contains(' ');
    PAPER.iter().find(|p| is_whole && p.0 == row.triangles).map(|p| (p.1, p.2))
}

fn beside(ours: String, paper: Option<f64>) -> String {
    paper.map_or(ours.clone(), |p| format!("{ours} ({p})"))
}

fn counters(out: &mut String, rows: &[random::Row]) {
    let _ = writeln!(
        out,
        "| | samples | tree's nodes | nodes visited | occlusion-culled | samples tested | exact tests |\n\
         |---|---|---|---|---|---|---|"
    );
    for row in rows {
        let paper = paper_of(row).map(|p| p.0);
        let c = &row.counters;
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {} | {} |",
            row.name,
            thousands(row.samples as u64),
            beside(thousands(row.nodes as u64), paper.map(|_| 16.0)),
            beside(thousands(c.nodes_visited), paper.map(|p| p[0])),
            beside(thousands(c.nodes_culled), paper.map(|p| p[1])),
            beside(thousands(c.samples_tested), paper.map(|p| p[2])),
            thousands(c.tests_exact),
        );
    }
}

fn times(out: &mut String, rows: &[random::Row]) {
    let _ = writeln!(
        out,
        "| | transform | medians: tree | triangles | total | Morton order: tree | triangles | total | BVH | rays | total |\n\
         |---|---|---|---|---|---|---|---|---|---|---|"
    );
    for row in rows {
        let paper = paper_of(row).map(|p| p.1.map(f64::from));
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} |",
            row.name,
            beside(format!("{:.1}", row.transform), paper.map(|_| 130.0)),
            beside(format!("{:.1}", row.medians.build), paper.map(|p| p[0])),
            beside(format!("{:.1}", row.medians.run), paper.map(|p| p[1])),
            beside(format!("{:.1}", row.medians.total()), paper.map(|p| p[2])),
            row.morton.build,
            row.morton.run,
            row.morton.total(),
            row.rays.build,
            row.rays.run,
            row.rays.total(),
        );
    }
}

fn anew(out: &mut String, rows: &[random::Row]) {
    let _ = writeln!(out, "| | alias-free map | rays with their BVH | ratio |\n|---|---|---|---|");
    for row in rows {
        let (map, rays) = (row.medians_all.total(), row.rays_all.total());
        let _ = writeln!(out, "| {} | {map:.1} | {rays:.1} | {:.2} |", row.name, rays / map);
    }
}

fn hairs(out: &mut String, rows: &[hair::Row]) {
    let _ = writeln!(
        out,
        "| hairs | triangles | samples | nodes visited | samples tested | tree, ms | triangles, ms | total, s | along rays \
         (BVH built before), ms | largest difference |\n|---|---|---|---|---|---|---|---|---|---|"
    );
    for row in rows {
        let total = (row.build + row.draw) / 1e3;
        let paper = (row.hairs == 5000).then_some(12.6);
        let _ = writeln!(
            out,
            "| {} | {} k | {} k | {} k | {} k | {:.0} | {:.0} | {} | {:.0} | {:.1e} |",
            row.hairs,
            thousands(row.triangles as u64),
            thousands(row.samples as u64),
            thousands(row.counters.nodes_visited),
            thousands(row.counters.samples_tested),
            row.build,
            row.draw,
            beside(format!("{total:.2}"), paper),
            row.rays,
            row.largest_difference,
        );
    }
}
