//! Ogden: W = Σ (μi/αi)(λ1^αi + λ2^αi + λ3^αi − 3).

use crate::rubber::{Constant, LawConstants, Principal, RubberLaw};

/// Ogden rubber with as many terms as there are pairs (μi, αi).
///
/// ```text
/// W = Σ (μi/αi) (λ1^αi + λ2^αi + λ3^αi − 3),   μ = ½ Σ μi αi > 0
///
/// λ1, λ2, λ3  principal stretches     –
/// μi          modulus of a term       MPa    of either sign
/// αi          exponent of a term      –      other than 0
/// ```
///
/// Stable at any stretch where every μi αi > 0. Three terms follow natural rubber up to 600 %
/// strain. Source: `ogden1972`.
#[derive(Debug, Clone, PartialEq)]
pub struct Ogden {
    /// (μi in MPa, αi) of each term.
    pub terms: Vec<(f64, f64)>,
}

impl LawConstants for Ogden {
    const NAME: &'static str = "ogden";
    const CONSTANTS: &'static [Constant] = &[
        Constant::coefficient(
            "mu",
            "the modulus of a term: W = Σ (mu/alpha)(λ1^alpha + λ2^alpha + λ3^alpha − 3)",
        ),
        Constant::above("alpha", f64::NEG_INFINITY, "the exponent of a term"),
    ];
    const IS_SUM: bool = true;
    // Treloar's rubber (`ogden1972`, in kg/cm²: 6.3/1.3, 0.012/5.0, −0.1/−2.0).
    const EXAMPLE: &'static [f64] = &[0.6178, 1.3, 0.001177, 5.0, -0.009807, -2.0];

    fn from_values(values: &[f64]) -> Option<Self> {
        let terms = values.chunks_exact(2);
        terms.remainder().is_empty().then(|| Self {
            terms: terms.map(|t| (t[0], t[1])).collect(),
        })
    }

    fn values(&self) -> Vec<f64> {
        self.terms
            .iter()
            .flat_map(|&(mu, alpha)| [mu, alpha])
            .collect()
    }
}

impl RubberLaw for Ogden {
    fn shear_modulus_mpa(&self) -> f64 {
        0.5 * self
            .terms
            .iter()
            .map(|&(mu, alpha)| mu * alpha)
            .sum::<f64>()
    }

    fn principal(&self, l: [f64; 3]) -> Principal {
        let mut p = Principal {
            w: 0.0,
            d: [0.0; 3],
            dd: [[0.0; 3]; 3],
        };
        for &(mu, alpha) in &self.terms {
            for (i, stretch) in l.into_iter().enumerate() {
                let power = stretch.powf(alpha - 2.0);
                p.w += mu / alpha * (power * stretch * stretch - 1.0);
                p.d[i] += mu * power * stretch;
                p.dd[i][i] += mu * (alpha - 1.0) * power;
            }
        }
        p
    }
}
