//! Progress on a terminal, and the wish to stop by Ctrl-C.

use crate::Result;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mckibben_app::{ProblemKind, words::number};
use mckibben_core::{cancel::Cancel, progress::Progress};
use mckibben_io::files::Unfinished;
use signal_hook::{consts, flag};
use std::{
    fmt::Write,
    io::{IsTerminal, stderr},
    sync::{
        Arc, LazyLock, Mutex, Once, OnceLock, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

/// Set by Ctrl-C and the signals that end a process, which are taken over when a command begins.
static STOPPED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);
/// The signals that end a process.
#[cfg(unix)]
const ENDING: [i32; 3] = [consts::SIGINT, consts::SIGTERM, consts::SIGHUP];
#[cfg(not(unix))]
const ENDING: [i32; 2] = [consts::SIGINT, consts::SIGTERM];

/// After the wish to end, work has this long to leave everything in order.
const GRACE: Duration = Duration::from_millis(700);
/// What takes less time has no bar.
const SOON: Duration = Duration::from_millis(500);
/// The wish is looked for this often.
const TICK: Duration = Duration::from_millis(50);

/// The flag that ends the work.
pub fn cancel() -> Cancel {
    Arc::clone(&STOPPED).into()
}

/// Refuses the result of cancelled work: what came out of cancelled work is no answer, and is not
/// written.
pub fn ended() -> Result<()> {
    Ok(cancel().check()?)
}

/// How a command ended: what it says that failed in cancelled work is no reason.
pub fn last_word(done: Result<u8>) -> Result<u8> {
    match done {
        Err(problem) if problem.kind != ProblemKind::Internal => ended().and(Err(problem)),
        done => done,
    }
}

/// A file that grows beyond a limit of the system is an error of writing, and not the end of the
/// process: what is unfinished is removed.
pub fn no_signal_for_long_files() {
    // The flag is never read: that somebody listens is enough.
    #[cfg(unix)]
    let _ = flag::register(consts::SIGXFSZ, Arc::default());
}

/// Whether a signal came that ends a process. From the first call on the first signal no longer
/// ends the program by itself; the second one does.
pub fn stopped() -> bool {
    static TAKEN: Once = Once::new();
    TAKEN.call_once(|| {
        for signal in ENDING {
            // In this order: the first one sets the flag, and a later one finds it set. Where
            // signals cannot be taken over, they end the program as ever.
            let _ = flag::register_conditional_shutdown(
                signal,
                i32::from(INTERRUPTED),
                Arc::clone(&STOPPED),
            )
            .and_then(|_| flag::register(signal, Arc::clone(&STOPPED)));
        }
    });
    STOPPED.load(Ordering::Relaxed)
}

/// From now on a signal ends the work, and soon after it the program, whatever it does.
pub fn watched() {
    static WATCHED: Once = Once::new();
    stopped();
    // Where there is no thread for it, work ends as soon as it looks.
    WATCHED.call_once(|| drop(std::thread::Builder::new().spawn(watch)));
}

/// Ends at last the program: files appear whole or not at all, and what is unfinished is removed.
fn watch() {
    while !STOPPED.load(Ordering::Relaxed) {
        std::thread::sleep(TICK);
    }
    std::thread::sleep(GRACE);
    let _held = Unfinished::abandon();
    std::process::exit(i32::from(INTERRUPTED));
}

/// A bar with rate and remaining time on a terminal, of work that takes longer than a moment; where
/// standard error is a log, a line a minute. The first Ctrl-C ends the work, the second the program.
pub struct Bar {
    bar: ProgressBar,
    things: String,
    /// When it is drawn, or the next line is due.
    due: Mutex<Instant>,
    /// What was there already.
    before: OnceLock<usize>,
}

/// A log gets a line this often.
const A_MINUTE: Duration = Duration::from_secs(60);

impl Bar {
    /// A bar that counts things of this name.
    pub fn new(things: &str) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template(&format!(
            "{{bar:32}} {{pos}}/{{len}} {things}, {{rate}}, {{eta}} left{{msg}}"
        )) {
            let rate = |s: &ProgressState, to: &mut dyn Write| {
                // Nothing better can be done if the message cannot be shown.
                let _ = write!(to, "{} a second", number(s.per_sec(), 3));
            };
            bar.set_style(style.with_key("rate", rate));
        }
        let first = if stderr().is_terminal() {
            SOON
        } else {
            A_MINUTE
        };
        Self {
            bar,
            things: things.into(),
            due: Mutex::new(Instant::now() + first),
            before: OnceLock::new(),
        }
    }

    /// Draws it from its time on, or writes the line that is due.
    fn draw(&self, done: usize, total: usize) {
        let mut due = self.due.lock().unwrap_or_else(PoisonError::into_inner);
        if Instant::now() < *due {
            return;
        }
        *due += A_MINUTE;
        if stderr().is_terminal() {
            if self.bar.is_hidden() {
                self.bar
                    .set_draw_target(ProgressDrawTarget::stderr_with_hz(5));
            }
            return;
        }
        let before = *self.before.get_or_init(|| done);
        let rate = done.saturating_sub(before) as f64 / self.bar.elapsed().as_secs_f64();
        let left = number(total.saturating_sub(done) as f64 / rate.max(1e-9), 2);
        let things = &self.things;
        let rate = number(rate, 3);
        eprintln!("{done} of {total} {things}, {rate} a second, {left} s left");
    }
}

/// Exit code of work that was ended from outside, as shells have it.
pub const INTERRUPTED: u8 = 130;

impl Progress for Bar {
    fn report(&self, done: usize, total: usize) {
        if total > 0 {
            self.draw(done, total);
        }
        let bar = &self.bar;
        if bar.length().is_none() {
            bar.set_position(done as u64);
            // What was there already says nothing about the rate.
            bar.reset_elapsed();
            self.before.get_or_init(|| done);
        }
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
