//! Gent's law, P = (μ/2) (dI1/dλ) /(1 − (I1 − 3)/Jm), in μ and q = X/Jm with X the largest I1 − 3 of the data.
//!
//! q = 0 is the neo-Hookean law and q = 1 a chain that locks at the last point, so q has two ends where Jm has none.
//! Standard error of Jm = X/q: X/q² times that of q.

use super::form::Form;
use super::problem::Problem;
use super::{Raw, TensionFitError};
use crate::least_squares::{Loss, Residuals, Unknown, estimate};
use crate::rubber::{Gent, Law};

/// Jm up to a thousand times X: farther away the law cannot be told from the neo-Hookean.
const LOWEST: f64 = 1e-3;

struct OfQ<'a> {
    problem: &'a Problem,
    largest: f64,
}

impl Residuals for OfQ<'_> {
    fn at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.problem.residuals(&Law::Gent(Gent { mu_mpa: x[0], jm: self.largest / x[1] }))
    }

    fn by_unknowns(&self, x: &[f64]) -> Option<Vec<Vec<f64>>> {
        let law = Law::Gent(Gent { mu_mpa: x[0], jm: self.largest / x[1] });
        let stress = self.problem.scaled_stresses(&law)?;
        let by_q = stress.iter().zip(&self.problem.points).map(|(s, p)| {
            let y = p.mode.i1_minus_3(p.stretch) / self.largest;
            s * y / (1.0 - x[1] * y)
        });
        let by_q = by_q.collect();
        Some(vec![stress.iter().map(|s| s / x[0]).collect(), by_q])
    }
}

/// The fit; `least_jm` keeps the limit beyond what a muscle wall reaches.
pub(super) fn fit(problem: &Problem, least_jm: Option<f64>) -> Result<Raw, TensionFitError> {
    let failed = |why: String| TensionFitError::NotConverged { law: Form::Gent.name(), why };
    let largest = problem.largest_i1_minus_3();
    let high = least_jm.map_or(0.999, |jm| (largest / jm).min(0.999));
    let mu = problem.modulus_mpa;
    let of_q = OfQ { problem, largest };
    let mut best: Option<(f64, Raw)> = None;
    let mut why = String::new();
    for start in [0.1, 0.4, 0.7, 0.95] {
        let unknowns = [
            Unknown { start: mu, low: 1e-3 * mu, high: 1e3 * mu, scale: mu },
            Unknown { start: LOWEST + (high - LOWEST) * start, low: LOWEST, high, scale: 1.0 },
        ];
        match estimate(&of_q, &unknowns, &problem.weights, Loss::Squares) {
            Ok(found) => {
                let squares: f64 = found.residuals.iter().zip(&problem.weights).map(|(r, w)| w * r * r).sum();
                if best.as_ref().is_some_and(|b| b.0 <= squares * (1.0 + 1e-9)) {
                    continue;
                }
                let q = found.x[1];
                let slope = largest / (q * q);
                let raw = Raw {
                    constants: vec![found.x[0], largest / q],
                    standard_errors: vec![found.standard_errors[0], slope * found.standard_errors[1]],
                    at_bound: found.at_bound,
                    scales: vec![0.0, 0.0],
                    freedom: problem.counting() - 2,
                };
                best = Some((squares, raw));
            }
            Err(error) => why = error.to_string(),
        }
    }
    best.map(|b| b.1).ok_or_else(|| failed(why))
}
