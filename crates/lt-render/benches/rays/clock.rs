//! Clocks: what a thread has run, what the process has run, what has passed.

use std::time::Duration;

/// CPU time of the calling thread: other programs on the machine add nothing to it but cache misses.
#[cfg(unix)]
pub fn thread_time() -> Duration {
    read(rustix::time::ClockId::ThreadCPUTime)
}

/// CPU time of all threads of this process.
#[cfg(unix)]
pub fn process_time() -> Duration {
    read(rustix::time::ClockId::ProcessCPUTime)
}

#[cfg(unix)]
fn read(clock: rustix::time::ClockId) -> Duration {
    let time = rustix::time::clock_gettime(clock);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

/// Without such clocks: time passed.
#[cfg(not(unix))]
pub fn thread_time() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
}

/// Without such clocks: time passed.
#[cfg(not(unix))]
pub fn process_time() -> Duration {
    thread_time()
}
