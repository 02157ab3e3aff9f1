//! Progress on stderr, for anything over a second; silent where stderr is no terminal.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How long a thing may take before anybody is told.
const PATIENCE: Duration = Duration::from_secs(1);

/// A spinner that names the work; the caller clears it when done.
pub fn spinner(message: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner().with_message(message.to_owned());
    bar.enable_steady_tick(Duration::from_millis(120));
    bar
}

/// A bar over counted steps.
///
/// It draws only between steps, on the caller's thread, so that nothing runs beside a measurement.
pub struct Steps {
    bar: ProgressBar,
    start: Instant,
    is_shown: bool,
}

impl Steps {
    /// A bar that stays hidden until the work has lasted a second.
    pub fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {wide_msg} {elapsed}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, start: Instant::now(), is_shown: false }
    }

    /// Says that `done` of `total` steps are over and `what` comes next.
    pub fn at(&mut self, done: usize, total: usize, what: &str) {
        if !self.is_shown && self.start.elapsed() > PATIENCE {
            self.is_shown = true;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
        self.bar.set_message(what.to_owned());
    }

    /// Takes the bar away.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
