//! Gent: W = −(μ Jm/2) ln(1 − (I1 − 3)/Jm).

use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, LawConstants};

/// Gent rubber: neo-Hookean at small stretch, locking where I1 − 3 reaches Jm.
///
/// ```text
/// W = −(μ Jm/2) ln(1 − (I1 − 3)/Jm)
///
/// I1  λ1² + λ2² + λ3²                           –
/// μ   shear modulus at rest                     MPa    > 0
/// Jm  largest I1 − 3 that the chains can reach  –      > 0
/// ```
///
/// For I1 − 3 < Jm; at and beyond the limit the energy is `+∞` and the derivatives are not numbers.
/// A function of I1 alone: tests along one axis give a usable answer in two axes as well. Source:
/// `gent1996`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gent {
    /// Shear modulus μ in MPa.
    pub mu_mpa: f64,
    /// Jm, the largest I1 − 3 the chains can reach (–).
    pub jm: f64,
}

impl LawConstants for Gent {
    const NAME: &'static str = "gent";
    const CONSTANTS: &'static [Constant] = &[
        Constant::modulus("mu", "the shear modulus"),
        Constant::above("jm", 0.0, "the largest I1 − 3"),
    ];
    const EXAMPLE: &'static [f64] = &[0.24, 30.0];

    constants_are_fields!(mu_mpa, jm);

    fn locks_at(&self) -> Option<f64> {
        Some(self.jm)
    }
}

impl InvariantLaw for Gent {
    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let mu = self.mu_mpa;
        let jm = self.jm;
        let x = (i1 - 3.0) / jm;
        let left = 1.0 - x;
        if left <= 0.0 {
            return InvariantDerivatives::LOCKED;
        }
        InvariantDerivatives {
            w: -0.5 * mu * jm * (-x).ln_1p(),
            w1: 0.5 * mu / left,
            w11: 0.5 * mu / (jm * left * left),
            ..Default::default()
        }
    }
}
