//! Why a muscle does not fit.

use super::spec::OperatingPoint;
use crate::model::ModelError;
use crate::muscle::{Muscle, MuscleError};
use serde::Serialize;

/// The bound that a muscle breaks.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", content = "detail", rename_all = "snake_case")]
pub enum Reason {
    /// It does not pull enough at the maximum pressure.
    Force {
        /// The operating point.
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
    /// Its strands break too early.
    Burst {
        /// Burst pressure over maximum pressure.
        margin: f64,
        /// The bound.
        limit: f64,
    },
    /// Its rubber is stretched too far.
    Stretch {
        /// Largest principal stretch.
        stretch: f64,
        /// The bound.
        limit: f64,
    },
    /// The model has no answer.
    #[serde(serialize_with = "in_words")]
    Model(ModelError),
    /// The parts do not make a muscle.
    #[serde(serialize_with = "in_words")]
    Muscle(MuscleError),
}

fn in_words<E: std::fmt::Display, S: serde::Serializer>(error: &E, out: S) -> Result<S::Ok, S::Error> {
    out.collect_str(error)
}

impl Reason {
    /// The sentence, with pressures written by `pressure` ("2.5 bar").
    pub fn describe(&self, pressure: impl Fn(f64) -> String) -> String {
        match self {
            Reason::Force { point, available_n, pressure_mpa } => format!(
                "{:.0} N at {} and {} %, {} N wanted",
                available_n.floor(),
                pressure(*pressure_mpa),
                round(100.0 * point.contraction),
                round(point.force_n)
            ),
            Reason::Bulge { diameter_mm, limit_mm } => {
                format!("bulges to {diameter_mm:.1} mm, at most {limit_mm} mm wanted")
            }
            Reason::Burst { margin, limit } => {
                format!("strands break at {margin:.2} times the maximum pressure, {limit} wanted")
            }
            Reason::Stretch { stretch, limit } => {
                format!("rubber stretched to {stretch:.2}, at most {limit} wanted")
            }
            Reason::Model(error) => error.to_string(),
            Reason::Muscle(error) => error.to_string(),
        }
    }

    /// By which factor the bound is missed (1: met; larger: further off; ∞: no answer at all).
    pub fn shortfall(&self) -> f64 {
        match self {
            Reason::Force { point, available_n, .. } => {
                // A muscle that pushes is further off than one that pulls nothing.
                let share = available_n / point.force_n;
                if share > 0.0 { 1.0 / share } else { 1e6 * (1.0 - share) }
            }
            Reason::Bulge { diameter_mm, limit_mm } => diameter_mm / limit_mm,
            Reason::Burst { margin, limit } => limit / margin,
            Reason::Stretch { stretch, limit } => stretch / limit,
            Reason::Model(_) | Reason::Muscle(_) => f64::INFINITY,
        }
    }
}

fn round(v: f64) -> f64 {
    (v * 1e4).round() / 1e4
}

/// A muscle that does not fit, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejected {
    /// Outer diameter in mm.
    pub outer_diameter_mm: f64,
    /// Wall in mm.
    pub wall_mm: f64,
    /// Braid angle in degrees.
    pub angle_deg: f64,
    /// Name of the rubber, where it has one.
    pub rubber: Option<String>,
    /// The bound it breaks by most.
    pub reason: Reason,
}

impl Rejected {
    pub(super) fn of(muscle: &Muscle, reason: Reason) -> Self {
        Self {
            outer_diameter_mm: muscle.outer_diameter_mm(),
            wall_mm: muscle.wall_mm(),
            angle_deg: muscle.braid().angle_deg,
            rubber: muscle.tube().rubber.name.clone(),
            reason,
        }
    }
}
