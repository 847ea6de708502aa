//! `fill`: a volume of liquid pushed into a muscle.

use crate::burst::{PressureLimits, QUIET_MPA, put_first, said_of};
use crate::fields::{AskFields, ModelFields, MuscleFields};
use crate::load::LoadFields;
use crate::muscle::MuscleSummary;
use crate::point::{ModelAbout, given, ratio};
use crate::problem::{Problem, ProblemKind};
use crate::question::Question;
use crate::uncertainty::UncertaintyWords;
use mckibben::analysis::source_of;
use mckibben::liquid::{Liquid, LiquidError};
use mckibben::load::{Fill, FillError, Filling, fill as filled};
use mckibben::progress::Progress;
use mckibben::uncertainty::basis_of;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Pressure, stroke and energies of a muscle that a volume of liquid is pushed into, from its length at rest without pressure, filled without
/// air.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct FillRequest {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// How it is asked.
    #[serde(flatten)]
    pub asking: AskFields,
    /// Volume that is pushed in, measured at atmospheric pressure (the stroke of a syringe), mm³.
    pub volume_mm3: Option<f64>,
    /// Volume of line, fittings and what stays in the syringe, mm³; default 0.
    pub dead_volume_mm3: Option<f64>,
    /// Liquid: water, oil (SAE 10W) or glycol (ethylene glycol); default water.
    pub liquid: Option<String>,
    /// Bulk modulus of the liquid without gas in MPa, in place of that of the table.
    pub liquid_bulk_modulus_mpa: Option<f64>,
    /// Gas in the liquid by volume at atmospheric pressure; default 0.
    pub gas_share: Option<f64>,
    /// What the muscle works against; without it the muscle is free.
    #[serde(flatten)]
    pub load: LoadFields,
    /// Contraction ratio ε = ΔL/L0 at which the muscle is held: with a load, where its way ends.
    pub contraction: Option<f64>,
}

/// A muscle with a volume of liquid pushed in.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FillAnswer {
    /// Pressure, stroke, pull and energies.
    #[serde(flatten)]
    pub fill: Fill,
    /// The liquid.
    pub liquid: Liquid,
    /// The ± of the pull in words.
    pub uncertainty_words: UncertaintyWords,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// The model.
    pub about: ModelAbout,
}

impl From<FillError> for Problem {
    fn from(error: FillError) -> Self {
        let (message, field) = (
            error.to_string(),
            match error {
                FillError::Analysis(error) => return error.into(),
                FillError::TooLarge { .. } => "volume_mm3",
                FillError::HeldBehind { .. } => "contraction",
                FillError::Extends => "load",
            },
        );
        Self::new(ProblemKind::NoAnswer, message, "").in_field(field)
    }
}

impl From<LiquidError> for Problem {
    fn from(error: LiquidError) -> Self {
        let field = match error {
            LiquidError::Unknown { .. } => "liquid",
            LiquidError::BulkModulus { .. } => "liquid_bulk_modulus_mpa",
            LiquidError::Gas { .. } => "gas_share",
        };
        Self::new(ProblemKind::Quantity, error.to_string(), "").in_field(field)
    }
}

/// A volume of liquid pushed into a muscle.
///
/// # Errors
/// [`Problem`].
pub fn fill(request: &FillRequest, progress: &dyn Progress) -> Result<FillAnswer, Problem> {
    let volume_mm3 =
        volume("volume_mm3", given("volume_mm3", request.volume_mm3, "a volume, such as 20 mL")?)?;
    let dead_volume_mm3 = match request.dead_volume_mm3 {
        None | Some(0.0) => 0.0,
        Some(dead) => volume("dead_volume_mm3", dead)?,
    };
    let name = request.liquid.as_deref().unwrap_or("water");
    let mut liquid = Liquid::named(name, request.gas_share.unwrap_or(0.0))?;
    if let Some(modulus) = request.liquid_bulk_modulus_mpa {
        liquid = liquid.with_bulk_modulus(modulus)?;
    }
    let held_at = request.contraction.map(ratio).transpose()?;
    let mut question = Question::new(&request.muscle, &request.model, request.asking, &progress.budget())?;
    let load = request.load.resolve(question.muscle.length_mm())?;
    let asked = Filling { liquid: &liquid, volume_mm3, dead_volume_mm3, load: load.as_ref(), held_at };
    let found = filled(&*question.model, &mut question.workspace, &asked, question.options);
    question.workspace.budget().ended()?;
    let mut fill = found?;
    let burst = question.burst()?;
    let pressure_mpa = fill.answer.response.pressure_mpa;
    put_first(&mut fill.answer.warnings, said_of(&burst, pressure_mpa, QUIET_MPA));
    let parts = fill.answer.uncertainty_parts_n;
    Ok(FillAnswer {
        uncertainty_words: UncertaintyWords::of(
            parts,
            &*question.model,
            &mut question.workspace,
            pressure_mpa,
        ),
        limits: (&burst).into(),
        muscle: (&question.muscle).into(),
        about: ModelAbout {
            source: source_of(&*question.model, question.options.direction),
            uncertainty_basis: basis_of(&question.model.info().accuracy),
        },
        fill,
        liquid,
    })
}

/// A volume above zero.
fn volume(field: &str, value: f64) -> Result<f64, Problem> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    let message = format!("{value} mm³ is not a volume above zero");
    Err(Problem::new(ProblemKind::Quantity, message, "").in_field(field))
}
