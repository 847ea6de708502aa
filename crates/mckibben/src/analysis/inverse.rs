//! P(F, ε) and ε(F, P) of any model.

use super::error::AnalysisError;
use super::root::{RootError, find_root};
use crate::model::{ForceModel, ModelError, Workspace};

/// Where the search for a pressure ends if the model sets no limit, in MPa.
const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// Steps in which the falling branch is searched for the first crossing.
const SCAN: usize = 80;

/// The smallest pressure in MPa at which the pull is `force_n` at a contraction.
///
/// Takes the model's closed form where there is one, else a safeguarded search between the ends of the model's
/// pressure range (with `extrapolate`, up to 20 MPa).
///
/// # Errors
/// [`AnalysisError::NoPressure`] with the nearest pull there is; the model's error where it has no answer at all.
pub fn pressure_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    extrapolate: bool,
) -> Result<f64, AnalysisError> {
    let (lowest, limit) = model.range().pressure_mpa;
    let highest = if extrapolate { HIGHEST_PRESSURE_MPA } else { limit.min(HIGHEST_PRESSURE_MPA) };
    let none = |nearest_pressure_mpa: f64, nearest_force_n: f64| AnalysisError::NoPressure {
        model: model.name().into(),
        force_n,
        contraction,
        nearest_force_n,
        nearest_pressure_mpa,
    };
    if let Some(closed) = model.pressure_in_closed_form(workspace, force_n, contraction) {
        let p = closed?;
        if p >= lowest && p <= highest {
            return Ok(p);
        }
        let end = if p < lowest { lowest } else { highest };
        return Err(none(end, model.force_n(workspace, end, contraction)?));
    }
    let mut at = |p: f64| model.force_n(workspace, p, contraction).map(|f| f - force_n);
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
    let (mut low, mut best) = (lowest, (lowest, first));
    let mut step = (0.02 * highest.min(1.0)).max(1e-6);
    while low < highest {
        let high = (low + step).min(highest);
        match at(high) {
            Ok(f) if f >= 0.0 => return bracketed(at, low, high),
            Ok(f) => {
                if f > best.1 {
                    best = (high, f);
                }
                low = high;
                step *= 1.5;
            }
            // Past the last equilibrium: close in on it.
            Err(_) if high - low > 1e-9 => step = 0.25 * (high - low),
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
    extrapolate: bool,
) -> Result<f64, AnalysisError> {
    let range = model.range().contraction;
    let lowest = range.0.max(0.0);
    // Past the ideal maximum nothing pulls; a strand that stretches reaches a little further.
    let natural = (model.muscle().max_ideal_contraction() * 1.3 + 0.05).min(0.95);
    let highest = if extrapolate { natural } else { range.1.min(natural.max(range.0)) };
    let none = |nearest_contraction: f64, nearest_force_n: f64| AnalysisError::NoContraction {
        model: model.name().into(),
        force_n,
        pressure_mpa,
        nearest_force_n,
        nearest_contraction,
    };
    let mut at = |e: f64| model.force_n(workspace, pressure_mpa, e).map(|f| f - force_n);
    let blocked = at(lowest)?;
    if blocked.abs() <= 1e-12 * force_n.abs().max(1.0) {
        return Ok(lowest);
    }
    if blocked < 0.0 {
        return Err(none(lowest, blocked + force_n));
    }
    if let Some(Ok(e)) = model.contraction_in_closed_form(workspace, force_n, pressure_mpa)
        && e >= lowest
        && e <= highest
    {
        return Ok(e);
    }
    let mut at = |e: f64| model.force_n(workspace, pressure_mpa, e).map(|f| f - force_n);
    let mut nearest = (lowest, blocked);
    let mut low = lowest;
    for i in 1..=SCAN {
        let high = lowest + (highest - lowest) * i as f64 / SCAN as f64;
        match at(high) {
            Ok(f) if f <= 0.0 => return bracketed(at, low, high),
            Ok(f) => {
                if f < nearest.1 {
                    nearest = (high, f);
                }
                low = high;
            }
            Err(_) => break,
        }
    }
    Err(none(nearest.0, nearest.1 + force_n))
}

fn bracketed(
    at: impl FnMut(f64) -> Result<f64, ModelError>,
    low: f64,
    high: f64,
) -> Result<f64, AnalysisError> {
    find_root(at, low, high, 1e-13).map_err(|e| match e {
        RootError::Function(error) => error.into(),
        RootError::NotBracketed { low, .. } => ModelError::NotConverged {
            pressure_mpa: low,
            contraction: low,
            iterations: 0,
            residual: f64::NAN,
        }
        .into(),
    })
}
