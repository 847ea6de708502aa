//! [liquid], [pump], [syringe] and the valve of a liquid.

use crate::drive::Actuator;
use crate::hose::Hose;
use crate::liquid::{LiquidFill, LiquidValve, Restriction, Syringe};
use crate::valve::ValveKind;
use mckibben::liquid::Liquid;
use mckibben::muscle::file::{FileError, Section};
use mckibben::refused::Refused;

/// What [liquid] says; `None` where it is not written.
pub(super) fn liquid(
    section: &Section<'_>,
    temperature_k: f64,
) -> Result<Option<LiquidFill>, FileError> {
    let Some(name) = section.get("name") else {
        return Ok(None);
    };
    let wrong = |error: Refused| {
        section.error(
            error.fields.last().copied().unwrap_or_default(),
            format!("is invalid: {error}"),
        )
    };
    let mut liquid = Liquid::named(name, section.get("gas_share").unwrap_or(0.0)).map_err(wrong)?;
    if let Some(modulus) = section.get("bulk_modulus") {
        liquid = liquid.with_bulk_modulus(modulus).map_err(wrong)?;
    }
    Ok(Some(LiquidFill {
        liquid,
        temperature_k,
        dead_volume_mm3: section.get("dead_volume").unwrap_or(0.0),
    }))
}

/// The valve of a liquid.
pub(super) fn valve(
    section: &Section<'_>,
    kind: ValveKind,
    line: Option<Hose>,
) -> Result<LiquidValve, FileError> {
    let of_air = [
        "name",
        "sonic_conductance",
        "critical_ratio",
        "exhaust_conductance",
        "exhaust_critical_ratio",
    ];
    if let Some(key) = of_air.into_iter().find(|key| section.has(key)) {
        return Err(section.error(
            key,
            "is of a valve of air; a liquid needs flow_coefficient alone",
        ));
    }
    let path = |key: &str| {
        section
            .get(key)
            .map(|kv| section.valid(key, Restriction::new(kv)))
            .transpose()
    };
    let supply = path("flow_coefficient")?.ok_or_else(|| {
        section.missing(
            "flow_coefficient",
            None,
            "the valve's Kv, such as \"0.1 m3/h\"",
        )
    })?;
    Ok(LiquidValve {
        kind,
        supply,
        tank: path("return_coefficient")?.unwrap_or(supply),
        line,
    })
}

/// [syringe].
pub(super) fn syringe(section: &Section<'_>) -> Actuator {
    /// How fast a piston follows, in s, where the file does not say.
    const TIME_CONSTANT_S: f64 = 0.05;
    Actuator::Syringe(Syringe {
        volume_mm3: section.get("volume").unwrap_or_default(),
        time_constant_s: section.get("time_constant").unwrap_or(TIME_CONSTANT_S),
    })
}
