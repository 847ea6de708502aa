//! Why parts do not make a muscle.

use crate::refused::Refused;
use crate::rubber::LawError;
use crate::rubber::over_time::OverTimeError;
use crate::sleeve::SleeveError;
use std::borrow::Cow;
use thiserror::Error;

/// What is wrong with a muscle.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MuscleError {
    /// A value, or values together; the fields are keys as in the muscle file.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A wall that leaves no bore.
    #[error(
        "tube.wall_thickness is {wall_mm} mm, but the radius is {radius_mm} mm: the wall must be thinner than the radius (half of tube.outer_diameter)"
    )]
    WallTooThick {
        /// Wall in mm.
        wall_mm: f64,
        /// Outer radius in mm.
        radius_mm: f64,
    },
    /// Rubber constants that make no law.
    #[error("tube.material: {0}")]
    Rubber(#[from] LawError),
    /// Softening constants that make no rubber.
    #[error("tube.material.softening: {0}")]
    Softening(OverTimeError),
    /// A series that makes no rubber.
    #[error("tube.material.prony: {0}")]
    Relaxation(OverTimeError),
    /// A named sleeve that is not known, does not fit, or does not say enough.
    #[error("braid: {0}")]
    Sleeve(#[from] SleeveError),
}

impl MuscleError {
    /// Values that make no muscle, the likeliest key first.
    pub(crate) fn refused(
        fields: impl IntoIterator<Item = &'static str>,
        message: impl Into<String>,
    ) -> Self {
        Self::Refused(Refused { fields: fields.into_iter().collect(), message: message.into() })
    }

    /// The keys of the muscle file that can be at fault, the likeliest first.
    pub fn keys(&self) -> Vec<Cow<'static, str>> {
        let keys: Vec<&'static str> = match self {
            MuscleError::Refused(refused) => refused.fields.clone(),
            MuscleError::WallTooThick { .. } => vec!["tube.wall_thickness", "tube.outer_diameter"],
            MuscleError::Rubber(error) => {
                let constant = error.constant().map(|name| Cow::from(format!("tube.material.{name}")));
                return constant.into_iter().chain(["tube.material".into()]).collect();
            }
            MuscleError::Softening(_) => vec!["tube.material.softening"],
            MuscleError::Relaxation(_) => vec!["tube.material.prony"],
            MuscleError::Sleeve(SleeveError::Diameter(_)) => {
                vec!["braid.name", "tube.outer_diameter"]
            }
            MuscleError::Sleeve(_) => vec!["braid.name"],
        };
        keys.into_iter().map(Cow::from).collect()
    }
}

/// That a value with its unit must be something else. A key may carry an explanation behind it: "terminals.end_factor at 0 MPa (a + b)".
pub(super) fn must(key: &'static str, value: f64, unit: &str, must: &str) -> MuscleError {
    let field = key.split(' ').next().unwrap_or(key);
    let of_model = match field {
        "terminals.end_factor" => Some("model.tondu-lopez.end_factor"),
        "terminals.cone_factor" => Some("model.conical-ends.cone_factor"),
        _ => None,
    };
    let given = format!("{value} {unit}");
    MuscleError::refused(
        [field].into_iter().chain(of_model),
        format!("{key} is {}; it must {must}", given.trim_end()),
    )
}

pub(super) fn positive(key: &'static str, value: f64, unit: &'static str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value > 0.0;
    if fine { Ok(()) } else { Err(must(key, value, unit, "be above zero and finite")) }
}

pub(super) fn not_negative(key: &'static str, value: f64, unit: &'static str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value >= 0.0;
    if fine { Ok(()) } else { Err(must(key, value, unit, "not be below zero, and finite")) }
}
