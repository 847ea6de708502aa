//! What every answer, file and export says of the pressures that a muscle bears.

use super::failure::{Burst, FailureMode, FailurePressure};
use serde::Serialize;

/// The pressures that a muscle bears.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct PressureLimits {
    /// Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of
    /// what is estimated, of several muscles that of the weakest; none where no number for it is
    /// stated.
    #[serialize_always]
    pub burst_pressure_mpa: Option<f64>,
    /// How it fails there.
    pub burst_by: Option<FailureMode>,
    /// The pressure at which it fails by the nominal numbers, MPa, where number or strength of the
    /// strands are estimates.
    pub nominal_burst_pressure_mpa: Option<f64>,
    /// Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at
    /// which the tube does, two thirds of the least that each may be by estimates of the strands,
    /// and at most that for which the fittings are rated, or at which the strands are stretched to
    /// the validated limit.
    pub allowed_pressure_mpa: Option<f64>,
    /// What it keeps its distance from.
    pub allowed_by: Option<FailureMode>,
    /// The pressure of that over the allowed one.
    pub allowed_factor: Option<f64>,
    /// Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    pub ends_included: bool,
    /// Whether the allowed pressure was raised up to that of a proof test.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub overpressure: bool,
}

impl From<&Burst> for PressureLimits {
    fn from(found: &Burst) -> Self {
        let least = found.least();
        let allowed = found.allowed();
        let nominal_mpa = found.pressure_mpa();
        Self {
            burst_pressure_mpa: least.map(|f| f.1),
            burst_by: least.map(|f| f.0),
            nominal_burst_pressure_mpa: nominal_mpa.filter(|p| least.is_some_and(|f| f.1 < *p)),
            allowed_pressure_mpa: allowed.map(|a| a.mpa),
            allowed_by: allowed.map(|a| a.by),
            allowed_factor: allowed.map(|a| a.factor),
            ends_included: !matches!(found.ends, FailurePressure::Unknown(_)),
            overpressure: found.overpressure,
        }
    }
}

impl PressureLimits {
    /// Those of several muscles: of the one that allows the least pressure; the burst pressure of
    /// the weakest, and none where that of one of them is not known.
    pub fn of_all(all: &[Burst]) -> Self {
        let all: Vec<Self> = all.iter().map(Self::from).collect();
        let least = |of: fn(&Self) -> Option<f64>| {
            let known = all.iter().filter_map(|l| Some((of(l)?, l)));
            known
                .reduce(|a, b| if b.0 < a.0 { b } else { a })
                .map(|a| *a.1)
        };
        let weakest = least(|l| l.burst_pressure_mpa)
            .filter(|_| all.iter().all(|l| l.burst_pressure_mpa.is_some()))
            .unwrap_or_default();
        Self {
            burst_pressure_mpa: weakest.burst_pressure_mpa,
            burst_by: weakest.burst_by,
            nominal_burst_pressure_mpa: weakest.nominal_burst_pressure_mpa,
            ends_included: all.iter().all(|l| l.ends_included),
            ..least(|l| l.allowed_pressure_mpa).unwrap_or_default()
        }
    }
}
