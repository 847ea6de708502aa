//! The tests a muscle is put to: isometric, isotonic, isobaric; blocked force, free contraction, starting pressure.
//!
//! Every point of a curve carries its own status: one that has no equilibrium does not end the others.

use super::engine::{Along, Engine};
use super::equilibrium::Control;
use super::error::FemError;
use super::model::Axisymmetric;
use super::results::Solution;
use super::sensitivity::{self, Sensitivity};
use mckibben::model::{ForceModel, Response, Workspace};

/// A point of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvePoint {
    /// Pressure in MPa: given, or found.
    pub pressure_mpa: f64,
    /// Contraction: given, or found (below 0: the pull stretches the muscle).
    pub contraction: f64,
    /// Pull in N: given, or found (below 0: the muscle pushes).
    pub force_n: f64,
    /// Volume of the cavity in mm³.
    pub volume_mm3: f64,
    /// Newton iterations it took.
    pub iterations: usize,
    /// Factorisations it took.
    pub factorisations: usize,
}

impl CurvePoint {
    /// Whether the muscle would have to push.
    pub fn slack(&self) -> bool {
        self.force_n < 0.0
    }

    fn here(e: &mut Engine, spent: (usize, usize)) -> Result<Self, FemError> {
        let (s, effort) = (&e.walker.body.state, e.walker.effort);
        Ok(Self {
            // Zeros without a sign.
            pressure_mpa: s.pressure + 0.0,
            contraction: 0.0 - s.terminal / e.half_length(),
            force_n: e.walker.body.totals.pull,
            volume_mm3: 2.0 * e.walker.body.totals.volume,
            iterations: effort.iterations - spent.0,
            factorisations: effort.factorisations - spent.1,
        })
    }
}

/// A point of a curve with what its tangent tells.
#[derive(Debug, Clone, PartialEq)]
pub struct TangentPoint {
    /// What every model tells, stiffness and ∂F/∂P among it.
    pub response: Response,
    /// ∂F/∂(constants and measures), where they were asked for.
    pub sensitivities: Vec<Sensitivity>,
    /// Newton iterations it took.
    pub iterations: usize,
}

/// Points of a curve in the order they were asked for.
pub type Curve = Vec<Result<CurvePoint, FemError>>;

fn spent(e: &Engine) -> (usize, usize) {
    (e.walker.effort.iterations, e.walker.effort.factorisations)
}

/// Visits `values` in the order of `order`: from what the last points foretell where that works, else by `afresh`.
fn run<T: Clone>(
    e: &mut Engine,
    values: &[f64],
    along: Along,
    descending: bool,
    control: impl Fn(&Engine, f64) -> Control,
    afresh: impl Fn(&mut Engine, f64) -> Result<(), FemError>,
    here: impl Fn(&mut Engine, (usize, usize)) -> Result<T, FemError>,
) -> Vec<Result<T, FemError>> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    if descending {
        order.reverse();
    }
    let mut out: Vec<Option<Result<T, FemError>>> = vec![None; values.len()];
    let mut running = false;
    for (turn, &i) in order.iter().enumerate() {
        let cost = spent(e);
        let value = values[i];
        if turn > 0 && value == values[order[turn - 1]] {
            out[i] = out[order[turn - 1]].clone();
            continue;
        }
        let place = match along {
            Along::Pressure => value,
            Along::Length => -value * e.half_length(),
        };
        let held = control(e, value);
        let foretold = running && e.next(along, place, held).is_ok() && e.stable_under(held);
        let walked = |e: &mut Engine| match held {
            Control::Length(w) => {
                let pressure = if along == Along::Pressure { value } else { e.pressure_of_trail() };
                e.walk_on(pressure, w)
            }
            _ => false,
        };
        let point = if foretold || (running && walked(e)) { Ok(()) } else { afresh(e, value) };
        if foretold {
            e.trail_here();
        } else {
            running = point.is_ok();
            if running {
                e.begin_trail();
            }
        }
        out[i] = Some(point.and_then(|()| here(e, cost)));
    }
    if running {
        e.keep();
    }
    out.into_iter().flatten().collect()
}

impl Axisymmetric {
    /// Isometric test: F at one contraction and the given pressures (MPa). Runs from the highest pressure down.
    pub fn isometric(&self, workspace: &mut Workspace, contraction: f64, pressures_mpa: &[f64]) -> Curve {
        self.isometric_with(workspace, contraction, pressures_mpa, CurvePoint::here)
    }

    /// [`Axisymmetric::isometric`] with what the tangents tell, and ∂F/∂(constants and measures) if they are asked for.
    pub fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
    ) -> Vec<Result<TangentPoint, FemError>> {
        let muscle = self.muscle();
        self.isometric_with(workspace, contraction, pressures_mpa, |e, spent| {
            let iterations = e.walker.effort.iterations - spent.0;
            let body = &mut e.walker.body;
            let response = Solution::response(body, muscle)?;
            let all = if sensitivities { sensitivity::all(body, muscle)? } else { vec![] };
            Ok(TangentPoint { response, sensitivities: all, iterations })
        })
    }

    fn isometric_with<T: Clone>(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        here: impl Fn(&mut Engine, (usize, usize)) -> Result<T, FemError>,
    ) -> Vec<Result<T, FemError>> {
        let held = |e: &Engine, _: f64| Control::Length(-contraction * e.half_length());
        let afresh = |e: &mut Engine, p: f64| e.reach(p, contraction);
        run(self.engine(workspace), pressures_mpa, Along::Pressure, true, held, afresh, here)
    }

    /// Isobaric test: F at one pressure (MPa) and the given contractions. Runs from the smallest contraction on.
    pub fn isobaric(&self, workspace: &mut Workspace, pressure_mpa: f64, contractions: &[f64]) -> Curve {
        run(
            self.engine(workspace),
            contractions,
            Along::Length,
            false,
            |e, c| Control::Length(-c * e.half_length()),
            |e, c| e.reach(pressure_mpa, c),
            CurvePoint::here,
        )
    }

    /// Isotonic test: ε under one pull (N) at the given pressures (MPa). Where the pull is above the blocked force the
    /// contraction is below zero. Runs from the highest pressure down.
    pub fn isotonic(&self, workspace: &mut Workspace, force_n: f64, pressures_mpa: &[f64]) -> Curve {
        run(
            self.engine(workspace),
            pressures_mpa,
            Along::Pressure,
            true,
            |_, _| Control::Force(force_n),
            |e, p| self.reach_force(e, force_n, p),
            CurvePoint::here,
        )
    }

    /// Isometric tests at 0, 45 % and 90 % of the largest contraction, as the paper validates its model; the largest is
    /// the free contraction at the highest of the pressures.
    ///
    /// # Errors
    /// [`FemError`] where no free contraction is found.
    pub fn validation_set(
        &self,
        workspace: &mut Workspace,
        pressures_mpa: &[f64],
    ) -> Result<Vec<(f64, Curve)>, FemError> {
        let highest = pressures_mpa.iter().copied().fold(0.0, f64::max);
        let largest = self.free_contraction(workspace, highest)?;
        Ok([0.0, 0.45, 0.90]
            .map(|share| (share * largest, self.isometric(workspace, share * largest, pressures_mpa)))
            .into())
    }

    /// Blocked force in N: the pull without contraction.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn blocked_force_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        let e = self.engine(workspace);
        e.reach(pressure_mpa, 0.0)?;
        Ok(e.walker.body.totals.pull)
    }

    /// Free contraction: ε without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        let e = self.engine(workspace);
        self.reach_force(e, 0.0, pressure_mpa)?;
        Ok(-e.walker.body.state.terminal / e.half_length())
    }

    /// P′ in MPa: the pressure at which the muscle begins to pull at a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn starting_pressure_mpa(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
    ) -> Result<f64, FemError> {
        self.at_pressure_for(workspace, 0.0, contraction).map(|s| s.response.pressure_mpa)
    }
}
