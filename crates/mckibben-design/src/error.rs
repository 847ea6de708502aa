//! Why a specification cannot be searched.

use mckibben::cancel::Cancelled;
use mckibben::muscle::MuscleError;
use thiserror::Error;

/// Why a specification cannot be searched at all.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpecError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A largest liquid volume without a liquid.
    #[error(
        "`max_liquid_volume_mm3` is {volume_mm3} mm³, and the muscle is filled with air: give `liquid`, or leave `max_liquid_volume_mm3` out"
    )]
    NoLiquid {
        /// The volume in mm³.
        volume_mm3: f64,
    },
    /// No combination is a muscle at all.
    #[error("none of the combinations is a muscle: {0}")]
    NoMuscle(MuscleError),
    /// The caller wanted the search to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
