//! What fills a muscle: air or a liquid.

use crate::{Air, Cavity, Flow, Heat, LiquidFill};
use mckibben::analysis::HEAT_RATIO;

/// What fills a muscle.
#[derive(Debug, Clone, PartialEq)]
pub enum Fluid {
    /// Air.
    Air(Air),
    /// A liquid.
    Liquid(LiquidFill),
}

impl Default for Fluid {
    fn default() -> Self {
        Self::Air(Air::default())
    }
}

impl Fluid {
    /// Whether it is a liquid.
    pub fn is_liquid(&self) -> bool {
        matches!(self, Self::Liquid(_))
    }

    /// Volume outside of the cavity in mm³, without the hose.
    pub fn dead_volume_mm3(&self) -> f64 {
        match self {
            Self::Air(air) => air.dead_volume_mm3,
            Self::Liquid(liquid) => liquid.dead_volume_mm3,
        }
    }

    /// The wall's temperature in K.
    pub fn wall_temperature_k(&self) -> f64 {
        match self {
            Self::Air(air) => air.wall_temperature_k,
            Self::Liquid(liquid) => liquid.temperature_k,
        }
    }

    /// Its temperature in K.
    pub fn temperature_k(&self, absolute_mpa: f64, mass_g: f64, volume_mm3: f64) -> f64 {
        match self {
            Self::Air(air) => air.temperature_k(absolute_mpa, mass_g, volume_mm3),
            Self::Liquid(liquid) => liquid.temperature_k,
        }
    }

    /// Its mass in g at the wall's temperature.
    pub fn mass_g(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        match self {
            Self::Air(air) => air.mass_g(absolute_mpa, volume_mm3),
            Self::Liquid(liquid) => liquid.mass_g(absolute_mpa, volume_mm3),
        }
    }

    /// Whether its heat passes through the area of the wall.
    pub(crate) fn needs_area(&self) -> bool {
        matches!(self, Self::Air(Air { heat: Heat::Transfer(_), .. }))
    }

    /// ṗ in MPa/s for given flows.
    pub(crate) fn pressure_rate_mpa_per_s(
        &self,
        absolute_mpa: f64,
        temperature_k: f64,
        cavity: &Cavity,
        flows: &[Flow],
    ) -> f64 {
        match self {
            Self::Air(air) => air.pressure_rate_mpa_per_s(absolute_mpa, temperature_k, cavity, flows),
            Self::Liquid(liquid) => liquid.pressure_rate_mpa_per_s(absolute_mpa, cavity, flows),
        }
    }

    /// The flow that makes the pressure change at a rate.
    pub(crate) fn flow_for_rate(
        &self,
        rate_mpa_per_s: f64,
        (absolute_mpa, temperature_k): (f64, f64),
        cavity: &Cavity,
        supply_k: f64,
    ) -> Flow {
        match self {
            Self::Air(air) => {
                air.flow_for_rate(rate_mpa_per_s, absolute_mpa, temperature_k, cavity, supply_k)
            }
            Self::Liquid(liquid) => liquid.flow_for_rate(rate_mpa_per_s, absolute_mpa, cavity),
        }
    }

    /// What a flow carries in mW: of air its enthalpy, of a liquid its stored energy and p V at the muscle's pressure.
    pub(crate) fn enthalpy_mw(&self, flow: Flow, absolute_mpa: f64) -> f64 {
        match self {
            Self::Air(_) => flow.enthalpy_mw(),
            Self::Liquid(liquid) => liquid.enthalpy_mw(flow, absolute_mpa),
        }
    }

    /// Heat from the wall in mW; a liquid's is not counted.
    pub(crate) fn heat_mw(&self, absolute_mpa: f64, rate: f64, cavity: &Cavity, flows: &[Flow]) -> f64 {
        match self {
            Self::Air(air) => air.heat_mw(absolute_mpa, rate, cavity, flows),
            Self::Liquid(_) => 0.0,
        }
    }

    /// Its internal energy in mJ: of air p V/(γ − 1).
    pub(crate) fn internal_mj(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        match self {
            Self::Air(_) => absolute_mpa * volume_mm3 / (HEAT_RATIO - 1.0),
            Self::Liquid(liquid) => liquid.internal_mj(absolute_mpa, volume_mm3),
        }
    }
}
