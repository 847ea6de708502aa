//! Laws whose stress is linear in their constants, as it is seen from the law: neo-Hookean,
//! Mooney–Rivlin, Yeoh.
//!
//! The constants free, or such that the law is stable wherever a muscle wall may be. With x = ln
//! λθ, y = ln λz, Hill's inequality (see [`is_stable_at`](mckibben_core::rubber::is_stable_at)) asks the
//! Hessian H(c) of ŵ to be positive definite, and H is linear in the constants c. So in every state
//!
//!   vᵀ H(c) v = Σ cᵢ vᵀ Hᵢ v ≥ 0.001 μ    for every unit vector v,
//!
//! a convex set, which is cut out step by step: solve, look for the state and v where it is
//! violated most, add that inequality, solve again (J. E. Kelley, SIAM J. 8 (1960) 703).
//! Mooney–Rivlin has C10 ≥ 0 and C01 ≥ 0 besides.

use super::{
    Result,
    convex::{Inequality, normal, solve},
    no_fit,
    problem::{Problem, Raw},
};
use crate::least_squares::{Residuals, Unknown, estimate};
use mckibben_core::{
    by_number::ByNumber,
    rubber::{Form, Law, LawConstants, MooneyRivlin, RubberLaw, log_hessian, muscle_states},
};

/// The columns ∂P/∂c over the divisors.
struct Linear<'a> {
    columns: &'a [Vec<f64>],
    measured: Vec<f64>,
}

impl Residuals for Linear<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        let residual = |(k, b): (usize, &f64)| {
            self.columns
                .iter()
                .zip(x)
                .map(|(c, x)| c[k] * x)
                .sum::<f64>()
                - b
        };
        Some(self.measured.iter().enumerate().map(residual).collect())
    }

    fn by_unknowns(&self, _x: &[f64]) -> Option<Vec<Vec<f64>>> {
        Some(self.columns.to_vec())
    }
}

fn columns(basis: &[Law], problem: &Problem) -> Option<Vec<Vec<f64>>> {
    basis
        .iter()
        .map(|law| problem.scaled_stresses(law))
        .collect()
}

/// Size of the constant of a basis law: with it that law gives, in planar tension to the largest I1
/// − 3 = (λ − 1/λ)² of the data, the stress μ (λ − λ⁻³) of the modulus.
fn scale(basis: &Law, problem: &Problem) -> f64 {
    let x = problem.largest_i1_minus_3().max(1e-6);
    let stretch = 0.5 * (x.sqrt() + (x + 4.0).sqrt());
    problem.modulus_mpa * (stretch - stretch.powi(-3)) / basis.planar_stress_mpa(stretch)
}

pub fn free(form: Form, basis: &[Law], problem: &Problem) -> Result<Raw> {
    let columns = columns(basis, problem).ok_or_else(|| no_fit(form, "a stress is not finite"))?;
    let unknowns: Vec<Unknown> = basis
        .iter()
        .map(|law| Unknown::free(0.0, scale(law, problem)))
        .collect();
    let linear = Linear {
        columns: &columns,
        measured: problem.measured(),
    };
    let fit = estimate(&linear, &unknowns, &problem.weights).map_err(|e| no_fit(form, e))?;
    Ok(Raw {
        constants: fit.x,
        standard_errors: fit.standard_errors,
        at_bound: fit.at_bound,
        scales: unknowns.iter().map(|u| u.scale).collect(),
        freedom: problem.counting() - basis.len(),
    })
}

/// The law whose constants are held at or above zero.
pub const HELD_POSITIVE: &str = MooneyRivlin::NAME;
/// Cuts at most; some ten are usual.
const CUTS: usize = 40;

/// The fit among the laws that are stable in a muscle.
pub fn stable(form: Form, basis: &[Law], problem: &Problem, hoop_stretch: f64) -> Result<Raw> {
    let columns = columns(basis, problem).ok_or_else(|| no_fit(form, "a stress is not finite"))?;
    let (n, d) = normal(&columns, &problem.measured(), &problem.weights);
    let margin = 1e-3 * problem.modulus_mpa;
    let states: Vec<Vec<[f64; 3]>> = muscle_states(hoop_stretch)
        .map(|(hoop, axial)| {
            basis
                .iter()
                .map(|law| log_hessian(law, hoop, axial))
                .collect()
        })
        .collect();
    let mut cuts = Inequality::positive(if form.law() == HELD_POSITIVE {
        basis.len()
    } else {
        0
    });
    for _ in 0..CUTS {
        let solution =
            solve(&n, &d, &cuts).ok_or_else(|| no_fit(form, "no stable law fits these data"))?;
        let worst = states
            .iter()
            .map(|s| deepest(s, &solution.x))
            .min_by_number(|a| a.0);
        let (depth, g) = worst.ok_or_else(|| no_fit(form, "no states"))?;
        // The iteration ends within half of the margin.
        if depth >= 0.5 * margin {
            let freedom = (problem.counting() + solution.active.len())
                .saturating_sub(basis.len())
                .max(1);
            let squares = form
                .law_of(&solution.x)
                .and_then(|law| problem.squares(&law));
            let deviation = (squares.ok_or_else(|| no_fit(form, "a stress is not finite"))?
                / freedom as f64)
                .sqrt();
            let at_bound = |i: usize| {
                let alone = |k: &usize| {
                    cuts[*k]
                        .g
                        .iter()
                        .enumerate()
                        .all(|(j, g)| (j == i) == (*g != 0.0))
                };
                solution.active.iter().any(alone)
            };
            return Ok(Raw {
                standard_errors: solution
                    .variances
                    .iter()
                    .map(|v| deviation * v.sqrt())
                    .collect(),
                at_bound: (0..basis.len()).map(at_bound).collect(),
                scales: basis.iter().map(|law| scale(law, problem)).collect(),
                constants: solution.x,
                freedom,
            });
        }
        cuts.push(Inequality { g, h: margin });
    }
    Err(no_fit(form, "the constraint of stability was not met"))
}

/// The smallest eigenvalue of H(c), and vᵀHᵢv with its eigenvector v.
fn deepest(of_basis: &[[f64; 3]], c: &[f64]) -> (f64, Vec<f64>) {
    let sum = |k: usize| of_basis.iter().zip(c).map(|(h, c)| h[k] * c).sum::<f64>();
    let [xx, xy, yy] = [0, 1, 2].map(sum);
    // Angle of the principal axes: tan 2φ = 2 xy/(xx − yy); the smaller eigenvalue lies across.
    let phi = 0.5 * (2.0 * xy).atan2(xx - yy) + std::f64::consts::FRAC_PI_2;
    let (s, k) = phi.sin_cos();
    let form = |h: &[f64; 3]| h[0] * k * k + 2.0 * h[1] * k * s + h[2] * s * s;
    (form(&[xx, xy, yy]), of_basis.iter().map(form).collect())
}
