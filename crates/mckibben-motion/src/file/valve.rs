//! [valve], [regulator], [pump], [syringe] and [air].

use super::checks::{above, at, said};
use super::liquid;
use crate::air::{Air, Heat};
use crate::catalogue::{CRITICAL_RATIO, known, valve_named};
use crate::drive::Actuator;
use crate::hose::Hose;
use crate::orifice::Orifice;
use crate::valve::{Valve, ValveKind};
use mckibben::muscle::file::{FileError, Section};
use mckibben::units::Dimension;

const VALVE: &[&str] = &[
    "name",
    "kind",
    "sonic_conductance",
    "critical_ratio",
    "exhaust_conductance",
    "exhaust_critical_ratio",
    "flow_coefficient",
    "return_coefficient",
    "lag",
    "wide_open_at",
    "hysteresis",
    "closed_centre",
    "hose_length",
    "hose_diameter",
];
const PUMP: &[&str] =
    &["flow", "kind", "lag", "wide_open_at", "hysteresis", "closed_centre", "hose_length", "hose_diameter"];
const AIR: &[&str] = &["dead_volume", "heat", "polytropic_index"];
/// Where the command of a pressure opens a proportional valve wide, in MPa, and half of an on–off valve's dead band.
const WIDE_OPEN_MPA: f64 = 0.05;
const HYSTERESIS_MPA: f64 = 0.005;

/// The tables of what gives the fluid.
const ACTUATORS: [&str; 4] = ["valve", "regulator", "pump", "syringe"];

/// The actuator; `base` where none is written.
pub(super) fn actuator(
    root: &Section<'_>,
    base: Option<Actuator>,
    of_liquid: bool,
) -> Result<Actuator, FileError> {
    let sections = ACTUATORS.map(|name| root.section(name, name));
    let [valve, regulator, pump, syringe] = sections;
    let (valve, regulator, pump, syringe) = (valve?, regulator?, pump?, syringe?);
    let written = [&valve, &regulator, &pump, &syringe].map(Section::is_written);
    let mut names = ACTUATORS.iter().zip(written).filter(|(_, written)| *written).map(|(name, _)| *name);
    if let (Some(first), Some(second)) = (names.next(), names.next()) {
        return Err(said(root, second, format!("conflicts with [{first}]; keep one")));
    }
    match written {
        [true, ..] => read_valve(&valve, base, of_liquid),
        [_, true, ..] => {
            regulator.only(&["time_constant"], &["regulator.time_constant"])?;
            let time_constant_s = above(&regulator, "time_constant", Dimension::Time)?.ok_or_else(|| {
                regulator.missing("time_constant", None, "how fast it follows, such as \"20 ms\"")
            })?;
            Ok(Actuator::Regulator { time_constant_s })
        }
        [_, _, true, _] => {
            pump.only(PUMP, PUMP)?;
            let base = if let Some(Actuator::Pump(base)) = base { Some(base) } else { None };
            liquid::pump(&pump, kind(&pump)?, hose(&pump)?, base)
        }
        [.., true] => liquid::syringe(
            &syringe,
            if let Some(Actuator::Syringe(base)) = base { Some(base) } else { None },
        ),
        _ => base.ok_or_else(|| {
            let expected =
                "a [valve] or a [regulator] that gives the air; of a liquid also a [pump] or a [syringe]";
            root.missing("valve", None, expected)
        }),
    }
}

/// A valve, of air or of a liquid.
fn read_valve(section: &Section<'_>, base: Option<Actuator>, of_liquid: bool) -> Result<Actuator, FileError> {
    section.only(VALVE, VALVE)?;
    let (kind, hose) = (kind(section)?, hose(section)?);
    if of_liquid {
        let base = if let Some(Actuator::LiquidValve(base)) = base { Some(base) } else { None };
        return Ok(Actuator::LiquidValve(liquid::valve(section, kind, hose, base)?));
    }
    for key in ["flow_coefficient", "return_coefficient"] {
        if section.has(key) {
            return Err(said(
                section,
                key,
                "is of a liquid, and the file has no [liquid]; air needs sonic_conductance",
            ));
        }
    }
    let base = if let Some(Actuator::Valve(base)) = base { Some(base) } else { None };
    Ok(Actuator::Valve(Valve { kind, hose, ..of_air(section, base)? }))
}

/// A valve; the ways that it leaves out are those of `base`.
fn of_air(section: &Section<'_>, base: Option<Valve>) -> Result<Valve, FileError> {
    let named = match section.text("name", "the name of a valve, in quotes")? {
        None => base.map(|v| (v.supply, v.exhaust)),
        Some(name) => match valve_named(name) {
            Some(v) => Some((v.supply, v.exhaust)),
            None => return Err(said(section, "name", format!("is not a known valve: {}", known(name)))),
        },
    };
    // Two ways that are alike stay alike.
    let alike = base.is_some_and(|v| v.supply == v.exhaust) && !section.has("name");
    let path = |c: &str, b: &str, own: Option<Orifice>| -> Result<Option<Orifice>, FileError> {
        let conductance = above(section, c, Dimension::Conductance)?;
        let ratio = section.number(b)?;
        let base = own.map(|o| (o.conductance_l_per_s_bar(), o.critical_ratio()));
        let Some(conductance) = conductance.or(base.map(|o| o.0)) else { return Ok(None) };
        let ratio = ratio.or(base.map(|o| o.1)).unwrap_or(CRITICAL_RATIO);
        let key = if section.has(b) { b } else { c };
        at(section, key, Orifice::new(conductance, ratio)).map(Some)
    };
    let supply = path("sonic_conductance", "critical_ratio", named.map(|v| v.0))?.ok_or_else(|| {
        section.missing("sonic_conductance", None, "the valve's C, such as \"0.5 L/(s bar)\", or a name")
    })?;
    let own = named.filter(|_| !section.has("sonic_conductance") && !alike).map_or(supply, |v| v.1);
    let exhaust = path("exhaust_conductance", "exhaust_critical_ratio", Some(own))?.unwrap_or(supply);
    Ok(Valve { supply, exhaust, ..Valve::new(supply) })
}

/// How a valve or a pump moves.
fn kind(section: &Section<'_>) -> Result<ValveKind, FileError> {
    Ok(match section.text("kind", "proportional or on-off, in quotes")?.unwrap_or("proportional") {
        "proportional" => ValveKind::Proportional {
            time_constant_s: section.quantity("lag", Dimension::Time)?.unwrap_or(0.0),
            gain_per_mpa: 1.0 / above(section, "wide_open_at", Dimension::Pressure)?.unwrap_or(WIDE_OPEN_MPA),
        },
        "on-off" => ValveKind::OnOff {
            hysteresis_mpa: above(section, "hysteresis", Dimension::Pressure)?.unwrap_or(HYSTERESIS_MPA),
            closed_centre: section.boolean("closed_centre")?.unwrap_or(true),
        },
        _ => return Err(said(section, "kind", "must be \"proportional\" or \"on-off\"")),
    })
}

/// What is between a valve or a pump and the muscle.
fn hose(section: &Section<'_>) -> Result<Option<Hose>, FileError> {
    let length = above(section, "hose_length", Dimension::Length)?;
    Ok(match (above(section, "hose_diameter", Dimension::Length)?, length) {
        (Some(d), Some(l)) => Some(at(section, "hose_length", Hose::new(d, l))?),
        (None, None) => None,
        (Some(_), None) => {
            return Err(section.missing("hose_length", Some("hose_diameter"), "the hose's length"));
        }
        (None, Some(_)) => {
            return Err(section.missing("hose_diameter", Some("hose_length"), "the hose's inner diameter"));
        }
    })
}

pub(super) fn air(section: &Section<'_>, wall_temperature_k: f64) -> Result<Air, FileError> {
    section.only(AIR, AIR)?;
    let expected = "\"isothermal\", \"adiabatic\", or a coefficient such as \"25 W/(m2 K)\" or \"0.3 W/K\"";
    let heat = match section.text("heat", expected)?.map(str::trim) {
        None | Some("isothermal") => Heat::Isothermal,
        Some("adiabatic") => Heat::Adiabatic,
        Some(text) => {
            let number = |unit: &str| text.strip_suffix(unit).and_then(|t| t.trim().parse::<f64>().ok());
            let of_area = ["W/(m2 K)", "W/(m² K)", "W/m2/K", "W/(m^2 K)"].into_iter().find_map(number);
            match (of_area, number("W/K")) {
                (Some(h), _) if h >= 0.0 => Heat::Transfer(h),
                (None, Some(h)) if h >= 0.0 => Heat::Conductance(h),
                _ => return Err(said(section, "heat", format!("must be {expected}"))),
            }
        }
    };
    let heat = match section.number("polytropic_index")? {
        None => heat,
        Some(_) if section.has("heat") => {
            return Err(said(section, "polytropic_index", "conflicts with heat; keep one"));
        }
        Some(n) if (1.0..=1.4).contains(&n) => Heat::Polytropic(n),
        Some(_) => return Err(said(section, "polytropic_index", "must be from 1 to 1.4")),
    };
    let dead_volume_mm3 = section.quantity("dead_volume", Dimension::Volume)?.unwrap_or(0.0);
    Ok(Air { heat, wall_temperature_k, dead_volume_mm3 })
}
