//! In place of threads where the feature `threads` is off: the calling thread does the work.

/// The calling thread.
pub struct Threads;

impl Threads {
    /// That of the process.
    pub fn shared() -> &'static Self {
        &Self
    }

    pub(super) fn each(&self, count: usize, work: &dyn Fn(usize)) {
        (0..count).for_each(work);
    }
}
