//! What fills a muscle from rest to a point: air, or the liquid of the specification.

use super::spec::Spec;
use mckibben::analysis::{AnalysisError, air_per_stroke};
use mckibben::load::{LiquidStroke, liquid_per_stroke};
use mckibben::model::{ForceModel, Workspace};

/// What is pushed into a muscle from rest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stroke {
    /// Air in normal litres.
    Air(f64),
    Liquid(LiquidStroke),
}

impl Stroke {
    /// What muscles are compared by: normal litres of air, or mm³ of liquid.
    pub(super) fn amount(&self) -> f64 {
        match self {
            Self::Air(normal_litres) => *normal_litres,
            Self::Liquid(liquid) => liquid.volume_mm3,
        }
    }

    /// Air in normal litres.
    pub(super) fn air(&self) -> Option<f64> {
        if let Self::Air(normal_litres) = self { Some(*normal_litres) } else { None }
    }

    pub(super) fn liquid(&self) -> Option<LiquidStroke> {
        if let Self::Liquid(liquid) = self { Some(*liquid) } else { None }
    }
}

/// What is pushed in from rest to a point, and whether the thick-wall model gave it.
pub(super) fn stroke(
    spec: &Spec,
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    thick_wall: &dyn ForceModel,
    (p, contraction): (f64, f64),
) -> (Option<Stroke>, bool) {
    let mut of = |m: &dyn ForceModel| -> Result<Stroke, AnalysisError> {
        Ok(match &spec.liquid {
            Some(supply) => Stroke::Liquid(liquid_per_stroke(m, workspace, supply, p, contraction)?),
            None => Stroke::Air(air_per_stroke(m, workspace, p, contraction)?.normal_litres),
        })
    };
    match of(model) {
        Ok(stroke) => (Some(stroke), false),
        Err(_) => (of(thick_wall).ok(), true),
    }
}
