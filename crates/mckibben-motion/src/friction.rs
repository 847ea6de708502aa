//! Friction of the braid that does not depend on the speed.

use crate::{MotionError, Result, error::within};
use mckibben::muscle::{Friction, Presliding};

/// Friction of the braid with its history.
///
/// ```text
/// F_f = F_c Σ sᵢ zᵢ,   żᵢ = (v/xᵢ)(1 − zᵢ sgn v),   F_c = C P^β + μw G(P, ε)
/// ```
///
/// F_f opposes shortening at speed v = L0 ε̇; zᵢ in −1 … 1; xᵢ presliding lengths with shares sᵢ ([`Presliding`]); G of the strands' contact
/// ([`pivoting_n_per_mm`](mckibben::model::pivoting_n_per_mm)). The friction follows the way, at any speed: a stroke S ≫ xᵢ there and back encloses
/// 2 ∫ F_c dx. The sign of v is fixed between its zeros, which are events. The elements
/// creep under small oscillations about a load, as is known of Dahl's equation. Together with the overstress of the rubber the friction is no larger
/// than the model's pull, so that the end of a muscle that goes slack is free of force. Source: Dahl (1976) \[dahl1976\]; C P^β: Tondu (2012) \[tondu2012\].
#[derive(Debug, Clone, PartialEq)]
pub struct Hysteresis {
    /// F_c.
    pub level: Friction,
    /// How it builds up.
    pub presliding: Presliding,
}

/// Whether lengths are above zero, and shares sum to 1.
pub(crate) fn check(presliding: &Presliding) -> Result<()> {
    for element in &presliding.0 {
        within("the friction's presliding length in mm", element.length_mm, 1e-6, 1e6)?;
        within("the share of a presliding length", element.share, 0.0, 1.0)?;
    }
    let sum = presliding.0.iter().fold(0.0, |sum, element| sum + element.share);
    let is_one = (sum - 1.0).abs() <= 1e-9;
    let what = "the sum of the shares of the presliding lengths";
    if is_one { Ok(()) } else { Err(MotionError::value(what, sum, "1")) }
}

impl Hysteresis {
    /// The muscle's friction, with the presliding of a drive or else of the muscle.
    pub fn new(friction: &Friction, presliding: Option<&Presliding>) -> Self {
        let presliding = presliding.cloned().unwrap_or_else(|| friction.presliding());
        Self { level: *friction, presliding }
    }

    pub(crate) fn check(&self) -> Result<()> {
        within("the friction's coefficient in N/MPa^β", self.level.coefficient, 0.0, 1e9)?;
        within("the friction's exponent", self.level.exponent, 0.0, 10.0)?;
        within("the friction's lever in mm", self.level.lever_mm, 0.0, 1e6)?;
        check(&self.presliding)
    }

    /// Whether it needs G.
    pub(crate) fn has_contact(&self) -> bool {
        self.level.lever_mm > 0.0
    }

    /// F_c in N at a pressure, with G in N/mm.
    pub fn level_n(&self, pressure_mpa: f64, pivoting_n_per_mm: f64) -> f64 {
        let half_n = || self.level.rule_n(pressure_mpa) + self.level.lever_mm * pivoting_n_per_mm.max(0.0);
        if pressure_mpa > 0.0 { half_n() } else { 0.0 }
    }

    /// żᵢ where the sign of the speed is `sign`.
    pub(crate) fn rates(&self, states: &[f64], speed_mm_per_s: f64, sign: f64) -> Vec<f64> {
        let each = self.presliding.0.iter().zip(states);
        each.map(|(element, z)| speed_mm_per_s / element.length_mm * (1.0 - z * sign)).collect()
    }
}
