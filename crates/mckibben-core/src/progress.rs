//! Progress of long work, and how a caller cancels it.

use crate::cancel::{self, Cancelled};

/// What long work tells its caller, and asks him: one small trait for every front end.
///
/// Work calls [`Progress::report`] now and then and ends early, with an error that says so, once
/// [`Progress::cancelled`] answers true.
pub trait Progress: Sync {
    /// So many of so many steps are done.
    fn report(&self, _done: usize, _total: usize) {}

    /// Whether the caller wants the work to end: the flag that was [entered](cancel::Cancel::enter)
    /// says so.
    fn cancelled(&self) -> bool {
        cancel::check().is_err()
    }

    /// The same as an error.
    fn check(&self) -> Result<(), Cancelled> {
        if self.cancelled() {
            Err(Cancelled)
        } else {
            Ok(())
        }
    }
}

/// No report, and no end before that of the flag.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {}

/// Cancels only: for a part of the work that reports no steps.
pub struct CancelOnly<'a>(pub &'a dyn Progress);

impl Progress for CancelOnly<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        cancel::{Cancel, check},
        threads,
    };

    #[test]
    fn a_flag_that_was_entered_is_that_of_threads_and_silent_work_until_it_is_left() {
        let cancel = Cancel::default();
        let ended = || {
            let here = check().is_err() && Silent.cancelled();
            here && threads::map(&[1, 2, 3], |_| Silent.cancelled()) == [true; 3]
        };
        assert!(!ended());
        {
            let _entered = cancel.enter();
            assert!(!ended());
            cancel.cancel();
            assert!(ended());
            let _other = Cancel::default().enter();
            assert!(!ended());
        }
        assert!(!ended());
    }
}
