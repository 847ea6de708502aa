//! `rubber`: laws from tension tests.

mod page;

use crate::{
    Columns, Count, DataFields, Problem, ProblemKind, Result, TextFile, UnderstoodTable, figure,
    flags::{self, Args},
    muscle_of, readable,
};
use mckibben_core::units::typed::Ratio;
use mckibben_core::{
    muscle::{Muscle, Rubber, file::to_toml},
    progress::Progress,
    rubber::over_time::OgdenRoxburgh,
    size,
    warning::Warning,
};
use mckibben_fit::{
    rubber::{
        FitSettings, FittedLaw, Form, LawQuality, Measure, Mode, Parameter, fit_tension_with,
        read_tests,
    },
    rubber_over_time::{PronyFit, SofteningFit, fit_prony, fit_softening, read_history},
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, path::Path};

/// Tension tests, and the laws to fit.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct RubberFitRequest {
    /// The tests: one table or several, each with its mode and dimensions in `set`, where its
    /// columns do not state them.
    #[serde(flatten)]
    #[command(flatten)]
    pub tables: DataFields,
    /// Laws by name, or `all` [all that the points determine]
    #[arg(long = "law", value_name = "LIST", value_delimiter = ',', value_parser = flags::laws())]
    pub laws: Vec<String>,
    /// Leave out points beyond this stretch (3) or strain (200%) [that of a muscle]
    #[arg(long = "up-to", value_name = "STRETCH", value_parser = flags::stretch, allow_hyphen_values = true)]
    pub up_to_stretch: Option<f64>,
    /// Branches of a Prony series that is fitted as well, from a column of times
    ///
    /// One specimen, uniaxial, from rest on. Of the one law of `laws`, else of the recommended one.
    #[arg(long, value_name = "N")]
    pub relaxation: Option<Count<1, 8>>,
    /// Fit softening by Ogden and Roxburgh as well, from a column of times that begins with the
    /// first loading
    #[arg(long)]
    pub softening: bool,
    /// Muscle that receives the rubber [the prototype]
    #[arg(long, value_name = "FILE", value_parser = flags::muscle_file, help_heading = "Muscle")]
    pub muscle: Option<TextFile>,
    /// Name of the rubber in the muscle file [that of the first table]
    #[arg(long, help_heading = "Muscle")]
    pub name: Option<String>,
    /// Terms of `ogden` [1, 2 and 3]
    #[arg(long, value_name = "N", help_heading = "Advanced")]
    pub terms: Option<Count<1, 3>>,
    /// Modes to fit [all]
    ///
    /// The others are held out, and the answer gives the errors of each law there.
    #[arg(long = "fit-mode", value_name = "LIST", value_delimiter = ',', value_parser = flags::word::<Mode>(), help_heading = "Advanced")]
    pub fit_modes: Vec<Mode>,
    /// Minimise relative differences: small stretches count as much as large ones
    #[arg(long, help_heading = "Advanced")]
    pub relative: bool,
    /// Give every mode the same weight, whatever its number of points
    #[arg(long, help_heading = "Advanced")]
    pub balance: bool,
    /// Weights of the modes: uniaxial=1,equibiaxial=2
    #[arg(long, value_name = "LIST", value_parser = weights, default_value = "", hide_default_value = true, help_heading = "Advanced")]
    pub weights: BTreeMap<Mode, f64>,
    /// Fit only laws that stay stable in a muscle
    #[arg(long, help_heading = "Advanced")]
    pub stable: bool,
    /// Hoop stretch of the muscle up to which a law must be stable [3]
    #[arg(long, value_name = "STRETCH", help_heading = "Advanced")]
    pub hoop_stretch: Option<f64>,
    /// Add a figure to the answer.
    #[arg(skip)]
    pub figure: bool,
}

/// The laws of the tests.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct RubberFitAnswer {
    /// What was understood of them.
    pub understood: Vec<UnderstoodTable>,
    /// Points that were fitted.
    pub points: usize,
    /// Points that were left out.
    pub left_out: usize,
    /// Largest stretch of those beyond `up_to_stretch`, or beyond the stretches of a muscle.
    pub left_out_to_stretch: Option<f64>,
    /// Points of modes that were held out.
    pub held_out: usize,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// The objective of the fit.
    pub measure: Measure,
    /// The law to take, where one is stable in a muscle.
    #[serialize_always]
    pub recommended: Option<String>,
    /// Constants of that law.
    pub parameters: Vec<Parameter>,
    /// The laws.
    pub laws: Vec<FittedLaw>,
    /// Laws without a fit, and why.
    pub failed: Vec<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Muscle file with that law. With a softening it is the law of the first loading, with a
    /// relaxation alone the one at once, each with its constants.
    pub muscle_file: Option<String>,
    /// Hoop stretch of the muscle up to which the laws were examined.
    #[serde(skip)]
    pub hoop_stretch: f64,
    /// Relaxation, if requested.
    pub relaxation: Option<PronyFit>,
    /// Softening, if requested.
    pub softening: Option<SofteningFit>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

/// A constant with the law that it belongs to: a row of a table.
#[derive(Serialize, JsonSchema)]
struct ConstantRow {
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
    /// Whether a law is the one to take.
    pub fn is_recommended(&self, law: &FittedLaw) -> bool {
        law.is_trusted() && self.recommended.as_ref() == Some(&law.form.name())
    }

    /// The law to take, where one is stable in a muscle.
    pub fn taken(&self) -> Option<&FittedLaw> {
        self.laws.iter().find(|law| self.is_recommended(law))
    }

    /// The constants of all laws, one row each.
    fn constants(&self) -> Vec<ConstantRow> {
        let rows = |law: &FittedLaw| {
            let row = |p: &Parameter| ConstantRow {
                law: law.form.name(),
                constrained: law.constrained,
                recommended: self.is_recommended(law),
                constant: p.name.clone(),
                value: p.value,
                unit: p.unit,
                standard_error: p.standard_error,
                identifiable: p.identifiable,
                quality: law.quality,
            };
            law.parameters.iter().map(row).collect::<Vec<_>>()
        };
        self.laws.iter().flat_map(rows).collect()
    }

    /// The muscle with a law.
    fn with_law(&self, law: &FittedLaw, muscle: &Muscle, rubber: Option<String>) -> Result<String> {
        let relaxation = self.relaxation.as_ref();
        let softening = self.softening.as_ref();
        let over_time = softening
            .map(|s| &s.first_loading)
            .or(relaxation.map(|r| &r.instantaneous));
        let stem = || {
            let stem = Path::new(&self.understood.first()?.data).file_stem()?;
            Some(stem.to_string_lossy().into_owned())
        };
        let mut tube = muscle.tube().clone();
        tube.rubber = Rubber {
            name: rubber.or_else(stem),
            // 1 + strain has more digits than the measurement.
            fitted_to_stretch: Some((self.fitted_to_stretch * 1e4).round() / 1e4),
            softening: softening.map(|s| OgdenRoxburgh {
                r: s.r,
                m_mpa: s.m_mpa,
                beta: s.beta,
            }),
            prony: relaxation.map(PronyFit::prony),
            ..Rubber::new(over_time.unwrap_or(&law.law).clone())
        };
        readable(to_toml(&muscle.with_tube(tube)?))
    }
}

const APART: &str = "softening and relaxation were fitted separately, each without the other: \
    relaxation during the test counts as softening, and the \
     reverse; the muscle file has the law of the first loading with both";

/// The laws that follow the tests, with the errors of their constants, and where they are stable.
pub fn rubber_fit(request: &RubberFitRequest, progress: &dyn Progress) -> Result<RubberFitAnswer> {
    let settings = request.settings()?;
    let muscle = request
        .muscle
        .as_ref()
        .map_or_else(|| Ok(Muscle::prototype()), muscle_of)?;
    let first = request
        .tables
        .data
        .first()
        .ok_or_else(|| Problem::missing("data", "a table of tension tests"))?;
    let read = |text: &str, columns: Columns| read_tests(text, &columns);
    let (points, understood): (Vec<_>, Vec<_>) = request.tables.read(read)?.into_iter().unzip();
    let points = points.concat();
    size::points("data", points.len() as f64)?;
    let fit = fit_tension_with(&points, &settings, progress)?;
    let taken = fit.recommended.and_then(|i| fit.laws.get(i));
    let form = || match (settings.forms.as_slice(), taken) {
        ([form], _) => Ok(*form),
        (_, Some(law)) => Ok(law.form),
        _ => Err(Problem::new(
            ProblemKind::NoAnswer,
            "none of these laws is stable over the stretches of a muscle; none is \
                fitted over time",
            "take `laws` with one law",
        )),
    };
    let history = || {
        let several = [("data", request.tables.data.len() > 1)];
        Problem::refuse_unused(
            &several,
            "`relaxation` and `softening` are of one specimen: give one table",
        )?;
        read_history(
            &first.text,
            &request.tables.columns.clone().unwrap_or_default(),
        )
        .map_err(|error| Problem::of_table(&first.name, &error))
    };
    let relaxes =
        |Count(branches)| form().and_then(|form| Ok(fit_prony(&history()?, form, branches)?));
    let relaxation = request.relaxation.map(relaxes).transpose()?;
    let softens = || form().and_then(|form| Ok(fit_softening(&history()?, form)?));
    let softening = request.softening.then(softens).transpose()?;
    let both = relaxation.as_ref().zip(softening.as_ref());
    let warnings = fit.warnings.iter().cloned();
    let warnings = warnings
        .chain(both.map(|_| APART.into()))
        .map(Warning::from);
    let mut answer = RubberFitAnswer {
        understood,
        points: fit.points.len(),
        left_out: fit.left_out,
        left_out_to_stretch: fit.left_out_to_stretch,
        held_out: fit.held_out.len(),
        fitted_to_stretch: fit.fitted_to_stretch,
        measure: settings.measure,
        recommended: taken.map(|law| law.form.name()),
        parameters: taken.map_or_else(Vec::new, |law| law.parameters.clone()),
        failed: fit.failed.iter().map(ToString::to_string).collect(),
        warnings: warnings.collect(),
        relaxation,
        softening,
        muscle_file: None,
        hoop_stretch: settings.hoop_stretch,
        figure: request
            .figure
            .then(|| figure::tension(&fit, &request.tables.names())),
        laws: fit.laws,
    };
    answer.muscle_file = answer
        .taken()
        .map(|law| answer.with_law(law, &muscle, request.name.clone()))
        .transpose()?;
    Ok(answer)
}

impl RubberFitRequest {
    fn settings(&self) -> Result<FitSettings> {
        let usual = FitSettings::default().hoop_stretch;
        let hoop_stretch = self.hoop_stretch.unwrap_or(usual);
        Ok(FitSettings {
            forms: self.forms()?,
            measure: if self.relative {
                Measure::Relative
            } else {
                Measure::Absolute
            },
            balance: self.balance,
            mode_weights: self.weights.clone().into_iter().collect(),
            fit_modes: self.fit_modes.clone(),
            up_to_stretch: self.up_to_stretch.or(Some(hoop_stretch)),
            history: self.relaxation.is_some() || self.softening,
            stable: self.stable,
            hoop_stretch,
        })
    }

    /// The requested laws; none means all that the points determine.
    fn forms(&self) -> Result<Vec<Form>> {
        let mut forms: Vec<Form> = vec![];
        if self.laws.is_empty() && self.terms.is_none() {
            return Ok(forms);
        }
        let several = |word: &String| {
            word.trim() == "all" || Form::parse(word).iter().any(|form| form.terms().is_some())
        };
        let alone = self.terms.is_some() && !self.laws.is_empty() && !self.laws.iter().any(several);
        Problem::refuse_unused(
            &[("terms", alone)],
            "none of these `laws` has a selectable number of terms",
        )?;
        let all = ["all".to_owned()];
        for word in if self.laws.is_empty() {
            &all[..]
        } else {
            &self.laws
        } {
            let named = if word.trim() == "all" {
                Form::all()
            } else {
                Form::parse(word)
            };
            if named.is_empty() {
                let hint = format!("known: {}, all", Form::words().join(", "));
                return Err(Problem::new(
                    ProblemKind::Rubber,
                    format!("there is no law \"{:.60}\"", word.trim()),
                    hint,
                )
                .in_field("laws"));
            }
            for form in named {
                let wanted = form
                    .terms()
                    .is_none_or(|n| self.terms.is_none_or(|wanted| n == wanted.0));
                if wanted && !forms.contains(&form) {
                    forms.push(form);
                }
            }
        }
        if forms.is_empty() {
            return Err(Problem::usage(
                "none of these laws has this number of terms",
                "leave `terms` out, or take `laws` ogden",
            )
            .in_field("terms"));
        }
        Ok(forms)
    }
}

/// Weights of the modes: `uniaxial=1,equibiaxial=2`.
fn weights(text: &str) -> Result<BTreeMap<Mode, f64>> {
    let mut out = BTreeMap::new();
    for entry in text.split(',').filter(|entry| !entry.trim().is_empty()) {
        let bad = |why: &str| {
            Problem::usage(
                format!("\"{:.60}\" {why}", entry.trim()),
                "write uniaxial=1,equibiaxial=2",
            )
        };
        let (mode, weight) = entry.split_once('=').ok_or_else(|| bad("has no ="))?;
        let mode = mckibben_core::units::named(mode.trim()).ok_or_else(|| {
            let modes = Mode::ALL.map(|mode| format!("`{}`", mode.name()));
            bad(&format!(
                "names no mode; expected one of {}",
                modes.join(", ")
            ))
        })?;
        let weight = weight
            .parse::<Ratio>()
            .map_err(|e| bad(&format!("has a weight that is none: {e}")))?;
        if out.insert(mode, weight.0).is_some() {
            return Err(bad("is given twice"));
        }
    }
    Ok(out)
}
