//! Loads in requests, and what a muscle does with them.

use crate::{ProblemKind, Result, TextFile, Units, flags::Args, print::Page};
use mckibben_core::{
    analysis::Evaluation,
    by_number::ByNumber,
    cancel,
    load::{Balance, Cycle, Load, LoadError, LoadTable, cycle},
    warning::sentence,
};
use mckibben_io::table::read_load;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, fmt};

/// What a muscle works against.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct LoadFields {
    /// Load, such as 20kg, 300N or 12N/mm
    ///
    /// A mass, a force, a spring with its preload (12N/mm@50N), lever:5kg@300mm/40mm/-30deg (mass,
    /// its distance from the pivot, the pulley's radius, the angle from the horizontal),
    /// table:load.csv; several joined by +.
    #[arg(long, allow_hyphen_values = true)]
    pub load: Option<String>,
    /// The tables that it names.
    #[arg(skip)]
    pub load_tables: Vec<TextFile>,
}

impl LoadFields {
    /// The load, for a muscle of this length.
    pub fn resolve(&self, rest_length_mm: f64) -> Result<Option<Load>> {
        let Some(text) = &self.load else {
            return Ok(None);
        };
        let read = |file: &TextFile| -> Result<(String, LoadTable)> {
            let bad = |error: &dyn fmt::Display| {
                ProblemKind::Data
                    .problem(format!("{}: {error}", file.name))
                    .in_field("load_tables")
            };
            if !cfg!(feature = "whole") {
                return Err(bad(&"tables need the full engine; this is a reduced one"));
            }
            let points = read_load(&file.text, rest_length_mm).map_err(|e| bad(&e))?;
            Ok((
                file.name.clone(),
                LoadTable::new(points).map_err(|e| bad(&e))?,
            ))
        };
        let tables = self
            .load_tables
            .iter()
            .map(read)
            .collect::<Result<BTreeMap<_, _>>>()?;
        Load::parse(text, &|name| tables.get(name).cloned())
            .map(Some)
            .map_err(|error| ProblemKind::Quantity.problem(error).in_field("load"))
    }
}

/// The equilibria at pressures, and the stroke from the first to the last.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct LoadAnswer {
    /// The load as it was written.
    pub load: String,
    /// At each pressure its equilibria, by rising contraction; none where the load is not lifted.
    pub at: Vec<LoadedAt>,
    /// From the lowest pressure to the highest, where the load is lifted at the highest.
    pub cycle: Option<Cycle>,
    /// The load itself.
    #[serde(skip)]
    pub line: Load,
}

/// The equilibria at a pressure.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LoadedAt {
    /// The pressure, MPa.
    pub pressure_mpa: f64,
    /// The equilibria, by rising contraction.
    pub equilibria: Vec<Balance>,
    /// Why there is none.
    #[serde(
        rename = "cause",
        skip_serializing_if = "Option::is_none",
        serialize_with = "sentence"
    )]
    #[schemars(with = "Option<String>")]
    pub error: Option<LoadError>,
}

/// Equilibria of a model and a load at pressures.
pub fn loaded(
    fields: &LoadFields,
    evaluation: &mut Evaluation<'_>,
    pressures_mpa: &[f64],
) -> Result<Option<LoadAnswer>> {
    let length = evaluation.model.muscle().length_mm();
    let Some(load) = fields.resolve(length)? else {
        return Ok(None);
    };
    let mut stable = vec![];
    let mut at = vec![];
    for &pressure_mpa in pressures_mpa {
        let balances = evaluation.balances(&load, pressure_mpa);
        cancel::check()?;
        let (equilibria, error) = balances.map_or_else(|e| (vec![], Some(e)), |all| (all, None));
        stable.push((pressure_mpa, equilibria.iter().find(|b| b.stable).cloned()));
        at.push(LoadedAt {
            pressure_mpa,
            equilibria,
            error,
        });
    }
    let least = stable.iter().min_by_number(|a| a.0);
    let most = stable.iter().max_by_number(|a| a.0);
    let cycle = match (least, most) {
        (Some((low, from)), Some((high, Some(to)))) if low < high => {
            let (contraction, volume) = match from {
                Some(from) => (
                    from.answer.response.contraction,
                    from.answer.response.volume_mm3,
                ),
                // The load rests on its stop.
                None => (0.0, evaluation.cavity_mm3(*low, 0.0).ok()),
            };
            let mut cycle = cycle(&load, length, (*low, contraction, volume), to);
            let job = evaluation.model.muscle().job();
            // What it costs of a liquid, `fill` says.
            cycle.air_normal_litres = cycle
                .air_normal_litres
                .filter(|_| job.is_none_or(|job| job.liquid.is_none()));
            Some(cycle)
        }
        _ => None,
    };
    Ok(Some(LoadAnswer {
        load: fields.load.clone().unwrap_or_default(),
        at,
        cycle,
        line: load,
    }))
}

/// Fields of an equilibrium that a page has.
const SHOWN: [&str; 9] = [
    "pressure_mpa",
    "contraction",
    "predicted_contraction",
    "shortening_mm",
    "force_n",
    "held_stiffness_n_per_mm",
    "stable",
    "natural_frequency_hz",
    "cause",
];

impl LoadAnswer {
    /// A table of the equilibria, and the stroke between the lowest and the highest pressure.
    pub fn onto(&self, page: &mut Page, u: &Units) {
        page.paragraph(format!("load {}", self.load));
        let all = Vec::from_iter(self.at.iter().flat_map(|at| &at.equilibria));
        page.list("", &all, u, &SHOWN);
        let none = Vec::from_iter(self.at.iter().filter(|at| at.error.is_some()));
        page.list("", &none, u, &SHOWN);
        if let Some(cycle) = &self.cycle {
            page.gap();
            page.and(Page::of(cycle, u, &[]));
        }
    }
}
