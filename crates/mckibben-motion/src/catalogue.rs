//! Named valves.

use crate::{MotionError, Orifice, Result, Valve};
use mckibben_core::{
    muscle::file::{FileError, Source},
    nearest::nearest,
    units::{Dimension, parse_quantity},
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::sync::LazyLock;

/// A valve that one can buy.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedValve {
    /// Its name.
    pub name: String,
    /// What it is.
    pub what: String,
    /// From the supply into the muscle.
    pub supply: Orifice,
    /// From the muscle into the atmosphere.
    pub exhaust: Orifice,
    /// Where the numbers come from, and how they were converted.
    pub source: String,
}

/// Critical ratio of a valve that states none.
pub const CRITICAL_RATIO: f64 = 0.3;

static VALVES: LazyLock<Vec<NamedValve>> =
    LazyLock::new(|| read(include_str!("../data/valves.toml")).unwrap_or_default());

/// C in L/(s bar) of a standard nominal flow in l/min: the flow from 6 bar to 5 bar gauge (VDI
/// 3290), p1 = 7.01325 bar, at the critical ratio b, in litres at the reference of ISO 8778: Q = C
/// p1 ψ(6.01325/7.01325).
pub fn conductance_of_rated_flow(litres_per_minute: f64, critical_ratio: f64) -> Result<f64> {
    MotionError::positive("the rated flow in l/min", litres_per_minute)?;
    Ok(
        litres_per_minute / 60.0 * crate::air::REFERENCE_DENSITY_G_PER_L
            / Orifice::new(1.0, critical_ratio)?
                .flow((0.701_325, 293.15), (0.601_325, 293.15))
                .mass_g_per_s,
    )
}

/// All of them (`data/valves.toml`).
pub fn valves() -> &'static [NamedValve] {
    &VALVES
}

/// One by its name.
pub fn valve_named(name: &str) -> Option<&'static NamedValve> {
    valves().iter().find(|v| v.name == name)
}

/// What valves there are, beginning with the one that a wrong name may mean.
pub fn valves_known(name: &str) -> String {
    let all = Vec::from_iter(valves().iter().map(|v| v.name.as_str()));
    let near = nearest(name, all.iter().copied())
        .map_or_else(String::new, |n| format!("did you mean {n}? "));
    format!("{near}there are {}", all.join(", "))
}

impl std::str::FromStr for Valve {
    type Err = MotionError;

    /// A valve by its name, or by its sonic conductance such as `0.5 L/(s bar)`.
    fn from_str(text: &str) -> Result<Self> {
        let text = text.trim();
        if text.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == '-') {
            let conductance = parse_quantity(text, Dimension::Conductance)
                .map_err(|error| MotionError::Refused(error.to_string()))?;
            MotionError::positive("the valve's sonic conductance in L/(s bar)", conductance)?;
            return Ok(Self::new(Orifice::new(conductance, CRITICAL_RATIO)?));
        }
        let unknown = || {
            MotionError::Refused(format!(
                "{text} is not a known valve: {}",
                valves_known(text)
            ))
        };
        let named = valve_named(text).ok_or_else(unknown)?;
        Ok(Self {
            exhaust: named.exhaust,
            ..Self::new(named.supply)
        })
    }
}

/// The built-in table.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Table {
    valve: Vec<Row>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Row {
    name: String,
    what: String,
    sonic_conductance_l_per_s_bar: Option<f64>,
    /// In place of C.
    rated_flow_l_per_min: Option<f64>,
    critical_ratio: f64,
    exhaust_conductance_l_per_s_bar: Option<f64>,
    exhaust_critical_ratio: Option<f64>,
    source: String,
}

impl Row {
    /// The valve; of one that states a rated flow, C is by [`conductance_of_rated_flow`].
    fn valve(self) -> Result<NamedValve> {
        let b = self.critical_ratio;
        let rated = self.rated_flow_l_per_min.unwrap_or_default();
        let c = match self.sonic_conductance_l_per_s_bar {
            Some(c) => c,
            None => conductance_of_rated_flow(rated, b)?,
        };
        let supply = Orifice::new(c, b)?;
        let exhaust = match self.exhaust_conductance_l_per_s_bar {
            Some(c) => Orifice::new(c, self.exhaust_critical_ratio.unwrap_or(b))?,
            None => supply,
        };
        Ok(NamedValve {
            name: self.name,
            what: self.what,
            supply,
            exhaust,
            source: self.source,
        })
    }
}

fn read(text: &str) -> Result<Vec<NamedValve>, FileError> {
    let source = Source::parse(text)?;
    let table: Table = source.read()?;
    let valves: Result<Vec<NamedValve>> = table.valve.into_iter().map(Row::valve).collect();
    valves.map_err(|error| source.error("valve", error.to_string()))
}
