//! What `motion` answers.

use super::uncertainty::EndUncertainty;
use crate::burst::PressureLimits;
use crate::muscle::MuscleSummary;
use crate::problem::Problem;
use mckibben::warning::Warning;
use mckibben_motion::Motion;
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;

/// A motion.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MotionRun {
    /// The value of the sweep's key, where there is a sweep.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// The motion.
    #[serde(flatten)]
    pub motion: Motion,
    /// The ± of its end.
    #[serde(flatten)]
    pub end: EndUncertainty,
}

/// The answer to a drive: its motion, or those of a sweep.
#[derive(Debug, Clone, Serialize, JsonSchema)]
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
    /// Sonic conductance of the smallest valve with the rise time that was asked for, L/(s bar).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sonic_conductance_l_per_s_bar: Option<f64>,
    /// The pressures that its weakest muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// Warnings.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

impl MotionAnswer {
    /// Its motions: one, or those of a sweep.
    pub fn runs(&self) -> impl Iterator<Item = &MotionRun> {
        std::iter::once(&self.motion).chain(&self.others)
    }

    /// Where a motion ended before its end: the reason.
    pub fn problem(&self) -> Option<Problem> {
        self.runs().find_map(|run| run.motion.ended.clone()).map(Problem::from)
    }
}
