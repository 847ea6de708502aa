//! What was measured as a folder: `case.toml`, `points.csv`, and of a muscle `muscle.toml`; of a
//! muscle of the library ([`library`](super::library)) `identified.toml` too.
//!
//! The same reader serves the folders that are built in (`data/measured`) and those of users.

use super::rubber::RubberCase;
use crate::{identify::Parameter, measured::DataPoint};
use mckibben::{
    cancel::Cancel,
    muscle::{Friction, Muscle},
};
use mckibben_io::table::TableError;
use rust_embed::Embed;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;
use thiserror::Error;

/// The files of a measured muscle or rubber.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
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

#[derive(Debug, Clone)]
pub enum Measurement {
    Muscle(MuscleCase),
    Rubber(RubberCase),
}

/// A measured muscle, and what is fitted to it.
#[derive(Debug, Clone)]
pub struct MuscleCase {
    /// What is known of it.
    pub facts: Facts,
    /// The rms error over the blocked force that passes in the first fit: that of finite elements,
    /// rounded up. A regression. `None` of a set whose lengths differ as specimens do: it is judged
    /// by the points that are left out of fits alone.
    pub rms_of_blocked: Option<f64>,
    /// The points that pull.
    pub points: Vec<DataPoint>,
    /// What is fitted; the ± is calibrated on the first.
    pub fits: Vec<CaseFit>,
    /// The number of the fit that identifies the muscle of the library.
    pub library_fit: usize,
    /// The muscle of the library, with its bench; `None` where the folder holds none.
    pub identified: Option<Box<Muscle>>,
}

impl MuscleCase {
    /// c_f of the friction that is estimated on its branches; 0 of a product, whose strands are
    /// inside of the rubber.
    pub fn friction_share(&self) -> f64 {
        if self.facts.product.is_none() {
            Friction::OF_TENSION
        } else {
            0.0
        }
    }
}

/// What is fitted to which points.
#[derive(Debug, Clone)]
pub struct CaseFit {
    pub name: String,
    /// The muscle with which the search begins.
    pub muscle: Muscle,
    /// What is free; where nothing is, nothing is fitted, and all points are blind.
    pub free: Vec<Parameter>,
    /// Whether it is fitted to the single branches of the hysteresis, in place of their means.
    pub both_branches: bool,
    /// Which points it is fitted to; all where `None`.
    pub split: Option<Split>,
}

/// Which points are fitted; the others are predicted blind.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "super::read::SplitText")]
pub struct Split {
    /// Quantity that divides the points.
    pub by: By,
    pub fitted: FittedSubset,
}

/// Quantity that divides points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum By {
    /// L0 of the muscle.
    #[serde(rename = "length_mm")]
    Length,
    #[serde(rename = "pressure_mpa")]
    Pressure,
    #[serde(rename = "contraction")]
    Contraction,
}

/// Which points are fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FittedSubset {
    /// Those of one value, for each value in turn.
    One,
    /// Those of all values but one, for each in turn.
    Others,
    /// Those of a range, both ends in it.
    Range(f64, f64),
}

#[derive(Embed)]
#[folder = "data/measured"]
struct Folders;

/// The texts of the folders that are built in.
pub fn built_in() -> Vec<MeasuredFolder> {
    let files = |name: String| {
        let text = |file| text_of(&name, file).unwrap_or_default();
        MeasuredFolder {
            case: text("case.toml"),
            muscle: text("muscle.toml"),
            points: text("points.csv"),
            identified: text(IDENTIFIED),
            name,
        }
    };
    with_file("case.toml").into_iter().map(files).collect()
}

/// The file of the identified muscle.
pub const IDENTIFIED: &str = "identified.toml";

/// A file of a folder that is built in.
pub(super) fn text_of(name: &str, file: &str) -> Option<String> {
    let file = Folders::get(&format!("{name}/{file}"))?;
    Some(String::from_utf8_lossy(&file.data).into_owned())
}

/// The folders that are built in and hold a file.
pub(super) fn with_file(file: &str) -> Vec<String> {
    let folder = |path: &str| Some(path.strip_suffix(file)?.strip_suffix('/')?.to_owned());
    let mut names: Vec<String> = Folders::iter().filter_map(|path| folder(&path)).collect();
    names.sort();
    names
}

type BuiltIn = LazyLock<Result<Vec<Measurement>, CaseError>>;

static MUSCLES: BuiltIn = LazyLock::new(|| read_built_in(false));
static RUBBERS: BuiltIn = LazyLock::new(|| read_built_in(true));

fn read_built_in(rubbers: bool) -> Result<Vec<Measurement>, CaseError> {
    // For every caller, and not for the first alone, who may leave.
    let _entered = Cancel::default().enter();
    let wanted = |files: &&MeasuredFolder| files.muscle.trim().is_empty() == rubbers;
    let all = built_in();
    all.iter().filter(wanted).map(Measurement::read).collect()
}

/// What is built in, of its kind.
fn built_in_of_kind<T>(
    list: &'static BuiltIn,
    of: fn(&Measurement) -> Option<&T>,
) -> Result<Vec<&'static T>, &'static CaseError> {
    Ok(list.as_ref()?.iter().filter_map(of).collect())
}

/// The measured muscles that are built in.
pub fn muscles() -> Result<Vec<&'static MuscleCase>, &'static CaseError> {
    built_in_of_kind(&MUSCLES, Measurement::muscle)
}

/// The measured rubbers that are built in.
pub fn rubbers() -> Result<Vec<&'static RubberCase>, &'static CaseError> {
    built_in_of_kind(&RUBBERS, Measurement::rubber)
}

impl Measurement {
    pub fn muscle(&self) -> Option<&MuscleCase> {
        match self {
            Self::Muscle(case) => Some(case),
            Self::Rubber(_) => None,
        }
    }

    pub fn rubber(&self) -> Option<&RubberCase> {
        match self {
            Self::Rubber(case) => Some(case),
            Self::Muscle(_) => None,
        }
    }
}

/// Why a folder is no case.
#[derive(Debug, Error)]
pub enum CaseError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A parameter that the muscle does not have.
    #[error("{0}")]
    Parameter(String),
    /// Points that cannot be read.
    #[error("{0}/points.csv: {1}")]
    Points(String, TableError),
}

/// What is known of something that was measured.
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "MeasuredFacts")]
pub struct Facts {
    /// Name of its folder.
    pub name: String,
    /// Which muscle or rubber.
    pub title: String,
    /// Who measured it.
    pub source: String,
    /// Terms of use of the points.
    pub terms: String,
    /// What is known of it.
    pub known: String,
    /// What is not.
    pub unknown: String,
    /// The product, where one can buy it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
}
