//! A bar with rate and time left on the standard error, if that is a terminal.

use std::fmt;
use std::io::{self, IsTerminal};
use std::sync::Once;

use indicatif::{HumanCount, ProgressBar, ProgressState, ProgressStyle};
use littlewood_sweep::Progress;

const TEMPLATE: &str = "{bar:32} {percent:>3}%  {human_pos} of {human_len} starts  {rate}  {eta} left";

/// A bar, or nothing.
pub(crate) struct Bar {
    bar: ProgressBar,
    begun: Once,
}

impl Bar {
    /// A bar at zero.
    pub(crate) fn new() -> Self {
        let bar = if io::stderr().is_terminal() { ProgressBar::new(0) } else { ProgressBar::hidden() };
        if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
            // Whole starts: the rate of the library has four decimals.
            let rate = |state: &ProgressState, writer: &mut dyn fmt::Write| {
                let _ = write!(writer, "{}/s", HumanCount(state.per_sec() as u64));
            };
            bar.set_style(style.with_key("rate", rate));
        }
        Self { bar, begun: Once::new() }
    }

    /// Moves the bar.
    pub(crate) fn show(&self, progress: Progress) {
        self.begun.call_once(|| {
            // What an earlier run has done says nothing about the speed of this one.
            self.bar.set_length(progress.total);
            self.bar.set_position(progress.reused);
            self.bar.reset_eta();
        });
        self.bar.set_position(progress.done);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
