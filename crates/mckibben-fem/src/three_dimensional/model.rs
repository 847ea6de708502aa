//! The three-dimensional muscle as a force model.

use super::discretisation::Discretisation;
use super::mesh::{BrickMesh, BrickSpec};
use super::muscle::{MuscleInBricks, MuscleMesh};
use crate::FemError;
use crate::axisymmetric::Axisymmetric;
use crate::simulation::{Discretised, Given, MuscleBody, Simulation};
use crate::solver::continuation::Continuation;
use mckibben::model::{
    Accuracy, Extensions, ForceModel, Inverse, Mesh, ModelEntry, ModelError, ModelId, ModelInfo, ModelRange,
    Reference, Response, Workspace,
};
use mckibben::muscle::Muscle;

pub(crate) const ENTRY: ModelEntry = ModelEntry {
    name: "fe3d",
    description: "three-dimensional finite elements: bricks and single strands; the reference for fe",
    source: "three-dimensional finite elements (one eighth in mixed bricks, strands between their nodes, bonded terminals)",
};

/// Three-dimensional finite elements (`--model fe3d`): one eighth in bricks of any law, strands between their nodes along
/// both diagonals, terminals as rigid planes or as plugs ([`super::Plug`]), pressure as −P·V.
///
/// D0 and L0 are the muscle's; the strands lie at the angle of the mesh ([`ThreeDimensional::mesh`] tells it), or at θ0
/// with another length ([`super::Match::Angle`]). The last equilibria are kept in the workspace.
#[derive(Debug, Clone)]
pub struct ThreeDimensional {
    id: ModelId,
    info: ModelInfo,
    divided: MuscleMesh,
    /// The limit of fine meshes and many strands.
    limit: Axisymmetric,
}

impl ThreeDimensional {
    /// The model of a muscle with a mesh of the program's choice.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh.
    pub fn new(muscle: &Muscle) -> Result<Self, FemError> {
        Self::with_mesh(muscle, &BrickSpec::default())
    }

    /// The model of a muscle with a mesh that is said.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh, or one of another braid.
    pub fn with_mesh(muscle: &Muscle, spec: &BrickSpec) -> Result<Self, FemError> {
        BrickMesh::check_angle(muscle, spec)?;
        let divided = MuscleMesh::new(muscle, spec)?;
        // What an insertion adds has no limit to compare with.
        let accuracy = match divided.mesh.plug.as_ref().is_some_and(|p| p.insertion_mm > 0.0) {
            true => Accuracy::UNKNOWN,
            false => Accuracy::share(0.0, Reference::Equations),
        };
        let info = ModelInfo {
            range: ModelRange::open().stretched(muscle.braid().angle_deg),
            accuracy,
            costly: true,
            notes: notes(&divided, muscle),
            ..ModelInfo::new(&ENTRY, muscle)
        };
        Ok(Self { id: ModelId::new(), info, divided, limit: Axisymmetric::new(muscle)? })
    }

    /// The grid at rest.
    pub fn mesh(&self) -> &BrickMesh {
        &self.divided.mesh
    }

    /// The unknowns and what they are made of.
    pub fn discretisation(&self) -> &Discretisation {
        &self.divided.discretisation
    }
}

impl Discretised for ThreeDimensional {
    type Body = MuscleInBricks;

    fn continuation<'w>(
        &self,
        workspace: &'w mut Workspace,
    ) -> Result<&'w mut Continuation<MuscleInBricks>, FemError> {
        workspace.try_of(&self.id, || self.divided.at_rest().map(Continuation::new))
    }

    fn known<'w>(&self, workspace: &'w Workspace) -> Option<&'w Continuation<MuscleInBricks>> {
        workspace.get(&self.id)
    }
}

/// What of the mesh is not as of the muscle.
fn notes(divided: &MuscleMesh, muscle: &Muscle) -> Vec<String> {
    let (mesh, angle) = (&*divided.mesh, muscle.braid().angle_deg);
    let mut out = Vec::new();
    let degrees = |rad: f64| format!("{:.2}°", rad.to_degrees());
    if (mesh.tube.angle_rad.to_degrees() - angle).abs() > 0.005 {
        let meshed = degrees(mesh.tube.angle_rad);
        out.push(format!("the strands of the mesh lie at {meshed}, those of the braid at {angle}°"));
    }
    if (mesh.last_angle_rad - mesh.tube.angle_rad).abs() > 0.01 {
        let last = degrees(mesh.last_angle_rad);
        out.push(format!("in the last row of bricks at the terminal the strands lie at {last}"));
    }
    let (length, meshed) = (muscle.length_mm(), 2.0 * mesh.tube.half_mm);
    if (meshed - length).abs() > 1e-6 * length {
        out.push(format!("the mesh is {meshed:.2} mm long, the muscle {length} mm"));
    }
    if let Some(plug) = &mesh.plug {
        let (name, insertion, nose) = (plug.material.name(), plug.insertion_mm, plug.nose_mm);
        let assumed = if divided.insertion_assumed {
            " (assumed, because it is not stated; it reduces the pull by about 5 %)"
        } else {
            ""
        };
        out.push(format!(
                "the terminal is a plug ({name}) with {insertion} mm in the tube{assumed} and a nose of {nose} mm radius"
            ));
    }
    out
}

impl ForceModel for ThreeDimensional {
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
        Extensions {
            inverse: Some(self),
            mesh: Some(self),
            companion: Some(&self.limit),
            ..Extensions::default()
        }
    }
}

impl Inverse for ThreeDimensional {
    fn pressure_at_pull(&self, workspace: &mut Workspace, force_n: f64, contraction: f64) -> Option<f64> {
        let found = self.reach(workspace, Given::ContractionAndPull { contraction, force_n });
        found.ok().map(|found| found.pressure_mpa).filter(|p| *p >= 0.0)
    }

    fn contraction_at_pull(&self, workspace: &mut Workspace, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        let found = self.reach(workspace, Given::PressureAndPull { pressure_mpa, force_n });
        found.ok().map(|found| found.contraction)
    }
}

impl Mesh for ThreeDimensional {
    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, ModelError> {
        self.limit.blocked_scale_n(workspace, pressure_mpa)
    }

    /// The difference from the axisymmetric limit at the point itself.
    fn mesh_error_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
        blocked_n: f64,
    ) -> Option<f64> {
        let own = self.limit.mesh_error_n(workspace, pressure_mpa, contraction, force_n, blocked_n)?;
        Some(own + self.limit.difference_n(workspace, pressure_mpa, contraction, force_n))
    }

    fn findings(&self, workspace: &Workspace) -> Vec<String> {
        let unstable = self.known(workspace).and_then(|c| c.unstable().first());
        let said = unstable.map(|u| {
            let met = match u.step {
                0 => "an equilibrium".to_owned(),
                n => format!("step {n} of the walk from rest"),
            };
            format!(
                "{met} is not stable ({} directions) at contraction {:.4} and {:.4} MPa",
                u.directions, u.contraction, u.pressure_mpa
            )
        });
        said.into_iter().collect()
    }
}
