//! Extended tube: chains between crosslinks that lock, and a tube of neighbours around each.

use crate::rubber::{Constant, LawConstants, Principal, RubberLaw};

/// Extended-tube rubber: crosslinks (a function of I1 that locks) and entanglements (of the
/// principal stretches).
///
/// ```text
/// W = (Gc/2) [(1 − δ²) D/(1 − δ² D) + ln(1 − δ² D)] + (2 Ge/β²) (λ1^−β + λ2^−β + λ3^−β − 3)
/// D = I1 − 3,   δ² = 1/Jm,   β = 0.2,   μ = Gc (1 − 2/Jm) + Ge
///
/// I1  λ1² + λ2² + λ3²                                –
/// Gc  modulus of the network of crosslinks            MPa    > 0
/// Ge  modulus of the constraint by entanglements      MPa    > 0
/// Jm  largest I1 − 3 that the chains can reach, 1/δ²  –      > 2
/// β   compliance of the crosslinks, here 0.2           –      0 < β ≤ 1
/// ```
///
/// For D < Jm; at and beyond the limit the energy is `+∞` and the derivatives are not numbers.
/// Convex in the logarithms of the stretches, so stable up to the limit, for all Gc, Ge ≥ 0 and
/// Jm > 2: ∂W/∂D and ∂²W/∂D² of the first part are positive there, and the second is a term of Ogden's
/// law with exponent −β. The authors' β is a constant; with the value that they give for Treloar's
/// rubber three constants follow six rubbers in two axes nearly as well as four (`docs/rubber-modes.md`),
/// and uniaxial tests, which say nothing of β, predict the other modes better. Source:
/// `kaliske1999`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExtendedTube {
    /// Gc in MPa.
    pub gc_mpa: f64,
    /// Ge in MPa.
    pub ge_mpa: f64,
    /// Jm, the largest I1 − 3 the chains can reach (–).
    pub jm: f64,
}

/// β.
const BETA: f64 = 0.2;

impl LawConstants for ExtendedTube {
    const NAME: &'static str = "extended-tube";
    const CONSTANTS: &'static [Constant] = &[
        Constant::modulus("gc", "the modulus of the network of crosslinks"),
        Constant::modulus("ge", "the modulus of the entanglements"),
        Constant::above("jm", 2.0, "the largest I1 − 3"),
    ];
    const EXAMPLE: &'static [f64] = &[0.19, 0.2, 110.0];

    constants_are_fields!(gc_mpa, ge_mpa, jm);

    fn locks_at(&self) -> Option<f64> {
        Some(self.jm)
    }
}

impl RubberLaw for ExtendedTube {
    fn shear_modulus_mpa(&self) -> f64 {
        self.gc_mpa * (1.0 - 2.0 / self.jm) + self.ge_mpa
    }

    fn principal(&self, l: [f64; 3]) -> Principal {
        let d = l.map(|x| x * x - 1.0).iter().sum::<f64>();
        let s = 1.0 / self.jm;
        let x = d / self.jm;
        let q = 1.0 - x;
        if q <= 0.0 {
            let nan = f64::NAN;
            return Principal {
                w: f64::INFINITY,
                d: [nan; 3],
                dd: [[nan; 3]; 3],
            };
        }
        let half = 0.5 * self.gc_mpa;
        let w1 = half * ((1.0 - s) / (q * q) - s / q);
        let w11 = half * s * (2.0 * (1.0 - s) / (q * q * q) - s / (q * q));
        let mut p = Principal {
            w: half * ((1.0 - s) * d / q + (-x).ln_1p()),
            d: l.map(|x| 2.0 * w1 * x),
            dd: [[0.0; 3]; 3],
        };
        for i in 0..3 {
            for j in 0..3 {
                p.dd[i][j] = 4.0 * w11 * l[i] * l[j];
            }
            let ln = l[i].ln();
            let power = (-BETA * ln).exp();
            p.w += 2.0 * self.ge_mpa / (BETA * BETA) * (-BETA * ln).exp_m1();
            p.d[i] -= 2.0 * self.ge_mpa / BETA * power / l[i];
            p.dd[i][i] += 2.0 * w1 + 2.0 * self.ge_mpa * (1.0 + 1.0 / BETA) * power / (l[i] * l[i]);
        }
        p
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rubber::{Law, NeoHookean, Ogden, muscle_unstable_from};

    /// Without a limit the crosslinks are neo-Hookean and the entanglements a term of Ogden's law.
    #[test]
    fn long_chains_are_neo_hookean_beside_a_term_of_ogdens() {
        let law = ExtendedTube {
            gc_mpa: 0.24,
            ge_mpa: 0.1,
            jm: 1e9,
        };
        let neo = NeoHookean { mu_mpa: 0.24 };
        let ogden = Ogden {
            terms: vec![(-2.0 * 0.1 / BETA, -BETA)],
        };
        for (u, v) in [(4.0, 0.8), (1.3, 0.6)] {
            let (a, b, c) = (law.biaxial(u, v), neo.biaxial(u, v), ogden.biaxial(u, v));
            assert!((a.w - b.w - c.w).abs() < 1e-7 && (a.u - b.u - c.u).abs() < 1e-7);
            assert!((a.vv - b.vv - c.vv).abs() < 1e-7);
        }
        assert_eq!(
            ExtendedTube { jm: 9.0, ..law }
                .principal([3.4641016151377544, 0.0, 0.0])
                .w,
            f64::INFINITY
        );
    }

    /// Up to the limit it is stable over the whole field of a muscle's stretches, whatever its
    /// constants.
    #[test]
    fn it_is_stable_until_it_locks() {
        for (gc, ge, jm) in [
            (0.2, 0.0, 2.1),
            (0.0, 0.2, 12.0),
            (0.3, 0.1, 9.0),
            (0.01, 1.0, 50.0),
        ] {
            let law = Law::from(ExtendedTube {
                gc_mpa: gc,
                ge_mpa: ge,
                jm,
            });
            let reach = (jm + 1.0).sqrt().min(3.0) * 0.98;
            if let Some(hoop_stretch) = muscle_unstable_from(&law, reach) {
                let locks = |axial: f64| {
                    hoop_stretch.powi(2) + axial * axial + (hoop_stretch * axial).powi(-2) - 3.0
                        >= jm
                };
                assert!(locks(0.6) || locks(1.1), "{gc} {ge} {jm}: {hoop_stretch}");
            }
        }
    }
}
