//! Ogden: W = Σ (μi/αi)(λ1^αi + λ2^αi + λ3^αi − 3).

use super::{Principal, RubberLaw};

/// Ogden rubber (Ogden 1972) with as many terms as there are pairs (μi, αi); μ = ½ Σ μi αi.
#[derive(Debug, Clone, PartialEq)]
pub struct Ogden {
    /// (μi in MPa, αi) of each term.
    pub terms: Vec<(f64, f64)>,
}

impl RubberLaw for Ogden {
    fn name(&self) -> &'static str {
        "ogden"
    }

    fn constants(&self) -> Vec<(String, f64, &'static str)> {
        let one = |(i, &(mu, alpha)): (usize, &(f64, f64))| {
            [(format!("mu{}", i + 1), mu, "MPa"), (format!("alpha{}", i + 1), alpha, "")]
        };
        self.terms.iter().enumerate().flat_map(one).collect()
    }

    fn shear_modulus_mpa(&self) -> f64 {
        0.5 * self.terms.iter().map(|&(mu, alpha)| mu * alpha).sum::<f64>()
    }

    fn principal(&self, l: [f64; 3]) -> Principal {
        let mut p = Principal { w: 0.0, d: [0.0; 3], dd: [[0.0; 3]; 3] };
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
