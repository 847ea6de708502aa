//! The progress bar: on a terminal only, to standard error.

use crate::output::text::number;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mckibben_campaign::campaign::Progress;
use std::fmt::Write;

/// A bar with rate and remaining time.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar; hidden where nobody wants it or standard error is no terminal.
    pub fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr_with_hz(5) };
        let bar = ProgressBar::with_draw_target(None, target);
        let template = "{bar:32} {pos}/{len} muscles, {rate}, {eta} left{msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            let rate = |s: &ProgressState, to: &mut dyn Write| {
                // Nothing better can be done where nobody can be told.
                let _ = write!(to, "{} a second", number(s.per_sec(), 3));
            };
            bar.set_style(style.with_key("rate", rate));
        }
        Self(bar)
    }

    /// Shows how far the run is.
    pub fn show(&self, p: Progress) {
        if self.0.length().is_none() {
            self.0.set_length(p.of);
            self.0.set_position(p.resumed);
            // What was there already says nothing about the rate.
            self.0.reset_eta();
        }
        self.0.set_position(p.muscles);
        if p.failed > 0 {
            self.0.set_message(format!(", {} of {} points without an answer", p.failed, p.points));
        }
        self.0.tick();
    }

    /// Removes it.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}
