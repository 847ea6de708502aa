//! `validate`: verification against exact values, validation against measured muscles, and a sweep of random muscles.

use crate::{Model, Result};
use mckibben::{joint, muscle::Muscle, progress::Progress, size, threads, verification::VerificationRow};
use mckibben_campaign::fit::held_out;
use mckibben_fem::axisymmetric::sweep::{Sweep, SweepRow, question};
use mckibben_fem::verification;
use mckibben_fit::validation;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The cases.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ValidateRequest {
    /// The finest meshes as well; some seconds more.
    pub all: bool,
}

/// The table of cases.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ValidateAnswer {
    /// The cases.
    pub cases: Vec<VerificationRow>,
}

impl ValidateAnswer {
    /// Whether every case holds.
    pub fn ok(&self) -> bool {
        self.cases.iter().all(|case| case.ok)
    }
}

/// Every case of verification and validation.
pub fn validate(request: &ValidateRequest, progress: &dyn Progress) -> Result<ValidateAnswer> {
    let mut rows = verification::cases(progress)?;
    if request.all {
        rows.extend(verification::bricks::cook_fine());
    }
    rows.extend(joint::verification::cases());
    rows.extend(mckibben_motion::verification::cases());
    rows.extend(held_out::cases());
    rows.extend(validation::cases(&|muscle: &Muscle| Model::FE.build(muscle), progress)?);
    Ok(ValidateAnswer { cases: rows })
}

/// Random muscles, one point each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SweepRequest {
    /// How many.
    pub muscles: usize,
    /// Seed of the random numbers.
    #[serde(default = "one")]
    pub seed: u64,
}

fn one() -> u64 {
    1
}

/// The share of points with an answer. It does not depend on the machine.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SweepAnswer {
    /// How many muscles.
    pub muscles: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Points that must have an answer: the infinitely long muscle pulls and its strands stretch by less than 5 %.
    pub required: usize,
    /// How many of them have one.
    pub required_answered: usize,
    /// The other points.
    pub others: usize,
    /// How many of them have an answer.
    pub others_answered: usize,
    /// Largest number of factorisations of a point.
    pub most_factorisations: usize,
    /// Reasons why required points have no answer.
    pub unanswered: Vec<String>,
    /// The sweep itself, with its times.
    #[serde(skip)]
    pub sweep: Sweep,
}

impl SweepAnswer {
    /// Whether at least 99.9 % of what must have an answer has one.
    pub fn ok(&self) -> bool {
        1000 * self.required_answered >= 999 * self.required
    }
}

/// Asks random muscles one question each, on all cores.
pub fn sweep(request: &SweepRequest, progress: &dyn Progress) -> Result<SweepAnswer> {
    size::points("muscles", request.muscles as f64)?;
    let done = AtomicUsize::new(0);
    let one = |&i: &usize| {
        if progress.cancelled() {
            return None;
        }
        let row = question(request.seed, i);
        progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, request.muscles);
        row
    };
    let numbers: Vec<usize> = (0..request.muscles).collect();
    let rows: Vec<SweepRow> = threads::map(&numbers, one).into_iter().flatten().collect();
    progress.check()?;
    let sweep = Sweep { rows };
    let ((required_answered, required), (others_answered, others)) =
        (sweep.answered(true), sweep.answered(false));
    let unanswered = sweep.rows.iter().filter(|r| r.required).filter_map(|r| r.answer.as_ref().err());
    Ok(SweepAnswer {
        muscles: sweep.rows.len(),
        seed: request.seed,
        required,
        required_answered,
        others,
        others_answered,
        most_factorisations: sweep.most_factorisations(),
        unanswered: unanswered.cloned().collect(),
        sweep,
    })
}
