//! Why a specification cannot be searched.

use mckibben::cancel::Cancelled;
use mckibben::muscle::MuscleError;
use thiserror::Error;

/// Why a specification cannot be searched at all.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpecError {
    /// No operating point.
    #[error(
        "no operating point: give `force_n` and `contraction`, or `points`, each a pull at a contraction, or a load that pulls"
    )]
    NoPoint,
    /// A pull or contraction that is no operating point.
    #[error(
        "the operating point {force_n} N at a contraction of {contraction} is invalid: the pull must be above 0 N and the contraction from 0 to below 1; for a push of a muscle that extends, the force below 0 N and the contraction from above -1 to 0"
    )]
    Point {
        /// Pull in N.
        force_n: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// An invalid torque or angle.
    #[error(
        "{torque_nm} N m at {angle_deg}° is invalid: the torque must be above zero and the angle within ±{largest_deg}°"
    )]
    Torque {
        /// Torque in N m.
        torque_nm: f64,
        /// Angle in degrees.
        angle_deg: f64,
        /// Largest angle in degrees.
        largest_deg: f64,
    },
    /// A table that ends before the stroke does.
    #[error(
        "the load is known for shortenings from {low_mm} to {high_mm} mm, and the stroke goes from 0 to {stroke_mm} mm"
    )]
    LoadReach {
        /// From, in mm.
        low_mm: f64,
        /// To, in mm.
        high_mm: f64,
        /// The stroke in mm.
        stroke_mm: f64,
    },
    /// A pressure that is not above zero.
    #[error("the maximum pressure is {0} MPa; it must be above zero")]
    Pressure(f64),
    /// A bound that is not above zero.
    #[error("{name} is {value}; it must be above zero")]
    Bound {
        /// Which bound.
        name: &'static str,
        /// Its value.
        value: f64,
    },
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
    /// Too many combinations.
    #[error("{0:.3e} combinations are too many; at most 5 million: take larger steps or fewer values")]
    TooMany(f64),
}
