//! Finite elements of a muscle whose ends give way: tests and searches with the contraction of the whole muscle.

use crate::FemError;
use crate::results::{Solution, TangentPoint};
use crate::simulation::Simulation;
use crate::solver::curve::{Curve, CurvePoint};
use crate::solver::newton::Effort;
use mckibben::model::{ForceModel, Seated, Workspace};
use mckibben::progress::Progress;

/// The elements themselves where the muscle's ends hold, else with ends that give way.
pub fn seated(model: Box<dyn Simulation>) -> Box<dyn Simulation> {
    if model.muscle().seating_ratio() == 0.0 { model } else { Box::new(Seated::new(model)) }
}

/// Errors with the contraction of the whole muscle.
fn told(of: &Seated<dyn Simulation>, mut error: FemError) -> FemError {
    match &mut error {
        FemError::Path { contraction, last, .. } => {
            *contraction = of.whole(*contraction);
            last.contraction = of.whole(last.contraction);
        }
        FemError::Question { contraction, .. } | FemError::OutOfReach { contraction, .. } => {
            *contraction = of.whole(*contraction);
        }
        _ => {}
    }
    error
}

fn solution(of: &Seated<dyn Simulation>, found: Result<Solution, FemError>) -> Result<Solution, FemError> {
    let mut found = found.map_err(|error| told(of, error))?;
    found.response.contraction = of.whole(found.response.contraction);
    Ok(found)
}

fn curve(of: &Seated<dyn Simulation>, points: Curve) -> Curve {
    let whole = |point: CurvePoint| CurvePoint { contraction: of.whole(point.contraction), ..point };
    points.into_iter().map(|point| point.map(whole).map_err(|error| told(of, error))).collect()
}

impl Simulation for Seated<dyn Simulation> {
    fn solve(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Solution, FemError> {
        solution(self, self.inner().solve(workspace, p, self.between(e)))
    }

    fn at_force(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Result<Solution, FemError> {
        solution(self, self.inner().at_force(workspace, force_n, p))
    }

    fn at_pressure_for(&self, workspace: &mut Workspace, force_n: f64, e: f64) -> Result<Solution, FemError> {
        solution(self, self.inner().at_pressure_for(workspace, force_n, self.between(e)))
    }

    fn contraction_at_force(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Result<f64, FemError> {
        let found = self.inner().contraction_at_force(workspace, force_n, p);
        found.map(|e| self.whole(e)).map_err(|error| told(self, error))
    }

    fn pressure_at_force_mpa(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        e: f64,
    ) -> Result<f64, FemError> {
        let found = self.inner().pressure_at_force_mpa(workspace, force_n, self.between(e));
        found.map_err(|error| told(self, error))
    }

    fn isometric(
        &self,
        workspace: &mut Workspace,
        e: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        let points = self.inner().isometric(workspace, self.between(e), pressures_mpa, progress);
        // As it was asked for, to the last bit.
        let asked = |point: CurvePoint| CurvePoint { contraction: e, ..point };
        curve(self, points).into_iter().map(|point| point.map(asked)).collect()
    }

    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        e: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
        progress: &dyn Progress,
    ) -> Vec<Result<TangentPoint, FemError>> {
        let inner = self.inner();
        let points =
            inner.isometric_with_tangents(workspace, self.between(e), pressures_mpa, sensitivities, progress);
        let ratio = self.muscle().seating_ratio();
        let whole = |mut point: TangentPoint| {
            point.response.contraction = e;
            let stiffness = point.response.stiffness_n_per_mm.unwrap_or(0.0);
            for slope in point.sensitivities.iter_mut().filter(|s| s.name == "tube.length") {
                slope.force_n_per_unit += stiffness * ratio;
            }
            point
        };
        points.into_iter().map(|point| point.map(whole).map_err(|error| told(self, error))).collect()
    }

    fn isobaric(
        &self,
        workspace: &mut Workspace,
        p: f64,
        contractions: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        let between: Vec<f64> = contractions.iter().map(|e| self.between(*e)).collect();
        let points = curve(self, self.inner().isobaric(workspace, p, &between, progress));
        let asked = |(point, e): (Result<CurvePoint, FemError>, &f64)| {
            point.map(|point| CurvePoint { contraction: *e, ..point })
        };
        points.into_iter().zip(contractions).map(asked).collect()
    }

    fn isotonic(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        curve(self, self.inner().isotonic(workspace, force_n, pressures_mpa, progress))
    }

    fn effort(&self, workspace: &Workspace) -> Effort {
        self.inner().effort(workspace)
    }
}

#[cfg(test)]
mod tests {
    use crate::simulation::{Elements, Simulation};
    use mckibben::model::Workspace;
    use mckibben::muscle::{Muscle, Terminals};
    use mckibben::progress::Silent;

    fn elements(seating_mm: f64) -> Box<dyn Simulation> {
        let terminals = Terminals { seating_mm: Some(seating_mm), ..Terminals::default() };
        let muscle = Muscle::prototype().with_terminals(terminals).unwrap();
        "fe".parse::<Elements>().unwrap().build(&muscle).unwrap()
    }

    /// F(P, ε) = F₀(P, ε + δ/L0) in every test and search, with the contraction of the whole muscle; seating 0 changes no digit.
    #[test]
    fn every_test_of_a_seated_muscle_is_that_of_the_muscle_between_its_ends() {
        let (held, none, gives) = (elements(0.0), elements(0.0), elements(2.85));
        let w = &mut Workspace::new();
        let (p, shift) = (0.2, 0.01);
        let here = held.solve(w, p, 0.1).unwrap().response;
        assert_eq!(none.solve(w, p, 0.1).unwrap().response, here);
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
        let found = gives.solve(w, p, 0.1 - shift).unwrap().response;
        close(found.force_n, here.force_n);
        close(found.contraction, 0.1 - shift);
        close(gives.contraction_at_force(w, here.force_n, p).unwrap(), 0.1 - shift);
        close(gives.pressure_at_force_mpa(w, here.force_n, 0.1 - shift).unwrap(), p);
        close(gives.at_force(w, here.force_n, p).unwrap().response.contraction, 0.1 - shift);
        close(gives.free_contraction(w, p).unwrap(), held.free_contraction(w, p).unwrap() - shift);
        let (pressures, contractions) = ([0.1, p], [0.05 - shift, 0.1 - shift]);
        let isometric = gives.isometric(w, 0.1 - shift, &pressures, &Silent);
        let isobaric = gives.isobaric(w, p, &contractions, &Silent);
        let isotonic = gives.isotonic(w, here.force_n, &pressures, &Silent);
        close(isometric[1].as_ref().unwrap().force_n, here.force_n);
        assert_eq!(isometric[1].as_ref().unwrap().contraction, 0.1 - shift);
        close(isobaric[1].as_ref().unwrap().force_n, here.force_n);
        close(isotonic[1].as_ref().unwrap().contraction, 0.1 - shift);
        let refused = gives.solve(w, p, 2.0).unwrap_err();
        assert!(
            matches!(refused, crate::FemError::Question { contraction, .. } if (contraction - 2.0).abs() < 1e-12)
        );
    }

    /// ∂F/∂L0 at fixed ε, with the way of the ends in it, against central differences.
    #[test]
    fn the_slope_by_length_is_that_of_differences() {
        let w = &mut Workspace::new();
        let base = elements(2.85);
        let at = |length_mm: f64, w: &mut Workspace| {
            let mut tube = base.muscle().tube().clone();
            tube.length_mm = length_mm;
            let muscle = base.muscle().with_tube(tube).unwrap();
            let model = "fe".parse::<Elements>().unwrap().build(&muscle).unwrap();
            model.force_n(w, 0.2, 0.1).unwrap()
        };
        let difference = (at(286.0, w) - at(284.0, w)) / 2.0;
        let names = ["terminals.seating".to_owned(), "tube.length".into()];
        let found = base.force_by(w, 0.2, 0.1, &names).unwrap().unwrap();
        assert!((found[1] - difference).abs() < 1e-3 * difference.abs(), "{found:?} {difference}");
        let stiffness = base.response(w, 0.2, 0.1).unwrap().stiffness_n_per_mm.unwrap();
        assert!((found[0] + stiffness).abs() < 1e-9 * stiffness);
    }
}
