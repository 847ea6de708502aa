//! Any model with braid friction: the pull on one branch of the hysteresis loop.
//!
//!   F = F_model ± C P^β   (+ while the muscle is lengthened, − while it shortens)

use super::{Accuracy, ForceModel, ModelError, ModelRange, Response, Workspace};
use crate::muscle::{Friction, Motion, Muscle};

/// A model and the friction of its braid in one direction of motion. It keeps the name of the model inside.
pub struct Hysteresis {
    inner: Box<dyn ForceModel>,
    friction: Friction,
    motion: Motion,
    source: String,
}

impl Hysteresis {
    /// Puts friction around a model.
    pub fn new(inner: Box<dyn ForceModel>, friction: Friction, motion: Motion) -> Self {
        let branch = match motion {
            Motion::Mean => "mean of both branches",
            Motion::Shortening => "branch of shortening",
            Motion::Lengthening => "branch of lengthening",
        };
        let source = format!("{}; braid friction C·P^β (Tondu 2012), {branch}", inner.source());
        Self { inner, friction, motion, source }
    }
}

impl ForceModel for Hysteresis {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn muscle(&self) -> &Muscle {
        self.inner.muscle()
    }

    fn source(&self) -> &str {
        &self.source
    }

    fn range(&self) -> ModelRange {
        self.inner.range()
    }

    fn accuracy(&self) -> Accuracy {
        self.inner.accuracy()
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        self.inner.notes(workspace)
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        let mut response = self.inner.response(workspace, pressure_mpa, contraction)?;
        response.force_n += self.friction.force_n(pressure_mpa, self.motion);
        let slope = self.friction.slope(pressure_mpa, self.motion);
        response.force_per_pressure_mm2 = response.force_per_pressure_mm2.map(|f| f + slope);
        Ok(response)
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        let force = self.inner.force_n(workspace, pressure_mpa, contraction)?;
        Ok(force + self.friction.force_n(pressure_mpa, self.motion))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Ideal;

    #[test]
    fn the_branches_lie_on_both_sides_of_the_mean() {
        let m = Muscle::prototype();
        let friction = Friction { coefficient: 40.0, exponent: 0.7 };
        let on = |motion| Hysteresis::new(Box::new(Ideal::new(&m)), friction, motion);
        let (p, e, h) = (0.2, 0.1, 1e-6);
        let ideal = Ideal::new(&m).force_n(&mut Workspace::new(), p, e).unwrap();
        let half = 40.0 * 0.2f64.powf(0.7);
        for (motion, sign) in [(Motion::Mean, 0.0), (Motion::Shortening, -1.0), (Motion::Lengthening, 1.0)] {
            let model = on(motion);
            let response = model.response(&mut Workspace::new(), p, e).unwrap();
            assert!((response.force_n - ideal - sign * half).abs() < 1e-10);
            assert_eq!(model.force_n(&mut Workspace::new(), p, e).unwrap(), response.force_n);
            let slope = (model.force_n(&mut Workspace::new(), p + h, e).unwrap()
                - model.force_n(&mut Workspace::new(), p - h, e).unwrap())
                / (2.0 * h);
            assert!((slope / response.force_per_pressure_mm2.unwrap() - 1.0).abs() < 1e-6);
            assert_eq!(model.name(), "ideal");
        }
        assert_eq!(on(Motion::Shortening).pressure_in_closed_form(&mut Workspace::new(), 100.0, 0.1), None);
    }
}
