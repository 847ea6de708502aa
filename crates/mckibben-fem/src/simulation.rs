//! What finite-element models have in common beyond [`ForceModel`]: whole solutions and tests.

use crate::axisymmetric::{Axisymmetric, FemError, MeshSpec, Solution, TangentPoint};
use crate::three_dimensional::{BrickMesh, BrickSpec, ThreeDimensional};
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

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
    /// Their names.
    pub const NAMES: [&'static str; 2] = ["fe", "fe3d"];

    /// Its name.
    pub fn name(&self) -> &'static str {
        let [section, bricks] = Self::NAMES;
        match self {
            Self::Axisymmetric(_) => section,
            Self::ThreeDimensional(_) => bricks,
        }
    }

    /// With the mesh that a text says, in the syntax of [`Elements::mesh_syntax`].
    ///
    /// # Errors
    /// [`MeshTextError`].
    pub fn with_mesh(self, text: &str) -> Result<Self, MeshTextError> {
        let unreadable = || MeshTextError::Syntax(self.mesh_syntax());
        match self {
            Self::Axisymmetric(_) => {
                let spec = MeshSpec::parse(text).ok_or_else(unreadable)?;
                // Whether it is a mesh does not depend on the size of the muscle.
                spec.resolve(10.0, 1.0, 100.0)?;
                Ok(Self::Axisymmetric(spec))
            }
            Self::ThreeDimensional(old) => {
                let spec = BrickSpec::parse(text).ok_or_else(unreadable)?;
                BrickMesh::check(&spec)?;
                Ok(Self::ThreeDimensional(BrickSpec { keep: old.keep, plug: old.plug, ..spec }))
            }
        }
    }

    /// How a mesh is written, in words.
    pub fn mesh_syntax(&self) -> &'static str {
        match self {
            Self::Axisymmetric(_) => {
                "elements along the half length (\"8\"), through the wall x along (\"2x8\"), or with a grading (\"2x8:2\")"
            }
            Self::ThreeDimensional(_) => {
                "bricks around the quarter (\"12\"), through the wall x around (\"2x12\"), or x along (\"2x12x39\")"
            }
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

impl fmt::Display for Elements {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no finite elements.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("\"{word}\" is no finite-element model; there are {}", Elements::NAMES.join(" and "))]
pub struct UnknownElements {
    /// The word.
    pub word: String,
}

impl FromStr for Elements {
    type Err = UnknownElements;

    /// By their name, with the usual mesh.
    fn from_str(word: &str) -> Result<Self, UnknownElements> {
        let all = [Self::Axisymmetric(MeshSpec::default()), Self::ThreeDimensional(BrickSpec::default())];
        let named = all.into_iter().find(|e| e.name() == word.trim());
        named.ok_or_else(|| UnknownElements { word: word.into() })
    }
}

/// Why a text is no mesh.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeshTextError {
    /// It is not written as a mesh; what it should be.
    #[error("expected {0}")]
    Syntax(&'static str),
    /// There is no such mesh.
    #[error(transparent)]
    Mesh(#[from] FemError),
}
