//! What finite-element models have in common: equilibria and tests.

use crate::{
    FemError,
    axisymmetric::Axisymmetric,
    results::{MuscleBody, Solution},
    solver::{
        body::Body as _,
        continuation::Continuation,
        curve::{Curve, CurvePoint, isometric},
    },
};
use mckibben_core::{
    model::{
        Accuracy, ForceModel, ModelEntry, ModelError, ModelId, ModelInfo, ModelRange, Response,
        Result, Workspace,
    },
    muscle::Muscle,
};

/// Error of the default mesh over the blocked force, of a muscle that pulls; of a stretched one
/// over its pull. Both hold more than 95 % of random muscles, as `docs/finite-elements.md` counts
/// them.
const MESH_ERROR: f64 = 0.0009;
const MESH_ERROR_STRETCHED: f64 = 0.003;

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
        Self::PressureAndContraction {
            pressure_mpa,
            contraction,
        }
    }

    /// The pressure in MPa, where it is given.
    pub fn pressure_mpa(self) -> Option<f64> {
        match self {
            Self::PressureAndContraction { pressure_mpa, .. }
            | Self::PressureAndPull { pressure_mpa, .. } => Some(pressure_mpa),
            Self::ContractionAndPull { .. } => None,
        }
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
    type Body: MuscleBody + Send + Sync + 'static;

    /// The muscle at rest.
    ///
    /// # Errors
    /// [`FemError::Refused`] where there is not enough memory.
    fn at_rest(&self) -> Result<Self::Body, FemError>;

    /// The model itself, where it is that of the section, which computes slopes and the strands'
    /// contact.
    fn section(_model: &FiniteElements<Self>) -> Option<&Axisymmetric> {
        None
    }

    /// The section that its answers tend to with finer meshes and more strands.
    fn limit(&self) -> Option<&Axisymmetric> {
        None
    }

    /// The section with the default mesh, from whose pull that of its mesh is measured.
    fn reference(&self) -> Option<&Axisymmetric> {
        self.limit()
    }
}

/// A force model by finite elements. The last equilibria are kept in the workspace, so that
/// neighbouring questions are cheap.
#[derive(Debug, Clone)]
pub struct FiniteElements<D> {
    id: ModelId,
    info: ModelInfo,
    /// The muscle in elements.
    pub divided: D,
}

impl<D: Divided> FiniteElements<D> {
    pub(crate) fn from_divided(
        divided: D,
        muscle: &Muscle,
        accuracy: Accuracy,
        notes: Vec<String>,
    ) -> Self {
        let info = ModelInfo {
            range: ModelRange::open().stretched(muscle.braid().angle_deg),
            accuracy,
            costly: true,
            notes,
            ..ModelInfo::new(&D::ENTRY, muscle)
        };
        Self {
            id: ModelId::new(),
            info,
            divided,
        }
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
            Given::PressureAndContraction {
                pressure_mpa,
                contraction,
            } => c.reach(pressure_mpa, contraction),
            Given::PressureAndPull {
                pressure_mpa,
                force_n,
            } => c.reach_force(force_n, pressure_mpa),
            Given::ContractionAndPull {
                contraction,
                force_n,
            } => c.reach_pressure(force_n, contraction),
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
    ) -> Result<Response> {
        Ok(self
            .led_to(workspace, Given::at(pressure_mpa, contraction))?
            .body
            .response(self.muscle())?)
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64> {
        Ok(self
            .led_to(workspace, Given::at(pressure_mpa, contraction))?
            .pull())
    }

    fn has_slopes(&self) -> bool {
        D::section(self).is_some_and(|section| section.divided.discretisation.has_slopes())
    }

    fn force_by(
        &self,
        w: &mut Workspace,
        p: f64,
        e: f64,
        names: &[String],
    ) -> Result<Option<Vec<f64>>> {
        let section = D::section(self).filter(|_| self.has_slopes());
        section.map_or(Ok(None), |section| Ok(section.slopes(w, p, e, names)?))
    }

    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64> {
        self.companion()
            .unwrap_or(self)
            .force_n(workspace, pressure_mpa, 0.0)
    }

    fn mesh_error_n(
        &self,
        w: &mut Workspace,
        p: f64,
        e: f64,
        force_n: f64,
        scale_n: f64,
    ) -> Option<f64> {
        let of_default = if e < 0.0 {
            MESH_ERROR_STRETCHED * force_n.abs()
        } else {
            MESH_ERROR * scale_n
        };
        let reference_n = self
            .divided
            .reference()
            .and_then(|section| section.force_n(w, p, e).ok());
        // With a slack muscle there is nothing to compare.
        let off = reference_n
            .filter(|_| force_n > 0.0)
            .map_or(0.0, |other_n| (force_n - other_n).abs());
        Some(of_default + off)
    }

    fn notes(&self, workspace: &Workspace) -> Vec<String> {
        let unstable = self
            .known(workspace)
            .and_then(|c| c.unstable)
            .filter(|_| D::Body::SETTINGS.take_unstable)
            .map(|u| u.to_string());
        self.info.notes.iter().cloned().chain(unstable).collect()
    }

    fn contact_n_per_mm(&self, workspace: &mut Workspace, p: f64, e: f64) -> Option<Result<f64>> {
        let contact = D::section(self)?.contact(workspace, p, e);
        Some(
            contact
                .map(|contact| contact.pivoting_n_per_mm)
                .map_err(ModelError::from),
        )
    }

    fn companion(&self) -> Option<&dyn ForceModel> {
        self.divided.limit().map(|limit| limit as _)
    }

    fn pressure_at_pull(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        contraction: f64,
    ) -> Option<f64> {
        let point = self.reach(
            workspace,
            Given::ContractionAndPull {
                contraction,
                force_n,
            },
        );
        point
            .ok()
            .map(|point| point.pressure_mpa)
            .filter(|p| *p >= 0.0)
    }

    fn contraction_at_pull(
        &self,
        workspace: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Option<f64> {
        let given = Given::PressureAndPull {
            pressure_mpa,
            force_n,
        };
        Some(self.led_to(workspace, given).ok()?.contraction())
    }
}

/// A finite-element model of a muscle.
pub trait ElementModel: ForceModel {
    /// An equilibrium with everything that is known of it.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::OutOfReach`] where the muscle cannot carry the pull.
    fn solve(&self, workspace: &mut Workspace, given: Given) -> Result<Solution, FemError>;

    /// The same without what needs its tangent.
    fn reach(&self, workspace: &mut Workspace, given: Given) -> Result<CurvePoint, FemError>;

    /// The test at one contraction: a point for each pressure in MPa.
    fn isometric(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        detail: Detail,
    ) -> Curve;
}

impl<D: Divided> ElementModel for FiniteElements<D> {
    fn solve(&self, workspace: &mut Workspace, given: Given) -> Result<Solution, FemError> {
        self.led_to(workspace, given)?.body.solution(self.muscle())
    }

    fn reach(&self, workspace: &mut Workspace, given: Given) -> Result<CurvePoint, FemError> {
        let before = self.known(workspace).map(|c| c.effort).unwrap_or_default();
        Ok(CurvePoint::here(self.led_to(workspace, given)?, before))
    }

    fn isometric(
        &self,
        workspace: &mut Workspace,
        contraction: f64,
        pressures_mpa: &[f64],
        detail: Detail,
    ) -> Curve {
        let muscle = self.muscle();
        let c = match self.continuation(workspace) {
            Ok(c) => c,
            Err(error) => return vec![Err(error); pressures_mpa.len()],
        };
        isometric(c, contraction, pressures_mpa, |c, point| {
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
    model: &dyn ElementModel,
    workspace: &mut Workspace,
    pressure_mpa: f64,
) -> Result<f64, FemError> {
    if pressure_mpa == 0.0 && model.muscle().tube().prestretch == 1.0 {
        return Ok(0.0);
    }
    Ok(model
        .reach(
            workspace,
            Given::PressureAndPull {
                pressure_mpa,
                force_n: 0.0,
            },
        )?
        .contraction)
}
