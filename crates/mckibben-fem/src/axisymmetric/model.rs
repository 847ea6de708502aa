//! The axisymmetric muscle as a force model.

use super::body::Body;
use super::discretisation::{Discretisation, Memory, Problem};
use super::mesh::{Mesh, MeshSpec};
use super::sensitivity;
use crate::FemError;
use crate::results::Sensitivity;
use crate::simulation::{Divided, FiniteElements, Given};
use mckibben::model::{
    self, Accuracy, Extensions, ForceModel, ModelEntry, ModelError, Reference, Response, Slopes, ThickWall,
    Workspace,
};
use mckibben::muscle::Muscle;
use std::sync::Arc;

pub(crate) const ENTRY: ModelEntry = ModelEntry {
    name: "fe",
    description: "axisymmetric finite elements: any rubber, wall, braid and length, with the ends; the default",
    source: "axisymmetric finite elements (Q2/P−1, two strand families bonded to the outer surface, rigid terminals)",
};

/// Error of the default mesh over the blocked force, of a muscle that pulls; of a stretched one over its pull. Both hold more than 95 % of
/// random muscles, as `docs/finite-elements.md` counts them.
const MESH_ERROR: f64 = 0.0009;
const MESH_ERROR_STRETCHED: f64 = 0.003;

/// A pressure that is so much larger than that of the infinitely long muscle may not be the smallest.
const FAR: f64 = 2.0;

/// Axisymmetric finite elements (`--model fe`): Q2/P−1 rubber of any law, two strand families bonded to the outer
/// surface, rigid terminals, pressure as −P·V.
pub type Axisymmetric = FiniteElements<MuscleSection>;

/// What of the axisymmetric muscle does not change.
#[derive(Debug, Clone)]
pub struct MuscleSection {
    /// The unknowns and what they are made of.
    pub discretisation: Arc<Discretisation>,
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
    /// [`FemError`] where the numbers give no valid mesh; [`FemError::Refused`] of a muscle that was cycled at a pressure at which it has
    /// no equilibrium.
    pub fn with_mesh(muscle: &Muscle, spec: &MeshSpec) -> Result<Self, FemError> {
        let tube = muscle.tube();
        let half = 0.5 * tube.length_mm;
        let division = spec.resolve(tube.outer_radius_mm(), tube.wall_mm, half)?;
        let mesh = Mesh::tube(tube.inner_radius_mm(), tube.outer_radius_mm(), half, division);
        let thick_wall = Arc::new(ThickWall::new(muscle));
        let mut discretisation = Discretisation::new(mesh, Problem::of(muscle))?;
        discretisation.memory = match muscle.rubber().conditioned_alike() {
            Some((softening, seen_mpa)) => {
                let mut memory = Memory::new(softening, &discretisation);
                memory.seen_mpa.iter_mut().flatten().for_each(|seen| *seen = seen_mpa);
                Some(memory)
            }
            None => Memory::of(muscle, &discretisation, &thick_wall)?,
        };
        let section = MuscleSection {
            discretisation: Arc::new(discretisation),
            thick_wall,
            default: if *spec == MeshSpec::default() { None } else { Some(Box::new(Self::new(muscle)?)) },
        };
        Ok(Self::of(section, muscle, Accuracy::share(0.0, Reference::Equations), vec![]))
    }

    /// How far a pull in N that another mesh gave is from this one's; 0 where the muscle hangs slack, which leaves nothing to compare.
    pub(crate) fn difference_n(&self, workspace: &mut Workspace, here: &Response) -> f64 {
        let Response { pressure_mpa, contraction, force_n, .. } = *here;
        let own = self.force_n(workspace, pressure_mpa, contraction).unwrap_or(force_n);
        if force_n > 0.0 { (force_n - own).abs() } else { 0.0 }
    }
}

impl Divided for MuscleSection {
    const ENTRY: ModelEntry = ENTRY;
    type Body = Body;

    fn at_rest(&self) -> Result<Body, FemError> {
        Ok(Body::of_muscle(self.discretisation.clone(), self.thick_wall.clone()))
    }

    fn extensions(model: &Axisymmetric) -> Extensions<'_> {
        let slopes = model.divided.discretisation.has_slopes().then_some(model as &dyn Slopes);
        Extensions { slopes, mesh: Some(model), contact: Some(model), ..Extensions::default() }
    }

    /// Soft strands let the pull rise and fall again with the pressure; the smaller of two is near that of the infinitely long muscle.
    fn near_smaller(&self, found_mpa: f64, force_n: f64, contraction: f64) -> Option<f64> {
        let near = self.thick_wall.pressure_at_pull(&mut Workspace::new(), force_n, contraction)?;
        (found_mpa > FAR * near).then_some(near)
    }
}

impl Slopes for Axisymmetric {
    fn force_by(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        let mut known = || {
            let c = self.led_to(workspace, Given::at(pressure_mpa, contraction))?;
            c.body.tangent()?;
            sensitivity::of(&mut c.body, self.muscle(), |name| names.iter().any(|n| n == name))
        };
        let one = |known: &[Sensitivity], name: &String| {
            known.iter().find(|s| s.name == *name).map(|s| s.force_n_per_unit)
        };
        let all =
            known().map(|known| names.iter().map(|name| one(&known, name)).collect::<Option<Vec<f64>>>());
        all.map_err(ModelError::from).transpose()
    }
}

impl model::Mesh for Axisymmetric {
    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, ModelError> {
        self.force_n(workspace, pressure_mpa, 0.0)
    }

    fn mesh_error_n(&self, workspace: &mut Workspace, here: &Response, blocked_n: f64) -> Option<f64> {
        let stretched = here.contraction < 0.0;
        let own = if stretched { MESH_ERROR_STRETCHED * here.force_n.abs() } else { MESH_ERROR * blocked_n };
        let off = self.divided.default.as_deref().map(|m| m.difference_n(workspace, here));
        Some(own + off.unwrap_or(0.0))
    }
}

impl model::Contact for Axisymmetric {
    fn pivoting_n_per_mm(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        Ok(self.contact(workspace, pressure_mpa, contraction)?.pivoting_n_per_mm)
    }
}
