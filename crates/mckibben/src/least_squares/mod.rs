//! Nonlinear least squares (Levenberg–Marquardt).
//!
//! The one place that speaks to the library which does it; fits of constants elsewhere hand over their residuals.
//! [`minimise`] seeks a minimum and nothing else; [`estimate`] knows bounds, weights and outliers, takes derivatives where
//! the model has them, and says how well the data tell each unknown.

mod bounds;
mod estimate;
mod student;

pub use bounds::Unknown;
pub use estimate::{Estimate, EstimateError, Loss, Residuals, estimate};
pub use student::t95;

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};
use thiserror::Error;

/// How a minimum is sought.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Settings {
    /// Step of the central differences.
    pub step: f64,
    /// Relative change of the sum of squares, and of the unknowns, below which it ends; the smallest sensible where `None`.
    pub tolerances: Option<(f64, f64)>,
}

/// A minimum.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimum {
    /// The unknowns.
    pub x: Vec<f64>,
    /// Sum of the squared residuals.
    pub sum_of_squares: f64,
}

/// The iteration ended without a minimum.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{reason}")]
pub struct NoMinimum {
    /// Why.
    pub reason: String,
}

struct Problem<F> {
    residuals: F,
    step: f64,
    x: DVector<f64>,
}

impl<F: Fn(&[f64]) -> Option<Vec<f64>>> Problem<F> {
    fn at(&self, x: &DVector<f64>) -> Option<DVector<f64>> {
        (self.residuals)(x.as_slice()).map(DVector::from_vec)
    }
}

impl<F: Fn(&[f64]) -> Option<Vec<f64>>> LeastSquaresProblem<f64, Dyn, Dyn> for Problem<F> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.x.copy_from(x);
    }

    fn params(&self) -> DVector<f64> {
        self.x.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.at(&self.x)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let column = |i: usize| {
            let (mut up, mut down) = (self.x.clone(), self.x.clone());
            up[i] += self.step;
            down[i] -= self.step;
            Some((self.at(&up)? - self.at(&down)?) / (2.0 * self.step))
        };
        let columns: Option<Vec<DVector<f64>>> = (0..self.x.len()).map(column).collect();
        columns.map(|c| DMatrix::from_columns(&c))
    }
}

/// Minimises the sum of squares of `residuals` over so many unknowns, which start from zero. `residuals` answers `None`
/// where it has no value.
///
/// # Errors
/// [`NoMinimum`] with the reason.
pub fn minimise(
    unknowns: usize,
    settings: Settings,
    residuals: impl Fn(&[f64]) -> Option<Vec<f64>>,
) -> Result<Minimum, NoMinimum> {
    let problem = Problem { residuals, step: settings.step, x: DVector::zeros(unknowns) };
    let mut method = LevenbergMarquardt::new().with_patience(50);
    if let Some((squares, x)) = settings.tolerances {
        method = method.with_ftol(squares).with_xtol(x);
    }
    let (problem, report) = method.minimize(problem);
    if report.termination.was_successful() {
        Ok(Minimum { x: problem.x.as_slice().to_vec(), sum_of_squares: 2.0 * report.objective_function })
    } else {
        Err(NoMinimum { reason: format!("{:?}", report.termination) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock (1960): minimum 0 at (1, 1).
    #[test]
    fn rosenbrocks_valley_is_followed_to_its_end() {
        let valley = |x: &[f64]| Some(vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]);
        let found = minimise(2, Settings { step: 1e-6, tolerances: None }, valley).unwrap();
        assert!((found.x[0] - 1.0).abs() < 1e-7 && (found.x[1] - 1.0).abs() < 1e-7, "{found:?}");
        assert!(found.sum_of_squares < 1e-14);
        assert!(minimise(1, Settings { step: 1e-6, tolerances: None }, |_| None).is_err());
    }
}
