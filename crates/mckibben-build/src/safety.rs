//! Pressures of the tests and the energy of the air.

use mckibben::analysis::ATMOSPHERE_MPA;

/// Burst over working pressure of a hose for compressed air (RMA IP-2, Hose Handbook, 2003, p. 50; ISO 7751).
pub(crate) const BURST_TO_WORKING: f64 = 4.0;
/// Proof over working pressure of a hose for compressed air (ISO 7751).
pub(crate) const PROOF_TO_WORKING: f64 = 2.0;

/// Pressures, and what they store.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Safety {
    /// Working pressure in MPa.
    pub working_mpa: f64,
    /// Burst pressure in MPa, where it is known.
    pub burst_mpa: Option<f64>,
    /// Largest allowed working pressure in MPa, where it is known.
    pub allowed_mpa: Option<f64>,
    /// Pressure in MPa of the proof test, with water.
    pub proof_mpa: f64,
    /// Pressure in MPa of the leak test.
    pub leak_mpa: f64,
    /// Energy in J of the air at the working pressure.
    pub air_j: f64,
    /// Energy in J that air would have at the proof pressure.
    pub air_at_proof_j: f64,
}

impl Safety {
    /// The tests of a muscle with a cavity of `volume_mm3` at the working pressure.
    pub(crate) fn new(
        working_mpa: f64,
        burst_mpa: Option<f64>,
        allowed_mpa: Option<f64>,
        volume_mm3: f64,
    ) -> Self {
        let proof_mpa = PROOF_TO_WORKING * working_mpa;
        Self {
            working_mpa,
            burst_mpa,
            allowed_mpa: allowed_mpa.or(burst_mpa.map(|burst| burst / BURST_TO_WORKING)),
            proof_mpa,
            leak_mpa: working_mpa,
            air_j: energy_j(working_mpa, volume_mm3),
            air_at_proof_j: energy_j(proof_mpa, volume_mm3),
        }
    }

    /// Whether the working pressure is above what is allowed.
    pub fn is_above_allowed(&self) -> bool {
        self.allowed_mpa.is_some_and(|allowed| self.working_mpa > allowed * (1.0 + 1e-9))
    }
}

/// Energy in J of air at a gauge pressure: E = p V ln(p/p₀), p absolute. It is the work of an isothermal expansion to the atmosphere, an upper
/// bound of what the air can do.
pub fn energy_j(gauge_mpa: f64, volume_mm3: f64) -> f64 {
    let absolute = gauge_mpa.max(0.0) + ATMOSPHERE_MPA;
    1e-3 * absolute * volume_mm3 * (absolute / ATMOSPHERE_MPA).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 0.5 L at 6 bar gauge, 0.701325 MPa · 500 000 mm³ = 350.66 J, ln(6.92154) = 1.934638, together 678.4 J.
    #[test]
    fn the_energy_of_air_is_that_of_an_isothermal_expansion() {
        assert!((energy_j(0.6, 5e5) - 678.4).abs() < 0.05, "{}", energy_j(0.6, 5e5));
        assert_eq!(energy_j(0.0, 5e5), 0.0);
    }

    #[test]
    fn a_proof_is_half_of_the_burst_where_the_working_pressure_is_a_quarter_of_it() {
        let safety = Safety::new(0.25, Some(1.0), None, 1e5);
        assert_eq!((safety.proof_mpa, safety.allowed_mpa), (0.5, Some(0.25)));
        assert!(!safety.is_above_allowed() && Safety::new(0.26, Some(1.0), None, 1e5).is_above_allowed());
    }
}
