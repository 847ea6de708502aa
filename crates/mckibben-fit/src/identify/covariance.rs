//! R = D + L Lᵀ: what each point has alone, and what points share.
//!
//! A whole R of n points needs n² numbers; a logged bench has ten thousands of points. Errors that
//! are smooth over pressure and contraction have few columns L: those of a Cholesky decomposition
//! at the points where most is left, until what is left is below one part in 10¹⁰ of the noise
//! (`harbrecht2012`). With M = D^(−1/2) L,
//!
//! ```text
//! R⁻¹B = D^(−1/2) [I − M (I + MᵀM)⁻¹ Mᵀ] D^(−1/2) B      (`woodbury1950`)
//! ```

use mckibben_core::progress::Progress;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// What is left over the noise.
const LEFT: f64 = 1e-10;
/// A column beyond this share of the largest variance is rounding.
const ROUNDING: f64 = 1e-14;

pub struct Covariance {
    /// D^(−1/2).
    weights: DVector<f64>,
    /// M.
    shared: DMatrix<f64>,
    /// Of I + MᵀM.
    root: Cholesky<f64, Dyn>,
}

impl Covariance {
    /// Of points with the variances that each has alone, above zero, and the covariance that two
    /// share; `None` where a number is none, or the caller has left.
    pub fn new(
        variances: &DVector<f64>,
        shared: impl Fn(usize, usize) -> f64,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let n = variances.len();
        let mut left = DVector::from_fn(n, |i, _| shared(i, i));
        let least = (LEFT * variances.min()).max(ROUNDING * left.max());
        let mut columns: Vec<DVector<f64>> = vec![];
        while columns.len() < n {
            let (pivot, most) = left.argmax();
            if most.is_infinite() {
                return None;
            }
            if most <= least {
                break;
            }
            progress.check().ok()?;
            let mut column = DVector::from_fn(n, |i, _| shared(i, pivot));
            for known in &columns {
                column.axpy(-known[pivot], known, 1.0);
            }
            column /= most.sqrt();
            left -= column.component_mul(&column);
            left[pivot] = 0.0;
            columns.push(column);
        }
        let weights = variances.map(|v| v.sqrt().recip());
        let of = columns.len();
        let shared = DMatrix::from_fn(n, of, |i, k| columns[k][i] * weights[i]);
        let root = (DMatrix::identity(of, of) + shared.tr_mul(&shared)).cholesky()?;
        Some(Self {
            weights,
            shared,
            root,
        })
    }

    /// R⁻¹ B.
    pub fn solve(&self, mut b: DMatrix<f64>) -> DMatrix<f64> {
        let weigh = |b: &mut DMatrix<f64>| {
            for mut column in b.column_iter_mut() {
                column.component_mul_assign(&self.weights);
            }
        };
        weigh(&mut b);
        b -= &self.shared * self.root.solve(&self.shared.tr_mul(&b));
        weigh(&mut b);
        b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mckibben_core::progress::Silent;

    /// Distances of points on a line, and a term that all share.
    fn of_two(i: usize, j: usize) -> f64 {
        let apart = (i as f64 - j as f64) / 40.0;
        900.0 * (-apart * apart).exp() + 25.0
    }

    fn known(of: usize) -> (DVector<f64>, DMatrix<f64>) {
        let variances = DVector::from_fn(of, |i, _| 1.0 + (i % 7) as f64);
        let b = DMatrix::from_fn(of, 3, |i, k| ((i + 5) * (k + 2) % 11) as f64 - 4.0);
        (variances, b)
    }

    #[test]
    fn identity_the_covariance_times_its_solution_is_what_was_asked() {
        for of in [1, 2, 60, 300] {
            let (variances, b) = known(of);
            let covariance = Covariance::new(&variances, of_two, &Silent).unwrap();
            assert!(
                covariance.shared.ncols() <= 40,
                "{}",
                covariance.shared.ncols()
            );
            let whole = DMatrix::from_diagonal(&variances) + DMatrix::from_fn(of, of, of_two);
            let back = whole * covariance.solve(b.clone());
            assert!((back - &b).amax() < 1e-6 * b.amax(), "{of}");
        }
    }

    #[test]
    fn a_number_that_is_none_has_no_covariance() {
        for (wrong, value) in [(0, f64::NAN), (3, f64::NAN), (3, f64::INFINITY)] {
            let (variances, _) = known(9);
            let of = |i: usize, j: usize| {
                if i == wrong || j == wrong {
                    value
                } else {
                    of_two(i, j)
                }
            };
            assert!(Covariance::new(&variances, of, &Silent).is_none());
        }
        let (variances, _) = known(0);
        assert!(Covariance::new(&variances, of_two, &Silent).is_some());
    }
}
