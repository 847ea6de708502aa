//! Neo-Hookean: W = (μ/2) (I1 − 3).

use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, LawConstants};

/// Neo-Hookean rubber: one constant.
///
/// ```text
/// W = (μ/2) (I1 − 3)
///
/// I1  λ1² + λ2² + λ3²        –
/// μ   shear modulus          MPa    > 0
/// ```
///
/// Good up to about 50–100 % strain. Source: `treloar1943`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeoHookean {
    /// Shear modulus μ in MPa.
    pub mu_mpa: f64,
}

impl LawConstants for NeoHookean {
    const NAME: &'static str = "neo-hookean";
    const CONSTANTS: &'static [Constant] = &[Constant::modulus("mu", "the shear modulus")];
    const EXAMPLE: &'static [f64] = &[0.24];

    constants_are_fields!(mu_mpa);
}

impl InvariantLaw for NeoHookean {
    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let half = 0.5 * self.mu_mpa;
        InvariantDerivatives {
            w: half * (i1 - 3.0),
            w1: half,
            ..Default::default()
        }
    }
}
