//! Progress of long work, and the wish to stop it.

use crate::budget::Budget;

/// What long work tells its caller, and asks him: one small trait for every front end.
///
/// Work calls [`Progress::report`] now and then and ends early, with an error that says so, once
/// [`Progress::cancelled`] answers true.
pub trait Progress: Sync {
    /// So many of so many steps are done.
    fn report(&self, _done: usize, _total: usize) {}

    /// Whether the work is to end: its caller wants it, or its budget is used up.
    fn cancelled(&self) -> bool {
        self.budget().check().is_err()
    }

    /// What the work may cost: the budget that was [entered](Budget::enter).
    fn budget(&self) -> Budget {
        Budget::current()
    }
}

/// No report, and no end before that of the budget.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {}

/// Only the wish to end, and the budget: for a part of the work that tells no steps of its own.
pub struct CancelOnly<'a>(pub &'a dyn Progress);

impl Progress for CancelOnly<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }

    fn budget(&self) -> Budget {
        self.0.budget()
    }
}
