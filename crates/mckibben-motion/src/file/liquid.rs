//! [liquid], [pump], [syringe] and the valve of a liquid.

use super::checks::{above, at, said};
use crate::drive::Actuator;
use crate::hose::Hose;
use crate::liquid::{LiquidFill, LiquidValve, Pump, Restriction, Syringe};
use crate::valve::ValveKind;
use mckibben::liquid::{Liquid, LiquidError};
use mckibben::muscle::file::{FileError, Problem, Section};
use mckibben::units::Dimension;

/// Keys of [liquid], [pump] and [syringe]; those of a valve are in its own file.
const LIQUID: &[&str] = &["name", "bulk_modulus", "gas_share", "dead_volume"];
const SYRINGE: &[&str] = &["volume", "time_constant"];

/// What [liquid] says; `None` where it is not written.
pub(super) fn liquid(section: &Section<'_>, temperature_k: f64) -> Result<Option<LiquidFill>, FileError> {
    if !section.is_written() {
        return Ok(None);
    }
    section.only(LIQUID, LIQUID)?;
    let wrong = |error: LiquidError| section.error(error.key, Problem::Said(format!("is invalid: {error}")));
    let name = section
        .text("name", "the name of a liquid, in quotes")?
        .ok_or_else(|| section.missing("name", None, "the liquid: water, oil or glycol"))?;
    let gas_share = section.quantity("gas_share", Dimension::Ratio)?.unwrap_or(0.0);
    let mut liquid = Liquid::named(name, gas_share).map_err(wrong)?;
    if let Some(modulus) = section.quantity("bulk_modulus", Dimension::Pressure)? {
        liquid = liquid.with_bulk_modulus(modulus).map_err(wrong)?;
    }
    let dead_volume_mm3 = section.quantity("dead_volume", Dimension::Volume)?.unwrap_or(0.0);
    Ok(Some(LiquidFill { liquid, temperature_k, dead_volume_mm3 }))
}

/// The valve of a liquid; `base` where it leaves something out.
pub(super) fn valve(
    section: &Section<'_>,
    kind: ValveKind,
    line: Option<Hose>,
    base: Option<LiquidValve>,
) -> Result<LiquidValve, FileError> {
    for key in
        ["name", "sonic_conductance", "critical_ratio", "exhaust_conductance", "exhaust_critical_ratio"]
    {
        if section.has(key) {
            return Err(said(section, key, "is of a valve of air; a liquid needs flow_coefficient alone"));
        }
    }
    let way = |key: &str| -> Result<Option<Restriction>, FileError> {
        let kv = above(section, key, Dimension::Flow)?;
        kv.map(|kv| at(section, key, Restriction::new(kv))).transpose()
    };
    let supply = way("flow_coefficient")?
        .or(base.map(|b| b.supply))
        .ok_or_else(|| section.missing("flow_coefficient", None, "the valve's Kv, such as \"0.1 m3/h\""))?;
    // Two ways that are alike stay alike.
    let own = base.filter(|b| b.supply != b.tank).map_or(supply, |b| b.tank);
    let tank = way("return_coefficient")?.unwrap_or(own);
    Ok(LiquidValve { kind, supply, tank, line })
}

/// [pump].
pub(super) fn pump(
    section: &Section<'_>,
    kind: ValveKind,
    line: Option<Hose>,
    base: Option<Pump>,
) -> Result<Actuator, FileError> {
    let flow = above(section, "flow", Dimension::Flow)?.or(base.map(|b| b.flow_mm3_per_s));
    let flow_mm3_per_s =
        flow.ok_or_else(|| section.missing("flow", None, "the pump's largest flow, such as \"0.5 L/min\""))?;
    Ok(Actuator::Pump(Pump { kind, flow_mm3_per_s, line }))
}

/// [syringe].
pub(super) fn syringe(section: &Section<'_>, base: Option<Syringe>) -> Result<Actuator, FileError> {
    /// How fast a piston follows, in s, where the file does not say.
    const TIME_CONSTANT_S: f64 = 0.05;
    section.only(SYRINGE, SYRINGE)?;
    let volume = above(section, "volume", Dimension::Volume)?.or(base.map(|b| b.volume_mm3));
    let volume_mm3 =
        volume.ok_or_else(|| section.missing("volume", None, "what the syringe holds, such as \"20 mL\""))?;
    let time_constant_s = above(section, "time_constant", Dimension::Time)?
        .or(base.map(|b| b.time_constant_s))
        .unwrap_or(TIME_CONSTANT_S);
    Ok(Actuator::Syringe(Syringe { volume_mm3, time_constant_s }))
}
