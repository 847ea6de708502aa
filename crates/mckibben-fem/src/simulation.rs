//! What finite-element models have in common: equilibria and tests.

use crate::FemError;
use crate::results::{MuscleBody, Solution};
use crate::solver::body::Body as _;
use crate::solver::continuation::Continuation;
use crate::solver::curve::{Curve, CurvePoint, Test, run};
use mckibben::model::{
    Accuracy, Extensions, ForceModel, ModelEntry, ModelError, ModelId, ModelInfo, ModelRange, Response,
    Workspace,
};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;

/// What is given of an equilibrium. Pressures are in MPa, pulls in N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// Pressure and contraction.
    PressureAndContraction {
        /// P
        pressure_mpa: f64,
        /// ε
        contraction: f64,
    },
    /// Pressure and pull, which Newton's method holds; the contraction is sought.
    PressureAndPull {
        /// P
        pressure_mpa: f64,
        /// F
        force_n: f64,
    },
    /// Contraction and pull, likewise; the pressure is sought. P′ is the one without a pull.
    ContractionAndPull {
        /// ε
        contraction: f64,
        /// F
        force_n: f64,
    },
}

impl Given {
    /// Pressure in MPa and contraction.
    pub fn at(pressure_mpa: f64, contraction: f64) -> Self {
        Self::PressureAndContraction { pressure_mpa, contraction }
    }
}

/// What the points of a test have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// Pressure, contraction, pull and volume.
    Point,
    /// And the response, with what the tangent gives.
    Tangent,
    /// And ∂F/∂(constants and measures), where the model has them.
    Sensitivities,
}

/// What of a muscle that is divided into elements does not change.
pub trait Divided: Send + Sync + Sized {
    /// Name, description and source of the model.
    const ENTRY: ModelEntry;

    /// The body that is led from equilibrium to equilibrium.
    type Body: MuscleBody + Send + 'static;

    /// The muscle at rest.
    ///
    /// # Errors
    /// [`FemError::Refused`] where there is not enough memory.
    fn at_rest(&self) -> Result<Self::Body, FemError>;

    /// What its model can do.
    fn extensions(model: &FiniteElements<Self>) -> Extensions<'_>;

    /// A pressure in MPa near which a smaller one than was found for a pull in N at a contraction may be.
    fn near_smaller(&self, _found_mpa: f64, _force_n: f64, _contraction: f64) -> Option<f64> {
        None
    }
}

/// A force model by finite elements. The last equilibria are kept in the workspace, so that neighbouring questions are cheap.
#[derive(Debug, Clone)]
pub struct FiniteElements<D> {
    id: ModelId,
    info: ModelInfo,
    /// The muscle in elements.
    pub divided: D,
}

impl<D: Divided> FiniteElements<D> {
    pub(crate) fn of(divided: D, muscle: &Muscle, accuracy: Accuracy, notes: Vec<String>) -> Self {
        let range = ModelRange::open().stretched(muscle.braid().angle_deg);
        let info = ModelInfo { range, accuracy, costly: true, notes, ..ModelInfo::new(&D::ENTRY, muscle) };
        Self { id: ModelId::new(), info, divided }
    }

    /// The states and memory of this model in a workspace.
    ///
    /// # Errors
    /// [`FemError::Refused`] where there is not enough memory.
    pub fn continuation<'w>(
        &self,
        workspace: &'w mut Workspace,
    ) -> Result<&'w mut Continuation<D::Body>, FemError> {
        workspace.try_state(&self.id, || self.divided.at_rest().map(Continuation::new))
    }

    /// The same where the workspace has them already.
    pub fn known<'w>(&self, workspace: &'w Workspace) -> Option<&'w Continuation<D::Body>> {
        workspace.get(&self.id)
    }

    /// The body in an equilibrium.
    pub(crate) fn led_to<'w>(
        &self,
        workspace: &'w mut Workspace,
        given: Given,
    ) -> Result<&'w mut Continuation<D::Body>, FemError> {
        let c = self.continuation(workspace)?;
        match given {
            Given::PressureAndContraction { pressure_mpa, contraction } => c.reach(pressure_mpa, contraction),
            Given::PressureAndPull { pressure_mpa, force_n } => c.reach_force(force_n, pressure_mpa),
            Given::ContractionAndPull { contraction, force_n } => c.reach_pressure(force_n, contraction),
        }?;
        Ok(c)
    }
}

impl<D: Divided> ForceModel for FiniteElements<D> {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        Ok(self.led_to(workspace, Given::at(pressure_mpa, contraction))?.body.response(self.muscle())?)
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        Ok(self.led_to(workspace, Given::at(pressure_mpa, contraction))?.pull())
    }

    fn extensions(&self) -> Extensions<'_> {
        D::extensions(self)
    }

    fn pressure_at_pull(&self, workspace: &mut Workspace, force_n: f64, contraction: f64) -> Option<f64> {
        let found = self.reach(workspace, Given::ContractionAndPull { contraction, force_n });
        let found = found.ok().map(|found| found.pressure_mpa).filter(|p| *p >= 0.0)?;
        let c = self.continuation(workspace).ok()?;
        let near = self.divided.near_smaller(found, force_n, contraction);
        let reached = near.filter(|near| c.reach_pressure_from(*near, force_n, contraction).is_ok());
        let smaller = reached.map(|_| c.body.state().pressure).filter(|p| *p >= 0.0);
        Some(smaller.map_or(found, |p| p.min(found)))
    }

    fn contraction_at_pull(&self, workspace: &mut Workspace, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        let found = self.reach(workspace, Given::PressureAndPull { pressure_mpa, force_n });
        found.ok().map(|found| found.contraction)
    }
}

/// A finite-element model of a muscle.
pub trait Simulation: ForceModel {
    /// An equilibrium with everything that is known of it.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::OutOfReach`] where the muscle cannot carry the pull.
    fn solve(&self, workspace: &mut Workspace, given: Given) -> Result<Solution, FemError>;

    /// The same without what needs its tangent.
    fn reach(&self, workspace: &mut Workspace, given: Given) -> Result<CurvePoint, FemError>;

    /// A test: a point for each of `values`. Where the pull is above the blocked force an isotonic contraction is below zero.
    fn run(
        &self,
        workspace: &mut Workspace,
        test: Test,
        values: &[f64],
        detail: Detail,
        progress: &dyn Progress,
    ) -> Curve;
}

impl<D: Divided> Simulation for FiniteElements<D> {
    fn solve(&self, workspace: &mut Workspace, given: Given) -> Result<Solution, FemError> {
        self.led_to(workspace, given)?.body.solution(self.muscle())
    }

    fn reach(&self, workspace: &mut Workspace, given: Given) -> Result<CurvePoint, FemError> {
        let before = self.known(workspace).map(|c| c.effort).unwrap_or_default();
        Ok(CurvePoint::here(self.led_to(workspace, given)?, before))
    }

    fn run(
        &self,
        workspace: &mut Workspace,
        test: Test,
        values: &[f64],
        detail: Detail,
        progress: &dyn Progress,
    ) -> Curve {
        let muscle = self.muscle();
        let c = match self.continuation(workspace) {
            Ok(c) => c,
            Err(error) => return vec![Err(error); values.len()],
        };
        run(c, values, test, progress, |c, point| {
            if detail >= Detail::Tangent {
                point.response = Some(c.body.response(muscle)?);
            }
            if detail >= Detail::Sensitivities {
                point.sensitivities = c.body.sensitivities(muscle)?;
            }
            Ok(())
        })
    }
}

/// Free contraction: ε without a pull.
pub fn free_contraction(
    model: &dyn Simulation,
    workspace: &mut Workspace,
    pressure_mpa: f64,
) -> Result<f64, FemError> {
    if pressure_mpa == 0.0 && model.muscle().tube().prestretch == 1.0 {
        return Ok(0.0);
    }
    Ok(model.reach(workspace, Given::PressureAndPull { pressure_mpa, force_n: 0.0 })?.contraction)
}
