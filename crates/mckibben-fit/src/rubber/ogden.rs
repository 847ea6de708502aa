//! Ogden's law, P = Σ μᵢ (λ1^αᵢ − λ3^αᵢ)/λ1, of a difference of true stresses Σ μᵢ (λ1^αᵢ −
//! λ2^αᵢ)/max(λ1, λ2).
//!
//! Every term has μᵢ αᵢ ≥ 0, which makes ŵ convex in the logarithms of the stretches: stable at any
//! stretch (R. W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565). The sum of squares has many minima.
//! Starts are all sets of exponents from a list, each with the moduli ≥ 0 that suit it best (linear
//! least squares); the best of them are followed to their minimum, and the lowest is taken. The
//! list is fixed, so the same data give the same law.

use super::{
    Result, TensionFitError,
    convex::{Inequality, normal, solve, subsets},
    no_fit,
    problem::{Problem, Raw},
};
use crate::least_squares::{Estimate, Residuals, Unknown, estimate};
use mckibben_core::{
    by_number::SortByNumber,
    cancel,
    rubber::{Form, Law, Ogden},
};

const EXPONENTS: [f64; 14] = [
    0.7, 1.3, 2.0, 3.0, 4.0, 5.5, 7.5, 10.0, 14.0, -0.7, -1.5, -2.5, -4.5, -8.0,
];
/// Smallest and largest |α|.
const RANGE: (f64, f64) = (0.2, 25.0);
/// Starts that are followed.
const FOLLOWED: usize = 8;

/// x = |μ1|, |α1|, |μ2|, …; each term has its sign.
struct Terms<'a> {
    problem: &'a Problem,
    signs: Vec<f64>,
}

impl Terms<'_> {
    fn law(&self, x: &[f64]) -> Law {
        let terms = x
            .chunks_exact(2)
            .zip(&self.signs)
            .map(|(t, s)| (s * t[0], s * t[1]))
            .collect();
        Law::Ogden(Ogden { terms })
    }
}

impl Residuals for Terms<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.problem.residuals(&self.law(x))
    }

    fn by_unknowns(&self, x: &[f64]) -> Option<Vec<Vec<f64>>> {
        let mut columns = vec![];
        for (t, s) in x.chunks_exact(2).zip(&self.signs) {
            let mu = s * t[0];
            let alpha = s * t[1];
            let mut by_mu = vec![];
            let mut by_alpha = vec![];
            for (p, d) in self.problem.points.iter().zip(&self.problem.divisors) {
                let [l1, l2, l3] = p.stretches();
                let (less, over) = if p.difference {
                    (l2, l1.max(l2))
                } else {
                    (l3, l1)
                };
                let up = l1.powf(alpha) / over;
                let down = less.powf(alpha) / over;
                by_mu.push(s * (up - down) / d);
                by_alpha.push(s * mu * (l1.ln() * up - less.ln() * down) / d);
            }
            columns.extend([by_mu, by_alpha]);
        }
        Some(columns)
    }
}

/// A set of exponents with the moduli that suit it, and the sum of their squares.
struct Start {
    squares: f64,
    terms: Vec<(f64, f64)>,
}

fn starts(count: usize, problem: &Problem) -> Vec<Start> {
    let measured = problem.measured();
    let column = |alpha: f64| {
        let unit = Law::Ogden(Ogden {
            terms: vec![(alpha.signum(), alpha)],
        });
        problem.scaled_stresses(&unit)
    };
    let columns: Vec<(f64, Vec<f64>)> = EXPONENTS
        .into_iter()
        .filter_map(|alpha| Some((alpha, column(alpha)?)))
        .collect();
    let (exponents, columns): (Vec<f64>, Vec<Vec<f64>>) = columns.into_iter().unzip();
    let (all, right) = normal(&columns, &measured, &problem.weights);
    let mut out = vec![];
    for places in subsets(columns.len(), count)
        .into_iter()
        .filter(|set| set.len() == count)
    {
        if cancel::check().is_err() {
            break;
        }
        let n = all.select_rows(&places).select_columns(&places);
        let d = right.select_rows(&places);
        let Some(solution) = solve(&n, &d, &Inequality::positive(count)) else {
            continue;
        };
        if solution.x.iter().any(|x| *x <= 0.0) {
            continue;
        }
        let terms = places
            .iter()
            .zip(&solution.x)
            .map(|(&k, x)| (*x, exponents[k]))
            .collect();
        let residual = |i: usize| {
            places
                .iter()
                .zip(&solution.x)
                .map(|(&k, x)| x * columns[k][i])
                .sum::<f64>()
                - measured[i]
        };
        let squares = problem
            .weights
            .iter()
            .enumerate()
            .map(|(i, w)| w * residual(i).powi(2))
            .sum();
        out.push(Start { squares, terms });
    }
    out.sort_by_number(|a| a.squares);
    out.truncate(FOLLOWED);
    out
}

pub fn fit(form: Form, problem: &Problem) -> Result<Raw> {
    let count = form.terms().unwrap_or(1);
    let mut best: Option<(Vec<f64>, Estimate)> = None;
    let mut why = None;
    // The residuals of exact data are rounding, and in planar tension α and −α are one law: then
    // exponents above zero are taken.
    let all: f64 = problem
        .measured()
        .iter()
        .zip(&problem.weights)
        .map(|(m, w)| w * m * m)
        .sum();
    for start in starts(count, problem) {
        let signs: Vec<f64> = start.terms.iter().map(|t| t.1.signum()).collect();
        let unknowns: Vec<Unknown> = start
            .terms
            .iter()
            .flat_map(|&(mu, alpha)| {
                let exponent = Unknown {
                    start: alpha.abs(),
                    low: RANGE.0,
                    high: RANGE.1,
                    scale: 1.0,
                };
                [Unknown::above(mu, 0.0, mu), exponent]
            })
            .collect();
        let terms = Terms {
            problem,
            signs: signs.clone(),
        };
        match estimate(&terms, &unknowns, &problem.weights) {
            Ok(fit) => {
                let better = |(best_signs, best): &(Vec<f64>, Estimate)| {
                    let alike =
                        (fit.squares - best.squares).abs() <= 1e-9 * best.squares + 1e-14 * all;
                    let (sum, best_sum) =
                        (signs.iter().sum::<f64>(), best_signs.iter().sum::<f64>());
                    if alike {
                        sum > best_sum
                    } else {
                        fit.squares < best.squares
                    }
                };
                if best.as_ref().is_none_or(better) {
                    best = Some((signs, fit));
                }
            }
            Err(error) => why = Some(error.to_string()),
        }
    }
    let no_better = || TensionFitError::NoBetter(form.name());
    let (signs, fit) = best.ok_or_else(|| why.map_or_else(no_better, |why| no_fit(form, why)))?;
    let alpha = |k: usize| signs[k] * fit.x[2 * k + 1];
    let same = |a: usize, b: usize| (alpha(a) - alpha(b)).abs() < 0.01 * alpha(a).abs();
    let twice = (0..count).any(|a| (0..a).any(|b| same(a, b)));
    if count > 1 && (twice || (0..count).any(|k| fit.at_bound[2 * k])) {
        return Err(no_better());
    }
    // The term that gives most of the modulus first.
    let mut order: Vec<usize> = (0..count).collect();
    let share = |k: &usize| fit.x[2 * k] * fit.x[2 * k + 1];
    order.sort_by_number(|a| -share(a));
    let places: Vec<usize> = order.iter().flat_map(|k| [2 * k, 2 * k + 1]).collect();
    Ok(Raw {
        constants: places.iter().map(|&i| signs[i / 2] * fit.x[i]).collect(),
        standard_errors: places.iter().map(|&i| fit.standard_errors[i]).collect(),
        at_bound: places.iter().map(|&i| fit.at_bound[i]).collect(),
        scales: vec![0.0; 2 * count],
        freedom: problem.counting() - 2 * count,
    })
}
