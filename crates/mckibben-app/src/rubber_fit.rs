//! `rubber fit`: laws from tension tests.

use crate::fields::{Columns, TextFile, UnderstoodTable};
use crate::figure;
use crate::muscle::muscle_of;
use crate::point::finite;
use crate::problem::{Problem, ProblemKind};
use crate::rubber_over_time::{PronyAnswer, SofteningAnswer, relaxation, softening};
use mckibben::budget::Resource;
use mckibben::muscle::file::to_toml;
use mckibben::muscle::{Muscle, Rubber};
use mckibben::progress::Progress;
use mckibben::rubber::{RubberLaw, Stability};
use mckibben_fit::rubber::{
    FitSettings, FittedLaw, Form, HeldOutError, Measure, Mode, ModeError, Parameter, ReadOptions, TensionFit,
    TensionFitError, fit_tension_with, read_tests,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// Tension tests, and the laws to fit.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct RubberFitRequest {
    /// Tension tests: a table of stretches, strains or extensions, and of stresses or forces, with their units; where it has
    /// one, of modes.
    pub data: Option<TextFile>,
    /// Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    pub columns: Columns,
    /// Laws by name, or `all`; all that the points determine if none is named.
    pub laws: Vec<String>,
    /// Terms of `ogden`; default 1, 2 and 3.
    pub terms: Option<usize>,
    /// How the specimens were stretched, where the table has no column `mode`; with a column `stretch_2` that is `general`.
    pub mode: Mode,
    /// Cross-section of the specimen at rest, mm², for a column of forces.
    pub area_mm2: Option<f64>,
    /// Length of the specimen at rest, mm, for a column of extensions or lengths.
    pub gauge_length_mm: Option<f64>,
    /// Modes to fit; default: all. The others are held out, and the answer gives the errors of each law there.
    pub fit_modes: Vec<Mode>,
    /// Leave out points beyond this stretch.
    pub up_to_stretch: Option<f64>,
    /// Minimise relative differences: small stretches count as much as large ones.
    pub relative: bool,
    /// Give every mode the same weight, whatever its number of points.
    pub balance: bool,
    /// Weights of the modes.
    pub weights: BTreeMap<Mode, f64>,
    /// Fit only laws that stay stable in a muscle.
    pub stable: bool,
    /// Hoop stretch of the muscle up to which a law must be stable; default 3.
    pub hoop_stretch: Option<f64>,
    /// Branches of a Prony series that is fitted as well, 1 to 8, from a column of times: one specimen, uniaxial, from rest on.
    /// Of the one law of `laws`, else of the recommended one.
    pub relaxation: Option<usize>,
    /// Softening by Ogden and Roxburgh is fitted as well, from a column of times that begins with the first loading. Of the same law.
    pub softening: bool,
    /// Name of the rubber in the muscle file; default that of the table.
    pub name: Option<String>,
    /// Muscle that receives the rubber; default: the prototype.
    pub muscle: Option<TextFile>,
    /// Add a figure to the answer.
    pub figure: bool,
}

/// The laws of the tests.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RubberFitAnswer {
    /// The table.
    pub data: String,
    /// What was understood of it.
    pub understood: Vec<UnderstoodTable>,
    /// Points that were fitted.
    pub points: usize,
    /// Points that were left out.
    pub left_out: usize,
    /// Points of modes that were held out.
    pub held_out: usize,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// The objective of the fit.
    pub measure: Measure,
    /// Whether every mode had the same weight.
    pub balance: bool,
    /// The law to take, where one is stable in a muscle.
    pub recommended: Option<String>,
    /// Constants of that law.
    pub parameters: Vec<Parameter>,
    /// The laws.
    pub laws: Vec<LawAnswer>,
    /// Laws without a fit, and why.
    pub failed: Vec<String>,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Relaxation, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relaxation: Option<PronyAnswer>,
    /// Softening, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub softening: Option<SofteningAnswer>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
    /// The request.
    #[serde(skip)]
    pub settings: FitSettings,
    /// What was found.
    #[serde(skip)]
    pub fit: TensionFit,
    /// The muscle that gets the rubber.
    #[serde(skip)]
    base: Muscle,
    /// The name of the rubber in it.
    #[serde(skip)]
    name: Option<String>,
}

/// A fitted law.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LawAnswer {
    /// The law, as in muscle files.
    pub law: String,
    /// The same with the number of its terms.
    pub name: String,
    /// Whether it was held among the laws that are stable in a muscle.
    pub constrained: bool,
    /// Quality of the fit.
    #[serde(flatten)]
    pub quality: LawQuality,
    /// Its constants.
    pub parameters: Vec<Parameter>,
    /// Its errors by mode.
    pub modes: Vec<ModeError>,
    /// Its errors in modes that were held out, and over their points in whose state a muscle's wall may be.
    pub held_out: Vec<HeldOutError>,
}

/// Quality of the fit of a law, and its range of stability.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LawQuality {
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// R² of the nominal stresses.
    pub r_squared: f64,
    /// R² of the free fit, where this one was held.
    pub free_r_squared: Option<f64>,
    /// Root mean square of the differences of nominal stress, MPa.
    pub rms_mpa: f64,
    /// Root mean square of the differences over the measured stress.
    pub relative_rms: f64,
    /// Akaike's criterion for small samples.
    pub aicc: f64,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// Whether it is stable in a muscle.
    pub stable: bool,
    /// Hoop stretch from which on it is not.
    pub unstable_from_hoop_stretch: Option<f64>,
}

/// A constant with the law that it belongs to: a row of a table.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ConstantRow {
    law: String,
    constrained: bool,
    recommended: bool,
    constant: String,
    value: f64,
    unit: &'static str,
    standard_error: Option<f64>,
    identifiable: bool,
    #[serde(flatten)]
    quality: LawQuality,
}

impl RubberFitAnswer {
    /// The constants of all laws, one row each.
    pub fn constants(&self) -> Vec<ConstantRow> {
        let rows = |(i, law): (usize, &LawAnswer)| {
            let recommended = self.fit.recommended == Some(i);
            let row = |p: &Parameter| ConstantRow {
                law: law.name.clone(),
                constrained: law.constrained,
                recommended,
                constant: p.name.clone(),
                value: p.value,
                unit: p.unit,
                standard_error: p.standard_error,
                identifiable: p.identifiable,
                quality: law.quality,
            };
            law.parameters.iter().map(row).collect::<Vec<_>>()
        };
        self.laws.iter().enumerate().flat_map(rows).collect()
    }

    /// A muscle file with the recommended law. With a softening it is the law of the first loading, with a relaxation alone the one at once,
    /// each with its constants.
    ///
    /// # Errors
    /// [`Problem`] of kind `no_answer` where no law is stable in a muscle.
    pub fn muscle_file(&self) -> Result<String, Problem> {
        let taken = self.fit.recommended.and_then(|i| self.fit.laws.get(i)).ok_or_else(|| {
            let message =
                "none of these laws is stable over the stretches of a muscle; no muscle file is written";
            Problem::new(ProblemKind::NoAnswer, message, "add `stable`, or take `laws` neo-hookean")
        })?;
        let relaxation = self.relaxation.as_ref().map(|r| &r.found);
        let softening = self.softening.as_ref().map(|s| &s.found);
        let over_time = softening.map(|s| &s.0).or(relaxation.map(|r| &r.0));
        let mut tube = self.base.tube().clone();
        tube.rubber = Rubber {
            name: self.name.clone(),
            // 1 + strain has digits that nobody measured.
            fitted_to_stretch: Some((self.fit.fitted_to_stretch * 1e4).round() / 1e4),
            softening: softening.map(|s| s.1),
            prony: relaxation.map(|r| r.1.clone()),
            ..Rubber::of(over_time.unwrap_or(&taken.law).clone())
        };
        Ok(to_toml(&self.base.with_tube(tube)?))
    }
}

const APART: &str = "softening and relaxation were fitted separately, each without the other: relaxation during the test counts as softening, and the \
     reverse; the muscle file has the law of the first loading with both";

/// The laws that follow the tests, with the errors of their constants, and where they are stable.
///
/// # Errors
/// [`Problem`].
pub fn rubber_fit(request: &RubberFitRequest, progress: &dyn Progress) -> Result<RubberFitAnswer, Problem> {
    let settings = request.settings()?;
    let base = request.muscle.as_ref().map_or_else(|| Ok(Muscle::prototype()), muscle_of)?;
    let file = request.data.as_ref().ok_or_else(|| Problem::missing("data", "a table of tension tests"))?;
    let options = ReadOptions {
        mode: request.mode,
        area_mm2: positive("area_mm2", request.area_mm2)?,
        gauge_length_mm: positive("gauge_length_mm", request.gauge_length_mm)?,
    };
    let (points, table) = read_tests(file.text.as_bytes(), options, &request.columns)
        .map_err(|error| Problem::of_table(&file.name, &error))?;
    let has = |quantities: &[&str]| table.columns.iter().any(|c| quantities.contains(&c.quantity.as_str()));
    let area = request.area_mm2.is_some() && !has(&["force"]);
    Problem::refuse_unused(&[("area_mm2", area)], "the table has stresses, and no `columns` of forces")?;
    let gauge = request.gauge_length_mm.is_some() && !has(&["extension", "length"]);
    let why = "the table has stretches or strains, and no `columns` of extensions or lengths";
    Problem::refuse_unused(&[("gauge_length_mm", gauge)], why)?;
    progress.budget().admit(Resource::Points, points.len() as f64)?;
    let fit = fit_tension_with(&points, &settings, progress)?;
    let taken = fit.recommended.and_then(|i| fit.laws.get(i));
    let form = || match (settings.forms.as_slice(), taken) {
        ([form], _) => Ok(*form),
        (_, Some(law)) => Ok(law.form),
        _ => {
            let message =
                "none of these laws is stable over the stretches of a muscle; none is fitted over time";
            Err(Problem::new(ProblemKind::NoAnswer, message, "take `laws` with one law"))
        }
    };
    let of_branches = |n| relaxation(file, &request.columns, form()?, n);
    let relaxation = request.relaxation.map(of_branches).transpose()?;
    let softens = || softening(file, &request.columns, form()?);
    let softening = request.softening.then(softens).transpose()?;
    let mut warnings: Vec<String> = fit.warnings.iter().map(ToString::to_string).collect();
    if relaxation.is_some() && softening.is_some() {
        warnings.push(APART.into());
    }
    let stem = || Path::new(&file.name).file_stem().map(|s| s.to_string_lossy().into_owned());
    Ok(RubberFitAnswer {
        data: file.name.clone(),
        understood: vec![UnderstoodTable { data: file.name.clone(), table }],
        points: fit.points.len(),
        left_out: fit.left_out,
        held_out: fit.held_out.len(),
        fitted_to_stretch: fit.fitted_to_stretch,
        measure: settings.measure,
        balance: settings.balance,
        recommended: taken.map(|law| law.form.name()),
        parameters: taken.map_or_else(Vec::new, |law| law.parameters.clone()),
        laws: fit.laws.iter().map(|law| LawAnswer::new(law, fit.fitted_to_stretch)).collect(),
        failed: fit.failed.iter().map(ToString::to_string).collect(),
        warnings,
        relaxation,
        softening,
        figure: request.figure.then(|| figure::tension(&fit, &file.name)),
        name: request.name.clone().or_else(stem),
        settings,
        fit,
        base,
    })
}

impl LawAnswer {
    fn new(law: &FittedLaw, fitted_to_stretch: f64) -> Self {
        Self {
            law: law.form.law().into(),
            name: law.form.name(),
            constrained: law.constrained,
            quality: LawQuality {
                shear_modulus_mpa: law.law.shear_modulus_mpa(),
                r_squared: law.r_squared,
                free_r_squared: law.free_r_squared,
                rms_mpa: law.rms_mpa,
                relative_rms: law.relative_rms,
                aicc: law.aicc,
                fitted_to_stretch,
                stable: law.is_stable(),
                unstable_from_hoop_stretch: match law.stability {
                    Stability::Stable => None,
                    Stability::UnstableFrom { hoop_stretch } => Some(hoop_stretch),
                },
            },
            parameters: law.parameters.clone(),
            modes: law.modes.clone(),
            held_out: law.held_out.clone(),
        }
    }
}

fn positive(field: &str, value: Option<f64>) -> Result<Option<f64>, Problem> {
    match value {
        Some(v) if finite(field, v)? <= 0.0 => {
            let message = format!("{v}; it must be above zero");
            Err(Problem::new(ProblemKind::Quantity, message, "").in_field(field))
        }
        value => Ok(value),
    }
}

impl RubberFitRequest {
    fn settings(&self) -> Result<FitSettings, Problem> {
        let usual = FitSettings::default();
        Ok(FitSettings {
            forms: self.forms()?,
            measure: if self.relative { Measure::Relative } else { Measure::Absolute },
            balance: self.balance,
            mode_weights: self.weights.iter().map(|(&mode, &weight)| (mode, weight)).collect(),
            fit_modes: self.fit_modes.clone(),
            up_to_stretch: self.up_to_stretch,
            history: self.relaxation.is_some() || self.softening,
            stable: self.stable,
            hoop_stretch: self.hoop_stretch.unwrap_or(usual.hoop_stretch),
        })
    }

    /// The laws that are asked for; none means all that the points determine.
    fn forms(&self) -> Result<Vec<Form>, Problem> {
        let mut forms: Vec<Form> = vec![];
        if self.laws.is_empty() && self.terms.is_none() {
            return Ok(forms);
        }
        let several = |word: &String| {
            word.trim() == "all" || Form::parse(word).iter().any(|form| form.terms().is_some())
        };
        let alone = self.terms.is_some() && !self.laws.is_empty() && !self.laws.iter().any(several);
        Problem::refuse_unused(&[("terms", alone)], "none of these `laws` has a selectable number of terms")?;
        let all = ["all".to_owned()];
        for word in if self.laws.is_empty() { &all[..] } else { &self.laws } {
            let found = if word.trim() == "all" { Form::all() } else { Form::parse(word) };
            if found.is_empty() {
                let short: String = word.trim().chars().take(60).collect();
                let hint = format!("known: {}, all", Form::words().join(", "));
                let message = format!("there is no law \"{short}\"");
                return Err(Problem::new(ProblemKind::Rubber, message, hint).in_field("laws"));
            }
            for form in found {
                let wanted = form.terms().is_none_or(|n| self.terms.is_none_or(|wanted| n == wanted));
                if wanted && !forms.contains(&form) {
                    forms.push(form);
                }
            }
        }
        if forms.is_empty() {
            let message = "none of these laws has this number of terms";
            let hint = "leave `terms` out, or take `laws` ogden";
            return Err(Problem::new(ProblemKind::Usage, message, hint).in_field("terms"));
        }
        Ok(forms)
    }
}

impl From<TensionFitError> for Problem {
    fn from(error: TensionFitError) -> Self {
        let (kind, hint) = match error {
            TensionFitError::Ended(exceeded) => return exceeded.into(),
            TensionFitError::NotConverged { .. } => (ProblemKind::NotConverged, ""),
            TensionFitError::NoBetter { .. } => (ProblemKind::NoAnswer, "take `terms` with a smaller number"),
            TensionFitError::TooFew { .. } => {
                (ProblemKind::Fit, "take a law with fewer constants, or leave `up_to_stretch` out")
            }
            _ => (ProblemKind::Fit, ""),
        };
        Self::new(kind, error.to_string(), hint)
    }
}
