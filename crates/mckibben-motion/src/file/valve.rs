//! [valve], [regulator], [pump], [syringe] and [air].

use super::liquid;
use crate::air::{Air, Heat};
use crate::catalogue::{CRITICAL_RATIO, known, valve_named};
use crate::drive::Actuator;
use crate::hose::Hose;
use crate::liquid::Pump;
use crate::orifice::Orifice;
use crate::valve::{Valve, ValveKind};
use mckibben::muscle::file::{FileError, Section};

/// Where the command of a pressure opens a proportional valve wide, in MPa, and half of an on–off
/// valve's dead band.
const WIDE_OPEN_MPA: f64 = 0.05;
const HYSTERESIS_MPA: f64 = 0.005;

/// The tables of what gives the fluid.
const ACTUATORS: [&str; 4] = ["valve", "regulator", "pump", "syringe"];

/// What gives the fluid.
pub(super) fn actuator(root: &Section<'_>, is_liquid: bool) -> Result<Actuator, FileError> {
    let mut names = ACTUATORS.into_iter().filter(|name| root.has(name));
    let (first, second) = (names.next(), names.next());
    if let (Some(first), Some(second)) = (first, second) {
        return Err(root.error(second, format!("conflicts with [{first}]; keep one")));
    }
    let section = root.at(first.unwrap_or_default());
    match first {
        Some("valve") => read_valve(&section, is_liquid),
        Some("regulator") => Ok(Actuator::Regulator {
            time_constant_s: section.get("time_constant").unwrap_or_default(),
        }),
        Some("pump") => {
            let flow_mm3_per_s = section.get("flow").unwrap_or_default();
            Ok(Actuator::Pump(Pump {
                kind: kind(&section),
                flow_mm3_per_s,
                line: hose(&section)?,
            }))
        }
        Some(_) => Ok(liquid::syringe(&section)),
        None => {
            let expected = "a [valve] or a [regulator] that gives the air; of a liquid also a \
                [pump] or a [syringe]";
            Err(root.missing("valve", None, expected))
        }
    }
}

/// A valve, of air or of a liquid.
fn read_valve(section: &Section<'_>, is_liquid: bool) -> Result<Actuator, FileError> {
    let (kind, hose) = (kind(section), hose(section)?);
    if is_liquid {
        return Ok(Actuator::LiquidValve(liquid::valve(section, kind, hose)?));
    }
    if let Some(key) = ["flow_coefficient", "return_coefficient"]
        .into_iter()
        .find(|key| section.has(key))
    {
        let said = "is of a liquid, and the file has no [liquid]; air needs sonic_conductance";
        return Err(section.error(key, said));
    }
    Ok(Actuator::Valve(Valve {
        kind,
        hose,
        ..of_air(section)?
    }))
}

/// A valve; of a named one the file overrides what it states.
fn of_air(section: &Section<'_>) -> Result<Valve, FileError> {
    let unknown = |name| section.error("name", format!("is not a known valve: {}", known(name)));
    let named = section
        .get("name")
        .map(|name| valve_named(name).ok_or_else(|| unknown(name)));
    let named = named.transpose()?;
    let path = |c: &str, b: &str, default: Option<Orifice>| -> Result<Option<Orifice>, FileError> {
        let conductance = section
            .get(c)
            .or(default.map(|o| o.conductance_l_per_s_bar));
        let ratio = section
            .get(b)
            .or(default.map(|o| o.critical_ratio))
            .unwrap_or(CRITICAL_RATIO);
        let key = if section.has(b) { b } else { c };
        conductance
            .map(|conductance| section.valid(key, Orifice::new(conductance, ratio)))
            .transpose()
    };
    let supply = path(
        "sonic_conductance",
        "critical_ratio",
        named.map(|v| v.supply),
    )?
    .ok_or_else(|| {
        section.missing(
            "sonic_conductance",
            None,
            "the valve's C, such as \"0.5 L/(s bar)\", or a name",
        )
    })?;
    let same = named
        .filter(|_| !section.has("sonic_conductance"))
        .map_or(supply, |v| v.exhaust);
    let exhaust =
        path("exhaust_conductance", "exhaust_critical_ratio", Some(same))?.unwrap_or(supply);
    Ok(Valve {
        supply,
        exhaust,
        ..Valve::new(supply)
    })
}

/// How a valve or a pump moves.
fn kind(section: &Section<'_>) -> ValveKind {
    match section.get("kind") {
        Some("on-off") => ValveKind::OnOff {
            hysteresis_mpa: section.get("hysteresis").unwrap_or(HYSTERESIS_MPA),
            closed_centre: section.get("closed_centre").unwrap_or(true),
        },
        _ => ValveKind::Proportional {
            time_constant_s: section.get("lag").unwrap_or(0.0),
            gain_per_mpa: 1.0 / section.get("wide_open_at").unwrap_or(WIDE_OPEN_MPA),
        },
    }
}

/// What is between a valve or a pump and the muscle.
fn hose(section: &Section<'_>) -> Result<Option<Hose>, FileError> {
    const KEYS: (&str, &str) = ("hose_diameter", "hose_length");
    match (section.get(KEYS.0), section.get(KEYS.1)) {
        (Some(d), Some(l)) => section.valid(KEYS.1, Hose::new(d, l)).map(Some),
        (None, None) => Ok(None),
        (Some(_), None) => Err(section.missing(KEYS.1, Some(KEYS.0), "the hose's length")),
        (None, Some(_)) => Err(section.missing(KEYS.0, Some(KEYS.1), "the hose's inner diameter")),
    }
}

pub(super) fn air(section: &Section<'_>, wall_temperature_k: f64) -> Result<Air, FileError> {
    let expected =
        "\"isothermal\", \"adiabatic\", or a coefficient such as \"25 W/(m2 K)\" or \"0.3 W/K\"";
    let heat = match (
        section.get("heat").map(str::trim),
        section.get("polytropic_index"),
    ) {
        (Some(_), Some::<f64>(_)) => {
            return Err(section.error("polytropic_index", "conflicts with heat; keep one"));
        }
        (None, Some(n)) => Heat::Polytropic(n),
        (None | Some("isothermal"), None) => Heat::Isothermal,
        (Some("adiabatic"), None) => Heat::Adiabatic,
        (Some(text), None) => {
            let number = |unit: &str| {
                text.strip_suffix(unit)
                    .and_then(|t| t.trim().parse::<f64>().ok())
            };
            let of_area = ["W/(m2 K)", "W/(m² K)", "W/m2/K", "W/(m^2 K)"]
                .into_iter()
                .find_map(number);
            match (of_area, number("W/K")) {
                (Some(h), _) if h >= 0.0 => Heat::Transfer(h),
                (None, Some(h)) if h >= 0.0 => Heat::Conductance(h),
                _ => return Err(section.error("heat", format!("must be {expected}"))),
            }
        }
    };
    Ok(Air {
        heat,
        wall_temperature_k,
        dead_volume_mm3: section.get("dead_volume").unwrap_or(0.0),
    })
}
