//! Why a muscle does not fit.

use crate::{Limit, OperatingPoint};
use mckibben::analysis::FailureMode;
use mckibben::model::ModelError;
use mckibben::muscle::{Muscle, MuscleError};
use mckibben::units::Dimension;
use serde::Serialize;

/// The bound that a muscle breaks.
#[derive(Debug, Clone, PartialEq)]
pub enum Reason {
    /// It does not pull enough at the maximum pressure.
    Force {
        point: OperatingPoint,
        /// Its pull there at `pressure_mpa`, in N.
        available_n: f64,
        /// The maximum pressure in MPa.
        pressure_mpa: f64,
    },
    /// It bulges too far.
    Bulge {
        /// Outer diameter at the point, in mm.
        diameter_mm: f64,
        /// The bound in mm.
        limit_mm: f64,
    },
    /// It bursts too early.
    Burst {
        by: FailureMode,
        /// Burst pressure over maximum pressure.
        margin: f64,
        limit: f64,
    },
    /// Its rubber is stretched too far.
    Stretch { stretch: f64, limit: f64 },
    /// Its strands stretch too far.
    StrandStrain {
        /// Largest strain at the maximum pressure.
        strain: f64,
        limit: f64,
    },
    /// It buckles under its push.
    Buckling {
        /// Its push in N.
        push_n: f64,
        /// The push in N at which it buckles between two joints.
        limit_n: f64,
    },
    /// It takes more liquid than there is.
    LiquidVolume {
        /// Volume that is pushed in up to the point, in mm³.
        volume_mm3: f64,
        /// The bound in mm³.
        limit_mm3: f64,
    },
    /// The model has no answer.
    Model(ModelError),
    /// The parts do not make a muscle.
    Muscle(MuscleError),
}

impl Reason {
    /// The sentence, with pressures, forces and lengths written by `show` ("2.5 bar", "700 N", "30 mm").
    pub fn describe(&self, show: impl Fn(Dimension, f64) -> String) -> String {
        match self {
            Reason::Force { point, available_n, pressure_mpa } => format!(
                "{} at {} and {} %, {} required",
                show(Dimension::Force, available_n.trunc()),
                show(Dimension::Pressure, *pressure_mpa),
                round(100.0 * point.contraction),
                show(Dimension::Force, point.force_n)
            ),
            Reason::Bulge { diameter_mm, limit_mm } => {
                let bulged = (10.0 * diameter_mm).round() / 10.0;
                let [bulged, limit] = [bulged, *limit_mm].map(|v| show(Dimension::Length, v));
                format!("bulged diameter {bulged}, at most {limit} allowed")
            }
            Reason::Burst { by, margin, limit } => {
                format!("{by} at {margin:.2} times the maximum pressure, {limit} required")
            }
            Reason::Stretch { stretch, limit } => {
                format!("rubber stretched to {stretch:.2}, at most {limit} allowed")
            }
            Reason::StrandStrain { strain, limit } => format!(
                "strands stretched by {:.1} %, at most {} % allowed",
                100.0 * strain,
                round(100.0 * limit)
            ),
            Reason::Buckling { push_n, limit_n } => {
                let [push, limit] = [push_n.ceil(), limit_n.floor()].map(|v| show(Dimension::Force, v));
                format!("buckles at {limit} between two joints, {push} required")
            }
            Reason::LiquidVolume { volume_mm3, limit_mm3 } => {
                let (volume, limit) = ((0.1 * volume_mm3).ceil() / 100.0, round(1e-3 * limit_mm3));
                format!("takes {volume} mL of liquid, at most {limit} mL allowed")
            }
            Reason::Model(error) => error.to_string(),
            Reason::Muscle(error) => error.to_string(),
        }
    }

    /// The kind of limit that is missed; `None` where there is no answer at all.
    pub fn limit(&self) -> Option<Limit> {
        Some(match self {
            Reason::Force { .. } => Limit::Force,
            Reason::Bulge { .. } => Limit::BulgedDiameter,
            Reason::Burst { .. } => Limit::BurstMargin,
            Reason::Stretch { .. } => Limit::MaxStretch,
            Reason::StrandStrain { .. } => Limit::StrandStrain,
            Reason::Buckling { .. } => Limit::Buckling,
            Reason::LiquidVolume { .. } => Limit::LiquidVolume,
            Reason::Model(_) | Reason::Muscle(_) => return None,
        })
    }

    /// The share of the limit by which it is missed; `None` where there is no answer at all.
    pub fn misses_by(&self) -> Option<f64> {
        let (value, bound) = match *self {
            Reason::Force { point, available_n, .. } => (available_n, point.force_n),
            Reason::Bulge { diameter_mm: value, limit_mm: bound }
            | Reason::Burst { margin: value, limit: bound, .. }
            | Reason::Stretch { stretch: value, limit: bound }
            | Reason::StrandStrain { strain: value, limit: bound }
            | Reason::Buckling { push_n: value, limit_n: bound }
            | Reason::LiquidVolume { volume_mm3: value, limit_mm3: bound } => (value, bound),
            Reason::Model(_) | Reason::Muscle(_) => return None,
        };
        Some(self.limit()?.missed_by(value, bound))
    }
}

fn round(v: f64) -> f64 {
    (v * 1e4).round() / 1e4
}

/// A muscle that does not fit, and why.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Rejected {
    /// Outer diameter D0, mm.
    pub outer_diameter_mm: f64,
    /// Wall s, mm.
    pub wall_mm: f64,
    /// Length L0, mm.
    pub length_mm: f64,
    /// Braid angle θ0, degrees.
    pub angle_deg: f64,
    /// Name of the rubber, where it has one.
    pub rubber: Option<String>,
    /// Name of the sleeve, where it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sleeve: Option<String>,
    /// The bound it breaks by most.
    #[serde(skip)]
    pub reason: Reason,
}

impl Rejected {
    pub(super) fn of(muscle: &Muscle, reason: Reason) -> Self {
        Self {
            outer_diameter_mm: muscle.outer_diameter_mm(),
            wall_mm: muscle.wall_mm(),
            length_mm: muscle.length_mm(),
            angle_deg: muscle.braid().angle_deg,
            rubber: muscle.tube().rubber.name.clone(),
            sleeve: muscle.braid().sleeve.as_ref().map(|s| s.name.clone()),
            reason,
        }
    }
}
