//! `fit --report`: the paper's campaign computed anew, and how everything compares.

use crate::problem::{Problem, ProblemKind};
use mckibben::progress::Progress;
use mckibben_campaign::fit::FitError;
use mckibben_campaign::fit::results::{Results, results};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The paper's campaign computed anew.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct FitReportRequest {}

/// How everything compares.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FitReportAnswer {
    /// Comparisons, constants, and models on random muscles.
    #[serde(flatten)]
    pub results: Results,
}

impl FitReportAnswer {
    /// Whether every goal is met.
    pub fn ok(&self) -> bool {
        self.results.findings.iter().all(|f| f.ok)
    }
}

/// Computes the paper's campaign, the formulas of it, and their errors.
pub fn fit_report(_: &FitReportRequest, progress: &dyn Progress) -> Result<FitReportAnswer, Problem> {
    Ok(FitReportAnswer { results: results(progress)? })
}

impl From<FitError> for Problem {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Cancelled(cancelled) => cancelled.into(),
            error => Self::new(ProblemKind::Fit, error.to_string(), ""),
        }
    }
}
