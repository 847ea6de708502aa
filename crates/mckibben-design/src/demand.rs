//! What a muscle must do.

use crate::SpecError;
use mckibben_core::load::Load;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

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

/// What a muscle must do: the operating points, where these follow from its length as well.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    Points(Vec<OperatingPoint>),
    /// To lift a load from the length at rest.
    Load {
        load: Load,
        way: Lift,
    },
    /// To turn a joint.
    Joint(JointDemand),
}

/// How far a load is lifted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lift {
    /// Stroke in mm.
    Stroke(f64),
    /// Contraction ratio.
    Contraction(f64),
}

impl Lift {
    /// Whether a load is lifted by a stroke, of which a length is a share.
    pub fn is_stroke(demand: &Demand) -> bool {
        let stroke = |way: &Lift| matches!(way, Self::Stroke(_));
        matches!(demand, Demand::Load { way, .. } if stroke(way))
    }

    /// Where it ends, in mm from the length at rest of a muscle of a length in mm.
    fn end_mm(self, length_mm: f64) -> f64 {
        match self {
            Self::Stroke(mm) => mm,
            Self::Contraction(ratio) => ratio * length_mm,
        }
    }
}

/// Torques wanted of one of two equal muscles that turn a joint against each other on a pulley, the
/// other one without pressure.
///
/// At an angle φ from the neutral one the muscle is contracted by ε = ε0 + r φ/L0 and pulls F =
/// τ/r. It is contracted by ε0 = r φm/L0 at the neutral angle, φm the largest angle of the joint,
/// so that the other one is at its length at rest there, without a pull, and slack at every smaller
/// angle.
#[derive(Debug, Clone, PartialEq)]
pub struct JointDemand {
    pub torques: Vec<TorqueWanted>,
    /// Largest angle φm in degrees to either side.
    pub largest_angle_deg: f64,
    /// Radius r of the pulley in mm.
    pub radius_mm: f64,
    /// Whether the two muscles lie beside each other, 2 r apart, and so must have room there.
    pub beside: bool,
}

impl JointDemand {
    /// ε0 at the neutral angle, of a muscle of a length in mm.
    pub fn contraction_at_neutral(&self, radius_mm: f64, length_mm: f64) -> f64 {
        radius_mm * self.largest_angle_deg.to_radians() / length_mm
    }

    fn points(&self, length_mm: f64) -> Vec<OperatingPoint> {
        let point = |&TorqueWanted {
                         torque_nm,
                         angle_deg,
                     }: &TorqueWanted| OperatingPoint {
            force_n: 1e3 * torque_nm / self.radius_mm,
            contraction: self.contraction_at_neutral(self.radius_mm, length_mm)
                + self.radius_mm * angle_deg.to_radians() / length_mm,
        };
        self.torques.iter().map(point).collect()
    }
}

/// What is left in mm for the width of one muscle beside the other one at rest, where both must have
/// room on a pulley.
pub fn room_on_pulley_mm(demand: &Demand, radius_mm: f64, rest_mm: f64) -> Option<f64> {
    let Demand::Joint(joint) = demand else {
        return None;
    };
    let room_mm = 4.0 * radius_mm - 2.0 * ROOM_MM - rest_mm;
    joint.beside.then_some(room_mm.max(NO_ROOM_MM))
}

impl Demand {
    /// The same on a pulley of a radius in mm.
    pub fn on_radius(&self, radius_mm: f64) -> Cow<'_, Self> {
        match self {
            Self::Joint(joint) => Cow::Owned(Self::Joint(JointDemand {
                radius_mm,
                ..joint.clone()
            })),
            _ => Cow::Borrowed(self),
        }
    }

    /// Whether pushes of a muscle that extends are wanted: forces and contractions below zero.
    pub fn extends(&self) -> bool {
        matches!(self, Self::Points(points) if points.iter().any(|q| q.force_n < 0.0))
    }

    /// The operating points of a muscle of a length in mm.
    pub fn points(&self, length_mm: f64) -> Cow<'_, [OperatingPoint]> {
        match self {
            Self::Points(points) => Cow::Borrowed(points),
            Self::Joint(joint) => Cow::Owned(joint.points(length_mm)),
            Self::Load { load, way } => {
                let end = way.end_mm(length_mm);
                // A muscle pulls less the more it is contracted: where the load grows, the end
                // decides.
                let grows = SHARES
                    .windows(2)
                    .all(|s| load.force_n(s[0] * end) <= load.force_n(s[1] * end));
                let shares = if grows {
                    &SHARES[SHARES.len() - 1..]
                } else {
                    &SHARES
                };
                let at = |share: &f64| OperatingPoint {
                    force_n: load.force_n(share * end),
                    contraction: share * end / length_mm,
                };
                Cow::Owned(shares.iter().map(at).filter(|q| q.force_n > 0.0).collect())
            }
        }
    }

    /// So many times what is wanted, over the same way.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        self.scaled(factor, 1.0)
    }

    /// The same over a share of the way; the torques of a joint have theirs from its angles.
    #[must_use]
    pub fn shorter(&self, share: f64) -> Self {
        self.scaled(1.0, share)
    }

    fn scaled(&self, factor: f64, share: f64) -> Self {
        match self {
            Self::Points(points) => {
                let one = |&OperatingPoint {
                               force_n,
                               contraction,
                           }: &OperatingPoint| OperatingPoint {
                    force_n: factor * force_n,
                    contraction: share * contraction,
                };
                Self::Points(points.iter().map(one).collect())
            }
            Self::Load { load, way } => Self::Load {
                load: load.times(factor),
                way: match way {
                    Lift::Stroke(mm) => Lift::Stroke(share * mm),
                    Lift::Contraction(ratio) => Lift::Contraction(share * ratio),
                },
            },
            Self::Joint(joint) => {
                let one = |t: &TorqueWanted| TorqueWanted {
                    torque_nm: factor * t.torque_nm,
                    ..*t
                };
                Self::Joint(JointDemand {
                    torques: joint.torques.iter().map(one).collect(),
                    ..joint.clone()
                })
            }
        }
    }

    /// The number that says how far: the first contraction, or the stroke in mm; `None` of a joint,
    /// and of a muscle that does not shorten.
    pub fn way(&self) -> Option<f64> {
        let way = match self {
            Self::Points(points) => points.first()?.contraction,
            Self::Load {
                way: Lift::Stroke(way) | Lift::Contraction(way),
                ..
            } => *way,
            Self::Joint(_) => return None,
        };
        Some(way).filter(|way| *way != 0.0)
    }

    /// The number that says how much: the first pull in N or torque in N m; of a load 1.
    pub fn size(&self) -> f64 {
        match self {
            Self::Points(points) => points.first().map_or(1.0, |q| q.force_n.abs()),
            Self::Load { .. } => 1.0,
            Self::Joint(joint) => joint.torques.first().map_or(1.0, |t| t.torque_nm),
        }
    }

    /// Checks what is wanted of a muscle of a length in mm.
    #[doc(hidden)]
    pub fn check(&self, length_mm: f64) -> Result<(), SpecError> {
        match self {
            Self::Joint(j) => {
                let senseless = |t: &&TorqueWanted| {
                    !(t.torque_nm > 0.0
                        && t.torque_nm.is_finite()
                        && t.angle_deg.abs() <= j.largest_angle_deg)
                };
                if let Some(&TorqueWanted {
                    torque_nm,
                    angle_deg,
                }) = j.torques.iter().find(senseless)
                {
                    let largest_deg = j.largest_angle_deg;
                    return Err(SpecError::Refused(format!(
                        "{torque_nm} N m at {angle_deg}° is invalid: the torque must be above zero \
                         and the angle within ±{largest_deg}°"
                    )));
                }
                let bounds = [
                    ("the largest angle of the joint", j.largest_angle_deg),
                    ("the radius of the pulley", j.radius_mm),
                ];
                if let Some((name, value)) = bounds
                    .into_iter()
                    .find(|(_, v)| !(v.is_finite() && *v > 0.0))
                {
                    return Err(SpecError::Refused(format!(
                        "{name} is {value}; it must be above zero"
                    )));
                }
            }
            Self::Load { load, way } => {
                let end = way.end_mm(length_mm);
                let (low, high) = load.reach_mm();
                if !(low <= 0.0 && end <= high) {
                    return Err(SpecError::Refused(format!(
                        "the load is known for shortenings from {low}\u{a0}mm to {high}\u{a0}mm, \
                         and the stroke goes from 0\u{a0}mm to {end}\u{a0}mm"
                    )));
                }
            }
            Self::Points(_) => {}
        }
        let points = self.points(length_mm);
        if points.is_empty() {
            return Err(SpecError::Refused(
                "no operating point: give `force_n` and `contraction`, \
                or `points`, each a pull at a contraction, or a load that pulls"
                    .into(),
            ));
        }
        let sign = if self.extends() { -1.0 } else { 1.0 };
        let senseless = |p: &&OperatingPoint| {
            let force_n = sign * p.force_n;
            let way = sign * p.contraction;
            !(force_n > 0.0 && force_n.is_finite() && (0.0..1.0).contains(&way))
        };
        match points.iter().find(senseless) {
            Some(p) => Err(SpecError::Refused(format!(
                "the operating point {force_n}\u{a0}N at a contraction of {contraction} is \
                 invalid: the pull must be above 0 N and the contraction from 0 to below 1; for a \
                 push of a muscle that extends, the force below 0 N and the contraction from above \
                 -1 to 0",
                force_n = p.force_n,
                contraction = p.contraction
            ))),
            None => Ok(()),
        }
    }
}

impl From<Vec<OperatingPoint>> for Demand {
    fn from(points: Vec<OperatingPoint>) -> Self {
        Self::Points(points)
    }
}
