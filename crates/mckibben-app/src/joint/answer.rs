//! What `joint` answers.

use crate::{MuscleSummary, PressureLimits};
use mckibben_core::{
    joint::{JointMap, JointPoint, Rest},
    warning::Warning,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;

/// A point of a joint.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct JointRow {
    /// Angle, torque and stiffness.
    #[serde(flatten)]
    pub point: JointPoint,
    /// Pressure of the first muscle, MPa.
    pub pressure_1_mpa: f64,
    /// Pressure of the second muscle, MPa.
    pub pressure_2_mpa: Option<f64>,
    /// The torque while the joint turns to +, where the muscles' friction is known, N m.
    pub torque_turning_plus_nm: Option<f64>,
    /// The torque while it turns to −, likewise.
    pub torque_turning_minus_nm: Option<f64>,
    /// Of a joint at rest: `stable`, `unstable`, at a `limit` of its range, or `loose`: it rests at
    /// any angle near this one.
    pub rest: Option<RestWord>,
    /// Pull of the first muscle, N.
    pub force_1_n: f64,
    /// Pull of the second muscle, N.
    pub force_2_n: Option<f64>,
    /// Contraction of the first muscle.
    pub contraction_1: f64,
    /// Contraction of the second muscle.
    pub contraction_2: Option<f64>,
    /// Moment arm of the first muscle, mm.
    pub arm_1_mm: f64,
    /// Moment arm of the second muscle, mm.
    pub arm_2_mm: Option<f64>,
    /// Whether the first muscle is slack.
    pub slack_1: bool,
    /// Whether the second muscle is slack.
    pub slack_2: Option<bool>,
    /// Pressure below which the first muscle is slack at this angle, MPa.
    pub start_pressure_1_mpa: Option<f64>,
    /// Pressure below which the second muscle is slack at this angle, MPa.
    pub start_pressure_2_mpa: Option<f64>,
    /// Of a joint at rest: 95 % half-width of the angle, from that of the torque and the stiffness,
    /// degrees.
    pub angle_uncertainty_deg: Option<f64>,
    /// Of pressures that were sought: 95 % half-width of that of the first muscle, by which it
    /// alone makes up for that of the torque, MPa.
    pub pressure_1_uncertainty_mpa: Option<f64>,
    /// That of the second muscle, likewise, MPa.
    pub pressure_2_uncertainty_mpa: Option<f64>,
}

/// How a joint rests.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RestWord {
    /// It comes back after a small turn.
    Stable,
    /// It does not.
    Unstable,
    /// It rests at a limit of its range.
    Limit,
    /// No torque acts, and it rests at any angle near this one.
    Loose,
}

impl From<&Rest> for RestWord {
    fn from(rest: &Rest) -> Self {
        match rest {
            Rest::Balance { stable: true, .. } => Self::Stable,
            Rest::Balance { stable: false, .. } => Self::Unstable,
            Rest::Limit { .. } => Self::Limit,
            Rest::Loose { .. } => Self::Loose,
        }
    }
}

mckibben_core::units::display_as_serde_word!(RestWord);

/// A joint's answer.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct JointAnswer {
    /// The model's name.
    pub model: String,
    /// The muscles.
    pub muscles: Vec<MuscleSummary>,
    /// Limits of the angle in degrees.
    pub range_deg: (f64, f64),
    /// The points, pressures after pressures.
    pub points: Vec<JointRow>,
    /// The pressures that its weakest muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// What the joint reaches, if requested.
    pub map: Option<JointMap>,
    /// The largest ± of the torques, in words:
    /// `at φ 20°: ± 2.0 N m (95 %): friction unknown 1.7, model against tests 0.8`.
    pub uncertainty_text: Option<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}
