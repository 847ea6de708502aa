//! Mooney–Rivlin: W = C10 (I1 − 3) + C01 (I2 − 3).

use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, Law, LawConstants, NeoHookean};

/// Mooney–Rivlin rubber, the law of the paper's finite-element model.
///
/// ```text
/// W = C10 (I1 − 3) + C01 (I2 − 3),   μ = 2 (C10 + C01) > 0
///
/// I1  λ1² + λ2² + λ3²                   –
/// I2  λ1²λ2² + λ2²λ3² + λ3²λ1²          –
/// C10 half the modulus that goes with I1  MPa
/// C01 half the modulus that goes with I2  MPa
/// ```
///
/// Tests along one axis often give C01 < 0, which is unstable in the two-axis stretch of a muscle:
/// see [`biaxial_unstable_from`](crate::rubber::biaxial_unstable_from). Good up to about 100–200 %
/// strain; it does not stiffen at large stretch. Sources: `mooney1940`, `rivlin1948`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooneyRivlin {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// C01 in MPa.
    pub c01_mpa: f64,
}

impl LawConstants for MooneyRivlin {
    const NAME: &'static str = "mooney-rivlin";
    const CONSTANTS: &'static [Constant] = &[
        Constant::coefficient("c10", "the coefficient of I1 − 3"),
        Constant::coefficient("c01", "the coefficient of I2 − 3"),
    ];
    const EXAMPLE: &'static [f64] = &[0.10, 0.02];

    constants_are_fields!(c10_mpa, c01_mpa);
}

impl InvariantLaw for MooneyRivlin {
    fn invariant(&self, i1: f64, i2: f64) -> InvariantDerivatives {
        let c10 = self.c10_mpa;
        let c01 = self.c01_mpa;
        InvariantDerivatives {
            w: c10 * (i1 - 3.0) + c01 * (i2 - 3.0),
            w1: c10,
            w2: c01,
            ..Default::default()
        }
    }
}

impl Law {
    /// The law as Mooney–Rivlin, where it is that or neo-Hookean (C10 = μ/2, C01 = 0): formulas in
    /// closed form exist for these two.
    #[inline(always)]
    pub(crate) fn as_mooney_rivlin(&self) -> Option<MooneyRivlin> {
        match *self {
            Law::MooneyRivlin(law) => Some(law),
            Law::NeoHookean(NeoHookean { mu_mpa }) => Some(MooneyRivlin {
                c10_mpa: 0.5 * mu_mpa,
                c01_mpa: 0.0,
            }),
            _ => None,
        }
    }

    /// C01 in MPa where it is below zero, as tests along one axis give it: it misleads in the
    /// two-axis stretch of a muscle, even if the muscle at hand does not reach where the law turns
    /// unstable.
    pub fn negative_c01_mpa(&self) -> Option<f64> {
        self.as_mooney_rivlin()
            .map(|law| law.c01_mpa)
            .filter(|c01| *c01 < 0.0)
    }
}
