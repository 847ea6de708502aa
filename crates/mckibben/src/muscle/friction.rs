//! Friction between the strands of the braid: hysteresis of the pull.

use super::error::{MuscleError, not_negative};

/// Half the width of the hysteresis loop, C·P^β.
///
/// The pull is higher by C·P^β while the muscle is lengthened and lower while it shortens. Measured exponents are
/// 0.57 (20° muscle) and 0.82 (30°) in Tondu (2012) \[tondu2012\], Fig. 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// C in N/MPa^β: the half-width at 1 MPa.
    pub coefficient: f64,
    /// β (–).
    pub exponent: f64,
}

/// Which way the muscle moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Motion {
    /// The mean of both branches: no friction.
    #[default]
    Mean,
    /// Shortening: friction takes from the pull.
    Shortening,
    /// Being lengthened: friction adds to the pull.
    Lengthening,
}

impl Friction {
    pub(super) fn check(&self) -> Result<(), MuscleError> {
        not_negative("friction.coefficient", self.coefficient, "N/MPa^exponent")?;
        not_negative("friction.exponent", self.exponent, "")
    }

    /// The signed friction force in N at a pressure (zero without pressure).
    pub fn force_n(&self, pressure_mpa: f64, motion: Motion) -> f64 {
        let half = if pressure_mpa > 0.0 { self.coefficient * pressure_mpa.powf(self.exponent) } else { 0.0 };
        match motion {
            Motion::Mean => 0.0,
            Motion::Shortening => -half,
            Motion::Lengthening => half,
        }
    }

    /// d(force)/dP in mm².
    pub fn slope(&self, pressure_mpa: f64, motion: Motion) -> f64 {
        if pressure_mpa > 0.0 {
            self.exponent * self.force_n(pressure_mpa, motion) / pressure_mpa
        } else {
            0.0
        }
    }
}
