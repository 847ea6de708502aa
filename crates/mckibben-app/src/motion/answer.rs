//! What a motion answers with.

use super::IdentifiedDrive;
use crate::{MuscleSummary, PressureLimits, Problem, breakdown, units::Units};
use mckibben_core::{built::UncertaintyParts, warning::Warning};
use mckibben_motion::Motion;
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;
use serde_with_macros::skip_serializing_none;

/// A motion.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct MotionRun {
    /// The value of the sweep's key, where there is a sweep.
    pub value: Option<String>,
    /// The motion.
    #[serde(flatten)]
    pub motion: Motion,
    /// The ± of its end.
    #[serde(flatten)]
    pub end: EndUncertainty,
}

/// How far from its computed end a measured muscle or joint may come to rest.
#[skip_serializing_none]
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct EndUncertainty {
    /// The contraction at which the load rests in the end on a muscle that is built, by the median;
    /// none on a stop, of a controlled position, and where the command still changes.
    pub end_contraction_predicted: Option<f64>,
    /// Lower end of its 95 % interval.
    pub end_contraction_predicted_low: Option<f64>,
    /// Upper end.
    pub end_contraction_predicted_high: Option<f64>,
    /// Half of what lies between.
    pub end_contraction_uncertainty: Option<f64>,
    /// 95 % half-width of the angle at which a joint rests in the end, likewise, degrees.
    pub end_angle_uncertainty_deg: Option<f64>,
    /// The ± of the pull or torque there with its parts, in words.
    pub uncertainty_text: Option<String>,
    /// These parts, in N or N m.
    #[serde(skip)]
    pub parts: Option<UncertaintyParts>,
}

impl MotionRun {
    /// The parts of the ± at its end in words, in units.
    pub fn uncertainty_in(&self, u: &Units) -> Option<String> {
        let (of, scale) = if self.end.end_angle_uncertainty_deg.is_some() {
            ("torque", crate::units::NEWTON_METRES)
        } else {
            ("pull", u.force.clone())
        };
        Some(format!(
            "of the {of} {}",
            breakdown(self.end.parts.as_ref()?, &scale)
        ))
    }
}

/// The answer to a drive: its motion, or those of a sweep.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct MotionAnswer {
    /// The model's name.
    pub model: String,
    /// The muscles.
    pub muscles: Vec<MuscleSummary>,
    /// The motion; of a sweep the first.
    #[serde(flatten)]
    pub motion: MotionRun,
    /// The other motions of a sweep.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<MotionRun>,
    /// Sonic conductance of the smallest valve with the requested rise time, L/(s bar).
    pub sonic_conductance_l_per_s_bar: Option<f64>,
    /// The pressures that its weakest muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// What was identified from a recorded motion.
    #[serde(flatten)]
    pub identified: Option<IdentifiedDrive>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

impl MotionAnswer {
    /// Its motions: one, or those of a sweep.
    pub fn runs(&self) -> impl Iterator<Item = &MotionRun> {
        std::iter::once(&self.motion).chain(&self.others)
    }

    /// Where a motion ended before its end: the reason.
    pub fn problem(&self) -> Option<Problem> {
        self.runs()
            .find_map(|run| run.motion.ended.clone())
            .map(Problem::from)
    }
}
