//! Interleaved measurement of several ways to answer one list of rays.

use std::ops::Range;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use super::clock::thread_time;

/// Rays per call of a tracer: four of the renderer's blocks of 32×32 pixels, and one of Embree's streams.
pub const BATCH: usize = 4096;

/// Whose code it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// This repository's.
    Ours,
    /// Intel Embree.
    Embree,
    /// The obvhs crate's own traversal.
    Obvhs,
}

/// One way to answer a fixed list of rays.
pub trait Way: Sync {
    /// Heading of its column.
    fn name(&self) -> &str;
    /// Whose it is.
    fn family(&self) -> Family;
    /// Whatever must happen before each run and is not measured.
    fn prepare(&self) {}
    /// Answers rays `range`; measured. `out` has the length of `range`.
    fn trace(&self, range: Range<usize>, out: &mut [bool]);
    /// Puts the answers of the whole list into `out` if [`Way::trace`] did not; not measured.
    fn collect(&self, _out: &mut [bool]) {}
}

/// Median, least and largest rate, in millions of rays per second.
#[derive(Clone, Copy, Debug)]
pub struct Rate {
    pub median: f64,
    pub least: f64,
    pub most: f64,
}

impl Rate {
    fn of(mut times: Vec<Duration>, rays: usize) -> Self {
        times.sort();
        let rate = |t: Duration| rays as f64 / t.as_secs_f64().max(1e-12) * 1e-6;
        Rate {
            median: rate(times[times.len() / 2]),
            least: rate(times[times.len() - 1]),
            most: rate(times[0]),
        }
    }
}

/// One way's outcome.
#[derive(Clone, Debug)]
pub struct Column {
    pub name: String,
    pub family: Family,
    /// One thread, by its CPU time.
    pub one: Rate,
    /// Two threads, by wall time.
    pub two: Rate,
}

/// Rates and answers, way by way.
pub struct Measured {
    pub columns: Vec<Column>,
    pub answers: Vec<Vec<bool>>,
}

/// Runs every way once to warm up, then `repeats` times in turn; one thread and two.
///
/// Right before it is measured each way runs once more: what it reads is in the caches as far as it goes there, whichever way was
/// before it. Ways share trees, and the first of a family would else read what the others find.
pub fn measure(label: &str, ways: &[Box<dyn Way + '_>], rays: usize, repeats: u32) -> Measured {
    let mut answers = vec![vec![false; rays]; ways.len()];
    let (mut one, mut two) = (vec![Vec::new(); ways.len()], vec![Vec::new(); ways.len()]);
    let mut is_measured = vec![true; ways.len()];
    for round in 0..=repeats {
        eprint!("\r{label}: round {round} of {repeats} ");
        for (i, way) in ways.iter().enumerate().filter(|(i, _)| is_measured[*i]) {
            let out = &mut answers[i];
            way.prepare();
            on_two_threads(&**way, out);
            way.prepare();
            let start = thread_time();
            for (batch, out) in out.chunks_mut(BATCH).enumerate() {
                way.trace(range_of(batch, out.len()), out);
            }
            let single = thread_time() - start;
            way.prepare();
            let start = Instant::now();
            on_two_threads(&**way, out);
            let double = start.elapsed();
            way.collect(out);
            one[i].push(single);
            two[i].push(double);
        }
        if round == 0 {
            drop_slower(ways, &one, &mut is_measured);
            one.iter_mut().chain(&mut two).for_each(Vec::clear);
        }
    }
    eprintln!();
    let mut measured = Measured { columns: Vec::new(), answers: Vec::new() };
    for (((way, answers), (one, two)), is_measured) in
        ways.iter().zip(answers).zip(one.into_iter().zip(two)).zip(is_measured)
    {
        if is_measured {
            measured.columns.push(Column {
                name: way.name().to_owned(),
                family: way.family(),
                one: Rate::of(one, rays),
                two: Rate::of(two, rays),
            });
            measured.answers.push(answers);
        }
    }
    measured
}

/// Of obvhs's ways only the one that was faster in the first round goes on: the others only take time.
fn drop_slower(ways: &[Box<dyn Way + '_>], times: &[Vec<Duration>], is_measured: &mut [bool]) {
    let theirs = || (0..ways.len()).filter(|&i| ways[i].family() == Family::Obvhs);
    let fastest = theirs().min_by_key(|&i| times[i].iter().sum::<Duration>());
    for i in theirs().filter(|&i| Some(i) != fastest) {
        is_measured[i] = false;
    }
}

fn range_of(batch: usize, length: usize) -> Range<usize> {
    batch * BATCH..batch * BATCH + length
}

/// Two threads take batch after batch.
fn on_two_threads(way: &dyn Way, out: &mut [bool]) {
    let batches = Mutex::new(out.chunks_mut(BATCH).enumerate());
    let work = || {
        loop {
            let next = batches.lock().map_or(None, |mut batches| batches.next());
            let Some((batch, out)) = next else { return };
            way.trace(range_of(batch, out.len()), out);
        }
    };
    std::thread::scope(|scope| {
        scope.spawn(work);
        work();
    });
}
