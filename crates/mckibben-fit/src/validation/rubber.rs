//! The validation report of a measured rubber: the errors of each law at the stresses it was fitted
//! to and at those it predicts.

use super::{
    case::{Points, RubberCase},
    report::ReportError,
};
use crate::rubber::{Parameter, StressErrors};
use mckibben_core::progress::Progress;
use serde::Serialize;

/// Every fit of rubbers.
pub fn report(
    cases: &[&RubberCase],
    progress: &dyn Progress,
) -> Result<Vec<RubberFit>, ReportError> {
    let mut out = vec![];
    for (number, case) in cases.iter().enumerate() {
        for fit in &case.fits {
            progress.check()?;
            let result = match &case.points {
                Points::Tests(points) => fit.to_tests(points, progress),
                Points::History(points) => fit.to_history(points, progress),
            };
            let result = result.map_err(|error| {
                ReportError::Rubber(format!("{}, fit \"{}\"", case.facts.name, fit.name), error)
            })?;
            out.push(RubberFit {
                case: number,
                fit: fit.name.clone(),
                law: fit.form.name(),
                ..result
            });
        }
    }
    Ok(out)
}

/// A law that was fitted, with its constants and errors.
#[derive(Debug, Clone, Default, Serialize, schemars::JsonSchema)]
#[schemars(rename = "MeasuredRubberFit")]
pub struct RubberFit {
    /// Number of the case.
    #[serde(skip)]
    pub case: usize,
    /// Its name.
    pub fit: String,
    /// The law.
    pub law: String,
    /// Its constants, with a Prony series those at once.
    pub parameters: Vec<Parameter>,
    /// Shares and time constants in s of the Prony series, where one was fitted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub prony: Vec<(f64, f64)>,
    /// Whether the law is stable in a muscle.
    pub stable: bool,
    /// Errors, group by group: fitted points before those that are predicted.
    #[serde(skip)]
    pub groups: Vec<RubberGroup>,
}

/// Errors at some nominal stresses: measured less computed.
#[derive(Debug, Clone, Serialize, schemars::JsonSchema)]
pub struct RubberGroup {
    /// The points that are compared: a mode, a mode `further` than the law was fitted, or a branch
    /// of a test over time.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    #[serde(flatten)]
    pub errors: StressErrors,
}

#[cfg(test)]
mod tests {
    use super::{
        super::{built_in::measurements, case::Measurement},
        *,
    };
    use mckibben_core::progress::Silent;

    /// Every fit of every rubber that is built in has an answer; a fit to some modes predicts the
    /// others.
    #[test]
    fn every_rubber_that_is_built_in_is_fitted() {
        let all = measurements().unwrap().iter();
        let cases: Vec<_> = all.filter_map(Measurement::rubber).collect();
        let results = report(&cases, &Silent).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(
            results.len(),
            cases.iter().map(|c| c.fits.len()).sum::<usize>()
        );
        for r in &results {
            let name = format!("{} {}", cases[r.case].facts.name, r.fit);
            assert!(
                r.groups.iter().any(|g| !g.blind && g.errors.points > 5),
                "{name}"
            );
            let fit = cases[r.case].fits.iter().find(|f| f.name == r.fit).unwrap();
            assert!(
                fit.modes.is_empty() || r.groups.iter().any(|g| g.blind),
                "{name}"
            );
        }
    }
}
