//! Linear least squares.

use mckibben_core::cancel;
use nalgebra::{DMatrix, DVector};

/// Least squares by QR; `None` where they have no finite answer.
pub fn least_squares(matrix: DMatrix<f64>, values: DVector<f64>) -> Option<DVector<f64>> {
    let qr = matrix.qr();
    let solved = qr
        .r()
        .solve_upper_triangular(&(qr.q().transpose() * values))?;
    solved.iter().all(|v| v.is_finite()).then_some(solved)
}

/// The rows of a problem, terms | value, as the triangle R of their QR decomposition: its columns
/// have the same lengths and angles, so that nothing else is needed, however many rows there are
/// (J. Demmel, L. Grigori, M. Hoemmen, J. Langou, SIAM J. Sci. Comput. 34, A206, 2012).
#[derive(Clone)]
pub struct Triangle {
    /// Of the terms, and in the last column of the values.
    pub matrix: DMatrix<f64>,
    /// How many rows it stands for.
    pub rows: usize,
}

impl Triangle {
    pub fn none(terms: usize) -> Self {
        Self {
            matrix: DMatrix::zeros(0, terms + 1),
            rows: 0,
        }
    }

    /// Of rows that are made one after the other; of no more, where the work is to end.
    pub fn of_rows(terms: usize, rows: impl Iterator<Item = Vec<f64>>) -> Self {
        /// Rows of a matrix.
        const ROWS: usize = 2048;
        let mut rows = rows.peekable();
        let mut sum = Self::none(terms);
        while rows.peek().is_some() && cancel::check().is_ok() {
            let some: Vec<_> = rows.by_ref().take(ROWS).collect();
            sum = sum.and(&Self {
                matrix: DMatrix::from_fn(some.len(), terms + 1, |i, j| some[i][j]),
                rows: some.len(),
            });
        }
        sum
    }

    /// The problem of the rows of both.
    pub fn and(&self, other: &Self) -> Self {
        let (above, below) = (self.matrix.nrows(), other.matrix.nrows());
        let columns = other.matrix.ncols();
        let mut both = self.matrix.clone().resize(above + below, columns, 0.0);
        both.view_mut((above, 0), (below, columns))
            .copy_from(&other.matrix);
        Self {
            matrix: if above + below > columns {
                both.qr().r()
            } else {
                both
            },
            rows: self.rows + other.rows,
        }
    }

    /// Of all groups but one.
    pub fn without(groups: &[Self], left_out: Option<usize>) -> Self {
        groups
            .iter()
            .enumerate()
            .filter(|(group, _)| Some(*group) != left_out)
            .fold(Self::none(0), |sum, (_, group)| sum.and(group))
    }

    fn terms(&self) -> usize {
        self.matrix.ncols() - 1
    }

    pub fn columns(&self) -> impl Iterator<Item = DVector<f64>> {
        (0..self.terms()).map(|j| self.matrix.column(j).into_owned())
    }

    pub fn values(&self) -> DVector<f64> {
        self.matrix.column(self.terms()).into_owned()
    }

    /// The coefficients; `None` where they have no finite answer.
    pub fn solve(&self) -> Option<DVector<f64>> {
        least_squares(
            self.matrix.columns(0, self.terms()).into_owned(),
            self.values(),
        )
    }
}
