//! Arruda–Boyce: W = μ' N (β x + ln(β/sinh β)) and a constant, x = √(I1/3)/λm, β = L⁻¹(x), N = λm².

use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, LawConstants};

/// Arruda–Boyce rubber: eight chains of a given largest length from the middle of a cube to its
/// corners.
///
/// ```text
/// W  = μ' λm² [β x + ln(β/sinh β)] − the same at rest
/// x  = √(I1/3)/λm,   β = L⁻¹(x),   L(β) = coth β − 1/β
/// μ' = n k T = 3 μ/(λm L⁻¹(1/λm)),   so   μ = μ' (1 + 3/(5 λm²) + 99/(175 λm⁴) + …)
///
/// I1  λ1² + λ2² + λ3²                                       –
/// μ   shear modulus at rest                                 MPa    > 0
/// λm  locking stretch of a chain, √N for N rigid links      –      > 1
/// x   stretch of a chain √(I1/3) over its largest           –      < 1
/// L   Langevin function; β the pull on a chain, in k T over the length of a link
/// n   chains in a unit of volume; k Boltzmann's constant, T temperature
/// ```
///
/// Other programs may call μ' the constant `mu`: theirs is a little smaller. For I1 < 3 λm²; at and
/// beyond the limit the energy is `+∞` and the derivatives are not numbers. A function of I1 alone:
/// tests along one axis give a usable answer in two axes as well. Source: `arruda1993`; the first
/// guess of L⁻¹: `kroger2015`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArrudaBoyce {
    mu_mpa: f64,
    lambda_m: f64,
    rest: Chain,
}

impl ArrudaBoyce {
    /// The law of a shear modulus at rest in MPa and a locking stretch, not checked.
    pub fn new(mu_mpa: f64, lambda_m: f64) -> Self {
        Self {
            mu_mpa,
            lambda_m,
            rest: Chain::at(1.0 / lambda_m),
        }
    }

    /// μ' = n k T in MPa.
    pub fn chain_modulus_mpa(&self) -> f64 {
        3.0 * self.mu_mpa * self.rest.q
    }
}

impl LawConstants for ArrudaBoyce {
    const NAME: &'static str = "arruda-boyce";
    const CONSTANTS: &'static [Constant] = &[
        Constant::modulus("mu", "the shear modulus at rest"),
        Constant::above("lambda_m", 1.0, "the stretch at which a chain locks"),
    ];
    const EXAMPLE: &'static [f64] = &[0.24, 5.0];

    fn from_values(values: &[f64]) -> Option<Self> {
        if let &[mu_mpa, lambda_m] = values {
            Some(Self::new(mu_mpa, lambda_m))
        } else {
            None
        }
    }

    fn values(&self) -> Vec<f64> {
        vec![self.mu_mpa, self.lambda_m]
    }

    fn locks_at(&self) -> Option<f64> {
        Some(3.0 * self.lambda_m * self.lambda_m - 3.0)
    }
}

impl InvariantLaw for ArrudaBoyce {
    /// With q = L(β)/β: w1 = μ'/(6 q), w11 = μ'/(36 N) (dβ/dx − β/x)/x² and (dβ/dx − β/x)/x² = −2
    /// q_y/(q³ L'), y = β².
    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let chain = Chain::at((i1 / 3.0).sqrt() / self.lambda_m);
        if !chain.beta.is_finite() {
            return InvariantDerivatives::LOCKED;
        }
        let modulus = self.chain_modulus_mpa();
        let n = self.lambda_m * self.lambda_m;
        let Chain {
            q,
            q_y,
            slope,
            energy,
            ..
        } = chain;
        InvariantDerivatives {
            w: modulus * n * (energy - self.rest.energy),
            w1: modulus / (6.0 * q),
            w11: -modulus * q_y / (18.0 * n * q * q * q * slope),
            ..Default::default()
        }
    }
}

/// A chain that is pulled to the share x of its largest length.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Chain {
    /// β = L⁻¹(x)
    beta: f64,
    /// L(β)/β, 1/3 at rest
    q: f64,
    /// ∂q/∂(β²)
    q_y: f64,
    /// L'(β)
    slope: f64,
    /// β x + ln(β/sinh β)
    energy: f64,
}

impl Chain {
    /// Kröger's approximation of L⁻¹ (to 0.3 %), three steps of Newton's method: the error is
    /// squared in each.
    fn at(x: f64) -> Self {
        if x.is_nan() || x >= 1.0 {
            let nan = f64::NAN;
            return Self {
                beta: f64::INFINITY,
                q: nan,
                q_y: nan,
                slope: nan,
                energy: f64::INFINITY,
            };
        }
        let s = x * x;
        let mut beta = x * (3.0 - s * (6.0 + s - 2.0 * s * s) / 5.0) / (1.0 - s);
        for _ in 0..3 {
            let (chain, excess) = Self::at_beta(beta, x);
            beta -= excess / chain.slope;
        }
        Self::at_beta(beta, x).0
    }

    /// The chain at β, and L(β) − x.
    ///
    /// Near β = 0 in the series s = sinh(β)/β and p = L s/β, all of whose terms are positive: the
    /// differences in coth β − 1/β would cost digits there.
    fn at_beta(beta: f64, x: f64) -> (Self, f64) {
        let y = beta * beta;
        if y < 1.0 {
            // r = (s − 1)/y = Σ y^k/(2k+3)!,  p = Σ 2(k+1) y^k/(2k+3)!, and their derivatives in y
            let mut r = 0.0;
            let mut r_y = 0.0;
            let mut p = 0.0;
            let mut p_y = 0.0;
            for (k, factorial) in FACTORIALS.into_iter().enumerate().rev() {
                (r_y, r) = (r_y * y + r, r * y + 1.0 / factorial);
                (p_y, p) = (p_y * y + p, p * y + 2.0 * (k as f64 + 1.0) / factorial);
            }
            let s = 1.0 + y * r;
            let s_y = r + y * r_y;
            let q = p / s;
            let q_y = (p_y * s - p * s_y) / (s * s);
            let chain = Self {
                beta,
                q,
                q_y,
                slope: q + 2.0 * y * q_y,
                energy: y * q - (y * r).ln_1p(),
            };
            return (chain, beta * q - x);
        }
        let m = (-2.0 * beta).exp();
        // 1 − L: near locking L itself has no digits left.
        let lack = 1.0 / beta - 2.0 * m / (1.0 - m);
        let l = 1.0 - lack;
        // 1/sinh² β = 4m/(1 − m)²
        let slope = 1.0 / y - 4.0 * m / ((1.0 - m) * (1.0 - m));
        let log_sinh_over_beta = beta + ((1.0 - m) / (2.0 * beta)).ln();
        (
            Self {
                beta,
                q: l / beta,
                q_y: (beta * slope - l) / (2.0 * y * beta),
                slope,
                energy: beta * l - log_sinh_over_beta,
            },
            (1.0 - x) - lack,
        )
    }
}

/// (2k + 3)!
const FACTORIALS: [f64; 9] = [
    6.0,
    120.0,
    5_040.0,
    362_880.0,
    39_916_800.0,
    6_227_020_800.0,
    1_307_674_368_000.0,
    355_687_428_096_000.0,
    121_645_100_408_832_000.0,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rubber::{Law, NeoHookean, RubberLaw};

    /// L(L⁻¹(x)) = x from the smallest stretch to the last below locking, and L against 30 digits
    /// of mpmath at both sides of the change from series to coth.
    #[test]
    fn the_inverse_langevin_function_is_exact() {
        for i in 1..4000 {
            let x = f64::from(i) / 4000.0;
            let chain = Chain::at(x);
            assert!(
                (chain.q * chain.beta / x - 1.0).abs() < 4.0 * f64::EPSILON,
                "{x}"
            );
            let near = Chain::at(1e-7 * x).beta;
            assert!((near / (3e-7 * x) - 1.0).abs() < 1e-13, "{x}");
        }
        let last = Chain::at(1.0 - f64::EPSILON);
        assert!((last.beta * f64::EPSILON - 1.0).abs() < 1e-12);
        for (beta, exact) in [
            (
                0.3,
                [
                    0.33135032329469418708,
                    -0.02184635106309674109,
                    0.32741798010333677369,
                    0.014866273676851354352,
                ],
            ),
            (
                0.999,
                [
                    0.31307237025604173011,
                    -0.018554835707646995594,
                    0.27603688107390691161,
                    0.15132007431660866444,
                ],
            ),
            (
                1.001,
                [
                    0.31299817637353340751,
                    -0.01854210785141056612,
                    0.27583975515509093018,
                    0.15187195091502127173,
                ],
            ),
            (
                5.0,
                [
                    0.16001816079640387511,
                    -0.0024039955401161155351,
                    0.039818383790598098352,
                    1.3030845138645130509,
                ],
            ),
            (
                40.0,
                [0.024375, -7.421875e-6, 0.000625, 3.3820266346738816123],
            ),
        ] {
            let chain = Chain::at_beta(beta, 0.0).0;
            for (got, exact) in [chain.q, chain.q_y, chain.slope, chain.energy]
                .into_iter()
                .zip(exact)
            {
                assert!((got / exact - 1.0).abs() < 1e-13, "{beta}: {got} {exact}");
            }
        }
    }

    /// μ'/2 Σ 2 Ci i (I1/λm²)^(i−1) with Ci = 1/2, 1/20, 11/1050, 19/7000, 519/673750 (Arruda &
    /// Boyce 1993 \[arruda1993\], their series): the terms left out begin with ⅔ x^10, x² = I1/(3
    /// λm²).
    #[test]
    fn stresses_are_those_of_the_series_of_five_terms() {
        let law = ArrudaBoyce::new(0.28, 26.5_f64.sqrt());
        let coefficients = [
            1.0 / 2.0,
            1.0 / 20.0,
            11.0 / 1050.0,
            19.0 / 7000.0,
            519.0 / 673_750.0,
        ];
        for stretch in [0.6_f64, 1.01, 1.5, 2.0, 3.0, 4.0] {
            let i1 = stretch * stretch + 2.0 / stretch;
            let share = i1 / 26.5;
            let term = |(i, c): (usize, &f64)| c * (i + 1) as f64 * share.powi(i as i32);
            let w1 =
                law.chain_modulus_mpa() * coefficients.iter().enumerate().map(term).sum::<f64>();
            let series = 2.0 * w1 * (stretch - stretch.powi(-2));
            let left_out = (share / 3.0).powi(5) / (1.0 - share / 3.0);
            let off = law.uniaxial_stress_mpa(stretch) / series - 1.0;
            assert!(
                off > -1e-13 && off < left_out + 1e-13,
                "{stretch}: {off} {left_out}"
            );
        }
    }

    #[test]
    fn the_modulus_at_rest_is_mu_and_that_of_a_chain_a_little_less() {
        let law = ArrudaBoyce::new(0.28, 3.0);
        assert!((law.shear_modulus_mpa() / 0.28 - 1.0).abs() < 1e-15);
        let n = 9.0_f64;
        let series = [3.0 / 5.0, 99.0 / 175.0, 513.0 / 875.0, 42039.0 / 67375.0];
        let sum = 1.0
            + series
                .iter()
                .enumerate()
                .map(|(i, c)| c / n.powi(i as i32 + 1))
                .sum::<f64>();
        let ratio = law.mu_mpa / law.chain_modulus_mpa() / sum - 1.0;
        assert!(ratio > 0.0 && ratio < n.powi(-5), "{ratio}");
    }

    #[test]
    fn long_chains_are_neo_hookean_and_short_ones_lock() {
        let (long, neo) = (ArrudaBoyce::new(0.24, 1e5), NeoHookean { mu_mpa: 0.24 });
        let (a, b) = (long.biaxial(4.0, 0.8), neo.biaxial(4.0, 0.8));
        assert!((a.u - b.u).abs() < 1e-9 && (a.uu - b.uu).abs() < 1e-9);
        let short = ArrudaBoyce::new(0.24, 2.0);
        assert!(short.invariant(11.99, 4.0).w.is_finite());
        assert_eq!(short.invariant(12.0, 4.0).w, f64::INFINITY);
        let refused = Law::from(ArrudaBoyce::new(0.24, 1.0))
            .validated()
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            "lambda_m of the arruda-boyce law is 1; it must be above 1 (it is the stretch at which \
             a chain locks)"
        );
    }
}
