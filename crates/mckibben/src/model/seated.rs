//! Ends that give way: any model of a muscle whose terminals state their seating.
//!
//! Strands seat and slip in the clamps; the muscle between them is contracted by the seating δ (both ends together) more than the whole:
//!
//!   F(P, ε) = F₀(P, ε + δ/L0),   V(P, ε) = V₀(P, ε + δ/L0),
//!
//! F₀ and V₀ of the model with ends that hold, ε = ΔL/L0 of the whole muscle. Slopes by P and L are those of that state; by the measures
//! at fixed P and ε
//!
//!   ∂F/∂δ = −K,   ∂F/∂L0 = ∂F₀/∂L0 + K δ/L0,   K = −(1/L0) ∂F₀/∂ε.
//!
//! Range: δ constant, whatever the pull; a slack muscle does not seat its ends, and hangs a little longer than this says. One muscle
//! cannot tell δ from an error in the zero of its length; muscles of several lengths can.

use super::{Accuracy, ForceModel, ModelError, ModelRange, Response, Workspace};
use crate::muscle::Muscle;

/// A model of a muscle whose ends give way.
pub struct Seated<M: ForceModel + ?Sized> {
    inner: Box<M>,
}

/// The model itself where the muscle's ends hold, else with ends that give way.
pub fn seated(model: Box<dyn ForceModel>) -> Box<dyn ForceModel> {
    if model.muscle().seating_ratio() == 0.0 { model } else { Box::new(Seated::new(model)) }
}

impl<M: ForceModel + ?Sized> std::fmt::Debug for Seated<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Seated").field("inner", &self.inner.name()).finish_non_exhaustive()
    }
}

impl<M: ForceModel + ?Sized> Seated<M> {
    /// A model with the ends of its muscle, which it takes to hold.
    pub fn new(inner: Box<M>) -> Self {
        Self { inner }
    }

    /// The model with ends that hold.
    pub fn inner(&self) -> &M {
        &self.inner
    }

    /// Contraction of the muscle between its ends, where that of the whole is `contraction`.
    pub fn between(&self, contraction: f64) -> f64 {
        contraction + self.muscle().seating_ratio()
    }

    /// The other way.
    pub fn whole(&self, between: f64) -> f64 {
        between - self.muscle().seating_ratio()
    }
}

impl<M: ForceModel + ?Sized> ForceModel for Seated<M> {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn muscle(&self) -> &Muscle {
        self.inner.muscle()
    }

    fn source(&self) -> &str {
        self.inner.source()
    }

    fn range(&self) -> ModelRange {
        let range = self.inner.range();
        let (low, high) = range.contraction;
        ModelRange { contraction: (self.whole(low).max(-1.0), self.whole(high)), ..range }
    }

    fn accuracy(&self) -> Accuracy {
        self.inner.accuracy()
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        self.inner.notes(workspace)
    }

    fn response(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        let found = self.inner.response(workspace, p, self.between(e)).map_err(|error| self.told(error))?;
        Ok(Response { contraction: e, ..found })
    }

    fn force_n(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        self.inner.force_n(workspace, p, self.between(e)).map_err(|error| self.told(error))
    }

    fn blocked_scale_n(&self, workspace: &mut Workspace, p: f64) -> Result<f64, ModelError> {
        self.inner.blocked_scale_n(workspace, p)
    }

    fn mesh_error_n(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        force_n: f64,
        blocked_n: f64,
    ) -> Option<f64> {
        self.inner.mesh_error_n(workspace, p, self.between(e), force_n, blocked_n)
    }

    fn force_by(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        let inside: Vec<String> = names.iter().filter(|n| *n != "terminals.seating").cloned().collect();
        let stiffness = match self.response(workspace, p, e) {
            Ok(response) => response.stiffness_n_per_mm?,
            Err(error) => return Some(Err(error)),
        };
        let mut known = match self.inner.force_by(workspace, p, self.between(e), &inside)? {
            Ok(known) => known.into_iter(),
            Err(error) => return Some(Err(self.told(error))),
        };
        let ratio = self.muscle().seating_ratio();
        let one = |name: &String| match name.as_str() {
            "terminals.seating" => Some(-stiffness),
            "tube.length" => known.next().map(|slope| slope + stiffness * ratio),
            _ => known.next(),
        };
        names.iter().map(one).collect::<Option<Vec<f64>>>().map(Ok)
    }

    fn pivoting_n_per_mm(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        self.inner.pivoting_n_per_mm(workspace, p, self.between(e)).map_err(|error| self.told(error))
    }

    fn exact_pressure(&self, force_n: f64, e: f64) -> Option<f64> {
        self.inner.exact_pressure(force_n, self.between(e))
    }

    fn exact_contraction(&self, force_n: f64, p: f64) -> Option<f64> {
        self.inner.exact_contraction(force_n, p).map(|e| self.whole(e))
    }

    fn pressure_under_load(&self, workspace: &mut Workspace, force_n: f64, e: f64) -> Option<f64> {
        self.inner.pressure_under_load(workspace, force_n, self.between(e))
    }

    fn contraction_under_load(&self, workspace: &mut Workspace, force_n: f64, p: f64) -> Option<f64> {
        self.inner.contraction_under_load(workspace, force_n, p).map(|e| self.whole(e))
    }
}

impl<M: ForceModel + ?Sized> Seated<M> {
    /// An error with the contraction of the whole muscle.
    fn told(&self, mut error: ModelError) -> ModelError {
        match &mut error {
            ModelError::Geometry { contraction, lowest, highest } => {
                for value in [contraction, lowest, highest] {
                    *value = self.whole(*value);
                }
            }
            ModelError::NoEquilibrium { reason } | ModelError::Stopped { reason, .. } => {
                reason.push_str(" (contractions of the muscle between its ends, which give way)");
            }
            ModelError::Overstretched { contraction, .. }
            | ModelError::Locked { contraction, .. }
            | ModelError::NotConverged { contraction, .. }
            | ModelError::NotFinite { contraction, .. } => *contraction = self.whole(*contraction),
            _ => {}
        }
        error
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::ModelKind;
    use crate::muscle::Terminals;

    fn muscle(seating_mm: f64) -> Muscle {
        let terminals = Terminals { seating_mm: Some(seating_mm), ..Terminals::default() };
        Muscle::prototype().with_terminals(terminals).unwrap()
    }

    /// Seating 0 leaves every digit; δ shifts the contraction by δ/L0, in pull, volume, inverses and range.
    #[test]
    fn a_seated_muscle_is_the_same_one_contracted_by_the_seating() {
        let workspace = &mut Workspace::new();
        for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
            let (held, none, gives) = (
                kind.build(&Muscle::prototype()).unwrap(),
                kind.build(&muscle(0.0)).unwrap(),
                kind.build(&muscle(2.85)).unwrap(),
            );
            for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2)] {
                let here = held.response(workspace, p, e).unwrap();
                assert_eq!(none.response(workspace, p, e).unwrap(), here);
                let found = gives.response(workspace, p, e - 0.01).unwrap();
                assert!((found.force_n - here.force_n).abs() < 1e-9 * here.force_n.abs().max(1.0));
                assert_eq!(found.contraction, e - 0.01);
                if let Some(exact) = gives.exact_contraction(here.force_n, p) {
                    assert!((exact - (e - 0.01)).abs() < 1e-9);
                }
            }
            assert!((gives.range().contraction.1 - (held.range().contraction.1 - 0.01)).abs() < 1e-12);
        }
    }

    /// K δ: what rigid strands lose of the blocked force of a muscle, to first order in δ; the error is of second order.
    #[test]
    fn the_blocked_force_falls_by_stiffness_times_seating_to_second_order() {
        let workspace = &mut Workspace::new();
        let held = ModelKind::Ideal.build(&Muscle::prototype()).unwrap();
        let at_rest = held.response(workspace, 0.25, 0.0).unwrap();
        let stiffness = at_rest.stiffness_n_per_mm.unwrap();
        let miss = |seating: f64, w: &mut Workspace| {
            let gives = ModelKind::Ideal.build(&muscle(seating)).unwrap();
            (gives.force_n(w, 0.25, 0.0).unwrap() - (at_rest.force_n - stiffness * seating)).abs()
        };
        let (coarse, fine) = (miss(2.0, workspace), miss(1.0, workspace));
        assert!((coarse / fine - 4.0).abs() < 1e-6, "{coarse} {fine}");
    }

    /// ∂F/∂δ and ∂F/∂L0 against central differences.
    #[test]
    fn slopes_by_seating_and_length_are_those_of_differences() {
        let workspace = &mut Workspace::new();
        let names = ["terminals.seating".to_owned(), "tube.length".into(), "tube.wall_thickness".into()];
        let at = |m: &Muscle, w: &mut Workspace| {
            ModelKind::ThickWall.build(m).unwrap().force_n(w, 0.25, 0.1).unwrap()
        };
        let base = muscle(3.0);
        let longer = |h: f64| {
            let mut tube = base.tube().clone();
            tube.length_mm += h;
            base.with_tube(tube).unwrap()
        };
        let by_seating = (at(&muscle(3.01), workspace) - at(&muscle(2.99), workspace)) / 0.02;
        let by_length = (at(&longer(0.1), workspace) - at(&longer(-0.1), workspace)) / 0.2;
        let model = ModelKind::ThickWall.build(&base).unwrap();
        let Some(found) = model.force_by(workspace, 0.25, 0.1, &names) else {
            let stiffness = model.response(workspace, 0.25, 0.1).unwrap().stiffness_n_per_mm.unwrap();
            assert!((by_seating + stiffness).abs() < 1e-5 * stiffness);
            // The thick wall is endless: its pull depends on L0 through δ/L0 alone.
            assert!((by_length - stiffness * base.seating_ratio()).abs() < 1e-5 * stiffness);
            return;
        };
        let found = found.unwrap();
        assert!((found[0] - by_seating).abs() < 1e-5 * by_seating.abs(), "{found:?}");
        assert!((found[1] - by_length).abs() < 1e-5 * by_seating.abs(), "{found:?}");
    }
}
