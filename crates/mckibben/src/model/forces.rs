//! Lists of pulls: what may be wrong with them.

use super::paper_batch::same;
use super::{LengthMismatch, ModelError};
use thiserror::Error;

/// Why a list of pulls is not complete.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ForcesError {
    /// Lists of different length.
    #[error(transparent)]
    Length(#[from] LengthMismatch),
    /// A point without an answer.
    #[error("point {index}: {error}")]
    Point {
        /// Its place in the lists, from 0.
        index: usize,
        /// Why.
        error: ModelError,
    },
}

/// That the lists have the length of the output.
pub(crate) fn same_length(
    pressures_mpa: &[f64],
    contractions: &[f64],
    out: &[f64],
) -> Result<(), LengthMismatch> {
    same(out.len(), &[("pressures_mpa", pressures_mpa.len()), ("contractions", contractions.len())])
}

/// That the pulls of a formula are numbers, which they are not where a pressure or contraction is none.
pub(crate) fn check_finite(
    model: &str,
    pressures_mpa: &[f64],
    contractions: &[f64],
    out: &[f64],
) -> Result<(), ForcesError> {
    // A count goes through many numbers at a time, a search through one.
    if out.iter().map(|f| u64::from(!f.is_finite())).sum::<u64>() == 0 {
        return Ok(());
    }
    let Some(index) = out.iter().position(|f| !f.is_finite()) else { return Ok(()) };
    let at = |list: &[f64]| list.get(index).copied().unwrap_or(f64::NAN);
    let (pressure_mpa, contraction) = (at(pressures_mpa), at(contractions));
    let error = ModelError::NotFinite { model: model.into(), pressure_mpa, contraction };
    Err(ForcesError::Point { index, error })
}
