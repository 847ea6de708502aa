//! Formulas from tables: the paper's seven steps, one least-squares problem, and the ends of
//! muscles of every make.

pub mod constants;
pub mod data;
pub mod errors;
pub mod global;
pub mod held_out;
mod make;
pub mod paper_method;
pub mod results;
pub mod signs;
pub mod tables;
pub mod universal;

pub use global::{GlobalFit, global};
pub use make::{FittedFormula, Method, Request, fitted, made_for, make};
use mckibben::cancel::Cancelled;
use nalgebra::{DMatrix, DVector};
pub use paper_method::{PaperMethod, Rules, SlackRule, ThinRule, paper_method};
use thiserror::Error;

type Result<T, E = FitError> = std::result::Result<T, E>;

/// Why a table gives no formula.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl FitError {
    pub(crate) fn empty(place: &str) -> Self {
        Self::Refused(format!("the table has no point with an answer{place}"))
    }

    pub(crate) fn mixed_make(part: &str) -> Self {
        Self::Refused(format!(
            "the table mixes muscles of different {part}; a formula covers only one: fit them \
             separately"
        ))
    }

    pub(crate) fn varies(column: &str) -> Self {
        Self::Refused(format!(
            "in the table {column} varies, which is not a variable of the formula; fit a table in \
             which it is constant"
        ))
    }

    /// Least squares without a finite answer.
    pub(crate) fn singular(place: impl std::fmt::Display) -> Self {
        Self::Refused(format!("least squares have no finite answer for {place}"))
    }
}

/// Least squares by QR; `None` where they have no finite answer.
fn least_squares(matrix: DMatrix<f64>, values: DVector<f64>) -> Option<DVector<f64>> {
    let qr = matrix.qr();
    let solved = qr
        .r()
        .solve_upper_triangular(&(qr.q().transpose() * values))?;
    solved.iter().all(|v| v.is_finite()).then_some(solved)
}
