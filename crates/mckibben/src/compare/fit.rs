//! A small fit: up to three constants of a muscle from measured points, as [`crate::identify`] does it.

use super::measured::MeasuredPoint;
use crate::identify::{Build, DataPoint, IdentifyError, Parameter, Request, Target, identify, own_value};
use crate::least_squares::Loss;
use crate::model::ModelError;
use crate::muscle::{Muscle, MuscleError};
use thiserror::Error;

/// What can be fitted. All are positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FitParameter {
    /// One factor on all moduli of the rubber law.
    Modulus,
    /// The end factor of the terminals.
    EndFactor,
    /// Stiffness of a strand family.
    Stiffness,
}

impl FitParameter {
    /// Words a user writes.
    pub const NAMES: [(&'static str, FitParameter); 3] =
        [("modulus", Self::Modulus), ("end-factor", Self::EndFactor), ("stiffness", Self::Stiffness)];

    /// The word for it.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|n| n.1 == self).map_or("", |n| n.0)
    }

    fn target(self) -> Target {
        match self {
            Self::Modulus => Target::Modulus,
            Self::EndFactor => Target::EndFactor,
            Self::Stiffness => Target::Stiffness,
        }
    }
}

/// k in N/mm from which the search begins where the strands do not stretch.
const STIFF: f64 = 1e5;

/// The outcome of a fit.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The muscle with the fitted constants.
    pub muscle: Muscle,
    /// Fitted values: a factor on the moduli, an end factor, a stiffness in N/mm.
    pub values: Vec<(FitParameter, f64)>,
    /// Root mean square of the residuals in N.
    pub rms_n: f64,
}

/// Why a fit failed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Fewer points than twice the unknowns.
    #[error("{points} points are too few to fit {unknowns} constants: measure at least {}", 2 * .unknowns + 1)]
    TooFew {
        /// Points given.
        points: usize,
        /// Constants asked for.
        unknowns: usize,
    },
    /// Points that no muscle of this size gives.
    #[error("{0}")]
    Data(String),
    /// The model fails at the starting values.
    #[error("the model has no answer at the starting values: {0}")]
    Start(ModelError),
    /// The constants ran away or the iteration stopped early.
    #[error("the fit did not converge: {reason}")]
    NotConverged {
        /// Why it stopped.
        reason: String,
    },
    /// Fitted values that make no muscle.
    #[error(transparent)]
    Muscle(#[from] MuscleError),
}

/// Fits constants of `muscle` so that the model made by `build` comes closest to the points (least squares of the force).
///
/// # Errors
/// [`FitError`].
pub fn fit<B: Build>(
    muscle: &Muscle,
    parameters: &[FitParameter],
    points: &[MeasuredPoint],
    build: B,
) -> Result<Fit, FitError> {
    let unknowns = parameters.len();
    if points.len() < 2 * unknowns + 1 {
        return Err(FitError::TooFew { points: points.len(), unknowns });
    }
    let parameter = |p: &FitParameter| Parameter {
        start: Some(own_value(muscle, p.target()).unwrap_or(STIFF)),
        ..Parameter::free(p.target())
    };
    let free: Vec<Parameter> = parameters.iter().map(parameter).collect();
    // The model knows its branch; all points count, zeros among them.
    let points: Vec<DataPoint> =
        points.iter().map(|p| DataPoint::of(MeasuredPoint { branch: None, ..*p })).collect();
    let request =
        Request { muscle, free: &free, fixed: &[], points: &points, loss: Loss::Squares, two_sided: true };
    let found = identify(&request, build).map_err(|error| match error {
        IdentifyError::Start { error, .. } | IdentifyError::Model(error) => FitError::Start(error),
        IdentifyError::Implausible(sentence) => FitError::Data(sentence),
        IdentifyError::Muscle(error) => FitError::Muscle(error),
        other => FitError::NotConverged { reason: other.to_string() },
    })?;
    let values = parameters.iter().copied().zip(found.parameters.iter().map(|p| p.value)).collect();
    Ok(Fit { muscle: found.muscle, values, rms_n: found.rms_n })
}
