//! What was measured as a folder: `case.toml`, `points.csv`, and of a muscle `muscle.toml`; of a
//! muscle of the library ([`library`](super::library)) `identified.toml` too.
//!
//! The same reader serves the folders that are built in (`data/measured`) and those of users.

use crate::{
    identify::Parameter,
    measured::{DataPoint, mean_of_data},
    rubber::{Form, Mode, TensionPoint},
    rubber_over_time::TimePoint,
};
use mckibben_core::{built::Experience, muscle::Muscle};
use mckibben_io::table::TableError;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The files of a measured muscle or rubber.
#[derive(Debug, Serialize, Deserialize, schemars::JsonSchema)]
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

#[derive(Debug)]
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
            Experience::built_in().friction.centre
        } else {
            0.0
        }
    }

    /// The points that a fit is made to.
    pub fn points_of(&self, fit: &CaseFit) -> Vec<DataPoint> {
        if !fit.both_branches {
            return mean_of_data(&self.points);
        }
        let single = self.points.iter().filter(|p| !p.at.direction().is_mean());
        single.copied().collect()
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
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(try_from = "SplitText")]
pub struct Split {
    /// Quantity that divides the points.
    pub by: By,
    pub fitted: FittedSubset,
}

/// Which points are fitted, as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SplitText {
    by: By,
    fit_on: Option<String>,
    from: Option<f64>,
    to: Option<f64>,
}

impl TryFrom<SplitText> for Split {
    type Error = &'static str;

    fn try_from(text: SplitText) -> Result<Self, &'static str> {
        let fitted = match (text.fit_on.as_deref(), text.from, text.to) {
            (Some("one"), None, None) => FittedSubset::One,
            (Some("others"), None, None) => FittedSubset::Others,
            (None, Some(from), Some(to)) if from <= to => FittedSubset::Range(from, to),
            _ => {
                return Err(
                    "`split` must be a table such as { by = \"length_mm\", fit_on = \"one\" } \
                     (or \"others\"), or { by = \"pressure_mpa\", from = 0.1, to = 0.3 }",
                );
            }
        };
        Ok(Self {
            by: text.by,
            fitted,
        })
    }
}

/// Quantity that divides points.
#[derive(Debug, Clone, Copy, Deserialize)]
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
#[derive(Debug, Clone, Copy)]
pub enum FittedSubset {
    /// Those of one value, for each value in turn.
    One,
    /// Those of all values but one, for each in turn.
    Others,
    /// Those of a range, both ends in it.
    Range(f64, f64),
}

/// A measured rubber, and which laws are fitted to it.
#[derive(Debug)]
pub struct RubberCase {
    /// What is known of it.
    pub facts: Facts,
    pub fits: Vec<RubberCaseFit>,
    pub(super) points: Points,
}

#[derive(Debug)]
pub enum Points {
    Tests(Vec<TensionPoint>),
    /// One specimen over time, with loading and unloading.
    History(Vec<TimePoint>),
}

impl RubberCase {
    /// How many points there are.
    pub fn count(&self) -> usize {
        match &self.points {
            Points::Tests(list) => list.len(),
            Points::History(list) => list.len(),
        }
    }
}

/// A law, and which points it is fitted to.
#[derive(Debug, Deserialize)]
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
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "MeasuredFacts")]
pub struct Facts {
    /// Name, that of its folder.
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
    pub product: Option<String>,
    /// The family that it belongs to: what one maker or workshop made.
    pub family: Option<String>,
    /// Standard deviation of an angle that nobody stated, in degrees.
    pub angle_deviation_deg: Option<f64>,
}
