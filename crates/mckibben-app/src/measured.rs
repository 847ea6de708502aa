//! `validate --measured`: the dossier of every measured muscle, what each fit leaves of its points and of those it predicts blind.

use crate::figure;
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use mckibben::budget::Resource;
use mckibben::identify::Identified;
use mckibben::progress::Progress;
use mckibben_fem::validation::case::{CASES, Case, CaseError, CaseFiles};
use mckibben_fem::validation::dossier::{DossierError, FitResult, Group, dossier};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measured muscles, each with what is known of it and what is to be fitted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MeasuredRequest {
    /// The folders of the muscles; those that are built in where there are none.
    pub cases: Vec<MeasuredFolder>,
    /// The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// The files of a measured muscle.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredFolder {
    /// What to call it in messages: the name of the folder.
    pub name: String,
    /// `case.toml`: source, terms, what is known and unknown, and the fits.
    pub case: String,
    /// `muscle.toml`: the muscle as far as it is known.
    pub muscle: String,
    /// `points.csv`: the measured points.
    pub points: String,
}

/// The dossiers of measured muscles.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredAnswer {
    /// The model.
    pub model: String,
    /// The muscles.
    pub cases: Vec<MeasuredCase>,
    /// What is left of their points, fit by fit.
    pub results: Vec<MeasuredResult>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

/// A measured muscle.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MeasuredCase {
    /// Name of its folder.
    pub name: String,
    /// Which muscle.
    pub title: String,
    /// Who measured it.
    pub source: String,
    /// On what terms the points may be used.
    pub terms: String,
    /// What is known of the muscle.
    pub known: String,
    /// What is not.
    pub unknown: String,
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

/// What a fit leaves of some points: measured less computed.
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
    /// Mean of measured less computed in N.
    pub bias_n: f64,
    /// `rms_n` over the largest blocked force of these points.
    pub rms_of_blocked: f64,
    /// Share of the points that the ± of `fe` holds; null where there are none.
    pub held: Option<f64>,
    /// How many points of single branches there are.
    pub branch_points: usize,
    /// Share of these that the ± with its part for friction holds; null where there are none.
    pub branch_held: Option<f64>,
    /// Points without an answer of `fe`.
    pub unanswered: usize,
    /// The same by contraction ratio.
    pub by_contraction: Vec<MeasuredBin>,
}

/// What a fit leaves of points of about one contraction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredBin {
    /// From this contraction ratio,
    pub from: f64,
    /// to less than this.
    pub to: f64,
    /// How many points.
    pub points: usize,
    /// Mean of measured less computed in N.
    pub bias_n: f64,
    /// Root mean square in N.
    pub rms_n: f64,
}

/// The dossier of every measured muscle.
///
/// # Errors
/// [`Problem`] names the folder and the fit.
pub fn measured(request: &MeasuredRequest, progress: &dyn Progress) -> Result<MeasuredAnswer, Problem> {
    let own: Vec<Case> = request.cases.iter().map(read).collect::<Result<_, _>>()?;
    let cases = if own.is_empty() { &**CASES } else { &own };
    let points: usize = cases.iter().map(|case| case.points.len() * case.fits.len()).sum();
    progress.budget().admit(Resource::Points, points as f64)?;
    let found = dossier(cases, progress)?;
    let figure = request.figure.as_ref().map(|u| figure::measured(cases, &found, u));
    let results = found.iter().flat_map(|r| r.groups.iter().map(|g| result(cases, r, g)));
    Ok(MeasuredAnswer {
        model: "fe".into(),
        results: results.collect(),
        cases: cases.iter().enumerate().map(|(i, case)| facts(i, case, &found)).collect(),
        figure,
    })
}

fn read(folder: &MeasuredFolder) -> Result<Case, Problem> {
    let MeasuredFolder { name, case, muscle, points } = folder.clone();
    Ok(Case::read(&CaseFiles { name, case, muscle, points })?)
}

fn facts(number: usize, case: &Case, found: &[FitResult]) -> MeasuredCase {
    let fits = found.iter().filter(|r| r.case == number).map(|r| MeasuredFit {
        fit: case.fits[r.fit].name.clone(),
        fitted_to: r.fitted_to.clone(),
        parameters: r.parameters.clone(),
    });
    MeasuredCase {
        name: case.name.clone(),
        title: case.title.clone(),
        source: case.source.clone(),
        terms: case.terms.clone(),
        known: case.known.clone(),
        unknown: case.unknown.clone(),
        points: case.points.len(),
        fits: fits.collect(),
    }
}

fn result(cases: &[Case], r: &FitResult, group: &Group) -> MeasuredResult {
    let case = &cases[r.case];
    let (means, branches) = (group.means, group.branches);
    let share = |held: usize, points: usize| (points > 0).then(|| held as f64 / points as f64);
    let bins = group.by_contraction.iter().map(|(bin, left)| MeasuredBin {
        from: bin.start,
        to: bin.end,
        points: left.points,
        bias_n: left.bias_n,
        rms_n: left.rms_n,
    });
    MeasuredResult {
        case: case.name.clone(),
        fit: case.fits[r.fit].name.clone(),
        fitted_to: r.fitted_to.clone(),
        of: group.of.clone(),
        blind: group.blind,
        points: means.points,
        rms_n: means.rms_n,
        largest_n: means.largest_n,
        bias_n: means.bias_n,
        rms_of_blocked: if means.points > 0 { means.rms_n / means.blocked_n } else { 0.0 },
        held: share(means.held, means.points),
        branch_points: branches.points,
        branch_held: share(branches.held, branches.points),
        unanswered: group.unanswered,
        by_contraction: bins.collect(),
    }
}

impl From<CaseError> for Problem {
    fn from(error: CaseError) -> Self {
        let kind = match error {
            CaseError::Points { .. } => ProblemKind::Data,
            CaseError::Parameter { .. } => ProblemKind::Parameter,
            _ => ProblemKind::File,
        };
        Self::new(kind, error.to_string(), "")
    }
}

impl From<DossierError> for Problem {
    fn from(error: DossierError) -> Self {
        match error {
            DossierError::Cancelled => Self::cancelled(),
            DossierError::Fit { case, fit, fitted_to, error } => {
                let problem = Self::from(error);
                let message = format!("{case}, fit \"{fit}\" on {fitted_to}: {}", problem.message);
                Self { message, ..problem }
            }
        }
    }
}
