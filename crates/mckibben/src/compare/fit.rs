//! A small fit: up to three constants of a muscle from measured points, by Levenberg–Marquardt.

use super::measured::MeasuredPoint;
use crate::least_squares::{Settings, minimise};
use crate::model::{ForceModel, ModelError};
use crate::muscle::{BraidStiffness, EndFactor, Muscle, MuscleError};
use thiserror::Error;

/// What can be fitted. All are positive and fitted by their logarithm.
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

    fn value(self, muscle: &Muscle) -> f64 {
        match self {
            Self::Modulus => 1.0,
            Self::EndFactor => muscle.terminals().end_factor.map_or(1.0, |k| k.at(0.0)),
            Self::Stiffness => muscle.family_stiffness_n_per_mm().unwrap_or(1e5),
        }
    }

    fn apply(self, muscle: &Muscle, value: f64) -> Result<Muscle, MuscleError> {
        match self {
            Self::Modulus => {
                let mut tube = muscle.tube().clone();
                tube.rubber.law = tube.rubber.law.scaled(value);
                tube.rubber.name = None;
                muscle.with_tube(tube)
            }
            Self::EndFactor => {
                let mut terminals = muscle.terminals().clone();
                terminals.end_factor = Some(EndFactor::Constant(value));
                muscle.with_terminals(terminals)
            }
            Self::Stiffness => {
                let mut braid = muscle.braid().clone();
                braid.stiffness = BraidStiffness::NewtonPerMm(value);
                muscle.with_braid(braid)
            }
        }
    }
}

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
pub fn fit<B>(
    muscle: &Muscle,
    parameters: &[FitParameter],
    points: &[MeasuredPoint],
    build: B,
) -> Result<Fit, FitError>
where
    B: Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError>,
{
    let unknowns = parameters.len();
    if points.len() < 2 * unknowns + 1 {
        return Err(FitError::TooFew { points: points.len(), unknowns });
    }
    let start: Vec<f64> = parameters.iter().map(|p| p.value(muscle)).collect();
    // Logarithms of the values over their starts.
    let values_at = |x: &[f64]| -> Vec<(FitParameter, f64)> {
        parameters
            .iter()
            .zip(&start)
            .zip(x)
            .map(|((&parameter, start), x)| (parameter, start * x.exp()))
            .collect()
    };
    let muscle_at = |x: &[f64]| -> Result<Muscle, MuscleError> {
        values_at(x)
            .into_iter()
            .try_fold(muscle.clone(), |muscle, (parameter, value)| parameter.apply(&muscle, value))
    };
    // Say why, if the start already fails.
    let first = build(&muscle_at(&vec![0.0; unknowns])?).map_err(FitError::Start)?;
    for p in points {
        first.force_n(p.pressure_mpa, p.contraction).map_err(FitError::Start)?;
    }
    let residuals = |x: &[f64]| -> Option<Vec<f64>> {
        let model = build(&muscle_at(x).ok()?).ok()?;
        points
            .iter()
            .map(|p| model.force_n(p.pressure_mpa, p.contraction).ok().map(|f| f - p.force_n))
            .collect()
    };
    let found = minimise(unknowns, Settings { step: 1e-6, tolerances: None }, residuals)
        .map_err(|error| FitError::NotConverged { reason: error.reason })?;
    let rms_n = (found.sum_of_squares / points.len() as f64).sqrt();
    Ok(Fit { muscle: muscle_at(&found.x)?, values: values_at(&found.x), rms_n })
}
