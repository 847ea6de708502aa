//! Rubber that was stretched before, in an axisymmetric state (Ogden & Roxburgh 1999
//! \[ogden1999\]).
//!
//! With W0(F) the isochoric energy of the law, W_m the largest that a point has seen and η = η(W0,
//! W_m),
//!
//!   φ = ∫₀^W0 η dW,   ∂φ/∂F = η ∂W0/∂F,   ∂²φ/∂F∂F = η ∂²W0/∂F∂F + η′ ∂W0/∂F ⊗ ∂W0/∂F
//!
//! and p (J − 1) beside it, which does not soften. W_m is held, so that φ is an energy: forces have
//! a symmetric tangent.

use super::plane::{Gradient, Stress};
use mckibben_core::rubber::over_time::OgdenRoxburgh;

/// What becomes of the stress `s` of the first loading at F, taken without the multiplier, in
/// rubber that has seen the energy `seen_mpa`; `p` multiplies J − 1.
pub fn soften<const TANGENT: bool>(
    softening: &OgdenRoxburgh,
    seen_mpa: f64,
    f: &Gradient,
    p: f64,
    s: &mut Stress,
) {
    let eta = softening.factor(s.w, seen_mpa);
    if TANGENT {
        let slope = softening.slope(s.w, seen_mpa);
        let r = s.r;
        let z = s.z;
        for i in 0..3 {
            for j in 0..3 {
                s.rr[i][j] = eta * s.rr[i][j] + slope * r[i] * r[j];
            }
            for (k, z) in s.rz[i].iter_mut().zip(z) {
                *k = eta * *k + slope * r[i] * z;
            }
        }
        for i in 0..2 {
            for j in 0..2 {
                s.zz[i][j] = eta * s.zz[i][j] + slope * z[i] * z[j];
            }
        }
    }
    s.w = softening.energy_mpa(s.w, seen_mpa);
    s.r = s.r.map(|x| eta * x);
    s.z = s.z.map(|x| eta * x);
    volume::<TANGENT>(f, p, s);
}

/// Adds p (J − 1): J = (ad − bc) t.
fn volume<const TANGENT: bool>(f: &Gradient, p: f64, s: &mut Stress) {
    let Gradient { a, b, c, d, t } = *f;
    for (x, j) in s.r.iter_mut().zip([t * d, -t * c, f.section()]) {
        *x += p * j;
    }
    for (x, j) in s.z.iter_mut().zip([-t * b, t * a]) {
        *x += p * j;
    }
    if TANGENT {
        for (i, x) in [(0, d), (1, -c)] {
            s.rr[i][2] += p * x;
            s.rr[2][i] += p * x;
        }
        s.rz[0][1] += p * t;
        s.rz[1][0] -= p * t;
        s.rz[2][0] -= p * b;
        s.rz[2][1] += p * a;
    }
}
