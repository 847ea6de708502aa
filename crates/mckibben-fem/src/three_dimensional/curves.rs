//! Isometric, isotonic and isobaric tests. Every point carries its own status.

use super::engine::Engine;
use super::model::ThreeDimensional;
use super::results;
use crate::axisymmetric::equilibrium::Control;
use crate::axisymmetric::{Curve, CurvePoint, FemError, TangentPoint};
use mckibben::model::{ForceModel, Workspace};

fn here(e: &Engine, (iterations, factorisations): (usize, usize)) -> CurvePoint {
    CurvePoint {
        pressure_mpa: e.body.state.pressure + 0.0,
        contraction: e.contraction(),
        force_n: e.body.totals.pull,
        volume_mm3: 8.0 * e.body.totals.volume,
        iterations: e.effort.iterations - iterations,
        factorisations: e.effort.factorisations - factorisations,
    }
}

/// What is held along a curve: (place on it, pressure) to (control, a way to begin).
#[derive(Debug, Clone, Copy)]
enum Held {
    Contraction(f64),
    Force(f64),
    Pressure(f64),
}

impl Held {
    fn question(self, e: &Engine, place: f64) -> (f64, Control) {
        match self {
            Self::Contraction(c) => (place, Control::Length(-c * e.half_length())),
            Self::Force(f) => (place, Control::Force(f)),
            Self::Pressure(p) => (p, Control::Length(-place * e.half_length())),
        }
    }

    fn afresh(self, e: &mut Engine, place: f64) -> Result<(), FemError> {
        match self {
            Self::Contraction(c) => e.reach(place, c),
            Self::Force(f) => e.reach_force(f, place),
            Self::Pressure(p) => e.reach(p, place),
        }
    }
}

fn run<T: Clone>(
    e: &mut Engine,
    places: &[f64],
    held: Held,
    mut tell: impl FnMut(&mut Engine, (usize, usize)) -> Result<T, FemError>,
) -> Vec<Result<T, FemError>> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&a, &b| places[a].total_cmp(&places[b]));
    if !matches!(held, Held::Pressure(_)) {
        order.reverse();
    }
    let mut out: Vec<Option<Result<T, FemError>>> = vec![None; places.len()];
    e.begin_trail();
    for (turn, &i) in order.iter().enumerate() {
        if turn > 0 && places[i] == places[order[turn - 1]] {
            out[i] = out[order[turn - 1]].clone();
            continue;
        }
        let before = (e.effort.iterations, e.effort.factorisations);
        let (pressure, control) = held.question(e, places[i]);
        let mut answer = Ok(());
        if !e.next(places[i], pressure, control) {
            e.begin_trail();
            answer = held.afresh(e, places[i]);
        }
        if answer.is_ok() {
            e.trail_here(places[i]);
        }
        out[i] = Some(answer.and_then(|()| tell(e, before)));
    }
    out.into_iter().flatten().collect()
}

impl ThreeDimensional {
    fn run<T: Clone>(
        &self,
        workspace: &mut Workspace,
        places: &[f64],
        held: Held,
        tell: impl FnMut(&mut Engine, (usize, usize)) -> Result<T, FemError>,
    ) -> Vec<Result<T, FemError>> {
        match self.engine(workspace) {
            Ok(e) => run(e, places, held, tell),
            Err(error) => vec![Err(error); places.len()],
        }
    }

    /// Isometric test: F at one contraction and the given pressures (MPa). Runs from the highest pressure down.
    pub fn isometric(&self, workspace: &mut Workspace, contraction: f64, pressures_mpa: &[f64]) -> Curve {
        self.run(workspace, pressures_mpa, Held::Contraction(contraction), |e, b| Ok(here(e, b)))
    }

    /// [`ThreeDimensional::isometric`] with what the tangents tell; it has no sensitivities.
    pub fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
    ) -> Vec<Result<TangentPoint, FemError>> {
        let muscle = self.muscle();
        self.run(workspace, pressures_mpa, Held::Contraction(contraction), |e, before| {
            let iterations = e.effort.iterations - before.0;
            let response = results::response(&mut e.body, &e.mesh, muscle)?;
            Ok(TangentPoint { response, sensitivities: vec![], iterations })
        })
    }

    /// Isobaric test: F at one pressure (MPa) and the given contractions.
    pub fn isobaric(&self, workspace: &mut Workspace, pressure_mpa: f64, contractions: &[f64]) -> Curve {
        self.run(workspace, contractions, Held::Pressure(pressure_mpa), |e, b| Ok(here(e, b)))
    }

    /// Isotonic test: ε under one pull (N) at the given pressures (MPa). Runs from the highest pressure down.
    pub fn isotonic(&self, workspace: &mut Workspace, force_n: f64, pressures_mpa: &[f64]) -> Curve {
        self.run(workspace, pressures_mpa, Held::Force(force_n), |e, b| Ok(here(e, b)))
    }
}
