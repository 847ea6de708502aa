//! Friction between the strands of the braid: hysteresis of the pull.

use super::Direction;
use super::error::{MuscleError, not_negative};

/// Friction of the braid, half the width of the hysteresis loop.
///
/// ```text
/// F = F_model ± C P^β        + while the muscle is lengthened, − while it shortens
/// ```
///
/// Measured exponents are 0.57 (20° muscle) and 0.82 (30°) in Tondu (2012) \[tondu2012\], Fig. 3. The friction belongs to the muscle,
/// not to the model of its pull: [`Friction::force_n`] is added to what any model says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// C in N/MPa^β: the half-width at 1 MPa.
    pub coefficient: f64,
    /// β (–).
    pub exponent: f64,
}

impl Friction {
    pub(super) fn check(&self) -> Result<(), MuscleError> {
        not_negative("friction.coefficient", self.coefficient, "N/MPa^exponent")?;
        not_negative("friction.exponent", self.exponent, "")
    }

    /// The signed friction force in N at a pressure (zero without pressure).
    pub fn force_n(&self, pressure_mpa: f64, direction: Direction) -> f64 {
        if direction.is_mean() || pressure_mpa.is_nan() || pressure_mpa <= 0.0 {
            return 0.0;
        }
        direction.sign() * (self.coefficient * pressure_mpa.powf(self.exponent))
    }

    /// d(force)/dP in mm².
    pub fn slope_mm2(&self, pressure_mpa: f64, direction: Direction) -> f64 {
        if pressure_mpa > 0.0 {
            self.exponent * self.force_n(pressure_mpa, direction) / pressure_mpa
        } else {
            0.0
        }
    }
}
