//! Liquids in requests.

use crate::point::above_zero;
use crate::problem::{Problem, ProblemKind};
use mckibben::liquid::{Liquid, LiquidError, LiquidSupply};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a muscle is filled with.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct LiquidFields {
    /// Volume of line, fittings and what stays in the syringe, mm³; default 0.
    pub dead_volume_mm3: Option<f64>,
    /// Liquid: water, oil (SAE 10W) or glycol (ethylene glycol); default: water for `fill`, air for `design`.
    pub liquid: Option<String>,
    /// Bulk modulus of the liquid without gas in MPa, in place of that of the table.
    pub liquid_bulk_modulus_mpa: Option<f64>,
    /// Gas in the liquid by volume at atmospheric pressure; default 0.
    pub gas_share: Option<f64>,
}

impl LiquidFields {
    /// The liquid, water where no other one is named, with its dead volume.
    pub(crate) fn supply(&self) -> Result<LiquidSupply, Problem> {
        let name = self.liquid.as_deref().unwrap_or("water");
        let mut liquid = Liquid::named(name, self.gas_share.unwrap_or(0.0))?;
        if let Some(modulus) = self.liquid_bulk_modulus_mpa {
            liquid = liquid.with_bulk_modulus(modulus)?;
        }
        let dead_volume_mm3 = match self.dead_volume_mm3 {
            None | Some(0.0) => 0.0,
            Some(dead) => above_zero(ProblemKind::Quantity, "dead_volume_mm3", dead)?,
        };
        Ok(LiquidSupply { liquid, dead_volume_mm3 })
    }

    /// The same where a liquid is named; else the muscle is filled with air.
    pub(crate) fn named_supply(&self) -> Result<Option<LiquidSupply>, Problem> {
        if self.liquid.is_some() {
            return self.supply().map(Some);
        }
        let given = [
            ("dead_volume_mm3", self.dead_volume_mm3.is_some()),
            ("liquid_bulk_modulus_mpa", self.liquid_bulk_modulus_mpa.is_some()),
            ("gas_share", self.gas_share.is_some()),
        ];
        Problem::refuse_unused(&given, "it belongs to `liquid`, and none is given")
            .map_err(|problem| problem.with_hint("give `liquid`: water, oil or glycol"))?;
        Ok(None)
    }
}

impl From<LiquidError> for Problem {
    fn from(error: LiquidError) -> Self {
        Self::new(ProblemKind::Quantity, error.to_string(), "").in_field(error.field)
    }
}
