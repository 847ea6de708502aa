//! Named valves.

use crate::error::MotionError;
use crate::valve::Orifice;
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

static VALVES: LazyLock<Vec<NamedValve>> =
    LazyLock::new(|| read(include_str!("../data/valves.toml")).unwrap_or_default());

/// C in L/(s bar) of a standard nominal flow in l/min: the flow from 6 bar to 5 bar gauge (VDI 3290), p1 = 7.01325 bar, at the critical
/// ratio b, in litres at the reference of ISO 8778: Q = C p1 ψ(6.01325/7.01325).
///
/// # Errors
/// As [`Orifice::new`].
pub fn conductance_of_rated_flow(litres_per_minute: f64, critical_ratio: f64) -> Result<f64, MotionError> {
    MotionError::positive("the rated flow in l/min", litres_per_minute)?;
    let one = Orifice::new(1.0, critical_ratio)?;
    let flow = one.flow((0.701_325, 293.15), (0.601_325, 293.15)).mass_g_per_s;
    Ok(litres_per_minute / 60.0 * crate::air::REFERENCE_DENSITY_G_PER_L / flow)
}

/// All of them (`data/valves.toml`).
pub fn valves() -> &'static [NamedValve] {
    &VALVES
}

/// One by its name.
pub fn valve_named(name: &str) -> Option<&'static NamedValve> {
    valves().iter().find(|v| v.name == name)
}

/// The file's rows; those that state a rated flow have C by [`conductance_of_rated_flow`].
fn read(text: &str) -> Option<Vec<NamedValve>> {
    let document: toml_edit::DocumentMut = text.parse().ok()?;
    let number =
        |item: Option<&toml_edit::Item>| item.and_then(|i| i.as_float().or(i.as_integer().map(|v| v as f64)));
    let rows = document.get("valve")?.as_array_of_tables()?;
    rows.iter()
        .map(|row| {
            let word = |key: &str| row.get(key).and_then(|i| i.as_str()).map(str::to_owned);
            let b = number(row.get("critical_ratio"))?;
            let c = match number(row.get("sonic_conductance_l_per_s_bar")) {
                Some(c) => c,
                None => conductance_of_rated_flow(number(row.get("rated_flow_l_per_min"))?, b).ok()?,
            };
            let supply = Orifice::new(c, b).ok()?;
            let exhaust = match number(row.get("exhaust_conductance_l_per_s_bar")) {
                Some(c) => Orifice::new(c, number(row.get("exhaust_critical_ratio"))?).ok()?,
                None => supply,
            };
            Some(NamedValve {
                name: word("name")?,
                what: word("what")?,
                supply,
                exhaust,
                source: word("source")?,
            })
        })
        .collect()
}
