//! [valve], [regulator], [pump], [syringe] and [air].

use super::{
    keys::{DriveKeys, OfAir, OfPump, OfRegulator, OfSyringe, OfValve},
    liquid,
};
use crate::{
    air::{Air, Heat},
    catalogue::{CRITICAL_RATIO, valve_named, valves_known},
    drive::Actuator,
    hose::Hose,
    liquid::{Pump, Syringe},
    orifice::Orifice,
    valve::Valve,
};
use mckibben_core::{
    muscle::file::{FileError, Source},
    units::{
        Positive,
        typed::{Conductance, Length},
    },
};

/// How fast the piston of a syringe follows, in s, where the file does not say.
const TIME_CONSTANT_S: f64 = 0.05;

/// What gives the fluid.
pub fn actuator<P>(
    keys: &DriveKeys<P>,
    source: &Source<'_>,
    is_liquid: bool,
) -> Result<Actuator, FileError> {
    let of_valve = |keys| read_valve(keys, source, is_liquid);
    let of_regulator = |keys: &OfRegulator| {
        Ok(Actuator::Regulator {
            time_constant_s: keys.time_constant.into(),
        })
    };
    let of_pump = |keys: &OfPump| {
        Ok(Actuator::Pump(Pump {
            kind: keys.moves(),
            flow_mm3_per_s: keys.flow.into(),
            line: hose(keys.hose_length, keys.hose_diameter, source, "pump")?,
        }))
    };
    let of_syringe = |keys: &OfSyringe| {
        Ok(Actuator::Syringe(Syringe {
            volume_mm3: keys.volume.into(),
            time_constant_s: keys.time_constant.map_or(TIME_CONSTANT_S, f64::from),
        }))
    };
    let all = [
        ("valve", keys.valve.as_ref().map(of_valve)),
        ("regulator", keys.regulator.as_ref().map(of_regulator)),
        ("pump", keys.pump.as_ref().map(of_pump)),
        ("syringe", keys.syringe.as_ref().map(of_syringe)),
    ];
    let mut given = all
        .into_iter()
        .filter_map(|(name, read)| Some((name, read?)));
    match (given.next(), given.next()) {
        (Some((first, _)), Some((second, _))) => {
            Err(source.error(second, format!("conflicts with [{first}]; keep one")))
        }
        (Some((_, actuator)), None) => actuator,
        (None, _) => Err(source.missing(
            "valve",
            "",
            "a [valve] or a [regulator] that gives the air; of a liquid also a \
                [pump] or a [syringe]",
        )),
    }
}

/// A valve, of air or of a liquid.
fn read_valve(
    valve: &OfValve,
    source: &Source<'_>,
    is_liquid: bool,
) -> Result<Actuator, FileError> {
    let kind = valve.moves();
    let hose = hose(valve.hose_length, valve.hose_diameter, source, "valve")?;
    if is_liquid {
        return Ok(Actuator::LiquidValve(liquid::valve(
            valve, source, kind, hose,
        )?));
    }
    let of_liquid = ["valve.flow_coefficient", "valve.return_coefficient"];
    if let Some(key) = of_liquid.into_iter().find(|key| source.has(key)) {
        return Err(source.error(
            key,
            "is of a liquid, and the file has no [liquid]; air needs sonic_conductance",
        ));
    }
    Ok(Actuator::Valve(Valve {
        kind,
        hose,
        ..of_air(valve, source)?
    }))
}

/// A valve; of a named one the file overrides what it states.
fn of_air(valve: &OfValve, source: &Source<'_>) -> Result<Valve, FileError> {
    let unknown = |name: &str| {
        source.error(
            "valve.name",
            format!("is not a known valve: {}", valves_known(name)),
        )
    };
    let named = valve
        .name
        .as_deref()
        .map(|name| valve_named(name).ok_or_else(|| unknown(name)))
        .transpose()?;
    let path = |(c, conductance): (&str, Option<Positive<Conductance>>),
                (b, ratio): (&str, Option<f64>),
                default: Option<Orifice>|
     -> Result<Option<Orifice>, FileError> {
        let conductance = conductance
            .map(f64::from)
            .or(default.map(|o| o.conductance_l_per_s_bar));
        let key = if ratio.is_some() { b } else { c };
        let ratio = ratio.or(default.map(|o| o.critical_ratio));
        let orifice = |c| Orifice::new(c, ratio.unwrap_or(CRITICAL_RATIO));
        conductance
            .map(|c| source.valid(key, orifice(c)))
            .transpose()
    };
    let supply = path(
        ("valve.sonic_conductance", valve.sonic_conductance),
        ("valve.critical_ratio", valve.critical_ratio),
        named.map(|v| v.supply),
    )?
    .ok_or_else(|| {
        source.missing(
            "valve.sonic_conductance",
            "valve",
            "the valve's C, such as \"0.5 L/(s bar)\", or a name",
        )
    })?;
    let same = named
        .filter(|_| valve.sonic_conductance.is_none())
        .map_or(supply, |v| v.exhaust);
    let exhaust = path(
        ("valve.exhaust_conductance", valve.exhaust_conductance),
        ("valve.exhaust_critical_ratio", valve.exhaust_critical_ratio),
        Some(same),
    )?;
    Ok(Valve {
        supply,
        exhaust: exhaust.unwrap_or(supply),
        ..Valve::new(supply)
    })
}

/// What is between a valve or a pump and the muscle.
fn hose(
    length: Option<Positive<Length>>,
    diameter: Option<Positive<Length>>,
    source: &Source<'_>,
    table: &str,
) -> Result<Option<Hose>, FileError> {
    let length = ("hose_length", length, "the hose's length");
    let diameter = ("hose_diameter", diameter, "the hose's inner diameter");
    let hose = source
        .both(table, length, diameter)?
        .map(|(length, diameter)| Hose::new(diameter.into(), length.into()));
    hose.map(|hose| source.valid(&format!("{table}.hose_length"), hose))
        .transpose()
}

pub fn air(keys: &OfAir, source: &Source<'_>, wall_temperature_k: f64) -> Result<Air, FileError> {
    let heat = match (keys.heat.as_deref(), keys.polytropic_index) {
        (Some(_), Some(_)) => {
            return Err(source.error("air.polytropic_index", "conflicts with heat; keep one"));
        }
        (None, Some(n)) => {
            let heat = Heat::Polytropic(n);
            source.valid("air.polytropic_index", heat.check())?;
            heat
        }
        (None, None) => Heat::Isothermal,
        (Some(text), None) => heat(text.trim()).ok_or_else(|| {
            source.error(
                "air.heat",
                "must be \"isothermal\", \"adiabatic\", or a coefficient such as \
                \"25 W/(m2 K)\" or \"0.3 W/K\"",
            )
        })?,
    };
    Ok(Air {
        heat,
        wall_temperature_k,
        dead_volume_mm3: keys.dead_volume.0,
    })
}

fn heat(text: &str) -> Option<Heat> {
    let number = |unit: &str| -> Option<f64> {
        let number: f64 = text.strip_suffix(unit)?.trim().parse().ok()?;
        (number >= 0.0).then_some(number)
    };
    let of_area = ["W/(m2 K)", "W/(m² K)", "W/m2/K", "W/(m^2 K)"];
    match text {
        "isothermal" => Some(Heat::Isothermal),
        "adiabatic" => Some(Heat::Adiabatic),
        _ => of_area
            .into_iter()
            .find_map(number)
            .map(Heat::Transfer)
            .or_else(|| number("W/K").map(Heat::Conductance)),
    }
}
