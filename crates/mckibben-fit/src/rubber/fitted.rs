//! A law with its constants and its errors.

use super::{
    FitSettings, Mode, Result, TensionPoint, linear, no_fit, nonlinear, ogden,
    problem::{Problem, Raw},
};
use crate::least_squares::{Errors, aicc, t95};
use mckibben_core::rubber::{
    ConstantValue, Form, Law, LawConstants, Ogden, RubberLaw, is_stable_at, muscle_unstable_from,
};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// A constant.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Parameter {
    /// As in muscle files; `mu1`, `alpha1` for terms.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// What it is, in a few words.
    pub meaning: &'static str,
    /// `MPa` or nothing.
    pub unit: &'static str,
    /// Standard error; 0 on a bound, `None` where the data do not determine it at all.
    pub standard_error: Option<f64>,
    /// Whether the data determine it: it is not on a bound, and its 95 % interval does not reach
    /// zero or (constants that may be zero) is so narrow that it moves the stress at the end of the
    /// data by less than a quarter of the modulus.
    pub identifiable: bool,
}

/// Differences of nominal stress over some points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct StressErrors {
    /// How many points.
    pub points: usize,
    /// Largest stretch of them in the plane of the specimen.
    pub to_stretch: f64,
    /// Root mean square of the differences, in MPa.
    pub rms_mpa: f64,
    /// The same over the root mean square of the measured stresses.
    pub relative: f64,
    /// Mean of measured − computed, in MPa.
    pub bias_mpa: f64,
    /// Largest difference, in MPa.
    pub largest_mpa: f64,
}

impl StressErrors {
    /// The errors of computed stresses, from stretches, measured and computed stresses.
    pub fn new(list: impl Iterator<Item = (f64, f64, f64)>) -> Self {
        let mut differences = vec![];
        let mut to_stretch = 0.0_f64;
        let mut all = 0.0;
        for (stretch, measured, computed) in list {
            differences.push(measured - computed);
            to_stretch = to_stretch.max(stretch);
            all += measured * measured;
        }
        let errors = Errors::new(differences);
        let relative = if all > 0.0 {
            (errors.squares / all).sqrt()
        } else {
            0.0
        };
        Self {
            points: errors.points,
            to_stretch,
            rms_mpa: errors.rms,
            relative,
            bias_mpa: errors.mean,
            largest_mpa: errors.largest,
        }
    }

    /// The errors of a law at some points.
    pub fn for_law<'a>(law: &Law, points: impl Iterator<Item = &'a TensionPoint>) -> Self {
        Self::new(points.map(|p| (p.plane_stretch(), p.nominal_stress_mpa, p.stress_mpa(law))))
    }
}

/// The errors of a law in one of the tests.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ModeError {
    /// The test.
    pub mode: Mode,
    #[serde(flatten)]
    pub errors: StressErrors,
    /// Stretch up to which the law is stable in this test, where it ends below the larger of the
    /// data's and the muscle's.
    #[serde(rename = "unstable_from_stretch")]
    pub stable_to_stretch: Option<f64>,
}

/// A fitted law.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "LawAnswer")]
pub struct FittedLaw {
    /// Which law.
    #[serde(flatten, serialize_with = "names")]
    #[schemars(with = "FormNames")]
    pub form: Form,
    /// Whether it was held among the laws that are stable in a muscle.
    pub constrained: bool,
    /// Quality of the fit.
    #[serde(flatten)]
    pub quality: LawQuality,
    /// Its constants.
    pub parameters: Vec<Parameter>,
    /// Its errors by mode.
    pub modes: Vec<ModeError>,
    /// Its errors in modes that were held out, and over their points in whose state a muscle's wall
    /// may be.
    pub held_out: Vec<HeldOutError>,
    /// The law with its constants; they may be no sound rubber where `constrained` is false.
    #[serde(skip)]
    pub law: Law,
}

/// Quality of the fit of a law, and its range of stability.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LawQuality {
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// R²: of the nominal stresses.
    pub r_squared: f64,
    /// R² of the free fit, where this one was held.
    pub free_r_squared: Option<f64>,
    /// Root mean square of the differences of nominal stress, MPa.
    pub rms_mpa: f64,
    // Of points that pull; of general tests over the larger of the two stresses that the
    // neo-Hookean law which follows all points best has in that state.
    /// Root mean square of the differences, as a share of the measured stress.
    pub relative_rms: f64,
    /// The largest of them, as such a share.
    pub largest_relative: f64,
    /// AICc: Akaike's criterion for small samples.
    pub aicc: f64,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// Whether it is stable in a muscle.
    pub stable: bool,
    /// Hoop stretch from which on it is not.
    pub unstable_from_hoop_stretch: Option<f64>,
}

/// A form as its two names.
#[derive(Serialize, JsonSchema)]
struct FormNames {
    /// The law, as in muscle files.
    law: &'static str,
    /// The same with the number of its terms.
    name: String,
}

fn names<S: Serializer>(form: &Form, serializer: S) -> Result<S::Ok, S::Error> {
    FormNames {
        law: form.law(),
        name: form.name(),
    }
    .serialize(serializer)
}

impl FittedLaw {
    /// Whether a muscle can be computed with it: stable there, and no C01 below zero.
    pub fn is_trusted(&self) -> bool {
        self.quality.stable && self.law.negative_c01_mpa().is_none()
    }

    /// How the law is held stable, where it is; in words behind its name.
    pub fn stability_words(&self) -> &'static str {
        if self.form.law() == linear::HELD_POSITIVE {
            "with C01 not below 0"
        } else if self.law.locks_at().is_some() {
            "with a limit beyond the muscle's stretches"
        } else {
            "among its stable laws"
        }
    }
}

/// The free fit and, where that is unstable in a muscle, the stable one; or the stable one alone.
pub fn laws(form: Form, problem: &Problem, settings: &FitSettings) -> Result<Vec<FittedLaw>> {
    let hoop = settings.hoop_stretch;
    let fit = |held: bool| {
        let raw = match form.basis() {
            Some(basis) if held => linear::stable(form, &basis, problem, hoop)?,
            Some(basis) => linear::free(form, &basis, problem)?,
            None if form.law() == Ogden::NAME => ogden::fit(form, problem)?,
            None => nonlinear::fit(form, problem, held.then_some(hoop))?,
        };
        judged(form, held, raw, problem, hoop)
    };
    let free = fit(false)?;
    if free.is_trusted() {
        return Ok(vec![free]);
    }
    let free_r_squared = Some(free.quality.r_squared);
    let beside = |held: FittedLaw| {
        let quality = LawQuality {
            free_r_squared,
            ..held.quality
        };
        FittedLaw { quality, ..held }
    };
    let held = fit(true).map(beside);
    if settings.stable {
        Ok(vec![held?])
    } else {
        Ok([Some(free), held.ok()].into_iter().flatten().collect())
    }
}

fn judged(
    form: Form,
    constrained: bool,
    raw: Raw,
    problem: &Problem,
    hoop: f64,
) -> Result<FittedLaw> {
    let law = form
        .law_of(&raw.constants)
        .ok_or_else(|| no_fit(form, "its constants are not complete"))?;
    let squares = problem
        .squares(&law)
        .filter(|s| s.is_finite())
        .ok_or_else(|| no_fit(form, "its stresses are not finite"))?;
    let points = &problem.points;
    let off = |p: &TensionPoint| p.stress_mpa(&law) - p.nominal_stress_mpa;
    let average = points.iter().map(|p| p.nominal_stress_mpa).sum::<f64>() / points.len() as f64;
    let from_average = |p: &TensionPoint| (p.nominal_stress_mpa - average).powi(2);
    let spread: f64 = points.iter().map(from_average).sum();
    let left = Errors::new(points.iter().map(off));
    let relative =
        |p: &TensionPoint| Some(off(p) / p.reference_mpa(problem.reference_modulus_mpa)?);
    let relative = Errors::new(points.iter().filter_map(relative));
    let modes = Mode::ALL.into_iter();
    let unstable_from_hoop_stretch = muscle_unstable_from(&law, hoop);
    let counting = problem.counting();
    let quality = LawQuality {
        shear_modulus_mpa: law.shear_modulus_mpa(),
        r_squared: if spread > 0.0 {
            1.0 - left.squares / spread
        } else {
            0.0
        },
        free_r_squared: None,
        rms_mpa: left.rms,
        relative_rms: relative.rms,
        largest_relative: relative.largest,
        aicc: aicc(counting, form.constants(), squares / counting as f64),
        fitted_to_stretch: problem.fitted_to_stretch(),
        stable: unstable_from_hoop_stretch.is_none() && law.clone().validated().is_ok(),
        unstable_from_hoop_stretch,
    };
    Ok(FittedLaw {
        form,
        constrained,
        quality,
        parameters: parameters(&law, &raw),
        modes: modes
            .filter_map(|mode| mode_error(mode, &law, problem, hoop))
            .collect(),
        held_out: vec![],
        law,
    })
}

/// The constants of a law with their errors.
fn parameters(law: &Law, raw: &Raw) -> Vec<Parameter> {
    let t = t95(raw.freedom);
    let one = |(i, constant): (usize, ConstantValue)| {
        let error = raw.standard_errors[i];
        let value = constant.value;
        let narrow = t * error <= value.abs().max(0.25 * raw.scales[i]);
        Parameter {
            name: constant.name,
            value,
            meaning: constant.constant.doc,
            unit: constant.constant.unit(),
            standard_error: error.is_finite().then_some(error),
            identifiable: narrow && !raw.at_bound[i],
        }
    };
    law.constants().into_iter().enumerate().map(one).collect()
}

fn mode_error(mode: Mode, law: &Law, problem: &Problem, hoop: f64) -> Option<ModeError> {
    let errors = StressErrors::for_law(law, problem.points.iter().filter(|p| p.mode == mode));
    (errors.points > 0).then_some(ModeError {
        mode,
        errors,
        stable_to_stretch: stable_to(mode, law, errors.to_stretch.max(hoop)),
    })
}

/// Stretch from which on a law is unstable in a test, walking from rest.
fn stable_to(mode: Mode, law: &Law, end: f64) -> Option<f64> {
    const STEPS: u32 = 400;
    let stretch = |i: u32| 1.0 + (end - 1.0) * f64::from(i) / f64::from(STEPS);
    let unstable = |l: &f64| {
        mode.across(*l)
            .is_some_and(|across| !is_stable_at(law, *l, across))
    };
    (0..=STEPS).map(stretch).find(unstable)
}

/// The errors of a law in tests that it was not fitted to.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HeldOutError {
    /// The test; null for the points of all of them in whose state a muscle's wall may be.
    pub mode: Option<Mode>,
    #[serde(flatten)]
    pub errors: StressErrors,
    /// Share by which the law is too stiff (above zero) or too soft: Σ P Pm/Σ Pm² − 1.
    pub stiffer: f64,
}

fn held_out_error(mode: Option<Mode>, law: &Law, points: &[&TensionPoint]) -> Option<HeldOutError> {
    let mut both = 0.0;
    let mut all = 0.0;
    for p in points {
        both += p.stress_mpa(law) * p.nominal_stress_mpa;
        all += p.nominal_stress_mpa * p.nominal_stress_mpa;
    }
    let errors = StressErrors::for_law(law, points.iter().copied());
    let stiffer = both / all - 1.0;
    // Beyond the stretch at which a law locks it has no stress.
    let sound =
        errors.relative.is_finite() && stiffer.is_finite() && law.shear_modulus_mpa().is_finite();
    (!points.is_empty() && sound).then_some(HeldOutError {
        mode,
        errors,
        stiffer,
    })
}

/// By mode, and over the states of a muscle up to a hoop stretch.
pub fn errors(law: &Law, points: &[TensionPoint], hoop: f64) -> Vec<HeldOutError> {
    let of = |mode: Option<Mode>| {
        let is_of = |p: &&TensionPoint| match mode {
            Some(mode) => p.mode == mode,
            None => p.is_of_a_muscle(hoop),
        };
        held_out_error(mode, law, &points.iter().filter(is_of).collect::<Vec<_>>())
    };
    Mode::ALL
        .map(Some)
        .into_iter()
        .chain([None])
        .filter_map(of)
        .collect()
}
