//! What finite-element models have in common beyond [`ForceModel`]: whole solutions and tests.

use crate::axisymmetric::{Axisymmetric, FemError, Solution, TangentPoint};
use crate::three_dimensional::ThreeDimensional;
use mckibben::model::ForceModel;

/// A finite-element model of a muscle.
pub trait Simulation: ForceModel {
    /// Everything known at a pressure in MPa and a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    fn solve(&self, pressure_mpa: f64, contraction: f64) -> Result<Solution, FemError>;

    /// The equilibrium with a given pull in N at a pressure in MPa; its contraction is sought.
    ///
    /// # Errors
    /// [`FemError`].
    fn at_force(&self, force_n: f64, pressure_mpa: f64) -> Result<Solution, FemError>;

    /// Free contraction: ε without a pull.
    ///
    /// # Errors
    /// [`FemError`].
    fn free_contraction(&self, pressure_mpa: f64) -> Result<f64, FemError>;

    /// Isometric test at one contraction and the given pressures (MPa), with stiffness and ∂F/∂P, and ∂F/∂(constants and
    /// measures) where they are asked for and the model has them.
    fn isometric_with_tangents(
        &self,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
    ) -> Vec<Result<TangentPoint, FemError>>;
}

impl Simulation for Axisymmetric {
    fn solve(&self, pressure_mpa: f64, contraction: f64) -> Result<Solution, FemError> {
        Axisymmetric::solve(self, pressure_mpa, contraction)
    }

    fn at_force(&self, force_n: f64, pressure_mpa: f64) -> Result<Solution, FemError> {
        Axisymmetric::at_force(self, force_n, pressure_mpa)
    }

    fn free_contraction(&self, pressure_mpa: f64) -> Result<f64, FemError> {
        Axisymmetric::free_contraction(self, pressure_mpa)
    }

    fn isometric_with_tangents(
        &self,
        contraction: f64,
        pressures_mpa: &[f64],
        sensitivities: bool,
    ) -> Vec<Result<TangentPoint, FemError>> {
        Axisymmetric::isometric_with_tangents(self, contraction, pressures_mpa, sensitivities)
    }
}

impl Simulation for ThreeDimensional {
    fn solve(&self, pressure_mpa: f64, contraction: f64) -> Result<Solution, FemError> {
        ThreeDimensional::solve(self, pressure_mpa, contraction)
    }

    fn at_force(&self, force_n: f64, pressure_mpa: f64) -> Result<Solution, FemError> {
        ThreeDimensional::at_force(self, force_n, pressure_mpa)
    }

    fn free_contraction(&self, pressure_mpa: f64) -> Result<f64, FemError> {
        ThreeDimensional::free_contraction(self, pressure_mpa)
    }

    fn isometric_with_tangents(
        &self,
        contraction: f64,
        pressures_mpa: &[f64],
        _: bool,
    ) -> Vec<Result<TangentPoint, FemError>> {
        ThreeDimensional::isometric_with_tangents(self, contraction, pressures_mpa)
    }
}
