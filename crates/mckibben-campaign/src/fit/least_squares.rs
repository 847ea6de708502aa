//! Linear least squares.

use nalgebra::{DMatrix, DVector};

/// Least squares by QR; `None` where they have no finite answer.
pub fn least_squares(matrix: DMatrix<f64>, values: DVector<f64>) -> Option<DVector<f64>> {
    let qr = matrix.qr();
    let solved = qr
        .r()
        .solve_upper_triangular(&(qr.q().transpose() * values))?;
    solved.iter().all(|v| v.is_finite()).then_some(solved)
}
