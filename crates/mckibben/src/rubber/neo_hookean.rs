//! Neo-Hookean: W = (μ/2) (I1 − 3).

use super::{InvariantDerivatives, InvariantLaw};

/// Neo-Hookean rubber (Treloar 1943): one constant, the shear modulus μ. Good up to about 50–100 % strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeoHookean {
    /// Shear modulus μ in MPa.
    pub mu_mpa: f64,
}

impl InvariantLaw for NeoHookean {
    const NAME: &'static str = "neo-hookean";

    fn constant_list(&self) -> Vec<(String, f64, &'static str)> {
        vec![("mu".into(), self.mu_mpa, "MPa")]
    }

    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let half = 0.5 * self.mu_mpa;
        InvariantDerivatives { w: half * (i1 - 3.0), w1: half, ..Default::default() }
    }
}
