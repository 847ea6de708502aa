//! Progress on a terminal, and the wish to stop by Ctrl-C.

use crate::output::text::number;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mckibben::progress::Progress;
use std::fmt::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

/// Set by Ctrl-C and the signals that end a process.
static STOPPED: AtomicBool = AtomicBool::new(false);
/// Whether the signals were taken over already.
static LISTENS: OnceLock<()> = OnceLock::new();

/// A bar with rate and remaining time, to standard error, on a terminal only. The first Ctrl-C ends the work, the second
/// the program.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar that counts things of this name.
    pub fn new(things: &str) -> Self {
        Self::on(things, ProgressDrawTarget::stderr_with_hz(5))
    }

    /// One that nobody sees.
    pub fn hidden() -> Self {
        Self::on("", ProgressDrawTarget::hidden())
    }

    fn on(things: &str, target: ProgressDrawTarget) -> Self {
        LISTENS.get_or_init(|| {
            // Where signals cannot be taken over, they end the program as ever.
            let _ = ctrlc::set_handler(|| {
                if STOPPED.swap(true, Ordering::Relaxed) {
                    std::process::exit(i32::from(INTERRUPTED));
                }
            });
        });
        let bar = ProgressBar::with_draw_target(None, target);
        let template = format!("{{bar:32}} {{pos}}/{{len}} {things}, {{rate}}, {{eta}} left{{msg}}");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            let rate = |s: &ProgressState, to: &mut dyn Write| {
                // Nothing better can be done where nobody can be told.
                let _ = write!(to, "{} a second", number(s.per_sec(), 3));
            };
            bar.set_style(style.with_key("rate", rate));
        }
        Self(bar)
    }
}

/// Exit code of work that was ended from outside, as shells have it.
pub const INTERRUPTED: u8 = 130;

impl Progress for Bar {
    fn report(&self, done: usize, total: usize) {
        if self.0.length().is_none() {
            self.0.set_position(done as u64);
            // What was there already says nothing about the rate.
            self.0.reset_eta();
        }
        self.0.set_length(total as u64);
        self.0.set_position(done as u64);
    }

    fn cancelled(&self) -> bool {
        STOPPED.load(Ordering::Relaxed)
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
