//! Named rubbers, from `data/rubbers.toml`, which states source and terms of each.
//!
//! A rubber named without a law means its neo-Hookean fit up to 200 % strain: of all uniaxial fits the one that can be
//! trusted in two axes. `name:law` asks for another law. Where a law was fitted over several ranges, the widest
//! range whose law stays stable in the two-axis stretch of a muscle (up to [`LARGEST_HOOP_STRETCH`]) is
//! taken; if none does, the one that stays stable furthest. [`warnings`] says what to mind.

mod read;

use super::{Law, Stability, biaxial_stability};
use crate::muscle::{Bulk, Rubber};
use crate::nearest::nearest;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::OnceLock;
use thiserror::Error;

/// Hoop stretch up to which a law should be stable: that of a 20° braid contracted to 54.7°, sin 54.7°/sin 20° = 2.39,
/// and a little more for the bore.
pub const LARGEST_HOOP_STRETCH: f64 = 2.5;

/// A rubber of the library.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RubberEntry {
    /// Name in kebab-case, such as `dragon-skin-30`.
    pub name: String,
    /// Other names it answers to.
    pub aliases: Vec<String>,
    /// What it is, for people.
    pub title: String,
    /// Where the data come from.
    pub source: String,
    /// Terms under which the data may be used.
    pub terms: String,
    /// What else one should know.
    pub note: Option<String>,
    /// Largest engineering strain of the test (failure, for the silicones).
    pub max_strain: Option<f64>,
    /// Nominal stress there, in MPa.
    pub max_stress_mpa: Option<f64>,
    /// The laws fitted to it.
    pub fits: Vec<RubberFit>,
}

/// A law fitted to a rubber.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RubberFit {
    /// The law with its constants.
    #[serde(flatten)]
    pub law: Law,
    /// Engineering strain up to which data were used.
    pub up_to_strain: Option<f64>,
    /// R² of the fit, where it is known.
    pub r_squared: Option<f64>,
}

/// Why there is no such rubber.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LibraryError {
    /// No rubber of that name.
    #[error(
        "there is no rubber named \"{name}\"{}",
        .nearest.as_ref().map_or_else(
            || format!("; known: {}", .known.join(", ")),
            |n| format!(" (did you mean {n}?)"),
        )
    )]
    UnknownRubber {
        /// The name as given.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// All names.
        known: Vec<String>,
    },
    /// The rubber is there, but not with this law.
    #[error("{rubber} has no fit of the law \"{law}\"; it has {}", .available.join(", "))]
    NoSuchFit {
        /// The rubber.
        rubber: String,
        /// The law as given.
        law: String,
        /// Laws it has.
        available: Vec<&'static str>,
    },
    /// The built-in table cannot be read.
    #[error("the built-in table of rubbers is damaged: {what}")]
    Damaged {
        /// What is wrong with it.
        what: String,
    },
}

/// All rubbers, in the order of the table.
///
/// # Errors
/// [`LibraryError::Damaged`], which no released program should see.
pub fn entries() -> Result<&'static [RubberEntry], LibraryError> {
    static ENTRIES: OnceLock<Result<Vec<RubberEntry>, LibraryError>> = OnceLock::new();
    ENTRIES
        .get_or_init(|| read::table(include_str!("../../../data/rubbers.toml")))
        .as_deref()
        .map_err(LibraryError::clone)
}

/// The entry of a name or alias, without regard to case; spaces and underscores are as good as hyphens.
///
/// # Errors
/// [`LibraryError::UnknownRubber`] with the nearest name.
pub fn entry(name: &str) -> Result<&'static RubberEntry, LibraryError> {
    let entries = entries()?;
    let plain = name.trim().to_lowercase().replace([' ', '_'], "-");
    let found = entries.iter().find(|e| e.name == plain || e.aliases.contains(&plain));
    found.ok_or_else(|| {
        let names = entries.iter().flat_map(|e| e.aliases.iter().chain([&e.name])).map(String::as_str);
        LibraryError::UnknownRubber {
            name: name.chars().take(60).collect(),
            nearest: nearest(&plain, names).map(str::to_string),
            known: entries.iter().map(|e| e.name.clone()).collect(),
        }
    })
}

/// The rubber `name` or `name:law`; see the module on which fit that is. Its name is the one it can be found by.
///
/// # Errors
/// [`LibraryError`] with the nearest name, or the laws the rubber has.
///
/// ```
/// use mckibben::rubber::library::find;
/// assert_eq!(find("dragon-skin-30")?.fitted_to_stretch, Some(3.0));
/// assert!(find("dragon-skin-3").unwrap_err().to_string().contains("did you mean dragon-skin-30?"));
/// # Ok::<(), mckibben::rubber::LibraryError>(())
/// ```
pub fn find(name: &str) -> Result<Rubber, LibraryError> {
    let (plain, law) = match name.split_once(':') {
        Some((plain, law)) => (plain, Some(law.trim())),
        None => (name, None),
    };
    let entry = entry(plain)?;
    let fit = law.map_or_else(|| entry.default_fit(), |law| entry.fit(law));
    let fit = fit.ok_or_else(|| LibraryError::NoSuchFit {
        rubber: entry.name.clone(),
        law: law.unwrap_or("").chars().take(60).collect(),
        available: entry.laws(),
    })?;
    let is_default = entry.default_fit().is_some_and(|d| d.law.name() == fit.law.name());
    let name = if is_default { entry.name.clone() } else { format!("{}:{}", entry.name, fit.law.name()) };
    Ok(Rubber {
        name: Some(name),
        law: fit.law.clone(),
        bulk: Bulk::Incompressible,
        fitted_to_stretch: entry.reach(fit).map(|strain| 1.0 + strain),
    })
}

impl RubberEntry {
    /// Names of the laws it has, each once.
    pub fn laws(&self) -> Vec<&'static str> {
        let mut laws: Vec<_> = self.fits.iter().map(|f| f.law.name()).collect();
        laws.dedup();
        laws
    }

    /// The fit of a law: of several ranges the widest that is stable in two axes, else the one that stays stable furthest (of
    /// equals the widest).
    pub fn fit(&self, law: &str) -> Option<&RubberFit> {
        let stable_to = |f: &RubberFit| match biaxial_stability(&f.law, LARGEST_HOOP_STRETCH) {
            Stability::Stable => f64::INFINITY,
            Stability::UnstableFrom { hoop_stretch } => hoop_stretch,
        };
        let strain = |f: &RubberFit| f.up_to_strain.unwrap_or(0.0);
        self.fits
            .iter()
            .filter(|f| f.law.name() == law)
            .map(|f| (stable_to(f), strain(f), f))
            .max_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)))
            .map(|found| found.2)
    }

    /// What the name alone means: the neo-Hookean fit, or the first law where there is none.
    pub fn default_fit(&self) -> Option<&RubberFit> {
        self.fit("neo-hookean").or_else(|| self.fit(self.fits.first()?.law.name()))
    }

    /// Engineering strain to which a fit has data behind it: rubber may fail before the range ends.
    pub fn reach(&self, fit: &RubberFit) -> Option<f64> {
        fit.up_to_strain.map(|strain| self.max_strain.map_or(strain, |max| strain.min(max)))
    }
}

/// What to mind about a rubber.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RubberWarning {
    /// The law loses stability within a muscle's range of stretches.
    Unstable {
        /// Hoop stretch from which on it is unstable.
        hoop_stretch: f64,
    },
    /// Mooney–Rivlin with C01 < 0, as uniaxial fits give.
    NegativeC01 {
        /// C01 in MPa.
        c01_mpa: f64,
    },
}

impl fmt::Display for RubberWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RubberWarning::Unstable { hoop_stretch } => write!(
                f,
                "the law is unstable in two-axis stretch from a hoop stretch of {hoop_stretch:.2}; a muscle reaches up to {LARGEST_HOOP_STRETCH}"
            ),
            RubberWarning::NegativeC01 { c01_mpa } => write!(
                f,
                "C01 is {c01_mpa} MPa: a negative C01 comes from uniaxial tests and misleads in the two-axis stretch of a muscle; prefer neo-hookean or yeoh"
            ),
        }
    }
}

/// What to mind about a rubber in a muscle.
pub fn warnings(rubber: &Rubber) -> Vec<RubberWarning> {
    let unstable = match biaxial_stability(&rubber.law, LARGEST_HOOP_STRETCH) {
        Stability::UnstableFrom { hoop_stretch } => Some(RubberWarning::Unstable { hoop_stretch }),
        Stability::Stable => None,
    };
    let negative = rubber.law.negative_c01_mpa().map(|c01_mpa| RubberWarning::NegativeC01 { c01_mpa });
    unstable.into_iter().chain(negative).collect()
}

#[cfg(test)]
mod tests;
