//! The part of `validate --measured` about rubbers: what a law leaves of measured stresses.

use crate::problem::Problem;
use mckibben::progress::Progress;
use mckibben_fit::rubber::Parameter;
use mckibben_fit::validation::case::Facts;
use mckibben_fit::validation::rubber::{RubberCase, RubberFitResult, report};
use schemars::JsonSchema;
use serde::Serialize;

/// A measured rubber.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredRubber {
    /// What is known of it.
    #[serde(flatten)]
    pub facts: Facts,
    /// Points.
    pub points: usize,
    /// What was fitted.
    pub fits: Vec<MeasuredRubberFit>,
}

/// A law that was fitted, and what was found.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredRubberFit {
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
}

/// Errors of a fit at some nominal stresses: measured − computed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredStress {
    /// Name of the case's folder.
    pub case: String,
    /// Name of the fit.
    pub fit: String,
    /// The points that are compared: a mode, a mode `further` than the law was fitted, or a branch of a test over time.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    /// How many.
    pub points: usize,
    /// Their largest stretch.
    pub to_stretch: f64,
    /// Root mean square of the differences in MPa.
    pub rms_mpa: f64,
    /// The same over the root mean square of the measured stresses.
    pub relative: f64,
    /// Mean of measured − computed in MPa.
    pub bias_mpa: f64,
    /// Largest difference in MPa.
    pub largest_mpa: f64,
}

/// Every fit of rubbers.
pub(crate) fn rubbers(
    cases: &[&RubberCase],
    progress: &dyn Progress,
) -> Result<(Vec<MeasuredRubber>, Vec<MeasuredStress>), Problem> {
    let found = report(cases, progress)?;
    let of = |(number, case): (usize, &&RubberCase)| {
        let fits = found.iter().filter(|r| r.case == number).map(|r| {
            let RubberFitResult { fit, parameters, prony, stable, .. } = r.clone();
            let fit = &case.fits[fit];
            MeasuredRubberFit { fit: fit.name.clone(), law: fit.form.name(), parameters, prony, stable }
        });
        MeasuredRubber { facts: case.facts.clone(), points: case.len(), fits: fits.collect() }
    };
    let stresses = found.iter().flat_map(|r| {
        let case = cases[r.case];
        r.groups.iter().cloned().map(|g| MeasuredStress {
            case: case.facts.name.clone(),
            fit: case.fits[r.fit].name.clone(),
            of: g.of,
            blind: g.blind,
            points: g.points,
            to_stretch: g.to_stretch,
            rms_mpa: g.rms_mpa,
            relative: g.relative,
            bias_mpa: g.bias_mpa,
            largest_mpa: g.largest_mpa,
        })
    });
    Ok((cases.iter().enumerate().map(of).collect(), stresses.collect()))
}
