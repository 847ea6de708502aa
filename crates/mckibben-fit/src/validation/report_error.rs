//! Why there is no validation report.

use crate::identify::IdentifyError;
use crate::rubber_over_time::OverTimeFitError;
use mckibben::cancel::Cancelled;
use thiserror::Error;

/// Why there is no validation report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReportError {
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A fit that cannot be made.
    #[error("{case}, fit \"{fit}\" on {fitted_to}: {error}")]
    Fit {
        /// Folder of the case.
        case: String,
        /// Name of the fit.
        fit: String,
        /// Its points.
        fitted_to: String,
        /// Why.
        error: IdentifyError,
    },
    /// A fit of a rubber that cannot be made.
    #[error("{case}, fit \"{fit}\": {error}")]
    Rubber {
        /// Folder of the case.
        case: String,
        /// Name of the fit.
        fit: String,
        /// Why.
        error: OverTimeFitError,
    },
}
