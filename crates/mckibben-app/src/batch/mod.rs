//! A model bound to its muscle and evaluated at many points, for front ends that hold arrays of
//! numbers.
//!
//! A request in JSON is one question; here the same question is put to lists of numbers, without
//! text on the way: F(P, ε), or its inverses P(F, ε) and ε(F, P), with the derivatives that the
//! model has ([`slopes`]). What a point answers is what [`force`](crate::force),
//! [`pressure`](crate::pressure) and [`contraction`](crate::contraction) answer for it: the range
//! is checked, a muscle that would have to push is slack.

mod point;
pub use point::with_parameters;

use crate::{
    AskFields, Model, PressureLimits, Problem, ProblemKind, QUIET_MPA, Result, burst_of,
    check_branch, finite, ratio,
};
use mckibben::gradient;
use mckibben_core::{
    analysis::Evaluation,
    answer::{Answer, Options},
    model::{ForceModel, ModelInfo, Reference, Workspace},
    muscle::Muscle,
    progress::Progress,
    threads::{self, Threads},
    warning::Warning,
};
use mckibben_fit::identify::Target;
use std::sync::{
    Mutex, PoisonError,
    atomic::{AtomicUsize, Ordering},
};

/// The quantity that follows from each pair of numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointQuantity {
    /// F in N, of P in MPa and ε.
    Force,
    /// P in MPa, of F in N and ε.
    Pressure,
    /// ε, of F in N and P in MPa.
    Contraction,
}

/// How many points are answered.
#[derive(Debug)]
pub struct Many {
    pub wanted: PointQuantity,
    /// Also the derivatives by both numbers of a pair.
    pub slopes: bool,
    /// Also the derivatives by these constants and measures of the muscle, all others held.
    pub parameters: Vec<Target>,
    /// The numbers of a point without an answer are NaN; else the first one ends the work with its
    /// reason.
    pub nan: bool,
}

impl Many {
    /// Numbers of a point in the output: the answer, then the derivatives.
    pub fn width(&self) -> usize {
        1 + if self.slopes { 2 } else { 0 } + self.parameters.len()
    }
}

/// Why a list has no answer: the point that has none, and its reason.
#[derive(Debug, PartialEq)]
pub struct ArrayError {
    /// The point's place in the list, from 0; none where the list itself is at fault.
    pub index: Option<usize>,
    pub problem: Problem,
}

impl From<Problem> for ArrayError {
    fn from(problem: Problem) -> Self {
        Self {
            index: None,
            problem,
        }
    }
}

/// Points of a closed form that are worked on together: their lists lie in the first cache.
const BLOCK: usize = 1024;
/// Points of finite elements that one thread takes.
const BLOCK_OF_ELEMENTS: usize = 32;

/// A model bound to its muscle.
pub struct BoundModel {
    pub(crate) model: Box<dyn ForceModel>,
    pub(crate) options: Options,
    pub(crate) choice: Model,
}

impl BoundModel {
    /// The model of this muscle, and how it is asked.
    pub fn new(muscle: &Muscle, choice: Model, asking: AskFields) -> Result<Self> {
        let mut options = asking.options(muscle)?;
        let model = choice.bound(muscle)?;
        if matches!(model.info().accuracy.reference, Reference::ForceMap(_)) {
            options.friction_share = 0.0;
            check_branch(options, muscle)?;
        }
        Ok(Self {
            model,
            options,
            choice,
        })
    }

    pub fn muscle(&self) -> &Muscle {
        self.model.muscle()
    }

    /// What the model is.
    pub fn info(&self) -> &ModelInfo {
        self.model.info()
    }

    /// The pressures that the muscle bears.
    pub fn limits(&self) -> Result<PressureLimits> {
        Ok((&burst_of(&self.choice, &*self.model)?).into())
    }

    /// All that is known of points of P in MPa and ε but P′, each as [`force`](crate::force)
    /// answers it, on the threads of the process.
    pub fn answers(
        &self,
        points: &[(f64, f64)],
        progress: &dyn Progress,
    ) -> Result<Vec<Result<Answer>>> {
        let burst = burst_of(&self.choice, &*self.model)?;
        let done = AtomicUsize::new(0);
        let answer = |&(p, e): &(f64, f64)| {
            let p = finite("pressure_mpa", p)?;
            let e = ratio(e)?;
            let workspace = &mut Workspace::new();
            let mut answer = Evaluation::new(&*self.model, workspace, self.options).point(p, e)?;
            Warning::put_first(&mut answer.warnings, burst.warnings(p, QUIET_MPA));
            progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, points.len());
            Ok(answer)
        };
        let answers = threads::map(points, answer);
        progress.check().map_err(Problem::from)?;
        Ok(answers)
    }

    /// Whether a point takes finite elements, and so about a million times as long as a formula.
    pub fn is_elements(&self) -> bool {
        matches!(self.choice, Model::Elements(_))
    }

    /// Whether so many numbers take some hundredths of a second at most: no progress is reported.
    pub fn is_moment(&self, numbers: usize) -> bool {
        !self.is_elements() && numbers <= 20_000
    }

    /// The constant or measure of a name, as the muscle file has it.
    pub fn parameter(&self, name: &str) -> Result<Target> {
        Ok(gradient::parameter(self.muscle(), name)?)
    }

    /// Answers every pair, each into its [`Many::width`] places of `out`, on the threads of the
    /// process; returns how many have no answer. The numbers do not depend on the number of
    /// threads.
    pub fn fill(
        &self,
        pairs: [&[f64]; 2],
        many: &Many,
        out: &mut [f64],
        progress: &dyn Progress,
    ) -> Result<usize, ArrayError> {
        let (width, [count, other]) = (many.width(), pairs.map(<[f64]>::len));
        if count != other || count.checked_mul(width) != Some(out.len()) {
            let places = out.len();
            let message = format!("{count} and {other} numbers for {places} places of {width}");
            return Err(ProblemKind::Usage.problem(message).into());
        }
        let share = if self.is_elements() {
            BLOCK_OF_ELEMENTS
        } else {
            BLOCK
        };
        let done = AtomicUsize::new(0);
        let failed = AtomicUsize::new(0);
        let reason: Mutex<Option<(usize, Problem)>> = Mutex::new(None);
        // Whoever panicked with it left it whole.
        let reason = || reason.lock().unwrap_or_else(PoisonError::into_inner);
        let work = |place: usize, part: &mut [f64]| {
            for (i, places) in part.chunks_mut(BLOCK * width).enumerate() {
                let from = place / width + i * BLOCK;
                let length = places.len() / width;
                // Points behind one without an answer are left out.
                if reason().as_ref().is_some_and(|(first, _)| *first < from) || progress.cancelled()
                {
                    return;
                }
                let pairs = pairs.map(|list| list.get(from..from + length).unwrap_or_default());
                match self.block(pairs, many, places) {
                    Ok(count) => drop(failed.fetch_add(count, Ordering::Relaxed)),
                    Err((index, problem)) => {
                        let mut first = reason();
                        if first
                            .as_ref()
                            .is_none_or(|(known, _)| *known > from + index)
                        {
                            *first = Some((from + index, problem));
                        }
                        return;
                    }
                }
                progress.report(done.fetch_add(length, Ordering::Relaxed) + length, count);
            }
        };
        // A look at the threads of the process takes as long as some hundred points.
        if out.len() <= share * width {
            work(0, out)
        } else {
            Threads::shared().fill(out, share * width, work)
        }
        progress.check().map_err(Problem::from)?;
        match reason().take() {
            Some((index, problem)) => Err(ArrayError {
                index: Some(index),
                problem,
            }),
            None => Ok(failed.into_inner()),
        }
    }
}
