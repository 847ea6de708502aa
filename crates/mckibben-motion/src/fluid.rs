//! What fills a muscle: air or a liquid.

use crate::{Air, Flow, LiquidFill, air::Cavity};

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

    /// Its laws.
    pub(crate) fn medium(&self) -> &dyn Medium {
        match self {
            Self::Air(air) => air,
            Self::Liquid(liquid) => liquid,
        }
    }
}

/// What flows at a time.
#[derive(Default)]
pub struct FluidRates {
    pub supply: Flow,
    pub exhaust: Flow,
    pub pressure_rate: f64,
    pub opening: f64,
    pub opening_rate: f64,
    pub signal: f64,
    /// What a syringe's piston pushes out, in mm³/s.
    pub piston_mm3_per_s: f64,
}

/// The laws of a fluid in a muscle; pressures are absolute.
pub trait Medium {
    /// Volume outside of the cavity in mm³, without the hose.
    fn dead_volume_mm3(&self) -> f64;

    /// The wall's temperature in K.
    fn wall_temperature_k(&self) -> f64;

    /// Its temperature in K.
    fn temperature_k(&self, absolute_mpa: f64, mass_g: f64, volume_mm3: f64) -> f64;

    /// Mass in g of what has a volume at the wall's temperature.
    fn mass_g(&self, absolute_mpa: f64, volume_mm3: f64) -> f64;

    /// ṗ in MPa/s for given flows.
    fn pressure_rate_mpa_per_s(&self, cavity: &Cavity, flows: &[Flow]) -> f64;

    /// The flow that makes the pressure change at a rate: in from a supply at `supply_k`, out at
    /// the temperature of the fluid.
    fn flow_for_rate(&self, rate_mpa_per_s: f64, cavity: &Cavity, supply_k: f64) -> Flow;

    /// What a flow carries in mW.
    fn enthalpy_mw(&self, flow: Flow, absolute_mpa: f64) -> f64;

    /// Its internal energy in mJ.
    fn internal_mj(&self, absolute_mpa: f64, volume_mm3: f64) -> f64;

    /// Heat from the wall in mW while the pressure changes at a rate; a liquid's is not counted.
    fn heat_mw(&self, _rate_mpa_per_s: f64, _cavity: &Cavity, _flows: &[Flow]) -> f64 {
        0.0
    }

    /// Whether its heat passes through the area of the wall.
    fn needs_area(&self) -> bool {
        false
    }

    /// Whether it boils.
    fn boils(&self, _absolute_mpa: f64) -> bool {
        false
    }
}
