//! A joint: one muscle against a spring, or two against each other, and the weight of a link.
//!
//! Angles φ are counterclockwise from the neutral angle, in degrees at the boundary. Muscle i has
//! the contraction ε_i = ε_i0 + Δ_i(φ)/L_i ([`Path`]), and by virtual work the joint's torque is
//!
//!   τ = Σ F_i(P_i, ε_i) Δ_i′ + spring + weight,   stiffness −dτ/dφ = Σ (K_i Δ_i′² − F_i Δ_i″) + …
//!
//! with K = ∂F/∂L of a muscle at its pressure. A muscle beyond its free contraction is slack: its
//! rope hangs, F = K = 0.

mod error;
mod file;
mod inverse;
mod map;
mod model;
mod path;
mod rest;
mod shut;
mod sought;
#[cfg(test)]
mod tests;
mod uncertainty;

pub use error::{JointError, Result};
pub use file::{JointFile, JointKeys, parse_joint};
pub use inverse::JointTarget;
pub use map::{JointMap, MapPoint};
pub use model::{BoundJoint, JointPoint, MuscleState, Turning};
pub use path::{Path, Shortening};
pub use rest::Rest;
pub use shut::ShutStiffness;

use crate::{
    extremes::even,
    load::GRAVITY_M_PER_S2,
    muscle::{Direction, Muscle},
};

/// A muscle at a joint.
#[derive(Debug, Clone, PartialEq)]
pub struct JointMuscle {
    /// The muscle.
    pub muscle: Muscle,
    /// Its way about the joint.
    pub path: Path,
    /// ε at the neutral angle.
    pub contraction_at_neutral: f64,
}

/// A spring at a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointSpring {
    /// On a rope: F = max(0, F0 − c Δ).
    Rope {
        /// Its way about the joint.
        path: Path,
        /// c in N/mm.
        rate_n_per_mm: f64,
        /// F0 in N, at the neutral angle.
        preload_n: f64,
    },
    /// A torsion spring: τ = −(τ0 + k φ).
    Torsion {
        /// k in N m/rad.
        rate_nm_per_rad: f64,
        /// τ0 in N m, towards −, at the neutral angle.
        preload_nm: f64,
    },
}

/// The moving link: weight, inertia and damping.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Link {
    /// Mass in kg.
    pub mass_kg: f64,
    /// Distance of its centre of mass from the axis in mm.
    pub centre_mm: f64,
    /// Angle of the line from the axis to that centre against the horizontal, at φ = 0, in degrees.
    pub inclination_deg: f64,
    /// A mass carried on the same line, in kg.
    pub payload_kg: f64,
    /// Its distance from the axis in mm.
    pub payload_at_mm: f64,
    /// Moment of inertia of the link about the axis in kg m², without the payload; of a point mass
    /// at its centre where it is not stated.
    pub inertia_kg_m2: Option<f64>,
    /// Damping in N m s/rad.
    pub damping_nm_s_per_rad: f64,
}

impl Link {
    /// Torque of the weight in N m, −g Σ m r cos(φ + β), and its slope in φ.
    pub fn weight_nm(&self, angle_rad: f64) -> (f64, f64) {
        let moment = 1e-3
            * GRAVITY_M_PER_S2
            * (self.mass_kg * self.centre_mm + self.payload_kg * self.payload_at_mm);
        let (sin, cos) = (angle_rad + self.inclination_deg.to_radians()).sin_cos();
        (-moment * cos, moment * sin)
    }

    /// Moment of inertia about the axis in kg m², with the payload.
    pub fn whole_inertia_kg_m2(&self) -> f64 {
        let point = |mass: f64, at_mm: f64| mass * (1e-3 * at_mm).powi(2);
        self.inertia_kg_m2
            .unwrap_or(point(self.mass_kg, self.centre_mm))
            + point(self.payload_kg, self.payload_at_mm)
    }
}

/// Friction of a muscle's rope on its pulley: a pull F arrives as F exp(∓μα) while the muscle
/// shortens or lengthens (capstan), α the angle of wrap.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PulleyFriction {
    /// μ
    coefficient: f64,
    /// α at the neutral angle, in rad; it unwinds as the muscle shortens.
    wrap_rad: f64,
}

/// A joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// One or two muscles.
    muscles: Vec<JointMuscle>,
    /// One a muscle, where a joint file states them.
    pulleys: Vec<PulleyFriction>,
    spring: Option<JointSpring>,
    link: Link,
    /// Limits of the angle in degrees.
    range_deg: (f64, f64),
}

impl Joint {
    /// A joint of one muscle (with or without a spring) or two.
    pub fn new(
        muscles: Vec<JointMuscle>,
        spring: Option<JointSpring>,
        link: Link,
        range_deg: (f64, f64),
    ) -> Result<Self, JointError> {
        let joint = Self {
            muscles,
            pulleys: vec![],
            spring,
            link,
            range_deg,
        };
        joint.check()?;
        Ok(joint)
    }

    fn check(&self) -> Result<(), JointError> {
        if !(1..=2).contains(&self.muscles.len()) {
            return Err(JointError::Muscles(self.muscles.len()));
        }
        let wrong = |message: String| Err(JointError::Refused(message));
        let (low, high) = self.range_deg;
        if !(low < high && low >= -180.0 && high <= 180.0) {
            return wrong(format!(
                "the joint's range {low}..{high} deg must rise and lie between -180 and 180 deg"
            ));
        }
        let link = &self.link;
        let values = [
            ("mass", link.mass_kg),
            ("centre", link.centre_mm),
            ("payload", link.payload_kg),
            ("payload_at", link.payload_at_mm),
            ("inertia", link.inertia_kg_m2.unwrap_or(0.0)),
            ("damping", link.damping_nm_s_per_rad),
            ("inclination", link.inclination_deg.abs()),
        ];
        not_negative("link", &values)?;
        let least = link.mass_kg * (1e-3 * link.centre_mm).powi(2);
        if let Some(inertia) = link.inertia_kg_m2
            && inertia < (1.0 - 1e-9) * least
        {
            return wrong(format!(
                "inertia of the link is {inertia} kg m2; its mass alone has {least:.4e} kg m2 about \
                 the joint's axis"
            ));
        }
        self.check_spring()?;
        for (i, m) in (1..).zip(&self.muscles) {
            let of_muscle =
                |error| JointError::Refused(format!("muscle {i} of the joint: {error}"));
            m.muscle.check_contracts().map_err(of_muscle)?;
            let e = m.contraction_at_neutral;
            if !(e.is_finite() && e.abs() < 1.0) {
                return wrong(format!(
                    "muscle {i}: {e} is not a valid contraction at the neutral angle; it lies \
                     below 1"
                ));
            }
            self.check_path(&format!("muscle {i}"), &m.path)?;
            let apart = m.path.length_mm(0.0);
            let long = m.muscle.length_mm() * (1.0 - e);
            if matches!(m.path, Path::Points { .. }) && apart < long {
                return wrong(format!(
                    "muscle {i}: its attachment points are {apart:.1} mm apart at the neutral \
                     angle, and the muscle is {long:.1} mm long there; move them apart, shorten \
                     the muscle or contract it further"
                ));
            }
        }
        Ok(())
    }

    fn check_spring(&self) -> Result<(), JointError> {
        let (rate, preload) = match self.spring {
            None => return Ok(()),
            Some(JointSpring::Torsion {
                rate_nm_per_rad,
                preload_nm,
            }) => (rate_nm_per_rad, preload_nm),
            Some(JointSpring::Rope {
                path,
                rate_n_per_mm,
                preload_n,
            }) => {
                self.check_path("the spring", &path)?;
                (rate_n_per_mm, preload_n)
            }
        };
        not_negative("spring", &[("rate", rate), ("preload", preload.abs())])
    }

    /// The two points of a muscle do not meet, and a pulley has a radius.
    fn check_path(&self, of: &str, path: &Path) -> Result<(), JointError> {
        let size = match path {
            Path::Pulley { radius_mm } => *radius_mm,
            Path::Points { .. } => path.length_mm(0.0),
        };
        if size == 0.0 || !size.is_finite() {
            return Err(JointError::Refused(format!(
                "{of}: a path of {size} mm; a radius or distance must be above zero"
            )));
        }
        // Nearer than this the arm turns faster than anything that can be built.
        let least = 1e-3 * size;
        let meet = |deg: &f64| {
            matches!(path, Path::Points { .. }) && path.length_mm(deg.to_radians()) <= least
        };
        match self.angles_deg(181).find(meet) {
            None => Ok(()),
            Some(angle_deg) => Err(JointError::Refused(format!(
                "{of}: its two attachment points meet at {angle_deg:.1} deg; narrow the \
                 joint's range or move them"
            ))),
        }
    }

    /// So many angles, even over the range.
    fn angles_deg(&self, count: u32) -> impl Iterator<Item = f64> {
        even(self.range_deg, count - 1)
    }

    /// What is unlikely, a sentence each: a muscle whose points turn the joint to the other side than
    /// its place in the file says (the first to +, the second to −), and sizes in another unit.
    pub fn doubts(&self) -> Vec<String> {
        let (low, high) = self.range_deg;
        let deg = 0f64.clamp(low, high);
        let mut out = vec![];
        let mut doubt = |is_unlikely: bool, sentence| out.extend(is_unlikely.then_some(sentence));
        let sides = [(1.0, "\u{2212}"), (-1.0, "+")];
        for (number, (muscle, (side, wrong))) in (1..).zip(self.muscles.iter().zip(sides)) {
            let arm_mm = side * muscle.path.shortening(deg.to_radians()).arm_mm;
            doubt(
                arm_mm < 0.0,
                format!(
                    "muscle {number} turns the joint to {wrong}: swap the muscles or move its points"
                ),
            );
            let mm = arm_mm.abs();
            doubt(
                !(1.0..=1e3).contains(&mm),
                format!("muscle {number} has an arm of {mm:.3}\u{a0}mm"),
            );
        }
        let kg = self.link.mass_kg.max(self.link.payload_kg);
        doubt(kg > 100.0, format!("the link has a mass of {kg}\u{a0}kg"));
        out
    }

    /// Its muscles: one or two.
    pub fn muscles(&self) -> &[JointMuscle] {
        &self.muscles
    }

    /// Its spring.
    pub fn spring(&self) -> Option<&JointSpring> {
        self.spring.as_ref()
    }

    /// Its moving link.
    pub fn link(&self) -> &Link {
        &self.link
    }

    /// The limits of its angle in degrees.
    pub fn range_deg(&self) -> (f64, f64) {
        self.range_deg
    }

    /// ε of a muscle at an angle, and the arm.
    #[doc(hidden)]
    pub fn contraction(&self, muscle: usize, angle_rad: f64) -> Option<(f64, Shortening)> {
        let m = self.muscles.get(muscle)?;
        let s = m.path.shortening(angle_rad);
        Some((m.contraction_at_neutral + s.mm / m.muscle.length_mm(), s))
    }

    /// Whether the torque depends on which way it turns: by the friction in a muscle or on its
    /// pulley.
    pub fn has_friction(&self) -> bool {
        self.muscles.iter().any(|m| m.muscle.friction().is_some())
            || self.pulleys.iter().any(|p| p.coefficient > 0.0)
    }

    /// Share of a muscle's pull that arrives from its pulley, and its slope in the angle.
    fn arriving(
        &self,
        muscle: usize,
        angle_rad: f64,
        arm_mm: f64,
        direction: Direction,
    ) -> (f64, f64) {
        let Some(p) = self.pulleys.get(muscle) else {
            return (1.0, 0.0);
        };
        let wrap = p.wrap_rad - arm_mm.signum() * angle_rad;
        let rate = direction.sign() * p.coefficient;
        let share = (rate * wrap.max(0.0)).exp();
        (
            share,
            if wrap > 0.0 {
                -share * rate * arm_mm.signum()
            } else {
                0.0
            },
        )
    }

    /// Torque of spring and weight in N m at an angle, and its slope in φ.
    pub fn passive_nm(&self, angle_rad: f64) -> (f64, f64) {
        let (weight, by) = self.link.weight_nm(angle_rad);
        match self.spring {
            None => (weight, by),
            Some(JointSpring::Torsion {
                rate_nm_per_rad,
                preload_nm,
            }) => (
                weight - preload_nm - rate_nm_per_rad * angle_rad,
                by - rate_nm_per_rad,
            ),
            Some(JointSpring::Rope {
                path,
                rate_n_per_mm,
                preload_n,
            }) => {
                let s = path.shortening(angle_rad);
                let force = preload_n - rate_n_per_mm * s.mm;
                if force <= 0.0 {
                    return (weight, by);
                }
                let slope = force * s.arm_by_angle_mm - rate_n_per_mm * s.arm_mm * s.arm_mm;
                (weight + 1e-3 * force * s.arm_mm, by + 1e-3 * slope)
            }
        }
    }
}

/// Whether the values of a part of the joint are finite and none is below zero.
fn not_negative(part: &str, values: &[(&str, f64)]) -> Result<(), JointError> {
    values
        .iter()
        .find(|(_, v)| !(v.is_finite() && *v >= 0.0))
        .map_or(Ok(()), |(what, value)| {
            Err(JointError::Refused(format!(
                "{what} of the {part} is {value}; it must be zero or above"
            )))
        })
}
