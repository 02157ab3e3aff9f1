//! The tables and figures of "Leak Tracing" (Kern, Brüll, Grosch, EGSR 2024) with our scenes, ours beside the paper's.

mod cells;
mod paper;
mod plots;
mod tables;
#[path = "../../../crates/lt-render/benches/rays/today.rs"]
mod today;

use std::path::Path;

use anyhow::Result;

use crate::files;
use cells::{Cell, Keeper, Results};

/// Scenes of Table 2, each beside the paper's that it is most like.
const SCENES: [&str; 4] = ["street", PATH_SCENE, "town", "forest"];
/// The scene of Table 3: alpha-tested, as the paper's.
const PATH_SCENE: &str = "square";
/// Techniques of Table 3. The paper's maps alone are drawn every frame, in four levels.
const PATH_TECHNIQUES: &str = "ray,sm:no-reuse:cascades=4,vsm:no-reuse:cascades=4,msm:no-reuse:cascades=4,lt-evsm,\
    lt-evsm:no-rr,lt-evsm:no-reuse,ltt-evsm";
/// Map kinds, ranked.
const KINDS: [&str; 4] = ["lt-evsm", "lt-vsm", "lt-msm", "lt-esm"];
/// Factors of the scale test.
const SCALES: [&str; 3] = ["1", "0.001", "1000"];
/// The fence's techniques from no history, each with [`ONE_MAP`].
const FENCE: [&str; 6] =
    ["lt-evsm", "lt-vsm", "lt-msm", "lt-esm", "lt-evsm:refresh=16", "lt-evsm:refresh=64"];

/// One map for all of the fence.
const ONE_MAP: &str = ":cascades=1";

/// How much is measured.
#[derive(Clone, Copy)]
struct Extent {
    size: &'static str,
    /// The paper's picture sizes, or smaller ones.
    sizes: [&'static str; 4],
    /// Frames of a path; of one where things move or maps are drawn every frame; of a variant; of a cold start; of the fence's.
    frames: [u32; 5],
    fence_size: &'static str,
}

const FULL: Extent = Extent {
    size: "1920x1080",
    sizes: ["1280x720", "1920x1080", "2560x1440", "3840x2160"],
    frames: [24, 12, 8, 24, 400],
    fence_size: "960x540",
};
const QUICK: Extent = Extent {
    size: "480x270",
    sizes: ["320x180", "480x270", "640x360", "960x540"],
    frames: [6, 4, 4, 12, 60],
    fence_size: "320x180",
};

/// Everything that was measured.
struct Found {
    extent: Extent,
    /// By [`SCENES`].
    scenes: Vec<(Cell, Results)>,
    /// By [`Extent::sizes`].
    sizes: Vec<(Cell, Results)>,
    map_sizes: (Cell, Results),
    /// By scene: street, forest.
    kinds: Vec<(Cell, Results)>,
    fence: (Cell, Results),
    /// By scene: street, forest.
    cold: Vec<(Cell, Results)>,
    /// By [`SCALES`].
    scales: Vec<(Cell, Results)>,
}

/// Measures what no earlier run has measured, and writes `leak-tracing.md` and `leak-tracing.svg` into a folder.
///
/// # Errors
/// `lt` cannot be built or fails, or a file cannot be written.
pub fn run(is_quick: bool, out: &Path) -> Result<()> {
    let found = measure(if is_quick { QUICK } else { FULL })?;
    let text = tables::markdown(&found)?;
    println!("{text}");
    std::fs::create_dir_all(out)?;
    files::replace(&out.join("leak-tracing.md"), text.as_bytes())?;
    files::replace(&out.join("leak-tracing.svg"), plots::svg(&found)?.as_bytes())?;
    Ok(())
}

fn measure(extent: Extent) -> Result<Found> {
    let [path, heavy, variant, cold, fence] = extent.frames;
    let at = |scene: &str, size: &str, frames: u32, rest: &str| {
        Cell::new(&format!("{scene} --size {size} --backend cpu --no-flip --frames {frames} {rest}"))
    };
    let base = "--techniques ray,ltt-evsm,lt-evsm";
    let kinds = format!("--techniques ray,{}", KINDS.join(","));
    let mut cells: Vec<Cell> = Vec::new();
    for scene in SCENES {
        let (frames, rest) = match scene {
            PATH_SCENE => (heavy, format!("--techniques {PATH_TECHNIQUES}")),
            "forest" => (heavy, base.to_owned()),
            _ => (path, base.to_owned()),
        };
        cells.push(at(scene, extent.size, frames, &rest));
    }
    cells.extend(extent.sizes.map(|size| at("street", size, variant, base)));
    let maps = paper::MAP_SIZES.map(|(size, _)| format!("lt-evsm:map={size}")).join(",");
    cells.push(at("street", extent.size, variant, &format!("--techniques ray,{maps}")));
    cells.extend(["street", "forest"].map(|scene| at(scene, extent.size, variant, &kinds)));
    let ids = FENCE.map(|id| format!("{id}{ONE_MAP}")).join(",");
    let rest = format!("--still --cold --map-size 64 --techniques {ids}");
    cells.push(at("fence", extent.fence_size, fence, &rest));
    let rest = "--still --cold --techniques lt-evsm,lt-evsm:refresh=16";
    cells.extend(["street", "forest"].map(|scene| at(scene, extent.size, cold, rest)));
    let rest = |factor: &str| format!("{base} --scale {factor}");
    cells.extend(SCALES.map(|factor| at("street", extent.sizes[0], variant, &rest(factor))));
    let results = Keeper::new()?.measure(&cells)?;
    let mut all = cells.into_iter().zip(results);
    let mut take = |count: usize| all.by_ref().take(count).collect::<Vec<_>>();
    let (scenes, sizes, mut map_sizes, kinds) = (take(4), take(4), take(1), take(2));
    let (mut fence, cold, scales) = (take(1), take(2), take(3));
    Ok(Found {
        extent,
        scenes,
        sizes,
        map_sizes: map_sizes.remove(0),
        kinds,
        fence: fence.remove(0),
        cold,
        scales,
    })
}
