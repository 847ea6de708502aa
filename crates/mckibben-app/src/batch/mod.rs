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
    AskFields, Model, PressureLimits, Problem, ProblemKind, Result, burst_of, finite, ratio,
};
use mckibben::fit::GradientError;
use mckibben_core::{
    analysis::{Burst, Evaluation},
    answer::{Answer, Options},
    built::measured_up_to_mpa,
    model::{ForceModel, ModelInfo, ModelKind, Workspace},
    muscle::Muscle,
    progress::Progress,
    threads::{self, Threads},
    warning::Warning,
};
use mckibben_fit::identify::Target;
use serde::Deserialize;
use std::{
    collections::BTreeMap,
    sync::{
        Mutex, OnceLock, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};

/// The quantity that follows from each pair of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PointQuantity {
    /// F in N, of P in MPa and ε.
    #[default]
    Force,
    /// P in MPa, of F in N and ε.
    Pressure,
    /// ε, of F in N and P in MPa.
    Contraction,
}

/// How many points are answered.
#[derive(Debug, Default)]
pub struct Many {
    /// What is asked of each pair.
    pub wanted: PointQuantity,
    /// Also the derivatives by both numbers of a pair.
    pub slopes: bool,
    /// Also the derivatives by these constants and measures of the muscle, all others held.
    pub parameters: Vec<Target>,
    /// The numbers of a point without an answer are NaN; else the first one ends the work with its
    /// reason.
    pub nan: bool,
    /// Also what is to be said of the points.
    pub warnings: bool,
}

impl Many {
    /// Numbers of a point in the output: the answer, then the derivatives.
    pub fn width(&self) -> usize {
        1 + 2 * usize::from(self.slopes) + self.parameters.len()
    }
}

/// Why a list has no answer: the point that has none, and its reason.
#[derive(Debug, PartialEq)]
pub struct ArrayError {
    /// The point's place in the list, from 0; none where the list itself is at fault.
    pub index: Option<usize>,
    /// Why it has no answer.
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
    /// What computes the pulls.
    pub model: Box<dyn ForceModel>,
    /// Friction and branch that answers take.
    pub options: Options,
    /// The model by its name.
    pub choice: Model,
    quiet: OnceLock<Quiet>,
}

/// By what the pressures of a muscle are judged; and pressure in MPa and contraction up to which
/// nothing is to be said of it.
type Quiet = (Burst, (f64, f64));

impl BoundModel {
    /// The model of this muscle, and how it is asked.
    pub fn new(muscle: &Muscle, choice: Model, asking: AskFields) -> Result<Self> {
        Ok(Self {
            options: asking.options(muscle)?,
            model: choice.build(muscle)?,
            choice,
            quiet: OnceLock::new(),
        })
    }

    /// The muscle of the model.
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
            let answer = self.point(&burst, &mut Workspace::new(), p, e)?;
            progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, points.len());
            Ok(answer)
        };
        let answers = threads::map(points, answer);
        progress.check().map_err(Problem::from)?;
        Ok(answers)
    }

    /// Up to where nothing is to be said of the muscle; with finite elements of the infinitely long
    /// muscle.
    fn quiet(&self) -> Result<Quiet> {
        if let Some(known) = self.quiet.get() {
            return Ok(*known);
        }
        let burst = burst_of(&self.choice, &*self.model)?;
        let highest_mpa = burst
            .allowed()
            .map_or(f64::INFINITY, |allowed| allowed.mpa)
            .min(measured_up_to_mpa(self.muscle()))
            .min(self.info().range.pressure_mpa.1);
        let model = if self.is_elements() {
            ModelKind::ThickWall.build(self.muscle())
        } else {
            self.choice.build(self.muscle())
        }?;
        let workspace = &mut Workspace::new();
        let mut is_quiet = |p: f64, e: f64| {
            let answer = Evaluation::new(&*model, workspace, self.options).point(p, e);
            burst.warnings(p).iter().all(Warning::is_of_muscle)
                && answer.map_or(true, |a| a.warnings.iter().all(Warning::is_of_muscle))
        };
        let quiet = [1.0, 0.5, 0.25].into_iter().find_map(|share| {
            let p = share * highest_mpa;
            let e = [0.0, 0.1, 0.2, 0.25, 0.3, 0.35]
                .into_iter()
                .take_while(|e| is_quiet(p, *e))
                .last()?;
            (e > 0.1).then_some((p, e))
        });
        Ok(*self
            .quiet
            .get_or_init(|| (burst, quiet.unwrap_or_default())))
    }

    /// Whether a point takes finite elements, and so about a million times as long as a formula.
    pub fn is_elements(&self) -> bool {
        self.choice.is_elements()
    }

    /// Whether so many numbers take some tenths of a second at most.
    pub fn is_moment(&self, numbers: usize) -> bool {
        !self.is_elements() && numbers <= 500
    }

    /// The constant or measure of a name, as the muscle file has it.
    pub fn parameter(&self, name: &str) -> Result<Target> {
        Ok(Target::parse(name, self.muscle()).map_err(GradientError::from)?)
    }

    /// Answers every pair, each into its [`Many::width`] places of `out`, on the threads of the
    /// process; returns what is to be said of them, of each kind the gravest. Neither depends on
    /// the number of threads.
    pub fn fill(
        &self,
        pairs: [&[f64]; 2],
        many: &Many,
        out: &mut [f64],
        progress: &dyn Progress,
    ) -> Result<Vec<Warning>, ArrayError> {
        let (width, [count, other]) = (many.width(), pairs.map(<[f64]>::len));
        if count != other || count.checked_mul(width) != Some(out.len()) {
            return Err(ProblemKind::Usage
                .problem(format!(
                    "{count} and {other} numbers for {} places of {width}",
                    out.len()
                ))
                .into());
        }
        let quiet = many.warnings.then(|| self.quiet()).transpose()?;
        let share = if self.is_elements() {
            BLOCK_OF_ELEMENTS
        } else {
            BLOCK
        };
        let done = AtomicUsize::new(0);
        let first_failed = AtomicUsize::new(usize::MAX);
        let found = Mutex::new(BTreeMap::new());
        let work = |place: usize, places: &mut [f64]| {
            let from = place / width;
            let length = places.len() / width;
            // Points behind one without an answer are left out.
            if first_failed.load(Ordering::Relaxed) < from || progress.cancelled() {
                return;
            }
            let block = self.block(
                (
                    from,
                    pairs.map(|list| list.get(from..from + length).unwrap_or_default()),
                ),
                many,
                quiet,
                places,
            );
            if block.is_err() {
                first_failed.fetch_min(from, Ordering::Relaxed);
            }
            // Whoever panicked with it left it whole.
            let found = found.lock();
            found
                .unwrap_or_else(PoisonError::into_inner)
                .insert(from, block);
            progress.report(done.fetch_add(length, Ordering::Relaxed) + length, count);
        };
        // A look at the threads of the process takes as long as some hundred points.
        if out.len() <= share * width {
            work(0, out)
        } else {
            Threads::shared().fill(out, share * width, work)
        }
        progress.check().map_err(Problem::from)?;
        let said = found
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner)
            .into_values()
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Warning::gravest(said.iter().flatten()))
    }
}
