//! The validation report of a measured rubber: the errors of each law at the stresses it was fitted to and at those it predicts.

pub use super::rubber_fit::{RubberCaseFit, RubberFitResult, RubberGroup};

use super::case_error::CaseError;
use super::facts::Facts;
use super::keys::Keys;
use super::report_error::ReportError;
use super::stress::{history, tests};
use crate::rubber::{Form, Mode, ReadOptions, TensionPoint, read_tests};
use crate::rubber_over_time::{OverTimeFitError, TimePoint, read_history};
use mckibben::progress::Progress;
use mckibben_io::table::Columns;
use toml_edit::Item;

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

const FIT: &[&str] = &["name", "law", "modes", "up_to_stretch", "relaxation"];

pub(super) fn fit(table: &Keys<'_>) -> Result<RubberCaseFit, CaseError> {
    table.only(FIT)?;
    let (name, law) = (table.text("name")?, table.text("law")?);
    let forms = Form::parse(&law);
    let [form] = forms[..] else {
        let case = table.case.to_owned();
        return Err(CaseError::Refused(format!(
            "{case}/case.toml, fit \"{name}\": there is no law \"{law}\"; known: {}",
            Form::words().join(", ")
        )));
    };
    let expected = "a list of modes such as [\"uniaxial\"]; the others are blind";
    let modes = match table.table.get("modes") {
        None => vec![],
        Some(item) => {
            let words = item.as_array().map(|list| list.iter().map(|v| Mode::parse(v.as_str()?)));
            words.and_then(Iterator::collect).ok_or_else(|| table.wrong("modes", expected))?
        }
    };
    let branches = table.table.get("relaxation").map(|item: &Item| {
        let n = item.as_integer().and_then(|n| usize::try_from(n).ok()).filter(|n| (1..=8).contains(n));
        n.ok_or_else(|| table.wrong("relaxation", "a number of branches from 1 to 8"))
    });
    let up_to_stretch = table.number("up_to_stretch")?;
    Ok(RubberCaseFit { name, form, modes, up_to_stretch, relaxation: branches.transpose()? })
}

impl RubberCase {
    /// Reads the points: those of a test over time where a fit wants its relaxation.
    pub(super) fn new(facts: Facts, points: &str, fits: Vec<RubberCaseFit>) -> Result<Self, CaseError> {
        let (bytes, columns) = (points.as_bytes(), Columns::default());
        let points = if fits.iter().any(|f| f.relaxation.is_some()) {
            read_history(bytes, &columns).map(Points::History)
        } else {
            read_tests(bytes, ReadOptions::default(), &columns).map(|read| Points::Tests(read.0))
        };
        let points = points.map_err(|error| CaseError::Points { case: facts.name.clone(), error })?;
        Ok(Self { facts, fits, points })
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        match &self.points {
            Points::Tests(list) => list.len(),
            Points::History(list) => list.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn run(&self, fit: &RubberCaseFit, progress: &dyn Progress) -> Result<RubberFitResult, OverTimeFitError> {
        match &self.points {
            Points::Tests(points) => tests(fit, points, progress),
            Points::History(points) => history(fit, points, progress),
        }
    }
}

/// Every fit of rubbers.
pub fn report(cases: &[&RubberCase], progress: &dyn Progress) -> Result<Vec<RubberFitResult>, ReportError> {
    let mut out = vec![];
    for (number, case) in cases.iter().enumerate() {
        for (k, fit) in case.fits.iter().enumerate() {
            progress.check()?;
            let found = case.run(fit, progress).map_err(|error| {
                let (case, fit) = (case.facts.name.clone(), fit.name.clone());
                ReportError::Rubber { case, fit, error }
            })?;
            out.push(RubberFitResult { case: number, fit: k, ..found });
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::super::case::{Measurement, measurements};
    use super::*;
    use mckibben::progress::Silent;

    /// Every fit of every rubber that is built in has an answer; a fit to some modes predicts the others.
    #[test]
    fn every_rubber_that_is_built_in_is_fitted() {
        let cases: Vec<&RubberCase> =
            measurements().unwrap().iter().filter_map(Measurement::rubber).collect();
        let found = report(&cases, &Silent).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(found.len(), cases.iter().map(|c| c.fits.len()).sum::<usize>());
        for r in &found {
            let fit = &cases[r.case].fits[r.fit];
            assert!(
                r.groups.iter().any(|g| !g.blind && g.points > 5),
                "{} {}",
                cases[r.case].facts.name,
                fit.name
            );
            let blind = !fit.modes.is_empty();
            assert!(!blind || r.groups.iter().any(|g| g.blind), "{} {}", cases[r.case].facts.name, fit.name);
        }
    }
}
