//! Threads of rayon. Where the system refuses them (a limit of processes) the calling thread does
//! the work alone.
//!
//! There are as many threads as cores; `RAYON_NUM_THREADS` in the environment sets another number,
//! up to 64 or four for each core. Inside of a pool of rayon ([`rayon::ThreadPool::install`]) the
//! work stays in that pool. The parts of some work have its [flag](Cancel::current), on whichever
//! thread.

use super::ThreadsError;
use crate::cancel::Cancel;
use rayon::{ThreadPool, ThreadPoolBuilder, prelude::*};
use std::{
    num::NonZero,
    sync::{
        OnceLock,
        mpsc::{RecvTimeoutError, SyncSender, sync_channel},
    },
    time::Duration,
};

/// The caller of [`Threads::for_each`] hears from it this often at least.
const TICK: Duration = Duration::from_millis(100);

/// Threads that work, or none besides the calling one.
#[derive(Debug, Default)]
pub struct Threads(Option<ThreadPool>);

impl Threads {
    /// So many threads; one is the calling thread itself.
    pub fn new(count: usize) -> Result<Self, ThreadsError> {
        Ok(Self((count > 1).then(|| pool(count)).transpose()?))
    }

    /// Those of the process.
    pub fn shared() -> &'static Self {
        &shared().threads
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.0.as_ref().map_or(1, ThreadPool::current_num_threads)
    }

    /// Does work whose parts stay on these threads: that of others does not wait behind it.
    pub fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        let cancel = Cancel::current();
        let within = || {
            let _entered = cancel.enter();
            work()
        };
        match &self.0 {
            Some(pool) if rayon::current_thread_index().is_none() => pool.install(within),
            _ => within(),
        }
    }

    /// Does the work of every place, 0 to `count` − 1.
    pub(super) fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        let cancel = Cancel::current();
        let side_by_side = || {
            (0..count)
                .into_par_iter()
                .for_each_init(|| cancel.enter(), |_entered, i| work(i))
        };
        match &self.0 {
            _ if rayon::current_thread_index().is_some() => side_by_side(),
            Some(pool) => pool.install(side_by_side),
            None => (0..count).for_each(work),
        }
    }

    /// Works on every item and hands each result to `take` on the calling thread as it comes, in no
    /// order; `None` where nothing came for a while.
    pub fn for_each<T: Sync, R: Send>(
        &self,
        items: &[T],
        work: impl Fn(&T) -> R + Sync,
        mut take: impl FnMut(Option<R>),
    ) {
        // A thread of a pool must not wait for its own pool.
        let Some(pool) = self
            .0
            .as_ref()
            .filter(|_| rayon::current_thread_index().is_none())
        else {
            return items.iter().for_each(|item| take(Some(work(item))));
        };
        let (sender, receiver) = sync_channel(4 * pool.current_num_threads());
        let cancel = Cancel::current();
        pool.in_place_scope(|scope| {
            let work = &work;
            let cancel = &cancel;
            scope.spawn(move |_| {
                let give = |sender: &mut SyncSender<R>, item: &T| {
                    let _entered = cancel.enter();
                    // Nobody listens any more only where `take` panicked.
                    drop(sender.send(work(item)));
                };
                items.par_iter().with_max_len(1).for_each_with(sender, give);
            });
            loop {
                match receiver.recv_timeout(TICK) {
                    Ok(done) => take(Some(done)),
                    Err(RecvTimeoutError::Timeout) => take(None),
                    Err(RecvTimeoutError::Disconnected) => break,
                }
            }
        });
    }
}

/// A sentence where the process has fewer threads than it wanted; `None` also before any work.
pub fn shortage() -> Option<String> {
    let mut known = SHARED.get()?;
    while known.process != process() {
        known = known.of_child.get()?;
    }
    known
        .refused
        .as_ref()
        .map(|e| format!("{e}; the work is done by {}", known.threads.count()))
}

/// The threads of a process. One that was forked off has a copy of this, and none of the threads:
/// it gets its own.
struct Shared {
    process: u32,
    threads: Threads,
    refused: Option<ThreadsError>,
    of_child: OnceLock<Box<Shared>>,
}

static SHARED: OnceLock<Shared> = OnceLock::new();

/// The process, where one can be forked.
fn process() -> u32 {
    if cfg!(unix) { std::process::id() } else { 0 }
}

fn shared() -> &'static Shared {
    let mut known = SHARED.get_or_init(Shared::new);
    while known.process != process() {
        known = known.of_child.get_or_init(|| Box::new(Shared::new()));
    }
    known
}

impl Shared {
    fn new() -> Self {
        let cores = std::thread::available_parallelism().map_or(1, NonZero::get);
        let (threads, refused) = match pool(wanted(cores)) {
            Ok(pool) => (Threads(Some(pool)), None),
            Err(error) => {
                let fewer =
                    std::iter::successors(Some(cores / 2), |n| Some(n / 2)).take_while(|n| *n > 1);
                (Threads(fewer.map(pool).find_map(Result::ok)), Some(error))
            }
        };
        Self {
            process: process(),
            threads,
            refused,
            of_child: OnceLock::new(),
        }
    }
}

/// What the environment says, up to a number that is of use; none where it says nothing.
fn wanted(cores: usize) -> usize {
    std::env::var("RAYON_NUM_THREADS")
        .ok()
        .and_then(|text| text.trim().parse::<usize>().ok())
        .map_or(0, |count| at_most(count, cores))
}

fn at_most(count: usize, cores: usize) -> usize {
    count.min((4 * cores).max(64))
}

/// So many threads; none: as many as the environment or the cores say.
fn pool(count: usize) -> Result<ThreadPool, ThreadsError> {
    ThreadPoolBuilder::new()
        .num_threads(count)
        .build()
        .map_err(|e| ThreadsError(e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::threads;
    use std::panic::AssertUnwindSafe;

    /// 0², 1², …, 99², however many threads there are.
    #[test]
    fn results_are_the_same_on_any_number_of_threads() {
        let items: Vec<u64> = (0..100).collect();
        let squares: Vec<u64> = items.iter().map(|i| i * i).collect();
        for count in [0, 1, 2, 7] {
            let threads = Threads::new(count).unwrap();
            assert_eq!(threads.map(&items, |i| i * i), squares, "{count}");
            let mut taken = vec![];
            threads.for_each(&items, |i| i * i, |square| taken.extend(square));
            taken.sort_unstable();
            assert_eq!(taken, squares, "{count}");
            let mut filled = vec![0; 100];
            threads.fill(&mut filled, 7, |from, part| {
                part.iter_mut()
                    .zip(from as u64..)
                    .for_each(|(place, i)| *place = i * i);
            });
            assert_eq!(filled, squares, "{count}");
        }
    }

    #[test]
    fn threads_that_are_of_no_use_are_not_started() {
        assert_eq!(
            [at_most(5000, 2), at_most(5000, 96), at_most(7, 2)],
            [64, 384, 7]
        );
    }

    #[test]
    fn work_within_threads_stays_there() {
        let threads = Threads::new(2).unwrap();
        let count = || threads::map(&[1, 2, 3], |_| rayon::current_num_threads());
        assert_eq!(threads.within(count), [2, 2, 2]);
    }

    /// One pool used from its only thread would wait for itself.
    #[test]
    fn work_inside_of_work_ends() {
        let pool = pool(1).unwrap();
        let threads = Threads(Some(pool));
        let inner = |_: &u64| {
            let mut sum = 0;
            threads.for_each(&[1_u64, 2, 3], |i| *i, |i| sum += i.unwrap_or(0));
            sum + threads.map(&[4_u64, 5], |i| *i).iter().sum::<u64>()
        };
        assert_eq!(threads.map(&[0], inner), [15]);
    }

    #[test]
    fn a_panic_of_a_thread_reaches_the_caller() {
        let threads = Threads::new(2).unwrap();
        let work = |i: &u64| assert!(*i != 3);
        let all = AssertUnwindSafe(|| threads.for_each(&[1, 2, 3, 4], work, |_| {}));
        assert!(std::panic::catch_unwind(all).is_err());
    }
}
