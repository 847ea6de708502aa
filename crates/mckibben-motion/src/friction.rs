//! Friction of the braid that does not depend on the speed.

use crate::error::MotionError;

/// Dahl's element: a bristle that gives way.
///
/// ```text
/// F_f = F_c(P) z,   ż = (v/x_s)(1 − z sgn v),   F_c = C P^β of the muscle's `[friction]`
/// ```
///
/// F_f opposes shortening at speed v = L0 ε̇; z in −1 … 1; x_s presliding length. After a reversal z follows e^(−x/x_s), whatever the
/// speed: a stroke S ≫ x_s there and back encloses 2 F_c S. The sign of v is fixed between its zeros, which are events. The element
/// creeps under small oscillations about a load, as is known of it. Together with the overstress of the rubber it is no larger than the
/// model's pull, so that the end of a muscle that goes slack is free of force. Source: Dahl (1976) \[dahl1976\]; F_c: Tondu (2012) \[tondu2012\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dahl {
    /// C in N/MPa^β.
    pub coefficient: f64,
    /// β.
    pub exponent: f64,
    /// x_s in mm.
    pub presliding_mm: f64,
}

impl Dahl {
    /// The muscle's friction with a presliding length.
    pub fn of(friction: &mckibben::muscle::Friction, presliding_mm: f64) -> Self {
        Self { coefficient: friction.coefficient, exponent: friction.exponent, presliding_mm }
    }

    pub(crate) fn check(&self) -> Result<(), MotionError> {
        MotionError::within("the friction's coefficient in N/MPa^β", self.coefficient, 0.0, 1e9)?;
        MotionError::within("the friction's exponent", self.exponent, 0.0, 10.0)?;
        MotionError::within("the friction's presliding length in mm", self.presliding_mm, 1e-6, 1e6)
    }

    /// F_c in N.
    pub fn level_n(&self, pressure_mpa: f64) -> f64 {
        if pressure_mpa > 0.0 { self.coefficient * pressure_mpa.powf(self.exponent) } else { 0.0 }
    }

    /// ż where the sign of the speed is `sign`.
    pub(crate) fn rate(&self, z: f64, speed_mm_per_s: f64, sign: f64) -> f64 {
        speed_mm_per_s / self.presliding_mm * (1.0 - z * sign)
    }
}
