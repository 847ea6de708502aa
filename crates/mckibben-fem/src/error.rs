//! Why there is no answer.

use crate::solver::newton::{LastConverged, Stopped};
use mckibben_core::{cancel::Cancelled, model::ModelError, muscle::Ends, size, status::Status};
use thiserror::Error;

/// An answer, or why there is none.
pub type Result<T, E = FemError> = std::result::Result<T, E>;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FemError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A question that is no number, a pressure that is not finite, a contraction of 1 or more.
    #[error(
        "no muscle has a pressure of {pressure_mpa}\u{a0}MPa and a contraction of {contraction}"
    )]
    Question {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// The path to the answer ended before it.
    #[error("{}", ended(self))]
    Path {
        /// How: not converged, collapsed, or on another branch.
        status: Status,
        /// Required pressure in MPa.
        pressure_mpa: f64,
        /// Required contraction.
        contraction: f64,
        /// Why the last step was given up.
        reason: Stopped,
        /// Newton iterations done in all.
        iterations: usize,
        /// The last equilibrium.
        last: LastConverged,
        /// Pull in N of an equilibrium on another branch.
        other_n: Option<f64>,
    },
    /// Ends whose slip was not found.
    #[error(
        "no slip of the ends was found at {pressure_mpa}\u{a0}MPa and contraction {contraction} in \
         {} steps: take a smaller terminals.slip",
        Ends::STEPS
    )]
    Ends {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// No pressure or contraction gives the force.
    #[error("no equilibrium with a pull of {force_n}\u{a0}N was found{}", of_muscle(.reason))]
    Force {
        /// Required pull in N.
        force_n: f64,
        /// Why the search ended.
        reason: Stopped,
    },
    /// A pull beyond all that the muscle reaches at a pressure.
    #[error("{}", out_of_reach(*.force_n, *.pressure_mpa, *.nearest_force_n, *.contraction))]
    OutOfReach {
        /// Required pull in N.
        force_n: f64,
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// The nearest pull of an equilibrium, in N.
        nearest_force_n: f64,
        /// Contraction of that pull; below zero the muscle is stretched.
        contraction: f64,
    },
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A mesh of more elements or bytes than are allowed.
    #[error(transparent)]
    Large(#[from] size::TooLarge),
}

impl FemError {
    pub(crate) fn too_large(unknowns: usize) -> Self {
        Self::Refused(format!(
            "mesh: there is not enough memory for {unknowns} unknowns; take fewer elements"
        ))
    }

    /// Refuses a measure of a mesh that does not lie between two values.
    pub(crate) fn check_mesh(name: &str, value: f64, low: f64, high: f64) -> Result<(), Self> {
        let refused = || {
            Self::Refused(format!(
                "mesh: {name} is {value}; it must lie between {low} and {high}"
            ))
        };
        (low..=high)
            .contains(&value)
            .then_some(())
            .ok_or_else(refused)
    }

    /// Why a tube is not in equilibrium on its plugs.
    pub(crate) fn on_plugs(reason: Stopped) -> Self {
        match reason {
            Stopped::Cancelled(cancelled) => Self::Cancelled(cancelled),
            reason => Self::Refused(format!(
                "terminals.plug_diameter: {reason} as the tube is drawn on its plugs; take plugs \
                 nearer to the bore"
            )),
        }
    }

    /// Why there is no equilibrium with a pull in N; that the caller wanted to end is no property
    /// of that pull.
    pub(crate) fn at_force(force_n: f64, reason: Stopped) -> Self {
        match reason {
            Stopped::Cancelled(cancelled) => Self::Cancelled(cancelled),
            reason => Self::Force { force_n, reason },
        }
    }
}

/// A reason that lies in the muscle; how a search ended tells its user nothing.
fn of_muscle(reason: &Stopped) -> String {
    match reason {
        Stopped::Inverted | Stopped::NotFinite => format!(": {reason}"),
        _ => String::new(),
    }
}

fn ended(path: &FemError) -> String {
    let FemError::Path {
        status,
        pressure_mpa,
        contraction,
        reason,
        last,
        other_n,
        ..
    } = path
    else {
        return String::new();
    };
    let percent = |contraction: f64| (1e4 * contraction).round() / 1e2;
    let point = format!(
        "at {pressure_mpa}\u{a0}MPa and a contraction of {} %",
        percent(*contraction)
    );
    let begins = match (status, other_n) {
        (_, Some(force)) => format!(
            "no equilibrium found on the branch of the taut muscle {point} (one on another branch \
             has a pull of {force:.1}\u{a0}N)"
        ),
        (Status::Collapsed, None) => {
            format!("no equilibrium found {point} (the tube may have collapsed)")
        }
        _ => format!("no equilibrium found {point}"),
    };
    let because = of_muscle(reason);
    let last_mpa = last.pressure_mpa;
    let at = percent(last.contraction);
    let followed = if last_mpa > 0.0 || last.contraction != 0.0 {
        format!(
            "; on the way there from rest, the last one is at {last_mpa:.4}\u{a0}MPa and {at} %"
        )
    } else {
        String::new()
    };
    let advice = match status {
        // Pressure holds the wall out.
        Status::Collapsed if *pressure_mpa <= last_mpa => {
            "raise the pressure, or lower the contraction"
        }
        // No sleeve contracts further.
        _ if *contraction >= 0.4 => "lower the pressure or the contraction",
        _ => "lower the pressure or the contraction, or take stiffer strands",
    };
    format!("{begins}{because}{followed}; {advice}")
}

fn out_of_reach(force: f64, pressure: f64, nearest: f64, contraction: f64) -> String {
    let percent = 100.0 * contraction.abs();
    let nearest = (10.0 * nearest).round() / 10.0;
    if force > nearest {
        format!(
            "rubber and strands cannot carry a pull of {force}\u{a0}N at {pressure}\u{a0}MPa: \
             stretched by {percent:.0} % of its length, as far as an equilibrium was found, the \
             muscle pulls with {nearest}\u{a0}N"
        )
    } else {
        format!(
            "no equilibrium with a pull of {force}\u{a0}N exists at {pressure}\u{a0}MPa: shortened \
             by {percent:.0} % of its length, as far as an equilibrium was found, the muscle still \
             pulls with {nearest}\u{a0}N"
        )
    }
}

/// The same as an error of the library's models.
impl From<FemError> for ModelError {
    fn from(error: FemError) -> Self {
        match error {
            FemError::Question { contraction, .. } => Self::Geometry {
                contraction,
                lowest: -1.0,
                highest: 1.0,
            },
            FemError::Path { status, .. } => Self::Stopped {
                status,
                reason: error.to_string(),
            },
            FemError::Refused(_) | FemError::Large(_) => Self::Elements(error.to_string()),
            FemError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            FemError::Force { .. } | FemError::OutOfReach { .. } | FemError::Ends { .. } => {
                Self::NoEquilibrium(error.to_string())
            }
        }
    }
}
