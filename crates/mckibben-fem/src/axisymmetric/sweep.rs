//! Rubber laws of random muscles.

use mckibben_core::rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh};

/// The law number `kind` with a shear modulus at rest: Mooney–Rivlin with a share of C01 up to 0.3,
/// neo-Hookean, Yeoh, Gent with a jm from `least_jm` to 80, Ogden. `unit` gives a number below one
/// where the law has one more constant.
pub fn law(kind: usize, mu: f64, least_jm: f64, unit: impl FnOnce() -> f64) -> Law {
    match kind {
        0 => {
            let share = 0.3 * unit();
            Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: 0.5 * mu * (1.0 - share),
                c01_mpa: 0.5 * mu * share,
            })
        }
        1 => Law::NeoHookean(NeoHookean { mu_mpa: mu }),
        2 => {
            let c10 = 0.5 * mu;
            Law::Yeoh(Yeoh {
                c10_mpa: c10,
                c20_mpa: -0.007 * c10,
                c30_mpa: 2e-4 * c10,
            })
        }
        3 => Law::Gent(Gent {
            mu_mpa: mu,
            jm: least_jm + (80.0 - least_jm) * unit(),
        }),
        _ => {
            // Ogden 1972 [ogden1972], Treloar's rubber: μ = ½ Σ μi αi = 0.4143 MPa.
            let scale = mu / 0.414_319;
            let terms = [(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)];
            Law::Ogden(Ogden {
                terms: terms.iter().map(|&(m, a)| (m * scale, a)).collect(),
            })
        }
    }
}
