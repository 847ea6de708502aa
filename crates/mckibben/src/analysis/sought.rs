//! A pull that is sought along one variable: its value at a place, and the place between two that enclose it.

use super::ask::{force_on, response_on};
use super::error::AnalysisError;
use super::root::{RootError, find_root};
use crate::cancel;
use crate::model::{ForceModel, ModelError, Workspace, rising_root};
use crate::muscle::Direction;

/// A pressure in MPa or a contraction is known to this.
const TOLERANCE: f64 = 1e-13;
/// What is left at the place that was found, as a share of the values around it and of the pull; more is left where the pull jumps.
const LEFT: f64 = 1e-6;
const LEFT_OF_PULL: f64 = 1e-9;

/// What is varied, and what is held.
#[derive(Debug, Clone, Copy)]
pub(super) enum Along {
    /// The pressure is sought.
    Pressure { contraction: f64 },
    /// The contraction is sought.
    Contraction { pressure_mpa: f64 },
}

/// A pull that is sought.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sought {
    pub along: Along,
    pub force_n: f64,
    pub direction: Direction,
}

impl Sought {
    /// (P, ε) at a place.
    fn question(&self, x: f64) -> (f64, f64) {
        match self.along {
            Along::Pressure { contraction } => (x, contraction),
            Along::Contraction { pressure_mpa } => (pressure_mpa, x),
        }
    }

    /// F − wanted at a place; `None` where the model has no answer.
    pub fn value<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        x: f64,
    ) -> Result<Option<f64>, AnalysisError> {
        cancel::check().map_err(ModelError::from)?;
        let (p, e) = self.question(x);
        match force_on(model, workspace, p, e, self.direction) {
            Ok(force) if force.is_finite() => Ok(Some(force - self.force_n)),
            Err(error @ ModelError::Cancelled(_)) => Err(error.into()),
            _ => cancel::check().map(|()| None).map_err(|e| ModelError::from(e).into()),
        }
    }

    /// The place between `low` and `high`, (place, F − wanted) of which are on both sides of zero; `None` where the pull jumps over what is
    /// wanted, or where the model has no answer on the way, which is kept in `lost`.
    pub fn between<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        low: (f64, f64),
        high: (f64, f64),
        lost: &mut Option<ModelError>,
    ) -> Result<Option<f64>, AnalysisError> {
        let length = model.muscle().length_mm();
        // So that it rises.
        let sign = if low.1 < high.1 { 1.0 } else { -1.0 };
        let mut failed = None;
        let mut blind = false;
        let mut last = f64::INFINITY;
        let rising = |x: f64| {
            let (p, e) = self.question(x);
            let r = match response_on(model, workspace, p, e, self.direction) {
                Ok(r) => r,
                Err(error) => {
                    failed = Some(error);
                    return (f64::NAN, f64::NAN);
                }
            };
            last = r.force_n - self.force_n;
            let slope = match self.along {
                Along::Pressure { .. } => r.force_per_pressure_mm2,
                Along::Contraction { .. } => r.stiffness_n_per_mm.map(|k| -k * length),
            };
            blind |= slope.is_none();
            (sign * last, slope.map_or(f64::NAN, |slope| sign * slope))
        };
        // From where a straight line between both ends crosses zero.
        let share = if low.1.is_finite() { low.1 / (low.1 - high.1) } else { 1.0 };
        let guess = low.0 + share * (high.0 - low.0);
        let around = [low.1, high.1].into_iter().filter(|v| v.is_finite()).map(f64::abs).sum::<f64>();
        let left = (LEFT * around).max(LEFT_OF_PULL * self.force_n.abs().max(1.0));
        let found = rising_root(low.0, high.0, guess, TOLERANCE, rising);
        match (found, failed) {
            (Some(x), None) if !blind => Ok((last.abs() <= left).then_some(x)),
            (_, Some(error)) => keep(error, lost),
            // Without the model's slopes: interpolation.
            _ => self.interpolated(model, workspace, (low.0, high.0), left, lost),
        }
    }

    fn interpolated<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        (low, high): (f64, f64),
        left: f64,
        lost: &mut Option<ModelError>,
    ) -> Result<Option<f64>, AnalysisError> {
        let mut least = f64::INFINITY;
        let at = |x: f64| {
            let (p, e) = self.question(x);
            let value = force_on(model, workspace, p, e, self.direction).map(|f| f - self.force_n);
            least = value.as_ref().map_or(least, |v| least.min(v.abs()));
            value
        };
        match find_root(at, low, high, TOLERANCE) {
            Ok(x) => Ok((least <= left).then_some(x)),
            Err(RootError::Function(error)) => keep(error, lost),
            Err(RootError::NotBracketed { .. }) => Ok(None),
        }
    }
}

/// Keeps why a model had no answer; work that is to end does so.
fn keep(error: ModelError, lost: &mut Option<ModelError>) -> Result<Option<f64>, AnalysisError> {
    if let ModelError::Cancelled(_) = error {
        return Err(error.into());
    }
    *lost = Some(error);
    Ok(None)
}
