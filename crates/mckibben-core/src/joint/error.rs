//! Why a joint has no answer.

use crate::{analysis::AnalysisError, cancel::Cancelled};
use thiserror::Error;

/// The answer of a joint, or why it has none.
pub type Result<T, E = JointError> = std::result::Result<T, E>;

/// Why a joint has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum JointError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// Not one or two muscles.
    #[error("a joint has one muscle or two, not {0}")]
    Muscles(usize),
    /// Not as many pressures as muscles.
    #[error("the joint has {muscles} muscles and takes as many pressures; {given} were given")]
    Pressures {
        /// Muscles of the joint.
        muscles: usize,
        /// Pressures that were given.
        given: usize,
    },
    /// An angle outside of the joint's limits.
    #[error("{angle_deg} deg lies outside of the joint's range of {low_deg}..{high_deg} deg")]
    Angle {
        /// The angle in degrees.
        angle_deg: f64,
        /// Lower limit in degrees.
        low_deg: f64,
        /// Upper limit in degrees.
        high_deg: f64,
    },
    /// A torque, or a stiffness together with a torque, that no pressures give.
    #[error("{message}")]
    OutOfReach {
        /// The largest that is reached.
        most: f64,
        /// What was sought, where, and what is reached there.
        message: String,
    },
    /// One muscle sets a torque or a stiffness, not both.
    #[error(
        "a joint with one muscle has one pressure: its stiffness follows from the torque and \
         cannot be set"
    )]
    OneMuscle,
    /// A muscle's model has no answer.
    #[error("muscle {muscle}: {error}")]
    Muscle {
        /// Which muscle, from 1.
        muscle: usize,
        /// Why.
        error: AnalysisError,
    },
    /// An angle of the range at which a muscle has no state.
    #[error("at {angle_deg:.1} deg of the joint's range muscle {muscle}: {error}")]
    At {
        /// The angle in degrees.
        angle_deg: f64,
        /// Which muscle, from 1.
        muscle: usize,
        /// Why.
        error: AnalysisError,
    },
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl JointError {
    /// Whether a number of a request is finite.
    pub(super) fn unless_finite(what: &str, value: f64) -> Result<()> {
        if value.is_finite() {
            Ok(())
        } else {
            Err(Self::Refused(format!(
                "the {what} is {value}, not a finite number"
            )))
        }
    }

    /// The same at an angle of the range.
    pub(super) fn at(self, angle_rad: f64) -> Self {
        match self {
            Self::Muscle { muscle, error } => Self::At {
                angle_deg: angle_rad.to_degrees(),
                muscle,
                error,
            },
            error => error,
        }
    }

    pub(super) fn in_muscle<E: Into<AnalysisError>>(muscle: usize) -> impl Fn(E) -> Self {
        move |error| Self::Muscle {
            muscle: muscle + 1,
            error: error.into(),
        }
    }

    /// Whether a muscle has no state at the pressures and the angle of the question: others may
    /// have one.
    pub fn is_of_point(&self) -> bool {
        let (Self::Muscle { error, .. } | Self::At { error, .. }) = self else {
            return false;
        };
        matches!(error, AnalysisError::Model(error) if error.is_of_point())
    }
}
