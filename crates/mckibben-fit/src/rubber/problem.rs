//! The points with their weights, as the solvers see them.

use super::{Mode, TensionPoint};
use mckibben_core::{
    cancel,
    extremes::peak,
    rubber::{Law, RubberLaw},
};
use serde::{Deserialize, Serialize};

/// The objective of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Measure {
    /// Differences of nominal stress.
    #[default]
    Absolute,
    /// Minimise relative differences: small stretches count as much as large ones.
    Relative,
}

/// Points that are fitted, and their weights.
pub struct Problem {
    pub points: Vec<TensionPoint>,
    /// Divisors of the residuals: 1 MPa, or the reference of a relative error.
    pub divisors: Vec<f64>,
    /// Weights of the squares; 0 for points that cannot count.
    pub weights: Vec<f64>,
    /// Shear modulus of the neo-Hookean law that fits best: the size of all constants.
    pub modulus_mpa: f64,
    /// The same by absolute differences: what relative errors of general tests are relative to.
    pub reference_modulus_mpa: f64,
}

impl Problem {
    pub fn new(
        points: Vec<TensionPoint>,
        measure: Measure,
        balance: bool,
        modes: &[(Mode, f64)],
    ) -> Self {
        let ones = vec![1.0; points.len()];
        let mut out = Self {
            divisors: ones.clone(),
            weights: ones,
            points,
            modulus_mpa: 0.0,
            reference_modulus_mpa: 0.0,
        };
        out.reference_modulus_mpa = out.neo_hookean_modulus();
        // What a point's difference is over; none of a point that cannot count.
        let divisor = |p: &TensionPoint| match measure {
            Measure::Relative => p
                .reference_mpa(out.reference_modulus_mpa)
                .filter(|r| *r > 0.0),
            Measure::Absolute => Some(1.0),
        };
        let divisors: Vec<Option<f64>> = out.points.iter().map(divisor).collect();
        let counts = |mode: Option<Mode>| {
            out.points
                .iter()
                .zip(&divisors)
                .filter(|(p, _)| mode.is_none_or(|mode| p.mode == mode))
                .filter(|(_, divisor)| divisor.is_some())
                .count()
        };
        let is_present = |mode: &&Mode| out.points.iter().any(|p| p.mode == **mode);
        let present = Mode::ALL.iter().filter(is_present).count().max(1) as f64;
        let weight = |(p, divisor): (&TensionPoint, &Option<f64>)| {
            let factor = modes.iter().find(|m| m.0 == p.mode).map_or(1.0, |m| m.1);
            let even = if balance {
                counts(None) as f64 / (present * counts(Some(p.mode)).max(1) as f64)
            } else {
                1.0
            };
            divisor.map_or(0.0, |_| factor * even)
        };
        out.weights = out.points.iter().zip(&divisors).map(weight).collect();
        out.divisors = divisors.into_iter().map(|d| d.unwrap_or(1.0)).collect();
        out.modulus_mpa = out.neo_hookean_modulus();
        out
    }

    pub fn counting(&self) -> usize {
        self.weights.iter().filter(|w| **w > 0.0).count()
    }

    /// Largest principal stretch of the points.
    pub fn fitted_to_stretch(&self) -> f64 {
        self.points
            .iter()
            .map(TensionPoint::largest_stretch)
            .fold(1.0, f64::max)
    }

    /// Largest I1 − 3 of the points.
    pub fn largest_i1_minus_3(&self) -> f64 {
        peak(self.points.iter().map(TensionPoint::i1_minus_3))
    }

    /// Stresses of a law over the divisors; `None` where it cannot carry a stretch.
    pub fn scaled_stresses<L: RubberLaw + ?Sized>(&self, law: &L) -> Option<Vec<f64>> {
        let one = |(p, d): (&TensionPoint, &f64)| {
            let stress = p.stress_mpa(law) / d;
            stress.is_finite().then_some(stress)
        };
        self.points.iter().zip(&self.divisors).map(one).collect()
    }

    /// Measured stresses over the divisors.
    pub fn measured(&self) -> Vec<f64> {
        self.points
            .iter()
            .zip(&self.divisors)
            .map(|(p, d)| p.nominal_stress_mpa / d)
            .collect()
    }

    pub fn residuals(&self, law: &Law) -> Option<Vec<f64>> {
        // No residuals of cancelled work: solvers come to their end.
        cancel::check().ok()?;
        let model = self.scaled_stresses(law)?;
        Some(
            model
                .iter()
                .zip(self.measured())
                .map(|(a, b)| a - b)
                .collect(),
        )
    }

    /// Σ w r².
    pub fn squares(&self, law: &Law) -> Option<f64> {
        let r = self.residuals(law)?;
        Some(r.iter().zip(&self.weights).map(|(r, w)| w * r * r).sum())
    }

    fn neo_hookean_modulus(&self) -> f64 {
        let unit = Law::NeoHookean(mckibben_core::rubber::NeoHookean { mu_mpa: 1.0 });
        let Some(column) = self.scaled_stresses(&unit) else {
            return 0.0;
        };
        let mut aa = 0.0;
        let mut ab = 0.0;
        for ((a, b), w) in column.iter().zip(self.measured()).zip(&self.weights) {
            aa += w * a * a;
            ab += w * a * b;
        }
        if aa > 0.0 { ab / aa } else { 0.0 }
    }
}

/// Constants as a solver gives them.
pub struct Raw {
    pub constants: Vec<f64>,
    pub standard_errors: Vec<f64>,
    pub at_bound: Vec<bool>,
    /// A change of each constant that moves the stress at the end of the data by the modulus; 0
    /// where it may not be zero.
    pub scales: Vec<f64>,
    pub freedom: usize,
}
