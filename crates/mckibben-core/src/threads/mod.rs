//! Work side by side, on the threads that the system gives.
//!
//! All parallel work of the workspace goes through here. Results have the order of their items:
//! they are the same on any number of threads. Without the feature `threads` the calling thread
//! does the work alone.

#[cfg_attr(not(feature = "threads"), path = "alone.rs")]
mod pool;

pub use pool::*;

use std::sync::{Mutex, PoisonError};
use thiserror::Error;

/// Requested threads are not available.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("cannot start threads: {0}")]
pub struct ThreadsError(String);

impl Threads {
    /// `f` of every item, in their order.
    pub fn map<T: Sync, R: Send>(&self, items: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
        // What rayon compiles for each closure is long: it gets one that is the same for all, with a
        // place for each result.
        let places: Vec<Mutex<Option<R>>> = items.iter().map(|_| Mutex::new(None)).collect();
        self.each(items.len(), &|i| {
            *places[i].lock().unwrap_or_else(PoisonError::into_inner) = Some(f(&items[i]));
        });
        places
            .into_iter()
            .filter_map(|place| place.into_inner().unwrap_or_else(PoisonError::into_inner))
            .collect()
    }

    /// Works on the parts of a list, so many places each (the last one may have fewer): `work` gets
    /// the place where a part begins and the part.
    pub fn fill<T: Send>(
        &self,
        out: &mut [T],
        places: usize,
        work: impl Fn(usize, &mut [T]) + Sync,
    ) {
        let places = places.max(1);
        if out.len() <= places {
            return out.chunks_mut(places).for_each(|part| work(0, part));
        }
        let parts: Vec<Mutex<&mut [T]>> = out.chunks_mut(places).map(Mutex::new).collect();
        self.each(parts.len(), &|i| {
            work(
                i * places,
                &mut parts[i].lock().unwrap_or_else(PoisonError::into_inner),
            );
        });
    }
}

/// `f` of every item, in their order, on the threads of the process.
pub fn map<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
    Threads::shared().map(items, f)
}
