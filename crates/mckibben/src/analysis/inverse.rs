//! P(F, ε) and ε(F, P) of any model, by one way for all of them.
//!
//! 1. The model's exact inverse, where it has one ([`ForceModel::exact_pressure`]).
//! 2. Its equilibrium under the load, where it solves for one ([`ForceModel::pressure_under_load`]: finite elements).
//! 3. Else a bracket, found by steps from the lower end of the range, and inside of it Newton's method with the model's
//!    own ∂F/∂P or ∂F/∂ε, bisecting where a step would leave the bracket.
//!
//! Friction is no part of a model: with it only the third way is open.

use super::ask::{Options, force_on, friction, response_on};
use super::error::AnalysisError;
use super::root::{RootError, find_root};
use crate::model::{ForceModel, ModelError, Workspace, rising_root};
use crate::muscle::Direction;

/// Where the search for a pressure ends if the model sets no limit, in MPa.
const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// Steps in which the falling branch is searched for the first crossing.
const SCAN: usize = 80;
/// A pressure in MPa or a contraction is known to this.
const TOLERANCE: f64 = 1e-13;

/// The smallest pressure in MPa at which the pull is `force_n` at a contraction, within the model's range (with
/// `extrapolate`, up to 20 MPa).
///
/// # Errors
/// [`AnalysisError::NoPressure`] with the nearest pull there is; the model's error where it has no answer at all.
pub fn pressure_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let (lowest, limit) = model.range().pressure_mpa;
    let highest = if options.extrapolate { HIGHEST_PRESSURE_MPA } else { limit.min(HIGHEST_PRESSURE_MPA) };
    let none = |nearest_pressure_mpa: f64, nearest_force_n: f64| AnalysisError::NoPressure {
        model: model.name().into(),
        force_n,
        contraction,
        nearest_force_n,
        nearest_pressure_mpa,
    };
    let direct = match friction(model, options.direction) {
        Some(_) => None,
        None => match model.exact_pressure(force_n, contraction) {
            Some(exact) => Some(exact),
            None => model.pressure_under_load(workspace, force_n, contraction),
        },
    };
    if let Some(p) = direct {
        if p >= lowest && p <= highest {
            return Ok(p);
        }
        let end = if p < lowest { lowest } else { highest };
        return Err(none(end, model.force_n(workspace, end, contraction)?));
    }
    let direction = options.direction;
    let mut at = |p: f64| force_on(model, workspace, p, contraction, direction).map(|f| f - force_n);
    // Where there is no equilibrium without pressure, the search starts below any pull.
    let first = match at(lowest) {
        Ok(first) => first,
        Err(error @ (ModelError::OutOfRange { .. } | ModelError::Geometry { .. })) => {
            return Err(error.into());
        }
        Err(_) => f64::NEG_INFINITY,
    };
    if first.abs() <= 1e-12 * force_n.abs().max(1.0) {
        return Ok(lowest);
    }
    if first > 0.0 {
        return Err(none(lowest, first + force_n));
    }
    // Upwards in growing steps to the first pressure that pulls enough.
    let (mut low, mut best) = ((lowest, first), (lowest, first));
    let mut step = (0.02 * highest.min(1.0)).max(1e-6);
    while low.0 < highest {
        let high = (low.0 + step).min(highest);
        match at(high) {
            Ok(f) if f >= 0.0 => {
                let sought = Sought { along: Along::Pressure { contraction }, force_n, direction };
                return sought.between(model, workspace, low, (high, f));
            }
            Ok(f) => {
                if f > best.1 {
                    best = (high, f);
                }
                low = (high, f);
                step *= 1.5;
            }
            // Past the last equilibrium: close in on it.
            Err(_) if high - low.0 > 1e-9 => step = 0.25 * (high - low.0),
            Err(_) => break,
        }
    }
    if best.1 == f64::NEG_INFINITY {
        at(lowest)?;
    }
    Err(none(best.0, best.1 + force_n))
}

/// The contraction at which the pull is `force_n` at a pressure: the smallest on the falling branch that starts at ε = 0.
///
/// # Errors
/// [`AnalysisError::NoContraction`] for a pull above the blocked force, or one the model still exceeds at the end of its
/// range, with the nearest pull there is.
pub fn contraction_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let range = model.range().contraction;
    let lowest = range.0.max(0.0);
    // Past the ideal maximum nothing pulls; a strand that stretches reaches a little further.
    let natural = (model.muscle().max_ideal_contraction() * 1.3 + 0.05).min(0.95);
    let highest = if options.extrapolate { natural } else { range.1.min(natural.max(range.0)) };
    let none = |nearest_contraction: f64, nearest_force_n: f64| AnalysisError::NoContraction {
        model: model.name().into(),
        force_n,
        pressure_mpa,
        nearest_force_n,
        nearest_contraction,
    };
    let direction = options.direction;
    let blocked = force_on(model, workspace, pressure_mpa, lowest, direction)? - force_n;
    if blocked.abs() <= 1e-12 * force_n.abs().max(1.0) {
        return Ok(lowest);
    }
    if blocked < 0.0 {
        return Err(none(lowest, blocked + force_n));
    }
    if friction(model, direction).is_none() {
        let direct = model
            .exact_contraction(force_n, pressure_mpa)
            .or_else(|| model.contraction_under_load(workspace, force_n, pressure_mpa));
        if let Some(e) = direct.filter(|e| *e >= lowest && *e <= highest) {
            return Ok(e);
        }
    }
    let (mut low, mut nearest) = ((lowest, blocked), (lowest, blocked));
    for i in 1..=SCAN {
        let high = lowest + (highest - lowest) * i as f64 / SCAN as f64;
        match force_on(model, workspace, pressure_mpa, high, direction).map(|f| f - force_n) {
            Ok(f) if f <= 0.0 => {
                let sought = Sought { along: Along::Contraction { pressure_mpa }, force_n, direction };
                return sought.between(model, workspace, low, (high, f));
            }
            Ok(f) => {
                if f < nearest.1 {
                    nearest = (high, f);
                }
                low = (high, f);
            }
            Err(_) => break,
        }
    }
    Err(none(nearest.0, nearest.1 + force_n))
}

/// What is varied, and what is held.
#[derive(Debug, Clone, Copy)]
enum Along {
    /// The pressure is sought; F rises with it.
    Pressure { contraction: f64 },
    /// The contraction is sought; F falls with it.
    Contraction { pressure_mpa: f64 },
}

/// A pull that is sought between two places.
struct Sought {
    along: Along,
    force_n: f64,
    direction: Direction,
}

impl Sought {
    /// (P, ε) at a place.
    fn question(&self, x: f64) -> (f64, f64) {
        match self.along {
            Along::Pressure { contraction } => (x, contraction),
            Along::Contraction { pressure_mpa } => (pressure_mpa, x),
        }
    }

    /// The place between `low` and `high`, (place, F − wanted) of which are on both sides of zero.
    fn between<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        low: (f64, f64),
        high: (f64, f64),
    ) -> Result<f64, AnalysisError> {
        let length = model.muscle().length_mm();
        let mut failed = None;
        let mut blind = false;
        let rising = |x: f64| {
            let (p, e) = self.question(x);
            let r = match response_on(model, workspace, p, e, self.direction) {
                Ok(r) => r,
                Err(error) => {
                    failed = Some(error);
                    return (f64::NAN, f64::NAN);
                }
            };
            let rest = r.force_n - self.force_n;
            // Both so that they rise.
            let (value, slope) = match self.along {
                Along::Pressure { .. } => (rest, r.force_per_pressure_mm2),
                Along::Contraction { .. } => (-rest, r.stiffness_n_per_mm.map(|k| k * length)),
            };
            blind |= slope.is_none();
            (value, slope.unwrap_or(f64::NAN))
        };
        // From where a straight line between both ends crosses zero.
        let share = if low.1.is_finite() { low.1 / (low.1 - high.1) } else { 1.0 };
        let guess = low.0 + share * (high.0 - low.0);
        let found = rising_root(low.0, high.0, guess, TOLERANCE, rising);
        match (found, failed) {
            (Some(x), None) if !blind => Ok(x),
            (_, Some(error)) => Err(error.into()),
            // Without the model's slopes: interpolation.
            _ => self.interpolated(model, workspace, low.0, high.0),
        }
    }

    fn interpolated<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        low: f64,
        high: f64,
    ) -> Result<f64, AnalysisError> {
        let at = |x: f64| {
            let (p, e) = self.question(x);
            force_on(model, workspace, p, e, self.direction).map(|f| f - self.force_n)
        };
        find_root(at, low, high, TOLERANCE).map_err(|error| match error {
            RootError::Function(error) => error.into(),
            RootError::NotBracketed { low, .. } => {
                let (pressure_mpa, contraction) = self.question(low);
                ModelError::NotConverged { pressure_mpa, contraction, iterations: 0, residual: f64::NAN }
                    .into()
            }
        })
    }
}
