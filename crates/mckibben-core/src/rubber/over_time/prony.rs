//! Relaxation: a Prony series over any law.

use super::constant;
use crate::{
    refused::Refused,
    rubber::Law,
    units::{Dimension, Words, typed::Time},
};
use serde::{Deserialize, Deserializer, Serialize};

/// One branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// gᵢ, a share of the instantaneous stress.
    pub share: f64,
    /// τᵢ in s.
    pub time_constant_s: f64,
}

/// A Prony series on the isochoric stress.
///
/// ```text
/// S(t) = S0(t) − Σ gᵢ ∫ (1 − e^(−(t−s)/τᵢ)) dS0(s) = (1 − Σ gᵢ) S0 + Σ gᵢ hᵢ,   τᵢ ḣᵢ + hᵢ = τᵢ Ṡ0
///
/// S0   isochoric (deviatoric) second Piola–Kirchhoff stress of the law at once   MPa
/// gᵢ   share of it that relaxes with τᵢ                                            –     ≥ 0, Σ gᵢ < 1
/// τᵢ   time constant                                                               s     > 0
/// hᵢ   state of a branch, one tensor a point; zero at rest                         MPa
/// ```
///
/// Held at a stretch that came at once, S = S0 [1 − Σ gᵢ (1 − e^(−t/τᵢ))], at last (1 − Σ gᵢ) S0.
/// Linear in the stress: good where loops at different rates are alike in shape. Source:
/// `simo1987`, without its damage. As data (serde): a list of pairs, gᵢ and τᵢ in s.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(from = "Vec<(f64, Time)>", into = "Vec<(f64, f64)>")]
#[schemars(with = "Vec<(f64, Time)>")]
pub struct Prony {
    /// The branches; none is a rubber without memory.
    pub branches: Vec<Branch>,
}

impl From<Vec<(f64, Time)>> for Prony {
    fn from(pairs: Vec<(f64, Time)>) -> Self {
        let pairs: Vec<(f64, f64)> = pairs.into_iter().map(|(g, time)| (g, time.0)).collect();
        pairs.into()
    }
}

impl From<Vec<(f64, f64)>> for Prony {
    fn from(pairs: Vec<(f64, f64)>) -> Self {
        let branch = |(share, time_constant_s)| Branch {
            share,
            time_constant_s,
        };
        Self {
            branches: pairs.into_iter().map(branch).collect(),
        }
    }
}

impl From<Prony> for Vec<(f64, f64)> {
    fn from(prony: Prony) -> Self {
        prony
            .branches
            .iter()
            .map(|b| (b.share, b.time_constant_s))
            .collect()
    }
}

/// How long a muscle has been held as it is, after it came there at once.
/// As data (serde): a time in s, or `"long"`.
#[derive(Debug, Clone, Copy, PartialEq, schemars::JsonSchema)]
#[schemars(rename_all = "lowercase")]
pub enum Held {
    /// So long that all branches have relaxed.
    Long,
    /// For a time in s.
    #[schemars(untagged)]
    For(#[schemars(with = "Time")] f64),
}

const HELD: Words<Held> = Words {
    words: &[("long", Held::Long)],
    dimension: Dimension::Time,
    quantity: Held::For,
};

impl<'de> Deserialize<'de> for Held {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        HELD.read(from)
    }
}

impl Prony {
    /// Remaining share of a stress that came at once and was held so long.
    pub fn left(&self, held: Held) -> f64 {
        match held {
            Held::For(time_s) => self.left_after(time_s),
            Held::Long => self.long_time(),
        }
    }

    /// The law whose stresses are the remaining shares of those of the law at once.
    ///
    /// Exact at t → ∞, whatever went before, and for a deformation that came at once and stayed;
    /// between, where a muscle creeps or its ends move, it leaves out that later strains are
    /// younger than earlier ones.
    pub fn relaxed_law(&self, law: &Law, held: Held) -> Law {
        law.scaled(self.left(held))
    }

    /// Checks the constants.
    pub fn validated(self) -> Result<Self, Refused> {
        for b in &self.branches {
            if !(b.share >= 0.0 && b.share.is_finite()) {
                return Err(constant("a branch's share g", b.share, "zero or above"));
            }
            if !(b.time_constant_s > 0.0 && b.time_constant_s.is_finite()) {
                return Err(constant(
                    "a branch's time constant in s",
                    b.time_constant_s,
                    "above zero",
                ));
            }
        }
        let sum = self.relaxing();
        if sum < 1.0 {
            Ok(self)
        } else {
            Err(constant(
                "the sum of all shares g",
                sum,
                "below 1: the remainder is the rubber at rest",
            ))
        }
    }

    /// Σ gᵢ.
    pub fn relaxing(&self) -> f64 {
        self.branches.iter().map(|b| b.share).sum()
    }

    /// 1 − Σ gᵢ: moduli of long times over the instantaneous ones.
    pub fn long_time(&self) -> f64 {
        1.0 - self.relaxing()
    }

    /// 1 − Σ gᵢ (1 − e^(−t/τᵢ)): remaining share of a stress that came at once, after a time in s.
    pub fn left_after(&self, time_s: f64) -> f64 {
        let lost = |b: &Branch| -b.share * (-time_s / b.time_constant_s).exp_m1();
        1.0 - self.branches.iter().map(lost).sum::<f64>()
    }

    /// The states after a step in which S0 goes straight by `change`: hᵢ e^(−Δt/τᵢ) + (τᵢ/Δt)(1 −
    /// e^(−Δt/τᵢ)) ΔS0; exact for a stress that is piecewise linear in time, second order in Δt for
    /// a smooth one. No time is a jump.
    pub fn step<const N: usize>(&self, states: &mut [[f64; N]], change: [f64; N], duration_s: f64) {
        for (h, b) in states.iter_mut().zip(&self.branches) {
            let x = duration_s / b.time_constant_s;
            let mean = if x > 0.0 { -(-x).exp_m1() / x } else { 1.0 };
            for (h, d) in h.iter_mut().zip(change) {
                *h = *h * (-x).exp() + mean * d;
            }
        }
    }

    /// (1 − Σ gᵢ) S0 + Σ gᵢ hᵢ.
    pub fn stress<const N: usize>(&self, instantaneous: [f64; N], states: &[[f64; N]]) -> [f64; N] {
        let mut out = instantaneous.map(|s| self.long_time() * s);
        for (h, b) in states.iter().zip(&self.branches) {
            for (s, h) in out.iter_mut().zip(h) {
                *s += b.share * h;
            }
        }
        out
    }
}
