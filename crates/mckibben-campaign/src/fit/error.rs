//! Why a table gives no formula.

use mckibben_core::cancel::Cancelled;
use thiserror::Error;

pub type Result<T, E = FitError> = std::result::Result<T, E>;

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
            "the table mixes muscles of different {part}; this method covers only one: fit them \
             separately, or all by the method universal"
        ))
    }

    pub(crate) fn varies(column: &str) -> Self {
        Self::Refused(format!(
            "in the table {column} varies, which is not a variable of the formula; fit a table in \
             which it is constant"
        ))
    }

    pub(crate) fn extends(angle_deg: f64) -> Self {
        Self::Refused(format!(
            "muscles of {angle_deg} deg extend and push, and formulas are of pulls: vary angles \
             below 54.7 deg"
        ))
    }

    pub(crate) fn of_one(quantity: &str) -> Self {
        Self::Refused(format!(
            "the method universal needs muscles of many makes, and these are of one {quantity}: \
             vary it in the plan, or fit muscles of one make by the method global"
        ))
    }

    /// Refuses a formula that is further off than zero would be: a pull is a share of the blocked
    /// force between 0 and 1, and so is what zero misses.
    pub(crate) fn refuse_absurd(rms: f64) -> Result<()> {
        if rms <= 1.0 {
            return Ok(());
        }
        let percent = 100.0 * rms;
        Err(Self::Refused(format!(
            "the formula misses its points by {percent:.3e} % of the blocked force (rms): \
             its table has forces of no muscle"
        )))
    }

    /// Least squares without a finite answer.
    pub(crate) fn singular(place: impl std::fmt::Display) -> Self {
        Self::Refused(format!("least squares have no finite answer for {place}"))
    }
}
