//! The axisymmetric muscle as a force model.

use super::discrete::{Discrete, Make};
use super::engine::Engine;
use super::equilibrium::Control;
use super::error::FemError;
use super::mesh::{Mesh, MeshSpec};
use super::results::Solution;
use super::sensitivity;
use crate::solver::newton::{Effort, Stopped};
use mckibben::model::{
    Accuracy, ForceModel, ModelError, ModelId, ModelRange, Response, ThickWall, Workspace,
};
use mckibben::muscle::Muscle;
use std::sync::Arc;

/// Axisymmetric finite elements (`--model fe`): Q2/P−1 rubber of any law, two strand families bonded to the outer
/// surface, rigid terminals, pressure as −P·V.
///
/// The last equilibria are kept in the workspace, so that neighbouring questions are cheap.
#[derive(Debug, Clone)]
pub struct Axisymmetric {
    id: ModelId,
    muscle: Muscle,
    discrete: Arc<Discrete>,
    thick_wall: Arc<ThickWall>,
}

impl Axisymmetric {
    /// The model of a muscle with a mesh of the program's choice.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn new(muscle: &Muscle) -> Result<Self, FemError> {
        Self::with_mesh(muscle, &MeshSpec::default())
    }

    /// The model of a muscle with a mesh that is said.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn with_mesh(muscle: &Muscle, spec: &MeshSpec) -> Result<Self, FemError> {
        let tube = muscle.tube();
        let half = 0.5 * tube.length_mm;
        let division = spec.resolve(tube.outer_radius_mm(), tube.wall_mm, half)?;
        let mesh = Mesh::tube(tube.inner_radius_mm(), tube.outer_radius_mm(), half, division);
        Ok(Self {
            id: ModelId::new(),
            discrete: Arc::new(Discrete::new(mesh, Make::of(muscle))?),
            thick_wall: Arc::new(ThickWall::new(muscle)),
            muscle: muscle.clone(),
        })
    }

    /// The states and memory of this model in a workspace.
    pub(crate) fn engine<'w>(&self, workspace: &'w mut Workspace) -> &'w mut Engine {
        workspace.of(&self.id, || Engine::new(self.discrete.clone(), self.thick_wall.clone()))
    }

    /// Newton iterations, factorisations and residuals spent with a workspace.
    pub fn effort(&self, workspace: &Workspace) -> Effort {
        workspace.get::<Engine>(&self.id).map(|e| e.walker.effort).unwrap_or_default()
    }

    /// Everything known at a pressure in MPa and a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        let e = self.engine(workspace);
        e.reach(pressure_mpa, contraction)?;
        Solution::of(&mut e.walker.body, &self.muscle)
    }

    /// The equilibrium with a given pull in N at a pressure in MPa; its contraction is sought.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError> {
        let e = self.engine(workspace);
        self.reach_force(e, force_n, pressure_mpa)?;
        Solution::of(&mut e.walker.body, &self.muscle)
    }

    /// Goes to the equilibrium with a given pull and pressure.
    pub(crate) fn reach_force(&self, e: &mut Engine, force: f64, pressure: f64) -> Result<(), FemError> {
        let highest = 1.2 * self.muscle.max_ideal_contraction();
        let guess = e.guessed_contraction(force, pressure, highest).unwrap_or(0.0);
        // The ends take a share of the endless muscle's contraction.
        let mut contraction = 0.85 * guess;
        let length = 2.0 * e.half_length();
        close_in(e, force, |e| {
            e.reach(pressure, contraction)?;
            let (pull, stiffness) = (e.walker.body.totals.pull, 0.5 * e.tangent_stiffness()?);
            // dF/dε = −L0 ∂F/∂L; a step of at most a twentieth of the length.
            let step = (pull - force) / (length * stiffness.max(1e-3 * pull.abs() / length));
            contraction += step.clamp(-0.05, 0.05);
            Ok(Control::Force(force))
        })
    }

    /// The equilibrium with a given pull in N at a contraction; its pressure is sought. P′ is the one without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn at_pressure_for(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        let e = self.engine(workspace);
        self.reach_pressure(e, force_n, contraction)?;
        Solution::of(&mut e.walker.body, &self.muscle)
    }

    fn reach_pressure(&self, e: &mut Engine, force: f64, contraction: f64) -> Result<(), FemError> {
        let ideal = mckibben::model::Ideal::new(&self.muscle).pull(1.0, contraction).max(1.0);
        let start = e.pulling_pressure(contraction).unwrap_or(0.0) + force.max(0.0) / ideal;
        let scale = 1e-3 * e.walker.body.discrete.shear;
        let mut pressure = 1.4 * start + scale;
        let terminal = -contraction * e.half_length();
        close_in(e, force, |e| {
            e.reach(pressure, contraction)?;
            let (pull, slope) = (e.walker.body.totals.pull, e.tangent_per_pressure()?);
            let step = (force - pull) / slope;
            let largest = 0.5 * pressure.abs() + scale;
            pressure += if slope > 0.0 { step.clamp(-largest, largest) } else { largest };
            Ok(Control::Pressure { terminal, force })
        })
    }
}

/// Steps towards a pull by single equilibria until Newton's method with the pull held takes over.
fn close_in(
    e: &mut Engine,
    force: f64,
    mut step: impl FnMut(&mut Engine) -> Result<Control, FemError>,
) -> Result<(), FemError> {
    const STEPS: usize = 12;
    let mut reason = Stopped::Iterations { iterations: STEPS, residual: f64::INFINITY };
    for _ in 0..STEPS {
        let control = step(e)?;
        match e.walker.solve(control) {
            Ok(()) if e.stable_under(control) => {
                e.keep();
                return Ok(());
            }
            Ok(()) => {}
            Err(stop) => reason = stop,
        }
    }
    Err(FemError::Force { force_n: force, reason })
}

impl ForceModel for Axisymmetric {
    fn name(&self) -> &str {
        "fe"
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        "axisymmetric finite elements (Q2/P−1, two strand families bonded to the outer surface, rigid terminals)"
    }

    fn range(&self) -> ModelRange {
        ModelRange::open()
    }

    fn accuracy(&self) -> Accuracy {
        Accuracy::share(
            0.034,
            "twice the 1.7 % rms by which it misses the one measured muscle at hand (Tondu 2012, 20°, one modulus fitted); discretisation adds less than 0.05 %",
        )
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        let e = self.engine(workspace);
        e.reach(pressure_mpa, contraction)
            .and_then(|()| Solution::response(&mut e.walker.body, &self.muscle))
            .map_err(|e| e.into_model(pressure_mpa, contraction))
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        let e = self.engine(workspace);
        e.reach(pressure_mpa, contraction).map_err(|e| e.into_model(pressure_mpa, contraction))?;
        Ok(e.walker.body.totals.pull)
    }

    fn force_by(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        let e = self.engine(workspace);
        let known = e
            .reach(pressure_mpa, contraction)
            // The tangent of this very state, factorised.
            .and_then(|()| e.tangent_stiffness())
            .and_then(|_| {
                sensitivity::of(&mut e.walker.body, &self.muscle, |name| names.iter().any(|n| n == name))
            });
        let known = match known {
            Ok(known) => known,
            Err(error) => return Some(Err(error.into_model(pressure_mpa, contraction))),
        };
        let one = |name: &String| known.iter().find(|s| s.name == *name).map(|s| s.force_n_per_unit);
        names.iter().map(one).collect::<Option<Vec<f64>>>().map(Ok)
    }

    fn pressure_in_closed_form(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Option<Result<f64, ModelError>> {
        let e = self.engine(workspace);
        self.reach_pressure(e, force_n, contraction).ok()?;
        Some(e.walker.body.state.pressure).filter(|p| *p >= 0.0).map(Ok)
    }

    fn contraction_in_closed_form(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Option<Result<f64, ModelError>> {
        let e = self.engine(workspace);
        self.reach_force(e, force_n, pressure_mpa).ok()?;
        Some(-e.walker.body.state.terminal / e.half_length()).filter(|e| *e >= 0.0).map(Ok)
    }
}
