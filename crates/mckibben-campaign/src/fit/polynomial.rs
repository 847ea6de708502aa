//! Polynomials of one variable by least squares.

use nalgebra::{DMatrix, DVector};

/// A fitted polynomial of degree N − 1, highest power first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolynomialFit<const N: usize> {
    /// Coefficients, of the highest power first.
    pub coefficients: [f64; N],
    /// R² = 1 − Σ(y − ŷ)²/Σ(y − ȳ)²; 1 where all y are the same and met.
    pub r2: f64,
}

impl<const N: usize> PolynomialFit<N> {
    pub fn at(&self, x: f64) -> f64 {
        self.coefficients.iter().fold(0.0, |sum, c| sum * x + c)
    }
}

/// Σ (y − ŷ)² → min over ŷ = c₁ xᴺ⁻¹ + … + c_N, by QR of the matrix in x/max|x|. `None` for fewer than N points, or
/// points that do not determine it.
pub fn fit<const N: usize>(points: &[(f64, f64)]) -> Option<PolynomialFit<N>> {
    let scale = points.iter().map(|p| p.0.abs()).fold(0.0, f64::max);
    if points.len() < N || N == 0 || !(scale > 0.0 || N == 1) {
        return None;
    }
    let scale = if scale > 0.0 { scale } else { 1.0 };
    let power = |j: usize| i32::try_from(N - 1 - j).unwrap_or(0);
    let matrix = DMatrix::from_fn(points.len(), N, |i, j| (points[i].0 / scale).powi(power(j)));
    let values = DVector::from_iterator(points.len(), points.iter().map(|p| p.1));
    let qr = matrix.qr();
    let solved = qr.r().solve_upper_triangular(&(qr.q().transpose() * values))?;
    let mut coefficients = [0.0; N];
    for (j, c) in coefficients.iter_mut().enumerate() {
        *c = solved[j] / scale.powi(power(j));
    }
    if coefficients.iter().any(|c| !c.is_finite()) {
        return None;
    }
    let mut fitted = PolynomialFit { coefficients, r2: 1.0 };
    let mean = points.iter().map(|p| p.1).sum::<f64>() / points.len() as f64;
    let left: f64 = points.iter().map(|p| (p.1 - fitted.at(p.0)).powi(2)).sum();
    let all: f64 = points.iter().map(|p| (p.1 - mean).powi(2)).sum();
    if all > 0.0 {
        fitted.r2 = 1.0 - left / all;
    }
    Some(fitted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_free_polynomials_come_back() {
        let points: Vec<(f64, f64)> =
            [30.0, 40.0, 45.0, 50.0].iter().map(|&x| (x, (-12.079 * x + 1122.2) * x - 26214.0)).collect();
        let f = fit::<3>(&points).unwrap();
        for (c, exact) in f.coefficients.iter().zip([-12.079, 1122.2, -26214.0]) {
            assert!((c / exact - 1.0).abs() < 1e-11, "{c} {exact}");
        }
        assert!((f.r2 - 1.0).abs() < 1e-14);
        assert!(fit::<3>(&points[..2]).is_none());
        assert!(fit::<2>(&[(0.0, 1.0), (0.0, 2.0)]).is_none());
        assert!(fit::<2>(&[(1.0, 1.0), (1.0, f64::NAN)]).is_none());
    }

    /// y = 1, 2, 4 at x = 0, 1, 2: slope 3/2, intercept 5/6, R² = 1 − (1/6)/(14/3) = 27/28.
    #[test]
    fn a_line_through_three_points_by_hand() {
        let f = fit::<2>(&[(0.0, 1.0), (1.0, 2.0), (2.0, 4.0)]).unwrap();
        assert!((f.coefficients[0] - 1.5).abs() < 1e-14 && (f.coefficients[1] - 5.0 / 6.0).abs() < 1e-14);
        assert!((f.r2 - 27.0 / 28.0).abs() < 1e-14);
    }
}
