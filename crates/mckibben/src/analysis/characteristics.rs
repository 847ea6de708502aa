//! Blocked force, free contraction, dead pressure, work and burst.

use super::ask::{Options, force_on};
use super::error::AnalysisError;
use super::inverse::{contraction_at, pressure_at};
use super::root::find_root;
use crate::model::{ForceModel, ModelError, Workspace};

/// Blocked force F(P, 0) in N.
///
/// # Errors
/// The model's.
pub fn blocked_force_n<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    Ok(force_on(model, workspace, pressure_mpa, 0.0, options.direction)?)
}

/// Free contraction: the ε at which a muscle at this pressure no longer pulls.
///
/// # Errors
/// As [`contraction_at`]; a model whose range ends while it still pulls has no free contraction.
pub fn free_contraction<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    // Without pressure nothing pulls, and a muscle that nobody pulls is as long as at rest.
    if pressure_mpa == 0.0 && (options.extrapolate || model.range().pressure_mpa.0 <= 0.0) {
        return Ok(0.0);
    }
    contraction_at(model, workspace, 0.0, pressure_mpa, options)
}

/// Dead pressure P′ in MPa: below it the muscle does not pull at this contraction. Zero where it pulls from the start.
///
/// # Errors
/// As [`pressure_at`]: no pressure in the model's range makes it pull at this contraction; also where it pulls already at the
/// lowest pressure of a range that does not begin at zero, since P′ lies below.
pub fn start_pressure_mpa<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    contraction: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let lowest = model.range().pressure_mpa.0;
    // Without pressure a shortened muscle may have no equilibrium at all: then it does not pull either.
    if lowest <= 0.0
        && force_on(model, workspace, lowest, contraction, options.direction).is_ok_and(|force| force >= 0.0)
    {
        return Ok(lowest);
    }
    pressure_at(model, workspace, 0.0, contraction, options)
}

/// Work in J that the muscle does at constant pressure from ε = `from` to ε = `to`: L0 ∫ F dε.
///
/// # Errors
/// The model's.
pub fn work_per_stroke_j<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    from: f64,
    to: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    // Ten panels of four-point Gauss; the curves are smooth.
    const PANELS: usize = 10;
    let h = (to - from) / PANELS as f64;
    let mut sum = 0.0;
    for panel in 0..PANELS {
        let mid = from + h * (panel as f64 + 0.5);
        for &(x, weight) in crate::model::gauss(4) {
            let e = mid + 0.5 * h * x;
            sum += 0.5 * h * weight * force_on(model, workspace, pressure_mpa, e, options.direction)?;
        }
    }
    Ok(sum * model.muscle().length_mm() * 1e-3)
}

/// Pressure in MPa at which the strands break at a contraction: strand tension = strand strength.
///
/// `None` where the strands' strength or number is not stated. A pressure beyond which the model has no equilibrium is
/// the bursting pressure as well.
///
/// # Errors
/// [`AnalysisError::Unknown`] for a model without strand tension; the model's own errors at low pressure.
pub fn burst_pressure_mpa<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    contraction: f64,
) -> Result<Option<f64>, AnalysisError> {
    let Some(strands) = model.muscle().braid().strands else { return Ok(None) };
    let Some(strength) = strands.strength_n else { return Ok(None) };
    let mut at = |p: f64| -> Result<f64, AnalysisError> {
        let tension = model.response(workspace, p, contraction)?.strand_tension_n;
        let unknown = AnalysisError::Unknown { model: model.name().into(), quantity: "strand tension" };
        Ok(tension.ok_or(unknown)? - strength)
    };
    let (mut low, mut step) = (0.0, 0.05);
    at(low)?;
    while low < 1e4 {
        match at(low + step) {
            Ok(t) if t >= 0.0 => {
                let root = find_root(at, low, low + step, 1e-12);
                return root.map(Some).map_err(|_| {
                    ModelError::NotConverged {
                        pressure_mpa: low,
                        contraction,
                        iterations: 200,
                        residual: f64::NAN,
                    }
                    .into()
                });
            }
            Ok(_) => {
                low += step;
                step *= 1.5;
            }
            Err(_) if step > 1e-6 => step *= 0.25,
            Err(_) => return Ok(Some(low)),
        }
    }
    Ok(None)
}
