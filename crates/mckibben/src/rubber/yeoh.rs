//! Yeoh: W = C10 (I1 − 3) + C20 (I1 − 3)² + C30 (I1 − 3)³.

use super::{InvariantDerivatives, InvariantLaw};

/// Yeoh rubber (Yeoh 1993): μ = 2 C10; a negative C20 softens, a positive C30 stiffens at large stretch.
/// Being a function of I1 alone, one-axis data give a usable answer in two axes as well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yeoh {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// C20 in MPa.
    pub c20_mpa: f64,
    /// C30 in MPa.
    pub c30_mpa: f64,
}

impl InvariantLaw for Yeoh {
    const NAME: &'static str = "yeoh";

    fn constant_list(&self) -> Vec<(String, f64, &'static str)> {
        vec![
            ("c10".into(), self.c10_mpa, "MPa"),
            ("c20".into(), self.c20_mpa, "MPa"),
            ("c30".into(), self.c30_mpa, "MPa"),
        ]
    }

    fn invariant(&self, i1: f64, _i2: f64) -> InvariantDerivatives {
        let (c1, c2, c3, x) = (self.c10_mpa, self.c20_mpa, self.c30_mpa, i1 - 3.0);
        InvariantDerivatives {
            w: x * (c1 + x * (c2 + x * c3)),
            w1: c1 + x * (2.0 * c2 + 3.0 * x * c3),
            w11: 2.0 * c2 + 6.0 * x * c3,
            ..Default::default()
        }
    }
}
