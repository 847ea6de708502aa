//! The three-dimensional muscle as a force model.

use super::Discrete;
use super::engine::{Engine, Fixed};
use super::mesh::{BrickMesh, BrickSpec};
use super::results;
use crate::axisymmetric::{FemError, Solution};
use crate::solver::newton::Effort;
use mckibben::model::{Accuracy, ForceModel, ModelError, ModelId, ModelRange, Response, Workspace};
use mckibben::muscle::Muscle;

/// Error of the program's own mesh over the blocked force, 95 % of questions.
const MESH_ERROR: f64 = 0.004;
const MESH_ERROR_BASIS: &str = "the mesh alone, against the axisymmetric limit of the same equations: 95 % of 2000 random questions (D0 14 to 50 mm, s 0.5 to 5 mm, L0 80 to 300 mm, 20 to 35 degrees, 0.05 to 0.25 MPa, contraction 0 to 20 %), the largest 1.7 %; no measured muscle is in it";

/// Three-dimensional finite elements (`--model fe3d`): one eighth in bricks of any law, strands between their nodes along
/// both diagonals, terminals as rigid planes or as plugs ([`super::Plug`]), pressure as −P·V.
///
/// D0 and L0 are the muscle's; the strands lie at the angle of the mesh ([`ThreeDimensional::mesh`] tells it), or at θ0
/// with another length ([`super::Match::Angle`]). The last equilibria are kept in the workspace.
#[derive(Debug, Clone)]
pub struct ThreeDimensional {
    id: ModelId,
    muscle: Muscle,
    fixed: Fixed,
}

impl ThreeDimensional {
    /// The model of a muscle with a mesh of the program's choice.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn new(muscle: &Muscle) -> Result<Self, FemError> {
        Self::with_mesh(muscle, &BrickSpec::default())
    }

    /// The model of a muscle with a mesh that is said.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn with_mesh(muscle: &Muscle, spec: &BrickSpec) -> Result<Self, FemError> {
        Ok(Self { id: ModelId::new(), muscle: muscle.clone(), fixed: Fixed::new(muscle, spec)? })
    }

    /// The states and memory of this model in a workspace.
    ///
    /// # Errors
    /// [`FemError::TooLarge`] where there is not enough memory.
    pub fn engine<'w>(&self, workspace: &'w mut Workspace) -> Result<&'w mut Engine, FemError> {
        workspace.try_of(&self.id, || Engine::of(&self.fixed))
    }

    /// The grid at rest.
    pub fn mesh(&self) -> &BrickMesh {
        &self.fixed.mesh
    }

    /// The unknowns and what they are made of.
    pub fn discrete(&self) -> &Discrete {
        self.fixed.discrete()
    }

    /// Newton iterations, factorisations and residuals spent with a workspace.
    pub fn effort(&self, workspace: &Workspace) -> Effort {
        workspace.get::<Engine>(&self.id).map(|e| e.effort).unwrap_or_default()
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
        let e = self.engine(workspace)?;
        e.reach(pressure_mpa, contraction)?;
        results::solution(&mut e.body, &e.mesh, &self.muscle)
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
        let e = self.engine(workspace)?;
        e.reach_force(force_n, pressure_mpa)?;
        results::solution(&mut e.body, &e.mesh, &self.muscle)
    }

    /// The equilibrium with a given pull in N at a contraction; its pressure is sought.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn at_pressure_for(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        let e = self.engine(workspace)?;
        e.reach_pressure(force_n, contraction)?;
        results::solution(&mut e.body, &e.mesh, &self.muscle)
    }

    /// Free contraction: ε without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        let e = self.engine(workspace)?;
        e.reach_force(0.0, pressure_mpa)?;
        Ok(e.contraction())
    }
}

impl ForceModel for ThreeDimensional {
    fn name(&self) -> &str {
        "fe3d"
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        "three-dimensional finite elements (one eighth in mixed bricks, strands between their nodes, bonded terminals)"
    }

    fn range(&self) -> ModelRange {
        ModelRange::open()
    }

    fn accuracy(&self) -> Accuracy {
        // What an insertion adds has no limit to be held against.
        match self.mesh().plug().is_some_and(|p| p.insertion_mm > 0.0) {
            true => Accuracy::UNKNOWN,
            false => Accuracy::share(MESH_ERROR, MESH_ERROR_BASIS),
        }
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        let (mesh, angle) = (self.mesh(), self.muscle.braid().angle_deg);
        let mut out = Vec::new();
        let degrees = |rad: f64| format!("{:.2}°", rad.to_degrees());
        if (mesh.angle_rad().to_degrees() - angle).abs() > 0.005 {
            let meshed = degrees(mesh.angle_rad());
            out.push(format!("the strands of the mesh lie at {meshed}, those of the braid at {angle}°"));
        }
        if (mesh.last_angle_rad() - mesh.angle_rad()).abs() > 0.01 {
            let last = degrees(mesh.last_angle_rad());
            out.push(format!("in the last row of bricks at the terminal the strands lie at {last}"));
        }
        let (length, meshed) = (self.muscle.length_mm(), 2.0 * mesh.half_length_mm());
        if (meshed - length).abs() > 1e-6 * length {
            out.push(format!("the mesh is {meshed:.2} mm long, the muscle {length} mm"));
        }
        if let Some(plug) = mesh.plug() {
            let (name, insertion, nose) = (plug.material.name(), plug.insertion_mm, plug.nose_mm);
            out.push(format!(
                    "the terminal is a plug ({name}) with {insertion} mm in the tube and a nose of {nose} mm radius"
                ));
        }
        if let Some(u) = workspace.get::<Engine>(&self.id).and_then(|e| e.unstable().first()) {
            let met = match u.step {
                0 => "an equilibrium".to_owned(),
                n => format!("step {n} of the walk from rest"),
            };
            out.push(format!(
                "{met} is not stable ({} directions) at contraction {:.4} and {:.4} MPa",
                u.directions, u.contraction, u.pressure_mpa
            ));
        }
        out
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        let mut respond = || {
            let e = self.engine(workspace)?;
            e.reach(pressure_mpa, contraction)?;
            results::response(&mut e.body, &e.mesh, &self.muscle)
        };
        respond().map_err(|e: FemError| e.into_model(pressure_mpa, contraction))
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        let e = self.engine(workspace).and_then(|e| e.reach(pressure_mpa, contraction).map(|()| e));
        e.map(|e| e.body.totals.pull).map_err(|e| e.into_model(pressure_mpa, contraction))
    }

    fn pressure_in_closed_form(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Option<Result<f64, ModelError>> {
        let e = self.engine(workspace).ok()?;
        e.reach_pressure(force_n, contraction).ok()?;
        Some(e.body.state.pressure).filter(|p| *p >= 0.0).map(Ok)
    }

    fn contraction_in_closed_form(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Option<Result<f64, ModelError>> {
        let e = self.engine(workspace).ok()?;
        e.reach_force(force_n, pressure_mpa).ok()?;
        Some(e.contraction()).filter(|e| *e >= 0.0).map(Ok)
    }
}
