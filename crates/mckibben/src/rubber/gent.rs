//! Gent: W = −(μ Jm/2) ln(1 − (I1 − 3)/Jm).

use super::{InvariantDerivatives, InvariantLaw};

/// Gent rubber (Gent 1996): neo-Hookean at small stretch, locking where I1 − 3 reaches Jm.
///
/// At and beyond the limit the energy is `+∞` and the derivatives are not numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gent {
    /// Shear modulus μ in MPa.
    pub mu_mpa: f64,
    /// Jm, the largest I1 − 3 the chains can reach (–).
    pub jm: f64,
}

impl InvariantLaw for Gent {
    const NAME: &'static str = "gent";

    fn constant_list(&self) -> Vec<(String, f64, &'static str)> {
        vec![("mu".into(), self.mu_mpa, "MPa"), ("jm".into(), self.jm, "")]
    }

    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let (mu, jm) = (self.mu_mpa, self.jm);
        let x = (i1 - 3.0) / jm;
        let left = 1.0 - x;
        if left <= 0.0 {
            let w = f64::INFINITY;
            return InvariantDerivatives { w, w1: f64::NAN, w11: f64::NAN, ..Default::default() };
        }
        InvariantDerivatives {
            w: -0.5 * mu * jm * (-x).ln_1p(),
            w1: 0.5 * mu / left,
            w11: 0.5 * mu / (jm * left * left),
            ..Default::default()
        }
    }
}
