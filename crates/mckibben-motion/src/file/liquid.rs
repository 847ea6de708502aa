//! [liquid], and the valve of a liquid.

use super::keys::{OfLiquid, OfValve};
use crate::{
    hose::Hose,
    liquid::{LiquidFill, LiquidValve, Restriction},
    valve::ValveKind,
};
use mckibben_core::{
    liquid::Liquid,
    muscle::file::{FileError, Source},
    refused::Refused,
    units::{Positive, typed::Flow},
};

/// What [liquid] says.
pub fn liquid(
    keys: &OfLiquid,
    source: &Source<'_>,
    temperature_k: f64,
) -> Result<LiquidFill, FileError> {
    let wrong = |error: Refused| {
        let key = error.fields.last().copied().unwrap_or_default();
        source.error(&format!("liquid.{key}"), format!("is invalid: {error}"))
    };
    let mut liquid = Liquid::named(&keys.name, keys.gas_share.0).map_err(wrong)?;
    if let Some(modulus) = keys.bulk_modulus {
        liquid = liquid.with_bulk_modulus(modulus.into()).map_err(wrong)?;
    }
    Ok(LiquidFill {
        liquid,
        temperature_k,
        dead_volume_mm3: keys.dead_volume.0,
    })
}

/// The valve of a liquid.
pub fn valve(
    keys: &OfValve,
    source: &Source<'_>,
    kind: ValveKind,
    line: Option<Hose>,
) -> Result<LiquidValve, FileError> {
    let of_air = [
        "valve.name",
        "valve.sonic_conductance",
        "valve.critical_ratio",
        "valve.exhaust_conductance",
        "valve.exhaust_critical_ratio",
    ];
    if let Some(key) = of_air.into_iter().find(|key| source.has(key)) {
        return Err(source.error(
            key,
            "is of a valve of air; a liquid needs flow_coefficient alone",
        ));
    }
    let path = |key: &str, kv: Option<Positive<Flow>>| {
        kv.map(|kv| source.valid(key, Restriction::new(kv.into())))
            .transpose()
    };
    let supply = path("valve.flow_coefficient", keys.flow_coefficient)?.ok_or_else(|| {
        source.missing(
            "valve.flow_coefficient",
            "valve",
            "the valve's Kv, such as \"0.1 m3/h\"",
        )
    })?;
    Ok(LiquidValve {
        kind,
        supply,
        tank: path("valve.return_coefficient", keys.return_coefficient)?.unwrap_or(supply),
        line,
    })
}
