//! `fill`: a volume of liquid pushed into a muscle.

use crate::burst::{PressureLimits, QUIET_MPA, put_first, said_of};
use crate::liquid::LiquidFields;
use crate::load::LoadFields;
use crate::muscle::MuscleSummary;
use crate::point::{ModelAbout, above_zero, given, ratio};
use crate::problem::{Problem, ProblemKind};
use crate::question::QuestionFields;
use crate::uncertainty::UncertaintyWords;
use mckibben::analysis::source_of;
use mckibben::cancel;
use mckibben::liquid::{Liquid, LiquidSupply};
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
    /// The muscle, the model, and how it is asked.
    #[serde(flatten)]
    pub question: QuestionFields,
    /// Volume that is pushed in, measured at atmospheric pressure (the stroke of a syringe), mm³.
    pub volume_mm3: Option<f64>,
    /// The liquid.
    #[serde(flatten)]
    pub liquid: LiquidFields,
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
                FillError::Refused(refused) => refused.fields[0],
            },
        );
        Self::new(ProblemKind::NoAnswer, message, "").in_field(field)
    }
}

/// A volume of liquid pushed into a muscle.
pub fn fill(request: &FillRequest, _progress: &dyn Progress) -> Result<FillAnswer, Problem> {
    let volume_mm3 = given("volume_mm3", request.volume_mm3, "a volume, such as 20 mL")?;
    above_zero(ProblemKind::Quantity, "volume_mm3", volume_mm3)?;
    let LiquidSupply { liquid, dead_volume_mm3 } = request.liquid.supply()?;
    let held_at = request.contraction.map(ratio).transpose()?;
    let mut question = request.question.ask()?;
    let load = request.load.resolve(question.muscle.length_mm())?;
    let asked = Filling { liquid: &liquid, volume_mm3, dead_volume_mm3, load: load.as_ref(), held_at };
    let found = filled(&*question.model, &mut question.workspace, &asked, question.options);
    cancel::check()?;
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
