//! `check`: the data of a muscle and what follows from them, what it does at its working pressure, whether it is plausible, what of it is
//! not known, how far it is from measured muscles, and what to measure first.

pub(crate) mod findings;

pub use findings::{FindingKind, MuscleFinding};

use crate::burst::{PressureLimits, said_of, usual_mpa};
use crate::fields::MeshFields;
use crate::muscle::MuscleSummary;
use crate::muscle_fields::Stated;
use crate::point::finite;
use crate::problem::{Problem, ProblemKind};
use crate::question::{Question, QuestionFields};
use crate::uncertainty::UncertaintyWords;
use mckibben::analysis::{air_per_stroke, free_contraction, work_per_stroke_j};
use mckibben::answer;
use mckibben::muscle::file::to_toml;
use mckibben::muscle::{BuildSheet, Bulk, Muscle, MuscleKind};
use mckibben::progress::Progress;
use mckibben::rubber::{RubberLaw, library};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A muscle to be checked.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CheckRequest {
    /// The muscle, the model, and how it is asked.
    #[serde(flatten)]
    pub question: QuestionFields,
    /// Working pressure, MPa; 0.25 MPa, or the allowed pressure where that is lower.
    pub pressure_mpa: Option<f64>,
    /// Only its data and what follows from them: no model is asked.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub only_data: bool,
    /// Add the equivalent muscle file to the answer.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub muscle_file: bool,
}

/// What is known of a muscle, and what is not.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CheckAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub summary: MuscleSummary,
    /// Name of the rubber's law.
    pub law: String,
    /// Its constants by name; moduli in MPa.
    pub constants_mpa: BTreeMap<String, f64>,
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// Largest stretch of the data behind the constants, where it is known.
    pub fitted_to_stretch: Option<f64>,
    /// Bulk modulus, MPa; none for an incompressible rubber.
    pub bulk_modulus_mpa: Option<f64>,
    /// Stiffness k of one strand family, N/mm; none for inextensible strands.
    pub stiffness_n_per_mm: Option<f64>,
    /// Measures that need not be stated.
    #[serde(flatten)]
    pub stated: Stated,
    /// Derived quantities.
    pub derived: Derived,
    /// Build sheet.
    pub build_sheet: BuildSheet,
    /// Warnings, in sentences.
    pub warnings: Vec<String>,
    /// Its values at the working pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub characteristics: Option<Characteristics>,
    /// What was found beyond the warnings, the gravest kind first; what to measure in the order of its effect.
    pub findings: Vec<MuscleFinding>,
    /// The equivalent muscle file (TOML), if requested: file and fields of the request in one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub muscle_file: Option<String>,
    /// The muscle itself.
    #[serde(skip)]
    pub muscle: Muscle,
}

/// Quantities derived from the dimensions of a muscle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Derived {
    /// Which way the muscle moves under pressure.
    pub kind: MuscleKind,
    /// Inner diameter at rest, mm.
    pub inner_diameter_mm: f64,
    /// Length of a strand, mm.
    pub strand_length_mm: f64,
    /// Its turns.
    pub turns: f64,
    /// Its length per turn, mm.
    pub strand_length_per_turn_mm: f64,
    /// Contraction at which the ideal muscle no longer pulls.
    pub max_ideal_contraction: f64,
    /// Largest stretch of the rubber there, at the bore: the reach by which a named rubber has its law.
    pub reach: f64,
    /// Cavity at rest, mm³.
    pub volume_mm3: f64,
}

/// Values of a muscle at one pressure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Characteristics {
    /// The model that says so.
    pub model: String,
    /// The pressure, MPa.
    pub pressure_mpa: f64,
    /// Blocked force, N.
    pub blocked_force_n: f64,
    /// Half-width of the 95 % interval of the blocked force, N.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked_force_uncertainty_n: Option<f64>,
    /// The same in words.
    pub uncertainty_words: UncertaintyWords,
    /// Contraction without pull.
    pub free_contraction: Option<f64>,
    /// Work from rest to there, J.
    pub work_j: Option<f64>,
    /// Cavity there, mm³.
    pub volume_mm3: Option<f64>,
    /// Air from rest to there, normal litres.
    pub air_normal_litres: Option<f64>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
}

/// Values at the working pressure, what is said of the burst pressure, and what was found.
type Asked = (Option<Characteristics>, Vec<String>, Vec<MuscleFinding>);

/// What is known of a muscle, and what is not.
pub fn check(request: &CheckRequest, _progress: &dyn Progress) -> Result<CheckAnswer, Problem> {
    let mut volume_mm3 = None;
    let (muscle, (characteristics, said, findings)) = if request.only_data {
        let (model, asking) = (&request.question.model, request.question.asking);
        let fields = [
            ("pressure_mpa", request.pressure_mpa.is_some()),
            ("model", model.model.is_some()),
            ("mesh", model.mesh != MeshFields::default()),
            ("extrapolate", asking.extrapolate),
            ("two_sided", asking.two_sided),
            ("direction", !asking.direction.is_mean()),
        ];
        Problem::refuse_unused(&fields, "`only_data` asks no model")?;
        (request.question.muscle.resolve()?, Asked::default())
    } else {
        let mut question = request.question.ask()?;
        let asked = match asked(&mut question, request.pressure_mpa) {
            // Where no pressure is asked for, the data of the muscle are an answer by themselves.
            Err(e) if request.pressure_mpa.is_none() && e.kind != ProblemKind::Cancelled => {
                (None, vec![e.message], vec![])
            }
            asked => asked?,
        };
        // Plugs that are wider than the bore add to it: a model knows how much.
        let rest = answer::point(&*question.model, &mut question.workspace, 0.0, 0.0, question.options);
        volume_mm3 = rest.ok().and_then(|point| point.response.volume_mm3);
        (question.muscle, asked)
    };
    let rubber = &muscle.tube().rubber;
    let (law, reach) = (&rubber.law, muscle.reach());
    let beyond = rubber.fitted_to_stretch.filter(|limit| reach > *limit).map(|limit| {
        format!(
            "free to contract, this muscle stretches its rubber to {reach:.2} at the bore; the constants of {} were fitted up to {limit:.2}",
            rubber.name.as_deref().unwrap_or("this rubber")
        )
    });
    Ok(CheckAnswer {
        summary: (&muscle).into(),
        law: law.name().into(),
        constants_mpa: law.constants().into_iter().map(|c| (c.name, c.value)).collect(),
        shear_modulus_mpa: law.shear_modulus_mpa(),
        fitted_to_stretch: rubber.fitted_to_stretch,
        bulk_modulus_mpa: match muscle.tube().rubber.bulk {
            Bulk::Incompressible => None,
            Bulk::Modulus(k) => Some(k),
        },
        stiffness_n_per_mm: muscle.family_stiffness_n_per_mm(),
        stated: (&muscle).into(),
        derived: Derived {
            kind: muscle.kind(),
            inner_diameter_mm: muscle.inner_diameter_mm(),
            strand_length_mm: muscle.strand_length_mm(),
            turns: muscle.turns(),
            strand_length_per_turn_mm: muscle.strand_length_per_turn_mm(),
            max_ideal_contraction: muscle.max_ideal_contraction(),
            reach,
            volume_mm3: volume_mm3.unwrap_or_else(|| muscle.rest_volume_mm3()),
        },
        build_sheet: muscle.build_sheet(),
        warnings: said
            .into_iter()
            .chain(muscle.warnings())
            .chain(library::warnings(rubber))
            .chain(beyond)
            .collect(),
        characteristics,
        findings,
        muscle_file: request.muscle_file.then(|| to_toml(&muscle)),
        muscle,
    })
}

fn asked(question: &mut Question, pressure_mpa: Option<f64>) -> Result<Asked, Problem> {
    let burst = question.burst()?;
    let pressure_mpa = finite("pressure_mpa", pressure_mpa.unwrap_or_else(|| usual_mpa(&burst)))?;
    let (model, options, w) = (&*question.model, question.options, &mut question.workspace);
    let point = answer::point(model, w, pressure_mpa, 0.0, options)?;
    let free = free_contraction(model, w, pressure_mpa, options).ok();
    let air = free.and_then(|e| air_per_stroke(model, w, pressure_mpa, e).ok());
    let values = Characteristics {
        model: point.model.to_string(),
        pressure_mpa,
        blocked_force_n: point.response.force_n,
        blocked_force_uncertainty_n: point.uncertainty_n,
        uncertainty_words: UncertaintyWords::of(point.uncertainty_parts_n, model, w, pressure_mpa),
        free_contraction: free,
        work_j: free.and_then(|e| work_per_stroke_j(model, w, pressure_mpa, 0.0, e, options).ok()),
        volume_mm3: air.map(|a| a.volume_mm3),
        air_normal_litres: air.map(|a| a.normal_litres),
        limits: (&burst).into(),
    };
    let findings = findings::of(&question.muscle, &burst, &values, point.uncertainty_parts_n)?;
    let said = said_of(&burst, pressure_mpa, 0.0);
    Ok((Some(values), said.iter().map(ToString::to_string).collect(), findings))
}
