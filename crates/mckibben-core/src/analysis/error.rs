//! Why a question about a model has no answer.

use crate::{
    cancel::Cancelled, model::ModelError, refused::Refused, status::Status, units::trimmed as short,
};
use thiserror::Error;

/// The answer to a question about a model, or why it has none.
pub type Result<T, E = AnalysisError> = std::result::Result<T, E>;

/// Why a question about a model has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AnalysisError {
    /// The model itself has none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// No pressure gives this pull at this contraction.
    #[error("{}", no_pressure(model, *.force_n, *.contraction, (*.nearest_pressure_mpa, *.nearest_force_n), *.braid_stops_at))]
    NoPressure {
        /// The model's name.
        model: String,
        /// The pull wanted, in N.
        force_n: f64,
        /// At this contraction.
        contraction: f64,
        /// The nearest pull there is, in N.
        nearest_force_n: f64,
        /// The pressure it needs, in MPa.
        nearest_pressure_mpa: f64,
        /// The contraction at which the braid stops (its angle reaches 54.7°), where that is why
        /// the muscle does not pull.
        braid_stops_at: Option<f64>,
    },
    /// No contraction gives this pull at this pressure.
    #[error("{}", no_contraction(model, *.force_n, *.pressure_mpa, (*.nearest_contraction, *.nearest_force_n), *.at_rest_n))]
    NoContraction {
        /// The model's name.
        model: String,
        /// The pull wanted, in N.
        force_n: f64,
        /// At this pressure in MPa.
        pressure_mpa: f64,
        /// The nearest pull there is, in N.
        nearest_force_n: f64,
        /// The contraction it has.
        nearest_contraction: f64,
        /// The pull in N at the length at rest, where the model answers there.
        at_rest_n: Option<f64>,
    },
    /// A question with a number that is not finite.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// What was found is a pull of broken strands.
    #[error(
        "{}\u{a0}N at {}\u{a0}MPa and a contraction of {} break the strands: one of them carries \
         {}\u{a0}N, and its strength is {}\u{a0}N",
        short(*.force_n, 1), short(*.pressure_mpa, 4), percent(*.contraction),
        short(*.tension_n, 1), short(*.strength_n, 1)
    )]
    StrandsBreak {
        /// The pull in N.
        force_n: f64,
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
        /// Tension of a strand in N.
        tension_n: f64,
        /// Its strength in N.
        strength_n: f64,
    },
    /// The model does not know a quantity that the question needs.
    #[error("the {model} model does not give {quantity}")]
    Unknown {
        /// The model's name.
        model: String,
        /// What is missing.
        quantity: &'static str,
    },
}

impl From<Cancelled> for AnalysisError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Model(cancelled.into())
    }
}

impl AnalysisError {
    /// Where the pull is nearest to the one that is sought, and that pull in N.
    pub(crate) fn nearest(&self) -> Option<(f64, f64)> {
        match *self {
            Self::NoPressure {
                nearest_pressure_mpa,
                nearest_force_n,
                ..
            } => Some((nearest_pressure_mpa, nearest_force_n)),
            Self::NoContraction {
                nearest_contraction,
                nearest_force_n,
                ..
            } => Some((nearest_contraction, nearest_force_n)),
            _ => None,
        }
    }
}

fn percent(contraction: f64) -> String {
    format!("{} %", short(100.0 * contraction, 2))
}

fn no_pressure(
    model: &str,
    force_n: f64,
    contraction: f64,
    (nearest_mpa, nearest_n): (f64, f64),
    braid_stops_at: Option<f64>,
) -> String {
    let force = short(force_n, 4);
    let at = percent(contraction);
    let problem = format!("no pressure gives {force}\u{a0}N at a contraction of {at}");
    match braid_stops_at {
        Some(end) => format!(
            "{problem}: this braid contracts by {:.1} % at most (its angle is 54.7° there, and the \
             pull is zero); reduce the contraction, or take a braid with a smaller angle",
            100.0 * end
        ),
        None if nearest_n <= 0.0 && force_n > 0.0 => format!(
            "{problem}: at that contraction the muscle is slack at every pressure that the {model} \
             model accepts; reduce the contraction"
        ),
        None => format!(
            "{problem}: the nearest the {model} model reaches is {}\u{a0}N at {}\u{a0}MPa",
            short(nearest_n, 4),
            short(nearest_mpa, 6)
        ),
    }
}

fn no_contraction(
    model: &str,
    force_n: f64,
    pressure_mpa: f64,
    (nearest, nearest_n): (f64, f64),
    at_rest_n: Option<f64>,
) -> String {
    let force = short(force_n, 4);
    let at = short(pressure_mpa, 6);
    let problem = format!("no contraction gives {force}\u{a0}N at {at}\u{a0}MPa");
    let rest = match at_rest_n {
        Some(f) if nearest < 0.0 => format!(
            "at its length at rest it pulls {}\u{a0}N, and ",
            short(f, 1)
        ),
        _ => String::new(),
    };
    format!(
        "{problem}: {rest}the nearest the {model} model reaches is {}\u{a0}N at a contraction of {}",
        short(nearest_n, 4),
        percent(nearest)
    )
}

impl From<&ModelError> for Status {
    fn from(error: &ModelError) -> Self {
        match error {
            ModelError::OutOfRange { .. } | ModelError::Burst { .. } => Self::OutOfRange,
            ModelError::NotConverged { .. } => Self::NotConverged,
            ModelError::Stopped { status, .. } => *status,
            _ => Self::NoAnswer,
        }
    }
}

impl From<&AnalysisError> for Status {
    fn from(error: &AnalysisError) -> Self {
        match error {
            AnalysisError::Model(error) => error.into(),
            _ => Self::NoAnswer,
        }
    }
}
