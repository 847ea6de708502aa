//! Mullins softening by Ogden & Roxburgh: the stress of any law times η ≤ 1 where the rubber has
//! been further before.

use super::{
    constant,
    erf::{erf, erf_integral},
};
use crate::{
    refused::Refused,
    rubber::{Biaxial, Principal, RubberLaw},
    units::typed::{Pressure, read_quantity},
};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Softening constants.
///
/// ```text
/// η = 1 − (1/r) erf((W_m − W0)/s),   s = m + β W_m,   for W0 < W_m;   η = 1 for W0 ≥ W_m
/// stress = η · stress of the law
///
/// W0   energy of the law (first loading)              MPa
/// W_m  largest W0 that the point has seen             MPa
/// r    1/r is the largest loss of stress               –     ≥ 1
/// m    spread of the loss over the energy              MPa   ≥ 0
/// β    the same as a share of W_m                      –     ≥ 0,   m + β W_m > 0
/// ```
///
/// The energy lost in a cycle from rest to W_m and back is ∫(1 − η) dW0 = (s/r) ∫₀^(W_m/s) erf. No
/// permanent set, no rate: reloading goes back along the unloading. β = 0 is the law as it was
/// published; β and the name `s` follow its form in finite-element programs. Source: `ogden1999`.
/// As data (serde): `r`, `m` in MPa, `beta`, as in muscle files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OgdenRoxburgh {
    /// r (–).
    pub r: f64,
    /// m in MPa.
    #[serde(rename = "m", deserialize_with = "read_quantity::<Pressure, _>")]
    #[schemars(with = "Pressure")]
    pub m_mpa: f64,
    /// β (–).
    #[serde(default)]
    pub beta: f64,
}

impl OgdenRoxburgh {
    /// Checks the constants.
    pub fn validated(self) -> Result<Self, Refused> {
        let Self { r, m_mpa, beta } = self;
        let spreads = "above zero: one of m and beta spreads the loss";
        let checks = [
            (
                "r",
                r,
                r >= 1.0,
                "1 or above: 1/r is the largest loss of stress",
            ),
            (
                "m",
                m_mpa,
                m_mpa >= 0.0,
                "an energy of zero or above, in MPa",
            ),
            ("beta", beta, beta >= 0.0, "zero or above"),
            ("m + beta", m_mpa + beta, m_mpa + beta != 0.0, spreads),
        ];
        checks
            .into_iter()
            .find(|(_, value, holds, _)| !(*holds && value.is_finite()))
            .map_or(Ok(self), |(name, value, _, expected)| {
                Err(constant(name, value, expected))
            })
    }

    fn spread(&self, w_max: f64) -> f64 {
        self.m_mpa + self.beta * w_max
    }

    /// η for an energy W0 and the largest so far, both in MPa.
    pub fn factor(&self, w0_mpa: f64, w_max_mpa: f64) -> f64 {
        if w0_mpa >= w_max_mpa {
            return 1.0;
        }
        1.0 - erf((w_max_mpa - w0_mpa) / self.spread(w_max_mpa)) / self.r
    }

    /// ∂η/∂W0 in 1/MPa; zero on the first loading.
    pub fn slope(&self, w0_mpa: f64, w_max_mpa: f64) -> f64 {
        if w0_mpa >= w_max_mpa {
            return 0.0;
        }
        let s = self.spread(w_max_mpa);
        let x = (w_max_mpa - w0_mpa) / s;
        2.0 / PI.sqrt() * (-x * x).exp() / (self.r * s)
    }

    /// ∫₀^W0 η dW in MPa: the energy whose derivative is the softened stress.
    pub fn energy_mpa(&self, w0_mpa: f64, w_max_mpa: f64) -> f64 {
        if w_max_mpa <= 0.0 {
            return w0_mpa;
        }
        let s = self.spread(w_max_mpa);
        let left = erf_integral((w_max_mpa - w0_mpa).max(0.0) / s);
        w0_mpa - s / self.r * (erf_integral(w_max_mpa / s) - left)
    }
}

/// A law that has seen the energy `w_max_mpa`: a law again, with exact tangent. The state is held
/// while it is evaluated; beyond `w_max_mpa` it is the law itself, and whoever steps in time sets
/// the new largest energy from [`Softened::seen_mpa`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softened<'a, L> {
    /// The law of the first loading.
    pub law: &'a L,
    /// How it softens.
    pub softening: OgdenRoxburgh,
    /// W_m in MPa.
    pub w_max_mpa: f64,
}

impl<L: RubberLaw> Softened<'_, L> {
    /// W_m after this state.
    pub fn seen_mpa(&self, stretches: [f64; 3]) -> f64 {
        self.w_max_mpa.max(self.law.principal(stretches).w)
    }
}

impl<L: RubberLaw> RubberLaw for Softened<'_, L> {
    fn shear_modulus_mpa(&self) -> f64 {
        self.softening.factor(0.0, self.w_max_mpa) * self.law.shear_modulus_mpa()
    }

    fn principal(&self, stretches: [f64; 3]) -> Principal {
        let p = self.law.principal(stretches);
        let eta = self.softening.factor(p.w, self.w_max_mpa);
        let slope = self.softening.slope(p.w, self.w_max_mpa);
        let mut dd = p.dd;
        for (i, row) in dd.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value = eta * *value + slope * p.d[i] * p.d[j];
            }
        }
        Principal {
            w: self.softening.energy_mpa(p.w, self.w_max_mpa),
            d: p.d.map(|d| eta * d),
            dd,
        }
    }

    fn biaxial(&self, u: f64, v: f64) -> Biaxial {
        let b = self.law.biaxial(u, v);
        let eta = self.softening.factor(b.w, self.w_max_mpa);
        let slope = self.softening.slope(b.w, self.w_max_mpa);
        Biaxial {
            w: self.softening.energy_mpa(b.w, self.w_max_mpa),
            u: eta * b.u,
            v: eta * b.v,
            uu: eta * b.uu + slope * b.u * b.u,
            uv: eta * b.uv + slope * b.u * b.v,
            vv: eta * b.vv + slope * b.v * b.v,
        }
    }
}
