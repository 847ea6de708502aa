//! `fit --report`: the paper's campaign computed anew, and how everything compares.

use crate::problem::{Problem, ProblemKind};
use mckibben::progress::Progress;
use mckibben_campaign::fit::FitError;
use mckibben_campaign::fit::results::{Results, paper_formula, results};
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
    /// Seconds from nothing to the paper's formula with its errors, where there is a clock.
    #[serde(rename = "seconds_to_the_papers_formula", skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

impl FitReportAnswer {
    /// Whether every goal is met.
    pub fn ok(&self) -> bool {
        self.results.findings.iter().all(|f| f.ok)
    }
}

/// Computes the paper's campaign, the formulas of it, and their errors.
pub fn fit_report(_: &FitReportRequest, progress: &dyn Progress) -> Result<FitReportAnswer, Problem> {
    // Without an operating system there may be no clock.
    #[cfg(feature = "files")]
    let start = std::time::Instant::now();
    let ours = paper_formula()?;
    #[cfg(feature = "files")]
    let seconds = Some(start.elapsed().as_secs_f64());
    #[cfg(not(feature = "files"))]
    let seconds = None;
    Ok(FitReportAnswer { results: results(&ours, progress)?, seconds })
}

impl From<FitError> for Problem {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Cancelled(cancelled) => cancelled.into(),
            error => Self::new(ProblemKind::Fit, error.to_string(), ""),
        }
    }
}
