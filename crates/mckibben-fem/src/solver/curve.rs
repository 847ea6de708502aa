//! Tests of a muscle: isometric, isotonic, isobaric. Every point carries a status: one that has no equilibrium does not end the
//! others.

use super::body::{Body, Control};
use super::continuation::Continuation;
use super::newton::Effort;
use super::trail::Along;
use crate::results::Sensitivity;
use crate::{FemError, Result};
use mckibben::cancel::{self, Cancelled};
use mckibben::model::Response;

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
    /// Factorisations it took.
    pub factorisations: usize,
    /// What every model answers, stiffness and ∂F/∂P among it, where the detail includes it.
    pub response: Option<Response>,
    /// ∂F/∂(constants and measures), where the detail includes them.
    pub sensitivities: Vec<Sensitivity>,
}

impl CurvePoint {
    /// Whether the muscle would have to push.
    pub fn slack(&self) -> bool {
        self.force_n < 0.0
    }

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
            factorisations: c.effort.factorisations - before.factorisations,
            response: None,
            sensitivities: vec![],
        }
    }
}

/// Points of a curve in the order of the given values.
pub type Curve = Vec<Result<CurvePoint>>;

/// What is kept fixed along a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Test {
    /// A contraction, at given pressures; from the highest pressure down.
    Isometric(f64),
    /// A pull in N, at given pressures; from the highest pressure down.
    Isotonic(f64),
    /// A pressure in MPa, at given contractions; from the smallest contraction on.
    Isobaric(f64),
}

impl Test {
    fn along(self) -> Along {
        if matches!(self, Self::Isobaric(_)) { Along::Length } else { Along::Pressure }
    }

    /// The places of `values` in the order in which the test visits them.
    pub(crate) fn order(self, values: &[f64]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        if self.along() == Along::Pressure {
            order.reverse();
        }
        order
    }

    fn solve_anew<B: Body>(self, c: &mut Continuation<B>, value: f64) -> Result<()> {
        match self {
            Self::Isometric(contraction) => c.reach(value, contraction),
            Self::Isotonic(force) => c.reach_force(force, value),
            Self::Isobaric(pressure) => c.reach(pressure, value),
        }
    }

    /// From the last points of the path to the next; whether that is the answer there.
    fn follow_trail<B: Body>(self, c: &mut Continuation<B>, value: f64) -> bool {
        let half = c.body.half_length();
        let (place, held) = match self {
            Self::Isometric(contraction) => (value, Control::Length(-contraction * half)),
            Self::Isotonic(force) => (value, Control::Force(force)),
            Self::Isobaric(_) => (-value * half, Control::Length(-value * half)),
        };
        let predicted = c.trail.predict(self.along(), place, c.body.state_mut());
        predicted && c.solve(held).is_ok() && c.stable_under(held) && c.body.certain()
    }
}

/// Visits `values` in the order of the test: from what the last points predict where that works, else anew. `complete` adds to a point.
pub(crate) fn run<B: Body>(
    c: &mut Continuation<B>,
    values: &[f64],
    test: Test,
    complete: impl Fn(&mut Continuation<B>, &mut CurvePoint) -> Result<()>,
) -> Curve {
    let order = test.order(values);
    let mut out: Curve = vec![Err(FemError::Cancelled(Cancelled)); values.len()];
    let mut running = false;
    for (turn, &i) in order.iter().enumerate() {
        if cancel::check().is_err() {
            break;
        }
        if turn > 0 && values[i] == values[order[turn - 1]] {
            out[i] = out[order[turn - 1]].clone();
            continue;
        }
        let before = c.effort;
        let followed = running && test.follow_trail(c, values[i]);
        let point = if followed { Ok(()) } else { test.solve_anew(c, values[i]) };
        if followed {
            c.trail_here();
        } else {
            // Where strands are slack the next point is none of this path.
            running = point.is_ok() && (B::SETTINGS.take_unstable || c.body.certain());
            if running {
                c.begin_trail();
            }
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
