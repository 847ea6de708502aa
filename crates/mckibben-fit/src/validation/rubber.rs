//! The validation report of a measured rubber: the errors of each law at the stresses it was fitted
//! to and at those it predicts.

use super::{
    case::{CaseError, Facts},
    report::ReportError,
};
use crate::{
    rubber::{Form, Mode, Parameter, StressErrors, TensionPoint, read_tests},
    rubber_over_time::{self, TimePoint, read_history},
};
use mckibben::progress::Progress;
use mckibben_io::table::Columns;
use serde::{Deserialize, Serialize};

/// A measured rubber, and which laws are fitted to it.
#[derive(Debug, Clone)]
pub struct RubberCase {
    /// What is known of it.
    pub facts: Facts,
    pub fits: Vec<RubberCaseFit>,
    points: Points,
}

#[derive(Debug, Clone)]
enum Points {
    Tests(Vec<TensionPoint>),
    /// One specimen over time, with loading and unloading.
    History(Vec<TimePoint>),
}

impl RubberCase {
    /// Reads the points: those of a test over time where a fit wants its relaxation.
    pub(super) fn new(
        facts: Facts,
        points: &str,
        fits: Vec<RubberCaseFit>,
    ) -> Result<Self, CaseError> {
        let points = if fits.iter().any(|f| f.relaxation.is_some()) {
            read_history(points, &Columns::default()).map(Points::History)
        } else {
            read_tests(points, &Columns::default()).map(|read| Points::Tests(read.0))
        };
        Ok(Self {
            points: points.map_err(|error| CaseError::Points(facts.name.clone(), error))?,
            facts,
            fits,
        })
    }

    /// How many points there are.
    pub fn count(&self) -> usize {
        match &self.points {
            Points::Tests(list) => list.len(),
            Points::History(list) => list.len(),
        }
    }

    fn run(
        &self,
        fit: &RubberCaseFit,
        progress: &dyn Progress,
    ) -> rubber_over_time::Result<RubberFit> {
        match &self.points {
            Points::Tests(points) => fit.to_tests(points, progress),
            Points::History(points) => fit.to_history(points, progress),
        }
    }
}

/// Every fit of rubbers.
pub fn report(
    cases: &[&RubberCase],
    progress: &dyn Progress,
) -> Result<Vec<RubberFit>, ReportError> {
    let mut out = vec![];
    for (number, case) in cases.iter().enumerate() {
        for fit in &case.fits {
            progress.check()?;
            let result = case.run(fit, progress).map_err(|error| {
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

/// A law, and which points it is fitted to.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RubberCaseFit {
    pub name: String,
    #[serde(rename = "law")]
    pub form: Form,
    /// Modes that are fitted, all where none is named; the others are blind.
    #[serde(default)]
    pub modes: Vec<Mode>,
    /// Stretch up to which it is fitted; what is stretched further is blind.
    pub up_to_stretch: Option<f64>,
    /// Branches of a Prony series beside it, of a test over time.
    pub relaxation: Option<usize>,
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
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
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
    use super::super::case::rubbers;
    use super::*;
    use mckibben::progress::Silent;

    /// Every fit of every rubber that is built in has an answer; a fit to some modes predicts the
    /// others.
    #[test]
    fn every_rubber_that_is_built_in_is_fitted() {
        let cases = rubbers().unwrap();
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
