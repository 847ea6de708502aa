//! Mooney–Rivlin: W = C10 (I1 − 3) + C01 (I2 − 3).

use super::{InvariantDerivatives, InvariantLaw};

/// Mooney–Rivlin rubber (Mooney 1940; Rivlin 1948), the law of the paper's finite-element model.
///
/// μ = 2(C10 + C01). One-axis fits often give C01 < 0, which is unstable in the two-axis stretch of a muscle:
/// see [`biaxial_stability`](super::biaxial_stability). Good up to about 100–200 % strain; it does not stiffen at large stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooneyRivlin {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// C01 in MPa.
    pub c01_mpa: f64,
}

impl InvariantLaw for MooneyRivlin {
    const NAME: &'static str = "mooney-rivlin";

    fn constant_list(&self) -> Vec<(String, f64, &'static str)> {
        vec![("c10".into(), self.c10_mpa, "MPa"), ("c01".into(), self.c01_mpa, "MPa")]
    }

    fn invariant(&self, i1: f64, i2: f64) -> InvariantDerivatives {
        let (c10, c01) = (self.c10_mpa, self.c01_mpa);
        InvariantDerivatives {
            w: c10 * (i1 - 3.0) + c01 * (i2 - 3.0),
            w1: c10,
            w2: c01,
            ..Default::default()
        }
    }
}
