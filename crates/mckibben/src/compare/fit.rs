//! A small fit: up to three constants of a muscle from measured points, by Levenberg–Marquardt.

use super::measured::MeasuredPoint;
use crate::model::{ForceModel, ModelError};
use crate::muscle::{BraidStiffness, EndFactor, Muscle, MuscleError};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};
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

struct Problem<'a, B> {
    muscle: &'a Muscle,
    parameters: &'a [FitParameter],
    start: Vec<f64>,
    points: &'a [MeasuredPoint],
    build: &'a B,
    x: DVector<f64>,
}

impl<B> Problem<'_, B>
where
    B: Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError>,
{
    fn muscle_at(&self, x: &DVector<f64>) -> Result<Muscle, MuscleError> {
        let mut muscle = self.muscle.clone();
        for ((parameter, start), x) in self.parameters.iter().zip(&self.start).zip(x.iter()) {
            muscle = parameter.apply(&muscle, start * x.exp())?;
        }
        Ok(muscle)
    }

    fn residuals_at(&self, x: &DVector<f64>) -> Option<DVector<f64>> {
        let model = (self.build)(&self.muscle_at(x).ok()?).ok()?;
        let list: Option<Vec<f64>> = self
            .points
            .iter()
            .map(|p| model.force_n(p.pressure_mpa, p.contraction).ok().map(|f| f - p.force_n))
            .collect();
        list.map(DVector::from_vec)
    }
}

impl<B> LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_, B>
where
    B: Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError>,
{
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.x.copy_from(x);
    }

    fn params(&self) -> DVector<f64> {
        self.x.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.residuals_at(&self.x)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        const H: f64 = 1e-6;
        let columns: Option<Vec<DVector<f64>>> = (0..self.x.len())
            .map(|i| {
                let (mut up, mut down) = (self.x.clone(), self.x.clone());
                up[i] += H;
                down[i] -= H;
                Some((self.residuals_at(&up)? - self.residuals_at(&down)?) / (2.0 * H))
            })
            .collect();
        columns.map(|c| DMatrix::from_columns(&c))
    }
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
    let problem = Problem {
        muscle,
        parameters,
        start: parameters.iter().map(|p| p.value(muscle)).collect(),
        points,
        build: &build,
        x: DVector::zeros(unknowns),
    };
    // Say why, if the start already fails.
    let first = build(&problem.muscle_at(&problem.x)?).map_err(FitError::Start)?;
    for p in points {
        first.force_n(p.pressure_mpa, p.contraction).map_err(FitError::Start)?;
    }
    let (problem, report) = LevenbergMarquardt::new().with_patience(50).minimize(problem);
    if !report.termination.was_successful() {
        return Err(FitError::NotConverged { reason: format!("{:?}", report.termination) });
    }
    let values: Vec<(FitParameter, f64)> = parameters
        .iter()
        .zip(&problem.start)
        .zip(problem.x.iter())
        .map(|((&parameter, start), x)| (parameter, start * x.exp()))
        .collect();
    let rms_n = (2.0 * report.objective_function / points.len() as f64).sqrt();
    Ok(Fit { muscle: problem.muscle_at(&problem.x)?, values, rms_n })
}
