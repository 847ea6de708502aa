//! The axisymmetric muscle as a force model.

use super::body::Body;
use super::discretisation::{Discretisation, Problem};
use super::memory::Memory;
use super::mesh::{Mesh, MeshSpec};
use super::{results, sensitivity};
use crate::FemError;
use crate::results::{Sensitivity, Solution};
use crate::simulation::{self, Discretised, MuscleBody};
use crate::solver::continuation::Continuation;
use mckibben::model::{
    Accuracy, ForceModel, ModelError, ModelId, ModelRange, Reference, Response, ThickWall, Workspace,
};
use mckibben::muscle::Muscle;
use std::sync::Arc;

/// Error of the default mesh over the blocked force, of a muscle that pulls; of a stretched one over its pull. Both hold more than 95 % of
/// random muscles, as `docs/finite-elements.md` counts them.
const MESH_ERROR: f64 = 0.0009;
const MESH_ERROR_STRETCHED: f64 = 0.003;

/// Axisymmetric finite elements (`--model fe`): Q2/P−1 rubber of any law, two strand families bonded to the outer
/// surface, rigid terminals, pressure as −P·V.
///
/// The last equilibria are kept in the workspace, so that neighbouring questions are cheap.
#[derive(Debug, Clone)]
pub struct Axisymmetric {
    id: ModelId,
    muscle: Muscle,
    discretisation: Arc<Discretisation>,
    thick_wall: Arc<ThickWall>,
    /// The default mesh, for one that was said.
    default: Option<Box<Axisymmetric>>,
}

impl Axisymmetric {
    /// The model of a muscle with a mesh of the program's choice.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh.
    pub fn new(muscle: &Muscle) -> Result<Self, FemError> {
        Self::with_mesh(muscle, &MeshSpec::default())
    }

    /// The model of a muscle with a mesh that is said.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh; [`FemError::Conditioning`] of a muscle that was cycled at a pressure at which it has
    /// no equilibrium.
    pub fn with_mesh(muscle: &Muscle, spec: &MeshSpec) -> Result<Self, FemError> {
        let tube = muscle.tube();
        let half = 0.5 * tube.length_mm;
        let division = spec.resolve(tube.outer_radius_mm(), tube.wall_mm, half)?;
        let mesh = Mesh::tube(tube.inner_radius_mm(), tube.outer_radius_mm(), half, division);
        let thick_wall = Arc::new(ThickWall::new(muscle));
        let mut discretisation = Discretisation::new(mesh, Problem::of(muscle))?;
        discretisation.memory = match tube.rubber.conditioned_alike() {
            Some((softening, seen_mpa)) => {
                let mut memory = Memory::new(softening, &discretisation);
                memory.seen_mpa.iter_mut().flatten().for_each(|seen| *seen = seen_mpa);
                Some(memory)
            }
            None => Memory::of(muscle, &discretisation, &thick_wall)?,
        };
        Ok(Self {
            id: ModelId::new(),
            discretisation: Arc::new(discretisation),
            thick_wall,
            default: if *spec == MeshSpec::default() { None } else { Some(Box::new(Self::new(muscle)?)) },
            muscle: muscle.clone(),
        })
    }

    /// How far a pull in N that another mesh gave is from this one's; 0 where the muscle hangs slack, which leaves nothing to compare.
    pub(crate) fn difference_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
    ) -> f64 {
        let own = self.force_n(workspace, pressure_mpa, contraction).unwrap_or(force_n);
        if force_n > 0.0 { (force_n - own).abs() } else { 0.0 }
    }

    /// The unknowns and what they are made of.
    pub fn discretisation(&self) -> &Discretisation {
        &self.discretisation
    }
}

impl Axisymmetric {
    /// At a pressure in MPa and a contraction, with the tangent of this very state factorised.
    pub(super) fn factorised<'w>(
        &self,
        workspace: &'w mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<&'w mut Continuation<Body>, FemError> {
        let c = self.continuation(workspace)?;
        c.reach(pressure_mpa, contraction)?;
        let force_n = c.pull();
        c.body.factorise().map_err(|reason| FemError::at_force(force_n, reason))?;
        Ok(c)
    }
}

impl Discretised for Axisymmetric {
    type Body = Body;

    fn continuation<'w>(&self, workspace: &'w mut Workspace) -> Result<&'w mut Continuation<Body>, FemError> {
        let budget = workspace.budget().clone();
        let c = workspace.of(&self.id, || {
            Continuation::new(Body::of_muscle(self.discretisation.clone(), self.thick_wall.clone()))
        });
        c.budget = budget;
        Ok(c)
    }

    fn known<'w>(&self, workspace: &'w Workspace) -> Option<&'w Continuation<Body>> {
        workspace.get(&self.id)
    }
}

impl MuscleBody for Body {
    fn response(&mut self, muscle: &Muscle) -> Result<Response, FemError> {
        results::response(self, muscle)
    }

    fn solution(&mut self, muscle: &Muscle) -> Result<Solution, FemError> {
        results::solution(self, muscle)
    }

    fn sensitivities(&mut self, muscle: &Muscle) -> Result<Vec<Sensitivity>, FemError> {
        if self.discretisation.memory.is_some() { Ok(vec![]) } else { sensitivity::all(self, muscle) }
    }
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
        ModelRange::open().stretched(self.muscle().braid().angle_deg)
    }

    fn notes(&self, _: &Workspace) -> Vec<String> {
        vec![]
    }

    fn accuracy(&self) -> Accuracy {
        Accuracy::share(0.0, Reference::Equations)
    }

    fn mesh_error_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
        blocked_n: f64,
    ) -> Option<f64> {
        let own =
            if contraction < 0.0 { MESH_ERROR_STRETCHED * force_n.abs() } else { MESH_ERROR * blocked_n };
        let off =
            self.default.as_deref().map(|m| m.difference_n(workspace, pressure_mpa, contraction, force_n));
        Some(own + off.unwrap_or(0.0))
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        simulation::response(self, workspace, pressure_mpa, contraction)
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        simulation::force_n(self, workspace, pressure_mpa, contraction)
    }

    fn force_by(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        // What the rubber has seen goes by the constants as well.
        if self.discretisation.memory.is_some() {
            return None;
        }
        let mut known = || {
            let c = self.factorised(workspace, pressure_mpa, contraction)?;
            sensitivity::of(&mut c.body, &self.muscle, |name| names.iter().any(|n| n == name))
        };
        let known = match known() {
            Ok(known) => known,
            Err(error) => return Some(Err(error.into())),
        };
        let one = |name: &String| known.iter().find(|s| s.name == *name).map(|s| s.force_n_per_unit);
        names.iter().map(one).collect::<Option<Vec<f64>>>().map(Ok)
    }

    fn pivoting_n_per_mm(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        Ok(self.contact(workspace, pressure_mpa, contraction)?.pivoting_n_per_mm)
    }

    fn is_costly(&self) -> bool {
        true
    }

    fn pressure_under_load(&self, workspace: &mut Workspace, force_n: f64, contraction: f64) -> Option<f64> {
        simulation::pressure(self, workspace, force_n, contraction)
    }

    fn contraction_under_load(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Option<f64> {
        simulation::contraction(self, workspace, force_n, pressure_mpa)
    }
}
