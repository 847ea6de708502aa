//! `check`: the data of a muscle and what follows from them, what it does at its working pressure,
//! whether it is plausible, what of it is not known, how far it is from measured muscles, and what
//! to measure first.

mod page;

use crate::{
    LiquidFields, MeasureValues, MeshFields, MuscleSummary, PressureLimits, Problem, ProblemKind,
    Question, QuestionFields, Result, UncertaintyWords, Units, finite,
    flags::Args,
    muscle_fields::{stated, stated_schema},
    number, percent, usual_mpa,
};
use mckibben_core::{
    analysis::{Burst, FailureMode, FailurePressure},
    built::{Built, Left, not_measured},
    muscle::{Bulk, Muscle, MuscleKind, file::to_toml},
    rubber::{RubberLaw, library},
    units::{Dimension, tidy, typed::Pressure},
    warning::{Warning, WarningKind},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A muscle to be checked.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct CheckRequest {
    /// Working pressure [2.5bar, or the allowed pressure where that is lower]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Only its data and what follows from them: no model is evaluated.
    #[arg(skip)]
    pub only_data: bool,
    /// Add the equivalent muscle file to the answer.
    #[arg(skip)]
    pub muscle_file: bool,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
}

/// What is known of a muscle, and what is not.
#[derive(Debug, Serialize, JsonSchema)]
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
    #[schemars(schema_with = "stated_schema")]
    pub stated: MeasureValues,
    /// Derived quantities.
    pub derived: Derived,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Its values at the working pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub characteristics: Option<Characteristics>,
    /// Findings beyond the warnings, the gravest kind first; what to measure in the order of its
    /// effect.
    pub findings: Vec<MuscleFinding>,
    /// The equivalent muscle file (TOML), if requested: file and fields of the request in one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub muscle_file: Option<String>,
    /// The muscle itself.
    #[serde(skip)]
    pub muscle: Muscle,
}

/// Quantities derived from the dimensions of a muscle.
#[derive(Debug, Serialize, JsonSchema)]
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
    /// Largest stretch of the rubber there, at the bore: the reach by which a named rubber has its
    /// law.
    pub reach: f64,
    /// Cavity at rest, mm³.
    pub volume_mm3: f64,
}

/// Values of a muscle at one pressure.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Characteristics {
    /// The model that says so.
    pub model: String,
    /// The pressure, MPa.
    pub pressure_mpa: f64,
    /// Blocked force that a built muscle reaches: its median and interval, N.
    #[serde(flatten)]
    pub built: Option<Built>,
    /// Whether the model was named: its number is shown first.
    #[serde(skip)]
    pub is_model_named: bool,
    /// Blocked force of the model on the branch that is asked, N.
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
    /// Air from rest to there, normal litres; none of a muscle whose job names a liquid.
    pub air_normal_litres: Option<f64>,
    /// Liquid that its job names from rest to there, mm³.
    pub liquid_volume_mm3: Option<f64>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
}

/// Values at the working pressure, warnings of the burst pressure, and findings.
type AtPressure = (Option<Characteristics>, Vec<Warning>, Vec<MuscleFinding>);

/// Of a muscle whose data alone are asked nothing that evaluates a model may be given.
fn refuse_what_needs_a_model(request: &CheckRequest) -> Result<()> {
    let model = &request.question.model;
    let asking = request.question.asking;
    Problem::refuse_unused(
        &[
            ("pressure_mpa", request.pressure_mpa.is_some()),
            ("model", model.name.is_some()),
            ("mesh", model.mesh != MeshFields::default()),
            ("extrapolate", asking.extrapolate),
            ("two_sided", asking.two_sided),
            ("direction", asking.direction.is_some()),
        ],
        "`only_data` evaluates no model",
    )
}

/// What is known of a muscle, and what is not.
pub fn check(request: &CheckRequest) -> Result<CheckAnswer> {
    let (muscle, rest_volume_mm3, (characteristics, said, findings)) = if request.only_data {
        refuse_what_needs_a_model(request)?;
        (
            request.question.muscle.resolve()?,
            None,
            AtPressure::default(),
        )
    } else {
        let mut question = request.question.ask()?;
        let at_pressure = match at_pressure(&mut question, request.pressure_mpa.map(f64::from)) {
            // Without a requested pressure the data of the muscle are an answer by themselves.
            Err(e) if request.pressure_mpa.is_none() && e.kind != ProblemKind::Cancelled => {
                (None, vec![e.message.into()], vec![])
            }
            at_pressure => at_pressure?,
        };
        // Plugs that are wider than the bore add to it: a model knows how much.
        let rest_volume_mm3 = question.muscle.terminals().plug_diameter_mm.and_then(|_| {
            question
                .evaluation()
                .point(0.0, 0.0)
                .ok()?
                .response
                .volume_mm3
        });
        (question.muscle, rest_volume_mm3, at_pressure)
    };
    let rubber = &muscle.tube().rubber;
    let law = &rubber.law;
    let constants = law.constants().into_iter();
    let reach = muscle.reach();
    let beyond = rubber
        .fitted_to_stretch
        .filter(|limit| reach > *limit)
        .map(|limit| {
            format!(
                "free to contract, this muscle stretches its rubber to {reach:.2} at the bore; the \
             constants of {} were fitted up to {limit:.2}",
                rubber.name.as_deref().unwrap_or("this rubber")
            )
        });
    let outside = characteristics
        .as_ref()
        .map(|c: &Characteristics| c.pressure_mpa)
        .and_then(|p| Warning::not_measured(&muscle, p));
    let of_muscle = muscle
        .warnings()
        .into_iter()
        .chain(library::warnings(rubber));
    Ok(CheckAnswer {
        summary: (&muscle).into(),
        law: law.name().into(),
        constants_mpa: constants.map(|c| (c.name, c.value)).collect(),
        shear_modulus_mpa: law.shear_modulus_mpa(),
        fitted_to_stretch: rubber.fitted_to_stretch,
        bulk_modulus_mpa: match rubber.bulk {
            Bulk::Incompressible => None,
            Bulk::Modulus(k) => Some(k),
        },
        stiffness_n_per_mm: muscle.family_stiffness_n_per_mm(),
        stated: stated(&muscle),
        derived: Derived {
            kind: muscle.kind(),
            inner_diameter_mm: muscle.inner_diameter_mm(),
            strand_length_mm: muscle.strand_length_mm(),
            turns: muscle.turns(),
            strand_length_per_turn_mm: muscle.strand_length_per_turn_mm(),
            max_ideal_contraction: muscle.max_ideal_contraction(),
            reach,
            volume_mm3: rest_volume_mm3.unwrap_or_else(|| muscle.rest_volume_mm3()),
        },
        warnings: said
            .into_iter()
            .chain(outside)
            .chain(of_muscle.chain(beyond).map(Warning::from))
            .collect(),
        characteristics,
        findings,
        muscle_file: request.muscle_file.then(|| to_toml(&muscle)),
        muscle,
    })
}

fn at_pressure(question: &mut Question, pressure_mpa: Option<f64>) -> Result<AtPressure> {
    let burst = question.burst()?;
    let pressure_mpa = finite(
        "pressure_mpa",
        pressure_mpa.unwrap_or_else(|| usual_mpa(&burst, &question.muscle)),
    )?;
    let is_model_named = question.is_model_named;
    let liquid = LiquidFields {
        liquid: question.muscle.job().and_then(|job| job.liquid.clone()),
        ..LiquidFields::default()
    };
    let liquid = liquid.named_supply()?;
    let mut model = question.evaluation();
    let point = model.point(pressure_mpa, 0.0)?;
    let free = model.free_contraction(pressure_mpa).ok();
    let air = free.and_then(|e| model.air_per_stroke(pressure_mpa, e).ok());
    let values = Characteristics {
        model: point.model.to_string(),
        pressure_mpa,
        built: point.built,
        is_model_named,
        blocked_force_n: point.response.force_n,
        blocked_force_uncertainty_n: point.uncertainty_n,
        uncertainty_words: UncertaintyWords::of(&point, &mut model),
        free_contraction: free,
        work_j: free.and_then(|e| model.work_per_stroke_j(pressure_mpa, 0.0, e).ok()),
        volume_mm3: air.map(|a| a.volume_mm3),
        air_normal_litres: air.filter(|_| liquid.is_none()).map(|a| a.normal_litres),
        liquid_volume_mm3: free
            .zip(liquid)
            .and_then(|(e, liquid)| model.liquid_per_stroke_mm3(&liquid, pressure_mpa, e).ok()),
        limits: (&burst).into(),
    };
    let findings = findings_of(&question.muscle, &burst, &values);
    let said = burst.warnings(pressure_mpa);
    Ok((Some(values), said, findings))
}

/// A finding.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MuscleFinding {
    /// Its kind.
    pub kind: FindingKind,
    /// In a sentence.
    pub text: String,
    /// Half of the 95 % interval of the blocked force that a measurement leaves, N.
    pub left_n: Option<f64>,
}

/// A kind of finding.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FindingKind {
    /// The muscle is unusual, or is loaded beyond what it bears.
    Implausible,
    /// A number that is not stated.
    Unknown,
    /// A number outside of the muscles that the models were compared with.
    Outside,
    /// A measurement that reduces the ±.
    Measure,
}

/// Ends take a large part of a muscle that is shorter than so many diameters.
const SHORT: f64 = 5.0;
/// Walls over bores of tubes that people cast (the catalogue of parts).
const WALLS: (f64, f64) = (0.04, 1.0 / 3.0);
/// A ± above this share of the blocked force is more than a design can do with.
const WIDE: f64 = 0.3;
/// A muscle that contracts less than this even without wall and load hardly moves.
const LITTLE: f64 = 0.1;

/// Findings about a muscle beyond its warnings.
fn findings_of(muscle: &Muscle, burst: &Burst, values: &Characteristics) -> Vec<MuscleFinding> {
    let of = |kind, texts: Vec<String>| {
        texts.into_iter().map(move |text| MuscleFinding {
            kind,
            text,
            left_n: None,
        })
    };
    of(FindingKind::Implausible, implausible(muscle, burst, values))
        .chain(of(FindingKind::Unknown, unknown(burst)))
        .chain(of(
            FindingKind::Outside,
            not_measured(muscle, values.pressure_mpa)
                .map(|q| q.to_string())
                .collect(),
        ))
        .chain(values.uncertainty_words.measurements.iter().map(measure))
        .chain(of(FindingKind::Measure, sleeve(burst)))
        .collect()
}

/// What of a sleeve with estimated strands comes first.
fn sleeve(burst: &Burst) -> Vec<String> {
    let ends = burst
        .least()
        .zip(burst.first())
        .filter(|(least, first)| least.1 < first.1);
    let text = |((_, least_mpa), (_, first_mpa)): ((FailureMode, f64), (FailureMode, f64))| {
        let [least, first] = [least_mpa, first_mpa]
            .map(|mpa| Units::default().show(Dimension::Pressure, tidy(mpa, 3)));
        format!(
            "of the sleeve first the least and the largest diameter to which it closes and opens: \
             they set the angle, and so the pull; then its mass per metre: it sets the number of \
             strands, and so the burst pressure, which lies between {least} and {first}"
        )
    };
    ends.map(text).into_iter().collect()
}

fn implausible(muscle: &Muscle, burst: &Burst, values: &Characteristics) -> Vec<String> {
    let pull = values.blocked_force_n;
    let ideal = muscle.max_ideal_contraction();
    let slender = muscle.length_mm() / muscle.tube().outer_diameter_mm;
    let wall = muscle.wall_mm() / muscle.inner_diameter_mm();
    let share = values
        .blocked_force_uncertainty_n
        .map_or(0.0, |half| half / pull);
    let ratio = number(slender, 3);
    let angle = number(muscle.braid().angle_deg, 4);
    let ideal_text = percent(ideal);
    let [bore, low, high] = [wall, WALLS.0, WALLS.1].map(percent);
    let half = percent((100.0 * share).round() / 100.0);
    let extends = muscle.is_extensile();
    let is_broken = burst
        .strands
        .mpa()
        .is_some_and(|mpa| mpa <= values.pressure_mpa);
    let oddities = [
        (
            is_broken,
            "the muscle does not pull: at this pressure its strands are broken".to_owned(),
        ),
        (
            pull <= 0.0 && !is_broken && !extends,
            "the muscle does not pull at this pressure and its rest length: the pressure is too \
             low for its wall, or its angle is above 54.7°"
                .to_owned(),
        ),
        (
            ideal < LITTLE && !extends,
            format!(
                "with an angle of {angle}° even the ideal muscle contracts by no more than \
                 {ideal_text}"
            ),
        ),
        (
            slender < SHORT,
            format!(
                "the length is {ratio} outer diameters; below {SHORT} the ends take a large part \
                 of stroke and pull"
            ),
        ),
        (
            wall < WALLS.0 || wall > WALLS.1,
            format!(
                "the wall is {bore} of the bore; tubes on sale and cast ones have {low} to {high}"
            ),
        ),
        (
            pull > 0.0 && share > WIDE,
            format!("the ± is {half} of the blocked force: measure before you rely on the pull"),
        ),
    ]
    .into_iter()
    .filter(|(is_odd, _)| *is_odd);
    oddities.map(|(_, sentence)| sentence).collect()
}

/// Failures whose pressure cannot be computed, with what is missing.
fn unknown(burst: &Burst) -> Vec<String> {
    let of_mode = |(mode, pressure)| match pressure {
        FailurePressure::Unknown(why) => Some(format!("the pressure at which {mode}: {why}")),
        _ => None,
    };
    let rated = "the pressure for which plugs and fittings are rated; give \
        `terminals.rated_pressure` in the muscle file";
    let rated = burst.rated_mpa.is_none().then(|| rated.to_owned());
    burst
        .modes()
        .into_iter()
        .filter_map(of_mode)
        .chain(rated)
        .collect()
}

/// A measurement, and the ± that it leaves.
fn measure(left: &Left) -> MuscleFinding {
    let (what, minutes) = left.measurement.words();
    MuscleFinding {
        kind: FindingKind::Measure,
        text: format!("{what} (about {minutes}\u{a0}min)"),
        left_n: Some(left.uncertainty_n),
    }
}

impl CheckAnswer {
    /// The findings of a kind, in sentences with units; warnings are of the implausible, but for
    /// those of the burst pressure.
    pub fn sentences(&self, kind: FindingKind, u: &Units) -> Vec<String> {
        let warnings = self
            .warnings
            .iter()
            .filter(|_| kind == FindingKind::Implausible)
            .filter(|w| !w.is_of_burst() && w.kind != WarningKind::NotMeasured);
        let sentences = self
            .findings
            .iter()
            .filter(|finding| finding.kind == kind)
            .map(|finding| match finding.left_n {
                Some(left) => {
                    let text = &finding.text;
                    let half = u.force.half_width(left);
                    format!("{text}: ± {half}\u{a0}{}", u.force.name)
                }
                None => finding.text.clone(),
            });
        warnings.map(ToString::to_string).chain(sentences).collect()
    }
}
