//! `rubber list` and `rubber show`: the rubbers of the library.

use crate::muscle::rubber;
use crate::problem::{Problem, ProblemKind};
use mckibben::rubber::RubberLaw;
use mckibben::rubber::library::{self, LibraryError, RubberEntry, RubberFit};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// All named rubbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct RubberListRequest {}

/// All named rubbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RubberListAnswer {
    /// The rubbers, in the order of the library.
    pub rubbers: Vec<RubberSummary>,
}

/// A rubber in a line.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RubberSummary {
    /// The word for `rubber`.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Shear modulus μ at rest of the fit that is taken when no law is named, MPa.
    pub shear_modulus_mpa: f64,
    /// Largest engineering strain of the test.
    pub max_strain: Option<f64>,
    /// Its laws, with spaces between them.
    pub laws: String,
    /// Where the data come from.
    pub source: String,
}

/// One rubber.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct RubberShowRequest {
    /// NAME or NAME:LAW.
    pub name: String,
}

/// A rubber with its laws, its source and its terms.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RubberShowAnswer {
    /// Its name.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Largest engineering strain of the test.
    pub max_strain: Option<f64>,
    /// Nominal stress there, MPa.
    pub max_stress_mpa: Option<f64>,
    /// The laws fitted to it.
    pub fits: Vec<LibraryFit>,
    /// Where the data come from.
    pub source: String,
    /// Terms under which the data may be used.
    pub terms: String,
    /// What else one should know.
    pub note: Option<String>,
    /// The word for `rubber` by which the fit is found that is taken.
    pub rubber: String,
    /// What to mind about the fit that is taken.
    pub warnings: Vec<String>,
}

/// A law fitted to a rubber.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryFit {
    /// The law.
    pub law: String,
    /// Whether it is the one that the name means.
    pub taken: bool,
    /// Its constants; those in MPa end in `_mpa`.
    #[serde(flatten)]
    pub constants: BTreeMap<String, f64>,
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// Engineering strain up to which data were used.
    pub up_to_strain: Option<f64>,
    /// R² of the fit.
    pub r_squared: Option<f64>,
    /// The fit itself.
    #[serde(skip)]
    pub fit: RubberFit,
}

/// All named rubbers.
///
/// # Errors
/// [`Problem`] of kind `rubber` where the library is damaged, which no released program should see.
pub fn rubber_list(_: &RubberListRequest) -> Result<RubberListAnswer, Problem> {
    let one = |entry: &RubberEntry| {
        Ok(RubberSummary {
            name: entry.name.clone(),
            title: entry.title.clone(),
            shear_modulus_mpa: rubber(&entry.name)?.law.shear_modulus_mpa(),
            max_strain: entry.max_strain,
            laws: entry.laws().join(" "),
            source: entry.source.clone(),
        })
    };
    Ok(RubberListAnswer { rubbers: library::entries()?.iter().map(one).collect::<Result<_, Problem>>()? })
}

/// One rubber.
///
/// # Errors
/// [`Problem`] of kind `rubber` with the name that was probably meant, or the laws that it has.
pub fn rubber_show(request: &RubberShowRequest) -> Result<RubberShowAnswer, Problem> {
    let found = rubber(&request.name)?;
    let (plain, law) = match request.name.split_once(':') {
        Some((plain, law)) => (plain, Some(law.trim())),
        None => (request.name.as_str(), None),
    };
    let entry = library::entry(plain)?;
    // Fits up to different strains may have the same constants: the one that is taken is one of them.
    let taken = law.map_or_else(|| entry.default_fit(), |law| entry.fit(law));
    let fit = |fit: &RubberFit| LibraryFit {
        law: fit.law.name().into(),
        taken: taken.is_some_and(|taken| std::ptr::eq(taken, fit)),
        constants: fit.law.constants().into_iter().map(|c| (c.column(), c.value)).collect(),
        shear_modulus_mpa: fit.law.shear_modulus_mpa(),
        up_to_strain: fit.up_to_strain,
        r_squared: fit.r_squared,
        fit: fit.clone(),
    };
    Ok(RubberShowAnswer {
        name: entry.name.clone(),
        title: entry.title.clone(),
        max_strain: entry.max_strain,
        max_stress_mpa: entry.max_stress_mpa,
        fits: entry.fits.iter().map(fit).collect(),
        source: entry.source.clone(),
        terms: entry.terms.clone(),
        note: entry.note.clone(),
        warnings: library::warnings(&found).iter().map(ToString::to_string).collect(),
        rubber: found.name.unwrap_or_else(|| entry.name.clone()),
    })
}

impl From<LibraryError> for Problem {
    fn from(error: LibraryError) -> Self {
        Self::new(ProblemKind::Rubber, error.to_string(), "")
    }
}
