//! What finite-element models have in common: solutions, tests, searches.

use crate::FemError;
use crate::axisymmetric::{Axisymmetric, MeshSpec};
use crate::results::{Sensitivity, Solution, TangentPoint};
use crate::seated::seated;
use crate::solver::body::Body;
use crate::solver::continuation::Continuation;
use crate::solver::curve::{Curve, CurvePoint, Test, run};
use crate::solver::newton::Effort;
use crate::three_dimensional::{BrickMesh, BrickSpec, ThreeDimensional};
use mckibben::budget::{Budget, Resource};
use mckibben::model::{ForceModel, ModelError, Response, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// A body that is a muscle: what its present equilibrium tells.
pub trait MuscleBody: Body {
    /// The part that every model tells; factorises the tangent.
    ///
    /// # Errors
    /// [`FemError::Force`] where the tangent is singular.
    fn response(&mut self, muscle: &Muscle) -> Result<Response, FemError>;

    /// Everything; factorises the tangent.
    ///
    /// # Errors
    /// [`FemError::Force`] where the tangent is singular.
    fn solution(&mut self, muscle: &Muscle) -> Result<Solution, FemError>;

    /// ∂F/∂(constants and measures) with the tangent that [`MuscleBody::response`] has factorised; none where it does not know them.
    ///
    /// # Errors
    /// [`FemError`] where a neighbouring muscle cannot be assembled.
    fn sensitivities(&mut self, _muscle: &Muscle) -> Result<Vec<Sensitivity>, FemError> {
        Ok(vec![])
    }
}

/// A model whose workspace holds a continuation.
pub trait Discretised: ForceModel {
    /// The body that is led from equilibrium to equilibrium.
    type Body: MuscleBody;

    /// The states and memory of this model in a workspace.
    ///
    /// # Errors
    /// [`FemError::TooLarge`] where there is not enough memory.
    fn continuation<'w>(
        &self,
        workspace: &'w mut Workspace,
    ) -> Result<&'w mut Continuation<Self::Body>, FemError>;

    /// The same where the workspace has them already.
    fn known<'w>(&self, workspace: &'w Workspace) -> Option<&'w Continuation<Self::Body>>;
}

/// A finite-element model of a muscle. Pressures are in MPa, pulls in N.
pub trait Simulation: ForceModel {
    /// Everything known at a pressure and a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError>;

    /// The equilibrium with a given pull at a pressure, by Newton's method with the pull held; its contraction is sought.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::OutOfReach`] where the muscle cannot carry that pull.
    fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError>;

    /// The equilibrium with a given pull at a contraction, likewise; its pressure is sought. P′ is the one without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    fn at_pressure_for(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<Solution, FemError>;

    /// Contraction with a given pull at a pressure.
    ///
    /// # Errors
    /// As [`Simulation::at_force`].
    fn contraction_at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<f64, FemError>;

    /// Pressure in MPa with a given pull at a contraction.
    ///
    /// # Errors
    /// As [`Simulation::at_pressure_for`].
    fn pressure_at_force_mpa(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<f64, FemError>;

    /// Free contraction: ε without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    fn free_contraction(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, FemError> {
        // Without pressure every force is nil, and a muscle that nobody pulls is as long as at rest.
        if pressure_mpa == 0.0 { Ok(0.0) } else { self.contraction_at_force(workspace, 0.0, pressure_mpa) }
    }

    /// P′ in MPa: the pressure at which the muscle begins to pull at a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    fn starting_pressure_mpa(&self, workspace: &mut Workspace, contraction: f64) -> Result<f64, FemError> {
        self.pressure_at_force_mpa(workspace, 0.0, contraction)
    }

    /// Isometric test: F at one contraction and the given pressures. Runs from the highest pressure down.
    fn isometric(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve;

    /// [`Simulation::isometric`] with what the tangents tell, and ∂F/∂(constants and measures) where they are asked for and the model
    /// has them.
    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
        progress: &dyn Progress,
    ) -> Vec<Result<TangentPoint, FemError>>;

    /// Isobaric test: F at one pressure and the given contractions. Runs from the smallest contraction on.
    fn isobaric(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contractions: &[f64],
        progress: &dyn Progress,
    ) -> Curve;

    /// Isotonic test: ε under one pull at the given pressures. Where the pull is above the blocked force the contraction is below zero.
    /// Runs from the highest pressure down.
    fn isotonic(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve;

    /// Newton iterations, factorisations and residuals spent with a workspace.
    fn effort(&self, workspace: &Workspace) -> Effort;
}

/// A curve, or that there is no memory for it.
fn curve<M: Discretised, T: Clone>(
    model: &M,
    workspace: &mut Workspace,
    values: &[f64],
    go: impl FnOnce(&mut Continuation<M::Body>) -> Vec<Result<T, FemError>>,
) -> Vec<Result<T, FemError>> {
    match model.continuation(workspace) {
        Ok(c) => go(c),
        Err(error) => vec![Err(error); values.len()],
    }
}

impl<M: Discretised> Simulation for M {
    fn solve(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        let c = self.continuation(workspace)?;
        c.reach(pressure_mpa, contraction)?;
        c.body.solution(self.muscle())
    }

    fn at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Solution, FemError> {
        let c = self.continuation(workspace)?;
        c.reach_force(force_n, pressure_mpa)?;
        c.body.solution(self.muscle())
    }

    fn at_pressure_for(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<Solution, FemError> {
        let c = self.continuation(workspace)?;
        c.reach_pressure(force_n, contraction)?;
        c.body.solution(self.muscle())
    }

    fn contraction_at_force(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<f64, FemError> {
        let c = self.continuation(workspace)?;
        c.reach_force(force_n, pressure_mpa)?;
        Ok(c.contraction())
    }

    fn pressure_at_force_mpa(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Result<f64, FemError> {
        let c = self.continuation(workspace)?;
        c.reach_pressure(force_n, contraction)?;
        Ok(c.body.state().pressure)
    }

    fn isometric(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        curve(self, workspace, pressures_mpa, |c| {
            run(c, pressures_mpa, Test::Isometric(contraction), progress, |c, spent| {
                Ok(CurvePoint::here(c, spent))
            })
        })
    }

    fn isometric_with_tangents(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
        progress: &dyn Progress,
    ) -> Vec<Result<TangentPoint, FemError>> {
        let muscle = self.muscle();
        curve(self, workspace, pressures_mpa, |c| {
            run(c, pressures_mpa, Test::Isometric(contraction), progress, |c, spent| {
                let response = c.body.response(muscle)?;
                let sensitivities = if sensitivities { c.body.sensitivities(muscle)? } else { vec![] };
                Ok(TangentPoint { response, sensitivities, iterations: spent.iterations })
            })
        })
    }

    fn isobaric(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contractions: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        curve(self, workspace, contractions, |c| {
            run(c, contractions, Test::Isobaric(pressure_mpa), progress, |c, spent| {
                Ok(CurvePoint::here(c, spent))
            })
        })
    }

    fn isotonic(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressures_mpa: &[f64],
        progress: &dyn Progress,
    ) -> Curve {
        curve(self, workspace, pressures_mpa, |c| {
            run(c, pressures_mpa, Test::Isotonic(force_n), progress, |c, spent| {
                Ok(CurvePoint::here(c, spent))
            })
        })
    }

    fn effort(&self, workspace: &Workspace) -> Effort {
        self.known(workspace).map(|c| c.effort).unwrap_or_default()
    }
}

/// What a model answers as a [`ForceModel`]: the response at a pressure and a contraction.
pub(crate) fn response<M: Discretised>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    contraction: f64,
) -> Result<Response, ModelError> {
    let mut answer = || {
        let c = model.continuation(workspace)?;
        c.reach(pressure_mpa, contraction)?;
        c.body.response(model.muscle())
    };
    answer().map_err(|e: FemError| e.into())
}

/// The pull alone.
pub(crate) fn force_n<M: Discretised>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    contraction: f64,
) -> Result<f64, ModelError> {
    let mut answer = || {
        let c = model.continuation(workspace)?;
        c.reach(pressure_mpa, contraction)?;
        Ok(c.pull())
    };
    answer().map_err(|e: FemError| e.into())
}

/// The pressure at a pull, where there is one.
pub(crate) fn pressure<M: Discretised>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
) -> Option<f64> {
    model.pressure_at_force_mpa(workspace, force_n, contraction).ok().filter(|p| *p >= 0.0)
}

/// The contraction at a pull, where there is one.
pub(crate) fn contraction<M: Discretised>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
) -> Option<f64> {
    model.contraction_at_force(workspace, force_n, pressure_mpa).ok()
}

/// Nodes through the wall, around and along, bytes, and seconds of a factorisation, of one mesh of bricks that was measured
/// (`docs/finite-elements-3d.md`).
const MEASURED: ([f64; 3], f64, f64) = ([5.0, 81.0, 258.0], 1.6e9, 1.9);
/// Bytes of an unknown beside the factor: elements, maps and state.
const BYTES_BESIDE: f64 = 1500.0;

/// What the factor's entries and the operations of a factorisation grow with: nested dissection of a sheet of n points with w unknowns each
/// has w² n log n entries and w³ n^1.5 operations (George 1973 \[george1973\]).
fn dissected([through, around, along]: [f64; 3]) -> (f64, f64) {
    let sheet = around * along;
    (through.powi(2) * sheet * sheet.ln(), through.powi(3) * sheet.powf(1.5))
}

/// Factorisations of a point.
const POINT: f64 = 10.0;

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

    /// Refuses a mesh of a muscle that does not fit into a budget, before anything is allocated. The section's is small whatever it is.
    ///
    /// # Errors
    /// [`FemError`]: the budget's, or where the numbers give no valid mesh.
    pub fn admit(&self, muscle: &Muscle, budget: &Budget) -> Result<(), FemError> {
        let Self::ThreeDimensional(spec) = self else { return Ok(()) };
        let (tube, angle) = (muscle.tube(), muscle.braid().angle_rad());
        let (inner, outer) = (tube.inner_radius_mm(), tube.outer_radius_mm());
        let [through, around, along, bonded] =
            BrickMesh::count(inner, outer, 0.5 * tube.length_mm, angle, spec)?;
        let bricks = [through, around, along + bonded].map(|n| n as f64);
        budget.admit(Resource::Elements, bricks.iter().product())?;
        let nodes = bricks.map(|n| n * spec.brick.order() as f64 + 1.0);
        let (mesh, bytes, seconds) = MEASURED;
        let ((entries, operations), measured) = (dissected(nodes), dissected(mesh));
        let beside = BYTES_BESIDE * 3.0 * nodes.iter().product::<f64>();
        budget.admit(Resource::Bytes, beside + bytes * entries / measured.0)?;
        Ok(budget.admit(Resource::Seconds, POINT * seconds * operations / measured.1)?)
    }

    /// The model of a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh.
    pub fn build(&self, muscle: &Muscle) -> Result<Box<dyn Simulation>, FemError> {
        let inner = &*muscle.between_ends();
        let model: Box<dyn Simulation> = match self {
            Self::Axisymmetric(spec) => Box::new(Axisymmetric::with_mesh(inner, spec)?),
            Self::ThreeDimensional(spec) => Box::new(ThreeDimensional::with_mesh(inner, spec)?),
        };
        Ok(seated(model, muscle))
    }
}

impl fmt::Display for Elements {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no finite elements.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("\"{word}\" is not a finite-element model; there are {}", Elements::NAMES.join(" and "))]
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
