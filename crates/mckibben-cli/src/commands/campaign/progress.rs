//! The progress bar: on a terminal only, to standard error.

use crate::output::text::number;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mckibben::progress::Progress;
use std::fmt::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A bar with rate and remaining time, and the flag that a signal sets.
pub struct Watch {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
}

impl Watch {
    /// The bar is hidden where nobody wants it or standard error is no terminal.
    pub fn new(quiet: bool, stop: Arc<AtomicBool>) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr_with_hz(5) };
        let bar = ProgressBar::with_draw_target(None, target);
        if let Ok(style) = ProgressStyle::with_template("{bar:32} {pos}/{len} muscles, {rate}, {eta} left") {
            let rate = |s: &ProgressState, to: &mut dyn Write| {
                // Nothing better can be done where nobody can be told.
                let _ = write!(to, "{} a second", number(s.per_sec(), 3));
            };
            bar.set_style(style.with_key("rate", rate));
        }
        Self { bar, stop }
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Watch {
    fn report(&self, done: usize, total: usize) {
        let first = self.bar.length().is_none();
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
        if first {
            // What was there already says nothing about the rate.
            self.bar.reset_eta();
        }
        self.bar.tick();
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
