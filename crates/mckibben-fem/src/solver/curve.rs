//! The isometric test of a muscle. Every point carries a status: one that has no equilibrium does
//! not end the others.

use super::{
    body::{Body, Control},
    continuation::Continuation,
    newton::Effort,
    trail::{Along, Trail},
};
use crate::{FemError, Result, results::Sensitivity};
use mckibben_core::{
    by_number::SortByNumber,
    cancel::{self, Cancelled},
    model::Response,
};

/// A point of a curve.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CurvePoint {
    /// Pressure in MPa: given, or solved for.
    pub pressure_mpa: f64,
    /// Contraction: given, or solved for (below 0: the pull stretches the muscle).
    pub contraction: f64,
    /// Pull in N: given, or solved for (below 0: the muscle pushes).
    pub force_n: f64,
    /// Volume of the cavity in mm³.
    pub volume_mm3: f64,
    /// Newton iterations it took.
    pub iterations: usize,
    /// What every model answers, stiffness and ∂F/∂P among it, where the detail includes it.
    pub response: Option<Response>,
    /// ∂F/∂(constants and measures), where the detail includes them.
    pub sensitivities: Vec<Sensitivity>,
}

impl CurvePoint {
    /// The present equilibrium, with what was spent since `before`.
    pub(crate) fn here<B: Body>(c: &Continuation<B>, before: Effort) -> Self {
        let totals = c.body.totals();
        Self {
            // Zeros without a sign.
            pressure_mpa: c.body.state().pressure + 0.0,
            contraction: c.contraction(),
            force_n: totals.pull,
            volume_mm3: B::COPIES * totals.volume,
            iterations: c.effort.iterations - before.iterations,
            response: None,
            sensitivities: vec![],
        }
    }
}

/// Points of a curve in the order of the given values.
pub type Curve = Vec<Result<CurvePoint>>;

/// From the last points of the path to the pressure; whether that is the answer there.
fn follow_trail<B: Body>(c: &mut Continuation<B>, contraction: f64, pressure_mpa: f64) -> bool {
    let held = Control::Length(-contraction * c.body.half_length());
    let predicted = c
        .trail
        .predict(Along::Pressure, pressure_mpa, c.body.state_mut());
    predicted && c.solve(held).is_ok() && c.stable_under(held) && c.body.certain()
}

/// Places of numbers from the largest down.
pub(crate) fn falling(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by_number(|&a| -values[a]);
    order
}

/// Visits the pressures in MPa from the highest down: from what the last points predict where that
/// works, else anew. `complete` adds to a point.
pub(crate) fn isometric<B: Body>(
    c: &mut Continuation<B>,
    contraction: f64,
    pressures_mpa: &[f64],
    complete: impl Fn(&mut Continuation<B>, &mut CurvePoint) -> Result<()>,
) -> Curve {
    let order = falling(pressures_mpa);
    let mut out: Curve = vec![Err(FemError::Cancelled(Cancelled)); pressures_mpa.len()];
    let mut running = false;
    for (turn, &i) in order.iter().enumerate() {
        if cancel::check().is_err() {
            break;
        }
        let pressure_mpa = pressures_mpa[i];
        if turn > 0 && pressure_mpa == pressures_mpa[order[turn - 1]] {
            out[i] = out[order[turn - 1]].clone();
            continue;
        }
        let before = c.effort;
        let followed = running && follow_trail(c, contraction, pressure_mpa);
        let point = if followed {
            Ok(())
        } else {
            c.reach(pressure_mpa, contraction)
        };
        if !followed {
            // Where strands are slack the next point is none of this path.
            running = point.is_ok() && (B::SETTINGS.take_unstable || c.body.certain());
            c.trail = Trail::default();
        }
        if running {
            c.trail.push(c.body.state());
        }
        out[i] = point.and_then(|()| {
            let mut here = CurvePoint::here(c, before);
            complete(c, &mut here)?;
            Ok(here)
        });
    }
    if running {
        c.keep();
    }
    out
}
