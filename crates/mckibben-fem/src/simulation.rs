//! What finite-element models have in common beyond [`ForceModel`]: whole solutions and tests.

use crate::axisymmetric::{Axisymmetric, MeshSpec, Solution, TangentPoint};
use crate::FemError;
use crate::three_dimensional::{BrickSpec, ThreeDimensional};
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;

/// A finite-element model of a muscle.
pub trait Simulation: ForceModel {
    /// Everything known at a pressure in MPa and a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError>;

    /// The equilibrium with a given pull in N at a pressure in MPa; its contraction is sought.
    ///
    /// # Errors
    /// [`FemError`].
    fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError>;

    /// Free contraction: ε without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError>;

    /// Isometric test at one contraction and the given pressures (MPa), with stiffness and ∂F/∂P, and ∂F/∂(constants and
    /// measures) where they are asked for and the model has them.
    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
    ) -> Vec<Result<TangentPoint, FemError>>;
}

impl Simulation for Axisymmetric {
    fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        Axisymmetric::solve(self, workspace, pressure_mpa, contraction)
    }

    fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError> {
        Axisymmetric::at_force(self, workspace, force_n, pressure_mpa)
    }

    fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        Axisymmetric::free_contraction(self, workspace, pressure_mpa)
    }

    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
    ) -> Vec<Result<TangentPoint, FemError>> {
        Axisymmetric::isometric_with_tangents(self, workspace, contraction, pressures_mpa, sensitivities)
    }
}

impl Simulation for ThreeDimensional {
    fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        ThreeDimensional::solve(self, workspace, pressure_mpa, contraction)
    }

    fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError> {
        ThreeDimensional::at_force(self, workspace, force_n, pressure_mpa)
    }

    fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        ThreeDimensional::free_contraction(self, workspace, pressure_mpa)
    }

    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        _: bool,
    ) -> Vec<Result<TangentPoint, FemError>> {
        ThreeDimensional::isometric_with_tangents(self, workspace, contraction, pressures_mpa)
    }
}

/// Which finite elements, and how fine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Elements {
    /// Axisymmetric.
    Axisymmetric(MeshSpec),
    /// Three-dimensional.
    ThreeDimensional(BrickSpec),
}

impl Elements {
    /// The word for `--model`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Axisymmetric(_) => "fe",
            Self::ThreeDimensional(_) => "fe3d",
        }
    }

    /// The model of a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn build(&self, muscle: &Muscle) -> Result<Box<dyn Simulation>, FemError> {
        Ok(match self {
            Self::Axisymmetric(spec) => Box::new(Axisymmetric::with_mesh(muscle, spec)?),
            Self::ThreeDimensional(spec) => Box::new(ThreeDimensional::with_mesh(muscle, spec)?),
        })
    }
}
