//! Rubbers of the library.

use crate::{Result, rubber};
use mckibben_core::{
    extremes::even,
    rubber::{
        Law, RubberLaw,
        library::{self, COVERING, RubberEntry, RubberFit, Standing, Window, WindowLaw},
    },
    warning::Warning,
};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// A rubber in a line.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RubberSummary {
    /// The word for `rubber`.
    pub name: String,
    /// What it is.
    pub title: String,
    /// The law that the name means in the prototype.
    pub law: String,
    /// Shear modulus μ at rest of that law, MPa.
    pub shear_modulus_mpa: f64,
    /// Whether its curve is at hand: the law then is fitted to the stretches that a muscle reaches.
    pub curve: bool,
    /// Largest engineering strain of the test.
    pub max_strain: Option<f64>,
    /// The laws that can be requested (`NAME:LAW`), with spaces between them.
    pub laws: String,
    /// Where the data come from.
    pub source: String,
}

/// A rubber with its laws, its source and its terms.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct RubberDetails {
    /// Its row of the library.
    #[serde(flatten)]
    pub entry: RubberEntry,
    /// The laws that can be requested: `NAME:LAW`.
    pub laws: Vec<String>,
    /// The laws fitted to it: those of its curve by ranges of stretch, then the published ones.
    pub fits: Vec<LibraryFit>,
    /// The word for `rubber` that names the fits that are taken.
    pub rubber: String,
    /// Warnings about the fit that the prototype uses.
    pub warnings: Vec<Warning>,
}

/// A law fitted to a rubber.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct LibraryFit {
    /// The law.
    pub law: String,
    /// The same with the number of its terms.
    pub name: String,
    /// Whether it is what the requested name means for a muscle with this very reach; between two
    /// reaches it means constants between theirs, beyond the last reach those of the last.
    pub by_reach: bool,
    /// Largest stretch that a muscle may reach for this range of data to cover it; none for
    /// published constants that are given for comparison.
    pub reach_up_to: Option<f64>,
    /// Its constants; those in MPa end in `_mpa`.
    #[serde(flatten, serialize_with = "columns")]
    #[schemars(with = "BTreeMap<String, f64>")]
    pub fit: Law,
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// Engineering strain up to which data were used.
    pub up_to_strain: Option<f64>,
    /// R²: of the fit.
    pub r_squared: Option<f64>,
    /// What is known of a law that was fitted to the curve.
    #[serde(flatten)]
    pub fitted: Option<FittedToCurve>,
}

fn columns<S: Serializer>(law: &Law, serializer: S) -> Result<S::Ok, S::Error> {
    law.columns().serialize(serializer)
}

/// What is known of a law that was fitted to a curve.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct FittedToCurve {
    /// Number of points.
    pub points: usize,
    /// Against the law that is recommended.
    pub standing: Standing,
    /// Whether it was held among the laws that are stable in a muscle.
    pub held: bool,
    /// Root mean square of the differences of nominal stress, MPa.
    pub rms_mpa: f64,
    /// Largest difference from the recommended law of the stress in planar tension (a wall that
    /// widens at constant length), up to the end of the data, over the largest stress there.
    pub planar_difference: f64,
}

/// The command `rubber` without data: all named rubbers.
pub fn rubbers() -> Result<Vec<RubberSummary>> {
    let one = |entry: &RubberEntry| {
        let law = rubber(&entry.name)?.law;
        Ok(RubberSummary {
            name: entry.name.clone(),
            title: entry.title.clone(),
            law: law.name().into(),
            shear_modulus_mpa: law.shear_modulus_mpa(),
            curve: !entry.windows.is_empty(),
            max_strain: entry.max_strain,
            laws: entry.laws().join(" "),
            source: entry.source.clone(),
        })
    };
    library::entries()?.iter().map(one).collect()
}

/// A rubber by NAME or NAME:LAW; `None` where there is none of that name.
pub fn rubber_details(name: &str) -> Result<Option<RubberDetails>> {
    let plain = name.split(':').next().unwrap_or_default();
    let Ok(entry) = library::entry(plain) else {
        return Ok(None);
    };
    let named = rubber(name)?;
    let word = named.name.clone().unwrap_or_else(|| entry.name.clone());
    let fitted = entry
        .windows
        .iter()
        .flat_map(|w| w.laws.iter().map(|l| of_curve(&word, w, l)));
    let published = entry.fits.iter().map(|fit| as_published(&word, entry, fit));
    let warnings = library::warnings(&named).into_iter();
    Ok(Some(RubberDetails {
        laws: entry.laws(),
        fits: fitted.chain(published).collect(),
        entry: entry.clone(),
        warnings: warnings.map(Warning::from).collect(),
        rubber: word,
    }))
}

/// Whether a law is what a word means with data up to a stretch.
fn means(word: &str, law: &Law, fitted_to_stretch: Option<f64>) -> bool {
    library::find_up_to(word, fitted_to_stretch.unwrap_or(1.0)).is_ok_and(|named| named.law == *law)
}

fn of_curve(word: &str, window: &Window, l: &WindowLaw) -> LibraryFit {
    let best = window.recommended().map_or(&l.law, |best| &best.law);
    LibraryFit {
        law: l.law.name().into(),
        name: l.name.clone(),
        by_reach: means(word, &l.law, Some(window.fitted_to_stretch)),
        reach_up_to: Some(window.fitted_to_stretch / COVERING),
        fit: l.law.clone(),
        shear_modulus_mpa: l.law.shear_modulus_mpa(),
        up_to_strain: Some(window.fitted_to_stretch - 1.0),
        r_squared: Some(l.r_squared),
        fitted: Some(FittedToCurve {
            points: window.points,
            standing: l.standing,
            held: l.held,
            rms_mpa: l.rms_mpa,
            planar_difference: planar_difference(&l.law, best, window.fitted_to_stretch),
        }),
    }
}

fn as_published(word: &str, entry: &RubberEntry, fit: &RubberFit) -> LibraryFit {
    let alone = entry.windows.is_empty();
    let fitted = entry.reach(fit).map(|strain| 1.0 + strain);
    LibraryFit {
        law: fit.law.name().into(),
        name: fit.law.name().into(),
        by_reach: alone && means(word, &fit.law, fitted),
        reach_up_to: fitted.filter(|_| alone).map(|end| end / COVERING),
        fit: fit.law.clone(),
        shear_modulus_mpa: fit.law.shear_modulus_mpa(),
        up_to_strain: fit.up_to_strain,
        r_squared: fit.r_squared,
        fitted: None,
    }
}

/// max |P − P_best| over max |P_best| of stretches from 1 to `end`.
fn planar_difference(law: &Law, best: &Law, end: f64) -> f64 {
    const STEPS: u32 = 40;
    let stretches = even((1.0, end), STEPS).skip(1);
    let (apart, largest) =
        stretches.fold((0.0_f64, f64::MIN_POSITIVE), |(apart, largest), stretch| {
            let stress = law.planar_stress_mpa(stretch);
            let best = best.planar_stress_mpa(stretch);
            (apart.max((stress - best).abs()), largest.max(best.abs()))
        });
    apart / largest
}
