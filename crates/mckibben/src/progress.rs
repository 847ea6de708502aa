//! Progress of long work, and the wish to stop it.

use crate::cancel::{self, Cancelled};

/// What long work tells its caller, and asks him: one small trait for every front end.
///
/// Work calls [`Progress::report`] now and then and ends early, with an error that says so, once
/// [`Progress::cancelled`] answers true.
pub trait Progress: Sync {
    /// So many of so many steps are done.
    fn report(&self, _done: usize, _total: usize) {}

    /// Whether the caller wants the work to end: the flag that was [entered](cancel::Cancel::enter) says so.
    fn cancelled(&self) -> bool {
        cancel::check().is_err()
    }

    /// The same as an error.
    fn check(&self) -> Result<(), Cancelled> {
        if self.cancelled() { Err(Cancelled) } else { Ok(()) }
    }
}

/// No report, and no end before that of the flag.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {}

/// Only the wish to end: for a part of the work that tells no steps of its own.
pub struct CancelOnly<'a>(pub &'a dyn Progress);

impl Progress for CancelOnly<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
