//! A muscle held against a specification: its model, and the thick-wall model for what that does not know.

use crate::{Build, OperatingPoint, Spec};
use mckibben::analysis::{AnalysisError, Evaluation};
use mckibben::cancel;
use mckibben::load::LiquidStroke;
use mckibben::model::{ForceModel, ModelError, ModelKind, Response, Workspace};
use mckibben::muscle::Muscle;

pub(super) struct Trial<'a> {
    pub(super) spec: &'a Spec,
    pub(super) muscle: &'a Muscle,
    pub(super) model: Box<dyn ForceModel>,
    pub(super) thick_wall: Box<dyn ForceModel>,
    pub(super) workspace: Workspace,
}

/// What is pushed into a muscle from rest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    /// What muscles are compared by: normal litres of air, or mm³ of liquid.
    pub(super) amount: f64,
    /// `None`: of air.
    pub(super) liquid: Option<LiquidStroke>,
}

impl<'a> Trial<'a> {
    pub(super) fn new(spec: &'a Spec, build: &Build<'_>, muscle: &'a Muscle) -> Result<Self, ModelError> {
        // Of what is to end, not even the model is made.
        cancel::check()?;
        let (model, thick_wall) = (build(muscle)?, ModelKind::ThickWall.build(muscle)?);
        Ok(Self { spec, muscle, model, thick_wall, workspace: Workspace::new() })
    }

    /// Its model, ready to be asked.
    pub(super) fn evaluation(&mut self) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, self.spec.options())
    }

    /// The pull at the maximum pressure.
    pub(super) fn strongest_n(&mut self, contraction: f64) -> Result<f64, ModelError> {
        let max = self.spec.max_pressure_mpa;
        self.evaluation().force_n(max, contraction)
    }

    /// Half the width of the 95 % interval of a pull, where it is known.
    pub(super) fn uncertainty_n(&mut self, (p, contraction): (f64, f64), force_n: f64) -> Option<f64> {
        Some(self.evaluation().uncertainty(p, contraction, force_n)?.total())
    }

    /// The pressure a point takes, where the pull at the maximum pressure is known to be enough.
    pub(super) fn need(&mut self, point: &OperatingPoint) -> Result<f64, ModelError> {
        let OperatingPoint { force_n, contraction } = *point;
        let max = self.spec.max_pressure_mpa;
        let mut model = self.evaluation();
        if let Some(p) = model.pressure_below(force_n, contraction, max) {
            return Ok(p);
        }
        match model.pressure_at(force_n, contraction) {
            Ok(p) => Ok(p.min(max)),
            Err(AnalysisError::Model(error)) => Err(error),
            // At the lowest pressure of its range the model already pulls more: that pressure is enough.
            Err(AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. })
                if nearest_force_n / force_n >= 1.0 =>
            {
                Ok(nearest_pressure_mpa)
            }
            Err(_) => Ok(max),
        }
    }

    /// A response with what the model does not know filled in from the thick-wall model, and what that is.
    pub(super) fn full_response(
        &mut self,
        p: f64,
        contraction: f64,
    ) -> Result<(Response, Vec<&'static str>), ModelError> {
        cancel::check()?;
        let mut r = self.model.response(&mut self.workspace, p, contraction)?;
        let mut filled = vec![];
        if r.bulged_diameter_mm.is_some() && r.volume_mm3.is_some() && r.max_stretch.is_some() {
            return Ok((r, filled));
        }
        if let Ok(other) = self.thick_wall.response(&mut self.workspace, p, contraction) {
            let mut fill = |slot: &mut Option<f64>, value: Option<f64>, name| {
                if slot.is_none() && value.is_some() {
                    *slot = value;
                    filled.push(name);
                }
            };
            fill(&mut r.bulged_diameter_mm, other.bulged_diameter_mm, "bulged diameter");
            fill(&mut r.volume_mm3, other.volume_mm3, "volume");
            fill(&mut r.max_stretch, other.max_stretch, "stretch");
            fill(&mut r.middle_stretch, other.middle_stretch, "stretch");
            fill(&mut r.braid_tension_n, other.braid_tension_n, "strand tension");
            fill(&mut r.strand_tension_n, other.strand_tension_n, "strand tension");
            fill(&mut r.stiffness_n_per_mm, other.stiffness_n_per_mm, "stiffness");
        }
        Ok((r, filled))
    }

    /// What is pushed in from rest to a pressure and contraction, and whether the thick-wall model gave it.
    pub(super) fn stroke(&mut self, p: f64, contraction: f64) -> (Option<Stroke>, bool) {
        let (workspace, options) = (&mut self.workspace, self.spec.options());
        let mut stroke = |model: &dyn ForceModel| -> Result<Stroke, AnalysisError> {
            let mut model = Evaluation::new(model, workspace, options);
            let Some(supply) = &self.spec.liquid else {
                let amount = model.air_per_stroke(p, contraction)?.normal_litres;
                return Ok(Stroke { amount, liquid: None });
            };
            let liquid = model.liquid_per_stroke(supply, p, contraction)?;
            Ok(Stroke { amount: liquid.volume_mm3, liquid: Some(liquid) })
        };
        match stroke(&*self.model) {
            Ok(stroke) => (Some(stroke), false),
            Err(_) => (stroke(&*self.thick_wall).ok(), true),
        }
    }
}
