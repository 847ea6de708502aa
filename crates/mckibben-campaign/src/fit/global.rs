//! One least-squares problem for the whole range.
//!
//!   F = D0² Σ c · xᵃ pᵇ eᶜ dᵈ,   x = (s/D0)/0.1, p = P/P_max, e = ε/ε_max, d = D0/40 mm
//!   Σ ((F − F_FE)/F_blocked)² → min   over the points where the muscle pulls
//!
//! F_blocked is the muscle's blocked force at the highest pressure, as in the stated errors. Points
//! below zero are left out: there the strands go slack one after the other, and F(P) has kinks that
//! no short formula follows.
//!
//! Terms are chosen by forward selection: at each step the one that, made orthogonal to those
//! already chosen, reduces the sum most (S. Chen, S. A. Billings, W. Luo, Int. J. Control 50, 1873,
//! 1989). How many: the smallest number whose error on diameters left out one at a time is within 5
//! % of the smallest such error, and at most 48. Only inner diameters are left out; without the
//! outermost the formula would have to extrapolate, which it refuses to do later.

use super::{
    data::{FULL_PRESSURE, FitPoint, distinct, same},
    error::{FitError, Result},
    errors::ForceScales,
    least_squares::Triangle,
};
use mckibben_core::{
    cancel,
    formula::{GlobalTerms, Scales, Term},
    threads,
};
use nalgebra::DVector;

/// As many coefficients as the paper's formula.
pub const MOST_TERMS: usize = 48;
/// Highest powers of x, p, e and d, and of all but p together.
const HIGHEST: [usize; 4] = [3, 4, 4, 2];
const HIGHEST_TOGETHER: usize = 6;
/// A term this close (squared sine of the angle) to the space of those chosen brings nothing but
/// rounding.
const DEPENDENT: f64 = 1e-12;
/// The sum of squares is met to rounding.
const MET: f64 = 1e-26;
/// A number of terms is as good as the best within this factor.
const AS_GOOD: f64 = 1.05;

/// Fits given terms, or at most [`MOST_TERMS`] chosen ones; how many candidates there were.
pub fn global(points: &[FitPoint], own: Option<&[[u8; 4]]>) -> Result<(GlobalTerms, usize)> {
    let forces = ForceScales::new(points)?;
    let used = || points.iter().filter(|p| p.force_n > 0.0);
    if used().next().is_none() {
        return Err(FitError::empty(" where the muscle pulls"));
    }
    let values = |f: fn(&FitPoint) -> f64| distinct(used().map(f));
    let diameters = values(|p| p.outer_diameter_mm);
    let walls = values(|p| p.wall_mm);
    let pressures = values(|p| p.pressure_mpa);
    let contractions = values(|p| p.contraction);
    let last =
        |list: &[f64], default: f64| list.last().copied().filter(|v| *v > 0.0).unwrap_or(default);
    let scales = Scales {
        wall_ratio: 0.1,
        pressure_mpa: last(&pressures, FULL_PRESSURE),
        contraction: last(&contractions, 0.2),
        outer_diameter_mm: 40.0,
    };
    // A power needs one value more than its degree, that of d one more, since s/D0 depends on D0.
    let counts = [
        walls.len(),
        pressures.len() + 1,
        contractions.len(),
        diameters.len().saturating_sub(1),
    ];
    let candidates = match own {
        Some(own) => own.to_vec(),
        None => candidates(counts),
    };
    // D0² xᵃ pᵇ eᶜ dᵈ/F_blocked | F/F_blocked
    let row = |p: &FitPoint| {
        let blocked_n = forces.blocked_n(p);
        let d = p.outer_diameter_mm;
        let variables = scales.variables(d, p.wall_mm, p.pressure_mpa, p.contraction);
        let term = |powers: &[u8; 4]| d.powi(2) / blocked_n * Term::product(*powers, variables);
        let force = p.force_n / blocked_n;
        candidates.iter().map(term).chain([force]).collect()
    };
    let groups = groups(points, &diameters, candidates.len(), row);
    cancel::check()?;
    let full = Triangle::without(&groups, None);
    // Terms that are chosen have two points each at least.
    let chosen = select(&full, own.map_or(full.rows / 2, <[_]>::len));
    // The choice of work that was ended is not complete.
    cancel::check()?;
    let coefficients = nested(&full, &chosen);
    let left_out = own.map_or_else(|| leave_out(&groups), |_| None);
    cancel::check()?;
    let count = left_out
        .and_then(|errors| enough(&errors, chosen.len()))
        .unwrap_or(chosen.len());
    let values = coefficients(count).ok_or_else(|| FitError::singular("the global formula"))?;
    let terms = chosen.iter().zip(values.iter()).map(|(&j, &v)| Term {
        powers: candidates[j],
        value: v,
    });
    let terms = GlobalTerms {
        scales,
        terms: terms.collect(),
    };
    Ok((terms, candidates.len()))
}

/// The problems of groups of diameters, of which one can be left out: of each diameter, or of
/// neighbouring ones where they are many.
fn groups(
    points: &[FitPoint],
    diameters: &[f64],
    terms: usize,
    row: impl Fn(&FitPoint) -> Vec<f64> + Sync,
) -> Vec<Triangle> {
    /// Most groups.
    const GROUPS: usize = 12;
    let size = diameters.len().div_ceil(GROUPS).max(1);
    threads::map(&Vec::from_iter(diameters.chunks(size)), |group| {
        let belongs = |d: f64| group.iter().any(|one| same(d, *one));
        let used = |p: &&FitPoint| p.force_n > 0.0 && belongs(p.outer_diameter_mm);
        Triangle::of_rows(terms, points.iter().filter(used).map(&row))
    })
}

/// All products of powers that the values in the table distinguish.
fn candidates(counts: [usize; 4]) -> Vec<[u8; 4]> {
    let highest = |i: usize| HIGHEST[i].min(counts[i].saturating_sub(1));
    let mut out = vec![];
    for a in 0..=highest(0) {
        for b in 0..=highest(1) {
            for c in 0..=highest(2) {
                for d in 0..=highest(3) {
                    if a + c + d <= HIGHEST_TOGETHER {
                        out.push([a, b, c, d].map(|n| n as u8));
                    }
                }
            }
        }
    }
    out
}

/// Forward selection by modified Gram–Schmidt: the order in which terms are chosen.
fn select(problem: &Triangle, most: usize) -> Vec<usize> {
    let mut columns: Vec<DVector<f64>> = problem.columns().collect();
    let lengths: Vec<f64> = columns.iter().map(DVector::norm_squared).collect();
    let mut rest = problem.values();
    let all = rest.norm_squared();
    let mut free: Vec<usize> = (0..columns.len()).collect();
    let mut chosen = vec![];
    while chosen.len() < MOST_TERMS.min(most)
        && rest.norm_squared() > MET * all
        && cancel::check().is_ok()
    {
        let gain = |&j: &usize| {
            let square = columns[j].norm_squared();
            if square > DEPENDENT * lengths[j] {
                columns[j].dot(&rest).powi(2) / square
            } else {
                0.0
            }
        };
        let best = free.iter().map(|j| (gain(j), *j)).filter(|b| b.0 > 0.0);
        // Among equals the first, so that the order does not depend on rounding of the comparison.
        let Some((_, j)) = best.reduce(|a, b| if b.0 > a.0 { b } else { a }) else {
            break;
        };
        free.retain(|&k| k != j);
        chosen.push(j);
        let unit = columns[j].normalize();
        let share = unit.dot(&rest);
        rest.axpy(-share, &unit, 1.0);
        for &k in &free {
            let share = unit.dot(&columns[k]);
            columns[k].axpy(-share, &unit, 1.0);
        }
    }
    chosen
}

/// Coefficients of the first n chosen terms, for any n, from one QR (Householder).
fn nested(problem: &Triangle, chosen: &[usize]) -> impl Fn(usize) -> Option<DVector<f64>> + use<> {
    let qr = problem.matrix.select_columns(chosen).qr();
    let r = qr.r();
    let turned = qr.q().transpose() * problem.values();
    move |n: usize| {
        let square = r.view((0, 0), (n, n)).into_owned();
        square
            .solve_upper_triangular(&turned.rows(0, n).into_owned())
            .filter(|x| x.iter().all(|v| v.is_finite()))
    }
}

/// rms over inner groups of diameters left out one at a time, by number of terms; the terms are
/// chosen anew each time.
fn leave_out(groups: &[Triangle]) -> Option<Vec<f64>> {
    if groups.len() < 4 {
        return None;
    }
    let mut sums = vec![0.0; MOST_TERMS];
    let mut rows = 0;
    let mut length = MOST_TERMS;
    for (group, out) in groups.iter().enumerate().take(groups.len() - 1).skip(1) {
        cancel::check().ok()?;
        let kept = Triangle::without(groups, Some(group));
        let chosen = select(&kept, kept.rows / 2);
        cancel::check().ok()?;
        let coefficients = nested(&kept, &chosen);
        let columns = out.matrix.select_columns(&chosen);
        length = length.min(chosen.len());
        for n in 1..=length {
            let error = columns.columns(0, n) * coefficients(n)? - out.values();
            sums[n - 1] += error.norm_squared();
        }
        rows += out.rows;
    }
    sums.truncate(length);
    Some(sums.into_iter().map(|s| (s / rows as f64).sqrt()).collect())
}

/// The smallest number of terms, of at most so many, that is as good as the best on the diameters left
/// out, by their rms with one term, two terms, …
fn enough(errors: &[f64], most: usize) -> Option<usize> {
    let errors = &errors[..most.min(errors.len())];
    let best = errors.iter().copied().fold(f64::INFINITY, f64::min);
    // Errors of rounding are all alike.
    let good = (AS_GOOD * best).max(1e-10);
    Some(1 + errors.iter().position(|e| *e <= good)?)
}
