//! Laws whose stress is not linear in their constants: moduli, plain numbers within their bounds,
//! and limits.
//!
//! A limit is the constant that says where the chains lock, such as Jm of Gent's law. With Y its
//! value for a law that locks at the last point of the data it is sought as q = Y/limit: q = 0 is a
//! chain that never locks and q = 1 one that locks at the last point, so q has two ends where the
//! limit has none. Standard error of the limit Y/q: Y/q² times that of q. The fit begins at several
//! q and the lowest minimum is taken.

use super::{
    Result, no_fit,
    problem::{Problem, Raw},
};
use crate::least_squares::{Residuals, Unknown, estimate};
use mckibben_core::rubber::{Form, Law, MUSCLE_AXIAL_STRETCH, RubberLaw};

/// A limit up to a thousand times that of the data: farther away it is not identifiable.
const LOWEST: f64 = 1e-3;
/// Shares of the range of q at which the fit begins.
const STARTS: [f64; 4] = [0.1, 0.4, 0.7, 0.95];

/// A limit: its place among the constants and its value for a law that locks at the last point.
#[derive(Clone, Copy)]
struct Limit {
    place: usize,
    at_data: f64,
}

struct Unknowns<'a> {
    form: Form,
    problem: &'a Problem,
    limit: Option<Limit>,
}

impl Unknowns<'_> {
    /// The limit for q, or q for the limit; all others stay.
    fn turned(&self, x: &[f64]) -> Vec<f64> {
        let mut out = x.to_vec();
        if let Some(Limit { place, at_data }) = self.limit {
            out[place] = at_data / out[place];
        }
        out
    }
}

impl Residuals for Unknowns<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.problem.residuals(&self.form.law_of(&self.turned(x))?)
    }
}

/// The constant that says where a law locks, at the value with which it does so at `i1_minus_3`.
fn limit(law: &Law, i1_minus_3: f64) -> Option<Limit> {
    law.locks_at()?;
    let constants = law.constants();
    let place = constants.iter().position(|c| !c.constant.is_modulus())?;
    let locks = |value: f64| {
        law.with_constants(|i, v| if i == place { value } else { v })
            .locks_at()
            .is_some_and(|l| l < i1_minus_3)
    };
    let mut low = constants[place].constant.bounds.0;
    let mut high = low + 1.0;
    while locks(high) && high < 1e12 {
        (low, high) = (high, 2.0 * high);
    }
    // Halved until nothing lies between.
    let mut middle = 0.5 * (low + high);
    while low < middle && middle < high {
        if locks(middle) {
            low = middle
        } else {
            high = middle
        }
        middle = 0.5 * (low + high);
    }
    Some(Limit {
        place,
        at_data: high,
    })
}

/// I1 − 3 that a muscle wall reaches, at either end of its axial stretches.
fn muscle_i1_minus_3(hoop: f64) -> f64 {
    let i1 = |axial: f64| hoop * hoop + axial * axial + (hoop * axial).powi(-2) - 3.0;
    i1(MUSCLE_AXIAL_STRETCH.0).max(i1(MUSCLE_AXIAL_STRETCH.1))
}

/// The fit; with the hoop stretch of a muscle the limit is kept a little beyond what its wall
/// reaches.
pub fn fit(form: Form, problem: &Problem, hoop: Option<f64>) -> Result<Raw> {
    let mu = problem.modulus_mpa;
    let example = form
        .example()
        .ok_or_else(|| no_fit(form, "its constants are not complete"))?;
    let law = example.scaled(mu / example.shear_modulus_mpa());
    let of_muscle = hoop.and_then(|hoop| limit(&law, muscle_i1_minus_3(hoop)));
    let limit = limit(&law, problem.largest_i1_minus_3());
    let high = match (limit, of_muscle) {
        (Some(data), Some(muscle)) => (data.at_data / (1.02 * muscle.at_data)).min(0.999),
        _ => 0.999,
    };
    let residuals = Unknowns {
        form,
        problem,
        limit,
    };
    let mut best: Option<(f64, Raw)> = None;
    let mut why = String::new();
    for start in if limit.is_some() {
        &STARTS[..]
    } else {
        &STARTS[..1]
    } {
        let one = |(i, c): (usize, mckibben_core::rubber::ConstantValue)| {
            let (low, up) = c.constant.bounds;
            match limit {
                Some(limit) if limit.place == i => Unknown {
                    start: LOWEST + (high - LOWEST) * start,
                    low: LOWEST,
                    high,
                    scale: 1.0,
                },
                _ if c.constant.is_modulus() && low == 0.0 => Unknown {
                    start: c.value,
                    low: 1e-3 * mu,
                    high: 1e3 * mu,
                    scale: mu,
                },
                _ if c.constant.is_modulus() => Unknown::free(c.value, mu),
                _ => Unknown {
                    start: c.value,
                    low,
                    high: up,
                    scale: c.value.abs().max(0.1),
                },
            }
        };
        let unknowns: Vec<Unknown> = law.constants().into_iter().enumerate().map(one).collect();
        match estimate(&residuals, &unknowns, &problem.weights) {
            Ok(fit)
                if best
                    .as_ref()
                    .is_none_or(|b| b.0 > fit.squares * (1.0 + 1e-9)) =>
            {
                let mut standard_errors = fit.standard_errors;
                if let Some(Limit { place, at_data }) = limit {
                    standard_errors[place] *= at_data / fit.x[place].powi(2);
                }
                let raw = Raw {
                    constants: residuals.turned(&fit.x),
                    standard_errors,
                    at_bound: fit.at_bound,
                    scales: vec![0.0; unknowns.len()],
                    freedom: problem.counting() - unknowns.len(),
                };
                best = Some((fit.squares, raw));
            }
            Ok(_) => {}
            Err(error) => why = error.to_string(),
        }
    }
    best.map(|b| b.1).ok_or_else(|| no_fit(form, why))
}
