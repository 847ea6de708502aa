//! The rubber's viscoelasticity.

use crate::{Result, error::within};
pub use mckibben_core::rubber::over_time::Branch;

/// A Prony series on the wall's part of the pull, whose shares are over the long-time part.
///
/// ```text
/// F = F_model + Σ gᵢ (F_w − aᵢ),   τᵢ ȧᵢ = F_w − aᵢ,   F_w = F_model(P, ε) − F_ideal(P, ε)
/// ```
///
/// The wall's part F_w is what the model says less the ideal formula (1), which has no wall
/// \[chou1996\]. After a step of F_w the pull is too large by Σ gᵢ of it and relaxes to the static
/// pull, which the long-time limit is by definition. Linear viscoelasticity in the pull, not in the
/// stress: fit for shares below some tenths. Empty: none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Prony(pub Vec<Branch>);

impl Prony {
    pub(crate) fn check(&self) -> Result<()> {
        self.0.iter().try_for_each(|b| {
            within("a branch's share of the wall's pull", b.share, 0.0, 1e3)?;
            within(
                "a branch's time constant in s",
                b.time_constant_s,
                1e-6,
                1e12,
            )
        })
    }

    /// Σ gᵢ (F_w − aᵢ) in N.
    pub fn excess_n(&self, wall_n: f64, states: &[f64]) -> f64 {
        self.0
            .iter()
            .zip(states)
            .fold(0.0, |sum, (b, a)| sum + b.share * (wall_n - a))
    }

    /// ȧᵢ in N/s.
    pub fn rates(&self, wall_n: f64, states: &[f64]) -> Vec<f64> {
        self.0
            .iter()
            .zip(states)
            .map(|(b, a)| (wall_n - a) / b.time_constant_s)
            .collect()
    }
}
