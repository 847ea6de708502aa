//! `validate --measured`: the validation report of every measured case: the errors of each fit at fitted points and at predicted points.

use crate::fields::MeshFields;
use crate::figure;
use crate::measured_rubber::{MeasuredRubber, MeasuredStress, rubbers};
use crate::model::Model;
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use mckibben::muscle::{Direction, Muscle};
use mckibben::progress::Progress;
use mckibben::size;
use mckibben_fit::identify::Identified;
pub use mckibben_fit::validation::case::Facts as MeasuredFacts;
use mckibben_fit::validation::case::{CaseError, CaseFiles, Measurement, MuscleCase, measurements};
use mckibben_fit::validation::report::{FitResult, Group, ReportError, report};
use mckibben_fit::validation::rubber::RubberCase;
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measured muscles and rubbers, each with its known data and its fits.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MeasuredRequest {
    /// The folders; default: the built-in cases.
    pub cases: Vec<MeasuredFolder>,
    /// The model of the muscles; `fe` where none is named.
    pub model: Option<String>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// The files of a measured muscle or rubber.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredFolder {
    /// What to call it in messages: the name of the folder.
    pub name: String,
    /// `case.toml`: source, terms, what is known and unknown, and the fits.
    pub case: String,
    /// `muscle.toml`: the muscle as far as it is known; empty where a rubber was measured.
    pub muscle: String,
    /// `points.csv`: the measured points.
    pub points: String,
    /// `identified.toml`: the muscle that was identified from them, of a folder of the library.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub identified: String,
}

/// The validation reports of measured muscles and rubbers.
#[derive(Debug, Clone, Serialize, JsonSchema)]
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
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

/// A measured muscle.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredCase {
    /// What is known of it.
    #[serde(flatten)]
    pub facts: MeasuredFacts,
    /// Points that pull.
    pub points: usize,
    /// What was fitted.
    pub fits: Vec<MeasuredFit>,
}

/// What was fitted to which points, and what was found.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredFit {
    /// Its name.
    pub fit: String,
    /// Its points: `all`, `nothing`, or their lengths, pressures or contractions.
    pub fitted_to: String,
    /// What was found, with its error.
    pub parameters: Vec<Identified>,
}

/// Errors of a fit at some points: measured − computed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredResult {
    /// Name of the case's folder.
    pub case: String,
    /// Name of the fit.
    pub fit: String,
    /// The points it was fitted to.
    pub fitted_to: String,
    /// The points that are compared.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    /// How many: means of the two branches of the hysteresis, and points without a branch.
    pub points: usize,
    /// Root mean square of the differences in N.
    pub rms_n: f64,
    /// Largest difference in N.
    pub largest_n: f64,
    /// Mean of measured − computed in N.
    pub bias_n: f64,
    /// `rms_n` over the largest blocked force of these points.
    pub rms_of_blocked: f64,
    /// Share of the points within the ± of the model; null if there are none, or no ±.
    pub held: Option<f64>,
    /// How many points of single branches there are.
    pub branch_points: usize,
    /// Share of these within the ± with its part for friction; null if there are none.
    pub branch_held: Option<f64>,
    /// The points of each branch of the hysteresis, where it was measured.
    pub by_branch: Vec<MeasuredBranch>,
    /// Points without an answer of the model.
    pub unanswered: usize,
    /// The same by contraction ratio.
    pub by_contraction: Vec<MeasuredBin>,
}

/// Errors of a fit at the points of one branch of the hysteresis.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredBranch {
    /// The branch: `contraction` while the muscle shortened or its pressure rose, `elongation` back.
    pub branch: Direction,
    /// How many points.
    pub points: usize,
    /// Root mean square in N.
    pub rms_n: f64,
    /// Mean of measured − computed in N.
    pub bias_n: f64,
    /// Share of the points within the ±, with its part for friction if the muscle states none.
    pub held: Option<f64>,
}

/// Errors of a fit at points of about one contraction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredBin {
    /// From this contraction ratio,
    pub from: f64,
    /// to less than this.
    pub to: f64,
    /// How many points.
    pub points: usize,
    /// Mean of measured − computed in N.
    pub bias_n: f64,
    /// Root mean square in N.
    pub rms_n: f64,
}

/// The validation report of every measured case.
pub fn measured(request: &MeasuredRequest, progress: &dyn Progress) -> Result<MeasuredAnswer, Problem> {
    let own: Vec<Measurement> = request.cases.iter().map(read).collect::<Result<_, _>>()?;
    let all = if own.is_empty() { measurements().map_err(Problem::from)? } else { &own };
    let cases: Vec<&MuscleCase> = all.iter().filter_map(Measurement::muscle).collect();
    let stretched: Vec<&RubberCase> = all.iter().filter_map(Measurement::rubber).collect();
    if request.figure.is_some() && cases.is_empty() {
        let message = "the figure shows measured muscles, and these cases are rubbers only: leave it out";
        return Err(Problem::new(
            ProblemKind::Usage,
            message,
            "`rubber` draws a rubber's laws over its points",
        ));
    }
    let points: usize = cases.iter().map(|case| case.points.len() * case.fits.len()).sum();
    let stresses: usize = stretched.iter().map(|case| case.len() * case.fits.len()).sum();
    size::points("cases", (points + stresses) as f64)?;
    let model = Model::named(request.model.as_deref().unwrap_or("fe"), &[], &MeshFields::default())?;
    let build = |muscle: &Muscle| model.build(muscle);
    let found = report(&cases, &build, progress)?;
    let (rubbers, stresses) = rubbers(&stretched, progress)?;
    let name = model.name().to_owned();
    let figure = request.figure.as_ref().map(|u| figure::measured(&cases, &found, (&name, &build), u));
    let results = found.iter().flat_map(|r| r.groups.iter().map(|g| result(&cases, r, g)));
    Ok(MeasuredAnswer {
        model: name,
        results: results.collect(),
        cases: cases.iter().enumerate().map(|(i, case)| facts(i, case, &found)).collect(),
        rubbers,
        stresses,
        figure,
    })
}

fn read(folder: &MeasuredFolder) -> Result<Measurement, Problem> {
    let MeasuredFolder { name, case, muscle, points, identified } = folder.clone();
    Measurement::read(&CaseFiles { name, case, muscle, points, identified }).map_err(|error| (&error).into())
}

fn facts(number: usize, case: &MuscleCase, found: &[FitResult]) -> MeasuredCase {
    let fits = found.iter().filter(|r| r.case == number).map(|r| MeasuredFit {
        fit: case.fits[r.fit].name.clone(),
        fitted_to: r.fitted_to.clone(),
        parameters: r.parameters.clone(),
    });
    MeasuredCase { facts: case.facts.clone(), points: case.points.len(), fits: fits.collect() }
}

fn result(cases: &[&MuscleCase], r: &FitResult, group: &Group) -> MeasuredResult {
    let case = cases[r.case];
    let (means, branches) = (group.means, group.branches);
    let bins = group.by_contraction.iter().map(|(bin, left)| MeasuredBin {
        from: bin.start,
        to: bin.end,
        points: left.points,
        bias_n: left.bias_n,
        rms_n: left.rms_n,
    });
    let by_branch = group.by_branch.iter().map(|(branch, left)| MeasuredBranch {
        branch: *branch,
        points: left.points,
        rms_n: left.rms_n,
        bias_n: left.bias_n,
        held: left.share_held(),
    });
    MeasuredResult {
        case: case.facts.name.clone(),
        fit: case.fits[r.fit].name.clone(),
        fitted_to: r.fitted_to.clone(),
        of: group.of.clone(),
        blind: group.blind,
        points: means.points,
        rms_n: means.rms_n,
        largest_n: means.largest_n,
        bias_n: means.bias_n,
        rms_of_blocked: means.rms_of_blocked(),
        held: means.share_held(),
        branch_points: branches.points,
        branch_held: branches.share_held(),
        by_branch: by_branch.collect(),
        unanswered: group.unanswered,
        by_contraction: bins.collect(),
    }
}

impl From<&CaseError> for Problem {
    fn from(error: &CaseError) -> Self {
        let kind = match error {
            CaseError::Points { .. } => ProblemKind::Data,
            CaseError::Parameter { .. } => ProblemKind::Parameter,
            _ => ProblemKind::File,
        };
        Self::new(kind, error.to_string(), "")
    }
}

impl From<ReportError> for Problem {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Cancelled(cancelled) => cancelled.into(),
            ReportError::Fit { case, fit, fitted_to, error } => {
                let problem = Self::from(error);
                let message = format!("{case}, fit \"{fit}\" on {fitted_to}: {}", problem.message);
                Self { message, ..problem }
            }
            ReportError::Rubber { case, fit, error } => {
                let problem = Self::from(error);
                let message = format!("{case}, fit \"{fit}\": {}", problem.message);
                Self { message, ..problem }
            }
        }
    }
}
