//! Why there is no motion.

use mckibben_core::{cancel::Cancelled, model::ModelError, muscle::MuscleError, size::TooLarge};
use thiserror::Error;

/// A motion, or why there is none.
pub type Result<T, E = MotionError> = std::result::Result<T, E>;

/// Why a motion was refused, or ended early.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A muscle that no drive moves.
    #[error(transparent)]
    Muscle(#[from] MuscleError),
    /// A liquid that boils.
    #[error("{0}; raise the pressure, or move the load more slowly")]
    Boils(String),
    /// No answer exists, as far as was looked: why, with its values.
    #[error("{0}")]
    NoAnswer(String),
    /// The load never leaves its stop.
    #[error(
        "the load is never lifted: the largest net force from the stop was {net} (N, or N mm about \
         a joint) at {time_s} s, at most {pressure_mpa}\u{a0}MPa; raise the pressure, take a \
         larger muscle or a smaller load",
        net = .0.net, time_s = .0.time_s, pressure_mpa = .0.pressure_mpa
    )]
    NeverLifted(#[doc(hidden)] OnStop),
    /// A model has no answer on the way.
    #[error(
        "the motion ends at {time_s} s, muscle {muscle} at {pressure_mpa}\u{a0}MPa and contraction \
         {contraction}: {error}"
    )]
    Model {
        /// When.
        time_s: f64,
        /// Which muscle, from 1.
        muscle: usize,
        /// Its gauge pressure in MPa.
        pressure_mpa: f64,
        /// Its contraction.
        contraction: f64,
        /// The model's reason.
        error: Box<ModelError>,
    },
    /// Not a number, without bounds, steps that go to nothing, too many of them, or events without
    /// time in between: when, and the values.
    #[error("{0}")]
    Diverged(String),
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// More points than are allowed.
    #[error(transparent)]
    Large(
        #[doc(hidden)]
        #[from]
        TooLarge,
    ),
}

/// The largest net force off a stop, while a load lies on it from the start on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnStop {
    /// The net force away from the stop (negative).
    pub net: f64,
    /// When it was, in s.
    pub time_s: f64,
    /// Gauge pressure of the first muscle there, in MPa.
    pub pressure_mpa: f64,
}

impl MotionError {
    /// A model's refusal at a time, of a muscle counted from 0.
    pub fn model(
        error: ModelError,
        time_s: f64,
        muscle: usize,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Self {
        match error {
            ModelError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => Self::Model {
                time_s,
                muscle: muscle + 1,
                pressure_mpa,
                contraction,
                error: Box::new(error),
            },
        }
    }

    /// That there is no equilibrium at the start.
    pub fn no_equilibrium(position: f64, net: f64) -> Self {
        Self::NoAnswer(format!(
            "no equilibrium at the start: at a position of {position} the net force is {net} (N, \
             or N mm about a joint), and it does not change its sign up to there; change the load \
             or the first command, or give a stop"
        ))
    }

    pub(crate) fn diverged(time_s: f64, what: &str) -> Self {
        Self::Diverged(format!("the motion diverges at {time_s} s ({what})"))
    }

    /// That a number cannot be.
    pub fn value(what: &str, value: f64, must: &str) -> Self {
        Self::Refused(format!("{what} is {value}; it must be {must}"))
    }

    /// Refused with a sentence where something does not hold.
    pub fn require(holds: bool, why: impl FnOnce() -> String) -> Result<(), Self> {
        holds.then_some(()).ok_or_else(|| Self::Refused(why()))
    }

    pub(crate) fn positive(what: &'static str, value: f64) -> Result<(), Self> {
        if value.is_finite() && value > 0.0 {
            Ok(())
        } else {
            Err(Self::value(what, value, "above zero"))
        }
    }

    /// Whether what was computed up to here is an answer: the motion ended early, and not because
    /// of the request.
    pub fn ends_early(&self) -> bool {
        matches!(
            self,
            Self::Model { .. } | Self::Boils(_) | Self::Diverged(_)
        )
    }
}

pub fn within(what: &'static str, value: f64, low: f64, high: f64) -> Result<()> {
    if value >= low && value <= high {
        return Ok(());
    }
    let must = if high >= f64::MAX {
        format!("at least {low}")
    } else {
        format!("from {low} to {high}")
    };
    Err(MotionError::value(what, value, &must))
}
