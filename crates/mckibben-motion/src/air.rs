//! The air in a muscle: mass, energy, heat.

use crate::{Result, error::within, fluid::Medium};

/// R of dry air in J/(kg K), which is mJ/(g K).
pub const GAS_CONSTANT_J_PER_KG_K: f64 = 287.05;
pub use mckibben_core::analysis::{ATMOSPHERE_MPA, HEAT_RATIO};
/// Density of ISO 8778's reference atmosphere (20 °C, 1 bar, 65 % humidity), ρ0 of \[iso2013\].
pub const REFERENCE_DENSITY_G_PER_L: f64 = 1.185;

/// cp in J/(kg K).
pub const CP: f64 = HEAT_RATIO * GAS_CONSTANT_J_PER_KG_K / (HEAT_RATIO - 1.0);

/// How the air exchanges heat.
///
/// ```text
/// ṗ (V + n p V_P) = n R (G_in T_in − G_out T) + (γ − 1) Q̇ − n p V_ε ε̇
/// ṁ = G_in − G_out,   T = p V/(m R)
/// ```
///
/// p absolute pressure, V cavity and dead volume, V_P and V_ε its derivatives, G mass flows, ε
/// contraction. n = γ and Q̇ = hA (T_wall − T) follow from the balance of energy; n = 1 at T =
/// T_wall is the isothermal limit; a polytropic index between them is an empirical shorthand for
/// both. The state is p and m. Perfect gas: within 1 % below 10 bar. Source: \[beater2007\], ch. 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Heat {
    /// Always at the wall's temperature.
    Isothermal,
    /// p Vⁿ constant without flow, 1 ≤ n ≤ γ.
    Polytropic(f64),
    /// No heat.
    Adiabatic,
    /// h in W/(m² K) on the wall's area, which is that of a cylinder with the cavity's volume and
    /// length.
    Transfer(f64),
    /// hA in W/K.
    Conductance(f64),
}

impl Heat {
    /// n of the balance of pressure.
    pub fn index(self) -> f64 {
        match self {
            Self::Isothermal => 1.0,
            Self::Polytropic(n) => n,
            _ => HEAT_RATIO,
        }
    }

    pub(crate) fn check(self) -> Result<()> {
        match self {
            Self::Polytropic(n) => within("the polytropic index", n, 1.0, 1.4),
            Self::Transfer(h) => within("the heat transfer in W/(m² K)", h, 0.0, 1e9),
            Self::Conductance(h) => within("the heat conductance in W/K", h, 0.0, 1e9),
            Self::Isothermal | Self::Adiabatic => Ok(()),
        }
    }
}

/// What is in and around a muscle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Air {
    /// How it exchanges heat.
    pub heat: Heat,
    /// The wall's temperature in K, also that of the air at the start.
    pub wall_temperature_k: f64,
    /// Volume outside of the cavity in mm³, without the hose.
    pub dead_volume_mm3: f64,
}

impl Default for Air {
    /// Isothermal at 20 °C without dead volume.
    fn default() -> Self {
        Self {
            heat: Heat::Isothermal,
            wall_temperature_k: 293.15,
            dead_volume_mm3: 0.0,
        }
    }
}

/// The state of what fills a muscle, and how its volume changes, dead volume included.
pub struct Cavity {
    pub absolute_mpa: f64,
    pub temperature_k: f64,
    /// V in mm³.
    pub volume_mm3: f64,
    /// ∂V/∂P at fixed contraction in mm³/MPa.
    pub volume_per_pressure_mm3_per_mpa: f64,
    /// V̇ at fixed pressure, V_ε ε̇, in mm³/s.
    pub swept_mm3_per_s: f64,
    /// Area of the wall in mm².
    pub area_mm2: f64,
}

/// What flows into the muscle through a port in g/s, negative outwards, with the temperature of
/// where it comes from.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Flow {
    /// Mass flow in g/s.
    pub mass_g_per_s: f64,
    /// Temperature of what flows in K.
    pub temperature_k: f64,
}

impl Flow {
    /// R G T in mJ/s.
    fn power(self) -> f64 {
        GAS_CONSTANT_J_PER_KG_K * self.mass_g_per_s * self.temperature_k
    }
}

/// Area in mm² of a cylinder of this volume and length, with its ends: 2 √(π V L) + 2 V/L.
pub fn cavity_area_mm2(volume_mm3: f64, length_mm: f64) -> f64 {
    2.0 * (std::f64::consts::PI * volume_mm3 * length_mm).sqrt() + 2.0 * volume_mm3 / length_mm
}

impl Air {
    /// Heat hA (T_wall − T) in mW, where the law is one of heat transfer.
    fn transferred_mw(&self, cavity: &Cavity) -> f64 {
        let per_kelvin = match self.heat {
            // W/(m² K) · mm² = 1e-3 mW/K
            Heat::Transfer(h) => 1e-3 * h * cavity.area_mm2,
            Heat::Conductance(ha) => 1e3 * ha,
            _ => return 0.0,
        };
        per_kelvin * (self.wall_temperature_k - cavity.temperature_k)
    }
}

impl Medium for Air {
    fn dead_volume_mm3(&self) -> f64 {
        self.dead_volume_mm3
    }

    fn wall_temperature_k(&self) -> f64 {
        self.wall_temperature_k
    }

    /// T = pV/(mR); that of the wall where the law says so.
    fn temperature_k(&self, absolute_mpa: f64, mass_g: f64, volume_mm3: f64) -> f64 {
        match self.heat {
            Heat::Isothermal => self.wall_temperature_k,
            _ => absolute_mpa * volume_mm3 / (mass_g * GAS_CONSTANT_J_PER_KG_K),
        }
    }

    /// m = pV/(RT).
    fn mass_g(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        absolute_mpa * volume_mm3 / (GAS_CONSTANT_J_PER_KG_K * self.wall_temperature_k)
    }

    fn pressure_rate_mpa_per_s(&self, cavity: &Cavity, flows: &[Flow]) -> f64 {
        let n = self.heat.index();
        let p = cavity.absolute_mpa;
        let mut power: f64 = flows.iter().map(|f| n * f.power()).sum();
        if self.heat == Heat::Isothermal {
            power = flows.iter().map(|f| f.mass_g_per_s).sum::<f64>()
                * GAS_CONSTANT_J_PER_KG_K
                * self.wall_temperature_k;
        }
        power += (HEAT_RATIO - 1.0) * self.transferred_mw(cavity);
        (power - n * p * cavity.swept_mm3_per_s)
            / (cavity.volume_mm3 + n * p * cavity.volume_per_pressure_mm3_per_mpa)
    }

    fn flow_for_rate(&self, rate_mpa_per_s: f64, cavity: &Cavity, supply_k: f64) -> Flow {
        let n = self.heat.index();
        let p = cavity.absolute_mpa;
        let power = rate_mpa_per_s
            * (cavity.volume_mm3 + n * p * cavity.volume_per_pressure_mm3_per_mpa)
            + n * p * cavity.swept_mm3_per_s
            - (HEAT_RATIO - 1.0) * self.transferred_mw(cavity);
        let from = if power > 0.0 {
            supply_k
        } else {
            cavity.temperature_k
        };
        let t = if self.heat == Heat::Isothermal {
            self.wall_temperature_k
        } else {
            from
        };
        Flow {
            mass_g_per_s: power / (n * GAS_CONSTANT_J_PER_KG_K * t),
            temperature_k: from,
        }
    }

    /// cp G T.
    fn enthalpy_mw(&self, flow: Flow, _: f64) -> f64 {
        CP * flow.mass_g_per_s * flow.temperature_k
    }

    /// p V/(γ − 1).
    fn internal_mj(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        absolute_mpa * volume_mm3 / (HEAT_RATIO - 1.0)
    }

    /// From the balance of energy: d(pV)/dt/(γ − 1) + p V̇ − Σ cp G T.
    fn heat_mw(&self, rate_mpa_per_s: f64, cavity: &Cavity, flows: &[Flow]) -> f64 {
        let p = cavity.absolute_mpa;
        let swelling =
            cavity.swept_mm3_per_s + cavity.volume_per_pressure_mm3_per_mpa * rate_mpa_per_s;
        let stored = (rate_mpa_per_s * cavity.volume_mm3 + p * swelling) / (HEAT_RATIO - 1.0);
        stored + p * swelling - flows.iter().map(|f| self.enthalpy_mw(*f, p)).sum::<f64>()
    }

    fn needs_area(&self) -> bool {
        matches!(self.heat, Heat::Transfer(_))
    }
}

/// Normal litres (DIN 1343: 0 °C, 101.325 kPa, dry) of a mass of air in g.
pub fn normal_litres(mass_g: f64) -> f64 {
    // mm³ at 20 °C and atmospheric pressure; J/(kg K) is mJ/(g K), and 1 MPa mm³ is 1 mJ
    mckibben_core::analysis::normal_litres(
        mass_g * GAS_CONSTANT_J_PER_KG_K * 293.15 / ATMOSPHERE_MPA,
    )
}
