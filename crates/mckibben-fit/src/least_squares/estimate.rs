//! Constants from data with their standard errors, and those that the data do not determine.
//!
//! With the residuals rᵢ in units of one (or of their stated error), weights wᵢ, and J = ∂r/∂x at
//! the minimum,
//!
//!   s² = Σ w r²/(n − m),   cov x = s² (JᵀWJ)⁻¹
//!
//! with n points and m unknowns that are not on a bound (Seber & Wild 2003 \[seber2003\], ch. 2).
//! The half-width of a 95 % interval is t(n − m) √covᵢᵢ.

use super::{Unknown, t95};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use mckibben_core::{cancel, extremes::peak};
use nalgebra::{DMatrix, DVector, Dyn, Owned};
use std::cell::RefCell;
use thiserror::Error;

/// The residual of every point as a function of the unknowns.
pub trait Residuals {
    /// One number a point; `None` where the model has no answer.
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>>;

    /// ∂r/∂x, one column an unknown, where the model has it; else central differences are taken.
    fn by_unknowns(&self, _x: &[f64]) -> Option<Vec<Vec<f64>>> {
        None
    }
}

impl<F: Fn(&[f64]) -> Option<Vec<f64>>> Residuals for F {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self(x)
    }
}

/// A minimum with its statistics.
#[derive(Debug, PartialEq)]
pub struct Estimate {
    /// The unknowns at the minimum.
    pub x: Vec<f64>,
    /// Standard errors; infinite where the data do not determine the unknown at all, 0 on a bound.
    pub standard_errors: Vec<f64>,
    /// Half-widths of the 95 % intervals (Student's t); likewise.
    pub half_widths: Vec<f64>,
    /// Whether it lies on a bound.
    pub at_bound: Vec<bool>,
    /// r of every point, not weighted.
    pub residuals: Vec<f64>,
    /// Σ w r².
    pub squares: f64,
}

/// Why there is no estimate.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum EstimateError {
    /// Numbers that make no unknown.
    #[error(
        "unknown {index} cannot be fitted: its start {} and its bounds {} to {} must be numbers in \
         order, and its scale {} above zero",
        .unknown.start, .unknown.low, .unknown.high, .unknown.scale
    )]
    Unsound {
        /// Its place.
        index: usize,
        /// The numbers.
        unknown: Unknown,
    },
    /// Not more points than unknowns.
    #[error("{points} points do not determine {unknowns} unknowns: at least {} are needed, and \
        more for a meaningful error bar", .unknowns + 1)]
    TooFew {
        /// Points with a weight.
        points: usize,
        /// Those that vary.
        unknowns: usize,
    },
    /// No answer of the model at the start.
    #[error("the model has no answer at the start for one of the points")]
    Start,
    /// The iteration ended without a minimum.
    #[error("no minimum was found: {reason}")]
    NoMinimum {
        /// Why.
        reason: String,
        /// The unknowns where it ended.
        at: Vec<f64>,
    },
}

/// Residuals and slopes with the last results: a search, the check of its end and the statistics
/// need the same values.
struct Known<'a> {
    residuals: &'a dyn Residuals,
    at: Answers<Vec<f64>>,
    by: Answers<Vec<Vec<f64>>>,
}

/// Unknowns with their results.
type Answers<T> = RefCell<Vec<(Vec<f64>, Option<T>)>>;

/// So many: the best and the steps tried from it.
const KNOWN: usize = 4;

/// The result at x, computed where it is not known.
fn remembered<T: Clone>(
    list: &Answers<T>,
    x: &[f64],
    compute: impl FnOnce() -> Option<T>,
) -> Option<T> {
    if let Some((_, known)) = list.borrow().iter().find(|(known, _)| known == x) {
        return known.clone();
    }
    let value = compute();
    let mut list = list.borrow_mut();
    list.truncate(KNOWN - 1);
    list.insert(0, (x.to_vec(), value.clone()));
    value
}

impl Residuals for Known<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        remembered(&self.at, x, || self.residuals.residuals_at(x))
    }

    fn by_unknowns(&self, x: &[f64]) -> Option<Vec<Vec<f64>>> {
        remembered(&self.by, x, || self.residuals.by_unknowns(x))
    }
}

struct Inner<'a> {
    residuals: &'a dyn Residuals,
    unknowns: &'a [Unknown],
    roots: DVector<f64>,
    u: DVector<f64>,
    /// The residual of every point where the model has no answer.
    wall: Option<f64>,
}

impl Inner<'_> {
    fn x(&self, u: &DVector<f64>) -> Vec<f64> {
        self.unknowns
            .iter()
            .zip(u.iter())
            .map(|(k, &u)| k.outer(u).0)
            .collect()
    }

    /// Unknowns with a smaller sum of squares beside the end of a search, where that is no minimum;
    /// or that the model has no answer where it falls. It is searched along the Gauss–Newton step,
    /// J δ = −r in the least squares, in the unknowns that lie on no bound: none further than its
    /// scale.
    fn beside(&self) -> Result<Option<DVector<f64>>, &'static str> {
        let at = |u: &DVector<f64>| {
            self.residuals
                .residuals_at(&self.x(u))
                .map(|r| self.weighted(r))
        };
        let Some((mut j, r)) = self.jacobian().zip(at(&self.u)) else {
            return Ok(None);
        };
        let x = self.x(&self.u);
        for (k, (unknown, &x)) in self.unknowns.iter().zip(&x).enumerate() {
            if unknown.is_at_bound(x) {
                j.column_mut(k).fill(0.0);
            }
        }
        let svd = j.clone().svd(true, true);
        let largest = peak(svd.singular_values.iter().copied());
        let Ok(step) = svd.solve(&-&r, 1e-10 * largest) else {
            return Ok(None);
        };
        let in_scales = |(k, unknown): (usize, &Unknown)| {
            (unknown.outer(self.u[k]).1 * step[k] / unknown.scale).abs()
        };
        let far = peak(self.unknowns.iter().enumerate().map(in_scales));
        if far <= STEP || (&j * &step).norm_squared() <= SMALLER * r.norm_squared() {
            return Ok(None);
        }
        let step = step / far.max(1.0);
        let mut answers = true;
        for share in SHARES {
            let u = &self.u + share * &step;
            let residuals = at(&u);
            answers = residuals.is_some();
            if residuals
                .is_some_and(|next| next.norm_squared() < (1.0 - SMALLER) * r.norm_squared())
            {
                return Ok(Some(u));
            }
        }
        if answers { Ok(None) } else { Err(NO_ANSWER) }
    }

    fn weighted(&self, residuals: Vec<f64>) -> DVector<f64> {
        DVector::from_vec(residuals).component_mul(&self.roots)
    }

    /// At the minimum. Where the model has no answer in places, the steps may shrink to nothing
    /// before it: a new search begins with long ones.
    fn minimum(mut self) -> Result<Self, EstimateError> {
        let search = LevenbergMarquardt::new()
            .with_ftol(1e-13)
            .with_xtol(1e-11)
            .with_gtol(1e-13)
            .with_patience(100);
        let mut searches = 0;
        loop {
            let (ended, report) = search.minimize(self);
            self = ended;
            searches += 1;
            let reason = match report.termination {
                TerminationReason::User(_) => NO_ANSWER,
                TerminationReason::LostPatience => NOT_CONVERGED,
                // Where no step makes it smaller it is the minimum within the rounding of the model.
                end if end.was_successful()
                    || matches!(end, TerminationReason::NoImprovementPossible(_)) =>
                {
                    match self.beside() {
                        Ok(None) => return Ok(self),
                        Ok(Some(u)) if searches < SEARCHES => {
                            self.u = u;
                            continue;
                        }
                        Ok(Some(_)) => NOT_CONVERGED,
                        Err(reason) => reason,
                    }
                }
                _ => "the data do not determine the unknowns, or the model is not smooth",
            };
            return Err(EstimateError::NoMinimum {
                reason: reason.into(),
                at: self.x(&self.u),
            });
        }
    }
}

/// ∂r/∂x, one column an unknown, not weighted: of the model, or by central differences.
pub fn slopes(residuals: &dyn Residuals, unknowns: &[Unknown], x: &[f64]) -> Option<Vec<Vec<f64>>> {
    if let Some(columns) = residuals.by_unknowns(x) {
        return Some(columns);
    }
    let column = |i: usize| {
        let unknown = &unknowns[i];
        let h = 1e-5 * unknown.scale;
        let mut up = x.to_vec();
        let mut down = x.to_vec();
        up[i] = (x[i] + h).min(unknown.high);
        down[i] = (x[i] - h).max(unknown.low);
        let a = residuals.residuals_at(&up)?;
        let b = residuals.residuals_at(&down)?;
        let width = up[i] - down[i];
        Some(a.iter().zip(&b).map(|(a, b)| (a - b) / width).collect())
    };
    (0..x.len()).map(column).collect()
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Inner<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, u: &DVector<f64>) {
        self.u.copy_from(u);
    }

    fn params(&self) -> DVector<f64> {
        self.u.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        // Not even a wall: the iteration ends.
        cancel::check().ok()?;
        match self.residuals.residuals_at(&self.x(&self.u)) {
            Some(r) => Some(self.weighted(r)),
            // A step to where the model has no answer is a bad step: the next one is shorter.
            None => self
                .wall
                .map(|wall| DVector::from_element(self.roots.len(), wall)),
        }
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let columns = slopes(self.residuals, self.unknowns, &self.x(&self.u))?;
        let mut j = DMatrix::zeros(self.roots.len(), self.u.len());
        for (c, column) in columns.iter().enumerate() {
            let slope = self.unknowns[c].outer(self.u[c]).1;
            for (r, v) in column.iter().enumerate() {
                j[(r, c)] = v * slope * self.roots[r];
            }
        }
        Some(j)
    }
}

const NO_ANSWER: &str = "the model has no answer near the best values found";
const NOT_CONVERGED: &str = "the search did not converge; free fewer unknowns";
/// Searches at most, each from where the one before has ended beside a minimum.
const SEARCHES: usize = 4;
/// A step may make the sum of squares smaller by this share at a minimum.
const SMALLER: f64 = 1e-4;
/// The same of a step in an unknown, in its scale.
const STEP: f64 = 1e-6;
/// Shares of the step that are tried.
const SHARES: [f64; 5] = [1.0, 0.3, 0.1, 0.01, 0.001];

/// The unknowns that make the sum of squares small, with their errors. `weights` has one number ≥ 0 a
/// point.
pub fn estimate(
    residuals: &dyn Residuals,
    unknowns: &[Unknown],
    weights: &[f64],
) -> Result<Estimate, EstimateError> {
    if let Some(index) = unknowns.iter().position(|u| !u.is_sound()) {
        return Err(EstimateError::Unsound {
            index,
            unknown: unknowns[index],
        });
    }
    let points = weights.iter().filter(|w| **w > 0.0).count();
    if points <= unknowns.len() {
        return Err(EstimateError::TooFew {
            points,
            unknowns: unknowns.len(),
        });
    }
    let start = unknowns.iter().map(Unknown::inner_start);
    let mut inner = Inner {
        residuals: &Known {
            residuals,
            at: RefCell::default(),
            by: RefCell::default(),
        },
        unknowns,
        roots: DVector::from_iterator(weights.len(), weights.iter().map(|w| w.sqrt())),
        u: DVector::from_iterator(unknowns.len(), start),
        wall: None,
    };
    let start = inner.residuals().ok_or(EstimateError::Start)?;
    inner.wall = Some(1e3 * (1.0 + start.amax()));
    statistics(&inner.minimum()?, weights, points).ok_or(EstimateError::Start)
}

/// Weighted sizes of residuals, and 1.4826 times the median of those that count.
pub fn robust_deviation(r: &[f64], weights: &[f64]) -> (Vec<f64>, f64) {
    let scaled: Vec<f64> = r
        .iter()
        .zip(weights)
        .map(|(r, w)| r.abs() * w.sqrt())
        .collect();
    let mut sorted: Vec<f64> = scaled
        .iter()
        .zip(weights)
        .filter(|p| *p.1 > 0.0)
        .map(|p| *p.0)
        .collect();
    sorted.sort_by(f64::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    (scaled, 1.4826 * median)
}

/// The errors of the unknowns at a minimum.
fn statistics(inner: &Inner<'_>, weights: &[f64], points: usize) -> Option<Estimate> {
    let x = inner.x(&inner.u);
    let unknowns = inner.unknowns;
    let residuals = inner.residuals.residuals_at(&x)?;
    let columns = slopes(inner.residuals, unknowns, &x)?;
    let at_bound: Vec<bool> = unknowns
        .iter()
        .zip(&x)
        .map(|(u, &x)| u.is_at_bound(x))
        .collect();
    let inside: Vec<usize> = (0..x.len()).filter(|&i| !at_bound[i]).collect();
    let freedom = points.saturating_sub(inside.len()).max(1);
    let squares: f64 = residuals.iter().zip(weights).map(|(r, w)| w * r * r).sum();
    let deviation = (squares / freedom as f64).sqrt();
    // Columns in units of the scales, so that singular values compare.
    let j = DMatrix::from_fn(weights.len(), inside.len(), |r, c| {
        columns[inside[c]][r] * weights[r].sqrt() * unknowns[inside[c]].scale
    });
    let mut standard_errors = vec![0.0; x.len()];
    // Every unknown may lie on a bound; an empty matrix has no decomposition.
    if !inside.is_empty() {
        let svd = j.svd(false, true);
        let v = svd.v_t?;
        let largest = peak(svd.singular_values.iter().copied());
        for (a, &i) in inside.iter().enumerate() {
            let mut variance = 0.0_f64;
            for (k, &sigma) in svd.singular_values.iter().enumerate() {
                if sigma > 1e-10 * largest && sigma > 0.0 {
                    variance += v[(k, a)] * v[(k, a)] / (sigma * sigma);
                } else if v[(k, a)].abs() > 1e-3 {
                    variance = f64::INFINITY;
                }
            }
            standard_errors[i] = if variance.is_finite() {
                deviation * unknowns[i].scale * variance.sqrt()
            } else {
                variance
            };
        }
    }
    Some(Estimate {
        half_widths: standard_errors.iter().map(|s| t95(freedom) * s).collect(),
        x,
        standard_errors,
        at_bound,
        residuals,
        squares,
    })
}

#[cfg(test)]
mod tests;
