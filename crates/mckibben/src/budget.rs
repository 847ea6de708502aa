//! What one request may cost, and the wish to end it.
//!
//! A request that would not fit is refused before anything is allocated, with an estimate and the limit's name; one that turns out to be
//! longer ends inside of the solver. A front end makes a [`Budget`] for each request, [enters](Budget::enter) it for the time of the work,
//! and hands it over with its [`Progress`](crate::progress::Progress). Work side by side ([`crate::threads`]) takes it along, and every
//! [`Workspace`](crate::model::Workspace) made meanwhile has it: whatever a command does, its budget ends it.

use crate::units::MAX_POINTS;
use std::cell::RefCell;
use std::fmt;
use std::marker::PhantomData;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use thiserror::Error;

/// What is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Resource {
    /// Points of curves, tests and plans that are held at once.
    Points,
    /// Finite elements of a mesh.
    Elements,
    /// Memory in bytes.
    Bytes,
    /// Tangents that are assembled and factorised.
    Factorisations,
    /// Time in seconds.
    Seconds,
}

impl Resource {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Points, Self::Elements, Self::Bytes, Self::Factorisations, Self::Seconds];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Elements => "elements",
            Self::Bytes => "bytes",
            Self::Factorisations => "factorisations",
            Self::Seconds => "seconds",
        }
    }
}

impl fmt::Display for Resource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The limits of a request; what is left out is not limited.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Points that are held at once.
    pub points: f64,
    /// Finite elements of a mesh.
    pub elements: f64,
    /// Memory in bytes.
    pub bytes: f64,
    /// Tangents that are assembled and factorised.
    pub factorisations: f64,
    /// Time in seconds.
    pub seconds: f64,
}

impl Default for Limits {
    /// A million points, 250,000 elements, 4 GB; work and time are not limited.
    fn default() -> Self {
        Self {
            points: MAX_POINTS as f64,
            elements: 250e3,
            bytes: 4e9,
            factorisations: f64::INFINITY,
            seconds: f64::INFINITY,
        }
    }
}

impl Limits {
    /// One of them.
    pub fn of(&self, resource: Resource) -> f64 {
        match resource {
            Resource::Points => self.points,
            Resource::Elements => self.elements,
            Resource::Bytes => self.bytes,
            Resource::Factorisations => self.factorisations,
            Resource::Seconds => self.seconds,
        }
    }

    /// The same with another limit.
    pub fn with(mut self, resource: Resource, limit: f64) -> Self {
        match resource {
            Resource::Points => self.points = limit,
            Resource::Elements => self.elements = limit,
            Resource::Bytes => self.bytes = limit,
            Resource::Factorisations => self.factorisations = limit,
            Resource::Seconds => self.seconds = limit,
        }
        self
    }
}

/// Why a request is not answered, or not to its end.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Exceeded {
    /// It would take more than its budget allows.
    #[error("this takes about {} {resource}, and the limit is {}", amount(*.estimate), amount(*.limit))]
    Estimate {
        /// Of what.
        resource: Resource,
        /// What it would take.
        estimate: f64,
        /// The limit.
        limit: f64,
    },
    /// The budget was used up on the way.
    #[error("the limit of {} {resource} is used up", amount(*.limit))]
    Spent {
        /// Of what.
        resource: Resource,
        /// The limit.
        limit: f64,
    },
    /// The caller wanted the work to end.
    #[error("cancelled before the end")]
    Cancelled,
}

/// A number with its thousands: 8 388 608, 1.5, 4e9 as 4 000 000 000.
fn amount(value: f64) -> String {
    if value < 10.0 {
        return format!("{value:.2}").trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    let digits = format!("{value:.0}");
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|c| std::str::from_utf8(c).ok()).collect();
    groups.join(" ")
}

#[derive(Debug, Default)]
struct Spending {
    factorisations: AtomicU64,
    cancelled: AtomicBool,
    /// Whether a limit stopped the work: 1 + the place of the resource.
    stopped: AtomicU64,
}

/// What is left of the limits of one request. Copies share it.
#[derive(Debug, Clone, Default)]
pub struct Budget {
    limits: Limits,
    /// The end, where time is limited: only then a clock is looked at.
    until: Option<Instant>,
    spending: Arc<Spending>,
}

impl Budget {
    /// A budget that begins now.
    pub fn new(limits: Limits) -> Self {
        let until = limits.seconds.is_finite().then(|| {
            let seconds = limits.seconds.clamp(0.0, 1e9);
            Instant::now() + Duration::from_secs_f64(seconds)
        });
        Self { limits, until, spending: Arc::default() }
    }

    /// Its limits.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Ends the work at the next factorisation or point.
    pub fn cancel(&self) {
        self.spending.cancelled.store(true, Ordering::Relaxed);
    }

    /// Refuses what would not fit, before it is begun.
    pub fn admit(&self, resource: Resource, estimate: f64) -> Result<(), Exceeded> {
        let limit = self.limits.of(resource);
        if estimate <= limit { Ok(()) } else { Err(Exceeded::Estimate { resource, estimate, limit }) }
    }

    /// The budget of the work that this thread does: the one that was entered last, else one with the usual limits.
    pub fn current() -> Self {
        CURRENT.with_borrow(Clone::clone).unwrap_or_default()
    }

    /// Makes this the budget of the work that this thread does, until what is returned is dropped.
    #[must_use = "the budget is left where this is dropped"]
    pub fn enter(&self) -> Entered {
        let before = CURRENT.replace(Some(self.clone()));
        Entered { before, of_this_thread: PhantomData }
    }

    /// Whether the work may go on.
    pub fn check(&self) -> Result<(), Exceeded> {
        self.ended()?;
        if self.until.is_some_and(|until| Instant::now() >= until) {
            return Err(self.spent(Resource::Seconds));
        }
        Ok(())
    }

    /// Counts a factorisation.
    pub fn factorise(&self) -> Result<(), Exceeded> {
        self.check()?;
        let done = self.spending.factorisations.fetch_add(1, Ordering::Relaxed);
        if (done as f64) < self.limits.factorisations {
            Ok(())
        } else {
            Err(self.spent(Resource::Factorisations))
        }
    }

    /// That the work came to its own end: what came out of work that this budget ended is no answer.
    pub fn ended(&self) -> Result<(), Exceeded> {
        self.exceeded().map_or(Ok(()), Err)
    }

    /// Why the work was ended by this budget, if it was.
    pub fn exceeded(&self) -> Option<Exceeded> {
        if self.spending.cancelled.load(Ordering::Relaxed) {
            return Some(Exceeded::Cancelled);
        }
        let stopped = self.spending.stopped.load(Ordering::Relaxed);
        let resource = Resource::ALL.get((stopped as usize).checked_sub(1)?).copied()?;
        Some(Exceeded::Spent { resource, limit: self.limits.of(resource) })
    }

    fn spent(&self, resource: Resource) -> Exceeded {
        let place = Resource::ALL.iter().position(|r| *r == resource).unwrap_or(0);
        self.spending.stopped.store(1 + place as u64, Ordering::Relaxed);
        Exceeded::Spent { resource, limit: self.limits.of(resource) }
    }
}

thread_local! {
    static CURRENT: RefCell<Option<Budget>> = const { RefCell::new(None) };
}

/// A budget that was entered; where it is dropped, the one before it holds again.
#[derive(Debug)]
pub struct Entered {
    before: Option<Budget>,
    of_this_thread: PhantomData<*const ()>,
}

impl Drop for Entered {
    fn drop(&mut self) {
        CURRENT.set(self.before.take());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Workspace;
    use crate::progress::{Progress, Silent};
    use crate::threads;

    #[test]
    fn a_budget_that_was_entered_is_that_of_workspaces_threads_and_silent_work_until_it_is_left() {
        let budget = Budget::default();
        let ended = || {
            let here = Workspace::new().budget().check().is_err() && Silent.cancelled();
            here && threads::map(&[1, 2, 3], |_| Silent.cancelled()) == [true; 3]
        };
        assert!(!ended());
        {
            let _entered = budget.enter();
            assert!(!ended());
            budget.cancel();
            assert!(ended());
            let _other = Budget::default().enter();
            assert!(!ended());
        }
        assert!(!ended());
    }

    #[test]
    fn what_was_spent_stays_spent() {
        let budget = Budget::new(Limits::default().with(Resource::Factorisations, 0.0));
        assert!(budget.check().is_ok());
        assert!(budget.factorise().is_err() && budget.check().is_err());
    }

    #[test]
    fn what_does_not_fit_is_refused_with_an_estimate_and_the_name_of_the_limit() {
        let budget = Budget::default();
        assert!(budget.admit(Resource::Elements, 1e3).is_ok());
        let refused = budget.admit(Resource::Elements, 8_388_608.0).unwrap_err();
        assert_eq!(refused.to_string(), "this takes about 8 388 608 elements, and the limit is 250 000");
        assert_eq!(budget.exceeded(), None);
    }

    #[test]
    fn work_ends_when_it_is_used_up_or_cancelled_and_copies_know() {
        let budget = Budget::new(Limits::default().with(Resource::Factorisations, 2.0));
        let copy = budget.clone();
        assert!(budget.factorise().is_ok() && copy.factorise().is_ok());
        let spent = Exceeded::Spent { resource: Resource::Factorisations, limit: 2.0 };
        assert_eq!(budget.factorise(), Err(spent));
        assert_eq!(copy.exceeded(), Some(spent));
        assert!(Budget::new(Limits::default().with(Resource::Seconds, 0.0)).check().is_err());
        copy.cancel();
        assert_eq!(budget.check(), Err(Exceeded::Cancelled));
    }
}
