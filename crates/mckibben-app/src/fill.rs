//! `fill`: a volume of liquid pushed into a muscle.

use crate::{
    Background, Contraction, LoadFields, Problem, ProblemKind, QuestionFields, Result, Units,
    above_zero,
    flags::{self, Args},
    given,
    print::{Csv, Page, Rows, Show},
    units::{JOULES, MEGAPASCALS, PERCENT},
};
use mckibben_core::{
    liquid::{Liquid, LiquidSupply},
    load::{Fill, FillError, Filling},
    refused::Refused,
    units::typed::{Pressure, Ratio, Volume},
    warning::Warning,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Pressure, stroke and energies of a muscle that a volume of liquid is pushed into, from its
/// length at rest without pressure, filled without air.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct FillRequest {
    /// Volume that is pushed in, measured at atmospheric pressure (the stroke of a syringe)
    #[arg(long, value_parser = flags::volume)]
    pub volume_mm3: Option<Volume>,
    /// What the muscle works against; without it the muscle is free.
    #[serde(flatten)]
    #[command(flatten)]
    pub load: LoadFields,
    /// Contraction at which it is held; with a load: its stop
    #[arg(short = 'e', long)]
    pub contraction: Option<Contraction>,
    /// The liquid.
    #[serde(flatten)]
    #[command(flatten)]
    pub liquid: LiquidFields,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
}

/// A muscle with a volume of liquid pushed in.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FillAnswer {
    /// Pressure, stroke, pull and energies.
    #[serde(flatten)]
    pub fill: Fill,
    /// The liquid.
    pub liquid: Liquid,
    /// The muscle, the model, limits and ±.
    #[serde(flatten)]
    pub background: Background,
}

impl Show for FillAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.fill.answer.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let (fill, liquid, a) = (&self.fill, &self.liquid, &self.fill.answer);
        let uncertainty = self.background.uncertainty_words.text_in(u);
        let rows = Rows::default()
            .text("muscle", self.background.muscle.line(u))
            .text("model", &a.model)
            .text("by", &self.background.about.source)
            .text("liquid", liquid.name)
            .quantity("gas", &PERCENT, liquid.gas_share)
            .quantity("bulk modulus", &MEGAPASCALS, liquid.bulk_modulus_mpa)
            .quantity(
                "with its gas at this pressure",
                &MEGAPASCALS,
                fill.effective_bulk_modulus_mpa,
            )
            .quantity("pushed in", &u.volume, fill.pushed_volume_mm3)
            .quantity(
                "of it by compression",
                &u.volume,
                fill.compressed_volume_mm3,
            )
            .quantity("pressure", &u.pressure, a.response.pressure_mpa)
            .quantity("stroke", &u.length.digits(4), fill.stroke_mm)
            .quantity("contraction", &PERCENT, a.response.contraction)
            .text("state", fill.state.to_string())
            .quantity("pull", &u.force.digits(4), a.response.force_n)
            .text("as built", self.background.uncertainty_words.built_in(u))
            .quantity(
                "stiffness, liquid shut in",
                &u.stiffness(),
                fill.shut_stiffness_n_per_mm,
            )
            .quantity(
                "at constant pressure",
                &u.stiffness(),
                a.response.stiffness_n_per_mm,
            )
            .quantity("work of the pump", &JOULES, fill.pump_work_j)
            .quantity("stored in the muscle", &JOULES, fill.muscle_energy_j)
            .quantity("stored in the liquid", &JOULES, fill.liquid_energy_j)
            .quantity("work on the load", &JOULES, fill.load_work_j)
            .quantity("taken by friction", &JOULES, fill.friction_work_j)
            .quantity("cavity", &u.volume, a.response.volume_mm3)
            .quantity("cavity at the start", &u.volume, fill.rest_volume_mm3)
            .and(self.background.limit_rows(u))
            .text(
                "uncertainty",
                uncertainty.map(|text| format!("of the pull {text}")),
            );
        rows.into()
    }

    fn csv(&self) -> Csv {
        Csv::flat(self)
    }
}

impl From<FillError> for Problem {
    fn from(error: FillError) -> Self {
        let field = match &error {
            FillError::Analysis(error) => return error.clone().into(),
            FillError::TooLarge { .. } => "volume_mm3",
            FillError::Refused(refused) => refused.fields[0],
        };
        ProblemKind::NoAnswer.problem(error).in_field(field)
    }
}

/// A volume of liquid pushed into a muscle.
pub fn fill(request: &FillRequest) -> Result<FillAnswer> {
    let volume_mm3 = given("volume_mm3", request.volume_mm3, "a volume, such as 20 mL")?;
    above_zero(ProblemKind::Quantity, "volume_mm3", volume_mm3)?;
    let LiquidSupply {
        liquid,
        dead_volume_mm3,
    } = request.liquid.supply()?;
    let mut question = request.question.ask()?;
    let length_mm = question.muscle.length_mm();
    let held_at = request
        .contraction
        .as_ref()
        .map(|e| e.of_length(length_mm))
        .transpose()?;
    let load = request.load.resolve(length_mm)?;
    let filling = Filling {
        liquid: &liquid,
        volume_mm3,
        dead_volume_mm3,
        load: load.as_ref(),
        held_at,
    };
    let mut fill = question.evaluation().fill(&filling)?;
    let pressure_mpa = fill.answer.response.pressure_mpa;
    let background = question.background(&mut fill.answer, pressure_mpa)?;
    Ok(FillAnswer {
        fill,
        liquid,
        background,
    })
}

/// What a muscle is filled with.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct LiquidFields {
    /// Liquid: water, oil (SAE 10W) or glycol (ethylene glycol) [water for `fill`, air for `design`]
    #[arg(long)]
    pub liquid: Option<String>,
    /// Gas in the liquid by volume at atmospheric pressure [0]
    #[arg(long = "gas", value_name = "SHARE")]
    pub gas_share: Option<Ratio>,
    /// Volume of line, fittings and what stays in the syringe [0]
    #[arg(long, value_parser = flags::volume)]
    pub dead_volume_mm3: Option<Volume>,
    /// Bulk modulus of the liquid without gas, in place of that of the table
    #[arg(long = "bulk-modulus", value_name = "MODULUS", hide_short_help = true)]
    pub liquid_bulk_modulus_mpa: Option<Pressure>,
}

impl LiquidFields {
    /// The liquid, water where no other one is named, with its dead volume.
    pub fn supply(&self) -> Result<LiquidSupply> {
        let name = self.liquid.as_deref().unwrap_or("water");
        let wrong = |error: Refused| {
            ProblemKind::Quantity
                .problem(&error)
                .in_field(error.fields[0])
        };
        let mut liquid =
            Liquid::named(name, self.gas_share.unwrap_or_default().0).map_err(wrong)?;
        if let Some(modulus) = self.liquid_bulk_modulus_mpa {
            liquid = liquid.with_bulk_modulus(modulus.0).map_err(wrong)?;
        }
        let dead_volume_mm3 = match self.dead_volume_mm3 {
            None | Some(Volume(0.0)) => 0.0,
            Some(dead) => above_zero(ProblemKind::Quantity, "dead_volume_mm3", dead)?,
        };
        Ok(LiquidSupply {
            liquid,
            dead_volume_mm3,
        })
    }

    /// The same where a liquid is named; else the muscle is filled with air.
    pub fn named_supply(&self) -> Result<Option<LiquidSupply>> {
        if self.liquid.is_some() {
            return self.supply().map(Some);
        }
        Problem::refuse_unused(
            &[
                ("dead_volume_mm3", self.dead_volume_mm3.is_some()),
                (
                    "liquid_bulk_modulus_mpa",
                    self.liquid_bulk_modulus_mpa.is_some(),
                ),
                ("gas_share", self.gas_share.is_some()),
            ],
            "it belongs to `liquid`, and none is given",
        )
        .map_err(|problem| problem.with_hint("give `liquid`: water, oil or glycol"))?;
        Ok(None)
    }
}
