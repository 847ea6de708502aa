//! A rubber law from tension tests.
//!
//! [`read_tension`] reads uniaxial, planar, equibiaxial and general biaxial tests; [`fit_tension`]
//! finds the constants of every law by least squares of the nominal stress,
//!
//!   minimise Σ w (P(λ; c) − P_measured)²   or   Σ w (P(λ; c)/P_measured − 1)²,
//!
//! with standard errors (see [`estimate`](crate::least_squares::estimate)), R² = 1 − Σ(P −
//! P_m)²/Σ(P_m − mean)² (always of the stresses, not weighted), and Akaike's criterion for small
//! samples (Hurvich & Tsai 1989 \[hurvich1989\]), k constants and s²:
//!
//!   AICc = n ln(Σ w r²/n) + 2(k + 1) + 2(k + 1)(k + 2)/(n − k − 2).
//!
//! It checks where a law is stable: over the stretches of a muscle wall, and in the three tests. A
//! law that is not is fitted again among those that are. Standard errors take the errors of the
//! points as independent; neighbouring points of one test err alike, so that the true errors are
//! larger.

mod convex;
mod data;
mod fitted;
mod linear;
mod nonlinear;
mod ogden;
mod point;
mod problem;
mod runs;
mod standing;
mod warning;

pub use data::{read_tension, read_tests};
pub use fitted::{FittedLaw, LawQuality, Parameter, StressErrors};
pub use mckibben_core::rubber::Form;
use mckibben_core::{
    by_number::SortByNumber,
    cancel::{self, Cancelled},
    extremes::peak,
    progress::{Progress, Silent},
    rubber::MUSCLE_HOOP_STRETCH,
};
pub use point::{Mode, TensionPoint};
pub use problem::Measure;
use problem::Problem;
use serde::{Deserialize, Serialize};
pub use standing::{DECIDED_AICC, TensionFit};
use thiserror::Error;
pub(crate) use warning::MODULI;

/// Fits laws to points.
///
/// # Errors
/// [`TensionFitError`]: bad settings, too few points, no stiffness; or, where none of the laws has
/// a fit, why the first one has none.
pub fn fit_tension(points: &[TensionPoint], settings: &FitSettings) -> Result<TensionFit> {
    fit_tension_with(points, settings, &Silent)
}

/// The same with progress over the laws, and an end when the caller wants one.
pub fn fit_tension_with(
    points: &[TensionPoint],
    settings: &FitSettings,
    progress: &dyn Progress,
) -> Result<TensionFit> {
    check(settings)?;
    let sorted = if settings.history {
        runs::Sorted {
            kept: points.to_vec(),
            ..Default::default()
        }
    } else {
        runs::sort(points)
    };
    let mut warnings = warning::for_runs(&sorted);
    let limit = settings.up_to_stretch.unwrap_or(f64::INFINITY);
    let reached = peak(sorted.kept.iter().map(TensionPoint::plane_stretch));
    let within = sorted
        .kept
        .into_iter()
        .filter(|p| p.plane_stretch() <= limit);
    let is_fitted =
        |p: &TensionPoint| settings.fit_modes.is_empty() || settings.fit_modes.contains(&p.mode);
    let (used, held_out): (Vec<TensionPoint>, Vec<TensionPoint>) = within.partition(is_fitted);
    let problem = Problem::new(
        used,
        settings.measure,
        settings.balance,
        &settings.mode_weights,
    );
    let count = problem.counting();
    let forms = chosen(settings, count)?;
    let modulus_mpa = problem.modulus_mpa;
    if !(modulus_mpa > 0.0 && modulus_mpa.is_finite()) {
        return Err(TensionFitError::Refused(format!(
            "the points give a modulus of {modulus_mpa} MPa: stress must be above zero where the \
             stretch is above 1; check the columns and their signs"
        )));
    }
    let fitted_to_stretch = problem.fitted_to_stretch();
    let mut laws = vec![];
    let mut failed = vec![];
    for (done, form) in forms.iter().enumerate() {
        progress.report(done, forms.len());
        progress.check()?;
        match fitted::laws(*form, &problem, settings) {
            Ok(fitted) => laws.push(fitted),
            Err(error) => failed.push(error),
        }
        cancel::check()?;
    }
    // The free and the stable fit of one law are neighbours.
    laws.sort_by_number(|a| a[0].quality.aicc);
    let mut laws: Vec<FittedLaw> = laws.into_iter().flatten().collect();
    for law in &mut laws {
        law.held_out = fitted::errors(&law.law, &held_out, settings.hoop_stretch);
    }
    if let (true, Some(error)) = (laws.is_empty(), failed.first()) {
        return Err(error.clone());
    }
    let recommended = standing::recommended(&laws, &problem.points);
    warnings.extend(warning::for_points(
        &problem,
        fitted_to_stretch,
        settings.hoop_stretch,
    ));
    warnings.extend(
        laws.iter()
            .flat_map(|l| warning::for_law(l, settings.hoop_stretch)),
    );
    Ok(TensionFit {
        points: problem.points,
        left_out: points.len() - count - held_out.len(),
        left_out_to_stretch: Some(reached).filter(|stretch| *stretch > limit),
        held_out,
        fitted_to_stretch,
        laws,
        failed,
        recommended,
        warnings,
    })
}

fn check(settings: &FitSettings) -> Result<()> {
    let bad = |what, value, expected| {
        Err(TensionFitError::Refused(format!(
            "{what} is {value}; it must be {expected}"
        )))
    };
    if !(settings.hoop_stretch > 1.0 && settings.hoop_stretch <= 10.0) {
        return bad(
            "the hoop stretch",
            settings.hoop_stretch,
            "above 1 and at most 10",
        );
    }
    if let Some(limit) = settings
        .up_to_stretch
        .filter(|l| !(*l > 1.0 && l.is_finite()))
    {
        return bad(
            "the largest stretch",
            limit,
            "above 1 (a stretch, or a strain such as 200%)",
        );
    }
    match settings
        .mode_weights
        .iter()
        .find(|w| !(w.1 >= 0.0 && w.1.is_finite()))
    {
        Some(w) => bad("a weight", w.1, "zero or above"),
        None => Ok(()),
    }
}

/// The requested laws, or all, that the number of points determines.
fn chosen(settings: &FitSettings, points: usize) -> Result<Vec<Form>> {
    let mut forms = if settings.forms.is_empty() {
        Form::all()
    } else {
        settings.forms.clone()
    };
    let first = forms.first().copied();
    forms.retain(|f| points >= f.fewest_points());
    match first.filter(|_| forms.is_empty()) {
        Some(first) => Err(TensionFitError::TooFew {
            points,
            law: first.name(),
            fewest: first.fewest_points(),
        }),
        None => Ok(forms),
    }
}

pub(crate) type Result<T, E = TensionFitError> = std::result::Result<T, E>;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TensionFitError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// Not enough points for a law.
    #[error("{points} points are too few for {law}: it takes {fewest} or more")]
    TooFew {
        /// Points that count.
        points: usize,
        /// Its name.
        law: String,
        /// Points that it takes.
        fewest: usize,
    },
    /// A term too many.
    #[error("{0}: this number of terms fits these data no better than fewer terms")]
    NoBetter(String),
    /// The work was ended.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No minimum was found of a law, and why.
    #[error("{0}: no fit was found: {1}")]
    NotConverged(String, String),
}

/// The error of a law without a fit.
pub(crate) fn no_fit(form: Form, why: impl std::fmt::Display) -> TensionFitError {
    TensionFitError::NotConverged(form.name(), why.to_string())
}

/// Settings of a fit.
#[derive(Debug, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct FitSettings {
    /// The laws; none means all that the number of points determines.
    pub forms: Vec<Form>,
    /// What is minimised: absolute or relative differences.
    pub measure: Measure,
    /// Give every mode the same weight, whatever its number of points. Else every point counts
    /// alike.
    pub balance: bool,
    /// A factor on the weights of a mode.
    pub mode_weights: Vec<(Mode, f64)>,
    /// Modes that are fitted; none means all. The others are held out, and their errors are given.
    pub fit_modes: Vec<Mode>,
    /// Points up to this stretch only; none means all.
    pub up_to_stretch: Option<f64>,
    /// The points are a history: a stress that falls is no rupture, and all points are fitted.
    pub history: bool,
    /// Laws that are stable in a muscle only.
    pub stable: bool,
    /// Largest hoop stretch of the muscle.
    pub hoop_stretch: f64,
}

impl Default for FitSettings {
    fn default() -> Self {
        Self {
            forms: vec![],
            measure: Measure::Absolute,
            balance: false,
            mode_weights: vec![],
            fit_modes: vec![],
            up_to_stretch: Some(MUSCLE_HOOP_STRETCH),
            history: false,
            stable: false,
            hoop_stretch: MUSCLE_HOOP_STRETCH,
        }
    }
}

#[cfg(test)]
mod tests;
