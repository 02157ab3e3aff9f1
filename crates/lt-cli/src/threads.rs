//! The threads that do the work.

use anyhow::Context;

/// Starts so many threads in all, or one per core, of which the calling one is the first.
///
/// It works with the others instead of waiting beside them: where there are as many threads as cores, one more makes the system put two of
/// them on one core for some milliseconds, in the middle of a measured frame.
///
/// # Errors
/// The system starts no such number of threads.
pub fn start(threads: Option<u16>) -> anyhow::Result<()> {
    let count = threads.map_or(0, usize::from);
    let threads = rayon::ThreadPoolBuilder::new().num_threads(count).use_current_thread().build_global();
    threads.context("the threads could not be started: ask for fewer with --threads")
}
