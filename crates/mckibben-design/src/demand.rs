//! What a muscle must do.

use crate::{SpecError, spec::refused};
use mckibben_core::{load::Load, units::Values};
use serde::{Deserialize, Serialize};

/// An operating point that is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct OperatingPoint {
    /// Pull, N.
    pub force_n: f64,
    /// Contraction ratio.
    pub contraction: f64,
}

/// A torque that a joint must hold at an angle, to either side.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct TorqueWanted {
    /// Torque away from the neutral angle, N m.
    pub torque_nm: f64,
    /// Angle from the neutral one, degrees.
    pub angle_deg: f64,
}

/// Room in mm between two muscles beside each other, for cords and clamps.
const ROOM_MM: f64 = 4.0;
/// What is left in mm where there is no room at all: a share of it is still a number.
const NO_ROOM_MM: f64 = 0.1;

/// Shares of the way at which a load is looked at that does not grow all along it.
const SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// What the muscle must do.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "DemandAnswer")]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum Demand {
    /// Pulls at contractions.
    Points {
        /// The operating points.
        points: Vec<OperatingPoint>,
    },
    /// To lift a load by a stroke.
    Stroke {
        /// Lifted from the length at rest.
        #[serde(skip)]
        load: Load,
        /// The stroke, mm.
        stroke_mm: f64,
    },
    /// To lift a load to a contraction.
    Contraction {
        /// Lifted from the length at rest.
        #[serde(skip)]
        load: Load,
        /// The contraction ratio.
        contraction: f64,
    },
    /// To turn a joint.
    Joint(JointDemand),
}

/// Torques wanted of one of two equal muscles that turn a joint against each other on a pulley, the
/// other one without pressure.
///
/// At an angle φ from the neutral one the muscle is contracted by ε = ε0 + r φ/L0 and pulls F =
/// τ/r. It is contracted by ε0 = r φm/L0 at the neutral angle, φm the largest angle of the joint,
/// so that the other one is at its length at rest there, without a pull, and slack at every smaller
/// angle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(inline)]
pub struct JointDemand {
    /// Torques at angles.
    pub torques: Vec<TorqueWanted>,
    /// Largest angle φm in degrees to either side.
    #[serde(skip)]
    pub largest_angle_deg: f64,
    /// Radii r of the pulley in mm that are searched.
    #[serde(skip)]
    pub radii_mm: Values,
    /// Whether the two muscles lie beside each other, 2 r apart, and so must have room there.
    #[serde(skip)]
    pub beside: bool,
}

impl JointDemand {
    /// ε0 at the neutral angle, of a muscle of a length in mm.
    pub fn contraction_at_neutral(&self, radius_mm: f64, length_mm: f64) -> f64 {
        radius_mm * self.largest_angle_deg.to_radians() / length_mm
    }

    fn points(&self, length_mm: f64, radius_mm: f64) -> Vec<OperatingPoint> {
        let point = |t: &TorqueWanted| OperatingPoint {
            force_n: 1e3 * t.torque_nm / radius_mm,
            contraction: self.contraction_at_neutral(radius_mm, length_mm)
                + radius_mm * t.angle_deg.to_radians() / length_mm,
        };
        self.torques.iter().map(point).collect()
    }

    fn check(&self) -> Result<(), SpecError> {
        let largest_deg = self.largest_angle_deg;
        for t in &self.torques {
            let (torque_nm, angle_deg) = (t.torque_nm, t.angle_deg);
            let is_sound = torque_nm > 0.0 && torque_nm.is_finite();
            if !(is_sound && angle_deg.abs() <= largest_deg) {
                return refused(
                    "torques",
                    format!(
                        "{torque_nm} N m at {angle_deg}° is invalid: the torque must be above zero \
                     and the angle within ±{largest_deg}°"
                    ),
                );
            }
        }
        let bounds = [
            ("largest_angle_deg", largest_deg),
            ("radius_mm", self.radii_mm.bounds().1),
        ];
        for (name, value) in bounds {
            if !(value.is_finite() && value > 0.0) {
                return refused(name, format!("`{name}` is {value}; it must be above zero"));
            }
        }
        Ok(())
    }
}

/// What is left in mm for the width of one muscle beside the other one at rest, where both must have
/// room on a pulley.
pub fn room_on_pulley_mm(demand: &Demand, radius_mm: f64, rest_mm: f64) -> Option<f64> {
    let joint = demand.joint()?;
    let room_mm = 4.0 * radius_mm - 2.0 * ROOM_MM - rest_mm;
    joint.beside.then_some(room_mm.max(NO_ROOM_MM))
}

impl Demand {
    /// The joint that is wanted.
    pub fn joint(&self) -> Option<&JointDemand> {
        match self {
            Self::Joint(joint) => Some(joint),
            _ => None,
        }
    }

    /// Whether pushes of a muscle that extends are wanted: forces and contractions below zero.
    pub fn extends(&self) -> bool {
        matches!(self, Self::Points { points } if points.iter().any(|q| q.force_n < 0.0))
    }

    /// The load that is lifted.
    pub fn load(&self) -> Option<&Load> {
        match self {
            Self::Stroke { load, .. } | Self::Contraction { load, .. } => Some(load),
            _ => None,
        }
    }

    /// The load that is lifted, and how far in mm by a muscle of a length in mm.
    fn lift(&self, length_mm: f64) -> Option<(&Load, f64)> {
        match self {
            Self::Stroke { load, stroke_mm } => Some((load, *stroke_mm)),
            Self::Contraction { load, contraction } => Some((load, contraction * length_mm)),
            _ => None,
        }
    }

    /// The operating points of a muscle of a length in mm, of a joint on a pulley of a radius in mm.
    pub fn points(&self, length_mm: f64, radius_mm: f64) -> Vec<OperatingPoint> {
        match (self, self.lift(length_mm)) {
            (Self::Points { points }, _) => points.clone(),
            (Self::Joint(joint), _) => joint.points(length_mm, radius_mm),
            (_, None) => vec![],
            (_, Some((load, end_mm))) => {
                let along = SHARES.map(|share| OperatingPoint {
                    force_n: load.force_n(share * end_mm),
                    contraction: share * end_mm / length_mm,
                });
                // A muscle pulls less the more it is contracted: where the load grows, the end
                // decides.
                let grows = along.is_sorted_by(|a, b| a.force_n <= b.force_n);
                let from = if grows { along.len() - 1 } else { 0 };
                let pulls = along[from..].iter().filter(|q| q.force_n > 0.0);
                pulls.copied().collect()
            }
        }
    }

    /// So many times what is wanted over a share of the way; the torques of a joint have theirs
    /// from its angles.
    #[must_use]
    pub fn scaled(&self, factor: f64, share: f64) -> Self {
        let mut scaled = self.clone();
        match &mut scaled {
            Self::Points { points } => {
                for q in points {
                    q.force_n *= factor;
                    q.contraction *= share;
                }
            }
            Self::Stroke {
                load,
                stroke_mm: way,
            }
            | Self::Contraction {
                load,
                contraction: way,
            } => {
                *load = load.times(factor);
                *way *= share;
            }
            Self::Joint(joint) => joint.torques.iter_mut().for_each(|t| t.torque_nm *= factor),
        }
        scaled
    }

    /// The number that says how far: the first contraction, or the stroke in mm; `None` of a joint,
    /// and of a muscle that does not shorten.
    pub fn way(&self) -> Option<f64> {
        let way = match self {
            Self::Points { points } => points.first()?.contraction,
            Self::Stroke { stroke_mm: way, .. }
            | Self::Contraction {
                contraction: way, ..
            } => *way,
            Self::Joint(_) => return None,
        };
        Some(way).filter(|way| *way != 0.0)
    }

    /// The number that says how much: the first pull in N or torque in N m; of a load 1.
    pub fn size(&self) -> f64 {
        let first = match self {
            Self::Points { points } => points.first().map(|q| q.force_n.abs()),
            Self::Joint(joint) => joint.torques.first().map(|t| t.torque_nm),
            _ => None,
        };
        first.unwrap_or(1.0)
    }

    /// Checks what is wanted of a muscle of a length in mm.
    #[doc(hidden)]
    pub fn check(&self, length_mm: f64) -> Result<(), SpecError> {
        if let Self::Joint(joint) = self {
            joint.check()?;
        }
        if let Some((load, end)) = self.lift(length_mm) {
            let (low, high) = load.reach_mm();
            if !(low <= 0.0 && end <= high) {
                return refused(
                    "stroke_mm",
                    format!(
                        "the load is known for shortenings from {low}\u{a0}mm to {high}\u{a0}mm, \
                     and the stroke goes from 0\u{a0}mm to {end}\u{a0}mm"
                    ),
                );
            }
        }
        let widest_mm = self.joint().map_or(0.0, |joint| joint.radii_mm.bounds().1);
        let points = self.points(length_mm, widest_mm);
        if points.is_empty() {
            return refused(
                "force_n",
                "no operating point: give `force_n` and `contraction`, \
                or `points`, each a pull at a contraction, or a load that pulls",
            );
        }
        let sign = if self.extends() { -1.0 } else { 1.0 };
        for OperatingPoint {
            force_n,
            contraction,
        } in points
        {
            let pull_n = sign * force_n;
            let is_sound = pull_n > 0.0 && pull_n.is_finite();
            if !(is_sound && (0.0..1.0).contains(&(sign * contraction))) {
                return refused(
                    "points",
                    format!(
                        "the operating point {force_n}\u{a0}N at a contraction of {contraction} is \
                     invalid: the pull must be above 0 N and the contraction from 0 to below 1; for \
                     a push of a muscle that extends, the force below 0 N and the contraction from \
                     above -1 to 0"
                    ),
                );
            }
        }
        Ok(())
    }
}
