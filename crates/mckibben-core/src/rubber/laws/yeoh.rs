//! Yeoh: W = C10 (I1 − 3) + C20 (I1 − 3)² + C30 (I1 − 3)³.

use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, LawConstants};

/// Yeoh rubber: a polynomial in I1.
///
/// ```text
/// W = C10 (I1 − 3) + C20 (I1 − 3)² + C30 (I1 − 3)³,   μ = 2 C10 > 0
///
/// I1            λ1² + λ2² + λ3²       –
/// C10, C20, C30                       MPa
/// ```
///
/// A negative C20 softens, a positive C30 stiffens at large stretch. A function of I1 alone: tests
/// along one axis give a usable answer in two axes as well, as far as they reach. Source:
/// `yeoh1993`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yeoh {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// C20 in MPa.
    pub c20_mpa: f64,
    /// C30 in MPa.
    pub c30_mpa: f64,
}

impl LawConstants for Yeoh {
    const NAME: &'static str = "yeoh";
    const CONSTANTS: &'static [Constant] = &[
        Constant::coefficient("c10", "the coefficient of I1 − 3"),
        Constant::coefficient("c20", "the coefficient of (I1 − 3)²"),
        Constant::coefficient("c30", "the coefficient of (I1 − 3)³"),
    ];
    const EXAMPLE: &'static [f64] = &[0.1789, -0.001219, 3.678e-5];

    constants_are_fields!(c10_mpa, c20_mpa, c30_mpa);
}

impl InvariantLaw for Yeoh {
    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let c1 = self.c10_mpa;
        let c2 = self.c20_mpa;
        let c3 = self.c30_mpa;
        let x = i1 - 3.0;
        InvariantDerivatives {
            w: x * (c1 + x * (c2 + x * c3)),
            w1: c1 + x * (2.0 * c2 + 3.0 * x * c3),
            w11: 2.0 * c2 + 6.0 * x * c3,
            ..Default::default()
        }
    }
}
