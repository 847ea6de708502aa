//! Cancelling: a flag that ends long work.
//!
//! A front end makes a [`Cancel`] for each request and [enters](Cancel::enter) it for the time of
//! the work. Every loop that may be long [looks](check) at the flag of its thread; work side by
//! side (threads of the crate `mckibben`) takes the flag along.

use std::{
    cell::RefCell,
    marker::PhantomData,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};
use thiserror::Error;

/// The caller wanted the work to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("cancelled before the end")]
pub struct Cancelled;

/// A flag that ends work. Copies share it.
#[derive(Debug, Clone, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Ends the work where it looks at the flag next.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the work may go on.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.0.load(Ordering::Relaxed) {
            Err(Cancelled)
        } else {
            Ok(())
        }
    }

    /// The flag of the work that this thread does: the one that was entered last, else one that
    /// nobody sets.
    pub fn current() -> Self {
        CURRENT.with_borrow(Clone::clone).unwrap_or_default()
    }

    /// Makes this the flag of the work that this thread does, until what is returned is dropped.
    #[must_use = "the flag ends where this is dropped"]
    pub fn enter(&self) -> Entered {
        Entered {
            before: CURRENT.replace(Some(self.clone())),
            of_this_thread: PhantomData,
        }
    }
}

impl From<Arc<AtomicBool>> for Cancel {
    fn from(flag: Arc<AtomicBool>) -> Self {
        Self(flag)
    }
}

/// Whether the work that this thread does may go on.
pub fn check() -> Result<(), Cancelled> {
    CURRENT.with_borrow(|current| current.as_ref().map_or(Ok(()), Cancel::check))
}

thread_local! {
    static CURRENT: RefCell<Option<Cancel>> = const { RefCell::new(None) };
}

/// A flag that was entered; where it is dropped, the one before it holds again.
#[derive(Debug)]
pub struct Entered {
    before: Option<Cancel>,
    of_this_thread: PhantomData<*const ()>,
}

impl Drop for Entered {
    fn drop(&mut self) {
        CURRENT.set(self.before.take());
    }
}
