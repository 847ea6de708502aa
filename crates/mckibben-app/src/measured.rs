//! `validate --measured`: the validation report of every measured case: the errors of each fit at
//! fitted points and at predicted points.

mod page;

use crate::{MeshFields, Problem, ProblemKind, Result, Units, figure};
use mckibben_core::{muscle::Muscle, progress::Progress, size};
use mckibben_fit::validation::{
    built_in::measurements,
    case::{CaseError, Measurement, MuscleCase, RubberCase},
    report::{Group, report},
    residual::Fitter,
    rubber::{self, RubberGroup},
};
pub use mckibben_fit::validation::{
    case::{Facts as MeasuredFacts, MeasuredFolder},
    report::{MeasuredBranch, MeasuredFit},
    rubber::RubberFit as MeasuredRubberFit,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measured muscles and rubbers, each with its known data and its fits.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MeasuredRequest {
    /// The folders; default: the built-in cases.
    pub cases: Vec<MeasuredFolder>,
    /// The model of the muscles; `fe` where none is named.
    pub model: Option<String>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// The validation reports of measured muscles and rubbers.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuredAnswer {
    /// The model.
    pub model: String,
    /// The muscles.
    pub cases: Vec<MeasuredCase>,
    /// Errors at their points, fit by fit.
    pub results: Vec<MeasuredResult>,
    /// The rubbers.
    pub rubbers: Vec<MeasuredRubber>,
    /// Errors at their stresses, fit by fit.
    pub stresses: Vec<MeasuredStress>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

/// A measured muscle.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuredCase {
    /// What is known of it.
    #[serde(flatten)]
    pub facts: MeasuredFacts,
    /// Points that pull.
    pub points: usize,
    /// What was fitted.
    pub fits: Vec<MeasuredFit>,
}

/// Errors of a fit at some points: measured − computed.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuredResult {
    /// Name of the case's folder.
    pub case: String,
    /// Name of the fit.
    pub fit: String,
    /// The points it was fitted to.
    pub fitted_to: String,
    /// Residuals of its points.
    #[serde(flatten)]
    pub group: Group,
}

/// A measured rubber.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuredRubber {
    /// What is known of it.
    #[serde(flatten)]
    pub facts: MeasuredFacts,
    /// Points.
    pub points: usize,
    /// What was fitted.
    pub fits: Vec<MeasuredRubberFit>,
}

/// Errors of a fit at some nominal stresses: measured − computed.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuredStress {
    /// Name of the case's folder.
    pub case: String,
    /// Name of the fit.
    pub fit: String,
    /// Residuals of its points.
    #[serde(flatten)]
    pub group: RubberGroup,
}

/// The validation report of every measured case.
pub fn measured(request: &MeasuredRequest, progress: &dyn Progress) -> Result<MeasuredAnswer> {
    let read = request
        .cases
        .iter()
        .map(Measurement::read)
        .collect::<Result<Vec<_>, _>>()
        .map_err(|error| Problem::from(&error))?;
    let all = if read.is_empty() {
        measurements().map_err(Problem::from)?
    } else {
        &read
    };
    let cases: Vec<&MuscleCase> = all.iter().filter_map(Measurement::muscle).collect();
    let stretched: Vec<&RubberCase> = all.iter().filter_map(Measurement::rubber).collect();
    if request.figure.is_some() && cases.is_empty() {
        let message =
            "the figure shows measured muscles, and these cases are rubbers only: leave it out";
        let hint = "`rubber` draws a rubber's laws over its points";
        return Err(Problem::usage(message, hint));
    }
    let points: usize = cases
        .iter()
        .map(|case| case.points.len() * case.fits.len())
        .sum();
    let stresses: usize = stretched
        .iter()
        .map(|case| case.count() * case.fits.len())
        .sum();
    size::points("cases", (points + stresses) as f64)?;
    let model = MeshFields::default().model(request.model.as_deref().unwrap_or("fe"))?;
    let build = |muscle: &Muscle| model.build(muscle);
    let reported = report(
        &cases,
        Fitter {
            build: &build,
            progress,
        },
    )?;
    let (rubbers, stresses) = rubbers(&stretched, progress)?;
    let name = model.name().to_owned();
    let figure = request
        .figure
        .as_ref()
        .map(|u| figure::measured(&cases, &reported, (&name, &build), u));
    let results = reported
        .iter()
        .flat_map(|r| r.groups.iter().map(|g| result(&cases, r, g)));
    let case = |(number, case): (usize, &&MuscleCase)| {
        let fits = reported
            .iter()
            .filter(|r| r.case == number)
            .cloned()
            .collect();
        MeasuredCase {
            facts: case.facts.clone(),
            points: case.points.len(),
            fits,
        }
    };
    Ok(MeasuredAnswer {
        model: name,
        results: results.collect(),
        cases: cases.iter().enumerate().map(case).collect(),
        rubbers,
        stresses,
        figure,
    })
}

fn result(cases: &[&MuscleCase], r: &MeasuredFit, group: &Group) -> MeasuredResult {
    MeasuredResult {
        case: cases[r.case].facts.name.clone(),
        fit: r.fit.clone(),
        fitted_to: r.fitted_to.clone(),
        group: group.clone(),
    }
}

/// Every fit of rubbers.
fn rubbers(
    cases: &[&RubberCase],
    progress: &dyn Progress,
) -> Result<(Vec<MeasuredRubber>, Vec<MeasuredStress>)> {
    let reported = rubber::report(cases, progress)?;
    let rubber = |(number, case): (usize, &&RubberCase)| {
        let fits = reported
            .iter()
            .filter(|r| r.case == number)
            .cloned()
            .collect();
        MeasuredRubber {
            facts: case.facts.clone(),
            points: case.count(),
            fits,
        }
    };
    let stresses = reported.iter().flat_map(|r| {
        let stress = |group: &RubberGroup| MeasuredStress {
            case: cases[r.case].facts.name.clone(),
            fit: r.fit.clone(),
            group: group.clone(),
        };
        r.groups.iter().map(stress)
    });
    Ok((
        cases.iter().enumerate().map(rubber).collect(),
        stresses.collect(),
    ))
}

impl From<&CaseError> for Problem {
    fn from(error: &CaseError) -> Self {
        let kind = match error {
            CaseError::Points { .. } => ProblemKind::Data,
            CaseError::Parameter { .. } => ProblemKind::Parameter,
            _ => ProblemKind::File,
        };
        kind.problem(error)
    }
}
